// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "render/batches.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <map>
#include <tuple>

namespace betwixt {
namespace {

Instance instance_of(const Thing& t, const Mat4& m) {
  Instance r{};
  std::array<Vec3, 3> c;
  double scale = 0;
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 4; ++k) r.rows[static_cast<std::size_t>(4 * i + k)] = static_cast<float>(m(i, k));
    c[static_cast<std::size_t>(i)] = {m(0, i), m(1, i), m(2, i)};
  }
  // The inverse transpose but for its length: the cross products of the columns.
  std::array<Vec3, 3> n = {cross(c[1], c[2]), cross(c[2], c[0]), cross(c[0], c[1])};
  for (const Vec3& v : n) scale = std::max(scale, length(v));
  scale = scale > 0 ? (t.mirrored ? -1 : 1) / scale : 0;
  for (std::size_t i = 0; i < 9; ++i) r.normal[i] = static_cast<float>(scale * n[i / 3][static_cast<int>(i % 3)]);
  const Item& item = *t.item;
  for (int i = 0; i < 3; ++i)
    r.color[static_cast<std::size_t>(i)] = static_cast<float>(std::clamp(item.color[i], 0.0, 1e4));
  r.color[3] = static_cast<float>(1 - std::clamp(item.transparency, 0.0, 1.0));
  r.look = {static_cast<float>(std::clamp(item.shininess, 0.0, 1.0)), static_cast<float>(item.material)};
  return r;
}

}  // namespace

Batches batches_of(std::span<const Thing* const> things, bool coarse) {
  struct Group {
    double depth = std::numeric_limits<double>::infinity();
    std::size_t order = 0;
    std::vector<const Thing*> members;
  };
  using Key = std::tuple<const StoredMesh*, const Picture*, bool, bool>;
  std::map<Key, std::size_t> index;
  std::vector<Group> groups;
  const auto mesh_of = [coarse](const Thing& t) { return coarse ? t.coarse : t.mesh; };
  for (const Thing* t : things) {
    const Key key{mesh_of(*t), coarse ? nullptr : t->item->texture.get(), t->mirrored, t->closed};
    const auto [at, fresh] = index.try_emplace(key, groups.size());
    if (fresh) groups.push_back({.order = groups.size(), .members = {}});
    Group& g = groups[at->second];
    g.depth = std::min(g.depth, t->depth);
    g.members.push_back(t);
  }
  std::sort(groups.begin(), groups.end(),
            [](const Group& a, const Group& b) { return std::tie(a.depth, a.order) < std::tie(b.depth, b.order); });
  Batches r;
  r.instances.reserve(things.size());
  for (Group& g : groups) {
    std::stable_sort(g.members.begin(), g.members.end(),
                     [](const Thing* a, const Thing* b) { return a->depth < b->depth; });
    const Thing& one = *g.members.front();
    r.batches.push_back(
        {mesh_of(one), one.item->texture, one.mirrored, one.closed, one.ball, r.instances.size(), g.members.size()});
    for (const Thing* t : g.members) r.instances.push_back(instance_of(*t, coarse ? t->coarse_local : t->local));
  }
  return r;
}

Batches sorted_singles(std::span<const Thing* const> things) {
  std::vector<const Thing*> order(things.begin(), things.end());
  std::stable_sort(order.begin(), order.end(), [](const Thing* a, const Thing* b) { return a->depth > b->depth; });
  Batches r;
  for (const Thing* t : order) {
    r.batches.push_back({t->mesh, t->item->texture, t->mirrored, t->closed, t->ball, r.instances.size(), 1});
    r.instances.push_back(instance_of(*t, t->local));
  }
  return r;
}

void send_instances(const gl::Buffer& buffer, const std::vector<Instance>& instances) {
  glBindBuffer(GL_ARRAY_BUFFER, buffer.id());
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(instances.size() * sizeof(Instance)), instances.data(),
               GL_STREAM_DRAW);
}

void bind_instances(const gl::Buffer& buffer, std::size_t first) {
  static constexpr struct {
    GLint count;
    std::size_t offset;
  } fields[] = {{4, offsetof(Instance, rows)},        {4, offsetof(Instance, rows) + 16},
                {4, offsetof(Instance, rows) + 32},   {3, offsetof(Instance, normal)},
                {3, offsetof(Instance, normal) + 12}, {3, offsetof(Instance, normal) + 24},
                {4, offsetof(Instance, color)},       {2, offsetof(Instance, look)}};
  glBindBuffer(GL_ARRAY_BUFFER, buffer.id());
  GLuint attribute = at_instance;
  for (const auto& f : fields) {
    glEnableVertexAttribArray(attribute);
    glVertexAttribDivisor(attribute, 1);
    glVertexAttribPointer(attribute, f.count, GL_FLOAT, GL_FALSE, sizeof(Instance),
                          reinterpret_cast<const void*>(first * sizeof(Instance) + f.offset));
    ++attribute;
  }
}

void set_facing(bool mirrored, bool upside_down) { glFrontFace(mirrored != upside_down ? GL_CW : GL_CCW); }

void draw_triangles(const Batch& b, const gl::Buffer& instances, bool upside_down) {
  if (b.mesh->parts.empty()) return;
  (b.closed && !b.ball ? glEnable : glDisable)(GL_CULL_FACE);
  set_facing(b.mirrored, upside_down);
  glBindVertexArray(b.mesh->triangles.id());
  bind_instances(instances, b.first);
  for (const MeshPart& p : b.mesh->parts)
    glDrawElementsInstanced(GL_TRIANGLES, static_cast<GLsizei>(p.count), GL_UNSIGNED_INT,
                            reinterpret_cast<const void*>(p.first * sizeof(std::uint32_t)),
                            static_cast<GLsizei>(b.count));
}

}  // namespace betwixt
