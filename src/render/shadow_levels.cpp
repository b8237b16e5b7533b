// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Chooses the objects of each shadow map: those that cast, and those for which a map must be fine.
#include "render/shadow_levels.h"

#include <algorithm>
#include <utility>

#include "render/shadow.h"

namespace betwixt {

Ball around(const Ball& a, const Ball& b) {
  const double d = length(b.center - a.center);
  if (d + b.radius <= a.radius) return a;
  if (d + a.radius <= b.radius) return b;
  const double r = (d + a.radius + b.radius) / 2;
  return {a.center + (r - a.radius) / d * (b.center - a.center), r};
}

Ball ball_of(const Thing& t, Vec3 anchor) { return {t.bounds.center - anchor, t.bounds.radius()}; }

Ball around_all(const Things& things, std::span<const std::uint32_t> casters, Vec3 anchor) {
  Ball all = ball_of(things[casters.front()], anchor);
  for (const std::uint32_t i : casters) all = around(all, ball_of(things[i], anchor));
  return all;
}

namespace {

constexpr double coarse = 6;        // pixels a texel, where it is most visible
constexpr double minor = 0.2;       // of the largest in the picture: smaller objects do not count for the resolution
constexpr double most_size = 0.25;  // of the picture's width: those that are larger, as hills are, count as that
constexpr std::size_t most_levels = 3;

// A caster, its pixels a metre where it is most visible, and its approximate size in the picture, wherever in it.
struct Seen {
  std::uint32_t thing = 0;
  double pixels = 0, size = 0;
};
Seen seen(std::uint32_t i, const Things& things) {
  const Bounds& b = things[i].bounds;
  const View& view = things.view();
  const double r = b.radius(), scale = 0.5 * view.sx * view.width;
  const Vec3 to = view.eye - b.center;
  const Vec3 out{std::max(std::abs(to.x) - b.half.x, 0.0), std::max(std::abs(to.y) - b.half.y, 0.0),
                 std::max(std::abs(to.z) - b.half.z, 0.0)};
  const double away = std::max(length(out), 1e-3 * r);
  return {i, view.orthographic ? scale : scale / away,
          view.orthographic ? scale * r : scale * r / std::max(away, 0.5 * r)};
}

// Returns the width of a texel of a light's map at its worst, within a ball.
double texel_of(const Ball& ball, bool sun, Vec3 lamp) {
  if (sun) return 2 * ball.radius / Shadows::map_size;
  const double d = length(lamp - ball.center), r = ball.radius;
  const double tangent = d > r ? std::min(r / std::sqrt(d * d - r * r), widest) : widest;
  return 2 * tangent / Shadows::map_size * (d + r);
}

// A box with the orientation of an object.
struct Turned {
  Vec3 center;
  std::array<Vec3, 3> half;  // from there to the centres of three sides
  // Returns half its extent along a direction.
  double reach(Vec3 a) const {
    return std::abs(dot(a, half[0])) + std::abs(dot(a, half[1])) + std::abs(dot(a, half[2]));
  }
};
Turned turned(const Thing& t, Store& store) {
  const Form::Realised& plain = t.form->plain(store);
  const Mat4 m = t.world * plain.local;
  const Vec3 half = plain.mesh->box.half();
  return {transform_point(m, plain.mesh->box.middle()),
          {half.x * column(m, 0), half.y * column(m, 1), half.z * column(m, 2)}};
}

// Returns whether an object fills its box, or is flat.
bool is_plain(const Thing& t, const Turned& box) {
  if (t.shape->kind == Kind::box && !detailed(*t.shape) && !t.form->blends()) return true;
  double most = 0, least = INFINITY;
  for (const Vec3& h : box.half) most = std::max(most, length(h)), least = std::min(least, length(h));
  return least < 1e-6 * most;
}

// Returns whether the shadow of a ball may be in the picture: it extends along the light as far as any object reaches.
bool shadow_in_view(const View& view, const Ball& from, const Ball& to) {
  if (view.orthographic) return true;
  const auto outside = [&](Vec3 n) { return dot(n, from.center) < -from.radius && dot(n, to.center) < -to.radius; };
  return !outside(-view.backward) && std::none_of(view.side.begin(), view.side.end(), outside);
}

}  // namespace

// Returns whether a plain object casts no shadow on anything. For a floor or a wall, everything is on the lit side; for
// a room, everything and the lamp are inside. An object that is sunk into a floor at most to its middle is on it.
bool Shadows::casts_on_nothing(Things& things, std::uint32_t i, const Made& light) {
  const Turned box = turned(things[i], things.store());
  if (!is_plain(things[i], box)) return false;
  const double slack = 5e-3 * things[i].bounds.radius();
  bool room = things[i].closed && !light.sun;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 a = normalize(cross(box.half[(k + 1) % 3], box.half[(k + 2) % 3]), {});
    const double reach = box.reach(a);
    double low = INFINITY, high = -INFINITY;
    for (std::uint32_t j = 0; j < things.all().size(); ++j) {
      const Bounds& b = things[j].bounds;
      if (j == i || !things[j].there || !things[j].surface) continue;
      const double at = dot(a, b.center - box.center);
      double r = std::abs(a.x) * b.half.x + std::abs(a.y) * b.half.y + std::abs(a.z) * b.half.z;
      if (b.radius() < 0.25 * things[i].bounds.radius())
        r = 0;
      else if (at - r < reach && at + r > -reach)  // with its orientation it may still be on one side
        r = std::min(r, turned(things[j], things.store()).reach(a));
      low = std::min(low, at - r), high = std::max(high, at + r);
    }
    const double floor = std::abs(a.y) > 0.999999 ? -a.y * box.center.y : NAN;
    if (light.floor) low = std::isnan(floor) ? -INFINITY : std::min(low, floor);
    if (light.floor) high = std::isnan(floor) ? INFINITY : std::max(high, floor);
    const double lit = light.sun ? 1e300 * dot(a, light.place) : dot(a, light.place - box.center);
    if (length(a) > 0 && low >= reach - slack && lit >= reach) return true;
    if (length(a) > 0 && high <= slack - reach && lit <= -reach) return true;
    room = room && low >= -reach - slack && high <= reach + slack && std::abs(lit) < reach;
  }
  return room;
}

