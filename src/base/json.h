// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Texts and numbers as JSON.
#pragma once

#include <string>
#include <string_view>

namespace betwixt {

// In double quotes. What is not UTF-8 becomes the replacement character, so that the answer can always be read; what a
// terminal would obey, and what turns the direction of writing, is written as \u202e.
std::string json_text(std::string_view);
// The same of words for a person, in which such characters stay visible once the answer is read (utf8.h).
std::string json_words(std::string_view);
// How many lists and objects stand in one another, where most do. The text need not be JSON.
std::size_t json_depth(std::string_view);
std::string json_number(double);  // null for infinity and NaN, which JSON lacks

}  // namespace betwixt
