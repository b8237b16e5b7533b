// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "export/gltf_nodes.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "export/seen.h"

namespace betwixt::gltf {
namespace {

constexpr double smallest_scale = 1e-6;  // of a node before its animation begins

}  // namespace

std::size_t Nodes::place_objects(const Program& program, const ExportOptions& options) {
  const Document& document = program.document();
  std::vector<ObjectKeys> all = motion_keys(program, options.from, options.until, options.keys);
  keep_asked(all, options.objects);
  std::unordered_map<std::uint32_t, std::size_t> node_of;
  for (const ObjectKeys& k : all) {
    const std::size_t node = add({{"name", document.name(k.id)}});
    inner_of_[k.id.index] = node_of[k.id.index] = node;
    put(node, "translation", k.translation, {});
    put(node, "rotation", k.rotation, {0, 0, 0, 1});
    put(node, "scale", k.scale, {1, 1, 1});
    if (!k.sheared) continue;
    const std::size_t inner = add_below(node, {{"name", document.name(k.id) + " turned"}});
    put(inner, "rotation", k.inner, {0, 0, 0, 1});
    inner_of_[k.id.index] = inner;
  }
  for (const ObjectKeys& k : all) {
    const auto parent = k.parent ? inner_of_.find(k.parent.index) : inner_of_.end();
    (parent == inner_of_.end() ? roots_ : children_[parent->second]).push_back(node_of[k.id.index]);
  }
  parent_.assign(all_.size(), all_.size());
  for (std::size_t i = 0; i < all_.size(); ++i)
    for (const std::size_t child : children_[i]) parent_[child] = i;
  return all.size();
}

std::size_t Nodes::root_above(std::size_t node) const {
  while (parent_[node] < parent_.size()) node = parent_[node];
  return node;
}

std::size_t Nodes::add(Json node) {
  all_.push_back(std::move(node));
  children_.emplace_back();
  return all_.size() - 1;
}
std::size_t Nodes::add_root(Json node) { return roots_.emplace_back(add(std::move(node))); }
std::size_t Nodes::add_below(std::size_t parent, Json node) {
  const std::size_t made = add(std::move(node));
  return children_[parent].emplace_back(made);
}

void Nodes::put(std::size_t node, const char* path, const Channel& c, const std::array<double, 4>& rest) {
  std::array<double, 4> first = c.pieces.front().begin;
  // Programs that read a node as a matrix (assimp) find no rotation in a scale of 0, and then keep a wrong one.
  if (std::string_view(path) == "scale" && !c.constant())
    for (double& x : first) x = std::abs(x) < smallest_scale ? smallest_scale : x;
  const auto same = [&](double a, double b) { return static_cast<float>(a) == static_cast<float>(b); };
  if (!std::equal(first.begin(), first.begin() + static_cast<std::ptrdiff_t>(c.width), rest.begin(), same))
    all_[node][path] = numbers(first, c.width);
  if (!c.constant()) film_.animate(c, {{"node", node}, {"path", path}});
}

std::size_t Nodes::first_read() const {
  std::size_t node = roots_.front();
  while (!children_[node].empty()) node = children_[node].front();
  return node;
}

Json Nodes::all() const {
  Json all = all_;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (!children_[i].empty()) all[i]["children"] = children_[i];
  return all;
}

}  // namespace betwixt::gltf
