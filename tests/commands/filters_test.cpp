// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Compares filters of tracks with closed forms.
#include <cmath>

#include "betwixt/track.h"
#include "support/loaded_film.h"

namespace betwixt {
namespace {

// shows: G105 R-T16
TEST(Filters, KeepToTheirSegmentAndComponent) {
  const LoadedFilm s(
      "rate 24\ncreate a sphere\na.position\n  1f (0 0 0) linear\n  73f (3 6 9)\n"
      "filter a.position.y delay by=12f 25f..49f\nfilter a.position.z limit high=4\n");
  expect_numbers(s, "a.position", "13f", {0.5, 1, 1.5}, 1e-9);
  expect_numbers(s, "a.position", "25f", {1, 1, 3}, 1e-9);
  expect_numbers(s, "a.position", "49f", {2, 3, 4}, 1e-9);
  expect_numbers(s, "a.position", "50f", {49 / 24.0, 49 / 12.0, 4}, 1e-9);
  // In the order they were put on; none takes them off.
  const std::string twice = "rate 24\ncreate a sphere\na.radius\n  1f 1 linear\n  73f 4\n";
  expect_numbers(LoadedFilm(twice + "filter a.radius delay by=24f\nfilter a.radius limit low=3\n"), "a.radius", "61f",
                 {3});
  expect_numbers(LoadedFilm(twice + "filter a.radius limit low=3\nfilter a.radius delay by=24f\n"), "a.radius", "85f",
                 {3.5});
  expect_numbers(LoadedFilm(twice + "filter a.radius limit low=3\nfilter a.radius none\n"), "a.radius", "25f", {2});
}

// A filter that is off is as if it were not there, but it stays in the film with its numbers.
TEST(Filters, AreSwitchedOff) {
  const std::string track = "rate 24\ncreate {a,b} sphere\na.radius\n  1f 1 linear\n  73f 4\n";
  for (const char* filter : {"limit low=3 off", "limit off low=3", "delay by=24f off 1f..96f"})
    expect_numbers(LoadedFilm(track + "filter a.radius " + filter + "\n"), "a.radius", "25f", {2});
  // The others act as before.
  expect_numbers(LoadedFilm(track + "filter a.radius delay by=24f\nfilter a.radius limit low=3 off\n"), "a.radius",
                 "61f", {2.5});
  expect_numbers(LoadedFilm(track + "filter a.radius delay by=24f off\nfilter a.radius limit low=3\n"), "a.radius",
                 "61f", {3.5});
  const LoadedFilm kept(track + "filter a.radius limit low=3 off\n");
  const std::string text = write(kept.loaded.document);
  EXPECT_NE(text.find("filter a.radius limit low=3 off\n"), std::string::npos) << text;
  EXPECT_EQ(write(read(text).document), text);
  const Target target = find_targets("a.radius", kept.loaded.document)->front();
  ASSERT_EQ(filters(kept.loaded.document, target).size(), 1U);
  EXPECT_TRUE(filters(kept.loaded.document, target)[0].off);
  // A program that was compiled before sees the change.
  const Document on = read(track + "filter a.radius limit low=3\n").document;
  EXPECT_EQ(std::get<double>(Program::compile(kept.loaded.document, Program::compile(on)).read(target, Time{0})), 1);
}

// shows: G16
TEST(Filters, AreLimitsThatAnObjectBringsAlong) {
  const LoadedFilm s(
      "rate 24\ncreate arm group\ncreate elbow group\nfilter elbow.rotation.z limit low=0 high=150deg\n"
      "filter elbow.position limit low=-1 high=1\ncreate other like elbow\nrename elbow human-elbow\n"
      "*.rotation.z\n  1f -30deg linear\n  73f 330deg\nset *.position (-2 0.5 2)\n");
  const double degree = std::acos(-1.0) / 180;
  const auto z = [&](const char* name, const char* time) {
    return s.numbers(std::string(name) + ".rotation.z", time)[0] / degree;
  };
  for (const char* name : {"human-elbow", "other"}) {
    EXPECT_EQ(z(name, "1f"), 0) << name;
    EXPECT_NEAR(z(name, "25f"), 90, 1e-9) << name;
    EXPECT_NEAR(z(name, "73f"), 150, 1e-9) << name;
    expect_numbers(s, std::string(name) + ".position", "9f", {-1, 0.5, 1});
  }
  EXPECT_NEAR(z("arm", "73f"), 330, 1e-9);  // what has none goes on
  expect_numbers(s, "arm.position", "9f", {-2, 0.5, 2});
}

TEST(Filters, WhatTheyAreToldOfAnglesAreAngles) {
  const LoadedFilm s(
      "create b box\nb.rotation.z\n  1f 0deg linear\n  25f 180deg\nfilter b.rotation.z limit high=90deg\n"
      "create c camera\nset c.fov 50deg\nfilter c.fov limit low=60deg\n");
  expect_numbers(s, {{"b.rotation.z", "25f", {pi / 2}}, {"b.rotation.z", "7f", {pi / 4}}, {"c.fov", "1f", {pi / 3}}});
  EXPECT_EQ(all_told(read("create b box\nfilter b.rotation.z limit high=90\n")),
            std::vector<std::string>{"type 2:32 90"});
  // Written and read again it is the same.
  const std::string text = write(s.loaded.document);
  EXPECT_NE(text.find("limit high=90deg"), std::string::npos) << text;
  EXPECT_EQ(write(read(text).document), text);
}

TEST(Filters, OfAnOrientationThereIsNoLimit) {
  const LoadedFilm s("create b box\nset b.rotation axis(0 1 0, 90deg)\nfilter b.rotation limit high=10deg\n");
  const auto problems = s.frame("1f").problems;
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_NE(problems[0].find("an orientation has no separate angles"), std::string::npos) << problems[0];
}

TEST(Filters, PointsComeLater) {
  const LoadedFilm s(
      "create c polyline\nc.points\n  1f ((0 0 0) (1 0 0)) linear\n  25f ((0 0 0) (1 24 0))\nfilter c.points delay "
      "by=12f\n");
  const auto points = [&](const char* t) { return (*std::get<Points>(s.read("c.points", t)))[1].y; };
  EXPECT_NEAR(points("19f"), 6, 1e-9);
  EXPECT_NEAR(points("25f"), 12, 1e-9);
  EXPECT_NEAR(points("37f"), 24, 1e-9);
}

TEST(Filters, AndLayersMixLight) {
  const LoadedFilm s(
      "create b box\nset b.color black\nlayer l mix weight=0.5\non l set b.color white\n"
      "create q{1..3} box\nspread q*.color from black to white\n");
  // Half of the light: sRGB 0.7354 (by its definition: 1.055 0.5^(1/2.4) - 0.055).
  const double half = 1.055 * std::pow(0.5, 1 / 2.4) - 0.055;
  for (const char* target : {"b.color", "q2.color"}) expect_numbers(s, target, "1f", {half, half, half}, 1e-9);
}

TEST(Filters, PlainNumbersHaveNoUnit) {
  const auto first = [](const std::string& filter) {
    return told("create b sphere\nb.position\n  1f (0 0 0)\nfilter b.position " + filter + "\n");
  };
  EXPECT_EQ(first("wobble amount=0.1 frequency=3f"), "type 4:47 3f");
  EXPECT_EQ(first("noise seed=5f"), "type 4:30 5f");
  EXPECT_EQ(first("wobble amount=0.1 frequency=3"), "");
  EXPECT_EQ(first("wobble amount=.1 frequency=3."), "");
  EXPECT_EQ(first("smooth width=3f"), "");
}

}  // namespace
}  // namespace betwixt
