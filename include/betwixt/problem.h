// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What went wrong while a frame was evaluated, as data.
//
// Room: base
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <tuple>

namespace betwixt {

// The frame uses another value instead, so a problem is no Error.
struct Problem {
  // What gave no value; then `message` says why. `other` is anything else; then `message` goes on from the subject.
  enum What : std::uint8_t { other, procedure, filter, twerper, step } what = other;
  std::string subject = {};  // OBJECT.FUNCTION, or the name of a stepped procedure; empty if it is about none
  std::string name = {};     // of the filter, twerper or step; of a procedure the beginning of its code
  std::string message = {};
  std::optional<std::string> source = {};  // the author's code as written, if the error is in it
  int line = 0;                            // of that code; 0 if it is unknown, or the only one
  // Whether their texts are equal.
  friend bool operator==(const Problem& a, const Problem& b) {
    return std::tie(a.what, a.subject, a.name, a.message, a.line) ==
           std::tie(b.what, b.subject, b.name, b.message, b.line);
  }
};
// Returns 'ball.radius: the procedure "…" gives no value: line 2: …', and the like.
std::string to_string(const Problem&);

}  // namespace betwixt
