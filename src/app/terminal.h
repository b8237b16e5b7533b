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

// A rectangle of characters. The first column and row of the terminal are 1.
struct Cells {
  int column = 1, row = 1, columns = 1, rows = 1;
};
// Returns the largest cells for pictures of this aspect ratio (width / height), in the middle of the terminal's first
// `rows` rows.
Cells largest_cells(const TerminalSize&, int rows, double aspect);
// Returns a picture as characters in these cells.
std::string characters(const Picture&, const Cells&);

// Parses typed bytes into keys. Unknown sequences are skipped.
std::vector<Key> read_keys(std::string_view typed);

}  // namespace betwixt
