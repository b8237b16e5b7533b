// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// All commands that have a key, a menu entry or a row in the command palette.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace betwixt::studio {

class Window;

struct ActionRow {
  std::string_view menu, name;  // "Play", "Play forward"
  std::string_view keys;        // "Space", "Ctrl+Z; Ctrl+U": any of these keys
  std::string_view sentence;    // describes the command; `…` are the script lines that it carries out
  std::function<void(Window&)> run;
  bool (*is_on)(const Window&) = nullptr;  // whether a switch is on; null if the command is no switch
  std::string_view also = {};              // words by which people look for it
  bool divides = false;                    // a line above it in the menu
};
const std::vector<ActionRow>& action_rows();
std::vector<ActionRow> picture_rows();  // those of the view of the picture

}  // namespace betwixt::studio
