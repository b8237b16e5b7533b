// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Builds the registers of a plan.
#pragma once

#include <algorithm>
#include <cstdint>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

#include "algebra/plan.h"

namespace betwixt::algebra {

// Makes registers. It reuses existing ones and folds constants.
template <class Number>
class Builder {
 public:
  explicit Builder(std::int64_t steps) : steps_(steps) {}
  using R = Register<Number>;

  int constant(Number a) { return add({R::Kind::constant, a}); }
  int ramp(Number a, Number slope) { return slope == Number(0) ? constant(a) : add({R::Kind::ramp, a, slope}); }
  int geometric(Number a, double log_growth) {
    if (log_growth == 0 || a == Number(0)) return constant(a);
    R r{R::Kind::geometric, a};
    r.log_growth = log_growth;
    return add(r);
  }
  int wave(Number a, Number b, Turns turns, double log_growth) {
    if (a == Number(0) && b == Number(0)) return constant(0);
    R r{R::Kind::wave, a, b, turns};
    r.log_growth = log_growth;
    return add(r);
  }
  int product(int l, int r) {
    if (is(l, 0) || is(r, 0)) return constant(0);
    if (is(l, 1)) return r;
    if (is(r, 1)) return l;
    if (fixed(l) && fixed(r)) return constant(of(l) * of(r));
    return add({R::Kind::product, {}, {}, {}, 0, std::min(l, r), std::max(l, r)});
  }
  int sum(int l, int r) {
    if (is(l, 0)) return r;
    if (is(r, 0)) return l;
    if (fixed(l) && fixed(r)) return constant(of(l) + of(r));
    return add({R::Kind::sum, {}, {}, {}, 0, std::min(l, r), std::max(l, r)});
  }
  int difference(int l, int r) {
    if (is(r, 0)) return l;
    if (fixed(l) && fixed(r)) return constant(of(l) - of(r));
    return add({R::Kind::difference, {}, {}, {}, 0, l, r});
  }
  bool is(int r, double x) const { return fixed(r) && of(r) == Number(x); }
  // Removes all registers that `wanted` does not depend on.
  void keep(std::vector<int>& wanted) {
    std::vector<bool> needed(registers_.size());
    for (const int w : wanted) needed[static_cast<std::size_t>(w)] = true;
    for (std::size_t i = registers_.size(); i-- > 0;)
      for (const int before : {registers_[i].left, registers_[i].right})
        if (needed[i] && before >= 0) needed[static_cast<std::size_t>(before)] = true;
    std::vector<int> now(registers_.size());
    std::vector<R> kept;
    for (std::size_t i = 0; i < registers_.size(); ++i) {
      if (!needed[i]) continue;
      R r = registers_[i];
      for (int* before : {&r.left, &r.right})
        if (*before >= 0) *before = now[static_cast<std::size_t>(*before)];
      now[i] = static_cast<int>(kept.size());
      kept.push_back(r);
    }
    registers_ = std::move(kept);
    for (int& w : wanted) w = now[static_cast<std::size_t>(w)];
  }
  // Returns the registers with the factors of their steps.
  std::vector<R> finished() {
    for (R& r : registers_) {
      if (r.kind != R::Kind::geometric && r.kind != R::Kind::wave) continue;
      const Number growth =
          r.log_growth == 0 ? Number(1) : exponential(Number(r.log_growth) / Number(static_cast<double>(steps_)));
      if (r.kind == R::Kind::geometric) {
        r.p = growth;
        continue;
      }
      const Number cosine = circle<Number>(r.turns, 1, steps_).cosine;
      r.p = Number(2) * cosine, r.q = 1;
      if (r.log_growth != 0) r.p = r.p * growth, r.q = growth * growth;
    }
    return std::move(registers_);
  }

 private:
  const R& at(int r) const { return registers_[static_cast<std::size_t>(r)]; }
  bool fixed(int r) const { return at(r).kind == R::Kind::constant; }
  Number of(int r) const { return at(r).a; }
  int add(const R& r) {
    const auto key =
        std::tuple(static_cast<int>(r.kind), value(r.a), value(r.b), r.turns, r.log_growth, r.left, r.right);
    const auto [place, fresh] = known_.emplace(key, static_cast<int>(registers_.size()));
    if (fresh) registers_.push_back(r);
    return place->second;
  }

  std::int64_t steps_;
  std::vector<R> registers_;
  std::map<std::tuple<int, double, double, Turns, double, int, int>, int> known_;
};

}  // namespace betwixt::algebra
