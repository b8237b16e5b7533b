// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests notes and their track.
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
  EXPECT_EQ(after("copy notes 1f..5f to 21f times 2"), "a1 b5 c5 d9 a21 a25 b25 c25 b29 c29 ");
}

TEST(Notes, HaveColours) {
  const std::string more = "at 7f note \"e\" color=#00ff00\nat 7f note \"f\"\n";
  EXPECT_EQ(after("", more), "a1 b5 c5 elime7 f7 d9 ");
  EXPECT_EQ(after("move notes 7f..7f by 4f", more), "a1 b5 c5 d9 elime11 f11 ");
  EXPECT_EQ(after("copy notes 7f..7f to 21f times 2", more), "a1 b5 c5 elime7 f7 d9 elime21 elime21 f21 f21 ");
  EXPECT_EQ(told("at 5f note \"b\" colour=red\n"), "type 1:16 colour");
  EXPECT_EQ(told("at 5f note \"b\" color red\n"), "syntax 1:22 red");
  EXPECT_EQ(told("at 5f note \"b\" color=redd\n"), "name 1:22 redd");
  EXPECT_EQ(told("at 5f note \"b\" color=red 7\n"), "syntax 1:26 7");
}

TEST(Notes, ThingsOfThatNameAreTargetsAsBefore) {
  EXPECT_EQ(after("clear notes.position 1f..9f", "create notes box\nnotes.position\n  1f (1 2 3)\n"), "a1 b5 c5 d9 ");
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
