// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "commands/script.h"

#include <fmt/format.h>

#include "commands/plugins.h"

namespace betwixt {
namespace {

constexpr int most_errors = 1000;  // said; the rest is noise

}  // namespace

Script::Script(Scene& scene, Diagnostics& to, const LoadOptions& how) : diagnostics(to), options(how) {
  adopt_plugins(scene);
}

void Script::carry(const Carried& from, const std::string& script) {
  frames_read = from.frames_read, ticks_read = from.ticks_read;
  included = from.included, copied = from.copied;
  live = true;
  std::error_code ignored;
  if (!script.empty()) open_files.push_back(std::filesystem::weakly_canonical(script, ignored));
}

void Script::report(Severity severity, Error error, std::string_view about) {
  if (severity == Severity::error && ++errors > most_errors) {
    if (!given_up)
      diagnostics.push_back({Severity::error,
                             fail(Code::syntax, fmt::format("more than {} errors; the rest is not said", most_errors)),
                             {},
                             0});
    given_up = true;
    return;
  }
  diagnostics.push_back(source.diagnose(severity, std::move(error), about));
}

void Script::note(Severity severity, std::string message, std::string_view about, std::string hint) {
  report(severity, fail(Code::syntax, std::move(message), std::move(hint)), about);
}

std::optional<Diagnostic> Script::withheld(Severity severity, std::string message, std::string_view about) {
  if (given_up) return std::nullopt;
  return source.diagnose(severity, fail(Code::syntax, std::move(message)), about);
}

}  // namespace betwixt
