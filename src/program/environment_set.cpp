// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "program/environment_set.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <functional>
#include <limits>
#include <thread>
#include <tuple>
#include <utility>

#include "base/in_parallel.h"

namespace betwixt {

using environments::Form;
using environments::lanes;
using environments::Row;
using environments::Run;

// A motion that is applied every `interval` ticks from `tick` on, without end.
struct EnvironmentSet::Steady {
  std::size_t member = 0;
  std::int64_t tick = 0, interval = 1;
  Form form = Form::translation;
  std::size_t major = 0;
  std::int64_t safe = 0;  // the last step at which A is well below Power::bound
  const Power* power = nullptr;

  std::int64_t phase() const { return (tick % interval + interval) % interval; }
  // A = M^(step - first)
  std::int64_t first() const { return (tick - phase()) / interval - 1; }
  std::uint16_t delay() const { return static_cast<std::uint16_t>(first() & 0xffff); }
  auto beat() const { return std::tuple(interval, phase()); }
  auto group() const { return std::tuple(beat(), form, major, first() - delay()); }
};

namespace {

constexpr std::uint32_t nobody = std::numeric_limits<std::uint32_t>::max();
constexpr std::int64_t horizon = 2 * Environment::furthest;  // the same as for environments
constexpr std::size_t cache = std::size_t{4} << 20;          // bytes; a larger set does not fit the caches
constexpr std::size_t most_threads = 8;                      // more would wait for memory
constexpr std::int64_t far = 30;                             // ticks, after which nearly all members are due
constexpr double large = 1e-2 * Power::bound;                // below this, no number is clamped

std::int64_t step_at(std::int64_t tick, std::int64_t interval, std::int64_t phase) {
  const std::int64_t steps = (tick - phase) / interval;
  return steps * interval > tick - phase ? steps - 1 : steps;
}

std::size_t blocks_for(std::size_t count) { return (count + lanes - 1) / lanes; }
double largest(Vec3 v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

// Returns nullopt for a motion of no such form.
std::optional<Form> form_of(const Power& power) {
  const Power::Similarity& f = power.similarity();
  if (power.kind() == Power::Kind::identity || power.kind() == Power::Kind::translation) return Form::translation;
  if (power.kind() == Power::Kind::general || f.mirrored || !f.centred) return std::nullopt;
  if (f.scale != 1) return Form::similarity;
  return f.centre == Vec3{} && f.advance == 0 ? Form::spin : Form::screw;
}

double rise(const Power::Similarity& f) { return f.scale == 1 ? f.advance : f.advance / std::expm1(f.log_scale); }

// Returns a lower bound on the applications before a number of A comes near Power::bound; below 1 if it is there at
// once.
double safe_powers(const Power& power, Form form) {
  const Power::Similarity& f = power.similarity();
  if (form == Form::spin) return large;
  if (form == Form::translation) return large / (1 + largest(f.slide));
  const double reach = 1 + 4 * largest(f.centre) + std::abs(rise(f));
  if (form == Form::screw) return (large - 4 * largest(f.centre)) / (1 + std::abs(f.advance));
  if (reach > large) return 0;
  return f.log_scale < 0 ? large : std::log(large / reach) / f.log_scale;
}

std::size_t major_of(const Power& power, Form form) {
  if (form == Form::translation) return 0;
  const Vec3 a = power.similarity().axis;
  const auto longer = [&](int i, int j) { return std::abs(a[i]) < std::abs(a[j]); };
  return static_cast<std::size_t>(std::max({0, 1, 2}, longer));
}

void fill(const Power::Similarity& f, Form form, std::size_t major, Row* rows, std::size_t lane) {
  const auto put = [&](double x) { (rows++)->of[lane] = x; };
  if (form == Form::translation) return put(f.slide.x), put(f.slide.y), put(f.slide.z);
  // A turn about an axis equals the opposite turn about the opposite axis.
  const int m = static_cast<int>(major), u = (m + 1) % 3, v = (m + 2) % 3;
  const bool back = f.axis[m] < 0;
  const double sign = back ? -1 : 1;
  put(std::bit_cast<double>(back ? 0 - f.turns : f.turns));
  put(sign * f.axis[u]), put(sign * f.axis[v]);
  if (form == Form::spin) return;
  put(f.centre[u]), put(f.centre[v]);
  put(sign * rise(f));
  if (form == Form::similarity) put(f.log_scale);
}

// Calls `work` for each run of consecutive elements with equal keys.
template <class Iterator, class Key, class F>
void for_each_piece(Iterator first, Iterator last, Key key, F&& work) {
  while (first != last) {
    const auto value = std::invoke(key, *first);
    const Iterator end = std::find_if(first, last, [&](const auto& s) { return std::invoke(key, s) != value; });
    work(first, end);
    first = end;
  }
}

}  // namespace

// ---- construction

std::optional<EnvironmentSet::Steady> EnvironmentSet::steady(const Member& m, std::size_t index) {
  const Environment& e = *m.environment;
  if (e.size() != 1 || m.generation != 0) return std::nullopt;
  const auto* a = std::get_if<EnvironmentEvent::Animate>(&e.event(0).what);
  if (!a || a->until || a->timing.change != 0 || a->timing.interval > Pace::largest) return std::nullopt;
  const std::int64_t tick = e.event(0).tick + a->from.value_or(0);
  const Environment::Span* span = e.span(0, tick);
  if (!span || !span->running) return std::nullopt;
  const Power& power = span->motion->power;
  const std::optional<Form> form = form_of(power);
  if (!form) return std::nullopt;
  const double powers = safe_powers(power, *form);
  if (!(powers >= 1)) return std::nullopt;
  Steady s{index, tick, a->timing.interval, *form, major_of(power, *form), 0, &power};
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
  std::size_t blocks = 0, motion_rows = 0, matrix_rows = 0;
  for_each_piece(all.cbegin(), all.cend(), &Steady::group, [&](Iterator first, Iterator last) {
    const std::size_t more = blocks_for(static_cast<std::size_t>(last - first));
    blocks += more;
    motion_rows += more * environments::rows(first->form);
    matrix_rows += more * environments::matrix_rows(first->form);
  });
  blocks_.reserve(blocks);
  motions_.reserve(motion_rows);
  matrices_.reserve(matrix_rows);
  delays_.reserve(blocks);
  safe_.reserve(blocks * lanes);
  member_at_.reserve(blocks * lanes + others_.size());
  for_each_piece(all.cbegin(), all.cend(), &Steady::beat,
                 [&](Iterator first, Iterator last) { add_beat(first, last); });
  for (std::size_t i = 0; i < others_.size(); ++i) {
    slot_of_[others_[i].member] = static_cast<std::uint32_t>(steady_slots() + i);
    member_at_.push_back(static_cast<std::uint32_t>(others_[i].member));
  }
  large_ = matrices_.size() * sizeof(Row) > cache;
  seek(-horizon);
}

void EnvironmentSet::add_beat(Iterator first, Iterator last) {
  Beat b{first->interval, first->phase(), first->tick, groups_.size(), 0};
  for (Iterator s = first; s != last; ++s) b.begin = std::min(b.begin, s->tick);
  for_each_piece(first, last, &Steady::group, [&](Iterator from, Iterator to) { add_group(from, to); });
  b.groups_end = groups_.size();
  beats_.push_back(b);
}

void EnvironmentSet::add_group(Iterator first, Iterator last) {
  const auto count = static_cast<std::size_t>(last - first);
  const std::size_t height = environments::rows(first->form), blocks = blocks_for(count);
  const Group g{
      first->first() - first->delay(), first->safe, blocks_.size(), blocks, motions_.size(), first->major, first->form};
  motions_.resize(g.row + blocks * height);
  delays_.resize(g.block + blocks);
  safe_.resize((g.block + blocks) * lanes, std::numeric_limits<std::int64_t>::max());
  member_at_.resize((g.block + blocks) * lanes, nobody);
  for (std::size_t i = 0; i < count; ++i) {
    const Steady& s = first[static_cast<std::ptrdiff_t>(i)];
    const std::size_t slot = g.block * lanes + i, lane = i % lanes;
    if (lane == 0) {
      blocks_.push_back({static_cast<std::uint32_t>(matrices_.size()), s.form});
      matrices_.resize(matrices_.size() + environments::matrix_rows(s.form));
    }
    fill(s.power->similarity(), s.form, s.major, &motions_[g.row + i / lanes * height], lane);
    delays_[slot / lanes].of[lane] = s.delay();
    safe_[slot] = s.safe;
    slot_of_[s.member] = static_cast<std::uint32_t>(slot);
    member_at_[slot] = static_cast<std::uint32_t>(s.member);
  }
  groups_.push_back(g);
}

// ---- lookup

std::optional<std::size_t> EnvironmentSet::member(std::size_t slot) const {
  return member_at_[slot] == nobody ? std::nullopt : std::optional<std::size_t>(member_at_[slot]);
}

// Visits the elements that may differ from the identity.
template <class Rows, class F>
void EnvironmentSet::for_each_element(Rows& matrices, const Block& b, const F& work) {
  auto row = matrices.begin() + b.row;
  for (int i = 0; environments::turns(b.form) && i < 9; ++i) work(i / 3, i % 3, *row++);
  for (int i = 0; environments::shifts(b.form) && i < 3; ++i) work(i, 3, *row++);
}

Mat4 EnvironmentSet::matrix(std::size_t member) const {
  const std::size_t slot = slot_of_[member];
  if (slot >= steady_slots()) return others_[slot - steady_slots()].matrix;
  Mat4 a;
  for_each_element(matrices_, blocks_[slot / lanes],
                   [&](int r, int c, const Row& row) { a(r, c) = row.of[slot % lanes]; });
  return a;
}

EnvironmentSet::Range EnvironmentSet::slots_of(std::size_t what) const {
  if (what >= beats_.size()) {
    const std::size_t slot = steady_slots() + what - beats_.size();
    return {slot, slot + 1};
  }
  const Group &first = groups_[beats_[what].group], &last = groups_[beats_[what].groups_end - 1];
  return {first.block * lanes, (last.block + last.blocks) * lanes};
}

// ---- evaluation

const Row* EnvironmentSet::motions_of(std::size_t what) const {
  return what < beats_.size() ? &motions_[groups_[beats_[what].group].row] : nullptr;
}

void EnvironmentSet::evaluate(Other& o) {
  o.matrix = members_[o.member].environment->at(members_[o.member].generation, tick_);
}

// Evaluates those of its blocks that are in `blocks`. `then`: the rows read after these.
void EnvironmentSet::evaluate(const Beat& b, Range blocks, const Row* then) {
  const std::int64_t step = step_at(tick_, b.interval, b.phase);
  for (std::size_t i = b.group; i < b.groups_end; ++i) {
    const Group& g = groups_[i];
    const Range part{std::max(g.block, blocks.begin), std::min(g.block + g.blocks, blocks.end)};
    if (part.begin < part.end) evaluate(g, part, step, i + 1 < b.groups_end ? &motions_[groups_[i + 1].row] : then);
  }
}

Run EnvironmentSet::run(const Group& g, std::size_t begin, std::size_t end) {
  if (begin == end) return {};
  const Row* const in = &motions_[g.row + (begin - g.block) * environments::rows(g.form)];
  return {g.form, g.major, &delays_[begin], in, &matrices_[blocks_[begin].row], end - begin};
}

void EnvironmentSet::evaluate(const Group& g, Range blocks, std::int64_t step, const Row* then) {
  // A group's members are sorted by the step at which they come near the bound.
  const std::size_t begin = blocks.begin * lanes;
  std::size_t held = begin;
  if (step > g.safe) {
    const auto at = [&](std::size_t slot) { return safe_.begin() + static_cast<std::ptrdiff_t>(slot); };
    held += static_cast<std::size_t>(std::lower_bound(at(begin), at(blocks.end * lanes), step) - at(begin));
  }
  environments::evaluate(run(g, held / lanes, blocks.end), step - g.first, large_, then);
  if (begin < held) hold(g, {begin, held}, step);
}

void EnvironmentSet::hold(const Group& g, Range slots, std::int64_t step) {
  const std::size_t full = slots.end / lanes, rest = slots.end % lanes;
  if (g.form == Form::similarity) {
    environments::evaluate_held(run(g, slots.begin / lanes, full), step - g.first);
    if (rest == 0) return;
    std::array<Row, environments::matrix_rows(Form::similarity)> some;
    Run last = run(g, full, full + 1);
    Row* const out = std::exchange(last.out, some.data());
    environments::evaluate_held(last, step - g.first);
    for (std::size_t row = 0; row < some.size(); ++row) std::copy_n(some[row].of.begin(), rest, out[row].of.begin());
    return;
  }
  // Few motions come near the bound without growing, so these are evaluated one by one.
  for (std::size_t slot = slots.begin; slot < slots.end; ++slot) {
    const Member& m = members_[member_at_[slot]];
    const Mat4 a = m.environment->at(m.generation, tick_);
    for_each_element(matrices_, blocks_[slot / lanes], [&](int r, int c, Row& row) { row.of[slot % lanes] = a(r, c); });
  }
}

std::optional<std::int64_t> EnvironmentSet::due(std::size_t what, std::int64_t tick) const {
  if (what >= beats_.size()) {
    const Member& m = members_[others_[what - beats_.size()].member];
    const auto next = m.environment->next_due(tick);
    const auto then = next ? m.environment->generation_at(*next) : std::nullopt;
    return then && *then > m.generation ? std::nullopt : next;  // killed: it will not change any more
  }
  const Beat& b = beats_[what];
  if (tick < b.begin) return b.begin;
  const std::int64_t next = (step_at(tick, b.interval, b.phase) + 1) * b.interval + b.phase;
  return next > horizon ? std::nullopt : std::optional(next);
}

void EnvironmentSet::seek(std::int64_t tick) {
  tick_ = std::clamp(tick, -horizon, horizon);
  const std::size_t parts = large_ ? std::clamp<std::size_t>(std::thread::hardware_concurrency(), 1, most_threads) : 1;
  in_parallel(parts, [&](std::size_t part) {
    const std::size_t begin = part * blocks_.size() / parts, end = (part + 1) * blocks_.size() / parts;
    for (std::size_t what = 0; what < beats_.size(); ++what)
      evaluate(beats_[what], {begin, end}, motions_of(std::min(what + 1, beats_.size() - 1)));
    environments::settle();
  });
  for (Other& o : others_) evaluate(o);
  queue_.clear();
  for (std::size_t what = 0; what < things(); ++what)
    if (const auto next = due(what, tick_)) queue_.push_back({*next, what});
  std::make_heap(queue_.begin(), queue_.end(), std::greater<>());
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
  if (tick < tick_ || (large_ && tick - tick_ > far)) {
    seek(tick);
    touch({0, slots()});
    return changed_;
  }
  tick_ = tick;
  due_.clear();
  while (!queue_.empty() && queue_.front().tick <= tick) {
    std::pop_heap(queue_.begin(), queue_.end(), std::greater<>());
    due_.push_back(queue_.back().what);
    queue_.pop_back();
  }
  for (std::size_t i = 0; i < due_.size(); ++i) {
    const std::size_t what = due_[i];
    if (what < beats_.size())
      evaluate(beats_[what], {0, blocks_.size()}, motions_of(due_[std::min(i + 1, due_.size() - 1)]));
    else
      evaluate(others_[what - beats_.size()]);
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
