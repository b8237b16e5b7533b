// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// An append-only list, as a value. A copy costs nothing, and appending to a copy shares the existing items. Items that
// a reader on another thread holds are never moved or written.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <memory>

namespace betwixt {

template <class T>
class SharedLog {
 public:
  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  const T& operator[](std::size_t i) const {
    const Block* b = last_.get();
    while (i < b->begin) b = b->before.get();
    return b->items[i - b->begin];
  }
  const T& back() const { return (*this)[size_ - 1]; }

  void push(T value) {
    if (!claim()) grow();
    std::construct_at(last_->items + (size_ - last_->begin), std::move(value));
    ++size_;
  }

 private:
  // Holds the items begin, begin + 1, ...; earlier items are in earlier blocks.
  struct Block {
    Block(std::size_t first, std::size_t space, std::shared_ptr<Block> older)
        : begin(first),
          capacity(space),
          depth(older ? older->depth + 1 : 0),
          before(std::move(older)),
          items(std::allocator<T>().allocate(space)) {}
    Block(const Block&) = delete;
    Block& operator=(const Block&) = delete;
    ~Block() {
      std::destroy_n(items, used.load());
      std::allocator<T>().deallocate(items, capacity);
    }
    const std::size_t begin, capacity, depth;
    const std::shared_ptr<Block> before;
    T* const items;
    std::atomic<std::size_t> used{0};
  };
  static constexpr std::size_t deepest = 64;

  // Takes the next place of our last block. Fails if it is full, or if a copy of us has appended there already.
  bool claim() {
    if (!last_) return false;
    std::size_t here = size_ - last_->begin;
    return here < last_->capacity && last_->used.compare_exchange_strong(here, here + 1);
  }
  // Adds a block of our own, as large as all before. If many copies have branched off, copies all items into it.
  void grow() {
    const bool flatten = last_ && last_->depth >= deepest;
    auto block = flatten ? std::make_shared<Block>(0, 2 * size_, nullptr)
                         : std::make_shared<Block>(size_, std::max<std::size_t>(1, size_), last_);
    for (std::size_t i = block->begin; i < size_; ++i, ++block->used) std::construct_at(block->items + i, (*this)[i]);
    ++block->used;
    last_ = std::move(block);
  }

  std::shared_ptr<Block> last_;
  std::size_t size_ = 0;
};

}  // namespace betwixt
