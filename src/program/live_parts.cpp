// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "program/live_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/cancellation.h"
#include "base/utf8.h"
#include "program/along.h"
#include "program/integrals.h"
#include "program/questions.h"
#include "scene/kinds.h"
#include "track/along.h"
#include "track/operations.h"
#include "track/turns.h"

namespace betwixt {
namespace {

using Numbers = std::array<double, 4>;

// Returns enough of the first line to recognise it.
std::string brief(std::string_view source) {
  source.remove_prefix(std::min(source.find_first_not_of(" \t\r\n"), source.size()));
  const std::string_view line = source.substr(0, source.find('\n'));
  const bool more = source.find_first_not_of(" \t\r\n", line.size()) != std::string_view::npos;
  return std::string(line.substr(0, 60)) + (more ? " …" : "");
}

// Repeats a track of places on lines like a track of plain values. Code is never repeated: it always gets the true
// time.
Time repeated(const Track& track, Time t) {
  if (track.events.size() < 2) return t;
  const Time first = track.events.front().time, last = track.events.back().time;
  const bool over = t > last || (t == last && track.after == Extrapolation::cycle);
  const Extrapolation how = t < first ? track.before : over ? track.after : Extrapolation::hold;
  if (how < Extrapolation::cycle) return t;
  bool code = false;
  track.events.each(
      [&](const Event& e) { code = code || (std::holds_alternative<Procedure>(e.value) && !along(e.value)); });
  return code ? t : Time{fold(t.flicks, first.flicks, last.flicks, how == Extrapolation::bounce)};
}

}  // namespace

Result<Value> usable(const Scene& scene, FunctionId function, Type type, const Value& v, bool rate) {
  const auto no = [](std::string why) { return fail(ErrorCode::type, std::move(why)); };
  const auto plain = [&]() -> Value {  // rates are plain numbers
    if (const auto* angles = std::get_if<Angles>(&v)) return angles->xyz;
    if (const auto* color = std::get_if<Color>(&v)) return Vec3{color->r, color->g, color->b};
    return v;
  };
  auto fitting = fit(rate ? plain() : v, type, scene);
  if (!fitting) return fitting;
  double n[4];
  if (!finite({n, static_cast<std::size_t>(to_numbers(*fitting, n))})) return no("it is not finite");
  const auto* text = std::get_if<Text>(&*fitting);
  if (!text) return fitting;
  const std::string& letters = **text;
  if (const FunctionSpec& spec = spec_of(scene, function); !spec.words.empty()) {
    const auto words = choices(spec);
    if (std::find(words.begin(), words.end(), letters) == words.end())
      return no(fmt::format("'{}' is not one of {}", letters.substr(0, 40), fmt::join(words, ", ")));
  }
  if (function == fn::texture && !letters.empty() && !scene.pictures->contains(letters))
    return no(fmt::format("the film has not read the picture '{}': write its name in quotes in this code",
                          letters.substr(0, 60)));
  if (function == fn::file && !letters.empty() && !scene.meshes->contains(letters))
    return no(fmt::format("the film has not read the mesh '{}': write its name in quotes in this code",
                          letters.substr(0, 60)));
  if (function == fn::text && letters.size() > most_letters && count_characters(letters) > most_letters)
    return no(fmt::format("its text has more than {} letters", most_letters));
  return fitting;
}

// Returns true if the code is the default of the author's function.
bool LiveParts::by_definition(const Routine& code) const {
  const auto* rest = std::get_if<Procedure>(&spec_of(scene, live.function).rest);
  return rest && rest->code.get() == &code;
}

std::optional<Value> LiveParts::run(const Procedure& p, const LivePart& part, Time t) const {
  if (asking.work(0)) return std::nullopt;
  if (const Along* place = along(Value(p)))
    return value_along(c, live.object, live.function, place->road, place->share, t, asking);
  return answer(*p.code, part, t, [&](Questions& q, std::uint64_t& cost) { return p.code->value(q, {}, cost); });
}

template <class Call>
std::optional<Value> LiveParts::answer(const Routine& code, const LivePart& part, Time t, Call&& call) const {
  if (asking.in_haste() && asking.work(asking.most + 1)) return std::nullopt;  // code may always take long
  FilmQuestions questions(c, asking, t, {live.object});
  std::uint64_t cost = 0;
  const Result<Value> answer = call(questions, cost);
  if (questions.called_off) throw Cancelled{};
  if (asking.work(cost + 300)) return std::nullopt;  // starting the code costs something too
  if (!answer && questions.lacking && by_definition(code)) return std::nullopt;  // the object has no such value
  const auto say = [&](const std::string& why, int line = 0) {
    const std::string& source = code.source;
    Target about{{live.object}, live.function, part.component};
    about.velocity = part.velocity;
    asking.say({Problem::procedure, c.document.name(about), brief(source), why, source, line});
    return std::nullopt;
  };
  if (!answer) return say(answer.error().message, answer.error().place.line);
  const auto fitting = usable(scene, live.function, part.value_type(), *answer, part.velocity);
  if (!fitting) return say(fitting.error().message);
  return *fitting;
}

// Returns the value of an event that changes the twerper only: that of the track without it.
Value LiveParts::kept_value(const Event& e, const LivePart& part) const {
  LivePart without = part;
  without.plain = {};
  Track& track = without.track;
  track.events = {};
  part.track.events.each([&](const Event& other) {
    if (!other.keep) track.events.put(other);
  });
  return scripted(without, e.time);
}

// Code knows objects by their names.
Value LiveParts::named(Value v) const {
  const auto* id = std::get_if<ObjectId>(&v);
  if (!id) return v;
  const Object* o = find_object(scene, *id);
  return Text(o ? o->name : std::string("none"));
}

std::optional<Value> LiveParts::run_tween(const Routine& code, const LivePart& part,
                                          const std::vector<const Event*>& near, std::size_t after, Time t) const {
  if (asking.work(0)) return std::nullopt;
  const auto leaves = [&](const Event& e) {
    return named(e.keep ? kept_value(e, part) : event_value(e.value, part, e.time, e.time));
  };
  const auto arrives = [&](const Event& e) {
    return e.detail->before ? named(event_value(*e.detail->before, part, e.time, e.time)) : leaves(e);
  };
  const Event &begin = *near[after - 1], &end = *near[after];
  const double length = static_cast<double>((end.time - begin.time).flicks);
  CurveDetail from, to;
  from.ease_out = static_cast<double>(begin.detail->ease_out.flicks);
  to.ease_in = static_cast<double>(end.detail->ease_in.flicks);
  const Value values[] = {leaves(begin), arrives(end)};
  std::optional<Value> before, behind;
  if (after >= 2) before = leaves(*near[after - 2]);
  if (after + 1 < near.size()) behind = arrives(*near[after + 1]);
  const TweenSegment gap{eased(static_cast<double>((t - begin.time).flicks) / length, &from, &to, length),
                         (end.time - begin.time).seconds(),
                         &values[0],
                         &values[1],
                         before ? &*before : nullptr,
                         behind ? &*behind : nullptr};
  return answer(code, part, t, [&](Questions& q, std::uint64_t& cost) { return code.between(q, gap, cost); });
}

Value LiveParts::settled(const LivePart& part, Time t) const {
  Value v = part.rest;
  part.track.events.each([&](const Event& e) {
    if (e.time <= t && !e.keep && !std::holds_alternative<Procedure>(e.value)) v = e.value;
  });
  return std::holds_alternative<Procedure>(v) ? at_rest(part) : v;
}
Value LiveParts::at_rest(const LivePart& part) const {
  const FunctionSpec& spec = spec_of(scene, live.function);
  const Value v = std::holds_alternative<Procedure>(spec.rest) ? row_of(spec.type).example() : spec.rest;
  return part.component < 0 ? v : Value(component_of(v, part.component));
}

Value LiveParts::event_value(const Value& v, const LivePart& part, Time t, Time at) const {
  const auto* p = std::get_if<Procedure>(&v);
  if (!p) return v;
  if (auto made = run(*p, part, at)) return *std::move(made);
  return settled(part, t);
}

// Moves along a line between two places on it, by the blend of their fractions. `near`: the events about t, those
// from index `after` on behind t. Returns nullopt if they are not on one line.
std::optional<Value> LiveParts::along_line(const Track& track, const std::vector<const Event*>& near, std::size_t after,
                                           Time t) const {
  const auto reaches = [](const Event& e) { return along(e.detail->before ? *e.detail->before : e.value); };
  const Along* const from = along(near[after - 1]->value);
  if (!from || after == near.size() || near[after - 1]->keep || near[after]->keep) return std::nullopt;
  const auto here = [&](const Along* other) { return other && other->road == from->road; };
  if (!here(reaches(*near[after]))) return std::nullopt;
  std::size_t first = after - 1, end = after + 1;
  while (first > 0 && !near[first]->detail->before && here(along(near[first - 1]->value))) --first;
  while (end < near.size() && !near[end - 1]->detail->before && here(reaches(*near[end]))) ++end;
  Track shares;
  shares.global = track.global, shares.arguments = track.arguments;
  for (std::size_t i = first; i < end; ++i) {
    Event e = *near[i];
    e.value = (i + 1 == end ? reaches(e) : along(e.value))->share;
    if (e.detail->before) e.detail.edit().before.reset();
    shares.events.put(std::move(e));
  }
  CurveSet small;
  small.own = c.set.own;
  double share = 0;
  small.evaluate(small.add(shares, Type::scalar), t, &share);
  return value_along(c, live.object, live.function, from->road, share, t, asking);
}

// Evaluates a track that contains procedures. A segment that begins with a procedure takes its value throughout. With
// a twerper, it blends from the procedure's value to the next one.
Value LiveParts::scripted(const LivePart& part, const Time asked) const {
  const Time t = repeated(part.track, asked);
  std::vector<const Event*> near;  // three before and three behind, which is all that splines use
  std::size_t before = 0;
  const Event* last = nullptr;
  const bool holds = part.type == Type::attachment;  // before its first event, the initial value holds
  part.track.events.each([&](const Event& e) {
    if (holds && (e.keep || e.time > t)) return;
    if (e.time <= t) {
      near.push_back(&e), last = &e;
      if (near.size() > 3) near.erase(near.begin());
      before = near.size();
    } else if (near.size() < before + 3) {
      near.push_back(&e);
    }
  });
  if (near.empty()) return event_value(part.rest, part, t, t);
  const auto as_plain = [&] {
    Numbers n{};
    c.set.evaluate(part.plain, asked, n.data());
    return as_written(part, n.data(), part.plain.orientation);
  };
  if (!last && part.plain.count > 0) return as_plain();
  if (!last && near[0]->detail->before) return event_value(*near[0]->detail->before, part, t, t);
  if (!last) return event_value(near[0]->value, part, t, near[0]->time);
  const Twerper twerper = part.track.global != Twerper::unset ? part.track.global : last->twerper;
  if (const Routine* code = before < near.size() ? tween(scene, twerper) : nullptr)
    if (auto made = run_tween(*code, part, near, before, t)) return *std::move(made);
  if (part.plain.count > 0) return as_plain();
  if (twerper != Twerper::hold)
    if (auto place = along_line(part.track, near, before, t)) return *std::move(place);
  const bool alone = near.back() == last || twerper == Twerper::hold || !has_velocity(part.type) ||
                     (twerper == Twerper::unset && std::holds_alternative<Procedure>(last->value));
  // A motion is computed once, when it begins.
  if (alone && !last->keep) return event_value(last->value, part, t, part.type == Type::motion ? last->time : t);
  // No blend crosses a cut or a hold, so values beyond it are not evaluated.
  const auto parts = [&](std::size_t i) {
    const Twerper to_here = part.track.global != Twerper::unset ? part.track.global : near[i - 1]->twerper;
    return !near[i]->keep && (near[i]->detail->before || to_here == Twerper::hold);
  };
  std::size_t first = before - 1, end = std::min(before + 1, near.size());
  while (first > 0 && !parts(first)) --first;
  while (end < near.size() && !parts(end - 1)) ++end;
  Track few;
  few.global = part.track.global, few.arguments = part.track.arguments, few.srgb = part.track.srgb;
  for (std::size_t i = first; i < end; ++i) {
    const Event* e = near[i];
    Event made = *e;
    if (e->detail->before && i > first) {
      made.value = *(made.detail.edit().before = event_value(*e->detail->before, part, t, e->time));
    } else {
      if (e->detail->before) made.detail.edit().before.reset();
      made.value = event_value(e->value, part, t, e == last ? t : e->time);
    }
    few.events.put(std::move(made));
  }
  CurveSet small;
  small.own = c.set.own;
  const Curve curve = small.add(few, part.type, part.component >= 0);
  if (curve.count == 0) return at_rest(part);
  Numbers n{};
  small.evaluate(curve, t, n.data());
  return as_written(part, n.data(), curve.orientation);
}

Value LiveParts::as_written(const LivePart& part, double* n, bool orientation) const {
  if (part.value_type() != part.type) return to_srgb(n[0]);
  return written_value(part.type, n, orientation);
}

Value LiveParts::piece_value(const LivePart& part, std::size_t i, Time t) const {
  const Piece& p = part.pieces[i];
  if (p.reign < 0 && p.integral < 0) {
    if (p.scripted) {  // the value reached at the release holds until the track's next event
      bool any = i == 0;
      part.track.events.each([&](const Event& e) { any = any || (e.time > p.from && e.time <= t); });
      return any ? scripted(part, t) : piece_value(part, i - 1, p.from);
    }
    if (p.primary.count == 0) return i > 0 ? piece_value(part, i - 1, p.from) : event_value(part.rest, part, t, t);
    Numbers n{};
    c.set.evaluate(p.primary, t, n.data());
    return as_written(part, n.data(), p.primary.orientation);
  }
  // The value of the track at that time, also before its first event.
  const Value anchor = piece_value(part, i - 1, p.from);
  Numbers sum{};
  if (p.integral >= 0)
    integral_at(c, *c.integrals[static_cast<std::size_t>(p.integral)], t, asking, sum.data());
  else
    c.reigns[static_cast<std::size_t>(p.reign)].sum(c.set, t, sum.data());
  if (part.orientation) {
    const auto* q = std::get_if<Quat>(&anchor);
    const auto* a = std::get_if<Angles>(&anchor);
    return normalize(quat(sum.data()) * (q ? *q : from_angles(a ? a->xyz : Vec3{})));
  }
  const auto both = add_scaled(anchor, value_of_numbers(part.value_type(), sum.data()), 1);
  return both ? *both : anchor;
}

Value LiveParts::part_value(const LivePart& part, Time t) const {
  return part.pieces.empty() ? scripted(part, t) : piece_value(part, part.piece_at(t), t);
}

}  // namespace betwixt
