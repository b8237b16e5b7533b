// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "exchange/sound_meter.h"

#include <algorithm>
#include <cmath>

namespace betwixt {
namespace {

// Finds sudden rises of loudness, in steps of a hundredth of a second. Loudness is perceived in ratios, so its
// logarithm counts; 60 dB below a full sine counts as silence.
std::vector<double> find_onsets(const std::vector<double>& energy) {
  constexpr std::size_t hop = 10, before = 10, least_apart = 5;  // in milliseconds; the others in hops
  constexpr double floor = 1e-6, rise = 1.0;                     // of the logarithm: by a factor e of energy
  std::vector<double> level;
  for (std::size_t ms = 0; ms + hop < energy.size(); ms += hop)
    level.push_back(std::log(floor + 1000.0 / hop * (energy[ms + hop] - energy[ms])));
  std::vector<double> onsets;
  std::size_t last = 0;
  for (std::size_t i = 0; i < level.size(); ++i) {
    double most = std::log(floor);  // of the last hops
    for (std::size_t k = i > before ? i - before : 0; k < i; ++k) most = std::max(most, level[k]);
    if (level[i] < most + rise || (!onsets.empty() && i < last + least_apart)) continue;
    last = i;
    // Refines the time to a millisecond: the steepest point of the rise.
    std::size_t at = i * hop;
    for (std::size_t ms = i * hop; ms < (i + 1) * hop; ++ms)
      if (energy[ms + 1] - energy[ms] > energy[at + 1] - energy[at]) at = ms;
    onsets.push_back(static_cast<double>(at) / 1000);
  }
  return onsets;
}

}  // namespace

void SoundMeter::hear(std::span<const float> stereo) {
  constexpr std::size_t a_millisecond = sound_rate / 1000;
  for (std::size_t i = 0; i + 1 < stereo.size(); i += 2) {
    const double left = stereo[i], right = stereo[i + 1], square = (left * left + right * right) / 2;
    if (std::isfinite(square)) sum_ += square;
    if (++count_ % a_millisecond == 0) energy_.push_back(sum_ / sound_rate);
  }
}

Sound SoundMeter::sound(const std::string& path) const {
  constexpr std::size_t a_millisecond = sound_rate / 1000;
  Sound out;
  out.path = path, out.seconds = seconds(), out.energy = energy_;
  if (count_ % a_millisecond != 0) out.energy.push_back(sum_ / sound_rate);
  out.onsets = find_onsets(out.energy);
  return out;
}

}  // namespace betwixt
