// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Times that have names: `voice:"the square"` is when these words begin, `voice:"the square"#2` when they begin the
// second time, `voice:"the square".end` when they end; `voice.start` and `voice.end` are those of the whole sound, and
// `proof.start` and `proof.end` those of a section. They are operands of formulas, so that a length may follow:
// voice.end+12f.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "language/cursor.h"

namespace betwixt {

// Returns whether such a time begins at a place of the cursor's text.
bool moment_begins(const Cursor&, const char* at);
// Reads it. Errors: syntax, name (no such object, or words that are not spoken), type (no sound, a sound without
// words), range (spoken less often).
bool moment(Cursor&, Quantity& out);
// Returns the length of what has the form of such a time at the beginning of a text, without the length behind it, or
// 0.
std::size_t moment_length(std::string_view text);

// Returns what can complete `voice:"the sq`: the begun words with each word that can follow.
std::vector<std::string> moments_like(const Scene&, std::string_view begun);
// Returns the beginnings of such times: voice:" and voice.end for each sound.
std::vector<std::string> moment_names(const Scene&);

}  // namespace betwixt
