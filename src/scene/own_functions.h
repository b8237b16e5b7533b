// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The functions that the author has defined, in the order of their ids, with an index of their names.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "base/memory.h"
#include "scene/functions.h"

namespace betwixt {

class OwnFunctions {
 public:
  static constexpr std::size_t most = 60'000;  // of a film; an id has 16 bits

  std::size_t size() const { return all_.size(); }
  bool empty() const { return all_.empty(); }
  auto begin() const { return all_.begin(); }
  auto end() const { return all_.end(); }
  const FunctionSpec& operator[](std::size_t i) const { return all_[i]; }
  // Returns the place of the function, or nullopt if none has the name.
  std::optional<std::size_t> find(std::string_view name) const {
    const auto at = place(name);
    return at != by_name_.end() && all_[*at].name == name ? std::optional<std::size_t>(*at) : std::nullopt;
  }
  void push_back(FunctionSpec spec) {
    by_name_.insert(place(spec.name), static_cast<FunctionId>(all_.size()));
    all_.push_back(std::move(spec));
  }
  void set_default(std::size_t i, Value rest) { all_[i].rest = std::move(rest); }
  friend bool operator==(const OwnFunctions& a, const OwnFunctions& b) { return a.all_ == b.all_; }
  friend std::size_t bytes_held(const OwnFunctions& f) {
    using betwixt::bytes_held;
    return bytes_held(f.all_) + bytes_held(f.by_name_);
  }

 private:
  std::vector<FunctionId>::const_iterator place(std::string_view name) const {
    return std::lower_bound(by_name_.begin(), by_name_.end(), name,
                            [&](FunctionId f, std::string_view n) { return all_[f].name < n; });
  }
  std::vector<FunctionSpec> all_;
  std::vector<FunctionId> by_name_;  // their places, in the order of their names
};

}  // namespace betwixt
