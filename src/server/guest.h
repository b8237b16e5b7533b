// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Who is connected to a server: what has come from there, and what is on its way there.
#pragma once

#include <atomic>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <string>

#include "server/imaging.h"

namespace betwixt {

struct Guest {
  int file = -1;
  std::optional<Imaging::Host> host;  // none: has not said the token yet
  Nanos came = 0;
  int guesses = 0;
  std::string in;                 // what has come and has not been looked at
  std::size_t seen = 0;           // bytes of it that hold no end of a line
  bool skipping = false;          // a line that is too long
  bool last_word = false;         // nothing more is read; it goes when it has its answers
  bool half_closed = false;       // it will say no more
  Nanos moved = 0;                // when it last read some of its answers
  bool in_hand = false;           // a thread works on what it said; nobody else touches it
  std::atomic<bool> gone{false};  // meanwhile: it takes back what it asked
  bool kept = false;              // its next line waits until another host's is done
  Nanos parting = 0;       // when it closed its end while it was in hand, or was last asked whether it is still there
  std::uint64_t lost = 0;  // events that it was not told of
  std::uint32_t watched = 0;

  static constexpr std::size_t chunk = 1 << 16;         // bytes that are read in one turn
  static constexpr std::size_t most_waiting = 4 << 20;  // bytes of answers; behind them nothing more is looked at
  static constexpr std::size_t most_sent = 1 << 20;     // bytes that are sent in one turn
  std::size_t waiting() const { return waiting_; }
  bool full() const { return waiting() > most_waiting; }
  // What has come; false: it has gone for good.
  bool read();
  // So much of it has been looked at.
  void drop(std::size_t bytes);
  // Puts a text behind what is on its way there. Nothing is copied of one that is long, and hosts may share it.
  void say(std::string text);
  void say(std::shared_ptr<const std::string> text);
  // Sends some of it; false: the host has gone.
  bool send();

 private:
  std::deque<std::shared_ptr<const std::string>> out_;
  std::shared_ptr<std::string> open_;   // the last of these, while short texts join it
  std::size_t sent_ = 0, waiting_ = 0;  // bytes of the first that have been sent; of all that have not
};

}  // namespace betwixt
