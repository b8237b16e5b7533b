// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// betwixt check: all errors and warnings of a script.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "app/command.h"
#include "betwixt/program.h"

namespace betwixt {
namespace {

// What only frames tell: what procedures, twerpers and filters do wrong, attachments that are left out. Some frames of
// the film, both ends among them, for two seconds at most.
std::vector<std::string> problems_of(const Document& document) {
  constexpr int looks = 60;
  const auto stop = std::chrono::steady_clock::now() + std::chrono::seconds(2);
  const Program program = Program::compile(document);
  const auto [first, last] = document.range();
  std::vector<std::string> said;
  for (int k = 0, n = std::min(looks, document.frame_count()); k < n && std::chrono::steady_clock::now() < stop; ++k) {
    const Time t = n > 1 ? Time{first.flicks + (last - first).flicks / (n - 1) * k} : first;
    for (std::string& p : program.frame(t).problems)
      if (std::find(said.begin(), said.end(), p) == said.end()) said.push_back(std::move(p));
  }
  return said;
}

}  // namespace

void add_check(CLI::App& app, int& exit_code) {
  auto* sub =
      app.add_subcommand("check", "says all errors and warnings of a script, and what goes wrong in its frames");
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
    if (errors == 0)
      for (const std::string& p : problems_of(loaded.document)) {
        fmt::print(stderr, "{}: warning: {}\n", *file, p);
        ++warnings;
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
