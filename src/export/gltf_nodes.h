// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The nodes of a glTF file: one for each object, below that of its parent and with its motion, and those added to them.
#pragma once

#include <string>
#include <unordered_map>
#include <vector>

#include "export/gltf_parts.h"

namespace betwixt::gltf {

class Nodes {
 public:
  explicit Nodes(Timeline& film) : film_(film) {}

  // Makes the nodes of the objects. Returns how many objects there are.
  std::size_t place_objects(const Program&, const ExportOptions&);
  bool has(ObjectId id) const { return inner_of_.contains(id.index); }
  // Returns the node of the object's children.
  std::size_t of(ObjectId id) const { return inner_of_.at(id.index); }
  // Returns the node at the top above an object's node.
  std::size_t root_above(std::size_t node) const;

  // Adds a node, and returns its number.
  std::size_t add_root(Json node);
  std::size_t add_below(std::size_t parent, Json node);
  Json& operator[](std::size_t node) { return all_[node]; }
  // Sets a property of a node, constant or with keys. `rest`: the default in glTF.
  void put(std::size_t node, const char* path, const Channel&, const std::array<double, 4>& rest);

  const std::vector<std::size_t>& roots() const { return roots_; }
  // Returns the node that assimp has read first: it reads the children of a node before the node itself.
  std::size_t first_read() const;
  Json all() const;

 private:
  std::size_t add(Json node);

  Timeline& film_;
  Json all_ = Json::array();
  std::vector<std::vector<std::size_t>> children_;
  std::vector<std::size_t> roots_, parent_;                  // parents of objects' nodes; their number if there is none
  std::unordered_map<std::uint32_t, std::size_t> inner_of_;  // by object
};

}  // namespace betwixt::gltf
