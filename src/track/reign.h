// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The reign of a velocity track: from its first event to its release the value is what it was, and what has been added
// up since. (rules R-T5, R-T5b)
#pragma once

#include "track/curve.h"

namespace betwixt {

class Reign {
 public:
  // `velocity`: the events of one reign, per second, three numbers (angular velocity) where `orientation`.
  Reign(CurveSet& set, const Curve& velocity, bool orientation);
  Time from() const { return from_; }
  const Curve& velocity() const { return v_; }
  // out[0 … channels): what has been added at t >= from(). Orientations: the turn since, four numbers, by which the
  // anchor is multiplied from the left.
  void sum(const CurveSet& set, Time t, double* out) const;

 private:
  void numbers(const CurveSet& set, Time t, double* out) const;
  void stepped(const CurveSet& set, Time t, double* out) const;

  Curve v_;
  Time from_;
  bool orientation_ = false, one_axis_ = true;
  std::vector<double> prefix_;  // the integral up to each event
  // Where the axis wanders: the turn at each step of a fixed grid, from the reign's beginning to its last event.
  std::int64_t step_ = 0;
  std::vector<Quat> checkpoints_;
};

}  // namespace betwixt
