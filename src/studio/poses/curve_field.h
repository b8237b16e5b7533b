// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// A Bézier curve from 0 to 1 with two handles: drag them, or Tab to one and use the arrow keys.
#pragma once

#include <QWidget>
#include <array>

namespace betwixt::studio {

class CurveField : public QWidget {
  Q_OBJECT
 public:
  explicit CurveField(QWidget* parent = nullptr);
  const std::array<double, 4>& curve() const { return curve_; }
  void set_curve(const std::array<double, 4>&);
  QSize sizeHint() const override;

 Q_SIGNALS:
  void changed();

 protected:
  void paintEvent(QPaintEvent*) override;
  void mousePressEvent(QMouseEvent*) override;
  void mouseMoveEvent(QMouseEvent*) override;
  void keyPressEvent(QKeyEvent*) override;

 private:
  QRectF square() const;
  QPointF place(double x, double y) const;
  void put(int handle, double x, double y);

  std::array<double, 4> curve_{0, 0, 1, 1};
  int held_ = 0;  // the handle that keys move
};

}  // namespace betwixt::studio
