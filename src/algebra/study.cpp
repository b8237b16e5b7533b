// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "algebra/study.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "algebra/power.h"

namespace betwixt::algebra {
namespace {

constexpr std::size_t most_factors = 64, most_points = 50;
constexpr double farthest = 1e9;
constexpr int slow_samples = 120;          // for a slow path
constexpr double most_sampled_turns = 24;  // for a path that is sampled for its turns

double size_of(const Mat4& m) {
  double most = 0;
  for (const double x : m.m) most = std::isfinite(x) ? std::max(most, std::abs(x)) : INFINITY;
  return most;
}
double reach_of(Vec3 v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

// Tests everything that is drawn: every factor by itself, and every factor with those to its right.
bool stays_near(const Motion& motion) {
  const std::vector<Factor>& f = motion.factors;
  for (auto i = f.begin(); i != f.end(); ++i) {
    if (reach_of(i->by) > farthest || reach_of(i->centre) > farthest || std::abs(i->angle) > farthest) return false;
    for (int k = 0; k <= 8; ++k)
      if (!(size_of(at({{i, i + 1}}, k / 8.0)) <= farthest && size_of(at({{i, f.end()}}, k / 8.0)) <= farthest))
        return false;
  }
  return true;
}

std::vector<Mat4> sampled(const Motion& motion, int steps) {
  std::vector<Mat4> frames;
  for (int k = 0; k <= steps; ++k) frames.push_back(*frame(motion, k, steps));
  return frames;
}

double all_turns(const Motion& motion) {
  double turns = 0;
  for (const Factor& f : motion.factors)
    if (f.kind == Factor::Kind::rotate) turns += std::abs(f.angle) / (2 * pi);
  return turns;
}

std::vector<Mat4> root_path(const Motion& motion) {
  std::vector<Mat4> frames;
  for (int k = 0; k <= slow_samples; ++k) {
    const auto m = power(at(motion, 1), k / static_cast<double>(slow_samples));
    if (!m || !(size_of(*m) <= farthest)) return {};
    frames.push_back(*m);
  }
  return frames;
}

}  // namespace

Motion by_linear_law(Motion motion) {
  for (Factor& f : motion.factors)
    if (f.kind == Factor::Kind::scale) f.law = Factor::Law::linear;
  return motion;
}

Status can_be_shown(const Motion& motion, const Places& points) {
  if (auto bad = check(motion); !bad) return bad;
  if (motion.factors.size() > most_factors)
    return fail(ErrorCode::range, fmt::format("{} factors are too many for a lesson", motion.factors.size()),
                fmt::format("the limit is {}", most_factors));
  if (points.size() > most_points)
    return fail(ErrorCode::range, fmt::format("{} points are too many for a lesson", points.size()),
                fmt::format("the limit is {}", most_points));
  for (const Vec3& p : points)
    if (!(reach_of(p) <= farthest))
      return fail(ErrorCode::range, "a point is too far away for a lesson", "the limit is 1e9");
  if (!stays_near(motion))
    return fail(ErrorCode::range, "this motion goes too far away for a lesson", "the limit is 1e9");
  return Nothing{};
}

double unit_for(const Motion& motion, const Places& points) {
  double reach = 0;
  for (const Factor& f : motion.factors)
    reach = std::max(reach, f.kind == Factor::Kind::translate ? reach_of(f.by) : 2 * reach_of(f.centre));
  for (const Vec3& p : points) reach = std::max(reach, reach_of(p));
  if (!(reach > 1e-300)) return 1;
  const double about = 0.18 * reach, power = std::pow(10, std::floor(std::log10(about)));
  return power * (about < 1.5 * power ? 1 : about < 3.5 * power ? 2 : about < 7.5 * power ? 5 : 10);
}

// Three points determine an affine map.
std::vector<Mat4> stepped(const Motion& motion, Method method, std::int64_t count) {
  const std::vector<double> x{0, 1, 0}, y{0, 0, 1};
  auto steps = Steps<double>::make(motion, count, method, x, y);
  std::vector<Mat4> frames;
  for (; steps && frames.size() <= static_cast<std::size_t>(count); steps->step()) {
    const auto px = steps->x(), py = steps->y();
    Mat4 m;
    m(0, 3) = px[0], m(0, 0) = px[1] - px[0], m(0, 1) = px[2] - px[0];
    m(1, 3) = py[0], m(1, 0) = py[1] - py[0], m(1, 1) = py[2] - py[0];
    frames.push_back(m);
  }
  return frames;
}

Gap gap_between(const Motion& motion, const std::vector<Mat4>& frames, const Places& points) {
  Gap gap;
  const auto steps = static_cast<std::int64_t>(frames.size()) - 1;
  for (std::int64_t k = 0; k <= steps; ++k) {
    const Mat4 wanted = *frame(motion, k, steps);
    for (const Vec3& p : points) {
      const double d = length(transform_point(frames[static_cast<std::size_t>(k)], p) - transform_point(wanted, p));
      if (d > gap.most) gap = {d, static_cast<double>(k) / static_cast<double>(steps)};
    }
  }
  return gap;
}

std::vector<OtherWay> other_ways(const Motion& motion, const Places& points) {
  std::vector<OtherWay> ways;
  double size = 0;
  for (const Mat4& m : sampled(motion, slow_samples))
    for (const Vec3& p : points) size = std::max(size, length(transform_point(m, p)));
  using Kind = OtherWay::Kind;
  const auto add = [&](Kind kind, bool beside_linear, std::vector<Mat4> frames, const Motion& base) {
    if (frames.empty()) return;
    const Gap gap = gap_between(base, frames, points);
    if (gap.most > 1e-7 * size) ways.push_back({kind, beside_linear, std::move(frames), gap});
  };
  const double turns = all_turns(motion);
  const int steps =
      turns > most_sampled_turns ? slow_samples : std::max(slow_samples, static_cast<int>(std::ceil(48 * turns)));
  const Motion linear = by_linear_law(motion);
  if (is_planar(motion)) {
    if (!count_operations(motion, slow_samples, Method::differences, 1)) {
      std::vector<Mat4> root = root_path(motion);
      if (root.empty()) ways.push_back({Kind::no_root, false, {}, {}});
      add(Kind::root, false, std::move(root), motion);
    }
    add(Kind::scheme, true, stepped(linear, Method::geometric, steps), linear);
  }
  if (linear != motion) add(Kind::law, false, sampled(linear, steps), motion);
  return ways;
}

std::vector<std::int64_t> drift_marks(std::int64_t steps) {
  std::vector<std::int64_t> at;
  for (std::int64_t power = 1; power < steps; power *= 10)
    for (const std::int64_t n : {1, 2, 5})
      if (n * power < steps) at.push_back(n * power);
  if (!at.empty() && at.back() != steps - 1) at.push_back(steps - 1);
  return at;
}

template <class Number>
std::vector<double> drift(const Motion& motion, Method method, std::int64_t steps, const Places& points, bool renewed) {
  std::vector<Number> x, y;
  std::vector<double> exact_x, exact_y;
  for (const Vec3& p : points) {
    x.push_back(static_cast<Number>(p.x)), y.push_back(static_cast<Number>(p.y));
    // The points as the method got them, rounded.
    exact_x.push_back(static_cast<double>(x.back())), exact_y.push_back(static_cast<double>(y.back()));
  }
  auto run = Steps<Number>::make(motion, steps, method, x, y);
  auto exact = Steps<double>::make(motion, steps, method, exact_x, exact_y);
  std::vector<double> largest;
  if (!run || !exact) return largest;
  if (!renewed) run->renew_every(0);
  constexpr int apart = 61;  // no divisor of the steps between renewals, so that all their phases occur
  double worst = 0;
  for (const std::int64_t mark : drift_marks(steps)) {
    while (run->frame() < mark) {
      run->step();
      if (run->frame() != mark && run->frame() > 1000 && run->frame() % apart != 0) continue;
      exact->seek(run->frame());
      for (std::size_t i = 0; i < x.size(); ++i) {
        const double d = std::hypot(static_cast<double>(run->x()[i]) - exact->x()[i],
                                    static_cast<double>(run->y()[i]) - exact->y()[i]);
        worst = std::isfinite(d) ? std::max(worst, d) : INFINITY;
      }
    }
    largest.push_back(worst);
  }
  return largest;
}
template std::vector<double> drift<float>(const Motion&, Method, std::int64_t, const Places&, bool);
template std::vector<double> drift<double>(const Motion&, Method, std::int64_t, const Places&, bool);

}  // namespace betwixt::algebra
