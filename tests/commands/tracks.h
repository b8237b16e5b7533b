// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Helpers for tests of track commands: values at each frame, and a track that goes up and down again.
#pragma once

#include "support/loaded_film.h"

namespace betwixt {

// Checks the values of a target at whole frames, beginning at `first`.
inline void expect_track(const LoadedFilm& s, const char* target, int first, const std::vector<double>& wanted) {
  for (std::size_t i = 0; i < wanted.size(); ++i)
    expect_numbers(s, target, fmt::format("{}f", first + static_cast<int>(i)), {wanted[i]}, 1e-9);
}

inline constexpr const char* ramp = "create b sphere\nb.position.x\n  1f 0 linear\n  5f 4 linear\n  9f 0\n";
inline LoadedFilm after_ramp(const std::string& command) { return LoadedFilm(std::string(ramp) + command + "\n"); }

}  // namespace betwixt
