// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "program/evaluator.h"

#include <algorithm>
#include <bit>
#include <cstring>

#include "program/placing.h"

namespace betwixt {
namespace {

template <class T>
bool same_bits(const T& a, const T& b) {
  return std::memcmp(&a, &b, sizeof(T)) == 0;
}

Material material_of(const std::string& word) {
  return word == "matte"   ? Material::matte
         : word == "metal" ? Material::metal
         : word == "glow"  ? Material::glow
                           : Material::plastic;
}

}  // namespace

Evaluator::Evaluator(const Program::Compiled& compiled)
    : compiled_(compiled),
      numbers_(compiled.rest),
      asked_(compiled.schedule.sources.size()),
      playing_(compiled.schedule.sources.size()),
      dirty_(compiled.nodes.size()),
      held_(compiled.nodes.size()),
      parent_(compiled.nodes.size(), -1),
      products_(compiled.sitings.size()),
      own_(compiled.nodes.size()),
      placed_(compiled.nodes.size()),
      around_(compiled.sited ? compiled.nodes.size() : 0) {
  for (std::size_t i = 0; i < playing_.size(); ++i) {
    const Schedule::Source& s = compiled.schedule.sources[i];
    if (s.what != Schedule::Source::curve) continue;
    const CurveUse& use = compiled.curves[s.index];
    playing_[i] = {{}, use.offset, s.node, use.curve.channels, s.affects, use.bounded};
  }
  const std::size_t drawables = compiled.drawables.size();
  worlds.resize(drawables), looks.resize(drawables);
  forms_.resize(drawables), stale_.assign(drawables, true), renewed_.resize(drawables), flagged_.resize(drawables);
}

void Evaluator::mark(std::uint32_t node, std::uint8_t what) {
  if (dirty_[node] == 0) marked_.push_back(node);
  dirty_[node] |= what;
}

void Evaluator::flag(std::uint32_t drawable) {
  if (flagged_[drawable]) return;
  flagged_[drawable] = true;
  changed.push_back(drawable);
}

void Evaluator::touch(std::uint32_t source, std::int64_t t) {
  if (asked_[source] == turn_) return;
  asked_[source] = turn_;
  due_.push_back(source);
  if (const Activity* now = compiled_.schedule.active(compiled_.schedule.sources[source], t))
    active_.push_back({source, *now});
}

// The sources that may say something else at `t` than they did; and which go on changing then.
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
      if (a.now.from <= t && t < a.now.until)
        active_[kept++] = a;
      else if (const Activity* now = s.active(s.sources[a.source], t))
        active_[kept++] = {a.source, *now};
    }
    active_.resize(kept);
    for (auto e = first; e != last; ++e) touch(e->source, t);
  }
}

void Evaluator::evaluate(std::uint32_t i, std::int64_t t) {
  if (playing_[i].channels > 0) return evaluate_curve(i, t);
  const Schedule::Source& s = compiled_.schedule.sources[i];
  if (s.what == Schedule::Source::siting) tick_ = INT64_MIN;  // its environments are others now
  if (s.what == Schedule::Source::attachment) {
    const CompiledSpan* held = compiled_.span(compiled_.nodes[s.node], {t});
    if (held == held_[s.node]) return;
    held_[s.node] = held;
    rearrange_ = true;
  }
  mark(s.node, s.affects);
}

void Evaluator::evaluate_curve(std::uint32_t i, std::int64_t t) {
  Playing& p = playing_[i];
  CubicSegment& g = p.segment;
  const auto use = [&]() -> const CurveUse& { return compiled_.curves[compiled_.schedule.sources[i].index]; };
  double n[4];
  if ((g.from <= t && t < g.until) || compiled_.set.cubic(use().curve, t, g)) {
    const double part = static_cast<double>(t - g.from) / g.length;
    for (std::uint32_t c = 0; c < p.channels; ++c) n[c] = g.channels[c].at(part);
    if (p.bounded) use().bound(n);
  } else {
    compiled_.evaluate(use(), {t}, n);
  }
  std::uint64_t other = 0;  // bits that differ
  for (std::uint32_t c = 0; c < p.channels; ++c) {
    double& was = numbers_[p.offset + c];
    other |= std::bit_cast<std::uint64_t>(was) ^ std::bit_cast<std::uint64_t>(n[c]);
    was = n[c];
  }
  if (other != 0) mark(p.node, p.affects);
}

void Evaluator::evaluate_lives(Asking& asking, bool solids) {
  for (const Schedule::LiveSource& live : compiled_.schedule.lives) {
    if (solids && !live.solid) continue;
    if (live.binding->channels == 0) {
      mark(live.node, live.affects);
      continue;
    }
    double n[4];
    std::copy_n(&compiled_.rest[live.binding->offset], 4, n);
    compiled_.evaluate(*live.binding, now_, asking, n);
    if (std::memcmp(n, &numbers_[live.binding->offset], sizeof n) == 0) continue;
    std::memcpy(&numbers_[live.binding->offset], n, sizeof n);
    mark(live.node, live.affects);
  }
}

