// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// A set of objects with a test in constant time.
#pragma once

#include <vector>

#include "betwixt/value.h"

namespace betwixt::studio {

class Marks {
 public:
  Marks() = default;
  explicit Marks(const std::vector<ObjectId>& ids) {
    for (const ObjectId id : ids) add(id);
  }
  void add(ObjectId id) {
    if (id.index >= marked_.size()) marked_.resize(id.index + std::size_t{1});
    marked_[id.index] = true;
  }
  bool operator()(ObjectId id) const { return id.index < marked_.size() && marked_[id.index]; }

 private:
  std::vector<bool> marked_;
};

}  // namespace betwixt::studio
