// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The playhead of the terminal player.
#pragma once

#include <algorithm>
#include <chrono>
#include <cmath>

#include "app/command.h"

namespace betwixt {

// Computes which frame is due. Time comes from the clock, not from a count of pictures: late pictures are dropped.
class Playhead {
 public:
  using Clock = std::chrono::steady_clock;
  static double since(Clock::time_point then) { return std::chrono::duration<double>(Clock::now() - then).count(); }

  Playhead(const FrameList& frames, bool loop) : frames_(frames), loop_(loop) {}
  bool playing() const { return playing_; }
  // The position at a moment; during playback it continues from there.
  struct Place {
    bool playing;
    int frame;
    Clock::time_point since;
  };
  Place place() const { return {playing_, at_, started_}; }
  // Returns whether the last frame has had its full time; always false in a loop.
  bool ended() const {
    return playing_ && !loop_ && at_ + since(started_) * frames_.rate.per_second() >= frames_.count;
  }
  int last() const { return frames_.count - 1; }
  int now() const {
    if (!playing_) return at_;
    const double due = at_ + since(started_) * frames_.rate.per_second();
    if (loop_) return static_cast<int>(std::fmod(due, frames_.count));
    return static_cast<int>(std::min<double>(due, last()));
  }
  double until_next() const {  // seconds
    const double due = since(started_) * frames_.rate.per_second();
    return (std::floor(due) + 1 - due) / frames_.rate.per_second();
  }
  void pause() { at_ = now(), playing_ = false; }
  void play() { at_ = now() == last() && !loop_ ? 0 : now(), started_ = Clock::now(), playing_ = true; }
  void jump(int k) { at_ = std::clamp(k, 0, last()), started_ = Clock::now(); }

 private:
  const FrameList& frames_;
  const bool loop_;
  bool playing_ = true;
  int at_ = 0;
  Clock::time_point started_ = Clock::now();
};

}  // namespace betwixt
