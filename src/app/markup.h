// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Pages from their texts.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>

namespace betwixt {

// As text of XML and HTML. What they cannot hold, and what turns the direction of writing, is made visible (utf8.h).
std::string escaped(std::string_view text);

// A page in which each {{name}} is what stands beside that name. In one pass: what is filled in is not looked at again.
std::string filled(std::string_view page, std::initializer_list<std::pair<std::string_view, std::string>> parts);

}  // namespace betwixt
