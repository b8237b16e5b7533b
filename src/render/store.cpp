// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "render/store.h"

#include <algorithm>
#include <bit>
#include <span>

#include "betwixt/math.h"

namespace betwixt {
namespace {

using Floats = std::vector<float>;

template <class T>
void send(GLenum target, GLuint buffer, const std::vector<T>& data) {
  glBindBuffer(target, buffer);
  glBufferData(target, static_cast<GLsizeiptr>(data.size() * sizeof(T)), data.data(), GL_STATIC_DRAW);
}

void floats_at(GLuint attribute, GLint count, std::size_t stride, std::size_t first) {
  glEnableVertexAttribArray(attribute);
  glVertexAttribPointer(attribute, count, GL_FLOAT, GL_FALSE, static_cast<GLsizei>(stride * sizeof(float)),
                        reinterpret_cast<const void*>(first * sizeof(float)));
}

bool indices_fit(const std::vector<std::uint32_t>& indices, std::size_t count) {
  return std::all_of(indices.begin(), indices.end(), [count](std::uint32_t i) { return i < count; });
}

Floats interleave(const Mesh& mesh) {
  const bool normals = mesh.normals.size() == mesh.positions.size();
  const bool uvs = mesh.uvs.size() == mesh.positions.size();
  Floats out;
  out.reserve(mesh.positions.size() * 8);
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const auto n = normals ? mesh.normals[i] : std::array<float, 3>{0, 0, 1};
    const auto uv = uvs ? mesh.uvs[i] : std::array<float, 2>{0, 0};
    out.insert(out.end(), mesh.positions[i].begin(), mesh.positions[i].end());
    out.insert(out.end(), n.begin(), n.end());
    out.insert(out.end(), uv.begin(), uv.end());
  }
  return out;
}

std::vector<StoredPart> parts_of(const Mesh& mesh, Store& store) {
  const auto all = static_cast<std::uint32_t>(mesh.triangles.size());
  if (!indices_fit(mesh.triangles, mesh.positions.size()) || all < 3) return {};
  if (mesh.parts.empty()) return {{0, all, {1, 1, 1}, true, false, nullptr}};
  std::vector<StoredPart> parts;
  for (const MeshPart& p : mesh.parts) {
    const std::uint32_t first = std::min(p.first, all), count = std::min(p.count, all - first);
    if (count > 0)
      parts.push_back({first, count, p.color, p.tinted, p.stroke, p.texture ? store.texture(p.texture) : nullptr});
  }
  return parts;
}

// Cut into a ring of triangles and the polygon inside, again and again: the triangles are broad, which fills faster
// than a fan.
Mesh regular_polygon(std::uint32_t corners) {
  Mesh m;
  for (std::uint32_t i = 0; i < corners; ++i) {
    const double angle = 2 * pi * i / corners;
    m.positions.push_back({static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle)), 0});
  }
  for (std::uint32_t step = 1; 2 * step < corners; step *= 2)
    for (std::uint32_t i = 0; i < corners; i += 2 * step)
      m.triangles.insert(m.triangles.end(), {i, i + step, (i + 2 * step) % corners});
  return m;
}

// Graphics memory has a largest size; larger pictures lose every other row and column until they fit.
Picture thinned(const Picture& from, int limit) {
  int step = 1;
  while ((from.width + step - 1) / step > limit || (from.height + step - 1) / step > limit) step *= 2;
  Picture to{(from.width + step - 1) / step, (from.height + step - 1) / step, {}};
  to.rgba.reserve(static_cast<std::size_t>(to.width) * to.height * 4);
  for (int y = 0; y < from.height; y += step)
    for (int x = 0; x < from.width; x += step) {
      const auto* p = &from.rgba[(static_cast<std::size_t>(y) * from.width + x) * 4];
      to.rgba.insert(to.rgba.end(), p, p + 4);
    }
  return to;
}

gl::Texture send_texture(const Picture& picture, GLint format = GL_SRGB8_ALPHA8) {
  const auto size = static_cast<std::size_t>(std::max(picture.width, 0)) * std::max(picture.height, 0) * 4;
  if (size == 0 || picture.rgba.size() < size) return {};
  GLint limit = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &limit);
  const bool large = picture.width > limit || picture.height > limit;
  const Picture smaller = large ? thinned(picture, limit) : Picture{};
  const Picture& p = large ? smaller : picture;
  GLuint id = 0;
  glGenTextures(1, &id);
  gl::use_texture(0, id);
  glTexImage2D(GL_TEXTURE_2D, 0, format, p.width, p.height, 0, GL_RGBA, GL_UNSIGNED_BYTE, p.rgba.data());
  glGenerateMipmap(GL_TEXTURE_2D);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  return gl::Texture(id);
}

bool has_holes(const Picture& p) {
  for (std::size_t i = 3; i < p.rgba.size(); i += 4)
    if (p.rgba[i] != 255) return true;
  return false;
}

}  // namespace

template <class Source, class Stored>
std::weak_ptr<Stored>& Store::Kept<Source, Stored>::at(const Source* source) {
  if (all.size() > limit) {
    std::erase_if(all, [](const auto& entry) { return entry.second.expired(); });
    limit = std::max<std::size_t>(64, 2 * all.size());
  }
  return all[source];
}

