// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Pictures in the form of video encoders.
#pragma once

#include <cstdint>
#include <vector>

#include "betwixt/mesh.h"

namespace betwixt {

// Converts to planar 4:2:0, BT.709, limited range: luma, then Cb, then Cr. Chroma is sited at the left, as H.264 and
// VP9 assume. Odd sizes are made even by repeating the last row or column. `alpha`: adds a fourth plane, and
// transparent pixels do not affect chroma.
void to_yuv420(const Picture&, bool alpha, std::vector<std::uint8_t>& out);

// The same with 10 bits, each in two bytes, from pictures of 16 bits (to_coded_16), by the matrix of BT.709 or of
// BT.2020.
enum class YuvMatrix : std::uint8_t { bt709, bt2020 };
void to_yuv420_10(int width, int height, const std::vector<std::uint16_t>& rgba, YuvMatrix,
                  std::vector<std::uint8_t>& out);

}  // namespace betwixt
