// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Scenes of surfaces with finishes under skies, for tests.
#pragma once

#include <gtest/gtest.h>

#include "render/scenes.h"

namespace betwixt::physical_scenes {

using namespace scenes;

inline std::shared_ptr<const LinearPicture> even_light(float light) {
  auto picture = std::make_shared<LinearPicture>();
  picture->width = 8, picture->height = 4;
  picture->rgba.assign(static_cast<std::size_t>(4 * 8 * 4), light);
  return picture;
}

inline Sky even_sky(float light) {
  Sky sky;
  sky.kind = Sky::picture, sky.light = even_light(light);
  return sky;
}

inline Frame frame_of(std::vector<Item> items, const Sky& sky) {
  Frame f;
  f.items = std::move(items);
  f.camera.world = translation({0, 0, 4}), f.camera.fov = 0.6;
  f.background = Vec3{};
  f.surroundings.environment = sky;
  return f;
}

inline LinearPicture styled_light(const Frame& frame, const std::string& style, int size = 32, int samples = 0) {
  RenderOptions options{.width = size,
                        .height = size,
                        .samples = samples > 0         ? samples
                                   : style == "traced" ? 64
                                                       : 4,
                        .style = style};
  options.linear = options.unclamped = true;
  LinearPicture out;
  const auto renderer = make_renderer(options);
  EXPECT_TRUE(renderer);
  if (renderer) EXPECT_TRUE((*renderer)->render(frame, out));
  return out;
}

inline Vec3 light_at(const LinearPicture& p, int x, int y) {
  const float* const c =
      &p.rgba.at(4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(p.width) + static_cast<std::size_t>(x)));
  return {static_cast<double>(c[0]), static_cast<double>(c[1]), static_cast<double>(c[2])};
}
inline Vec3 mean_of(const LinearPicture& p, int from, int to) {
  Vec3 sum;
  for (int y = from; y < to; ++y)
    for (int x = from; x < to; ++x) sum = sum + light_at(p, x, y);
  return 1.0 / ((to - from) * (to - from)) * sum;
}

inline Item finished(const Finish& finish, Vec3 color, double radius = 1) {
  Item i = item(sphere(radius), {}, color, Material::plastic);
  i.finish = std::make_shared<const Finish>(finish);
  return i;
}

}  // namespace betwixt::physical_scenes
