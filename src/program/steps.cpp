// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "program/steps.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/cancellation.h"
#include "program/compiled.h"
#include "program/held_values.h"
#include "program/questions.h"
#include "scene/names.h"
#include "track/types.h"

namespace betwixt {
namespace {

constexpr std::int64_t most_steps = 10'000'000;
constexpr std::uint64_t most_work = 10'000'000'000;  // for all steps together

// Returns whether the step or a later one is being computed. Then all steps of this circle fail, whichever of them was
// asked for first.
bool closes_circle(const StepRun& run, std::int64_t step, Asking& asking) {
  const OpenStep* first = asking.step;
  while (first && (first->run != &run || step < first->step)) first = first->outer;
  for (OpenStep* open = first ? asking.step : nullptr; open; open = open->outer) {
    open->circle = true;
    if (open == first) return true;
  }
  return false;
}

// Returns the state between `a` and `b`: numbers, vectors, colours and rotations blend, and everything else is that of
// `a`. A whole number blends with a number that is not whole, because Lua writes 0 for the beginning of both.
State between(const State& a, const State& b, double share) {
  const auto number = [](const State& s) -> std::optional<double> {
    if (const auto* whole = std::get_if<std::int64_t>(&s.is)) return static_cast<double>(*whole);
    const auto* v = std::get_if<Value>(&s.is);
    const auto* d = v ? std::get_if<double>(v) : nullptr;
    return d ? std::optional(*d) : std::nullopt;
  };
  if (std::holds_alternative<std::int64_t>(a.is) && std::holds_alternative<std::int64_t>(b.is)) return a;
  if (const auto from = number(a), to = number(b); from && to) return {Value(*from + share * (*to - *from))};
  if (const auto* from = std::get_if<Value>(&a.is)) {
    const auto* to = std::get_if<Value>(&b.is);
    if (!to || from->index() != to->index() || !numeric(*from) || std::holds_alternative<bool>(*from)) return a;
    const auto blend = laid_over(*from, *to, share, true);
    return blend ? State{*blend} : a;
  }
  const auto *from = std::get_if<State::Table>(&a.is), *to = std::get_if<State::Table>(&b.is);
  const auto same_key = [](const State::Entry& x, const State::Entry& y) { return x.key == y.key; };
  if (!from || !to || !std::equal(from->begin(), from->end(), to->begin(), to->end(), same_key)) return a;
  State::Table out;
  out.reserve(from->size());
  for (std::size_t i = 0; i < from->size(); ++i)
    out.push_back({(*from)[i].key, between((*from)[i].state, (*to)[i].state, share)});
  return {std::move(out)};
}

// One procedure in one film.
struct Stepper {
  const Program::Compiled& c;
  const NamedProcedure& p;
  StepRun& run;
  Asking& asking;
  Time every = p.stepping.every > Time{} ? p.stepping.every : c.document.scene().rate.span(1);

  Time time_of(std::int64_t step) const { return p.stepping.from + Time{every.flicks * step}; }

  // Computes the step after a point. Returns false if it fails.
  bool advance(StepRun::Point at) const {
    Cancellation::check();
    const std::int64_t number = at.step + 1;
    OpenStep open{&run, number, asking.step};
    Asking inner;
    inner.step = &open;
    FilmQuestions questions(c, inner, time_of(number));
    std::uint64_t cost = 0;
    auto state = p.code->step(questions, at.state ? *at.state : State{}, number, every.seconds(), cost);
    if (questions.called_off) throw Cancelled{};
    if (open.circle)
      state = fail(ErrorCode::range, std::string(p.code->circle()));
    else
      run.note(number, inner);
    at.cost += cost;
    if (state && at.cost > most_work)
      state =
          fail(ErrorCode::range, fmt::format("stopped: its steps took more than {} steps of Lua together", most_work));
    if (state) return run.put({number, std::make_shared<const State>(*std::move(state)), at.cost}), true;
    const std::string when =
        fmt::format("step {} at {}", number, format_time(time_of(number), c.document.scene().rate));
    run.fail_at(
        {number, {Problem::step, p.name, when, state.error().message, p.code->source, state.error().place.line}});
    return false;
  }

  Result<std::shared_ptr<const State>> after(std::int64_t step) const {
    if (closes_circle(run, step, asking)) return fail(ErrorCode::range, std::string(p.code->circle()));
    for (StepRun::Point at; (at = run.nearest(step)).step < step;) {
      const auto failure = run.failed(at.step + 1);
      if (!failure && advance(at)) continue;
      asking.say(run.failed(at.step + 1)->why);
      if (at.step < 0) return fail(ErrorCode::type, "its first step failed");
      return at.state;
    }
    return run.nearest(step).state;
  }

