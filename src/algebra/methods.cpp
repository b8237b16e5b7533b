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
// Makes the shears of a rotation by these turns a step.
template <class Number>
Shears<Number> shears(Turns turns, std::int64_t steps) {
  // Half of the angle, in either direction below half a turn.
  const auto part = static_cast<std::int64_t>(phase(turns, 1, steps));
  const Number half(std::ldexp(static_cast<double>(part), -64) * pi);
  return {-tangent(half), circle<Number>(turns, 1, steps).sine};
}

bool half_turn(Turns turns, std::int64_t steps) {
  const auto part = static_cast<std::int64_t>(phase(turns, 1, steps));
  return std::abs(std::ldexp(static_cast<double>(part), -63)) > 1 - 1e-9;
}

// Builds the plan of a row of the source's table.
template <class Number>
class Scheme {
 public:
  Scheme(const Motion& motion, std::int64_t steps, const std::string& row) : motion_(motion), row_(row) {
    plan_.steps = steps;
    for (const Factor& f : motion.factors)
      (f.kind == Factor::Kind::translate ? t_ : f.kind == Factor::Kind::rotate ? r_ : s_) = &f;
    const Number n(static_cast<double>(steps)), one(1);
    if (s_) plan_.slope_x = (Number(s_->by.x) - one) / n, plan_.slope_y = (Number(s_->by.y) - one) / n;
    if (t_) dx_ = Number(t_->by.x) / n, dy_ = Number(t_->by.y) / n;
  }

  Result<Plan<Number>> made() {
    if (s_ && s_->law == Factor::Law::exponential && !(s_->by.x == 1 && s_->by.y == 1))
      return fail(ErrorCode::type, "the geometric method needs the linear law for scalings",
                  "write S(… linear), or use the method `matrix`");
    if (!r_) return go_straight(), plan_;
    Turns all, so_far;
    for (const Factor& f : motion_.factors)
      if (f.kind == Factor::Kind::rotate) all = all + planar_turns(f);
    for (const Factor& f : motion_.factors)
      if (f.kind == Factor::Kind::rotate &&
          (half_turn(so_far = so_far + planar_turns(f), plan_.steps) || half_turn(all, plan_.steps)))
        return fail(ErrorCode::range, "shears cannot make half a turn in one step", "use more steps");
    return turn(all), plan_;
  }

 private:
  using R = Register<Number>;

  int add(const R& reg) {
    plan_.registers.push_back(reg);
    return static_cast<int>(plan_.registers.size()) - 1;
  }
  int sheared(Number x, Number y, Turns turns) {
    const Shears<Number> by = shears<Number>(turns, plan_.steps);
    R reg{R::Kind::sheared, x, y, turns};
    reg.p = by.a, reg.q = by.b;
    const int at = add(reg);
    add({R::Kind::second});
    return at;
  }
  // Puts the offset of the rotation, constant or moving.
  void put_offset() {
    const Vec3 c = r_->centre;
    if (t_)
      plan_.inputs = {add({R::Kind::ramp, Number(c.x), dx_}), add({R::Kind::ramp, Number(c.y), dy_})};
    else
      plan_.constants.insert(plan_.constants.end(), {Number(c.x), Number(c.y)});
  }

  void go_straight() {
    plan_.kernel = s_ ? Kernel::slide : Kernel::move;
    if (row_ == "ST") dx_ = Number(s_->by.x) * dx_, dy_ = Number(s_->by.y) * dy_;
    plan_.gain_x = s_ ? dx_ - plan_.slope_x * Number(s_->centre.x) : dx_;
    plan_.gain_y = s_ ? dy_ - plan_.slope_y * Number(s_->centre.y) : dy_;
    if (!s_) plan_.constants = {dx_, dy_};
  }

  void turn(Turns turns) {
    Block turned;
    turned.turns = turns;
    plan_.blocks = {turned};
    const Shears<Number> whole = shears<Number>(turns, plan_.steps);
    const Vec3 centre = r_->centre;  // of the last rotation, which is the innermost
    plan_.centre_x = -centre.x, plan_.centre_y = -centre.y;
    plan_.constants = {whole.a, whole.b};
    if (row_ == "R" || row_ == "TR") {
      plan_.kernel = Kernel::shears;
      put_offset();
    } else if (row_ == "RT") {
      plan_.kernel = Kernel::pushed_shears;
      plan_.constants.insert(plan_.constants.end(), {Number(centre.x), Number(centre.y)});
      plan_.gain_x = dx_, plan_.gain_y = dy_;
      const int push = sheared(dx_, dy_, turns);
      plan_.inputs = {push, push + 1};
    } else if (row_ == "SR") {
      plan_.kernel = Kernel::swung_shears;
      plan_.home_x = centre.x, plan_.home_y = centre.y;
      plan_.gain_x = Number(centre.x) - Number(s_->centre.x), plan_.gain_y = Number(centre.y) - Number(s_->centre.y);
    } else if (s_) {  // RS, TRS
      plan_.kernel = Kernel::carried_shears;
      plan_.gain_x = plan_.slope_x * (Number(centre.x) - Number(s_->centre.x));
      plan_.gain_y = plan_.slope_y * (Number(centre.y) - Number(s_->centre.y));
      put_offset();
    } else {
      plan_.kernel = Kernel::shears;
      turn_arms();
    }
  }

