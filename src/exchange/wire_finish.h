// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The parts of a finish that files have, in the order of the wire.
#pragma once

#include <array>

#include "betwixt/finish.h"

namespace betwixt::wire {

struct BoundedNumber {
  double Finish::*is;
  double low, high;
};
inline constexpr BoundedNumber finish_numbers[] = {
    {&Finish::metalness, 0, 1},
    {&Finish::roughness, 0, 1},
    {&Finish::clearcoat, 0, 1},
    {&Finish::clearcoat_roughness, 0, 1},
    {&Finish::sheen_roughness, 0, 1},
    {&Finish::transmission, 0, 1},
    {&Finish::ior, 1, 4},
    {&Finish::thickness, 0, 1e6},
    {&Finish::specular, 0, 1},
    {&Finish::normal_strength, -10, 10},
    {&Finish::tile_x, -1e6, 1e6},
    {&Finish::tile_y, -1e6, 1e6},
    {&Finish::move_x, -1e9, 1e9},
    {&Finish::move_y, -1e9, 1e9},
    {&Finish::turn, -1e6, 1e6},
};
inline constexpr std::shared_ptr<const Picture> Finish::*finish_pictures[] = {
    &Finish::normals, &Finish::roughness_map, &Finish::metalness_map, &Finish::occlusion_map, &Finish::emission_map};

}  // namespace betwixt::wire
