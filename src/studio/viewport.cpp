// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/viewport.h"

#include <QPainter>
#include <algorithm>

namespace betwixt::studio {

Viewport::Viewport(Desk& desk, QWidget* parent) : QWidget(parent), desk_(desk) {
  setObjectName("viewport");
  setWindowTitle(tr("Picture"));
  setFocusPolicy(Qt::StrongFocus);
  connect(&desk, &Desk::document_changed, this, &Viewport::ask);
  connect(&desk, &Desk::time_changed, this, &Viewport::ask);
  connect(&maker_, &PictureMaker::made, this, &Viewport::take, Qt::QueuedConnection);
}

// The largest box of the film's own shape.
QRect Viewport::frame_box() const {
  const double aspect = desk_.document().aspect();
  const int w = std::max(1, std::min(width(), static_cast<int>(height() * aspect)));
  const int h = std::max(1, static_cast<int>(w / aspect));
  return {(width() - w) / 2, (height() - h) / 2, w, h};
}

PictureWanted Viewport::wanted() const {
  const QSize size = frame_box().size() * devicePixelRatioF();
  RenderOptions o;
  o.width = std::clamp(size.width(), 1, 8192), o.height = std::clamp(size.height(), 1, 8192);
  o.style = style_;
  return {desk_.program(), desk_.time(), o, std::nullopt};
}

void Viewport::ask() {
  if (isVisible()) maker_.want(wanted());
}

void Viewport::take(const PictureMade& made) {
  shown_ = made;
  desk_.picture_shown();
  update();
}

void Viewport::await_picture() { take(PictureMaker::make(wanted())); }

void Viewport::set_style(const std::string& style) {
  style_ = style;
  ask();
  emit style_changed();
}

void Viewport::resizeEvent(QResizeEvent*) { ask(); }

void Viewport::paintEvent(QPaintEvent*) {
  QPainter p(this);
  p.fillRect(rect(), palette().color(QPalette::Window));
  p.setRenderHint(QPainter::SmoothPixmapTransform);
  if (!shown_.image.isNull()) p.drawImage(frame_box(), shown_.image);
}

}  // namespace betwixt::studio
