// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Writes conflicts into a merged script: a comment beside the line that stays.
#pragma once

#include <string>
#include <vector>

#include "betwixt/compare.h"
#include "compare/fact_merge.h"

namespace betwixt {

// Adds a comment for each conflict to a text that makes the film, and sets their places. `theirs`: their film.
void note_conflicts(std::string& text, const Document& film, const Document& theirs, const std::vector<FactConflict>&,
                    std::vector<MergeConflict>& said);

}  // namespace betwixt
