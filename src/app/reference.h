// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The reference pages of the documentation, generated from the rows of the language and of the subcommands.
#pragma once

#include <string>

namespace betwixt {

std::string language_reference();      // docs/reference.md
std::string command_line_reference();  // docs/command-line.md
std::string words_json();              // `betwixt help --json`: all words and commands, as one object
std::string words_for_assistants();    // llms.txt

}  // namespace betwixt
