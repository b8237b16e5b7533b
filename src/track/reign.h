// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The reign of a velocity track: from its first event to its release the value is that at the first event plus the
// integral of the velocity since.
#pragma once

#include "track/curve.h"

namespace betwixt {

class Reign {
 public:
  // `velocity`: the events of one reign, per second, three numbers (angular velocity) where `orientation`.
  Reign(CurveSet& set, const Curve& velocity, bool orientation);
  Time from() const { return from_; }
  const Curve& velocity() const { return v_; }
  // Sets out[0 … channels) to the integral at t >= from(). For orientations it is the rotation since, four numbers;
  // multiply the anchor by it from the left.
  void sum(const CurveSet& set, Time t, double* out) const;

 private:
  void numbers(const CurveSet& set, Time t, double* out) const;
  // For a varying axis: the rotation up to each step of a grid, which starts again at each event.
  struct Steps {
    std::vector<Quat> turns;
    std::vector<std::size_t> first;  // of each event
  };
  Steps steps(const CurveSet& set, double sign) const;
  Quat stepped(const CurveSet& set, const Steps&, double sign, std::int64_t t) const;
  Quat wandered(const CurveSet& set, Time t) const;

  Curve v_;
  Time from_;
  bool orientation_ = false, one_axis_ = true;
  std::vector<double> prefix_;  // the integral up to each event
  std::int64_t step_ = 0;
  Steps there_, against_;  // `against_`: with the velocity reversed, for `bounce`
};

}  // namespace betwixt