std::shared_ptr<StoredMesh> Store::mesh(const std::shared_ptr<const Mesh>& mesh) {
  if (latest_ != nullptr && latest_->mesh == mesh) return latest_;
  auto& place = meshes_.at(mesh.get());
  latest_ = place.lock();
  if (latest_ != nullptr) return latest_;
  latest_ = std::make_shared<StoredMesh>();
  latest_->mesh = mesh;
  latest_->box = mesh->box();
  latest_->parts = parts_of(*mesh, *this);
  latest_->see_through = std::any_of(latest_->parts.begin(), latest_->parts.end(), [](const StoredPart& p) {
    return p.texture != nullptr && p.texture->see_through;
  });
  place = latest_;
  return latest_;
}

void Store::need_triangles(StoredMesh& m) {
  if (m.parts.empty() || m.triangles.id() != 0) return;
  m.triangles = gl::new_vertex_array();
  glBindVertexArray(m.triangles.id());
  m.vertices = gl::new_buffer();
  send(GL_ARRAY_BUFFER, m.vertices.id(), interleave(*m.mesh));
  m.indices = gl::new_buffer();
  send(GL_ELEMENT_ARRAY_BUFFER, m.indices.id(), m.mesh->triangles);
  floats_at(at_position, 3, 8, 0);
  floats_at(at_normal, 3, 8, 3);
  floats_at(at_uv, 2, 8, 6);
}

const std::shared_ptr<StoredMesh>& Store::disc(double radius) {
  // Its edge is off by a third of a pixel, up to a radius of 1000.
  const std::size_t detail = radius < 4 ? 0 : radius < 18 ? 1 : radius < 64 ? 2 : radius < 250 ? 3 : 4;
  auto& mesh = discs_[detail];
  if (mesh == nullptr) mesh = this->mesh(std::make_shared<const Mesh>(regular_polygon(8U << detail)));
  return mesh;
}

void Store::need_edges(StoredMesh& m) {
  const Mesh& mesh = *m.mesh;
  if (m.edge_count > 0 || mesh.edges.size() < 2 || !indices_fit(mesh.edges, mesh.positions.size())) return;
  const std::size_t edges = mesh.edges.size() / 2;
  Floats corners;
  std::vector<std::uint32_t> indices;
  corners.reserve(edges * 4 * 8), indices.reserve(edges * 6);
  for (std::size_t e = 0; e < edges; ++e) {
    const auto &a = mesh.positions[mesh.edges[2 * e]], &b = mesh.positions[mesh.edges[2 * e + 1]];
    for (int corner = 0; corner < 4; ++corner)
      corners.insert(corners.end(),
                     {a[0], a[1], a[2], b[0], b[1], b[2], corner & 1 ? 1.F : 0.F, corner & 2 ? 1.F : -1.F});
    for (const std::uint32_t k : {0U, 1U, 2U, 2U, 1U, 3U}) indices.push_back(static_cast<std::uint32_t>(e) * 4 + k);
  }
  m.edges = gl::new_vertex_array();
  glBindVertexArray(m.edges.id());
  m.edge_vertices = gl::new_buffer();
  send(GL_ARRAY_BUFFER, m.edge_vertices.id(), corners);
  m.edge_indices = gl::new_buffer();
  send(GL_ELEMENT_ARRAY_BUFFER, m.edge_indices.id(), indices);
  floats_at(at_start, 3, 8, 0);
  floats_at(at_end, 3, 8, 3);
  floats_at(at_corner, 2, 8, 6);
  m.edge_count = static_cast<GLsizei>(indices.size());
}

void Store::need_twins(StoredMesh& stored) {
  const std::vector<std::uint32_t>& corners = stored.mesh->triangles;
  const std::size_t edges = corners.size() / 3 * 3;
  if (stored.twins.size() == edges) return;
  stored.twins.resize(edges);
  const auto from = [&](std::size_t k) { return corners[k]; };
  const auto to = [&](std::size_t k) { return corners[k % 3 == 2 ? k - 2 : k + 1]; };
  // An open hash table of edges that have no twin yet; 0 is an empty place.
  const std::size_t places = std::bit_ceil(2 * edges + 1);
  std::vector<std::uint32_t> table(places);
  for (std::size_t k = 0; k < edges; ++k) {
    const std::uint32_t a = from(k), b = to(k);
    stored.twins[k] = static_cast<std::uint32_t>(k);
    std::size_t at = (std::uint64_t{std::min(a, b)} * 0x9E3779B97F4A7C15U + std::max(a, b) * 0xC2B2AE3D27D4EB4FU) >> 20;
    for (at &= places - 1; table[at] != 0; at = (at + 1) & (places - 1)) {
      const std::uint32_t other = table[at] - 1;
      if (stored.twins[other] != other || from(other) != b || to(other) != a) continue;
      stored.twins[k] = other, stored.twins[other] = static_cast<std::uint32_t>(k);
      break;
    }
    if (stored.twins[k] == k) table[at] = static_cast<std::uint32_t>(k) + 1;
  }
}

GLuint Store::need_texture(const StoredTexture& t) {
  if (!t.sent) t.texture = send_texture(*t.picture), t.sent = true;
  return t.texture.id();
}

GLuint Store::need_plain_texture(const StoredTexture& t) {
  if (!t.numbers_sent) t.numbers = send_texture(*t.picture, GL_RGBA8), t.numbers_sent = true;
  return t.numbers.id();
}

std::shared_ptr<const StoredTexture> Store::texture(const std::shared_ptr<const Picture>& picture) {
  auto& place = textures_.at(picture.get());
  if (auto known = place.lock()) return known;
  auto t = std::make_shared<StoredTexture>();
  t->picture = picture;
  t->see_through = has_holes(*picture);
  place = t;
  return t;
}

}  // namespace betwixt
