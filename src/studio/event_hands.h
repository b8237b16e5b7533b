// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What is done to the events that are selected, by keys and menus, alike in all panels that show events.
#pragma once

#include <QObject>

#include "studio/event_lines.h"

class QMenu;

namespace betwixt::studio {

class EventHands : public QObject {
  Q_OBJECT
 public:
  static EventHands& of(Desk&);

  // Carries out what a key means; without `act` it is only asked whether it means anything.
  bool key(int, Qt::KeyboardModifiers, bool act);
  void fill(QMenu&);           // with what can be done to what is selected
  void fill_twerpers(QMenu&);  // with how it can go on from there

  void clear();
  void reverse();
  void copy();
  void paste();      // at the playhead
  void duplicate();  // from where they end on
  void insert();     // at the playhead, on the tracks of the selected objects
  void move(Time by);
  void twerper(const std::string& name);
  void extend(const std::string& how, const std::string& side);
  // Says what moves or retimes the selected events; they stay selected where they have gone.
  bool retime(const Lines&, const std::function<Time(Time)>& when);

 private:
  explicit EventHands(Desk& desk);
  void select_copies(const std::vector<EventAt>&, Time to, ObjectId onto);

  Desk& desk_;
  Document kept_;  // that was copied from
  std::vector<EventAt> copied_;
};

}  // namespace betwixt::studio