  Result<State> at(Time t) const {
    const std::int64_t since = std::max<std::int64_t>(0, t.flicks - p.stepping.from.flicks);
    const std::int64_t step = since / every.flicks, rest = since % every.flicks;
    if (step >= most_steps) return fail(ErrorCode::range, fmt::format("it can have at most {} steps", most_steps));
    const bool blends = rest > 0 && !p.stepping.hold;
    const auto before = after(step), next = blends ? after(step + 1) : before;
    run.tell(blends ? step + 1 : step, asking);
    if (!before || !next) return before ? next.error() : before.error();
    return blends ? between(**before, **next, static_cast<double>(rest) / static_cast<double>(every.flicks)) : **before;
  }
};

}  // namespace

State state_of(std::vector<Vec3> vectors) { return {Value(Points(std::move(vectors)))}; }

std::span<const Vec3> vectors_of(const State& s) {
  const auto* v = std::get_if<Value>(&s.is);
  const auto* p = v ? std::get_if<Points>(v) : nullptr;
  return p ? std::span(**p) : std::span<const Vec3>();
}

bool is_computing(const Program::Compiled& c, const NamedProcedure& p, const Asking& asking) {
  const StepRun* run = &c.caches.steps.of(p);
  const OpenStep* open = asking.step;
  while (open && open->run != run) open = open->outer;
  return open != nullptr;
}

PartOfStep::PartOfStep(const Program::Compiled& c, const NamedProcedure& p, Time t, Asking& asking) : asking_(asking) {
  open_.run = &c.caches.steps.of(p), open_.step = (t.flicks - p.stepping.from.flicks) / p.stepping.every.flicks + 1;
  open_.outer = asking.step, asking.step = &open_;
}
PartOfStep::~PartOfStep() { asking_.step = open_.outer; }

StepRun::Point StepRun::nearest(std::int64_t step) {
  const std::lock_guard lock(in_use_);
  const Point none;
  const Point* best = &none;
  const auto closer = [&](const Point& p) {
    if (p.step <= step && p.step > best->step) best = &p;
  };
  if (!kept_.empty() && step >= 0) closer(kept_[std::min(static_cast<std::size_t>(step / stride_), kept_.size() - 1)]);
  closer(newest_);
  for (const Point& p : recent_) closer(p);
  return *best;
}

void StepRun::put(Point p) {
  const std::lock_guard lock(in_use_);
  recent_.push_back(p), recent_bytes_ += bytes_of(*p.state);
  for (; recent_.size() > most_recent || (recent_.size() > 2 && recent_bytes_ > most_recent_bytes); recent_.pop_front())
    recent_bytes_ -= bytes_of(*recent_.front().state);
  if (p.step <= newest_.step) return;
  newest_ = p;
  if (p.step != static_cast<std::int64_t>(kept_.size()) * stride_) return;
  bytes_ += bytes_of(*p.state);
  kept_.push_back(std::move(p));
  if (bytes_ <= most_bytes || kept_.size() < 2) return;
  stride_ *= 2, bytes_ = 0;  // every second checkpoint goes
  for (std::size_t i = 0; 2 * i < kept_.size(); ++i) kept_[i] = kept_[2 * i], bytes_ += bytes_of(*kept_[i].state);
  kept_.resize((kept_.size() + 1) / 2);
}

void StepRun::fail_at(Failure f) {
  const std::lock_guard lock(in_use_);
  if (!failure_ || f.step < failure_->step) failure_ = std::move(f);
}

std::optional<StepRun::Failure> StepRun::failed(std::int64_t step) {
  const std::lock_guard lock(in_use_);
  return failure_ && failure_->step <= step ? failure_ : std::nullopt;
}

namespace {

// Adds what a step has, if no step before had it.
template <class What>
void add(std::vector<std::pair<std::int64_t, What>>& all, std::int64_t step, const What& what, std::size_t most) {
  const auto known = std::find_if(all.begin(), all.end(), [&](const auto& one) { return one.second == what; });
  if (known != all.end())
    known->first = std::min(known->first, step);
  else if (all.size() < most)
    all.emplace_back(step, what);
}

}  // namespace

void StepRun::note(std::int64_t step, const Asking& asking) {
  const std::lock_guard lock(in_use_);
  for (const Target& t : asking.read) add(read_, step, t, most_noted);
  for (const Problem& p : asking.problems) add(problems_, step, p, most_noted);
}

void StepRun::tell(std::int64_t step, Asking& caller) {
  const std::lock_guard lock(in_use_);
  for (const auto& [first, target] : read_)
    if (first <= step) caller.note_read(target);
  for (const auto& [first, problem] : problems_)
    if (first <= step) caller.say(problem);
}

StepRun& StepRuns::of(const NamedProcedure& p) {
  const std::lock_guard lock(in_use_);
  auto& run = all_[&p];
  if (!run) run = std::make_unique<StepRun>();
  return *run;
}

Result<State> state_at(const Program::Compiled& c, const NamedProcedure& p, Time t, Asking& asking) {
  return Stepper{c, p, c.caches.steps.of(p), asking}.at(t);
}

}  // namespace betwixt
