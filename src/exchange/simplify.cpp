// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "exchange/simplify.h"

#include <meshoptimizer.h>

#include <algorithm>
#include <limits>
#include <map>
#include <mutex>
#include <vector>

#include "scene/topology.h"

namespace betwixt {
namespace {

// Returns whether a mesh with a radius of `radius` pixels has far more triangles than it can cover pixels.
bool crowded(const Mesh& m, double radius) { return static_cast<double>(m.triangles.size()) / 3 > 8 * radius * radius; }

using Corners = std::vector<std::uint32_t>;

bool sound(const Mesh& m) {
  return m.normals.size() == m.positions.size() && m.triangles.size() % 3 == 0 &&
         std::all_of(m.triangles.begin(), m.triangles.end(), [&](std::uint32_t i) { return i < m.positions.size(); });
}

// One part: its vertices, and its corners as indexes into them.
struct Part {
  Corners vertices, corners;
  std::vector<std::array<float, 3>> positions;
  std::vector<std::array<float, 2>> uvs;

  Part(const Mesh& m, const MeshPart& part) {
    constexpr std::uint32_t unused = std::numeric_limits<std::uint32_t>::max();
    Corners place(m.positions.size(), unused);
    for (std::uint32_t k = part.first; k < part.first + part.count; ++k) {
      const std::uint32_t v = m.triangles[k];
      if (place[v] == unused) {
        place[v] = static_cast<std::uint32_t>(vertices.size());
        vertices.push_back(v), positions.push_back(m.positions[v]);
        if (m.uvs.size() == m.positions.size()) uvs.push_back(m.uvs[v]);
      }
      corners.push_back(place[v]);
    }
  }
  // Returns the corners, with the first of all vertices that differ only by their normals.
  Corners welded() const {
    Corners out(corners.size());
    const meshopt_Stream streams[] = {{positions.data(), sizeof positions[0], sizeof positions[0]},
                                      {uvs.data(), sizeof uvs[0], sizeof uvs[0]}};
    meshopt_generateShadowIndexBufferMulti(out.data(), corners.data(), corners.size(), positions.size(), streams,
                                           uvs.empty() ? 1 : 2);
    return out;
  }
};

float size_of(const std::vector<std::array<float, 3>>& positions) {
  return meshopt_simplifyScale(positions.front().data(), positions.size(), sizeof positions[0]);
}

// Returns fewer triangles of a part, off by up to a pixel, as indexes into the mesh's vertices. Corners within a pixel
// merge; then edges collapse without visible change.
Corners fewer(const Mesh& m, const MeshPart& of, float pixel) {
  const Part part(m, of);
  if (part.corners.empty()) return {};
  const Corners welded = part.welded();
  const float* const first = part.positions.front().data();
  const std::size_t count = part.positions.size(), stride = sizeof part.positions[0];
  const float error = pixel / size_of(part.positions);
  Corners some(welded.size());
  some.resize(
      meshopt_simplifySloppy(some.data(), welded.data(), welded.size(), first, count, stride, 0, error, nullptr));
  Corners out(some.size());
  out.resize(meshopt_simplify(out.data(), some.data(), some.size(), first, count, stride, 0, 0.5F * error, 0, nullptr));
  meshopt_optimizeVertexCache(out.data(), out.data(), out.size(), count);
  for (std::uint32_t& i : out) i = part.vertices[i];
  return out;
}

// Removes the unused vertices.
void compact(Mesh& m) {
  constexpr std::uint32_t unused = std::numeric_limits<std::uint32_t>::max();
  Corners place(m.positions.size(), unused);
  const Mesh all = m;
  m.positions.clear(), m.normals.clear(), m.uvs.clear();
  for (std::uint32_t& i : m.triangles) {
    if (place[i] == unused) {
      place[i] = static_cast<std::uint32_t>(m.positions.size());
      m.positions.push_back(all.positions[i]), m.normals.push_back(all.normals[i]);
      if (all.uvs.size() == all.positions.size()) m.uvs.push_back(all.uvs[i]);
    }
    i = place[i];
  }
}

// Returns a simpler mesh for a pixel of this size.
Mesh simpler(const Mesh& from, float pixel) {
  Mesh m = from;
  m.edges.clear(), m.triangles.clear();
  std::vector<MeshPart> parts = from.parts;
  if (parts.empty()) parts.push_back({0, static_cast<std::uint32_t>(from.triangles.size()), {1, 1, 1}, nullptr});
  for (MeshPart& p : parts) {
    const auto all = static_cast<std::uint32_t>(from.triangles.size());
    p.first = std::min(p.first, all), p.count = std::min(p.count, all - p.first) / 3 * 3;
    const Corners some = fewer(from, p, pixel);
    p.first = static_cast<std::uint32_t>(m.triangles.size()), p.count = static_cast<std::uint32_t>(some.size());
    m.triangles.insert(m.triangles.end(), some.begin(), some.end());
  }
  if (!from.parts.empty()) m.parts = std::move(parts);
  compact(m);
  make_normals(m, 0.6);
  m.closed = from.closed;
  return m;
}

struct Simpler {
  std::weak_ptr<const Mesh> of, mesh;
};

}  // namespace

std::shared_ptr<const Mesh> simplified(const std::shared_ptr<const Mesh>& mesh, const Detail& detail) {
  static std::mutex mutex;
  static std::map<std::pair<const Mesh*, int>, Simpler> held;
  if (detail.even || mesh->posed || !crowded(*mesh, detail.pixels())) return mesh;
  const std::pair key{mesh.get(), detail.around};
  {
    const std::lock_guard lock(mutex);
    if (const auto i = held.find(key); i != held.end() && i->second.of.lock() == mesh)
      if (auto known = i->second.mesh.lock()) return known;
  }
  std::shared_ptr<const Mesh> made = mesh;
  if (sound(*mesh)) {
    const float pixel = size_of(mesh->positions) / static_cast<float>(2 * detail.pixels());
    auto fewer = std::make_shared<const Mesh>(simpler(*mesh, pixel));
    if (2 * fewer->triangles.size() < mesh->triangles.size()) made = std::move(fewer);
  }
  const std::lock_guard lock(mutex);
  std::erase_if(held, [](const auto& entry) { return entry.second.of.expired(); });
  Simpler& place = held[key];
  if (place.of.lock() == mesh)
    if (auto known = place.mesh.lock()) return known;  // another thread was faster
  place = {mesh, made};
  return made;
}

}  // namespace betwixt
