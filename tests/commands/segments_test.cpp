// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests operations on segments of tracks. The values are computed by hand.
#include <array>
#include <functional>

#include "betwixt/object.h"
#include "betwixt/track.h"
#include "commands/tracks.h"
#include "support/dice.h"

namespace betwixt {
namespace {

// shows: G38 G39 G40
TEST(Segments, OperationsOnTimes) {
  expect_track(after_ramp("move b.position.x 5f..9f by 2f"), "b.position.x", 7, {4, 3, 2, 1, 0});
  expect_track(after_ramp("move b.position.x 1f..9f by -48f"), "b.position.x", -47, {0, 1, 2, 3, 4, 3});
  const LoadedFilm s = after_ramp("stretch b.position.x 1f..9f by 2");
  expect_track(s, "b.position.x", 1, {0, 0.5, 1, 1.5, 2, 2.5, 3, 3.5, 4, 3.5});
  const LoadedFilm r("create b sphere\nb.radius\n 1f 0 linear\n 2f 4 linear\n 5f 1\nreverse b.radius 1f..5f\n");
  expect_track(r, "b.radius", 1, {1, 2, 3, 4, 0});
}

// shows: G92 G93 G94
TEST(Segments, OperationsOnValues) {
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

TEST(Segments, OperationsOnTimesAskForNoTypes) {
  const std::string film =
      "create man group\ncreate man/head sphere\ncreate man/arm box\nat 1f man/head.radius 1\n"
      "at 24f man/head.radius 2\nat 12f hide man/arm\nat 6f man/arm.color red\nat 10f man/arm.color blue\n"
      "at 5f man/arm.position (1 2 3)\nat 3f attach man/arm to man/head\n";
  const LoadedFilm s(film + "move man/*.* 1f..72f by 2f\n");
  expect_numbers(s, "man/head.radius", "26f", {2});
  EXPECT_EQ(s.read("man/arm.display", "13f"), Value(true));
  EXPECT_EQ(s.read("man/arm.display", "14f"), Value(false));
  const LoadedFilm reversed(film +
                            "reverse man/*.* 1f..24f\nclear man/arm.* 5f..6f\nextend man/*.* hold\n"
                            "twerper man/*.* none\nfilter man/*.* delay by=1f\nstagger man/*.* by 1f\n"
                            "copy man/*.* 1f..24f to 48f\nstretch man/*.* 1f..24f by 2\n");
  (void)reversed;
  const LoadedFilm cleared(film + "clear man/*.* 1f..24f\n");
  for (const ObjectId id : objects(cleared.loaded.document))
    EXPECT_TRUE(tracks(cleared.loaded.document, id).empty() || tracks(cleared.loaded.document, id)[0].event_count == 0);
}

// The notices of a film without errors.
std::vector<std::string> noticed(const std::string& film) {
  const Loaded l = read(film);
  EXPECT_EQ(errors(l), std::vector<std::string>{}) << film;
  std::vector<std::string> out;
  for (const Diagnostic& d : l.diagnostics)
    if (!d.what.message.starts_with("a velocity overrides "))
      out.push_back(d.what.message + (d.what.hint.empty() ? "" : " (" + d.what.hint + ")"));
  return out;
}

TEST(Segments, OperationsOnValuesTakeEachTypeInItsOwnWay) {
  const std::string film =
      "rate 24\ncreate b sphere\nat 1f b.position (1 2 3)\nat 1f b.color rgb(0.2 0.4 0.6)\nat 1f hide b\nat 1f "
      "b.radius 3\n"
      "at 1f b.rotation axis(0 1 0, 90deg)\n";
  const std::string moved = film + "translate b.{position,color,display} 1f..24f (0 1 0)\n";
  EXPECT_EQ(noticed(moved), std::vector<std::string>{"left out: b.display (on or off cannot be moved)"});
  expect_numbers(LoadedFilm(moved), {{"b.position", "1f", {1, 3, 3}}, {"b.color", "1f", {0.2, 1.4, 0.6}}});
  const std::string scaled = film + "scale b.{position,radius,scale} 1f..24f 2\n";
  EXPECT_EQ(noticed(scaled), std::vector<std::string>{});
  expect_numbers(LoadedFilm(scaled), {{"b.position", "1f", {2, 4, 6}}, {"b.radius", "1f", {6}}});
  const std::string turned = film + "rotate b.{position,rotation,radius} 1f..24f 90deg y\n";
  EXPECT_EQ(noticed(turned),
            std::vector<std::string>{
                "left out: b.radius (only vectors, points and orientations can be rotated; this is a number)"});
  const LoadedFilm s(turned);
  expect_numbers(s, "b.position", "1f", {3, 2, -1}, 1e-12);
  const Quat half = std::get<Quat>(s.read("b.rotation", "1f"));
  EXPECT_NEAR(std::abs(half.y), 1, 1e-12);
  // A value that fits only some of them; none of them; one that is wrong for all.
  EXPECT_EQ(noticed(film + "translate b.{position,radius} 1f..24f (0 1 0)\n"),
            std::vector<std::string>{"left out: b.radius (expected a number here, not a vector)"});
  EXPECT_EQ(first_error(film + "scale b.{display,material} 1f..24f 2\n"), "8:7: on or off cannot be scaled");
  const Loaded grown = read(film + "scale b.{radius,position} 1f..24f 1e308\nscale b.radius 1f..2f 1e308\n");
  EXPECT_EQ(errors(grown).size(), 2u);
}

// Each point of a list, and the point that an object looks at. An aim at an object stays.
TEST(Segments, OperationsOnValuesTakePoints) {
  const std::string film =
      "rate 24\ncreate {b,c} polygon points=((9 9) (8 8) (7 7))\ncreate q box\ncreate {w,v} camera\n"
      "b.points\n  1f ((0 0) (1 0) (1 2)) linear\n  25f ((3 0) (1 0 5) (1 1))\n"
      "w.look-at\n  1f (1 2 3) linear\n  25f (3 2 1)\nat 1f v.look-at q\n";
  const auto points = [&](const std::string& line, const char* time) {
    return *std::get<Points>(LoadedFilm(film + line + "\n").read("b.points", time));
  };
  using List = std::vector<Vec3>;
  EXPECT_EQ(points("translate b.points 1f..25f (1 2 3)", "1f"), (List{{1, 2, 3}, {2, 2, 3}, {2, 4, 3}}));
  EXPECT_EQ(points("translate b.points 1f..5f (1 2 3)", "25f"), (List{{3, 0, 0}, {1, 0, 5}, {1, 1, 0}}));
  EXPECT_EQ(points("scale b.points 1f..25f 2", "25f"), (List{{6, 0, 0}, {2, 0, 10}, {2, 2, 0}}));
  EXPECT_EQ(points("scale b.points 1f..25f (1 -1 2)", "13f"), (List{{1.5, 0, 0}, {1, 0, 5}, {1, -1.5, 0}}));
  EXPECT_EQ(points("copy b.points 1f..25f to 49f shift (1 0 0) times 2", "97f"),
            (List{{5, 0, 0}, {3, 0, 5}, {3, 1, 0}}));
  const List turned = points("rotate b.points 1f..25f 90deg z @ (1 0 0)", "1f");
  const List wanted{{1, -1, 0}, {1, 0, 0}, {-1, 0, 0}};
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(length(turned[i] - wanted[i]), 0, 1e-12);
  const std::string aims = film + "translate {w,v}.look-at 1f..25f (0 1 0)\nscale w.look-at 1f..25f 2\n";
  EXPECT_EQ(noticed(aims), std::vector<std::string>{"left out: v.look-at (this cannot be moved by this)"});
  EXPECT_EQ(LoadedFilm(aims).read("w.look-at", "1f"), Value(Vec3{2, 6, 6}));
  EXPECT_EQ(LoadedFilm(aims + "rotate w.look-at 1f..5f 180deg y\n").read("w.look-at", "25f"), Value(Vec3{6, 6, 2}));
  EXPECT_EQ(told(film + "translate b.points 1f..25f ((0 0) (1 1))\n"), "syntax 12:32 0");
  EXPECT_EQ(told(film + "scale b.points 1f..25f 1e308\nscale b.points 1f..25f 1e308\n").substr(0, 5), "range");
}

TEST(Segments, WhatMeansNothingForSomeIsDoneToTheOthers) {
  const std::string film =
      "rate 24\ncreate b sphere\nb.radius\n  1f 1 linear\n  25f 3\nb.position\n  1f (0 0 0) linear\n  25f (4 0 0)\n"
      "at 13f b.position.velocity (1 0 0)\n";
  EXPECT_EQ(noticed(film + "reverse b.* 1f..25f\n"),
            std::vector<std::string>{"left out: b.position (a track with velocities cannot be reversed)"});
  const LoadedFilm s(film + "reverse b.* 1f..25f\n"), was(film);
  expect_numbers(s, {{"b.radius", "1f", {3}}, {"b.radius", "7f", {2.5}}});
  for (const char* time : {"1f", "7f", "20f", "30f"})
    expect_numbers(s, "b.position", time, was.numbers("b.position", time));
  EXPECT_EQ(first_error(film + "reverse b.position 1f..25f\n"), "10:9: a track with velocities cannot be reversed");
  EXPECT_EQ(
      noticed("create b box\ncreate c box\nb.attachment\n  5f attach to c\nextend b.{position,attachment} cycle\n"),
      std::vector<std::string>{"left out: b.attachment (an attachment cannot be extended by cycle)"});
}

TEST(Segments, TwerpersAndFiltersTakeEachType) {
  const std::string film =
      "rate 24\ncreate b sphere\nb.position\n  1f (0 0 0) hold\n  25f (4 0 0)\nb.color\n  1f black hold\n  25f white\n";
  const std::string linear = film + "twerper b.{position,color,material} linear in=srgb\n";
  EXPECT_EQ(noticed(film + "twerper b.{position,color} linear\n"), std::vector<std::string>{});
  expect_numbers(LoadedFilm(film + "twerper b.{position,color} linear\ntwerper b.color linear in=srgb\n"),
                 {{"b.position", "13f", {2, 0, 0}}, {"b.color", "13f", {0.5, 0.5, 0.5}}});
  const auto left = noticed(linear);
  ASSERT_EQ(left.size(), 1u);
  EXPECT_TRUE(left[0].starts_with("left out: b.position, b.material (only colours can blend in light or srgb"))
      << left[0];
  expect_numbers(LoadedFilm(linear), {{"b.position", "13f", {0, 0, 0}}, {"b.color", "13f", {0.5, 0.5, 0.5}}});
  const std::string sprung = film +
                             "filter b.{scale,position,material} delay by=1f\nfilter b.{scale,material,radius} spring\n"
                             "filter b.{radius,rotation} limit high=0.5\n";
  EXPECT_EQ(noticed(sprung), (std::vector<std::string>{"left out: b.material ('spring' cannot filter a text)",
                                                       "left out: b.rotation (an angle needs a unit)"}));
  expect_numbers(LoadedFilm(sprung),
                 {{"b.position", "25f", {0, 0, 0}}, {"b.position", "26f", {4, 0, 0}}, {"b.radius", "1f", {0.5}}});
  EXPECT_EQ(first_error("create b box\nfilter b.{material,display} spring\n"), "2:8: 'spring' cannot filter a text");
  EXPECT_EQ(first_error("create b box\nfilter b.{position,color} sprong\n"), "2:27: there is no filter 'sprong'");
  // One that is wrong otherwise does nothing to anyone.
  const Loaded wrong = read(film + "twerper b.{position,color} liner\n");
  EXPECT_EQ(errors(wrong), std::vector<std::string>{"9:28: there is no twerper 'liner'"});
}

TEST(Segments, AVelocityAloneIsReversed) {
  const LoadedFilm s(
      "rate 24\ncreate b sphere\nb.radius.velocity\n  1f 1 linear\n  25f 3\nreverse b.radius.velocity 1f..25f\n");
  expect_numbers(s, {{"b.radius.velocity", "1f", {3}}, {"b.radius.velocity", "13f", {2}}});
}

// What lies inside is the mirror of what it was, whoever stands outside.
TEST(Segments, ReversingAPartBendsNothingInside) {
  const std::string film =
      "create b sphere\nb.position\n  1f (0 9 0)\n  5f (1 0 0)\n  9f (4 1 0)\n  17f (2 7 1)\n  19f (9 0 3)\n  30f (0 0 "
      "-20)\n"
      "create c sphere\nc.rotation.x\n  1f 0deg\n  5f 90deg\n  9f 20deg\n  19f 50deg\n  30f 0deg\n";
  const LoadedFilm was(film), is(film + "reverse b.position 5f..19f\nreverse c.rotation.x 5f..19f\n");
  for (double f = 5; f <= 19; f += 0.5) {
    const std::string back = fmt::format("{}f", 24 - f), now = fmt::format("{}f", f);
    expect_numbers(is, "b.position", now, was.numbers("b.position", back), 1e-9);
    expect_numbers(is, "c.rotation.x", now, was.numbers("c.rotation.x", back), 1e-9);
  }
}

// With eases, other twerpers, one for the whole track, and of velocities.
struct TracksToTurnRound : Dice {
  using Dice::Dice;
  std::string rows(const std::function<std::string(double, int)>& value) {
    static constexpr std::array twerpers{"", "smooth", "auto", "linear", "ease-in-out", "fcurve"};
    static constexpr std::array eases{"", " ease-in=2f", " ease-out=3f", " ease-in=1f ease-out=2f"};
    std::string text;
    for (int frame = 1; frame < 60; frame += 2 + below(6))
      text += fmt::format("  {}f {} {}{}\n", frame, value(below(90) / 7.0, below(90)),
                          twerpers[static_cast<std::size_t>(below(6))], eases[static_cast<std::size_t>(below(4))]);
    return text;
  }
  std::string film() {
    const auto vector = [](double x, int y) { return fmt::format("({} {} 1)", x, y); };
    std::string text = "rate 24\ncreate b sphere\ncreate c sphere\nb.position\n" + rows(vector) + "b.rotation.y\n";
    text += rows([](double, int y) { return fmt::format("{}deg", y); }) + "c.radius.velocity\n";
    text += rows([](double x, int) { return fmt::format("{}", x); }) + "c.position\n" + rows(vector);
    return text + (chance(2) ? "twerper c.position smooth\n" : "twerper c.position auto\n");
  }
};

TEST(Segments, ReversingAPartBendsNothingWhateverItsTwerpers) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const std::string film = TracksToTurnRound(seed).film();
    const std::string reversed =
        film +
        "reverse b.position 10f..50f\nreverse b.rotation.y 10f..50f\nreverse c.radius.velocity 10f..50f\n"
        "reverse c.position 10f..50f\n";
    const LoadedFilm was(film), is(reversed);
    for (const char* target : {"b.position", "b.rotation.y", "c.radius.velocity", "c.position"}) {
      const auto all = find_targets(target, was.loaded.document);
      std::vector<double> frames;
      for (const EventView& e : events(was.loaded.document, all->front()))
        if (const double f = 1 + e.time.seconds() * 24; f >= 10 && f <= 50) frames.push_back(f);
      for (double f = frames.front() + 0.25; f < frames.back(); f += 1.5)
        expect_numbers(is, target, fmt::format("{}f", 60 - f), was.numbers(target, fmt::format("{}f", f)), 1e-8);
    }
    EXPECT_EQ(said(is.loaded.diagnostics).find("bend"), std::string::npos) << said(is.loaded.diagnostics);
  }
}

TEST(Segments, ReversingAPartSaysWhatBends) {
  const std::string film =
      "rate 24\ncreate b sphere\nb.radius\n  1f 1 bspline\n  5f 9 bspline\n  9f 2 bspline\n  17f 7 bspline\n"
      "  19f 4 bspline\n  30f 8\n";
  const std::string hint =
      " (their shape depends on the neighbouring events, which have changed; reverse the whole track, or bake it "
      "first)";
  EXPECT_EQ(
      noticed(film + "reverse b.radius 5f..19f\n"),
      std::vector<std::string>{
          "these segments have another shape backwards: b.radius from 15f to 19f, b.radius from 5f to 7f" + hint});
  // What is not named is the mirror of what it was.
  const LoadedFilm was(film), is(film + "reverse b.radius 5f..19f\n");
  for (double f = 9; f < 17; f += 0.5)
    expect_numbers(is, "b.radius", fmt::format("{}f", 24 - f), was.numbers("b.radius", fmt::format("{}f", f)), 1e-9);
  EXPECT_EQ(noticed(film + "reverse b.radius 1f..30f\n"), std::vector<std::string>{});  // all of it
  EXPECT_EQ(noticed(film + "at 5f b.radius 9 cut 9 bspline\nreverse b.radius 5f..30f\n"), std::vector<std::string>{});
  const std::string turns =
      "create b box\nb.rotation\n  1f axis(y 0deg) squad\n  5f axis(y 40deg) squad\n  9f axis(x 90deg) squad\n  13f "
      "axis(z "
      "90deg)\ncreate c box\nc.color\n  1f red smooth\n  5f blue smooth\n  9f green smooth\n  13f gold\n";
  EXPECT_EQ(noticed(turns + "reverse b.rotation 5f..13f\nreverse c.color 5f..13f\n"),
            (std::vector<std::string>{"these segments have another shape backwards: b.rotation from 9f to 13f" + hint,
                                      "these segments have another shape backwards: c.color from 9f to 13f" + hint}));
}

struct FilmsToForget : Dice {
  using Dice::Dice;
  static constexpr std::array twerpers{"", "linear", "smooth", "bspline", "hold", "ease-in-out", "auto", "keep smooth"};
  std::string row(int frame, const std::string& value) {
    const std::string how =
        frame == 1 ? "" : twerpers[static_cast<std::size_t>(below(static_cast<int>(twerpers.size())))];
    return fmt::format("  {}f {}\n", frame, how.starts_with("keep") ? how : value + " " + how);
  }
  std::string film() {
    std::string text = "rate 24\ncreate b box\n";
    for (const char* target : {"position", "size.y", "color", "display", "rotation", "transparency"}) {
      text += fmt::format("b.{}\n", target);
      const std::string_view what = target;
      for (int frame = 1; frame < 90; frame += 1 + below(9)) {
        const int a = below(90), b = below(9);
        if (what == "position")
          text += row(frame, fmt::format("({} {} 3)", a, b));
        else if (what == "color")
          text += row(frame, fmt::format("#{:02x}{:02x}30", a, 9 * b));
        else if (what == "display")
          text += fmt::format("  {}f {}\n", frame, b < 4 ? "on" : "off");
        else if (what == "rotation")
          text += fmt::format("  {}f axis(x {}deg)\n", frame, 4 * a);
        else
          text += row(frame, fmt::format("{}", what == "transparency" ? a / 90.0 : 1 + a));
      }
    }
    return text;
  }
};

// Bit for bit, on both sides of events too; and of what holds one event is left.
TEST(Segments, WhatCameBeforeATimeCanGoAndNothingFromThereOnChanges) {
  std::size_t gone = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const std::string film = FilmsToForget(seed).film();
    const int from = 20 + static_cast<int>(seed);
    const LoadedFilm was(film), is(film + fmt::format("clear b.* before {}f\n", from));
    ASSERT_EQ(all_told(is.loaded), std::vector<std::string>{}) << film;
    for (double f = from; f < 95; f += 0.25)
      for (const char* target : {"b.position", "b.size", "b.color", "b.display", "b.transparency"})
        ASSERT_EQ(is.read(target, fmt::format("{}f", f)), was.read(target, fmt::format("{}f", f)))
            << target << " at " << f << "f, cleared before " << from << "f\n"
            << film;
    for (double f = from; f < 95; f += 0.25) {  // q and -q are one orientation
      const auto a = std::get<Quat>(is.read("b.rotation", fmt::format("{}f", f)));
      const auto b = std::get<Quat>(was.read("b.rotation", fmt::format("{}f", f)));
      ASSERT_NEAR(std::abs(a.w * b.w + a.x * b.x + a.y * b.y + a.z * b.z), 1, 1e-12) << film;
    }
    const auto events = [](const LoadedFilm& s) {
      std::size_t n = 0;
      for (const auto& t : tracks(s.loaded.document, objects(s.loaded.document).front())) n += t.event_count;
      return n;
    };
    gone += events(was) - events(is);
  }
  EXPECT_GT(gone, 500u);
  const LoadedFilm held("create b box\nb.display\n 1f on\n 5f off\n 9f on\n 12f off\nclear b.display before 10f\n");
  const auto left = tracks(held.loaded.document, objects(held.loaded.document).front());
  EXPECT_EQ(left.front().event_count, 2u);
  EXPECT_EQ(held.read("b.display", "1f"), Value(true));
}

