// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The sound of a film in blocks, from any position.
#pragma once

#include <map>
#include <memory>

#include "film/mixing.h"

namespace betwixt {

class Tape;

// Files are decoded once, as needed, and kept: 23 MB a minute. The blocks equal the samples of mix_sounds to the bit.
class Soundtrack {
 public:
  explicit Soundtrack(Time first);  // of the film
  ~Soundtrack();
  Soundtrack(const Soundtrack&) = delete;
  Soundtrack& operator=(const Soundtrack&) = delete;

  // Returns false if it is not decoded yet. The next part is decoded in the background.
  bool mix(const Program&, std::int64_t from, std::span<float> stereo);
  // Waits until the samples are decoded. Returns false after `seconds`.
  bool await(const Program&, std::int64_t from, std::int64_t pairs, double seconds);

  static constexpr std::int64_t soon = 2 * sound_rate;  // pairs; longer than a decoder takes to start

 private:
  Time time(std::int64_t pair) const;
  Tape& tape(const HeardSound&);
  const Time first_;
  std::map<std::string, std::unique_ptr<Tape>> tapes_;  // by path
};

}  // namespace betwixt
