// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Runs a plan: points from frame to frame, in f32, in f64 or in numbers that count.
#pragma once

#include <span>
#include <vector>

#include "algebra/plan.h"
#include "base/large_pages.h"

namespace betwixt::algebra {

template <class T>
using Line = std::vector<T, LargePages<T>>;

// The number type of plans for Number: constants are computed in f64.
template <class Number>
struct Planned {
  using Type = double;
};
template <>
struct Planned<Counted> {
  using Type = Counted;
};

template <class Number>
class Stepper {
 public:
  using Constant = typename Planned<Number>::Type;
  // x and y must have equal sizes. The plan is for this motion, which gives the last frame.
  Stepper(Plan<Constant>, Motion, std::span<const Number> x, std::span<const Number> y);

  std::int64_t frame() const { return k_; }
  void seek(std::int64_t k);  // goes to a frame by the closed form
  void step();
  // Sets after how many steps the closed form is evaluated again; 0: never. The default is 32 for the registers, which
  // cost nothing beside the points; for the points it is 256, in f32 64, and in f32 32 for the two-term kernels.
  void renew_every(int steps) { renew_ = renew_registers_ = steps; }
  void use_threads(unsigned most) { threads_ = most; }  // 0: as many as the machine has
  std::span<const Number> x() const { return {drawn_x(), rest_x_.size()}; }
  std::span<const Number> y() const { return {drawn_y(), rest_x_.size()}; }

 private:
  void seek_registers();
  void seek_points();
  void step_registers();
  void gather_inputs();
  void place_by_closed_form();  // draws A_k of the points at rest
  bool by_closed_form() const { return k_ == plan_.steps || plan_.whole_step; }
  void run(Kernel);
  Arrays<Number> arrays();
  bool in_place() const { return !uses(plan_.kernel).drawn; }
  bool from_rest() const { return !uses(plan_.kernel).state; }
  const Number* drawn_x() const { return in_place() && !placed_ ? x_.data() : out_x_.data(); }
  const Number* drawn_y() const { return in_place() && !placed_ ? y_.data() : out_y_.data(); }

  Plan<Constant> plan_;
  Motion motion_;
  Line<Number> rest_x_, rest_y_;  // as given
  Line<Number> x_, y_, u_, v_, du_, dv_, out_x_, out_y_;
  std::vector<Number> registers_, before_, inputs_;
  std::vector<Number> p_, q_;  // of the registers
  std::int64_t k_ = 0;
  int renew_ = 256, renew_registers_ = 32, since_ = 0;
  unsigned threads_ = 0;
  bool placed_ = false;
};

}  // namespace betwixt::algebra
