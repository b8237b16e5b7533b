// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests sections: a film with blocks is the film that the same lines make with the times of the whole film.
#include <fmt/format.h>

#include "scene/document.h"
#include "support/folder.h"
#include "support/loaded_film.h"

namespace betwixt {
namespace sections_test {

// The film as a script without its sections.
std::string without_sections(const Document& d) {
  std::string out, text = write(d);
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = text.find('\n', at) + 1;
    if (!text.substr(at, end - at).starts_with("section ")) out += text.substr(at, end - at);
    at = end;
  }
  return out;
}

void same_film(const std::string& blocks, const std::string& plain) {
  const Loaded a = read(blocks), b = read(plain);
  EXPECT_TRUE(a.diagnostics.empty()) << blocks << to_string(a.diagnostics[0]);
  EXPECT_TRUE(b.diagnostics.empty()) << plain;
  EXPECT_EQ(without_sections(a.document), write(b.document));
}

// The beginnings and ends of all sections, in frames of 24 to the second, counted from 0.
std::string spans(const std::string& text) {
  const Loaded film = read(text);
  std::string out;
  for (const Section& s : film.document.sections())
    out += s.name + " " + std::to_string(std::lround(s.begin.seconds() * 24)) + ".." +
           std::to_string(std::lround(s.end.seconds() * 24)) + " ";
  return out;
}

std::string first_error(const std::string& text) {
  const Loaded film = read(text);
  for (const Diagnostic& d : film.diagnostics)
    if (d.severity == Severity::error)
      return std::to_string(d.what.place.line) + ":" + std::to_string(d.what.place.column) + " " + d.what.message +
             (d.what.hint.empty() ? "" : " (" + std::string(d.what.hint) + ")");
  return {};
}

const std::string ball = "create ball sphere\n";

TEST(Sections, TimesCountFromTheBeginningOfTheirSection) {
  same_film(ball +
                "section one\n  ball.position\n    1f (0 0 0)\n    # later\n\n    25f (1 0 0) linear\n"
                "section two\n  at 1f ball.color red\n  at 13f ball.color gold\n"
                "  ball.radius\n    1f 1\n    +12f 2\nat 13f ball.shininess 0.5\n",
            ball +
                "ball.position\n  1f (0 0 0)\n  25f (1 0 0) linear\nat 25f ball.color red\nat 37f ball.color gold\n"
                "ball.radius\n  25f 1\n  37f 2\nat 13f ball.shininess 0.5\n");
}

TEST(Sections, SpeedDividesTimesAndLengths) {
  same_film(ball +
                "section one at 2s speed=2\n  ball.position\n    0s (0 0 0)\n    3s (3 0 0) ease-in=1s\n"
                "  at 4s ball.color gold for 2s\n",
            ball + "ball.position\n  2s (0 0 0)\n  3.5s (3 0 0) ease-in=0.5s\nat 4s ball.color gold for 1s\n");
  EXPECT_EQ(spans(ball + "section one at 2s speed=2\n  at 4s ball.color gold for 2s\nsection two\n"),
            "one 48..120 two 120..120 ");
}

TEST(Sections, BeginWhereOthersEnd) {
  EXPECT_EQ(spans("section a for 1s\nsection b for 2s\nsection c at 10s for 1s\nsection d\n"),
            "a 0..24 b 24..72 c 240..264 d 264..264 ");
  EXPECT_EQ(spans("section a after c for 1s\nsection b at 0s for 2s\nsection c after b for 3s\n"),
            "a 120..144 b 0..48 c 48..120 ");
  EXPECT_EQ(spans("section last after middle for 1s\nsection middle after first for 1s\n"
                  "section first at 1s for 1s\nsection behind after last for 1s\n"),
            "last 72..96 middle 48..72 first 24..48 behind 96..120 ");
  EXPECT_EQ(spans(ball + "section a after b\n  at 24f ball.color red\nsection b at 0s\n  at 49f ball.color gold\n"),
            "a 48..71 b 0..48 ");
}

TEST(Sections, TheirEdgesAreTimes) {
  same_film(ball +
                "section a at 1s for 1s\nsection b at 4s for 1s speed=2\n  at a.end ball.color red\n"
                "  at a.end+1s ball.color gold\nat b.start ball.radius 2\nat b.end-12f ball.radius 3\n"
                "ball.position\n  a.start (0 0 0)\n  a.end (1 0 0)\nrange a.start..b.end\n",
            ball +
                "at 2s ball.color red\nat 2.5s ball.color gold\nat 4s ball.radius 2\nat 4s ball.radius 3\n"
                "ball.position\n  1s (0 0 0)\n  2s (1 0 0)\nrange 1s 4.5s\n");
  same_film(ball + "at proof.start ball.color red\nsection proof at 3s for 1s\n", ball + "at 3s ball.color red\n");
}

TEST(Sections, MistakesHavePlaces) {
  EXPECT_EQ(first_error("section a for 1s\nsection b after intro\nsection indro for 1s\n"),
            "2:17 there is no section 'intro' (did you mean 'indro'?)");
  EXPECT_EQ(first_error("section a for 1s\nsection a for 2s\n"),
            "2:9 there is a section 'a' already (two sections cannot have one name)");
  EXPECT_EQ(first_error("section a after b\nsection b after a\n").substr(0, 65),
            "1:17 these sections wait for each other: a after b after a (let o");
  EXPECT_EQ(first_error("section a after a\n"), "1:17 'a' cannot begin after itself");
  EXPECT_EQ(first_error("section a\n  section b\n").substr(0, 40), "2:3 a section cannot contain another one");
  EXPECT_EQ(first_error("section a speed=0\n").substr(0, 22), "1:17 a speed must be f");
  EXPECT_EQ(first_error(ball + "section a\n    hide ball\n  hide ball\n").substr(0, 48),
            "4:1 this line is indented less than the lines of");
  EXPECT_EQ(first_error(ball + "section a\n  at a.end hide ball\n").substr(0, 40),
            "3:6 the end of 'a' is not known in its o");
  EXPECT_EQ(first_error(ball + "section a at b.end for 1s\nsection b at a.end for 1s\n").substr(0, 44),
            "2:9 the times of section 'a' depend on thems");
  // An error in the opener is one error.
  const Loaded once = read(ball + "section a soon\n  at 1f ball.color red\n  create box1 box\nhide box1\n");
  EXPECT_EQ(once.diagnostics.size(), 1u);
}

TEST(Sections, OverlapsAreWarnings) {
  const Loaded film = read("section a for 2s\nsection b at 1s for 2s\n");
  ASSERT_EQ(film.diagnostics.size(), 1u);
  EXPECT_EQ(film.diagnostics[0].severity, Severity::warning);
  EXPECT_EQ(film.diagnostics[0].what.place.line, 2);
  EXPECT_EQ(film.diagnostics[0].what.message, "section 'b' begins before 'a' ends");
}

TEST(Sections, AreWrittenAndReadBack) {
  const Loaded film = read(ball +
                           "rate 30\nsection a at 1s speed=1.2\n  at 31f ball.color red\nsection b for 40f\n"
                           "  at 10f step \"x\" note=\"say \\\"y\\\"\"\n  step\n  at 5f describe \"it falls\"\n");
  EXPECT_TRUE(film.diagnostics.empty());
  const Loaded again = read(write(film.document));
  EXPECT_TRUE(again.diagnostics.empty()) << write(film.document);
  EXPECT_EQ(again.document, film.document) << write(film.document);
  ASSERT_EQ(film.document.pauses().size(), 2u);
  EXPECT_EQ(film.document.pauses()[0].time, film.document.sections()[1].begin);
  EXPECT_EQ(film.document.pauses()[1].note, "say \"y\"");
  EXPECT_EQ(film.document.descriptions()[0].text, "it falls");
}

TEST(Sections, TidyKeepsTheirBlocks) {
  const std::string text =
      "section  a  for 2.0s\n\n    # all of it\n    ball.position\n          24.0f (1 0 0)\n          1f (0 0 0)\n"
      "    hide   ball\n    section_less.x  # a target\nhide  ball\n";
  const std::string tidied = tidy(text);
  EXPECT_EQ(tidied,
            "section a for 2s\n\n  # all of it\n  ball.position\n    1f   (0 0 0)\n    24f  (1 0 0)\n  hide ball\n"
            "  section_less.x  # a target\nhide ball\n");
  EXPECT_EQ(tidy(tidied), tidied);
}

TEST(Sections, AFileThatABlockUsesHasItsTimes) {
  const Folder folder;
  folder.put("part.bx", "at 1f ball.color red\nball.radius\n  1s 2\n");
  folder.put("film.bx", ball + "section a at 5s\n  use \"part.bx\"\nsection b for 1s\n");
  const Loaded film = load_file(folder / "film.bx");
  EXPECT_TRUE(film.diagnostics.empty());
  EXPECT_EQ(without_sections(film.document),
            write(read(ball + "at 5s ball.color red\nat 6s ball.radius 2\n").document));
  EXPECT_EQ(film.document.sections()[1].begin, from_seconds(6));
}

TEST(Sections, EdgesAreOperandsOfFormulas) {
  const std::string two = ball + "section intro for 2s\nsection proof after intro for 3s\n";
  same_film(two +
                "let b = proof.start\nlet late = proof.end-12f\nat b ball.color red\nat late ball.color gold\n"
                "at 12f+intro.end ball.radius 2\nat (proof.start+proof.end)/2 ball.shininess 0.5\n",
            ball +
                "let b = 1f+2s\nlet late = -11f+5s\nat 49f ball.color red\nat 109f ball.color gold\n"
                "at 61f ball.radius 2\nat 85f ball.shininess 0.5\n");
  same_film(ball + "let b = proof.start\nat b+12f ball.color red\nsection intro for 2s\nsection proof for 1s\n",
            ball + "let b = 1f+2s\nat 61f ball.color red\n");
  EXPECT_EQ(first_error(two + "let b = prof.start\n"), "4:9 there is no section 'prof' (did you mean 'proof'?)");
}

TEST(Sections, OutsideTheRangeAreWarnedOf) {
  const auto said = [](const std::string& range) {
    std::string all;
    for (const Diagnostic& d : read(ball + "section one for 1s\nsection two for 1s\n" + range).diagnostics)
      all += fmt::format("{} {}\n", d.what.place.line, d.what.message);
    return all;
  };
  EXPECT_EQ(said(""), "");
  EXPECT_EQ(said("range 1f two.end\n"), "");
  EXPECT_EQ(said("range 1f 12f\n"), "3 section 'two' is behind the range of the film\n");
  EXPECT_EQ(said("range two.start two.end\n"), "2 section 'one' is before the range of the film\n");
}

}  // namespace sections_test
}  // namespace betwixt
