// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "program/environment_set.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <functional>
#include <limits>
#include <ranges>
#include <tuple>

namespace betwixt {

using environments::Block;
using environments::Form;
using environments::lanes;
using environments::Row;

// A motion that is applied every `interval` ticks from `tick` on, for good.
struct EnvironmentSet::Steady {
  std::size_t member = 0;
  std::int64_t tick = 0, interval = 1;
  Form form = Form::translation;
  std::int64_t safe = 0;  // the last step at which A is not near Power::bound
  const Power* power = nullptr;

  std::int64_t phase() const { return (tick % interval + interval) % interval; }
  // A = M^(step - first)
  std::int64_t first() const { return (tick - phase()) / interval - 1; }
  auto group() const { return std::tuple(interval, phase(), form); }
};

namespace {

constexpr std::uint32_t nobody = std::numeric_limits<std::uint32_t>::max();
constexpr std::int64_t horizon = 2 * Environment::furthest;  // as for environments
constexpr std::size_t cache = std::size_t{4} << 20;          // bytes; what is larger hardly stays in one
constexpr double large = 1e-2 * Power::bound;                // so far no number is held at the bound

std::int64_t step_at(std::int64_t tick, std::int64_t interval, std::int64_t phase) {
  const std::int64_t steps = (tick - phase) / interval;
  return steps * interval > tick - phase ? steps - 1 : steps;
}

std::size_t blocks_for(std::size_t count) { return (count + lanes - 1) / lanes; }
double largest(Vec3 v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

// Nothing for what is not of any form.
std::optional<Form> form_of(const Power& power) {
  const Power::Similarity& f = power.similarity();
  if (power.kind() == Power::Kind::identity || power.kind() == Power::Kind::translation) return Form::translation;
  if (power.kind() == Power::Kind::general || f.mirrored || !f.centred) return std::nullopt;
  if (f.scale != 1) return Form::similarity;
  return f.centre == Vec3{} && f.advance == 0 ? Form::spin : Form::screw;
}

double rise(const Power::Similarity& f) { return f.scale == 1 ? f.advance : f.advance / std::expm1(f.log_scale); }

// How often the motion can be applied, counted low, until a number of A comes near the bound; below 1: it is there.
double safe_powers(const Power& power, Form form) {
  const Power::Similarity& f = power.similarity();
  if (form == Form::spin) return large;
  if (form == Form::translation) return large / (1 + largest(f.slide));
  const double reach = 1 + 4 * largest(f.centre) + std::abs(rise(f));
  if (form == Form::screw) return (large - 4 * largest(f.centre)) / (1 + std::abs(f.advance));
  if (reach > large) return 0;
  return f.log_scale < 0 ? large : std::log(large / reach) / f.log_scale;
}

void fill(const Power& power, Form form, std::int64_t first, Row* rows, std::size_t lane) {
  const auto put = [&](double x) { (rows++)->of[lane] = x; };
  const auto put_vector = [&](Vec3 v) { put(v.x), put(v.y), put(v.z); };
  const Power::Similarity& f = power.similarity();
  put(std::bit_cast<double>(first));
  if (form == Form::translation) return put_vector(f.slide);
  put(std::bit_cast<double>(f.turns));
  put_vector(f.axis);
  if (form == Form::spin) return;
  put_vector(f.centre);
  put(rise(f));
  if (form == Form::similarity) put(f.log_scale);
}

}  // namespace

// ---- Making

std::optional<EnvironmentSet::Steady> EnvironmentSet::steady(const Member& m, std::size_t index) {
  const Environment& e = *m.environment;
  if (e.size() != 1 || m.generation != 0) return std::nullopt;
  const auto* a = std::get_if<EnvironmentEvent::Animate>(&e.event(0).what);
  if (!a || a->until || a->timing.change != 0 || a->timing.interval > Pace::largest) return std::nullopt;
  const std::int64_t tick = e.event(0).tick + a->from.value_or(0);
  const Environment::Span* span = e.span(0, tick);
  if (!span || !span->running) return std::nullopt;
  const std::optional<Form> form = form_of(span->motion->power);
  if (!form) return std::nullopt;
  const double powers = safe_powers(span->motion->power, *form);
  if (!(powers >= 1)) return std::nullopt;
  Steady s{index, tick, a->timing.interval, *form, 0, &span->motion->power};
  s.safe = s.first() + static_cast<std::int64_t>(powers);
  return s;
}

EnvironmentSet::EnvironmentSet(std::vector<Member> members) : members_(std::move(members)), slot_of_(members_.size()) {
  assert(members_.size() < nobody / lanes && "slots are counted in 32 bits");
  std::vector<Steady> all;
  for (std::size_t i = 0; i < members_.size(); ++i) {
    if (const auto s = steady(members_[i], i))
      all.push_back(*s);
    else
      others_.push_back({i, {}});
  }
  std::sort(all.begin(), all.end(), [](const Steady& a, const Steady& b) {
    return std::tuple(a.group(), a.safe, a.member) < std::tuple(b.group(), b.safe, b.member);
  });
  const auto end_of = [&](Iterator first) {
    return std::find_if(first, all.cend(), [&](const Steady& s) { return s.group() != first->group(); });
  };
  std::size_t blocks = 0, rows = 0;
  for (auto first = all.cbegin(); first != all.cend(); first = end_of(first)) {
    const std::size_t more = blocks_for(static_cast<std::size_t>(end_of(first) - first));
    blocks += more;
    rows += more * environments::rows(first->form);
  }
  blocks_.reserve(blocks);
  rows_.reserve(rows);
  member_at_.reserve(blocks * lanes + others_.size());
  for (auto first = all.cbegin(); first != all.cend(); first = end_of(first)) add_group(first, end_of(first));
  for (std::size_t i = 0; i < others_.size(); ++i) {
    slot_of_[others_[i].member] = static_cast<std::uint32_t>(steady_slots() + i);
    member_at_.push_back(static_cast<std::uint32_t>(others_[i].member));
  }
  large_ = blocks_.size() * sizeof(Block) > cache;
  seek(-horizon);
}

void EnvironmentSet::add_group(Iterator first, Iterator last) {
  const auto count = static_cast<std::size_t>(last - first);
  const std::size_t height = environments::rows(first->form), slots = blocks_for(count) * lanes;
  Group g{first->interval, first->phase(), first->tick,  first->safe,
          blocks_.size(),  slots / lanes,  rows_.size(), first->form};
  Block identity;
  for (std::size_t i : {0, 5, 10}) identity.m[i].fill(1);
  blocks_.resize(blocks_.size() + g.blocks, identity);
  rows_.resize(rows_.size() + g.blocks * height);
  member_at_.resize(member_at_.size() + slots, nobody);
  for (std::size_t i = 0; i < count; ++i) {
    const Steady& s = first[static_cast<std::ptrdiff_t>(i)];
    const std::size_t slot = g.first * lanes + i;
    g.begin = std::min(g.begin, s.tick);
    fill(*s.power, s.form, s.first(), &rows_[g.rows + i / lanes * height], i % lanes);
    slot_of_[s.member] = static_cast<std::uint32_t>(slot);
    member_at_[slot] = static_cast<std::uint32_t>(s.member);
  }
  groups_.push_back(g);
}

// ---- Where things are

std::optional<std::size_t> EnvironmentSet::member(std::size_t slot) const {
  return member_at_[slot] == nobody ? std::nullopt : std::optional<std::size_t>(member_at_[slot]);
}

Mat4 EnvironmentSet::matrix(std::size_t member) const {
  const std::size_t slot = slot_of_[member];
  if (slot >= steady_slots()) return others_[slot - steady_slots()].matrix;
  const Block& b = blocks_[slot / lanes];
  Mat4 a;
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 4; ++c) a(r, c) = b.m[static_cast<std::size_t>(4 * r + c)][slot % lanes];
  return a;
}

EnvironmentSet::Range EnvironmentSet::slots_of(std::size_t what) const {
  if (what >= groups_.size()) {
    const std::size_t slot = steady_slots() + what - groups_.size();
    return {slot, slot + 1};
  }
  const Group& g = groups_[what];
  return {g.first * lanes, (g.first + g.blocks) * lanes};
}

// ---- Going

void EnvironmentSet::evaluate(std::size_t what) {
  if (what < groups_.size()) return evaluate(groups_[what]);
  Other& o = others_[what - groups_.size()];
  o.matrix = members_[o.member].environment->at(members_[o.member].generation, tick_);
}

void EnvironmentSet::evaluate(const Group& g) {
  const std::int64_t step = step_at(tick_, g.interval, g.phase);
  environments::evaluate(g.form, step, &rows_[g.rows], g.blocks, &blocks_[g.first], large_);
  if (step > g.safe) hold_bounds(g, step);
}

// The members of a group stand in the order in which they come near the bound.
void EnvironmentSet::hold_bounds(const Group& g, std::int64_t step) {
  const auto slots = std::views::iota(g.first * lanes, (g.first + g.blocks) * lanes);
  const auto end = std::ranges::partition_point(slots, [&](std::size_t slot) {
    const auto m = member(slot);
    return m && steady(members_[*m], *m)->safe < step;
  });
  for (std::size_t slot : std::ranges::subrange(slots.begin(), end)) {
    const Member& m = members_[member_at_[slot]];
    const Mat4 a = m.environment->at(m.generation, tick_);
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 4; ++c) blocks_[slot / lanes].m[static_cast<std::size_t>(4 * r + c)][slot % lanes] = a(r, c);
  }
}