// Returns all objects that may cast a shadow. Large floors, walls and rooms mostly do not, and would make maps coarse.
Shadows::Numbers Shadows::without_backdrops(Things& things, const Made& light) const {
  constexpr std::size_t most = 8;
  Numbers left = casters_;
  for (std::size_t before = 0; before != left.size() && !left.empty();) {
    before = left.size();
    const double all = around_all(things, left, light.anchor).radius;
    Numbers large;
    for (const std::uint32_t i : left)
      if (things[i].bounds.radius() > 0.25 * all) large.push_back(i);
    if (large.size() > most) break;
    for (const std::uint32_t i : large)
      if (casts_on_nothing(things, i, light)) std::erase(left, i);
  }
  return left.empty() ? casters_ : left;
}

// Returns the objects of each of a light's maps, the finest first; the last has all. Objects that are small in the
// picture do not count for the resolution, nor do those so close to the eye that no map would be fine enough.
std::vector<Shadows::Numbers> Shadows::levels(Things& things, const Made& light) const {
  const Vec3 lamp = light.place - light.anchor;
  const auto is_fine = [&](const Ball& ball, double pixels) {
    return texel_of(ball, light.sun, lamp) * pixels <= coarse;
  };
  const Numbers wanted = without_backdrops(things, light);
  Numbers all = wanted;
  std::vector<Seen> major;
  const auto find_major = [&] {
    major.clear();
    double largest = 0;
    for (const std::uint32_t i : all)
      if (const Seen s = seen(i, things); is_fine(ball_of(things[i], light.anchor), s.pixels))
        major.push_back(s), largest = std::max(largest, std::min(s.size, most_size * things.view().width));
    std::erase_if(major, [&](const Seen& s) { return s.size < minor * largest; });
    std::stable_sort(major.begin(), major.end(), [](const Seen& a, const Seen& b) { return a.pixels > b.pixels; });
  };
  find_major();
  if (major.empty() || is_fine(around_all(things, all, light.anchor), major.front().pixels)) return {all};
  double low = INFINITY;  // along a sun's light
  if (light.sun)
    for (const Thing& t : things.all())
      if (t.there && t.surface)
        low = std::min(low, dot(t.bounds.center - light.anchor, light.place) - t.bounds.radius());
  std::erase_if(all, [&](std::uint32_t i) {
    const Vec3 eye = things.view().eye;
    const Bounds& b = things[i].bounds;
    const Ball from{b.center - eye, b.radius()};
    Ball to = from;
    if (light.sun) {
      double far = std::max(dot(b.center - light.anchor, light.place) - low, 0.0);
      if (light.floor) far = std::max(far, (b.center.y + b.radius()) / std::max(light.place.y, 1e-3));
      to.center = from.center - far * light.place;
    } else {
      const Vec3 way = b.center - light.place;
      const double d = std::max(length(way), 1e-9), grown = std::max(light.range / d, 1.0);
      if (d <= b.radius()) return false;
      to = {from.center + (grown - 1) * way, from.radius * grown};
    }
    return !shadow_in_view(things.view(), from, to);
  });
  if (all.empty()) return {wanted};
  find_major();
  std::vector<Numbers> r;
  Numbers shown;
  Ball ball;
  for (std::size_t k = 0; k < major.size() && r.size() + 1 < most_levels;) {
    const double pixels = major[k].pixels;
    for (const std::size_t first = k; k < major.size(); ++k) {
      const Ball one = ball_of(things[major[k].thing], light.anchor), with = shown.empty() ? one : around(ball, one);
      if (k > first && !is_fine(with, pixels)) break;
      ball = with, shown.push_back(major[k].thing);
    }
    r.push_back(shown);
  }
  // The last one stays the same while the camera turns, if that costs little. A map that is hardly finer than the next
  // is left out.
  const double everywhere = around_all(things, wanted, light.anchor).radius;
  if (everywhere <= 1.6 * around_all(things, all, light.anchor).radius) all = wanted;
  double next = around_all(things, all, light.anchor).radius;
  for (std::size_t k = r.size(); k-- > 0;) {
    const double own = around_all(things, r[k], light.anchor).radius;
    if (own > (k + 1 == r.size() ? 0.8 : 0.4) * next)
      r.erase(r.begin() + static_cast<std::ptrdiff_t>(k));
    else
      next = own;
  }
  r.push_back(std::move(all));
  return r;
}

}  // namespace betwixt
