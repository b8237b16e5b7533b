// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "program/integrals.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "program/live_parts.h"
#include "program/questions.h"
#include "program/steps.h"
#include "track/turns.h"

namespace betwixt {
namespace {

using Four = std::array<double, 4>;

constexpr Time integral_step{flicks_per_second / 60};
constexpr double accuracy = 1e-9;  // of the velocity, on average over a step
constexpr int most_halvings = 24;  // of a step: a flick

Quat turn_by(Vec3 angle) { return exp(Quat{0, angle.x / 2, angle.y / 2, angle.z / 2}); }

class Integral final : public Routine {
 public:
  Integral(const Live& of, LivePart rates, bool spaced) : rates_(std::move(rates)), spaced_(spaced) {
    language = "integral";
    live_.object = of.object, live_.function = of.function;
    rates_.track.events.each([&](const Event& e) { events_.push_back(e.time.flicks); });
  }
  bool stepped() const override { return true; }
  std::string_view circle() const override {
    return "its code depends on the value that it moves: a velocity can read it only at times that are a sixtieth of a "
           "second earlier, as in (t - 0.1)";
  }
  Result<State> step(Questions& q, const State& before, std::int64_t number, double,
                     std::uint64_t& cost) const override {
    auto& film = static_cast<FilmQuestions&>(q);  // only a film's steps call this
    Four sum = read(before);
    if (number > 0) {
      const std::uint64_t begun = film.asking.cost;
      advance(film.c, film.asking, film.t - integral_step, film.t, sum);
      cost += std::exchange(film.asking.cost, begun) - begun;
    }
    const Four v = rate(film.c, film.asking, film.t.flicks);
    return state_of({{sum[0], sum[1], sum[2]}, {sum[3], v[0], v[1]}, {v[2], v[3], 0}});
  }

  // A state is the integral, and the velocity at that time.
  Four read(const State& s) const {
    const auto all = vectors_of(s);
    if (all.empty()) return rates_.orientation ? Four{1, 0, 0, 0} : Four{};
    return {all[0].x, all[0].y, all[0].z, all[1].x};
  }
  static Four read_rate(const State& s) {
    const auto all = vectors_of(s);
    return all.empty() ? Four{} : Four{all[1].y, all[1].z, all[2].x, all[2].y};
  }
  // Returns the integral between two steps for the code itself, which may read its past very often: by a cubic.
  Four hermite(const State& a, const State& b, double share) const {
    const Four from = read(a), to = read(b), out = read_rate(a), in = read_rate(b);
    if (rates_.orientation) {
      const Quat q = slerp(Quat{from[0], from[1], from[2], from[3]}, Quat{to[0], to[1], to[2], to[3]}, share);
      return {q.w, q.x, q.y, q.z};
    }
    const double h = integral_step.seconds(), s2 = share * share, s3 = s2 * share;
    Four sum{};
    for (std::size_t i = 0; i < 4; ++i)
      sum[i] =
          from[i] + (3 * s2 - 2 * s3) * (to[i] - from[i]) + h * ((s3 - 2 * s2 + share) * out[i] + (s3 - s2) * in[i]);
    return sum;
  }

  // Adds the integral from a time to a later one. A velocity may jump at its events.
  void advance(const Program::Compiled& c, Asking& asking, Time from, Time until, Four& sum) const {
    for (std::int64_t at = from.flicks; at < until.flicks;) {
      const auto next = std::upper_bound(events_.begin(), events_.end(), at);
      const std::int64_t end = next != events_.end() ? std::min(*next, until.flicks) : until.flicks;
      add(sum, halved(c, asking, at, end, over(c, asking, at, end), 0));
      at = end;
    }
  }
  Four rate(const Program::Compiled& c, Asking& asking, std::int64_t flicks) const {
    const LiveParts parts{c, live_, asking};
    asking.work(1);
    Four n{};
    to_numbers(parts.part_value(rates_, Time{flicks}), n.data());
    if (!spaced_) return n;
    const Value space = c.value(c.find(live_.object, fn::velocity_space), Time{flicks}, asking);
    if (const auto* word = std::get_if<Text>(&space); !word || **word != "own") return n;
    const Vec3 v = transform_vector(rotation(own_turn(c, asking, Time{flicks})), vec3(n.data()));
    return {v.x, v.y, v.z, 0};
  }

