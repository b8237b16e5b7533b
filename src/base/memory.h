// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Heap sizes: the bytes that a value owns outside itself.
#pragma once

#include <algorithm>
#include <cstddef>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace betwixt {

// Returns the size of an allocation of `bytes`: the allocator adds a header and rounds up to a multiple of 16.
constexpr std::size_t in_heap(std::size_t bytes) {
  return bytes == 0 ? 0 : std::max<std::size_t>(32, (bytes + 8 + 15) / 16 * 16);
}

template <class T, class A>
std::size_t bytes_held(const std::vector<T, A>& v) {
  return in_heap(v.capacity() * sizeof(T));
}
// Each element of a map has a node with a colour and three pointers.
template <class K, class T, class C>
std::size_t bytes_held(const std::map<K, T, C>& m) {
  return m.size() * in_heap(sizeof(typename std::map<K, T, C>::value_type) + 4 * sizeof(void*));
}
template <class K, class T, class C>
std::size_t bytes_held(const std::multimap<K, T, C>& m) {
  return m.size() * in_heap(sizeof(typename std::multimap<K, T, C>::value_type) + 4 * sizeof(void*));
}
// A short string has no allocation.
inline std::size_t bytes_held(const std::string& s) {
  return s.capacity() > std::string().capacity() ? in_heap(s.capacity() + 1) : 0;
}
// The control block of a shared pointer: the object, a pointer to its table of functions, and two counts.
template <class T>
constexpr std::size_t shared_bytes = in_heap(sizeof(T) + sizeof(void*) + 2 * sizeof(int));

}  // namespace betwixt
