// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Shows a question of the session as a window with a button for each choice.
#pragma once

#include <optional>
#include <string>

#include "betwixt/session.h"

class QWidget;

namespace betwixt::studio {

// Returns the choice, or nullopt if the user closes the window.
std::optional<std::string> ask_in_window(QWidget* parent, const Session::Question&);

}  // namespace betwixt::studio
