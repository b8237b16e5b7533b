// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Copy on write: a value that many documents share until one of them edits it.
#pragma once

#include <atomic>
#include <memory>

namespace betwixt {

template <class T>
class Cow {
 public:
  Cow() = default;
  explicit Cow(T value) : at_(std::make_shared<T>(std::move(value))) {}
  explicit operator bool() const { return at_ != nullptr; }
  const T& operator*() const { return at_ ? *at_ : empty(); }
  const T* operator->() const { return &**this; }

  // Returns the value for changing: a copy of our own if another owner sees it too. The editor holds the only path to
  // this Cow, so a count of one cannot grow in between; the fence orders us after the last other owner's reads.
  T& edit() {
    if (!at_)
      at_ = std::make_shared<T>();
    else if (at_.use_count() > 1)
      at_ = std::make_shared<T>(*at_);
    else
      std::atomic_thread_fence(std::memory_order_acquire);
    return *at_;
  }
  void reset() { at_.reset(); }
  bool same(const Cow& other) const { return at_ == other.at_; }
  friend bool operator==(const Cow& a, const Cow& b) { return a.at_ == b.at_ || *a == *b; }

 private:
  static const T& empty() {
    static const T e{};
    return e;
  }
  std::shared_ptr<T> at_;
};

}  // namespace betwixt
