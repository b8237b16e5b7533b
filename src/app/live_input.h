// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What controls say while a film plays: OSC over UDP, and MIDI where there is some.
#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "betwixt/result.h"

namespace betwixt {

struct LiveMessage {
  std::string address;
  std::vector<double> numbers;
  std::vector<double> within;       // nearer to each than this, it is the same message; empty: exact
  std::optional<std::string> text;  // the first text, if any
  // When it came to this machine, which may be long before anybody had time to read it.
  std::chrono::steady_clock::time_point arrived = std::chrono::steady_clock::now();
};

std::string in_words(const LiveMessage&);

// The messages of one packet of OSC, those in bundles too (their times are ignored: all is now). Empty: no OSC.
std::vector<LiveMessage> read_osc(std::span<const std::uint8_t> packet);
// Control changes as /midi/cc/CHANNEL/NUMBER from 0 to 1, notes as /midi/note/CHANNEL/NUMBER with the velocity from 0
// to 1, the wheel as /midi/bend/CHANNEL from -1 to 1. Channels count from 1.
std::optional<LiveMessage> read_midi(std::span<const std::uint8_t> message);

class LiveInput {
 public:
  // "9000" listens on this machine's own address only, "HOST:PORT" where it says. No MIDI is no error.
  // Errors: range (no such port), file (no such address, taken already).
  static Result<std::unique_ptr<LiveInput>> open(const std::string& where);
  virtual ~LiveInput() = default;
  // What has come since; never waits. Not more at once than a frame has time for: the rest comes next time.
  virtual std::vector<LiveMessage> poll() = 0;
  virtual std::uint64_t ignored() const = 0;  // packets that were no OSC
};

}  // namespace betwixt
