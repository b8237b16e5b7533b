// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Shapes between two shapes.
#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <mutex>
#include <optional>

#include "exchange/geometry.h"
#include "exchange/outlines.h"
#include "exchange/shapes.h"
#include "scene/topology.h"

namespace betwixt {
namespace {

double lerp(double a, double b, double s) { return (1 - s) * a + s * b; }
Vec3 lerp(Vec3 a, Vec3 b, double s) { return (1 - s) * a + s * b; }

bool has_outline(const Shape& s) { return s.kind == Kind::text || s.kind == Kind::polygon; }

// ---- shapes of one kind: by their measures

bool same_but_measures(const Shape& a, const Shape& b) {
  if (a.kind != b.kind || has_outline(a) || a.kind == Kind::mesh) return false;
  if (a.kind == Kind::polyline && (a.width > 0) != (b.width > 0)) return false;
  return a.points->size() == b.points->size();
}

Shape between(const Shape& a, const Shape& b, double s) {
  Shape shape = a;
  const auto measure = [&](double Shape::*m) { shape.*m = std::max(0.0, lerp(a.*m, b.*m, s)); };
  shape.size = lerp(a.size, b.size, s);
  for (const auto m : {&Shape::radius, &Shape::height, &Shape::tube, &Shape::width, &Shape::depth}) measure(m);
  std::vector<Vec3> points(std::min(a.points->size(), b.points->size()));
  for (std::size_t i = 0; i < points.size(); ++i) points[i] = lerp((*a.points)[i], (*b.points)[i], s);
  shape.points = std::move(points);
  return shape;
}

// ---- meshes: vertex by vertex

// The geometry in object space.
struct Baked {
  const Mesh& mesh;
  Vec3 stretch;
  explicit Baked(const Geometry& g) : mesh(*g.mesh), stretch{g.local(0, 0), g.local(1, 1), g.local(2, 2)} {}
  Vec3 position(std::size_t i) const { return stretch * widen(mesh.positions[i]); }
  Vec3 normal(std::size_t i) const {
    const Vec3 n = widen(mesh.normals[i]);
    return normalize(Vec3{n.x / stretch.x, n.y / stretch.y, n.z / stretch.z}, n);
  }
};

Mesh between(const Geometry& a, const Geometry& b, double s) {
  const Baked from(a), to(b);
  Mesh mesh = *a.mesh;
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    mesh.positions[i] = narrow(lerp(from.position(i), to.position(i), s));
    mesh.normals[i] = narrow(normalize(lerp(from.normal(i), to.normal(i), s), from.normal(i)));
  }
  if (to.mesh.uvs.size() == mesh.uvs.size())
    for (std::size_t i = 0; i < mesh.uvs.size(); ++i)
      for (std::size_t k = 0; k < 2; ++k)
        mesh.uvs[i][k] = static_cast<float>(lerp(mesh.uvs[i][k], to.mesh.uvs[i][k], s));
  if (to.mesh.parts.size() == mesh.parts.size())
    for (std::size_t i = 0; i < mesh.parts.size(); ++i)
      for (std::size_t k = 0; k < 3; ++k)
        mesh.parts[i].color[k] =
            std::max(0.0F, static_cast<float>(lerp(mesh.parts[i].color[k], to.mesh.parts[i].color[k], s)));
  mesh.closed = mesh.closed && to.mesh.closed && s >= 0 && s <= 1;
  return mesh;
}

// ---- outlines: contour by contour

// Twice the area as seen from `facing`; positive counter-clockwise.
double turn(const Contour& c, Vec3 facing) {
  Vec3 sum{};
  for (std::size_t i = 0; i < c.size(); ++i) sum = sum + cross(c[i] - c[0], c[(i + 1) % c.size()] - c[0]);
  return dot(sum, facing);
}

Vec3 middle(const Contour& c) {
  Vec3 low = c[0], high = c[0];
  for (const Vec3 p : c)
    for (int i = 0; i < 3; ++i) low[i] = std::min(low[i], p[i]), high[i] = std::max(high[i], p[i]);
  return 0.5 * (low + high);
}

bool contains(const Contour& c, Vec3 p) {
  bool inside = false;
  for (std::size_t i = 0, j = c.size() - 1; i < c.size(); j = i++)
    if ((c[i].y > p.y) != (c[j].y > p.y) && p.x < lerp(c[i].x, c[j].x, (p.y - c[i].y) / (c[j].y - c[i].y)))
      inside = !inside;
  return inside;
}

// An outer contour with its holes.
struct Island {
  Contour outer;
  std::vector<Contour> holes;
};

std::vector<Island> islands(const Outline& outline, bool single) {
  const Vec3 toward = facing(outline);
  std::vector<Island> found;
  for (Contour c : outline.contours) {
    if (single && turn(c, toward) < 0) std::reverse(c.begin(), c.end());  // a polygon is no hole
    if (turn(c, toward) >= 0) found.push_back({std::move(c), {}});
  }
  for (const Contour& c : outline.contours) {
    if (single || turn(c, toward) >= 0) continue;
    Island* home = nullptr;
    for (auto& island : found)
      if (contains(island.outer, c[0]) && (home == nullptr || turn(island.outer, toward) < turn(home->outer, toward)))
        home = &island;
    if (home != nullptr) home->holes.push_back(c);
  }
  return found;
}

// Two contours with as many points, each on its way to the other's.
struct Pair {
  Contour from, to;
};

// How far along the contour each point is, 0 to 1; one more entry for the way back to the first.
std::vector<double> arc(const Contour& c) {
  std::vector<double> at{0};
  for (std::size_t i = 0; i < c.size(); ++i) at.push_back(at.back() + length(c[(i + 1) % c.size()] - c[i]));
  const double whole = at.back();
  for (double& a : at) a = whole > 0 ? a / whole : 0;
  at.back() = 1;
  return at;
}

Vec3 point_at(const Contour& c, const std::vector<double>& arc, double u) {
  const auto next = std::clamp<std::ptrdiff_t>(std::upper_bound(arc.begin(), arc.end(), u) - arc.begin(), 1,
                                               static_cast<std::ptrdiff_t>(c.size()));
  const auto i = static_cast<std::size_t>(next - 1);
  const double span = arc[i + 1] - arc[i];
  return lerp(c[i], c[(i + 1) % c.size()], span > 0 ? std::clamp((u - arc[i]) / span, 0.0, 1.0) : 0);
}

// Begins `c` at the corner that lets `with` travel least.
Contour aligned(const Contour& with, const Contour& c) {
  constexpr int samples = 48;
  const auto arc_with = arc(with), arc_c = arc(c);
  const Vec3 shift = middle(c) - middle(with);
  const std::size_t step = 1 + c.size() / 128;
  std::size_t best = 0;
  double least = INFINITY;
  for (std::size_t start = 0; start < c.size(); start += step) {
    double travel = 0;
    for (int k = 0; k < samples; ++k) {
      const double u = static_cast<double>(k) / samples, v = u + arc_c[start];
      const Vec3 d = point_at(c, arc_c, v < 1 ? v : v - 1) - point_at(with, arc_with, u) - shift;
      travel += dot(d, d);
    }
    if (travel < least) least = travel, best = start;
  }
  Contour turned = c;
  std::rotate(turned.begin(), turned.begin() + static_cast<std::ptrdiff_t>(best), turned.end());
  return turned;
}

// Each gets the other's corners as well, so that at either end nothing but a straight side has been divided.
Pair paired(const Contour& a, const Contour& b) {
  const Contour c = aligned(a, b);
  const auto arc_a = arc(a), arc_c = arc(c);
  std::vector<double> at = arc_a;
  at.insert(at.end(), arc_c.begin(), arc_c.end());
  std::sort(at.begin(), at.end());
  at.erase(std::unique(at.begin(), at.end(), [](double p, double q) { return q - p < 1e-9; }), at.end());
  if (at.size() > 1) at.pop_back();  // 1 is 0 again
  Pair pair;
  for (const double u : at) {
    pair.from.push_back(point_at(a, arc_a, u));
    pair.to.push_back(point_at(c, arc_c, u));
  }
  return pair;
}

Pair shrinking(const Contour& c, Vec3 to) { return {c, Contour(c.size(), to)}; }
Pair growing(const Contour& c, Vec3 from) { return {Contour(c.size(), from), c}; }

// Everything about a morph that does not depend on how far it is.
struct Morph {
  Shape a, b;
  std::vector<Pair> pairs;
  Winding winding = Winding::positive;
};

void pair_islands(const Island& a, const Island& b, std::vector<Pair>& out) {
  out.push_back(paired(a.outer, b.outer));
  const std::size_t both = std::min(a.holes.size(), b.holes.size());
  for (std::size_t i = 0; i < both; ++i) out.push_back(paired(a.holes[i], b.holes[i]));
  for (std::size_t i = both; i < a.holes.size(); ++i) out.push_back(shrinking(a.holes[i], middle(b.outer)));
  for (std::size_t i = both; i < b.holes.size(); ++i) out.push_back(growing(b.holes[i], middle(a.outer)));
}

Morph prepare(const Shape& a, const Shape& b) {
  Morph morph{a, b, {}, Winding::positive};
  const bool text = a.kind == Kind::text && b.kind == Kind::text;
  if (!text) morph.winding = Winding::nonzero;  // a polygon may cross itself
  const auto from = islands(outline_of(a), a.kind == Kind::polygon),
             to = islands(outline_of(b), b.kind == Kind::polygon);
  const std::size_t n = from.size(), m = to.size(), most = std::max(n, m);
  const auto own = [&](const std::vector<Island>& all, auto make) {
    for (const auto& island : all) {
      morph.pairs.push_back(make(island.outer, middle(island.outer)));
      for (const auto& hole : island.holes) morph.pairs.push_back(make(hole, middle(island.outer)));
    }
  };
  if (n == 0) own(to, growing);
  if (m == 0) own(from, shrinking);
  if (n == 0 || m == 0) return morph;
  // In reading order, the fewer spread evenly over the more; who comes second to a partner shrinks into it or grows out
  // of it.
  for (std::size_t i = 0; i < most; ++i) {
    const std::size_t f = i * n / most, t = i * m / most;
    const bool again = i > 0 && (n < m ? (i - 1) * n / most == f : n > m && (i - 1) * m / most == t);
    if (!again) {
      pair_islands(from[f], to[t], morph.pairs);
      continue;
    }
    const Island& island = n > m ? from[f] : to[t];
    const Vec3 partner = middle(n > m ? to[t].outer : from[f].outer);
    const auto move = n > m ? shrinking : growing;
    morph.pairs.push_back(move(island.outer, partner));
    for (const auto& hole : island.holes) morph.pairs.push_back(move(hole, partner));
  }
  return morph;
}

// The last few are kept: a film asks for the same one frame after frame.
std::shared_ptr<const Morph> morph_of(const Shape& a, const Shape& b) {
  static std::mutex mutex;
  static std::deque<std::shared_ptr<const Morph>> recent;
  const auto find = [&] {
    return std::find_if(recent.begin(), recent.end(), [&](const auto& m) { return m->a == a && m->b == b; });
  };
  {
    const std::lock_guard lock(mutex);
    if (const auto i = find(); i != recent.end()) return *i;
  }
  auto made = std::make_shared<const Morph>(prepare(a, b));
  const std::lock_guard lock(mutex);
  if (const auto i = find(); i != recent.end()) return *i;
  recent.push_front(made);
  if (recent.size() > 32) recent.pop_back();
  return made;
}

Mesh between(const Morph& morph, double s) {
  Outline outline;
  for (const auto& [from, to] : morph.pairs) {
    Contour c(from.size());
    for (std::size_t i = 0; i < c.size(); ++i) c[i] = lerp(from[i], to[i], s);
    outline.contours.push_back(std::move(c));
  }
  const auto depth = [](const Shape& shape) { return shape.kind == Kind::text ? shape.depth : 0; };
  return fill(outline, lerp(depth(morph.a), depth(morph.b), s), morph.winding);
}

std::string_view name(Kind kind) {
  constexpr std::array<std::string_view, 15> names{"group",  "sphere", "box",  "cylinder", "cone",
                                                   "torus",  "plane",  "disc", "polygon",  "polyline",
                                                   "points", "text",   "mesh", "light",    "camera"};
  return names[static_cast<std::size_t>(kind)];
}

// Why the meshes cannot be blended vertex by vertex; empty where they can.
std::string obstacle(const Shape& a, const Shape& b, const Mesh& from, const Mesh& to) {
  if (from.positions.size() != to.positions.size())
    return a.kind == b.kind && a.kind != Kind::mesh
               ? fmt::format("{} points against {}", a.points->size(), b.points->size())
               : fmt::format("{} vertices against {}", from.positions.size(), to.positions.size());
  if (from.triangles != to.triangles)
    return a.kind == b.kind ? "as many vertices, but other triangles between them"
                            : fmt::format("a {} and a {} have nothing in common", name(a.kind), name(b.kind));
  return {};
}

}  // namespace

Geometry realise_blend(const Shape& a, const Shape& b, double s, int detail) {
  if (s == 0 || a == b || !std::isfinite(s)) return realise(a, detail);
  if (s == 1) return realise(b, detail);
  if (has_outline(a) && has_outline(b)) {
    if (s <= 0 || s >= 1) return realise(s < 1 ? a : b, detail);
    return {std::make_shared<const Mesh>(between(*morph_of(a, b), s)), {}};
  }
  if (same_but_measures(a, b)) return realise(between(a, b, s), detail);
  const Geometry from = realise(a, detail), to = realise(b, detail);
  if (!obstacle(a, b, *from.mesh, *to.mesh).empty()) return s < 1 ? from : to;
  return {std::make_shared<const Mesh>(between(from, to, s)), {}};
}

bool can_blend(const Shape& a, const Shape& b, std::string* why) {
  if ((has_outline(a) && has_outline(b)) || same_but_measures(a, b)) return true;
  const Geometry from = realise(a), to = realise(b);
  const std::string reason = obstacle(a, b, *from.mesh, *to.mesh);
  if (why != nullptr) *why = reason;
  return reason.empty();
}

}  // namespace betwixt
