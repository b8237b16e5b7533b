// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What each command does, by values worked out by hand.
#include "support/loaded_film.h"

namespace betwixt {
namespace {

// The film at the head of the description of the language, word for word.
constexpr const char* bounce = R"(# bounce.bx — a ball bounces along a mirror
rate 24
range 1f 72f

create ball   sphere radius=1 color=gold
create lamp   light  position=(5 10 8) range=60
create eye    camera position=(12 0 42) look-at=(12 0 0) lens=35mm

ball.position
  1f   (0 10 0)
  12f  (4 1 0)    linear
  24f  (8 10 0)   ease-in=4f ease-out=4f

copy  ball.position 1f..24f to 24f shift (8 0 0) times 2
create reflection like ball
scale reflection.position 1f..72f (1 -1 1)
at 24f note "first bounce ends"
)";

// shows: G25 G32 G96
TEST(Bounce, Values) {
  const LoadedFilm s(bounce);
  EXPECT_EQ(s.loaded.diagnostics.size(), 0u) << said(s.loaded.diagnostics);
  EXPECT_EQ(s.loaded.document.frame_count(), 72);
  const std::vector<std::pair<const char*, std::vector<double>>> wanted{
      {"1f", {0, 10, 0}},
      // Between 1f and 12f a cubic: the chord's slope at the end, the slope of the parabola through three events
      // inside.
      {"6.5f", {2 + 121 / 6072.0, 4.46875, 0}},
      {"12f", {4, 1, 0}},
      // Linear, at rest after four frames of braking: speed 6/5, so 0.6 at the middle.
      {"18f", {6.4, 6.4, 0}},
      {"22f", {7.8, 9.55, 0}},
      {"24f", {8, 10, 0}},
      {"29.5f", {10, 5.5, 0}},
      {"35f", {12, 1, 0}},
      {"41f", {14.4, 6.4, 0}},
      {"47f", {16, 10, 0}},
      {"52.5f", {18, 5.5, 0}},
      {"58f", {20, 1, 0}},
      {"70f", {24, 10, 0}},
      {"72f", {24, 10, 0}}};
  for (const auto& [time, v] : wanted) {
    expect_numbers(s, "ball.position", time, v, 1e-9);
    expect_numbers(s, "reflection.position", time, {v[0], -v[1], v[2]}, 1e-9);
    expect_numbers(s, "ball.world", time, {1, 0, 0, v[0], 0, 1, 0, v[1], 0, 0, 1, v[2], 0, 0, 0, 1}, 1e-9);
  }
  const Document& d = s.loaded.document;
  const auto notes = d.notes({}, {flicks_per_second * 3});
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_EQ(notes[0].second, "first bounce ends");
  EXPECT_EQ(format_time(notes[0].first, d), "24f");
}

// shows: G95 G96
TEST(Bounce, ReflectionIsTheMirrorBitForBit) {
  const LoadedFilm s(bounce);
  for (double f = 1; f <= 72; f += 0.25) {
    const auto time = fmt::format("{}f", f);
    const auto a = s.numbers("ball.position", time), b = s.numbers("reflection.position", time);
    EXPECT_EQ(a[0], b[0]) << time;
    EXPECT_EQ(a[1], -b[1]) << time;
    EXPECT_EQ(a[2], b[2]) << time;
  }
}

// Values of x at whole frames from `first` on.
void expect_track(const LoadedFilm& s, const char* target, int first, const std::vector<double>& wanted) {
  for (std::size_t i = 0; i < wanted.size(); ++i)
    expect_numbers(s, target, fmt::format("{}f", first + static_cast<int>(i)), {wanted[i]}, 1e-9);
}

constexpr const char* ramp = "create b sphere\nb.position.x\n  1f 0 linear\n  5f 4 linear\n  9f 0\n";
LoadedFilm after_ramp(const std::string& command) { return LoadedFilm(std::string(ramp) + command + "\n"); }

TEST(Commands, SettingsOfTheDocument) {
  const LoadedFilm s("rate 30000/1001\nticks 60\nrange 1f 100f\nbackground #336699\nnotes off\npolicy ignore\n");
  EXPECT_EQ(s.loaded.document.rate(), (Rate{30000, 1001}));
  EXPECT_EQ(s.loaded.document.frame_count(), 100);
  EXPECT_NEAR(s.program.frame({}).background->x, std::pow((0.2 + 0.055) / 1.055, 2.4), 1e-12);
  EXPECT_EQ(LoadedFilm("").loaded.document.frame_count(), 24);
}

// shows: G18
TEST(Commands, CreateAndLike) {
  const LoadedFilm s(
      "create ball{1..100} sphere radius=2\ncreate {left,right}-eye sphere\nball7.position.x\n 1f 7\n"
      "create twin like ball7\nset twin.radius 3\nball7.position.x\n 1f 8\n");
  EXPECT_EQ(s.loaded.document.names().size(), 103u);
  EXPECT_EQ(s.loaded.document.names()[99], "ball100");
  expect_numbers(s, {{"ball100.radius", "1f", {2}},
                     {"twin.position.x", "1f", {7}},
                     {"twin.radius", "1f", {3}},
                     {"ball7.radius", "1f", {2}}});
}

// shows: G26 G28
TEST(Commands, EveryKindHasItsParameters) {
  const LoadedFilm s(
      "create a group\ncreate b sphere radius=2\ncreate c box size=(1 2 3)\ncreate d cylinder radius=1 height=2\n"
      "create e cone radius=1 height=2\ncreate f torus radius=1 tube=0.3\ncreate g plane size=(1 2)\n"
      "create h disc radius=3\ncreate i polygon points=((0 0) (1 0) (0 1))\ncreate j polyline points=((0 0) (1 1)) "
      "width=1\n"
      "create k points points=((0 0 1)) size=1\ncreate l text text=\"x\"\ncreate m light\ncreate n camera\n");
  EXPECT_EQ(s.loaded.document.names().size(), 14u);
  EXPECT_EQ(s.program.frame({}).items.size(), 11u);
  expect_numbers(s, {{"f.tube", "1f", {0.3}}, {"n.lens", "1f", {35}}, {"m.range", "1f", {20}}});
}

TEST(Commands, SetIsTheValueWithoutEvents) {
  expect_numbers(LoadedFilm("create b sphere\nset b.position (1 2 3)\n"), "b.position", "9f", {1, 2, 3});
  expect_numbers(LoadedFilm("create b sphere\nset b.position.y 2\n"), "b.position", "9f", {0, 2, 0});
  expect_numbers(after_ramp("set b.position (9 8 7)"), "b.position", "5f", {4, 8, 7});
}

// shows: G32 G53
TEST(Commands, AtIsARowInOneLine) {
  const LoadedFilm s(
      "create b sphere\nat 1f b.radius 1 linear\nat 5f b.radius 3\nat 3f b.radius 9\nat 3f b.radius 5 linear\n");
  expect_track(s, "b.radius", 1, {1, 3, 5, 4, 3, 3});
}

// shows: G42 G48
TEST(Commands, CutJumpsAndKeepChangesTheTwerper) {
  const LoadedFilm s("create b sphere\nb.radius\n 1f 0 linear\n 5f 4 cut 10 linear\n 9f 14\n");
  expect_track(s, "b.radius", 1, {0, 1, 2, 3, 10, 11, 12, 13, 14});
  const LoadedFilm k("create b sphere\nb.radius\n 1f 0 linear\n 5f keep hold\n 9f 8\n");
  expect_track(k, "b.radius", 1, {0, 1, 2, 3, 4, 4, 4, 4, 8});
}

// shows: G44 G50 G103
TEST(Commands, Twerpers) {
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

TEST(Commands, Extrapolation) {
  const LoadedFilm cycle = after_ramp("extend b.position.x cycle after\nextend b.position.x linear before");
  expect_track(cycle, "b.position.x", 9, {0, 1, 2, 3, 4, 3, 2, 1, 0, 1});
  expect_numbers(cycle, "b.position.x", "-1f", {-2}, 1e-9);
  const LoadedFilm half("create b sphere\nb.position.x\n 1f 0 linear\n 5f 4\nextend b.position.x bounce\n");
  expect_track(half, "b.position.x", 3, {2, 3, 4, 3, 2, 1, 0, 1});
  expect_numbers(half, "b.position.x", "-1f", {2}, 1e-9);
  expect_track(after_ramp("extend b.position.x cycle\nextend b.position.x hold"), "b.position.x", 9, {0, 0, 0});
}

// shows: G93 G95
TEST(Commands, CopyTimesShiftOn) {
  const LoadedFilm s = after_ramp("copy b.position.x 1f..9f to 9f shift 10 times 2");
  expect_track(s, "b.position.x", 1, {0, 1, 2, 3, 4});
  expect_numbers(s, "b.position.x", "9f", {10}, 1e-9);
  expect_numbers(s, "b.position.x", "13f", {14}, 1e-9);
  expect_numbers(s, "b.position.x", "17f", {20}, 1e-9);
  expect_numbers(s, "b.position.x", "21f", {24}, 1e-9);
  expect_numbers(s, "b.position.x", "25f", {20}, 1e-9);
  const LoadedFilm on = after_ramp("create c sphere\ncopy b.position.x 1f..5f to 11f on c.position.y");
  expect_track(on, "c.position.y", 10, {0, 0, 1, 2, 3, 4, 4});
  expect_track(on, "b.position.x", 1, {0, 1, 2, 3, 4, 3, 2, 1, 0});
  // What stood in the range gives way.
  const LoadedFilm over("create b sphere\nb.radius\n 1f 1 linear\n 3f 3\n 6f 99\n 7f 50\ncopy b.radius 1f..3f to 5f\n");
  expect_numbers(over, "b.radius", "6f", {2}, 1e-9);
}

// shows: G38 G39 G40
TEST(Commands, OperationsOnTimes) {
  expect_track(after_ramp("move b.position.x 5f..9f by 2f"), "b.position.x", 7, {4, 3, 2, 1, 0});
  expect_track(after_ramp("move b.position.x 1f..9f by -48f"), "b.position.x", -47, {0, 1, 2, 3, 4, 3});
  const LoadedFilm s = after_ramp("stretch b.position.x 1f..9f by 2");
  expect_track(s, "b.position.x", 1, {0, 0.5, 1, 1.5, 2, 2.5, 3, 3.5, 4, 3.5});
  const LoadedFilm r("create b sphere\nb.radius\n 1f 0 linear\n 2f 4 linear\n 5f 1\nreverse b.radius 1f..5f\n");
  expect_track(r, "b.radius", 1, {1, 2, 3, 4, 0});
}

// shows: G92 G93 G94
TEST(Commands, OperationsOnValues) {
  const char* head = "create b sphere\nb.position\n 1f (1 2 3) linear\n 5f (4 5 6)\n 9f (7 7 7)\n";
  const auto does = [&](const char* command) { return LoadedFilm(std::string(head) + command + "\n"); };
  expect_numbers(does("scale b.position 1f..5f (1 -1 2)"), "b.position", "1f", {1, -2, 6});
  expect_numbers(does("scale b.position 1f..5f 3"), "b.position", "5f", {12, 15, 18});
  expect_numbers(does("scale b.position 1f..5f 3"), "b.position", "9f", {7, 7, 7});
  expect_numbers(does("translate b.position 5f..9f (0 1 0)"), "b.position", "5f", {4, 6, 6});
  expect_numbers(does("rotate b.position 1f..1f 90deg y"), "b.position", "1f", {3, 2, -1});
  expect_numbers(does("rotate b.position 1f..1f 90deg z @ (1 0 0)"), "b.position", "1f", {-1, 0, 3});
  expect_numbers(does("rotate b.position 1f..1f 0.25turn (0 0 2)"), "b.position", "1f", {-2, 1, 3});
  expect_numbers(does("clear b.position 5f"), "b.position", "5f", {4, 4.5, 5});
  expect_numbers(does("clear b.position 1f..5f"), "b.position", "1f", {7, 7, 7});
}

// shows: G2
TEST(Commands, StaggerAndSpread) {
  const LoadedFilm s(
      "create b{1..3} sphere\nb*.radius\n 1f 1 linear\n 5f 5\nstagger b*.radius by 2f\n"
      "spread b*.position from (0 0 0) to (10 20 0)\n");
  expect_track(s, "b1.radius", 1, {1, 2, 3, 4, 5});
  expect_track(s, "b2.radius", 1, {1, 1, 1, 2, 3, 4, 5});
  expect_track(s, "b3.radius", 1, {1, 1, 1, 1, 1, 2, 3, 4, 5});
  expect_numbers(
      s, {{"b1.position", "1f", {0, 0, 0}}, {"b2.position", "1f", {5, 10, 0}}, {"b3.position", "1f", {10, 20, 0}}});
  const char* random = "create b{1..20} sphere\nb*.radius\n 1f 1 hold\n 2f 2\nstagger b*.radius by 1f random 7\n";
  EXPECT_EQ(read(random).document, read(random).document);
  // The same starts, in another order: at frame 12 the eleven that have started are among any eleven.
  const LoadedFilm r(random);
  double sum = 0, orderly = 0;
  for (int i = 1; i <= 20; ++i) {
    sum += r.numbers(fmt::format("b{}.radius", i), "12f")[0];
    orderly += i == 1 + static_cast<int>(r.numbers(fmt::format("b{}.radius", i), "12f")[0] == 2);
  }
  EXPECT_EQ(sum, 20 + 11);
}

// shows: G61 G80
TEST(Commands, HierarchyByNameAndByCouple) {
  const LoadedFilm s(
      "create car group position=(10 0 0)\ncreate car/wheel sphere position=(1 0 0) attach-position=(0 1 0)\n"
      "create dog sphere position=(0 0 5)\ncouple dog to car/wheel\ncreate cat sphere position=(0 0 5)\n"
      "couple cat to car\ndetach cat\nset car.scale (2 2 2)\nrename car bus\n");
  const Frame f = s.program.frame({});
  const auto at = [&](const char* name) {
    const auto m = s.numbers(std::string(name) + ".world", "1f");
    return std::vector<double>{m[3], m[7], m[11]};
  };
  EXPECT_EQ(at("car/wheel"), (std::vector<double>{12, 2, 0}));  // the name stays
  EXPECT_EQ(at("dog"), (std::vector<double>{12, 2, 10}));
  EXPECT_EQ(at("cat"), (std::vector<double>{0, 0, 5}));
}

// shows: G18
TEST(Commands, RenameKeepsWhatSpeaksOfIt) {
  const LoadedFilm s(
      "create a sphere position=(1 2 3)\ncreate eye camera look-at=a\ncreate b box\nset b.geometry shape(a)\n"
      "alias both = a b\nrename a c\nset both.radius 1\nset both.color red\nremove b\n");
  EXPECT_EQ(s.loaded.document.names(), (std::vector<std::string>{"c", "eye"}));
  EXPECT_EQ(std::get<ObjectId>(s.read("eye.look-at", "1f")), s.loaded.document.find("c"));
  expect_numbers(s, "c.color", "1f", {1, 0, 0});
}

// shows: G28 G69
TEST(Commands, LookThroughShowHide) {
  const LoadedFilm s(
      "create a camera position=(1 0 0)\ncreate b camera position=(2 0 0)\nat 5f look through b\nat 9f look through a\n"
      "create ball sphere\nat 5f hide ball\nat 9f show ball\ncreate gone sphere\nhide gone\n");
  EXPECT_EQ(s.frame("4f").camera.world(0, 3), 1);
  EXPECT_EQ(s.frame("5f").camera.world(0, 3), 2);
  EXPECT_EQ(s.frame("9f").camera.world(0, 3), 1);
  expect_numbers(s, "ball.display", "5f", {0});
  EXPECT_EQ(s.frame("6f").items.size(), 0u);
  EXPECT_EQ(s.frame("9f").items.size(), 1u);
}

// shows: G64 G65 G66 G67
TEST(Commands, PatternsAndAliases) {
  const LoadedFilm s(
      "create wheel{1..3} sphere\ncreate car group\ncreate car/wheel1 sphere\nalias wheels = wheel* spare\n"
      "set wheel*.color red\ncreate wheel4 sphere\nset wheels.radius 5\nset wheel[12].shininess 0.5\n"
      "set car/*.transparency 0.5\nset wheel?.position.{x,y} 3\ncreate spare sphere\nset wheels.pivot (1 1 1)\n");
  EXPECT_FALSE(has_errors(s.loaded.diagnostics));
  expect_numbers(s, {{"wheel3.color", "1f", {1, 0, 0}},
                     {"wheel4.color", "1f", {1, 1, 1}},      // made after
                     {"car/wheel1.color", "1f", {1, 1, 1}},  // * does not cross /
                     {"wheel4.radius", "1f", {5}},           // read at each use
                     {"spare.radius", "1f", {1}},
                     {"spare.pivot", "1f", {1, 1, 1}},
                     {"wheel2.shininess", "1f", {0.5}},
                     {"wheel3.shininess", "1f", {0}},
                     {"car/wheel1.transparency", "1f", {0.5}},
                     {"wheel1.position", "1f", {3, 3, 0}}});
  const auto nothing = read("set nobody*.color red\nnobody*.color\n  1f red\n  what ever\nat 3f nobody?.color blue\n");
  EXPECT_FALSE(has_errors(nothing.diagnostics)) << said(nothing.diagnostics);
  ASSERT_FALSE(nothing.diagnostics.empty());
  EXPECT_EQ(nothing.diagnostics[0].severity, Severity::notice);
  EXPECT_EQ(nothing.diagnostics[0].what.message, "'nobody*' names nothing");
}

TEST(Commands, AliasesThatGoRoundOrMultiplyEnd) {
  std::string text = "create ball sphere\nalias a = b ball\nalias b = a\nset a.radius 2\n";
  for (int i = 0; i < 60; ++i) text += fmt::format("alias t{} = t{} t{}\n", i, i + 1, i + 1);
  text += "alias t60 = ball\nset t0.radius 3\n";
  expect_numbers(LoadedFilm(text), "ball.radius", "1f", {3});
  std::string deep = "create ball sphere\n";
  for (int i = 0; i < 100'000; ++i) deep += fmt::format("alias t{} = t{}\n", i, i + 1);
  deep += "alias t100000 = ball\nset t0.radius 3\n";
  expect_numbers(LoadedFilm(deep), "ball.radius", "1f", {3});
}

// shows: G14
TEST(Commands, Define) {
  const LoadedFilm s(
      "define heat number 20\ndefine wind vector\ndefine glow color red\ndefine angle2 angle 90deg\ndefine lit boolean "
      "on\n"
      "define label text \"x\"\ndefine turn orientation\ncreate b sphere heat=30\ncreate c sphere\nb.wind\n 1f (0 0 0) "
      "linear\n"
      " 3f (2 4 6)\nat 2f b.wind.y 9\nset c.lit off\n");
  expect_numbers(s, {{"b.heat", "1f", {30}},
                     {"c.heat", "1f", {20}},
                     {"b.wind", "2f", {1, 9, 3}},
                     {"c.glow", "1f", {1, 0, 0}},
                     {"b.lit", "1f", {1}},
                     {"c.lit", "1f", {0}}});
  EXPECT_EQ(s.text("c.label", "1f"), "x");
}

// shows: G27
TEST(Commands, PolicyDecidesWhatAMeaninglessValueGets) {
  const LoadedFilm translate("create b sphere\npolicy translate\nset b.radius (3 4 0)\nset b.position 2\n");
  expect_numbers(translate, "b.radius", "1f", {5});
  expect_numbers(translate, "b.position", "1f", {2, 2, 2});
  const Loaded ignore = read("create b sphere\npolicy ignore\nset b.radius (3 4 0)\nset b.radius 2\n");
  ASSERT_EQ(ignore.diagnostics.size(), 1u);
  EXPECT_EQ(ignore.diagnostics[0].severity, Severity::warning);
  EXPECT_EQ(ignore.diagnostics[0].what.message, "ignored: a number is wanted here, not a vector");
  EXPECT_EQ(errors(read("create b sphere\nset b.radius (3 4 0)\n")),
            (std::vector<std::string>{"2:14: a number is wanted here, not a vector"}));
}

// shows: G33
TEST(Sheets, RowsInAnyOrderWithCommentsAndBlankLines) {
  const Document wanted = read("create b sphere\nb.radius\n 1f 1 linear\n 3f 3\n 5f 9\n").document;
  EXPECT_EQ(read("create b sphere\nb.radius\n\t5f 9\n\n# here\n  1f 1 linear   # there\n\n      3f 3").document,
            wanted);
  EXPECT_EQ(read("create b sphere\r\nb.radius\r\n  1f 1 linear\r\n  3f 3\r\n  5f 9\r\n").document, wanted);
  EXPECT_EQ(read("\xEF\xBB\xBF"
                 "create b sphere\nb.radius\n  1f 1 linear\n  3f 3\n  5f 9\n")
                .document,
            wanted);
  EXPECT_EQ(read("create b sphere\nb.radius\n  5f 9\nb.radius\n  3f 3\n  1f 2\n  1f 1 linear\n").document, wanted);
  EXPECT_EQ(read("create b sphere\nalias all = b\nall.radius\n  1f 1 linear\n  3f 3\n  5f 9\n").document.names().size(),
            1u);
}

// shows: G2 G26
TEST(Sheets, ManyObjectsAndComponents) {
  const LoadedFilm s("create b{1..2} sphere\nb*.position.y\n  1f 0 linear\n  3f 2\nb1.position\n  2f (1 1 1)\n");
  expect_numbers(s, "b2.position", "2f", {0, 1, 0}, 1e-9);
  expect_numbers(s, "b1.position", "2f", {1, 1, 1}, 1e-9);
}

// The parabola through 0, 1, 1 at 10f, 20f, 60f leads past 1: transparency stays where it means something.
TEST(Commands, ValuesStayWithinWhatTheFunctionCanBe) {
  const LoadedFilm s(
      "create a sphere\na.transparency\n 1f 0\n 10f 0\n 20f 1\n 60f 1\na.radius\n 1f 1\n 10f 0\n 60f 0.1\n");
  for (int f = 1; f <= 60; ++f) {
    const auto at = std::to_string(f) + "f";
    EXPECT_GE(s.numbers("a.transparency", at)[0], 0) << at;
    EXPECT_LE(s.numbers("a.transparency", at)[0], 1) << at;
    EXPECT_GE(s.numbers("a.radius", at)[0], 0) << at;
  }
  expect_numbers(s, "a.transparency", "40f", {1});
}

TEST(Commands, LookAtHasComponents) {
  const LoadedFilm s("create c camera position=(0 0 10)\nc.look-at.x\n 1f 0 linear\n 11f 10\nc.look-at.y\n 1f 2\n");
  expect_numbers(s, "c.look-at", "6f", {5, 2, 0});
  expect_numbers(s, "c.look-at.x", "6.5f", {5.5});
}

TEST(Commands, RowsOfOneTimeAreWarnedOf) {
  const LoadedFilm twice("create a sphere\na.position\n 1f (0 0 0)\n 1f (4 0 0)\n");
  EXPECT_NE(said(twice.loaded.diagnostics).find("test.bx:4:5: warning: an earlier row of this sheet has the same time"),
            std::string::npos);
  expect_numbers(twice, "a.position", "1f", {4, 0, 0});
  // Another sheet may well replace an event.
  const LoadedFilm again("create a sphere\na.position\n 1f (0 0 0)\na.position\n 1f (4 0 0)\n");
  EXPECT_TRUE(again.loaded.diagnostics.empty());
}

TEST(Commands, ColoursBeyondBrightAreWarnedOf) {
  const LoadedFilm s("create a sphere color=rgb(255 0 0)\n");
  EXPECT_NE(said(s.loaded.diagnostics).find("write rgb(1 0 0)"), std::string::npos);
}

}  // namespace
}  // namespace betwixt
