// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Texts of the film in another language: the command `language`, and the option of its name.
#pragma once

#include <string>
#include <string_view>

#include "commands/command.h"

namespace betwixt {

// Replaces a text that is shown by its translation, if there is one. `about`: where it is written.
void translate_text(Script&, std::string& text, std::string_view about);
// Returns whether the values of this function are texts that people read.
bool is_read_by_people(FunctionId);
// Reads the catalogue that the options name.
void begin_translation(Script&);

}  // namespace betwixt
