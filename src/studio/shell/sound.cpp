// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/shell/sound.h"

#include "betwixt/film.h"

namespace betwixt::studio {

Sound::Sound(Workspace& workspace, QObject* parent) : QObject(parent), workspace_(workspace) {
  connect(&workspace, &Workspace::playing_changed, this, &Sound::follow);
  connect(&workspace, &Workspace::document_changed, this, &Sound::follow);
  connect(&workspace, &Workspace::jumped, this, &Sound::follow);
}

void Sound::mute(bool on) {
  muted_ = on;
  follow();
}

void Sound::follow() {
  const Playhead& t = workspace_.playhead();
  const bool plays = t.direction() > 0 && has_sounds(workspace_.document());
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
    hearing_ = Hearing::open(workspace_.program(), frames_, loops_);
  }
  if (!hearing_) return;
  hearing_->follow(workspace_.program(), t.place(), muted_ || !plays);
}

}  // namespace betwixt::studio
