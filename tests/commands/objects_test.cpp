// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests how objects are created, copied and renamed.
#include "betwixt/object.h"
#include "support/loaded_film.h"

namespace betwixt {
namespace {

// shows: G18
TEST(Objects, CreateAndLike) {
  const LoadedFilm s(
      "create ball{1..100} sphere radius=2\ncreate {left,right}-eye sphere\nball7.position.x\n 1f 7\n"
      "create twin like ball7\nset twin.radius 3\nball7.position.x\n 1f 8\n");
  expect_numbers(s, {{"ball100.radius", "1f", {2}},
                     {"twin.position.x", "1f", {7}},
                     {"twin.radius", "1f", {3}},
                     {"ball7.radius", "1f", {2}}});
  EXPECT_EQ(s.loaded.document.names().size(), 103u);
  EXPECT_EQ(s.loaded.document.names()[99], "ball100");
}

// shows: G26 G28
TEST(Objects, EveryKindHasItsParameters) {
  const LoadedFilm s(
      "create a group\ncreate b sphere radius=2\ncreate c box size=(1 2 3)\ncreate d cylinder radius=1 height=2\n"
      "create e cone radius=1 height=2\ncreate f torus radius=1 tube=0.3\ncreate g plane size=(1 2)\n"
      "create h disc radius=3\ncreate i polygon points=((0 0) (1 0) (0 1))\ncreate j polyline points=((0 0) (1 1)) "
      "width=1\n"
      "create k points points=((0 0 1)) size=1\ncreate l text text=\"x\"\ncreate m light\ncreate n camera\n");
  EXPECT_EQ(s.loaded.document.names().size(), 14u);
  EXPECT_EQ(s.program.frame({}).items.size(), 11u);
  expect_numbers(s, {{"f.tube", "1f", {0.3}}, {"n.lens", "1f", {35}}, {"m.range", "1f", {20}}});
}

// One kind has two names, and messages use the usual one.
TEST(Objects, ADiscIsACircle) {
  const LoadedFilm s("create a circle radius=2\ncreate b disc radius=2\n");
  for (const ObjectId id : objects(s.loaded.document)) EXPECT_EQ(name_of(kind(s.loaded.document, id)), "circle");
  expect_numbers(s, {{"a.radius", "1f", {2}}, {"b.radius", "1f", {2}}});
}

// shows: G18
TEST(Objects, RenameKeepsWhatSpeaksOfIt) {
  const LoadedFilm s(
      "create a sphere position=(1 2 3)\ncreate eye camera look-at=a\ncreate b box\nset b.geometry shape(a)\n"
      "alias both = a b\nrename a c\nset both.radius 1\nset both.color red\nremove b\n");
  EXPECT_EQ(s.loaded.document.names(), (std::vector<std::string>{"c", "eye"}));
  EXPECT_EQ(std::get<ObjectId>(s.read("eye.look-at", "1f")), s.loaded.document.find("c"));
  expect_numbers(s, "c.color", "1f", {1, 0, 0});
}

}  // namespace
}  // namespace betwixt
