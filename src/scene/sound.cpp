// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "betwixt/sound.h"

#include <algorithm>
#include <cmath>

namespace betwixt {
namespace {

constexpr double window = 0.05;  // seconds: two periods of the lowest audible tone

// Interpolates linearly between milliseconds, so that loudness has no steps.
double energy_until(const std::vector<double>& energy, double seconds) {
  if (energy.empty()) return 0;
  const double at = std::clamp(1000 * seconds, 0.0, static_cast<double>(energy.size() - 1));
  const auto before = std::min(static_cast<std::size_t>(at), energy.size() - 1);
  const std::size_t behind = std::min(before + 1, energy.size() - 1);
  return std::lerp(energy[before], energy[behind], at - static_cast<double>(before));
}

}  // namespace

double Sound::loudness(double at) const {
  const double there = energy_until(energy, at + window / 2) - energy_until(energy, at - window / 2);
  return std::sqrt(std::max(0.0, there / window));
}

std::size_t Sound::onsets_between(double from, double to) const {
  const auto first = std::lower_bound(onsets.begin(), onsets.end(), from);
  const auto last = std::upper_bound(first, onsets.end(), to);
  return static_cast<std::size_t>(last - first);
}

}  // namespace betwixt
