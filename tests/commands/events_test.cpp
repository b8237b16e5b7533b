// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests the parts of an event row after its time: a value, and how the track continues from it.
#include "commands/tracks.h"
#include "track/turns.h"

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

// The cubic of glTF's CUBICSPLINE, by its formula: of four numbers, scaled by the segment's seconds, and made a unit.
std::array<double, 4> gltf(const std::array<double, 4>& v, const std::array<double, 4>& b,
                           const std::array<double, 4>& w, const std::array<double, 4>& a, double seconds, double t) {
  std::array<double, 4> out{};
  double square = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    out[i] = (2 * t * t * t - 3 * t * t + 1) * v[i] + seconds * (t * t * t - 2 * t * t + t) * b[i] +
             (-2 * t * t * t + 3 * t * t) * w[i] + seconds * (t * t * t - t * t) * a[i];
    square += out[i] * out[i];
  }
  for (double& n : out) n /= std::sqrt(square);
  return out;
}

TEST(Events, OrientationsHaveTheTangentsOfGltf) {
  // A second and a half between them; the second one written with the other sign.
  const LoadedFilm s(
      "rate 24\ncreate b box\nb.rotation\n"
      "  1f  quat(0.8 0.6 0 0) hermite tangent-out=quat(-0.3 0.4 0.5 -0.1)\n"
      "  37f quat(-0.6 0 -0.8 0) hermite tangent-in=quat(0.2 -0.7 0.1 0.3)\n");
  for (const double f : {1.0, 5.0, 13.5, 22.0, 30.25, 36.9}) {
    const auto wanted =
        gltf({0.8, 0.6, 0, 0}, {-0.3, 0.4, 0.5, -0.1}, {0.6, 0, 0.8, 0}, {-0.2, 0.7, -0.1, -0.3}, 1.5, (f - 1) / 36);
    const auto is = s.numbers("b.rotation", fmt::format("{}f", f));
    ASSERT_EQ(is.size(), 4u);
    for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(is[i], wanted[i], 1e-12) << f;
  }
  const LoadedFilm again(write(s.loaded.document));
  EXPECT_EQ(again.loaded.document, s.loaded.document);
}

TEST(Events, AnOrientationsTangentIsATurningSpeedAboutFixedAxes) {
  const LoadedFilm s(
      "rate 24\ncreate b box\nb.rotation\n  1f axis(x, 50deg) hermite tangent=axis(y, 90deg)\n"
      "  25f axis((1 1 0), 80deg) hermite tangent=spin(10deg 20deg -30deg)\n  49f axis(z, 10deg)\n");
  const auto at = [&](double seconds) {
    const auto n = s.numbers("b.rotation", fmt::format("{:.9f}s", seconds));
    return Quat{n[0], n[1], n[2], n[3]};
  };
  const auto speed = [&](double from, double to) {
    const Quat turn = log(at(to) * conjugate(at(from)));
    return 2 / (to - from) * Vec3{turn.x, turn.y, turn.z};
  };
  const auto expect_speed = [&](Vec3 is, Vec3 degrees) {
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(is[i] * 180 / pi, degrees[i], 0.02);
  };
  expect_speed(speed(0, 1e-5), {0, 90, 0});
  expect_speed(speed(1 - 1e-5, 1), {10, 20, -30});
  expect_speed(speed(1, 1 + 1e-5), {10, 20, -30});
  // Twice as long, half as fast; backwards, the other way.
  const LoadedFilm slow(write(s.loaded.document) + "stretch b.rotation 1f..25f by 2\n");
  const LoadedFilm back(write(s.loaded.document) + "reverse b.rotation 1f..25f\n");
  for (const double u : {0.1, 0.37, 0.5, 0.92})
    for (const auto& [film, time] : {std::pair(&slow, 2 * u), std::pair(&back, 1 - u)}) {
      const auto n = film->numbers("b.rotation", fmt::format("{:.9f}s", time));
      EXPECT_NEAR(std::abs(dot(Quat{n[0], n[1], n[2], n[3]}, at(u))), 1, 1e-9) << u;
    }
}

TEST(Events, TangentsThatMeanNothingAreRefused) {
  const auto said_of = [](const std::string& row) { return told("create b box\nb.rotation\n  1f " + row + "\n"); };
  EXPECT_EQ(said_of("axis(x, 50deg) hermite tangent=(1 2 3)"), "type 3:37 (");
  EXPECT_EQ(said_of("axis(x, 50deg) hermite tangent=euler(0 9deg 0)"), "type 3:37 euler");
  EXPECT_EQ(said_of("euler(0 0 0) hermite tangent=axis(y, 90deg)"), "type 3:35 axis(y, 90deg)");
  EXPECT_EQ(said_of("axis(x, 50deg) hermite tangent=quat(1 2 3)"), "syntax 3:47 )");
}

