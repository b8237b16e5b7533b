// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The translations of a film's texts, from a catalogue of gettext (.po).
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "betwixt/result.h"

namespace betwixt {

// By the text as it is written in the script. Texts that are not translated yet are left out.
using Translations = std::map<std::string, std::string, std::less<>>;

// `name`: of the file, for errors. Errors: syntax, with the line as their place; file (no UTF-8).
Result<Translations> read_po(std::string_view text, const std::string& name);

// Returns a text in quotes, as a catalogue has it: of several lines, a piece for each.
std::string write_po_text(std::string_view text);

}  // namespace betwixt
