// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "betwixt/pick.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "exchange/geometry.h"
#include "render/view.h"

namespace betwixt {
namespace {

using Rectangle = Projection::Rectangle;
using Spot = Projection::Spot;

constexpr Detail plain{24, true};  // one that the renderer has anyway: no mesh is made for this
constexpr double endless = std::numeric_limits<double>::infinity();

bool seen(const Item& i) { return i.shape && i.transparency < 1 && finite(i.world); }

void add(Rectangle& r, const Spot& s) {
  r.left = std::min(r.left, s.x), r.right = std::max(r.right, s.x);
  r.top = std::min(r.top, s.y), r.bottom = std::max(r.bottom, s.y);
}

template <class Places>
std::optional<Rectangle> around(const Places& places, const Projection& p) {
  Rectangle r{endless, endless, -endless, -endless};
  bool any = false, all = true;
  for (const Vec3& place : places) {
    const auto spot = p.spot(place);
    if (spot) add(r, *spot), any = true;
    all = all && spot;
  }
  if (!any) return std::nullopt;
  return all ? r : Rectangle{-endless, -endless, endless, endless};
}

// Returns the rectangle around an outer box, which is fast. Unbounded if there is none: measures of texts are
// estimates.
std::optional<Rectangle> roughly_around(const Item& i, const Projection& p) {
  const Extent e = extent(*i.shape);
  if (i.toward || i.shape->kind == Kind::text) return Rectangle{-endless, -endless, endless, endless};
  if (e.empty()) return std::nullopt;
  std::array<Vec3, 8> corners;
  for (unsigned k = 0; k < 8; ++k)
    corners[k] =
        transform_point(i.world, {k & 1 ? e.high.x : e.low.x, k & 2 ? e.high.y : e.low.y, k & 4 ? e.high.z : e.low.z});
  return around(corners, p);
}

bool near(const Rectangle& r, double x, double y, double slack, double aspect) {
  return x >= r.left - slack / aspect && x <= r.right + slack / aspect && y >= r.top - slack && y <= r.bottom + slack;
}

// Returns the distance along a ray to a triangle, from either side.
std::optional<double> meet(const Ray& ray, Vec3 a, Vec3 b, Vec3 c) {
  const Vec3 ab = b - a, ac = c - a, p = cross(ray.along, ac);
  const double det = dot(ab, p);
  if (det == 0) return std::nullopt;
  const Vec3 from = ray.from - a, q = cross(from, ab);
  const double u = dot(from, p) / det, v = dot(ray.along, q) / det, t = dot(ac, q) / det;
  if (!(u >= 0 && v >= 0 && u + v <= 1 && t >= 0)) return std::nullopt;
  return t;
}

// A ball is round, however it is drawn.
std::optional<double> meet_ball(const Ray& ray, const Mat4& back, double radius) {
  const Vec3 from = transform_point(back, ray.from), along = transform_vector(back, ray.along);
  const double a = dot(along, along), b = dot(from, along), c = dot(from, from) - radius * radius, d = b * b - a * c;
  if (!(d >= 0) || a == 0) return std::nullopt;
  const double first = (-b - std::sqrt(d)) / a, second = (-b + std::sqrt(d)) / a;
  if (second < 0) return std::nullopt;
  return first >= 0 ? first : second;
}

std::optional<double> meet(const Ray& ray, const Item& i) {
  if (i.shape->kind == Kind::sphere && !i.toward)
    if (const auto back = inverse(i.world)) return meet_ball(ray, *back, i.shape->radius);
  const Drawn d = drawn(i);
  std::optional<double> nearest;
  const auto& t = d.mesh->triangles;
  for (std::size_t k = 0; k + 2 < t.size(); k += 3)
    if (const auto far = meet(ray, d.corners[t[k]], d.corners[t[k + 1]], d.corners[t[k + 2]]))
      if (!nearest || *far < *nearest) nearest = far;
  return nearest;
}

// Returns the distance of a place of the picture from an edge, in heights of the picture, and the nearest point of the
// edge.
std::optional<std::pair<double, Vec3>> beside(const Projection& p, double x, double y, Vec3 a, Vec3 b) {
  const auto from = p.spot(a), to = p.spot(b);
  if (!from || !to) return std::nullopt;
  const double w = p.aspect(), dx = (to->x - from->x) * w, dy = to->y - from->y, l = dx * dx + dy * dy;
  const double px = (x - from->x) * w, py = y - from->y;
  const double s = l > 0 ? std::clamp((px * dx + py * dy) / l, 0.0, 1.0) : 0;
  return std::pair(std::hypot(px - s * dx, py - s * dy), a + s * (b - a));
}

std::optional<Hit> pick_edge(const Frame& f, const Projection& p, double x, double y, double slack) {
  std::optional<Hit> hit;
  double nearest = slack;
  for (const Item& i : f.items) {
    if (!seen(i)) continue;
    const auto box = roughly_around(i, p);
    if (!box || !near(*box, x, y, slack, p.aspect())) continue;
    const Drawn d = drawn(i);
    const auto& e = d.mesh->edges;
    for (std::size_t k = 0; k + 1 < e.size(); k += 2) {
      const auto there = beside(p, x, y, d.corners[e[k]], d.corners[e[k + 1]]);
      if (!there || there->first > nearest) continue;
      nearest = there->first;
      hit = Hit{i.id, there->second, p.spot(there->second)->depth};
    }
  }
  return hit;
}

}  // namespace

Projection::Projection(const Camera& c, double aspect) : aspect_(aspect > 0 && std::isfinite(aspect) ? aspect : 1) {
  bool good = true;
  const View v = make_view(c, 1, 1, good);
  eye_ = v.eye, right_ = v.right, up_ = v.up, backward_ = v.backward, orthographic_ = v.orthographic;
  // For a square picture; a wider one shows less from bottom to top, or, if orthographic, more from left to right.
  sx_ = orthographic_ ? v.sx / aspect_ : v.sx, sy_ = orthographic_ ? v.sy : v.sy * aspect_;
  shift_x_ = v.shift_x, shift_y_ = v.shift_y;
}

std::optional<Spot> Projection::spot(Vec3 place) const {
  const Vec3 d = place - eye_;
  const double depth = -dot(d, backward_);
  if (!(depth > 0) && !(orthographic_ && depth == 0)) return std::nullopt;
  const double w = orthographic_ ? 1 : depth;
  return Spot{(1 + sx_ * dot(d, right_) / w + shift_x_) / 2, (1 - sy_ * dot(d, up_) / w - shift_y_) / 2, depth};
}

Vec3 Projection::place(double x, double y, double depth) const {
  const double w = orthographic_ ? 1 : depth;
  return eye_ - depth * backward_ + (2 * x - 1 - shift_x_) / sx_ * w * right_ + (1 - 2 * y - shift_y_) / sy_ * w * up_;
}

Ray Projection::ray(double x, double y) const {
  if (orthographic_) return {place(x, y, 0), -backward_};
  return {eye_, normalize(place(x, y, 1) - eye_)};
}

double Projection::height(double depth) const { return 2 / sy_ * (orthographic_ ? 1 : depth); }

Drawn drawn(const Item& i, double pixels) {
  const Detail detail = pixels > 0 ? Detail::for_pixels(pixels) : plain;
  const Geometry g = i.toward ? realise_blend(*i.shape, *i.toward, i.blend, detail) : realise(*i.shape, detail);
  const Mat4 m = i.world * g.local;
  Drawn d{{}, g.mesh};
  d.corners.reserve(g.mesh->positions.size());
  for (const auto& p : g.mesh->positions) d.corners.push_back(transform_point(m, {p[0], p[1], p[2]}));
  return d;
}

std::optional<Rectangle> rectangle_around(const Drawn& d, const Projection& p) { return around(d.corners, p); }

std::optional<Hit> pick(const Frame& f, const Projection& p, double x, double y, double slack) {
  const Ray ray = p.ray(x, y);
  std::optional<Hit> hit;
  double nearest = endless;
  for (const Item& i : f.items) {
    if (!seen(i)) continue;
    const auto box = roughly_around(i, p);
    if (!box || !near(*box, x, y, 0, p.aspect())) continue;
    const auto far = meet(ray, i);
    if (!far || *far > nearest) continue;  // of two at one place, the one that is drawn later
    nearest = *far;
    const Vec3 place = ray.from + *far * ray.along;
    hit = Hit{i.id, place, dot(place - p.eye(), p.forward())};
  }
  return hit || slack <= 0 ? hit : pick_edge(f, p, x, y, slack);
}

std::vector<Hit> pick_through(const Frame& f, const Projection& p, double x, double y) {
  const Ray ray = p.ray(x, y);
  std::vector<Hit> hits;
  for (auto i = f.items.rbegin(); i != f.items.rend(); ++i) {
    if (!seen(*i)) continue;
    const auto box = roughly_around(*i, p);
    if (!box || !near(*box, x, y, 0, p.aspect())) continue;
    const auto far = meet(ray, *i);
    if (!far) continue;
    const Vec3 place = ray.from + *far * ray.along;
    hits.push_back({i->id, place, dot(place - p.eye(), p.forward())});
  }
  std::stable_sort(hits.begin(), hits.end(), [](const Hit& a, const Hit& b) { return a.depth < b.depth; });
  return hits;
}

std::vector<ObjectId> pick_within(const Frame& f, const Projection& p, const Rectangle& r) {
  std::vector<ObjectId> ids;
  for (const Item& i : f.items) {
    if (!seen(i)) continue;
    const auto rough = roughly_around(i, p);
    if (!rough || rough->right < r.left || rough->left > r.right || rough->bottom < r.top || rough->top > r.bottom)
      continue;
    const auto box = r.holds(*rough) ? rough : rectangle_around(drawn(i), p);
    if (box && r.holds(*box)) ids.push_back(i.id);
  }
  return ids;
}

}  // namespace betwixt
