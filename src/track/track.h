// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// A track: the sorted events of one display function, and what it does outside them. (twixt notes, 3.2, 4.4)
#pragma once

#include "track/events.h"
#include "track/types.h"

namespace betwixt {

enum class Extrapolation : std::uint8_t { hold, linear, cycle, bounce };
inline constexpr std::array<std::string_view, 4> extrapolation_names{"hold", "linear", "cycle", "bounce"};

struct Track {
  Events events;
  Twerper global = Twerper::unset;  // set: the one interpolator of the whole track, whatever the events say (G102)
  TwerperArguments arguments;       // of the global twerper
  Extrapolation before = Extrapolation::hold, after = Extrapolation::hold;
  bool srgb = false;  // colours: blend the numbers as written, not the light
  friend bool operator==(const Track&, const Track&) = default;
};

// sRGB (as written) to linear light and back, per channel, mirrored at 0. Going there and back gives the number
// written.
double to_linear(double srgb);
double to_srgb(double linear);
Vec3 to_linear(Color c);
Color to_srgb(Vec3 linear);
Color from_hsv(double turns, double saturation, double value);

}  // namespace betwixt
