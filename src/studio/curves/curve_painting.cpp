// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "scene/document.h"
#include "studio/curves/curve_pane.h"
#include "studio/shell/text_of.h"
#include "studio/shell/theme.h"

namespace betwixt::studio {
namespace {

// Returns the colour for the curves of a further function: its hue goes round in steps that do not meet again soon, and
// every second one is paler, which helps people who do not see all hues.
QColor shaded(QColor c, int shade) {
  if (shade == 0) return c;
  constexpr int step = 47;
  const int paler = shade % 2 == 1 ? 60 : 100;
  return QColor::fromHsv((c.hsvHue() + step * shade) % 360, c.hsvSaturation() * paler / 100, c.value());
}

// Returns whether a curve is the number of a track, also after the track was separated into components.
bool same_number(const CurveLine& line, const Target& t, int part) {
  const auto whole = [](Target of) {
    of.component = -1;
    return of;
  };
  const auto axis = [](const Target& of, int number) { return of.component >= 0 ? of.component : number; };
  return whole(line.target) == whole(t) && axis(line.target, line.part) == axis(t, part);
}

}  // namespace

QColor CurvePane::color(const CurveLine& line) const {
  const Colors& c = colors();
  const QColor all[] = {c.x, c.y, c.z, c.event};
  return shaded(all[line.color], line.shade);
}

// Draws lines at round values, with their numbers.
void CurvePane::paint_values(QPainter& p) const {
  if (each_fills_) return;
  const Colors& c = colors();
  const double least = 2.5 * line_height() / scale_, power = std::pow(10, std::floor(std::log10(least)));
  double step = 10 * power;
  for (const double k : {5., 2., 1.})
    if (k * power >= least) step = k * power;
  const double low = level_at(height()), high = level_at(ruler_height());
  if (!((high - low) / step < 1000)) return;
  for (double i = std::ceil(low / step); i * step <= high; ++i) {
    const double y = y_of(i * step);
    p.setPen(faint(i == 0 ? c.dim : c.line, i == 0 ? 0.7F : 0.5F));
    p.drawLine(QPointF(axis_.gutter(), y), QPointF(width(), y));
    p.setPen(c.dim);
    p.drawText(QPointF(axis_.gutter() + 4, y - 2), QString::number(i * step, 'g', 6));
  }
}

void CurvePane::paint_names(QPainter& p) const {
  const Colors& c = colors();
  const int w = axis_.gutter();
  p.fillRect(0, ruler_height() + 1, w, height(), c.back);
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    const double top = ruler_height() + 2 + static_cast<double>(i) * line_height(), r = line_height() * 0.18;
    if (top > height()) break;
    const QPointF dot(line_height() / 2.0, top + line_height() / 2.0);
    p.setPen(QPen(color(lines_[i]), 1.5));
    p.setBrush(seen(i) ? QBrush(color(lines_[i])) : Qt::NoBrush);
    p.drawEllipse(dot, r, r);
    p.setPen(seen(i) ? c.text : c.dim);
    const QRectF box(line_height(), top, w - line_height() * 1.2, line_height());
    p.drawText(box, Qt::AlignVCenter,
               fontMetrics().elidedText(QString::fromStdString(lines_[i].name), Qt::ElideMiddle,
                                        static_cast<int>(box.width())));
  }
  p.setPen(c.line);
  p.drawLine(w, 0, w, height());
}

void CurvePane::paint_curves(QPainter& p) const {
  const double left = axis_.gutter();
  const auto path = [&](std::size_t line, auto&& value) {
    QPainterPath way;
    bool on = false;
    for (std::size_t x = 0; x < samples_.columns(); ++x) {
      const std::optional<double> v = value(line, x);
      if (!v) continue;  // not computed yet
      const QPointF at(left + static_cast<double>(x), std::clamp(y_of(line, *v), -1e5, 1e5));
      if (on && lines_[line].steps && way.currentPosition().y() != at.y())
        way.lineTo(at.x(), way.currentPosition().y());
      on ? way.lineTo(at) : way.moveTo(at);
      on = true;
    }
    return way;
  };
  for (std::size_t i = 0; i < lines_.size() && i < samples_.lines().size(); ++i) {
    if (!seen(i)) continue;
    const CurveLine& line = lines_[i];
    if (line.swatch) {  // draw colours as bands, one above the other
      const double h = line_height() * 0.8, y = strip(i) - h / 2;
      std::optional<Color> last;
      for (std::size_t x = 0; x < samples_.columns(); ++x) {
        if (const auto c = samples_.color(i, x)) last = c;
        if (last) p.fillRect(QRectF(left + static_cast<double>(x), y, 1, h), swatch(*last));
      }
      continue;
    }
    p.setBrush(Qt::NoBrush);
    if (samples_.has_bare(i)) {
      p.setPen(QPen(faint(color(line), 0.55F), 1, Qt::DashLine));
      p.drawPath(path(i, [&](std::size_t l, std::size_t x) { return samples_.bare(l, x); }));
    }
    p.setPen(QPen(color(line), line.tracked ? 1.8 : 1.4));
    p.drawPath(path(i, [&](std::size_t l, std::size_t x) { return samples_.final(l, x); }));
  }
}

void CurvePane::paint_reference(QPainter& p) const {
  p.setBrush(Qt::NoBrush);
  for (std::size_t i = 0; i < lines_.size(); ++i)
    for (const Reference& frozen : reference_) {
      if (!seen(i) || !same_number(lines_[i], frozen.target, frozen.part)) continue;
      QPolygonF way;
      for (const auto& [time, value] : frozen.points) way << QPointF(x_of(time), std::clamp(y_of(i, value), -1e5, 1e5));
      p.setPen(QPen(faint(colors().text, 0.35F), 3));
      p.drawPolyline(way);
    }
}

