// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The sky around a scene, and how its light becomes a picture.
//
// Room: scene
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string_view>
#include <vector>

#include "betwixt/linear_picture.h"

namespace betwixt {

// Light that arrives from all directions. All skies but `none` light the objects and are mirrored by them.
struct Sky {
  enum Kind : std::uint8_t { none, studio, day, overcast, sunset, picture } kind = none;
  double hour = 13;     // of `day`: the sun rises at 6, is highest at 12 and sets at 18
  double turn = 0;      // radians, about the vertical
  double strength = 1;  // factor of its light
  // Of `picture`: the whole sky (equirectangular: longitudes across, latitudes down).
  std::shared_ptr<const LinearPicture> light;
  friend bool operator==(const Sky&, const Sky&) = default;
};
// In the order of Sky::Kind.
inline constexpr std::array<std::string_view, 6> sky_names{"off", "studio", "day", "overcast", "sunset", "picture"};

// What a look file or an OpenColorIO configuration makes of colours: signals of an sRGB screen, of 16 bits.
struct ColorTable {
  // What it takes: signals of the picture that a view has made; light; or light in stops (grade.cpp, place_of_stops).
  enum Takes : std::uint8_t { picture, light, stops } takes = picture;
  bool cube = true;                             // size^3 colours, red fastest; otherwise a curve of each channel
  int size = 0;                                 // 2 to most_side, or to most_curve
  std::array<float, 3> least{}, most{1, 1, 1};  // of `picture` and `light`: what its first and last colours are for
  std::vector<std::uint16_t> signals;           // r g b of each
  static constexpr int most_side = 129, most_curve = 65536;
  friend bool operator==(const ColorTable&, const ColorTable&) = default;
};

// How linear light becomes a picture. Light that is not graded rolls off towards white (`neutral`).
struct Grade {
  enum View : std::uint8_t { neutral, plain, filmic, agx } view = neutral;
  double white_balance = 6500;  // kelvin, of the light that becomes white
  double bloom = 0;             // how much bright light spreads, 0 to 1
  double vignette = 0;          // how much darker the corners are, 0 to 1
  double grain = 0;             // how strong the grain of the film is, 0 to 1
  // After the view, or instead of it if it takes light.
  std::shared_ptr<const ColorTable> table;
  double table_share = 1;  // how much of its picture is shown, and of that before it
  friend bool operator==(const Grade& a, const Grade& b) {
    const bool same_table = a.table == b.table || (a.table && b.table && *a.table == *b.table);
    return same_table && a.view == b.view && a.white_balance == b.white_balance && a.bloom == b.bloom &&
           a.vignette == b.vignette && a.grain == b.grain && a.table_share == b.table_share;
  }
};
// In the order of Grade::View.
inline constexpr std::array<std::string_view, 4> view_names{"neutral", "plain", "filmic", "agx"};

}  // namespace betwixt
