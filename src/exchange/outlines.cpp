// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "exchange/outlines.h"

#include <GL/glu.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <map>

#include "scene/primitives.h"
#include "scene/topology.h"

namespace betwixt {
namespace {

using Index = std::uint32_t;

// Flat triangles with shared points, or the borders of the filled area, which is on their left.
struct Filling {
  std::deque<Vec3> points;  // a deque, because the tessellator stores pointers into it
  std::vector<Index> triangles;
  Contours loops;
  bool failed = false;
};

Index add(Filling& out, Vec3 p) {
  out.points.push_back(p);
  return static_cast<Index>(out.points.size() - 1);
}
// The tessellator carries indices as pointers.
void* handle(Index i) { return reinterpret_cast<void*>(static_cast<std::uintptr_t>(i)); }

void on_begin(GLenum what, void* out) {
  if (what == GL_LINE_LOOP) static_cast<Filling*>(out)->loops.emplace_back();
}
void on_edge(GLboolean) {}  // registering it makes the tessellator emit plain triangles
void on_vertex(void* vertex, void* to) {
  Filling& out = *static_cast<Filling*>(to);
  const auto i = static_cast<Index>(reinterpret_cast<std::uintptr_t>(vertex));
  if (out.loops.empty())
    out.triangles.push_back(i);
  else
    out.loops.back().push_back(out.points[i]);
}
void on_crossing(GLdouble at[3], void* [4], GLfloat[4], void** vertex, void* out) {
  *vertex = handle(add(*static_cast<Filling*>(out), {at[0], at[1], at[2]}));
}
void on_error(GLenum, void* out) { static_cast<Filling*>(out)->failed = true; }

template <class F>
auto callback(F* f) {
  return reinterpret_cast<_GLUfuncptr>(f);
}

Filling tessellate(const Contours& contours, Vec3 normal, Winding winding, bool borders) {
  Filling out;
  GLUtesselator* tess = gluNewTess();
  if (tess == nullptr) return out;
  gluTessCallback(tess, GLU_TESS_BEGIN_DATA, callback(on_begin));
  if (!borders) gluTessCallback(tess, GLU_TESS_EDGE_FLAG, callback(on_edge));
  gluTessProperty(tess, GLU_TESS_BOUNDARY_ONLY, borders ? GL_TRUE : GL_FALSE);
  gluTessCallback(tess, GLU_TESS_VERTEX_DATA, callback(on_vertex));
  gluTessCallback(tess, GLU_TESS_COMBINE_DATA, callback(on_crossing));
  gluTessCallback(tess, GLU_TESS_ERROR_DATA, callback(on_error));
  gluTessProperty(tess, GLU_TESS_WINDING_RULE,
                  winding == Winding::nonzero    ? GLU_TESS_WINDING_NONZERO
                  : winding == Winding::positive ? GLU_TESS_WINDING_POSITIVE
                                                 : GLU_TESS_WINDING_ODD);
  gluTessNormal(tess, normal.x, normal.y, normal.z);
  gluTessBeginPolygon(tess, &out);
  for (const auto& contour : contours) {
    gluTessBeginContour(tess);
    for (const Vec3 p : contour) {
      GLdouble at[3] = {p.x, p.y, p.z};
      gluTessVertex(tess, at, handle(add(out, p)));
    }
    gluTessEndContour(tess);
  }
  gluTessEndPolygon(tess);
  gluDeleteTess(tess);
  if (out.failed || out.triangles.size() % 3 != 0) out.triangles.clear(), out.loops.clear();
  return out;
}

// Returns the border sides of the filling, each from point to point with the inside on the left.
std::multimap<Index, Index> border(const std::vector<Index>& triangles) {
  std::map<std::pair<Index, Index>, int> uses;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const Index a = triangles[i], b = triangles[i % 3 == 2 ? i - 2 : i + 1];
    if (--uses[{b, a}] == 0) uses.erase({b, a});
    if (++uses[{a, b}] == 0) uses.erase({a, b});
  }
  std::multimap<Index, Index> sides;
  for (const auto& [side, n] : uses)
    for (int i = 0; i < n; ++i) sides.emplace(side.first, side.second);
  return sides;
}

void flat_side(Mesh& mesh, const Filling& filling, Vec3 normal, Vec3 shift, bool turned) {
  const Index base = static_cast<Index>(mesh.positions.size());
  for (const Vec3 p : filling.points) {
    mesh.positions.push_back(narrow(p + shift));
    mesh.normals.push_back(narrow(normal));
  }
  for (std::size_t i = 0; i < filling.triangles.size(); i += 3) {
    const Index *t = &filling.triangles[i], second = t[turned ? 2 : 1], third = t[turned ? 1 : 2];
    mesh.triangles.insert(mesh.triangles.end(), {base + t[0], base + second, base + third});
  }
}

void walls(Mesh& mesh, const Filling& filling, Vec3 facing, Vec3 shift) {
  const auto sides = border(filling.triangles);
  std::map<Index, Vec3> entering;  // by end point: the normal of the wall that ends there
  std::map<Index, int> ends;
  const auto wall = [&](Index a, Index b) { return normalize(cross(filling.points[b] - filling.points[a], facing)); };
  for (const auto& [a, b] : sides) {
    entering[b] = wall(a, b);
    ++ends[b];
  }
  const double smooth = std::cos(30 * pi / 180);
  // Two walls that meet nearly straight, and without others, share their normal there.
  const auto joined = [&](Index at, Vec3 own, Vec3 neighbour) {
    return ends[at] == 1 && sides.count(at) == 1 && dot(own, neighbour) > smooth ? normalize(own + neighbour) : own;
  };
  for (const auto& [a, b] : sides) {
    const Vec3 own = wall(a, b), at_a = joined(a, own, entering[a]);
    const auto next = sides.find(b);
    const Vec3 at_b = next == sides.end() ? own : joined(b, own, wall(b, next->second));
    const Index base = static_cast<Index>(mesh.positions.size());
    const Vec3 pa = filling.points[a], pb = filling.points[b];
    for (const Vec3 p : {pa - shift, pb - shift, pb + shift, pa + shift}) mesh.positions.push_back(narrow(p));
    for (const Vec3 n : {at_a, at_b, at_b, at_a}) mesh.normals.push_back(narrow(n));
    mesh.triangles.insert(mesh.triangles.end(), {base, base + 1, base + 2, base, base + 2, base + 3});
  }
}

}  // namespace

