// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/viewport/chart_icons.h"

#include <QPainterPath>
#include <initializer_list>

namespace betwixt::studio {
namespace {

void draw_line(QPainter& p, double x0, double y0, double x1, double y1) {
  p.drawLine(QPointF(x0, y0), QPointF(x1, y1));
}

void draw_dots(QPainter& p, double radius, std::initializer_list<QPointF> at) {
  p.setBrush(p.pen().color());
  for (const QPointF& middle : at) p.drawEllipse(middle, radius, radius);
}

// Faint axes at the left and at the bottom, on which a plot lies.
void draw_corner(QPainter& p) {
  const QPen pen = p.pen();
  QColor faint = pen.color();
  faint.setAlpha(130);
  p.setPen(QPen(faint, 1));
  draw_line(p, 2.5, 2, 2.5, 13.5), draw_line(p, 2.5, 13.5, 14, 13.5);
  p.setPen(pen);
}

QPainterPath graph() {
  QPainterPath way(QPointF(2.5, 11));
  way.cubicTo(6, 0, 9, 14, 14, 3);
  return way;
}

void draw_curve(QPainter& p, const QPainterPath& way) {
  const QBrush brush = p.brush();
  p.setBrush(Qt::NoBrush);
  p.drawPath(way);
  p.setBrush(brush);
}

void draw_tip(QPainter& p, double x, double y, double dx, double dy) {
  p.drawPolyline(QPolygonF(
      {{x - 2 * dx - 1.5 * dy, y - 2 * dy + 1.5 * dx}, {x, y}, {x - 2 * dx + 1.5 * dy, y - 2 * dy - 1.5 * dx}}));
}

void draw_axes_icon(QPainter& p, Kind k) {
  if (k == Kind::axes) {
    draw_line(p, 4.5, 14, 4.5, 2.5), draw_line(p, 2, 11.5, 13.5, 11.5);
    draw_tip(p, 4.5, 2.5, 0, -1), draw_tip(p, 13.5, 11.5, 1, 0);
  } else if (k == Kind::number_line) {
    draw_line(p, 2, 8, 14, 8), draw_tip(p, 14, 8, 1, 0);
    for (const double x : {4.0, 7.0, 10.0}) draw_line(p, x, 6, x, 10);
  } else if (k == Kind::polar_axes) {
    p.setBrush(Qt::NoBrush);
    for (const double r : {3.0, 6.0}) p.drawEllipse(QPointF(8, 8), r, r);
    draw_line(p, 2, 8, 14, 8), draw_line(p, 8, 2, 8, 14);
  } else {  // a plane that a map has slanted
    for (const double at : {0.0, 3.0, 6.0, 9.0})
      draw_line(p, 2 + at, 13, 5 + at, 3), draw_line(p, 2 + at / 3, 13 - at * 10 / 9, 11 + at / 3, 13 - at * 10 / 9);
  }
}

void draw_plot_icon(QPainter& p, Kind k) {
  if (k != Kind::vector_field && k != Kind::streamlines && k != Kind::surface) draw_corner(p);
  if (k == Kind::plot) return draw_curve(p, graph());
  if (k == Kind::area) {
    QPainterPath under = graph();
    under.lineTo(14, 13.5), under.lineTo(2.5, 13.5);
    return p.drawPath(under);
  }
  if (k == Kind::riemann) {
    int i = 0;
    for (const double top : {9.0, 6.0, 4.5, 3.0}) p.drawRect(QRectF(2.5 + 2.8 * i++, top, 2.8, 13.5 - top));
  } else if (k == Kind::tangent) {
    QPainterPath bow(QPointF(3, 4));
    bow.quadTo(7, 18, 14, 4);
    draw_curve(p, bow);
    draw_line(p, 6, 14.5, 14.5, 6.5);
  } else if (k == Kind::scatter) {
    draw_dots(p, 0.9, {{5, 10.5}, {7, 8}, {8.5, 10}, {10, 5.5}, {12.5, 6.5}, {12.5, 3}});
  } else if (k == Kind::vector_field) {
    for (const double x : {6.0, 13.5})
      for (const double y : {2.5, 7.5, 12.0}) draw_line(p, x - 4, y + 2, x, y), draw_tip(p, x, y, 0.8, -0.4);
  } else if (k == Kind::streamlines) {
    for (const double y : {4.0, 8.0, 12.0}) {
      QPainterPath flow(QPointF(2, y + 1));
      flow.cubicTo(6, y - 4, 9, y + 4, 14, y - 1);
      draw_curve(p, flow);
    }
    draw_tip(p, 14, 3, 0.9, -0.4), draw_tip(p, 14, 11, 0.9, -0.4);
  } else {  // a surface: a sheet with a hill
    QPainterPath sheet(QPointF(1.5, 11));
    sheet.cubicTo(5, 3, 8, 13, 10.5, 9.5), sheet.lineTo(14.5, 5), sheet.cubicTo(11, 8, 8, -1, 5.5, 5.5);
    sheet.closeSubpath();
    p.drawPath(sheet);
    draw_line(p, 4.5, 8, 11.5, 6);
  }
}

void draw_data_icon(QPainter& p, Kind k) {
  if (k == Kind::bars) {
    double y = 2.5;
    for (const double length : {11.0, 6.0, 9.0}) p.drawRect(QRectF(2.5, y, length, 2.6)), y += 4;
  } else if (k == Kind::columns) {
    double x = 2.5;
    for (const double height : {6.0, 11.0, 8.0}) p.drawRect(QRectF(x, 13.5 - height, 2.6, height)), x += 4;
  } else if (k == Kind::bar) {
    p.drawRect(QRectF(6, 3, 4, 10.5));
    draw_line(p, 2.5, 13.5, 13.5, 13.5);
  } else if (k == Kind::line_chart) {
    draw_corner(p);
    p.drawPolyline(QPolygonF({{4, 10.5}, {7, 6}, {10, 8.5}, {13.5, 3}}));
    draw_dots(p, 1.2, {{4, 10.5}, {7, 6}, {10, 8.5}, {13.5, 3}});
  } else if (k == Kind::dot) {
    draw_dots(p, 2.4, {{8, 8}});
  } else if (k == Kind::pie) {
    p.drawPie(QRectF(2, 3, 11, 11), 90 * 16, 270 * 16);
    p.drawPie(QRectF(4, 1.5, 11, 11), 0, 90 * 16);
  } else if (k == Kind::table) {
    p.drawRect(QRectF(2, 3, 12, 3.2));
    p.setBrush(Qt::NoBrush);
    p.drawRect(QRectF(2, 3, 12, 10.5));
    draw_line(p, 2, 9.8, 14, 9.8), draw_line(p, 8, 3, 8, 13.5);
  } else {  // a matrix: brackets around numbers
    p.drawPolyline(QPolygonF({{4.5, 2.5}, {2.5, 2.5}, {2.5, 13.5}, {4.5, 13.5}}));
    p.drawPolyline(QPolygonF({{11.5, 2.5}, {13.5, 2.5}, {13.5, 13.5}, {11.5, 13.5}}));
    draw_dots(p, 0.8, {{6, 5.5}, {10, 5.5}, {6, 10.5}, {10, 10.5}});
  }
}

void draw_explaining_icon(QPainter& p, Kind k) {
  if (k == Kind::code) {
    p.drawPolyline(QPolygonF({{5, 4.5}, {1.8, 8}, {5, 11.5}}));
    p.drawPolyline(QPolygonF({{11, 4.5}, {14.2, 8}, {11, 11.5}}));
    draw_line(p, 9.3, 3, 6.7, 13);
  } else if (k == Kind::diagram) {
    p.drawRect(QRectF(5.5, 2, 5, 3.5));
    p.drawRect(QRectF(1.5, 10.5, 5, 3.5)), p.drawRect(QRectF(9.5, 10.5, 5, 3.5));
    draw_line(p, 7.2, 5.5, 4.4, 10.5), draw_line(p, 8.8, 5.5, 11.6, 10.5);
  } else {  // a brace
    QPainterPath way(QPointF(2, 6));
    way.cubicTo(2, 10, 8, 6, 8, 11);
    way.cubicTo(8, 6, 14, 10, 14, 6);
    draw_curve(p, way);
  }
}

}  // namespace

bool draw_chart_icon(QPainter& p, Kind k) {
  switch (k) {
    case Kind::axes:
    case Kind::number_line:
    case Kind::polar_axes:
    case Kind::plane_grid:
      return draw_axes_icon(p, k), true;
    case Kind::plot:
    case Kind::area:
    case Kind::riemann:
    case Kind::tangent:
    case Kind::scatter:
    case Kind::vector_field:
    case Kind::streamlines:
    case Kind::surface:
      return draw_plot_icon(p, k), true;
    case Kind::bars:
    case Kind::columns:
    case Kind::bar:
    case Kind::line_chart:
    case Kind::dot:
    case Kind::pie:
    case Kind::table:
    case Kind::matrix:
      return draw_data_icon(p, k), true;
    case Kind::code:
    case Kind::diagram:
    case Kind::brace:
      return draw_explaining_icon(p, k), true;
    default:
      return false;
  }
}

}  // namespace betwixt::studio
