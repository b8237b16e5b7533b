// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What of a sound can be asked for at any time, in its own time.
//
// Room: scene
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace betwixt {

inline constexpr int sound_rate = 48'000;  // stereo samples a second, whatever the file has

struct Sound {
  std::string path;  // of its file, as it can be opened
  double seconds = 0;
  std::vector<double> energy;  // the squares (means of left and right) summed up to each millisecond, in seconds
  std::vector<double> onsets;  // when something begins to sound, ascending

  // The root of the mean square over 50 ms about a time; silence outside. A full sine has 0.7071.
  double loudness(double at) const;
  std::size_t onsets_between(double from, double to) const;  // from <= onset <= to
};

}  // namespace betwixt