namespace {

Mesh filled(const Contours& contours, Vec3 normal, double depth, Winding winding) {
  Mesh mesh;
  const Vec3 half = depth / 2 * normal;
  const Filling filling = tessellate(contours, normal, winding, false);
  if (filling.triangles.empty()) return mesh;
  flat_side(mesh, filling, normal, half, false);
  if (depth > 0) {
    flat_side(mesh, filling, -normal, -half, true);
    walls(mesh, filling, normal, half);
  }
  mesh.edges = crease_edges(mesh);
  mesh.closed = depth > 0 && is_closed(mesh);
  return mesh;
}

}  // namespace

double turn(const Contour& c, Vec3 facing) {
  Vec3 sum{};
  for (std::size_t i = 0; i < c.size(); ++i) sum = sum + cross(c[i] - c[0], c[(i + 1) % c.size()] - c[0]);
  return dot(sum, facing);
}

bool contains(const Contour& c, Vec3 p) {
  bool inside = false;
  for (std::size_t i = 0, j = c.size() - 1; i < c.size(); j = i++)
    if ((c[i].y > p.y) != (c[j].y > p.y) && p.x < std::lerp(c[i].x, c[j].x, (p.y - c[i].y) / (c[j].y - c[i].y)))
      inside = !inside;
  return inside;
}

std::vector<Island> islands(const Contours& contours, Winding winding) {
  std::vector<Island> out;
  std::vector<double> areas;
  constexpr Vec3 up{0, 0, 1};
  const Contours loops = tessellate(contours, up, winding, true).loops;
  for (const Contour& loop : loops)
    if (const double area = turn(loop, up); area > 0) out.push_back({loop, {}}), areas.push_back(area);
  for (const Contour& loop : loops) {
    if (!(turn(loop, up) < 0)) continue;
    // The middle of a side, because corners may also belong to contours around it.
    const Vec3 on_it = 0.5 * (loop[0] + loop[1]);
    std::size_t around = out.size();
    for (std::size_t i = 0; i < out.size(); ++i)
      if ((around == out.size() || areas[i] < areas[around]) && contains(out[i].outer, on_it)) around = i;
    if (around < out.size()) out[around].holes.push_back(loop);
  }
  return out;
}

Mesh fill(const Outline& outline, double depth, Winding winding) {
  return filled(outline.contours, facing(outline.contours), depth, winding);
}

Mesh drawn(const Outline& outline, const Pen& pen, double depth, Winding winding) {
  if (!(pen.width > 0)) return pen.fills ? fill(outline, depth, winding) : Mesh{};
  const Vec3 up = facing(outline.contours);
  const Contours areas = stroke_areas(outline.contours, pen, up);
  std::vector<Mesh> both;
  if (pen.fills) {
    Contours left = tessellate(outline.contours, up, winding, true).loops;
    for (auto& loop : tessellate(areas, up, Winding::nonzero, true).loops) {
      std::reverse(loop.begin(), loop.end());
      left.push_back(std::move(loop));
    }
    both.push_back(filled(left, up, depth, Winding::positive));
  }
  both.push_back(filled(areas, up, depth, Winding::nonzero));
  const auto stroke = static_cast<std::uint32_t>(both.back().triangles.size());
  Mesh mesh = joined(std::move(both));
  const auto all = static_cast<std::uint32_t>(mesh.triangles.size());
  mesh.parts.push_back({0, all - stroke, {1, 1, 1}, nullptr});
  mesh.parts.push_back({all - stroke, stroke, narrow(pen.color.value_or(Vec3{1, 1, 1})), nullptr, !pen.color, true});
  return mesh;
}

}  // namespace betwixt
