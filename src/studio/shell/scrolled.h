// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Controls that scroll one way where their panel is too small for them, so that large text does not make windows
// larger.
#pragma once

#include <QScrollArea>

class QVBoxLayout;

namespace betwixt::studio {

class Scrolled : public QScrollArea {
 public:
  Scrolled(QWidget* content, Qt::Orientation way, QWidget* parent = nullptr);
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 protected:
  bool event(QEvent*) override;
  void resizeEvent(QResizeEvent*) override;
  void wheelEvent(QWheelEvent*) override;

 private:
  int bar() const;  // the width of the scroll bar if there is one

  const Qt::Orientation way_;
};

// Gives a panel a column for its controls that scrolls.
QVBoxLayout* scrolled_column(QWidget& panel);

}  // namespace betwixt::studio