TEST(Segments, WhatFollowsFromAllThatCameBeforeIsLeftWhole) {
  const Loaded l = read(
      "rate 24\ncreate {a,b,c,d,e} box\nat 1f a.position (1 2 3)\nat 9f a.position (3 2 1)\n"
      "at 1f b.size.y 2\nat 3f b.size.y 3\nextend b.size.y cycle\nat 2f c.position.velocity (1 0 0)\n"
      "at 4f attach d to a\nat 1f e.color red\nat 5f e.color blue\nfilter e.color delay by=2f\n"
      "clear {a,b,c,d,e}.{position,size,color,attachment} before 8f\nat 1f note \"x\"\nat 3f note \"y\"\nclear notes "
      "before "
      "3f\n");
  EXPECT_EQ(all_told(l), std::vector<std::string>{});
  EXPECT_NE(said(l.diagnostics)
                .find("not cleared, because later values depend on all earlier events: b.size, c.position, "
                      "d.attachment and 1 more"),
            std::string::npos)
      << said(l.diagnostics);
  EXPECT_EQ(all_told(read("create b box\nclear b.position before\n")).size(), 1u);
}

TEST(Segments, ComponentsWithoutEventsAreNotPassedOver) {
  const std::string split = "rate 24\ncreate c sphere\nc.position.x\n  1f 0\n  24f 5\n";
  for (const char* line : {"translate c.position 1f..24f (0 3 0)", "translate c.position 1f..24f (5 5 0)",
                           "copy c.position 1f..24f to 24f shift (0 2 0)"}) {
    const Loaded l = read(split + line + "\n");
    ASSERT_EQ(l.diagnostics.size(), 1u) << line;
    EXPECT_EQ(l.diagnostics[0].severity, Severity::error) << line;
    EXPECT_TRUE(l.diagnostics[0].what.message.starts_with("c.position.y has no events from 1f to 24f")) << line;
  }
  const LoadedFilm fine(split + "translate c.position 1f..24f (3 0 0)\ntranslate c.position 30f..40f (0 3 0)\n");
  expect_numbers(fine, "c.position", "24f", {8, 0, 0});
}

