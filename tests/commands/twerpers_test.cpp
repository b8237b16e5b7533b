// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests twerpers (interpolations) with arguments: the stops of `linear`, the handles of `fcurve`.
#include <random>

#include "betwixt/track.h"
#include "commands/tracks.h"

namespace betwixt {
namespace {

// From 0 at 1f to 1 at 101f: a frame is a hundredth.
double at_percent(const std::string& twerper, double percent) {
  const LoadedFilm s("create b sphere\nb.radius\n  1f 0 " + twerper + "\n  101f 1\n");
  return s.numbers("b.radius", fmt::format("{}f", 1 + percent))[0];
}

// What CSS Easing 2 says of each of its forms: stops lie evenly, or where they say; two places make a flat piece.
TEST(TwerperStops, AreThoseOfCss) {
  const auto expect = [](const char* twerper, const std::vector<std::pair<double, double>>& wanted) {
    for (const auto& [percent, value] : wanted)
      EXPECT_NEAR(at_percent(twerper, percent), value, 1e-12) << twerper << percent;
  };
  expect("linear(0 0.3 1)", {{0, 0}, {25, 0.15}, {50, 0.3}, {75, 0.65}, {99, 0.986}});
  expect("linear(0, 0.25, 1)", {{10, 0.05}, {50, 0.25}, {90, 0.85}});
  expect("linear(0 0.25 75% 1)", {{30, 0.1}, {75, 0.25}, {95, 0.85}});
  expect("linear(0 0.25 25% 75% 1)", {{10, 0.1}, {25, 0.25}, {50, 0.25}, {75, 0.25}, {80, 0.4}});
  // Runs without places between some that have them.
  expect("linear(0 0.1 0.2 60% 0.5 0.6 1)", {{30, 0.1}, {60, 0.2}, {66, 0.335}, {80, 0.55}, {90, 0.7}});
  // A jump; what lies before the beginning and behind the end shows the way; going too far.
  expect("linear(0 0 50% 1 50% 1)", {{49.9, 0}, {50, 1}, {80, 1}});
  expect("linear(-1 -100% 3 300%)", {{0, 0}, {50, 0.5}, {90, 0.9}});
  expect("linear(0 1.5 50% 1)", {{50, 1.5}, {75, 1.25}});
  expect("linear(0.2 20% 0.6 60%)", {{0, 0}, {10, 0.1}, {40, 0.4}, {80, 0.8}});
  // The value of the next event stands at the next event.
  expect("linear(0 0.5)", {{50, 0.25}, {99, 0.495}, {100, 1}});
  // Formulas stand wherever numbers do: % is a formula's where a number follows it directly.
  expect("linear(0 0.7%0.4 50% 1)", {{50, 0.3}, {25, 0.15}});
}

TEST(TwerperStops, BendTimeForAllThatBlends) {
  // A turn of 100 degrees is at 30 where the stop is 0.3.
  const LoadedFilm s(
      "create b box color=black\nb.rotation\n  1f axis(z, 0) linear(0 0.3 1)\n  25f axis(z, 100deg)\n"
      "b.position\n  1f (0 0 0) linear(0 0.3 1) ease-out=24f\n  25f (10 20 30)\n"
      "create c camera\nc.look-at\n  1f (0 0 0) linear(0 0.3 1)\n  25f (10 0 0)\n");
  const auto q = s.numbers("b.rotation", "13f");
  EXPECT_NEAR(2 * std::atan2(q[3], q[0]), 30 * pi / 180, 1e-12);
  // An ease over all of it: u² of the time.
  expect_numbers(s, "b.position", "13f", {1.5, 3, 4.5}, 1e-12);
  expect_numbers(s, "c.look-at", "13f", {3, 0, 0}, 1e-12);
  // One for the whole track wins, with its stops or without.
  const std::string two = "create b sphere\nb.radius\n  1f 0 linear(0 0.9 1)\n  25f 1\ntwerper b.radius ";
  EXPECT_NEAR(LoadedFilm(two + "linear\n").numbers("b.radius", "13f")[0], 0.5, 1e-12);
  EXPECT_NEAR(LoadedFilm(two + "linear(0 0.2 1)\n").numbers("b.radius", "13f")[0], 0.2, 1e-12);
  EXPECT_NEAR(LoadedFilm(two + "none\n").numbers("b.radius", "13f")[0], 0.9, 1e-12);
  // Of a velocity the way is the area below it: 4 s times the mean of 0, 0.3, 1 by trapezes; turned round, upside down.
  const LoadedFilm v("create b sphere\nb.position.x.velocity\n  1f 0 linear(0 0.3 1)\n  97f 1 hold\n");
  EXPECT_NEAR(v.numbers("b.position.x", "97f")[0], 4 * (0.15 + 0.65) / 2, 1e-12);
  const LoadedFilm r("create b sphere\nb.radius\n  1f 0 linear(0 0.3 20% 1)\n  101f 1\nreverse b.radius 1f..101f\n");
  for (const auto& [f, x] : {std::pair{81.0, 0.3}, {91.0, 0.15}, {41.0, 0.65}})
    EXPECT_NEAR(r.numbers("b.radius", fmt::format("{}f", f))[0], x, 1e-12);
  // It goes on as its last piece does.
  const LoadedFilm on("create b sphere\nb.radius\n  1f 0 linear(0 0.5 50% 0.6 1)\n  101f 1\nextend b.radius linear\n");
  EXPECT_NEAR(on.numbers("b.radius", "111f")[0], 1.16, 1e-9);
}

// The points as CSS makes them, and a straight search through them.
double by_css(const std::vector<std::pair<double, std::optional<double>>>& said, double s) {
  std::vector<std::pair<long double, long double>> points;
  for (const auto& [value, place] : said) points.emplace_back(place ? *place / 100 : NAN, value);
  if (std::isnan(points.front().first)) points.front().first = 0;
  long double largest = 0;
  for (const auto& p : points)
    if (!std::isnan(p.first)) largest = std::max(largest, p.first);
  if (std::isnan(points.back().first)) points.back().first = std::max(1.0L, largest);
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (!std::isnan(points[i].first)) continue;
    std::size_t j = i;
    while (std::isnan(points[j].first)) ++j;
    const long double a = points[i - 1].first;
    points[i].first = a + (points[j].first - a) / static_cast<long double>(j - i + 1);
  }
  std::size_t a = 0;
  for (std::size_t i = 0; i + 1 < points.size(); ++i)
    if (points[i].first <= s) a = i;
  const auto &p = points[a], &q = points[a + 1];
  return static_cast<double>(
      p.first == q.first ? q.second : p.second + (s - p.first) / (q.first - p.first) * (q.second - p.second));
}

TEST(TwerperStops, RandomOnesAreWrittenAsTheyAreAndGoAsCssSays) {
  std::mt19937 random(20);
  const auto below = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  for (int round = 0; round < 60; ++round) {
    std::vector<std::pair<double, std::optional<double>>> stops;
    std::string text;
    double place = below(3) == 0 ? -13 : 0;
    for (int i = 0, n = 2 + below(9); i < n; ++i) {
      const double value = (below(200) - 50) / 64.0;
      text += fmt::format("{}{}", i ? " " : "", value);
      stops.emplace_back(value, std::nullopt);
      for (int k = below(5) / 2; k > 0; --k) {
        place += below(4) == 0 ? 0 : below(3000) / 97.0;
        text += fmt::format(" {}%", place);
        if (stops.back().second) stops.emplace_back(value, std::nullopt);
        stops.back().second = place;
      }
      if (!stops.front().second) place = std::max(place, 0.0);
    }
    if (stops.size() < 2) continue;
    const LoadedFilm s("create b sphere\nb.position.x\n  1f 0 linear(" + text + ")\n  101f 1\n");
    for (int k = 0; k < 20; ++k) {
      const double percent = below(9900) / 100.0 + 0.0031;
      EXPECT_NEAR(s.numbers("b.position.x", fmt::format("{}f", 1 + percent))[0], by_css(stops, percent / 100), 1e-6)
          << text << " at " << percent;
    }
    const LoadedFilm again(write(s.loaded.document));
    EXPECT_EQ(again.loaded.document, s.loaded.document) << text;
    EXPECT_EQ(write(again.loaded.document), write(s.loaded.document)) << text;
  }
  // As short as what was written.
  for (const char* said : {"linear(0 0.3 1)", "linear(0 0.25 25% 0.25 75% 1)", "linear(0.5 10% 1 2 80% 3 4)"}) {
    const LoadedFilm s(fmt::format("create b sphere\nb.radius\n  1f 0 {}\n  101f 1\n", said));
    EXPECT_NE(write(s.loaded.document).find(said), std::string::npos) << write(s.loaded.document);
  }
}

TEST(TwerperStops, AreSeenInViews) {
  const LoadedFilm s(
      "create b sphere\nb.radius\n  1f 0 linear(0 0.25 25% 75% 1)\n  101f 1 linear\ntwerper b.radius linear(0 1)\n");
  const Target t = find_targets("b.radius", s.loaded.document)->front();
  const auto all = events(s.loaded.document, t);
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0].twerper, "linear");
  const std::vector<std::array<double, 2>> wanted{{0, 0}, {25, 0.25}, {75, 0.25}, {100, 1}};
  EXPECT_TRUE(std::equal(wanted.begin(), wanted.end(), all[0].stops.begin(), all[0].stops.end()));
  EXPECT_TRUE(all[1].stops.empty());
  EXPECT_EQ(track(s.loaded.document, t)->stops.size(), 2u);
}

