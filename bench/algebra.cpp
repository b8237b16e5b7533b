// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Measures how fast each kernel moves points from step to step, compared with a copy of as many bytes, and how far the
// methods drift. Checks the values.
#include <fmt/format.h>
#include <time.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <string_view>
#include <thread>
#include <vector>

#include "algebra/stepper.h"
#include "kernel_copies.h"

using namespace betwixt;
using namespace betwixt::algebra;

namespace {

void insist(bool holds, const std::string& what) {
  if (holds) return;
  fmt::print(stderr, "wrong: {}\n", what);
  std::exit(1);
}

// One thread is measured by processor time, because other work may run on the machine.
template <class F>
double nanoseconds(bool one_thread, F&& work) {
  const auto now = [&] {
    timespec t{};
    clock_gettime(one_thread ? CLOCK_THREAD_CPUTIME_ID : CLOCK_MONOTONIC, &t);
    return 1e9 * static_cast<double>(t.tv_sec) + static_cast<double>(t.tv_nsec);
  };
  const double begin = now();
  work();
  return now() - begin;
}

struct Spread {
  double least, median;
};
Spread spread(std::vector<double> all) {
  std::sort(all.begin(), all.end());
  return {all.front(), all[all.size() / 2]};
}

Motion parsed(const char* text) {
  auto motion = parse_motion(text);
  insist(bool(motion), text);
  return *motion;
}

Plan<double> planned(const Motion& motion, std::int64_t steps, Method method, std::size_t points) {
  auto checked = [](Result<Plan<double>> plan) {
    insist(bool(plan), plan ? "" : plan.error().message);
    return *std::move(plan);
  };
  if (method == Method::geometric) return checked(geometric<double>(motion, steps));
  if (method == Method::differences) return checked(differences<double>(motion, steps));
  return compile<double>(motion, steps, method == Method::matrix ? Family::matrix : Family::any, points);
}

// ---- Speed

struct Case {
  Kernel kernel;
  const char *name, *motion;
  Method method;
};
constexpr Case cases[] = {
    {Kernel::offset, "offset", "T(5 3)", Method::matrix},
    {Kernel::scale, "scale", "S(2 3 @ 1 4)", Method::matrix},
    {Kernel::matrix, "matrix", "T(5 3) R(100rad @ 1 4) S(2 3 @ 5 2)", Method::matrix},
    {Kernel::move, "move", "T(5 3)", Method::best},
    {Kernel::slide, "slide", "S(2 3 @ 1 4 linear)", Method::geometric},
    {Kernel::stretch, "stretch", "S(2 3 @ 1 4)", Method::differences},
    {Kernel::turn, "turn", "R(100rad @ 1 4)", Method::differences},
    {Kernel::grow, "grow", "S(2 3 @ 1 4)", Method::best},
    {Kernel::ramp, "ramp", "T(1 1) S(2 3 linear) T(2 1)", Method::best},
    {Kernel::two_term, "two-term", "R(100rad @ 1 4)", Method::best},
    {Kernel::damped, "damped", "S(2 3 @ 5 2) R(100rad @ 1 4)", Method::best},
    {Kernel::conformal, "conformal", "R(100rad @ 1 4) S(2 @ 5 2)", Method::best},
    {Kernel::shears, "shears", "T(5 3) R(100rad @ 1 4)", Method::geometric},
    {Kernel::pushed_shears, "shears, pushed", "R(100rad @ 1 4) T(5 3)", Method::geometric},
    {Kernel::carried_shears, "shears, carried", "T(5 3) R(100rad @ 1 4) S(2 3 @ 5 2 linear)", Method::geometric},
    {Kernel::swung_shears, "shears, swung", "S(2 3 @ 5 2 linear) R(100rad @ 1 4)", Method::geometric},
};

constexpr std::int64_t whole = 10'000;  // steps of the motion; never reached

int arrays_read(Kernel k) { return 2 + 2 * uses(k).second + 2 * uses(k).gain; }
int arrays_written(Kernel k) { return 2 * uses(k).state + 2 * uses(k).written + 2 * uses(k).drawn; }

// Copies as many bytes as the kernel reads and writes, in arrays of the same form.
template <class Number>
class Copy {
 public:
  Copy(Kernel kernel, std::size_t points, bool through, unsigned threads)
      : kernel_(kernel), through_(through), threads_(threads) {
    const Uses use = uses(kernel);
    const bool used[8] = {true, true, use.second, use.second, use.gain, use.gain, use.drawn, use.drawn};
    for (int i = 0; i < 8; ++i)
      if (used[i]) all_[i].assign(points, 1);
  }
  void operator()() {
    const auto at = [&](int i) { return all_[i].data(); };
    copy_all(kernel_, {at(0), at(1), at(2), at(3), at(4), at(5), at(6), at(7), all_[0].size()}, through_, threads_);
  }

