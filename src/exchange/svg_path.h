// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// SVG's own notations: numbers, transforms, and the commands of paths.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "exchange/flattener.h"

namespace betwixt {

inline constexpr double farthest_in_svg = 1e6;  // larger numbers are errors

// Successive numbers, with or without blanks or commas between them: "M.5-1.2,3".
class PathNumbers {
 public:
  explicit PathNumbers(std::string_view text) : rest_(text) {}

  bool done();
  bool letter();  // whether a letter is next
  char take();
  std::optional<double> number();
  std::optional<double> flag();  // of arcs: 0 or 1, without separators

 private:
  std::string_view rest_;
};

// SVG's matrix(a b c d e f).
struct Affine {
  double a = 1, b = 0, c = 0, d = 1, e = 0, f = 0;
  Vec3 operator()(Vec3 p) const { return {a * p.x + c * p.y + e, b * p.x + d * p.y + f, 0}; }
  friend Affine operator*(const Affine& m, const Affine& n) {
    return {m.a * n.a + m.c * n.b, m.b * n.a + m.d * n.b,       m.a * n.c + m.c * n.d,
            m.b * n.c + m.d * n.d, m.a * n.e + m.c * n.f + m.e, m.b * n.e + m.d * n.f + m.f};
  }
  bool sane() const;
};

// Reads "translate(3 4) rotate(30)": a list of any of the six functions. Returns nullopt for anything else.
std::optional<Affine> transform_in(std::string_view);

// Runs the commands of a path's `d`.
class PathReader {
 public:
  PathReader(const Affine& to, Flattener& into) : to_(to), into_(into) {}
  // Returns false at an invalid command; the commands before it remain drawn.
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