std::string error_of(const std::string& rows) { return told("create b sphere\ncreate c box\nb.position.x\n" + rows); }

TEST(TwerperStops, WhatIsWrongIsSaid) {
  const std::pair<const char*, const char*> cases[] = {
      {"linear()", "syntax 4:14 ()"},
      {"linear(1)", "syntax 4:14 (1)"},
      {"linear(25% 1)", "syntax 4:15 25%"},
      {"linear(0 10% 20% 30% 1)", "syntax 4:25 30%"},
      {"linear(0 50% 0.5 20% 1)", "range 4:25 20%"},
      {"linear(0 -10% -20% 1)", "range 4:22 -20%"},
      {"linear(0 1 -10% 1)", "range 4:19 -10%"},
      {"linear(0 2f 1)", "type 4:17 2f"},
      {"linear(0 red 1)", "syntax 4:17 red"},
      {"linear(0 (1 2) 1)", "syntax 4:20 2"},
      {"linear(0 2000000 1)", "range 4:17 2000000"},
      {"linear(0 1 2000000%)", "range 4:19 2000000%"},
      {"linear(0 1", "syntax 4:14 ("},
      {"linear(0 1) linear", "syntax 4:20 linear"},
      {"hold(0 1)", "syntax 4:12 ("},
  };
  for (const auto& [twerper, wrong] : cases) EXPECT_EQ(error_of(fmt::format("  1f 0 {}\n", twerper)), wrong) << twerper;
  std::string many = "  1f 0 linear(0";
  for (int i = 0; i < 1001; ++i) many += " 1";
  EXPECT_EQ(error_of(many + ")\n"), "range 4:14 (");
  EXPECT_TRUE(
      mentions("create b sphere\ncreate c box\nb.position.x\n" + many + ")\n", "linear can have at most 1000 stops"));
  EXPECT_NE(error_of("c.text\n"), "");
}

