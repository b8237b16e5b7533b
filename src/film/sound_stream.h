// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Sound in step with pictures: feeds an output.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <utility>

namespace betwixt {

// An output of samples: a device, or a test.
class SoundOutput {
 public:
  virtual ~SoundOutput() = default;
  // Returns the pairs that it has got and not played yet.
  virtual std::int64_t waiting() = 0;
  virtual void write(std::span<const float> stereo) = 0;
  virtual void forget() = 0;  // drops the waiting pairs
};

// Fills in the samples from a pair of the film on. Returns false if they are not known yet.
using SoundSource = std::function<bool(std::int64_t from, std::span<float> stereo)>;

// Keeps the output a tenth of a second ahead. While pictures continue, so does the sound, from sample to sample, also
// where a film begins again; if they jump, it fades out and in. Sound that is under way is played to its end.
class SoundStream {
 public:
  static constexpr std::int64_t block = 960, ahead = 5 * block, tolerance = 2 * block;  // 20, 100 and 40 ms

  // The film has `length` pairs, at least one.
  SoundStream(SoundSource source, std::int64_t length, bool loop)
      : source_(std::move(source)), length_(length), loop_(loop) {}
  // Fills up the output. `now`: the pair that is due at this moment; nullopt: silence.
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
  std::optional<std::int64_t> next_;  // the pair after the last one in the output; nullopt: the output has silence
  std::int64_t silent_ = 0;           // pairs of silence in it
  std::pair<float, float> last_;      // the last pair in the output
};

}  // namespace betwixt
