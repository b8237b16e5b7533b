// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/viewport/looking.h"

#include <algorithm>
#include <cmath>

#include "betwixt/object.h"
#include "betwixt/pick.h"
#include "scene/functions.h"

namespace betwixt::studio {
namespace {

// The transform without its scales.
Mat4 rigid(const Mat4& m) {
  const Vec3 back = normalize(transform_vector(m, {0, 0, 1}), {0, 0, 1});
  const Vec3 right = normalize(cross(transform_vector(m, {0, 1, 0}), back), {1, 0, 0}), up = cross(back, right);
  Mat4 out = translation(translation_of(m));
  for (int i = 0; i < 3; ++i) out(i, 0) = right[i], out(i, 1) = up[i], out(i, 2) = back[i];
  return out;
}

void give_lens(const Program& program, ObjectId camera, Time t, Camera& c) {
  const auto number = [&](std::uint16_t f) {
    const Value v = program.read({camera, f}, t);
    const auto* n = std::get_if<double>(&v);
    return n ? *n : 0;
  };
  constexpr double gate = 36;  // mm
  const double fov = number(fn::fov);
  c.fov = fov > 0 ? std::min(fov, 3.1) : 2 * std::atan(gate / (2 * std::max(number(fn::lens), 0.1)));
  c.height = number(fn::camera_height), c.orthographic = c.height > 0;
}

// From the sun, so that all objects are in front of it and in the picture.
void stand_in_rays(Vec3 along, const Frame& frame, Camera& c) {
  Vec3 least = translation_of(c.world), most = least;
  bool any = false;
  for (const Item& i : frame.items) {
    const Vec3 p = translation_of(i.world);
    for (int k = 0; k < 3; ++k)
      least[k] = any ? std::min(least[k], p[k]) : p[k], most[k] = any ? std::max(most[k], p[k]) : p[k];
    any = true;
  }
  const double across = any ? length(most - least) : 0;
  c.orthographic = true, c.height = std::max(2.0, 1.5 * across);
  const Vec3 place = translation_of(c.world);
  c.world = look_at(place, place + along);
}

}  // namespace

Camera eye_of(const Program& program, ObjectId id, Time t, const Frame& frame) {
  Camera c;
  c.aspect = program.document().aspect();
  const Value world = program.read(Target(id, Query::world), t);
  if (const auto* m = std::get_if<Matrix>(&world)) c.world = rigid(**m);
  if (kind(program.document(), id) == Kind::camera) give_lens(program, id, t, c);
  for (const Light& l : frame.lights)
    if (l.id == id && l.sun) stand_in_rays(l.direction, frame, c);
  return c;
}

}  // namespace betwixt::studio
