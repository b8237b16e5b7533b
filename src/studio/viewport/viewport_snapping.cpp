// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Places under the pointer: what a moved object snaps to, and what is measured.
#include <QPainter>
#include <algorithm>

#include "language/values.h"
#include "scene/kinds.h"
#include "studio/shell/theme.h"
#include "studio/viewport/viewport.h"

namespace betwixt::studio {
namespace {

constexpr double snap_reach = 12;              // pixels
constexpr std::size_t most_snapped_to = 2000;  // objects

// Calls f with the origin of an object and the corners of its box.
template <class F>
void each_point(const Item& i, F&& f) {
  f(translation_of(i.world));
  const Extent e = extent(*i.shape);
  if (e.empty() || i.toward) return;
  for (unsigned k = 0; k < 8; ++k)
    f(transform_point(i.world, {k & 1 ? e.high.x : e.low.x, k & 2 ? e.high.y : e.low.y, k & 4 ? e.high.z : e.low.z}));
}

}  // namespace

// Returns the nearest point of an object within reach; otherwise the surface or the ground under the pointer.
std::optional<Vec3> Viewport::snap_place(QPointF p, const Marks& without) const {
  const Scope s = scope();
  std::optional<Vec3> found;
  double nearest = snap_reach;
  const auto try_point = [&](Vec3 place) {
    const auto spot = s.spot(place);
    const double away = spot ? QLineF(*spot, p).length() : nearest;
    if (away < nearest) nearest = away, found = place;
  };
  std::size_t count = 0;
  for (const Item& i : frame().items)
    if (!without(i.id) && ++count <= most_snapped_to) each_point(i, try_point);
  for (const Icon& i : icons())
    if (!without(i.id)) try_point(i.place);
  if (found) return found;
  const QPointF at = s.in_picture(p);
  for (const Hit& h : pick_through(frame(), s.projection, at.x(), at.y()))
    if (!without(h.id)) return h.place;
  const Ray ray = s.ray(p);
  if (!frame().surroundings.ground || ray.along.y > -1e-6) return std::nullopt;
  return ray.from - ray.from.y / ray.along.y * ray.along;
}

// The third click begins again.
void Viewport::measure_to(QPointF p) {
  if (measured_.size() == 2) measured_.clear();
  measured_.push_back(snap_place(p, Marks()).value_or(place_under(p)));
  update();
}

// Returns the measured points, of which the last one may still follow the pointer.
std::vector<Vec3> Viewport::measured(QPointF p) const {
  std::vector<Vec3> all = measured_;
  if (all.size() < 2 && rect().contains(p.toPoint())) all.push_back(snap_place(p, Marks()).value_or(place_under(p)));
  return all;
}

QString Viewport::measure_words() const {
  const std::vector<Vec3> ends = measured(at_);
  if (ends.size() < 2) return {};
  const double step = scope().metres(std::max(1e-3, scope().depth(ends[1])));
  Vec3 by = ends[1] - ends[0];
  const double far = rounded(length(by), step);
  for (int i = 0; i < 3; ++i) by[i] = rounded(by[i], step);
  return QString::fromStdString(write_number(far) + " m " + write_vector(by));
}

void Viewport::paint_measure(QPainter& p, const Scope& s) const {
  const std::vector<Vec3> ends = measured(at_);
  p.save();
  p.setRenderHint(QPainter::Antialiasing);
  const QColor color = picture_colors().event;
  std::vector<QPointF> spots;
  for (const Vec3& end : ends)
    if (const auto spot = s.spot(end)) spots.push_back(*spot);
  for (const bool shade : {true, false}) {
    p.setPen(QPen(shade ? QColor(0, 0, 0, 130) : color, shade ? 4 : 1.75)), p.setBrush(Qt::NoBrush);
    if (spots.size() == 2) p.drawLine(spots[0], spots[1]);
    for (const QPointF& spot : spots) p.drawEllipse(spot, 4, 4);
  }
  if (spots.size() == 2) {
    const QString words = measure_words();
    QRectF box = QFontMetricsF(font()).boundingRect(words).adjusted(-6, -3, 6, 3);
    box.moveCenter((spots[0] + spots[1]) / 2 - QPointF(0, box.height()));
    QColor back = colors().raised;
    back.setAlpha(225);
    p.setPen(Qt::NoPen), p.setBrush(back);
    p.drawRoundedRect(box, 4, 4);
    p.setPen(colors().text);
    p.drawText(box, Qt::AlignCenter, words);
  }
  p.restore();
}

}  // namespace betwixt::studio