std::optional<std::int64_t> EnvironmentSet::due(std::size_t what, std::int64_t tick) const {
  if (what >= groups_.size()) {
    const Member& m = members_[others_[what - groups_.size()].member];
    const auto next = m.environment->next_due(tick);
    const auto then = next ? m.environment->generation_at(*next) : std::nullopt;
    return then && *then > m.generation ? std::nullopt : next;  // killed: nothing of it will change any more
  }
  const Group& g = groups_[what];
  if (tick < g.begin) return g.begin;
  const std::int64_t next = (step_at(tick, g.interval, g.phase) + 1) * g.interval + g.phase;
  return next > horizon ? std::nullopt : std::optional(next);
}

void EnvironmentSet::seek(std::int64_t tick) {
  tick_ = std::clamp(tick, -horizon, horizon);
  queue_.clear();
  for (std::size_t what = 0; what < things(); ++what) {
    evaluate(what);
    if (const auto next = due(what, tick_)) queue_.push_back({*next, what});
  }
  std::make_heap(queue_.begin(), queue_.end(), std::greater<>());
  environments::settle();
}

void EnvironmentSet::touch(Range r) {
  if (!changed_.empty() && changed_.back().end == r.begin)
    changed_.back().end = r.end;
  else
    changed_.push_back(r);
}

std::span<const EnvironmentSet::Range> EnvironmentSet::advance(std::int64_t tick) {
  tick = std::clamp(tick, -horizon, horizon);
  changed_.clear();
  if (tick < tick_) {
    seek(tick);
    touch({0, slots()});
    return changed_;
  }
  tick_ = tick;
  while (!queue_.empty() && queue_.front().tick <= tick) {
    std::pop_heap(queue_.begin(), queue_.end(), std::greater<>());
    const std::size_t what = queue_.back().what;
    queue_.pop_back();
    evaluate(what);
    touch(slots_of(what));
    if (const auto next = due(what, tick)) {
      queue_.push_back({*next, what});
      std::push_heap(queue_.begin(), queue_.end(), std::greater<>());
    }
  }
  environments::settle();
  return changed_;
}

std::optional<std::int64_t> EnvironmentSet::next_due(std::int64_t tick) const {
  tick = std::clamp(tick, -horizon, horizon);
  if (tick == tick_) return queue_.empty() ? std::nullopt : std::optional(queue_.front().tick);
  std::optional<std::int64_t> first;
  for (std::size_t what = 0; what < things(); ++what)
    if (const auto next = due(what, tick); next && (!first || *next < *first)) first = next;
  return first;
}

}  // namespace betwixt
