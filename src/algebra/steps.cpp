// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "algebra/stepper.h"
#include "base/counted.h"

namespace betwixt {
namespace {

using algebra::Counted;
using algebra::Family;
using algebra::Plan;
using algebra::Stepper;
using algebra::Tally;

Status ready(const Motion& motion, std::int64_t steps) {
  if (auto bad = check(motion); !bad) return bad;
  if (auto first = frame(motion, 0, steps); !first) return first.error();
  if (!is_planar(motion)) return fail(ErrorCode::type, "this motion leaves the plane", "steps work only in the plane");
  return Nothing{};
}

template <class Number>
Result<Plan<Number>> planned(const Motion& motion, std::int64_t steps, Method method, std::size_t points) {
  if (method == Method::geometric) return algebra::geometric<Number>(motion, steps);
  if (method == Method::differences) return algebra::differences<Number>(motion, steps);
  return algebra::compile<Number>(motion, steps, method == Method::matrix ? Family::matrix : Family::any, points);
}

std::string_view name_of(algebra::Kernel kernel) {
  constexpr std::string_view names[algebra::kernel_count] = {
      "y + o",
      "g y + o",
      "M y + o",
      "x += d",
      "x += d of each point",
      "x = g x + o",
      "x = M x + o",
      "y *= g, draw y + o",
      "y += d of each point, draw y + o",
      "y = 2 cos y - y before, draw y + o",
      "y = p y - q y before, draw y + o",
      "y *= a complex number, draw y + o",
      "three shears, draw y + o",
      "three shears, y += v, draw y + o",
      "y += v of each point, three shears, draw y + o, three shears of v",
      "three shears, e += d, draw y + e"};
  return names[static_cast<std::size_t>(kernel)];
}

}  // namespace

std::string_view name_of(Method method) {
  constexpr std::string_view names[] = {"matrix", "geometric", "differences", "best"};
  return names[static_cast<std::size_t>(method)];
}

template <class Number>
struct Steps<Number>::State {
  Stepper<Number> stepper;
};

template <class Number>
Result<Steps<Number>> Steps<Number>::make(const Motion& motion, std::int64_t steps, Method method,
                                          std::span<const Number> x, std::span<const Number> y) {
  if (auto bad = ready(motion, steps); !bad) return bad.error();
  if (x.size() != y.size())
    return fail(ErrorCode::range, fmt::format("there are {} for x and {} for y: each point needs both",
                                              counted(x.size(), "number"), counted(y.size(), "number")));
  auto plan = planned<double>(motion, steps, method, x.size());
  if (!plan) return plan.error();
  return Steps(std::unique_ptr<State>(new State{Stepper<Number>(*std::move(plan), motion, x, y)}));
}

template <class Number>
Steps<Number>::Steps(std::unique_ptr<State> state) : state_(std::move(state)) {}
template <class Number>
Steps<Number>::Steps(Steps&&) noexcept = default;
template <class Number>
Steps<Number>& Steps<Number>::operator=(Steps&&) noexcept = default;
template <class Number>
Steps<Number>::~Steps() = default;
template <class Number>
std::int64_t Steps<Number>::frame() const {
  return state_->stepper.frame();
}
template <class Number>
void Steps<Number>::step() {
  state_->stepper.step();
}
template <class Number>
void Steps<Number>::seek(std::int64_t k) {
  state_->stepper.seek(k);
}
template <class Number>
void Steps<Number>::renew_every(int steps) {
  state_->stepper.renew_every(steps);
}
template <class Number>
std::span<const Number> Steps<Number>::x() const {
  return state_->stepper.x();
}
template <class Number>
std::span<const Number> Steps<Number>::y() const {
  return state_->stepper.y();
}
template class Steps<float>;
template class Steps<double>;

Result<Count> count_operations(const Motion& motion, std::int64_t steps, Method method, std::size_t points) {
  if (auto bad = ready(motion, steps); !bad) return bad.error();
  Count count;
  Tally before[2], step[2];
  for (const std::size_t n : {1u, 2u}) {
    const Tally start = Counted::tally;
    auto plan = planned<Counted>(motion, steps, method, points);
    if (!plan) return plan.error();
    count.kernel = name_of(plan->kernel);
    count.planned = {plan->per_point(), plan->per_step(), 0};
    const std::vector<Counted> x(n, 1.25), y(n, -0.75);  // any position will do
    Stepper<Counted> stepper(*std::move(plan), motion, x, y);
    const Tally ready_to_go = Counted::tally;
    stepper.step();
    before[n - 1] = ready_to_go - start, step[n - 1] = Counted::tally - ready_to_go;
  }
  const auto cost = [](const Tally(&t)[2]) {
    const long long one = t[0].operations(), two = t[1].operations();
    return Cost{two - one, 2 * one - two, t[0].functions};
  };
  count.before = cost(before), count.step = cost(step);
  return count;
}

std::string to_string(const Cost& c) {
  if (c.per_point == 0) return fmt::format("{}", c.besides);
  if (c.besides == 0) return fmt::format("{}Np", c.per_point);
  return fmt::format("{}Np {} {}", c.per_point, c.besides < 0 ? '-' : '+', std::abs(c.besides));
}

std::optional<Printed> printed_costs(const Motion& motion) {
  const std::string row = algebra::letters(motion);
  const auto n = static_cast<long long>(row.size());
  if (n > 1 && row.find_first_not_of('R') == std::string::npos)
    return Printed{"R…R", {8, 14 * n - 20}, {8, 8 * n - 4}, {0, 10 * n}, {2, 6 * n - 2}, {2, 2 * n - 1}};
  static const Printed rows[] = {
      {"T", {2, 0}, {2, 0}, {0, 2}, {0, 2}, {}},           {"S", {4, 0}, {2, 0}, {0, 6}, {0, 8}, {}},
      {"R", {8, 0}, {8, 0}, {0, 10}, {2, 4}, {2, 0}},      {"TS", {4, 10}, {2, 0}, {0, 14}, {6, 6}, {}},
      {"ST", {4, 12}, {2, 0}, {0, 14}, {6, 8}, {}},        {"TR", {8, 18}, {8, 2}, {0, 12}, {2, 4}, {2, 0}},
      {"RT", {8, 23}, {10, 6}, {0, 18}, {2, 2}, {2, 0}},   {"RS", {8, 31}, {16, 0}, {0, 35}, {6, 6}, {2, 0}},
      {"SR", {8, 27}, {10, 0}, {0, 34}, {16, 15}, {2, 0}}, {"TRS", {8, 33}, {16, 2}, {0, 35}, {6, 10}, {2, 0}},
  };
  for (const Printed& p : rows)
    if (p.row == row) return p;
  return std::nullopt;
}

}  // namespace betwixt
