// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What stands behind a row's time: a value, and how to go on from there.
#include "commands/tracks.h"

namespace betwixt {
namespace {

// shows: G42 G48
TEST(Events, CutJumpsAndKeepChangesTheTwerper) {
  const LoadedFilm s("create b sphere\nb.radius\n 1f 0 linear\n 5f 4 cut 10 linear\n 9f 14\n");
  expect_track(s, "b.radius", 1, {0, 1, 2, 3, 10, 11, 12, 13, 14});
  const LoadedFilm k("create b sphere\nb.radius\n 1f 0 linear\n 5f keep hold\n 9f 8\n");
  expect_track(k, "b.radius", 1, {0, 1, 2, 3, 4, 4, 4, 4, 8});
}

// shows: G44 G50 G103
TEST(Events, Twerpers) {
  const LoadedFilm hold("create b sphere\nb.radius\n 1f 1 hold\n 5f 5\n");
  expect_track(hold, "b.radius", 1, {1, 1, 1, 1, 5});
  // ease of CSS at a quarter of the time: 0.40851…
  const LoadedFilm bezier("create b sphere\nb.radius\n 1f 0 bezier(0.25 0.1 0.25 1)\n 5f 1\n");
  EXPECT_NEAR(bezier.numbers("b.radius", "2f")[0], 0.4085105913553584, 1e-9);
  // A parabola's tangents: the cubic through them is the parabola.
  const LoadedFilm hermite("create b sphere\nb.position.x\n 1f 0 hermite tangent=0\n 25f 1 tangent=2\n");
  EXPECT_NEAR(hermite.numbers("b.position.x", "13f")[0], 0.25, 1e-12);
  // Uniform B-spline, at an event: (1 4 1)/6.
  const LoadedFilm spline("create b sphere\nb.position.x\n 1f 0 bspline\n 2f 6 bspline\n 3f 0 bspline\n");
  EXPECT_NEAR(spline.numbers("b.position.x", "2f")[0], 4, 1e-9);
  // One interpolator for the whole track wins over those of the events; none gives them back.
  const LoadedFilm global = after_ramp("twerper b.position.x hold");
  expect_track(global, "b.position.x", 1, {0, 0, 0, 0, 4, 4, 4, 4, 0});
  expect_track(after_ramp("twerper b.position.x hold\ntwerper b.position.x none"), "b.position.x", 1,
               {0, 1, 2, 3, 4, 3});
}

TEST(Events, ColoursBeyondBrightAreWarnedOf) {
  const LoadedFilm s("create a sphere color=rgb(255 0 0)\n");
  EXPECT_NE(said(s.loaded.diagnostics).find("write rgb(1 0 0)"), std::string::npos);
}

TEST(Events, KeepOnAnEventThatIsThereChangesHowItGoesOnOnly) {
  for (const char* keep : {"a.radius\n  11f keep hold\n", "at 11f a.radius keep hold\n"}) {
    const LoadedFilm s(std::string("create a sphere\na.radius\n  1f 1 linear\n  11f 4 linear\n  21f 2\n") + keep);
    expect_numbers(s, {{"a.radius", "6f", {2.5}}, {"a.radius", "11f", {4}}, {"a.radius", "20f", {4}}});
  }
}

TEST(Events, AGroupHasNoGeometryToShow) {
  EXPECT_EQ(errors(read("create g group\ncreate b box\nset g.geometry shape(b)\n")),
            std::vector<std::string>{"3:5: 'g', a group, draws nothing: its geometry would not be seen"});
  const Loaded l = read("create g group\ncreate b box\nat 1f g.geometry shape(b)\n");
  ASSERT_EQ(errors(l).size(), 1u);
  EXPECT_NE(errors(l)[0].find("'g', a group, draws nothing: its geometry would not be seen"), std::string::npos);
}

}  // namespace
}  // namespace betwixt
