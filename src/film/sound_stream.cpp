// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "film/sound_stream.h"

#include <algorithm>
#include <array>
#include <cstdlib>

namespace betwixt {

void SoundStream::fill(SoundOutput& output, std::optional<std::int64_t> now) {
  std::int64_t waiting = output.waiting();
  std::array<float, 2 * block> stereo{};
  // Do not wait for the end of silence.
  if (now && !next_ && waiting > 0 && silent_ >= waiting && read(in_film(*now), stereo)) output.forget(), waiting = 0;
  for (; waiting < ahead; waiting += block) {
    stereo.fill(0);
    next_block(now ? std::optional(in_film(*now + waiting)) : std::nullopt, stereo);
    last_ = {stereo[stereo.size() - 2], stereo.back()};
    output.write(stereo);
  }
}

void SoundStream::next_block(std::optional<std::int64_t> due, std::span<float> stereo) {
  if (next_ && due && near(*next_, *due) && read(*next_, stereo)) return go_on(*next_ + block);
  std::fill(stereo.begin(), stereo.end(), 0.0f);
  if (next_) {  // a short fade from the last value makes no click
    next_.reset();
    silent_ = block - fade;
    for (std::size_t i = 0; i < static_cast<std::size_t>(fade); ++i) {
      const float share = 1 - static_cast<float>(i + 1) / fade;
      stereo[2 * i] = share * last_.first, stereo[2 * i + 1] = share * last_.second;
    }
    return;
  }
  // A film starts with its first sample, even if the clock is some milliseconds late.
  const std::int64_t from = due && *due >= block ? *due : 0;
  if (!due || !read(from, stereo)) {
    std::fill(stereo.begin(), stereo.end(), 0.0f);
    silent_ += block;
    return;
  }
  go_on(from + block);
  if (from == 0) return;
  for (std::size_t i = 0; i < static_cast<std::size_t>(2 * fade); ++i) stereo[i] *= static_cast<float>(i / 2) / fade;
}

void SoundStream::go_on(std::int64_t next) {
  silent_ = 0;
  next_ = in_film(next);
  if (*next_ >= length_) next_.reset();
}

// Reads across the end of the film, where it begins again or is silent.
bool SoundStream::read(std::int64_t from, std::span<float> stereo) const {
  if (from >= length_) return false;
  while (!stereo.empty()) {
    const auto part = std::min(stereo.size(), static_cast<std::size_t>(2 * (length_ - from)));
    if (!source_(from, stereo.first(part))) return false;
    stereo = stereo.subspan(part);
    if (!loop_) {
      std::fill(stereo.begin(), stereo.end(), 0.0f);
      break;
    }
    from = 0;
  }
  return true;
}

// With `loop`, the end of the film is near its beginning.
bool SoundStream::near(std::int64_t a, std::int64_t b) const {
  const std::int64_t apart = std::abs(a - b);
  return std::min(apart, loop_ ? std::abs(length_ - apart) : apart) <= tolerance;
}

std::int64_t SoundStream::in_film(std::int64_t pair) const { return loop_ ? pair % length_ : pair; }

}  // namespace betwixt
