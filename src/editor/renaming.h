// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Renames a name in all texts of a film, and leaves the film the same otherwise.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "betwixt/language.h"
#include "editor/text_names.h"

namespace betwixt {

// Returns the name at a place if it can be renamed. Errors: name (there is no name; a pattern or a file makes it).
Result<NameAt> to_rename(const TextNames&, std::size_t text, std::size_t place);

// Loads the film with these texts in place of its own.
using LoadTexts = std::function<Loaded(const std::vector<std::string>&)>;

// Returns the places of a name that must change so that the texts make the same film. Errors: syntax (not a valid
// name), name (the new name is taken; or something refers to the old one indirectly and would not follow).
Result<std::vector<TextSpan>> renaming(std::span<const FilmText>, const TextNames&, const Loaded& film, const NameAt&,
                                       const std::string& to, const LoadTexts&);

// Returns the text with `others` in these places, which must be in order.
std::string with_others(std::string text, std::span<const Span>, std::string_view others);

}  // namespace betwixt
