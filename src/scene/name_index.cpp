// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "scene/name_index.h"

#include <functional>
#include <utility>

#include "base/memory.h"

namespace betwixt {

std::uint32_t NameIndex::hash_of(std::string_view name) {
  const std::uint64_t h = std::hash<std::string_view>{}(name);
  return static_cast<std::uint32_t>(h ^ h >> 32);
}

// Returns the index of the name in a node, or the number of its names if it is not there.
std::size_t NameIndex::place(const Node& node, std::uint32_t hash, std::string_view name) {
  std::size_t i = 0;
  while (i < node.hashes.size() && !(node.hashes[i] == hash && node.entries[i].name == name)) ++i;
  return i;
}

const NameIndex::Entry* NameIndex::entry(std::string_view name) const {
  const std::uint32_t hash = hash_of(name);
  const Node* node = &*root_;
  for (unsigned depth = 0; !node->branches.empty(); ++depth) node = &*node->branches[way(hash, depth)];
  const std::size_t i = place(*node, hash, name);
  return i < node->entries.size() ? &node->entries[i] : nullptr;
}

ObjectId NameIndex::find(std::string_view name) const {
  const Entry* e = entry(name);
  return e ? e->id : ObjectId{};
}

void NameIndex::split(Node& node, unsigned depth) {
  node.branches.resize(ways);
  for (std::size_t i = 0; i < node.entries.size(); ++i) {
    Node& below = node.branches[way(node.hashes[i], depth)].edit();
    below.hashes.push_back(node.hashes[i]);
    below.entries.push_back(std::move(node.entries[i]));
  }
  node.hashes = {}, node.entries = {};
}

void NameIndex::keep(std::string name, ObjectId id) {
  const std::uint32_t hash = hash_of(name);
  Node* node = &root_.edit();
  for (unsigned depth = 0;; ++depth) {
    if (node->branches.empty() && node->entries.size() >= most && depth < deepest) split(*node, depth);
    if (node->branches.empty()) break;
    node = &node->branches[way(hash, depth)].edit();
  }
  const std::size_t i = place(*node, hash, name);
  if (i < node->entries.size()) {
    node->entries[i].id = id;
    return;
  }
  node->hashes.push_back(hash);
  node->entries.push_back({std::move(name), id});
}

void NameIndex::put(const std::string& name, ObjectId id) {
  keep(name, id);
  std::string above = name;
  for (auto slash = above.rfind('/'); slash != std::string::npos; slash = above.rfind('/')) {
    above.resize(slash);
    if (ever_above(above)) return;
    keep(above + '/', {});  // a name with a trailing slash, which is not valid, marks that something was named below it
  }
}

void NameIndex::erase(std::string_view name) {
  if (!entry(name)) return;
  const std::uint32_t hash = hash_of(name);
  Node* node = &root_.edit();
  for (unsigned depth = 0; !node->branches.empty(); ++depth) node = &node->branches[way(hash, depth)].edit();
  const std::size_t i = place(*node, hash, name);
  node->hashes[i] = node->hashes.back(), node->hashes.pop_back();
  if (i + 1 < node->entries.size()) node->entries[i] = std::move(node->entries.back());
  node->entries.pop_back();
}

bool NameIndex::ever_above(std::string_view name) const { return entry(std::string(name) + '/') != nullptr; }

std::size_t NameIndex::bytes_apart(const Cow<Node>& node, const Cow<Node>& other) {
  if (!node || node.same(other)) return 0;
  std::size_t sum =
      shared_bytes<Node> + bytes_held(node->hashes) + bytes_held(node->entries) + bytes_held(node->branches);
  for (const Entry& e : node->entries) sum += bytes_held(e.name);
  const bool both = node->branches.size() == other->branches.size();
  for (std::size_t i = 0; i < node->branches.size(); ++i)
    sum += bytes_apart(node->branches[i], both ? other->branches[i] : Cow<Node>());
  return sum;
}

std::size_t NameIndex::bytes_apart(const NameIndex& other) const { return bytes_apart(root_, other.root_); }

}  // namespace betwixt
