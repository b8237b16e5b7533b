// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests scatters, streamlines, surfaces, slopes and the error of plots.
#include <algorithm>
#include <cmath>

#include "betwixt/frame.h"
#include "scene/kinds.h"
#include "support/loaded_film.h"

namespace betwixt {
namespace {

const std::string plane = "film flat\ncreate ax axes x=(-4 4) y=(-2 2) size=(8 4)\n";
const std::string space = "create ax axes x=(-2 2) y=(-2 2) z=(-1 1) size=(4 4 2)\n";

std::vector<Vec3> points_of(const LoadedFilm& s, std::string_view target, std::string_view when = "1f") {
  return *std::get<Points>(s.read(std::string(target) + ".points", when));
}
const Shape& shape_of(const Frame& frame, Kind kind) {
  const auto at =
      std::find_if(frame.items.begin(), frame.items.end(), [&](const Item& i) { return i.shape->kind == kind; });
  EXPECT_NE(at, frame.items.end());
  return *at->shape;
}
// Cuts at the points that lift the pen.
std::vector<std::vector<Vec3>> lines_of_points(const std::vector<Vec3>& all) {
  std::vector<std::vector<Vec3>> out(1);
  for (const Vec3 p : all)
    if (std::isfinite(p.x))
      out.back().push_back(p);
    else
      out.emplace_back();
  return out;
}

TEST(Scatters, ShowDataInsideTheirAxes) {
  const LoadedFilm s(
      plane +
      "create s scatter on=ax of=((1 2) (2 -1.5) (9 0) (-4 -2)) size=0.1\n"
      "at 1f s.points ((1 2) (2 -1.5) (9 0) (-4 -2)) linear\nat 25f s.points ((1 0) (2 0) (3 0) (4 0))\n");
  ASSERT_TRUE(s.loaded.diagnostics.empty()) << said(s.loaded.diagnostics);
  const auto first = s.frame("1f"), last = s.frame("25f"), between = s.frame("13f");
  EXPECT_EQ(*shape_of(first, Kind::scatter).points, (std::vector<Vec3>{{1, 2, 0}, {2, -1.5, 0}, {-4, -2, 0}}));
  EXPECT_EQ(shape_of(first, Kind::scatter).width, 0.1);
  EXPECT_EQ(shape_of(last, Kind::scatter).points->size(), 4u);
  EXPECT_NEAR((*shape_of(between, Kind::scatter).points)[0].y, 1, 1e-9);
}

TEST(Scatters, OfCode) {
  const LoadedFilm s(plane +
                     "create s scatter on=ax\nset s.points = \"local p = {} for i = 1, 50 do p[i] = vec(i / 20, 1) "
                     "end return p\"\n");
  EXPECT_EQ(shape_of(s.frame("1f"), Kind::scatter).points->size(), 50u);
}

TEST(Streamlines, FollowTheirFieldAtADistance) {
  const LoadedFilm s(plane + "create v streamlines on=ax of=\"vec(-y, x)\" density=16\n");
  ASSERT_TRUE(s.loaded.diagnostics.empty()) << said(s.loaded.diagnostics);
  const auto all = lines_of_points(points_of(s, "v"));
  std::vector<std::vector<Vec3>> lines;
  for (const auto& line : all)
    if (line.size() > 3) lines.push_back(line);  // the others are heads of arrows
  ASSERT_GT(lines.size(), 8u);
  // They are circles: the radius of none changes.
  for (const auto& line : lines)
    for (const Vec3 p : line) EXPECT_NEAR(std::hypot(p.x, p.y), std::hypot(line[0].x, line[0].y), 2e-3);
  // Cells are half a metre: no line is nearer to another than half of that, and no place is far from all.
  for (std::size_t a = 0; a < lines.size(); ++a)
    for (std::size_t b = a + 1; b < lines.size(); ++b)
      for (const Vec3 p : lines[a])
        for (const Vec3 q : lines[b]) ASSERT_GT(length(p - q), 0.24);
  for (double x = -3.9; x < 4; x += 0.3)
    for (double y = -1.9; y < 2; y += 0.3) {
      double nearest = 1e9;
      for (const auto& line : lines)
        for (const Vec3 p : line) nearest = std::min(nearest, length(p - Vec3{x, y, 0}));
      EXPECT_LT(nearest, 0.75) << x << ' ' << y;
    }
  EXPECT_EQ(points_of(s, "v"),
            points_of(LoadedFilm(plane + "create v streamlines on=ax of=\"vec(-y, x)\" density=16\n"), "v"));
}

TEST(Streamlines, DrawnPiecesTravel) {
  const LoadedFilm s(plane +
                     "create v streamlines on=ax of=\"vec(1, 0)\" density=8 drawn=0.5\n"
                     "at 1f v.flow 0 linear\nat 25f v.flow 1\n");
  // Pieces of 1.5 m, which begin every 3 m. After 1 each is where the next one was.
  const auto begin = lines_of_points(points_of(s, "v")), end = lines_of_points(points_of(s, "v", "25f")),
             later = lines_of_points(points_of(s, "v", "7f"));
  ASSERT_EQ(begin.size(), end.size());
  for (std::size_t i = 0; i < begin.size(); ++i) EXPECT_NEAR(length(begin[i][0] - end[i][0]), 0, 1e-9);
  bool moved = false;
  for (const auto& a : begin)
    for (const auto& b : later)
      moved = moved || (a[0].y == b[0].y && std::abs(b[0].x - a[0].x - 0.75) < 1e-9 && a[0].x > -3.9);
  EXPECT_TRUE(moved);  // a quarter of three metres
}

TEST(Streamlines, EndWhateverTheField) {
  for (const char* of : {"vec(0, 0)", "vec(0/0, 1)", "vec(1/x, 1/y)", "vec(sin(9*x), cos(9*y))", "vec(1e300*x, y)",
                         "vec(-y - 0.2*x, x - 0.2*y)", "x"}) {
    const LoadedFilm s(plane + "create v streamlines on=ax density=30 of=\"" + of + "\"\n");
    std::vector<std::string> problems;
    s.program.read(*find_targets("v.points", s.loaded.document), {}, &problems);
    EXPECT_TRUE(problems.empty()) << of << ": " << problems[0];
  }
}

TEST(Surfaces, AreGraphsWithSmoothNormalsAndHoles) {
  const LoadedFilm s(space +
                     "create s surface on=ax of=\"x * y / 4\" density=20\n"
                     "create h surface on=ax of=\"sqrt(1 - x^2 - y^2)\" density=40\n"
                     "create w surface on=ax of=\"sin(x - t)\"\n");
  ASSERT_TRUE(s.loaded.diagnostics.empty()) << said(s.loaded.diagnostics);
  const auto grid = points_of(s, "s");
  ASSERT_EQ(grid.size(), 21u * 21);
  for (const Vec3 p : grid) EXPECT_NEAR(p.z, p.x * p.y / 4, 1e-12);
  const Frame frame = s.frame("1f");
  const auto mesh = row_of(Kind::surface).mesh(shape_of(frame, Kind::surface), {});
  EXPECT_EQ(mesh.triangles.size(), 3u * 2 * 20 * 20);
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const double x = mesh.positions[i][0], y = mesh.positions[i][1];
    if (std::max(std::abs(x), std::abs(y)) > 1.9) continue;  // at the border the difference has one side
    const Vec3 normal = normalize(Vec3{-y / 4, -x / 4, 1});
    EXPECT_NEAR(mesh.normals[i][0], normal.x, 1e-4);
    EXPECT_NEAR(mesh.normals[i][1], normal.y, 1e-4);
  }
  // Of the half ball nothing is beyond its rim, and it reaches the rim.
  double widest = 0, holes = 0;
  for (const Vec3 p : points_of(s, "h")) {
    if (!std::isfinite(p.z)) {
      ++holes;
      continue;
    }
    EXPECT_LT(std::abs(p.x * p.x + p.y * p.y + p.z * p.z - 1), 0.05);
    widest = std::max(widest, std::hypot(p.x, p.y));
  }
  EXPECT_GT(holes, 400);
  EXPECT_NEAR(widest, 1, 1e-3);
  EXPECT_NE(points_of(s, "w"), points_of(s, "w", "25f"));
}

TEST(Surfaces, EndAtTheEndsOfZ) {
  const LoadedFilm s(space + "create s surface on=ax of=\"1 / x\"\n");
  for (const Vec3 p : points_of(s, "s"))
    if (std::isfinite(p.z)) EXPECT_LE(std::abs(p.z), 1 + 1e-9);
}

TEST(Fields, SayWhatIsWrong) {
  expect_refused(plane, "create s surface on=ax of=\"x\"", "range 1:10 surface");
  expect_refused(plane, "create s surface of=\"x\"", "syntax 1:10 surface");
  expect_refused("create n number-line\n", "create s streamlines on=n", "range 1:10 streamlines");
  expect_refused(plane, "create s scatter of=((1 2))", "syntax 1:10 scatter");
}

// ---- Slopes

TEST(Plots, OfFirstAndSecondSlopes) {
  const LoadedFilm s(plane +
                     "create f plot on=ax of=\"sin(x)\"\ncreate d plot on=ax of=\"f'\"\n"
                     "create e plot on=ax of=\"f''\"\ncreate g plot on=ax of=\"d'\"\n"
                     "create a area on=ax of=\"f''\"\ncreate tan tangent on=ax of=\"f'\" at=1\n");
  ASSERT_TRUE(s.loaded.diagnostics.empty()) << said(s.loaded.diagnostics);
  for (const Vec3 p : points_of(s, "d")) EXPECT_NEAR(p.y, std::cos(p.x), 1e-6);
  for (const Vec3 p : points_of(s, "e")) EXPECT_NEAR(p.y, -std::sin(p.x), 1e-4);
  for (const Vec3 p : points_of(s, "g")) EXPECT_NEAR(p.y, -std::sin(p.x), 1e-4);
  for (const Vec3 p : points_of(s, "a")) EXPECT_TRUE(std::abs(p.y) < 1e-9 || std::abs(p.y + std::sin(p.x)) < 1e-4);
  const auto tangent = points_of(s, "tan");
  EXPECT_NEAR((tangent[1].y - tangent[0].y) / (tangent[1].x - tangent[0].x), -std::sin(1), 1e-4);
}

// A slope on a short axis needs short steps, and on one far from 0 long ones.
TEST(Plots, SlopesFitTheirAxes) {
  const LoadedFilm s(
      "create a axes x=(0 0.0001) y=(-2 2) size=(8 4)\ncreate f plot on=a of=\"sin(x * 1e5) / 1e5\"\n"
      "create d plot on=a of=\"f'\"\ncreate b axes x=(100000 100010) y=(-2 2) size=(10 4)\n"
      "create g plot on=b of=\"sin(x)\"\ncreate e plot on=b of=\"g'\"\n");
  for (const Vec3 p : points_of(s, "d")) EXPECT_NEAR(p.y, std::cos((p.x / 8 + 0.5) * 10), 1e-4);
  for (const Vec3 p : points_of(s, "e")) EXPECT_NEAR(p.y, std::cos(p.x + 5 + 100000), 1e-4);
}

TEST(Plots, KnowNamesOfValues) {
  const LoadedFilm s(plane +
                     "let a = 0.5\nlet f = 9\ncreate f plot on=ax of=\"a * x\"\ncreate g plot on=ax of=\"f'\"\n"
                     "create h plot on=ax of=\"a * f\"\nlet again a = 0.25\nat 25f f.of \"a * x\"\n");
  ASSERT_TRUE(s.loaded.diagnostics.empty()) << said(s.loaded.diagnostics);
  for (const Vec3 p : points_of(s, "f")) EXPECT_NEAR(p.y, 0.5 * p.x, 1e-9);
  for (const Vec3 p : points_of(s, "f", "25f")) EXPECT_NEAR(p.y, 0.25 * p.x, 1e-9);
  for (const Vec3 p : points_of(s, "g")) EXPECT_NEAR(p.y, 0.5, 1e-9);  // the plot, not the value
}

TEST(Plots, GiveTheirValuesAndAreasToCode) {
  const LoadedFilm s(plane +
                     "create f plot on=ax of=\"x^2 / 4\"\ncreate a area on=ax of=f from=0 to=1\n"
                     "create b area on=ax of=\"sin(x)\" base=f from=-1 to=0.5\ncreate p circle\n"
                     "set p.position = \"vec(plot.at('f', 1.5), plot.sum('a'), plot.sum('b'))\"\n");
  ASSERT_TRUE(s.loaded.diagnostics.empty()) << said(s.loaded.diagnostics);
  const auto p = s.numbers("p.position", "1f");
  EXPECT_NEAR(p[0], 1.5 * 1.5 / 4, 1e-12);
  EXPECT_NEAR(p[1], 1.0 / 12, 1e-9);
  EXPECT_NEAR(p[2], (std::cos(-1) - std::cos(0.5)) - (0.125 + 1) / 12, 1e-9);
  const LoadedFilm wrong(plane + "create p circle\nset p.position.x = \"plot.sum('p')\"\n");
  std::vector<std::string> problems;
  wrong.program.read(*find_targets("p.position.x", wrong.loaded.document), Time{}, &problems);
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_NE(problems[0].find("neither an area nor a Riemann sum"), std::string::npos) << problems[0];
}

// Formulas of a pattern know their places in it, in commands and in rows.
TEST(Plots, KnowTheirPlacesInAPattern) {
  const LoadedFilm s(plane +
                     "let a = 0.5\ncreate f{1..3} plot on=ax of=\"a * i * x\"\nat 25f f*.of \"(i - n) * x\"\n"
                     "f{1..3}.of\n  49f \"i / 10\"\n");
  ASSERT_TRUE(s.loaded.diagnostics.empty()) << said(s.loaded.diagnostics);
  for (int i = 1; i <= 3; ++i) {
    const std::string f = "f" + std::to_string(i);
    for (const Vec3 p : points_of(s, f)) EXPECT_NEAR(p.y, 0.5 * i * p.x, 1e-9) << f;
    for (const Vec3 p : points_of(s, f, "25f")) EXPECT_NEAR(p.y, (i - 3) * p.x, 1e-9) << f;
    for (const Vec3 p : points_of(s, f, "49f")) EXPECT_NEAR(p.y, i / 10.0, 1e-9) << f;
  }
}

// ---- Error

// The largest distance of a plot from its closed form in pixels of a picture 1920 wide, where the axes fill it: of
// densely sampled points of the form from the nearest piece, and of points on pieces from the form.
double pixels_off(std::vector<Vec3> drawn, const std::vector<Vec3>& form, double width) {
  const auto away = [](Vec3 p, Vec3 a, Vec3 b) {
    const Vec3 way = b - a;
    const double u = std::clamp(dot(p - a, way) / std::max(dot(way, way), 1e-300), 0.0, 1.0);
    return length(p - (a + u * way));
  };
  // Both are graphs in order of x, so only pieces near the x of a point can be the nearest.
  const auto farthest = [&](const std::vector<Vec3>& of, const std::vector<Vec3>& from) {
    double most = 0;
    for (const Vec3 p : of) {
      double nearest = 1e300;
      const auto begin =
          std::lower_bound(from.begin(), from.end(), p.x - 0.02, [](Vec3 a, double x) { return a.x < x; });
      const auto first = std::clamp<std::ptrdiff_t>(begin - from.begin(), 1, std::ssize(from) - 1);
      for (auto i = static_cast<std::size_t>(first); i < from.size(); ++i) {
        nearest = std::min(nearest, away(p, from[i - 1], from[i]));
        if (from[i - 1].x > p.x + 0.02) break;
      }
      most = std::max(most, nearest);
    }
    return most;
  };
  std::vector<Vec3> middles;
  for (std::size_t i = 0; i + 1 < drawn.size(); ++i)
    if (const Vec3 m = 0.5 * (drawn[i] + drawn[i + 1]); std::isfinite(m.x)) middles.push_back(m);
  std::erase_if(drawn, [](Vec3 p) { return !std::isfinite(p.x); });
  return std::max(farthest(middles, form), farthest(form, drawn)) * 1920 / width;
}

TEST(Plots, AreExactAtEveryZoom) {
  struct Case {
    const char* of;
    double (*f)(double);
  };
  const Case cases[] = {{"sin(x)", [](double x) { return std::sin(x); }},
                        {"sin(10 * x)", [](double x) { return std::sin(10 * x); }},
                        {"x^3 - x", [](double x) { return x * x * x - x; }},
                        {"exp(-x^2)", [](double x) { return std::exp(-x * x); }},
                        {"atan(20 * x)", [](double x) { return std::atan(20 * x); }},
                        {"1 / (1 + 25 * x^2)", [](double x) { return 1 / (1 + 25 * x * x); }}};
  double worst = 0;
  for (const Case& one : cases)
    for (const double half : {100.0, 5.0, 0.5, 0.01, 1e-5}) {
      const double high = std::abs(one.f(0)) + half;
      const LoadedFilm s(fmt::format("create ax axes x=({} {}) y=({} {}) size=(16 9)\ncreate f plot on=ax of=\"{}\"\n",
                                     -half, half, -high, high, one.of));
      const auto drawn = points_of(s, "f");
      ASSERT_GT(drawn.size(), 1u);
      std::vector<Vec3> form;
      for (int i = 0; i <= 60'000; ++i) {
        const double x = -half + 2 * half * i / 60'000, y = one.f(x);
        if (std::abs(y) <= high) form.push_back({x / half * 8, y / high * 4.5, 0});
      }
      const double off = pixels_off(drawn, form, 16);
      EXPECT_LT(off, 0.25) << one.of << " at " << half << ", " << drawn.size() << " points";
      worst = std::max(worst, off);
    }
  RecordProperty("worst", fmt::format("{:.3f} pixels", worst));
}

}  // namespace
}  // namespace betwixt
