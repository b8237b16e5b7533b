// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The default camera of films without cameras.
#include "program/stage.h"

#include <algorithm>
#include <cmath>

#include "program/evaluator.h"
#include "scene/extent.h"

namespace betwixt {

namespace {

// Returns a box around everything visible during the film. Grounds and walls count only if there is nothing else.
Extent stage_of(const Program::Compiled& compiled) {
  Extent things, grounds;
  const auto [from, to] = compiled.document.range();
  constexpr int looks = 24;
  Evaluator film(compiled);
  for (int k = 0; k <= looks; ++k) {
    Asking asking;
    film.to({from.flicks + (to - from).flicks / looks * k}, asking);
    for (const std::uint32_t i : film.changed) {
      if (!film.looks[i].visible) continue;
      const Shape& shape = *film.shape(film.looks[i].shape);
      const Extent e = extent(shape);
      if (e.empty()) continue;
      Extent& all = row_of(shape.kind).ground ? grounds : things;
      for (int corner = 0; corner < 8; ++corner) {
        const Vec3 p = transform_point(
            film.worlds()[i],
            {corner & 1 ? e.high.x : e.low.x, corner & 2 ? e.high.y : e.low.y, corner & 4 ? e.high.z : e.low.z});
        if (finite(p)) all.add(p);
      }
    }
  }
  if (!things.empty()) return things;
  return grounds.empty() ? Extent{{-1, -1, -1}, {1, 1, 1}} : grounds;
}

}  // namespace

const Camera& own_camera(const Program::Compiled& compiled) {
  OwnCamera& own = compiled.caches.camera;
  std::call_once(own.once, [&] {
    Camera& c = own.made;
    c.aspect = compiled.document.aspect();
    if (compiled.document.scene().appearance.flat) {
      c.world = translation({0, 0, 100}), c.orthographic = true, c.height = 9;
      return;
    }
    const Extent all = stage_of(compiled);
    c.fov = 2 * std::atan(36.0 / 70);
    // If the film gives no size, fits a picture of 16:9, the widest in common use; then taller pictures fit too.
    const Vec3 middle = 0.5 * (all.low + all.high), half = 0.5 * (all.high - all.low);
    const double across = std::tan(c.fov / 2), up = across / std::max(c.aspect, 16.0 / 9);
    const Mat4 turned = look_at(normalize(Vec3{0, 0.12, 1}), {});
    double distance = 1e-3;
    for (int corner = 0; corner < 8; ++corner) {
      const Vec3 p = half * Vec3{corner & 1 ? 1.0 : -1.0, corner & 2 ? 1.0 : -1.0, corner & 4 ? 1.0 : -1.0};
      const auto along = [&](int axis) {
        return p.x * turned(0, axis) + p.y * turned(1, axis) + p.z * turned(2, axis);
      };
      distance = std::max(distance, along(2) + 1.1 * std::max(std::abs(along(0)) / across, std::abs(along(1)) / up));
    }
    c.world = look_at(middle + distance * normalize(Vec3{0, 0.12, 1}), middle);
  });
  return own.made;
}

}  // namespace betwixt
