// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "program/collisions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "program/collision_step.h"
#include "program/compile.h"
#include "program/questions.h"
#include "program/steps.h"

namespace betwixt {
namespace {

constexpr double touching = 1e-6;                            // metres: closer surfaces touch
constexpr std::int64_t beside = flicks_per_second / 10'000;  // distance of the places that give a velocity
constexpr double rounding = 1e-9;                            // a direction that leads less into a surface is along it

// The motion among obstacles at the end of a step, in world space.
struct Flight {
  Vec3 off;                                                     // from the free path
  Vec3 drift;                                                   // of a bounce: velocity beside that of the free path
  std::array<Vec3, 3> turn{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};  // of a mirror: rows of the matrix of the free path
  bool undisturbed() const { return off == Vec3{} && drift == Vec3{} && straight(); }
  bool straight() const { return turn == Flight{}.turn; }
  Vec3 turned(Vec3 v) const { return {dot(turn[0], v), dot(turn[1], v), dot(turn[2], v)}; }
};

State to_state(const Flight& f) { return state_of({f.off, f.drift, f.turn[0], f.turn[1], f.turn[2]}); }
Flight to_flight(const State& s) {
  const auto all = vectors_of(s);
  return all.empty() ? Flight{} : Flight{all[0], all[1], {all[2], all[3], all[4]}};
}

// One step of an object among its obstacles.
class Path {
 public:
  Path(const Program::Compiled& film, const Live& live, const std::vector<std::int64_t>& keys, Time from,
       Asking& asking)
      : c_(film), live_(live), keys_(keys), asking_(asking), s_(collision_step(film, live, from, asking)) {}

  // Advances to a time within the step.
  void advance(Flight& f, std::int64_t until) const {
    if (!drifts()) f.drift = {}, f.turn = Flight{}.turn;
    constexpr int most_legs = 16;
    std::int64_t at = s_.from.flicks;
    std::vector<std::size_t> held;  // obstacles that it touches
    for (int legs = 0; legs < most_legs && at < until; ++legs) {
      const auto key = std::upper_bound(keys_.begin(), keys_.end(), at);
      const bool to_key = f.drift != Vec3{} && key != keys_.end() && *key <= s_.until.flicks;
      const std::int64_t end = to_key ? *key : s_.until.flicks;
      const Leg leg = begin(f, at, end, held);
      const auto hit = first_hit(leg, at, std::min(end, until), held);
      move(f, leg, hit ? hit->at : std::min(end, until));
      at = hit ? hit->at : std::min(end, until);
      held.clear();
      if (hit) held.push_back(hit->obstacle), respond(f, leg, *hit);
      if (!hit && to_key && at == end) pass_key(f, leg, at);
    }
    if (at < until) f.off = f.off + free(at) - free(until);  // too many collisions in one step: it waits
    push_out(f, until);
  }

