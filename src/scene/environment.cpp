// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "scene/environment.h"

#include <algorithm>
#include <cstring>
#include <mutex>
#include <string>

namespace betwixt {

using Animate = EnvironmentEvent::Animate;
using Halt = EnvironmentEvent::Halt;
using Kill = EnvironmentEvent::Kill;

struct Environment::Tail {
  std::once_flag once;
  Output output;
};

namespace {

// The limit of ticks; differences of two ticks within it fit in 64 bits.
constexpr std::int64_t horizon = 2 * Environment::furthest;

std::int64_t within(std::int64_t tick) { return std::clamp(tick, -horizon, horizon); }

std::int64_t updates(const Environment::Span& s, std::int64_t tick) {
  return s.running ? s.pace.count(tick - s.tick) : 0;
}
Mat4 value(const Environment::Span& s, std::int64_t tick) {
  if (!s.running) return s.a;
  bool clamped = false;
  return bounded(s.a * s.motion->power(updates(s, tick)), clamped);
}
std::int64_t interval_of(const Environment::Span& s, std::int64_t tick) {
  return s.running ? s.pace.interval(tick - s.tick) : s.interval;
}
std::optional<std::int64_t> due_of(const Environment::Span& s, std::int64_t tick) {
  if (!s.running) return std::nullopt;
  const auto due = s.pace.due(tick - s.tick);
  if (!due || *due > horizon - s.tick) return std::nullopt;
  return s.tick + *due;
}

Status check_times(const Animate& a) {
  const std::int64_t from = a.from.value_or(0);
  if (from < 0) return fail(ErrorCode::range, "an environment cannot start before its animate");
  if (a.until && *a.until <= from)
    return fail(ErrorCode::range,
                a.from ? "an environment must halt after it starts: until " + std::to_string(*a.until) +
                             "t is not after from " + std::to_string(from) + "t"
                       : "an environment must halt after its animate, not after " + std::to_string(*a.until) + "t");
  if (std::max(from, a.until.value_or(0)) > Environment::furthest)
    return fail(ErrorCode::range, "a start or a stop is too far in the future");
  return Nothing{};
}

Status check_motion(const Animate& a) {
  for (double e : a.motion.m)
    if (!std::isfinite(e)) return fail(ErrorCode::range, "the matrix of a motion has an element that is not finite");
  if (const Result<Pace> pace = Pace::make(a.timing); !pace) return pace.error();
  return check_times(a);
}

// The remainder of an older interval may need one row too many; then leave it out.
Pace pace_of(const Timing& t, std::optional<std::int64_t> first) {
  if (Result<Pace> pace = Pace::make(t, first)) return *pace;
  return *Pace::make(t);
}

}  // namespace

// ---- Construction

Environment Environment::compile(std::vector<EnvironmentEvent> events) {
  const auto key = [](const EnvironmentEvent& e) { return Key{e.tick, e.number}; };
  std::stable_sort(events.begin(), events.end(), [&](const auto& a, const auto& b) { return key(a) < key(b); });
  Environment e;
  for (const EnvironmentEvent& event : events) e.take(event);
  return e;
}

// Keeps even an event without a meaning, since a later event before it may give it one.
void Environment::take(const EnvironmentEvent& event, const Environment* like) {
  if (const Status good = check(event))
    apply(event, like);
  else
    problems_.edit().push_back({event.number, Severity::error, good.error()});
  events_.push(event);
}

Status Environment::add(const EnvironmentEvent& event, const Environment* like) {
  const auto after = [&](const EnvironmentEvent& e) { return Key{e.tick, e.number} > Key{event.tick, event.number}; };
  if (events_.empty() || !after(events_.back())) {
    if (Status good = check(event); !good) return good;
    take(event, like);
    return Nothing{};
  }
  Environment again;
  std::size_t i = 0;
  while (!after(events_[i])) again.take(events_[i++]);
  if (Status good = again.check(event); !good) return good;
  again.take(event);
  while (i < size()) again.take(events_[i++]);
  *this = std::move(again);
  return Nothing{};
}

Status Environment::check(const EnvironmentEvent& event) const {
  if (event.tick > furthest || event.tick < -furthest) return fail(ErrorCode::range, "this time is too far away");
  if (const auto* a = std::get_if<Animate>(&event.what)) return check_motion(*a);
  if (alive()) return Nothing{};
  const std::string verb = std::holds_alternative<Halt>(event.what)   ? "halt"
                           : std::holds_alternative<Kill>(event.what) ? "kill"
                                                                      : "cancel";
  return fail(ErrorCode::name, "there is nothing to " + verb + ": it has not been animated" +
                                   (births_.empty() ? " before this" : " since it was killed"));
}

void Environment::apply(const EnvironmentEvent& event, const Environment* like) {
  const Key key{event.tick, event.number};
  Output out;
  while (!pending_->empty() && pending_->back().key <= key) {
    run(now_, pending_->back(), out);
    pending_.edit().pop_back();
  }
  if (const auto* a = std::get_if<Animate>(&event.what))
    animate(key, *a, like, out);
  else if (std::holds_alternative<Halt>(event.what))
    halt(now_, key, out);
  else if (std::holds_alternative<Kill>(event.what))
    kill(key, out);
  else
    pending_.reset();
  keep(std::move(out));
  tail_ = pending_->empty() ? nullptr : std::make_shared<Tail>();
}

void Environment::keep(Output out) {
  for (Span& s : out.spans) spans_.push(std::move(s));
  if (out.problems.empty()) return;
  auto& all = problems_.edit();
  all.insert(all.end(), out.problems.begin(), out.problems.end());
}

void Environment::animate(Key key, const Animate& a, const Environment* like, Output& out) {
  const std::shared_ptr<const Motion> theirs = like ? like->now_.span.motion : nullptr;
  const bool same = theirs && theirs->timing == a.timing && theirs->keep_phase == a.keep_phase &&
                    std::memcmp(&theirs->matrix, &a.motion, sizeof a.motion) == 0;
  const Scheduled now{
      key, same ? theirs : std::make_shared<const Motion>(Motion{a.motion, a.timing, a.keep_phase, Power(a.motion)})};
  if (!alive()) {
    births_.push({key, spans_.size() + out.spans.size()});
    now_ = {.span = {}, .started = false, .warned = now_.warned};
    if (a.from.value_or(0) > 0) wait(now_, key, now, out);
  }
  if (a.from.value_or(0) > 0)
    schedule({{key.tick + *a.from, key.number}, now.motion});
  else
    start(now_, now, out);
  if (a.until) schedule({{key.tick + *a.until, key.number}, nullptr});
}

// Created but not started: the name exists, A is still the identity.
void Environment::wait(Now& now, Key key, const Scheduled& what, Output& out) const {
  now.span.tick = key.tick;
  now.span.motion = what.motion;
  now.span.interval = what.motion->timing.interval;
  out.spans.push_back(now.span);
}

void Environment::kill(Key key, Output& out) {
  halt(now_, key, out);
  kills_.push(key);
  pending_.reset();
}

void Environment::schedule(Scheduled s) {
  auto& all = pending_.edit();
  const auto after = std::partition_point(all.begin(), all.end(), [&](const Scheduled& o) { return o.key > s.key; });
  all.insert(after, std::move(s));
}

void Environment::run(Now& now, const Scheduled& s, Output& out) {
  if (s.motion)
    start(now, s, out);
  else
    halt(now, s.key, out);
}

void Environment::start(Now& now, const Scheduled& s, Output& out) {
  const Span& old = now.span;
  const std::int64_t tick = s.key.tick, done = now.started ? updates(old, tick) : 0;
  const auto due = now.started ? due_of(old, tick) : std::nullopt;
  const bool keep = s.motion->keep_phase && due;
  if (due && !keep && done == 0 && tick > old.tick && !now.warned) {
    now.warned = true;
    out.problems.push_back(
        {s.key.number, Severity::warning,
         fail(ErrorCode::range,
              "this animate comes before the first update of the previous one; if it repeats like this, nothing moves",
              "to keep the update that was due: keep-phase")});
  }
  Span next;
  next.tick = tick;
  next.a = now.started ? value(old, tick) : s.motion->power(1);
  next.motion = s.motion;
  next.pace = pace_of(s.motion->timing, keep ? std::optional(*due - tick) : std::nullopt);
  next.before = now.started ? old.before + done : 0;
  next.running = true;
  next.first = !now.started;
  now.span = next;
  now.started = true;
  out.spans.push_back(std::move(next));
}

void Environment::halt(Now& now, Key key, Output& out) {
  if (!now.span.running) return;
  Span next = now.span;
  next.tick = key.tick;
  next.a = value(now.span, key.tick);
  next.before += updates(now.span, key.tick);
  next.interval = interval_of(now.span, key.tick);
  next.running = next.first = false;
  now.span = next;
  out.spans.push_back(std::move(next));
}

// ---- Queries

const Environment::Output& Environment::tail() const {
  static const Output none;
  if (!tail_) return none;
  std::call_once(tail_->once, [&] {
    Now now = now_;
    for (auto s = pending_->rbegin(); s != pending_->rend(); ++s) run(now, *s, tail_->output);
  });
  return tail_->output;
}

std::size_t Environment::spans() const { return spans_.size() + tail().spans.size(); }

const Environment::Span& Environment::span_number(std::size_t i) const {
  return i < spans_.size() ? spans_[i] : tail().spans[i - spans_.size()];
}

// Returns the first of the spans [first, end) that begins after `tick`.
std::size_t Environment::spans_until(std::size_t first, std::size_t end, std::int64_t tick) const {
  while (first < end) {
    const std::size_t middle = first + (end - first) / 2;
    if (span_number(middle).tick <= tick)
      first = middle + 1;
    else
      end = middle;
  }
  return first;
}

const Environment::Span* Environment::span(int generation, std::int64_t tick) const {
  if (generation < 0 || generation >= generations()) return nullptr;
  const auto g = static_cast<std::size_t>(generation);
  const std::size_t first = births_[g].span, end = g + 1 < births_.size() ? births_[g + 1].span : spans();
  const std::size_t after = spans_until(first, end, within(tick));
  return after == first ? nullptr : &span_number(after - 1);
}

std::optional<int> Environment::bind(std::int64_t tick, std::uint64_t number) const {
  const Key key{tick, number};
  std::size_t first = 0, end = births_.size();
  while (first < end) {
    const std::size_t middle = first + (end - first) / 2;
    if (births_[middle].key <= key)
      first = middle + 1;
    else
      end = middle;
  }
  const bool living = first > 0 && (first > kills_.size() || kills_[first - 1] > key);
  if (living) return static_cast<int>(first - 1);
  return first < births_.size() ? std::optional(static_cast<int>(first)) : std::nullopt;
}

std::optional<int> Environment::generation_at(std::int64_t tick) const {
  const auto g = bind(tick);
  return g && births_[static_cast<std::size_t>(*g)].key.tick <= tick ? g : std::nullopt;
}

Mat4 Environment::at(int generation, std::int64_t tick) const {
  const Span* s = span(generation, tick);
  return s ? value(*s, within(tick)) : Mat4{};
}

Mat4 Environment::smooth(int generation, double tick) const {
  if (!(std::abs(tick) < static_cast<double>(horizon))) return {};
  const auto whole = static_cast<std::int64_t>(std::floor(tick));
  const Span* s = span(generation, whole);
  if (!s) return {};
  const Pace::Row row = s->running ? s->pace.row(whole - s->tick) : Pace::Row{.ended = true};
  if (row.ended) return value(*s, whole);
  const double passed = static_cast<double>(whole - s->tick - row.begin) + (tick - std::floor(tick));
  const auto power = s->motion->power.real(static_cast<double>(row.count) + passed / static_cast<double>(row.interval));
  return power ? s->a * *power : value(*s, whole);
}

std::int64_t Environment::count(int generation, std::int64_t tick) const {
  const Span* s = span(generation, tick);
  return s ? s->before + updates(*s, within(tick)) : 0;
}

bool Environment::clamped(int generation, std::int64_t tick) const {
  const Span* s = span(generation, tick);
  if (!s) return false;
  const auto full = [](double e) { return std::abs(e) >= Power::bound; };
  const Mat4 a = value(*s, within(tick));
  return std::any_of(a.m.begin(), a.m.end(), full) || s->motion->power.clamped(updates(*s, within(tick)));
}

std::optional<std::int64_t> Environment::next_due(std::int64_t tick) const {
  tick = within(tick);
  const std::size_t all = spans();
  for (std::size_t i = spans_until(0, all, tick);; ++i) {
    const Span* next = i < all ? &span_number(i) : nullptr;
    if (i > 0) {
      const Span& s = span_number(i - 1);
      const auto due = due_of(s, std::max(s.tick, tick));
      if (due && (!next || *due <= next->tick)) return due;
    }
    if (!next) return std::nullopt;
    if (next->first) return next->tick;
  }
}

std::optional<Mat4> Environment::matrix(std::int64_t tick) const {
  const auto g = generation_at(tick);
  return g ? std::optional(span(*g, tick)->motion->matrix) : std::nullopt;
}

std::optional<std::int64_t> Environment::interval(std::int64_t tick) const {
  const auto g = generation_at(tick);
  return g ? std::optional(interval_of(*span(*g, tick), within(tick))) : std::nullopt;
}

std::vector<Environment::Problem> Environment::problems() const {
  std::vector<Problem> all = *problems_;
  all.insert(all.end(), tail().problems.begin(), tail().problems.end());
  return all;
}

bool operator==(const Environment& a, const Environment& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i)
    if (!(a.event(i) == b.event(i))) return false;
  return true;
}

}  // namespace betwixt
