// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Reads and writes the contents of texts in quotes and of comments.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace betwixt {

// Returns a text in quotes, on one line.
std::string write_text(std::string_view);
// Reads what is between the quotes of a text on one line. Returns the place of the first escape (a backslash and a
// letter) that has no meaning, if there is one.
std::optional<std::size_t> read_escapes(std::string_view written, std::string& out);

// Returns a text as comments, one for each line.
std::string as_comment(std::string_view);
// Returns the words of a line that is only a comment; nullopt for other lines.
std::optional<std::string_view> comment_in(std::string_view line);

}  // namespace betwixt
