// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests the warnings after loading, about parts of a film that will never be visible.
#include <fmt/format.h>

#include "support/loaded_film.h"

namespace betwixt {
namespace {

// The notices of a text, a line each.
std::string notices(const std::string& text) {
  const Loaded l = read(text);
  EXPECT_FALSE(has_errors(l.diagnostics)) << text;
  std::string out;
  for (const Diagnostic& d : l.diagnostics)
    if (d.severity == Severity::notice) out += d.what.message + "\n";
  return out;
}

TEST(LookOver, TangentsThatNothingAsksFor) {
  const std::string ball = "rate 24\ncreate ball sphere\nball.radius\n";
  EXPECT_EQ(notices(ball + "  1f 1 linear tangent=2\n  9f 3 linear\n  17f 1 smooth tangent-in=1\n"),
            "ball.radius has a tangent at 1f that its twerper does not use\n");
  EXPECT_EQ(remarks_told(ball + "  1f 1 linear\n  9f 3 linear tangent-in=1\n"),
            std::vector<std::string>{"notice type 5:3 9f 3 linear tangent-in=1"});
  EXPECT_TRUE(mentions(ball + "  1f 1 linear\n  9f 3 linear tangent-in=1\n", " 9f"));
  EXPECT_EQ(notices(ball + "  1f 1 hermite tangent=2\n  9f 3 linear tangent-in=1\n"), "");
  EXPECT_EQ(notices(ball + "  1f 1 linear tangent=2\n  9f 3\ntwerper ball.radius hermite\n"), "");
}

TEST(LookOver, LettingGoWhatNothingHolds) {
  const std::string two = "rate 24\ncreate hand group\ncreate ball sphere\n";
  EXPECT_EQ(notices(two + "at 5f letgo ball\n"), "ball is released by letgo at 5f, but nothing holds it then\n");
  const std::string twice = two + "at 9f letgo ball\nat 3f hang ball on hand\nat 12f detach ball\nat 13f letgo ball\n";
  EXPECT_EQ(remarks_told(twice).size(), 1u);
  EXPECT_TRUE(mentions(twice, "ball") && mentions(twice, " 12f"));
  EXPECT_EQ(notices(two + "couple ball to hand\nat 5f letgo ball\nat 6f attach ball to hand\nat 7f detach ball\n"), "");
}

TEST(LookOver, LensesOfWhatHasNone) {
  EXPECT_EQ(notices("create eye camera height=5 f-stop=2\n"),
            "eye has a height and thus no perspective, so its f-stop has no effect\n");
  EXPECT_EQ(notices("create eye camera f-stop=2\ncreate side camera height=5\n"), "");
}

TEST(LookOver, CodeThatDoesNotReachAComponent) {
  const std::string ball = "create ball sphere\nset ball.scale = \"vec(1, 1, 1 + t)\"\n";
  EXPECT_EQ(notices(ball), "");
  EXPECT_EQ(notices(ball + "at 4f ball.scale.x 3\n"),
            "ball.scale.x has events of its own, so the code of ball.scale has no effect on it\n");
}

TEST(LookOver, WhatMakesRoomForAFall) {
  const std::string ball =
      "rate 24\ncreate ball sphere\nball.position\n  1f (0 9 0) linear\n  25f (1 9 0)\n  49f (2 9 0)\n  400f (0 9 0)\n";
  EXPECT_EQ(notices(ball + "at 1f fall ball ground=-99 for 2s\n"), "the fall replaces 2 events of ball.position\n");
  EXPECT_EQ(notices(ball + "at 49f fall ball for 2s\n"), "");
  EXPECT_EQ(notices("rate 24\ncreate ball sphere position=(0 9 0)\nat 1f fall ball\nat 9f fall ball\n"),
            "");  // an earlier fall
}

// Between two squashes a smooth scale swings: with the tangents of the parabolas through (13f, 0.5), (16f, 1), (34f, 1)
// and through (16f, 1), (34f, 1), (37f, 0.5) it is 1 + 2 (0.5 * 6 * 18 / 21) / 8 in the middle.
TEST(LookOver, SwingsFarBeyondEventsThatAreAlike) {
  const std::string rows =
      "rate 24\ncreate b sphere\nb.scale\n  13f (1.4 0.5 1) {0}\n  16f (1 1 1) {0}\n  34f (1 1 1) {0}\n"
      "  37f (1.4 0.5 1)\n";
  const auto with = [&](std::string_view twerper) { return fmt::format(fmt::runtime(rows), twerper); };
  const std::string film = with("");
  EXPECT_EQ(remarks_told(film), std::vector<std::string>{"notice range 5:3 16f (1 1 1)"});
  EXPECT_TRUE(mentions(film, "b.scale.x") && mentions(film, fmt::format("{:.4g}", 1 - 0.4 * 6 * 18 / 21 / 4)));
  EXPECT_TRUE(mentions(film, " 25f"));
  EXPECT_TRUE(read(film).diagnostics[0].what.hint.starts_with("auto"));
  EXPECT_EQ(remarks_told(with("smooth")).size(), 1u);
  for (const char* other : {"auto", "linear", "hold", "ease", "back-out", "hermite"})
    EXPECT_EQ(notices(with(other)), "") << other;
  EXPECT_EQ(notices(with("") + "twerper b.scale auto\n"), "");
  EXPECT_EQ(remarks_told(with("") + "twerper b.scale smooth\n").size(), 1u);
  // Where a line below has put the event there, that is the place; of a component its own track is meant.
  EXPECT_EQ(remarks_told(film + "at 16f b.scale (1 1 1)\nat 16f b.scale (1 1 1) smooth\n"),
            std::vector<std::string>{"notice range 9:1 at 16f b.scale (1 1 1) smooth"});
  EXPECT_EQ(remarks_told("rate 24\ncreate b sphere\nb.rotation.x\n  1f 90deg\n  3f 0\n  25f 0\n  27f 90deg\n"),
            std::vector<std::string>{"notice range 5:3 3f 0"});
}

// A pause before an even start, and a hop, swing by less; a jump in between, or another value, is no swing at all.
TEST(LookOver, FollowThroughIsNoRemark) {
  const std::string b = "rate 24\ncreate b sphere\nb.position.y\n";
  EXPECT_EQ(notices(b + "  1f 0\n  13f 0\n  25f 10\n"), "");
  EXPECT_EQ(notices(b + "  1f 0\n  13f 4\n  25f 0\n  37f 4\n  49f 0\n"), "");
  EXPECT_EQ(notices(b + "  1f 5\n  3f 0\n  25f 1\n  27f 5\n"), "");
  EXPECT_EQ(notices(b + "  1f 5\n  3f 5 cut 0\n  25f 0 cut 5\n  27f 5\n"), "");
  EXPECT_EQ(remarks_told(b + "  1f 5\n  3f 0\n  25f 0\n  27f 5\n").size(), 1u);
}

TEST(LookOver, WhatItIsAboutHasAPlace) {
  const std::string two = "create ball sphere\ncreate hand group\n";
  EXPECT_EQ(remarks_told(two + "set {ball,hand}.environments (wind)\n"),
            std::vector<std::string>{"notice name 3:1 set {ball,hand}.environments (wind)"});
  EXPECT_EQ(remarks_told(two + "ball.radius\n  1f 1 bspline\n  9f 4 smooth\n  17f 1\n"),
            std::vector<std::string>{"notice type 5:3 9f 4 smooth"});
  EXPECT_EQ(remarks_told(two + "range 1f 9f\nat 3f note \"a\"\nat 12f note \"b\"\n"),
            std::vector<std::string>{"notice range 5:1 at 12f note \"b\""});
  EXPECT_EQ(remarks_told(two + "at 5f letgo ball\n"), std::vector<std::string>{"notice type 3:1 at 5f letgo ball"});
}

}  // namespace
}  // namespace betwixt
