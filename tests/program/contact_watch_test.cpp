// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "betwixt/contacts.h"
#include "program/contact_scenes.h"
#include "scene/mentions.h"

namespace betwixt {
namespace {

std::vector<std::string> lines(const std::vector<ContactEvent>& events, const Document& d) {
  std::vector<std::string> out;
  for (const ContactEvent& e : events) out.push_back(to_json(e, d));
  return out;
}
void moves(Scene& s, ObjectId id, double t0, Vec3 from, double t1, Vec3 to) {
  Event e;
  e.time = from_seconds(t0), e.value = from, e.twerper = Twerper::linear;
  put_event(s, {id, fn::position}, e);
  e.time = from_seconds(t1), e.value = to;
  put_event(s, {id, fn::position}, e);
}
// Camera that looks along -z, 20 metres high, 32 at 16:9 wide and more.
void add_camera(Scene& s) {
  const ObjectId eye = add(s, "eye", Kind::camera);
  set_value(s, {eye, fn::position}, Vec3{0, 0, 50});
  set_value(s, {eye, fn::camera_height}, 18.0);
}

struct TwoBalls {
  Scene s;
  ObjectId a, b;
};
// Of radius 1, they come from both sides at 1 m a second each, 10 m apart: 10 - 2t = 2 at 4 s, tick 120; they go
// through each other and part at 6 s, when they are 2 m apart for the last time: tick 180. The next one, 181, is the
// first at which they are further apart.
TwoBalls two_balls() {
  TwoBalls t;
  t.a = add(t.s, "a"), t.b = add(t.s, "b");
  add_camera(t.s);
  moves(t.s, t.a, 0, {-5, 0, 0}, 10, {5, 0, 0});
  moves(t.s, t.b, 0, {5, 0, 0}, 10, {-5, 0, 0});
  return t;
}

// shows: C148 C150 C154
TEST(ContactWatch, TwoBallsMeetAndPartWhenTheyMust) {
  const auto [s, a, b] = two_balls();
  const Program p = compile(s);
  ContactWatch watch;
  watch.seek(p.frame({}));
  std::vector<std::string> said;
  for (int tick = 1; tick <= 300; ++tick)
    for (const auto& line : lines(watch.step(p.frame(s.ticks.span(tick))), p.document())) said.push_back(line);
  EXPECT_EQ(said, (std::vector<std::string>{R"({"event":"contact","state":"begin","a":"a","b":"b","tick":120})",
                                            R"({"event":"contact","state":"end","a":"a","b":"b","tick":181})"}));
  // The same as a function of time, in any order.
  EXPECT_TRUE(p.contacts(s.ticks.span(150)).touching(a, b));
  EXPECT_TRUE(p.contacts(s.ticks.span(150)).touching(b, a));
  EXPECT_FALSE(p.contacts(s.ticks.span(119)).touching(a, b));
  EXPECT_EQ(std::get<Names>(p.read({b, Query::touching}, from_seconds(5))), Names(std::vector<std::string>{"a"}));
  EXPECT_EQ(std::get<Names>(p.read({b, Query::touching}, from_seconds(1))), Names());
}

// shows: C148 C150
TEST(ContactWatch, GroupsOfMoreThanTwo) {
  // Three balls in a row, 2 m apart at the end: the outer ones never touch each other.
  Scene s;
  const ObjectId a = add(s, "a"), b = add(s, "b"), c = add(s, "c");
  add_camera(s);
  set_value(s, {a, fn::position}, Vec3{-2, 0, 0});
  moves(s, b, 0, {0, 5, 0}, 1, {0, 0, 0});
  set_value(s, {c, fn::position}, Vec3{2, 0, 0});
  const Program p = compile(s);
  ContactWatch watch;
  watch.seek(p.frame({}));
  EXPECT_TRUE(watch.now().groups.empty());
  EXPECT_EQ(
      lines(watch.step(p.frame(from_seconds(1))), p.document()),
      (std::vector<std::string>{
          R"({"event":"contact","state":"begin","a":"a","b":"b","tick":30})",
          R"({"event":"contact","state":"begin","a":"b","b":"c","tick":30})",
          R"({"event":"group","state":"begin","objects":["a","b","c"],"pairs":[["a","b"],["b","c"]],"tick":30})"}));
  // The host takes the middle one away at the same tick: all ends.
  Scene without = s;
  remove_objects(without, {b}, all_of(without.objects));
  const Program q = compile(without);
  EXPECT_EQ(lines(watch.step(q.frame(from_seconds(1))), q.document()),
            (std::vector<std::string>{
                R"({"event":"contact","state":"end","a":"a","b":"b","tick":30})",
                R"({"event":"contact","state":"end","a":"b","b":"c","tick":30})",
                R"({"event":"group","state":"end","objects":["a","b","c"],"pairs":[["a","b"],["b","c"]],"tick":30})",
                R"({"event":"view","object":"b","state":"out","tick":30})"}));
}

// The picture is 18 m high and 32 m wide: its right side is at x = 16. A ball of radius 1 at x = 10 + 2t, later back.
// Its box reaches 16 at t = 2.5 s (tick 75), its other side at 3.5 s (105, still touching): out from 106. It turns
// round at 5 s, x = 20, and touches again when 20 - 2u = 17: 1.5 s later, tick 195; in from behind x = 15, 2.5 s later
// (225, still touching): 226.
// shows: C149 C150
TEST(ContactWatch, LeavingAndComingBack) {
  Scene s;
  const ObjectId ball = add(s, "ball");
  add_camera(s);
  moves(s, ball, 0, {10, 0, 0}, 5, {20, 0, 0});
  moves(s, ball, 5, {20, 0, 0}, 10, {10, 0, 0});
  const Program p = compile(s);
  ContactWatch watch;
  std::vector<std::string> said;
  for (int tick = 0; tick <= 300; ++tick)
    for (const auto& line : lines(watch.step(p.frame(s.ticks.span(tick))), p.document())) said.push_back(line);
  EXPECT_EQ(said, (std::vector<std::string>{R"({"event":"view","object":"ball","state":"in","tick":0})",
                                            R"({"event":"view","object":"ball","state":"boundary","tick":75})",
                                            R"({"event":"view","object":"ball","state":"out","tick":106})",
                                            R"({"event":"view","object":"ball","state":"boundary","tick":195})",
                                            R"({"event":"view","object":"ball","state":"in","tick":226})"}));
  EXPECT_EQ(std::get<bool>(p.read({ball, Query::in_view}, from_seconds(3))), true);
  EXPECT_EQ(std::get<bool>(p.read({ball, Query::in_view}, from_seconds(4))), false);
}

// shows: C150 C151
TEST(ContactWatch, ASeekSaysNothingAndKnowsAll) {
  const auto [s, a, b] = two_balls();
  const Program p = compile(s);
  ContactWatch watch;
  for (const double t : {5.0, 0.0, 9.0, 5.0, 5.0}) {
    watch.seek(p.frame(from_seconds(t)));
    EXPECT_EQ(watch.now().touching(a, b), t == 5);
    EXPECT_EQ(watch.now().sight(a), Sight::in);
  }
  EXPECT_TRUE(watch.step(p.frame(from_seconds(5.1))).empty());
  EXPECT_TRUE(watch.step(p.frame(from_seconds(1))).empty());  // backwards: a seek
  EXPECT_FALSE(watch.now().touching(a, b));
  EXPECT_EQ(watch.step(p.frame(from_seconds(5))).size(), 1U);
}

}  // namespace
}  // namespace betwixt
