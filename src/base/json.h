// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Formats texts and numbers as JSON.
#pragma once

#include <string>
#include <string_view>

namespace betwixt {

// Returns the text in double quotes. Bytes that are not UTF-8 become the replacement character, so that the result is
// always valid. Control characters, and those that change the direction of writing, are written as \u202e.
std::string json_text(std::string_view);
// Like json_text(), for words that a person will read: such characters stay visible after decoding (utf8.h).
std::string json_words(std::string_view);
// Returns the deepest nesting of lists and objects. The text need not be valid JSON.
std::size_t json_depth(std::string_view);
std::string json_number(double);  // null for infinity and NaN, which JSON lacks

}  // namespace betwixt
