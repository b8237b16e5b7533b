// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// A connection to a server, with its receive and send buffers.
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
  std::optional<Imaging::Host> host;  // nullopt until it has sent the token
  Nanos came = 0;
  int guesses = 0;
  std::string in;                 // bytes received but not processed
  std::size_t seen = 0;           // bytes of `in` known to hold no end of a line
  std::string announced;          // its `send`, whose bytes are on their way
  std::uint64_t awaited = 0;      // bytes of it still to come …
  bool wanted = false;            // … which are kept, or else skipped
  std::string sent;               // those that came
  bool skipping = false;          // the current line is too long, so its rest is skipped
  bool last_word = false;         // reads no more; the connection closes when its answers are sent
  bool half_closed = false;       // the peer has closed its sending side
  Nanos moved = 0;                // when the peer last read some of its answers
  bool in_hand = false;           // a thread works on its line; no other thread touches the guest
  std::atomic<bool> gone{false};  // the connection was lost while a thread worked for it: a cancellation token
  bool kept = false;              // its next line waits until another host's is done
  Nanos parting = 0;              // when it closed its side while a thread worked for it, or when it was last probed
  std::uint64_t lost = 0;         // events dropped because it reads too slowly
  std::uint32_t watched = 0;

  static constexpr std::size_t chunk = 1 << 16;  // bytes read in one turn
  // Bytes of answers. Above this the server stops reading from the connection (back-pressure).
  static constexpr std::size_t most_waiting = 4 << 20;
  static constexpr std::size_t most_sent = 1 << 20;  // bytes sent in one turn
  std::size_t waiting() const { return waiting_; }
  bool full() const { return waiting() > most_waiting; }
  // Reads what has arrived. Returns false if the connection is lost.
  bool read();
  // Removes processed bytes from the buffer.
  void drop(std::size_t bytes);
  // Takes the bytes of a `send`, as far as they have arrived. Returns false if some are still to come.
  bool take_bytes();
  // Appends a text to the send buffer. Does not copy a long text, and hosts may share one.
  void say(std::string text);
  void say(std::shared_ptr<const std::string> text);
  // Sends part of the buffer. Returns false if the connection is lost.
  bool send();

 private:
  std::deque<std::shared_ptr<const std::string>> out_;
  std::shared_ptr<std::string> open_;   // the last element of `out_`, while short texts are appended to it
  std::size_t sent_ = 0, waiting_ = 0;  // bytes sent of the first element; bytes of all that remain
};

}  // namespace betwixt
