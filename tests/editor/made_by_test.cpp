// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests the search for the lines that make a value.
#include "editor/made_by.h"

#include <gtest/gtest.h>

#include "betwixt/language.h"

namespace betwixt {
namespace {

struct Film {
  Document d;
  explicit Film(const std::string& lines) : d(load_text("rate 24\ncreate ball sphere\n" + lines, "film.bx").document) {}
  Target of(const char* target) const { return find_targets(target, d)->front(); }
  Time at(const char* time) const { return *parse_time(time, d); }
  // The sources of a value, such as "between 24f 48f, filter noise".
  std::string words(const char* target, const char* time) const {
    constexpr std::string_view names[] = {"event here", "between",  "since", "before", "set",
                                          "code",       "velocity", "layer", "filter"};
    std::string all;
    for (const ValueSource& s : made_by(d, of(target), at(time)).sources) {
      all += (all.empty() ? "" : ", ") + std::string(names[static_cast<std::size_t>(s.what)]);
      for (const std::string& name : {s.name, s.until})
        if (!name.empty()) all += " " + name;
    }
    return all;
  }
};

TEST(MadeBy, RestSetAndEvents) {
  const Film f("set ball.radius 2\nball.position\n  1f (0 0 0)\n  24f (1 0 0)\n  48f (2 0 0)\n");
  EXPECT_EQ(f.words("ball.color", "1f"), "");
  EXPECT_FALSE(made_by(f.d, f.of("ball.color"), Time{}).said);
  EXPECT_EQ(f.words("ball.radius", "1f"), "set");
  EXPECT_EQ(f.words("ball.position", "24f"), "event here");
  EXPECT_EQ(f.words("ball.position", "30f"), "between 24f 48f");
  EXPECT_EQ(f.words("ball.position", "50f"), "since 48f");
  EXPECT_EQ(f.words("ball.position", "0f"), "before 1f");
}

TEST(MadeBy, WhatStandsBeside) {
  const Film f(
      "layer sway add\nat 1f on sway ball.position (0 1 0)\nset ball.color = \"rgb(t, 0, 0)\"\n"
      "at 12f ball.radius.velocity 1\nfilter ball.radius noise\nat 10f ball.scale.x 2\nat 20f ball.scale.y 2\n");
  EXPECT_EQ(f.words("ball.position", "1f"), "layer sway");
  EXPECT_EQ(f.words("ball.color", "1f"), "code");
  EXPECT_EQ(made_by(f.d, f.of("ball.color"), Time{}).code, "rgb(t, 0, 0)");
  EXPECT_EQ(f.words("ball.radius", "1f"), "velocity, filter noise");
  EXPECT_EQ(f.words("ball.scale", "20f"), "event here");
  EXPECT_EQ(f.words("ball.scale", "15f"), "between 10f 20f");
  EXPECT_TRUE(in_components(f.d, f.of("ball.scale")));
  EXPECT_FALSE(in_components(f.d, f.of("ball.position")));
}

// Of many events the nearest are the ones that a walk over all finds.
TEST(MadeBy, NearestOfMany) {
  std::string rows = "ball.radius\n";
  std::vector<int> frames;
  for (int i = 0; i < 200; ++i) frames.push_back(1 + i * i % 997 * 3);
  for (const int frame : frames) rows += "  " + std::to_string(frame) + "f 1\n";
  const Film f(rows);
  for (int frame = -5; frame < 3000; frame += 7) {
    std::optional<Time> before, after;
    const Time at = f.d.rate().frame(frame);
    for (const int k : frames) {
      const Time t = f.d.rate().frame(k);
      if (t < at) before = std::max(before.value_or(t), t);
      if (t > at) after = std::min(after.value_or(t), t);
    }
    EXPECT_EQ(events_beside(f.d, f.of("ball.radius"), at), std::pair(before, after)) << frame;
  }
}

TEST(MadeBy, TheLineOfAHand) {
  const Film f("at 1f ball.radius 2\n");
  EXPECT_EQ(line_that_sets(f.d, f.of("ball.radius"), f.at("24f"), "3"), "at 24f ball.radius 3 auto");
  EXPECT_EQ(line_that_sets(f.d, f.of("ball.color"), f.at("24f"), "red"), "set ball.color red");
}

// An event that has a new value continues as before.
TEST(MadeBy, TheLineOfAnEventThatIsThere) {
  const auto line = [](const std::string& row) {
    const Film f("ball.radius\n  1f 1\n  " + row + "\n  25f 2\n");
    return line_that_sets(f.d, f.of("ball.radius"), f.at("12f"), "3");
  };
  EXPECT_EQ(line("12f 4"), "at 12f ball.radius 3");
  EXPECT_EQ(line("12f 4 auto"), "at 12f ball.radius 3 auto");
  EXPECT_EQ(line("12f 4 linear(0 2 1)"), "at 12f ball.radius 3 linear(0 2 1)");
  EXPECT_EQ(line("12f 4 bounce-out ease-in=2f"), "at 12f ball.radius 3 bounce-out ease-in=2f");
  EXPECT_EQ(line("12f 5 cut 4 hold"), "at 12f ball.radius 5 cut 3 hold");
}

// A new event goes on by auto where it would swing, and as the one before it where that says a plain word.
TEST(MadeBy, HowANewEventGoesOn) {
  const auto way = [](const std::string& lines, const char* target) {
    const Film f(lines);
    return way_of_new_event(f.d, f.of(target), f.at("12f"));
  };
  EXPECT_EQ(way("", "ball.position"), " auto");
  EXPECT_EQ(way("", "ball.scale.y"), " auto");
  EXPECT_EQ(way("", "ball.rotation"), " auto");
  for (const char* stays : {"ball.color", "ball.display", "ball.material"}) EXPECT_EQ(way("", stays), "") << stays;
  const std::string rows = "ball.radius\n  1f 1 linear\n  25f 2 hold\n";
  EXPECT_EQ(way(rows, "ball.radius"), " linear");
  EXPECT_EQ(way("ball.radius\n  1f 1 bounce-out\n  25f 2\n", "ball.radius"), " auto");
  EXPECT_EQ(way("ball.radius\n  1f 1 linear(0 2 1)\n  25f 2\n", "ball.radius"), " auto");
  EXPECT_EQ(way("ball.radius\n  12f 1\n  25f 2\n", "ball.radius"), "");  // it is there already
  EXPECT_EQ(way(rows + "twerper ball.radius smooth\n", "ball.radius"), "");
  EXPECT_EQ(way("at 1f ball.rotation axis(x, 1deg)\n", "ball.rotation"), "");
}

TEST(MadeBy, TheLineThatHolds) {
  const Film f("create car box\ncreate hand group\nattach hand to car\nat 10f attach hand to ball\n");
  const ObjectId ball = f.d.find("ball"), car = f.d.find("car"), hand = f.d.find("hand");
  // At the film's first frame for all of it, behind that from there on.
  const auto first = [&](ObjectId id, const Attachment& a) { return line_that_holds(f.d, id, f.at("1f"), a); };
  EXPECT_EQ(first(ball, {AttachmentKind::couple, car, true}), "couple ball to car keep-world");
  EXPECT_EQ(first(ball, {AttachmentKind::hang, car, false}), "hang ball on car");
  EXPECT_EQ(first(ball, {AttachmentKind::detach, {}, false}), "detach ball");
  EXPECT_EQ(first(hand, {AttachmentKind::attach, car, true}), "at 1f attach hand to car keep-world");
  const auto line = [&](ObjectId id, const Attachment& a) { return line_that_holds(f.d, id, f.at("24f"), a); };
  EXPECT_EQ(line(ball, {AttachmentKind::couple, car, true}), "at 24f couple ball to car keep-world");
  EXPECT_EQ(line(hand, {AttachmentKind::attach, car, true}), "at 24f attach hand to car keep-world");
  EXPECT_EQ(line(ball, {AttachmentKind::letgo, {}, false}), "at 24f letgo ball");
}

}  // namespace
}  // namespace betwixt
