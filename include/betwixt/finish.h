// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The finish of a surface: how it reflects, lets through and sends out light. It is the metallic-roughness model of
// glTF 2.0 with its extensions for clear coats, sheen, transmission, refraction and emission.
//
// Room: scene
#pragma once

#include <memory>

#include "betwixt/mesh.h"

namespace betwixt {

// A pattern that is computed in object space, so that it needs no picture and no texture coordinates.
enum class Pattern : std::uint8_t {
  none,
  brushed,   // fine lines along x
  wood,      // rings about the y axis
  planks,    // boards of wood along x
  marble,    // veins
  granite,   // grains of three colours
  concrete,  // clouds and pores
  bricks,    // courses along y
  tiles,     // squares with joints
  checker,   // squares of two colours
  leather,   // cells with bumps
  fabric,    // a weave
  clouds,    // soft patches
  rust,      // patches that are rough and not metallic
  flakes,    // small mirrors in lacquer
  hammered,  // round dents
  sand,      // fine bumps
  waves,     // water that wind moves
  grass      // blades and tufts
};

// How pictures lie on a surface: by its texture coordinates, or projected along the three axes of the object space, one
// picture a metre. `automatic`: projected if it has no texture coordinates.
enum class PictureProjection : std::uint8_t { automatic, uv, box };

struct Finish {
  double metalness = 0;              // 0 an insulator to 1 a metal
  double roughness = 0.5;            // 0 a mirror to 1 dull
  Vec3 emission;                     // light that the surface sends out, linear
  double clearcoat = 0;              // how much of it a clear coat covers, 0 to 1
  double clearcoat_roughness = 0.1;  // of that coat
  Vec3 sheen;                        // the colour of light at grazing angles, as of cloth
  double sheen_roughness = 0.4;
  double transmission = 0;  // how much of the light that is not reflected goes through, 0 to 1
  double ior = 1.5;         // index of refraction
  double thickness = 0;     // metres that light goes through it; 0: a thin wall, which does not bend light
  double specular = 1;      // factor of the reflection of an insulator
  double normal_strength = 1;

  // Pictures. Of `normals`, red is x and green is y. Roughness is green, metalness is blue and occlusion is red, as in
  // glTF. Null if there is none.
  std::shared_ptr<const Picture> normals, roughness_map, metalness_map, occlusion_map, emission_map;
  PictureProjection projection = PictureProjection::automatic;
  double tile_x = 1, tile_y = 1;  // how often pictures and patterns repeat
  double move_x = 0, move_y = 0;  // how far they are moved, in pictures
  double turn = 0;                // radians

  Pattern pattern = Pattern::none;
  Vec3 second{1, 1, 1};      // the pattern's other colour, linear
  double pattern_bumps = 0;  // how high the bumps of the pattern are, in its own units

  bool has_pictures() const { return normals || roughness_map || metalness_map || occlusion_map || emission_map; }
  friend bool operator==(const Finish&, const Finish&) = default;
};

}  // namespace betwixt
