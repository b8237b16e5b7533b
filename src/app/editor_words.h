// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Syntax highlighting for editors that know words only by patterns, generated from the rows of the language.
#pragma once

#include <string>

namespace betwixt {

std::string vim_syntax();
std::string textmate_grammar();

}  // namespace betwixt
