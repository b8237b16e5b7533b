// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/sound.h"

#include "betwixt/film.h"

namespace betwixt::studio {

Sound::Sound(Desk& desk, QObject* parent) : QObject(parent), desk_(desk) {
  connect(&desk, &Desk::playing_changed, this, &Sound::follow);
  connect(&desk, &Desk::document_changed, this, &Sound::follow);
  connect(&desk, &Desk::jumped, this, &Sound::follow);
}

void Sound::mute(bool on) {
  muted_ = on;
  follow();
}

void Sound::follow() {
  const Transport& t = desk_.transport();
  const bool plays = t.direction() > 0 && has_sounds(desk_.document());
  if (!plays && !hearing_) return;
  FrameList f;
  f.rate = t.rate(), f.first = t.first(), f.last = t.last();
  const double number = f.rate.frame_number(f.first), last = f.rate.frame_number(f.last);
  f.number = static_cast<int>(std::floor(number)), f.on_grid = number == std::floor(number);
  f.count = std::max(1, static_cast<int>(std::floor(last - number)) + 1);
  const bool same =
      hearing_ && f.first == frames_.first && f.count == frames_.count && f.rate == frames_.rate && loops_ == t.loops();
  if (plays && !same) {
    frames_ = f, loops_ = t.loops();
    hearing_ = Hearing::open(desk_.program(), frames_, loops_);
  }
  if (!hearing_) return;
  const auto [frame, since] = t.place();
  hearing_->follow(desk_.program(), {plays, frame, since}, muted_);
}

}  // namespace betwixt::studio
