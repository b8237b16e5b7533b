// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Pictures of light, for what is added up, laid over something or worked on further.
//
// Room: scene
#pragma once

#include <cstdint>
#include <vector>

#include "betwixt/mesh.h"

namespace betwixt {

// Linear light as bright as it may be, with the primaries of sRGB and the opacity multiplied in; rows from the top,
// four numbers a pixel: r g b a.
struct DeepPicture {
  int width = 0, height = 0;
  std::vector<float> rgba;
};

// As screens show it, the opacity not multiplied in: the colours are straight. Light above white is white; what is
// brighter than its opacity (highlights on glass) gets more of that. What has no number is black.
void to_shown(const DeepPicture&, Picture& out);
// The same with 16 bits a channel.
std::vector<std::uint16_t> to_shown_16(const DeepPicture&);
// Back: of what is shown, four numbers of 16 bits a pixel, its light.
DeepPicture to_light(int width, int height, const std::vector<std::uint16_t>& rgba);

}  // namespace betwixt
