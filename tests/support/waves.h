// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Makes sounds for tests: WAV files of 32-bit floating-point numbers, which are read back unchanged.
#pragma once

#include <cstdint>
#include <cstring>
#include <fstream>
#include <string>
#include <vector>

namespace betwixt {

inline void write_wave(const std::string& path, const std::vector<float>& samples, std::uint32_t rate = 48'000,
                       std::uint16_t channels = 2) {
  std::string head;
  const auto put = [&](auto number) { head.append(reinterpret_cast<const char*>(&number), sizeof number); };
  const auto bytes = static_cast<std::uint32_t>(samples.size() * sizeof(float));
  head += "RIFF", put(bytes + 36), head += "WAVEfmt ", put(std::uint32_t{16}), put(std::uint16_t{3}), put(channels);
  put(rate), put(rate * channels * 4), put(static_cast<std::uint16_t>(4 * channels)), put(std::uint16_t{32});
  head += "data", put(bytes);
  std::ofstream file(path, std::ios::binary);
  file << head;
  file.write(reinterpret_cast<const char*>(samples.data()), bytes);
}

// Writes f(seconds) to all channels.
template <class F>
std::vector<float> wave_of(double seconds, F&& f, int rate = 48'000, int channels = 2) {
  std::vector<float> all;
  for (int i = 0; i < static_cast<int>(seconds * rate); ++i)
    for (int c = 0; c < channels; ++c) all.push_back(static_cast<float>(f(static_cast<double>(i) / rate)));
  return all;
}

}  // namespace betwixt
