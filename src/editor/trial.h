// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// A start that a command of the history ends, again and again. A file beside the journal marks a start until it has
// succeeded. The next start that finds the mark carries out the history in a copy of the process first, and looks for
// the command that ends it.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>

namespace betwixt {

// Does the work in a copy of this process. Returns how that ended ("signal 11"), or nullopt if it comes to the end of
// its work. A process with several threads cannot be copied: nullopt then.
std::optional<std::string> dies_of(const std::function<void()>& work);

struct Culprit {
  std::size_t number = 0;  // from 0
  std::string how;         // it ends the process
};
// The command that ends the process. `carry_out(n)` carries out the first n of them and shows what they make. Returns
// nullopt if nothing does, or if `carry_out(0)` does already.
std::optional<Culprit> find_culprit(std::size_t commands, const std::function<void(std::size_t)>& carry_out);

// A mark beside the journal of a script while it lives. It stays if the process ends before that.
class StartMark {
 public:
  explicit StartMark(const std::string& script);
  ~StartMark();
  StartMark(const StartMark&) = delete;
  StartMark& operator=(const StartMark&) = delete;
  // An earlier start has left one.
  bool found() const { return found_; }

 private:
  std::string path_;
  bool found_ = false;
};

}  // namespace betwixt
