// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The decoded pictures of all videos of this process that were used last, as many as fit into a bound.
#pragma once

#include <cstddef>
#include <list>
#include <map>
#include <memory>
#include <utility>

#include "betwixt/mesh.h"

namespace betwixt {

class KeptFrames {
 public:
  explicit KeptFrames(std::size_t most_bytes) : most_(most_bytes) {}
  // Returns null if it is not kept.
  std::shared_ptr<const Picture> find(const void* video, std::size_t number);
  // The latest two stay, however large they are.
  void add(const void* video, std::size_t number, std::shared_ptr<const Picture>);
  void forget(const void* video);
  std::size_t bytes() const { return bytes_; }

 private:
  using Key = std::pair<const void*, std::size_t>;
  struct Kept {
    Key key;
    std::shared_ptr<const Picture> picture;
  };
  using Place = std::list<Kept>::iterator;
  void drop(Place);

  const std::size_t most_;
  std::size_t bytes_ = 0;
  std::list<Kept> all_;  // the latest first
  std::map<Key, Place> places_;
};

}  // namespace betwixt
