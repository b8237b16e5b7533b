// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Which part of a sound is audible when, and how loud.
#pragma once

#include <algorithm>

#include "scene/functions.h"

namespace betwixt {

// In seconds: `at` of the film, the others of the sound.
struct AudiblePart {
  double at = 0, from = 0, until = 0, fade_in = 0, fade_out = 0, length = 0;

  double own_time(double film) const { return from + (film - at); }
  double end() const { return std::min(until, length); }
  // Returns the fade, 0 to 1: zero outside the part, linear ramps at its ends.
  double share(double own) const {
    if (own < from || own >= end()) return 0;
    const double in = fade_in > 0 ? (own - from) / fade_in : 1, out = fade_out > 0 ? (end() - own) / fade_out : 1;
    return std::clamp(std::min(in, out), 0.0, 1.0);
  }
};

// `number` returns a function's value; `length` is the sound's length.
template <class F>
AudiblePart audible_part(double length, F&& number) {
  return {number(fn::sound_at), number(fn::sound_from), number(fn::sound_until),
          number(fn::fade_in),  number(fn::fade_out),   length};
}

}  // namespace betwixt
