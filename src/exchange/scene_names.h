// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Converts foreign names to unique names of ours.
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>

namespace betwixt {

class SceneNames {
 public:
  // Returns a unique name: '-' replaces forbidden characters, and a taken name gets a number, as in Wheel-2.
  std::string give(std::string_view wanted, std::string_view otherwise);
  void take(std::string name) { taken_.insert(std::move(name)); }

 private:
  std::set<std::string, std::less<>> taken_;
  std::map<std::string, int, std::less<>> next_;  // the next number to try
};

}  // namespace betwixt
