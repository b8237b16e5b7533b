// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// "-" in the place of a file: standard input for a script, standard output for what is made.
#pragma once

#include <optional>
#include <string>

#include "betwixt/result.h"

namespace betwixt {

// Whether a script comes from standard input; then its name in errors is "<stdin>".
bool is_stream(const std::string& file);
// What a script says, of a file or of standard input, which is read once. Errors: file.
Result<std::string> script_text(const std::string& file);

// Where something is made that is to go to standard output: "-", or "-.webm" where the ending says what it is. Until
// it is whole it lies in a folder of its own, which goes with this.
class Outgoing {
 public:
  // `out` becomes the path to make it at. `usual`: the ending of "-"; empty: it has to be said.
  // Errors: range (no ending, or a terminal, which shows no pictures), machine.
  static Result<Outgoing> begin(std::string& out, const std::string& usual);
  Outgoing() = default;
  Outgoing(Outgoing&&) noexcept;
  Outgoing& operator=(Outgoing&&) noexcept;
  ~Outgoing();
  explicit operator bool() const { return !path_.empty(); }
  Status send() const;  // errors: machine

 private:
  std::string folder_, path_;  // empty: it goes where it is made
};

}  // namespace betwixt
