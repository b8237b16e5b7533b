// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Who is connected to a server: what has come from there, and what is on its way there.
#pragma once

#include <atomic>
#include <cstdint>
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
  Nanos parting = 0;  // when it closed its end while it was in hand, or was last asked whether it is still there
  std::string out;
  std::size_t sent = 0;
  std::uint64_t lost = 0;  // events that it was not told of
  std::uint32_t watched = 0;

  static constexpr std::size_t chunk = 1 << 16;         // bytes that are read in one turn
  static constexpr std::size_t most_waiting = 4 << 20;  // bytes of answers; behind them nothing more is looked at
  std::size_t waiting() const { return out.size() - sent; }
  bool full() const { return waiting() > most_waiting; }
  // What has come; false: it has gone for good.
  bool read();
  // So much of it has been looked at.
  void drop(std::size_t bytes);
};

}  // namespace betwixt
