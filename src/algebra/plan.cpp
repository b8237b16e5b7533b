// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "algebra/plan.h"

#include <algorithm>
#include <map>
#include <tuple>

namespace betwixt::algebra {
namespace {

template <class Number>
using Kind = typename Register<Number>::Kind;

// Makes registers; what is there already is not made again, and what is known is not worked out.
template <class Number>
class Builder {
 public:
  explicit Builder(std::int64_t steps) : steps_(static_cast<double>(steps)) {}
  using R = Register<Number>;

  int constant(Number a) { return add({R::Kind::constant, a}); }
  int ramp(Number a, Number slope) { return slope == Number(0) ? constant(a) : add({R::Kind::ramp, a, slope}); }
  int geometric(Number a, double log_growth) {
    if (log_growth == 0 || a == Number(0)) return constant(a);
    R r{R::Kind::geometric, a};
    r.log_growth = log_growth;
    return add(r);
  }
  int wave(Number a, Number b, long double turns, double log_growth) {
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
    return add({R::Kind::product, {}, {}, 0, 0, std::min(l, r), std::max(l, r)});
  }
  int sum(int l, int r) {
    if (is(l, 0)) return r;
    if (is(r, 0)) return l;
    if (fixed(l) && fixed(r)) return constant(of(l) + of(r));
    return add({R::Kind::sum, {}, {}, 0, 0, std::min(l, r), std::max(l, r)});
  }
  int difference(int l, int r) {
    if (is(r, 0)) return l;
    if (fixed(l) && fixed(r)) return constant(of(l) - of(r));
    return add({R::Kind::difference, {}, {}, 0, 0, l, r});
  }
  bool is(int r, double x) const { return fixed(r) && of(r) == Number(x); }
  // Only those that lead to what is asked for.
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
  // With what a step multiplies by.
  std::vector<R> finished() {
    for (R& r : registers_) {
      if (r.kind != R::Kind::geometric && r.kind != R::Kind::wave) continue;
      const Number growth = r.log_growth == 0 ? Number(1) : exponential(Number(r.log_growth) / Number(steps_));
      if (r.kind == R::Kind::geometric) {
        r.p = growth;
        continue;
      }
      const Number cosine = circle<Number>(r.turns, 1, static_cast<long double>(steps_)).cosine;
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

  double steps_;
  std::vector<R> registers_;
  std::map<std::tuple<int, double, double, long double, double, int, int>, int> known_;
};

struct Pair {
  int x, y;
};

// [k] times (growth_x^k (x cos - y sin), growth_y^k (x sin + y cos)): what turns and growths make of an offset.
template <class Number>
struct Term {
  bool drift = false;  // times k
  Number x{}, y{};
  long double turns = 0;
  double log_x = 0, log_y = 0;

  bool like(const Term& o) const {
    return drift == o.drift && turns == o.turns && log_x == o.log_x && log_y == o.log_y;
  }
  // Whether the block leaves it a term.
  bool takes(const Block& b) const {
    if (b.linear) return !drift && turns == 0 && log_x == 0 && log_y == 0;
    return b.turns == 0 || log_x == log_y;
  }
};

// The offset of A_k from the inside outwards. Where `collapsed` says so, what is inside a block is worked out first
// and then multiplied by the block; elsewhere each offset goes through all blocks as a sequence of its own.
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
      // Those that differed before differ now.
      t.turns += b.turns, t.log_x += b.log_x, t.log_y += b.log_y;
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
    if (b.turns == 0)
      return {make_.product(make_.geometric(1, b.log_x), v.x), make_.product(make_.geometric(1, b.log_y), v.y)};
    const int c = make_.wave(1, 0, b.turns, b.log_x), s = make_.wave(0, 1, b.turns, b.log_x);
    return {make_.difference(make_.product(c, v.x), make_.product(s, v.y)),
            make_.sum(make_.product(s, v.x), make_.product(c, v.y))};
  }
  // One number of an offset: what it is made of, each kind once. What differs in the other number only is one kind
  // here.
  int axis(const std::vector<Term<Number>>& terms, bool y) {
    struct Part {
      bool drift;
      long double turns;
      double log_growth;
      Number cosine, sine;  // what they are multiplied by
    };
    std::vector<Part> parts;
    for (const Term<Number>& t : terms) {
      const double log_growth = y ? t.log_y : t.log_x;
      const Number cosine = y ? t.y : t.x, sine = t.turns == 0 ? Number(0) : y ? t.x : -t.y;
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
      if (p.turns == 0 && p.log_growth == 0) {
        (p.drift ? drift : fixed) = p.cosine;
        continue;
      }
      int c =
          p.turns == 0 ? make_.geometric(p.cosine, p.log_growth) : make_.wave(p.cosine, p.sine, p.turns, p.log_growth);
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

bool merge(Block& into, const Block& b) {
  if (!(into.conformal() && b.conformal()) && !(into.diagonal() && b.diagonal())) return false;
  into.turns += b.turns, into.log_x += b.log_x, into.log_y += b.log_y;
  return true;
}

// The linear part of A_k, with the offsets left out: fewer blocks.
std::vector<Block> reduced(const std::vector<Block>& blocks) {
  std::vector<Block> few;
  for (const Block& b : blocks) {
    if (few.empty() || !merge(few.back(), b)) few.push_back(b);
    if (few.back().identity()) few.pop_back();
  }
  return few;
}

// a, -b, c, d of ((a b) (c d)).
template <class Number>
std::array<int, 4> entries(Builder<Number>& make, const std::vector<Block>& blocks, std::int64_t steps) {
  const Number n(static_cast<double>(steps));
  std::array<int, 4> m{make.constant(1), make.constant(0), make.constant(0), make.constant(1)};
  bool first = true;
  for (const Block& block : blocks) {
    if (block.turns == 0) {
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

template <class Number>
Plan<Number> build(const Canonical<Number>& string, std::int64_t steps, Family family, std::uint64_t collapsed) {
  Builder<Number> make(steps);
  Plan<Number> plan;
  plan.steps = steps;
  const Number n(static_cast<double>(steps));
  // The fixed part of the innermost offset belongs to the points.
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
  const std::vector<Block>& l = plan.blocks;
  const bool any = family == Family::any;
  // Every kind of linear part has its kernel.
  if (l.empty()) {
    plan.kernel = Kernel::offset;
    plan.inputs = {o.x, o.y};
    if (any && m == 0) {
      plan.kernel = Kernel::move;
      plan.centre_x = plan.centre_y = 0;
      plan.gain_x = inner.drift_x, plan.gain_y = inner.drift_y;
      plan.constants = {plan.gain_x, plan.gain_y};
      plan.inputs.clear();
    }
  } else if (any && l.size() == 1 && l[0].linear) {
    plan.kernel = Kernel::ramp;
    plan.slope_x = Number(l[0].slope_x) / n, plan.slope_y = Number(l[0].slope_y) / n;
    plan.inputs = {o.x, o.y};
    plan.blocks.clear();
    // Nothing but one such scaling and ways behind it: all of it in one difference.
    if (m == 1 && inner.fixed()) {
      plan.kernel = Kernel::slide;
      plan.gain_x = string.offsets[0].drift_x + plan.slope_x * plan.centre_x;
      plan.gain_y = string.offsets[0].drift_y + plan.slope_y * plan.centre_y;
      plan.centre_x = plan.centre_y = 0;
      plan.inputs.clear();
    }
  } else if (any && l.size() == 1 && l[0].turns == 0) {
    plan.kernel = Kernel::grow;
    plan.constants = {exponential(Number(l[0].log_x) / n), exponential(Number(l[0].log_y) / n)};
    plan.inputs = {o.x, o.y};
  } else if (any && l.size() == 1 && l[0].log_x == 0) {
    plan.kernel = Kernel::two_term;
    plan.constants = {Number(2) * circle<Number>(l[0].turns, 1, static_cast<long double>(steps)).cosine};
    plan.inputs = {o.x, o.y};
  } else if (any && l.size() == 1) {
    plan.kernel = Kernel::conformal;
    const auto at = circle<Number>(l[0].turns, 1, static_cast<long double>(steps));
    const Number growth = exponential(Number(l[0].log_x) / n), re = growth * at.cosine, im = growth * at.sine;
    plan.constants = {re, re + im, im - re};
    plan.inputs = {o.x, o.y};
  } else if (any && l.size() == 2 && l[0].diagonal() && l[1].conformal()) {
    plan.kernel = Kernel::damped;
    const Number gx = exponential(Number(l[0].log_x + l[1].log_x) / n),
                 gy = exponential(Number(l[0].log_y + l[1].log_y) / n);
    const Number twice = Number(2) * circle<Number>(l[1].turns, 1, static_cast<long double>(steps)).cosine;
    plan.constants = {gx * twice, gy * twice, gx * gx, gy * gy};
    plan.inputs = {o.x, o.y};
  } else {
    const auto e = entries(make, l, steps);
    const bool diagonal = make.is(e[1], 0) && make.is(e[2], 0);
    plan.kernel = diagonal ? Kernel::scale : Kernel::matrix;
    plan.inputs = diagonal ? std::vector{e[0], e[3], o.x, o.y} : std::vector{e[0], e[1], e[2], e[3], o.x, o.y};
  }
  make.keep(plan.inputs);
  plan.registers = make.finished();
  return plan;
}

}  // namespace

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
      // They undo each other: what stood on both sides of them is one.
      string.blocks.pop_back();
      string.offsets.pop_back();
    }
    shift(string.offsets.back(), f.centre, true);
  }
  return string;
}

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
      // Downhill, one block at a time.
      for (bool better = true; better;) {
        better = false;
        for (std::size_t j = 0; j < m; ++j)
          better = better || consider(priced(f, best.collapsed ^ std::uint64_t{1} << j));
      }
    }
  }
  return build(canonical<Number>(motion, steps), steps, best.family, best.collapsed);
}

template Canonical<double> canonical(const Motion&, std::int64_t);
template Canonical<Counted> canonical(const Motion&, std::int64_t);
template struct Plan<double>;
template struct Plan<Counted>;
template Plan<double> compile(const Motion&, std::int64_t, Family, std::size_t);
template Plan<Counted> compile(const Motion&, std::int64_t, Family, std::size_t);

}  // namespace betwixt::algebra
