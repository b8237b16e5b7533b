// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/shell/sound.h"

#include <QGuiApplication>

#include "betwixt/film.h"

namespace betwixt::studio {
namespace {

constexpr int piece = 80;  // ms that are heard of each place; the device adds what it has got already

}  // namespace

Sound::Sound(Workspace& workspace, QObject* parent) : QObject(parent), workspace_(workspace) {
  piece_ends_.setSingleShot(true), piece_ends_.setInterval(piece);
  connect(&piece_ends_, &QTimer::timeout, this, &Sound::follow);
  connect(&workspace, &Workspace::playing_changed, this, &Sound::follow);
  connect(&workspace, &Workspace::document_changed, this, &Sound::follow);
  connect(&workspace, &Workspace::jumped, this, &Sound::jump);
}

void Sound::mute(bool on) {
  muted_ = on;
  follow();
}

void Sound::jump() {
  const bool dragged = !workspace_.playhead().playing() && QGuiApplication::mouseButtons() != Qt::NoButton;
  dragged&& heard_in_drags_ ? play_piece() : follow();
}

void Sound::play_piece() {
  Playhead::Place here = workspace_.playhead().place();
  here.playing = !workspace_.playhead().playing();
  if (!here.playing) return;
  play_on(true, here);
  piece_ends_.start();
}

void Sound::follow() {
  piece_ends_.stop();
  play_on(workspace_.playhead().direction() > 0, workspace_.playhead().place());
}

void Sound::play_on(bool plays, const Playhead::Place& place) {
  const Playhead& t = workspace_.playhead();
  plays_ = plays && has_sounds(workspace_.document());
  if (!plays_ && !hearing_) return;
  FrameList f;
  f.rate = t.rate(), f.first = t.first(), f.last = t.last();
  const double number = f.rate.frame_number(f.first), last = f.rate.frame_number(f.last);
  f.number = static_cast<int>(std::floor(number)), f.on_grid = number == std::floor(number);
  f.count = std::max(1, static_cast<int>(std::floor(last - number)) + 1);
  const bool same =
      hearing_ && f.first == frames_.first && f.count == frames_.count && f.rate == frames_.rate && loops_ == t.loops();
  if (plays_ && !same) {
    frames_ = f, loops_ = t.loops();
    hearing_ = Hearing::open(workspace_.program(), frames_, loops_);
  }
  if (hearing_) hearing_->follow(workspace_.program(), place, muted_ || !plays_);
}

}  // namespace betwixt::studio
