// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// A map from names to objects, in a tree that copies share: naming one copies the path to it, however many there are.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/cow.h"
#include "betwixt/value.h"

namespace betwixt {

class NameIndex {
 public:
  ObjectId find(std::string_view name) const;
  void put(const std::string& name, ObjectId id);
  void erase(std::string_view name);
  bool ever_above(std::string_view name) const;           // whether any object was ever named below it, as man/arm is
  std::size_t bytes() const { return bytes_apart({}); }   // of its own memory
  std::size_t bytes_apart(const NameIndex& other) const;  // of its own memory that the other does not share
  bool same(const NameIndex& other) const { return root_.same(other.root_); }

 private:
  struct Entry {
    std::string name;
    ObjectId id;
  };
  // Has names, with their hashes; or, if these were too many, branches, by the next bits of the hash.
  struct Node {
    std::vector<std::uint32_t> hashes;
    std::vector<Entry> entries;
    std::vector<Cow<Node>> branches;
  };
  static constexpr unsigned bits = 5, ways = 1U << bits, deepest = 32 / bits;
  static constexpr std::size_t most = 64;  // names of a node

  static std::uint32_t hash_of(std::string_view name);
  static std::size_t way(std::uint32_t hash, unsigned depth) { return hash >> bits * depth & (ways - 1); }
  static std::size_t place(const Node&, std::uint32_t hash, std::string_view name);
  static void split(Node&, unsigned depth);
  static std::size_t bytes_apart(const Cow<Node>&, const Cow<Node>& other);
  const Entry* entry(std::string_view name) const;
  void keep(std::string name, ObjectId id);

  Cow<Node> root_;
};

}  // namespace betwixt
