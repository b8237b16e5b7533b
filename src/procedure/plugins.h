// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Plug-ins: the author's code in C, through include/betwixt/plugin.h.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "track/procedure.h"

struct betwixt_frame;  // betwixt/plugin.h

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
struct PluginRenderer {
  std::string name, help, path;  // `path`: of the plug-in
  int (*function)(const struct betwixt_frame*, unsigned char* rgba, const char** why, void* user) = nullptr;
  void* user = nullptr;
};
struct Plugin {
  std::vector<PluginItem> items;
  std::vector<PluginKind> kinds;
  std::vector<PluginRenderer> renderers;
  std::vector<PluginFunction> functions;
};

// Loads a plug-in permanently. A child process loads it first, so that one that crashes, or takes more than five
// seconds, is refused.
Result<Plugin> load_plugin(const std::string& path);

}  // namespace betwixt
