// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "scene/names.h"

#include <gtest/gtest.h>

namespace betwixt {
namespace {

TEST(Names, OfTargetsAreWhatFindsThem) {
  Scene s;
  s.defined.edit().push_back({"mood", Type::scalar, 0.0, 0xffffffff, Unit::none, {}});
  for (const auto& [name, kind] :
       {std::pair("ball", Kind::sphere), {"lens", Kind::camera}, {"spin", Kind::environment}}) {
    Object o;
    o.name = name;
    o.kind = kind;
    add_object(s, std::move(o));
  }
  for (const char* text :
       {"ball.position", "ball.position.y", "ball.color.b", "ball.rotation.z", "ball.rotation.z.velocity", "ball.mood",
        "ball.mood.velocity", "ball.radius", "lens.look-at.x", "ball.world", "ball.touching", "ball.in-view",
        "spin.world", "spin.by", "spin.every", "spin.count"}) {
    const auto t = find_target(s, text);
    ASSERT_TRUE(t) << text << ": " << t.error().message;
    EXPECT_EQ(target_name(s, *t), text);
  }
  EXPECT_FALSE(find_target(s, "ball.by"));
  EXPECT_FALSE(find_target(s, "spin.touching"));
  EXPECT_EQ(object_name(s, {2}), "spin");
  EXPECT_EQ(object_name(s, {3}), "none");
  EXPECT_EQ(object_name(s, {}), "none");
}

TEST(Names, OfTimesAreFramesWhereThereIsOne) {
  const Rate film{24, 1}, video{30000, 1001};
  EXPECT_EQ(format_time({}, film), "1f");
  EXPECT_EQ(format_time({flicks_per_second}, film), "25f");
  EXPECT_EQ(format_time({-flicks_per_second}, film), "-23f");
  EXPECT_EQ(format_time({flicks_per_second * 1001 / 1000}, video), "31f");
  EXPECT_EQ(format_time({flicks_per_second * 1001 / 1000}, film), "1.001s");
  EXPECT_EQ(format_time({flicks_per_second / 48}, film), "0.020833333333333332s");
  EXPECT_EQ(format_time({-flicks_per_second / 24}, film), "0f");
}

}  // namespace
}  // namespace betwixt
