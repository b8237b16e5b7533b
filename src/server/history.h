// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What a document was made of, as a script: the author's text, then every command that was accepted. It may be kept in
// a file; then a command that has been answered is in it, whatever ends the process.
#pragma once

#include <sys/types.h>

#include <deque>
#include <string>
#include <vector>

#include "language/reader.h"

namespace betwixt {

class History {
 public:
  // A document and what the next command must know.
  struct Point {
    Document document;
    Reader::Carried carried;
    std::size_t events = 0;  // of the document
  };

  // `depth`: so many commands can be undone. The texts of all are kept, the documents before them only of these.
  // `longest`: so many bytes of commands, beside the author's text.
  History(std::size_t depth, std::size_t longest) : depth_(depth), longest_(longest) {}
  ~History();
  History(const History&) = delete;
  History& operator=(const History&) = delete;

  // Begins with the author's text. `cut` gets what stands at its end and was never answered: half a command.
  Diagnostics begin(std::string text, const std::string& name, const LoadOptions&, std::string& cut);
  // From now on the file holds the history. Errors: file (there already, another server has it), machine.
  Status keep_in(const std::string& path, bool overwrite);

  const Point& now() const { return now_; }
  // Commands that were carried out together: one step. `sheet`: the line that their rows stand below; may be empty.
  // On failure (the disk is full, the history is too long) nothing has changed.
  Status take(Point after, const std::vector<std::string>& lines, const std::string& sheet);
  Status undo();
  Status redo();
  // What was taken is on the disk. A failure leaves unknown what is.
  Status sync();

  std::string text() const;
  std::size_t steps() const { return steps_.size(); }
  std::size_t bytes() const { return bytes_; }  // of commands

 private:
  struct Step {
    std::vector<std::string> lines;
    std::string sheet;
    off_t begins = 0;  // in the file
    std::size_t bytes() const;
  };
  std::string written(std::size_t i) const;
  Status append(Step step);
  Status write(Step step);
  Status take_back();  // the last step, from the file and from the list

  const std::size_t depth_, longest_;
  std::string base_;
  Point now_;
  std::vector<Step> steps_;
  std::deque<Point> before_;  // of the last steps
  std::vector<std::pair<Step, Point>> undone_;
  int file_ = -1;
  off_t end_ = 0;
  std::size_t bytes_ = 0;
  bool dirty_ = false;
};

// The text without what was begun at its end and not finished, as a process that is killed may leave it.
std::string_view whole_steps(std::string_view text);

}  // namespace betwixt
