// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "program/deferred_evaluation.h"

#include <algorithm>

#include "program/placing.h"
#include "program/splined.h"
#include "program/stage.h"

namespace betwixt {
namespace {

// Answers how far the shapes of `geometry` are blended. Shapes are made once each.
struct Blender {
  const Program::Compiled& c;
  std::uint32_t drawable;
  Time t;
  Asking& asking;
  std::map<std::uint32_t, std::shared_ptr<const Shape>> made{};

  const std::shared_ptr<const Shape>& shape(const Value& v) {
    const ObjectId said = std::get<ObjectId>(v);
    const Object* o = find_object(c.document.scene(), said);
    const std::uint32_t node = o && betwixt::drawable(o->kind) ? c.node_of[said.index] : drawable;
    std::shared_ptr<const Shape>& known = made[node];
    if (!known) known = c.drawn_shape(node, t, asking);
    return known;
  }
  void answer(Answer& a) {
    const Binding& geometry = *c.drawables[drawable].geometry;
    const StepTrack& track = c.steps_of(geometry);
    const Between w = c.between(geometry, t, asking);
    const auto values = track.values();
    const bool splines = w.a != w.b && w.splines;
    if (auto sum = splines ? splined(track, w, [&](const Value& v) { return shape(v); }) : std::nullopt) {
      a.shape = sum->one ? shape(*sum->one) : std::make_shared<const Shape>(*std::move(sum->sum));
      return;
    }
    a.shape = shape(values[w.a]);
    if (w.a != w.b && w.s != 0) a.toward = shape(values[w.b]), a.blend = w.s;
  }
};

void answer_track(const Program::Compiled& c, const Schedule::LiveSource& s, Time t, Asking& asking, Answer& a) {
  if (s.binding->function == fn::motion)
    a.motion = moved(c, c.nodes[s.node], t, asking);
  else if (s.binding->steps >= 0)
    a.between = c.between(*s.binding, t, asking);
  else
    c.evaluate(*s.binding, t, asking, a.numbers.data());
}

}  // namespace

std::vector<Question> questions_of(const CompiledFilm& c) {
  std::vector<Question> all;
  const auto add = [&](Question::What what, std::size_t count) {
    for (std::uint32_t i = 0; i < count; ++i) all.push_back({what, i});
  };
  add(Question::live, c.lives.size());
  add(Question::track, c.schedule.coded.size());
  add(Question::shape, c.slow_shapes.size());
  add(Question::blend, c.slow_blends.size());
  add(Question::camera, c.asks_for_camera() ? 1 : 0);
  return all;
}

std::pair<std::uint32_t, FunctionId> subject_of(const CompiledFilm& c, const Question& q) {
  switch (q.what) {
    case Question::live:
      return {c.lives[q.index].object, c.lives[q.index].function};
    case Question::track:
      return {c.nodes[c.schedule.coded[q.index].node].object, c.schedule.coded[q.index].binding->function};
    case Question::shape:
      return {c.nodes[c.slow_shapes[q.index]].object, 0};
    case Question::blend:
      return {c.nodes[c.slow_blends[q.index]].object, fn::geometry};
    case Question::camera:
      break;
  }
  return {0, 0};
}

bool may_take_long(const CompiledFilm& c, const Question& q, Time t) {
  if (q.what == Question::track) return c.runs_code(c.schedule.coded[q.index], t);
  if (q.what != Question::blend) return true;
  const Binding& geometry = *c.drawables[c.slow_blends[q.index]].geometry;
  const StepTrack& track = c.steps_of(geometry);
  if (track.runs_code(t)) return true;
  const Between w = track.at(t, c.set);
  return w.a != w.b && w.s != 0;
}

Answer work_out(const Program::Compiled& c, const Question& q, Time t) {
  Answer a;
  Asking asking;
  const TwerperFailures failed;
  if (q.what == Question::live) a.value = c.live_value(static_cast<std::int32_t>(q.index), t, asking);
  if (q.what == Question::track) answer_track(c, c.schedule.coded[q.index], t, asking, a);
  if (q.what == Question::shape) a.shape = c.drawn_shape(c.slow_shapes[q.index], t, asking);
  if (q.what == Question::blend) Blender{c, c.slow_blends[q.index], t, asking}.answer(a);
  if (q.what == Question::camera) a.camera = own_camera(c);
  asking.say_all(failed, c.document.scene());
  for (const Target& read : asking.read) a.read.push_back(read.object.index);
  std::sort(a.read.begin(), a.read.end());
  a.read.erase(std::unique(a.read.begin(), a.read.end()), a.read.end());
  a.problems = std::move(asking.problems);
  return a;
}

Asking::Deferred Asking::deferred_answer(const Question& q, Time t) const {
  if (!deferred || !open.empty() || (t != deferred->time() && deferred->quick(q))) return {};
  return {true, deferred->answer(q)};
}

}  // namespace betwixt
