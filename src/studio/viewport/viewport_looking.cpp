// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What the view shows: through which object it looks, which objects are isolated, and guides over the film's frame.
#include <QPainter>

#include "betwixt/object.h"
#include "studio/shell/theme.h"
#include "studio/viewport/looking.h"
#include "studio/viewport/viewport.h"

namespace betwixt::studio {

std::optional<Camera> Viewport::own_eye(Time t) const {
  if (!through_) return free_;
  if (t == shown_time()) return eye_of(workspace_.program(), through_, t, frame());
  return eye_of(workspace_.program(), through_, t, workspace_.program().frame(t));
}

void Viewport::look_through() {
  const ObjectId active = workspace_.selected().empty() ? ObjectId{} : workspace_.selected().back();
  if (!active && !through_) {
    refusal_ = tr("select the object to look through");
    return update();
  }
  if (pull_) end_pull(false);
  through_ = through_ && (through_ == active || !active) ? ObjectId{} : active;
  outline_.reset(), grid_.reset(), icons_.reset();
  workspace_.set_view(own_eye(workspace_.time()));
  ask();
  show_corner();
  update();
}

void Viewport::isolate() {
  if (workspace_.left_out()) return workspace_.leave_out(nullptr);
  if (workspace_.selected().empty()) {
    refusal_ = tr("select what you want to see alone");
    return update();
  }
  const Marks shown(with_what_hangs_on(workspace_.selected()));
  Marks others;
  for (const ObjectId id : objects(workspace_.document()))
    if (!shown(id)) others.add(id);
  workspace_.leave_out(std::make_shared<const Marks>(std::move(others)));
}

void Viewport::paint_guides(QPainter& p) const {
  const QRectF box = frame_box();
  const auto line_of = [&](const auto& draw) {
    for (const bool shade : {true, false}) {
      p.setPen(QPen(shade ? QColor(0, 0, 0, 110) : QColor(255, 255, 255, 190), shade ? 3 : 1));
      draw();
    }
  };
  p.setBrush(Qt::NoBrush);
  p.setRenderHint(QPainter::Antialiasing, false);
  if (switches_.safe)
    for (const double part : {0.9, 0.8}) {
      const QSizeF margin = box.size() * (1 - part) / 2;
      const QRectF inside = box.adjusted(margin.width(), margin.height(), -margin.width(), -margin.height());
      line_of([&] { p.drawRect(inside); });
      p.drawText(inside.topLeft() + QPointF(4, fontMetrics().ascent() + 2), part > 0.85 ? tr("action") : tr("title"));
    }
  if (switches_.thirds)
    for (const double part : {1.0 / 3, 2.0 / 3})
      line_of([&] {
        const double x = box.left() + part * box.width(), y = box.top() + part * box.height();
        p.drawLine(QPointF(x, box.top()), QPointF(x, box.bottom()));
        p.drawLine(QPointF(box.left(), y), QPointF(box.right(), y));
      });
}

}  // namespace betwixt::studio
