// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/viewport/kind_icons.h"

#include <QIconEngine>
#include <QPainter>
#include <QPainterPath>
#include <QTransform>
#include <algorithm>
#include <cmath>
#include <functional>

#include "scene/kinds.h"
#include "studio/shell/theme.h"
#include "studio/viewport/chart_icons.h"

namespace betwixt::studio {
namespace {

// Draws into a square from 0 to 16; in white if selected.
using Drawing = std::function<void(QPainter&, bool selected)>;

class Engine : public QIconEngine {
 public:
  explicit Engine(Drawing d) : draw_(std::move(d)) {}
  void paint(QPainter* p, const QRect& r, QIcon::Mode mode, QIcon::State) override {
    p->save();
    p->setRenderHint(QPainter::Antialiasing);
    p->translate(r.topLeft());
    p->scale(r.width() / 16.0, r.height() / 16.0);
    if (mode == QIcon::Disabled) p->setOpacity(0.4);
    draw_(*p, mode == QIcon::Selected);
    p->restore();
  }
  QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
    QPixmap all(size);
    all.fill(Qt::transparent);
    QPainter p(&all);
    paint(&p, QRect({}, size), mode, state);
    return all;
  }
  QIconEngine* clone() const override { return new Engine(draw_); }

 private:
  Drawing draw_;
};

QPolygonF around(int points, double from, double outer, double inner) {
  QPolygonF all;
  const int all_of_them = inner > 0 ? 2 * points : points;
  for (int i = 0; i < all_of_them; ++i) {
    const double r = inner > 0 && i % 2 ? inner : outer, a = from + i * 2 * M_PI / all_of_them;
    all << QPointF(8 + r * std::cos(a), 8 + r * std::sin(a));
  }
  return all;
}

// The icon of a kind that has none of its own: the contours of its row, or a square.
QPainterPath outline_of(Kind k) {
  QPainterPath path;
  Shape shape;
  shape.kind = k;
  if (const auto contours = row_of(k).contours)
    for (const std::vector<Vec3>& contour : contours(shape)) {
      QPolygonF points;
      for (const Vec3& at : contour) points << QPointF(at.x, -at.y);
      path.addPolygon(points), path.closeSubpath();
    }
  const QRectF box = path.boundingRect();
  const double size = std::max(box.width(), box.height());
  if (!(size > 0)) return path = {}, path.addRoundedRect(QRectF(3, 3, 10, 10), 2, 2), path;
  return QTransform(11 / size, 0, 0, 11 / size, 8 - 11 / size * box.center().x(), 8 - 11 / size * box.center().y())
      .map(path);
}

QColor color_of(Kind k) {
  const Colors& c = colors();
  switch (k) {
    case Kind::light:
      return c.event;
    case Kind::camera:
      return c.playhead;
    case Kind::sound:
      return c.note;
    case Kind::layer:
    case Kind::environment:
      return c.cut;
    case Kind::group:
      return c.dim;
    default:
      return c.accent;
  }
}

void draw(QPainter& p, Kind k, const QColor& c) {
  QColor fill = c;
  fill.setAlpha(90);
  p.setPen(QPen(c, 1.2, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  p.setBrush(fill);
  if (draw_chart_icon(p, k)) return;
  switch (k) {
    case Kind::group:
      p.setBrush(Qt::NoBrush);
      p.drawLine(QPointF(8, 2), QPointF(8, 14)), p.drawLine(QPointF(2, 8), QPointF(14, 8));
      return p.drawEllipse(QPointF(8, 8), 2.5, 2.5);
    case Kind::sphere:
      p.drawEllipse(QPointF(8, 8), 5.5, 5.5);
      p.setBrush(Qt::NoBrush);
      return p.drawEllipse(QPointF(8, 8), 5.5, 2);
    case Kind::box:
      p.drawPolygon(QPolygonF({{2.5, 5.5}, {10, 5.5}, {10, 13.5}, {2.5, 13.5}}));
      p.drawPolygon(QPolygonF({{2.5, 5.5}, {5.5, 2.5}, {13.5, 2.5}, {10, 5.5}}));
      return p.drawPolygon(QPolygonF({{10, 5.5}, {13.5, 2.5}, {13.5, 10.5}, {10, 13.5}}));
    case Kind::cylinder:
      p.drawRect(QRectF(3.5, 4, 9, 8.5));
      return p.drawEllipse(QPointF(8, 4), 4.5, 1.8);
    case Kind::cone:
      return p.drawPolygon(QPolygonF({{8, 2}, {13, 12.5}, {8, 14}, {3, 12.5}}));
    case Kind::torus:
      p.drawEllipse(QPointF(8, 8), 6, 4.5);
      p.setBrush(Qt::NoBrush);
      return p.drawEllipse(QPointF(8, 8), 2.2, 1.2);
    case Kind::plane:
      return p.drawPolygon(QPolygonF({{5, 4.5}, {14, 4.5}, {11, 11.5}, {2, 11.5}}));
    case Kind::rectangle:
      return p.drawRect(QRectF(2.5, 4.5, 11, 7));
    case Kind::video:
      p.drawRect(QRectF(2.5, 4, 11, 8));
      return p.drawPolygon(QPolygonF({{6.5, 6}, {10.5, 8}, {6.5, 10}}));
    case Kind::disc:
      return p.drawEllipse(QPointF(8, 8), 5.5, 5.5);
    case Kind::ring: {
      QPainterPath ring;
      ring.addEllipse(QPointF(8, 8), 5.5, 5.5), ring.addEllipse(QPointF(8, 8), 2.8, 2.8);
      return p.drawPath(ring);
    }
    case Kind::arc:
      p.setPen(QPen(c, 2.4, Qt::SolidLine, Qt::RoundCap));
      return p.drawArc(QRectF(2.5, 4, 12, 12), 20 * 16, 140 * 16);
    case Kind::regular:
      return p.drawPolygon(around(6, -M_PI / 2, 6, 0));
    case Kind::star:
      return p.drawPolygon(around(5, -M_PI / 2, 6.5, 2.8));
    case Kind::gear:
      return p.drawPolygon(around(8, 0, 6.5, 4.6));
    case Kind::polygon:
      return p.drawPolygon(QPolygonF({{3, 12.5}, {4, 4}, {11, 3}, {13.5, 9}, {8, 13.5}}));
    case Kind::arrow:
      p.drawLine(QPointF(2.5, 8), QPointF(10, 8));
      return p.drawPolygon(QPolygonF({{9, 4.5}, {14, 8}, {9, 11.5}}));
    case Kind::line:
      return p.drawLine(QPointF(3, 13), QPointF(13, 3));
    case Kind::polyline:
      return p.drawPolyline(QPolygonF({{2.5, 12}, {6, 4}, {10, 11}, {13.5, 4}}));
    case Kind::curve:
    case Kind::trace: {
      QPainterPath way(QPointF(2.5, 12));
      way.cubicTo(6, 0, 10, 16, 13.5, 4);
      p.setBrush(Qt::NoBrush);
      if (k == Kind::trace) p.setPen(QPen(c, 1.4, Qt::DotLine, Qt::RoundCap));
      return p.drawPath(way);
    }
    case Kind::points:
      p.setBrush(c);
      for (const QPointF at : {QPointF(4, 5), QPointF(11, 4), QPointF(7, 9), QPointF(12, 11), QPointF(4, 12.5)})
        p.drawEllipse(at, 1, 1);
      return;
    case Kind::text:
      p.setPen(QPen(c, 1.8));
      p.drawLine(QPointF(3.5, 3.5), QPointF(12.5, 3.5));
      return p.drawLine(QPointF(8, 3.5), QPointF(8, 13));
    case Kind::mesh: {
      const QPolygonF all = around(6, -M_PI / 2, 6.2, 0);
      p.drawPolygon(all);
      for (const int i : {0, 2, 4}) p.drawLine(QPointF(8, 8), all[i]);
      return;
    }
    case Kind::light:
      p.drawEllipse(QPointF(8, 8), 2.8, 2.8);
      for (int i = 0; i < 8; ++i) {
        const double a = i * M_PI / 4;
        p.drawLine(QPointF(8 + 4.6 * std::cos(a), 8 + 4.6 * std::sin(a)),
                   QPointF(8 + 6.6 * std::cos(a), 8 + 6.6 * std::sin(a)));
      }
      return;
    case Kind::camera:
      p.drawRoundedRect(QRectF(2, 5, 8, 7), 1, 1);
      return p.drawPolygon(QPolygonF({{10, 8.5}, {14, 5.5}, {14, 11.5}}));
    case Kind::sound:
      p.drawPolygon(QPolygonF({{2.5, 6}, {5, 6}, {8.5, 3}, {8.5, 13}, {5, 10}, {2.5, 10}}));
      return p.drawArc(QRectF(7, 4, 6, 8), -60 * 16, 120 * 16);
    case Kind::layer:
      p.drawPolygon(QPolygonF({{8, 6.5}, {14, 9.5}, {8, 12.5}, {2, 9.5}}));
      return p.drawPolygon(QPolygonF({{8, 3}, {14, 6}, {8, 9}, {2, 6}}));
    case Kind::environment:
      p.setBrush(Qt::NoBrush);
      for (const double y : {5.0, 8.5, 12.0}) {
        QPainterPath wave(QPointF(2.5, y));
        wave.cubicTo(5.5, y - 3.5, 10.5, y + 3.5, 13.5, y);
        p.drawPath(wave);
      }
      return;
    default:
      return p.drawPath(outline_of(k));
  }
}

}  // namespace

QIcon kind_icon(Kind k) {
  return QIcon(
      new Engine([k](QPainter& p, bool selected) { draw(p, k, selected ? text_on(colors().accent) : color_of(k)); }));
}

QIcon eye_icon(bool open) {
  return QIcon(new Engine([open](QPainter& p, bool selected) {
    const QColor c = selected ? text_on(colors().accent) : open ? colors().text : colors().dim;
    p.setPen(QPen(c, 1.2));
    QPainterPath lid(QPointF(1.5, 8));
    lid.quadTo(8, open ? 1.5 : 8, 14.5, 8);
    lid.quadTo(8, open ? 14.5 : 12, 1.5, 8);
    p.drawPath(lid);
    if (!open) return;
    p.setBrush(c);
    p.drawEllipse(QPointF(8, 8), 2, 2);
  }));
}

}  // namespace betwixt::studio
