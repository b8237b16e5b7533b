// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// "-" as a file name: standard input for a script, standard output for results.
#pragma once

#include <optional>
#include <string>

#include "betwixt/result.h"

namespace betwixt {

// Returns whether a script comes from standard input. Errors then call it "<stdin>".
bool is_stream(const std::string& file);
// Returns the text of a script. Standard input is read only once. Errors: file.
Result<std::string> script_text(const std::string& file);

// A result for standard output: "-", or "-.webm" with the ending that gives the format. Until it is complete it is a
// file in a temporary folder, which the destructor removes.
class Outgoing {
 public:
  // Replaces `out` by the temporary path. `usual`: the ending of "-"; if empty, the user must give one. Errors: range
  // (no ending, or the output is a terminal, which shows no pictures), machine.
  static Result<Outgoing> begin(std::string& out, const std::string& usual);
  Outgoing() = default;
  Outgoing(Outgoing&&) noexcept;
  Outgoing& operator=(Outgoing&&) noexcept;
  ~Outgoing();
  explicit operator bool() const { return !path_.empty(); }
  Status send() const;  // errors: machine

 private:
  std::string folder_, path_;  // empty if the result has a file name of its own
};

}  // namespace betwixt
