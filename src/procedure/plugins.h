// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Plug-ins: the author's code in C, through include/betwixt/plugin.h.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "track/procedure.h"

namespace betwixt {

struct PluginItem {
  std::string name, help;
  Role role = Role::value;
  std::shared_ptr<const Routine> code;
};
struct PluginFunction {
  std::string name, type;       // the name of the type in the language
  std::vector<double> numbers;  // the value before any event
};
struct PluginKind {
  std::string name, help, lines;  // the lines make the model
};
struct Plugin {
  std::vector<PluginItem> items;
  std::vector<PluginKind> kinds;
  std::vector<PluginFunction> functions;
};

// Loads a plug-in permanently. A child process loads it first, so that one that crashes, or takes more than five
// seconds, is refused.
Result<Plugin> load_plugin(const std::string& path);

}  // namespace betwixt
