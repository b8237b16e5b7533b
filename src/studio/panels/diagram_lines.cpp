// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/panels/diagram_lines.h"

#include <fmt/format.h>

#include <algorithm>

#include "betwixt/language.h"
#include "betwixt/object.h"
#include "syntax/tokens.h"

namespace betwixt::studio {

std::optional<std::string> line_that_recreates(const std::string& text, const std::string& name,
                                               const std::string& parameter, const std::string& value) {
  const std::string_view all = text;
  const char* const end = all.data() + all.size();
  for (std::string_view rest = all; !rest.empty();) {
    const LogicalLine one = logical_line(rest);
    const char* const begin = rest.data();
    std::string_view pieces = between(begin, one.end);
    rest = between(one.next(end), end);
    if (take_piece(pieces) != "create" || take_piece(pieces) != name) continue;
    const std::string_view line = without_comment(between(begin, one.end));
    const std::string said = parameter + "=" + value;
    std::string now(between(begin, one.end));
    std::string_view old = line.substr(line.size());  // nothing, at its end
    while (!pieces.empty()) {
      const std::string_view piece = take_piece(pieces);
      if (piece.empty()) break;
      if (piece.starts_with(parameter + "=")) old = piece;
    }
    now.replace(static_cast<std::size_t>(old.data() - begin), old.size(), (old.empty() ? " " : "") + said);
    const auto number = [&](const char* at) { return 1 + static_cast<int>(std::count(all.data(), at, '\n')); };
    return Session::rewrite_line(number(begin), number(one.end), now + "\n");
  }
  return std::nullopt;
}

std::optional<std::string> diagram_line(const Workspace& workspace, ObjectId id, std::string_view function,
                                        const std::string& value) {
  const Document& d = workspace.session().document();
  const bool content = function == "of" || function == "layout" || function == "direction";
  if (kind(d, id) != Kind::diagram || (!content && function != "nodes" && function != "apart")) return std::nullopt;
  const Time t = workspace.time();
  if (content && t > d.range().first)
    return fmt::format("at {} rearrange {} {}={}", format_time(t, d), d.name(id), function, value);
  return line_that_recreates(workspace.text(), d.name(id), std::string(function), value);
}

}  // namespace betwixt::studio
