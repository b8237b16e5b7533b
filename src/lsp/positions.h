// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Converts places to and from the Language Server Protocol. It counts lines from 0 and UTF-16 units in them; Betwixt
// counts bytes, or characters where people read them. The protocol names files by URI.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "export/json.h"
#include "syntax/script_text.h"

namespace betwixt {

std::size_t utf16_units(std::string_view);

Json position_at(const ScriptText&, std::size_t place);
Json range_of(const ScriptText&, Span);
// Returns the byte of a position, clamped to the end of its line, or nullopt if the position is malformed.
std::optional<std::size_t> place_of(const ScriptText&, const Json& position);
std::optional<Span> span_of(const ScriptText&, const Json& range);
// Returns the span of a diagnostic's place in its text. It is empty if the place has no line.
Span span_of(const ScriptText&, const Place&);

// Returns nullopt if the URI names no file.
std::optional<std::string> path_of_uri(std::string_view uri);
std::string uri_of_path(std::string_view path);

}  // namespace betwixt
