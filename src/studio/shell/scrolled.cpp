// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/shell/scrolled.h"

#include <QCoreApplication>
#include <QEvent>
#include <QScrollBar>
#include <QVBoxLayout>
#include <QWheelEvent>
#include <algorithm>

namespace betwixt::studio {

Scrolled::Scrolled(QWidget* content, Qt::Orientation way, QWidget* parent) : QScrollArea(parent), way_(way) {
  const bool across = way == Qt::Horizontal;
  setHorizontalScrollBarPolicy(across ? Qt::ScrollBarAsNeeded : Qt::ScrollBarAlwaysOff);
  setVerticalScrollBarPolicy(across ? Qt::ScrollBarAlwaysOff : Qt::ScrollBarAsNeeded);
  setFrameShape(QFrame::NoFrame), setFocusPolicy(Qt::NoFocus);
  setWidgetResizable(true);
  setWidget(content);
  content->setAutoFillBackground(false), viewport()->setAutoFillBackground(false);
  if (across) setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
}

int Scrolled::bar() const {
  if (way_ == Qt::Vertical) return verticalScrollBar()->sizeHint().width();
  return width() < widget()->minimumSizeHint().width() ? horizontalScrollBar()->sizeHint().height() : 0;
}

QSize Scrolled::sizeHint() const {
  const QSize all = widget()->sizeHint();
  if (way_ == Qt::Horizontal) return all + QSize(0, bar());
  const int room = width() - bar();  // a text that wraps is as high as its width lets it be
  return widget()->hasHeightForWidth() && isVisible() ? QSize(all.width(), widget()->heightForWidth(room)) : all;
}

QSize Scrolled::minimumSizeHint() const {
  const QSize all = widget()->minimumSizeHint();
  const int line = fontMetrics().height();
  return way_ == Qt::Horizontal ? QSize(std::min(all.width(), 4 * line), widget()->sizeHint().height() + bar())
                                : QSize(all.width() + bar(), std::min(all.height(), 2 * line));
}

bool Scrolled::event(QEvent* e) {
  const bool done = QScrollArea::event(e);
  if (e->type() == QEvent::LayoutRequest) updateGeometry();
  return done;
}

void Scrolled::resizeEvent(QResizeEvent* e) {
  QScrollArea::resizeEvent(e);
  if (e->oldSize().width() != e->size().width()) updateGeometry();
}

// A bar has nothing to scroll upwards.
void Scrolled::wheelEvent(QWheelEvent* e) {
  if (way_ == Qt::Vertical || e->angleDelta().x() != 0) return QScrollArea::wheelEvent(e);
  QCoreApplication::sendEvent(horizontalScrollBar(), e);
}

QVBoxLayout* scrolled_column(QWidget& panel) {
  auto* content = new QWidget(&panel);
  auto* around = new QVBoxLayout(&panel);
  around->setContentsMargins(0, 0, 0, 0);
  around->addWidget(new Scrolled(content, Qt::Vertical, &panel));
  return new QVBoxLayout(content);
}

}  // namespace betwixt::studio
