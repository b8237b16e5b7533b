// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Everything that a key, a menu or the palette of commands can do, a row each.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace betwixt::studio {

class Window;

struct ActionRow {
  std::string_view menu, name;  // "Play", "Play forward"
  std::string_view keys;        // "Space", "Ctrl+Z; Ctrl+U": any of them
  std::string_view sentence;    // what it does; `…` are lines of the language that it says
  void (*run)(Window&);
  bool (*is_on)(const Window&) = nullptr;  // of what is switched
};
const std::vector<ActionRow>& action_rows();

}  // namespace betwixt::studio
