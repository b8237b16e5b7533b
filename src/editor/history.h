// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What a document was made of, as a script: the author's text, then every step that stands. It may be kept in a file;
// then a step that has been answered is in it, whatever ends the process.
#pragma once

#include <sys/types.h>

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "betwixt/result.h"
#include "editor/step.h"

namespace betwixt {

// `base`: the author's text.
std::string as_script(const std::string& base, std::span<const Step> steps);
// The text without what was begun at its end and not finished, as a process that is killed may leave it.
std::string_view whole_steps(std::string_view text);
// The text that a history goes on from. What was half done at its end, and never answered, goes to `cut`.
std::string begun_with(std::string text, std::string& cut);

// A sink of an editor: it is told of every step before it is done.
class History {
 public:
  // `longest`: so many bytes of commands, beside the author's text.
  explicit History(std::size_t longest) : longest_(longest) {}
  ~History();
  History(const History&) = delete;
  History& operator=(const History&) = delete;

  // From now on the file holds the history, which begins with the author's text. Errors: file (there already, another
  // server has it), machine.
  Status keep_in(const std::string& path, bool overwrite, const std::string& base);
  // On failure (the disk is full, the history is too long) nothing has changed.
  Status note(Did what, const Step& step, std::span<const Step> standing);
  // What was noted is on the disk. A failure leaves unknown what is.
  Status sync();
  std::size_t bytes() const { return bytes_; }  // of commands

 private:
  Status append(const Step& step, std::span<const Step> standing);
  Status take_back(const Step& step);

  const std::size_t longest_;
  std::vector<off_t> begins_;  // of each step, in the file
  int file_ = -1;
  off_t end_ = 0;
  std::size_t bytes_ = 0;
  bool dirty_ = false;
};

}  // namespace betwixt
