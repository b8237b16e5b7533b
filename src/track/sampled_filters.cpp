// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// `smooth` and `spring` sample the track on a fixed grid that starts at time 0, not at offsets from the evaluated time.
// So the result is smooth in time whatever the track does. If the samples moved with the time, they would pass a jump
// one by one, and each would make a small jump again.
#include <algorithm>
#include <cmath>

#include "track/filter_call.h"
#include "track/track.h"

namespace betwixt::filters {

Sample numbers(const Value& v) {
  Sample s;
  if (!std::holds_alternative<bool>(v)) s.count = to_numbers(v, s.n);
  return s;
}

Value value_of(const Value& like, const double* n) {
  if (numbers(like).count == 0) return like;
  Value v = with_numbers(like, n);
  if (auto* c = std::get_if<Color>(&v)) *c = {std::max(c->r, 0.0), std::max(c->g, 0.0), std::max(c->b, 0.0)};
  if (auto* q = std::get_if<Quat>(&v)) *q = normalize(*q);
  return v;
}

namespace {

// The same for means: colours as linear light.
Sample mixable(const Value& v) {
  Sample s = numbers(v);
  if (std::holds_alternative<Color>(v))
    for (double& x : s.n) x = to_linear(x);
  return s;
}

Value mixed(const Value& like, Sample s) {
  if (std::holds_alternative<Color>(like))
    for (double& x : s.n) x = to_srgb(x);
  return value_of(like, s.n);
}

// The same for a value of the kind of `like`: among orientations, angles are converted, and of the two quaternions of
// an orientation the nearer to `beside` is taken.
Sample sample_near(const Value& v, const Value& like, const Sample& beside) {
  const bool turns = std::holds_alternative<Quat>(like);
  const auto* angles = turns ? std::get_if<Angles>(&v) : nullptr;
  Sample n = mixable(angles ? Value(from_angles(angles->xyz)) : v);
  double cosine = 0;
  for (int i = 0; turns && i < 4; ++i) cosine += beside.n[i] * n.n[i];
  if (cosine < 0)
    for (double& x : n.n) x = -x;
  return n;
}

// The track at the points first, first + 1, … of a grid.
struct Samples {
  Value like;              // the common kind
  std::vector<Sample> at;  // empty if they are not numbers, or of several kinds
};
Samples samples(Input& input, double first, int count, double cell) {
  std::vector<Value> values;
  values.reserve(static_cast<std::size_t>(count));
  for (int k = 0; k < count; ++k) values.push_back(look(input, (first + k) * cell));
  const auto turn =
      std::find_if(values.begin(), values.end(), [](const Value& v) { return std::holds_alternative<Quat>(v); });
  Samples s{turn == values.end() ? values.front() : *turn, {}};
  s.at.reserve(values.size());
  for (const Value& v : values) {
    const Sample n = sample_near(v, s.like, s.at.empty() ? Sample{} : s.at.back());
    if (n.count == 0 || (!s.at.empty() && n.count != s.at.back().count)) return {};
    s.at.push_back(n);
  }
  return s;
}

// The cubic B-spline over the knots -2 to 2, whose integral is 1; and the part of the integral beyond x.
double spline(double x) {
  const double a = std::abs(x);
  if (a >= 2) return 0;
  return a > 1 ? (2 - a) * (2 - a) * (2 - a) / 6 : 2.0 / 3 - a * a * (1 - a / 2);
}
double spline_behind(double x) {
  const double a = std::abs(x), b = 2 - a;
  const double behind = a >= 2 ? 0 : a > 1 ? b * b * b * b / 24 : 0.5 - a * (2.0 / 3 - a * a * (1.0 / 3 - a / 8));
  return x < 0 ? 1 - behind : behind;
}

// A jump within a cell of a grid: its time in seconds, and its size.
struct Jump {
  double at = 0, by[4] = {};
};
// Finds a jump by repeated bisection of the cell: at a jump the change stays as large as that of the whole cell; on a
// slope it shrinks too. Only the cell itself is read, so the result is the same for every caller.
std::optional<Jump> jump_in(Input& input, const Value& like, Sample before, Sample after, double from, double to) {
  constexpr int halvings = 24;  // of a cell of the usual window: to less than a flick
  const auto change = [&](const Sample& a, const Sample& b) {
    double most = 0;
    for (int i = 0; i < a.count; ++i) most = std::max(most, std::abs(b.n[i] - a.n[i]));
    return most;
  };
  const double whole = change(before, after);
  for (int halving = 1; halving <= halvings && whole > 0; ++halving) {
    const Sample middle = sample_near(look(input, (from + to) / 2), like, before);
    if (middle.count != before.count) return std::nullopt;
    const bool early = change(before, middle) > change(middle, after);
    (early ? to : from) = (from + to) / 2;
    (early ? after : before) = middle;
    if (change(before, after) < 0.6 * whole) return std::nullopt;
  }
  Jump jump{(from + to) / 2, {}};
  for (int i = 0; i < before.count; ++i) jump.by[i] = after.n[i] - before.n[i];
  return whole > 0 ? std::optional(jump) : std::nullopt;
}

// A mass on a damped spring whose other end follows the track: x'' = w² (u - x) - 2 d w x'. Between two points of the
// grid the track is taken as linear; for that the motion has a closed form. A straight line is followed 2 d / w late.
// The mass starts at rest early enough that its earlier motion has decayed to less than 1e-4.
struct Oscillator {
  double w, damping;
  struct Step {
    double time, xx, xv, vx, vv;  // the factors of the deviation from the steady motion
  };
  Step step(double time) const {
    const double d = 1 - damping * damping, rate = w * std::sqrt(std::abs(d));
    const double decay = std::exp(-damping * w * time), turn = rate * time;
    const double c = decay * (d > 0 ? std::cos(turn) : std::cosh(turn));
    const double s = decay * (turn < 1e-6 ? time : (d > 0 ? std::sin(turn) : std::sinh(turn)) / rate);
    return {time, c + damping * w * s, s, -w * w * s, c - damping * w * s};
  }
  // The end moves from `from` with a constant velocity.
  void advance(double& x, double& v, const Step& step, double from, double velocity) const {
    const double lag = 2 * damping / w * velocity;
    const double dx = x - (from - lag), dv = v - velocity;
    x = step.xx * dx + step.xv * dv + from + velocity * step.time - lag;
    v = step.vx * dx + step.vv * dv + velocity;
  }
  // The slowest part decays like exp(-t / this).
  double time_constant() const {
    return 1 / (w * (damping > 1 ? damping - std::sqrt(damping * damping - 1) : damping));
  }
};

// A jump within a cell of the grid, found by bisection. Otherwise the mass would see it half a cell off.
struct Bend {
  std::size_t cell = 0;
  double at = 0;  // seconds since the beginning of the cell
  Sample before, after;
};
std::vector<Bend> bends_of(Input& input, const Samples& s, double first, double cell) {
  double low[4], high[4];
  std::copy_n(s.at[0].n, 4, low), std::copy_n(s.at[0].n, 4, high);
  for (const Sample& one : s.at)
    for (int i = 0; i < one.count; ++i) low[i] = std::min(low[i], one.n[i]), high[i] = std::max(high[i], one.n[i]);
  const auto apart = [&](const Sample& a, const Sample& b, double part) {
    for (int i = 0; i < a.count; ++i)
      if (std::abs(a.n[i] - b.n[i]) > part * (high[i] - low[i])) return true;
    return false;
  };
  const auto looked = [&](double t) { return samples(input, t, 1, 1).at; };
  std::vector<Bend> out;
  for (std::size_t k = 0; k + 1 < s.at.size(); ++k) {
    if (!apart(s.at[k], s.at[k + 1], 0.05)) continue;
    const double begin = (first + static_cast<double>(k)) * cell;
    Bend bend{k, 0, s.at[k], s.at[k + 1]};
    double from = 0, to = cell;
    for (int halving = 0; halving < 12; ++halving) {
      const auto middle = looked(begin + (from + to) / 2);
      if (middle.empty() || middle[0].count != bend.before.count) break;
      const bool early = apart(bend.before, middle[0], 0.025), late = apart(middle[0], bend.after, 0.025);
      if (early == late) break;  // no jump, or more than one: treat it as a slope
      (early ? to : from) = (from + to) / 2;
      (early ? bend.after : bend.before) = middle[0];
    }
    bend.at = (from + to) / 2;
    if (to - from < cell / 1000) out.push_back(bend);
  }
  return out;
}

}  // namespace

// A mean weighted by a cubic B-spline. There is a whole number of cells between two knots of the spline. Therefore the
// weights add up to 1 wherever the grid is relative to the spline, their centre is the evaluated time, and the mean has
// two continuous derivatives. A jump between two points of the grid counts from its own time on.
constexpr int cells_between_knots = 8;
Value smooth(const FilterCall& told, Input& input, double seconds) {
  constexpr int reach = 2 * cells_between_knots;
  constexpr int count = 2 * reach + 2;  // all cells under the spline
  const double cell = told.number("width") / (2 * reach);
  const double first = std::floor(seconds / cell) - reach;
  const Samples s = samples(input, first, count, cell);
  if (s.at.empty()) return look(input, seconds);
  const Sample& base = s.at[reach];  // average differences from it, so that a constant stays the same to the last bit
  const auto place = [&](double k) { return (first + k - seconds / cell) / cells_between_knots; };
  Sample mean = base;
  double behind = 1;  // the weights of the points from k on
  for (std::size_t k = 0; k < s.at.size(); ++k) {
    const double weight = spline(place(static_cast<double>(k))) / cells_between_knots;
    for (int i = 0; i < base.count; ++i) mean.n[i] += weight * (s.at[k].n[i] - base.n[i]);
    behind -= weight;
    if (k + 1 == s.at.size()) break;
    const double from = (first + static_cast<double>(k)) * cell;
    if (const auto jump = jump_in(input, s.like, s.at[k], s.at[k + 1], from, from + cell))
      for (int i = 0; i < base.count; ++i)
        mean.n[i] += jump->by[i] * (spline_behind((jump->at - seconds) / (cell * cells_between_knots)) - behind);
  }
  return mixed(s.like, mean);
}

Value spring(const FilterCall& told, Input& input, double seconds) {
  constexpr double cells_per_swing = 48, time_constants = 12;  // (1 + 12) exp(-12) < 1e-4: the worst, damping 1
  const double frequency = told.number("frequency"), cell = 1 / (frequency * cells_per_swing);
  const Oscillator mass{2 * pi * frequency, told.number("damping")};
  const int count = static_cast<int>(std::ceil(time_constants * mass.time_constant() / cell)) + 2;
  const double last = std::floor(seconds / cell), first = last - count + 2;
  const Samples s = samples(input, first, count, cell);
  if (s.at.empty()) return look(input, seconds);
  const Oscillator::Step whole = mass.step(cell), rest = mass.step(seconds - last * cell);
  Sample out = s.at.front();
  const std::vector<Bend> bends = bends_of(input, s, first, cell);
  for (int i = 0; i < out.count; ++i) {
    const double start = out.n[i];
    double x = 0, v = 0;  // relative to the start, so that a constant stays the same to the last bit
    auto bend = bends.begin();
    for (std::size_t k = 0; k + 1 < s.at.size(); ++k) {
      const double from = s.at[k].n[i] - start, to = s.at[k + 1].n[i] - start;
      const bool all = k + 2 < s.at.size();
      if (bend == bends.end() || bend->cell != k) {
        mass.advance(x, v, all ? whole : rest, from, (to - from) / cell);
        continue;
      }
      // Before the jump, the jump, after it; up to the evaluated time.
      const double ends = all ? cell : seconds - last * cell, before = bend->before.n[i] - start,
                   after = bend->after.n[i] - start;
      mass.advance(x, v, mass.step(std::min(ends, bend->at)), from, (before - from) / bend->at);
      if (ends > bend->at) mass.advance(x, v, mass.step(ends - bend->at), after, (to - after) / (cell - bend->at));
      ++bend;
    }
    out.n[i] = start + x;
  }
  return mixed(s.like, out);
}

}  // namespace betwixt::filters
