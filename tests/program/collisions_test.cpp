// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Compares objects among obstacles with closed forms.
#include <cmath>

#include "support/any_order.h"

namespace betwixt {
namespace {

constexpr double close = 1e-7;  // an object stops up to a flick before it touches

std::string at(double seconds) { return fmt::format("{}s", seconds); }

LoadedFilm towards_wall(std::string_view collision) {
  return LoadedFilm(fmt::format(
      "rate 24\ncreate wall box size=(1 4 4) position=(4 0 0)\ncreate ball sphere radius=0.5 obstacles=(wall) "
      "collision={}\nball.position\n  1f (0 0 0) linear\n  49f (8 0 0) linear\n  97f (0 0 0)\n",
      collision));
}

// shows: G51 S4 G51
TEST(Collisions, StopAtTheSurfaceUntilTheTrackComesBack) {
  for (const char* how : {"stop", "slide"}) {
    const LoadedFilm s = towards_wall(how);
    EXPECT_TRUE(s.frame("25f").problems.empty());
    for (const double t : {0.1, 0.5, 0.74}) expect_numbers(s, "ball.position", at(t), {4 * t, 0, 0}, 0);
    for (const double t : {0.75, 1.0, 2.0, 3.0, 3.25}) expect_numbers(s, "ball.position", at(t), {3, 0, 0}, close);
    for (const double t : {3.3, 3.5, 4.0, 9.0})
      expect_numbers(s, "ball.position", at(t), {std::max(0.0, 16 - 4 * t), 0, 0}, 1e-12);
  }
}

TEST(Collisions, MirrorTheRestOfTheTrack) {
  const LoadedFilm s = towards_wall("mirror");
  for (const double t : {0.8, 1.3, 2.0}) expect_numbers(s, "ball.position", at(t), {6 - 4 * t, 0, 0}, close);
  expect_numbers(s, "ball.position", "3s", {2, 0, 0}, close);  // back towards the wall, as the track goes back
}

// After a bounce the object moves on by itself, also where the track turns or ends.
TEST(Collisions, BounceAndKeepTheirSpeed) {
  const LoadedFilm s = towards_wall("bounce bounciness=0.5");
  for (const double t : {0.8, 1.3, 2.0, 3.1, 7.5})
    expect_numbers(s, "ball.position", at(t), {3 - 2 * (t - 0.75), 0, 0}, close);
}

// A ball that falls on a floor: parabolas between the times of the bounces.
TEST(Collisions, AFallingBallBouncesAsPhysicsSays) {
  const LoadedFilm s(
      "rate 24\ncreate floor box size=(20 1 20) position=(0 -0.5 0)\n"
      "create ball sphere radius=0.5 obstacles=(floor) collision=bounce bounciness=0.8 position=(0 5.5 0)\n"
      "at 0s fall ball\n");
  const double g = 9.81;
  const auto height = [&](double t) {
    double up = std::sqrt(2 * g * 5), from = std::sqrt(2 * 5 / g);
    if (t < from) return 5.5 - g / 2 * t * t;
    for (up *= 0.8;; from += 2 * up / g, up *= 0.8)
      if (const double d = t - from; d < 2 * up / g) return 0.5 + up * d - g / 2 * d * d;
  };
  for (double t = 0; t < 6; t += 0.0937) expect_numbers(s, "ball.position", at(t), {0, height(t), 0}, 2e-6);
  // It comes to rest, and stays where the fall has ended.
  expect_numbers(s, {{"ball.position", "9.5s", {0, 0.5, 0}}, {"ball.position", "60s", {0, 0.5, 0}}}, 1e-5);
}

// Between two walls the position is a triangle wave. The other component is that of the track.
TEST(Collisions, OfADiscInAFlatFilm) {
  const LoadedFilm s(
      "rate 24\ncreate d disc radius=0.5 obstacles=(left right) collision=bounce\n"
      "create left rectangle size=(1 9) position=(-3 0 0)\ncreate right rectangle size=(1 9) position=(3 0 0)\n"
      "at 0s d.position.velocity (6 0.2 0)\n");
  for (double t = 0; t < 10; t += 0.217) {
    const double x = std::fmod(6 * t + 2, 8);
    expect_numbers(s, "d.position", at(t), {x < 4 ? x - 2 : 6 - x, 0.2 * t, 0}, 1e-6);
  }
}

// On a slope of 30 degrees: without bounciness, the acceleration is g sin 30 along it.
TEST(Collisions, ABallRollsDownASlope) {
  const LoadedFilm s(
      "rate 24\ncreate ramp box size=(40 1 20) rotation=euler(0 0 -30deg)\ncreate ball sphere radius=0.5 "
      "obstacles=(ramp) collision=bounce bounciness=0 position=(0 2 0)\nat 0s fall ball\n");
  const double angle = pi / 6, gap = (2 * std::cos(angle) - 1) / std::cos(angle);  // of the vertical way to the slope
  const double hits = std::sqrt(2 * gap / 9.81), speed = 9.81 * hits * std::sin(angle);
  const Vec3 down{std::cos(angle), -std::sin(angle), 0}, begin{0, 2 - gap, 0};
  for (const double d : {0.1, 0.5, 1.0, 1.7}) {
    const Vec3 p = begin + (speed * d + 9.81 / 4 * d * d) * down;
    expect_numbers(s, "ball.position", at(hits + d), {p.x, p.y, 0}, 1e-3);  // steps of 1/240 s along the surface
  }
}

// A slide is the point of the free side that is nearest to the track.
TEST(Collisions, SlideAlongTheSurface) {
  const LoadedFilm s(
      "rate 24\ncreate wall box size=(1 40 40) position=(4 0 0) rotation=euler(0 0 20deg)\ncreate crate box "
      "rotation=euler(0 0 20deg) obstacles=(wall) collision=slide\ncrate.position\n  1f (0 -2 0) linear\n  49f (8 2 "
      "1)\n");
  const Vec3 n{-std::cos(pi / 9), -std::sin(pi / 9), 0};
  for (const double t : {1.1, 1.5, 2.0}) {
    const Vec3 p{4 * t, -2 + 2 * t, t / 2};
    const double inside = 1 - dot(p - Vec3{4, 0, 0}, n);
    ASSERT_GT(inside, 0);
    const Vec3 wanted = p + inside * n;
    expect_numbers(s, "crate.position", at(t), {wanted.x, wanted.y, wanted.z}, 1e-6);
  }
}

// A moving obstacle pushes what stands in its way.
TEST(Collisions, AMovingObstaclePushes) {
  const LoadedFilm s(
      "rate 24\ncreate pusher box size=(1 2 2)\npusher.position\n  1f (-3 0 0) linear\n  49f (1 0 0)\n"
      "create crate box obstacles=(pusher) collision=bounce bounciness=0\n");
  expect_numbers(s, {{"crate.position", "12f", {0, 0, 0}}});
  expect_numbers(s, "crate.position", "37f", {1, 0, 0}, 1e-6);
}

TEST(Collisions, InTheSpaceOfAParent) {
  const LoadedFilm s(
      "rate 24\ncreate cart group rotation=euler(0 0 90deg) scale=(2 2 2)\ncreate bead sphere radius=0.25 "
      "obstacles=(gate)\ncouple bead to cart\nbead.position\n  1f (0 0 0) linear\n  49f (4 0 0)\n"
      "create gate box size=(10 0.1 10) position=(0 4 0)\n");
  expect_numbers(s, "bead.position", "2s", {(3.95 - 0.5) / 2, 0, 0}, close);
  expect_place(s, "bead", "2s", {0, 3.45, 0}, close);
}

// A fast object does not pass a thin wall. Bodies of both shapes meet at their surfaces.
TEST(Collisions, OfFastAndThinThings) {
  const LoadedFilm s(
      "rate 24\ncreate bullet sphere radius=0.05 obstacles=(sheet)\ncreate sheet plane size=(4 4) position=(100 0 0) "
      "rotation=euler(0 90deg 0)\nat 0s bullet.position.velocity (400 0 0)\n"
      "create a sphere radius=2 position=(0 0 50) obstacles=(b)\ncreate b sphere position=(9 0.9 50) scale=(2 2 2)\n"
      "at 0s a.position.velocity (30 0 0)\n");
  expect_numbers(s, "bullet.position", "1s", {99.95, 0, 0}, 1e-5);
  expect_numbers(s, "a.position", "1s", {9 - std::sqrt(16 - 0.81), 0, 50}, 1e-6);
}

// Tracks switch obstacles and laws. Without obstacles an object returns to its track.
TEST(Collisions, LawsChangeAtEvents) {
  const LoadedFilm s(
      "rate 24\ncreate wall box size=(1 4 4) position=(4 0 0)\ncreate ball sphere radius=0.5 obstacles=(wall)\n"
      "ball.position\n  1f (0 0 0) linear\n  49f (8 0 0)\nball.obstacles\n  1f (wall)\n  37f none\n");
  expect_numbers(s, "ball.position", "1.4s", {3, 0, 0}, close);
  expect_numbers(s, "ball.position", "1.6s", {6.4, 0, 0}, 1e-9);
}

// The same bits in any order, from any thread.
TEST(Collisions, DoNotDependOnTheOrderOfQuestions) {
  const std::string text =
      "rate 24\ncreate floor box size=(20 1 20) position=(0 -0.5 0)\ncreate wall box size=(1 9 9) position=(3 0 0)\n"
      "create ball sphere radius=0.5 obstacles=(floor wall) collision=bounce bounciness=0.9 position=(0 5.5 0)\n"
      "at 0s ball.position.velocity.x 3\nat 0s fall ball\ncreate echo sphere\nset echo.position = "
      "\"value('ball.position', t - 0.5)\"\n";
  expect_same_in_any_order(text, "ball.position", {4.31, 0.2, 7.77, 1.001, 3.3333, 4.3, 0.9});
  const LoadedFilm s(text);
  EXPECT_EQ(s.read("echo.position", "4.8s"), s.read("ball.position", "4.3s"));
}

TEST(Collisions, AnObstacleThatFollowsTheObjectIsACircle) {
  const LoadedFilm s(
      "rate 24\ncreate b sphere position=(3 0 0)\ncreate a sphere obstacles=(b)\nset b.position = "
      "\"value('a.position')\"\nat 0s a.position.velocity (1 0 0)\n");
  const Frame f = s.frame("13f");
  ASSERT_FALSE(f.problems.empty());
  EXPECT_NE(f.problems[0].find("they must not depend on its place"), std::string::npos) << f.problems[0];
  expect_numbers(s, "a.position", "13f", {0.5, 0, 0});
}

TEST(Collisions, AreCheckedForNamesAndShapes) {
  const auto said = [](const std::string& text) { return betwixt::said(read(text).diagnostics); };
  EXPECT_NE(said("create a sphere obstacles=(wal)\n").find("'wal' is an obstacle of a, but does not exist"),
            std::string::npos);
  EXPECT_NE(said("create g group\ncreate a sphere obstacles=(g)\n").find("g has no shape, so it is no obstacle of a"),
            std::string::npos);
  EXPECT_NE(said("create b box\ncreate g group obstacles=(b)\n").find("g has obstacles, but no shape"),
            std::string::npos);
  EXPECT_NE(said("create a sphere collision=boing\n").find("boing"), std::string::npos);
  EXPECT_NE(said("create a sphere bounciness=2\n").find("test.bx:1:"), std::string::npos);
}

TEST(Collisions, AreWrittenAndFollowNewNames) {
  const LoadedFilm s(
      "create wall box size=(1 4 4) position=(4 0 0)\ncreate ball sphere radius=0.5 obstacles=(wall) collision=bounce "
      "bounciness=0.5\nball.position\n  1f (0 0 0) linear\n  49f (8 0 0)\nrename wall fence\n");
  const LoadedFilm again(write(s.loaded.document));
  EXPECT_EQ(**std::get_if<Names>(&static_cast<const Value&>(again.read("ball.obstacles", "1f"))),
            std::vector<std::string>{"fence"});
  EXPECT_EQ(again.read("ball.position", "40f"), s.read("ball.position", "40f"));
}

}  // namespace
}  // namespace betwixt
