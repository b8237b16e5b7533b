// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The points of surfaces that rays hit: place, normals, colour and material.
#include "render/traced_world.h"
#include "scene/patterns.h"

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

double as_it_is(std::uint8_t byte) { return static_cast<double>(byte) / 255; }

struct Texel {
  Vec3 color{1, 1, 1};
  double opacity = 1;
};

// Interpolates between the four nearest pixels; the picture repeats.
template <double (*decode)(std::uint8_t) = decoded>
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
    sum.color = sum.color + share * Vec3{decode(c[0]), decode(c[1]), decode(c[2])};
    sum.opacity += share * c[3] / 255;
  }
  return sum;
}

// Where pictures are on a surface: one place by its texture coordinates, or three along the axes with their shares.
struct Laid {
  std::array<Vec3, 3> at;
  std::array<double, 3> share{1, 0, 0};
  template <double (*decode)(std::uint8_t)>
  Texel texel(const Picture& p) const {
    Texel sum{{}, 0};
    for (std::size_t k = 0; k < 3; ++k) {
      if (!(share[k] > 0)) continue;
      const Texel t = texel_at<decode>(p, at[k].x, at[k].y);
      sum.color = sum.color + share[k] * t.color, sum.opacity += share[k] * t.opacity;
    }
    return sum;
  }
};

double sign(double x) { return x < 0 ? -1 : 1; }

// `on`, `across`: the point and the normal in object space.
Laid laid(const Finish& f, bool projected, Vec3 uv, Vec3 on, Vec3 across) {
  const auto [sine, cosine] = sine_cosine(f.turn);
  const auto moved = [&](double x, double y) {
    return Vec3{(cosine * x - sine * y) * f.tile_x + f.move_x, (sine * x + cosine * y) * f.tile_y + f.move_y, 0};
  };
  if (!projected) return {{moved(uv.x, uv.y)}};
  const auto fourth = [](double x) { return x * x * x * x; };
  const double x = fourth(across.x), y = fourth(across.y), z = fourth(across.z), sum = std::max(x + y + z, 1e-30);
  return {
      {moved(-sign(across.x) * on.z, -on.y), moved(on.x, sign(across.y) * on.z), moved(sign(across.z) * on.x, -on.y)},
      {x / sum, y / sum, z / sum}};
}

// Returns where a point of the object space lies in the pattern.
Vec3 in_pattern(const Finish& f, Vec3 on) {
  const auto [sine, cosine] = sine_cosine(f.turn);
  return {(cosine * on.x - sine * on.y) * f.tile_x + f.move_x, (sine * on.x + cosine * on.y) * f.tile_y + f.move_y,
          on.z * f.tile_x};
}

// The slope of a pattern's bumps along a surface with the normal n, in object space.
Vec3 slope_of_bumps(const Finish& f, Vec3 color, Vec3 on, Vec3 n, double width, double height) {
  const double step = std::max(0.5 * width, 1e-4);
  const Vec3 x = unit(cross(std::abs(n.y) < 0.9 ? Vec3{0, 1, 0} : Vec3{1, 0, 0}, n)), y = cross(n, x);
  const double bumps = f.pattern_bumps * f.normal_strength / std::max(std::abs(f.tile_x), 1e-6);
  const auto slope = [&](Vec3 d) {
    return (pattern_at(f, color, in_pattern(f, on + step * d), n, width).height - height) / step;
  };
  return bumps * (slope(x) * x + slope(y) * y);
}

// The transpose of a matrix without its movement, times v.
Vec3 transposed_times(const Mat4& m, Vec3 v) {
  return {dot(column(m, 0), v), dot(column(m, 1), v), dot(column(m, 2), v)};
}

// A normal of the mesh in object space.
Vec3 normal_in_object(const Mat4& to_object, Vec3 n) {
  const Vec3 x = column(to_object, 0), y = column(to_object, 1), z = column(to_object, 2);
  const double turns = determinant(to_object) < 0 ? -1 : 1;
  return unit(turns * (n.x * cross(y, z) + n.y * cross(z, x) + n.z * cross(x, y)));
}

