// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What a film says and nobody will see is said when it has been read.
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
            "ball.radius has a tangent at 1f that nothing asks for\n");
  EXPECT_EQ(remarks_told(ball + "  1f 1 linear\n  9f 3 linear tangent-in=1\n"),
            std::vector<std::string>{"notice type"});
  EXPECT_TRUE(mentions(ball + "  1f 1 linear\n  9f 3 linear tangent-in=1\n", " 9f"));
  EXPECT_EQ(notices(ball + "  1f 1 hermite tangent=2\n  9f 3 linear tangent-in=1\n"), "");
  EXPECT_EQ(notices(ball + "  1f 1 linear tangent=2\n  9f 3\ntwerper ball.radius hermite\n"), "");
}

TEST(LookOver, LettingGoWhatNothingHolds) {
  const std::string two = "rate 24\ncreate hand group\ncreate ball sphere\n";
  EXPECT_EQ(notices(two + "at 5f letgo ball\n"), "ball is let go at 5f, where nothing holds it\n");
  const std::string twice = two + "at 9f letgo ball\nat 3f hang ball on hand\nat 12f detach ball\nat 13f letgo ball\n";
  EXPECT_EQ(remarks_told(twice).size(), 1u);
  EXPECT_TRUE(mentions(twice, "ball") && mentions(twice, " 12f"));
  EXPECT_EQ(notices(two + "couple ball to hand\nat 5f letgo ball\nat 6f attach ball to hand\nat 7f detach ball\n"), "");
}

TEST(LookOver, LensesOfWhatHasNone) {
  EXPECT_EQ(notices("create eye camera height=5 f-stop=2\n"),
            "eye has a height, so it sees without perspective and its f-stop blurs nothing\n");
  EXPECT_EQ(notices("create eye camera f-stop=2\ncreate side camera height=5\n"), "");
}

TEST(LookOver, CodeThatDoesNotReachAComponent) {
  const std::string ball = "create ball sphere\nset ball.scale = \"vec(1, 1, 1 + t)\"\n";
  EXPECT_EQ(notices(ball), "");
  EXPECT_EQ(notices(ball + "at 4f ball.scale.x 3\n"),
            "ball.scale.x has events of its own: the code of ball.scale does not reach it\n");
}

TEST(LookOver, WhatMakesRoomForAFall) {
  const std::string ball =
      "rate 24\ncreate ball sphere\nball.position\n  1f (0 9 0) linear\n  25f (1 9 0)\n  49f (2 9 0)\n  400f (0 9 0)\n";
  EXPECT_EQ(notices(ball + "at 1f fall ball ground=-99 for 2s\n"),
            "2 events of ball.position make room for the fall\n");
  EXPECT_EQ(notices(ball + "at 49f fall ball for 2s\n"), "");
  EXPECT_EQ(notices("rate 24\ncreate ball sphere position=(0 9 0)\nat 1f fall ball\nat 9f fall ball\n"),
            "");  // an earlier fall
}

}  // namespace
}  // namespace betwixt
