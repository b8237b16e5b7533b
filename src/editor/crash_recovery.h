// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Crash recovery at the start. If a command of the history crashes the program, every start would crash again. A file
// beside the journal marks a start until it has succeeded. A start that finds the mark first carries out the history in
// a copy of the process, and looks for the command that crashes it.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>

namespace betwixt {

// Does the work in a copy of this process. Returns how the copy died ("signal 11"); nullopt if it completed the work,
// or if this process has several threads and cannot be copied.
std::optional<std::string> dies_of(const std::function<void()>& work);

struct Culprit {
  std::size_t number = 0;  // from 0
  std::string how;         // how the process died
};
// Returns the command that crashes the process. `carry_out(n)` carries out the first n commands and evaluates the
// result. Returns nullopt if no command crashes, or if `carry_out(0)` does already.
std::optional<Culprit> find_culprit(std::size_t commands, const std::function<void(std::size_t)>& carry_out);

// Marks a start with a file beside the journal, for its own lifetime. The file stays if the process dies before that.
class StartMark {
 public:
  explicit StartMark(const std::string& script);
  ~StartMark();
  StartMark(const StartMark&) = delete;
  StartMark& operator=(const StartMark&) = delete;
  // Returns true if an earlier start has left its mark.
  bool found() const { return found_; }

 private:
  std::string path_;
  bool found_ = false;
};

}  // namespace betwixt
