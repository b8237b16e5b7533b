// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What SVG writes in the words of its own: numbers, transforms, the commands of paths.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "exchange/flattener.h"

namespace betwixt {

inline constexpr double farthest_in_svg = 1e6;  // a number that is larger is none

// Numbers one behind the other, between blanks and commas or nothing at all: "M.5-1.2,3".
class PathNumbers {
 public:
  explicit PathNumbers(std::string_view text) : rest_(text) {}

  bool done();
  bool letter();  // what comes next is one
  char take();
  std::optional<double> number();
  std::optional<double> flag();  // of arcs: 0 or 1, which need nothing between them

 private:
  std::string_view rest_;
};

// As SVG's matrix(a b c d e f).
struct Affine {
  double a = 1, b = 0, c = 0, d = 1, e = 0, f = 0;
  Vec3 operator()(Vec3 p) const { return {a * p.x + c * p.y + e, b * p.x + d * p.y + f, 0}; }
  friend Affine operator*(const Affine& m, const Affine& n) {
    return {m.a * n.a + m.c * n.b, m.b * n.a + m.d * n.b,       m.a * n.c + m.c * n.d,
            m.b * n.c + m.d * n.d, m.a * n.e + m.c * n.f + m.e, m.b * n.e + m.d * n.f + m.f};
  }
  bool sane() const;
};

// "translate(3 4) rotate(30)": a list of any of the six functions. None: it is something else.
std::optional<Affine> transform_in(std::string_view);

// The commands of a path's `d`, carried out.
class PathReader {
 public:
  PathReader(const Affine& to, Flattener& into) : to_(to), into_(into) {}
  // False where something is no command; what stands before it is drawn.
  bool read(std::string_view d);

 private:
  bool numbers(PathNumbers&, char command);
  Vec3 point(std::size_t i) const { return from_ + Vec3{v_[i], v_[i + 1], 0}; }
  Vec3 smooth(char one, char other) const;
  void draw(char command);
  void begin(Vec3 p) { into_.move(to_(at_ = start_ = p)); }
  void line(Vec3 p) { into_.line(to_(at_ = p)); }
  void cubic(Vec3 b, Vec3 c, Vec3 d);
  void conic(Vec3 b, Vec3 c);
  void arc(double rx, double ry, double turn, bool large, bool forward, Vec3 end);
  void close();

  const Affine to_;
  Flattener& into_;
  std::array<double, 7> v_{};
  Vec3 from_, at_, start_, control_;
  char before_ = 0;
};

}  // namespace betwixt
