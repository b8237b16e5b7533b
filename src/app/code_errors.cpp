// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "app/code_errors.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>

#include "app/command.h"
#include "app/streams.h"
#include "base/diagnostic.h"
#include "base/files.h"
#include "base/tell_user.h"
#include "syntax/script_text.h"

namespace betwixt {
namespace {

// Returns the files that a script includes by `use`.
std::vector<std::string> used(const std::string& file, std::string_view text) {
  std::vector<std::string> all;
  const ScriptText lines{std::string(text)};
  for (std::size_t i = 0; i < lines.count(); i = lines.behind(i)) {
    const auto words = line_words(lines.line(i));
    if (words.size() > 1 && words[0] == "use")
      all.push_back((std::filesystem::path(file).parent_path() / words[1]).string());
  }
  return all;
}

// Returns code as the script has it: without the values of names before it, "local k, i = 0.25, 3 return …".
std::string_view as_written(std::string_view source, std::string_view script) {
  if (!source.starts_with("local ") || script.find(source) != std::string_view::npos) return source;
  for (std::size_t at = source.find(' '); at != std::string_view::npos; at = source.find(' ', at + 1))
    if (script.find('"' + std::string(source.substr(at + 1))) != std::string_view::npos) return source.substr(at + 1);
  return source;
}

// Finds the code in the script or in those that it uses, and sets the error's place. Returns false if it is in none.
bool place_in(Diagnostic& d, Problem& p, const std::string& file, int deep = 0) {
  const auto text = script_text(file);
  if (!text) return false;
  point_at(d, p, *text, std::string(as_written(*p.source, *text)));
  if (d.what.place.line > 0) return d.what.place.file = is_stream(file) ? "<stdin>" : file, true;
  const auto files = deep < 8 ? used(file, *text) : std::vector<std::string>();
  return std::any_of(files.begin(), files.end(), [&](const auto& f) { return place_in(d, p, f, deep + 1); });
}

}  // namespace

void add_findings(Findings& found, const Frame& frame, const std::string& file) {
  for (Problem p : frame.reports) {
    if (!p.source) {
      const std::size_t n = found.warnings_said.add(p);
      if (n == found.warnings.size()) found.warnings.emplace_back();
      found.warnings[n] = found.warnings_said.text(n);
      continue;
    }
    if (std::find(found.placed.begin(), found.placed.end(), p) != found.placed.end()) continue;
    found.placed.push_back(p);
    Diagnostic d;
    d.what = fail(ErrorCode::type, {});
    Place& at = d.what.place;
    at.file = is_stream(file) ? "<stdin>" : file;
    place_in(d, p, file);
    const std::size_t n = found.errors_said.add(p, fmt::format("{}:{}:{}", at.file, at.line, at.column));
    if (n == found.errors.size()) found.errors.push_back(std::move(d));
    found.errors[n].what.message = found.errors_said.text(n);
  }
}

Findings look_through(const Program& program, const std::string& file, Time first, Time last, int frames) {
  constexpr int looks = 60;
  const auto stop = std::chrono::steady_clock::now() + std::chrono::milliseconds(1500);
  Findings found;
  for (int k = 0, n = std::min(looks, frames); k < n && std::chrono::steady_clock::now() < stop; ++k)
    add_findings(found, program.frame(n > 1 ? Time{first.flicks + (last - first).flicks / (n - 1) * k} : first), file);
  return found;
}

bool stopped_by(const Findings& found, bool keep_going) {
  for (Diagnostic d : found.errors) {
    if (keep_going) d.severity = Severity::warning;
    tell_user(d);
  }
  if (found.errors.empty() || keep_going) return false;
  tell_user("betwixt: error: nothing was made; to use the tracks' values without that code: --keep-going\n");
  return true;
}

}  // namespace betwixt
