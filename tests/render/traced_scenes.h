// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Scenes for tests of the style `traced`.
#pragma once

#include "render/scenes.h"

namespace betwixt::traced_scenes {

using namespace scenes;

inline RenderOptions with(int width, int height, int samples) { return {width, height, samples, "traced"}; }

// A scene with only ambient light.
inline Frame everywhere(Vec3 ambient) {
  Frame f = frame();
  f.surroundings.ambient = ambient;
  f.lights = {lamp({0, 0, 1e6}, 1)};
  return f;
}

// Returns a pixel in linear light.
inline double light(const Picture& p, int x, int y) { return decoded(pixel(p, x, y).r / 255.0); }

inline double psnr(const Picture& a, const Picture& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.rgba.size(); ++i) sum += std::pow(a.rgba[i] - b.rgba[i], 2);
  return sum == 0 ? 99 : 10 * std::log10(255 * 255 / (sum / static_cast<double>(a.rgba.size() / 4 * 3)));
}

inline std::shared_ptr<const Shape> shape(Kind kind) {
  auto s = std::make_shared<Shape>();
  s->kind = kind;
  return s;
}

inline double mean(const Picture& p) {
  double sum = 0;
  for (int y = 0; y < p.height; ++y)
    for (int x = 0; x < p.width; ++x) sum += light(p, x, y);
  return sum / (p.width * p.height);
}

// Balls, boxes and glass in front of a backdrop; walls with textures; a sky; drawings.
inline Frame apart() {
  Frame f = frame(20);
  f.background.reset();
  f.camera.orthographic = false, f.camera.fov = 0.5;
  f.lights = {lamp({6, 6, 9}, 30), lamp({-9, 2, 5}, 25)};
  Light sun;
  sun.sun = true, sun.direction = normalize(Vec3{0.3, -1, -0.4}), sun.color = {0.3, 0.3, 0.4};
  f.lights.push_back(sun);
  for (Light& l : f.lights) l.casting = Casting::off;
  f.items.push_back(item(sphere(1.2), translation({-3, 1, 0}), {0.8, 0.3, 0.2}, Material::matte));
  f.items.push_back(item(shape(Kind::torus), translation({0, 1.2, 0}) * rotation(axis_angle({1, 1, 0}, 0.8)),
                         {0.2, 0.6, 0.3}, Material::matte));
  f.items.push_back(
      item(sphere(1), translation({3, 1, 0}) * scaling({1, 1.5, 0.5}), {0.3, 0.3, 0.9}, Material::plastic));
  f.items.push_back(item(shape(Kind::box), translation({-2, -1.5, 0}) * rotation(axis_angle({0, 1, 0}, 0.6)),
                         {0.7, 0.7, 0.6}, Material::plastic));
  f.items.push_back(item(sphere(0.9), translation({1.5, -1.5, 0}), {0.3, 0.9, 0.9}, Material::plastic));
  f.items[2].shininess = 0.3, f.items[4].shininess = 0.7, f.items[4].transparency = 0.6;
  f.items.push_back(item(shape(Kind::cone), translation({4, -2, -3}), {0.9, 0.8, 0.1}, Material::glow));
  return f;
}

inline Frame some_of_all() {
  Frame f = apart();
  f.surroundings.ground = Vec3{0.5, 0.5, 0.4}, f.surroundings.sky = true;
  f.items[0].material = Material::metal, f.items[0].shininess = 0.8;
  for (Item& i : f.items) i.world = translation({0, 3, 0}) * i.world;
  for (Light& l : f.lights) l.casting = Casting::soft;
  f.camera.world = look_at({2, 5, 16}, {0, 2, 0});
  return f;
}

}  // namespace betwixt::traced_scenes
