// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Live input from controllers: OSC over UDP, and MIDI if the machine has it.
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
  std::vector<double> within;       // tolerances for equal messages; empty means exact
  std::optional<std::string> text;  // the first text, if any
  // The time when the machine received it, which can be long before the program reads it.
  std::chrono::steady_clock::time_point arrived = std::chrono::steady_clock::now();
};

std::string in_words(const LiveMessage&);

// Returns the messages of an OSC packet, including those in bundles, whose times are ignored. Returns an empty list if
// the packet is not OSC.
std::vector<LiveMessage> read_osc(std::span<const std::uint8_t> packet);
// Reads a MIDI message: control changes are /midi/cc/CHANNEL/NUMBER from 0 to 1, notes /midi/note/CHANNEL/NUMBER with
// the velocity from 0 to 1, the pitch wheel /midi/bend/CHANNEL from -1 to 1. Channels count from 1. Returns nullopt for
// other messages.
std::optional<LiveMessage> read_midi(std::span<const std::uint8_t> message);

class LiveInput {
 public:
  // "9000" listens on the loopback address only, "HOST:PORT" on that address. Missing MIDI is no error. Errors: range
  // (no such port), file (no such address, or it is in use).
  static Result<std::unique_ptr<LiveInput>> open(const std::string& where);
  virtual ~LiveInput() = default;
  // Returns messages received since the last call, at most as many as a frame has time for. Never waits.
  virtual std::vector<LiveMessage> poll() = 0;
  virtual std::uint64_t ignored() const = 0;  // packets that were not OSC
};

}  // namespace betwixt