 private:
  Quat own_turn(const Program::Compiled& c, Asking& asking, Time t) const {
    const Value v = c.value(c.find(live_.object, fn::rotation), t, asking);
    const auto* angles = std::get_if<Angles>(&v);
    const auto* q = std::get_if<Quat>(&v);
    return q ? *q : angles ? from_angles(angles->xyz) : Quat{};
  }
  // Returns an integral by Lobatto's rule: for numbers of the fifth degree, for rotations Magnus' of the fourth order.
  // Both look at the ends too, so no jump is missed.
  Four over(const Program::Compiled& c, Asking& asking, std::int64_t from, std::int64_t until) const {
    const double h = Time{until - from}.seconds();
    const auto at = [&](double share) {
      const std::int64_t flicks = from + std::llround(share * static_cast<double>(until - from));
      return rate(c, asking, std::min(flicks, until - 1));
    };
    if (rates_.orientation) {
      const Four a = at(0), m = at(0.5), b = at(1);
      const Vec3 x{a[0], a[1], a[2]}, y{m[0], m[1], m[2]}, z{b[0], b[1], b[2]};
      const Quat q = turn_by(h / 6 * (x + 4 * y + z) - h * h / 12 * cross(x, z));
      return {q.w, q.x, q.y, q.z};
    }
    const double beside = std::sqrt(0.2) / 2;
    const Four a = at(0), m = at(0.5 - beside), n = at(0.5 + beside), b = at(1);
    Four out{};
    for (std::size_t i = 0; i < 4; ++i) out[i] = h / 12 * (a[i] + 5 * (m[i] + n[i]) + b[i]);
    return out;
  }
  void add(Four& sum, const Four& more) const {
    if (!rates_.orientation) {
      for (std::size_t i = 0; i < 4; ++i) sum[i] += more[i];
      return;
    }
    const Quat q = normalize(Quat{more[0], more[1], more[2], more[3]} * Quat{sum[0], sum[1], sum[2], sum[3]});
    sum = {q.w, q.x, q.y, q.z};
  }
  Four halved(const Program::Compiled& c, Asking& asking, std::int64_t from, std::int64_t until, const Four& whole,
              int depth) const {
    const std::int64_t middle = from + (until - from) / 2;
    if (middle == from || asking.given_up) return whole;
    const Four first = over(c, asking, from, middle), second = over(c, asking, middle, until);
    Four both = first;
    add(both, second);
    double apart = 0;
    for (std::size_t i = 0; i < 4; ++i) apart = std::max(apart, std::abs(both[i] - whole[i]));
    if (depth == most_halvings || apart <= accuracy * integral_step.seconds()) return both;
    Four out = halved(c, asking, from, middle, first, depth + 1);
    add(out, halved(c, asking, middle, until, second, depth + 1));
    return out;
  }

  Live live_;
  LivePart rates_;
  bool spaced_;  // the object has a velocity-space
  std::vector<std::int64_t> events_;
};

}  // namespace

std::unique_ptr<NamedProcedure> make_integral(const Live& live, LivePart rates, Time from, bool spaced,
                                              std::string name) {
  auto made = std::make_unique<NamedProcedure>();
  made->name = std::move(name), made->role = Role::steps;
  made->code = std::make_shared<Integral>(live, std::move(rates), spaced);
  made->stepping = {integral_step, from, true};
  return made;
}

void integral_at(const Program::Compiled& c, const NamedProcedure& p, Time t, Asking& asking, double* out) {
  const auto& integral = static_cast<const Integral&>(*p.code);
  Four sum = integral.read({});
  const auto state = state_at(c, p, t, asking);
  const std::int64_t rest = std::max<std::int64_t>(0, t.flicks - p.stepping.from.flicks) % integral_step.flicks;
  const Time begun{t.flicks - rest};
  if (state) sum = integral.read(*state);
  if (!state && state.error().code == ErrorCode::range) asking.say(p.name, ": " + state.error().message);
  if (state && rest > 0 && is_computing(c, p, asking)) {
    const auto next = state_at(c, p, begun + integral_step, asking);
    if (next)
      sum = integral.hermite(*state, *next, static_cast<double>(rest) / static_cast<double>(integral_step.flicks));
    else if (next.error().code == ErrorCode::range)
      asking.say(p.name, ": " + next.error().message);
  } else if (state && rest > 0) {
    const PartOfStep part(c, p, t, asking);
    integral.advance(c, asking, begun, t, sum);
  }
  std::copy(sum.begin(), sum.end(), out);
}

void rate_at(const Program::Compiled& c, const NamedProcedure& p, Time t, Asking& asking, double* out) {
  const Four n = static_cast<const Integral&>(*p.code).rate(c, asking, t.flicks);
  std::copy(n.begin(), n.end(), out);
}

}  // namespace betwixt
