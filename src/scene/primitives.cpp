// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "scene/primitives.h"

#include <algorithm>

#include "scene/topology.h"

namespace betwixt {
namespace {

using Index = std::uint32_t;

Index add(Mesh& mesh, Vec3 position, Vec3 normal) {
  mesh.positions.push_back(narrow(position));
  mesh.normals.push_back(narrow(normal));
  return static_cast<Index>(mesh.positions.size() - 1);
}

Index add(Mesh& mesh, Vec3 position, Vec3 normal, double u, double v) {
  mesh.uvs.push_back({static_cast<float>(u), static_cast<float>(v)});
  return add(mesh, position, normal);
}

void triangle(Mesh& mesh, Index a, Index b, Index c) { mesh.triangles.insert(mesh.triangles.end(), {a, b, c}); }

// a b c d counter-clockwise.
void quad(Mesh& mesh, Index a, Index b, Index c, Index d) {
  triangle(mesh, a, b, c);
  triangle(mesh, a, c, d);
}

Mesh finished(Mesh mesh, bool closed) {
  mesh.edges = crease_edges(mesh);
  mesh.closed = closed;
  return mesh;
}

// The direction at step i of n around the y axis. The seam (i = 0 and n) is at -z, the middle of the picture at +z, and
// the last direction has the very bits of the first, so that the surface is closed.
Vec3 around_y(int i, int n) {
  const double angle = 2 * pi * (i % n) / n - pi;
  return {std::sin(angle), 0, std::cos(angle)};
}

// A flat round cap at height y, facing up (+1) or down (-1).
void cap(Mesh& mesh, int around, double y, double facing) {
  const Vec3 normal{0, facing, 0};
  const Index hub = add(mesh, {0, y, 0}, normal, 0.5, 0.5);
  for (int i = 0; i <= around; ++i) {
    const Vec3 d = around_y(i, around);
    add(mesh, {d.x, y, d.z}, normal, 0.5 + 0.5 * d.x, 0.5 + facing * 0.5 * d.z);
  }
  for (Index i = 1; i <= static_cast<Index>(around); ++i)
    facing > 0 ? triangle(mesh, hub, hub + i, hub + i + 1) : triangle(mesh, hub, hub + i + 1, hub + i);
}

}  // namespace

Mesh sphere_mesh(int around, int up) {
  Mesh mesh;
  for (int j = 0; j <= up; ++j) {
    const double angle = pi * j / up, r = j == up ? 0 : std::sin(angle);
    for (int i = 0; i <= around; ++i) {
      const Vec3 d = around_y(i, around);
      const Vec3 p{r * d.x, std::cos(angle), r * d.z};
      const bool pole = j == 0 || j == up;  // one vertex for each face, in its middle
      add(mesh, p, p, std::min(1.0, (i + (pole ? 0.5 : 0)) / around), static_cast<double>(j) / up);
    }
  }
  const Index row = static_cast<Index>(around) + 1;
  for (Index j = 0; j < static_cast<Index>(up); ++j)
    for (Index i = 0; i < static_cast<Index>(around); ++i) {
      const Index a = j * row + i, b = a + row;
      if (j + 1 < static_cast<Index>(up))
        triangle(mesh, a, b, b + 1);
      else
        triangle(mesh, a, b, a + 1);
      if (j > 0 && j + 1 < static_cast<Index>(up)) triangle(mesh, a, b + 1, a + 1);
    }
  return finished(std::move(mesh), true);
}

Mesh box_mesh() {
  Mesh mesh;
  const Vec3 y{0, 1, 0}, z{0, 0, 1};
  const auto face = [&](Vec3 normal, Vec3 upward) {
    const Vec3 right = cross(upward, normal), n = 0.5 * normal, u = 0.5 * upward, r = 0.5 * right;
    const Index a = add(mesh, n - u - r, normal, 0, 1);
    add(mesh, n - u + r, normal, 1, 1);
    add(mesh, n + u + r, normal, 1, 0);
    add(mesh, n + u - r, normal, 0, 0);
    quad(mesh, a, a + 1, a + 2, a + 3);
  };
  for (const Vec3 side : {z, Vec3{1, 0, 0}, -z, Vec3{-1, 0, 0}}) face(side, y);
  face(y, -z);
  face(-y, z);
  return finished(std::move(mesh), true);
}

Mesh round_box_mesh(Vec3 half, double radius, int steps) {
  Mesh mesh;
  // Each face goes half way around its edges. Of a direction (a b 1) seen from the face, a and b are one of these.
  std::vector<double> slopes;
  for (int i = -steps; i <= steps; ++i) {
    const double s = std::abs(i) == steps ? 1 : std::tan(pi / 4 * std::abs(i) / steps);
    slopes.push_back(i < 0 ? -s : s);
    if (i == 0) slopes.push_back(0);  // both ends of the flat part
  }
  const auto side = static_cast<Index>(slopes.size());
  const Vec3 inner{half.x - radius, half.y - radius, half.z - radius};
  const auto face = [&](Vec3 normal, Vec3 upward) {
    const Vec3 right = cross(upward, normal), r = half * right, u = half * upward;
    const Index first = static_cast<Index>(mesh.positions.size());
    for (Index j = 0; j < side; ++j)
      for (Index i = 0; i < side; ++i) {
        const double a = slopes[i], b = slopes[j];
        const Vec3 way = 1 / std::sqrt(a * a + b * b + 1) * (a * right + b * upward + normal);
        const Vec3 middle = inner * (normal + (2 * i < side ? -1 : 1) * right + (2 * j < side ? -1 : 1) * upward);
        const Vec3 p = middle + radius * way;
        const double x = dot(p, right) / length(r), y = dot(p, upward) / length(u);
        add(mesh, p, way, 0.5 + 0.5 * x, 0.5 - 0.5 * y);
        const auto has_area = [&](Index k, Vec3 axis) {  // the flat part has none if all of it is round
          return k > 0 && (2 * k != side || std::abs(dot(inner, axis)) > 0);
        };
        if (has_area(i, right) && has_area(j, upward)) {
          const Index at = first + j * side + i;
          quad(mesh, at - side - 1, at - side, at, at - 1);
        }
      }
  };
  const Vec3 y{0, 1, 0}, z{0, 0, 1};
  for (const Vec3 towards : {z, Vec3{1, 0, 0}, -z, Vec3{-1, 0, 0}}) face(towards, y);
  face(y, -z);
  face(-y, z);
  return finished(std::move(mesh), true);
}

Mesh cylinder_mesh(int around) {
  Mesh mesh;
  for (int i = 0; i <= around; ++i) {
    const Vec3 d = around_y(i, around);
    const double u = static_cast<double>(i) / around;
    add(mesh, {d.x, 0.5, d.z}, d, u, 0);
    add(mesh, {d.x, -0.5, d.z}, d, u, 1);
  }
  for (Index i = 0; i < 2 * static_cast<Index>(around); i += 2) quad(mesh, i, i + 1, i + 3, i + 2);
  cap(mesh, around, 0.5, 1);
  cap(mesh, around, -0.5, -1);
  return finished(std::move(mesh), true);
}

Mesh cone_mesh(int around) {
  Mesh mesh;
  const auto slope = [](Vec3 d) { return normalize(Vec3{d.x, 1, d.z}); };  // radius 1, height 1: 45 degrees
  for (int i = 0; i < around; ++i) {
    const Vec3 a = around_y(i, around), b = around_y(i + 1, around);
    const double u = static_cast<double>(i) / around, step = 1.0 / around;
    const Index tip = add(mesh, {0, 0.5, 0}, slope(normalize(a + b)), u + step / 2, 0);
    add(mesh, {a.x, -0.5, a.z}, slope(a), u, 1);
    add(mesh, {b.x, -0.5, b.z}, slope(b), std::min(1.0, u + step), 1);
    triangle(mesh, tip, tip + 1, tip + 2);
  }
  cap(mesh, around, -0.5, -1);
  return finished(std::move(mesh), true);
}

Mesh plane_mesh() {
  Mesh mesh;
  const Vec3 z{0, 0, 1};
  add(mesh, {-0.5, -0.5, 0}, z, 0, 1);
  add(mesh, {0.5, -0.5, 0}, z, 1, 1);
  add(mesh, {0.5, 0.5, 0}, z, 1, 0);
  add(mesh, {-0.5, 0.5, 0}, z, 0, 0);
  quad(mesh, 0, 1, 2, 3);
  return finished(std::move(mesh), false);
}

Mesh disc_mesh(int around) {
  Mesh mesh;
  const Vec3 z{0, 0, 1};
  add(mesh, {0, 0, 0}, z, 0.5, 0.5);
  for (int i = 0; i <= around; ++i) {
    const double angle = 2 * pi * (i % around) / around, x = std::cos(angle), y = std::sin(angle);
    add(mesh, {x, y, 0}, z, 0.5 + 0.5 * x, 0.5 - 0.5 * y);
  }
  for (Index i = 1; i <= static_cast<Index>(around); ++i) triangle(mesh, 0, i, i + 1);
  return finished(std::move(mesh), false);
}

Mesh torus_mesh(double radius, double tube, int around, int across) {
  Mesh mesh;
  for (int i = 0; i <= around; ++i)
    for (int j = 0; j <= across; ++j) {
      const Vec3 d = around_y(i, around);
      const double angle = 2 * pi * (j % across) / across;  // from the outer rim over the top
      const Vec3 n = std::cos(angle) * d + Vec3{0, std::sin(angle), 0};
      add(mesh, radius * d + tube * n, n, static_cast<double>(i) / around, 1 - static_cast<double>(j) / across);
    }
  const Index row = static_cast<Index>(across) + 1;
  for (Index i = 0; i < static_cast<Index>(around); ++i)
    for (Index j = 0; j < static_cast<Index>(across); ++j) {
      const Index a = i * row + j;
      quad(mesh, a, a + row, a + row + 1, a + 1);
    }
  return finished(std::move(mesh), tube <= radius);
}

namespace {

// The rings of a tube. `side` stays perpendicular to the direction of the tube, so that it does not twist.
struct Sweep {
  Mesh mesh;
  int around;
  double radius;
  Vec3 along, side;
  std::vector<std::pair<double, double>> turns;  // cosine and sine of each step round

