// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Joins the same error in many objects to one message with their number.
#pragma once

#include <string>
#include <vector>

#include "betwixt/problem.h"

namespace betwixt {

class MessageGroups {
 public:
  // Adds a problem. Returns its number; problems that differ only in the subject and in the code share one. Problems
  // with different places `where` in a script are different.
  std::size_t add(const Problem&, const std::string& where = {});
  std::size_t size() const { return all_.size(); }
  // Returns the text of the first problem with this number, and how many others there are.
  std::string text(std::size_t number) const;

 private:
  struct Said {
    Problem first;
    std::string where;
    std::vector<std::string> subjects;
  };
  std::vector<Said> all_;
};

}  // namespace betwixt
