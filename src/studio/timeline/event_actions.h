// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Actions on the selected events, by keys and menus, shared by all panels that show events.
#pragma once

#include <QObject>

#include "studio/timeline/event_lines.h"

class QMenu;

namespace betwixt::studio {

class EventActions : public QObject {
  Q_OBJECT
 public:
  static EventActions& of(Workspace&);

  // Carries out the action of a key. Without `act` it only returns whether the key has one.
  bool key(int, Qt::KeyboardModifiers, bool act);
  void fill(QMenu&);           // with the actions on the selection
  void fill_twerpers(QMenu&);  // with the twerpers for the selected events

  void clear();
  void reverse();
  void copy();
  void paste();      // at the playhead
  void duplicate();  // from their end
  // At the playhead, on the tracks of the selected objects:
  void insert();                  // events with the values there
  void insert_transforms();       // also on those of position, rotation and scale
  void insert_changed();          // only where the value has changed since the last event
  void insert_character();        // on all tracks of the whole characters
  void hold();                    // events with the values of the last ones, which hold until then
  Lines breakdown(double share);  // the lines of events between those before and after
  // Spreads the selected events between the first and the last one by a curve from 0 to 1, and says what stays behind.
  void warp(const std::function<double(double)>& share);
  void move(Time by);
  // Moves the playhead to the next event of the selection, or of all objects; -1: to the previous one. Then to a note.
  void go_to_event(int direction);
  void go_to_note(int direction);
  void twerper(const std::string& name);
  void extend(const std::string& how, const std::string& side);
  // Carries out lines that move or retime the selected events, and selects them at their new times.
  bool retime(const Lines&, const std::function<Time(Time)>& when);

 private:
  explicit EventActions(Workspace& workspace);
  std::vector<Target> without_code(std::vector<Target>);
  std::vector<ObjectId> with_parts() const;
  void insert_on(const std::vector<Target>&);
  void select_copies(const std::vector<EventAt>&, Time to, ObjectId onto);

  Workspace& workspace_;
  Document kept_;  // the document that copied_ refers to
  std::vector<EventAt> copied_;
};

}  // namespace betwixt::studio
