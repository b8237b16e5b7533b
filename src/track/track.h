// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// A track: the sorted events of one display function, and its extrapolation. (twixt notes, 3.2, 4.4)
#pragma once

#include "track/events.h"
#include "track/types.h"

namespace betwixt {

enum class Extrapolation : std::uint8_t { hold, linear, cycle, bounce };
inline constexpr std::array<std::string_view, 4> extrapolation_names{"hold", "linear", "cycle", "bounce"};

struct Track {
  Events events;
  Twerper global = Twerper::unset;  // if set, the twerper of the whole track, whatever the events say (G102)
  TwerperArguments arguments;       // of the global twerper
  Extrapolation before = Extrapolation::hold, after = Extrapolation::hold;
  bool srgb = false;  // colours: blend the sRGB numbers and not the light
  friend bool operator==(const Track&, const Track&) = default;
};

// Convert a channel from sRGB to linear light and back, mirrored at 0. A round trip returns the same number.
double to_linear(double srgb);
double to_srgb(double linear);
Vec3 to_linear(Color c);
Color to_srgb(Vec3 linear);
Color from_hsv(double turns, double saturation, double value);

}  // namespace betwixt
