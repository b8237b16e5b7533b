// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Names of others become names of ours, no two the same.
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>

namespace betwixt {

class SceneNames {
 public:
  // What names may not have becomes '-'; one that is taken gets a number: Wheel-2.
  std::string give(std::string_view wanted, std::string_view otherwise);
  void take(std::string name) { taken_.insert(std::move(name)); }

 private:
  std::set<std::string, std::less<>> taken_;
  std::map<std::string, int, std::less<>> next_;  // number to try
};

}  // namespace betwixt
