// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Live controls: OSC and MIDI input, the dials that it turns, and takes of them recorded during playback.
#pragma once

#include <QTimer>
#include <QWidget>
#include <memory>
#include <optional>

#include "app/live_input.h"
#include "editor/controls.h"
#include "studio/shell/workspace.h"

class QCheckBox;
class QLabel;
class QLineEdit;
class QListWidget;
class QPushButton;

namespace betwixt::studio {

class LivePanel : public QWidget {
  Q_OBJECT
 public:
  explicit LivePanel(Workspace&, QWidget* parent = nullptr);

  // Treats messages as if a controller had sent them.
  void obey(const LiveMessage& m) { obey(std::vector{m}); }
  void obey(const std::vector<LiveMessage>&);

 private:
  void listen(bool on);
  void poll();
  void take(const LiveMessage&, std::optional<Document>& ahead);
  void learn(const LiveMessage&);
  void end_take();
  void list_dials();

  Workspace& workspace_;
  std::unique_ptr<LiveInput> input_;
  QTimer poll_;
  QLineEdit *where_, *target_;
  QPushButton *listen_, *learn_;
  QCheckBox* record_;
  QLabel *state_, *last_;
  QListWidget* dials_;
  std::optional<Take> take_;
  Time taken_;
  std::size_t messages_ = 0;
};

}  // namespace betwixt::studio
