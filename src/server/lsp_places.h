// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Places as the Language Server Protocol says them: lines from 0, and UTF-16 units in them. Ours are bytes, and
// characters where people read them. Names of files are URIs there.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "editor/text_lines.h"
#include "export/json.h"

namespace betwixt {

std::size_t utf16_units(std::string_view);

Json position_at(const TextLines&, std::size_t place);
Json range_of(const TextLines&, Span);
// The byte of a position; beyond the end of a line, that end; none: it is no position.
std::optional<std::size_t> place_of(const TextLines&, const Json& position);
std::optional<Span> span_of(const TextLines&, const Json& range);
// Where a diagnostic's place is in its text; all but the text's end where it does not say any.
Span span_of(const TextLines&, const Place&);

// None: it names no file.
std::optional<std::string> path_of_uri(std::string_view uri);
std::string uri_of_path(std::string_view path);

}  // namespace betwixt
