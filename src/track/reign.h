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
  // Where the axis wanders: the turn up to each step of a grid that begins anew at each event. (R-T5b)
  struct Steps {
    std::vector<Quat> turns;
    std::vector<std::size_t> first;  // of each event's
  };
  Steps steps(const CurveSet& set, double sign) const;
  Quat stepped(const CurveSet& set, const Steps&, double sign, std::int64_t t) const;
  Quat wandered(const CurveSet& set, Time t) const;

  Curve v_;
  Time from_;
  bool orientation_ = false, one_axis_ = true;
  std::vector<double> prefix_;  // the integral up to each event
  std::int64_t step_ = 0;
  Steps there_, against_;  // `against_`: with the velocity turned round, for `bounce`
};

}  // namespace betwixt
