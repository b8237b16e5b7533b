// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Joins the same error in many objects to one message with their number.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace betwixt {

class MessageGroups {
 public:
  // Adds a message that begins with its subject, like "ball.radius: …". Returns its number; messages that differ only
  // in the subject share one. Messages with different places `where` in a script are different.
  std::size_t add(std::string_view message, std::string_view where = {});
  std::size_t size() const { return all_.size(); }
  // Returns the text of the first message with this number, and how many others there are.
  std::string text(std::size_t number) const;

 private:
  struct Said {
    std::string first, key;
    std::vector<std::string> things;
  };
  std::vector<Said> all_;
};

}  // namespace betwixt
