// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "editor/set_aside.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>

#include "commands/line_head.h"
#include "editor/journal.h"
#include "syntax/texts.h"
#include "syntax/tokens.h"

namespace betwixt {
namespace {

constexpr std::size_t longest_shown = 200;  // bytes of a command in a message

std::string as_text(const SetAside& c) {
  return as_comment(fmt::format("Set aside, {}: {}", c.where, c.why)) + as_script("", {&c.step, 1});
}

}  // namespace

std::string set_aside_path(const std::string& script) {
  std::error_code ignored;
  const std::string name = script.empty() ? "betwixt" : script;
  return std::filesystem::weakly_canonical(name, ignored).string() + ".set-aside";
}

Status set_aside(const std::string& script, std::span<const SetAside> commands) {
  const std::string path = set_aside_path(script);
  const auto there = read_script(path);
  if (!there) return there.error();
  const std::string before = there->value_or("");
  std::string text = before;
  for (const SetAside& c : commands)
    if (const std::string one = as_text(c); before.find(one) == std::string::npos) text += one;
  return text == before ? Status(Nothing{}) : write_script(path, text);
}

std::string why_refused(const Diagnostics& all) {
  const auto first = std::ranges::find(all, Severity::error, &Diagnostic::severity);
  return first == all.end() ? std::string() : first->what.message;
}

std::optional<Mended> without_errors(std::string_view text, const std::string& name, std::size_t bytes,
                                     const Diagnostics& errors) {
  std::map<int, std::string> wrong;  // line numbers and reasons
  for (const Diagnostic& d : errors) {
    if (d.severity != Severity::error || d.what.place.line < 1) continue;
    if (d.what.place.file != name) return std::nullopt;
    wrong.emplace(d.what.place.line, d.what.message);
  }
  Mended out;
  int number = 1;
  bool with_rows = false;  // skips the rows and the block of a wrong line
  std::size_t wrong_margin = 0;
  Indentation rows;
  for (std::size_t at = 0; at < text.size();) {
    const LogicalLine line = logical_line(text.substr(at));
    const std::size_t end = static_cast<std::size_t>(line.next(text.data() + text.size()) - text.data());
    const std::string_view all = text.substr(at, end - at);
    const int lines = static_cast<int>(std::count(all.begin(), all.end(), '\n'));
    const auto found = wrong.lower_bound(number);
    const bool is_wrong = found != wrong.end() && found->first < number + std::max(lines, 1);
    const std::string_view words = all.substr(0, all.find_last_not_of('\n') + 1);
    const std::size_t margin = indentation(all);
    with_rows = with_rows && (margin > wrong_margin || words.empty());
    const bool row = !empty_line(all) && rows.row(all);
    if (is_wrong && at >= bytes) return std::nullopt;
    if (is_wrong) {
      out.lines.push_back({fmt::format("line {}", number), {{std::string(words)}, {}}, found->second});
      with_rows = !row, wrong_margin = margin;
    } else if (with_rows) {
      (out.lines.back().step.lines[0] += "\n") += words;
    } else {
      out.text += all;
    }
    at = end, number += lines;
  }
  return out.lines.empty() ? std::nullopt : std::optional(std::move(out));
}

std::string set_aside_message(const std::string& script, std::span<const SetAside> commands) {
  const SetAside& first = commands.front();
  const std::string line = first.step.lines[0];
  return fmt::format("{} of the history failed and {} moved to '{}': {}{}: {}",
                     commands.size() == 1 ? "a command" : fmt::format("{} commands", commands.size()),
                     commands.size() == 1 ? "was" : "were", set_aside_path(script), line.substr(0, longest_shown),
                     commands.size() == 1 ? "" : " (the first)", first.why);
}

}  // namespace betwixt
