// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/viewport/ghosts.h"

#include <algorithm>

#include "scene/kinds.h"
#include "studio/shell/marks.h"
#include "studio/shell/theme.h"
#include "studio/viewport/picture_maker.h"

namespace betwixt::studio {
namespace {

constexpr int offsets[] = {-6, 6, -4, 4, -2, 2};  // frames; the nearest is drawn last
constexpr std::size_t most = 200;                 // objects in each
constexpr double coarse = 40;                     // pixels; smaller round objects do not show their corners
constexpr std::size_t most_corners = 60'000;      // corners of meshes in each

}  // namespace

void paint_silhouette(QPainter& p, const Scope& s, const Item& item, const QColor& color, HeldShapes& held) {
  Drawn d = drawn(item);
  held.push_back(d.mesh);
  if (const auto around = rectangle_around(d, s.projection)) {
    const double wide = (around->right - around->left) * s.box.width() / 2;
    if (wide > coarse && wide < 1e4 && row_of(item.shape->kind).detailed) {
      d = drawn(item, wide);
      held.push_back(d.mesh);
    }
  }
  std::vector<std::optional<QPointF>> spots;
  spots.reserve(d.corners.size());
  for (const Vec3& corner : d.corners) spots.push_back(s.spot(corner));
  p.setPen(Qt::NoPen), p.setBrush(color);
  const auto& t = d.mesh->triangles;
  for (std::size_t k = 0; k + 2 < t.size(); k += 3) {
    const auto &a = spots[t[k]], &b = spots[t[k + 1]], &c = spots[t[k + 2]];
    if (!a || !b || !c) continue;
    const QPointF corners[] = {*a, *b, *c};
    p.drawConvexPolygon(corners, 3);
  }
  // Draw edges too, so that flat objects seen from the side are visible.
  p.setPen(QPen(color, 1)), p.setBrush(Qt::NoBrush);
  const auto& e = d.mesh->edges;
  for (std::size_t k = 0; k + 1 < e.size(); k += 2)
    if (spots[e[k]] && spots[e[k + 1]]) p.drawLine(*spots[e[k]], *spots[e[k + 1]]);
}

std::pair<std::optional<Time>, std::optional<Time>> Ghosts::events_around(const Document& d, Time now,
                                                                          const std::vector<ObjectId>& ids) {
  std::optional<Time> before, after;
  for (const ObjectId id : ids)
    for (const TrackView& t : tracks(d, id)) {
      if (const auto e = event_before(d, t.target, now); e && (!before || *e > *before)) before = e;
      if (const auto e = next_event(d, t.target, now + Time{1}); e && (!after || *e < *after)) after = e;
    }
  return {before, after};
}

std::vector<Ghosts::Moment> Ghosts::moments(Time now, Kinds kinds, const std::vector<ObjectId>& ids) const {
  std::vector<Moment> all;
  const auto range = workspace_.document().range();
  if (kinds.frames)
    for (const int offset : offsets) {
      const Time t = now + workspace_.document().rate().span(offset);
      if (t >= range.first && t <= range.second) all.push_back({t, 0.42 - 0.05 * std::abs(offset)});
    }
  if (!kinds.events) return all;
  const auto [before, after] = events_around(workspace_.document(), now, ids);
  if (before) all.push_back({*before, 0.5});
  if (after) all.push_back({*after, 0.5});
  return all;
}

void Ghosts::paint(QPainter& p, const Scope& s, const Camera& eye, const Frame& now, Kinds kinds,
                   const std::function<std::vector<ObjectId>()>& which) {
  if (!image_ || image_->time != now.time || !(image_->eye == eye) || image_->box != s.box ||
      !(image_->kinds == kinds)) {
    const HeldShapes before = std::exchange(held_, {});  // until this painting holds them
    QImage all(s.box.size().toSize(), QImage::Format_ARGB32_Premultiplied);
    all.fill(Qt::transparent);
    QPainter over(&all);
    const std::vector<ObjectId> ids = which();
    const Marks wanted(ids);
    const auto here = [&](ObjectId id) {  // frames list items in the order of their objects
      const auto at = std::lower_bound(now.items.begin(), now.items.end(), id.index,
                                       [](const Item& i, std::uint32_t n) { return i.id.index < n; });
      return at != now.items.end() && at->id == id ? &*at : nullptr;
    };
    const Scope own{s.projection, QRectF(QPointF(0, 0), s.box.size())};
    for (const auto& [t, opacity] : moments(now.time, kinds, ids)) {
      QImage one(all.size(), QImage::Format_ARGB32_Premultiplied);
      one.fill(Qt::transparent);
      QPainter ghost(&one);
      Frame then = workspace_.program().frame(t);
      leave_out(workspace_.left_out().get(), then);
      std::size_t count = 0, corners = 0;
      for (const Item& item : then.items) {
        if (!ids.empty() && !wanted(item.id)) continue;
        const Item* i = here(item.id);
        if (i && i->world == item.world && i->shape == item.shape && i->blend == item.blend) continue;
        corners += item.shape->mesh ? item.shape->mesh->positions.size() : 100;
        if (++count > most || corners > most_corners) break;
        paint_silhouette(ghost, own, item, t < now.time ? picture_colors().playhead : picture_colors().note, held_);
      }
      ghost.end();
      over.setOpacity(opacity);
      over.drawImage(0, 0, one);
    }
    // Cut out the current objects, which are in front.
    over.setOpacity(1);
    over.setCompositionMode(QPainter::CompositionMode_DestinationOut);
    std::size_t count = 0;
    for (const Item& item : now.items)
      if ((ids.empty() || wanted(item.id)) && ++count <= most) paint_silhouette(over, own, item, Qt::black, held_);
    over.end();
    image_ = Kept{all, now.time, eye, s.box, kinds};
  }
  p.drawImage(s.box.topLeft(), image_->image);
}

}  // namespace betwixt::studio
