// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Where the parts of an object of a flat picture are in it.
#include <algorithm>
#include <cmath>

#include "render/flat.h"

namespace betwixt {
namespace {

struct Point {
  double x, y, depth;
};

// Moves points of a mesh to the picture: x and y in pixels.
class Projection {
 public:
  Projection(const View& v, const Instance& instance) : width_(v.width), height_(v.height) {
    Mat4 m;
    for (int i = 0; i < 3; ++i)
      for (int k = 0; k < 4; ++k) m(i, k) = static_cast<double>(instance.rows[static_cast<std::size_t>(4 * i + k)]);
    all_ = v.clip() * m;
    for (int k = 0; k < 4; ++k) depth_[static_cast<std::size_t>(k)] = -dot(v.backward, {m(0, k), m(1, k), m(2, k)});
  }
  const Mat4& to_clip() const { return all_; }
  Point operator()(const std::array<float, 3>& p) const {
    const double x = static_cast<double>(p[0]), y = static_cast<double>(p[1]), z = static_cast<double>(p[2]);
    const auto row = [&](int i) { return all_(i, 0) * x + all_(i, 1) * y + all_(i, 2) * z + all_(i, 3); };
    const double w = row(3);
    return {0.5 * width_ * (row(0) / w + 1), 0.5 * height_ * (row(1) / w + 1),
            depth_[0] * x + depth_[1] * y + depth_[2] * z + depth_[3]};
  }

 private:
  double width_, height_;
  Mat4 all_;
  std::array<double, 4> depth_;
};

}  // namespace

void FlatPainter::outline(Painted& to, const Thing& t) const {
  to.parts.clear(), to.edges.clear();
  to.good = true;
  if (!t.visible) return;
  to.good = t.surface && !t.ball && t.texture == nullptr && t.mesh != nullptr && !t.mesh->see_through;
  if (!to.good) return;
  const Projection project(things_.view(), t.instance);
  const Mesh& mesh = *t.mesh->mesh;
  std::vector<Point> points;
  points.reserve(mesh.positions.size());
  for (const auto& p : mesh.positions) points.push_back(project(p));
  to.front = to.back = points.empty() ? 0 : points.front().depth;
  for (const Point& p : points) {
    to.front = std::min(to.front, p.depth), to.back = std::max(to.back, p.depth);
    to.good = to.good && p.depth > 1e-9 && std::abs(p.x) < 1e7 && std::abs(p.y) < 1e7;
  }
  if (!to.good) return;
  Store::need_twins(*t.mesh);
  const std::vector<std::uint32_t>& corners = mesh.triangles;
  const Vec3 half = t.mesh->box.half();
  const bool thick = !t.pressed && half.z > 1e-6 * std::max(half.x, half.y);
  const double outside = t.mirrored ? 1 : -1;  // the sign of a triangle that is seen from outside: y goes down
  const bool may_share = t.mesh->parts.size() == 1 && t.shape->kind != Kind::text;
  // The sign of the area of each triangle as seen; 0 if it is not drawn.
  std::vector<signed char> seen(corners.size() / 3);
  std::vector<std::uint32_t> part_of(seen.size());
  for (std::size_t p = 0; p < t.mesh->parts.size(); ++p) {
    const StoredPart& part = t.mesh->parts[p];
    to.good = to.good && part.texture == nullptr;
    for (std::size_t k = part.first; k + 2 < part.first + part.count; k += 3) {
      const Point &a = points[corners[k]], &b = points[corners[k + 1]], &c = points[corners[k + 2]];
      const double area = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
      if (area != 0 && !(t.closed && area * outside < 0)) seen[k / 3] = area < 0 ? -1 : 1;
      part_of[k / 3] = static_cast<std::uint32_t>(p);
    }
  }
  for (std::size_t p = 0; p < t.mesh->parts.size(); ++p) {
    const StoredPart& part = t.mesh->parts[p];
    Paint paint;
    paint.area = Area(width_, height_);
    for (std::size_t k = part.first; k < part.first + part.count / 3 * 3; ++k) {
      const std::size_t triangle = k / 3, other = t.mesh->twins[k] / 3;
      // Edges within an area have an opposite one beside: the two would cancel.
      if (seen[triangle] == 0 || (other != triangle && seen[other] == seen[triangle] && part_of[other] == p)) continue;
      const Point &a = points[corners[k]], &b = points[corners[k % 3 == 2 ? k - 2 : k + 1]];
      const Point &start = seen[triangle] < 0 ? b : a, &end = seen[triangle] < 0 ? a : b;
      paint.area.add(static_cast<float>(start.x), static_cast<float>(start.y), static_cast<float>(end.x),
                     static_cast<float>(end.y));
      if (may_share)
        to.edges.add(static_cast<float>(start.x), static_cast<float>(start.y), static_cast<float>(end.x),
                     static_cast<float>(end.y));
    }
    if (paint.area.empty()) continue;
    paint.area.finish();
    const auto channel = [&](std::size_t i) {
      return std::min((part.tinted ? t.instance.color[i] : 1.F) * part.color[i], 1.F);
    };
    paint.color = {channel(0), channel(1), channel(2)};
    paint.opacity = t.instance.color[3];
    if (const Gradient* const gradient = gradient_of(t.gradients.get(), part.tinted, part.stroke)) {
      const auto rows = rows_from_pixels(placed_gradient(*gradient, t.gradient_box, t.to_object), project.to_clip(),
                                         width_, height_, t.mesh->box.middle().z);
      if (rows)
        paint.graded =
            std::make_shared<const Graded>(Graded{GradientColors(*gradient), *rows, is_even(*gradient, *rows, width_)});
      to.good = to.good && rows && !thick;
    }
    if (paint.graded || paint.opacity < 1) to.edges.clear();
    to.parts.push_back(std::move(paint));
  }
}

}  // namespace betwixt
