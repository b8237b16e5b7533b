// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "language/values.h"

#include <fmt/format.h>

#include <cmath>

#include "base/names.h"
#include "language/formula.h"
#include "scene/colors.h"
#include "scene/formula_parts.h"
#include "scene/names.h"
#include "syntax/tokens.h"
#include "track/curve.h"

namespace betwixt {
namespace {

constexpr const char* colors_look_like = "colours look like gold, #ffcc00, rgb(1 0.8 0) or hsv(48deg 1 1)";

std::string_view since(const char* start, const Cursor& c) { return c.since(start); }

int hex(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

}  // namespace

bool ValueReader::scalar(double& out, Unit unit) {
  c.space();
  const char* start = c.at;
  if (unit == Unit::opening) return c.opening(out);
  if (unit == Unit::moment || unit == Unit::seconds) {
    Time t;
    if (!(unit == Unit::moment ? c.time(t) : c.own_length(t))) return false;
    return out = t.seconds(), true;
  }
  if (translates() && meant_as_number(start, out)) return true;
  if (c.peek() == '(' && is_vector()) return c.fail(ErrorCode::type, "expected a number here, not a vector", {c.at, 1});
  if (c.peek() == '"')
    return c.fail_here(ErrorCode::type, "expected a number here, not a text",
                       "write it without quotes; quotes after '=' are for code");
  if (const std::string_view w = c.peek_word(); w == "on" || w == "off")
    return c.fail(ErrorCode::type, fmt::format("'{}' is not a number", w), w);
  std::optional<Quantity> q;
  if (!c.number(out, q)) return false;
  if (q) return in_unit(*q, unit, out, since(start, c));
  if (c.peek() == '%' && c.at > start) {
    if (translates()) return ++c.at, out /= 100, translate(start, write_number(out)), true;
    return c.fail(ErrorCode::type, "expected a number from 0 to 1 here, not a percentage", since(start, c),
                  fmt::format("write {}", write_number(out / 100)));
  }
  const std::string_view u = c.unit();
  if (u.empty()) return true;
  const double metres = u == "m" ? 1 : u == "cm" ? 0.01 : u == "mm" ? 0.001 : 0;
  if (translates() && (unit == Unit::none || metres == 0)) {  // a length in metres, an angle in degrees
    const double one = metres != 0 ? metres : u == "deg" ? 1 : u == "rad" ? 180 / pi : u == "turn" ? 360 : 0;
    if (one != 0) return out *= one, translate(start, write_number(out)), true;
  }
  if (unit == Unit::none || metres == 0)
    return c.fail(ErrorCode::type,
                  unit == Unit::none ? fmt::format("expected a plain number here, without '{}'", u)
                                     : fmt::format("'{}' is not a unit of length", u),
                  since(start, c),
                  unit == Unit::none ? ""
                  : u == "px"        ? "a film is measured in metres: a flat film is 16 wide and 9 high"
                                     : "units are m, cm and mm");
  // 35 mm are 35/1000 m: division, not multiplication by 0.001, gives the written number.
  if (unit == Unit::metres) out = u == "mm" ? out / 1000 : u == "cm" ? out / 100 : out;
  if (unit == Unit::millimetres) out = u == "m" ? out * 1000 : u == "cm" ? out * 10 : out;
  return true;
}

// Converts the value of a formula to the requested unit. A plain number is already in it.
bool ValueReader::in_unit(const Quantity& q, Unit unit, double& out, std::string_view about) {
  const bool length = q.of == Quantity::Of::length && unit != Unit::none;
  if (q.of == Quantity::Of::angle && translates() && unit == Unit::none) return out = q.value, true;
  if (q.of != Quantity::Of::number && !length)
    return c.fail(ErrorCode::type, fmt::format("expected a plain number here, not {}", to_string(q.of)), about);
  out = length && unit == Unit::millimetres ? q.value * 1000 : q.value;
  return true;
}

// Returns whether the brackets hold several numbers, and not one formula.
bool ValueReader::is_vector() {
  Cursor ahead = c;
  double first = 0;
  std::optional<Quantity> q;
  if (!ahead.open() || !ahead.number(first, q)) return ahead.at < ahead.end && ahead.peek() == ')';
  ahead.unit();
  ahead.space();
  return !(ahead.peek() == ')' || formula_goes_on(ahead.at, ahead.end) ||
           (ahead.at < ahead.end && std::string_view("+-*/%^").find(*ahead.at) != std::string_view::npos &&
            ahead.at + 1 < ahead.end && ahead.at[1] == ' '));
}

// Translates a vector to its length, and on and off to 1 and 0.
bool ValueReader::meant_as_number(const char* start, double& out) {
  if (c.peek() == '(' && is_vector()) {
    Vec3 v;
    if (!vector(3, v)) return false;
    out = length(v);
  } else if (c.accept_word("on")) {
    out = 1;
  } else if (c.accept_word("off")) {
    out = 0;
  } else {
    return false;
  }
  translate(start, write_number(out));
  return true;
}

// When values may be translated, a number without a unit is in degrees.
bool ValueReader::angle(double& radians) {
  c.space();
  const char* start = c.at;
  if (!translates()) return c.angle(radians);
  double degrees = 0;
  bool meant = meant_as_number(start, degrees);
  std::optional<Quantity> q;
  if (!meant && !c.error && looks_like_number())
    meant = c.number(degrees, q) && (q ? q->of == Quantity::Of::number : c.unit().empty());
  if (c.error) return false;
  if (!meant) return c.at = start, c.angle(radians);
  radians = degrees * (pi / 180);
  if (degrees != 0) translate(start, write_number(degrees) + "deg");
  return true;
}

bool ValueReader::looks_like_number() const {
  const std::string_view w = c.peek_word();
  return !w.empty() && (w[0] == '-' || w[0] == '+' || w[0] == '.' || (w[0] >= '0' && w[0] <= '9'));
}

bool ValueReader::vector(int numbers, Vec3& out, Unit unit, bool open) {
  c.space();
  const char* start = c.at;
  if (const auto named = let<Vec3>()) return out = *named, true;
  if (c.peek() != '(') {
    if (c.at_line_end())
      return c.fail_here(ErrorCode::syntax,
                         numbers == 3 ? "a vector (x y z) is missing here" : "a pair (x y) is missing here");
    double d = 0;
    if (!looks_like_number())
      return c.fail_here(ErrorCode::type, fmt::format("expected a vector (x y{}) here", numbers == 3 ? " z" : ""));
    if (!scalar(d, unit)) return false;
    if (!translates()) {
      // Three numbers without brackets, or one number for all components.
      const std::string_view about = since(start, c);
      Vec3 all{d, d, d};
      const char* end = c.at;
      int n = 1;
      for (double next = 0; n < numbers && !c.at_line_end() && c.number(next); ++n) all[n] = next;
      c.error.reset();
      c.where = {};
      c.at = end;
      return c.fail(ErrorCode::type, "expected a vector here, not one number", about,
                    fmt::format("write {}", write_vector(n == numbers ? all : Vec3{d, d, d}, numbers)));
    }
    out = {d, d, numbers == 3 ? d : 0};
    translate(start, write_vector(out, numbers));
    return true;
  }
  if (!c.open()) return false;
  out = {};
  int given = 0;  // when translated, a pair is a vector in the plane, and a vector without its third number is a pair
  for (int i = 0; i < (translates() ? 3 : numbers); ++i) {
    c.space();
    if (c.peek() == ')') {
      if (i >= 2 && (open || translates())) break;
      return c.fail(ErrorCode::type, fmt::format("expected {} numbers here, not {}", numbers, i),
                    {start, static_cast<std::size_t>(c.at + 1 - start)});
    }
    ++given;
    double d = 0;
    std::optional<Quantity> q;
    c.space();
    const char* const number = c.at;
    if (!c.number(d, q) || (q && !in_unit(*q, unit, d, since(number, c)))) return false;
    const std::string_view u = q ? std::string_view() : c.unit();
    if (!u.empty()) {
      if (unit != Unit::metres || (u != "m" && u != "cm" && u != "mm"))
        return c.fail(ErrorCode::type, fmt::format("the unit '{}' does not fit here", u), u);
      d = u == "mm" ? d / 1000 : u == "cm" ? d / 100 : d;
    }
    out[i] = d;
  }
  c.space();
  if (c.at < c.end && c.peek() != ')')
    return c.fail_here(ErrorCode::type, fmt::format("expected only {} numbers here", numbers));
  if (numbers == 2) out.z = 0;
  if (!c.close()) return false;
  if (given != numbers && !open) translate(start, write_vector(out, numbers));
  return true;
}

bool ValueReader::color(Color& out) {
  c.space();
  const char* start = c.at;
  if (c.peek() == '#') {
    ++c.at;
    std::uint32_t v = 0;
    int n = 0;
    for (; c.at < c.end && hex(*c.at) >= 0 && n < 9; ++c.at, ++n) v = v * 16 + static_cast<std::uint32_t>(hex(*c.at));
    if (n == 3) v = (v >> 8 & 15) * 0x110000 + (v >> 4 & 15) * 0x1100 + (v & 15) * 0x11;
    if ((n != 3 && n != 6) || !c.peek_word().empty())
      return c.fail(ErrorCode::syntax, "a hexadecimal colour must have 3 or 6 digits, as in #ffcc00", since(start, c),
                    n == 4 || n == 8  ? "opacity is apart: transparency=0.5, or set NAME.transparency 0.5"
                    : c.peek() == ';' ? "a line ends without a semicolon"
                                      : "a comment starts with # and a space");
    out = from_bytes(v);
    return true;
  }
  if (c.peek() == '(') {
    Vec3 v;
    if (!vector(3, v)) return false;
    out = {v.x, v.y, v.z};
    return true;
  }
  if (const auto named = let<Color>()) return out = *named, true;
  if (looks_like_number()) {
    double grey = 0;
    if (translates() && !scalar(grey)) return false;
    if (!translates()) return c.fail_here(ErrorCode::type, "expected a colour here, not a number", colors_look_like);
    out = {grey, grey, grey};
    translate(start, "rgb" + write_vector({grey, grey, grey}));
    return true;
  }
  const std::string_view w = c.word();
  if (w == "rgb") {
    Vec3 v;
    if (!vector(3, v)) return false;
    if (std::max({v.x, v.y, v.z}) > 10 && warn)
      warn("the parts of a colour are from 0 to 1; this is much brighter than white", since(start, c),
           fmt::format("write rgb{}, or #rrggbb",
                       write_vector({std::round(v.x / 0.255) / 1000, std::round(v.y / 0.255) / 1000,
                                     std::round(v.z / 0.255) / 1000})));
    out = {v.x, v.y, v.z};
    return true;
  }
  if (w == "hsv") {  // hue: an angle, or turns as a plain number
    double h = 0, s = 0, v = 0;
    bool angle = false;
    if (!c.open() || !c.number_or_angle(h, angle)) return false;
    if (angle) h /= 2 * pi;
    if (!c.number(s) || !c.number(v) || !c.close()) return false;
    out = from_hsv(h, s, v);
    return true;
  }
  if (const auto named = named_color(w)) {
    out = from_bytes(*named);
    return true;
  }
  if (w.empty())
    return c.fail_here(ErrorCode::syntax, c.at_line_end() ? "a colour is missing here" : "this is not a colour");
  Hint hint = did_you_mean(w, color_names());
  for (const std::string_view kind : {"linear", "radial", "conic"})
    if (w.substr(0, w.find('-')) == kind)
      hint = fmt::format("gradient={} makes a gradient, from color to gradient-color or along gradient-stops", kind);
  return c.fail(unknown_name("colour", w, hint.empty() ? colors_look_like : hint), w);
}

bool ValueReader::axis(Vec3& out) {
  c.space();
  const char* start = c.at;
  if (c.peek() == '(') {
    if (!vector(3, out)) return false;
    if (out == Vec3{}) return c.fail(ErrorCode::range, "the axis (0 0 0) has no direction", since(start, c));
    return true;
  }
  const std::string_view w = c.word();
  if (w == "x") return out = {1, 0, 0}, true;
  if (w == "y") return out = {0, 1, 0}, true;
  if (w == "z") return out = {0, 0, 1}, true;
  return c.fail(ErrorCode::syntax, "an axis is missing here", w.empty() ? std::string_view(start, 0) : w,
                "axes are x, y, z or a direction (x y z)");
}

// Takes the rotation of a matrix, whose columns must be three perpendicular unit vectors to 1e-3.
bool ValueReader::rotation_of(const Mat4& m, std::string_view about, Value& out) {
  const auto column = [&](int i) { return Vec3{m(0, i), m(1, i), m(2, i)}; };
  for (int i = 0; i < 3; ++i)
    for (int k = i; k < 3; ++k)
      if (const double is = dot(column(i), column(k)); !(std::abs(is - (i == k ? 1 : 0)) <= 1e-3))
        return c.fail(ErrorCode::range,
                      i == k
                          ? fmt::format("column {} of this matrix has the length {:.4g}, not 1", i + 1, std::sqrt(is))
                          : fmt::format("columns {} and {} of this matrix are not perpendicular", i + 1, k + 1),
                      about, "a rotation has neither scale nor shear; for those: set ball.transform matrix(…)");
  if (dot(cross(column(0), column(1)), column(2)) < 0)
    return c.fail(ErrorCode::range, "this matrix mirrors, so it is no rotation", about,
                  "its third column must be the cross product of the first two");
  out = normalize(from_matrix(m));
  return true;
}

bool ValueReader::orientation(Value& out, bool angles) {
  c.space();
  const char* start = c.at;
  if (translates() && looks_like_number()) {  // one number for all angles of a rotation
    double each = 0;
    if (!angle(each)) return false;
    out = angles ? Value(Angles{{each, each, each}}) : Value(from_angles({each, each, each}));
    const std::string degrees = write_number(each * 180 / pi);
    translate(start, fmt::format("euler({0}deg {0}deg {0}deg)", degrees));
    return true;
  }
  const std::string_view w = c.peek() == '(' ? std::string_view("euler") : c.word();
  if (w == "euler" || w == "axis" || w == "quat" || w == "matrix") {
    c.space();
    if (c.peek() != '(') return c.fail(ErrorCode::syntax, fmt::format("'{}' needs its numbers in brackets", w), w);
  }
  if (w == "euler") {
    Vec3 a;
    if (!c.open()) return false;
    for (int i = 0; i < 3; ++i)
      if (!angle(a[i])) return false;
    if (!c.close()) return false;
    if (angles)
      out = Angles{a};
    else
      out = from_angles(a);
    return true;
  }
  if (w == "axis") {
    Vec3 a;
    double turn = 0;
    if (!c.open()) return false;
    c.space();
    const char* axis_at = c.at;
    if (c.peek() == '(' || c.peek() == 'x' || c.peek() == 'y' || c.peek() == 'z') {
      if (!axis(a)) return false;
    } else {
      for (int i = 0; i < 3; ++i)
        if (!c.number(a[i])) return false;
      if (a == Vec3{}) return c.fail(ErrorCode::range, "the axis 0 0 0 has no direction", since(axis_at, c));
    }
    if (!angle(turn) || !c.close()) return false;
    if (std::abs(turn) > pi * (1 + 1e-9) && warn)
      warn("an orientation is at most half a turn, so the object takes the shorter way round", since(start, c),
           "write euler(x y z) to keep whole turns");
    out = axis_angle(a, turn);
    return true;
  }
  if (w == "quat") {
    Quat q;
    if (!c.open() || !c.number(q.w) || !c.number(q.x) || !c.number(q.y) || !c.number(q.z) || !c.close()) return false;
    const double l = std::sqrt(dot(q, q));
    if (!(l > 1e-9) || !std::isfinite(l))
      return c.fail(ErrorCode::range, "a quaternion must not be zero", since(start, c));
    // A unit quaternion stays as written, so that writing and reading back changes nothing.
    out = std::abs(l - 1) < 1e-12 ? q : Quat{q.w / l, q.x / l, q.y / l, q.z / l};
    return true;
  }
  if (w == "matrix") {  // row after row
    Mat4 m;
    if (!c.open()) return false;
    for (int row = 0; row < 3; ++row)
      for (int column = 0; column < 3; ++column)
        if (!c.number(m(row, column))) return false;
    return c.close() && rotation_of(m, since(start, c), out);
  }
  const bool number = !w.empty() && (starts_like_time(w[0]));
  return c.fail(number ? ErrorCode::type : ErrorCode::syntax,
                w.empty() ? "a rotation is missing here" : fmt::format("'{}' is not a rotation", w),
                w.empty() ? std::string_view(start, 0) : w,
                "rotations look like euler(0 90deg 0), axis(0 1 0, 90deg) or quat(1 0 0 0)");
}

bool ValueReader::object(ObjectId& out) {
  const std::string_view w = c.next_word();
  if (w.empty()) return c.fail_here(ErrorCode::syntax, "the name of an object is missing here");
  std::string name;
  if (!one_name(c, w, name)) return false;
  out = find_named(scene, name);
  if (out) return true;
  return c.fail(unknown_name("object", name, near_object(scene, name)), w);
}

}  // namespace betwixt
