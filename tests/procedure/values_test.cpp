// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests values of every type, from Lua and to Lua.
#include "procedure/routines.h"

namespace betwixt {
namespace {

// shows: G54 G29
TEST(Lua, ValuesOfEveryKind) {
  EXPECT_EQ(get<Vec3>("vec(1, 2, 3) + 2 * vec(1, 0, -1) / 4"), (Vec3{1.5, 2, 2.5}));
  EXPECT_EQ(get<Vec3>("-vec(1, 2, 3) * vec(2, 2, 2) - vec(1, 1, 1)"), (Vec3{-3, -5, -7}));
  EXPECT_EQ(get<bool>("vec(1, 2, 3) == vec(1, 2, 3) and vec(1, 2, 3) ~= vec(1, 2, 4)"), true);
  EXPECT_EQ(get<bool>("vec(1, 2, 3) == euler(1, 2, 3)"), false);
  EXPECT_EQ(number("length(vec(2, 3, 6))"), 7);
  EXPECT_EQ(number("dot(cross(vec(1,0,0), vec(0,1,0)), vec(4,5,6))"), 6);
  EXPECT_EQ(get<Color>("mix(rgb(0, 0, 0), rgb(1, 0.5, 0), 0.5)"), (Color{0.5, 0.25, 0}));
  EXPECT_EQ(get<Angles>("euler(1, 2, 3)"), (Angles{{1, 2, 3}}));
  EXPECT_EQ(get<Quat>("quat(0, 1, 0, 0)"), (Quat{0, 1, 0, 0}));
  const Vec3 turned = get<Vec3>("axis(0, 0, 1, pi / 2) * vec(1, 0, 0)");
  EXPECT_NEAR(turned.x, 0, 1e-15);
  EXPECT_NEAR(turned.y, 1, 1e-15);
  EXPECT_EQ(get<Points>("{vec(1,0,0), vec(0,1,0)}")->size(), 2u);
  EXPECT_EQ(get<Names>("{'a', 'b'}")->at(1), "b");
  FakeQuestions q;
  q.readings["hand.world"] = Matrix(translation({4, 5, 6}));
  EXPECT_EQ(number("local m = value('hand.world') return m[4] + 10 * m.y + 100 * m[1]", q), 4 + 50 + 100);
  q.readings["c"] = Color{0.1, 0.2, 0.3};
  EXPECT_EQ(get<Color>("value('c')", q), (Color{0.1, 0.2, 0.3}));
}

// shows: G54
TEST(Lua, TextsOfCodeAreTextsThatAScriptMayHave) {
  EXPECT_EQ(*get<Text>("'a\\27b\\7\\u{9b}c\\xffd\\te\\nf\\u{202e}é'"), "a\uFFFDb\uFFFD\uFFFDc\uFFFDd\te\nf\u202eé");
  const auto names = get<Names>("{'a\\27', 'b'}");
  EXPECT_EQ(*names, (std::vector<std::string>{"a\uFFFD", "b"}));
}

}  // namespace
}  // namespace betwixt
