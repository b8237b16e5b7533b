// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Questions of a session become windows with a button for each answer.
#pragma once

#include <optional>
#include <string>
#include <vector>

class QWidget;

namespace betwixt::studio {

// The answers that a question names: "save, discard or stay?" and "overwrite? (yes/no)".
std::vector<std::string> answers_of(const std::string& question);
// What it says without them: "1 command is not saved." and "overwrite?".
std::string words_of(const std::string& question);
// None: the window was closed.
std::optional<std::string> ask_in_window(QWidget* parent, const std::string& question);

}  // namespace betwixt::studio
