// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "scene/own_kinds.h"

#include <algorithm>
#include <set>

namespace betwixt {
namespace {

bool equal(const Strand& a, const Strand& b) { return a.track == b.track && a.components == b.components; }

}  // namespace

const OwnKind* OwnKinds::find(std::string_view name) const {
  const auto at = std::find_if(all.begin(), all.end(), [&](const OwnKind& k) { return k.name == name; });
  return at == all.end() ? nullptr : &*at;
}

const OwnKind* OwnKinds::of(ObjectId root) const {
  for (const OwnKind& k : all)
    for (const Cow<KindInstance>& one : k.instances)
      if (one->parts.front() == root) return &k;
  return nullptr;
}

std::uint8_t differing(const Slot* a, const Slot* b) {
  static const Slot nothing;
  const Slot &x = a ? *a : nothing, &y = b ? *b : nothing;
  std::uint8_t out = 0;
  if (!(x.set == y.set)) out |= aspect::set;
  if (!equal(x, y)) out |= aspect::track;
  if (!equal(x.velocity, y.velocity)) out |= aspect::velocity;
  if (!(x.filters == y.filters)) out |= aspect::filters;
  return out;
}

bool is_below(std::string_view name, std::string_view above) {
  return name.size() > above.size() && name.starts_with(above) && name[above.size()] == '/';
}

bool contains(const Scene& s, const OwnKind& other, const OwnKind& kind) {
  std::set<const OwnKind*> known{&other};
  std::vector<const OwnKind*> open{&other};
  while (!open.empty()) {
    const OwnKind* at = open.back();
    open.pop_back();
    if (at == &kind) return true;
    const std::string& model = s.objects[at->model().index].name;
    for (const OwnKind& k : s.kinds->all)
      if (!known.contains(&k) && std::any_of(k.instances.begin(), k.instances.end(), [&](const Cow<KindInstance>& one) {
            const Object& root = s.objects[one->parts.front().index];
            return !root.removed && (root.name == model || is_below(root.name, model) || is_below(model, root.name));
          }))
        known.insert(&k), open.push_back(&k);
  }
  return false;
}

const OwnKind* circle(const Scene& s, const OwnKind& kind, std::string_view name) {
  for (const OwnKind& k : s.kinds->all)
    if (is_below(name, s.objects[k.model().index].name) && contains(s, kind, k)) return &k;
  return nullptr;
}

}  // namespace betwixt
