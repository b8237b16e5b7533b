// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Characters of UTF-8 texts.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace betwixt {

// Returns true if a byte begins a character.
inline bool begins_character(char byte) { return (byte & 0xC0) != 0x80; }

std::size_t count_characters(std::string_view);
// Returns the first `count` characters, or all if there are fewer.
std::string_view first_characters(std::string_view, std::size_t count);

// Returns the number of bytes of the character at `i`, or 0 if it is not valid UTF-8.
std::size_t character_length(std::string_view, std::size_t i);

// Returns true for invisible characters that change how others appear: controls, line separators, and those that change
// the direction of writing.
bool is_hidden(char32_t);
// Returns the character at `i`, which has `length` bytes.
char32_t character_at(std::string_view, std::size_t i, std::size_t length);

// Returns the text as a terminal or a log may show it: control characters, line separators, characters that turn the
// direction of writing and bytes that are no UTF-8 are written as \x1b or \u{202e}. Tabs stay if `tabs` is set.
std::string visible(std::string_view, bool tabs = false);
// Like visible(), but keeps line ends and tabs.
std::string visible_lines(std::string_view);

// Returns a text that a film may have. Bytes that are not UTF-8, and control characters other than tabs and line ends,
// become the replacement character, U+FFFD.
std::string clean_text(std::string_view);

}  // namespace betwixt
