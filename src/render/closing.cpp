// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "render/closing.h"

#include <algorithm>
#include <cmath>

namespace betwixt {
namespace {

// Returns whether two numbers differ by more than any speed explains within a flick.
bool far_apart(double a, double b) { return std::abs(a - b) > 1e-6 * (1 + std::max(std::abs(a), std::abs(b))); }
bool far_apart(const Mat4& a, const Mat4& b) {
  return !std::equal(a.m.begin(), a.m.end(), b.m.begin(), [](double x, double y) { return !far_apart(x, y); });
}

// A mesh with joints is another one at every time; no part of it moves far within a flick.
bool jumps(const Mesh& a, const Mesh& b) {
  if (!a.posed || !b.posed || a.positions.size() != b.positions.size()) return true;
  constexpr float near = 1e-4F;
  for (std::size_t i = 0; i < a.positions.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k)
      if (std::abs(a.positions[i][k] - b.positions[i][k]) > near * (1 + std::abs(a.positions[i][k]))) return true;
  return false;
}

bool jumps(const std::shared_ptr<const Shape>& a, const std::shared_ptr<const Shape>& b) {
  if (a == b) return false;
  const auto meshes = [&] { return a->mesh != b->mesh && (!a->mesh || !b->mesh || jumps(*a->mesh, *b->mesh)); };
  if (!a || !b || a->kind != b->kind || meshes() || *a->text != *b->text || a->points->size() != b->points->size())
    return true;
  for (const auto measure : shape_measures)
    if (far_apart((*a).*measure, (*b).*measure)) return true;
  for (std::size_t i = 0; i < a->points->size(); ++i)
    if (far_apart((*a->points)[i], (*b->points)[i])) return true;
  return far_apart(a->size, b->size);
}

bool jumps(const Content& a, const Content& b) {
  const Evaluation::Look &l = a.look, &m = b.look;
  if (!l.visible && !m.visible) return false;
  return l.visible != m.visible || far_apart(a.world, b.world) || far_apart(l.color, m.color) ||
         far_apart(l.transparency, m.transparency) || far_apart(l.blend, m.blend) || l.material != m.material ||
         a.texture != b.texture || jumps(a.shape, b.shape) || jumps(a.toward, b.toward);
}

bool jumps(const Light& a, const Light& b) {
  return a.id.index != b.id.index || far_apart(a.position, b.position) || far_apart(a.color, b.color) ||
         a.sun != b.sun || far_apart(a.range, b.range);
}

}  // namespace

bool far_apart(Vec3 a, Vec3 b) { return far_apart(a.x, b.x) || far_apart(a.y, b.y) || far_apart(a.z, b.z); }

bool jumps(const Camera& a, const Camera& b) {
  return far_apart(a.world, b.world) || far_apart(a.fov, b.fov) || a.orthographic != b.orthographic ||
         far_apart(a.height, b.height);
}

bool alike(const std::vector<Light>& a, const std::vector<Light>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const Light& x, const Light& y) { return !jumps(x, y); });
}

Closing closing(Evaluation& e, const std::vector<Time>& breaks) {
  Closing all;
  std::vector<bool> closed;
  for (const Time at : breaks) {
    e.to(at - Time{1});
    const Columns before = columns_of(e);
    std::vector<Content> was;
    for (std::uint32_t i = 0; i < before.worlds.size(); ++i) was.push_back(content_of(before, i));
    const Camera camera = e.camera();
    const std::vector<Light> lights = e.lights();
    e.to(at);
    const Columns after = columns_of(e);
    closed.resize(was.size());
    std::vector<std::uint32_t> jumped;
    for (const std::uint32_t i : e.changed())
      if (!closed[i] && jumps(was[i], content_of(after, i))) jumped.push_back(i), closed[i] = true;
    if (!jumped.empty()) all.places.emplace_back(at, std::move(jumped));
    if (!all.camera && jumps(camera, e.camera())) all.camera = at;
    if (!all.lights && !alike(lights, e.lights())) all.lights = at;
  }
  return all;
}

Held held_at(Evaluation& e, Time opened, double part, const Closing& closing) {
  Held all;
  const auto before = [&](Time at) {
    return std::min(opened + from_seconds(part * (at - opened).seconds()), at - Time{1});
  };
  for (const auto& [at, places] : closing.places) {
    e.to(before(at));
    const Columns columns = columns_of(e);
    for (const std::uint32_t i : places) all.places.emplace_back(i, content_of(columns, i));
  }
  if (closing.camera) e.to(before(*closing.camera)), all.camera = e.camera();
  if (closing.lights) e.to(before(*closing.lights)), all.lights = e.lights();
  return all;
}

}  // namespace betwixt
