// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The clock's maker thread. It takes the published edition and makes the next frame that can be ready in time. Only one
// frame is in progress: the maker begins the next one, from the newest edition, when the clock has shown it.
#include <algorithm>

#include "server/frame_clock.h"

namespace betwixt {

void FrameClock::take_post() {
  Posted* const next = post_.exchange(nullptr);
  if (!next) return;
  if (Posted* const old = current_.release()) {  // the publisher frees it, because that may take long
    old->next = done_.load();
    while (!done_.compare_exchange_weak(old->next, old)) {
    }
  }
  const Transport before = std::exchange(transport_, next->edition.transport);
  if (!(transport_ == before)) last_.reset();
  current_.reset(next);
  fresh_ = true;
}

void FrameClock::doze(std::optional<Nanos> until) {
  maker_.wait(until);
  ++wakes_;
}

void FrameClock::make_frames() {
  while (!stop_) {
    take_post();
    if (news_.exchange(false)) fresh_ = true;
    const Nanos now = monotonic_now();
    std::optional<Making> next = current_ ? plan(now) : std::nullopt;
    if (!next)
      doze(std::nullopt);
    else if (next->deadline - now > 2 * period_ + cost_)
      doze(next->deadline - period_ - cost_);  // draw shortly before the deadline, from the newest edition
    else
      make(*std::move(next));
  }
}

// Returns the next frame that is due and its deadline, or nullopt if none is due.
std::optional<FrameClock::Making> FrameClock::plan(Nanos now) const {
  const Transport& t = current_->edition.transport;
  const Program& program = current_->edition.program;
  Making m;
  m.anew = !last_;
  if (!t.running) {
    if (!fresh_) return std::nullopt;
    m.shown.number = number_at(t.at), m.shown.time = t.at, m.deadline = now;
    return m;
  }
  // The first frame that can be ready in time.
  std::int64_t number = std::max(number_at(t.time(now + cost_)) + 1, last_ ? *last_ + 1 : number_at(t.at));
  if (last_) {
    const auto due = due_after(program, *last_);
    if (!due && !fresh_) return std::nullopt;
    if (!fresh_) number = std::max(number, *due);
    m.due = counted_ == last_ || !counted_ ? due : due_after(program, *counted_);
  }
  m.shown.number = number, m.shown.time = time_of(number), m.deadline = t.when(m.shown.time);
  return m;
}

void FrameClock::make(Making m) {
  making_ = std::move(m);
  stage_ = Stage::begun;
  clock_.signal();
  draw();
  stage_ = Stage::ready;
  if (overdue_) clock_.signal();
  while (stage_ != Stage::none) doze(std::nullopt);
  if (making_.lost) lose_screen(*making_.lost);
  if (current_->edition.transport.running) last_ = making_.shown.number;
  fresh_ = false;
}

void FrameClock::draw() {
  if (!current_->edition.look && !screen_) return;
  const Nanos begun = monotonic_now();
  std::optional<Evaluation>& played = current_->evaluation;
  if (!played) played.emplace(current_->edition.program, quarantine_);
  quarantine_.wait_until(patience(begun, played->revision().times == 0));
  played->to(making_.shown.time);
  making_.shown.problems = played->problems();
  making_.shown.turns = quarantine_.turns();
  if (screen_)
    if (Status drawn = screen_->draw(*played); !drawn) lose_screen(drawn.error());
  expect_cost(monotonic_now() - begun - quarantine_.waited());
}

// Returns the moment until which the maker waits for answers. It leaves enough time to draw them. The cost of an
// edition's first frame is not known yet.
Nanos FrameClock::patience(Nanos begun, bool first) const {
  if (!current_->edition.transport.running) return begun + period_;
  const Nanos cost = first ? std::max(cost_, period_ / 2) : cost_;
  return std::clamp(making_.deadline - cost - period_ / 8, begun + period_ / 8, begun + period_);
}

// Updates the expected cost of a frame, from the median of the last three. So one slow frame alone, such as the first,
// does not raise it.
void FrameClock::expect_cost(Nanos took) {
  std::rotate(took_.begin(), took_.begin() + 1, took_.end());
  took_.back() = took;
  auto sorted = took_;
  std::sort(sorted.begin(), sorted.end());
  const Nanos usual = sorted[1];
  cost_ = usual > cost_ ? usual : cost_ - (cost_ - usual) / 8;
}

}  // namespace betwixt
