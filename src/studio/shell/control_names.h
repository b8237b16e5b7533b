// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Gives every control a name for screen readers, if it has none of its own: its tooltip, the hint in it, or the title
// of its panel.
#pragma once

#include <QObject>

class QWidget;

namespace betwixt::studio {

// Returns whether the widget is a control: something with which the user works.
bool is_control(const QWidget&);

class ControlNames : public QObject {
 public:
  using QObject::QObject;
  bool eventFilter(QObject* on, QEvent* e) override;
};

}  // namespace betwixt::studio
