// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Sound in step with pictures: what an output is given next.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <utility>

namespace betwixt {

// What plays samples: a device, or a test.
class SoundOutput {
 public:
  virtual ~SoundOutput() = default;
  // Pairs that it was given and that are not heard yet.
  virtual std::int64_t waiting() = 0;
  virtual void write(std::span<const float> stereo) = 0;
  virtual void forget() = 0;  // what is waiting
};

// Fills in the samples from a pair of the film on. False: they are not known yet.
using SoundSource = std::function<bool(std::int64_t from, std::span<float> stereo)>;

// The output is kept a tenth of a second ahead. While pictures go on, so does the sound, from sample to sample, also
// where a film begins again; where they are elsewhere, it goes there, softly. What is under way is heard nevertheless.
class SoundStream {
 public:
  static constexpr std::int64_t block = 960, ahead = 5 * block, tolerance = 2 * block;  // 20, 100 and 40 ms

  // The film has `length` pairs, one at least.
  SoundStream(SoundSource source, std::int64_t length, bool loop)
      : source_(std::move(source)), length_(length), loop_(loop) {}
  // Gives the output what it lacks. `now`: the pair that is due at this moment; none: nothing is to be heard.
  void fill(SoundOutput&, std::optional<std::int64_t> now);

 private:
  static constexpr std::int64_t fade = 240;  // 5 ms

  void next_block(std::optional<std::int64_t> due, std::span<float> stereo);
  void go_on(std::int64_t next);
  bool read(std::int64_t from, std::span<float> stereo) const;
  bool near(std::int64_t a, std::int64_t b) const;
  std::int64_t in_film(std::int64_t pair) const;

  SoundSource source_;
  std::int64_t length_;
  bool loop_;
  std::optional<std::int64_t> next_;  // the pair that follows what the output has; none: it has silence
  std::int64_t silent_ = 0;           // so many pairs of it
  std::pair<float, float> last_;      // what it got last
};

}  // namespace betwixt