TEST(Segments, WhatIsKeptGoesAlongAsItWas) {
  const std::string rows = "rate 24\ncreate b sphere\nb.radius\n  1f 1 linear\n  25f 5\n  13f keep hold\n";
  const LoadedFilm back(rows + "reverse b.radius 1f..25f\n");
  expect_numbers(
      back, {{"b.radius", "1f", {3}}, {"b.radius", "7f", {3}}, {"b.radius", "19f", {2}}, {"b.radius", "25f", {1}}});
  const LoadedFilm copied(rows + "copy b.radius 13f..25f to 49f\n");
  expect_numbers(copied, {{"b.radius", "49f", {3}}, {"b.radius", "55f", {3}}, {"b.radius", "61f", {5}}});
}

TEST(Copying, SaysWhatGaveWay) {
  const std::string ramp = "rate 24\ncreate b sphere\nb.position.y\n  1f 0 linear\n  25f 5\n";
  const Loaded flat = read(ramp + "copy b.position.y 1f..25f to 25f times 2\n");
  ASSERT_EQ(flat.diagnostics.size(), 1u);
  EXPECT_EQ(flat.diagnostics[0].severity, Severity::notice);
  EXPECT_EQ(flat.diagnostics[0].what.message, "1 event replaced");
  EXPECT_TRUE(read(ramp + "copy b.position.y 1f..25f to 25f shift 5 times 2\n").diagnostics.empty());
  EXPECT_TRUE(read(ramp + "copy b.position.y 1f..25f to 30f times 2\n").diagnostics.empty());
}

}  // namespace
}  // namespace betwixt
