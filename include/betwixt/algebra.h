// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The animation algebra: motions as strings of translations, rotations and scalings, and their in-betweens.
// After Chandran, Kulkarni, Nath, On Transformations for Animation.
//
// A motion is a product F1 F2 ... Fm of factors with totals; the leftmost is applied last. Fraction t of it is
// A(t) = F1(t) F2(t) ... Fm(t); with N steps A_k = A(k/N), so frame 0 is the identity and frame N the whole motion.
// Centres are places of the rest pose; the factors to their left carry them along. Column vectors, radians.
//
// Room: algebra
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "betwixt/math.h"
#include "betwixt/result.h"

namespace betwixt {

struct Factor {
  enum class Kind : std::uint8_t { translate, rotate, scale };
  // Of fraction t of a scaling: G^t, or 1 + (G - 1) t as CSS and SVG have it.
  enum class Law : std::uint8_t { exponential, linear };
  Kind kind = Kind::translate;
  Law law = Law::exponential;
  Vec3 by{};           // translate: the way; scale: the factors G
  Vec3 centre{};       // rotate, scale
  std::string about;   // rotate, scale: the object whose place is the centre as the motion begins; empty: the centre as
                       // it stands
  Vec3 axis{0, 0, 1};  // rotate
  double angle = 0;    // rotate: all of it, whole turns too
  double angle_rest = 0;  // rotate: what rounding took of it, so that many turns keep their fraction; texts have it
  friend bool operator==(const Factor&, const Factor&) = default;
};

struct Motion {
  std::vector<Factor> factors;  // empty: nothing moves
  friend bool operator==(const Motion&, const Motion&) = default;
};

Factor translate_by(Vec3 way);
Factor rotate_by(double angle, Vec3 centre = {}, Vec3 axis = {0, 0, 1});
Factor scale_by(Vec3 factors, Vec3 centre = {}, Factor::Law = Factor::Law::exponential);

// T(dx dy) R(90deg @ cx cy) S(gx gy @ sx sy) S(g), and in space T(x y z) R(90deg @ cx cy cz axis x y z)
// S(gx gy gz @ x y z); `linear` at the end of an S; angles in deg, rad or turn, lengths in m, cm or mm; a centre may be
// the name of an object. Errors: syntax, range; place.column counts characters from 1, place.length too.
Result<Motion> parse_motion(std::string_view);
// The shortest text that reads back the same.
std::string to_string(const Motion&);

// Errors (range) name the factor, counted from 1: a number that is none or endless, an axis without a direction, more
// turns than 2^53, a factor of zero or less under the exponential law.
Status check(const Motion&);
// Nothing but x and y change, and by x and y only.
bool is_planar(const Motion&);

// A(t), t any number. Of a motion that `check` passes. Numbers beyond all doubles are infinite, and none is NaN.
Mat4 at(const Motion&, double t);
// A_k. Errors (range): steps below 1.
Result<Mat4> frame(const Motion&, std::int64_t k, std::int64_t steps);
// The motion B with B(t) A(t) = 1 for all t. Errors (range): a scaling under the linear law has none; neither has a
// factor of zero.
Result<Motion> inverse(const Motion&);

// ---- From step to step

// How points go from frame to frame. The other way, A(t) for each frame, needs no steps: it is the one to take unless
// there are reasons. These are the source's, and are for the plane.
enum class Method : std::uint8_t {
  matrix,     // the points at rest times A_k, whose numbers go on from step to step
  geometric,  // pushes, growths and shears in place: for the eleven rows of the source's first table, with scalings by
              // the linear law. SR and ST meet the motion at its end only
  differences,  // one constant matrix: where there is one. In one step there is one for every string
  best,         // what costs least, for any string
};
std::string_view name_of(Method);

// Points on their way. Errors: those of `check`; steps below 1 (range); a motion out of the plane, or one that the
// method does not know (type).
template <class Number>  // float, double
class Steps {
 public:
  // x and y: the points at rest, as many of each.
  static Result<Steps> make(const Motion&, std::int64_t steps, Method, std::span<const Number> x,
                            std::span<const Number> y);
  Steps(Steps&&) noexcept;
  Steps& operator=(Steps&&) noexcept;
  ~Steps();

  std::int64_t frame() const;
  void step();                // to the next frame; there is no last one
  void seek(std::int64_t k);  // to any frame, by the closed form
  // How many steps are taken before the closed form is taken anew: 256, in f32 64, and 32 for two-term
  // recurrences and for the numbers of A_k. 0: it never is.
  void renew_every(int steps);
  std::span<const Number> x() const;
  std::span<const Number> y() const;

 private:
  struct State;
  explicit Steps(std::unique_ptr<State>);
  std::unique_ptr<State> state_;
};

// Operations (products and sums) as so many per point and so many besides.
struct Cost {
  long long per_point = 0, besides = 0;
  long long functions = 0;  // sines, exponentials and their like
  friend bool operator==(const Cost&, const Cost&) = default;
};
struct Count {
  std::string kernel;  // what is done to the points
  Cost planned;        // per step, as the scheme has it
  Cost before, step;   // counted by running the very code with numbers that count
};
// For a plan that is made for so many points. Errors as above.
Result<Count> count_operations(const Motion&, std::int64_t steps, Method, std::size_t points);

// "8Np + 14"
std::string to_string(const Cost&);

// What the source prints for this row of its two tables; none where the string is no row of them. By the linear law for
// geometric, by the exponential law for matrix.
struct Printed {
  std::string row;
  Cost matrix, geometric;                // per step
  Cost matrix_before, geometric_before;  // pre-processing
  Cost geometric_after;                  // post-processing
};
std::optional<Printed> printed_costs(const Motion&);

}  // namespace betwixt