 private:
  struct Surface {
    Vec3 normal, velocity;
  };
  struct Leg {  // a part of the step between two collisions
    std::int64_t from = 0, until = 0;
    Vec3 start;  // the free path at its beginning
    Flight flight;
    std::vector<Surface> surfaces;  // that it must not move into
    bool still = false;
  };
  struct Hit {
    std::int64_t at = 0;  // the last flick before they touch
    std::size_t obstacle = 0;
    Vec3 normal;
  };
  // The free path in the world.
  Vec3 free(std::int64_t flicks) const {
    const Value v = c_.free_position(live_, Time{flicks}, asking_);
    return s_.in_world(std::get<Vec3>(v), flicks);
  }
  // Where a leg leads.
  Vec3 place(const Leg& leg, std::int64_t at) const {
    const Vec3 begun = leg.start + leg.flight.off;
    if (leg.still || at == leg.from) return begun;
    const Vec3 now = free(at);
    const double seconds = Time{at - leg.from}.seconds();
    if (leg.surfaces.empty() && leg.flight.straight()) return now + leg.flight.off + seconds * leg.flight.drift;
    return begun + along(leg.flight.turned(now - leg.start) + seconds * leg.flight.drift, leg.surfaces);
  }
  // Returns the part of a way that does not lead into surfaces.
  static Vec3 along(Vec3 way, const std::vector<Surface>& surfaces) {
    for (std::size_t pass = 0; pass < surfaces.size(); ++pass)
      for (const Surface& s : surfaces)
        if (const double into = dot(way, s.normal); into < 0) way = way - into * s.normal;
    for (const Surface& s : surfaces)
      if (dot(way, s.normal) < -rounding * length(way)) return {};  // a corner
    return way;
  }
  // Returns the slope of a path at one of its ends, from three places `flicks` apart; backwards if negative.
  template <class At>
  static Vec3 slope(std::int64_t at, std::int64_t flicks, At&& place) {
    return (1 / (2 * Time{flicks}.seconds())) * (4.0 * place(at + flicks) - 3.0 * place(at) - place(at + 2 * flicks));
  }
  Vec3 velocity(const Leg& leg, std::int64_t at, bool coming) const {
    const std::int64_t room = coming ? at - leg.from : s_.until.flicks - at;
    const std::int64_t h = std::max<std::int64_t>(1, std::min(beside, room / 2));
    return slope(at, coming ? -h : h, [&](std::int64_t t) { return place(leg, t); });
  }
  // Begins a leg: what touches and would be moved into holds it back.
  Leg begin(Flight& f, std::int64_t at, std::int64_t until, std::vector<std::size_t>& held) const {
    Leg leg{at, until, free(at), f, {}, false};
    // An object that was held up returns to its track as soon as the way is free.
    if (!drifts()) leg.flight.drift = (-1 / Time{s_.until.flicks - at}.seconds()) * f.off;
    const Vec3 here = leg.start + f.off, way = place(leg, until) - here;
    const double seconds = Time{until - at}.seconds();
    for (std::size_t i = 0; i < s_.obstacles.size(); ++i) {
      const Clearance g = s_.gap(i, here, at);
      const bool known = std::find(held.begin(), held.end(), i) != held.end();
      if (g.wide > touching && !known) continue;
      const Vec3 relative = way - seconds * s_.velocity_of(i);
      if (!(dot(relative, g.normal) < -rounding * length(relative))) continue;
      if (!known) held.push_back(i);
      leg.surfaces.push_back({g.normal, s_.velocity_of(i)});
    }
    if (leg.surfaces.empty()) return leg;
    if (s_.law == CollisionLaw::stop) leg.still = true;
    if (s_.law == CollisionLaw::mirror) {
      for (const Surface& surface : leg.surfaces) reflect(f, surface.normal);
      leg.flight = f, leg.surfaces.clear();
    }
    if (s_.law == CollisionLaw::bounce) bounce_or_rest(f, leg);
    return leg;
  }
  // Bounces, unless that would last less than four steps: then the drift cancels the speed towards the surface, and the
  // object rests on it or slides along it.
  void bounce_or_rest(Flight& f, Leg& leg) const {
    const std::vector<Surface> touched = std::exchange(leg.surfaces, {});
    const std::int64_t later = std::min(s_.until.flicks, leg.from + CollisionStep::length.flicks / 2);
    const Vec3 v = velocity(leg, leg.from, false), faster = velocity(leg, later, true) - v;
    for (const Surface& surface : touched) {
      const Vec3 n = surface.normal;
      const double into = std::min(0.0, dot(v - surface.velocity, n));
      const bool bounces = s_.kept * -into > 4 * std::abs(dot(faster, n)) + touching;
      f.drift = f.drift - (bounces ? 1 + s_.kept : 1) * into * n;
      if (!bounces) leg.surfaces.push_back(surface);
    }
    leg.flight = f;
  }
  // After its first bounce, an object keeps its speed where that of its track jumps, as at the track's last event.
  void pass_key(Flight& f, const Leg& leg, std::int64_t at) const {
    const auto path = [&](std::int64_t t) { return free(t); };
    const Vec3 came = slope(at, -beside, path), goes = slope(at, beside, path);
    if (length(goes - came) > 1e-6 + 1e-4 * (length(came) + length(goes))) f.drift = velocity(leg, at, true) - goes;
  }
  void reflect(Flight& f, Vec3 n) const {
    for (int k = 0; k < 3; ++k) {
      Vec3 column{f.turn[0][k], f.turn[1][k], f.turn[2][k]};
      column = column - (1 + s_.kept) * dot(column, n) * n;
      for (int i = 0; i < 3; ++i) f.turn[static_cast<std::size_t>(i)][k] = column[i];
    }
  }

