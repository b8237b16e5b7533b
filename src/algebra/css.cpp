// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Lists of CSS transforms as motions, motions as such lists, and what a browser shows between two lists.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "algebra/text.h"
#include "betwixt/algebra.h"

namespace betwixt {
namespace {

using algebra::angle_text, algebra::Unit, algebra::written;
using Kind = Factor::Kind;
using Law = Factor::Law;

constexpr Unit angles[] = {{"deg", pi, 180}, {"grad", pi, 200}, {"rad", 1, 1}, {"turn", 2 * pi, 1}};

struct Function {
  std::string_view name;
  Kind kind;
  int least, most;  // so many values
  int axis;         // the only one that it is about, or -1
  std::string_view values;
};
constexpr Function functions[] = {
    {"translate", Kind::translate, 1, 2, -1, "one or two lengths"},
    {"translateX", Kind::translate, 1, 1, 0, "one length"},
    {"translateY", Kind::translate, 1, 1, 1, "one length"},
    {"translateZ", Kind::translate, 1, 1, 2, "one length"},
    {"translate3d", Kind::translate, 3, 3, -1, "three lengths"},
    {"rotate", Kind::rotate, 1, 1, 2, "one angle"},
    {"rotateX", Kind::rotate, 1, 1, 0, "one angle"},
    {"rotateY", Kind::rotate, 1, 1, 1, "one angle"},
    {"rotateZ", Kind::rotate, 1, 1, 2, "one angle"},
    {"rotate3d", Kind::rotate, 4, 4, -1, "three numbers and an angle"},
    {"scale", Kind::scale, 1, 2, -1, "one or two numbers"},
    {"scaleX", Kind::scale, 1, 1, 0, "one number"},
    {"scaleY", Kind::scale, 1, 1, 1, "one number"},
    {"scaleZ", Kind::scale, 1, 1, 2, "one number"},
    {"scale3d", Kind::scale, 3, 3, -1, "three numbers"},
};
constexpr std::string_view no_motions[] = {"matrix", "matrix3d", "skew", "skewX", "skewY", "perspective"};
constexpr const char* wanted = "translate(), rotate() and scale(), with X, Y, Z or 3d behind the name";

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }
bool digit(char c) { return c >= '0' && c <= '9'; }
// CSS does not tell capitals from small letters.
bool same(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](char p, char q) { return lower(p) == lower(q); });
}

