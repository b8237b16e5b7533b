// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Merges the facts of three films: what one of two authors changed, changes; what both changed differently is a
// conflict, and that of `mine` stays.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "compare/facts.h"

namespace betwixt {

struct FactConflict {
  FactKey key;  // where it was in the base, or where theirs would be
  std::optional<std::string> mine;
  FactKey theirs_key;  // an event of theirs may have moved
  std::optional<std::string> theirs;
};
struct MergedFacts {
  std::map<FactKey, std::string> said;
  std::vector<FactConflict> conflicts;
};
MergedFacts merge_facts(const Facts& base, const Facts& mine, const Facts& theirs);

}  // namespace betwixt
