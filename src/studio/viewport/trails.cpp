// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/viewport/trails.h"

#include <QElapsedTimer>
#include <QLineF>
#include <cmath>

#include "scene/functions.h"
#include "studio/shell/theme.h"

namespace betwixt::studio {
namespace {

constexpr int most_frames = 240;  // frames shown around the playhead if the film is longer
constexpr std::size_t most_ways = 20;
constexpr double dot_reach = 6;       // pixels
constexpr int most_milliseconds = 6;  // time spent on paths in one picture

}  // namespace

std::pair<int, int> Trails::frames(const Workspace& workspace, Time now) {
  const Rate rate = workspace.document().rate();
  const auto range = workspace.document().range();
  int first = static_cast<int>(std::ceil(rate.frame_number(range.first)));
  int last = static_cast<int>(std::floor(rate.frame_number(range.second)));
  if (last - first > most_frames) {
    const int middle = static_cast<int>(rate.frame_number(now));
    first = std::max(first, middle - most_frames / 2), last = std::min(last, middle + most_frames / 2);
  }
  return {first, last};
}

// Finds the places nearest to the playhead first.
bool Trails::find(Way& way, ObjectId id, int first, int last, int now) {
  const Rate rate = workspace_.document().rate();
  const Target world(id, Query::world);
  QElapsedTimer clock;
  clock.start();
  for (int k = 0; k <= 2 * (last - first); ++k) {
    const int f = std::clamp(now, first, last) + (k % 2 == 0 ? k / 2 : -(k + 1) / 2);
    if (f < first || f > last || way.places.contains(f)) continue;
    if (clock.elapsed() > most_milliseconds) return false;
    const Value v = workspace_.program().read(world, rate.frame(f));
    if (const auto* m = std::get_if<Matrix>(&v)) way.places[f] = translation_of(**m);
  }
  way.events.clear();
  for (const TrackView& t : tracks(workspace_.document(), Target{id, fn::position}))
    each_event(workspace_.document(), t.target, rate.frame(first), rate.frame(last), [&](const EventView& e) {
      way.events.try_emplace(static_cast<int>(std::lround(rate.frame_number(e.time))), EventAt{t.target, e.time});
    });
  return true;
}

std::optional<EventAt> Trails::event_at(const Scope& s, QPointF p, Time now) const {
  const auto [first, last] = frames(workspace_, now);
  for (auto id = workspace_.selected().rbegin(); id != workspace_.selected().rend(); ++id) {
    const auto way = ways_.find(id->index);
    if (way == ways_.end() || !way->second.moves()) continue;
    for (auto e = way->second.events.lower_bound(first); e != way->second.events.end() && e->first <= last; ++e) {
      const auto place = way->second.places.find(e->first);
      if (place == way->second.places.end()) continue;
      if (const auto spot = s.spot(place->second); spot && QLineF(*spot, p).length() <= dot_reach) return e->second;
    }
  }
  return std::nullopt;
}

bool Trails::Way::moves() const {
  Box all;
  for (const auto& [frame, place] : places) all.add(place);
  return !all.empty() && length(all.half()) > 1e-9;
}

bool Trails::paint(QPainter& p, const Scope& s, Time now) {
  const auto [first, last] = frames(workspace_, now);
  const std::vector<ObjectId>& ids = workspace_.selected();
  bool all = true;
  p.save();
  p.setRenderHint(QPainter::Antialiasing);
  p.setClipRect(s.box);
  for (std::size_t i = ids.size() - std::min(ids.size(), most_ways); i < ids.size(); ++i) {
    Way& way = ways_[ids[i].index];
    if (all) all = find(way, ids[i], first, last, static_cast<int>(workspace_.document().rate().frame_number(now)));
    paint(p, s, way, first, last, workspace_.document().rate().frame_number(now));
  }
  p.restore();
  return all;
}

void Trails::paint(QPainter& p, const Scope& s, const Way& way, int first, int last, double now) const {
  if (!way.moves()) return;
  const Colors& c = picture_colors();
  const auto tint = [&](int frame, int alpha) {
    QColor color = frame < now ? c.playhead : c.note;
    color.setAlpha(alpha);
    return color;
  };
  std::optional<QPointF> before;
  for (auto i = way.places.lower_bound(first); i != way.places.end() && i->first <= last; ++i) {
    const auto spot = s.spot(i->second);
    if (spot && before) {
      p.setPen(QPen(tint(i->first - 1, 190), i->first <= now ? 2.4 : 1.1));  // also for those who see no colours
      p.drawLine(*before, *spot);
    }
    before = spot;
  }
  p.setPen(Qt::NoPen);
  for (auto i = way.places.lower_bound(first); i != way.places.end() && i->first <= last; ++i) {
    const auto spot = s.spot(i->second);
    if (!spot) continue;
    const bool event = way.events.contains(i->first);
    p.setBrush(event ? c.event : tint(i->first, 230));
    const double radius = event ? 4 : 1.9;
    if (event) p.setPen(QPen(QColor(0, 0, 0, 120), 1));
    p.drawEllipse(*spot, radius, radius);
    p.setPen(Qt::NoPen);
  }
}

}  // namespace betwixt::studio
