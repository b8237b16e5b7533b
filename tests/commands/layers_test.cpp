// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Layers with weights that move, and filters, against closed forms.
#include <cmath>

#include "support/loaded_film.h"

namespace betwixt {
namespace {

const double turn = 2 * std::acos(-1.0);

// shows: G58 R-T16
TEST(Layers, AddAndMixByWeightsThatMove) {
  const LoadedFilm s(
      "rate 24\ncreate a sphere color=rgb(0.2 0.4 0.6)\na.position\n  1f (0 0 0) linear\n  49f (4 0 0)\n"
      "layer up add\nlayer over mix\nup.weight\n  1f 0 linear\n  49f 1\nover.weight\n  25f 0 linear\n  49f 1\n"
      "on up at 1f a.position (0 2 0)\non over set a.position (9 9 9)\n"
      "on up set a.color rgb(0.1 0.1 0)\non over set a.color rgb(1 0 0)\n");
  expect_numbers(s, "a.position", "13f", {1, 0.5, 0});
  expect_numbers(s, "a.position", "25f", {2, 1, 0});
  // Half way over: from what the layer below has made, in the order they were made.
  expect_numbers(s, "a.position", "37f", {(3 + 9) / 2.0, (1.5 + 9) / 2, 4.5});
  expect_numbers(s, "a.position", "49f", {9, 9, 9});
  expect_numbers(s, "a.color", "25f", {0.25, 0.45, 0.6}, 1e-9);
  expect_numbers(s, "a.color", "49f", {1, 0, 0}, 1e-9);
  // The other order: first over, then up.
  const LoadedFilm other(
      "create a sphere\nlayer over mix weight=0.5\nlayer up add weight=0.5\n"
      "on up set a.position (0 2 0)\non over set a.position (8 8 8)\n");
  expect_numbers(other, "a.position", "1f", {4, 5, 4});
  const LoadedFilm none("create a sphere position=(1 2 3)\nlayer up add weight=0\non up set a.position (0 2 0)\n");
  expect_numbers(none, "a.position", "1f", {1, 2, 3});
}

// shows: G58 G70 R-T16
TEST(Layers, TurnOrientations) {
  for (const double w : {0.0, 0.25, 1.0}) {
    const LoadedFilm s(
        fmt::format("create a box rotation=axis(0 0 1, 30deg)\nlayer add-it add weight={0}\n"
                    "on add-it set a.rotation axis(0 0 1, 80deg)\ncreate b box rotation=axis(0 0 1, 30deg)\n"
                    "layer mix-it mix weight={0}\non mix-it set b.rotation axis(0 0 1, 80deg)\n",
                    w));
    const double a = (30 + 80 * w) / 720 * turn, b = (30 + 50 * w) / 720 * turn;
    expect_numbers(s, "a.rotation", "1f", {std::cos(a), 0, 0, std::sin(a)}, 1e-12);
    expect_numbers(s, "b.rotation", "1f", {std::cos(b), 0, 0, std::sin(b)}, 1e-12);
  }
}

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

// shows: G22 G27
TEST(Layers, UnknownNamesAreSaid) {
  const auto message = [](const std::string& line) {
    const auto all = errors(read("create a sphere\nlayer up add\n" + line + "\n"));
    return all.size() == 1 ? all[0] : fmt::format("{} errors", all.size());
  };
  EXPECT_EQ(message("on a set a.radius 2"), "3:4: 'a' is no layer");
  EXPECT_EQ(message("on upp set a.radius 2"), "3:4: there is no layer 'upp'");
  EXPECT_EQ(message("on up create b sphere"), "3:7: 'create' works on no layer");
  EXPECT_EQ(message("on up on up set a.radius 2"), "3:7: 'on' works on no layer");
  EXPECT_EQ(message("layer up add"), "3:7: there is a layer 'up' already");
  EXPECT_EQ(message("layer down sum"), "3:12: a layer adds or mixes");
  EXPECT_EQ(message("filter a.position smoth"), "3:19: there is no filter 'smoth'");
  EXPECT_EQ(message("filter a.position smooth with=5f"), "3:26: 'smooth' has no 'with'");
  EXPECT_EQ(message("filter a.display noise"), "3:8: 'noise' means nothing for on or off");
}

}  // namespace
}  // namespace betwixt
