// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Where keys go. They follow the pointer into panels, as in other animation programs, unless somebody is typing. In a
// field in which nothing has been typed, undo is that of the film. Keys that the user has changed are translated here.
#pragma once

#include <QObject>

class QKeyEvent;
class QWidget;

namespace betwixt::studio {

// Makes keys go to a widget while the pointer is in it.
void follow_pointer(QWidget&);

class KeyFocus : public QObject {
 public:
  using QObject::QObject;
  bool eventFilter(QObject* on, QEvent* e) override;

 private:
  static bool translate(QObject& on, QKeyEvent&);
};

}  // namespace betwixt::studio
