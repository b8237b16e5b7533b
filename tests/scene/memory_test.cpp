// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "scene/memory.h"

#include <gtest/gtest.h>

#include "scene/rig.h"
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

// shows: G90 G100
TEST(SceneSize, AnEventTakesTheSameWhateverItsType) {
  const auto bytes_each = [](FunctionId f, const Value& v) {
    const auto scene_with = [&](int events) {
      Scene s;
      const ObjectId ball = add(s, "ball");
      for (int k = 0; k < events; ++k) {
        put_event(s, {ball, f}, event(k, v));
      }
      return size_of(s).bytes;
    };
    return static_cast<double>(scene_with(6400) - scene_with(1280)) / 5120;
  };
  const double number = bytes_each(fn::radius, 1.0);
  // Large values are apart, and those that are equal are stored once.
  const std::vector<std::pair<FunctionId, Value>> others{{fn::position, Vec3{1, 2, 3}},
                                                         {fn::color, Color{1, 0, 0}},
                                                         {fn::rotation, Quat{}},
                                                         {fn::display, true},
                                                         {fn::text, Text(std::string(5000, 'x'))},
                                                         {fn::points, Points(std::vector<Vec3>(5000))},
                                                         {fn::transform, Matrix(Mat4())}};
  for (const auto& [f, v] : others) EXPECT_NEAR(bytes_each(f, v), number, 0.01) << f;
  EXPECT_LE(number, 65);
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

// Two meshes of three vertices wear one picture.
TEST(ContentBytes, CountsOnceWhatManyShare) {
  const auto picture = std::make_shared<const Picture>(Picture{2, 3, std::vector<std::uint8_t>(24)});
  Mesh m;
  m.positions = m.normals = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  m.triangles = {0, 1, 2};
  m.parts = {{0, 3, {1, 1, 1}, picture, true}};
  const std::size_t of_mesh = 3 * (12 + 12 + 4) + sizeof(MeshPart);
  const auto one = std::make_shared<const Mesh>(m), other = std::make_shared<const Mesh>(m);
  ContentBytes all;
  all.add(one);
  EXPECT_EQ(all.sum(), of_mesh + 24);
  all.add(one), all.add(picture);
  EXPECT_EQ(all.sum(), of_mesh + 24);
  all.add(other);
  EXPECT_EQ(all.sum(), 2 * of_mesh + 24);
  Rig rig;
  rig.joints.resize(3), rig.weights.resize(3), rig.inverse_bind.resize(2);
  rig.targets = {{"smile", m.positions, {}}};
  m.rig = std::make_shared<const Rig>(rig);
  all.add(std::make_shared<const Mesh>(m));
  EXPECT_EQ(all.sum(), 3 * of_mesh + 24 + 3 * (8 + 16 + 12) + 2 * sizeof(Mat4));
  auto sound = std::make_shared<Sound>();
  sound->energy.resize(5), sound->onsets.resize(2);
  const std::size_t before = all.sum();
  all.add(std::shared_ptr<const Sound>(sound));
  EXPECT_EQ(all.sum(), before + 7 * 8);
}

// Points that only a display list has, and code that nothing calls.
TEST(ValueBytes, CountsAllThatTheSceneHolds) {
  Scene s;
  edit_list(s, "tree", Time{}).commands.put(0, {Drawing::polygon, Points({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}), {}});
  EXPECT_EQ(bytes_of_values(s), 3 * sizeof(Vec3));
  s.pictures.edit()["a.png"] = std::make_shared<const Picture>(Picture{2, 3, std::vector<std::uint8_t>(24)});
  s.pictures.edit()["./a.png"] = s.pictures->at("a.png");
  EXPECT_EQ(bytes_of_values(s), 3 * sizeof(Vec3) + 24);
}

}  // namespace
}  // namespace betwixt
