// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The objects that the examples of `help` use. An example after this script is a complete film.
#pragma once

#include "editor/help.h"

namespace betwixt {

inline constexpr const char* small_film =
    "rate 24\nrange 1f 72f\ncreate ball sphere\ncreate hand group\ncreate wheel{1..4} cylinder\n"
    "create lamp light\ncreate eye camera position=(0 0 20)\nball.position\n  1f (0 10 0)\n  12f (4 1 0) linear\n"
    "  24f (8 10 0)\nwheel*.position\n  1f (0 0 0)\n  24f (3 0 0)\n";

// Returns whether the entry has an example that is part of a script and needs no other file.
inline bool in_a_film(const HelpEntry& e) {
  return e.group != HelpGroup::shell && !e.example.empty() && e.example.find("file=\"") == std::string::npos;
}

}  // namespace betwixt
