// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Gives every control a name for screen readers, if it has none of its own: its tooltip, the hint in it, or the title
// of its panel. Text that a screen reader or a program for dictation puts into a field counts as typed.
#pragma once

#include <QObject>

class QLineEdit;
class QWidget;

namespace betwixt::studio {

// Returns whether the widget is a control: something with which the user works.
bool is_control(const QWidget&);

// Shows a text that nobody typed: when the field is left, it writes no line.
void show_text(QLineEdit&, const QString&);

class ControlNames : public QObject {
 public:
  using QObject::QObject;
  bool eventFilter(QObject* on, QEvent* e) override;

 private:
  void typed();
};

}  // namespace betwixt::studio
