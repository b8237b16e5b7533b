// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "algebra/stepper.h"

#include <type_traits>

namespace betwixt::algebra {
namespace {

// ((a b) (c d)) of blocks at step k.
template <class Number>
struct LinearPart {
  Number a{1}, b{0}, c{0}, d{1};
  bool turned = false;
};
template <class Number>
LinearPart<Number> linear_at(const std::vector<Block>& blocks, std::int64_t k, std::int64_t steps) {
  LinearPart<Number> m;
  const Number part(static_cast<double>(k) / static_cast<double>(steps));
  for (const Block& l : blocks) {
    Number gx = 1, gy = 1;
    if (l.linear)
      gx = Number(1) + part * Number(l.slope_x), gy = Number(1) + part * Number(l.slope_y);
    else if (l.log_x != 0 || l.log_y != 0)
      gx = exponential(part * Number(l.log_x)), gy = l.log_x == l.log_y ? gx : exponential(part * Number(l.log_y));
    if (l.turns.none()) {
      m.a = m.a * gx, m.c = m.c * gx, m.b = m.b * gy, m.d = m.d * gy;
      continue;
    }
    const auto at = circle<Number>(l.turns, k, steps);
    const Number c = gx * at.cosine, s = gx * at.sine;
    m = {m.a * c + m.b * s, m.b * c - m.a * s, m.c * c + m.d * s, m.d * c - m.c * s, true};
  }
  return m;
}

template <class Number>
void shear(Number& x, Number& y, Number a, Number b) {
  x = x + a * y;
  y = y + b * x;
  x = x + a * y;
}

template <class To, class From>
To as(From x) {
  if constexpr (std::is_same_v<To, From>)
    return x;
  else
    return static_cast<To>(value(x));
}

}  // namespace

template <class Number>
Stepper<Number>::Stepper(Plan<Constant> plan, Motion motion, std::span<const Number> x, std::span<const Number> y)
    : plan_(std::move(plan)), motion_(std::move(motion)), rest_x_(x.begin(), x.end()), rest_y_(y.begin(), y.end()) {
  const bool two_term = plan_.kernel == Kernel::two_term || plan_.kernel == Kernel::damped;
  if (std::is_same_v<Number, float>) renew_ = two_term ? 32 : 64;
  if (from_rest()) renew_ = 0;  // the points stay at rest
  const std::size_t n = rest_x_.size();
  const Uses use = uses(plan_.kernel);
  x_.resize(n), y_.resize(n), out_x_.resize(n), out_y_.resize(n);
  if (use.second) u_.resize(n), v_.resize(n);
  if (use.gain) du_.resize(n), dv_.resize(n);
  registers_.resize(plan_.registers.size()), before_.resize(registers_.size());
  for (const auto& r : plan_.registers) p_.push_back(as<Number>(r.p)), q_.push_back(as<Number>(r.q));
  for (const Constant& c : plan_.constants) inputs_.push_back(as<Number>(c));
  inputs_.resize(static_cast<std::size_t>(most_inputs));
  seek(0);
}

template <class Number>
void Stepper<Number>::seek(std::int64_t k) {
  k_ = k, since_ = 0;
  seek_registers();
  seek_points();
}

template <class Number>
void Stepper<Number>::seek_registers() {
  const auto at = [&](const Register<Constant>& r, std::int64_t k) -> Constant {
    using Kind = typename Register<Constant>::Kind;
    const Constant count(static_cast<double>(k));
    if (r.kind == Kind::constant || k == 0) return r.a;
    if (r.kind == Kind::ramp) return r.a + r.b * count;
    const double part = static_cast<double>(k) / static_cast<double>(plan_.steps);
    Constant growth = 1;
    if (r.log_growth != 0) growth = exponential(Constant(r.log_growth) * Constant(part));
    if (r.kind == Kind::geometric) return r.a * growth;
    const auto turn = circle<Constant>(r.turns, k, plan_.steps);
    const Constant wave =
        r.kind == Kind::sheared ? r.a * turn.cosine - r.b * turn.sine : r.a * turn.cosine + r.b * turn.sine;
    return r.log_growth != 0 ? growth * wave : wave;
  };
  for (std::size_t i = 0; i < registers_.size(); ++i) {
    const Register<Constant>& r = plan_.registers[i];
    using Kind = typename Register<Constant>::Kind;
    const auto left = [&] { return registers_[static_cast<std::size_t>(r.left)]; };
    const auto right = [&] { return registers_[static_cast<std::size_t>(r.right)]; };
    switch (r.kind) {
      case Kind::product:
        registers_[i] = left() * right();
        break;
      case Kind::sum:
        registers_[i] = left() + right();
        break;
      case Kind::difference:
        registers_[i] = left() - right();
        break;
      case Kind::second: {
        const Register<Constant>& of = plan_.registers[i - 1];
        const auto turn = circle<Constant>(of.turns, k_, plan_.steps);
        registers_[i] = as<Number>(k_ == 0 ? of.b : of.a * turn.sine + of.b * turn.cosine);
        break;
      }
      case Kind::wave:
        before_[i] = as<Number>(at(r, k_ - 1));
        [[fallthrough]];
      default:
        registers_[i] = as<Number>(at(r, k_));
    }
  }
  gather_inputs();
}

template <class Number>
void Stepper<Number>::step_registers() {
  for (std::size_t i = 0; i < registers_.size(); ++i) {
    const Register<Constant>& r = plan_.registers[i];
    using Kind = typename Register<Constant>::Kind;
    Number& x = registers_[i];
    switch (r.kind) {
      case Kind::constant:
      case Kind::second:
        break;
      case Kind::ramp:
        x = x + as<Number>(r.b);
        break;
      case Kind::geometric:
        x = p_[i] * x;
        break;
      case Kind::wave: {
        const Number next = r.log_growth == 0 ? p_[i] * x - before_[i] : p_[i] * x - q_[i] * before_[i];
        before_[i] = x, x = next;
        break;
      }
      case Kind::sheared:
        shear(x, registers_[i + 1], p_[i], q_[i]);
        break;
      case Kind::product:
        x = registers_[static_cast<std::size_t>(r.left)] * registers_[static_cast<std::size_t>(r.right)];
        break;
      case Kind::sum:
        x = registers_[static_cast<std::size_t>(r.left)] + registers_[static_cast<std::size_t>(r.right)];
        break;
      case Kind::difference:
        x = registers_[static_cast<std::size_t>(r.left)] - registers_[static_cast<std::size_t>(r.right)];
        break;
    }
  }
  gather_inputs();
}

template <class Number>
void Stepper<Number>::gather_inputs() {
  for (std::size_t i = 0; i < plan_.inputs.size(); ++i)
    inputs_[plan_.constants.size() + i] = registers_[static_cast<std::size_t>(plan_.inputs[i])];
}

// state = L_k (rest + k (gain + slope rest)) + home; in f64 also for f32.
template <class Number>
void Stepper<Number>::seek_points() {
  const Kernel kernel = plan_.kernel;
  const Uses use = uses(kernel);
  const bool moved = !plan_.blocks.empty() && k_ != 0 && !from_rest();
  const LinearPart<Constant> now = moved ? linear_at<Constant>(plan_.blocks, k_, plan_.steps) : LinearPart<Constant>{};
  const bool recalls = kernel == Kernel::two_term || kernel == Kernel::damped;
  const LinearPart<Constant> earlier =
      recalls ? linear_at<Constant>(plan_.blocks, k_ - 1, plan_.steps) : LinearPart<Constant>{};
  const bool swung = kernel == Kernel::swung_shears;
  const LinearPart<Constant> whole =
      swung ? linear_at<Constant>(plan_.blocks, plan_.steps, plan_.steps) : LinearPart<Constant>{};
  const Constant k(static_cast<double>(k_));
  const bool centred = !(plan_.centre_x == Constant(0) && plan_.centre_y == Constant(0));
  const bool own = use.second && !recalls && !swung;  // each point has an increment of its own
  const bool all = !own && !swung && !(plan_.gain_x == Constant(0) && plan_.gain_y == Constant(0));
  struct Point {
    Constant x, y;
  };
  const auto times = [](const LinearPart<Constant>& m, Point p) -> Point {
    if (!m.turned) return {m.a * p.x, m.d * p.y};
    return {m.a * p.x + m.b * p.y, m.c * p.x + m.d * p.y};
  };
  for (std::size_t i = 0; i < rest_x_.size(); ++i) {
    Point p{as<Constant>(rest_x_[i]), as<Constant>(rest_y_[i])};
    // In place, frame 0 is the points as given, to the last bit.
    if (centred && !(in_place() && k_ == 0)) p = {p.x + plan_.centre_x, p.y + plan_.centre_y};
    Point gain{plan_.gain_x, plan_.gain_y};
    if (own) gain = {gain.x + plan_.slope_x * p.x, gain.y + plan_.slope_y * p.y};
    Point at = p;
    if ((own || all) && k_ != 0) at = {at.x + k * gain.x, at.y + k * gain.y};
    if (moved) at = times(now, at);
    if (in_place() && k_ != 0 && centred) at = {at.x + plan_.home_x, at.y + plan_.home_y};
    x_[i] = as<Number>(at.x), y_[i] = as<Number>(at.y);
    if (recalls) {
      const Point before = times(earlier, p);
      u_[i] = as<Number>(before.x), v_[i] = as<Number>(before.y);
    } else if (own) {
      const Point turned = moved ? times(now, gain) : gain;
      u_[i] = as<Number>(turned.x), v_[i] = as<Number>(turned.y);
    } else if (swung) {
      const Point end = times(whole, p);
      const Point d{plan_.slope_x * (end.x + plan_.gain_x), plan_.slope_y * (end.y + plan_.gain_y)};
      du_[i] = as<Number>(d.x), dv_[i] = as<Number>(d.y);
      u_[i] = as<Number>(k_ == 0 ? plan_.home_x : plan_.home_x + k * d.x);
      v_[i] = as<Number>(k_ == 0 ? plan_.home_y : plan_.home_y + k * d.y);
    }
  }
  placed_ = k_ == 0 || by_closed_form();
  if (k_ == 0) {
    out_x_ = rest_x_, out_y_ = rest_y_;
  } else if (placed_) {
    place_by_closed_form();
  } else if (from_rest()) {
    run(kernel);
  } else if (swung) {
    for (std::size_t i = 0; i < x_.size(); ++i) out_x_[i] = x_[i] + u_[i], out_y_[i] = y_[i] + v_[i];
  } else if (!in_place()) {
    const auto offset = static_cast<std::size_t>(use.offset);
    for (std::size_t i = 0; i < x_.size(); ++i)
      out_x_[i] = x_[i] + inputs_[offset], out_y_[i] = y_[i] + inputs_[offset + 1];
  }
}

template <class Number>
void Stepper<Number>::step() {
  if (renew_ > 0 && since_ >= renew_) return seek(k_ + 1);
  ++k_, ++since_;
  if (renew_registers_ > 0 && since_ % renew_registers_ == 0)
    seek_registers();
  else
    step_registers();
  run(plan_.kernel);
  placed_ = by_closed_form();
  if (placed_) place_by_closed_form();
}

template <class Number>
void Stepper<Number>::place_by_closed_form() {
  const Mat4 m = *betwixt::frame(motion_, k_, plan_.steps);
  for (std::size_t i = 0; i < rest_x_.size(); ++i) {
    const double x = value(rest_x_[i]), y = value(rest_y_[i]);
    out_x_[i] = static_cast<Number>(m(0, 0) * x + m(0, 1) * y + m(0, 3));
    out_y_[i] = static_cast<Number>(m(1, 0) * x + m(1, 1) * y + m(1, 3));
  }
}

template <class Number>
Arrays<Number> Stepper<Number>::arrays() {
  return {x_.data(),  y_.data(),     u_.data(),     v_.data(),     du_.data(),
          dv_.data(), out_x_.data(), out_y_.data(), rest_x_.size()};
}

template <class Number>
void Stepper<Number>::run(Kernel kernel) {
  if constexpr (std::is_same_v<Number, Counted>)
    step_plainly(kernel, arrays(), inputs_.data());
  else
    step_all(kernel, arrays(), inputs_.data(), threads_);
}

template class Stepper<float>;
template class Stepper<double>;
template class Stepper<Counted>;

}  // namespace betwixt::algebra
