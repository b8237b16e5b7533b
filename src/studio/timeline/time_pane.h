// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The base of all panels with a horizontal time axis: a ruler on top, the playhead, names at the left, and the gestures
// that concern only time.
#pragma once

#include <QPixmap>
#include <QWidget>
#include <optional>

#include "studio/timeline/time_axis.h"

class QPainter;

namespace betwixt::studio {

class TimePane : public QWidget {
  Q_OBJECT
 public:
  explicit TimePane(Workspace&, QWidget* parent = nullptr);
  QSize sizeHint() const override { return {40 * line_height(), 8 * line_height()}; }

  double x_of(Time t) const { return axis_.gutter() + axis_.x_of(t); }
  Time time_at(double x) const { return axis_.time_at(x - axis_.gutter()); }
  // Returns the time at the nearest frame; with Ctrl, the exact time.
  Time time_at(const QPointF&, Qt::KeyboardModifiers) const;
  int ruler_height() const;
  void update() { fresh_ = false, QWidget::update(); }

 protected:
  // Paints all but the playhead, which moves alone during playback.
  virtual void paint_content(QPainter&) = 0;
  virtual void paint_over(QPainter&) const {}  // what changes often, too
  // Called for presses that are no gesture of time; moves and a release follow.
  virtual void press(QMouseEvent*) {}
  virtual void drag(QMouseEvent*) {}
  virtual void release(QMouseEvent*) {}
  virtual void hover(QMouseEvent*) {}
  virtual void pan(double) {}  // vertically, in pixels
  virtual void call_off() {}   // Escape during a drag
  // Returns whether a key has an action here. Carries it out only if the last argument is true.
  virtual bool key(int, Qt::KeyboardModifiers, bool) { return false; }
  virtual void wheel(QWheelEvent* e) { zoom_time(e); }
  virtual bool in_ruler(const QPointF& at) const;

  void zoom_time(QWheelEvent*);
  bool dragging() const { return hand_ == Hand::own; }
  Time nearest_frame(Time) const;
  QRect time_box() const;  // the area right of the names
  int line_height() const;
  void paint_ruler(QPainter&) const;
  // Paints light lines at the ruler's labels, and shades the time outside the film's range.
  void paint_lines(QPainter&, int from, int to) const;
  void paint_playhead(QPainter&) const;

  Workspace& workspace_;
  TimeAxis& axis_;

  bool event(QEvent*) override;
  void paintEvent(QPaintEvent*) final;
  void mousePressEvent(QMouseEvent*) override;
  void mouseMoveEvent(QMouseEvent*) override;
  void mouseReleaseEvent(QMouseEvent*) override;
  void wheelEvent(QWheelEvent*) override;
  void keyPressEvent(QKeyEvent*) override;
  void resizeEvent(QResizeEvent*) override;
  void showEvent(QShowEvent*) override;

 private:
  enum class Hand { none, scrub, pan, gutter, part, own };
  bool at_gutter(const QPointF&) const;
  void fit_time();

  Hand hand_ = Hand::none;
  QPointF from_;
  QPixmap content_;
  bool fresh_ = false;  // content_ is up to date
};

}  // namespace betwixt::studio
