// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "editor/named_objects.h"

#include <algorithm>

#include "base/names.h"
#include "commands/command.h"
#include "commands/verbs.h"
#include "editor/line_pieces.h"
#include "syntax/tokens.h"

namespace betwixt {
namespace {

void put(std::vector<ObjectId>& all, ObjectId id) {
  if (std::ranges::find(all, id) == all.end()) all.push_back(id);
}

// Returns the words of a line that can be names or patterns of objects, cut at the first dot.
std::vector<std::string_view> names_in(std::string_view line, bool row, const Document& d) {
  std::vector<std::string_view> all;
  LineState state;
  for (const LinePiece& p : line_pieces(line, state, d, row))
    if (p.meaning != Meaning::comment && p.meaning != Meaning::text && p.meaning != Meaning::verb &&
        p.meaning != Meaning::function && p.meaning != Meaning::number && p.meaning != Meaning::time)
      all.push_back(line.substr(p.at, p.length));
  return all;
}

}  // namespace

std::vector<ObjectId> objects_named_in(std::string_view line, std::string_view opener, const Document& d,
                                       std::size_t most) {
  std::vector<ObjectId> all;
  for (const bool row : {false, true})
    for (const std::string_view w : names_in(row ? line : opener, row && !opener.empty(), d))
      for (const ObjectId id : select(d.scene(), w)) {
        if (all.size() >= most) return all;
        if (is_pattern(w) && all.size() > 1000)
          all.push_back(id);  // too many to search for duplicates
        else
          put(all, id);
      }
  return all;
}

bool names_any(std::string_view line, std::string_view opener, const Document& d, const std::vector<ObjectId>& ids) {
  if (ids.empty()) return false;
  const auto wanted = [&](ObjectId id) { return std::ranges::find(ids, id) != ids.end(); };
  for (const bool row : {false, true})
    for (const std::string_view w : names_in(row ? line : opener, row && !opener.empty(), d)) {
      if (const ObjectId id = d.find(w); id && wanted(id)) return true;
      if (is_pattern(w) || d.aliases().contains(w))
        if (std::ranges::any_of(select(d.scene(), w), wanted)) return true;
    }
  return false;
}

}  // namespace betwixt
