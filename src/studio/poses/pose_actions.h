// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Copies, pastes and keeps poses. A kept pose is a file of `set` lines in the folder `poses` beside the script.
#pragma once

#include <QObject>
#include <QStringList>
#include <optional>

#include "studio/poses/poses.h"

namespace betwixt::studio {

class PoseActions : public QObject {
  Q_OBJECT
 public:
  static PoseActions& of(Workspace&);

  void copy();  // the pose of the selection, to the clipboard
  void paste(bool in_mirror);
  // Keeps the pose of the selection under a name. Returns false and says why if that fails.
  bool keep(const QString& name);
  QStringList kept() const;  // the names, sorted
  bool forget(const QString& name);
  std::optional<Pose> read(const QString& name);  // for the selection; says why if there is none
  // Returns the lines that give the pose to the selection at the playhead.
  Lines lines(const Pose&, bool in_mirror, double share);

 Q_SIGNALS:
  void kept_changed();

 private:
  explicit PoseActions(Workspace& workspace);
  std::optional<Pose> read_text(const std::string& text);
  ObjectId onto() const;   // the uppermost object of the selection; none if nothing is selected
  QString folder() const;  // "" before the film has a file
  void tell(const QString& why);

  Workspace& workspace_;
};

}  // namespace betwixt::studio
