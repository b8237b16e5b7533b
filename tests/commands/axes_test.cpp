// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests axes, plots and charts in films.
#include <cmath>

#include "support/loaded_film.h"

namespace betwixt {
namespace {

const std::string axes = "film flat\ncreate ax axes x=(0 10) y=(-2 2) size=(10 4)\n";

std::vector<Vec3> points(const LoadedFilm& s, std::string_view of, std::string_view when = "1f") {
  return *std::get<Points>(s.read(std::string(of) + ".points", std::string(when)));
}
TEST(AxesOfFilms, PlaceWhatIsOnThem) {
  const LoadedFilm s(axes +
                     "set ax.position (1 2 0)\ncreate dot circle radius=0.06 on=ax position=(2 0.9)\n"
                     "at 1f ax.x (0 10) linear\nat 25f ax.x (0 4)\n");
  EXPECT_TRUE(s.loaded.diagnostics.empty()) << said(s.loaded.diagnostics);
  EXPECT_NEAR(length(place(s, "dot", "1f") - Vec3{1 + 2 - 5, 2 + 0.9, 0}), 0, 1e-12);
  EXPECT_NEAR(length(place(s, "dot", "25f") - Vec3{1 + 5 - 5, 2 + 0.9, 0}), 0, 1e-12);
  EXPECT_NEAR(place(s, "dot", "13f").x, 1 + 2.0 / 7 * 10 - 5, 1e-9);  // the ends of the axis move, not the dot
  EXPECT_EQ(std::get<Vec3>(s.read("dot.position", "25f")), (Vec3{2, 0.9, 0}));
  const Mat4 m = *std::get<Matrix>(s.read("dot.world", "25f"));
  EXPECT_EQ(m(0, 0), 1);  // zooming stretches no circle
}

TEST(AxesOfFilms, PlaceEveryKind) {
  for (const char* kind : {"star", "sphere", "text text=\"a\"", "group", "light", "line", "arrow"}) {
    const LoadedFilm s(axes + "create a " + kind + " on=ax position=(7 1)\n");
    EXPECT_NEAR(length(place(s, "a", "1f") - Vec3{2, 1, 0}), 0, 1e-12) << kind;
  }
}

TEST(AxesOfFilms, PointsAreNumbersToo) {
  const LoadedFilm s(axes + "create way polyline on=ax points=((0 0) (10 2))\n");
  const auto frame = s.frame("1f");
  bool found = false;
  for (const Item& item : frame.items)
    if (item.shape->kind == Kind::polyline && item.shape->width == 0.05) {
      found = true;
      EXPECT_EQ(*item.shape->points, (std::vector<Vec3>{{-5, 0, 0}, {5, 2, 0}}));
    }
  EXPECT_TRUE(found);
}

TEST(AxesOfFilms, CodeConvertsBothWays) {
  const LoadedFilm s(axes +
                     "create a group\nset a.position = \"axes.place('ax', vec(2, 1))\"\ncreate b group\n"
                     "set b.position = \"axes.numbers('ax', vec(-3, 1))\"\n");
  EXPECT_EQ(std::get<Vec3>(s.read("a.position", "1f")), (Vec3{-3, 1, 0}));
  EXPECT_EQ(std::get<Vec3>(s.read("b.position", "1f")), (Vec3{2, 1, 0}));
}

// The largest distance of the middles of all pieces from the curve y = f(x), in metres. A quarter of a pixel, if the
// axes fill a picture 1920 pixels wide, is 10/7680 m.
double error_of(const std::vector<Vec3>& all, double (*f)(double)) {
  double most = 0;
  for (std::size_t i = 0; i + 1 < all.size(); ++i) {
    if (!std::isfinite(all[i].x) || !std::isfinite(all[i + 1].x)) continue;
    const Vec3 a = all[i], b = all[i + 1], m = 0.5 * (a + b);
    // The nearest point of the curve, by search.
    double nearest = 1e300;
    const double reach = 0.02 + std::abs(b.x - a.x);
    for (int k = -400; k <= 400; ++k) {
      const double x = m.x + reach * k / 400;
      nearest = std::min(nearest, std::hypot(x - m.x, f(x + 5) - m.y));
    }
    most = std::max(most, nearest);
  }
  return most;
}

TEST(Plots, AreWithinAQuarterOfAPixel) {
  struct Case {
    const char* of;
    double (*f)(double);
  };
  const Case cases[] = {{"sin(x)", [](double x) { return std::sin(x); }},
                        {"sin(x^2 / 2)", [](double x) { return std::sin(x * x / 2); }},
                        {"exp(-(x - 5)^2 * 40)", [](double x) { return std::exp(-(x - 5) * (x - 5) * 40); }},
                        {"sqrt(x) - 1", [](double x) { return std::sqrt(x) - 1; }},
                        {"abs(x - 3) - 1", [](double x) { return std::abs(x - 3) - 1; }},
                        {"1 / (x - 4)", [](double x) { return 1 / (x - 4); }}};
  for (const Case& one : cases) {
    const LoadedFilm s(axes + "create f plot on=ax of=\"" + one.of + "\"\n");
    ASSERT_TRUE(s.loaded.diagnostics.empty()) << said(s.loaded.diagnostics);
    const auto all = points(s, "f");
    ASSERT_GT(all.size(), 10u) << one.of;
    EXPECT_LT(error_of(all, one.f), 10.0 / 7680 + 1e-4) << one.of << " " << all.size();
    EXPECT_LT(all.size(), 4000u) << one.of;
  }
}

std::size_t breaks(const std::vector<Vec3>& all) {
  std::size_t count = 0;
  for (const Vec3 p : all) count += std::isfinite(p.x) ? 0 : 1;
  return count;
}

TEST(Plots, DoNotJoinJumpsPolesAndGaps) {
  const LoadedFilm s(
      axes +
      "create floor plot on=ax of=\"floor(x / 4) - 1\"\ncreate pole plot on=ax of=\"1 / (x - 5)\"\n"
      "create root plot on=ax of=\"sqrt(x - 2.5)\"\ncreate gap plot on=ax of=\"sqrt((x - 3) * (x - 4))\"\n"
      "create whole plot on=ax of=\"sqrt(x)\"\ncreate empty plot on=ax of=\"0/0 + x\"\n");
  EXPECT_EQ(breaks(points(s, "floor")), 2u);
  EXPECT_EQ(breaks(points(s, "pole")), 1u);
  EXPECT_EQ(breaks(points(s, "root")), 0u);
  EXPECT_NEAR(points(s, "root").front().x, 2.5 - 5, 1e-9);  // the end of the domain is found
  EXPECT_EQ(breaks(points(s, "gap")), 1u);
  EXPECT_EQ(breaks(points(s, "whole")), 0u);
  EXPECT_TRUE(points(s, "empty").empty());
  for (const Vec3 p : points(s, "pole"))
    if (std::isfinite(p.x)) EXPECT_LE(std::abs(p.y), 2 + 1e-9);  // nothing is drawn beside the axes
}

TEST(Plots, OfVectorsAndEquations) {
  const LoadedFilm s(
      "create ax axes x=(-4 4) y=(-2 2) size=(8 4)\ncreate c plot on=ax of=\"vec(cos(u), sin(u))\"\n"
      "create i plot on=ax of=\"x^2 + y^2 = 2\"\n");
  EXPECT_GT(points(s, "c").size(), 30u);
  for (const Vec3 p : points(s, "c")) EXPECT_NEAR(std::hypot(p.x, p.y), 1, 1e-9);
  EXPECT_GT(points(s, "i").size(), 100u);
  for (const Vec3 p : points(s, "i"))
    if (std::isfinite(p.x)) EXPECT_NEAR(std::hypot(p.x, p.y), std::sqrt(2), 1e-5);
}

TEST(Plots, AreFunctionsOfTimeAndOfOtherPlots) {
  const LoadedFilm s(axes +
                     "create f plot on=ax of=\"sin(x - t)\"\ncreate d plot on=ax of=\"f'\"\n"
                     "create tan tangent on=ax of=f at=2 length=2\ncreate sec tangent on=ax of=f at=2 step=1\n");
  ASSERT_TRUE(s.loaded.diagnostics.empty()) << said(s.loaded.diagnostics);
  const double t = 1;  // frame 25
  for (const Vec3 p : points(s, "d", "25f")) EXPECT_NEAR(p.y, std::cos(p.x + 5 - t), 1e-5);
  const auto tangent = points(s, "tan", "25f");
  ASSERT_EQ(tangent.size(), 2u);
  EXPECT_NEAR((tangent[1].y - tangent[0].y) / (tangent[1].x - tangent[0].x), std::cos(2 - t), 1e-6);
  EXPECT_NEAR(length(tangent[1] - tangent[0]), 2, 1e-12);
  const auto secant = points(s, "sec", "25f");
  EXPECT_NEAR((secant[1].y - secant[0].y) / (secant[1].x - secant[0].x), std::sin(3 - t) - std::sin(2 - t), 1e-9);
}

TEST(Plots, SumsOfRectanglesTendToTheIntegral) {
  const LoadedFilm s(
      "create ax axes x=(0 4) y=(0 4)\ncreate r riemann on=ax of=\"x^2 / 4\" from=1 to=3 count=1000 "
      "touch=middle\ncreate v text\nset v.text = \"plot.sum('r')\"\n");
  EXPECT_NEAR(std::stod(*std::get<Text>(s.read("v.text", "1f"))), (27 - 1) / 12.0, 1e-6);
  EXPECT_EQ(points(s, "r").size(), 1000u * 4 + 999);
}

TEST(Charts, ShowTheirValues) {
  const LoadedFilm s(
      "create b columns of=(3 1 4) keys=(\"Ann\" \"Bob\" \"Cyd Low\") size=(6 4)\n"
      "at 1f b/Bob.value 1 linear\nat 25f b/Bob.value 8\n");
  ASSERT_TRUE(s.loaded.diagnostics.empty()) << said(s.loaded.diagnostics);
  EXPECT_NEAR(std::get<Vec3>(s.read("b/Ann.extent", "1f")).y, 3, 1e-12);  // 4 m for 4
  EXPECT_NEAR(std::get<Vec3>(s.read("b/Ann.extent", "1f")).x, 1.5, 1e-12);
  EXPECT_NEAR(std::get<Vec3>(s.read("b/Ann.extent", "25f")).y, 1.5, 1e-12);  // 4 m for 8
  EXPECT_EQ(std::get<Vec3>(s.read("b/Cyd-Low.position", "1f")), (Vec3{2, -2, 0}));
  EXPECT_EQ(*std::get<Text>(s.read("b/Bob/number.text", "13f")), "4.50");
}

TEST(Charts, GlideIfTheyAreSorted) {
  const LoadedFilm s("create b bars of=(3 1) size=(4 2) sorted=on\nat 1f b/2.value 1 linear\nat 49f b/2.value 5\n");
  const auto y = [&](const char* bar, const char* when) {
    return std::get<Vec3>(s.read(std::string(bar) + ".position", when)).y;
  };
  EXPECT_NEAR(y("b/1", "1f"), 0.5, 1e-9);
  EXPECT_NEAR(y("b/1", "49f"), -0.5, 1e-9);
  EXPECT_NEAR(y("b/2", "49f"), 0.5, 1e-9);
  const double between = y("b/1", "25f");  // they are equal there
  EXPECT_LT(between, 0.5);
  EXPECT_GT(between, -0.5);
}

TEST(Charts, OfSlicesAndCells) {
  const LoadedFilm s(
      "create p pie of=(1 1 2) radius=2 hole=1\ncreate m matrix of=((1 2) (3 4)) cell=(1 1)\n"
      "create t table of=((\"a\" 1) (\"b\" 2.5))\n");
  ASSERT_TRUE(s.loaded.diagnostics.empty()) << said(s.loaded.diagnostics);
  EXPECT_NEAR(std::get<double>(s.read("p/1.from", "1f")), pi / 2, 1e-12);
  EXPECT_NEAR(std::get<double>(s.read("p/3.to", "1f")), pi / 2 - 2 * pi, 1e-12);
  EXPECT_NEAR(std::get<double>(s.read("p/2.radius", "1f")), 1.5, 1e-12);
  EXPECT_EQ(*std::get<Text>(s.read("m/2-1.text", "1f")), "3");
  EXPECT_EQ(*std::get<Text>(s.read("t/2-2.text", "1f")), "2.5");
}

TEST(AxesOfFilms, AreWrittenWithTheirPieces) {
  const LoadedFilm s(axes +
                     "create f plot on=ax of=\"sin(x)\"\ncreate dot circle on=ax position=(1 1)\n"
                     "create b bars of=(3 1) keys=(\"Ann\" \"Bob\")\ncreate p pie of=(1 2)\n");
  const std::string text = write(s.loaded.document);
  const auto again = load_text(text, "again.bx");
  EXPECT_TRUE(again.diagnostics.empty()) << said(again.diagnostics) << text;
  EXPECT_TRUE(again.document == s.loaded.document) << text;
}

TEST(AxesOfFilms, AreCopiedRenamedAndRemovedAsOne) {
  const LoadedFilm s(axes + "create two like ax position=(0 -3 0)\nset two.x (0 5)\nrename ax one\n");
  ASSERT_TRUE(s.loaded.diagnostics.empty()) << said(s.loaded.diagnostics);
  EXPECT_NEAR(points(s, "two/x").front().x, -5, 1e-12);
  EXPECT_EQ(*std::get<Text>(s.read("two/x/1.text", "1f")), "0.5");  // 0 would be on the other axis
  EXPECT_EQ(*std::get<Text>(s.read("one/x/1.text", "1f")), "1");
  EXPECT_TRUE(LoadedFilm(axes + "remove ax\n").loaded.document.find("ax/x") == ObjectId{});
}

struct Wrong {
  const char* line;
  int column;
  ErrorCode code;
  const char* message;
};

TEST(AxesOfFilms, SayWhatIsWrong) {
  const Wrong all[] = {
      {"create a axes x=(2 2)", 10, ErrorCode::range, "the two ends of x must be different"},
      {"create a axes x=(0 10 -1)", 10, ErrorCode::range, "the step of x must not be below 0"},
      {"create a axes y=(-1 10) y-scale=log", 10, ErrorCode::range,
       "y has a logarithmic scale, so both its ends must be above 0"},
      {"create a axes x=(0 1e300)", 17, ErrorCode::range, nullptr},
      {"create f plot of=\"x\"", 10, ErrorCode::syntax, "a plot needs axes"},
      {"create f plot on=ax of=\"sin(x\"", 25, ErrorCode::syntax,
       "the formula has an error: ')' expected (to close '(') at its end"},
      {"create f plot on=ax of=\"2x\"", 25, ErrorCode::syntax,
       "the formula has an error: malformed number near '2x'; write 2*x for the product"},
      {"create f plot on=ball of=\"x\"", 8, ErrorCode::type, "'ball' is a sphere, which has no coordinates"},
      {"create f plot on=nowhere", 18, ErrorCode::name, nullptr},
      {"create b bars", 10, ErrorCode::syntax, "a chart of bars needs its values"},
      {"create b bars of=(1 2) keys=(\"a\")", 15, ErrorCode::range, "there are 2 values and 1 keys"},
      {"create b bars of=(1 red)", 15, ErrorCode::range, "the values of a chart are numbers"},
      {"create b bars of=()", 18, ErrorCode::syntax, "the list must have at least one value"},
      {"create p pie of=(1 -2)", 14, ErrorCode::range, "the values of a pie must not be below 0"},
      {"create m matrix of=((1 2) (3))", 17, ErrorCode::range, nullptr},
      {"create m matrix of=3", 20, ErrorCode::syntax, "a list in brackets is missing here"},
      {"create a axes radius=3", 15, ErrorCode::name, "a set of axes has no 'radius'"},
  };
  for (const Wrong& one : all) {
    const auto got = load_text(axes + "create ball sphere\n" + one.line + "\n", "wrong.bx");
    ASSERT_EQ(got.diagnostics.size(), 1u) << one.line << said(got.diagnostics);
    const Diagnostic& d = got.diagnostics[0];
    EXPECT_EQ(d.what.code, one.code) << one.line << said(got.diagnostics);
    EXPECT_EQ(d.what.place.line, 4) << one.line;
    EXPECT_EQ(d.what.place.column, one.column) << one.line << said(got.diagnostics);
    if (one.message) EXPECT_EQ(d.what.message, one.message) << one.line;
    EXPECT_FALSE(got.document.find("a")) << "nothing is left of what failed";
  }
}

TEST(Plots, ThatFailLaterSayWhy) {
  const LoadedFilm s(axes + "create f plot on=ax of=\"nosuch(x)\"\n");
  std::vector<std::string> problems;
  s.program.read(*find_targets("f.points", s.loaded.document), {}, &problems);
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_NE(problems[0].find("attempt to call a nil value (global 'nosuch')"), std::string::npos) << problems[0];
}

TEST(Plots, EndWhateverTheFormula) {
  for (const char* of : {"sin(1/x)", "x * 0/0", "1e308 * x * 10", "(function() while true do end end)()",
                         "hash(x, 0, 0)", "tan(x * 50)", "floor(x * 1000)"}) {
    const LoadedFilm s(axes + "create f plot on=ax of=\"" + of + "\"\n");
    std::vector<std::string> problems;
    s.program.read(*find_targets("f.points", s.loaded.document), {}, &problems);
    const bool endless = std::string_view(of).find("while") != std::string_view::npos;
    EXPECT_EQ(problems.size(), endless ? 1u : 0u) << of;
    if (endless) EXPECT_NE(problems.at(0).find("it took more than 1000000 steps"), std::string::npos) << problems.at(0);
  }
}

}  // namespace
}  // namespace betwixt
