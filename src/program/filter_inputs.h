// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The inputs of filters that look at the points of a fixed grid. Neighbouring frames look at the same points, and code
// that computes them may take long, so a film keeps them.
#pragma once

#include <mutex>
#include <optional>
#include <unordered_map>

#include "betwixt/track.h"
#include "program/asking.h"

namespace betwixt {

class FilterInputs {
 public:
  struct Key {
    std::int32_t live = 0, strand = 0;  // the value, and its layer
    std::int64_t time = 0;
    friend bool operator==(const Key&, const Key&) = default;
  };
  struct Kept {
    Value value;
    Asking::Taken taken;
    std::vector<Target> read;  // by its code
  };

  // Returns what is kept, unless it may differ because of a value that is being evaluated.
  std::optional<Value> find(const Key&, Asking&);
  // Keeps an input if computing it was worth that. Forgets all others when there are too many.
  void keep(const Key&, Kept);
  void clear();

 private:
  struct Hash {
    std::size_t operator()(const Key&) const;
  };
  std::mutex in_use_;
  std::unordered_map<Key, Kept, Hash> all_;
  std::size_t entries_ = 0;  // of all vectors
};

}  // namespace betwixt
