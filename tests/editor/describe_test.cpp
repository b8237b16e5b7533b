// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests the texts that describe a film, and questions about it.
#include "editor/describe.h"

#include "editor/author.h"
#include "editor/plain_values.h"
#include "support/loaded_film.h"

namespace betwixt {
namespace {

std::string described(const std::string& film, const std::string& word) {
  const LoadedFilm s(film);
  const auto said = describe(s.loaded.document, word);
  return said ? *said : said.error().message;
}

// shows: G22 G104
TEST(Describe, AllThatMakesAValue) {
  const std::string film =
      "create ball sphere position=(0 1 0)\nlayer sway add\nball.position\n  2f (0 0 0) linear ease-out=2f\n"
      "  9f (1 0 0) cut (2 0 0)\ntwerper ball.position smooth\nextend ball.position cycle\n"
      "filter ball.position limit high=5\nat 5f ball.position.velocity (1 0 0)\non sway at 3f ball.position (0 1 0)\n"
      "on sway set ball.radius 1\n";
  EXPECT_EQ(described(film, "ball.position"),
            "ball.position\n  2f       (0 0 0) linear ease-out=2f\n  9f       (1 0 0) cut (2 0 0)\n"
            "  set ball.position (0 1 0)\n  twerper ball.position smooth\n  extend ball.position cycle\n"
            "  ball.position.velocity\n    5f (1 0 0)\n  filter ball.position limit high=5\n"
            "  on sway ball.position\n    3f (0 1 0)\n");
  const std::string ball = described(film, "ball");
  EXPECT_NE(ball.find("at 1f; 2 events, twerper smooth, extend cycle, velocity 1 event, filter limit, layer sway\n"),
            std::string::npos)
      << ball;
  EXPECT_NE(ball.find("  radius           2 at 1f; layer sway\n"), std::string::npos) << ball;
}

// shows: G22
TEST(Describe, WhatAnObjectHangsOnAndWhenThatEnds) {
  EXPECT_TRUE(
      described("create a sphere\ncreate b box\nat 5f attach a to b keep-world\nat 9f letgo a\nat 12f detach a\n", "a")
          .starts_with(
              "a, a sphere\n  is attached to b from 5f, keep-world\n  is let go at 9f\n  is detached at 12f\n"));
}

TEST(Describe, WhatCanOnlyBeAsked) {
  const std::string film = "create a sphere\ncreate b sphere\ncreate eye camera position=(0 0 9)\n";
  EXPECT_EQ(described(film, "a.touching"), "a.touching  (b)\n");
  EXPECT_EQ(described(film, "a.in-view"), "a.in-view  on\n");
  EXPECT_EQ(described(film, "a.world.x"), "a.world.x  0\n");
}

// shows: G91 R-T13
TEST(Notes, AreShownAsPlayingPassesThem) {
  const std::string film = "rate 10\nat 3f note \"a\"\nat 3.5f note \"b\"\nat 4f note \"c\"\nat 9f note \"d\"\n";
  const LoadedFilm s(film), off(film + "notes off\n");
  const auto at = [&](int frame) { return s.loaded.document.rate().frame(frame); };
  const Document& d = s.loaded.document;
  EXPECT_EQ(notes_shown(d, at(3), at(4)), "\"b\" \"c\"");
  EXPECT_EQ(notes_shown(d, at(2), at(9)), "\"a\" \"b\" \"c\" \"d\"");
  EXPECT_EQ(notes_shown(d, {}, at(3)), "\"a\"");  // a jump
  EXPECT_EQ(notes_shown(d, {}, at(5)), "");
  EXPECT_EQ(notes_shown(d, at(4), at(8)), "");
  EXPECT_EQ(notes_shown(off.loaded.document, at(2), at(9)), "");
}

TEST(Describe, ComponentsWithTracksOfTheirOwnAreNamed) {
  const Document d = read("create b box\nb.position.x\n  1f 0\n  25f 4\nat 12f b.position.z 3\n").document;
  EXPECT_EQ(*describe(d, "b.position"),
            "b.position\n  b.position.x\n  1f       0\n  25f      4\n  b.position.z\n  12f      3\n");
}

TEST(Describe, PeopleReadDegrees) {
  const Document d =
      read("rate 24\ncreate b box\nb.rotation\n  1f (0 0 0) linear\n  25f (30deg 100deg 0.1turn)\n").document;
  const auto said_of = values_at(d, {"b.rotation"}, {{"11f", *parse_time("11f", d)}});
  ASSERT_TRUE(said_of);
  EXPECT_NE(said_of->find("euler(12.5deg 41.666666667deg 15deg)"), std::string::npos) << *said_of;
}

TEST(Describe, CodeThatIsSetIsShown) {
  EXPECT_EQ(described("create a sphere\nset a.radius = \"1 + t\"\n", "a.radius"),
            "a.radius  1\n  set a.radius = \"1 + t\"\n");
}

TEST(Describe, AnEnvironmentSaysHowItMovesWhat) {
  EXPECT_EQ(described("create {ball,wheel} sphere\nanimate wind every 2t by translate(0.1 0 0)\nat 90t halt wind\n"
                      "set ball.environments wind\nset wheel.drive (wind)\n",
                      "wind"),
            "wind, an environment\n  at 0t animate wind every 2t by translate(0.1 0 0)\n  at 90t halt wind\n"
            "  moves ball\n  drives wheel\n");
}

TEST(Describe, OfAComponentOnlyWhatThereIs) {
  EXPECT_EQ(described("rate 24\ncreate b sphere\nat 1f b.position.x.velocity 2\n", "b.position.x"),
            "b.position.x  0\n  b.position.x.velocity\n    1f 2\n");
}

}  // namespace
}  // namespace betwixt
