// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "program/compiled.h"
#include "program/programs.h"
#include "scene/mentions.h"

namespace betwixt {
namespace {

// shows: G61 G80 G85
TEST(World, IsTheProductDownTheChain) {
  Scene s;
  const ObjectId car = add(s, "car", Kind::group), wheel = add(s, "car/wheel", Kind::cylinder, car);
  put_event(s, {car, fn::position}, event(0, Vec3{0, 0, 0}, Twerper::linear));
  put_event(s, {car, fn::position}, event(2, Vec3{4, 0, 0}));
  set_value(s, {car, fn::rotation}, Angles{{0, pi / 2, 0}});
  set_value(s, {car, fn::scale}, Vec3{2, 3, 4});
  set_value(s, {wheel, fn::position}, Vec3{1, 2, 3});
  set_value(s, {wheel, fn::attach_position}, Vec3{0.5, 0, 0});
  set_value(s, {wheel, fn::rotation}, axis_angle({1, 0, 0}, 0.7));
  set_value(s, {wheel, fn::pivot}, Vec3{0, 1, 0});
  set_value(s, {wheel, fn::scale}, Vec3{1, 2, 1});
  const Program p = compile(s);
  const Mat4 parent = translation({2, 0, 0}) * rotation(axis_angle({0, 1, 0}, pi / 2)) * scaling({2, 3, 4});
  const Mat4 own = translation({1.5, 2, 3}) * translation({0, 1, 0}) * rotation(axis_angle({1, 0, 0}, 0.7)) *
                   scaling({1, 2, 1}) * translation({0, -1, 0});
  expect_near(world(p, car, 1), parent);
  expect_near(world(p, wheel, 1), parent * own);
  // By hand: the car's y axis stays up, three times as long; the pivot does not turn: (1.5, 3, 3) in the car.
  expect_near(transform_point(world(p, wheel, 1), {0, 1, 0}), {2 + 4 * 3, 9, -2 * 1.5});
  // Free: the place on the parent does not count.
  Scene free = s;
  remove_objects(free, {car}, all_of(free.objects));
  expect_near(world(compile(free), wheel, 1), translation({-0.5, 0, 0}) * own);
}

TEST(World, AnglesTurnAboutXThenYThenZOfTheObject) {
  Scene s;
  const ObjectId id = add(s, "ball");
  set_value(s, {id, fn::rotation}, Angles{{0.3, 0.5, 0.7}});
  const auto about = [](int i, double a) {
    Mat4 m;
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    m(j, j) = m(k, k) = std::cos(a), m(k, j) = std::sin(a), m(j, k) = -std::sin(a);
    return m;
  };
  expect_near(world(compile(s), id), about(0, 0.3) * about(1, 0.5) * about(2, 0.7));
}

// shows: G85
TEST(World, ChainsMayBeDeepAndParentsYoungerThanChildren) {
  Scene s;
  constexpr std::uint32_t n = 100'000;
  for (std::uint32_t i = 0; i < n; ++i)  // each on the one made after it
    set_value(s,
              {add(s, "b" + std::to_string(i), Kind::sphere, i + 1 < n ? ObjectId{i + 1} : ObjectId{}), fn::position},
              Vec3{0, 1, 0});
  const Program p = compile(s);
  const Frame f = p.frame({});
  ASSERT_EQ(f.items.size(), n);
  EXPECT_EQ(f.items[0].id, ObjectId{0});
  EXPECT_EQ(translation_of(f.items[0].world).y, n);
  EXPECT_EQ(translation_of(f.items[n - 1].world).y, 1);
}

}  // namespace
}  // namespace betwixt
