// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// How many bytes things hold beside themselves, as they ask for them; what an allocator adds is not counted.
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <vector>

namespace betwixt {

template <class T, class A>
std::size_t bytes_held(const std::vector<T, A>& v) {
  return v.capacity() * sizeof(T);
}
// Each element of a map has a node: a colour and three pointers beside it.
template <class K, class T, class C>
std::size_t bytes_held(const std::map<K, T, C>& m) {
  return m.size() * (sizeof(typename std::map<K, T, C>::value_type) + 4 * sizeof(void*));
}
// The block of a shared pointer: the object, a pointer to a table of functions and two counts.
template <class T>
constexpr std::size_t shared_bytes = sizeof(T) + sizeof(void*) + 2 * sizeof(int);

}  // namespace betwixt
