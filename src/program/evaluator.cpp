// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "program/evaluator.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <numeric>

#include "base/stages.h"
#include "program/deferred_evaluation.h"
#include "program/placing.h"
#include "program/splined.h"

namespace betwixt {
namespace {

template <class T>
bool same_bits(const T& a, const T& b) {
  return std::memcmp(&a, &b, sizeof(T)) == 0;
}

}  // namespace

Evaluator::Evaluator(const Program::Compiled& compiled, const DeferredEvaluation* deferred)
    : compiled_(compiled),
      deferred_(deferred),
      numbers_(compiled.rest),
      segments_(compiled.schedule.sources.size()),
      asked_(compiled.schedule.sources.size()),
      marks_(compiled.nodes.size()),
      held_(compiled.nodes.size()),
      by_code_(compiled.held_by_code.size()),
      parent_(compiled.nodes.size(), -1),
      products_(compiled.sitings.size()),
      turned_(compiled.sitings.size()),
      owns_(compiled.spans.empty() && !compiled.looks ? 0 : compiled.nodes.size()),
      worlds_(compiled.nodes.size()),
      turns_(compiled.turning ? compiled.nodes.size() : 0),
      around_(compiled.sited ? compiled.nodes.size() : 0),
      shown_(compiled.sited ? compiled.drawables.size() : 0),
      flags_(compiled.nodes.size()) {
  numbers_.resize(numbers_.size() + 4);  // because they are written four at a time
  for (std::size_t i = 0; i < segments_.size(); ++i) {
    const Schedule::Source& s = compiled.schedule.sources[i];
    if (s.what != Schedule::Source::curve) continue;
    const CurveUse& use = compiled.curves[s.index];
    segments_[i].offset = use.offset, segments_[i].node = s.node;
    segments_[i].channels = use.curve.channels, segments_[i].affects = s.affects, segments_[i].bounded = use.bounded;
  }
  const std::size_t drawables = compiled.drawables.size();
  const std::size_t forms = compiled.slow_blends.empty() && !compiled.matching ? 2 * drawables : 3 * drawables;
  looks.resize(drawables), forms_.resize(forms), stale_.assign(drawables, true), renewed_.resize(forms);
}

void Evaluator::touch(std::uint32_t source, std::int64_t t) {
  if (playing::Segment& s = segments_[source]; s.channels > 0) {
    if (!s.listed) curves_.push_back(source);
    s.listed = true;
    return;
  }
  if (asked_[source] == turn_) return;
  asked_[source] = turn_;
  due_.push_back(source);
  if (const Activity* now = compiled_.schedule.active(compiled_.schedule.sources[source], t))
    active_.push_back({source, *now});
}

// Collects the sources that may have changed by `t`, and those that are changing at `t`.
void Evaluator::collect(std::int64_t t) {
  const Schedule& s = compiled_.schedule;
  if (++turn_ == 0)
    std::fill(asked_.begin(), asked_.end(), 0), std::fill(renewed_.begin(), renewed_.end(), 0), turn_ = 1;
  due_.clear();
  const auto time = [](const Schedule::Edge& e, std::int64_t x) { return e.time < x; };
  const auto behind = [](std::int64_t x, const Schedule::Edge& e) { return x < e.time; };
  const std::int64_t now = now_.flicks;
  const auto& edges = t > now ? s.begins : s.ends;
  const auto first = t > now ? std::upper_bound(edges.begin(), edges.end(), now, behind)
                             : std::lower_bound(edges.begin(), edges.end(), t, time);
  const auto last = std::upper_bound(first, edges.end(), std::max(t, now), behind);
  if (fresh_ || static_cast<std::size_t>(last - first) + active_.size() > s.sources.size()) {
    active_.clear();
    for (std::uint32_t i = 0; i < s.sources.size(); ++i) touch(i, t);
  } else {
    std::size_t kept = 0;
    for (const Active& a : active_) {
      asked_[a.source] = turn_;
      due_.push_back(a.source);
      if (a.now.has(t))
        active_[kept++] = a;
      else if (const Activity* now = s.active(s.sources[a.source], t))
        active_[kept++] = {a.source, *now};
    }
    active_.resize(kept);
    for (auto e = first; e != last; ++e) touch(e->source, t);
  }
}

void Evaluator::evaluate(std::uint32_t i, std::int64_t t) {
  const Schedule::Source& s = compiled_.schedule.sources[i];
  if (s.what == Schedule::Source::siting) tick_ = INT64_MIN;  // its environments have changed
  if (s.what == Schedule::Source::attachment) {
    const CompiledSpan* held = compiled_.span(compiled_.nodes[s.node], {t});
    if (held == held_[s.node]) return;
    held_[s.node] = held;
    rearrange_ = true;
  }
  marks_.add(s.node, s.affects);
}

// Evaluates the changing curves, most of which are still in the same segment. The others find theirs in three steps,
// each some curves ahead of the next, because each waits for memory.
void Evaluator::play(std::int64_t t) {
  left_.resize(curves_.size());
  left_.resize(playing::play(segments_.data(), curves_, t, numbers_.data(), marks_, left_.data()));
  bool ended = false;
  constexpr std::size_t ahead = 12;
  const std::size_t count = left_.size();
  events_.resize(count);
  const std::vector<CurveEvents>& all = compiled_.schedule.events;
  const auto searches = [&](std::uint32_t i) { return !segments_[i].has(t) && all[i].has(t); };
  for (std::size_t k = 0; k < count + 2 * ahead; ++k) {
    if (k < count)
      if (const std::uint32_t i = curves_[left_[k]]; searches(i)) events_[k] = all[i].guess(t, segments_[i]);
    if (const std::size_t at = k - ahead; k >= ahead && at < count)
      if (const std::uint32_t i = curves_[left_[at]]; searches(i)) events_[at] = all[i].find(t, events_[at]);
    if (k < 2 * ahead) continue;
    std::uint32_t& source = curves_[left_[k - 2 * ahead]];
    if (seek(source, t, events_[k - 2 * ahead])) continue;
    segments_[source].listed = false;
    source = nothing;
    ended = true;
  }
  if (ended) std::erase(curves_, nothing);
}

// Takes the segment of a curve that has left its old one: that of event k, if the curve is plain. Returns true if the
// curve is changing at `t`.
bool Evaluator::seek(std::uint32_t i, std::int64_t t, std::uint32_t k) {
  playing::Segment& s = segments_[i];
  const Schedule& schedule = compiled_.schedule;
  const CurveEvents& events = schedule.events[i];
  const auto use = [&]() -> const CurveUse& { return compiled_.curves[schedule.sources[i].index]; };
  const bool plain = events.has(t);
  if (!plain && !s.active.has(t)) {
    const Activity* now = schedule.active(schedule.sources[i], t);
    s.active = now ? *now : Activity{};
  }
  if (deferred_ && use().coded) return plain ? schedule.active(schedule.sources[i], t) != nullptr : s.active.has(t);
  double n[4];
  bool changes = false;
  if (s.has(t) || (plain ? events.cubic(k, s) : compiled_.set.cubic(use().curve, t, s))) {
    const double share = s.share(t);
    for (std::uint32_t c = 0; c < s.channels; ++c) n[c] = s.at(c, share);
    if (s.bounded) use().bound(n);
    changes = plain && s.moves;
  } else {
    compiled_.evaluate_curve(use(), {t}, n);
    changes = plain;
  }
  std::uint64_t other = 0;  // bits that differ
  for (std::uint32_t c = 0; c < s.channels; ++c) {
    double& was = numbers_[s.offset + c];
    other |= std::bit_cast<std::uint64_t>(was) ^ std::bit_cast<std::uint64_t>(n[c]);
    was = n[c];
  }
  if (other != 0) marks_.add(s.node, s.affects);
  return plain ? changes : s.active.has(t);
}

void Evaluator::evaluate_lives(Asking& asking, bool solids) {
  const InStage stage(Stage::procedures);
  for (const Schedule::LiveSource& live : compiled_.schedule.lives) {
    const FunctionId f = live.binding->function;
    if (f == fn::attachment || f == fn::motion || f == fn::environments || f == fn::drive) continue;  // read elsewhere
    if (solids && !live.solid) continue;
    if (!only_ || only_->wants(live)) evaluate(live, asking);
  }
}

// Evaluates the tracks with coded twerpers. Without deferred evaluation they are evaluated like all others.
void Evaluator::evaluate_coded(Asking& asking) {
  const InStage stage(Stage::procedures);
  if (!deferred_) return;
  for (const Schedule::LiveSource& coded : compiled_.schedule.coded)
    if (!only_ || only_->wants(coded)) evaluate(coded, asking);
}

void Evaluator::evaluate(const Schedule::LiveSource& live, Asking& asking) {
  if (live.binding->channels == 0) return marks_.add(live.node, live.affects);
  double n[4];
  std::copy_n(&compiled_.rest[live.binding->offset], 4, n);
  compiled_.evaluate(*live.binding, now_, asking, n);
  if (std::memcmp(n, &numbers_[live.binding->offset], sizeof n) == 0) return;
  std::memcpy(&numbers_[live.binding->offset], n, sizeof n);
  marks_.add(live.node, live.affects);
}

void Evaluator::stay() {
  flags_.clear();
  changed.clear();
}

void Evaluator::change_all() {
  changed.resize(looks.size());
  std::iota(changed.begin(), changed.end(), 0U);
}

void Evaluator::play_to(Time t) {
  stay();
  collect(t.flicks);
  if (fresh_)
    for (std::uint32_t i = 0; i < compiled_.nodes.size(); ++i) {
      held_[i] = compiled_.span(compiled_.nodes[i], t);
      marks_.add(i, affects::all);
    }
  now_ = t;
  play(t.flicks);
  for (const std::uint32_t i : due_) evaluate(i, t.flicks);
}

void Evaluator::place(Time t, Asking& asking, const Needed& wanted) {
  only_ = &wanted;
  play_to(t);
  evaluate_lives(asking, false);
  evaluate_coded(asking);
  take_hold(asking);
  environments(asking, true);
  places(asking);
  only_ = nullptr;
}

void Evaluator::to(Time t, Asking& asking, bool solids) {
  const InStage stage(Stage::tracks);
  play_to(t);
  evaluate_lives(asking, solids);
  evaluate_coded(asking);
  if (deferred_) {  // an answer may arrive at any time
    for (const std::uint32_t d : compiled_.slow_shapes) marks_.add(d, affects::form);
    for (const std::uint32_t d : compiled_.slow_blends) marks_.add(d, affects::look);
  }
  take_hold(asking);
  environments(asking, !solids);
  places(asking);
  follow_joints();
  restyle(asking, solids);
  marks_.clear();
  const auto drawables = static_cast<std::uint32_t>(looks.size());
  if (fresh_)
    for (std::uint32_t d = 0; d < drawables; ++d) flags_.add(d, true);
  fresh_ = false;
  flags_.in_order(drawables, changed);
}

// Updates the looks of marked drawables, and of those that borrow a marked one's geometry.
void Evaluator::restyle(Asking& asking, bool solids) {
  const InStage stage(Stage::looks);
  mark_pieces();
  bool borrowed = false;
  for (const std::uint32_t d : marks_.all()) {
    if (!compiled_.draws(d) || !(marks_[d] & affects::form)) continue;
    stale_[d] = true;
    borrowed = true;
  }
  if (borrowed)
    for (const std::uint32_t d : compiled_.borrowers) marks_.add(d, affects::form);
  for (const std::uint32_t d : marks_.all())
    if (compiled_.draws(d) && (marks_[d] & (affects::look | affects::form))) look(d, asking, solids);
}

// Returns the number of the drawable's present shape.
std::uint32_t Evaluator::form(std::uint32_t drawable, Asking& asking) {
  const Drawable& d = compiled_.drawables[drawable];
  const bool deferred = deferred_ && d.slow >= 0;
  if (d.shape < compiled_.shapes.size() && !deferred) return d.shape;
  if (stale_[drawable]) {
    stale_[drawable] = false;
    return put(drawable, made(drawable, asking));
  }
  return static_cast<std::uint32_t>(compiled_.shapes.size()) + drawable;
}

// Returns the number of the shape, which is now the form at this index.
std::uint32_t Evaluator::put(std::size_t form, std::shared_ptr<const Shape> shape) {
  auto& was = forms_[form];
  if (!was || (was != shape && !(*was == *shape))) {
    was = std::move(shape);
    renewed_[form] = turn_;
  }
  return static_cast<std::uint32_t>(compiled_.shapes.size() + form);
}

// Makes the drawable's shape. A slow shape without an answer has no points.
std::shared_ptr<const Shape> Evaluator::made(std::uint32_t drawable, Asking& asking) const {
  const Drawable& d = compiled_.drawables[drawable];
  const Node& n = compiled_.nodes[drawable];
  Shape shape;
  shape.kind = n.kind;
  if (deferred_ && d.slow >= 0) {
    const Answer* known = deferred_->answer({Question::shape, static_cast<std::uint32_t>(d.slow)});
    if (!known || !known->shape) return std::make_shared<const Shape>(std::move(shape));
    asking.say_all(*known);
    return known->shape;
  }
  shape = compiled_.shape(n.object, now_, numbers_.data(), asking);
  if (d.skin >= 0) shape.mesh = posed(d.skin);
  return std::make_shared<const Shape>(std::move(shape));
}

// Returns the shape number of the object that `v` names, or the drawable's own.
std::uint32_t Evaluator::shape_of(const Value& v, std::uint32_t drawable, Asking& asking) {
  const ObjectId other = std::get<ObjectId>(v);
  const Object* o = find_object(compiled_.document.scene(), other);
  if (!o || !betwixt::drawable(o->kind)) return form(drawable, asking);
  return form(compiled_.node_of[other.index], asking);
}

// Returns the number of a shape on a spline through shapes of one topology, or `nothing` if they differ in topology.
std::uint32_t Evaluator::splined(const StepTrack& track, const Between& w, std::uint32_t drawable, Asking& asking) {
  auto sum = betwixt::splined(track, w, [&](const Value& v) { return shape(shape_of(v, drawable, asking)); });
  if (!sum) return nothing;
  if (sum->one) return shape_of(*sum->one, drawable, asking);
  return put(looks.size() + drawable, std::make_shared<const Shape>(*std::move(sum->sum)));
}

// Sets the shapes by the answer, if blending them may take long. Without an answer nothing is blended.
bool Evaluator::take_blend(std::uint32_t drawable, Looks& now, Asking& asking) {
  const Drawable& d = compiled_.drawables[drawable];
  if (!deferred_ || d.blend < 0) return false;
  const Question question{Question::blend, static_cast<std::uint32_t>(d.blend)};
  if (!may_take_long(compiled_, question, now_)) return false;
  const Answer* const known = deferred_->answer(question);
  if (!known || !known->shape) {
    const LinearTwerpers plain;
    const StepTrack& track = compiled_.steps_of(*d.geometry);
    now.shape = shape_of(track.values()[track.at(now_, compiled_.set).a], drawable, asking);
    return true;
  }
  asking.say_all(*known);
  now.shape = put(looks.size() + drawable, known->shape);
  if (known->toward) now.toward = put(2 * looks.size() + drawable, known->toward), now.blend = known->blend;
  return true;
}

// Sets the shape and the blend.
void Evaluator::take_shape(std::uint32_t i, Looks& now, Asking& asking) {
  const Binding& geometry = *compiled_.drawables[i].geometry;
  if (geometry.steps < 0) {
    now.shape = shape_of(compiled_.value(geometry, now_, asking), i, asking);
    take_match(i, now, asking);
    return;
  }
  if (take_blend(i, now, asking)) return;
  const Between b = compiled_.between(geometry, now_, asking);
  const auto values = compiled_.steps_of(geometry).values();
  if (b.a != b.b && b.splines) now.shape = splined(compiled_.steps_of(geometry), b, i, asking);
  if (now.shape != nothing) return;
  now.shape = shape_of(values[b.a], i, asking);
  if (b.a != b.b && b.s != 0) now.toward = shape_of(values[b.b], i, asking), now.blend = b.s;
}

void Evaluator::look(std::uint32_t i, Asking& asking, bool solids) {
  const Drawable& d = compiled_.drawables[i];
  const Node& n = compiled_.nodes[i];
  Looks now;
  bool refinished = false, regraded = false;
  const auto whole = static_cast<std::size_t>(d.whole);  // of a part of a formula
  now.visible = numbers_[n.display] != 0 && (d.whole < 0 || numbers_[compiled_.nodes[whole].display] != 0);
  if (now.visible) {
    take_shape(i, now, asking);
    if (!solids) {
      now.color = vec3(&numbers_[n.color]);
      now.transparency = std::clamp(numbers_[d.transparency], 0.0, 1.0);
      if (d.whole >= 0) {
        const double other = std::clamp(numbers_[compiled_.drawables[whole].transparency], 0.0, 1.0);
        now.transparency = 1 - (1 - now.transparency) * (1 - other);
      }
      now.shininess = std::clamp(numbers_[d.shininess], 0.0, 1.0);
      now.casts = numbers_[d.casts] != 0;
      const MaterialRow& made_of = d.made_of ? *d.made_of : material_of(compiled_.value(*d.material, now_, asking));
      now.material = made_of.old;
      now.texture = d.plain ? d.texture_number : texture(d, asking);
      if (d.finish >= 0) refinished = take_finish(i, made_of, now, asking);
      if (d.gradients >= 0) regraded = take_gradients(i, now, asking);
    }
  }
  // A drawable that borrows a new shape changes too.
  const auto renewed = [&](std::uint32_t shape) {
    return shape != nothing && shape >= compiled_.shapes.size() && renewed_[shape - compiled_.shapes.size()] == turn_;
  };
  if (!(now == looks[i]) || refinished || regraded || renewed(now.shape) || renewed(now.toward)) flags_.add(i, true);
  looks[i] = now;
}

}  // namespace betwixt
