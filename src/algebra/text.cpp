// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Reads and writes motions.
#include "algebra/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "base/names.h"
#include "base/utf8.h"
#include "betwixt/algebra.h"

namespace betwixt {
namespace {

using algebra::angle_text, algebra::written;
using Kind = Factor::Kind;
using Law = Factor::Law;

using algebra::Unit;
constexpr Unit lengths[] = {{"m", 1, 1}, {"cm", 1, 100}, {"mm", 1, 1000}};
constexpr Unit angle_units[] = {{"deg", pi, 180}, {"°", pi, 180}, {"turn", 2 * pi, 1}, {"rad", 1, 1}};

struct MotionReader : algebra::Cursor {
  void space() {
    while (at < text.size() && std::string_view(" \t\r\n,").find(text[at]) != std::string_view::npos) ++at;
  }
  bool accept(char c) {
    space();
    if (peek() != c) return false;
    ++at;
    return true;
  }
  // Returns the place after the bracket of the last factor.
  std::size_t behind() {
    space();
    return at + (peek() == ')' ? 1 : 0);
  }
  // Reads letters, and signs such as °, up to the next blank or bracket.
  std::string_view word() {
    const std::size_t from = at;
    while (at < text.size() && std::string_view(" \t\r\n,()@").find(text[at]) == std::string_view::npos) ++at;
    return text.substr(from, at - from);
  }
  std::string_view next_word() {
    const std::size_t from = at;
    const std::string_view w = word();
    at = from;
    return w;
  }
  // Accepts 'nan' and 'inf' too: number() rejects them with an error of its own.
  bool at_number() {
    space();
    const char c = peek();
    if ((c >= '0' && c <= '9') || c == '-' || c == '+' || c == '.') return true;
    const std::string_view w = next_word();
    return w == "nan" || w == "NaN" || w == "inf" || w == "infinity" || w == "Infinity";
  }
  // Reads a number with one of the units, or without.
  template <std::size_t n>
  bool number(double& out, const Unit (&units)[n], const char* kind, bool unit_needed = false,
              const Unit** used = nullptr) {
    space();
    const std::size_t from = at;
    if (peek() == '+') ++at;
    const char* first = text.data() + at;
    const auto [end, bad] = std::from_chars(first, text.data() + text.size(), out);
    const bool finite = bad == std::errc() && std::isfinite(out);
    if (!finite) {
      word();
      const std::size_t to = std::max(at, from + 1);
      return end != first || bad == std::errc::result_out_of_range
                 ? fail(from, to, ErrorCode::range,
                        fmt::format("'{}' is not a finite number", text.substr(from, to - from)))
                 : fail(from, to, ErrorCode::syntax, "expected a number here");
    }
    at += static_cast<std::size_t>(end - first);
    const std::size_t unit_from = at;
    const std::string_view name = word();
    if (name.empty() && (!unit_needed || out == 0)) return true;
    for (const Unit& u : units)
      if (name == u.name) {
        if (used != nullptr)
          *used = &u;
        else
          out = out * u.of / u.divisor;
        return true;
      }
    std::string known;
    for (const Unit& u : units) known += (known.empty() ? "" : ", ") + std::string(u.name);
    if (!name.empty())
      return fail(unit_from, at, ErrorCode::type, fmt::format("'{}' is not a unit of {}", name, kind),
                  fmt::format("units are {}", known));
    const std::size_t to = at;
    space();
    const std::string_view apart = next_word();
    const bool blank = std::any_of(units, units + n, [&](const Unit& u) { return u.name == apart; });
    return fail(from, to, ErrorCode::type, fmt::format("an angle needs its unit: {}", text.substr(from, to - from)),
                blank ? fmt::format("write the unit without a space: {}{}", text.substr(from, to - from), apart)
                      : fmt::format("units are {}", known));
  }
  // Reads a number without a unit: a scale or a direction.
  bool plain_number(double& out) {
    const std::size_t from = at;
    if (!number(out, lengths, "length")) {
      if (error->code != ErrorCode::type) return false;
    } else if (const char last = text[at - 1]; last != 'm') {
      return true;
    }
    error.reset();
    return fail(from, at, ErrorCode::type,
                fmt::format("expected a plain number here, not {}", text.substr(from, at - from)));
  }
  bool numbers(double (&out)[3], int& count, bool plain = false) {
    for (count = 0; at_number(); ++count) {
      if (count == 3) return fail(at, at + 1, ErrorCode::syntax, "expected at most three numbers here");
      if (!(plain ? plain_number(out[count]) : number(out[count], lengths, "length"))) return false;
    }
    return true;
  }
  // Reads the end of a factor, or reports what does not belong there.
  bool close(Kind kind) {
    if (accept(')')) return true;
    if (at == text.size()) return fail(at, at + 1, ErrorCode::syntax, "')' is missing");
    const std::size_t from = at;
    if (peek() == '@')
      ++at;
    else
      word();
    const std::size_t to = std::max(at, from + 1);
    constexpr const char* forms[] = {"T(6 0) or T(6 0 0)", "R(90deg @ 0 1) or R(90deg @ 0 1 0 axis 0 1 0)",
                                     "S(2 2 @ 0 0) or S(2 2 @ 0 0 linear)"};
    constexpr const char* names[] = {"translation", "rotation", "scaling"};
    return fail(
        from, to, ErrorCode::syntax,
        fmt::format("'{}' is not expected in a {}", text.substr(from, to - from), names[static_cast<int>(kind)]),
        forms[static_cast<int>(kind)]);
  }
  // Reads a position or a name after '@'.
  bool centre(Factor& f) {
    space();
    const std::size_t from = at;
    if (!at_number() && peek() != '(') {
      const std::string_view name = word();
      if (!is_name(name))
        return fail(from, at, ErrorCode::syntax, "expected a centre here",
                    "write @ 0 1, @ 0 1 2 or the name of an object");
      f.about = name;
      return true;
    }
    const bool bracket = accept('(');
    double n[3] = {};
    int count = 0;
    if (!numbers(n, count)) return false;
    if (count < 2) return fail(from, at, ErrorCode::syntax, "a centre must have two or three numbers");
    if (bracket && !accept(')')) return fail(at, at + 1, ErrorCode::syntax, "')' is missing");
    f.centre = {n[0], n[1], n[2]};
    return true;
  }
  bool translate(Factor& f, std::size_t from) {
    double n[3] = {};
    int count = 0;
    if (!numbers(n, count)) return false;
    if (count < 2)
      return fail(from, behind(), ErrorCode::syntax, "a translation must have two or three numbers",
                  "T(6 0) or T(6 0 0)");
    f.by = {n[0], n[1], n[2]};
    return true;
  }
  bool angle(Factor& f) {
    const std::size_t from = (space(), at);
    const Unit* unit = nullptr;
    double count = 0;
    if (!number(count, angle_units, "angle", true, &unit)) return false;
    if (unit == nullptr) return true;  // zero needs no unit
    const std::string_view digits = text.substr(from, at - from - unit->name.size());
    const auto read = algebra::read_angle(digits, count, *unit);
    if (!read)
      return fail(from, at, ErrorCode::range,
                  fmt::format("'{}' has more than {} turns", text.substr(from, at - from), algebra::most_turns));
    f.angle = read->radians, f.angle_rest = read->rest;
    return true;
  }
  bool rotate(Factor& f) {
    if (!angle(f)) return false;
    if (accept('@') && !centre(f)) return false;
    space();
    const std::size_t from = at;
    if (const std::string_view w = word(); w == "axis") {
      double n[3] = {};
      int count = 0;
      space();
      const bool bracket = accept('(');
      if (!at_number()) {
        const std::size_t name_at = at;
        const std::string_view name = word();
        if (name.size() != 1 || name[0] < 'x' || name[0] > 'z')
          return fail(name_at, at, ErrorCode::syntax, "expected an axis here",
                      "write axis x, y or z, or three numbers");
        n[name[0] - 'x'] = 1, count = 3;
      } else if (!numbers(n, count, true)) {
        return false;
      }
      if (bracket && !accept(')')) return fail(at, at + 1, ErrorCode::syntax, "')' is missing");
      if (count != 3) return fail(from, at, ErrorCode::syntax, "an axis must have three numbers", "as in axis 0 1 0");
      f.axis = {n[0], n[1], n[2]};
      if (f.axis == Vec3{}) return fail(from, at, ErrorCode::range, "this axis has no direction");
    } else if (!w.empty()) {
      return fail(from, at, ErrorCode::syntax, fmt::format("'{}' is not expected in a rotation", w),
                  "R(90deg @ 0 1) or R(90deg @ 0 1 0 axis 0 1 0)");
    }
    return true;
  }
  bool scale(Factor& f, std::size_t from) {
    double n[3] = {1, 1, 1};
    int count = 0;
    f.kind = Kind::scale;
    if (!numbers(n, count, true)) return false;
    if (count == 0)
      return fail(from, behind(), ErrorCode::syntax, "a scaling must have one, two or three numbers",
                  "S(2), S(2 1) or S(2 1 1)");
    f.by = count == 1 ? Vec3{n[0], n[0], n[0]} : Vec3{n[0], n[1], count == 3 ? n[2] : 1};
    if (accept('@') && !centre(f)) return false;
    space();
    const std::size_t word_at = at;
    if (const std::string_view w = word(); w == "linear")
      f.law = Law::linear;
    else if (!w.empty())
      return fail(word_at, at, ErrorCode::syntax, fmt::format("'{}' is not expected in a scaling", w),
                  "S(2 2 @ 0 0 linear)");
    for (int c = 0; c < 3; ++c)
      if (f.law == Law::exponential && !(f.by[c] > 0))
        return fail(from, behind(), ErrorCode::range, fmt::format("a scaling by {} has no in-between values", f.by[c]),
                    "use factors greater than 0, or the linear law: S(… linear)");
    return true;
  }
  bool factor(Factor& f) {
    const std::size_t from = at;
    const std::string_view letter = word();
    if (letter == "T")
      f.kind = Kind::translate;
    else if (letter == "R")
      f.kind = Kind::rotate;
    else if (letter == "S")
      f.kind = Kind::scale;
    else if (letter == "t" || letter == "r" || letter == "s")
      return fail(from, at, ErrorCode::syntax, fmt::format("'{}' is not a factor of a motion", letter),
                  correction(std::string(1, static_cast<char>(letter[0] - 'a' + 'A'))));
    else
      return fail(from, std::max(at, from + 1), ErrorCode::syntax, "expected a string of T(…), R(…) and S(…) here",
                  "as in T(6.28 0) R(-1turn @ 0 1)");
    if (!accept('(')) return fail(at, at + 1, ErrorCode::syntax, fmt::format("'(' is missing after {}", letter));
    const bool read = f.kind == Kind::translate ? translate(f, from)
                      : f.kind == Kind::rotate  ? rotate(f)
                                                : scale(f, from);
    if (!read) return false;
    return close(f.kind);
  }
};

std::string written(Vec3 v, int count) {
  std::string s = written(v.x);
  if (count > 1) s += " " + written(v.y);
  if (count > 2) s += " " + written(v.z);
  return s;
}

std::string centre_text(const Factor& f, int count) {
  if (!f.about.empty()) return " @ " + f.about;
  return f.centre == Vec3{} ? "" : " @ " + written(f.centre, f.centre.z != 0 ? 3 : count);
}

}  // namespace

namespace algebra {

bool Cursor::fail(std::size_t from, std::size_t to, ErrorCode code, std::string message, Hint hint) {
  if (error) return false;
  error = betwixt::fail(code, std::move(message), std::move(hint));
  const std::string_view before = text.substr(0, from), about = text.substr(before.size()).substr(0, to - from);
  const auto count = [](std::string_view part) { return static_cast<int>(count_characters(part)); };
  error->place = {"", 1, count(before) + 1, std::max(1, count(about))};
  return false;
}

std::string written(double x) { return fmt::format("{}", x == 0 ? 0.0 : x); }

}  // namespace algebra

Result<Motion> parse_motion(std::string_view text) {
  MotionReader r{{text}};
  Motion motion;
  for (r.space(); r.at < text.size(); r.space()) {
    if (!motion.factors.empty() && r.accept('*')) r.space();
    if (motion.factors.size() == 10'000) {
      r.fail(r.at, r.at + 1, ErrorCode::range, "there can be at most 10000 factors");
      return *r.error;
    }
    Factor f;
    if (!r.factor(f)) return *r.error;
    motion.factors.push_back(std::move(f));
  }
  return motion;
}

std::string to_string(const Motion& motion) {
  std::string s;
  for (const Factor& f : motion.factors) {
    if (!s.empty()) s += ' ';
    if (f.kind == Kind::translate) {
      s += "T(" + written(f.by, f.by.z == 0 ? 2 : 3);
    } else if (f.kind == Kind::rotate) {
      s += "R(" + angle_text({f.angle, f.angle_rest}) + centre_text(f, 2);
      if (f.axis != Vec3{0, 0, 1}) s += " axis " + written(f.axis, 3);
    } else {
      const int count = f.by == Vec3{f.by.x, f.by.x, f.by.x} ? 1 : f.by.z == 1 ? 2 : 3;
      s += "S(" + written(f.by, count) + centre_text(f, 2) + (f.law == Law::linear ? " linear" : "");
    }
    s += ')';
  }
  return s;
}

}  // namespace betwixt