TEST(Events, KeepOnAnEventThatIsThereChangesHowItGoesOnOnly) {
  for (const char* keep : {"a.radius\n  11f keep hold\n", "at 11f a.radius keep hold\n"}) {
    const LoadedFilm s(std::string("create a sphere\na.radius\n  1f 1 linear\n  11f 4 linear\n  21f 2\n") + keep);
    expect_numbers(s, {{"a.radius", "6f", {2.5}}, {"a.radius", "11f", {4}}, {"a.radius", "20f", {4}}});
  }
}

TEST(Events, SplinesOfShapesAreThoseOfTheirPoints) {
  // Three polylines; the same places of one point, as positions, say where theirs must be.
  const std::string rows = "  1f {0} {3}\n  9f {1} {3}\n  33f {2} {3}\n  41f {0} {3}\n";
  for (const char* twerper : {"smooth", "bspline", "hermite", "linear"}) {
    const LoadedFilm film(
        "rate 24\ncreate seen polyline points=((9 9 9) (8 8 8))\n"
        "create {a,b,c} polyline points=((0 0 0) (1 0 0))\nset b.points ((2 1 0) (1 3 0))\n"
        "set c.points ((-1 4 1) (1 0 7))\nset {a,b,c}.display off\ncreate p group\ncreate q group\nseen.geometry\n" +
        fmt::format(fmt::runtime(rows), "shape(a)", "shape(b)", "shape(c)", twerper) + "p.position\n" +
        fmt::format(fmt::runtime(rows), "(0 0 0)", "(2 1 0)", "(-1 4 1)", twerper) + "q.position\n" +
        fmt::format(fmt::runtime(rows), "(1 0 0)", "(1 3 0)", "(1 0 7)", twerper));
    for (const char* time : {"1f", "3f", "8f", "9f", "15.5f", "30f", "33f", "40f", "41f", "50f"}) {
      const Frame f = film.frame(time);
      ASSERT_EQ(f.items.size(), 1u);
      std::vector<Vec3> at = *f.items[0].shape->points;
      if (f.items[0].toward)  // linear: the renderer mixes
        for (std::size_t i = 0; i < 2; ++i)
          at[i] = at[i] + f.items[0].blend * ((*f.items[0].toward->points)[i] - at[i]);
      for (std::size_t i = 0; i < 2; ++i) {
        const auto want = film.numbers(i == 0 ? "p.position" : "q.position", time);
        EXPECT_NEAR(at[i].x, want[0], 1e-12) << twerper << time;
        EXPECT_NEAR(at[i].y, want[1], 1e-12) << twerper << time;
        EXPECT_NEAR(at[i].z, want[2], 1e-12) << twerper << time;
      }
    }
  }
}

TEST(Events, SplinesOfShapesAreThoseOfTheirMeasures) {
  const LoadedFilm film(
      "rate 24\ncreate seen sphere\ncreate a sphere radius=1\ncreate b sphere radius=2\ncreate c sphere radius=4\n"
      "create g sphere\nset {a,b,c,g}.display off\n"
      "seen.geometry\n  1f shape(a) smooth\n  9f shape(b) smooth\n  33f shape(c) smooth\n"
      "g.radius\n  1f 1 smooth\n  9f 2 smooth\n  33f 4 smooth\n");
  for (const char* time : {"2f", "8f", "12f", "31f"})
    EXPECT_NEAR(film.frame(time).items[0].shape->radius, film.numbers("g.radius", time)[0], 1e-12) << time;
}

TEST(Events, ThatOtherShapesGoStraightIsSaidOnce) {
  const Loaded l = read(
      "create a text text=\"a\"\ncreate b text text=\"b\"\na.geometry\n  1f shape(a) smooth\n"
      "  9f shape(b) smooth\n  17f shape(a) linear\n");
  const std::string all = said(l.diagnostics),
                    sentence = "a.geometry blends linearly from 1f to 9f: smooth needs shapes of one kind";
  const std::size_t at = all.find(sentence);
  ASSERT_NE(at, std::string::npos) << all;
  EXPECT_EQ(all.rfind(sentence), at) << all;
}

TEST(Events, AGroupHasNoGeometryToShow) {
  EXPECT_EQ(all_told(read("create g group\ncreate b box\nset g.geometry shape(b)\n")),
            std::vector<std::string>{"type 3:5 g.geometry"});
  const Loaded l = read("create g group\ncreate b box\nat 1f g.geometry shape(b)\n");
  EXPECT_EQ(all_told(l), std::vector<std::string>{"type 3:18 shape(b)"});
}

}  // namespace
}  // namespace betwixt
