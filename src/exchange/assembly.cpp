// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "exchange/assembly.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <map>
#include <unordered_map>

#include "base/files.h"
#include "exchange/unpacking.h"
#include "scene/memory.h"
#include "scene/topology.h"

namespace betwixt {
namespace {

constexpr std::size_t most_indices = 3 * 50'000'000;
constexpr double crease = 60 * pi / 180;  // for files without normals
constexpr double same_plane = 1e-4;

bool in_reach(const std::array<float, 3>& p) {
  return std::all_of(p.begin(), p.end(), [](float f) { return std::abs(f) < 1e15F; });  // false for NaN
}

// Transforms normals, up to their length: the cofactors of the upper 3 by 3. Works for a matrix that flattens, too.
Mat4 normal_matrix(const Mat4& m) {
  Mat4 n;
  for (int c = 0; c < 3; ++c) {
    const Vec3 cofactor = cross(column(m, (c + 1) % 3), column(m, (c + 2) % 3));
    n(0, c) = cofactor.x, n(1, c) = cofactor.y, n(2, c) = cofactor.z;
  }
  return n;
}

using Vertex = std::array<float, 8>;
struct VertexHash {
  std::size_t operator()(const Vertex& v) const {
    std::uint64_t h = 0;
    for (const float f : v) h = (h ^ std::bit_cast<std::uint32_t>(f)) * 0x9e3779b97f4a7c15ULL, h ^= h >> 29;
    return static_cast<std::size_t>(h);
  }
};

// Joins equal vertices, and removes unused ones.
void join_vertices(Mesh& mesh) {
  Mesh out;
  std::unordered_map<Vertex, std::uint32_t, VertexHash> known;
  known.reserve(mesh.positions.size());
  const bool uvs = !mesh.uvs.empty();
  const auto joined = [&](std::uint32_t i) {
    const auto &p = mesh.positions[i], &n = mesh.normals[i];
    const std::array<float, 2> uv = uvs ? mesh.uvs[i] : std::array<float, 2>{0, 0};
    const auto [at, fresh] = known.try_emplace({p[0], p[1], p[2], n[0], n[1], n[2], uv[0], uv[1]},
                                               static_cast<std::uint32_t>(out.positions.size()));
    if (fresh) {
      out.positions.push_back(p);
      out.normals.push_back(n);
      if (uvs) out.uvs.push_back(uv);
    }
    return at->second;
  };
  for (auto& i : mesh.triangles) i = joined(i);
  for (auto& i : mesh.edges) i = joined(i);
  mesh.positions = std::move(out.positions);
  mesh.normals = std::move(out.normals);
  mesh.uvs = std::move(out.uvs);
}

// Keeps each edge once, even if several polygons share it.
void join_edges(Mesh& mesh) {
  const auto welded = weld(mesh.positions);
  std::map<std::pair<std::uint32_t, std::uint32_t>, bool> seen;
  std::vector<std::uint32_t> edges;
  for (std::size_t i = 0; i + 1 < mesh.edges.size(); i += 2) {
    const auto [a, b] = std::minmax(welded[mesh.edges[i]], welded[mesh.edges[i + 1]]);
    if (a != b && seen.try_emplace({a, b}, true).second) edges.insert(edges.end(), {a, b});
  }
  mesh.edges = std::move(edges);
}

template <class T>
void add_to(std::vector<T>& to, const std::vector<T>& from) {
  to.insert(to.end(), from.begin(), from.end());
}

// Reorders an array for new vertices, each of which was another before; keeps an empty array.
template <class T>
void follow(std::vector<T>& all, const std::vector<std::uint32_t>& from) {
  if (all.empty()) return;
  std::vector<T> now;
  for (const std::uint32_t v : from) now.push_back(all[v]);
  all = std::move(now);
}

void follow(Rig& rig, const std::vector<std::uint32_t>& from) {
  follow(rig.joints, from), follow(rig.weights, from);
  for (Rig::Target& t : rig.targets) follow(t.positions, from), follow(t.normals, from);
}

// Sets the targets' flat normals: the difference to the normals at rest when the weight is 1. Source: glTF 2.0, section
// 3.7.2.2: flat normals are computed for each target, and the target's own are ignored.
void flatten_targets(const Mesh& mesh, Rig& rig) {
  for (Rig::Target& t : rig.targets) {
    t.normals.clear();
    if (t.positions.size() != mesh.positions.size()) continue;
    const auto at = [&](std::uint32_t v) { return widen(mesh.positions[v]) + widen(t.positions[v]); };
    std::vector<Vec3> sums(mesh.positions.size());
    for (std::size_t i = 0; i + 2 < mesh.triangles.size(); i += 3) {
      const auto* v = &mesh.triangles[i];
      const Vec3 area = cross(at(v[1]) - at(v[0]), at(v[2]) - at(v[0]));
      for (int k = 0; k < 3; ++k) sums[v[k]] = sums[v[k]] + area;
    }
    for (std::size_t v = 0; v < sums.size(); ++v) {
      const Vec3 rest = widen(mesh.normals[v]);
      t.normals.push_back(narrow(normalize(sums[v], rest) - rest));
    }
  }
}

}  // namespace

Error Assembly::error(const std::string& what) const {
  return fail(ErrorCode::file, fmt::format("{} cannot be read as a {}: {}", path_, as_, what));
}

Status Assembly::add(Mesh piece, const Mat4& to_scene, MeshPart look) {
  return append(std::move(piece), to_scene, std::move(look), nullptr);
}

Status Assembly::add(Mesh piece, const Mat4& to_scene, MeshPart look, Rig rig) {
  const std::size_t count = piece.positions.size();
  if (!rig.joints.empty() && (rig.joints.size() != count || rig.weights.size() != count))
    return error("some of its vertices have no joints");
  for (const Rig::Target& t : rig.targets)
    if ((!t.positions.empty() && t.positions.size() != count) || (!t.normals.empty() && t.normals.size() != count))
      return error("a morph target has another number of vertices than its mesh");
  return append(std::move(piece), to_scene, std::move(look), &rig);
}

Status Assembly::append(Mesh piece, const Mat4& to_scene, MeshPart look, Rig* rig) {
  const std::size_t count = piece.positions.size();
  piece.triangles.resize(piece.triangles.size() / 3 * 3);
  if (piece.triangles.empty()) return Nothing{};
  if (mesh_.triangles.size() + piece.triangles.size() > most_indices || mesh_.positions.size() + count > most_indices)
    return error("it has more than 50 million triangles");
  for (const auto* indices : {&piece.triangles, &piece.edges})
    for (const auto i : *indices)
      if (i >= count) return error(fmt::format("a triangle uses vertex {}, but there are only {}", i, count));
  for (auto& p : piece.positions) {
    p = narrow(transform_point(to_scene, widen(p)));
    if (!in_reach(p)) return error("the position of a vertex is not finite");
  }
  if (determinant(to_scene) < 0)
    for (std::size_t i = 0; i < piece.triangles.size(); i += 3)
      std::swap(piece.triangles[i + 1], piece.triangles[i + 2]);
  if (piece.uvs.size() != count) piece.uvs.clear();
  for (auto& uv : piece.uvs)
    for (auto& f : uv)
      if (!std::isfinite(f)) f = 0;

  const Mat4 turn = normal_matrix(to_scene);
  bool normals = piece.normals.size() == count;
  for (auto& n : piece.normals) {
    const Vec3 turned = transform_vector(turn, widen(n));
    normals = normals && length(turned) > 0 && std::isfinite(length(turned));
    n = narrow(normalize(turned));
  }
  if (!normals) {
    std::vector<std::uint32_t> from;
    make_normals(piece, missing_ == Normals::flat ? same_plane : crease, &from);
    if (rig) follow(*rig, from);
    if (rig && missing_ == Normals::flat) flatten_targets(piece, *rig);
  }
  if (piece.triangles.empty()) return Nothing{};  // all triangles had no area
  if (!rig) join_vertices(piece);
  if (piece.edges.empty())
    piece.edges = crease_edges(piece);
  else
    join_edges(piece);

  if (const Status fits = unpack(bytes_of(piece) + (rig ? bytes_of(*rig) : 0), path_); !fits) return fits;

  const auto base = static_cast<std::uint32_t>(mesh_.positions.size());
  const bool uvs = !mesh_.uvs.empty() || !piece.uvs.empty();
  if (uvs) mesh_.uvs.resize(mesh_.positions.size());
  add_to(mesh_.positions, piece.positions);
  add_to(mesh_.normals, piece.normals);
  add_to(mesh_.uvs, piece.uvs);
  if (uvs) mesh_.uvs.resize(mesh_.positions.size());
  if (rig) take(std::move(*rig));
  for (auto& i : piece.edges) i += base;
  for (auto& i : piece.triangles) i += base;
  add_to(mesh_.edges, piece.edges);
  look.first = static_cast<std::uint32_t>(mesh_.triangles.size());
  look.count = static_cast<std::uint32_t>(piece.triangles.size());
  add_to(mesh_.triangles, piece.triangles);
  // Neighbours of the same look become one run, which needs fewer draw calls.
  if (!mesh_.parts.empty() && mesh_.parts.back().color == look.color && mesh_.parts.back().texture == look.texture)
    mesh_.parts.back().count += look.count;
  else
    mesh_.parts.push_back(std::move(look));
  return Nothing{};
}

// Appends a rig; the mesh already has the vertices of this piece.
void Assembly::take(Rig rig) {
  const std::size_t before = rig_ ? rig_size_ : 0, now = mesh_.positions.size();
  rig_size_ = now;
  if (!rig_) {
    rig_ = std::move(rig);
  } else {
    add_to(rig_->joints, rig.joints), add_to(rig_->weights, rig.weights);
    for (std::size_t i = 0; i < rig_->targets.size() && i < rig.targets.size(); ++i) {
      auto &to = rig_->targets[i], &from = rig.targets[i];
      for (auto [all, more] : {std::pair(&to.positions, &from.positions), std::pair(&to.normals, &from.normals)}) {
        if (all->empty() && more->empty()) continue;
        all->resize(before), add_to(*all, *more), all->resize(now);
      }
    }
  }
}

Result<std::shared_ptr<const Mesh>> Assembly::finish() && {
  if (mesh_.triangles.empty()) return error("it has no triangles");
  if (rig_) {
    const std::size_t count = mesh_.positions.size();
    if (!rig_->joints.empty() && rig_->joints.size() != count) return error("some of its vertices have no joints");
    for (Rig::Target& t : rig_->targets)
      for (auto* all : {&t.positions, &t.normals})
        if (!all->empty()) all->resize(count);
    mesh_.rig = std::make_shared<const Rig>(*std::move(rig_));
  }
  mesh_.closed = is_closed(mesh_);
  return std::make_shared<const Mesh>(std::move(mesh_));
}

Result<std::shared_ptr<const Mesh>> parse_mesh(const std::string& path, FileSource& files) {
  const std::string kind = ending(path);
  if (kind == "gltf" || kind == "glb") return load_gltf(path, files);
  if (kind == "ply") return load_ply(path, files);
  {
    const auto bytes = files.read(path);  // a missing file is reported before a wrong ending
    if (!bytes) return bytes.error();
    // In a browser, a file converted to glTF keeps its own name.
    if (bytes->starts_with("glTF")) return load_gltf(path, files);
  }
  // The formats for which assimp is most robust against broken files.
  for (const char* known : {"obj", "stl", "dae", "fbx", "3ds"})
    if (kind == known) return load_by_assimp(path, files);
  return fail(ErrorCode::file, fmt::format("the format of the mesh {} is not supported", path),
              "supported: glTF (.gltf .glb), .obj .ply .stl .dae .fbx .3ds");
}

}  // namespace betwixt
