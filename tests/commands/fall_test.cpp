// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Compares falls with closed forms.
#include "support/loaded_film.h"

namespace betwixt {
namespace {

// shows: G12 G5
TEST(Fall, StandsBesideLinesAndCurvesOnOneTrack) {
  const LoadedFilm s(
      "rate 24\ncreate ball sphere\nball.position.y\n  1f 2 linear\n  25f 8 linear\n  49f 6\n  73f 8\n  97f 14 hold\n"
      "  121f 10\nat 121f fall ball gravity=10 for 1s\n");
  const auto y = [&](const char* time, double wanted) { expect_numbers(s, "ball.position.y", time, {wanted}, 1e-9); };
  y("7f", 3.5), y("19f", 6.5), y("31f", 7.5), y("43f", 6.5);  // lines, with a corner between them
  y("61f", 6.5);                                              // curves: from rest at 49f on
  y("85f", 10.75);                                            // no further than to the hold
  y("109f", 14);
  y("121f", 10), y("133f", 8.75), y("145f", 5);  // and a fall
}

// shows: G4 G3 G5 G52
TEST(Fall, IsHalfATSquaredAfterItsDelay) {
  const LoadedFilm s(
      "rate 24\ncreate ball sphere\nball.position\n  1f (0 5 0) linear\n  49f (4 5 0) linear\n"
      "at 1f fall ball delay=1s gravity=10 bounce=0.5 for 8s\n");
  const auto y = [](double t) {
    if (t < 1) return 5.0;  // walking on air
    if (t < 2) return 5 - 5 * (t - 1) * (t - 1);
    double at = 2, speed = 5;
    while (t >= at + speed / 5) at += speed / 5, speed /= 2;
    return speed * (t - at) - 5 * (t - at) * (t - at);
  };
  for (int k = 0; k <= 90; ++k) {
    const double t = k / 24.0;
    expect_numbers(s, "ball.position.y", fmt::format("{}f", k + 1), {y(t)}, 1e-6);
    if (t < 3.8) expect_numbers(s, "ball.position.x", fmt::format("{}f", k + 1), {2 * t}, 1e-9);
  }
  expect_numbers(s, "ball.position.y", "9s", {0}, 1e-3);  // it lies
  expect_numbers(s, "ball.position.x", "2s", {4}, 1e-9);
  // Plain events: no procedure is left.
  EXPECT_EQ(write(s.loaded.document).find("= \""), std::string::npos);
}

// At the last event of its track an object also continues with its speed for a while, and then falls with that speed.
// That holds for every kind of track: whole or by components, linear or curved, by values or by a velocity that is
// released there, and with a hold. shows: G4 G52
TEST(Fall, GoesOnAsItCameWhereItsTrackEnds) {
  struct Case {
    std::string rows;
    Vec3 end, speed;
  };
  const Case cases[] = {
      {"b.position\n  1f (0 8 0) linear\n  49f (4 8 6)\n", {4, 8, 6}, {2, 0, 3}},
      {"b.position\n  1f (0 8 0)\n  49f (4 8 6)\n", {4, 8, 6}, {2, 0, 3}},
      {"b.position.x\n  1f 0 linear\n  49f 4\nb.position.y\n  1f 8\n  97f 8\n", {4, 8, 0}, {2, 0, 0}},
      {"b.position\n  1f (0 8 0) hermite\n  49f (4 8 6) tangent-in=(3 1 -2)\n", {4, 8, 6}, {3, 1, -2}},
      {"b.position\n  1f (0 8 0) bezier(0 0 0.5 0)\n  49f (4 8 6)\n", {4, 8, 6}, {4, 0, 6}},
      {"b.position\n  1f (0 8 0) linear\n  49f (4 8 6) hold\n  97f (0 0 0)\n", {4, 8, 6}, {2, 0, 3}},
      {"b.position\n  1f (0 8 0) linear\n  49f (4 8 6) ease-in=48f\n", {4, 8, 6}, {0, 0, 0}},
      {"b.position\n  1f (0 8 0) hold\n  49f (4 8 6)\n", {4, 8, 6}, {0, 0, 0}},
      {"set b.position (0 8 0)\nat 1f b.position.velocity (2 0 3)\nat 49f b.position.velocity release\n",
       {4, 8, 6},
       {2, 0, 3}},
      {"set b.position (0 8 0)\nb.position.x.velocity\n  1f 1 hold\n  25f 3\nat 49f b.position.x.velocity release\n",
       {4, 8, 0},
       {3, 0, 0}}};
  for (const Case& c : cases)
    for (const double delay : {0.0, 2.0}) {
      const LoadedFilm s("rate 24\ncreate b sphere\n" + c.rows +
                         fmt::format("at 49f fall b delay={}s gravity=10 ground=-100 for 1s\n", delay));
      for (const double t : {0.0, 0.5, 1.0, 1.9, 2.0, 2.25, 2.9}) {
        const double d = t - delay;
        if (d > 1) continue;
        const double y = delay > 0 ? (d > 0 ? -5 * d * d : 0) : c.speed.y * t - 5 * t * t;
        expect_place(s, "b", fmt::format("{}s", 2 + t), c.end + Vec3{t * c.speed.x, y, t * c.speed.z}, 1e-6);
      }
      // Nothing changes before the fall.
      const LoadedFilm before("rate 24\ncreate b sphere\n" + c.rows);
      for (const char* time : {"1f", "9f", "30f", "48f"})
        expect_numbers(s, "b.position", time, before.numbers("b.position", time), 1e-9);
    }
}

// A second fall continues the first one if the object still falls, but an object at rest does not fall again.
TEST(Fall, FallsOnWhereAnotherOneEnds) {
  const std::string film = "rate 24\ncreate b sphere position=(0 30 0)\nat 1f b.position.velocity (3 0 0)\n";
  const LoadedFilm once(film + "at 1f fall b gravity=10 for 2s\n"),
      twice(film + "at 1f fall b gravity=10 for 1s\nat 25f fall b gravity=10 for 1s\n");
  for (const char* time : {"13f", "25f", "37f", "49f"})
    expect_numbers(twice, "b.position", time, once.numbers("b.position", time), 1e-8);
  const LoadedFilm lies(film + "at 1f fall b gravity=10\nat 9s fall b gravity=10\n");
  expect_numbers(lies, "b.position", "12s", lies.numbers("b.position", "8s"), 1e-9);
}

// A track that repeats would repeat the fall, and change the values before it. A baked one does not.
TEST(Fall, IsRefusedOnATrackThatRepeats) {
  const std::string rows = "rate 24\ncreate b sphere\nb.position\n  1f (0 8 0) linear\n  49f (4 8 0)\n";
  for (const char* how : {"cycle", "bounce", "cycle before", "bounce after"}) {
    const std::string film = rows + fmt::format("extend b.position {}\n", how);
    EXPECT_EQ(told(film + "at 61f fall b delay=2s gravity=10\n"), "type 7:13 b");
    const LoadedFilm was(film),
        falls(film + "bake b.position 1f..61f\nat 61f fall b delay=1s gravity=10 ground=-100 for 1s\n");
    for (const char* time : {"1f", "13f", "37f", "55f", "61f"})
      expect_numbers(falls, "b.position", time, was.numbers("b.position", time), 1e-9);
    expect_numbers(falls, "b.position.y", "97f", {8 - 5 * 0.25}, 1e-6);
  }
  EXPECT_EQ(told("rate 24\ncreate b sphere\nat 1f b.position.y 9\nextend b.position.y cycle\nat 2f fall b\n"),
            "type 5:12 b");
  EXPECT_EQ(all_told(read(rows + "extend b.position linear\nat 61f fall b\n")), std::vector<std::string>{});
}

// shows: G4 G71
TEST(Fall, EndsTheReignOfAVelocityAndGoesOnWithIt) {
  const LoadedFilm s(
      "rate 24\ncreate ball sphere\nset ball.position (0 10 0)\nat 1f ball.position.velocity (2 3 0)\n"
      "at 25f fall ball gravity=10\n");
  EXPECT_TRUE(s.loaded.diagnostics.empty()) << to_string(s.loaded.diagnostics[0]);
  for (const double t : {0.0, 0.25, 0.5, 1.0, 1.5}) {
    const double x = 2 * (1 + t), y = 13 + 3 * t - 5 * t * t;
    expect_numbers(s, "ball.position", fmt::format("{}s", 1 + t), {x, y, 0}, 1e-8);
  }
}

// shows: G82 G83
TEST(Fall, AfterLetgoIsThrownThroughTheWorldWhateverHeldIt) {
  const LoadedFilm s(
      "rate 24\ncreate hand group position=(0 8 0) rotation=euler(0 0 90deg) scale=(2 2 2)\n"
      "at 1f hand.position.x 0 linear\nat 49f hand.position.x 6\n"
      "create ball sphere\nset ball.position (1 0 0)\ncouple ball to hand\n"
      "at 25f letgo ball\nat 25f fall ball gravity=10\n");
  ASSERT_TRUE(s.loaded.diagnostics.empty()) << to_string(s.loaded.diagnostics[0]);
  // The pin is 2 m above the hand, which moves at 3 m/s.
  for (const double t : {0.0, 0.25, 0.5, 1.0, 1.25}) {
    const Value r = s.read("ball.world", fmt::format("{}s", 1 + t));
    const Vec3 at = translation_of(*std::get<Matrix>(r));
    EXPECT_NEAR(at.x, 3 * (1 + t), 1e-6);
    EXPECT_NEAR(at.y, 10 - 5 * t * t, 1e-6);
    EXPECT_NEAR(at.z, 0, 1e-6);
  }
}

// shows: G4 G52
TEST(Fall, BelowTheGroundIsNoticed) {
  const Loaded l = read("rate 24\ncreate b sphere\nat 1f fall b ground=2\n");
  ASSERT_EQ(l.diagnostics.size(), 1U);
  EXPECT_EQ(l.diagnostics[0].severity, Severity::notice);
  EXPECT_EQ(l.diagnostics[0].what.message, "b is below the ground at y = 2, so it does not fall");
}

TEST(Fall, EndsWhereSomethingTakesHold) {
  const LoadedFilm s(
      "rate 24\ncreate hand group\ncreate ball sphere position=(0 10 0)\nat 13f attach ball to hand keep-world\n"
      "at 1f fall ball\n");
  expect_place(s, "ball", "13f", {0, 10 - 9.81 / 2 * 0.25, 0}, 1e-6);  // half a second
  expect_place(s, "ball", "49f", {0, 10 - 9.81 / 2 * 0.25, 0}, 1e-6);
}

TEST(Fall, EndsWhereSomethingTakesHoldOfItLater) {
  const std::string fall =
      "rate 24\ncreate hand group\ncreate ball sphere position=(0 10 0)\nat 1f ball.position.velocity (3 0 0)\n"
      "at 1f fall ball delay=0.25s bounce=0.5 for 6s\n";
  const std::string hold = "attach ball to hand keep-world\n";
  // The cases are in every part of a fall: before it, in the first fall, in a bounce, and exactly at the events.
  for (const double frame : {1.0, 4.0, 7.0, 13.0, 37.0, 48.0, 61.0, 90.0}) {
    const std::string at = fmt::format("at {}f ", frame);
    const LoadedFilm late(fall + at + hold), free(fall);
    ASSERT_EQ(late.loaded.diagnostics.size(), 1u) << frame;
    EXPECT_EQ(late.loaded.diagnostics[0].severity, Severity::notice);
    EXPECT_EQ(late.loaded.diagnostics[0].what.message,
              fmt::format("the fall of ball now ends at {}f, where an object holds it", frame));
    for (const double t : {1.0, 5.5, 12.75, 30.0, 44.0, 59.0, 75.0, 200.0}) {
      const auto want = free.numbers("ball.position", fmt::format("{}f", std::min(t, frame)));
      expect_numbers(late, "ball.position", fmt::format("{}f", t), want, 1e-6);
    }
  }
  // At rest, before the fall, and at the moment of release there is no fall to end.
  for (const char* fine : {"at 400f attach ball to hand\n", "at 0f attach ball to hand\n",
                           "at 0f attach ball to hand\nat 13f letgo ball\n"})
    EXPECT_TRUE(read(fall + fine).diagnostics.empty()) << fine;
  // The author's own curves are not changed.
  const std::string own =
      "create hand group\ncreate b sphere\nb.position\n  1f (0 0 0) hermite tangent-out=(0 4 0)\n"
      "  25f (0 1 0) hermite tangent-in=(0 9 0)\n";
  EXPECT_TRUE(read(own + "at 13f attach b to hand\n").diagnostics.empty());
}

TEST(Fall, LeavesWhatFiltersAndLayersAddToThem) {
  const std::string film = "rate 24\ncreate b sphere position=(0 10 0)\n", fall = "at 7f fall b gravity=10 for 1s\n";
  // A sine with a period of 1 s. At 7f, a quarter of a second later, it adds 1.
  const LoadedFilm wobbly(film + "filter b.position wobble amount=(0 1 0)\n" + fall);
  expect_numbers(wobbly, "b.position.y", "7f", {11}, 1e-9);
  expect_numbers(wobbly, "b.position.y", "13f", {10 - 5 * 0.0625 + std::sin(pi)}, 1e-9);
  const LoadedFilm layered(film + "layer l add\non l set b.position (0 5 0)\n" + fall);
  expect_numbers(layered, "b.position.y", "6f", {15}, 1e-9);
  expect_numbers(layered, "b.position.y", "7f", {15}, 1e-9);
  expect_numbers(layered, "b.position.y", "13f", {15 - 5 * 0.0625}, 1e-9);
  // An object that moves at 24 m/s keeps this speed, and is still 6 frames late.
  const LoadedFilm late(film + "b.position.x\n  1f 0 linear\n  49f 48\nfilter b.position delay by=6f\n" +
                        "at 25f fall b gravity=10 for 1s\n");
  for (const double frame : {20.0, 25.0, 28.0, 31.0, 40.0})
    expect_numbers(late, "b.position.x", fmt::format("{}f", frame), {frame - 7}, 1e-8);
}

TEST(Fall, WhatIsHeldIsCarriedOnceOnly) {
  const std::string carried =
      "rate 24\ncreate p group\ncreate p/b sphere position=(0 5 0)\np.position\n  1f (0 0 0) linear\n  48f (47 0 0)\n";
  const LoadedFilm held(carried + "at 24f fall p/b ground=1\n");
  for (const double frame : {24.0, 25.0, 26.0, 36.0})
    expect_numbers(held, "p/b.world.x", fmt::format("{}f", frame), {frame - 1}, 1e-9);
  expect_numbers(held, "p/b.world.y", "36f", {5 - 9.81 / 8}, 1e-9);
  ASSERT_EQ(held.loaded.diagnostics.size(), 1u);
  EXPECT_EQ(held.loaded.diagnostics[0].what.message, "p still carries p/b while it falls");
  const LoadedFilm free(carried + "at 24f letgo p/b\nat 24f fall p/b ground=1\n");
  EXPECT_TRUE(free.loaded.diagnostics.empty()) << said(free.loaded.diagnostics);
  for (const double frame : {24.0, 25.0, 36.0})
    expect_numbers(free, "p/b.world.x", fmt::format("{}f", frame), {frame - 1}, 1e-8);
}

TEST(Fall, LeavesTheMotionBeforeItAlone) {
  const std::string rows = "rate 24\ncreate b sphere\nb.position\n  1f (0 10 0)\n  25f (12 14 0)\n  49f (0 10 0)\n";
  const std::string fall = "at 31f fall b gravity=10 for 0.5s\n";
  const LoadedFilm film(rows + fall);
  expect_numbers(film, "b.position.y", "13f", {12.5}, 1e-9);  // from the chord's 4 to the parabola's 0
  // After a quarter of the time: h00 = 27/32, h01 = 5/32, h11 = -3/64 s at -4 m/s. The speed there is -3.25 m/s.
  expect_numbers(film, "b.position.y", "31f", {14 * 27 / 32.0 + 10 * 5 / 32.0 + 4 * 3 / 64.0}, 1e-9);
  expect_numbers(film, "b.position.y", "43f", {13.5625 - 3.25 / 2 - 10 / 8.0}, 1e-9);
  for (const char* twerper :
       {"", "twerper b.position smooth\n", "twerper b.position bspline\n", "twerper b.position linear\n"}) {
    const LoadedFilm before(rows + twerper), after(rows + twerper + fall);
    for (const char* frame : {"0f", "1f", "5f", "13f", "24f", "25f", "27f", "30.5f", "31f"})
      expect_numbers(after, "b.position", frame, before.numbers("b.position", frame), 1e-9);
  }
  // Behind its last event it stood still.
  const LoadedFilm stood("rate 24\ncreate b sphere\nb.position\n  1f (0 10 0)\n  25f (12 14 0)\nat 49f fall b\n");
  expect_numbers(stood, "b.position", "37f", {12, 14, 0}, 1e-12);
}

TEST(Fall, LeavesNoNoiseInItsEvents) {
  const LoadedFilm s(
      "rate 24\ncreate hand group\nhand.position\n  1f (-3.3 6.1 0)\n  20f (-3 4.65 0)\n  48f (2 4.65 0)\n"
      "create ball sphere position=(-3 4 0)\nat 20f attach ball to hand keep-world\nat 48f letgo ball\n"
      "at 48f fall ball ground=0.5 bounce=0.6\n");
  EXPECT_EQ(write(s.loaded.document).find("e-"), std::string::npos) << write(s.loaded.document);
}

TEST(Fall, SaysWhereALineBelowTurnsWhatItFellFrom) {
  const std::string grab =
      "rate 24\ncreate hand box\ncreate ball sphere position=(1 4 0)\nhand.position\n  1f (0 4 0)\n  72f (4 4 0)\n"
      "at 20f attach ball to hand keep-world\n";
  const std::string letgo = "at 48f letgo ball\n", fall = "at 48f fall ball ground=0.5\n";
  const std::string turn = "at 20f hand.rotation.velocity axis(0 1 0, 90deg)\nat 48f hand.rotation.velocity release\n";
  const auto warned = [](const std::string& script) {
    const Loaded l = read(script);
    return l.diagnostics.size() == 1 && l.diagnostics[0].severity == Severity::warning &&
           l.diagnostics[0].what.message ==
               "a later line changes the parent of ball at 48f, so its fall turns or moves with the parent";
  };
  EXPECT_TRUE(warned(grab + letgo + fall + turn));
  EXPECT_TRUE(read(grab + turn + letgo + fall).diagnostics.empty());
  // The author may change the events of the fall.
  EXPECT_TRUE(read(grab + letgo + fall + "scale ball.position 60f..72f (1 0.5 1)\n").diagnostics.empty());
}

}  // namespace
}  // namespace betwixt
