// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Plays the film's sounds in step with the playhead, forward only.
#pragma once

#include <QObject>
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

 private:
  void follow();

  Workspace& workspace_;
  std::unique_ptr<Hearing> hearing_;  // null if there is no sound to play
  FrameList frames_;
  bool loops_ = false, muted_ = false;
};

}  // namespace betwixt::studio
