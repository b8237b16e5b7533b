// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Reads values, one or many at a time.
#include <algorithm>

#include "base/cancellation.h"
#include "base/diagnostic.h"
#include "program/audible_part.h"
#include "program/contacts.h"
#include "program/evaluator.h"
#include "program/placing.h"

namespace betwixt {
namespace {

Value part(const Value& v, int component) {
  if (component < 0 || !numeric(v)) return v;
  if (const auto* q = std::get_if<Quat>(&v)) return to_angles(*q)[component];
  return component_of(v, component);
}

// Returns the whole matrix, or one coordinate of its translation.
Value place_in(const Mat4& m, int component) {
  if (component < 0) return Matrix(m);
  return translation_of(m)[component];
}

// Reads a query of a sound at a time.
Value heard(const Program::Compiled& c, const Target& target, Time t, Asking& asking) {
  const auto number = [&](FunctionId f) { return std::get<double>(c.read(Target(target.object, f), t, asking)); };
  const auto& sounds = *c.document.scene().sounds;
  const auto found = sounds.find(*std::get<Text>(c.read(Target(target.object, fn::sound_file), t, asking)));
  if (found == sounds.end()) return 0.0;
  const Sound& sound = *found->second;
  const AudiblePart part = audible_part(sound.seconds, number);
  const double own = part.own_time(t.seconds());
  if (target.query() == Query::onsets)
    return static_cast<double>(sound.onsets_between(part.from, std::min(own, part.end())));
  return number(fn::gain) * part.share(own) * sound.loudness(own);
}

}  // namespace

Value Program::Compiled::read(const Target& target, Time t, Asking& asking) const {
  const std::uint32_t object = target.object.index;
  const Object& what = document.scene().objects[object];
  const std::optional<Query> query = target.query();
  if (what.environment && query) {
    const Environment& e = *what.environment;
    const std::int64_t tick = document.scene().ticks.whole(t);
    // The generation alive at the tick. If it has been killed, its last A.
    const int generation = e.generation_at(tick).value_or(std::max(0, e.bind(tick).value_or(e.generations()) - 1));
    if (query == Query::by) return Matrix(e.matrix(tick).value_or(Mat4{}));
    if (query == Query::every) return static_cast<double>(e.interval(tick).value_or(0));
    if (query == Query::count) return static_cast<double>(e.count(generation, tick));
    return place_in(e.at(generation, tick), target.component);
  }
  if (query == Query::touching) {
    std::vector<std::string> names;
    for (const ObjectId id : betwixt::contacts(*this, t, asking)->touching(target.object))
      names.push_back(document.name(id));
    return Names(std::move(names));
  }
  if (query == Query::loudness || query == Query::onsets) return heard(*this, target, t, asking);
  if (query == Query::in_view) return betwixt::contacts(*this, t, asking)->sight(target.object) != Sight::out;
  if (query == Query::world && target.component >= 0)
    return place_of(*this, node_of[object], t, asking, target.component);
  if (query == Query::world) return Matrix(placement(*this, node_of[object], t, asking).in_world());
  if (target.velocity) {
    const auto v = velocity(object, target.function, t, asking);
    return part(v.value_or(Value(0.0)), target.component);
  }
  const Binding& b = find(object, target.function);
  const Type type = spec_of(document.scene(), target.function).type;
  if (type == Type::attachment) {  // before its first event, the initial value holds
    AttachmentSpan now;
    for (const AttachmentSpan& a : attachments(document.scene().objects[object]))
      if (a.from <= t) now = a;
    return now.computed ? live_value(b.live, t, asking) : Value(now.to);
  }
  if (b.live >= 0 && parted(b.live, target.component)) return live_value(b.live, t, asking, target.component);
  if (b.live >= 0) return part(live_value(b.live, t, asking), target.component);
  if (b.channels == 0) {
    if (type == Type::aim && b.steps >= 0) {
      const Between w = between(b, t, asking);
      if (w.a != w.b) {
        // A focus is given as a distance in front of the camera.
        const bool focus = target.function == fn::focus;
        const auto own = focus ? inverse(placement(*this, node_of[object], t, asking).in_world()) : std::nullopt;
        const auto there = [&](std::uint32_t node) {
          const Vec3 p = place_of(*this, node, t, asking);
          return own ? Vec3{0, 0, transform_point(*own, p).z} : p;
        };
        std::vector<double> numbers = rest;
        numbers.resize(numbers.size() + 4);
        const Binding& beside = find(object, fn::look_offset);
        evaluate(beside, t, asking, &numbers[beside.offset]);
        if (const auto p = aim(object, target.function, t, numbers.data(), there, asking))
          return part(*p, target.component);
      }
    }
    if (type == Type::points && b.steps >= 0) return std::get<Points>(shape_part(b, t, rest.data(), asking));
    return part(value(b, t, asking), target.component);
  }
  double n[4];
  evaluate(b, t, asking, n);
  return part(written_value(type, n, b.orientation), target.component);
}

Value Program::read(const Target& target, Time t) const {
  if (!find_object(document().scene(), target.object)) return 0.0;
  Asking asking;
  return code_->read(target, t, asking);
}

namespace {

std::vector<Value> read_all(const Program::Compiled& code, const std::vector<Target>& targets, Time t, Asking& asking) {
  const TwerperFailures failed;
  std::vector<Value> out;
  out.reserve(targets.size());
  std::optional<Evaluator> all;  // many world transforms are cheaper together
  const auto wants_world = [&](const Target& x) {
    return x.query() == Query::world && !code.document.scene().objects[x.object.index].environment;
  };
  if (std::count_if(targets.begin(), targets.end(), wants_world) > 4) all.emplace(code).to(t, asking);
  for (const Target& target : targets) {
    Cancellation::check();
    out.push_back(wants_world(target) && all ? place_in(all->world(code.node_of[target.object.index]), target.component)
                                             : code.read(target, t, asking));
  }
  asking.say_all(failed, code.document.scene());
  return out;
}

// Returns true for queries that read all objects, at a cost that is not counted.
bool looks_far(const Target& t) { return t.query() == Query::touching || t.query() == Query::in_view; }

}  // namespace

std::vector<Value> Program::read(const std::vector<Target>& targets, Time t, std::vector<std::string>* problems) const {
  Asking asking;
  std::vector<Value> out = read_all(*code_, targets, t, asking);
  if (problems) *problems = to_strings(asking.problems);
  return out;
}

std::optional<std::vector<Value>> Program::read_within(std::uint64_t steps, const std::vector<Target>& targets, Time t,
                                                       std::vector<std::string>* problems) const {
  constexpr std::size_t few = 16;
  if (targets.size() > few || code_->traces || std::any_of(targets.begin(), targets.end(), looks_far))
    return std::nullopt;
  Asking asking;
  asking.most = steps;
  std::vector<Value> out = read_all(*code_, targets, t, asking);
  if (asking.cost > steps) return std::nullopt;
  if (problems) *problems = to_strings(asking.problems);
  return out;
}

std::vector<Target> Program::reads(const Target& target, Time t) const {
  Asking asking;
  code_->read(target, t, asking);
  return std::move(asking.read);
}

std::vector<double> numbers(const Value& v) {
  double n[16];
  int count = to_numbers(v, n);
  if (const auto* m = std::get_if<Matrix>(&v))
    for (int i = 0; i < 16; ++i) n[count++] = (**m)(i / 4, i % 4);
  return {n, n + count};
}

}  // namespace betwixt
