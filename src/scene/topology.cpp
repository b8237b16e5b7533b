// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "scene/topology.h"

#include <algorithm>
#include <bit>
#include <numeric>
#include <tuple>
#include <unordered_map>

namespace betwixt {
namespace {

struct PositionHash {
  std::size_t operator()(const std::array<float, 3>& p) const {
    std::uint64_t h = 0;
    for (const float f : p) h = (h ^ std::bit_cast<std::uint32_t>(f + 0.0F)) * 0x9e3779b97f4a7c15ULL;  // -0 is 0
    return static_cast<std::size_t>(h ^ (h >> 29));
  }
};

// A side of a triangle, between welded vertices.
struct Side {
  std::uint32_t low, high, triangle;
  bool forward;  // from low to high
};

std::vector<Side> sorted_sides(const Mesh& mesh, const std::vector<std::uint32_t>& welded) {
  std::vector<Side> sides;
  sides.reserve(mesh.triangles.size());
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    const std::uint32_t a = welded[mesh.triangles[i]];
    const std::uint32_t b = welded[mesh.triangles[i % 3 == 2 ? i - 2 : i + 1]];
    if (a != b) sides.push_back({std::min(a, b), std::max(a, b), i / 3, a < b});
  }
  std::sort(sides.begin(), sides.end(), [](const Side& p, const Side& q) {
    return std::tie(p.low, p.high, p.triangle, p.forward) < std::tie(q.low, q.high, q.triangle, q.forward);
  });
  return sides;
}

// Calls use(first, last) for each run of sides that are the same edge.
template <class F>
void each_edge(const std::vector<Side>& sides, F use) {
  for (auto i = sides.begin(); i != sides.end();) {
    auto j = i;
    while (j != sides.end() && j->low == i->low && j->high == i->high) ++j;
    use(i, j);
    i = j;
  }
}

Vec3 corner(const Mesh& mesh, std::size_t i) { return widen(mesh.positions[mesh.triangles[i]]); }

// Returns twice the area, along the normal.
Vec3 area_vector(const Mesh& mesh, std::size_t triangle) {
  const Vec3 a = corner(mesh, 3 * triangle);
  return cross(corner(mesh, 3 * triangle + 1) - a, corner(mesh, 3 * triangle + 2) - a);
}

std::uint32_t root(std::vector<std::uint32_t>& parent, std::uint32_t i) {
  while (parent[i] != i) i = parent[i] = parent[parent[i]];
  return i;
}

void drop_flat_triangles(Mesh& mesh) {
  std::vector<std::uint32_t> kept;
  kept.reserve(mesh.triangles.size());
  std::vector<std::uint32_t> before(mesh.triangles.size() + 1, 0);  // how many indices are kept before this one
  for (std::size_t t = 0; t * 3 < mesh.triangles.size(); ++t) {
    const bool keep = length(area_vector(mesh, t)) > 0;
    for (std::size_t i = 3 * t; i < 3 * t + 3; ++i) {
      if (keep) kept.push_back(mesh.triangles[i]);
      before[i + 1] = static_cast<std::uint32_t>(kept.size());
    }
  }
  for (auto& part : mesh.parts) {
    const std::uint32_t end = before[part.first + part.count];
    part.first = before[part.first];
    part.count = end - part.first;
  }
  mesh.triangles = std::move(kept);
}

}  // namespace

std::vector<std::uint32_t> weld(const std::vector<std::array<float, 3>>& positions) {
  std::unordered_map<std::array<float, 3>, std::uint32_t, PositionHash> first;
  first.reserve(positions.size());
  std::vector<std::uint32_t> welded(positions.size());
  for (std::uint32_t i = 0; i < positions.size(); ++i) welded[i] = first.try_emplace(positions[i], i).first->second;
  return welded;
}

std::vector<Vec3> face_normals(const Mesh& mesh) {
  std::vector<Vec3> normals(mesh.triangles.size() / 3);
  for (std::size_t t = 0; t < normals.size(); ++t) normals[t] = normalize(area_vector(mesh, t));
  return normals;
}

bool creased(Vec3 normal, Vec3 other) {
  static const double flat = std::cos(0.5 * pi / 180);
  return !(dot(normal, other) > flat);
}

std::vector<std::uint32_t> crease_edges(const Mesh& mesh) {
  const std::vector<Vec3> normals = face_normals(mesh);
  std::vector<std::uint32_t> edges;
  each_edge(sorted_sides(mesh, weld(mesh.positions)), [&](auto i, auto j) {
    if (j - i == 2 && !creased(normals[i->triangle], normals[(i + 1)->triangle])) return;
    edges.insert(edges.end(), {i->low, i->high});
  });
  return edges;
}

