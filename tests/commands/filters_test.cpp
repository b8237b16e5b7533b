// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Filters over tracks, against closed forms.
#include <cmath>

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

}  // namespace
}  // namespace betwixt