// Turns a normal toward the face until what it mirrors is not behind the surface.
Vec3 mirroring_outward(Vec3 normal, Vec3 face, Vec3 toward) {
  const double least = std::min(0.9 * dot(face, toward), 0.01);
  const Vec3 mirrored = 2 * dot(normal, toward) * normal - toward;
  const double up = dot(mirrored, face);
  if (up >= least) return normal;
  const Vec3 level = mirrored - up * face;
  const double flat = length(level);
  if (!(flat > 1e-9)) return face;
  return unit(toward + std::sqrt(1 - least * least) / flat * level + least * face);
}

}  // namespace

Vec3 picture_color(const Picture& p, double u, double v) { return texel_at(p, u, v).color; }

// Adds what the finish of an object makes of a point: its pictures, its pattern, its bumps.
void World::add_finish(const TracedObject& b, const Hit& m, SurfacePoint& s) const {
  const Finish& f = *b.finish;
  s.finish = &f, s.roughness = f.roughness, s.metalness = f.metalness, s.emission = f.emission;
  const bool meshed = b.solid->mesh != nullptr;
  const Picture* base = b.texture;
  if (base == nullptr && meshed) base = b.solid->parts[b.solid->part_of[m.triangle]].texture.get();
  if (f.pattern == Pattern::none && !f.has_pictures() && base == nullptr) return;
  Vec3 in_mesh = unit(m.across), uv;
  std::array<Vec3, 3> corners, places;
  const bool uvs = meshed && b.solid->mesh->uvs.size() == b.solid->mesh->positions.size();
  if (meshed) {
    const Mesh& mesh = *b.solid->mesh;
    const std::uint32_t* corner = &b.solid->corners[3 * std::size_t{m.triangle}];
    const std::array<double, 3> share{1 - m.u - m.v, m.u, m.v};
    in_mesh = {};
    for (std::size_t k = 0; k < 3; ++k) {
      corners[k] = b.position(corner[k]), in_mesh = in_mesh + share[k] * corners[k];
      if (uvs) places[k] = {mesh.uvs[corner[k]][0], mesh.uvs[corner[k]][1], 0}, uv = uv + share[k] * places[k];
    }
  }
  const Vec3 on = transform_point(b.to_object, in_mesh), across = normal_in_object(b.to_object, unit(m.across));
  const bool projected =
      f.projection == PictureProjection::box || (f.projection == PictureProjection::automatic && !uvs);
  const Laid at = laid(f, projected, uv, on, across);
  if (base) {
    const Texel t = at.texel<decoded>(*base);
    s.color = s.color * t.color, s.opacity *= t.opacity;
  }
  if (f.roughness_map) s.roughness *= at.texel<as_it_is>(*f.roughness_map).color.y;
  if (f.metalness_map) s.metalness *= at.texel<as_it_is>(*f.metalness_map).color.z;
  if (f.emission_map) s.emission = s.emission * at.texel<decoded>(*f.emission_map).color;
  if (f.normals && uvs && !projected) {
    const Vec3 bent = 2 * at.texel<as_it_is>(*f.normals).color - Vec3{1, 1, 1};
    const auto e1 = transform_vector(b.place, corners[1] - corners[0]),
               e2 = transform_vector(b.place, corners[2] - corners[0]);
    const Vec3 d1 = places[1] - places[0], d2 = places[2] - places[0];
    const double area = d1.x * d2.y - d2.x * d1.y;
    if (std::abs(area) > 1e-30) {
      const Vec3 along = unit(1 / area * (d2.y * e1 - d1.y * e2)), down = unit(1 / area * (d1.x * e2 - d2.x * e1));
      const Vec3 made = f.normal_strength * (bent.x * along - bent.y * down) + std::max(bent.z, 0.0) * s.normal;
      if (dot(made, made) > 1e-12) s.normal = unit(made);
    }
  }
  if (f.pattern == Pattern::none) return;
  const double scale = std::max(length(column(b.place, 0)) / std::max(length(column(b.to_object, 0)), 1e-12), 1e-12);
  const double width = pixel_ * (pixel_grows_ ? length(s.at) : 1) / scale * std::abs(f.tile_x);
  Finish here = f;
  here.roughness = s.roughness, here.metalness = s.metalness;
  const PatternPoint has = pattern_at(here, s.color, in_pattern(f, on), across, width);
  if (f.pattern_bumps > 0) {
    // Slopes become those of the scene by the inverse transpose, as it is: its length counts.
    const Vec3 slope = slope_of_bumps(here, s.color, on, across, width, has.height);
    const Vec3 there = transposed_times(inverse(b.place).value_or(Mat4{}), transposed_times(b.to_object, slope));
    s.normal = unit(s.normal - (s.inside ? -1.0 : 1.0) * (there - dot(there, s.normal) * s.normal));
  }
  s.color = has.color, s.roughness = has.roughness, s.metalness = has.metalness;
}