// ---- F-curves

// A cubic in time and value, its parameter found by halving in long double; handles as Blender limits them.
double blender(double t1, double v1, double l1, double h1, double l2, double h2, double t2, double v2, double t) {
  const long double span = t2 - t1;
  long double x1 = l1, y1 = h1, x2 = l2, y2 = h2;
  if (x1 > span) y1 *= span / x1, x1 = span;
  if (x2 > span) y2 *= span / x2, x2 = span;
  const auto at = [](long double a, long double b, long double c, long double d, long double p) {
    const long double q = 1 - p;
    return q * q * q * a + 3 * q * q * p * b + 3 * q * p * p * c + p * p * p * d;
  };
  long double low = 0, high = 1;
  for (int i = 0; i < 80; ++i) {
    const long double p = (low + high) / 2;
    (at(t1, t1 + x1, t2 - x2, t2, p) < t ? low : high) = p;
  }
  return static_cast<double>(at(v1, v1 + y1, v2 + y2, v2, low));
}

TEST(FCurves, GoByTheirHandlesInTimeAndValue) {
  struct Case {
    double l1, h1, l2, h2;
  };
  // The usual; long ones that cross; too long ones; of no length; flat; at odds with the way.
  for (const Case& k : std::vector<Case>{{8, 1, 8, -1},
                                         {20, 0, 20, 0},
                                         {40, 3, 30, -8},
                                         {0, 2, 0, -2},
                                         {8, 0, 3, 0},
                                         {12, -4, 6, 5},
                                         {24, 0, 24, 0}}) {
    const LoadedFilm s(fmt::format(
        "create b sphere\nb.position.x\n  1f 2 fcurve handle-out=({}f {})\n  25f 5 handle-in=({}f {}) linear\n", k.l1,
        k.h1, k.l2, k.h2));
    for (const double f : {1.0, 1.5, 3.0, 7.25, 13.0, 18.0, 22.5, 24.75, 25.0}) {
      const bool upright = f == 13 && k.l1 >= 24 && k.l2 >= 24;  // there halving finds a third of its digits
      EXPECT_NEAR(s.numbers("b.position.x", fmt::format("{}f", f))[0], blender(1, 2, k.l1, k.h1, k.l2, k.h2, 25, 5, f),
                  upright ? 1e-5 : 1e-9)
          << k.l1 << ' ' << k.l2 << ' ' << f;
    }
  }
  // Thirds are the cubic itself: three times the way over the time is the speed. Without handles it is at rest at both.
  const LoadedFilm thirds(
      "create b sphere\nb.position.x\n  1f 0 fcurve handle-out=(8f 1)\n  25f 6 handle-in=(8f -2)\n"
      "create c sphere\nc.position.x\n  1f 0 hermite tangent-out=3\n  25f 6 tangent-in=6\n"
      "create d sphere\nd.position.x\n  1f 0 fcurve\n  25f 6\n");
  for (const char* f : {"3f", "9.5f", "20f"})
    EXPECT_NEAR(thirds.numbers("b.position.x", f)[0], thirds.numbers("c.position.x", f)[0], 1e-9);
  EXPECT_NEAR(thirds.numbers("d.position.x", "7f")[0], 6 * (3 * 0.0625 - 2 * 0.015625), 1e-9);
}

