// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "algebra/plan.h"

#include <algorithm>

#include "algebra/offset.h"
#include "algebra/registers.h"

namespace betwixt::algebra {
namespace {

// Returns the blocks of the linear part of A_k, without offsets, so there are fewer.
std::vector<Block> reduced(const std::vector<Block>& blocks) {
  std::vector<Block> few;
  for (const Block& b : blocks) {
    if (few.empty() || !merge(few.back(), b)) few.push_back(b);
    if (few.back().identity()) few.pop_back();
  }
  return few;
}

// Returns a, -b, c, d of ((a b) (c d)).
template <class Number>
std::array<int, 4> entries(Builder<Number>& make, const std::vector<Block>& blocks, std::int64_t steps) {
  const Number n(static_cast<double>(steps));
  std::array<int, 4> m{make.constant(1), make.constant(0), make.constant(0), make.constant(1)};
  bool first = true;
  for (const Block& block : blocks) {
    if (block.turns.none()) {
      const int gx = block.linear ? make.ramp(1, Number(block.slope_x) / n) : make.geometric(1, block.log_x);
      const int gy = block.linear ? make.ramp(1, Number(block.slope_y) / n) : make.geometric(1, block.log_y);
      m = {make.product(m[0], gx), make.product(m[1], gy), make.product(m[2], gx), make.product(m[3], gy)};
    } else {
      const int c = make.wave(1, 0, block.turns, block.log_x), s = make.wave(0, 1, block.turns, block.log_x);
      m = first ? std::array{c, s, s, c}
                : std::array{make.difference(make.product(m[0], c), make.product(m[1], s)),
                             make.sum(make.product(m[0], s), make.product(m[1], c)),
                             make.sum(make.product(m[2], c), make.product(m[3], s)),
                             make.difference(make.product(m[3], c), make.product(m[2], s))};
    }
    first = false;
  }
  return m;
}

// Chooses the kernel for a linear part of one law that steps the points in place; returns false if there is none.
template <class Number>
bool by_law(Plan<Number>& plan, const Canonical<Number>& string, const Offset<Number>& inner, Pair o) {
  const Number n(static_cast<double>(plan.steps));
  const auto turn = [&](const Block& b) { return circle<Number>(b.turns, 1, plan.steps); };
  const std::vector<Block>& l = plan.blocks;
  plan.inputs = {o.x, o.y};
  if (l.empty()) {
    plan.kernel = Kernel::offset;
    if (!string.blocks.empty()) return true;
    plan.kernel = Kernel::move;
    plan.centre_x = plan.centre_y = 0;
    plan.gain_x = inner.drift_x, plan.gain_y = inner.drift_y;
    plan.constants = {plan.gain_x, plan.gain_y};
    plan.inputs.clear();
  } else if (l.size() == 1 && l[0].linear) {
    plan.kernel = Kernel::ramp;
    plan.slope_x = Number(l[0].slope_x) / n, plan.slope_y = Number(l[0].slope_y) / n;
    plan.blocks.clear();
    // A single such scaling, with translations after it: one difference has all of it.
    if (string.blocks.size() != 1 || !inner.fixed()) return true;
    plan.kernel = Kernel::slide;
    plan.gain_x = string.offsets[0].drift_x + plan.slope_x * plan.centre_x;
    plan.gain_y = string.offsets[0].drift_y + plan.slope_y * plan.centre_y;
    plan.centre_x = plan.centre_y = 0;
    plan.inputs.clear();
  } else if (l.size() == 1 && l[0].turns.none()) {
    plan.kernel = Kernel::grow;
    plan.constants = {exponential(Number(l[0].log_x) / n), exponential(Number(l[0].log_y) / n)};
  } else if (l.size() == 1 && l[0].log_x == 0) {
    plan.kernel = Kernel::two_term;
    plan.constants = {Number(2) * turn(l[0]).cosine};
  } else if (l.size() == 1) {
    plan.kernel = Kernel::conformal;
    const auto at = turn(l[0]);
    const Number growth = exponential(Number(l[0].log_x) / n), re = growth * at.cosine, im = growth * at.sine;
    plan.constants = {re, re + im, im - re};
  } else if (l.size() == 2 && l[0].diagonal() && l[1].conformal()) {
    plan.kernel = Kernel::damped;
    const Number gx = exponential(Number(l[0].log_x + l[1].log_x) / n),
                 gy = exponential(Number(l[0].log_y + l[1].log_y) / n);
    const Number twice = Number(2) * turn(l[1]).cosine;
    plan.constants = {gx * twice, gy * twice, gx * gx, gy * gy};
  } else {
    return false;
  }
  return true;
}

// Chooses the kernel that multiplies the points at rest by A_k; there is always one.
template <class Number>
void by_matrix(Plan<Number>& plan, Builder<Number>& make, Pair o) {
  if (plan.blocks.empty()) {
    plan.kernel = Kernel::offset;
    plan.inputs = {o.x, o.y};
    return;
  }
  const auto e = entries(make, plan.blocks, plan.steps);
  const bool diagonal = make.is(e[1], 0) && make.is(e[2], 0);
  plan.kernel = diagonal ? Kernel::scale : Kernel::matrix;
  plan.inputs = diagonal ? std::vector{e[0], e[3], o.x, o.y} : std::vector{e[0], e[1], e[2], e[3], o.x, o.y};
}

template <class Number>
Plan<Number> build(const Canonical<Number>& string, std::int64_t steps, Family family, std::uint64_t collapsed) {
  Builder<Number> make(steps);
  Plan<Number> plan;
  plan.steps = steps;
  // The constant part of the innermost offset is added to the points.
  Offset<Number> inner = string.offsets.back();
  plan.centre_x = inner.x, plan.centre_y = inner.y;
  inner.x = 0, inner.y = 0;
  Horner<Number> offset(make, steps);
  offset.add(inner);
  const std::size_t m = string.blocks.size();
  for (std::size_t j = m; j-- > 0;) {
    offset.multiply(string.blocks[j], j < 64 && (collapsed >> j & 1));
    offset.add(string.offsets[j]);
  }
  const Pair o = offset.result();
  plan.blocks = reduced(string.blocks);
  if (family != Family::any || !by_law(plan, string, inner, o)) by_matrix(plan, make, o);
  make.keep(plan.inputs);
  plan.registers = make.finished();
  return plan;
}

}  // namespace

template <class Number>
int Plan<Number>::per_step() const {
  int operations = 0;
  for (const Register<Number>& r : registers) {
    using K = typename Register<Number>::Kind;
    if (r.kind == K::wave)
      operations += r.log_growth == 0 ? 2 : 3;
    else if (r.kind == K::sheared)
      operations += 6;
    else if (r.kind != K::constant && r.kind != K::second)
      ++operations;
  }
  return operations;
}

template <class Number>
Plan<Number> compile(const Motion& motion, std::int64_t steps, Family family, std::size_t points) {
  constexpr std::size_t tried_all = 8, tried_each = 40;  // blocks
  const Canonical<double> string = canonical<double>(motion, steps);
  const std::size_t m = string.blocks.size();
  struct Choice {
    Family family = Family::matrix;
    std::uint64_t collapsed = 0;
    double cost = 0;
  };
  const auto priced = [&](Family f, std::uint64_t collapsed) {
    const Plan<double> plan = build(string, steps, f, collapsed);
    return Choice{f, collapsed, static_cast<double>(points) * plan.per_point() + plan.per_step()};
  };
  Choice best = priced(family, 0);
  const auto consider = [&](const Choice& c) {
    if (c.cost < best.cost) best = c;
    return best.collapsed == c.collapsed && best.family == c.family;
  };
  for (const Family f : {Family::any, Family::matrix}) {
    if (f == Family::any && family != f) continue;
    if (m <= tried_all) {
      for (std::uint64_t c = 0; c < std::uint64_t{1} << m; ++c) consider(priced(f, c));
    } else {
      consider(priced(f, 0));
      consider(priced(f, ~std::uint64_t{0}));
      if (m > tried_each) continue;
      // Descend, one block at a time.
      for (bool better = true; better;) {
        better = false;
        for (std::size_t j = 0; j < m; ++j)
          better = better || consider(priced(f, best.collapsed ^ std::uint64_t{1} << j));
      }
    }
  }
  return build(canonical<Number>(motion, steps), steps, best.family, best.collapsed);
}

template struct Plan<double>;
template struct Plan<Counted>;
template Plan<double> compile(const Motion&, std::int64_t, Family, std::size_t);
template Plan<Counted> compile(const Motion&, std::int64_t, Family, std::size_t);

}  // namespace betwixt::algebra
