// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Pictures as video encoders want them.
#pragma once

#include <cstdint>
#include <vector>

#include "betwixt/mesh.h"

namespace betwixt {

// Planar 4:2:0, BT.709, limited range: luma, then Cb, then Cr, with chroma sited at the left as H.264 and VP9 take it
// to be. Odd sizes are made even by repeating the last row or column. `alpha`: a fourth plane, and what is clear has no
// say in chroma.
void to_yuv420(const Picture&, bool alpha, std::vector<std::uint8_t>& out);

}  // namespace betwixt
