// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "support/loaded_film.h"

namespace betwixt {
namespace {

Vec3 round(double degrees, double radius) {
  const double a = degrees * pi / 180;
  return {radius * std::cos(a), radius * std::sin(a), 0};
}

// shows: C41 C42 C43 C44 C46 C52 C53 C54 C55 C81 C82 C84 C83 C102 C108 C109 C56 C4
TEST(Environments, AreMToThePowerOfNPlusOne) {
  const LoadedFilm s(
      "create ball sphere position=(2 0 0)\nanimate spin every 3t by rotate(10deg, z)\n"
      "set ball.environments spin\n");
  for (const int tick : {0, 1, 2, 3, 5, 6, 29, 30, 1000}) {
    expect_place(s, "ball", std::to_string(tick) + "t", round(10 * (tick / 3 + 1), 2));
    EXPECT_EQ(s.numbers("spin.count", std::to_string(tick) + "t")[0], tick / 3);
  }
  EXPECT_EQ(s.numbers("spin.every", "50t")[0], 3);
  // Before its animate it is as if nothing enclosed the ball.
  const LoadedFilm later(
      "create ball sphere position=(2 0 0)\nat 30t animate spin every 1t by translate(0 1 0)\n"
      "set ball.environments (spin)\n");
  expect_places(later, "ball", {{"29t", {2, 0, 0}}, {"30t", {2, 1, 0}}, {"31t", {2, 2, 0}}});
}

// shows: C47 C48 C49 C50
TEST(Environments, RollAndSpiralByTheOrderOfFactors) {
  // The leftmost is applied last: turned, then moved on, and the next in the axes of the one before.
  const LoadedFilm s(
      "create a sphere\nanimate roll every 1t by translate(1 0 0) rotate(90deg, z)\nset a.environments roll\n");
  expect_places(s, "a", {{"0t", {1, 0, 0}}, {"1t", {1, 1, 0}}, {"2t", {0, 1, 0}}, {"3t", {0, 0, 0}}});
  const LoadedFilm grow(
      "create a sphere position=(1 0 0)\nanimate grow every 1t by scale(2 @ 3 0 0)\n"
      "set a.environments grow\n");
  expect_places(grow, "a", {{"0t", {-1, 0, 0}}, {"1t", {-5, 0, 0}}});
  EXPECT_NEAR((*std::get<Matrix>(grow.read("a.world", "1t")))(0, 0), 4, 1e-12);
}

// shows: R-E15
TEST(Environments, TakeWordsAsTheyAreSaid) {
  const auto after_a_million = [](const std::string& transform, int element) {
    const LoadedFilm s("create a sphere\nanimate m every 1t by " + transform + "\nset a.environments m\n");
    EXPECT_EQ(said(s.loaded.diagnostics), "") << transform;
    const auto again = load_text(write(s.loaded.document), "again.bx");  // as matrix(…)
    EXPECT_EQ(said(again.diagnostics), "") << transform;
    EXPECT_EQ(write(again.document), write(s.loaded.document));
    return std::get<Matrix>(s.read("a.world", "999999t"))->m[static_cast<std::size_t>(element)];
  };
  for (const double more : {1e-6, 5e-6, 1e-8, 2e-11, 2e-13})  // (1 + x)^n = e^(n log(1 + x))
    EXPECT_NEAR(after_a_million(fmt::format("scale(1 1 {})", 1 + more), 10), std::exp(1e6 * std::log1p(1 + more - 1)),
                1e-8)
        << more;
  EXPECT_NEAR(after_a_million("scale(1 1 1.000001)", 10), 2.7182804693, 1e-9);
  EXPECT_NEAR(after_a_million("rotate(90deg, z) scale(1 1 1.000001)", 10), 2.7182804693, 1e-9);
  EXPECT_NEAR(after_a_million("scale(1.000001)", 0), 2.7182804693, 1e-9);
}

// shows: R-E15
TEST(Environments, TakeMatricesInFloatsForTurns) {
  const double c = static_cast<float>(std::cos(0.7)), sine = static_cast<float>(std::sin(0.7));
  ASSERT_GT(std::abs(c * c + sine * sine - 1), 1e-9) << "in f64 it would shrink or grow";
  const std::string turn = fmt::format("matrix({0} {2} 0 0  {1} {0} 0 0  0 0 1.00000005 0  0 0 0 1)", c, sine, -sine);
  const LoadedFilm s("create a sphere position=(1 0 0)\nanimate m every 1t by " + turn + "\nset a.environments m\n");
  EXPECT_EQ(said(s.loaded.diagnostics),
            "test.bx:2:23: notice: this matrix differs from a rotation and a translation by less than 1e-7, so it is "
            "rounded to them\n  animate m every 1t by " +
                turn + "\n                        ^~~~~~\n" + "  translate(…) rotate(…) are exact\n");
  const Matrix late = std::get<Matrix>(s.read("a.world", "99999999t"));
  EXPECT_NEAR(length(transform_vector(*late, {1, 0, 0})), 1, 1e-12);
  EXPECT_NEAR(late->m[10], 1, 1e-12);
  EXPECT_EQ(said(load_text(write(s.loaded.document), "again.bx").diagnostics), "");
  // At rest nothing adds up: it is what was said.
  const LoadedFilm still("create a sphere\nset a.transform " + turn + "\n");
  EXPECT_EQ(said(still.loaded.diagnostics), "");
  EXPECT_EQ(std::get<Matrix>(still.read("a.world", "0t"))->m[10], 1.00000005);
}

// shows: C57 C58 C60 C61 C62 C63 C76
TEST(Environments, NestTheFirstIsTheOutermost) {
  const LoadedFilm s(
      "create ball sphere position=(2 0 0)\ncreate kid box position=(1 0 0)\ncouple kid to ball\n"
      "create other sphere position=(0 1 0)\n"
      "animate drift every 1t by translate(0.5 0 0)\nanimate spin every 2t by rotate(30deg, z)\n"
      "set ball.environments (drift spin)\nset other.environments drift\n");
  for (const int tick : {0, 1, 7, 24, 25}) {
    const std::string at = std::to_string(tick) + "t";
    const double x = 0.5 * (tick + 1), angle = 30 * (tick / 2 + 1);
    expect_place(s, "ball", at, round(angle, 2) + Vec3{x, 0, 0});
    expect_place(s, "kid", at, round(angle, 3) + Vec3{x, 0, 0});  // what is attached is enclosed too
    expect_place(s, "other", at, {x, 1, 0});
  }
  // The other way round the drift itself is turned.
  const LoadedFilm t(
      "create ball sphere position=(2 0 0)\nanimate drift every 1t by translate(0.5 0 0)\n"
      "animate spin every 1t by rotate(90deg, z)\nset ball.environments (spin drift)\n");
  expect_places(t, "ball", {{"0t", {0, 2.5, 0}}, {"1t", {-3, 0, 0}}});
}

// shows: C34 C64
TEST(Environments, ThatDriveMoveAThingInItsOwnSpace) {
  const LoadedFilm s(
      "create axle group position=(5 0 0)\ncreate wheel disc position=(0 1 0)\ncouple wheel to axle\n"
      "create spoke box position=(1 0 0)\ncouple spoke to wheel\n"
      "animate roll every 1t by translate(1 0 0)\nanimate spin every 1t by rotate(90deg, z)\n"
      "set axle.drive roll\nset wheel.drive spin\n");
  expect_places(s, "spoke", {{"0t", {6, 2, 0}}, {"1t", {6, 1, 0}}});
  expect_place(s, "wheel", "0t", {6, 1, 0});
  const LoadedFilm t(
      "create a box position=(1 0 0)\nset a.transform translate(0 2 0) rotate(90deg, z) scale(2)\n"
      "create b box position=(1 0 0)\ncouple b to a\n");
  for (const auto& [name, y] : {std::pair{"a", 2.0}, {"b", 4.0}}) expect_place(t, name, "1f", {1, y, 0});
}

// shows: C86 C87 C90 C91 C92 C94 C95 C96 C88
TEST(Environments, HaltGoOnAndAreKilled) {
  const LoadedFilm s(
      "create a sphere\ncreate b sphere\n"
      "animate go every 2t by translate(1 0 0)\n"
      "at 10t halt go\nat 20t animate go every 5t by translate(0 1 0)\n"
      "at 31t kill go\nat 40t animate go every 1t by translate(0 0 1)\n"
      "set a.environments go\nat 35t b.environments (go)\n");
  expect_places(s, "a",
                {{"9t", {5, 0, 0}},
                 {"10t", {6, 0, 0}},  // the update due at its tick is made
                 {"19t", {6, 0, 0}}});
  EXPECT_EQ(s.numbers("go.every", "15t")[0], 2);
  expect_places(s, "a",
                {{"24t", {6, 0, 0}},  // in force five ticks on
                 {"25t", {6, 1, 0}},
                 {"31t", {6, 2, 0}},
                 {"90t", {6, 2, 0}}});  // killed: it stays
  expect_places(s, "b",
                {{"39t", {0, 0, 0}},  // bound to the next of that name
                 {"41t", {0, 0, 2}}});
}

// shows: C135 C136 C137 C138 C140 C143 C144 C139 C146 C147
TEST(Environments, SlowDownSpeedUpAndAreScheduled) {
  const LoadedFilm s(
      "create a sphere\nset a.environments slow\ncreate b sphere\nset b.environments fast\ncreate c sphere\n"
      "set c.environments later\n"
      "animate slow every 2t by translate(1 0 0) slower 1t per 1s limit 6t\n"
      "animate fast every 5t by translate(1 0 0) faster 1t per 30t\n"
      "at 10t animate later every 1t by translate(1 0 0) from 20t until 25t\n");
  for (const auto& [tick, n] :
       std::vector<std::pair<int, int>>{{29, 14}, {30, 15}, {60, 25}, {92, 33}, {122, 39}, {900, 39}})
    expect_place(s, "a", std::to_string(tick) + "t", {n + 1.0, 0, 0});
  for (const auto& [tick, n] : std::vector<std::pair<int, int>>{{30, 6}, {62, 14}, {92, 24}, {120, 38}, {220, 138}})
    expect_place(s, "b", std::to_string(tick) + "t", {n + 1.0, 0, 0});
  expect_places(s, "c", {{"29t", {0, 0, 0}}, {"30t", {1, 0, 0}}, {"35t", {6, 0, 0}}, {"99t", {6, 0, 0}}});
}

// shows: C89
TEST(Environments, GoTwiceAsFastByHalfTheIntervalOrTheSquare) {
  const LoadedFilm s(
      "create a sphere position=(1 0 0)\ncreate b sphere position=(1 0 0)\ncreate c sphere position=(1 0 0)\n"
      "animate slow every 2t by rotate(5deg, z)\nanimate half every 1t by rotate(5deg, z)\n"
      "animate square every 2t by rotate(5deg, z) rotate(5deg, z)\n"
      "set a.environments slow\nset b.environments half\nset c.environments square\n");
  for (const int tick : {2, 10, 60}) {
    const std::string at = std::to_string(tick) + "t", twice = std::to_string(2 * tick) + "t";
    expect_place(s, "b", at, place(s, "a", twice));
    expect_place(s, "c", at, round(10 * (tick / 2 + 1), 1));
  }
}

// What is no power of one matrix is a track: s = v t + a t^2 / 2.
// shows: C51
TEST(Environments, AndTracksForFreeAcceleration) {
  const LoadedFilm s(
      "create a sphere\nset a.environments drift\nanimate drift every 1t by translate(0 0 1)\n"
      "a.position.x\n  0s 0 hermite tangent=2\n  4s 40 tangent=18\n");
  for (const int tick : {0, 15, 45, 90}) {
    const double t = tick / 30.0;
    expect_place(s, "a", std::to_string(tick) + "t", {2 * t + 2 * t * t, 0, tick + 1.0});
  }
}

TEST(Environments, OldTurnsAreRight) {
  const LoadedFilm s(
      "create a sphere position=(1 0 0)\nanimate spin every 1t by rotate(7deg, z)\nset a.environments spin\n");
  const std::int64_t n = 1'000'000'000;
  expect_place(s, "a", std::to_string(n) + "t", round(static_cast<double>((n + 1) * 7 % 360), 1), 1e-6);
}

// What is let go keeps what enclosed its holder as it was at that moment.
// shows: C104
TEST(Environments, HoldAndLetGoWithoutAJump) {
  const LoadedFilm s(
      "create hand box position=(3 1 0) scale=(2 1 1)\nset hand.environments (drift spin)\n"
      "create ball sphere position=(9 9 9)\nset ball.environments wobble\n"
      "animate drift every 1t by translate(0.1 0 0)\nanimate spin every 1t by rotate(5deg, z) @ (1 1 0)\n"
      "animate wobble every 3t by rotate(1deg, x)\n"
      "at 20t couple ball to hand keep-world\nat 45t letgo ball\n");
  const auto world = [&](std::string_view t) { return *std::get<Matrix>(s.read("ball.world", t)); };
  const Mat4 a = world("20t");
  const LoadedFilm free(
      "create ball sphere position=(9 9 9)\nset ball.environments wobble\n"
      "animate wobble every 3t by rotate(1deg, x)\n");
  const Mat4 b = *std::get<Matrix>(free.read("ball.world", "20t"));
  for (int i = 0; i < 16; ++i) EXPECT_NEAR(a.m[static_cast<std::size_t>(i)], b.m[static_cast<std::size_t>(i)], 1e-9);
  // At the letgo nothing jumps: another script in which it stays held says where it would be then.
  const LoadedFilm held(
      "create hand box position=(3 1 0) scale=(2 1 1)\nset hand.environments (drift spin)\n"
      "create ball sphere position=(9 9 9)\nset ball.environments wobble\n"
      "animate drift every 1t by translate(0.1 0 0)\nanimate spin every 1t by rotate(5deg, z) @ (1 1 0)\n"
      "animate wobble every 3t by rotate(1deg, x)\nat 20t couple ball to hand keep-world\n");
  const Mat4 c = world("45t"), d = *std::get<Matrix>(held.read("ball.world", "45t"));
  for (int i = 0; i < 16; ++i) EXPECT_NEAR(c.m[static_cast<std::size_t>(i)], d.m[static_cast<std::size_t>(i)], 1e-9);
  const Vec3 then = place(s, "ball", "45t"), on = place(s, "ball", "46t");
  EXPECT_LT(length(on - then), 1e-9);  // the hand's environments move it no more, its own is due at 48t
  EXPECT_GT(length(place(s, "ball", "48t") - on), 1e-3);
}

// shows: C114 C93 C122 C5
TEST(Environments, SayWhenSomethingIsDue) {
  const auto ticks = [](const LoadedFilm& s, int at) -> std::optional<double> {
    const auto t = s.program.next_change(Rate{30, 1}.span(at));
    if (!t) return std::nullopt;
    return t->seconds() * 30;
  };
  const LoadedFilm s(
      "create a sphere\nset a.environments go\nat 10t animate go every 7t by translate(1 0 0)\nat 30t halt go\n");
  EXPECT_NEAR(*ticks(s, 0), 10, 1e-9);
  EXPECT_NEAR(*ticks(s, 10), 17, 1e-9);
  EXPECT_NEAR(*ticks(s, 18), 24, 1e-9);
  EXPECT_FALSE(ticks(s, 24));
  const LoadedFilm t("create a sphere\na.position\n  31f (0 0 0) linear\n  41f (1 0 0)\nat 51f hide a\n");
  EXPECT_NEAR(t.program.next_change({})->seconds(), 30 / 24.0, 1e-9);
  EXPECT_EQ(*t.program.next_change(Rate{}.frame(35)), Rate{}.frame(35));
  EXPECT_EQ(*t.program.next_change(Rate{}.frame(41)), Rate{}.frame(51));
  EXPECT_FALSE(t.program.next_change(Rate{}.frame(51)));
}

TEST(Environments, MoveBetweenTheirTicksWhereAsked) {
  const LoadedFilm s(
      "ticks 30 smooth\ncreate a sphere position=(1 0 0)\nanimate spin every 2t by rotate(20deg, z)\n"
      "set a.environments spin\n");
  expect_place(s, "a", "0t", round(20, 1));
  expect_place(s, "a", "1t", round(30, 1));
  expect_place(s, "a", "50ms", round(35, 1), 1e-7);
  expect_place(s, "a", "2t", round(40, 1));
}

TEST(Environments, WrittenAndReadAgainAreTheSame) {
  const LoadedFilm s(
      "ticks 60 smooth\ncreate a sphere\ncreate b box\nset b.drive (x y)\nset b.transform scale(2) rotate(1rad, (1 1 "
      "0))\n"
      "set a.environments (x y)\nat 9t a.environments none\n"
      "animate x every 2t by rotate(10deg, z) @ (1 2 3) translate(0 1 0) slower 2t per 5t limit 20t\n"
      "at 40t halt x\nat 30t animate x every 3t by matrix(1 0.5 0 0 0 1 0 0 0 0 1 2 0 0 0 1) keep-phase\n"
      "at 50t animate y every 1t by scale(1.5) from 3t until 9t\nat 52t cancel y\nat 60t kill y\n"
      "animate gear/wheel every 1t by rotate(1deg, x)\n");
  const std::string text = write(s.loaded.document);
  const Loaded again = load_text(text, "again.bx");
  EXPECT_TRUE(again.diagnostics.empty()) << said(again.diagnostics);
  EXPECT_EQ(again.document, s.loaded.document) << text;
  const LoadedFilm renamed(
      "create a sphere\nset a.environments (x y)\nanimate x every 1t by translate(1 0 0)\nrename x far\n");
  expect_place(renamed, "a", "1t", {2, 0, 0});
  EXPECT_EQ(write(renamed.loaded.document).find("(x y)"), std::string::npos);
}

}  // namespace
}  // namespace betwixt
