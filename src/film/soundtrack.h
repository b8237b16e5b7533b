// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The sound of a film in blocks, from any place at once.
#pragma once

#include <map>
#include <memory>

#include "film/mixing.h"

namespace betwixt {

class Tape;

// Files are decoded once and kept, as they are heard: 23 MB a minute. The blocks are mix_sounds' samples to the bit.
class Soundtrack {
 public:
  explicit Soundtrack(Time first);  // of the film
  ~Soundtrack();
  Soundtrack(const Soundtrack&) = delete;
  Soundtrack& operator=(const Soundtrack&) = delete;

  // False: not decoded yet. What follows soon is decoded meanwhile.
  bool mix(const Program&, std::int64_t from, std::span<float> stereo);
  // Waits till it is; false: that took longer than so many seconds.
  bool await(const Program&, std::int64_t from, std::int64_t pairs, double seconds);

  static constexpr std::int64_t soon = 2 * sound_rate;  // pairs; more than a decoder takes to begin

 private:
  Time time(std::int64_t pair) const;
  Tape& tape(const HeardSound&);
  const Time first_;
  std::map<std::string, std::unique_ptr<Tape>> tapes_;  // by path
};

}  // namespace betwixt