  // Returns the first collision on a leg with an obstacle that it does not touch already.
  std::optional<Hit> first_hit(const Leg& leg, std::int64_t from, std::int64_t until,
                               const std::vector<std::size_t>& held) const {
    const Vec3 begun = place(leg, from), ends = place(leg, leg.until);
    std::optional<Hit> first;
    for (std::size_t i = 0; i < s_.obstacles.size(); ++i) {
      if (std::find(held.begin(), held.end(), i) != held.end()) continue;
      const double own = length(ends - begun),
                   other = length(s_.obstacles[i].ends[1].middle - s_.obstacles[i].ends[0].middle);
      const double size = std::min(s_.own[0].size(), s_.obstacles[i].ends[0].size());
      if (s_.gap(i, begun, from).wide > 2 * (own + other) + size + s_.turning(i)) continue;
      const auto hit =
          hit_with(i, leg, from, first ? first->at : until, std::max(own + other, s_.turning(i)) / (size / 4));
      if (hit && (!first || hit->at < first->at)) first = hit;
    }
    return first;
  }
  std::optional<Hit> hit_with(std::size_t i, const Leg& leg, std::int64_t from, std::int64_t until,
                              double looks) const {
    const std::int64_t count = std::clamp<std::int64_t>(static_cast<std::int64_t>(std::ceil(looks)), 2, 64);
    const std::int64_t stride = std::max<std::int64_t>(1, CollisionStep::length.flicks / count);
    // Looks at fixed times of the step, so that a shorter part of the step finds the same collision.
    std::int64_t before = from;
    while (before < until) {
      const std::int64_t next = s_.from.flicks + ((before - s_.from.flicks) / stride + 1) * stride,
                         at = std::min(next, until);
      asking_.work(1);
      if (s_.gap(i, place(leg, at), at).wide <= 0) return closest(i, leg, before, at);
      before = at;
    }
    return std::nullopt;
  }
  Hit closest(std::size_t i, const Leg& leg, std::int64_t apart, std::int64_t inside) const {
    while (inside - apart > 1) {
      const std::int64_t middle = apart + (inside - apart) / 2;
      (s_.gap(i, place(leg, middle), middle).wide <= 0 ? inside : apart) = middle;
    }
    return {apart, i, s_.gap(i, place(leg, apart), apart).normal};
  }

  void move(Flight& f, const Leg& leg, std::int64_t at) const {
    const bool plain = !leg.still && leg.surfaces.empty() && f.straight();
    if (plain)
      f.off = f.off + Time{at - leg.from}.seconds() * leg.flight.drift;
    else
      f.off = place(leg, at) - free(at);
    if (plain && !drifts() && at == s_.until.flicks) f.off = {};  // it is back on its track
  }
  bool drifts() const { return s_.law == CollisionLaw::bounce || s_.law == CollisionLaw::mirror; }
  void respond(Flight& f, const Leg& leg, const Hit& hit) const {
    if (s_.law == CollisionLaw::mirror) return reflect(f, hit.normal);
    if (s_.law != CollisionLaw::bounce) return;
    const Vec3 v = velocity(leg, hit.at, true) - s_.velocity_of(hit.obstacle);
    if (const double into = dot(v, hit.normal); into < 0) f.drift = f.drift - (1 + s_.kept) * into * hit.normal;
  }
  // Moves it out of obstacles that have moved into it.
  void push_out(Flight& f, std::int64_t at) const {
    constexpr int passes = 4;
    Vec3 here = free(at) + f.off;
    bool moved = false;
    for (int pass = 0, any = 1; pass < passes && any; ++pass) {
      any = 0;
      for (std::size_t i = 0; i < s_.obstacles.size(); ++i)
        if (const Clearance g = s_.gap(i, here, at); g.wide < 0) here = here - g.wide * g.normal, any = 1, moved = true;
    }
    if (moved) f.off = here - free(at);
  }