bool is_closed(const Mesh& mesh) {
  if (mesh.triangles.empty()) return false;
  const auto welded = weld(mesh.positions);
  bool paired = true;
  each_edge(sorted_sides(mesh, welded), [&](auto i, auto j) {
    paired = paired && std::count_if(i, j, [](const Side& s) { return s.forward; }) * 2 == j - i;
  });
  if (!paired) return false;

  std::vector<std::uint32_t> parent(mesh.positions.size());
  std::iota(parent.begin(), parent.end(), 0U);
  for (std::size_t i = 0; i < mesh.triangles.size(); i += 3)
    for (std::size_t k = 1; k < 3; ++k)
      parent[root(parent, welded[mesh.triangles[i + k]])] = root(parent, welded[mesh.triangles[i]]);
  std::unordered_map<std::uint32_t, double> volumes;
  const Vec3 origin = corner(mesh, 0);  // near the mesh, against cancellation
  for (std::size_t i = 0; i < mesh.triangles.size(); i += 3)
    volumes[root(parent, welded[mesh.triangles[i]])] +=
        dot(corner(mesh, i) - origin, cross(corner(mesh, i + 1) - origin, corner(mesh, i + 2) - origin));
  return std::all_of(volumes.begin(), volumes.end(), [](const auto& v) { return v.second > 0; });
}

double signed_volume(const Mesh& mesh) {
  double sum = 0;
  for (std::size_t i = 0; i < mesh.triangles.size(); i += 3)
    sum += dot(corner(mesh, i), cross(corner(mesh, i + 1), corner(mesh, i + 2)));
  return sum / 6;
}

void make_normals(Mesh& mesh, double crease, std::vector<std::uint32_t>* from) {
  drop_flat_triangles(mesh);
  const auto welded = weld(mesh.positions);
  const std::size_t corners = mesh.triangles.size();
  std::vector<Vec3> face(corners / 3);
  for (std::size_t t = 0; t < face.size(); ++t) face[t] = area_vector(mesh, t);

  // The corners at each position, one run after the other.
  std::vector<std::uint32_t> begin(mesh.positions.size() + 1, 0), around(corners);
  for (const auto v : mesh.triangles) ++begin[welded[v] + 1];
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  auto next = begin;
  for (std::uint32_t c = 0; c < corners; ++c) around[next[welded[mesh.triangles[c]]]++] = c;

  const double limit = std::cos(crease);
  constexpr std::uint32_t crowd =
      256;  // a vertex with more triangles stays flat: comparing all pairs would take too long
  Mesh out;
  out.parts = std::move(mesh.parts);
  out.triangles.resize(corners);
  std::vector<std::vector<std::uint32_t>> copies(mesh.positions.size());  // of a vertex, one for each of its normals
  for (std::uint32_t c = 0; c < corners; ++c) {
    const std::uint32_t v = mesh.triangles[c], w = welded[v];
    const Vec3 own = normalize(face[c / 3]);
    Vec3 sum{};
    for (std::uint32_t i = begin[w]; i < begin[w + 1] && begin[w + 1] - begin[w] <= crowd; ++i) {
      const Vec3 other = face[around[i] / 3];
      if (dot(own, normalize(other)) >= limit) sum = sum + other;
    }
    const auto normal = narrow(normalize(sum, own));
    const auto same =
        std::find_if(copies[v].begin(), copies[v].end(), [&](auto n) { return out.normals[n] == normal; });
    if (same != copies[v].end()) {
      out.triangles[c] = *same;
      continue;
    }
    out.triangles[c] = static_cast<std::uint32_t>(out.positions.size());
    copies[v].push_back(out.triangles[c]);
    out.positions.push_back(mesh.positions[v]);
    out.normals.push_back(normal);
    if (from) from->push_back(v);
    if (!mesh.uvs.empty()) out.uvs.push_back(mesh.uvs[v]);
  }
  const auto moved = [&](std::uint32_t v) { return copies[v].empty() ? copies[welded[v]] : copies[v]; };
  for (std::size_t i = 0; i + 1 < mesh.edges.size(); i += 2) {
    const auto a = moved(mesh.edges[i]), b = moved(mesh.edges[i + 1]);
    if (!a.empty() && !b.empty()) out.edges.insert(out.edges.end(), {a.front(), b.front()});
  }
  mesh = std::move(out);
}

}  // namespace betwixt
