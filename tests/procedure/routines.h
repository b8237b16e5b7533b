// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Runs Lua code in a fake film and returns its values.
#pragma once

#include <gtest/gtest.h>

#include "base/diagnostic.h"
#include "procedure/fake.h"
#include "procedure/lua.h"

namespace betwixt {

inline std::shared_ptr<const Routine> made(Role role, const std::string& source) {
  auto r = make_lua(role, source);
  EXPECT_TRUE(r) << source << ": " << r.error().message;
  return r ? *r : nullptr;
}
inline Result<Value> value(const std::string& source, FakeQuestions q = {}, const std::vector<Value>& arguments = {}) {
  std::uint64_t cost = 0;
  return made(Role::value, source)->value(q, arguments, cost);
}
template <class T>
T get(const std::string& source, FakeQuestions q = {}, const std::vector<Value>& arguments = {}) {
  const auto v = value(source, q, arguments);
  EXPECT_TRUE(v) << source << ": " << v.error().message;
  const T* t = v ? std::get_if<T>(&*v) : nullptr;
  EXPECT_TRUE(t) << source;
  return t ? *t : T{};
}
inline double number(const std::string& source, FakeQuestions q = {}) { return get<double>(source, q); }
inline std::string error(const std::string& source, FakeQuestions q = {}) {
  const auto v = value(source, q);
  EXPECT_FALSE(v) << source;
  return v ? "" : with_line(v.error().place.line, v.error().message);
}
inline FakeQuestions at(double t) {
  FakeQuestions q;
  q.time = t;
  return q;
}

}  // namespace betwixt
