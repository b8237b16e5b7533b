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

struct Member {
  double depth = 0;
  std::uint32_t thing = 0;
  friend bool operator<(const Member& a, const Member& b) {
    return std::tie(a.depth, a.thing) < std::tie(b.depth, b.thing);
  }
};

struct Group {
  Member nearest{std::numeric_limits<double>::infinity(), 0};
  std::vector<Member> members;
};

// What lies on an object in object space needs its measures, which a mesh for many sizes does not have.
const Shape* measured_shape(const Thing& t) {
  const bool lies = t.finish && (t.finish->pattern != Pattern::none || t.finish->has_pictures() || t.texture);
  return lies || t.gradients ? t.shape.get() : nullptr;
}

}  // namespace

Batches batches_of(const Things& things, std::span<const std::uint32_t> numbers) {
  using Key =
      std::tuple<const StoredMesh*, const StoredTexture*, const Finish*, const Gradients*, const Shape*, bool, bool>;
  std::map<Key, std::size_t> index;
  std::vector<Group> groups;
  std::optional<Key> latest;
  std::size_t at = 0;
  for (const std::uint32_t i : numbers) {
    const Thing& t = things[i];
    if (const Key key{t.mesh, t.texture.get(), t.finish.get(), t.gradients.get(), measured_shape(t), t.mirrored,
                      t.closed};
        !latest || *latest != key) {
      latest = key;
      const auto [place, fresh] = index.try_emplace(key, groups.size());
      if (fresh) groups.emplace_back();
      at = place->second;
    }
    groups[at].members.push_back({t.depth, i});
    groups[at].nearest = std::min(groups[at].nearest, groups[at].members.back());
  }
  std::sort(groups.begin(), groups.end(), [](const Group& a, const Group& b) { return a.nearest < b.nearest; });
  Batches r;
  r.order.reserve(numbers.size());
  for (Group& g : groups) {
    std::sort(g.members.begin(), g.members.end());
    const Thing& one = things[g.members.front().thing];
    r.batches.push_back({one.mesh, one.texture.get(), one.finish.get(), one.gradients.get(), one.mirrored, one.closed,
                         one.ball, one.line, r.order.size(), g.members.size()});
    for (const Member& m : g.members) r.order.push_back(m.thing);
  }
  return r;
}

Batches sorted_singles(const Things& things, std::span<const std::uint32_t> numbers) {
  Batches r;
  r.order.assign(numbers.begin(), numbers.end());
  std::stable_sort(r.order.begin(), r.order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return things[a].depth > things[b].depth; });
  for (std::size_t k = 0; k < r.order.size(); ++k) {
    const Thing& t = things[r.order[k]];
    r.batches.push_back(
        {t.mesh, t.texture.get(), t.finish.get(), t.gradients.get(), t.mirrored, t.closed, t.ball, t.line, k, 1});
  }
  return r;
}

void Instances::set(std::vector<Instance> all) {
  sent_ = std::move(all);
  order_.clear();
  glBindBuffer(GL_ARRAY_BUFFER, buffer_.id());
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(sent_.size() * sizeof(Instance)), sent_.data(), GL_STREAM_DRAW);
}

void Instances::send(std::size_t first, std::size_t end) const {
  glBufferSubData(GL_ARRAY_BUFFER, static_cast<GLintptr>(first * sizeof(Instance)),
                  static_cast<GLsizeiptr>((end - first) * sizeof(Instance)), &sent_[first]);
}

void Instances::set(const Things& things, const std::vector<std::uint32_t>& order) {
  constexpr std::uint32_t nowhere = std::numeric_limits<std::uint32_t>::max();
  const bool few = !things.all_changed() && 4 * things.changed().size() < order.size();
  if (!few || order != order_ || place_.size() != things.all().size()) {
    std::vector<Instance> all;
    all.reserve(order.size());
    for (const std::uint32_t i : order) all.push_back(things[i].instance);
    set(std::move(all));
    order_ = order;
    place_.assign(things.all().size(), nowhere);
    for (std::size_t k = 0; k < order.size(); ++k) place_[order[k]] = static_cast<std::uint32_t>(k);
    return;
  }
  std::vector<std::uint32_t> places;
  for (const std::uint32_t i : things.changed())
    if (place_[i] != nowhere) places.push_back(place_[i]), sent_[place_[i]] = things[i].instance;
  std::sort(places.begin(), places.end());
  glBindBuffer(GL_ARRAY_BUFFER, buffer_.id());
  for (std::size_t k = 0; k < places.size();) {
    const std::size_t first = k;
    while (++k < places.size() && places[k] == places[k - 1] + 1) {
    }
    send(places[first], places[k - 1] + 1);
  }
}

void Instances::bind(std::size_t first) const {
  static constexpr struct {
    GLint count;
    std::size_t offset;
  } fields[] = {{4, offsetof(Instance, rows)},        {4, offsetof(Instance, rows) + 16},
                {4, offsetof(Instance, rows) + 32},   {3, offsetof(Instance, normal)},
                {3, offsetof(Instance, normal) + 12}, {3, offsetof(Instance, normal) + 24},
                {4, offsetof(Instance, color)},       {2, offsetof(Instance, look)}};
  glBindBuffer(GL_ARRAY_BUFFER, buffer_.id());
  GLuint attribute = at_instance;
  for (const auto& f : fields) {
    glEnableVertexAttribArray(attribute);
    glVertexAttribDivisor(attribute, 1);
    glVertexAttribPointer(attribute, f.count, GL_FLOAT, GL_FALSE, sizeof(Instance),
                          reinterpret_cast<const void*>(first * sizeof(Instance) + f.offset));
    ++attribute;
  }
}

void Once::begin() {
  if (++mark_ > most) {
    glClear(GL_STENCIL_BUFFER_BIT);
    mark_ = 1;
  }
  glEnable(GL_STENCIL_TEST);
  glStencilFunc(GL_NOTEQUAL, mark_, most);
  glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
}

void Once::end() { glDisable(GL_STENCIL_TEST); }

void set_facing(bool mirrored, bool upside_down) { glFrontFace(mirrored != upside_down ? GL_CW : GL_CCW); }

void draw_triangles(const Batch& b, const Instances& instances, bool upside_down) {
  if (b.mesh->parts.empty()) return;
  Store::need_triangles(*b.mesh);
  (b.closed && !b.ball ? glEnable : glDisable)(GL_CULL_FACE);
  set_facing(b.mirrored, upside_down);
  glBindVertexArray(b.mesh->triangles.id());
  instances.bind(b.first);
  for (const StoredPart& p : b.mesh->parts)
    glDrawElementsInstanced(GL_TRIANGLES, static_cast<GLsizei>(p.count), GL_UNSIGNED_INT,
                            reinterpret_cast<const void*>(p.first * sizeof(std::uint32_t)),
                            static_cast<GLsizei>(b.count));
}

}  // namespace betwixt
