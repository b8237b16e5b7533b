// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Actions on the selected objects, by keys and menus, shared by the picture and the outliner.
#pragma once

#include <QObject>

#include "studio/objects/object_lines.h"

class QKeyEvent;
class QMenu;

namespace betwixt::studio {

class ObjectActions : public QObject {
  Q_OBJECT
 public:
  static ObjectActions& of(Workspace&);

  // An action: its name, its keys in the picture and the outliner, and what it does.
  struct Row {
    const char *name, *key, *sentence;
    void (ObjectActions::*run)();
    bool divides = false;  // a line above it in menus
  };
  static const std::vector<Row>& rows();

  bool key(const QKeyEvent&);  // carries out the action of a key; returns false if it has none
  void fill(QMenu&);           // with the actions on the selection

  // Returns the lines that give an object another parent, at a time or, if nothing has moved by then, for the whole
  // film. The object stays where it is, and then moves along with the parent.
  Lines parent_lines(ObjectId, const Attachment& to) const;

  void duplicate();
  void instance();
  void cut();
  void copy();
  void paste();
  void group();
  void ungroup();
  void remove();
  void remove_all();
  void hide();
  void show_all();
  void fall();
  void mirror(Axis);
  void align(Axis);
  void distribute(Axis);
  void pivot(bool at_bottom);  // the objects stay where they are
  // Gives the selection the shape of a kind ("": its own), or of a file for which it asks. All else of it stays.
  void replace(const std::string& kind);
  void replace_by_file();

 private:
  explicit ObjectActions(Workspace& workspace);
  void say(const ObjectEdit&);
  Value world(ObjectId, Time) const;
  void tell(const QString& why);

  Workspace& workspace_;
};

}  // namespace betwixt::studio
