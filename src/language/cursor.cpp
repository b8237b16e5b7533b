// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "language/cursor.h"

#include <fast_float/fast_float.h>
#include <fmt/format.h>

#include <cmath>
#include <numeric>

#include "base/names.h"
#include "betwixt/math.h"
#include "language/formula.h"
#include "syntax/texts.h"

namespace betwixt {

bool Cursor::fail(ErrorCode code, std::string message, std::string_view about, Hint hint) {
  return fail(betwixt::fail(code, std::move(message), std::move(hint)), about);
}

bool Cursor::fail(Error e, std::string_view about) {
  if (error) return false;
  e.place = {};
  if (e.code == ErrorCode::name && e.subject.empty() && is_name(about)) e.subject = about;
  error = std::move(e), where = about;
  return false;
}

bool Cursor::fail_here(ErrorCode code, std::string message, Hint hint) {
  while (at < end && (*at == ' ' || *at == '\t')) ++at;
  const char* start = at;
  const std::string_view w = peek_word();
  return fail(code, std::move(message), w.empty() ? std::string_view(start, at < end ? 1 : 0) : w, std::move(hint));
}

void Cursor::space() { at = space_end(at, end, depth > 0); }

bool Cursor::at_line_end() {
  space();
  return at == end || *at == '\n';
}

std::string_view Cursor::word() {
  const char* const start = at;
  at = word_end(at, end);
  return since(start);
}

std::string_view Cursor::peek_word() {
  const char* start = at;
  const std::string_view w = word();
  at = start;
  return w;
}

bool Cursor::accept_word(std::string_view w) {
  space();
  if (peek_word() != w) return false;
  at += w.size();
  return true;
}

bool Cursor::accept(char c) {
  space();
  if (at == end || *at != c) return false;
  ++at;
  return true;
}

bool Cursor::open() {
  if (!accept('(')) return fail_here(ErrorCode::syntax, "an opening bracket '(' is missing here");
  if (static_cast<std::size_t>(depth) < brackets.size()) brackets[static_cast<std::size_t>(depth)] = at - 1;
  ++depth;
  return true;
}

bool Cursor::close() {
  space();
  if (at == end) return fail(ErrorCode::syntax, "a bracket is not closed before the text ends", {end, 0});
  if (*at != ')')
    return fail_here(ErrorCode::syntax,
                     fmt::format("a closing bracket ')' is missing before {}",
                                 quoted_word(peek_word().empty() ? std::string_view(at, 1) : peek_word())));
  ++at;
  --depth;
  return true;
}

bool Cursor::number(double& out) {
  const char* const start = (space(), at);
  std::optional<Quantity> q;
  if (!number(out, q)) return false;
  if (!q || q->of == Quantity::Of::number) return true;
  return fail(ErrorCode::type, fmt::format("expected a plain number here, not {}", to_string(q->of)), since(start));
}

bool Cursor::number(double& out, std::optional<Quantity>& of) {
  space();
  const char* const start = at;
  const char* const first = at + (peek() == '-' || peek() == '+');
  if (first < end && !is_digit(*first) && *first != '.' && formula_begins(*this)) {
    of.emplace();
    return formula(*this, *of) && (out = of->value, true);
  }
  if (!literal(out)) return false;
  const char* p = at;
  while (p < end && is_letter(*p)) ++p;
  if (!formula_goes_on(p, end)) return true;
  at = start;
  of.emplace();
  return formula(*this, *of) && (out = of->value, true);
}

bool Cursor::literal(double& out) {
  space();
  const char* start = at;
  const char* p = at;
  const bool plus = p < end && *p == '+';
  if (p < end && (*p == '-' || *p == '+')) ++p;
  if (!(p < end && (is_digit(*p) || (*p == '.' && p + 1 < end && is_digit(p[1]))))) {
    if (at_line_end()) return fail_here(ErrorCode::syntax, "a number is missing here");
    const std::string_view word = peek_word().empty() ? std::string_view(at, 1) : peek_word();
    return fail_here(ErrorCode::syntax, fmt::format("{} is not a number", quoted_word(word)), near_name(*this, word));
  }
  const auto r = fast_float::from_chars(plus ? p : at, end, out);
  at = r.ptr;
  // "1..24": neither dot belongs to the number.
  if (at < end && at[-1] == '.' && *at == '.') --at;
  if (r.ec != std::errc{} && r.ec != std::errc::result_out_of_range)
    return fail_here(ErrorCode::syntax, "this is not a number");
  if (!std::isfinite(out))
    return fail(ErrorCode::range, fmt::format("{} is too large for a number", quoted_word(since(start))), since(start));
  return true;
}

bool Cursor::whole_number(long low, long high, const char* what, long& out) {
  space();
  const char* start = at;
  double d = 0;
  if (!number(d)) return false;
  if (d != std::floor(d) || d < static_cast<double>(low) || d > static_cast<double>(high))
    return fail(ErrorCode::range, fmt::format("{} must be a whole number from {} to {}", what, low, high),
                since(start));
  out = static_cast<long>(d);
  return true;
}

std::string_view Cursor::unit() {
  const char* start = at;
  while (at < end && is_letter(*at)) ++at;
  return since(start);
}

std::string quoted_word(std::string_view s) {
  return s.size() > 40 ? fmt::format("'{}…'", s.substr(0, 36)) : fmt::format("'{}'", s);
}

std::string hint_of_escape(std::string_view from) {
  std::size_t end = 1;
  while (end < from.size() && std::isalpha(static_cast<unsigned char>(from[end]))) ++end;
  if (end == 1) return "a text can contain \\n \\t \\\" \\\\";
  return fmt::format("write \\{}, or put the text between \"\"\" and \"\"\"", from.substr(0, end));
}

bool Cursor::text(std::string& out) {
  space();
  const char* const start = at;
  if (peek() != '"') return fail_here(ErrorCode::syntax, "a text in double quotes is missing here");
  const QuotedEnd quoted = quoted_end(start, end);
  if (begins_block(start, end)) {
    if (!quoted.closed) return fail(ErrorCode::syntax, "this text is never closed by \"\"\"", {start, 3});
    out.assign(start + 3, quoted.at - 3);
    for (std::size_t cr; (cr = out.find("\r\n")) != std::string::npos;) out.erase(cr, 1);  // all lines end alike
  } else {
    const std::string_view written = between(start + 1, quoted.at - quoted.closed);
    if (const auto wrong = read_escapes(written, out))
      return fail(ErrorCode::syntax, fmt::format("a text cannot contain '{}'", written.substr(*wrong, 2)),
                  written.substr(*wrong, 2), hint_of_escape(written.substr(*wrong)));
    if (!quoted.closed)
      return fail(ErrorCode::syntax, "this text is not closed on the same line", {start, 1},
                  "end it with \", or begin and end it with \"\"\" if it has several lines");
    if (quoted.at < end && (std::isalnum(static_cast<unsigned char>(*quoted.at)) || *quoted.at == '%'))
      return fail(ErrorCode::syntax, "the text ends at this quote", {quoted.at - 1, 1},
                  "write \\\" for a quote inside a text; code may use '…' instead");
  }
  at = quoted.at;
  return true;
}

bool Cursor::angle(double& radians) {
  space();
  const char* start = at;
  double n = 0;
  std::optional<Quantity> q;
  if (!number(n, q)) return false;
  if (q && q->of != Quantity::Of::angle && n != 0)
    return fail(ErrorCode::type, fmt::format("expected an angle here, not {}", to_string(q->of)), since(start),
                q->of == Quantity::Of::number ? "write …*1deg for degrees" : "");
  const std::string_view u = q ? std::string_view("deg") : unit();
  if (u == "deg")
    radians = n * (pi / 180);
  else if (u == "turn")
    radians = n * (2 * pi);
  else if (u == "rad" || (u.empty() && n == 0))
    radians = n;
  else if (u.empty())
    return fail(ErrorCode::type, "an angle needs a unit", since(start),
                fmt::format("write {}deg; units are deg, rad and turn", since(start)));
  else
    return fail(ErrorCode::type, fmt::format("'{}' is not a unit of angles", u), u, "units are deg, rad and turn");
  if (!std::isfinite(radians)) return fail(ErrorCode::range, "this angle is too large", since(start));
  return true;
}

bool Cursor::number_or_angle(double& out, bool& is_angle) {
  const char* const start = (space(), at);
  std::optional<Quantity> q;
  if (!number(out, q)) return false;
  is_angle = q ? q->of == Quantity::Of::angle : !unit().empty();
  at = start;
  return is_angle ? angle(out) : number(out);
}

bool Cursor::per_second(Rate& out, const char* what) {
  space();
  const char* start = at;
  double num = 0, den = 1;
  if (!literal(num)) return false;
  if (peek() == '/') {
    ++at;
    if (!literal(den)) return false;
  }
  // 23.976 means 23976/1000: scaling keeps the numbers whole.
  while ((num != std::floor(num) || den != std::floor(den)) && den < 1e6) num *= 10, den *= 10;
  if (!(num >= 1 && den >= 1 && num <= 1e9 && den <= 1e7 && num / den <= 1e5 && num / den >= 1e-4) ||
      num != std::floor(num) || den != std::floor(den))
    return fail(ErrorCode::range, fmt::format("{} per second must be from 0.0001 to 100000", what), since(start));
  const auto n = static_cast<std::int64_t>(num), d = static_cast<std::int64_t>(den);
  const auto common = std::gcd(n, d);
  out = {n / common, d / common};
  return true;
}

bool stands_in(std::string_view text, std::string_view word) {
  const auto inside = [](char c) { return is_letter(c) || is_digit(c) || c == '-' || c == '_'; };
  for (std::size_t at = 0; (at = text.find(word, at)) != std::string_view::npos; ++at) {
    const std::size_t behind = at + word.size();
    if ((at == 0 || !inside(text[at - 1])) && (behind == text.size() || !inside(text[behind]))) return true;
  }
  return false;
}

}  // namespace betwixt
