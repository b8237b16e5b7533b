// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What is wrong with many things in the same way is said once, with how many there are.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace betwixt {

class Likewise {
 public:
  // A message that begins with what it is about, as "ball.radius: …" does. Its number, which is that of another one
  // where only the thing differs. `where`: in a script; messages of different places are different.
  std::size_t add(std::string_view message, std::string_view where = {});
  std::size_t size() const { return all_.size(); }
  // The first of those of a number, and of what else it holds.
  std::string text(std::size_t number) const;

 private:
  struct Said {
    std::string first, key;
    std::vector<std::string> things;
  };
  std::vector<Said> all_;
};

}  // namespace betwixt
