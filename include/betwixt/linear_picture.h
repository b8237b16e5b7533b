// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Pictures of linear light (high dynamic range), for compositing and further processing.
//
// Room: scene
#pragma once

#include <cstdint>
#include <vector>

#include "betwixt/mesh.h"

namespace betwixt {

// Linear light without an upper limit, with the primaries of sRGB and premultiplied alpha. Rows from the top, four
// numbers a pixel: r g b a.
struct LinearPicture {
  int width = 0, height = 0;
  std::vector<float> rgba;
};

// Converts to sRGB with straight alpha, for screens. Light above white becomes white. A pixel brighter than its
// opacity (a highlight on glass) gets more opacity. A number that is NaN becomes black.
void to_shown(const LinearPicture&, Picture& out);
// The same, with 16 bits a channel.
std::vector<std::uint16_t> to_shown_16(const LinearPicture&);
// Converts a shown picture, with four numbers of 16 bits a pixel, back to linear light.
LinearPicture to_light(int width, int height, const std::vector<std::uint16_t>& rgba);

}  // namespace betwixt