 private:
  Kernel kernel_;
  bool through_;
  unsigned threads_;
  Line<Number> all_[8];
};

// Computes the points of the SR scheme in between. This scheme is exact only at the end of the motion.
Vec3 swung(const Motion& m, double t, Vec3 p) {
  const Factor &s = m.factors[0], &r = m.factors[1];
  const auto turned = [&](double part) {
    const double c = std::cos(part * r.angle), i = std::sin(part * r.angle), x = p.x - r.centre.x, y = p.y - r.centre.y;
    return Vec3{r.centre.x + c * x - i * y, r.centre.y + i * x + c * y, 0};
  };
  const Vec3 now = turned(t), end = turned(1);
  return {now.x + t * (s.by.x - 1) * (end.x - s.centre.x), now.y + t * (s.by.y - 1) * (end.y - s.centre.y), 0};
}

template <class Number>
void check(const Case& c, const Motion& motion, const Stepper<Number>& s, const std::vector<Number>& x,
           const std::vector<Number>& y) {
  const double t = static_cast<double>(s.frame()) / static_cast<double>(whole);
  const Mat4 m = at(motion, t);
  const double near = sizeof(Number) == 4 ? 0.03 : 1e-8;
  for (std::size_t i = 0; i < x.size(); i += 97) {
    const Vec3 p{x[i], y[i], 0};
    const Vec3 want = c.kernel == Kernel::swung_shears ? swung(motion, t, p) : transform_point(m, p);
    insist(std::hypot(s.x()[i] - want.x, s.y()[i] - want.y) < near,
           fmt::format("{} at step {}: ({}, {}), not ({}, {})", c.name, s.frame(), s.x()[i], s.y()[i], want.x, want.y));
  }
}

template <class Number>
void speed(const Case& c, std::size_t points, unsigned threads) {
  const Motion motion = parsed(c.motion);
  const Plan<double> plan = planned(motion, whole, c.method, points);
  insist(plan.kernel == c.kernel, fmt::format("the plan for {} is for another kernel", c.name));
  std::vector<Number> x(points), y(points);
  std::mt19937 random(5);
  for (std::size_t i = 0; i < points; ++i)
    for (auto* v : {&x[i], &y[i]}) *v = static_cast<Number>(random() % 20'000) / Number(1000) - Number(10);
  Stepper<Number> stepper(plan, motion, x, y);
  stepper.renew_every(0);
  stepper.use_threads(threads);
  Copy<Number> cached(c.kernel, points, false, threads), past(c.kernel, points, true, threads);

  // Rounds with few points are short, so that other work on the machine disturbs only some of them.
  const int a_round = static_cast<int>(std::clamp<std::size_t>(200'000 / points, 1, 200));
  const int rounds = points > 1'000'000 ? 21 : 101;
  std::vector<double> ours, through_caches, past_caches;
  for (int round = -1; round < rounds; ++round) {
    if (a_round > 1) stepper.seek(stepper.frame());  // so that rounding errors do not add up
    const auto timed = [&](std::vector<double>& times, auto&& work) {
      const double t = nanoseconds(threads == 1, [&] {
        for (int k = 0; k < a_round; ++k) work();
      });
      if (round >= 0) times.push_back(t / a_round / static_cast<double>(points));  // rounds below 0 only map the pages
    };
    timed(ours, [&] { stepper.step(); });
    timed(through_caches, cached);
    if (uses(c.kernel).drawn) timed(past_caches, past);
  }
  check(c, motion, stepper, x, y);
  const Spread s = spread(ours);
  Spread copy = spread(through_caches);
  if (!past_caches.empty() && spread(past_caches).least < copy.least) copy = spread(past_caches);
  fmt::print("{:16} f{} {:8} {:7} {:4} {:4}  {:7.3f} {:7.3f}   {:7.3f} {:7.3f}   {:5.2f} {:5.2f}\n", c.name,
             8 * sizeof(Number), points, threads, arrays_read(c.kernel), arrays_written(c.kernel), s.least, s.median,
             copy.least, copy.median, s.least / copy.least, s.median / copy.median);
  std::fflush(stdout);
}

void speeds(std::string_view only) {
  const unsigned cores = std::max(1u, std::thread::hardware_concurrency());
  fmt::print("{:38}{:>9}  {:>15}   {:>15}   {:>11}\n", "", "arrays", "ns a point", "a copy", "times");
  fmt::print("{:16} {:3} {:>8} {:>7} {:>4} {:>4}  {:>7} {:>7}   {:>7} {:>7}   {:>5} {:>5}\n", "kernel", "", "points",
             "threads", "read", "wr.", "least", "median", "least", "median", "least", "median");
  for (const std::size_t points : {1'000u, 100'000u, 8'000'000u})
    for (const unsigned threads : {1u, cores}) {
      if (threads > 1 && points < 1'000'000) continue;  // so few points need only one thread
      for (const Case& c : cases) {
        if (!only.empty() && only != c.name) continue;
        speed<float>(c, points, threads);
        speed<double>(c, points, threads);
      }
    }
}

// ---- Drift

// The true places of points of the unit circle in quadruple precision: products of the rotation of one step, whose sine
// and cosine are sums of their series.
class Truth {
 public:
  explicit Truth(double angle) {
    Real term = 1;
    for (int n = 0; n < 40; ++n) {
      (n % 2 == 0 ? c_ : s_) += n / 2 % 2 == 0 ? term : -term;
      term *= static_cast<Real>(angle) / (n + 1);
    }
  }
  void step() {
    const Real x = c_ * x_ - s_ * y_;
    y_ = s_ * x_ + c_ * y_;
    x_ = x;
  }
  // Returns the distance of (x, y) from the true place of the point that began at (px, py).
  double distance(double px, double py, double x, double y) const {
    const auto c = static_cast<long double>(x_), s = static_cast<long double>(y_);
    const long double dx = c * px - s * py - x, dy = s * px + c * py - y;
    return static_cast<double>(std::sqrt(dx * dx + dy * dy));
  }

 private:
  __extension__ using Real = __float128;
  Real c_ = 0, s_ = 0, x_ = 1, y_ = 0;
};

constexpr double theta = 0.01;
constexpr std::int64_t turning = std::int64_t{1} << 24;  // steps of the motion: theta times this is exact
constexpr std::int64_t shown[] = {1'000, 100'000, 10'000'000};

template <class Number>
class Drifting {
 public:
  Drifting(const char* name, Method method, int renew)
      : name_(name), stepper_(planned(motion(), turning, method, 3), motion(), x_, y_) {
    if (renew >= 0) stepper_.renew_every(renew);
  }
  static Motion motion() { return {{rotate_by(theta * turning)}}; }
  void step(const Truth& truth) {
    stepper_.step();
    for (std::size_t i = 0; i < x_.size(); ++i)
      most_ = std::max(most_, truth.distance(x_[i], y_[i], stepper_.x()[i], stepper_.y()[i]));
    if (std::find(std::begin(shown), std::end(shown), stepper_.frame()) != std::end(shown)) at_.push_back(most_);
  }
  void print() const {
    fmt::print("{:40} f{}", name_, 8 * sizeof(Number));
    for (const double d : at_) fmt::print("  {:8.1e}", d);
    fmt::print("\n");
  }

 private:
  std::string name_;
  const std::vector<Number> x_{1, 0, Number(0.6)}, y_{0, 1, Number(-0.8)};
  Stepper<Number> stepper_;
  double most_ = 0;
  std::vector<double> at_;
};

// Computes A(t) for each frame in f64, and applies it to points of either type.
template <class Number>
class Stateless {
 public:
  void step(const Truth& truth) {
    const Mat4 m = at(Drifting<Number>::motion(), static_cast<double>(++k_) / turning);
    const auto x = static_cast<Number>(m(0, 0)), y = static_cast<Number>(m(1, 0));
    most_ = std::max(most_, truth.distance(1, 0, x, y));
    if (std::find(std::begin(shown), std::end(shown), k_) != std::end(shown)) at_.push_back(most_);
  }
  void print() const {
    fmt::print("{:40} f{}", "the closed form for each frame", 8 * sizeof(Number));
    for (const double d : at_) fmt::print("  {:8.1e}", d);
    fmt::print("\n");
  }

 private:
  std::int64_t k_ = 0;
  double most_ = 0;
  std::vector<double> at_;
};

template <class Number>
void drift() {
  Drifting<Number> all[] = {
      {"three shears", Method::geometric, 0},
      {"complex product (differences)", Method::differences, 0},
      {"two-term (best)", Method::best, 0},
      {"matrix, its numbers two-term", Method::matrix, 0},
      {"three shears, renewed", Method::geometric, -1},
      {"complex product, renewed", Method::differences, -1},
      {"two-term, renewed every 64", Method::best, 64},
      {"two-term, renewed", Method::best, -1},
      {"matrix, renewed", Method::matrix, -1},
  };
  Stateless<Number> stateless;
  Truth truth(theta);
  for (std::int64_t k = 1; k <= shown[2]; ++k) {
    truth.step();
    for (auto& d : all) d.step(truth);
    stateless.step(truth);
  }
  for (const auto& d : all) d.print();
  stateless.print();
}

}  // namespace

int main(int argc, char** argv) {
  const std::string_view what = argc > 1 ? argv[1] : "";
  if (what != "drift") speeds(argc > 2 ? argv[2] : "");
  if (what == "speed") return 0;
  fmt::print(
      "\nlargest distance of points on the unit circle from where they are, {} a step\n{:40}    {:>10}{:>10}{:>10}\n",
      theta, "", "1e3 steps", "1e5", "1e7");
  drift<float>();
  drift<double>();
}
