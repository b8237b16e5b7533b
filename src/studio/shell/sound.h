// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Plays the film's sounds in step with the playhead, forward only. While a hand drags the playhead, it plays a short
// piece at each place.
#pragma once

#include <QObject>
#include <QTimer>
#include <memory>

#include "app/hearing.h"
#include "studio/shell/workspace.h"

namespace betwixt::studio {

class Sound : public QObject {
  Q_OBJECT
 public:
  explicit Sound(Workspace&, QObject* parent = nullptr);
  void mute(bool on);
  bool muted() const { return muted_; }
  // Whether dragging the playhead is heard.
  void set_heard_in_drags(bool on) { heard_in_drags_ = on; }
  bool is_heard_in_drags() const { return heard_in_drags_; }
  void play_piece();  // at the playhead
  bool plays() const { return plays_; }

 private:
  void follow();
  void jump();
  void play_on(bool plays, const Playhead::Place&);

  Workspace& workspace_;
  std::unique_ptr<Hearing> hearing_;  // null if there is no sound to play
  FrameList frames_;
  bool loops_ = false, muted_ = false, heard_in_drags_ = true, plays_ = false;
  QTimer piece_ends_;
};

}  // namespace betwixt::studio
