// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The animation algebra: motions as strings of translations, rotations and scalings, and their in-betweens.
// Source: Chandran, Kulkarni, Nath, On Transformations for Animation.
//
// A motion is a product F1 F2 ... Fm of factors. Each factor gives its total movement, and the leftmost factor is
// applied last. At fraction t the motion is A(t) = F1(t) F2(t) ... Fm(t). With N steps, A_k = A(k/N): frame 0 is the
// identity and frame N is the whole motion. Centres are points of the rest pose. Each factor also moves the centres of
// the factors to its right. Points are column vectors, angles are in radians.
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
  // How much a scaling by G has scaled at t: by G^t (exponential), or by 1 + (G - 1) t as in CSS and SVG (linear).
  enum class Law : std::uint8_t { exponential, linear };
  Kind kind = Kind::translate;
  Law law = Law::exponential;
  Vec3 by{};              // translate: the displacement; scale: the factors G
  Vec3 centre{};          // rotate, scale
  std::string about;      // rotate, scale: the object whose position at the start of the motion is the centre; "": none
  Vec3 axis{0, 0, 1};     // rotate
  double angle = 0;       // rotate: the total, whole turns included
  double angle_rest = 0;  // rotate: what `angle` lost by rounding. With both, many turns keep their fraction
  friend bool operator==(const Factor&, const Factor&) = default;
};

struct Motion {
  std::vector<Factor> factors;  // may be empty, which is the identity
  friend bool operator==(const Motion&, const Motion&) = default;
};

Factor translate_by(Vec3 way);
Factor rotate_by(double angle, Vec3 centre = {}, Vec3 axis = {0, 0, 1});
Factor scale_by(Vec3 factors, Vec3 centre = {}, Factor::Law = Factor::Law::exponential);

// Reads a motion: T(dx dy) R(90deg @ cx cy) S(gx gy @ sx sy) S(g), and in space T(x y z) R(90deg @ cx cy cz axis x y z)
// S(gx gy gz @ x y z). `linear` at the end of an S sets the linear law. Angles are in deg, rad or turn, lengths in m,
// cm or mm. A centre may be the name of an object. Errors: syntax, range. Their place.column and place.length count
// characters; the first column is 1.
Result<Motion> parse_motion(std::string_view);
// Returns the shortest text that parse_motion reads as an equal motion.
std::string to_string(const Motion&);

// Returns an error (range) that names the factor, counted from 1, if a number is infinite or not a number, an axis has
// no direction, there are more than 2^53 turns, or a scaling under the exponential law is by zero or less.
Status check(const Motion&);
// Returns whether the motion changes x and y only, and depends on x and y only.
bool is_planar(const Motion&);

// Returns A(t) for any t. The motion must pass `check`. Numbers too large for a double are infinite; none is NaN.
Mat4 at(const Motion&, double t);
// Returns A_k. Errors (range): steps below 1.
Result<Mat4> frame(const Motion&, std::int64_t k, std::int64_t steps);
// Returns the motion B with B(t) A(t) = 1 for all t. Errors (range): a scaling under the linear law, or a scaling by
// zero. No motion is their inverse.
Result<Motion> inverse(const Motion&);

// ---- From step to step

// How points are moved from one frame to the next. The methods come from the source and work in the plane. If you do
// not need every frame in turn, compute A(t) instead.
enum class Method : std::uint8_t {
  matrix,       // multiplies the points at rest by A_k; the numbers of A_k are updated from step to step
  geometric,    // translates, scales and shears the points in place. Only for the strings in the eleven rows of the
                // source's first table; their scalings must follow the linear law. For SR and ST the points match the
                // motion only at its end
  differences,  // multiplies the points by one constant matrix at each step. Only for strings that have such a matrix;
                // with a single step every string has one
  best,         // the cheapest method, for any string
};
std::string_view name_of(Method);

// Moves points from frame to frame. Errors: those of `check`; steps below 1 (range); a motion that leaves the plane or
// that the method does not handle (type).
template <class Number>  // float, double
class Steps {
 public:
  // Starts at frame 0. `x` and `y` are the points at rest and must have equal sizes. Errors: range (the geometric
  // method cannot make a step of half a turn: use more steps).
  static Result<Steps> make(const Motion&, std::int64_t steps, Method, std::span<const Number> x,
                            std::span<const Number> y);
  Steps(Steps&&) noexcept;
  Steps& operator=(Steps&&) noexcept;
  ~Steps();

  std::int64_t frame() const;
  void step();                // goes to the next frame, also beyond the last step
  void seek(std::int64_t k);  // goes to any frame directly, by the closed form
  // Sets after how many steps the closed form is evaluated again, so that rounding errors do not accumulate; 0: never.
  // The default is 256 in double and 64 in float. For two-term recurrences in float, and for the numbers of A_k, it is
  // 32.
  void renew_every(int steps);
  std::span<const Number> x() const;
  std::span<const Number> y() const;

 private:
  struct State;
  explicit Steps(std::unique_ptr<State>);
  std::unique_ptr<State> state_;
};

// Numbers of operations (multiplications and additions). `per_point` counts those for each point. `besides` counts all
// others: they do not depend on the number of points.
struct Cost {
  long long per_point = 0, besides = 0;
  long long functions = 0;  // sines, exponentials and other functions
  friend bool operator==(const Cost&, const Cost&) = default;
};
struct Count {
  std::string kernel;  // the operation on the points, by name
  Cost planned;        // per step, as the scheme predicts
  Cost before, step;   // before the first step, and per step: counted by running the code with a counting number type
};
// Counts the operations of a plan for this number of points. Errors: as for Steps.
Result<Count> count_operations(const Motion&, std::int64_t steps, Method, std::size_t points);

// Returns "8Np + 14".
std::string to_string(const Cost&);

// Returns the costs that the two tables of the source print for this string, or std::nullopt if they have no row for
// it. The costs of `geometric` are for the linear law, those of `matrix` for the exponential law.
struct Printed {
  std::string row;
  Cost matrix, geometric;                // per step
  Cost matrix_before, geometric_before;  // before the first step (pre-processing)
  Cost geometric_after;                  // after the last step (post-processing)
};
std::optional<Printed> printed_costs(const Motion&);

}  // namespace betwixt
