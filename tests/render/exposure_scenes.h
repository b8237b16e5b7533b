// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Films whose motion blur has a closed form, for the styles that average subframes and for that of rays.
#pragma once

#include <string>

namespace betwixt {

// A drawing of 96 by 54 pixels, ten pixels per metre, white on black. The shutter is open for half a frame.
inline std::string drawn_film(const std::string& rest) {
  return "rate 24\nrange 1f 24f\nsize 96x54\nfilm flat\nbackground black\n"
         "create eye camera position=(0 0 10) look-at=(0 0 0) height=5.4\nset eye.shutter 180deg\n" +
         rest;
}

// Returns the exposure of a pixel from 0 to 1 by an edge that moves from `from` to `to` while the shutter is open: the
// integral over time of its covered share.
inline double share_swept(double from, double to) {
  const auto so_far = [](double u) { return u < 0 ? 0 : u < 1 ? u * u / 2 : u - 0.5; };
  return (so_far(to) - so_far(from)) / (to - from);
}

}  // namespace betwixt
