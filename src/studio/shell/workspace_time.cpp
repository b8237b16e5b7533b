// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The workspace's playhead.
#include <algorithm>

#include "betwixt/language.h"
#include "studio/shell/workspace.h"

namespace betwixt::studio {

void Workspace::tick() {
  const Time due = playhead_.now();
  if (playhead_.ended()) pause();
  if (due == time_) return;
  time_ = due;
  emit time_changed();
}

void Workspace::go_to(Time t) {
  playhead_.go_to(t);
  emit jumped();
  if (t == time_) return;
  time_ = t;
  emit time_changed();
}

void Workspace::step(int frames) {
  pause();
  const Rate rate = document_.rate();
  const double frame = rate.frame_number(time_);
  go_to(rate.frame((frames > 0 ? std::floor(frame) : std::ceil(frame)) + frames));
}

void Workspace::play(int direction) {
  if (playhead_.direction() == direction) return pause();
  playhead_.play(direction);
  shown_ = 0, shown_rate_ = 0, counted_since_ = Playhead::Clock::now();
  clock_.start();
  tick();
  emit playing_changed();
}

void Workspace::pause() {
  if (!playhead_.playing()) return;
  playhead_.pause();
  clock_.stop();
  emit playing_changed();
}

void Workspace::set_range(std::optional<std::pair<Time, Time>> range) {
  range_ = range;
  const auto part = range_.value_or(document_.range());
  playhead_.set(document_.rate(), part.first, part.second);
  emit playing_changed();
}

void Workspace::picture_shown() {
  if (!playhead_.playing()) return;
  ++shown_;
  const double gone = Playhead::seconds_since(counted_since_);
  if (gone < 0.5) return;
  shown_rate_ = shown_ / gone, shown_ = 0, counted_since_ = Playhead::Clock::now();
  emit playing_changed();
}

}  // namespace betwixt::studio
