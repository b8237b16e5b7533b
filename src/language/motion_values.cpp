// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Reads motions: T(6.28 0) R(-1turn @ wheel).
#include <fmt/format.h>

#include <algorithm>

#include "base/names.h"
#include "base/utf8.h"
#include "language/formula.h"
#include "language/values.h"
#include "syntax/tokens.h"

namespace betwixt {
namespace {

// Returns the factors that begin here: one-letter words, each with its brackets.
std::string_view factors_from(const char* from, const char* end) {
  const char* last = from;
  for (const char* p = from; p < end;) {
    if (blank(*p) || *p == '*') {
      ++p;
      continue;
    }
    if (!is_letter(*p) || (p + 1 < end && (is_letter(p[1]) || p[1] == '-' || p[1] == '='))) break;
    const char* at = p + 1;
    while (at < end && blank(*at)) ++at;
    const char* const behind = at < end && *at == '(' ? bracket_end(at, end) : at;
    if (behind == at) {  // anything else; the reader of motions reports the error
      last = line_end(p, end);
      break;
    }
    p = last = behind;
  }
  return {from, static_cast<std::size_t>(last - from)};
}

// The text of a motion with its formulas replaced by their values, and the source of each character.
class Spelled {
 public:
  std::string text;

  // Without any replacement.
  explicit Spelled(std::string_view source) : text(source) {
    for (const char& at : source) from_.push_back(&at);
    from_.push_back(source.data() + source.size());
  }
  // Reads `source`, which ends at the cursor `c`.
  Spelled(Cursor& c, const Scene& scene, std::string_view source) : end_(source.data() + source.size()) {
    int depth = 0;
    for (const char* at = source.data(); at < end_ && !c.error;) {
      const char* const next = depth > 0 && begins_word(at) ? behind_formula(c, scene, at) : nullptr;
      if (!next) {
        depth += *at == '(' ? 1 : *at == ')' ? -1 : 0;
        before_ = space(*at) ? before_ : *at;
        text += *at;
        from_.push_back(at++);
      } else {
        at = next, before_ = '0';
      }
    }
    from_.push_back(end_);
  }

  // Returns the source of a part of the text, given by a column that counts from 1 and a number of characters.
  std::string_view source(int column, int characters) const {
    const std::string_view all = text;
    const std::size_t begin = first_characters(all, static_cast<std::size_t>(std::max(0, column - 1))).size();
    return part(begin, first_characters(all.substr(begin), static_cast<std::size_t>(std::max(0, characters))).size());
  }
  std::string_view part(std::size_t at, std::size_t bytes) const {
    return {from_[at], static_cast<std::size_t>(from_[at + bytes] - from_[at])};
  }

 private:
  static bool space(char c) { return blank(c) || c == '\n'; }
  static bool begins_word(const char* at) { return !space(*at) && (space(at[-1]) || at[-1] == '(' || at[-1] == '@'); }
  // If a formula that is more than a number begins here, writes its value and returns its end. Otherwise returns
  // nullptr.
  const char* behind_formula(Cursor& c, const Scene& scene, const char* at) {
    Cursor ahead = c;
    ahead.at = at, ahead.end = end_;
    if (const std::string_view name = ahead.peek_word(); name.find('{') != name.npos) {
      std::string meant;
      if (!one_name(c, name, meant)) return nullptr;
      text += meant;
      from_.insert(from_.end(), meant.size(), at);
      return at + name.size();
    }
    const std::string_view word = ahead.peek_word(), head = word.substr(0, word.find_first_of("+-*/%^"));
    const bool name = !word.empty() && is_letter(word.front());
    const bool known = is_formula_word(head) || (c.lets && c.lets->contains(head));
    if (name && (a_word(word) || (before_ == '@' && (!known || scene.names.find(word))) || !formula_begins(ahead)))
      return nullptr;
    ValueReader values{ahead, scene, {}, {}, {}};
    if (*at == '(' && values.is_vector()) return nullptr;
    std::optional<Quantity> q;
    double plain = 0;
    const bool read = ahead.number(plain, q);
    if (!q) return nullptr;
    if (!read) return c.error = ahead.error, c.where = ahead.where, nullptr;
    const std::string came_to = write_quantity(*q);
    text += came_to;
    from_.insert(from_.end(), came_to.size(), at);
    return ahead.at;
  }
  // Returns whether the word is one that a factor may contain besides numbers.
  static bool a_word(std::string_view w) {
    static constexpr std::string_view words[] = {"T", "R", "S", "axis", "linear", "x", "y", "z"};
    return std::find(std::begin(words), std::end(words), w) != std::end(words);
  }

  std::vector<const char*> from_;
  const char* end_ = nullptr;
  char before_ = ' ';  // the last character that is no blank
};

}  // namespace

bool ValueReader::motion(Moves& out) {
  c.space();
  const char* start = c.at;
  std::string quoted;
  if (c.peek() == '"' && !c.text(quoted)) return false;
  const std::string_view stands = c.at > start ? std::string_view() : factors_from(start, c.end);
  if (c.at == start && stands.empty())
    return c.fail_here(ErrorCode::syntax, "expected a motion here",
                       "a string of T(…), R(…) and S(…), as in T(6.28 0) R(-1turn @ 0 1)");
  c.at += stands.size();
  const Spelled spelled = stands.empty() ? Spelled(quoted) : Spelled(c, scene, stands);
  if (c.error) return false;
  const std::string_view text = spelled.text;
  const auto part = [&](std::string_view in_source) { return stands.empty() ? c.since(start) : in_source; };
  auto read = parse_motion(text);
  if (!read) {
    const Error& e = read.error();
    return c.fail(e, part(spelled.source(e.place.column, e.place.length)));
  }
  std::size_t sign = 0;
  for (const Factor& f : read->factors) {
    if (f.about.empty()) continue;
    const auto named = [&] {  // moves after the next '@' that has a name after it
      sign = text.find('@', sign) + 1;
      return text.find_first_not_of(" \t\r\n,", sign);
    };
    std::size_t at = named();
    while (!is_letter(text[at])) at = named();
    const std::string_view about = part(spelled.part(at, f.about.size()));
    Cursor name(f.about);
    ObjectId id;
    ValueReader reader{name, scene, {}, {}, {}};
    if (scene.aliases->contains(f.about))
      return c.fail(ErrorCode::name, fmt::format("'{}' is an alias; a centre must be one object", f.about), about);
    if (!reader.object(id)) return c.fail(name.error->code, name.error->message, about, name.error->hint);
    if (!placed(scene.objects[id.index].kind))
      return c.fail(ErrorCode::type, fmt::format("'{}' has no position, so it cannot be a centre", f.about), about);
  }
  out = Moves(*std::move(read));
  return true;
}

}  // namespace betwixt
