// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/poses/curve_field.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>

namespace betwixt::studio {

CurveField::CurveField(QWidget* parent) : QWidget(parent) {
  setFocusPolicy(Qt::StrongFocus);
  setAccessibleName(tr("Curve of time"));
  setToolTip(tr("Drag the two handles. Or use the arrow keys, and Space for the other handle"));
}

QSize CurveField::sizeHint() const { return QSize(16, 16) * fontMetrics().height(); }

void CurveField::set_curve(const std::array<double, 4>& curve) {
  curve_ = curve;
  update();
  emit changed();
}

QRectF CurveField::square() const {
  const double margin = fontMetrics().height(), side = std::min(width(), height()) - 2 * margin;
  return {(width() - side) / 2, (height() - side) / 2, side, side};
}

QPointF CurveField::place(double x, double y) const {
  const QRectF s = square();
  return {s.left() + x * s.width(), s.bottom() - y * s.height()};
}

void CurveField::put(int handle, double x, double y) {
  const auto i = static_cast<std::size_t>(2 * handle);
  curve_[i] = std::clamp(x, 0.0, 1.0), curve_[i + 1] = std::clamp(y, 0.0, 1.0);
  update();
  emit changed();
}

void CurveField::paintEvent(QPaintEvent*) {
  QPainter p(this);
  p.setRenderHint(QPainter::Antialiasing);
  p.fillRect(rect(), palette().color(QPalette::Base));
  p.setPen(palette().color(QPalette::Mid));
  p.drawRect(square());
  p.drawLine(place(0, 0), place(1, 1));
  const QPointF a = place(curve_[0], curve_[1]), b = place(curve_[2], curve_[3]);
  p.setPen(QPen(palette().color(QPalette::Text), 1));
  p.drawLine(place(0, 0), a), p.drawLine(place(1, 1), b);
  QPainterPath path(place(0, 0));
  path.cubicTo(a, b, place(1, 1));
  p.setPen(QPen(palette().color(QPalette::Highlight), 2));
  p.drawPath(path);
  const double r = fontMetrics().height() / 3.0;
  for (const auto& [at, i] : {std::pair(a, 0), std::pair(b, 1)}) {
    p.setBrush(palette().color(hasFocus() && held_ == i ? QPalette::Highlight : QPalette::Button));
    p.setPen(palette().color(QPalette::Text));
    p.drawEllipse(at, r, r);
  }
}

void CurveField::mousePressEvent(QMouseEvent* e) {
  const auto away = [&](int i) {
    const auto k = static_cast<std::size_t>(2 * i);
    return QLineF(place(curve_[k], curve_[k + 1]), e->position()).length();
  };
  held_ = away(1) < away(0) ? 1 : 0;
  mouseMoveEvent(e);
}

void CurveField::mouseMoveEvent(QMouseEvent* e) {
  if (!(e->buttons() & Qt::LeftButton)) return;
  const QRectF s = square();
  put(held_, (e->position().x() - s.left()) / s.width(), (s.bottom() - e->position().y()) / s.height());
}

void CurveField::keyPressEvent(QKeyEvent* e) {
  const auto i = static_cast<std::size_t>(2 * held_);
  const double step = e->modifiers() & Qt::ShiftModifier ? 0.1 : 0.02;
  switch (e->key()) {
    case Qt::Key_Left:
      return put(held_, curve_[i] - step, curve_[i + 1]);
    case Qt::Key_Right:
      return put(held_, curve_[i] + step, curve_[i + 1]);
    case Qt::Key_Up:
      return put(held_, curve_[i], curve_[i + 1] + step);
    case Qt::Key_Down:
      return put(held_, curve_[i], curve_[i + 1] - step);
    case Qt::Key_Space:
      held_ = 1 - held_;
      return update();
    default:
      QWidget::keyPressEvent(e);
  }
}

}  // namespace betwixt::studio