TEST(FCurves, OfVectorsAnglesAndComponents) {
  const LoadedFilm s(
      "create b box\nb.position\n  1f (0 0 0) fcurve handle-out=(4f (1 2 3))\n  25f (3 3 3) handle-in=(12f (0 -1 0))\n"
      "b.rotation\n  1f euler(0 0 0) fcurve handle-out=(4f (0 0 30deg))\n  25f euler(0 0 90deg) handle-in=(4f euler(0 "
      "0 0))\n"
      "create c box\nset c.position (0 0 0)\nc.position.y\n  1f 0 fcurve handle-out=(4f 2)\n  25f 3 handle-in=(12f "
      "-1)\n");
  for (const double f : {2.0, 9.0, 21.0}) {
    const std::string at = fmt::format("{}f", f);
    const double y = blender(1, 0, 4, 2, 12, -1, 25, 3, f);
    expect_numbers(s, "b.position", at.c_str(),
                   {blender(1, 0, 4, 1, 12, 0, 25, 3, f), y, blender(1, 0, 4, 3, 12, 0, 25, 3, f)}, 1e-9);
    expect_numbers(s, "c.position.y", at.c_str(), {y}, 1e-9);
    expect_numbers(s, "b.rotation.z", at.c_str(), {blender(1, 0, 4, 30, 4, 0, 25, 90, f) * pi / 180}, 1e-9);
  }
  // What holds for the whole holds for its parts.
  const LoadedFilm parts(write(s.loaded.document) + "at 30f b.position.x 4\n");
  EXPECT_NEAR(parts.numbers("b.position.y", "9f")[0], s.numbers("b.position.y", "9f")[0], 1e-12);
}

