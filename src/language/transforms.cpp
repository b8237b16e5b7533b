// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Reads transforms and lists of names.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/memory_budget.h"
#include "base/names.h"
#include "language/values.h"
#include "scene/power.h"

namespace betwixt {
namespace {

constexpr std::string_view factors[] = {"translate", "rotate", "scale", "matrix"};

constexpr std::string_view example(std::string_view factor) {
  return factor == "translate" ? "translate(1 0 0)"
         : factor == "rotate"  ? "rotate(90deg, z)"
         : factor == "scale"   ? "scale(2)"
                               : "matrix(…), 16 numbers row by row";
}

// Returns `m` applied about a centre.
Mat4 about(const Mat4& m, Vec3 centre) { return translation(centre) * m * translation(-centre); }

// Reads the brackets of one factor: the operand, and the centre after '@', with or without its own brackets.
struct FactorReader {
  ValueReader& values;
  std::string_view word;
  Mat4 matrix;
  bool centred = false;
  Vec3 centre;
  const char* open = nullptr;  // its bracket

  bool numbers(int count, double* n, Unit unit = Unit::metres) {
    Cursor& c = values.c;
    for (int i = 0; i < count; ++i) {
      c.space();
      if (c.peek() == ')')
        return c.fail(ErrorCode::type, fmt::format("expected {} numbers here, not {}", count, i),
                      {open, static_cast<std::size_t>(c.at + 1 - open)});
      if (!values.scalar(n[i], unit)) return false;
    }
    return true;
  }

  bool translate() {
    double n[3];
    if (!numbers(3, n)) return false;
    matrix = translation({n[0], n[1], n[2]});
    return true;
  }

  bool rotate() {
    double angle = 0;
    Vec3 axis{0, 0, 1};
    if (!values.angle(angle) || !values.axis(axis)) return false;
    matrix = rotation(axis_angle(axis, angle));
    return true;
  }

  bool scale() {
    Cursor& c = values.c;
    double n[3];
    c.space();
    if (!values.scalar(n[0])) return false;
    n[1] = n[2] = n[0];
    c.space();
    if (c.peek() != ')' && c.peek() != '@' && (!values.scalar(n[1]) || !values.scalar(n[2]))) return false;
    if (n[0] == 0 && n[1] == 0 && n[2] == 0 && values.warn)
      values.warn("a scale of 0 shrinks everything to a point, so nothing is visible", word,
                  "to hide an object, write: hide NAME");
    matrix = scaling({n[0], n[1], n[2]});
    return true;
  }

  bool sixteen() {
    Cursor& c = values.c;
    double n[16];
    const char* start = (c.space(), c.at);
    if (!numbers(16, n, Unit::none)) return false;
    for (int i = 0; i < 16; ++i) matrix(i / 4, i % 4) = n[i];
    return (n[12] == 0 && n[13] == 0 && n[14] == 0 && n[15] == 1) ||
           c.fail(ErrorCode::range, "the last row of a matrix must be 0 0 0 1", c.since(start),
                  "write 16 numbers row by row; the last column is the translation");
  }

  bool point() {
    values.c.space();
    if (values.c.peek() == '(') return values.vector(3, centre, Unit::metres);
    double n[3];
    if (!numbers(3, n)) return false;
    centre = {n[0], n[1], n[2]};
    return true;
  }

  bool read() {
    Cursor& c = values.c;
    c.space();
    if (c.peek() != '(')
      return c.fail_here(ErrorCode::syntax, fmt::format("an opening bracket '(' is missing after '{}'", word),
                         fmt::format("as in {}", example(word)));
    open = c.at;
    if (!c.open()) return false;
    const bool done = word == "translate" ? translate()
                      : word == "rotate"  ? rotate()
                      : word == "scale"   ? scale()
                                          : sixteen();
    if (!done) return false;
    c.space();
    const bool inside = c.accept('@');
    if ((inside && !point()) || !c.close()) return false;
    c.space();
    centred = inside || c.accept('@');
    if (centred && !inside && !values.vector(3, centre, Unit::metres)) return false;
    return !(centred && word == "matrix") ||
           c.fail(ErrorCode::syntax, "a matrix takes no centre", word, "only rotate and scale take @ (x y z)");
  }
};

}  // namespace

bool ValueReader::transform(Mat4& out, std::string_view* noticed) {
  Mat4 product;
  int count = 0;
  std::string_view alone;  // the word of a matrix that is the only factor
  for (;; ++count) {
    c.space();
    if (count > 0 && c.accept('*')) c.space();
    FactorReader factor{*this, c.peek_word(), {}, false, {}, nullptr};
    if (std::find(std::begin(factors), std::end(factors), factor.word) == std::end(factors)) break;
    c.next_word();
    if (!factor.read()) return false;
    product = product * (factor.centred ? about(factor.matrix, factor.centre) : factor.matrix);
    alone = count == 0 && factor.word == "matrix" ? factor.word : std::string_view();
  }
  if (count == 0) {
    const Hint hint = did_you_mean(c.peek_word(), {std::begin(factors), std::end(factors)});
    return c.fail_here(ErrorCode::syntax, "expected a transform here",
                       hint.empty() ? "translate(x y z), rotate(90deg, z) @ (x y z), scale(x y z) or matrix(…)" : hint);
  }
  for (const double n : product.m)
    if (!std::isfinite(n)) return c.fail_here(ErrorCode::range, "this transform has a number that is not finite");
  const auto meant = noticed && !alone.empty() ? unrounded(product) : std::nullopt;
  if (meant && meant->noticeable) *noticed = alone;
  out = meant ? meant->matrix : product;
  return true;
}

bool ValueReader::names(Names& out) {
  std::vector<std::string> list;
  c.space();
  const bool brackets = c.peek() == '(';
  if (brackets && !c.open()) return false;
  if (!brackets && c.accept_word("none")) return out = Names(), true;
  for (c.space(); brackets ? c.peek() != ')' && c.at < c.end : list.empty(); c.space()) {
    const std::string_view word = c.word();
    std::string name;
    if (!one_name(c, word, name)) return false;
    if (!is_name(name))
      return c.fail(ErrorCode::syntax,
                    word.empty() ? "a name is missing here" : fmt::format("'{}' cannot be a name", word.substr(0, 60)),
                    word.empty() ? std::string_view(c.at, c.at < c.end ? 1 : 0) : word,
                    "write names in brackets, as in (A B), or none; an alias can name all objects of a pattern");
    MemoryBudget::charge(sizeof name + name.size());
    list.push_back(std::move(name));
    if (list.size() > 1000) return c.fail(ErrorCode::range, "a list can have at most 1000 names", word);
  }
  if (brackets && !c.close()) return false;
  out = Names(std::move(list));
  return true;
}

}  // namespace betwixt
