// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// betwixt check: all errors and warnings of a script.
#include <fmt/format.h>

#include "app/command.h"

namespace betwixt {

void add_check(CLI::App& app, int& exit_code) {
  auto* sub = app.add_subcommand("check", "says all errors and warnings of a script");
  auto file = std::make_shared<std::string>();
  sub->add_option("FILE", *file, "the script")->required()->type_name("");
  sub->footer("Example:\n  betwixt check examples/bounce.bx");
  sub->callback([file, &exit_code] {
    const Loaded loaded = load_file(*file, load_options());
    int errors = 0, warnings = 0;
    for (const Diagnostic& d : loaded.diagnostics) {
      std::fputs(to_string(d).c_str(), stderr);
      errors += d.severity == Severity::error;
      warnings += d.severity == Severity::warning;
    }
    const std::size_t objects = loaded.document.names().size();
    const int frames = loaded.document.frame_count();
    if (errors + warnings == 0)
      fmt::print("{}: no errors, {} object{}, {} frame{}\n", *file, objects, objects == 1 ? "" : "s", frames,
                 frames == 1 ? "" : "s");
    else
      fmt::print(stderr, "{} error{}, {} warning{}\n", errors, errors == 1 ? "" : "s", warnings,
                 warnings == 1 ? "" : "s");
    exit_code = errors ? wrong_input : all_done;
  });
}

}  // namespace betwixt