TEST(FCurves, OperationsKeepThem) {
  const std::string film =
      "create b sphere\nb.position.x\n  1f 2 fcurve handle-out=(8f 4)\n  25f 5 handle-in=(3f -1) linear\n";
  const LoadedFilm s(film), twice(film + "stretch b.position.x 1f..25f by 2\n"),
      back(film + "reverse b.position.x 1f..25f\n"), larger(film + "scale b.position.x 1f..25f 3\n"),
      on(film + "extend b.position.x linear\n");
  const auto x = [](const LoadedFilm& l, double f) { return l.numbers("b.position.x", fmt::format("{}f", f))[0]; };
  for (const double f : {2.0, 5.5, 13.0, 24.0}) {
    EXPECT_NEAR(x(twice, 1 + 2 * (f - 1)), x(s, f), 1e-9);
    EXPECT_NEAR(x(back, 26 - f), x(s, f), 1e-9);
    EXPECT_NEAR(x(larger, f), 3 * x(s, f), 1e-9);
  }
  // Beyond its ends it goes on where the handles point: 4 in 8 frames, 1 in 3.
  EXPECT_NEAR(x(on, -3), 2 - 2, 1e-9);
  EXPECT_NEAR(x(on, 31), 5 + 2, 1e-9);
  for (const LoadedFilm* l : {&s, &twice, &back, &larger, &on}) {
    const LoadedFilm again(write(l->loaded.document));
    EXPECT_EQ(again.loaded.document, l->loaded.document);
  }
  const LoadedFilm kept(
      "create b sphere\nb.position.x\n  1f 2 linear\n  25f 5\nat 1f b.position.x keep fcurve handle-out=(8f 4)\nat 25f "
      "b.position.x keep linear handle-in=(3f -1)\n");
  for (const double f : {2.0, 13.0}) EXPECT_NEAR(x(kept, f), x(s, f), 1e-12);
  const auto view = events(s.loaded.document, find_targets("b.position.x", s.loaded.document)->front());
  EXPECT_EQ(view[0].twerper, "fcurve");
  EXPECT_EQ(view[0].handle_out, from_seconds(8 / 24.0));
  EXPECT_EQ(std::get<double>(*view[0].tangent_out), 4);
  EXPECT_FALSE(view[0].handle_in);
}

TEST(FCurves, WhatIsWrongIsSaid) {
  const std::pair<const char*, const char*> cases[] = {
      {"fcurve handle-out=4f", "syntax 4:26 4f"},       {"fcurve handle-out (4f 1)", "syntax 4:26 ("},
      {"fcurve handle-in=()", "syntax 4:26 )"},         {"fcurve handle-in=(4f)", "syntax 4:28 )"},
      {"fcurve handle-in=(-4f 1)", "range 4:26 -4f"},   {"fcurve handle-in=(4 1)", "type 4:26 4"},
      {"fcurve handle-in=(4f red)", "syntax 4:29 red"}, {"fcurve handle-in=(4f 1 2)", "syntax 4:31 2"},
      {"fcurve handle-in=(4f (1 2 3))", "type 4:29 ("}, {"fcurve(1)", "syntax 4:14 ("},
  };
  for (const auto& [twerper, wrong] : cases) EXPECT_EQ(error_of(fmt::format("  1f 0 {}\n", twerper)), wrong) << twerper;
  EXPECT_EQ(error_of("c.color\n  1f red fcurve handle-in=(4f red)\n"), "type 5:17 handle-in");
  EXPECT_EQ(error_of("c.rotation\n  1f axis(x, 1deg) fcurve handle-in=(4f (0 0 0))\n"), "type 5:27 handle-in");
  EXPECT_EQ(error_of("c.rotation\n  1f (0 0 0) fcurve handle-in=(4f axis(x, 1deg))\n"), "type 5:32 4f axis(x, 1deg)");
  const LoadedFilm idle("create b sphere\nb.radius\n  1f 1 linear handle-out=(4f 1)\n  9f 2\n");
  EXPECT_EQ(remarks_told(idle.loaded), std::vector<std::string>{"notice type 3:3 1f 1 linear handle-out=(4f 1)"});
  EXPECT_TRUE(mentions(idle.loaded, "b.radius"));
}

}  // namespace
}  // namespace betwixt
