// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Where playing is: forward or back, again and again, in a part of the film. Time comes from the clock, never from
// counting pictures: a late picture is left out, and nothing slows down.
#pragma once

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "betwixt/time.h"

namespace betwixt::studio {

class Transport {
 public:
  using Clock = std::chrono::steady_clock;

  bool playing() const { return direction_ != 0; }
  int direction() const { return direction_; }  // 1, -1; 0: it stands
  bool loops() const { return loops_; }
  void loop(bool on) { hold(), loops_ = on; }
  Rate rate() const { return rate_; }
  Time first() const { return first_; }
  Time last() const { return last_; }
  // The part that is played, both frames included; where it stood outside it goes on from the nearest.
  // Each key and each message of a control calls this with the same part, which must not move the time.
  void set(Rate rate, Time first, Time last) {
    if (rate == rate_ && first == first_ && std::max(first, last) == last_) return;
    hold(), rate_ = rate, first_ = first, last_ = std::max(first, last);
  }

  // The frame's time that is due; while it stands, where it was put, which may be between frames.
  Time now(Clock::time_point clock = Clock::now()) const {
    if (direction_ == 0) return at_;
    const double frame = exact_frame(clock);
    return rate_.frame(std::clamp(direction_ > 0 ? std::floor(frame) : std::ceil(frame), rate_.frame_number(first_),
                                  rate_.frame_number(last_)));
  }
  // The number of whole frames after the first one, and the moment at which it was there. It plays on from there.
  std::pair<int, Clock::time_point> place() const {
    const double frames = std::max(0.0, rate_.frame_number(at_) - rate_.frame_number(first_));
    const int whole = static_cast<int>(std::floor(frames));
    const std::chrono::duration<double> begun((frames - whole) / rate_.per_second());
    return {whole, since_ - std::chrono::duration_cast<Clock::duration>(begun)};
  }
  // It has come to the end that it goes to, and stays there.
  bool ended(Clock::time_point clock = Clock::now()) const {
    return direction_ != 0 && !loops_ && now(clock) == (direction_ > 0 ? last_ : first_);
  }
  // From where it stands; from the other end where it stands at the one that it would go to.
  void play(int direction) {
    hold();
    direction_ = direction;
    if (at_ >= last_ && direction > 0) at_ = first_;
    if (at_ <= first_ && direction < 0) at_ = last_;
    go_to(std::clamp(at_, first_, last_));
  }
  void pause() { at_ = now(), direction_ = 0; }
  void go_to(Time t) { at_ = t, since_ = Clock::now(); }

 private:
  // The frame while it plays, with its fraction. The last frame of a loop lasts as long as the others. A message that
  // came before the start belongs to the first frame, not to the last one of a round before.
  double exact_frame(Clock::time_point clock) const {
    const auto since = std::max(clock, since_) - since_;
    const double gone = direction_ * std::chrono::duration<double>(since).count() * rate_.per_second();
    const double from = rate_.frame_number(first_), to = rate_.frame_number(last_);
    const double frame = rate_.frame_number(at_) + gone;
    const double length = std::floor(to) - std::ceil(from) + 1;
    if (!loops_ || length <= 0) return std::clamp(frame, from, to);
    const double past = std::fmod(frame - from, length);
    return from + (past < 0 ? past + length : past);
  }
  // The place now, with the fraction of the frame: many changes must not slow it down.
  void hold() {
    const auto clock = Clock::now();
    if (direction_ != 0) at_ = rate_.frame(exact_frame(clock));
    since_ = clock;
  }

  Rate rate_;
  Time first_, last_, at_;
  int direction_ = 0;
  bool loops_ = true;
  Clock::time_point since_ = Clock::now();
};

}  // namespace betwixt::studio
