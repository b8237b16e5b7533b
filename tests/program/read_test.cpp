// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "program/compiled.h"
#include "program/programs.h"

namespace betwixt {
namespace {

// shows: G29 G36
TEST(Read, GivesEveryTypeBack) {
  Scene s;
  s.defined.edit().push_back({"mood", Type::scalar, 3.5, 0xffffffff, Unit::none, {}});
  const auto mood = static_cast<FunctionId>(built_in_functions().size());
  const ObjectId id = add(s, "words", Kind::text), line = add(s, "line", Kind::polyline);
  set_value(s, {id, fn::text}, Text(std::string("hello")));
  using V = std::vector<Vec3>;
  put_event(s, {line, fn::points}, event(0, Points(V{{0, 0, 0}, {1, 0, 0}}), Twerper::linear));
  put_event(s, {line, fn::points}, event(1, Points(V{{0, 2, 0}, {3, 0, 0}})));
  const Program p = compile(s);
  EXPECT_EQ(*std::get<Text>(p.read({id, fn::text}, {})), "hello");
  EXPECT_EQ(*std::get<Points>(p.read({line, fn::points}, from_seconds(0.5))), (V{{0, 1, 0}, {2, 0, 0}}));
  EXPECT_EQ(std::get<double>(p.read({id, mood}, {})), 3.5);
  EXPECT_EQ(std::get<double>(p.read({id, fn::scale, 1}, {})), 1);
  EXPECT_EQ(numbers(p.read({id, Query::world}, {})).size(), 16U);
  EXPECT_EQ(numbers(Value(true)), std::vector<double>{1});
  EXPECT_TRUE(numbers(Value(Text())).empty());
}

}  // namespace
}  // namespace betwixt
