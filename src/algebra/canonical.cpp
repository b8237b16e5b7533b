// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "algebra/plan.h"

namespace betwixt::algebra {

bool merge(Block& into, const Block& b) {
  if (!(into.conformal() && b.conformal()) && !(into.diagonal() && b.diagonal())) return false;
  into.turns = into.turns + b.turns, into.log_x += b.log_x, into.log_y += b.log_y;
  // Rotations that cancel but are no multiple of 2^-64: three thirds.
  const Turns off = into.turns < Turns{} ? -into.turns : into.turns;
  if (off.whole == 0 && off.part < 16) into.turns = {};
  return true;
}

template <class Number>
Canonical<Number> canonical(const Motion& motion, std::int64_t steps) {
  Canonical<Number> string;
  string.offsets.emplace_back();
  const Number n(static_cast<double>(steps));
  const auto shift = [&](Offset<Number>& o, Vec3 by, bool back) {
    o.x = back ? o.x - Number(by.x) : o.x + Number(by.x), o.y = back ? o.y - Number(by.y) : o.y + Number(by.y);
  };
  for (const Factor& f : motion.factors) {
    if (f.kind == Factor::Kind::translate) {
      Offset<Number>& o = string.offsets.back();
      o.drift_x = o.drift_x + Number(f.by.x) / n, o.drift_y = o.drift_y + Number(f.by.y) / n;
      continue;
    }
    Block b;
    if (f.kind == Factor::Kind::rotate) {
      b.turns = planar_turns(f);
      if (phase(b.turns, 1, steps) == 0) continue;  // whole at every step, so it counts as none
    } else if (f.law == Factor::Law::linear) {
      b.linear = true;
      b.slope_x = value(Number(f.by.x) - Number(1)), b.slope_y = value(Number(f.by.y) - Number(1));
    } else {
      b.log_x = value(logarithm(Number(f.by.x)));
      b.log_y = f.by.y == f.by.x ? b.log_x : value(logarithm(Number(f.by.y)));
    }
    if (b.identity()) continue;
    shift(string.offsets.back(), f.centre, false);
    const bool together = !string.blocks.empty() && string.offsets.back().zero() && merge(string.blocks.back(), b);
    if (!together) {
      string.blocks.push_back(b);
      string.offsets.emplace_back();
    } else if (string.blocks.back().identity()) {
      // They cancel: merge their neighbours.
      string.blocks.pop_back();
      string.offsets.pop_back();
    }
    shift(string.offsets.back(), f.centre, true);
  }
  return string;
}

template Canonical<double> canonical(const Motion&, std::int64_t);
template Canonical<Counted> canonical(const Motion&, std::int64_t);

}  // namespace betwixt::algebra
