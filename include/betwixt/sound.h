// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// A sound's loudness and onsets, as functions of the sound's own time in seconds.
//
// Room: scene
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace betwixt {

inline constexpr int sound_rate = 48'000;  // stereo samples a second, whatever rate the file has

struct Sound {
  std::string path;  // the path to open
  double seconds = 0;
  // At each millisecond: the integral over time, in seconds, of the squared samples (mean of left and right) until
  // then.
  std::vector<double> energy;
  std::vector<double> onsets;  // the times at which a note or beat begins, ascending

  // Returns the root mean square over 50 ms around a time. Outside the file there is silence. A sine at full volume
  // gives 0.7071.
  double loudness(double at) const;
  std::size_t onsets_between(double from, double to) const;  // counts from <= onset <= to
};

}  // namespace betwixt
