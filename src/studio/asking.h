// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Shows a question of the session as a window with a button for each answer.
#pragma once

#include <optional>
#include <string>
#include <vector>

class QWidget;

namespace betwixt::studio {

// Returns the answers that a question offers: "save, discard or stay?" and "overwrite? (yes/no)".
std::vector<std::string> answers_of(const std::string& question);
// Returns the rest of the question: "1 command is not saved." and "overwrite?".
std::string words_of(const std::string& question);
// Returns nullopt if the user closes the window.
std::optional<std::string> ask_in_window(QWidget* parent, const std::string& question);

}  // namespace betwixt::studio
