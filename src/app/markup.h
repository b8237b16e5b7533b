// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Fills in the templates of web pages.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>

namespace betwixt {

// Escapes a text for XML and HTML. Characters that they do not allow, and those that change the direction of writing,
// are made visible (utf8.h).
std::string escaped(std::string_view text);

// Replaces each {{name}} by its text, in one pass: text filled in is not searched again.
std::string filled(std::string_view page, std::initializer_list<std::pair<std::string_view, std::string>> parts);

}  // namespace betwixt
