// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "betwixt/evaluation.h"
#include "support/loaded_film.h"

namespace betwixt {
namespace {

// A wheel of radius 1 that rolls 6.28 m in 48 frames; its nail begins at (0 0 0).
const std::string rolling =
    "create hub group position=(0 1 0)\ncreate nail sphere position=(0 -1 0) radius=0.05\ncouple nail to hub\n"
    "hub.position\n  1f (0 1 0) linear\n  49f (6.283185307179586 1 0)\nhub.rotation\n  1f euler(0 0 0) linear\n"
    "  49f euler(0 0 -1turn)\n";

std::vector<Vec3> drawn(const Frame& f, const LoadedFilm& s, std::string_view name) {
  for (const Item& i : f.items)
    if (i.id == s.loaded.document.find(name)) return *i.shape->points;
  return {};
}

double off_line(Vec3 p, const std::vector<Vec3>& line) {
  double best = 1e300;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Vec3 a = line[i - 1], way = line[i] - a;
    const double along = dot(way, way) > 0 ? std::clamp(dot(p - a, way) / dot(way, way), 0.0, 1.0) : 0;
    best = std::min(best, length(p - a - along * way));
  }
  return best;
}

TEST(Traces, OfANailInAWheelAreACycloid) {
  const LoadedFilm s(rolling + "create t trace of=nail\n");
  for (const char* time : {"2f", "13.3f", "25f", "49f", "60f"}) {
    const auto line = drawn(s.frame(time), s, "t");
    const double end = std::min(1.0, (parse_time(time, s.loaded.document)->seconds() * 24) / 48);
    // A quarter of a pixel of a picture 1920 wide that it fills.
    const double within = 6.3 / 1920 / 4;
    for (int i = 0; i <= 1000; ++i) {
      const double a = 2 * pi * end * i / 1000;
      EXPECT_LE(off_line({a - std::sin(a), 1 - std::cos(a), 0}, line), within) << time << ' ' << i;
    }
    for (const Vec3 p : line) EXPECT_LE(p.y, 2 + 1e-9);
    EXPECT_LE(length(line.front()), 1e-12);
    EXPECT_LE(length(line.back() - Vec3{2 * pi * end - std::sin(2 * pi * end), 1 - std::cos(2 * pi * end), 0}), 1e-9);
  }
}

TEST(Traces, HaveABeginningAnEndAndATail) {
  const LoadedFilm s(
      "create a sphere\na.position\n  1f (0 0 0) linear\n  49f (48 0 0)\n"
      "create t trace of=a from=11f until=31f\ncreate tail trace of=a last=5f\n"
      "create top trace of=a point=(0 1 0) from=11f\n");
  const auto ends = [&](const char* name, const char* time, double from, double to, double y = 0) {
    const auto line = drawn(s.frame(time), s, name);
    ASSERT_GE(line.size(), 2U) << name << time;
    EXPECT_LE(length(line.front() - Vec3{from, y, 0}), 1e-9) << name << time;
    EXPECT_LE(length(line.back() - Vec3{to, y, 0}), 1e-9) << name << time;
  };
  EXPECT_TRUE(drawn(s.frame("10f"), s, "t").empty());
  ends("t", "20.5f", 10, 19.5);
  ends("t", "31f", 10, 30);
  ends("t", "48f", 10, 30);
  ends("tail", "4f", 0, 3);
  ends("tail", "20.25f", 14.25, 19.25);
  ends("top", "20f", 10, 19, 1);
}

TEST(Traces, OnSomethingMoveWithIt) {
  // A pen goes straight along x over a paper that turns: on the paper it has drawn a spiral.
  const std::string film =
      "create paper disc radius=3\npaper.rotation\n  1f euler(0 0 0) linear\n  25f euler(0 0 1turn)\n"
      "create pen sphere\npen.position\n  1f (0 0 0) linear\n  25f (2 0 0)\ncreate t trace of=pen within=paper\n";
  const LoadedFilm s(film);
  const Frame f = s.frame("13f");
  const auto line = drawn(f, s, "t");
  // Half a turn: where the pen was at frame k is turned on by what the paper has turned since.
  for (int k = 1; k <= 13; ++k) {
    const double r = 2 * (k - 1) / 24.0, turned = 2 * pi * (13 - k) / 24.0;
    EXPECT_LE(off_line({r * std::cos(turned), r * std::sin(turned), 0}, line), 1e-3) << k;
  }
  // The trace's own place does not count then: it is drawn where the paper is.
  const LoadedFilm moved(film + "set t.position (1 2 3)\n");
  const Frame m = moved.frame("13f");
  for (const Item& i : m.items) {
    if (i.id != moved.loaded.document.find("t")) continue;
    std::vector<Vec3> in_world;
    for (const Vec3 p : *i.shape->points) in_world.push_back(transform_point(i.world, p));
    EXPECT_LE(off_line(Vec3{1, 0, 0}, in_world), 1e-9);
  }
}

TEST(Traces, AreTheSameBitsInAnyOrder) {
  const std::string film = rolling + "create t trace of=nail last=1s\ncreate u trace of=nail\n";
  const LoadedFilm s(film);
  Evaluation back(s.program);
  for (int f = 60; f >= 0; --f) {
    const Time t{f * 7 % 61 * (flicks_per_second / 24) + 12345};
    const LoadedFilm alone(film);
    const Frame fresh = alone.program.frame(t);
    back.to(t);
    const Frame other = back.frame();
    for (std::size_t i = 0; i < fresh.items.size(); ++i)
      EXPECT_TRUE(*fresh.items[i].shape->points == *other.items[i].shape->points) << f << ' ' << i;
  }
}

TEST(Traces, OfNothingOfThemselvesAndInCircles) {
  // A thing that goes along what it draws, two traces that draw each other, one of itself.
  const LoadedFilm s(
      "create a box\ncreate t trace of=a\nset a.position along t 1\n"
      "create u trace\ncreate v trace of=u\nset u.of v\ncreate w trace\nset w.of w\ncreate x trace\n"
      "create y trace of=(1 2 3)\n");
  for (const char* time : {"1f", "10f", "3f"}) EXPECT_EQ(s.frame(time).items.size(), 7U) << time;
  EXPECT_TRUE(drawn(s.frame("10f"), s, "x").empty());
  EXPECT_TRUE(drawn(s.frame("10f"), s, "y").empty());
  const LoadedFilm gone("create a box\ncreate t trace of=a\nremove a\n");
  EXPECT_TRUE(drawn(gone.frame("10f"), gone, "t").empty());
  const LoadedFilm written(write(gone.loaded.document));
  EXPECT_TRUE(drawn(written.frame("10f"), written, "t").empty());
}

TEST(Traces, AreWrittenAndReadBack) {
  const LoadedFilm s(rolling +
                     "create t trace of=nail from=7f until=2.5s last=11f point=(0 1 2) within=hub width=0.1\n");
  const std::string text = write(s.loaded.document);
  const LoadedFilm again(text);
  EXPECT_TRUE(again.loaded.document == s.loaded.document) << text;
  EXPECT_TRUE(drawn(s.frame("20f"), s, "t") == drawn(again.frame("20f"), again, "t"));
}

TEST(Traces, ErrorsInWords) {
  EXPECT_EQ(told("create t trace of=nobody\n"), "name 1:19 nobody");
  EXPECT_EQ(told("create t trace from=red\n"), "syntax 1:21 red");
  EXPECT_EQ(told("create t trace last=-2s\n"), "range 1:21 -2s");
  EXPECT_EQ(told("create t trace until=3\n"), "type 1:22 3");
}

}  // namespace
}  // namespace betwixt
