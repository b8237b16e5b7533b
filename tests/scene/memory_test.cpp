// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "scene/memory.h"

#include <gtest/gtest.h>

#include "support/objects.h"

namespace betwixt {
namespace {

Scene scene_of(int events) {
  Scene s;
  const ObjectId ball = add(s, "ball");
  for (int k = 0; k < events; ++k) put_event(s, {ball, fn::radius}, event(k, 0.5 * k));
  return s;
}

TEST(SceneSize, CountsEventsAndWhatTheyTake) {
  constexpr std::size_t few = 1280, many = 12'800;
  const SceneSize small = size_of(scene_of(few)), large = size_of(scene_of(many));
  EXPECT_EQ(small.events, few);
  EXPECT_EQ(large.events, many);
  const double each = static_cast<double>(large.bytes - small.bytes) / static_cast<double>(many - few);
  EXPECT_GE(each, sizeof(Event));
  EXPECT_LE(each, sizeof(Event) + 1);  // chunks and their counts
}

TEST(SceneSize, CountsOnceWhatManyShare) {
  Scene s = scene_of(10'000);
  const std::size_t one = size_of(s).bytes;
  Object twin = s.objects[0];
  twin.name = "twin";
  add_object(s, std::move(twin));
  EXPECT_LT(size_of(s).bytes - one, 4096U);
  const std::string verse(100'000, 'x');
  set_value(s, {add(s, "text", Kind::text), fn::text}, Text(verse));
  EXPECT_GE(size_of(s).bytes - one, verse.size());
}

}  // namespace
}  // namespace betwixt
