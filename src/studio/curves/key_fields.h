// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Fields for the time and the value of the selected events (keys), to type in.
#pragma once

#include <QWidget>

#include "studio/timeline/event_lines.h"

class QLineEdit;

namespace betwixt::studio {

class CurvePane;
class NumberField;

class KeyFields : public QWidget {
  Q_OBJECT
 public:
  KeyFields(Workspace&, CurvePane&, QWidget* parent);

 private:
  void refresh();
  void take_time();
  Lines value_lines(const QString&) const;
  std::vector<EventAt> on_curve() const;  // the selected events of the active curve

  Workspace& workspace_;
  CurvePane& pane_;
  QLineEdit* time_;
  NumberField* value_;
};

}  // namespace betwixt::studio
