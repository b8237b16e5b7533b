// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Reads lists of CSS transforms.
#include <fmt/format.h>

#include <algorithm>

#include "algebra/css_numbers.h"
#include "betwixt/css.h"

namespace betwixt {
namespace {

using CssKind = CssFunction::Kind;

struct FunctionRow {
  std::string_view name;
  CssKind kind;
  std::size_t least;       // the fewest values
  std::string_view takes;  // x, y, z: a length along it; n: a number; a: an angle; d: a distance
  int axis;                // its only axis, or -1
  std::string_view values;
};
constexpr FunctionRow functions[] = {
    {"translate", CssKind::translate, 1, "xy", -1, "one or two lengths"},
    {"translateX", CssKind::translate, 1, "x", 0, "one length"},
    {"translateY", CssKind::translate, 1, "y", 1, "one length"},
    {"translateZ", CssKind::translate, 1, "z", 2, "one length"},
    {"translate3d", CssKind::translate, 3, "xyz", -1, "three lengths"},
    {"rotate", CssKind::rotate, 1, "a", 2, "one angle"},
    {"rotateX", CssKind::rotate, 1, "a", 0, "one angle"},
    {"rotateY", CssKind::rotate, 1, "a", 1, "one angle"},
    {"rotateZ", CssKind::rotate, 1, "a", 2, "one angle"},
    {"rotate3d", CssKind::rotate, 4, "nnna", -1, "three numbers and an angle"},
    {"scale", CssKind::scale, 1, "nn", -1, "one or two numbers"},
    {"scaleX", CssKind::scale, 1, "n", 0, "one number"},
    {"scaleY", CssKind::scale, 1, "n", 1, "one number"},
    {"scaleZ", CssKind::scale, 1, "n", 2, "one number"},
    {"scale3d", CssKind::scale, 3, "nnn", -1, "three numbers"},
    {"skew", CssKind::skew, 1, "aa", -1, "one or two angles"},
    {"skewX", CssKind::skew_x, 1, "a", 0, "one angle"},
    {"skewY", CssKind::skew_y, 1, "a", 1, "one angle"},
    {"perspective", CssKind::perspective, 1, "d", -1, "a length, or none"},
    {"matrix", CssKind::matrix, 6, "nnnnnn", -1, "six numbers"},
    {"matrix3d", CssKind::matrix, 16, "nnnnnnnnnnnnnnnn", -1, "sixteen numbers"},
};
constexpr const char* motions = "translate(), rotate() and scale(), also with X, Y, Z or 3d after the name";

struct ListReader : algebra::CssNumbers {
  bool motions_only = false;
  double values[16] = {};
  algebra::Angle turned;

