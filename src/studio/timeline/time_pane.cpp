// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/timeline/time_pane.h"

#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "studio/shell/key_focus.h"
#include "studio/shell/theme.h"

namespace betwixt::studio {

TimePane::TimePane(Workspace& workspace, QWidget* parent)
    : QWidget(parent), workspace_(workspace), axis_(TimeAxis::of(workspace)) {
  follow_pointer(*this);
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  const auto repaint = [this] { update(); };
  connect(&axis_, &TimeAxis::changed, this, repaint);
  connect(&workspace, &Workspace::time_changed, this, [this] { QWidget::update(); });
  connect(&workspace, &Workspace::playing_changed, this, repaint);
  connect(&workspace, &Workspace::opened, this, &TimePane::fit_time);
}

int TimePane::line_height() const { return fontMetrics().height() * 3 / 2; }
int TimePane::ruler_height() const { return line_height(); }
QRect TimePane::time_box() const { return rect().adjusted(axis_.gutter(), 0, 0, 0); }

Time TimePane::nearest_frame(Time t) const {
  const Rate rate = workspace_.document().rate();
  return rate.frame(std::round(rate.frame_number(t)));
}

Time TimePane::time_at(const QPointF& at, Qt::KeyboardModifiers keys) const {
  const Time t = time_at(at.x());
  return keys & Qt::ControlModifier ? t : nearest_frame(t);
}

bool TimePane::in_ruler(const QPointF& at) const { return at.y() < ruler_height() && at.x() >= axis_.gutter(); }
bool TimePane::at_gutter(const QPointF& at) const { return std::abs(at.x() - axis_.gutter()) < 4; }

// Hidden panes do not change the axis.
void TimePane::fit_time() {
  if (isVisible()) axis_.fit(time_box().width());
}

void TimePane::resizeEvent(QResizeEvent*) { fit_time(); }
void TimePane::showEvent(QShowEvent*) { fit_time(); }

void TimePane::paintEvent(QPaintEvent*) {
  const QSize pixels = size() * devicePixelRatioF();
  if (!fresh_ || content_.size() != pixels) {
    content_ = QPixmap(pixels);
    content_.setDevicePixelRatio(devicePixelRatioF());
    content_.fill(colors().back);
    QPainter p(&content_);
    p.setFont(font());
    paint_content(p);
    fresh_ = true;
  }
  QPainter p(this);
  p.drawPixmap(0, 0, content_);
  paint_over(p);
  paint_playhead(p);
}

// While a panel has the focus, its keys have priority over the window's.
bool TimePane::event(QEvent* e) {
  if (e->type() == QEvent::ShortcutOverride) {
    const auto* k = static_cast<QKeyEvent*>(e);
    const bool mine = (k->key() == Qt::Key_Escape && hand_ != Hand::none) || key(k->key(), k->modifiers(), false);
    if (mine) return e->accept(), true;
  }
  switch (e->type()) {
    case QEvent::FocusIn:
    case QEvent::FocusOut:
    case QEvent::PaletteChange:
    case QEvent::FontChange:
    case QEvent::StyleChange:
      update();
      break;
    default:
      break;
  }
  return QWidget::event(e);
}

void TimePane::keyPressEvent(QKeyEvent* e) {
  if (e->key() == Qt::Key_Escape && hand_ == Hand::own) {
    hand_ = Hand::none;
    return call_off();
  }
  if (!key(e->key(), e->modifiers(), true)) QWidget::keyPressEvent(e);
}

void TimePane::mousePressEvent(QMouseEvent* e) {
  from_ = e->position();
  const bool left = e->button() == Qt::LeftButton;
  if (e->button() == Qt::MiddleButton)
    hand_ = Hand::pan;
  else if (left && at_gutter(from_))
    hand_ = Hand::gutter;
  else if (left && in_ruler(from_) && e->modifiers() & Qt::AltModifier)
    hand_ = Hand::part;
  else if (left && in_ruler(from_))
    hand_ = Hand::scrub, workspace_.pause(), workspace_.go_to(time_at(from_, e->modifiers()));
  else
    hand_ = left ? Hand::own : Hand::none, press(e);
}

void TimePane::mouseMoveEvent(QMouseEvent* e) {
  const QPointF at = e->position();
  switch (hand_) {
    case Hand::none:
      at_gutter(at) ? setCursor(Qt::SplitHCursor) : unsetCursor();
      return hover(e);
    case Hand::scrub:
      return workspace_.go_to(time_at(at, e->modifiers()));
    case Hand::gutter:
      return axis_.set_gutter(std::clamp(static_cast<int>(at.x()), 0, width() - 50));
    case Hand::part: {
      const auto [a, b] = std::minmax({time_at(from_, e->modifiers()), time_at(at, e->modifiers())});
      return workspace_.set_range(std::pair(a, b));
    }
    case Hand::pan:
      axis_.scroll(from_.x() - at.x());
      pan(at.y() - from_.y());
      from_ = at;
      return;
    case Hand::own:
      return drag(e);
  }
}

void TimePane::mouseReleaseEvent(QMouseEvent* e) {
  if (std::exchange(hand_, Hand::none) == Hand::own) release(e);
}

void TimePane::zoom_time(QWheelEvent* e) {
  const QPointF by = e->angleDelta();
  if (e->modifiers() & Qt::ShiftModifier || std::abs(by.x()) > std::abs(by.y()))
    return axis_.scroll(-(by.x() + by.y()) / 2);
  axis_.zoom(std::pow(1.0015, by.y()), e->position().x() - axis_.gutter());
}

void TimePane::wheelEvent(QWheelEvent* e) {
  wheel(e);
  e->accept();
}

void TimePane::paint_ruler(QPainter& p) const {
  const Colors& c = colors();
  const int h = ruler_height();
  p.fillRect(0, 0, width(), h, c.raised);
  p.save();
  p.setClipRect(axis_.gutter(), 0, width(), h);
  const double label = fontMetrics().horizontalAdvance(axis_.in_seconds() ? "00.00 s" : "00000");
  for (const TimeAxis::Tick& t : axis_.ticks(time_box().width(), label)) {
    const double x = axis_.gutter() + t.x;
    const bool main = !t.label.isEmpty();
    p.setPen(main ? c.dim : c.line);
    p.drawLine(QPointF(x, main ? h * 0.45 : h * 0.75), QPointF(x, h));
    const double wide = fontMetrics().horizontalAdvance(t.label);
    const double at = x + 3 + wide <= width() ? x + 3 : x - 3 - wide;  // no number is cut off at the end
    if (main) p.setPen(c.dim), p.drawText(QPointF(at, fontMetrics().ascent() + 1), t.label);
  }
  p.restore();
  p.setPen(c.line);
  p.drawLine(0, h, width(), h);
}

void TimePane::paint_lines(QPainter& p, int from, int to) const {
  const Colors& c = colors();
  const double label = fontMetrics().horizontalAdvance(axis_.in_seconds() ? "00.00 s" : "00000");
  p.save();
  p.setClipRect(axis_.gutter(), from, width(), to - from);
  QColor light = c.line;
  light.setAlphaF(0.6F);
  p.setPen(light);
  for (const TimeAxis::Tick& t : axis_.ticks(time_box().width(), label))
    if (!t.label.isEmpty()) p.drawLine(QPointF(axis_.gutter() + t.x, from), QPointF(axis_.gutter() + t.x, to));
  QColor outside = c.line;
  outside.setAlphaF(0.35F);
  const auto range = workspace_.document().range();
  const double left = axis_.gutter(), begins = x_of(range.first), ends = x_of(range.second);
  if (begins > left) p.fillRect(QRectF(left, from, begins - left, to - from), outside);
  if (ends < width()) p.fillRect(QRectF(std::max(left, ends), from, width() - ends, to - from), outside);
  p.restore();
}

void TimePane::paint_playhead(QPainter& p) const {
  const double x = x_of(workspace_.time());
  if (x < axis_.gutter() - 1 || x > width()) return;
  const Colors& c = colors();
  p.setPen(QPen(c.playhead, 1.5));
  p.drawLine(QPointF(x, ruler_height() * 0.7), QPointF(x, height()));
  const double w = fontMetrics().averageCharWidth() * 0.8, h = ruler_height() * 0.75;
  p.save();
  p.setRenderHint(QPainter::Antialiasing);
  p.setPen(Qt::NoPen), p.setBrush(c.playhead);
  p.drawPolygon(QPolygonF({{x - w, 0}, {x + w, 0}, {x + w, h * 0.6}, {x, h}, {x - w, h * 0.6}}));
  p.restore();
}

}  // namespace betwixt::studio