  const Program::Compiled& c_;
  const Live& live_;
  const std::vector<std::int64_t>& keys_;
  Asking& asking_;
  const CollisionStep s_;
};

// The law as a stepped procedure, whose states are flights.
class Collision final : public Routine {
 public:
  Collision(std::int32_t live, std::vector<std::int64_t> times) : keys(std::move(times)), live_(live) {
    language = "collision";
  }
  std::string_view circle() const override {
    return "its obstacles move with it or stop at it at the same time: they must not depend on its place";
  }
  const std::vector<std::int64_t> keys;  // the times of the track's events, in order
  bool stepped() const override { return true; }
  Result<State> step(Questions& q, const State& before, std::int64_t number, double,
                     std::uint64_t& cost) const override {
    auto& film = static_cast<FilmQuestions&>(q);  // only a film's steps call this
    if (number == 0) return to_state({});
    const std::uint64_t begun = film.asking.cost;
    Flight f = to_flight(before);
    Path(film.c, film.c.lives[static_cast<std::size_t>(live_)], keys, film.t - CollisionStep::length, film.asking)
        .advance(f, film.t.flicks);
    cost += std::exchange(film.asking.cost, begun) - begun + 100;
    return to_state(f);
  }

 private:
  std::int32_t live_;
};

}  // namespace

std::unique_ptr<NamedProcedure> make_collision(const Object& object, std::int32_t live, std::string name) {
  std::vector<std::int64_t> keys;
  for (const Slot& slot : object.slots)
    if (slot.function == fn::position)
      each_track(slot, [&](const Track& t) { t.events.each([&](const Event& e) { keys.push_back(e.time.flicks); }); });
  std::sort(keys.begin(), keys.end());
  auto made = std::make_unique<NamedProcedure>();
  made->name = std::move(name), made->role = Role::steps;
  made->code = std::make_shared<Collision>(live, std::move(keys));
  made->stepping = {CollisionStep::length, Time{}, true};
  return made;
}

Vec3 among_obstacles(const Program::Compiled& c, const Live& live, Vec3 free, Time t, Asking& asking) {
  if (t <= Time{}) return free;
  const NamedProcedure& law = *c.collisions[static_cast<std::size_t>(live.collision)];
  const auto state = state_at(c, law, t, asking);
  if (!state) {
    asking.say(c.document.name(Target{{live.object}, live.function, -1}), ": " + state.error().message);
    return free;
  }
  Flight f = to_flight(*state);
  const std::int64_t rest = t.flicks % CollisionStep::length.flicks;
  const Time from{t.flicks - rest};
  const std::uint32_t node = c.node_of[live.object];
  if (rest > 0 && is_computing(c, law, asking)) {  // for obstacles that look back, which may happen very often
    const auto next = state_at(c, law, from + CollisionStep::length, asking);
    const Vec3 later = next ? to_flight(*next).off : f.off;
    f.off = f.off + (static_cast<double>(rest) / static_cast<double>(CollisionStep::length.flicks)) * (later - f.off);
    if (!next) asking.say(law.name, ": " + next.error().message);
  } else if (rest > 0) {
    const PartOfStep part(c, law, t, asking);
    Path(c, live, static_cast<const Collision&>(*law.code).keys, from, asking).advance(f, t.flicks);
  }
  if (f.undisturbed()) return free;
  const Carrier carrier = carrier_of(c, c.nodes[node], t, asking);
  const Vec3 at = transform_point(carrier.above, transform_point(carrier.kept, free) + carrier.attach) + f.off;
  return carrier.seen(at).value_or(free);
}

}  // namespace betwixt
