// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The state of playback: position, direction, loop and the part to play. Time comes from the clock, not from a count of
// pictures: playback skips late pictures and does not slow down.
#pragma once

#include <algorithm>
#include <chrono>
#include <cmath>

#include "betwixt/time.h"

namespace betwixt {

class Playhead {
 public:
  using Clock = std::chrono::steady_clock;
  static double seconds_since(Clock::time_point then) {
    return std::chrono::duration<double>(Clock::now() - then).count();
  }

  bool playing() const { return direction_ != 0; }
  int direction() const { return direction_; }  // 1 or -1; 0 if it does not play
  bool loops() const { return loops_; }
  void loop(bool on) { hold(), loops_ = on; }
  double speed() const { return speed_; }
  void speed(double s) { hold(), speed_ = s; }  // 1: as fast as the film; more than 0
  Rate rate() const { return rate_; }
  Time first() const { return first_; }
  Time last() const { return last_; }
  // Sets the part to play, both frames included. If the position is outside, playback starts at the nearest end. Each
  // key and each message of a control calls this with the same part, which must not move the time.
  void set(Rate rate, Time first, Time last) {
    if (rate == rate_ && first == first_ && std::max(first, last) == last_) return;
    hold(), rate_ = rate, first_ = first, last_ = std::max(first, last);
  }

  // Returns the time of the frame that is due. Without playback it returns the position, which can be between frames.
  Time now(Clock::time_point clock = Clock::now()) const {
    if (direction_ == 0) return at_;
    const double frame = exact_frame(clock);
    return rate_.frame(std::clamp(direction_ > 0 ? std::floor(frame) : std::ceil(frame), rate_.frame_number(first_),
                                  rate_.frame_number(last_)));
  }
  // Returns the seconds until another frame is due.
  double until_next(Clock::time_point clock = Clock::now()) const {
    const double frame = direction_ * exact_frame(clock);
    return (std::floor(frame) + 1 - frame) / (rate_.per_second() * speed_);
  }
  // The position for sound: the number of whole frames since the first one, and the moment at which that frame began.
  // Playback counts from there.
  struct Place {
    bool playing;  // forward and at speed 1, because sounds play neither backward nor at another speed
    int frame;
    Clock::time_point since;
  };
  Place place() const {
    const double frames = std::max(0.0, rate_.frame_number(at_) - rate_.frame_number(first_));
    const int whole = static_cast<int>(std::floor(frames));
    const std::chrono::duration<double> begun((frames - whole) / rate_.per_second());
    return {direction_ > 0 && speed_ == 1, whole, since_ - std::chrono::duration_cast<Clock::duration>(begun)};
  }
  // Returns whether the frame at the end has had its full time; always false in a loop.
  bool ended(Clock::time_point clock = Clock::now()) const {
    if (direction_ == 0 || loops_) return false;
    const double frame = exact_frame(clock);
    return direction_ > 0 ? frame >= std::floor(rate_.frame_number(last_)) + 1
                          : frame <= std::ceil(rate_.frame_number(first_)) - 1;
  }
  // Plays from the position; from the other end if it is at the end already.
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
  // Returns the frame during playback, with a fraction. The frame at the end lasts as long as the others. A message
  // that arrived before the start belongs to the first frame, not to the last one of an earlier round.
  double exact_frame(Clock::time_point clock) const {
    const auto since = std::max(clock, since_) - since_;
    const double gone = direction_ * std::chrono::duration<double>(since).count() * rate_.per_second() * speed_;
    const double from = rate_.frame_number(first_), to = rate_.frame_number(last_);
    const double frame = rate_.frame_number(at_) + gone;
    const double length = std::floor(to) - std::ceil(from) + 1;
    if (!loops_ || length <= 0) return std::clamp(frame, from - (direction_ < 0), to + (direction_ > 0));
    const double begin = direction_ > 0 ? from : to, past = std::fmod(direction_ * (frame - begin), length);
    return begin + direction_ * (past < 0 ? past + length : past);
  }
  // Makes the current frame the position, with its fraction, so that many changes do not slow playback down.
  void hold() {
    const auto clock = Clock::now();
    if (direction_ != 0) at_ = rate_.frame(exact_frame(clock));
    since_ = clock;
  }

  Rate rate_;
  Time first_, last_, at_;
  int direction_ = 0;
  bool loops_ = true;
  double speed_ = 1;
  Clock::time_point since_ = Clock::now();
};

}  // namespace betwixt