  Sweep(int steps, double r, Vec3 direction) : around(steps), radius(r), along(direction) {
    for (int i = 0; i < steps; ++i) {
      const double angle = 2 * pi * i / steps;
      turns.emplace_back(std::cos(angle), std::sin(angle));
    }
  }

  // Adds a ring about `centre`, leaning forward by an angle (back if negative): a circle of a ball.
  void ring(Vec3 centre, double lean = 0) {
    const Vec3 other = cross(along, side);
    const double outwards = std::cos(lean), forward = std::sin(lean);
    for (const auto& [cosine, sine] : turns) {
      const Vec3 outward = cosine * side + sine * other;
      const Vec3 normal = outwards * outward + forward * along;
      add(mesh, centre + radius * normal, normal);
    }
    const Index n = static_cast<Index>(around), now = static_cast<Index>(mesh.positions.size()) - n;
    if (now < n + 1) return;
    for (Index i = 0; i < n; ++i) {
      const Index j = (i + 1) % n;
      quad(mesh, now - n + i, now - n + j, now + j, now + i);
    }
  }
  // Turns from facing `along` to facing `to` in small steps; the rings together are the outside of a ball.
  void turn(Vec3 centre, Vec3 to) {
    const double angle = std::atan2(length(cross(along, to)), dot(along, to));
    if (angle < 1e-6) {
      along = to;
      return;
    }
    const Vec3 axis = normalize(cross(along, to), side);
    const int steps = 1 + static_cast<int>(angle / (2 * pi / around));
    const Mat4 step = rotation(axis_angle(axis, angle / steps));
    for (int i = 0; i < steps; ++i) {
      along = normalize(transform_vector(step, along));
      side = normalize(transform_vector(step, side));
      ring(centre);
    }
    along = to;
    side = normalize(side - dot(side, to) * to);
  }

