// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Measures the loudness and the onsets of a sound from its samples.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "betwixt/sound.h"

namespace betwixt {

class SoundMeter {
 public:
  // Hears the next samples: left and right alternately, `sound_rate` pairs a second.
  void hear(std::span<const float> stereo);
  double seconds() const { return static_cast<double>(count_) / sound_rate; }
  // Returns the sound that was heard. `path`: where decode_sound finds its samples.
  Sound sound(const std::string& path) const;

 private:
  std::size_t count_ = 0;
  double sum_ = 0;
  std::vector<double> energy_{0};  // as in Sound
};

}  // namespace betwixt
