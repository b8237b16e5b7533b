// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The offset of A_k as registers.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "algebra/registers.h"

namespace betwixt::algebra {

struct Pair {
  int x, y;
};

// A term [k] (growth_x^k (x cos - y sin), growth_y^k (x sin + y cos)): an offset after rotations and scalings.
template <class Number>
struct Term {
  bool drift = false;  // whether it has the factor k
  Number x{}, y{};
  Turns turns{};
  double log_x = 0, log_y = 0;

  bool like(const Term& o) const {
    return drift == o.drift && turns == o.turns && log_x == o.log_x && log_y == o.log_y;
  }
  // Returns true if the block maps a term to a term.
  bool takes(const Block& b) const {
    if (b.linear) return !drift && turns.none() && log_x == 0 && log_y == 0;
    return b.turns.none() || log_x == log_y;
  }
};

// Computes the offset of A_k from the inside outwards. For a block with `collapsed`, the inner offset is computed first
// and then multiplied by the block; for any other, each offset goes through all blocks as a sequence of its own.
template <class Number>
class Horner {
 public:
  Horner(Builder<Number>& make, std::int64_t steps) : make_(make), steps_(static_cast<double>(steps)) {}

  void add(const Offset<Number>& d) {
    merge(Term<Number>{false, d.x, d.y});
    merge(Term<Number>{true, d.drift_x, d.drift_y});
  }
  void multiply(const Block& b, bool collapse) {
    std::vector<Term<Number>> through, stuck;
    for (const Term<Number>& t : terms_) (t.takes(b) && !collapse ? through : stuck).push_back(t);
    terms_.clear();
    if (!stuck.empty() || has_sum_) {
      const Pair inside = worked_out(stuck);
      sum_ = product(b, inside), has_sum_ = true;
    }
    for (Term<Number>& t : through) {
      if (b.linear) {
        const Number x = t.x * slope(b.slope_x), y = t.y * slope(b.slope_y);
        terms_.push_back(t);
        terms_.push_back({true, x, y});
        continue;
      }
      // Terms that differed before differ now too.
      t.turns = t.turns + b.turns, t.log_x += b.log_x, t.log_y += b.log_y;
      terms_.push_back(t);
    }
  }
  Pair result() { return worked_out(terms_); }

 private:
  Number slope(double whole) { return Number(whole) / Number(steps_); }
  void merge(const Term<Number>& t) {
    if (t.x == Number(0) && t.y == Number(0)) return;
    for (Term<Number>& o : terms_)
      if (o.like(t)) {
        o.x = o.x + t.x, o.y = o.y + t.y;
        return;
      }
    terms_.push_back(t);
  }
  Pair product(const Block& b, Pair v) {
    if (b.linear)
      return {make_.product(make_.ramp(1, slope(b.slope_x)), v.x), make_.product(make_.ramp(1, slope(b.slope_y)), v.y)};
    if (b.turns.none())
      return {make_.product(make_.geometric(1, b.log_x), v.x), make_.product(make_.geometric(1, b.log_y), v.y)};
    const int c = make_.wave(1, 0, b.turns, b.log_x), s = make_.wave(0, 1, b.turns, b.log_x);
    return {make_.difference(make_.product(c, v.x), make_.product(s, v.y)),
            make_.sum(make_.product(s, v.x), make_.product(c, v.y))};
  }
  // Returns one coordinate of the offset, with each kind of term once. Terms that differ in the other coordinate only
  // are of one kind here.
  int axis(const std::vector<Term<Number>>& terms, bool y) {
    struct Part {
      bool drift;
      Turns turns{};
      double log_growth;
      Number cosine, sine;  // their coefficients
    };
    std::vector<Part> parts;
    for (const Term<Number>& t : terms) {
      const double log_growth = y ? t.log_y : t.log_x;
      const Number cosine = y ? t.y : t.x, sine = t.turns.none() ? Number(0) : y ? t.x : -t.y;
      const auto like = std::find_if(parts.begin(), parts.end(), [&](const Part& p) {
        return p.drift == t.drift && p.turns == t.turns && p.log_growth == log_growth;
      });
      if (like == parts.end())
        parts.push_back({t.drift, t.turns, log_growth, cosine, sine});
      else
        like->cosine = like->cosine + cosine, like->sine = like->sine + sine;
    }
    Number fixed = 0, drift = 0;
    int sum = make_.constant(0);
    for (const Part& p : parts) {
      if (p.turns.none() && p.log_growth == 0) {
        (p.drift ? drift : fixed) = p.cosine;
        continue;
      }
      int c = p.turns.none() ? make_.geometric(p.cosine, p.log_growth)
                             : make_.wave(p.cosine, p.sine, p.turns, p.log_growth);
      if (p.drift) c = make_.product(make_.ramp(0, 1), c);
      sum = make_.sum(sum, c);
    }
    return make_.sum(make_.ramp(fixed, drift), sum);
  }
  Pair worked_out(const std::vector<Term<Number>>& terms) {
    Pair all{axis(terms, false), axis(terms, true)};
    if (has_sum_) all = {make_.sum(sum_.x, all.x), make_.sum(sum_.y, all.y)};
    return all;
  }

  Builder<Number>& make_;
  double steps_;
  std::vector<Term<Number>> terms_;
  Pair sum_{};
  bool has_sum_ = false;
};

}  // namespace betwixt::algebra
