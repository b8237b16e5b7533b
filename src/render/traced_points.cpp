// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The points of surfaces that rays hit: place, normals, colour and material.
#include "render/traced_world.h"

namespace betwixt::traced {
namespace {

double decoded(std::uint8_t byte) {
  static const std::array<double, 256> all = [] {
    std::array<double, 256> r{};
    for (std::size_t i = 0; i < r.size(); ++i) {
      const double s = static_cast<double>(i) / 255;
      r[i] = s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
    }
    return r;
  }();
  return all[byte];
}

struct Texel {
  Vec3 color{1, 1, 1};
  double opacity = 1;
};

// Interpolates between the four nearest pixels; the picture repeats.
Texel texel_at(const Picture& p, double u, double v) {
  const auto area = static_cast<std::size_t>(std::max(p.width, 0)) * static_cast<std::size_t>(std::max(p.height, 0));
  if (area == 0 || p.rgba.size() < 4 * area || !std::isfinite(u) || !std::isfinite(v)) return {};
  const double x = (u - std::floor(u)) * p.width - 0.5, y = (v - std::floor(v)) * p.height - 0.5;
  const int x0 = static_cast<int>(std::floor(x)), y0 = static_cast<int>(std::floor(y));
  Texel sum{{}, 0};
  for (int k = 0; k < 4; ++k) {
    const int i = x0 + k % 2, j = y0 + k / 2;
    const double share = (1 - std::abs(x - i)) * (1 - std::abs(y - j));
    const auto at = static_cast<std::size_t>((j + p.height) % p.height) * static_cast<std::size_t>(p.width) +
                    static_cast<std::size_t>((i + p.width) % p.width);
    const std::uint8_t* c = &p.rgba[4 * at];
    sum.color = sum.color + share * Vec3{decoded(c[0]), decoded(c[1]), decoded(c[2])};
    sum.opacity += share * c[3] / 255;
  }
  return sum;
}

}  // namespace

// The surface on a triangle. If the triangle approximates a smooth surface, rays to lights start from that, so that
// facets do not shade each other.
SurfacePoint World::triangle_point(const TracedObject& b, const Hit& m, bool back) const {
  const MeshScene& solid = *b.solid;
  const Mesh& mesh = *solid.mesh;
  const std::uint32_t* corner = &solid.corners[3 * std::size_t{m.triangle}];
  const std::array<double, 3> share{1 - m.u - m.v, m.u, m.v};
  const bool normals = mesh.normals.size() == mesh.positions.size();
  Vec3 at, normal, u;
  for (std::size_t k = 0; k < 3; ++k) {
    at = at + share[k] * wide(mesh.positions[corner[k]]);
    normal = normal + share[k] * (normals ? wide(mesh.normals[corner[k]]) : m.across);
  }
  Vec3 smooth = at;
  for (std::size_t k = 0; k < 3 && normals && !back; ++k) {
    const Vec3 n = wide(mesh.normals[corner[k]]);
    smooth = smooth + share[k] * std::max(dot(wide(mesh.positions[corner[k]]) - at, n), 0.0) * n;
  }
  const MeshPart& part = solid.parts[solid.part_of[m.triangle]];
  SurfacePoint s;
  s.at = transform_point(b.place, at), s.start = transform_point(b.place, smooth);
  s.normal = normal;
  s.color = (part.tinted ? b.color : Vec3{1, 1, 1}) * wide(part.color);
  s.opacity = b.opacity;
  const Picture* const picture = b.texture != nullptr ? b.texture.get() : part.texture.get();
  if (picture == nullptr) return s;
  if (mesh.uvs.size() == mesh.positions.size())
    for (std::size_t k = 0; k < 3; ++k) u = u + share[k] * Vec3{mesh.uvs[corner[k]][0], mesh.uvs[corner[k]][1], 0};
  const Texel texel = texel_at(*picture, u.x, u.y);
  s.color = s.color * texel.color, s.opacity *= texel.opacity;
  return s;
}

SurfacePoint World::surface_point(const Ray& r, const Hit& m) const {
  const TracedObject& b = objects_[m.object];
  const auto turned = [&](Vec3 v) {
    return unit(v.x * b.normal_matrix[0] + v.y * b.normal_matrix[1] + v.z * b.normal_matrix[2]);
  };
  SurfacePoint s;
  if (b.hairline) {
    s.at = s.start = r.from + m.distance * r.along;
    s.beyond = s.at + coplanar_tolerance * (largest(s.at) + m.distance) * r.along;
    s.color = {std::min(b.color.x, 1.0), std::min(b.color.y, 1.0), std::min(b.color.z, 1.0)};
    s.normal = s.face = -r.along, s.opacity = b.opacity, s.material = Material::glow, s.hairline = true;
    return s;
  }
  const Vec3 face = turned(m.across);
  const bool back = dot(face, r.along) > 0;
  if (b.solid->mesh != nullptr) {
    s = triangle_point(b, m, back);
    s.normal = turned(s.normal);
  } else {
    s.at = s.start = transform_point(b.place, unit(m.across));
    s.normal = face, s.color = b.color, s.opacity = b.opacity;
  }
  s.face = back ? -face : face;
  if (back) s.normal = -s.normal;
  const Vec3 clear = (coplanar_tolerance * largest(s.at) + b.blur) * s.face;
  s.start = s.start + clear, s.beyond = s.at - clear;
  s.shine = b.shine, s.material = b.material;
  return s;
}

}  // namespace betwixt::traced
