// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// A name is another one in all texts of a film, and the film is the same but for it.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "betwixt/language.h"
#include "editor/text_names.h"

namespace betwixt {

// What stands at a place and can be renamed. Errors: name (there is no name; a pattern or a file makes it).
Result<NameAt> to_rename(const TextNames&, std::size_t text, std::size_t place);

// Loads the film with its texts as they are said here.
using LoadTexts = std::function<Loaded(const std::vector<std::string>&)>;

// Where the name stands, so that another one put there makes the same film. Errors: syntax (this can be no name), name
// (something is called so already; some of what speaks of it does not speak by its name, and would not follow).
Result<std::vector<TextSpan>> renaming(std::span<const FilmText>, const TextNames&, const Loaded& film, const NameAt&,
                                       const std::string& to, const LoadTexts&);

// The text with something else in these places, which are in order.
std::string with_others(std::string text, std::span<const Span>, std::string_view others);

}  // namespace betwixt