  // Each arm turns about the end of the arm before it.
  void turn_arms() {
    const std::vector<Factor>& f = motion_.factors;
    int x = add({R::Kind::constant, Number(f[0].centre.x)}), y = add({R::Kind::constant, Number(f[0].centre.y)});
    Turns turns;
    for (std::size_t j = 0; j + 1 < f.size(); ++j) {
      turns = turns + planar_turns(f[j]);
      const Vec3 from = f[j].centre, to = f[j + 1].centre;
      const int arm = sheared(Number(to.x) - Number(from.x), Number(to.y) - Number(from.y), turns);
      x = add({R::Kind::sum, {}, {}, {}, 0, x, arm}), y = add({R::Kind::sum, {}, {}, {}, 0, y, arm + 1});
    }
    plan_.inputs = {x, y};
  }

  const Motion& motion_;
  const std::string row_;
  const Factor *t_ = nullptr, *r_ = nullptr, *s_ = nullptr;  // the last of each
  Number dx_ = 0, dy_ = 0;                                   // of a step
  Plan<Number> plan_;
};

}  // namespace

std::string letters(const Motion& motion) {
  std::string s;
  for (const Factor& f : motion.factors) s += "TRS"[static_cast<int>(f.kind)];
  return s;
}

Turns planar_turns(const Factor& f) {
  const Turns turns = turns_of(f.angle, f.angle_rest);
  return f.axis.z < 0 ? -turns : turns;
}

template <class Number>
Result<Plan<Number>> geometric(const Motion& motion, std::int64_t steps) {
  const std::string row = letters(motion);
  const bool arms = row.size() > 1 && row.find_first_not_of('R') == std::string::npos;
  constexpr const char* rows[] = {"T", "S", "R", "TS", "ST", "TR", "RT", "RS", "SR", "TRS"};
  if (!arms && std::find(std::begin(rows), std::end(rows), row) == std::end(rows))
    return fail(ErrorCode::type,
                fmt::format("the geometric method does not support {}", row.empty() ? "no factors" : row),
                "it supports T, S, R, TS, ST, TR, RT, RS, SR, TRS and R…R; `best` supports every string");
  return Scheme<Number>(motion, steps, row).made();
}

namespace {

// Returns the constant matrix of one step.
template <class Number>
Plan<Number> whole_step(const Motion& motion) {
  const Mat4 m = at(motion, 1);
  Plan<Number> plan;
  plan.kernel = Kernel::matrix;
  plan.constants = {m(0, 0), -m(0, 1), m(1, 0), m(1, 1), m(0, 3), m(1, 3)};
  plan.whole_step = true;
  return plan;
}

template <class Number>
Result<Plan<Number>> same_steps(const Motion& motion, std::int64_t steps) {
  const Canonical<Number> string = canonical<Number>(motion, steps);
  const auto none = [](std::string why) {
    return fail(ErrorCode::type, "no single matrix makes all steps of this motion: " + why,
                "the method `best` supports every string");
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
  if (b.linear) return none("the steps of a scaling by the linear law differ");
  const Number drift_x = outer.drift_x + inner.drift_x, drift_y = outer.drift_y + inner.drift_y;
  const bool commutes =
      b.turns.none() && (b.log_x == 0 || drift_x == Number(0)) && (b.log_y == 0 || drift_y == Number(0));
  if (!(outer.fixed() && inner.fixed()) && !commutes)
    return none(
        !b.turns.none()
            ? "a translation and a rotation do not commute, so the root of the whole is an arc instead of this path"
            : "a translation and a scaling do not commute, so the root of the whole takes another path");
  plan.centre_x = inner.x, plan.centre_y = inner.y;
  plan.home_x = outer.x, plan.home_y = outer.y;
  plan.gain_x = drift_x, plan.gain_y = drift_y;
  plan.blocks = {b};
  const Number gx = exponential(Number(b.log_x) / n);
  if (b.turns.none()) {
    const Number gy = b.log_y == b.log_x ? gx : exponential(Number(b.log_y) / n);
    plan.kernel = Kernel::stretch;
    plan.constants = {gx, gy, gx * inner.x + outer.x + drift_x, gy * inner.y + outer.y + drift_y};
    return plan;
  }
  const auto at = circle<Number>(b.turns, 1, steps);
  const Number c = gx * at.cosine, s = gx * at.sine;
  plan.kernel = Kernel::turn;
  plan.constants = {c, s, c * inner.x - s * inner.y + outer.x, s * inner.x + c * inner.y + outer.y};
  return plan;
}

}  // namespace

template <class Number>
Result<Plan<Number>> differences(const Motion& motion, std::int64_t steps) {
  auto plan = same_steps<Number>(motion, steps);
  if (!plan && steps == 1) return whole_step<Number>(motion);
  return plan;
}

template Result<Plan<double>> geometric(const Motion&, std::int64_t);
template Result<Plan<Counted>> geometric(const Motion&, std::int64_t);
template Result<Plan<double>> differences(const Motion&, std::int64_t);
template Result<Plan<Counted>> differences(const Motion&, std::int64_t);

}  // namespace betwixt::algebra