struct Reader : algebra::Cursor {
  char peek(std::size_t further = 0) const { return at + further < text.size() ? text[at + further] : '\0'; }
  // Blanks and comments.
  void space() {
    for (;;) {
      while (at < text.size() && std::string_view(" \t\r\n\f").find(text[at]) != std::string_view::npos) ++at;
      if (text.substr(at, 2) != "/*") return;
      at = std::min(text.find("*/", at + 2), text.size() - 2) + 2;
    }
  }
  std::string_view word() {
    const std::size_t from = at;
    const auto part = [](char c) {
      return digit(c) || (lower(c) >= 'a' && lower(c) <= 'z') || c == '-' || c == '_' || (c & 0x80) != 0;
    };
    while (at < text.size() && part(text[at])) ++at;
    return text.substr(from, at - from);
  }
  // As CSS has it: no point without a digit behind it, and 1em is 1 with a unit.
  bool number(double& out) {
    const std::size_t from = at;
    std::size_t end = at + (peek() == '+' || peek() == '-');
    const std::size_t first = end;
    const auto digits = [&] {
      const std::size_t begin = end;
      while (end < text.size() && digit(text[end])) ++end;
      return end > begin;
    };
    const auto c = [&](std::size_t i) { return i < text.size() ? text[i] : '\0'; };
    digits();
    if (c(end) == '.' && digit(c(end + 1))) ++end, digits();
    if (end == first) {
      const std::string_view name = word();
      if (!name.empty() && peek() == '(')
        return fail(from, at, ErrorCode::type, fmt::format("{}() is not worked out here", name), "write the number");
      return fail(from, std::max(at, from + 1), ErrorCode::syntax, "a number is wanted here");
    }
    if (lower(c(end)) == 'e' && (digit(c(end + 1)) || ((c(end + 1) == '+' || c(end + 1) == '-') && digit(c(end + 2)))))
      end += 2, digits();
    const std::size_t plus = peek() == '+';
    const auto read = std::from_chars(text.data() + from + plus, text.data() + end, out);
    at = end;
    return read.ec == std::errc() || too_large(from);
  }
  bool too_large(std::size_t from) {
    return fail(from, at, ErrorCode::range,
                fmt::format("'{}' is too large or too small a number", text.substr(from, at - from)));
  }
  // What stands behind a number: a unit, or nothing.
  std::string_view unit() {
    if (peek() != '%') return word();
    return text.substr(at++, 1);
  }
  bool length(double& out) {
    const std::size_t from = at;
    if (!number(out)) return false;
    const std::size_t unit_from = at;
    const std::string_view name = unit();
    if (same(name, "px") || (name.empty() && out == 0)) return true;
    if (name.empty())
      return fail(from, at, ErrorCode::type, fmt::format("a length needs its unit: {}", text.substr(from, at - from)),
                  "px");
    return fail(unit_from, at, ErrorCode::type, fmt::format("'{}' is not a unit of length here", name),
                "px: what others come to depends on the page");
  }
  bool angle(double& out) {
    const std::size_t from = at;
    if (!number(out)) return false;
    const std::size_t unit_from = at;
    const std::string_view name = unit();
    if (name.empty() && out == 0) return true;
    for (const Unit& u : angles)
      if (same(name, u.name)) {
        out = out * u.of / u.divisor;
        return std::isfinite(out) || too_large(from);
      }
    return fail(name.empty() ? from : unit_from, at, ErrorCode::type,
                name.empty() ? fmt::format("an angle needs its unit: {}", text.substr(from, at - from))
                             : fmt::format("'{}' is not a unit of angle", name),
                "units are deg, grad, rad, turn");
  }
  bool plain(double& out) {
    if (!number(out)) return false;
    const std::size_t unit_from = at;
    const std::string_view name = unit();
    return name.empty() ||
           fail(unit_from, at, ErrorCode::type, fmt::format("a number without a unit is wanted here, not '{}'", name),
                name == "%" ? "50% is 0.5" : "");
  }
  const Function* function_name() {
    const std::size_t from = at;
    const std::string_view name = word();
    for (const Function& f : functions)
      if (same(name, f.name)) {
        if (peek() == '(') return &f;
        fail(at, at + 1, ErrorCode::syntax, fmt::format("'(' is missing right behind {}", f.name));
        return nullptr;
      }
    for (const std::string_view n : no_motions)
      if (same(name, n)) {
        fail(from, at, ErrorCode::type, fmt::format("{}() is no translation, rotation or scaling", n),
             fmt::format("what is read: {}", wanted));
        return nullptr;
      }
    if (same(name, "none"))
      fail(from, at, ErrorCode::syntax, "'none' stands alone or not at all");
    else if (name.empty())
      fail(from, from + 1, ErrorCode::syntax, "a CSS transform is wanted here",
           "as in translate(10px, 20px) rotate(90deg)");
    else
      fail(from, at, ErrorCode::name, fmt::format("'{}' is no CSS transform", name),
           fmt::format("what is read: {}", wanted));
    return nullptr;
  }
  bool function(Factor& out) {
    const std::size_t from = at;
    const Function* f = function_name();
    if (f == nullptr) return false;
    double values[4] = {};
    int count = 0;
    do {
      ++at;  // '(' or ','
      space();
      if (count == f->most || (count == 0 && peek() == ')')) return wrong_count(*f, from);
      double& value = values[count++];
      const bool read = f->kind == Kind::translate                  ? length(value)
                        : f->kind == Kind::scale || count < f->most ? plain(value)
                                                                    : angle(value);
      if (!read) return false;
      space();
    } while (peek() == ',');
    if (at == text.size()) return fail(at, at + 1, ErrorCode::syntax, "')' is missing");
    if (peek() != ')') return fail(at, at + 1, ErrorCode::syntax, "',' or ')' is wanted here");
    if (count < f->least) return wrong_count(*f, from);
    ++at;
    return fill(out, *f, values, count) || fail(from, at, ErrorCode::range, "this axis has no direction");
  }
  bool wrong_count(const Function& f, std::size_t from) {
    return fail(from, at + 1, ErrorCode::syntax, fmt::format("{}() takes {}", f.name, f.values));
  }
  static bool fill(Factor& out, const Function& f, const double (&values)[4], int count) {
    out.kind = f.kind;
    if (f.kind == Kind::rotate) {
      out.angle = values[f.most - 1];
      out.axis = {values[0], values[1], values[2]};
      if (f.axis >= 0) out.axis = {}, out.axis[f.axis] = 1;
      return std::isnormal(1 / betwixt::length(out.axis));
    }
    if (f.kind == Kind::scale) out.law = Law::linear, out.by = {1, 1, 1};
    if (f.axis >= 0) {
      out.by[f.axis] = values[0];
      return true;
    }
    for (int i = 0; i < count; ++i) out.by[i] = values[i];
    if (f.kind == Kind::scale && count == 1) out.by.y = values[0];
    return true;
  }
};

// ---- Writing

Error about(std::size_t i, std::string what, std::string hint) {
  return fail(ErrorCode::type, fmt::format("factor {}: {}", i + 1, what), std::move(hint));
}

// CSS knows places and the linear law only.
Status has_css(const Motion& motion) {
  if (auto sound = check(motion); !sound) return sound;
  for (std::size_t i = 0; i < motion.factors.size(); ++i) {
    const Factor& f = motion.factors[i];
    if (!f.about.empty())
      return about(i, fmt::format("its centre is '{}', and CSS knows no objects", f.about), "a place in numbers");
    if (f.kind == Kind::scale && f.law == Law::exponential && f.by != Vec3{1, 1, 1})
      return about(i, "it grows by the exponential law, and CSS by the linear one", "S(… linear)");
  }
  return Nothing{};
}

