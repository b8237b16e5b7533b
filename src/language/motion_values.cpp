// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Motions in text: T(6.28 0) R(-1turn @ wheel).
#include <fmt/format.h>

#include <algorithm>

#include "base/names.h"
#include "base/utf8.h"
#include "language/values.h"

namespace betwixt {
namespace {

bool a_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

// The factors from here on: one-letter words, each with what stands in its brackets.
std::string_view factors_from(const char* from, const char* end) {
  const char* last = from;
  for (const char* p = from; p < end;) {
    if (*p == ' ' || *p == '\t' || *p == ',' || *p == '*') {
      ++p;
      continue;
    }
    if (!a_letter(*p) || (p + 1 < end && (a_letter(p[1]) || p[1] == '-' || p[1] == '='))) break;
    const char* at = p + 1;
    while (at < end && (*at == ' ' || *at == '\t')) ++at;
    int depth = 0;
    for (; at < end; ++at) {
      depth += *at == '(' ? 1 : *at == ')' ? -1 : 0;
      if (depth == 0) break;
    }
    if (at == end || *at != ')') {  // whatever it is: the one who reads motions says what is wrong with it
      last = line_end(p, end);
      break;
    }
    p = last = at + 1;
  }
  return {from, static_cast<std::size_t>(last - from)};
}

const char* character(const char* at, const char* end, int count) {
  return at + first_characters({at, end}, static_cast<std::size_t>(std::max(0, count))).size();
}

}  // namespace

bool ValueReader::motion(Moves& out) {
  c.space();
  const char* start = c.at;
  std::string quoted;
  std::string_view text;
  if (c.peek() == '"') {
    if (!c.text(quoted)) return false;
    text = quoted;
  } else {
    text = factors_from(start, c.end);
    if (text.empty())
      return c.fail_here(ErrorCode::syntax, "a motion is wanted here",
                         "a string of T(…), R(…) and S(…), as in T(6.28 0) R(-1turn @ 0 1)");
    c.at = text.data() + text.size();
  }
  const auto part = [&](int column, int length) -> std::string_view {
    if (!quoted.empty()) return c.since(start);
    const char *from = character(text.data(), c.at, column - 1), *to = character(from, c.at, length);
    return {from, static_cast<std::size_t>(to - from)};
  };
  auto read = parse_motion(text);
  if (!read) {
    const Error& e = read.error();
    return c.fail(e.code, e.message, part(e.place.column, e.place.length), e.hint);
  }
  std::size_t sign = 0;
  for (const Factor& f : read->factors) {
    if (f.about.empty()) continue;
    const auto named = [&] {  // behind the next '@' that has a name behind it
      sign = text.find('@', sign) + 1;
      return text.find_first_not_of(" \t\r\n,", sign);
    };
    std::size_t at = named();
    while (!a_letter(text[at])) at = named();
    const std::string_view about = quoted.empty() ? text.substr(at, f.about.size()) : c.since(start);
    Cursor name(f.about);
    ObjectId id;
    ValueReader reader{name, scene, {}, {}, {}};
    if (scene.aliases->contains(f.about))
      return c.fail(ErrorCode::name, fmt::format("'{}' is an alias: a centre is one object, by its own name", f.about),
                    about);
    if (!reader.object(id)) return c.fail(name.error->code, name.error->message, about, name.error->hint);
    if (!placed(scene.objects[id.index].kind))
      return c.fail(ErrorCode::type, fmt::format("'{}' is nowhere: it cannot be a centre", f.about), about);
  }
  out = Moves(*std::move(read));
  return true;
}

}  // namespace betwixt
