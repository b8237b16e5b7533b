// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Directions chosen at random. Random numbers are from 0 to 1.
#pragma once

#include <array>
#include <cmath>

#include "render/traced_world.h"

namespace betwixt::traced {

// Converts a vector from coordinates about a direction to the world.
inline Vec3 from_frame(Vec3 axis, Vec3 v) {
  const Vec3 x = unit(cross(std::abs(axis.y) < 0.9 ? Vec3{0, 1, 0} : Vec3{1, 0, 0}, axis));
  return v.x * x + v.y * cross(axis, x) + v.z * axis;
}
inline Vec3 cylindrical(double radius, double turn, double z) {
  const auto [sine, cosine] = sine_cosine(2 * pi * turn);
  return {radius * cosine, radius * sine, z};
}

// Returns a direction with the density of light that comes evenly from all around (cosine-weighted).
inline Vec3 sample_cosine_hemisphere(Vec3 normal, const std::array<double, 2>& random) {
  return from_frame(normal, cylindrical(std::sqrt(random[0]), random[1], std::sqrt(1 - random[0])));
}

// Returns the normal of one of the visible microfacets of a rough surface (GGX): on the sphere to which the surface is
// scaled, these are a cap about the direction of sight.
inline Vec3 sample_visible_facet(Vec3 normal, Vec3 toward, double alpha, const std::array<double, 2>& random) {
  const Vec3 x = from_frame(normal, {1, 0, 0}), y = from_frame(normal, {0, 1, 0});
  const Vec3 sight = unit({alpha * dot(toward, x), alpha * dot(toward, y), std::max(dot(toward, normal), 1e-4)});
  const double z = (1 - random[0]) * (1 + sight.z) - sight.z;
  const Vec3 facet = cylindrical(std::sqrt(std::max(1 - z * z, 0.0)), random[1], z) + sight;
  return from_frame(normal, unit({alpha * facet.x, alpha * facet.y, std::max(facet.z, 1e-9)}));
}
// Returns the direction in which a facet mirrors the viewer's.
inline Vec3 mirrored_at(Vec3 facet, Vec3 toward) { return unit(2 * dot(toward, facet) * facet - toward); }

}  // namespace betwixt::traced
