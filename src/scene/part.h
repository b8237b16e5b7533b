// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// PartsByName (`part`): lines with parameters that `create` carries out for each object, as if they were a kind.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "betwixt/result.h"
#include "scene/quantity.h"

namespace betwixt {

struct PartParameter {
  std::string name, said;  // `said`: the default, as the script has it
  Let value;
  friend bool operator==(const PartParameter&, const PartParameter&) = default;
};
struct Part {
  std::vector<PartParameter> parameters;
  std::string lines;
  std::string help;  // a sentence about it; "" for those of scripts
  Place at;          // of its first line, for messages
  friend bool operator==(const Part& a, const Part& b) { return a.parameters == b.parameters && a.lines == b.lines; }
};
using PartsByName = std::map<std::string, Part, std::less<>>;

// Returns "lamp height=1 color=gold".
std::string usage_of(const std::string& name, const Part&);

}  // namespace betwixt