// Between ticks environments stand still.
void Evaluator::environments(bool own_set) {
  if (compiled_.sitings.empty()) return;
  const Scene& scene = compiled_.document.scene();
  const std::int64_t tick = scene.smooth_ticks ? now_.flicks : scene.ticks.whole(now_);
  if (tick == tick_) return;
  tick_ = tick;
  if (compiled_.many && own_set) {
    if (!many_) {
      const std::lock_guard lock(compiled_.many_in_use);
      many_ = compiled_.many;
    }
    if (many_->tick() != tick) many_->advance(tick);
  }
  for (std::uint32_t i = 0; i < compiled_.nodes.size(); ++i)
    for (const std::int32_t siting : {compiled_.nodes[i].around, compiled_.nodes[i].drive}) {
      if (siting < 0) continue;
      const Mat4 m = compiled_.product(siting, now_, many_ ? &*many_ : nullptr);
      if (!fresh_ && same_bits(m, products_[static_cast<std::size_t>(siting)])) continue;
      products_[static_cast<std::size_t>(siting)] = m;
      mark(i, affects::place);
    }
}

void Evaluator::stay() {
  for (const std::uint32_t d : changed) flagged_[d] = false;
  changed.clear();
}

void Evaluator::to(Time t, Asking& asking, bool solids) {
  stay();
  collect(t.flicks);
  if (fresh_)
    for (std::uint32_t i = 0; i < compiled_.nodes.size(); ++i) {
      held_[i] = compiled_.span(compiled_.nodes[i], t);
      mark(i, affects::all);
    }
  now_ = t;
  for (const std::uint32_t i : due_) evaluate(i, t.flicks);
  evaluate_lives(asking, solids);
  environments(!solids);
  places(asking);
  restyle(asking, solids);
  for (const std::uint32_t i : marked_) dirty_[i] = 0;
  marked_.clear();
  if (fresh_)
    for (std::uint32_t d = 0; d < worlds.size(); ++d) flag(d);
  fresh_ = false;
  sort_numbers(changed);
}

// The looks of marked drawables, and of those that borrow a marked one's form.
void Evaluator::restyle(Asking& asking, bool solids) {
  bool borrowed = false;
  for (const std::uint32_t i : marked_) {
    const std::int32_t d = compiled_.nodes[i].drawable;
    if (d < 0 || !(dirty_[i] & affects::form)) continue;
    stale_[static_cast<std::size_t>(d)] = true;
    borrowed = true;
  }
  if (borrowed)
    for (const std::uint32_t d : compiled_.borrowers) mark(compiled_.drawables[d].node, affects::form);
  for (const std::uint32_t i : marked_)
    if (const std::int32_t d = compiled_.nodes[i].drawable; d >= 0 && (dirty_[i] & (affects::look | affects::form)))
      look(static_cast<std::uint32_t>(d), asking, solids);
}

// The form of a drawable for now: a number.
std::uint32_t Evaluator::form(std::uint32_t drawable, Asking& asking) {
  const Drawable& d = compiled_.drawables[drawable];
  if (d.shape < compiled_.shapes.size()) return d.shape;
  if (stale_[drawable]) {
    stale_[drawable] = false;
    auto made = compiled_.shape(compiled_.nodes[d.node].object, now_, numbers_.data(), asking);
    if (!forms_[drawable] || !(*forms_[drawable] == made)) {
      forms_[drawable] = std::make_shared<const Shape>(std::move(made));
      renewed_[drawable] = turn_;
    }
  }
  return d.shape;
}

// Its own, or that of another object.
std::uint32_t Evaluator::shape_of(const Value& v, std::uint32_t drawable, Asking& asking) {
  const ObjectId other = std::get<ObjectId>(v);
  const Object* o = find_object(compiled_.document.scene(), other);
  if (!o || !betwixt::drawable(o->kind)) return form(drawable, asking);
  return form(static_cast<std::uint32_t>(compiled_.nodes[compiled_.node_of[other.index]].drawable), asking);
}

void Evaluator::look(std::uint32_t i, Asking& asking, bool solids) {
  const Drawable& d = compiled_.drawables[i];
  const Node& n = compiled_.nodes[d.node];
  Looks now;
  now.visible = numbers_[n.display] != 0;
  if (now.visible) {
    const Binding& geometry = *d.geometry;
    if (geometry.steps < 0) {
      now.shape = shape_of(compiled_.value(geometry, now_, asking), i, asking);
    } else {
      const Between b = compiled_.between(geometry, now_);
      const auto values = compiled_.steps_of(geometry).values();
      now.shape = shape_of(values[b.a], i, asking);
      if (b.a != b.b && b.s != 0) now.toward = shape_of(values[b.b], i, asking), now.blend = b.s;
    }
    if (!solids) {
      now.color = vec3(&numbers_[n.color]);
      now.transparency = std::clamp(numbers_[d.transparency], 0.0, 1.0);
      now.shininess = std::clamp(numbers_[d.shininess], 0.0, 1.0);
      now.material = material_of(*std::get<Text>(compiled_.value(*d.material, now_, asking)));
      const auto& pictures = *compiled_.document.scene().pictures;
      const auto picture = pictures.find(*std::get<Text>(compiled_.value(*d.texture, now_, asking)));
      if (picture != pictures.end()) now.texture = static_cast<std::uint32_t>(std::distance(pictures.begin(), picture));
    }
  }
  // Whoever borrows a form that is new differs too.
  const auto renewed = [&](std::uint32_t shape) {
    return shape != nothing && shape >= compiled_.shapes.size() && renewed_[shape - compiled_.shapes.size()] == turn_;
  };
  if (!(now == looks[i]) || renewed(now.shape) || renewed(now.toward)) flag(i);
  looks[i] = now;
}

}  // namespace betwixt
