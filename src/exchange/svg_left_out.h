// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What the reader of an SVG leaves out: each thing once, with the first elements that had it.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace betwixt {

class SvgLeftOut {
 public:
  void add(const std::string& what, std::string_view of);
  void say(std::vector<std::string>& out) const;

 private:
  static constexpr std::size_t most_named = 5;
  std::map<std::string, std::pair<std::size_t, std::vector<std::string>>> all_;  // how often, and where first
};

}  // namespace betwixt
