// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The terminal as a stage: its other screen, keys as they are pressed, and everything put back whatever happens.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "betwixt/mesh.h"
#include "betwixt/result.h"

namespace betwixt {

enum class Key {
  space,
  left,
  right,
  shift_left,
  shift_right,
  up,
  down,
  home,
  end,
  style,
  samples,
  larger,
  smaller,
  mute,
  quit
};

struct TerminalSize {
  int columns = 80, rows = 24;
  double cell_aspect = 0.5;  // a character's width to its height
  friend bool operator==(const TerminalSize&, const TerminalSize&) = default;
};

// There is one terminal, so there is at most one of these.
class Terminal {
 public:
  static Result<std::unique_ptr<Terminal>> open();  // Errors: type (standard output is no terminal)
  ~Terminal();
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;

  TerminalSize size() const;
  bool has_keys() const { return keys_; }
  bool write(std::string_view) const;  // all at once, so that no half picture shows; false: it has gone away
  std::vector<Key> wait(double seconds, bool& closed) const;  // what was pressed; returns early when something was

 private:
  explicit Terminal(bool keys) : keys_(keys) {}
  const bool keys_;
};

// A picture as characters in `columns` x `rows` cells, put at a place (from 1) of the screen.
std::string characters(const Picture&, int column, int row, int columns, int rows);

// Sequences of what was typed; what means nothing is left out.
std::vector<Key> read_keys(std::string_view typed);

}  // namespace betwixt
