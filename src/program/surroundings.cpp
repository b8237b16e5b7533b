// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "program/surroundings.h"

namespace betwixt {
namespace {

constexpr Color dark{0.08, 0.088, 0.1};        // behind flat films
constexpr Color floor_color{0.6, 0.6, 0.585};  // the default

std::optional<Vec3> light(const std::optional<Color>& c) { return c ? std::optional(to_linear(*c)) : std::nullopt; }

}  // namespace

std::optional<Vec3> background_of(const Scene& s) {
  if (s.appearance.clear) return Vec3{};
  if (s.background) return to_linear(*s.background);
  // Fog fades everything to its colour, so the background has it too. A sky that is seen stays.
  const Sky::Kind sky = s.appearance.environment.kind;
  const bool seen = s.appearance.sky || (!s.appearance.flat && sky != Sky::none && sky != Sky::studio);
  if (s.appearance.fog && !seen) return to_linear(s.appearance.fog->color);
  return s.appearance.flat ? std::optional(to_linear(dark)) : std::nullopt;
}

Surroundings surroundings_of(const Scene& s) {
  const Appearance& a = s.appearance;
  Surroundings r;
  r.flat = a.flat, r.below = light(a.below), r.ambient = light(a.ambient), r.exposure = a.exposure, r.sky = a.sky;
  r.environment = a.environment, r.grade = a.grade;
  r.clear = a.clear, r.contact = a.contact;
  if (a.fog) r.fog = {to_linear(a.fog->color), a.fog->from, a.fog->to};
  if (a.ground) r.ground = to_linear(a.ground_color.value_or(floor_color));
  return r;
}

}  // namespace betwixt
