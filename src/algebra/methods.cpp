// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The source's own methods beside the matrix: geometric (its section 5) and differences (section 4).
#include <fmt/format.h>

#include <algorithm>

#include "algebra/plan.h"

namespace betwixt::algebra {
namespace {

template <class Number>
struct Shears {
  Number a, b;
};
// Of a rotation by these turns in a step.
template <class Number>
Shears<Number> shears(long double turns, std::int64_t steps) {
  const auto n = static_cast<long double>(steps);
  // Half of the angle, which is less than half a turn either way.
  const auto part = static_cast<std::int64_t>(phase(turns, 1, n));
  const Number half(std::ldexp(static_cast<double>(part), -64) * pi);
  return {-tangent(half), circle<Number>(turns, 1, n).sine};
}

bool half_turn(long double turns, std::int64_t steps) {
  const auto part = static_cast<std::int64_t>(phase(turns, 1, static_cast<long double>(steps)));
  return std::abs(std::ldexp(static_cast<double>(part), -63)) > 1 - 1e-9;
}

}  // namespace

std::string letters(const Motion& motion) {
  std::string s;
  for (const Factor& f : motion.factors) s += "TRS"[static_cast<int>(f.kind)];
  return s;
}

long double planar_turns(const Factor& f) { return turns_of(f.axis.z < 0 ? -f.angle : f.angle); }

template <class Number>
Result<Plan<Number>> geometric(const Motion& motion, std::int64_t steps) {
  using R = Register<Number>;
  const std::string row = letters(motion);
  const bool arms = row.size() > 1 && row.find_first_not_of('R') == std::string::npos;
  constexpr const char* rows[] = {"T", "S", "R", "TS", "ST", "TR", "RT", "RS", "SR", "TRS"};
  if (!arms && std::find(std::begin(rows), std::end(rows), row) == std::end(rows))
    return fail(Code::type, fmt::format("the geometric method has no scheme for {}", row.empty() ? "no factors" : row),
                "it knows T, S, R, TS, ST, TR, RT, RS, SR, TRS and R…R; `best` takes every string");
  Plan<Number> plan;
  plan.steps = steps;
  const Number n(static_cast<double>(steps));
  const Factor *t = nullptr, *r = nullptr, *s = nullptr;
  for (const Factor& f : motion.factors)
    (f.kind == Factor::Kind::translate ? t : f.kind == Factor::Kind::rotate ? r : s) = &f;
  if (s && s->law == Factor::Law::exponential && !(s->by.x == 1 && s->by.y == 1))
    return fail(Code::type, "the geometric method scales by the linear law", "S(… linear), or the method `matrix`");
  const auto number = [](double x) { return Number(x); };
  if (s) plan.slope_x = (number(s->by.x) - number(1)) / n, plan.slope_y = (number(s->by.y) - number(1)) / n;
  Number dx = 0, dy = 0;
  if (t) dx = number(t->by.x) / n, dy = number(t->by.y) / n;
  if (!r) {
    if (!s) {
      plan.kernel = Kernel::move;
      plan.gain_x = dx, plan.gain_y = dy;
      plan.constants = {dx, dy};
      return plan;
    }
    plan.kernel = Kernel::slide;
    if (row == "ST") dx = number(s->by.x) * dx, dy = number(s->by.y) * dy;
    plan.gain_x = dx - plan.slope_x * number(s->centre.x), plan.gain_y = dy - plan.slope_y * number(s->centre.y);
    return plan;
  }
  Block turned;
  for (const Factor& f : motion.factors)
    if (f.kind == Factor::Kind::rotate) turned.turns += planar_turns(f);
  long double so_far = 0;
  for (const Factor& f : motion.factors)
    if (f.kind == Factor::Kind::rotate &&
        (half_turn(so_far += planar_turns(f), steps) || half_turn(turned.turns, steps)))
      return fail(Code::range, "half a turn in one step cannot be made of shears", "more steps");
  plan.blocks = {turned};
  const Shears<Number> whole = shears<Number>(turned.turns, steps);
  const Vec3 centre = r->centre;  // of the last, which is the innermost
  plan.centre_x = -centre.x, plan.centre_y = -centre.y;
  plan.constants = {whole.a, whole.b};
  const auto add = [&](R reg) {
    plan.registers.push_back(reg);
    return static_cast<int>(plan.registers.size()) - 1;
  };
  const auto sheared = [&](Number x, Number y, long double turns) {
    const Shears<Number> by = shears<Number>(turns, steps);
    R reg{R::Kind::sheared, x, y, turns};
    reg.p = by.a, reg.q = by.b;
    const int at = add(reg);
    add({R::Kind::second});
    return at;
  };
  const auto fixed_offset = [&] {
    plan.constants.push_back(number(centre.x));
    plan.constants.push_back(number(centre.y));
  };
  const auto moving_offset = [&] {
    plan.inputs = {add({R::Kind::ramp, number(centre.x), dx}), add({R::Kind::ramp, number(centre.y), dy})};
  };
  const auto gain = [&](double c, double about, Number slope) { return slope * (number(c) - number(about)); };
  if (row == "R" || row == "TR") {
    plan.kernel = Kernel::shears;
    t ? moving_offset() : fixed_offset();
  } else if (arms) {
    plan.kernel = Kernel::shears;
    const std::vector<Factor>& f = motion.factors;
    int x = add({R::Kind::constant, number(f[0].centre.x)}), y = add({R::Kind::constant, number(f[0].centre.y)});
    long double turns = 0;
    for (std::size_t j = 0; j + 1 < f.size(); ++j) {
      turns += planar_turns(f[j]);
      const Vec3 from = f[j].centre, to = f[j + 1].centre;
      const int arm = sheared(number(to.x) - number(from.x), number(to.y) - number(from.y), turns);
      x = add({R::Kind::sum, {}, {}, 0, 0, x, arm}), y = add({R::Kind::sum, {}, {}, 0, 0, y, arm + 1});
    }
    plan.inputs = {x, y};
  } else if (row == "RT") {
    plan.kernel = Kernel::pushed_shears;
    fixed_offset();
    plan.gain_x = dx, plan.gain_y = dy;
    const int push = sheared(dx, dy, turned.turns);
    plan.inputs = {push, push + 1};
  } else if (row == "SR") {
    plan.kernel = Kernel::swung_shears;
    plan.home_x = centre.x, plan.home_y = centre.y;
    plan.gain_x = number(centre.x) - number(s->centre.x), plan.gain_y = number(centre.y) - number(s->centre.y);
  } else {  // RS, TRS
    plan.kernel = Kernel::carried_shears;
    plan.gain_x = gain(centre.x, s->centre.x, plan.slope_x), plan.gain_y = gain(centre.y, s->centre.y, plan.slope_y);
    t ? moving_offset() : fixed_offset();
  }
  return plan;
}

template <class Number>
Result<Plan<Number>> differences(const Motion& motion, std::int64_t steps) {
  const Canonical<Number> string = canonical<Number>(motion, steps);
  const auto none = [](std::string why) {
    return fail(Code::type, "no one matrix makes all steps of this motion: " + why,
                "the method `best` takes every string");
  };
  Plan<Number> plan;
  plan.steps = steps;
  const Number n(static_cast<double>(steps));
  const Offset<Number>& outer = string.offsets[0];
  if (string.blocks.empty()) {
    plan.kernel = Kernel::move;
    plan.gain_x = outer.drift_x, plan.gain_y = outer.drift_y;
    plan.constants = {plan.gain_x, plan.gain_y};
    return plan;
  }
  if (string.blocks.size() > 1) return none("its factors do not commute, so the root of the whole takes another path");
  const Block& b = string.blocks[0];
  const Offset<Number>& inner = string.offsets[1];
  if (b.linear) return none("the steps of a scaling by the linear law are not alike");
  const Number drift_x = outer.drift_x + inner.drift_x, drift_y = outer.drift_y + inner.drift_y;
  const bool commutes =
      b.turns == 0 && (b.log_x == 0 || drift_x == Number(0)) && (b.log_y == 0 || drift_y == Number(0));
  if (!(outer.fixed() && inner.fixed()) && !commutes)
    return none(b.turns != 0 ? "a way and a turn do not commute, so the root of the whole is an arc and not this path"
                             : "a way and a scaling do not commute, so the root of the whole takes another path");
  plan.centre_x = inner.x, plan.centre_y = inner.y;
  plan.home_x = outer.x, plan.home_y = outer.y;
  plan.gain_x = drift_x, plan.gain_y = drift_y;
  plan.blocks = {b};
  const Number gx = exponential(Number(b.log_x) / n);
  if (b.turns == 0) {
    const Number gy = b.log_y == b.log_x ? gx : exponential(Number(b.log_y) / n);
    plan.kernel = Kernel::stretch;
    plan.constants = {gx, gy, gx * inner.x + outer.x + drift_x, gy * inner.y + outer.y + drift_y};
    return plan;
  }
  const auto at = circle<Number>(b.turns, 1, static_cast<long double>(steps));
  const Number c = gx * at.cosine, s = gx * at.sine;
  plan.kernel = Kernel::turn;
  plan.constants = {c, s, c * inner.x - s * inner.y + outer.x, s * inner.x + c * inner.y + outer.y};
  return plan;
}

template Result<Plan<double>> geometric(const Motion&, std::int64_t);
template Result<Plan<Counted>> geometric(const Motion&, std::int64_t);
template Result<Plan<double>> differences(const Motion&, std::int64_t);
template Result<Plan<Counted>> differences(const Motion&, std::int64_t);

}  // namespace betwixt::algebra