std::string list(Vec3 v, int count, std::string_view unit) {
  std::string s;
  for (int i = 0; i < count; ++i) s += (i > 0 ? ", " : "") + written(v[i]) + std::string(unit);
  return s;
}

std::string translate_text(Vec3 way, bool in_space) {
  return fmt::format("translate{}({})", in_space ? "3d" : "", list(way, in_space ? 3 : 2, "px"));
}

// All of it, or the function of the same name that does nothing.
std::string css_text(const Factor& f, bool all) {
  if (f.kind == Kind::translate) return translate_text(all ? f.by : Vec3{}, f.by.z != 0);
  if (f.kind == Kind::scale) {
    const int count = f.by.z == 1 ? 2 : 3;
    return fmt::format("scale{}({})", count == 3 ? "3d" : "", list(all ? f.by : Vec3{1, 1, 1}, count, ""));
  }
  const std::string angle = all ? angle_text(f.angle) : "0deg";
  return f.axis == Vec3{0, 0, 1} ? fmt::format("rotate({})", angle)
                                 : fmt::format("rotate3d({}, {})", list(f.axis, 3, ""), angle);
}

void append(std::string& css, const std::string& function) { css += (css.empty() ? "" : " ") + function; }

// ---- Between two lists

// The factor of the same kind that does nothing.
Factor nothing_like(const Factor& f) {
  return f.kind == Kind::translate ? translate_by({})
         : f.kind == Kind::rotate  ? rotate_by(0, f.centre, f.axis)
                                   : scale_by({1, 1, 1}, f.centre, Law::linear);
}

Vec3 lerp(Vec3 a, Vec3 b, double t) { return {std::lerp(a.x, b.x, t), std::lerp(a.y, b.y, t), std::lerp(a.z, b.z, t)}; }

constexpr const char* verbs[] = {"moves", "turns", "scales"};

Result<Factor> between(const Factor& a, const Factor& b, double t, std::size_t i) {
  if (a.kind != b.kind)
    return about(
        i,
        fmt::format("one list {} where the other {}", verbs[static_cast<int>(a.kind)], verbs[static_cast<int>(b.kind)]),
        "from here on a browser mixes matrices, and turns are lost: let the same functions stand there");
  Factor f = b;
  f.law = Law::linear;
  f.by = lerp(a.by, b.by, t);
  if (f.kind == Kind::translate) return f;
  if (a.centre != b.centre) return about(i, "its centre is not the same in both lists", "read both about one origin");
  if (f.kind == Kind::scale) return f;
  f.angle = std::lerp(a.angle, b.angle, t);
  if (b.angle == 0) f.axis = a.axis;
  if (a.angle != 0 && b.angle != 0 && length(normalize(a.axis) - normalize(b.axis)) > 1e-12)
    return about(i, "it turns about one axis in one list and about another in the other",
                 "a browser then takes the short way, and turns are lost: two functions, one for each axis");
  return f;
}

}  // namespace

Result<Motion> from_css(std::string_view transforms, Vec3 origin) {
  Reader r{{transforms}};
  Motion motion;
  r.space();
  if (same(r.word(), "none") && (r.space(), r.at == transforms.size())) return motion;
  for (r.at = 0, r.space(); r.at < transforms.size(); r.space()) {
    if (motion.factors.size() == 10'000) {
      r.fail(r.at, r.at + 1, ErrorCode::range, "no more than 10000 transforms");
      return *r.error;
    }
    Factor f;
    if (!r.function(f)) return *r.error;
    if (f.kind != Kind::translate) f.centre = origin;
    motion.factors.push_back(std::move(f));
  }
  return motion;
}

Result<CssLists> to_css(const Motion& motion) {
  if (auto possible = has_css(motion); !possible) return possible.error();
  CssLists lists;
  Vec3 here;  // what the list stands about: a translation is the same about every place
  const auto go = [&](Vec3 centre) {
    for (const Vec3 way : {-here, centre})
      for (std::string* css : {&lists.from, &lists.to})
        if (way != Vec3{}) append(*css, translate_text(way, way.z != 0));
    here = centre;
  };
  for (const Factor& f : motion.factors) {
    if (f.kind != Kind::translate && f.centre != here) go(f.centre);
    append(lists.from, css_text(f, false));
    append(lists.to, css_text(f, true));
  }
  go({});
  if (lists.to.empty()) lists.from = lists.to = "none";
  return lists;
}

Result<Mat4> css_between(const Motion& from, const Motion& to, double t) {
  for (const Motion* m : {&from, &to})
    if (auto possible = has_css(*m); !possible) return possible.error();
  Motion now;
  for (std::size_t i = 0; i < std::max(from.factors.size(), to.factors.size()); ++i) {
    const Factor* a = i < from.factors.size() ? &from.factors[i] : nullptr;
    const Factor* b = i < to.factors.size() ? &to.factors[i] : nullptr;
    auto f = between(a != nullptr ? *a : nothing_like(*b), b != nullptr ? *b : nothing_like(*a), t, i);
    if (!f) return f.error();
    now.factors.push_back(std::move(*f));
  }
  return at(now, 1);
}

}  // namespace betwixt
