// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "scene/document.h"

#include <gtest/gtest.h>

#include "scene/mentions.h"
#include "support/objects.h"

namespace betwixt {
namespace {

std::vector<std::string> named(const Scene& s, std::string_view word) {
  std::vector<std::string> out;
  for (ObjectId id : select(s, word)) out.push_back(s.objects[id.index].name);
  return out;
}
using Words = std::vector<std::string>;

// shows: G60
TEST(Scene, EditingACopyLeavesTheOriginal) {
  Scene a;
  std::vector<ObjectId> ids;
  for (int i = 0; i < 300; ++i) ids.push_back(add(a, "b" + std::to_string(i)));
  put_event(a, {ids[7], fn::position}, event(0, Vec3{1, 2, 3}));
  a.aliases.edit()["all"] = {"b*"};
  const Scene kept = a;
  Scene again = a;
  EXPECT_TRUE(same(a, kept));
  put_event(a, {ids[7], fn::position}, event(1, Vec3{}));
  EXPECT_FALSE(same(a, kept));
  EXPECT_TRUE(same(again, kept));
  put_event(again, {ids[7], fn::position, 1}, event(1, 5.0));
  set_value(again, {ids[250], fn::radius}, 2.0);
  add(again, "more");
  remove_objects(again, {ids[0]}, all_of(again.objects));
  again.aliases.edit()["all"] = {"x"};
  EXPECT_EQ(kept.objects.size(), 300U);
  EXPECT_EQ(tracks_of(kept, {ids[7], fn::position}).size(), 1U);
  EXPECT_EQ(tracks_of(kept, {ids[7], fn::position})[0]->events.size(), 1U);
  EXPECT_EQ(kept.objects[250].find(fn::radius), nullptr);
  EXPECT_TRUE(kept.names.find("b0"));
  EXPECT_FALSE(kept.names.find("more"));
  EXPECT_EQ(kept.aliases->at("all"), Words{"b*"});
}

TEST(Scene, ComponentsTakeTheirPartOfWholeEvents) {
  Scene s;
  const ObjectId id = add(s, "ball");
  put_event(s, {id, fn::position, 1}, event(0, 5.0));
  put_event(s, {id, fn::position}, event(1, Vec3{1, 2, 3}));
  const auto tracks = tracks_of(s, {id, fn::position});
  ASSERT_EQ(tracks.size(), 3U);
  EXPECT_EQ(tracks[0]->events.size(), 1U);
  EXPECT_EQ(tracks[1]->events.size(), 2U);
  EXPECT_EQ(std::get<double>(tracks[2]->events.front().value), 3);
  EXPECT_EQ(tracks_of(s, {id, fn::position, 1})[0]->events.size(), 2U);
  set_value(s, {id, fn::scale, 2}, 4.0);
  EXPECT_EQ(std::get<Vec3>(*s.objects[id.index].find(fn::scale)->set), (Vec3{1, 1, 4}));
}

TEST(Scene, RemovedObjectsAreGoneEverywhere) {
  Scene s;
  const ObjectId car = add(s, "car", Kind::group), wheel = add(s, "car/wheel", Kind::sphere, car),
                 eye = add(s, "eye", Kind::camera);
  s.cuts.edit()[Time{}] = eye;
  s.objects.edit(car.index).leads = true;
  EXPECT_EQ(circle(s, car, wheel, {INT64_MIN}, {INT64_MAX}), (std::vector<ObjectId>{car, wheel}));
  EXPECT_TRUE(circle(s, wheel, car, {INT64_MIN}, {INT64_MAX}).empty());
  remove_objects(s, {car, eye, car}, all_of(s.objects));
  EXPECT_FALSE(s.names.find("car"));
  EXPECT_FALSE(s.objects[wheel.index].find(fn::attachment)->set);
  EXPECT_TRUE(s.cuts->empty());
  const ObjectId again = add(s, "car");
  EXPECT_NE(again, car);  // numbers are never given out twice
  remove_objects(s, {car}, all_of(s.objects));
  EXPECT_EQ(s.names.find("car"), again);
  EXPECT_EQ(Document(std::make_shared<const Scene>(s)).names(), (Words{"car/wheel", "car"}));
}

// shows: G64 G65 G66 G67
TEST(Select, ReadsAliasesPatternsAndNames) {
  Scene s;
  for (const char* n : {"wheel10", "wheel2", "spare", "wheel1", "car/wheel3", "ball"}) add(s, n);
  EXPECT_EQ(named(s, "wheel*"), (Words{"wheel1", "wheel2", "wheel10"}));
  EXPECT_EQ(named(s, "{wheel10,wheel*,ball}"), (Words{"wheel10", "wheel1", "wheel2", "ball"}));
  EXPECT_EQ(named(s, "car/*"), Words{"car/wheel3"});
  EXPECT_EQ(named(s, "nobody"), Words{});
  s.aliases.edit()["wheels"] = {"spare", "nobody", "wheel*"};
  EXPECT_EQ(named(s, "wheels"), (Words{"spare", "wheel1", "wheel2", "wheel10"}));
  add(s, "wheel0");  // patterns inside are read at each use
  EXPECT_EQ(named(s, "wheels"), (Words{"spare", "wheel0", "wheel1", "wheel2", "wheel10"}));
  s.aliases.edit()["ball"] = {"spare", "ball"};  // beats the object; inside itself it is the object
  EXPECT_EQ(named(s, "ball"), (Words{"spare", "ball"}));
  s.aliases.edit()["a"] = {"b", "wheel1"};
  s.aliases.edit()["b"] = {"a", "wheel2", "a"};
  EXPECT_EQ(named(s, "a"), (Words{"wheel2", "wheel1"}));
}

TEST(Select, AliasesOfAliasesMayBeDeepAndMany) {
  Scene s;
  add(s, "ball");
  auto& aliases = s.aliases.edit();
  for (int i = 0; i < 20'000; ++i) {
    const std::string next = i == 19'999 ? "ball" : "a" + std::to_string(i + 1);
    aliases["a" + std::to_string(i)] = {next, next};  // twice each: 2 to the power of 20 000, if taken at its word
  }
  EXPECT_EQ(named(s, "a0"), Words{"ball"});
}

TEST(Same, LooksAtContentNotHistory) {
  Scene a, b;
  const ObjectId gone = add(a, "gone");
  const ObjectId pa = add(a, "ball"), qa = add(a, "box", Kind::box, pa), pb = add(b, "ball"),
                 qb = add(b, "box", Kind::box, pb);
  put_event(a, {qa, fn::geometry}, event(0, pa));
  put_event(b, {qb, fn::geometry}, event(0, pb));
  EXPECT_FALSE(same(a, b));
  remove_objects(a, {gone}, all_of(a.objects));
  EXPECT_TRUE(same(a, b));  // although the numbers of the objects differ
  edit_track(a, {pa, fn::color});
  EXPECT_TRUE(same(a, b));  // an empty track is no track
  edit_track(a, {pa, fn::position, 1});
  EXPECT_TRUE(same(a, b));  // nor are three
  put_event(b, {qb, fn::geometry}, event(0, qb));
  EXPECT_FALSE(same(a, b));
  b.rate = {25, 1};
  EXPECT_FALSE(same(a, b));
}

TEST(Document, RangeGoesToTheLastEvent) {
  Scene s;
  EXPECT_EQ(Document(std::make_shared<const Scene>(s)).range(), (std::pair{Time{}, s.rate.frame(24)}));
  EXPECT_EQ(Document(std::make_shared<const Scene>(s)).frame_count(), 24);
  const ObjectId id = add(s, "ball");
  put_event(s, {id, fn::position, 1}, event(2, 0.0));
  EXPECT_EQ(Document(std::make_shared<const Scene>(s)).frame_count(), 49);
  s.rate = {30000, 1001};
  s.range = {s.rate.frame(10), s.rate.frame(1010)};
  const Document d(std::make_shared<const Scene>(s));
  EXPECT_EQ(d.frame_count(), 1001);
  EXPECT_EQ(d.name({id, fn::position, 1}), "ball.position.y");
  EXPECT_EQ(d.name({id, Query::world}), "ball.world");
  EXPECT_EQ(d.name(ObjectId{}), "none");
}

}  // namespace
}  // namespace betwixt