// Puts the colour of a gradient in place of the object's or the stroke's.
void World::add_gradient(const TracedObject& b, const MeshPart& part, Vec3 in_mesh, SurfacePoint& s) {
  const Graded* const graded = part.stroke && b.stroke ? b.stroke : part.tinted ? b.fill : nullptr;
  if (graded == nullptr) return;
  const auto along = [&](const std::array<double, 4>& row) {
    return row[0] * in_mesh.x + row[1] * in_mesh.y + row[2] * in_mesh.z + row[3];
  };
  const GradientLight l = graded->colors.at(along(graded->placed.x), along(graded->placed.y));
  s.color = 1 / std::max(l.opacity, 1e-6) * l.light * (part.stroke ? Vec3{1, 1, 1} : wide(part.color));
  s.opacity *= l.opacity;
}

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
    at = at + share[k] * b.position(corner[k]);
    normal = normal + share[k] * (normals ? b.normal(corner[k]) : m.across);
  }
  Vec3 smooth = at;
  for (std::size_t k = 0; k < 3 && normals && !back; ++k) {
    const Vec3 n = b.normal(corner[k]);
    smooth = smooth + share[k] * std::max(dot(b.position(corner[k]) - at, n), 0.0) * n;
  }
  const MeshPart& part = solid.parts[solid.part_of[m.triangle]];
  SurfacePoint s;
  s.at = transform_point(b.place, at), s.start = transform_point(b.place, smooth);
  s.normal = normal;
  s.color = (part.tinted ? b.color : Vec3{1, 1, 1}) * wide(part.color);
  s.opacity = b.opacity;
  add_gradient(b, part, at, s);
  const Picture* const picture = b.texture != nullptr ? b.texture : part.texture.get();
  if (picture == nullptr || b.finish) return s;  // add_finish() lays it as the finish says
  if (mesh.uvs.size() == mesh.positions.size())
    for (std::size_t k = 0; k < 3; ++k) u = u + share[k] * Vec3{mesh.uvs[corner[k]][0], mesh.uvs[corner[k]][1], 0};
  const Texel texel = texel_at(*picture, u.x, u.y);
  s.color = s.color * texel.color, s.opacity *= texel.opacity;
  return s;
}

SurfacePoint World::surface_point(const Ray& r, const Hit& m) const {
  const ObjectStates& o = objects_[m.object];
  return surface_point(o.all.size() == 1 ? o.all.front() : o.at(r.time), r, m);
}

SurfacePoint World::surface_point(const TracedObject& b, const Ray& r, const Hit& m) const {
  const auto turned = [&](Vec3 v) {
    return unit(v.x * b.normal_matrix[0] + v.y * b.normal_matrix[1] + v.z * b.normal_matrix[2]);
  };
  SurfacePoint s;
  s.time = r.time;
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
    s.normal = turned(s.normal), s.time = r.time;
  } else {
    s.at = s.start = transform_point(b.place, unit(m.across));
    s.normal = face, s.color = b.color, s.opacity = b.opacity;
  }
  s.face = back ? -face : face;
  if (back) s.normal = -s.normal;
  const Vec3 clear = (coplanar_tolerance * largest(s.at) + b.blur) * s.face;
  s.start = s.start + clear, s.beyond = s.at - clear;
  s.shine = b.shine, s.material = b.material;
  s.solid = b.solid->mesh == nullptr || b.solid->mesh->closed, s.inside = back;
  const Vec3 smooth = s.normal;
  if (b.finish) add_finish(b, m, s);
  if (b.finish && b.finish->normals) s.normal = mirroring_outward(s.normal, s.face, -r.along);
  if (!(s.normal == smooth)) s.smooth = smooth;
  return s;
}

}  // namespace betwixt::traced
