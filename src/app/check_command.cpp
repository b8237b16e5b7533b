// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// betwixt check: all errors and warnings of a script.
#include <fmt/format.h>

#include "app/command.h"

namespace betwixt {

void add_check(CLI::App& app, int& exit_code) {
  auto* sub = app.add_subcommand("check", "All errors and warnings of a script");
  auto file = std::make_shared<std::string>();
  sub->add_option("file", *file, "the script")->required()->type_name("FILE");
  sub->footer("Example:\n  betwixt check examples/bounce.bx");
  sub->callback([file, &exit_code] {
    const Loaded loaded = load_file(*file, load_options());
    int errors = 0, warnings = 0;
    for (const Diagnostic& d : loaded.diagnostics) {
      std::fputs(to_string(d).c_str(), stderr);
      errors += d.severity == Severity::error;
      warnings += d.severity == Severity::warning;
    }
    if (errors + warnings == 0)
      fmt::print("{}: no errors, {} objects, {} frames\n", *file, loaded.document.names().size(),
                 loaded.document.frame_count());
    else
      fmt::print(stderr, "{} error{}, {} warning{}\n", errors, errors == 1 ? "" : "s", warnings,
                 warnings == 1 ? "" : "s");
    exit_code = errors ? wrong_input : all_done;
  });
}

}  // namespace betwixt