  // Closes the ends with fans, whose centres are the mesh's first and last point.
  void close() {
    const Index n = static_cast<Index>(around), end = static_cast<Index>(mesh.positions.size()) - 1;
    for (Index i = 0; i < n; ++i) {
      const Index j = (i + 1) % n;
      triangle(mesh, 0, 1 + j, 1 + i);
      triangle(mesh, end, end - n + i, end - n + j);
    }
  }
  // Sets its crease edges. A line has too many triangles to search for neighbours in each picture, and here their
  // positions are known: each ring adds two triangles a step, and the fans come after them, alternating.
  // Where two rings share a corner, the triangle between them has no area, and its sides count as creases.
  void find_edges() {
    const std::vector<Vec3> normals = face_normals(mesh);
    const Index n = static_cast<Index>(around), end = static_cast<Index>(mesh.positions.size()) - 1;
    const Index rings = (end - 1) / n, fans = 2 * n * (rings - 1);
    mesh.edges.reserve(3 * mesh.positions.size());
    const auto edge = [&](Index a, Index b, Index one, Index other) {
      if (!creased(normals[one], normals[other])) return;
      mesh.edges.push_back(a), mesh.edges.push_back(b);
    };
    for (Index i = 0; i < n; ++i) {
      const Index j = (i + 1) % n, before = (i + n - 1) % n;
      edge(0, 1 + i, fans + 2 * i, fans + 2 * before);
      for (Index r = 0; r < rings; ++r) {
        const Index at = 1 + r * n, strip = 2 * n * r;  // the strip from this ring to the next
        edge(at + i, at + j, r == 0 ? fans + 2 * i : strip - 2 * n + 2 * i + 1,
             r + 1 == rings ? fans + 2 * i + 1 : strip + 2 * i);
        if (r + 1 == rings) continue;
        edge(at + i, at + n + i, strip + 2 * i + 1, strip + 2 * before);
        edge(at + i, at + n + j, strip + 2 * i, strip + 2 * i + 1);
      }
      edge(end, end - n + i, fans + 2 * i + 1, fans + 2 * before + 1);
    }
  }
};

}  // namespace

Mesh tube_mesh(const std::vector<Vec3>& given, double diameter, int around) {
  std::vector<Vec3> points;
  for (const Vec3 p : given)
    if (points.empty() || length(p - points.back()) > 1e-6 * diameter) points.push_back(p);
  if (points.size() < 2) return balls_mesh(points, diameter, sphere_mesh(around, std::max(2, around / 2)));

  Sweep sweep(around, diameter / 2, normalize(points[1] - points[0]));
  const Vec3 d = sweep.along, a{std::abs(d.x), std::abs(d.y), std::abs(d.z)};
  sweep.side = normalize(cross(d, a.x <= a.y && a.x <= a.z ? Vec3{1, 0, 0}
                                  : a.y <= a.z             ? Vec3{0, 1, 0}
                                                           : Vec3{0, 0, 1}));

  const int cap_rings = std::max(1, around / 4);
  add(sweep.mesh, points.front() - sweep.radius * d, -d);
  for (int i = 1; i <= cap_rings; ++i) sweep.ring(points.front(), 0.5 * pi * i / cap_rings - 0.5 * pi);
  for (std::size_t i = 1; i < points.size(); ++i) {
    sweep.ring(points[i]);
    if (i + 1 < points.size()) sweep.turn(points[i], normalize(points[i + 1] - points[i]));
  }
  for (int i = 1; i < cap_rings; ++i) sweep.ring(points.back(), 0.5 * pi * i / cap_rings);
  add(sweep.mesh, points.back() + sweep.radius * sweep.along, sweep.along);
  sweep.close();
  sweep.find_edges();
  sweep.mesh.closed = true;
  return std::move(sweep.mesh);
}

Mesh joined(std::vector<Mesh> parts) {
  if (parts.empty()) return {};
  Mesh all = std::move(parts.front());
  for (auto part = parts.begin() + 1; part != parts.end(); ++part) {
    const Index base = static_cast<Index>(all.positions.size());
    all.positions.insert(all.positions.end(), part->positions.begin(), part->positions.end());
    all.normals.insert(all.normals.end(), part->normals.begin(), part->normals.end());
    for (const Index i : part->triangles) all.triangles.push_back(base + i);
    for (const Index i : part->edges) all.edges.push_back(base + i);
    all.closed = all.closed && part->closed;
  }
  return all;
}

Mesh line_mesh(const std::vector<Vec3>& points) {
  Mesh mesh;
  for (const Vec3 p : points) add(mesh, p, {0, 0, 1});
  for (Index i = 1; i < points.size(); ++i) mesh.edges.insert(mesh.edges.end(), {i - 1, i});
  return mesh;
}

Mesh balls_mesh(const std::vector<Vec3>& points, double diameter, const Mesh& ball) {
  Mesh mesh;
  for (const Vec3 p : points) {
    const Index base = static_cast<Index>(mesh.positions.size());
    for (const auto& b : ball.positions) mesh.positions.push_back(narrow(p + 0.5 * diameter * widen(b)));
    mesh.normals.insert(mesh.normals.end(), ball.normals.begin(), ball.normals.end());
    for (const Index i : ball.triangles) mesh.triangles.push_back(base + i);
    for (const Index i : ball.edges) mesh.edges.push_back(base + i);
  }
  mesh.closed = !points.empty();
  return mesh;
}

}  // namespace betwixt
