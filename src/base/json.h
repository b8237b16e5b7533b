// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Texts and numbers as JSON.
#pragma once

#include <string>
#include <string_view>

namespace betwixt {

// Returns the text in double quotes. Bytes that are not UTF-8 become the replacement character, so JSON stays valid.
std::string json_text(std::string_view);
// Returns the deepest nesting of lists and objects. The text need not be JSON.
std::size_t json_depth(std::string_view);
std::string json_number(double);  // null for infinity and NaN, which JSON lacks

}  // namespace betwixt
