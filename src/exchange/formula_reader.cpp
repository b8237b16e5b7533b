// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "exchange/formula_reader.h"

#include <fmt/format.h>

#include "base/names.h"
#include "base/utf8.h"

namespace betwixt {
namespace {

constexpr char32_t prime = 0x2032;

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

std::string_view trimmed(std::string_view s) {
  while (!s.empty() && is_blank(s.front())) s.remove_prefix(1);
  while (!s.empty() && is_blank(s.back())) s.remove_suffix(1);
  return s;
}

// Returns the index behind the brace that closes the one at the beginning, or npos.
std::size_t behind_braces(std::string_view s) {
  int open = 0;
  for (std::size_t i = 0; i < s.size(); ++i) {
    if (s[i] == '\\')
      ++i;
    else if (s[i] == '{')
      ++open;
    else if (s[i] == '}' && --open == 0)
      return i + 1;
  }
  return s.npos;
}

// Returns what a part contains, without braces around all of it.
std::string_view bare(std::string_view s) {
  for (s = trimmed(s); s.starts_with('{') && behind_braces(s) == s.size();) s = trimmed(s.substr(1, s.size() - 2));
  return s;
}

// Returns the character at `i`, and moves behind it. Bytes that are no UTF-8 are characters of their own.
char32_t next_character(std::string_view s, std::size_t& i) {
  const std::size_t length = character_length(s, i);
  const char32_t c = length > 0 ? character_at(s, i, length) : 0xFFFD;
  i += std::max<std::size_t>(length, 1);
  return c;
}

}  // namespace

void mark_part(FormulaList& list, const std::string& part) {
  for (FormulaAtom& a : list) {
    if (a.part.empty()) a.part = part;
    for (FormulaList& inner : a.lists) mark_part(inner, part);
    mark_part(a.above, part), mark_part(a.below_it, part);
  }
}

// ---- Tokens

bool FormulaReader::skip_spaces() {
  while (at_ < text_.size()) {
    if (text_[at_] == '%')  // a comment ends with its line
      while (at_ < text_.size() && text_[at_] != '\n') ++at_;
    else if (is_blank(text_[at_]))
      ++at_;
    else
      return true;
  }
  return false;
}

FormulaReader::Token FormulaReader::peek() {
  Token t;
  t.at = at_;
  if (!skip_spaces()) return t;
  t.at = at_;
  if (text_[at_] != '\\') {
    std::size_t behind = at_;
    t.c = next_character(text_, behind);
    t.what = Token::character, t.length = behind - at_;
    return t;
  }
  t.what = Token::command;
  std::size_t end = at_ + 1;
  while (end < text_.size() && is_letter(text_[end])) ++end;
  if (end == at_ + 1 && end < text_.size()) next_character(text_, end);
  t.name = text_.substr(at_ + 1, end - at_ - 1);
  t.length = end - at_;
  return t;
}

FormulaReader::Token FormulaReader::take() {
  const Token t = peek();
  at_ = t.at + t.length;
  return t;
}

std::string FormulaReader::said(const Token& t) const {
  if (t.what == Token::nothing) return "the end of the formula";
  return fmt::format("'{}'", text_.substr(t.at, std::min<std::size_t>(t.length, 40)));
}

bool FormulaReader::fail_at(const Token& t, ErrorCode code, std::string message, Hint hint) {
  failed = {fail(code, "the formula has an error: " + message, std::move(hint)), t.at,
            std::max<std::size_t>(t.length, 1)};
  return false;
}

// ---- Lists

bool FormulaReader::whole(FormulaList& out) {
  FormulaList first;
  End end = End::text;
  if (!list(first, end)) return false;
  if (end == End::cell || end == End::row) {  // several lines
    FormulaAtom table = made(AtomForm::table, Token{});
    table.level = 0, table.gaps = {0, 1}, table.row_gap = 0.3;
    table.alignment = text_.find('&') == text_.npos ? "c" : "rl";
    if (!cells_from(table, std::move(first), end, End::text, Token{})) return false;
    out.push_back(std::move(table));
    return true;
  }
  const Token t = peek();
  if (end == End::brace) return fail_at(t, ErrorCode::syntax, "this } closes nothing", "write \\} for a brace");
  if (end == End::right || end == End::middle)
    return fail_at(t, ErrorCode::syntax, fmt::format("{} has no \\left before it", said(t)));
  if (end == End::end) return fail_at(t, ErrorCode::syntax, "this \\end has no \\begin");
  out = std::move(first);
  return true;
}

bool FormulaReader::ends_list(const Token& t, End& end) {
  if (t.what == Token::nothing) return end = End::text, true;
  if (is(t, '}')) return end = End::brace, true;
  if (is(t, ']') && brackets_ > 0) return end = End::bracket, true;
  if (is(t, '&')) return end = End::cell, true;
  if (is(t, "\\") || is(t, "cr") || is(t, "newline")) return end = End::row, true;
  if (is(t, "right")) return end = End::right, true;
  if (is(t, "middle")) return end = End::middle, true;
  if (is(t, "end")) return end = End::end, true;
  return false;
}

bool FormulaReader::list(FormulaList& out, End& end) {
  if (++depth_ > most_formula_depth)
    return fail_at(peek(), ErrorCode::range, fmt::format("it is nested more than {} levels deep", most_formula_depth));
  const Alphabet before = alphabet_;
  for (;;) {
    const Token t = peek();
    if (ends_list(t, end)) break;
    if (is(t, "over") || is(t, "atop") || is(t, "choose")) {
      if (!infix(out, take(), end)) return false;
      break;
    }
    if (!part_of_list(out)) return false;
  }
  alphabet_ = before;
  --depth_;
  return true;
}

// Everything before it in the list is above, everything behind it below.
bool FormulaReader::infix(FormulaList& out, const Token& t, End& end) {
  FormulaAtom a = made(AtomForm::fraction, t, AtomClass::inner);
  a.rule = is(t, "over");
  if (is(t, "choose")) a.left = '(', a.right = ')';
  a.lists.resize(2);
  a.lists[0] = std::exchange(out, {});
  if (!list(a.lists[1], end)) return false;
  out.push_back(std::move(a));
  return true;
}

bool FormulaReader::list_until(FormulaList& out, End wanted, const Token& opened) {
  End end = End::text;
  const int brackets = std::exchange(brackets_, wanted == End::bracket ? 1 : 0);
  if (!list(out, end)) return false;
  brackets_ = brackets;
  if (end == wanted) return true;
  if (end == End::text) return fail_at(opened, ErrorCode::syntax, fmt::format("{} is never closed", said(opened)));
  const Token t = peek();
  return fail_at(t, ErrorCode::syntax, fmt::format("{} comes before {} is closed", said(t), said(opened)));
}

bool FormulaReader::part_of_list(FormulaList& out) {
  FormulaList one;
  const Token t = peek();
  if (is(t, '^') || is(t, '_') || is(t, '\'')) {  // a script of nothing
    one.push_back(made(AtomForm::group, t));
    one.back().lists.resize(1);
  } else if (!nucleus(one)) {
    return false;
  }
  if (one.empty()) return true;
  const Token next = peek();
  if (one.size() > 1 && (is(next, '^') || is(next, '_') || is(next, '\''))) {
    FormulaAtom all = made(AtomForm::group, t);
    all.lists.push_back(std::move(one));
    one.clear();
    one.push_back(std::move(all));
  }
  if (one.size() == 1 && !scripts(one.back())) return false;
  std::move(one.begin(), one.end(), std::back_inserter(out));
  return true;
}

bool FormulaReader::scripts(FormulaAtom& a) {
  // A part that has scripts of its own is a nucleus as a whole.
  const auto whole = [&] {
    if (!a.has_above && !a.has_below) return;
    FormulaAtom all = made(AtomForm::group, Token{});
    all.lists.resize(1);
    all.lists[0].push_back(std::move(a));
    a = std::move(all);
  };
  for (bool fresh = true;; fresh = false) {
    const Token t = peek();
    const bool limits = is(t, "limits"), none = is(t, "nolimits");
    if (limits || none || is(t, "displaylimits")) {
      if (a.is != AtomClass::op)
        return fail_at(t, ErrorCode::syntax, fmt::format("{} can only follow a big operator or a function", said(t)));
      a.limits = limits ? FormulaAtom::Limits::on : none ? FormulaAtom::Limits::off : FormulaAtom::Limits::automatic;
      take();
    } else if (is(t, '^') || is(t, '_') || is(t, '\'')) {
      if (fresh && a.form != AtomForm::brace) whole();
      take();
      if (!script(a, !is(t, '_'), t)) return false;
    } else {
      return true;
    }
  }
}

bool FormulaReader::script(FormulaAtom& a, bool above, const Token& t) {
  bool& there = above ? a.has_above : a.has_below;
  if (there && !(above && is(t, '^') && !a.above.empty() && a.above.back().symbol == prime))
    return fail_at(t, ErrorCode::syntax, above ? "this is a second superscript" : "this is a second subscript",
                   "put what belongs together into braces");
  there = true;
  FormulaList& into = above ? a.above : a.below_it;
  if (!is(t, '\'')) return argument(into, t);
  into.push_back(sign({"", prime, AtomClass::ord}, t));
  while (is(peek(), '\'')) into.push_back(sign({"", prime, AtomClass::ord}, take()));
  return true;
}

// ---- Groups and arguments

FormulaAtom FormulaReader::made(AtomForm form, const Token& t, AtomClass is) const {
  FormulaAtom a;
  a.form = form, a.is = is, a.at = t.at, a.length = std::max<std::size_t>(t.length, 1);
  return a;
}

FormulaAtom FormulaReader::sign(const FormulaSign& s, const Token& t) const {
  FormulaAtom a = made(AtomForm::symbol, t, s.is);
  a.symbol = in_alphabet(s.code, alphabet_);
  return a;
}

// Returns where a part that begins here ends: {{ … }}, or npos.
std::size_t FormulaReader::end_of_part(std::size_t at) const {
  if (text_.substr(at, 2) != "{{") return text_.npos;
  int open = 0;
  for (std::size_t i = at; i < text_.size(); ++i) {
    if (text_[i] == '\\') {
      ++i;
    } else if (text_[i] == '{') {
      ++open;
    } else if (text_[i] == '}' && --open == 1) {
      return text_.substr(i, 2) == "}}" ? i + 2 : text_.npos;
    }
  }
  return text_.npos;
}

bool FormulaReader::marked_part(FormulaList& out) {
  const Token opened = peek();
  const std::size_t end = end_of_part(opened.at);
  const std::string_view content = bare(text_.substr(opened.at + 2, end - opened.at - 4));
  const int before = parts_[std::string(content)]++;
  take(), take();
  FormulaList inside;
  if (!list_until(inside, End::brace, opened)) return false;
  at_ = end;
  mark_part(inside, before == 0 ? std::string(content) : fmt::format("{}#{}", content, before + 1));
  std::move(inside.begin(), inside.end(), std::back_inserter(out));
  return true;
}

bool FormulaReader::group(FormulaList& out, const Token& opened) {
  if (!list_until(out, End::brace, opened)) return false;
  take();
  return true;
}

bool FormulaReader::argument(FormulaList& out, const Token& of) {
  const Token t = peek();
  End end = End::text;
  if (is(t, '{') && end_of_part(t.at) == text_.npos) {
    take();
    return group(out, t);
  }
  if (ends_list(t, end) || is(t, '^') || is(t, '_') || is(t, '\''))
    return fail_at(of, ErrorCode::syntax, fmt::format("{} needs something behind it", said(of)));
  if (++depth_ > most_formula_depth)
    return fail_at(t, ErrorCode::range, fmt::format("it is nested more than {} levels deep", most_formula_depth));
  if (!nucleus(out)) return false;
  --depth_;
  return true;
}

bool FormulaReader::optional_argument(FormulaList& out, bool& there) {
  const Token t = peek();
  there = is(t, '[');
  if (!there) return true;
  take();
  if (!list_until(out, End::bracket, t)) return false;
  take();
  return true;
}

// A text between braces as it is written.
bool FormulaReader::raw_argument(std::string_view& out, const Token& of) {
  const Token t = peek();
  if (!is(t, '{')) return fail_at(of, ErrorCode::syntax, fmt::format("{} needs braces behind it", said(of)));
  take();
  int open = 1;
  for (std::size_t i = at_; i < text_.size(); ++i) {
    if (text_[i] == '\\')
      ++i;
    else if (text_[i] == '{')
      ++open;
    else if (text_[i] == '}' && --open == 0) {
      out = text_.substr(at_, i - at_);
      at_ = i + 1;
      return true;
    }
  }
  return fail_at(t, ErrorCode::syntax, "'{' is never closed");
}

void FormulaReader::characters(FormulaList& out, const Token& t) {
  if (t.c == '~') {
    out.push_back(made(AtomForm::space, t, AtomClass::none));
    out.back().amount = 1.0 / 3;
    return;
  }
  out.push_back(sign(sign_of(t.c), t));
}

bool FormulaReader::nucleus(FormulaList& out) {
  const Token t = peek();
  if (is(t, '{')) {
    if (end_of_part(t.at) != text_.npos) return marked_part(out);
    take();
    FormulaAtom a = made(AtomForm::group, t);
    a.lists.resize(1);
    if (!group(a.lists[0], t)) return false;
    out.push_back(std::move(a));
    return true;
  }
  take();
  if (t.what == Token::command) return command(out, t);
  if (is(t, '#') || is(t, '$'))
    return fail_at(t, ErrorCode::syntax, fmt::format("{} has no meaning in a formula", said(t)),
                   fmt::format("write \\{} for the sign", static_cast<char>(t.c)));
  characters(out, t);
  return true;
}

FormulaError read_formula(std::string_view text, FormulaList& out) {
  if (text.size() > most_formula_bytes)
    return {fail(ErrorCode::range, fmt::format("a formula can have at most {} bytes", most_formula_bytes)), 0, 1};
  FormulaReader reader(text);
  if (reader.whole(out)) return {};
  return reader.failed;
}

}  // namespace betwixt
