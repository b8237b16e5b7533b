// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests the first film of the language's description. The values are computed by hand.
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
  EXPECT_EQ(notes[0].text, "first bounce ends");
  EXPECT_EQ(format_time(notes[0].time, d), "24f");
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

}  // namespace
}  // namespace betwixt
