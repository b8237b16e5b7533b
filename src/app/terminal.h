// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The terminal for pictures: the alternate screen, single keys, and a restore of all settings however the program ends.
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
  double cell_aspect = 0.5;  // width of a character divided by its height
  friend bool operator==(const TerminalSize&, const TerminalSize&) = default;
};

// There is one terminal, so there is at most one instance.
class Terminal {
 public:
  static Result<std::unique_ptr<Terminal>> open();  // Errors: type (standard output is no terminal)
  ~Terminal();
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;

  TerminalSize size() const;
  bool has_keys() const { return keys_; }
  bool write(std::string_view) const;  // in one call, so that no half picture shows; false: closed
  std::vector<Key> wait(double seconds, bool& closed) const;  // the keys pressed; returns early if there are any

 private:
  explicit Terminal(bool keys) : keys_(keys) {}
  const bool keys_;
};

// Returns a picture as characters in `columns` x `rows` cells, at a position (from 1) of the screen.
std::string characters(const Picture&, int column, int row, int columns, int rows);

// Parses typed bytes into keys. Unknown sequences are skipped.
std::vector<Key> read_keys(std::string_view typed);

}  // namespace betwixt
