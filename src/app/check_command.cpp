// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// betwixt check: all errors and warnings of a script.
#include <fmt/format.h>

#include "app/code_errors.h"
#include "app/command.h"
#include "app/streams.h"
#include "app/subcommand.h"
#include "base/tell_user.h"
#include "base/utf8.h"

namespace betwixt {
namespace {

std::string counted(std::size_t n, const char* what) { return fmt::format("{} {}{}", n, what, n == 1 ? "" : "s"); }

struct CheckCall {
  std::string file;
  bool counts = false;
};

int check(const CheckCall& call) {
  const std::string &file = call.file, name = is_stream(file) ? "<stdin>" : file;
  load_options().counts = call.counts;
  const Loaded loaded = load_script(file);
  std::size_t errors = 0, warnings = 0;
  for (const Diagnostic& d : loaded.diagnostics) {
    tell_user(d);
    errors += d.severity == Severity::error;
    warnings += d.severity == Severity::warning;
  }
  if (errors == 0) {
    const auto [first, last] = loaded.document.range();
    const Findings found =
        look_through(Program::compile(loaded.document), file, first, last, loaded.document.frame_count());
    for (const Diagnostic& d : found.errors) tell_user(d);
    for (const std::string& p : found.warnings) tell_user(fmt::format("{}: warning: {}\n", name, p));
    errors += found.errors.size(), warnings += found.warnings.size();
  }
  if (errors + warnings > 0)
    fmt::print(stderr, "{}, {}\n", counted(errors, "error"), counted(warnings, "warning"));
  else
    fmt::print("{}: no errors, {}, {}\n", visible(name), counted(loaded.document.names().size(), "object"),
               counted(static_cast<std::size_t>(loaded.document.frame_count()), "frame"));
  return errors ? wrong_input : all_done;
}

const Enlisted enlisted_check(check, [](CheckCall& call) -> Subcommand {
  return {.rank = 60,
          .name = "check",
          .sentence = "prints all errors and warnings of a script, and those that appear only in its frames",
          .takes = {script_parameter(call.file),
                    flag("-v,--verbose", "prints for each command how many objects its pattern matched", call.counts)},
          .example = "betwixt check examples/bounce.bx",
          .manual = "It checks up to 60 frames. The exit code is 1 if there is an error."};
});

}  // namespace
}  // namespace betwixt
