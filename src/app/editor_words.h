// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// How editors colour scripts that know words by patterns only. Made from the rows of the language.
#pragma once

#include <string>

namespace betwixt {

std::string vim_syntax();
std::string textmate_grammar();

}  // namespace betwixt