void CurvePane::paint_events(QPainter& p) const {
  using What = Handle::What;
  const Colors& c = colors();
  for (const auto& [line, h] : handles()) {
    const QColor ink = color(lines_[line]);
    const QPointF at = place(line, h), base = place(line, h.from, h.base);
    const double r = reach() * 0.55;
    if (h.what == What::ease_in || h.what == What::ease_out) {
      const bool none = h.time == h.from;
      p.setPen(QPen(faint(none ? c.dim : c.accent, none ? 0.5F : 0.9F), none ? 1 : 3, Qt::SolidLine, Qt::RoundCap));
      p.drawLine(QPointF(base.x(), at.y()), at);
      p.setPen(QPen(none ? c.dim : c.accent, 1)), p.setBrush(c.back);
      p.drawRect(QRectF(at.x() - r * 0.7, at.y() - r * 0.7, 1.4 * r, 1.4 * r));
      continue;
    }
    p.setPen(QPen(faint(ink, 0.8F), 1));
    p.drawLine(base, at);
    p.setPen(QPen(ink, 1.5)), p.setBrush(c.back);
    p.drawEllipse(at, r, r);
  }
  for (const auto& [line, h] : points()) {
    const bool on = is_selected(h.event);
    const double r = reach() * (on ? 0.75 : 0.6);
    const QPointF at = place(line, h);
    p.setPen(QPen(on ? c.accent : c.back, on ? 2 : 1)), p.setBrush(on ? c.selected : color(lines_[line]));
    p.drawEllipse(at, r, r);
  }
}

// Draws a ring at each overshoot, and the twerper that prevents it.
void CurvePane::paint_swings(QPainter& p) const {
  const Colors& c = colors();
  for (const auto& [line, far] : swings_) {
    if (!seen(line)) continue;
    const QPointF at = place(line, far.at, far.value);
    const double r = reach();
    if (at.x() < axis_.gutter()) continue;
    p.setBrush(Qt::NoBrush), p.setPen(QPen(c.warning, 2));
    p.drawEllipse(at, r, r);
    p.drawText(at + QPointF(1.5 * r, at.y() < ruler_height() + line_height() ? 2 * r : -r), tr("auto?"));
  }
}

// Draws the twerper's name in the middle of the segment after each selected event.
void CurvePane::paint_twerpers(QPainter& p) const {
  const Colors& c = colors();
  const Document& d = workspace_.document();
  int said = 0;
  words_.clear();
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    if (!seen(i) || (lines_[i].part > 0 && lines_[i - 1].target == lines_[i].target)) continue;
    for (const EventAt& e : workspace_.events_selected()) {
      if (e.target != lines_[i].target || said > 50) continue;
      const auto next = next_event(d, e.target, e.time + Time{1});
      const auto track = betwixt::track(d, e.target);
      if (!next || !track) continue;
      const double x = (x_of(e.time) + x_of(*next)) / 2;
      const auto column = static_cast<std::int64_t>(x) - axis_.gutter();
      if (column < 0 || column >= static_cast<std::int64_t>(samples_.columns())) continue;
      const auto v = samples_.final(i, static_cast<std::size_t>(column));
      if (!v && !lines_[i].swatch) continue;
      each_event(d, e.target, e.time, e.time, [&](const EventView& view) {
        const std::string_view name = twerper_of(*track, view);
        const QString words = text_of(name);
        const double w = fontMetrics().horizontalAdvance(words) + 8;
        if (w > x_of(*next) - x_of(e.time)) return;
        const double y = lines_[i].swatch ? strip(i) : y_of(i, *v) - line_height() * 0.9;
        const QRectF box(x - w / 2, y - line_height() / 2.0, w, line_height() * 0.9);
        p.setPen(QPen(c.line, 1)), p.setBrush(faint(c.raised, 0.85F));
        p.drawRoundedRect(box, 3, 3);
        p.setPen(view.twerper.empty() || !track->twerper.empty() ? c.dim : c.text);
        p.drawText(box, Qt::AlignCenter, words);
        words_.push_back(box);
        ++said;
      });
    }
  }
}

void CurvePane::paint_content(QPainter& p) {
  const Colors& c = colors();
  p.fillRect(rect(), c.back);
  paint_lines(p, ruler_height() + 1, height());
  p.setClipRect(time_box().adjusted(0, ruler_height(), 0, 0));
  paint_values(p);
  p.setRenderHint(QPainter::Antialiasing);
  paint_reference(p), paint_curves(p), paint_swings(p), paint_events(p), paint_twerpers(p);
  if (hand_ == Hand::box && dragging()) {
    p.setPen(QPen(c.accent, 1, Qt::DashLine)), p.setBrush(faint(c.accent, 0.1F));
    p.drawRect(QRectF(from_, to_).normalized());
  }
  p.setClipping(false);
  paint_names(p);
  p.setRenderHint(QPainter::Antialiasing, false);
  paint_ruler(p);
  if (lines_.empty()) {
    p.setPen(c.dim);
    p.drawText(time_box(), Qt::AlignCenter,
               workspace_.selected().empty() ? tr("This panel shows the curves of the selected objects.")
                                             : tr("The selection has no events yet; K writes one at the playhead."));
  }
}

}  // namespace betwixt::studio