  bool refuse(std::size_t from, std::string_view name) {
    const std::string hint =
        fmt::format("supported: {}{}", motions, motions_only ? "" : "; skew(), matrix(), matrix3d() and perspective()");
    if (algebra::same_in_css(name, "none")) return fail(from, at, ErrorCode::syntax, "'none' must be alone");
    if (name.empty())
      return fail(from, from + 1, ErrorCode::syntax, "expected a CSS transform here",
                  "as in translate(10px, 20px) rotate(90deg)");
    return fail(from, at, ErrorCode::name, fmt::format("'{}' is not a CSS transform", name), hint);
  }
  const FunctionRow* row() {
    const std::size_t from = at;
    const std::string_view name = word();
    const auto found = std::find_if(std::begin(functions), std::end(functions),
                                    [&](const FunctionRow& f) { return algebra::same_in_css(name, f.name); });
    if (found == std::end(functions)) {
      refuse(from, name);
    } else if (motions_only && found->kind > CssKind::scale) {
      fail(from, at, ErrorCode::type, fmt::format("{}() is not a translation, rotation or scaling", found->name),
           fmt::format("supported: {}", motions));
    } else if (peek() != '(') {
      fail(at, at + 1, ErrorCode::syntax, fmt::format("'(' is missing directly after {}", found->name));
    } else {
      return found;
    }
    return nullptr;
  }
  bool one_value(char what, double& value) {
    if (what == 'n') return plain(value);
    if (what == 'x') return length(value, Part::width);
    if (what == 'y') return length(value, Part::height);
    if (what == 'z') return length(value, Part::none);
    if (what == 'd') return distance(value);
    algebra::Angle a;
    if (!angle(a)) return false;
    value = a.radians, turned = a;
    return true;
  }
  // Reads the distance of the eye, taken as at least one pixel, and sets `nearness` to its inverse.
  bool distance(double& nearness) {
    const std::size_t from = at;
    if (algebra::same_in_css(word(), "none")) return true;
    at = from;
    double d = 0;
    if (!length(d, Part::none)) return false;
    if (d < 0)
      return fail(from, at, ErrorCode::range, "a distance must not be negative",
                  "for no perspective: perspective(none)");
    nearness = 1 / std::max(d, 1.0);
    return true;
  }
  bool function(CssFunction& out) {
    const std::size_t from = at;
    const FunctionRow* f = row();
    if (f == nullptr) return false;
    std::size_t count = 0;
    std::fill(std::begin(values), std::end(values), 0.0);
    do {
      ++at;  // '(' or ','
      space();
      if (count == f->takes.size() || (count == 0 && peek() == ')')) return wrong_count(*f, from);
      if (!one_value(f->takes[count], values[count])) return false;
      ++count;
      space();
    } while (peek() == ',');
    if (at == text.size()) return fail(at, at + 1, ErrorCode::syntax, "')' is missing");
    if (peek() != ')') return fail(at, at + 1, ErrorCode::syntax, "expected ',' or ')' here");
    if (count < f->least) return wrong_count(*f, from);
    ++at;
    return fill(out, *f, count) || fail(from, at, ErrorCode::range, "this axis has no direction");
  }
  bool wrong_count(const FunctionRow& f, std::size_t from) {
    return fail(from, at + 1, ErrorCode::syntax, fmt::format("{}() takes {}", f.name, f.values));
  }
  bool fill(CssFunction& out, const FunctionRow& f, std::size_t count) const {
    out.kind = f.kind;
    const Vec3 first{values[0], values[1], values[2]};
    switch (f.kind) {
      case CssKind::rotate:
        out.angle = turned.radians, out.angle_rest = turned.rest;
        out.axis = first;
        if (f.axis >= 0) out.axis = {}, out.axis[f.axis] = 1;
        return std::isnormal(1 / betwixt::length(out.axis));
      case CssKind::perspective:
        out.nearness = values[0];
        return true;
      case CssKind::matrix:
        fill_matrix(out.matrix, count);
        return true;
      case CssKind::scale:
        out.by = {1, 1, 1};
        [[fallthrough]];
      default:
        if (f.axis >= 0)
          out.by[f.axis] = values[0];
        else
          for (std::size_t i = 0; i < count; ++i) out.by[static_cast<int>(i)] = values[i];
        if (f.kind == CssKind::scale && f.axis < 0 && count == 1) out.by.y = values[0];
        return true;
    }
  }
  void fill_matrix(Mat4& m, std::size_t count) const {
    if (count == 16) {
      std::copy(std::begin(values), std::end(values), m.m.begin());
      return;
    }
    for (int c = 0; c < 3; ++c)
      for (int r = 0; r < 2; ++r) m(r, c == 2 ? 3 : c) = values[2 * c + r];
  }
};

Result<CssList> read_list(std::string_view text, const CssPage& page, bool motions_only) {
  ListReader r;
  r.text = text, r.motions_only = motions_only;
  r.page = page;
  CssList list;
  r.space();
  if (algebra::same_in_css(r.word(), "none") && (r.space(), r.at == text.size())) return list;
  for (r.at = 0, r.space(); r.at < text.size(); r.space()) {
    if (list.size() == 10'000) {
      r.fail(r.at, r.at + 1, ErrorCode::range, "there can be at most 10000 transforms");
      return *r.error;
    }
    CssFunction f;
    if (!r.function(f)) return *r.error;
    list.push_back(f);
  }
  return list;
}

}  // namespace

Result<CssList> parse_css(std::string_view list, const CssPage& page) { return read_list(list, page, false); }

Result<Motion> from_css(std::string_view list, Vec3 origin, const CssPage& page) {
  const auto read = read_list(list, page, true);
  if (!read) return read.error();
  Motion motion;
  for (const CssFunction& f : *read) {
    if (f.kind == CssKind::translate)
      motion.factors.push_back(translate_by(f.by));
    else if (f.kind == CssKind::scale)
      motion.factors.push_back(scale_by(f.by, origin, Factor::Law::linear));
    else
      motion.factors.push_back(rotate_by(f.angle, origin, f.axis)), motion.factors.back().angle_rest = f.angle_rest;
  }
  return motion;
}

}  // namespace betwixt
