// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests notes, steps and descriptions and their tracks.
#include "language/values.h"
#include "scene/document.h"
#include "support/loaded_film.h"

namespace betwixt {
namespace {

// The notes of a film whose notes stand at 1f, 5f, 5f and 9f, after a command.
std::string after(const std::string& command, const std::string& more = {}) {
  const LoadedFilm film(more + "at 1f note \"a\"\nat 5f note \"b\"\nat 5f note \"c\"\nat 9f note \"d\"\n" + command +
                        "\n");
  std::string out;
  for (const auto& [time, note] : *film.loaded.document.scene().notes) {
    EXPECT_EQ(note.time, time);
    const std::string color = note.color ? write_color(*note.color) : "";
    out += fmt::format("{}{}{} ", note.text, color, film.loaded.document.rate().frame_number(time));
  }
  EXPECT_EQ(LoadedFilm(write(film.loaded.document)).loaded.document, film.loaded.document);
  return out;
}

// shows: G28
TEST(Notes, AreATrack) {
  EXPECT_EQ(after(""), "a1 b5 c5 d9 ");
  EXPECT_EQ(after("clear notes 5f"), "a1 d9 ");
  EXPECT_EQ(after("clear notes 1f..5f"), "d9 ");
  EXPECT_EQ(after("move notes 1f..5f by 4f"), "a5 d9 b9 c9 ");
  EXPECT_EQ(after("stretch notes 1f..9f by 0.5"), "a1 b3 c3 d5 ");
  EXPECT_EQ(after("reverse notes 1f..5f"), "b1 c1 a5 d9 ");
  EXPECT_EQ(after("copy notes 5f..9f to 21f"), "a1 b5 c5 d9 b21 c21 d25 ");
  EXPECT_EQ(after("copy notes 1f..5f to 21f times 2"), "a1 b5 c5 d9 a21 b25 c25 a25 b29 c29 ");
}

TEST(Notes, HaveColours) {
  const std::string more = "at 7f note \"e\" color=#00ff00\nat 7f note \"f\"\n";
  EXPECT_EQ(after("", more), "a1 b5 c5 elime7 f7 d9 ");
  EXPECT_EQ(after("move notes 7f..7f by 4f", more), "a1 b5 c5 d9 elime11 f11 ");
  EXPECT_EQ(after("copy notes 7f..7f to 21f times 2", more), "a1 b5 c5 elime7 f7 d9 elime21 f21 elime21 f21 ");
  EXPECT_EQ(told("at 5f note \"b\" colour=red\n"), "type 1:16 colour");
  EXPECT_EQ(told("at 5f note \"b\" color red\n"), "syntax 1:22 red");
  EXPECT_EQ(told("at 5f note \"b\" color=redd\n"), "name 1:22 redd");
  EXPECT_EQ(told("at 5f note \"b\" color=red 7\n"), "syntax 1:26 7");
}

TEST(Notes, ThingsOfThatNameAreTargetsAsBefore) {
  EXPECT_EQ(after("clear notes.position 1f..9f", "create notes box\nnotes.position\n  1f (1 2 3)\n"), "a1 b5 c5 d9 ");
}

// The names of the steps, or the texts of the descriptions, of a film with steps at 1f, 5f and 9f, after a command.
std::string cues_after(const std::string& command) {
  const LoadedFilm film(
      "at 1f step \"a\" note=\"n\"\nat 5f step \"b\"\nat 9f step \"c\"\n"
      "at 1f describe \"x\"\nat 5f describe \"y\"\n" +
      command + "\n");
  const Document& d = film.loaded.document;
  std::string out;
  for (const Pause& p : d.pauses()) out += fmt::format("{}{}{} ", p.text, p.note, d.rate().frame_number(p.time));
  for (const Description& p : d.descriptions()) out += fmt::format("{}{} ", p.text, d.rate().frame_number(p.time));
  EXPECT_EQ(LoadedFilm(write(d)).loaded.document, d);
  return out;
}

TEST(Cues, StepsAndDescriptionsAreTracks) {
  EXPECT_EQ(cues_after(""), "an1 b5 c9 x1 y5 ");
  EXPECT_EQ(cues_after("clear steps 5f"), "an1 c9 x1 y5 ");
  EXPECT_EQ(cues_after("clear steps before 9f"), "c9 x1 y5 ");
  EXPECT_EQ(cues_after("move steps 1f..5f by 2f"), "an3 b7 c9 x1 y5 ");
  // A step is alone at its time.
  EXPECT_EQ(cues_after("move steps 1f..1f by 4f"), "an5 c9 x1 y5 ");
  EXPECT_EQ(cues_after("move steps 1f..5f by 4f"), "an5 b9 x1 y5 ");
  EXPECT_EQ(cues_after("stretch steps 1f..9f by 2"), "an1 b9 c17 x1 y5 ");
  EXPECT_EQ(cues_after("reverse steps 1f..9f"), "c1 b5 an9 x1 y5 ");
  EXPECT_EQ(cues_after("copy steps 1f..5f to 21f times 2"), "an1 b5 c9 an21 an25 b29 x1 y5 ");
  EXPECT_EQ(cues_after("move descriptions 5f..5f by 1s"), "an1 b5 c9 x1 y29 ");
  EXPECT_EQ(cues_after("clear descriptions 1f..5f"), "an1 b5 c9 ");
  EXPECT_EQ(told("at 5f step\nmove steps 5f..5f by -200000000000s\n"), "range 2:22 -200000000000s");
  EXPECT_EQ(told("at 5f step\ncopy steps 5f..5f to 9f times 200000\n"), "range 2:6 steps");
  EXPECT_EQ(told("scale steps 1f..9f 2\n"), "syntax 1:7 steps");
  EXPECT_EQ(told("step at 12f\n"), "type 1:6 at");
}

TEST(Notes, WhatCannotBeIsSaid) {
  const auto first = [](const std::string& line) { return told("at 5f note \"b\"\n" + line + "\n"); };
  EXPECT_EQ(first("move notes 1f..9f by 4000000000s"), "");
  EXPECT_EQ(first("at 4000000000s note \"c\"\nmove notes 1f..4000000000s by 4000000000s"), "range 3:6 notes");
  EXPECT_EQ(first("stretch notes 1f..9f by 1e300"), "range 2:9 notes");
  EXPECT_EQ(first("copy notes 1f..9f to 4599999999s times 1000000"), "range 2:6 notes");
  EXPECT_EQ(first("copy notes 5f..5f to 9f times 1000000"), "range 2:6 notes");
  EXPECT_EQ(first("clear notes"), "syntax 2:12");
  EXPECT_EQ(first("copy notes 1f..9f"), "syntax 2:18");
  EXPECT_EQ(first("scale notes 1f..9f 2"), "syntax 2:7 notes");
}

}  // namespace
}  // namespace betwixt
