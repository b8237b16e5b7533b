// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tracks from columns of numbers: they equal the tracks of scripts with the same rows.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "betwixt/language.h"
#include "betwixt/session.h"
#include "betwixt/track.h"
#include "support/told.h"

namespace betwixt {
namespace {

const std::string plain_text = "rate 30\ncreate ball sphere\ncreate other box\n";

Session begun(const std::string& text, bool in_place) {
  Session s;
  s.begin(text, "film.bx");
  if (in_place) s.edit_in_place();
  return s;
}

std::vector<Time> frames(std::size_t count, int step = 1) {
  std::vector<Time> out;
  for (std::size_t i = 0; i < count; ++i) out.push_back(Rate{30, 1}.frame(1.0 + static_cast<double>(i) * step));
  return out;
}

// Its text makes the same film, and its numbers are those that were given.
void expect_sound(const Session& s, const std::string& target, std::span<const Time> times,
                  std::span<const double> numbers) {
  const Loaded again = load_text(s.text(), "film.bx");
  EXPECT_FALSE(has_errors(again.diagnostics)) << s.text().substr(0, 400);
  EXPECT_TRUE(again.document == s.document()) << s.text().substr(0, 400);
  const auto found = track_numbers(s.document(), target);
  ASSERT_TRUE(found) << found.error().message;
  EXPECT_TRUE(std::equal(found->times.begin(), found->times.end(), times.begin(), times.end()));
  EXPECT_TRUE(std::equal(found->numbers.begin(), found->numbers.end(), numbers.begin(), numbers.end()));
}

TEST(SetTrack, IsTheTrackOfItsRows) {
  std::mt19937 random(2);
  const auto number = [&](double from, double to) { return std::uniform_real_distribution(from, to)(random); };
  struct Case {
    const char *target, *twerper;
    std::size_t width;
    double low, high;
  };
  for (const bool in_place : {false, true})
    for (const Case& c : {Case{"ball.position.x", "", 1, -9, 9},
                          {"ball.position", "linear", 3, -9, 9},
                          {"ball.rotation", "smooth", 3, -9, 9},
                          {"ball.rotation.z", "bezier(0.2 0 0.4 1)", 1, -9, 9},
                          {"ball.color", "", 3, 0, 1},
                          {"ball.transparency", "hold", 1, 0, 1},
                          {"ball.position.velocity", "", 3, -9, 9}}) {
      Session s = begun(plain_text, in_place);
      for (const std::size_t count : {1U, 2U, 300U, 7U}) {
        std::vector<double> numbers(count * c.width);
        for (double& n : numbers) n = number(c.low, c.high);
        std::vector<Time> times = frames(count, 3);
        if (count > 2) times[1] = {times[0].flicks + 12345};  // not on a frame
        const Session::Answer answer = s.set_track(c.target, times, numbers, c.twerper);
        ASSERT_TRUE(answer.done) << c.target << ": " << answer.said;
        expect_sound(s, c.target, times, numbers);
      }
      EXPECT_EQ(s.unsaved(), 4U);
    }
}

// A component of a track of whole values, and the whole value of a track of components.
TEST(SetTrack, ReplacesPartsAndWholes) {
  for (const bool in_place : {false, true}) {
    Session s = begun(plain_text + "ball.position\n  1f (1 2 3)\n  90f (4 5 6)\n", in_place);
    EXPECT_EQ(track_numbers(s.document(), "ball.position.y")->numbers, (std::vector<double>{2, 5}));
    const std::vector<double> line{7, 8, 9};
    ASSERT_TRUE(s.set_track("ball.position.y", frames(3), line, "linear").done);
    expect_sound(s, "ball.position.y", frames(3), line);
    EXPECT_EQ(track_numbers(s.document(), "ball.position.z")->numbers, (std::vector<double>{3, 6}));
    const std::vector<double> rows{1, 2, 3, 4, 5, 6};
    const Session::Answer answer = s.set_track("ball.position", frames(2), rows);
    ASSERT_TRUE(answer.done) << answer.said;
    expect_sound(s, "ball.position.x", frames(2), std::vector<double>{1, 4});
    expect_sound(s, "ball.position.y", frames(2), std::vector<double>{2, 5});
    expect_sound(s, "ball.position.z", frames(2), std::vector<double>{3, 6});
  }
}

TEST(SetTrack, ReplacesItsOwnRowsAndIsUndone) {
  Session s = begun(plain_text + "ball.position.x\n  1f 5\n  900f 6\n", true);
  const std::string before = s.text();
  const Document first = s.document();
  const std::vector<double> numbers(100, 2.5);
  ASSERT_TRUE(s.set_track("ball.position.x", frames(100), numbers).done);
  const std::string text = s.text();
  const Document second = s.document();
  for (int k = 0; k < 5; ++k) ASSERT_TRUE(s.set_track("ball.position.x", frames(100), numbers).done);
  EXPECT_EQ(s.text(), text);  // it does not grow
  ASSERT_TRUE(s.set_track("other.position.x", frames(3), std::vector<double>{1, 2, 3}).done);
  EXPECT_TRUE(s.text().starts_with(text));
  ASSERT_TRUE(s.set_track("ball.position.x", frames(2), std::vector<double>{-0.0, 1}).done);
  expect_sound(s, "ball.position.x", frames(2), std::vector<double>{0, 1});
  for (int k = 0; k < 7; ++k) ASSERT_TRUE(s.enter("undo").done) << k;
  EXPECT_EQ(s.text(), text);
  EXPECT_TRUE(s.document() == second);
  ASSERT_TRUE(s.enter("undo").done);
  EXPECT_EQ(s.text(), before);
  EXPECT_TRUE(s.document() == first);
  ASSERT_TRUE(s.enter("redo").done);
  EXPECT_EQ(s.text(), text);
  // A line after it stays where it is.
  ASSERT_TRUE(s.enter("ball.position.x").done);
  ASSERT_TRUE(s.enter("  2f 77").done);
  ASSERT_TRUE(s.set_track("ball.position.x", frames(2), std::vector<double>{3, 4}).done);
  expect_sound(s, "ball.position.x", frames(2), std::vector<double>{3, 4});
}

// The text is written when somebody asks for it; when does not matter.
TEST(SetTrack, WritesTheSameTextNowAndLater) {
  std::mt19937 random(5);
  for (int round = 0; round < 60; ++round) {
    Session asked = begun(plain_text + "ball.position.x\n  1f 5\n  900f 6\n", true),
            not_asked = begun(asked.text(), true);
    for (int k = 0; k < 12; ++k) {
      const auto both = [&](const auto& act) { EXPECT_EQ(act(asked).done, act(not_asked).done); };
      const std::size_t count = 1 + random() % 5;
      const std::vector<double> numbers(count, static_cast<double>(random() % 9));
      switch (random() % 8) {
        case 0:
          both([](Session& s) { return s.enter("undo"); });
          break;
        case 1:
          both([](Session& s) { return s.enter("redo"); });
          break;
        case 2:
          both([&](Session& s) { return s.enter(fmt::format("at 7f other.position.x {}", k)); });
          break;
        default: {
          const char* const target = random() % 3 ? "ball.position.x" : "other.position.y";
          both([&](Session& s) { return s.set_track(target, frames(count), numbers); });
        }
      }
      (void)asked.text();
    }
    ASSERT_EQ(asked.text(), not_asked.text());
    const Loaded again = load_text(asked.text(), "film.bx");
    EXPECT_TRUE(again.document == asked.document());
    while (asked.enter("undo").done) ASSERT_TRUE(not_asked.enter("undo").done);
    ASSERT_EQ(asked.text(), not_asked.text());
  }
}

TEST(SetTrack, SaysWhatIsWrong) {
  Session s = begun(plain_text + "at 5f ball.geometry shape(other)\nball.position.y\n  1f 2\n", true);
  const std::string text = s.text();
  const auto code = [&](const char* target, std::vector<Time> times, std::vector<double> numbers,
                        const char* twerper = "") {
    const Session::Answer answer = s.set_track(target, times, numbers, twerper);
    EXPECT_TRUE(answer.refused);
    EXPECT_FALSE(answer.said.empty());
    EXPECT_EQ(s.text(), text);
    return answer.said;
  };
  const auto has = [](const std::string& said, const char* words) {
    EXPECT_NE(said.find(words), std::string::npos) << said;
  };
  has(code("bal.position", frames(1), {1, 2, 3}), "bal");
  has(code("{ball,other}.position", frames(1), {1, 2, 3}), "does not name one track");
  has(code("ball.geometry", frames(1), {1}), "are not numbers");
  has(code("ball.position.x", {}, {}), "at least one time");
  has(code("ball.position", frames(2), {1, 2, 3}), "2 times need 6 numbers, not 3");
  has(code("ball.position", frames(1), {1, 2}), "1 time needs 3 numbers, not 2");
  has(code("ball.position.x", {frames(2)[1], frames(2)[0]}, {1, 2}), "time 2 is not after the time before it");
  has(code("ball.position.x", frames(2), {1, NAN}), "value 2 is not finite");
  has(code("ball.transparency", frames(2), {0.5, 1.5}), "value 2 is 1.5, which is not from 0 to 1");
  has(code("ball.position.x", frames(2), {1, 2}, "liner"), "liner");
  const auto told_of = [&](const char* target) { return told(track_numbers(s.document(), target)); };
  EXPECT_EQ(told_of("bal.position"), "name bal");
  EXPECT_EQ(told_of("ball.geometry"), "type ball.geometry");
  EXPECT_EQ(told_of("ball.position"), "type ball.position");  // its components have tracks of their own
  const auto none = track_numbers(s.document(), "other.scale");
  ASSERT_TRUE(none);
  EXPECT_EQ(none->width, 3U);
  EXPECT_TRUE(none->times.empty());
}

// The rows of a call are replaced only if nothing else was done since, however long the text is.
TEST(SetTrack, LeavesOtherLinesAlone) {
  Session s = begun(plain_text, true);
  ASSERT_TRUE(s.set_track("ball.position.x", frames(2), std::vector<double>{1, 2}).done);
  const std::size_t size = s.text().size();
  ASSERT_TRUE(s.enter("undo").done);
  const std::string other = "set ball.color red  # ";
  const std::string line = other + std::string(size - s.text().size() - other.size() - 1, 'x');
  ASSERT_TRUE(s.enter(line).done);
  ASSERT_EQ(s.text().size(), size);
  ASSERT_TRUE(s.set_track("ball.position.x", frames(2), std::vector<double>{3, 4}).done);
  EXPECT_NE(s.text().find(line), std::string::npos) << s.text();
  expect_sound(s, "ball.position.x", frames(2), std::vector<double>{3, 4});
}

TEST(SetTrack, InstancesOfAKindFollow) {
  for (const bool in_place : {false, true}) {
    Session s =
        begun(plain_text + "create man group\ncreate man/hat sphere\ndefine kind human like man\ncreate anna human\n",
              in_place);
    for (const std::size_t count : {9U, 2U, 1U}) {
      const std::vector<double> numbers(count, 4);
      ASSERT_TRUE(s.set_track("man/hat.position.x", frames(count), numbers).done);
      expect_sound(s, "man/hat.position.x", frames(count), numbers);
      expect_sound(s, "anna/hat.position.x", frames(count), numbers);
    }
  }
}

// Many lines without a message are read at once, which must make no difference.
TEST(SetTrack, ManyLinesAreThoseOneByOne) {
  std::vector<std::string> lines{"create c box", "c.position.x"};
  for (int i = 1; i < 200; ++i) lines.push_back(fmt::format("  {}f {}", i, i % 7));
  lines.push_back("set c.color red");
  for (const bool in_place : {false, true}) {
    Session together = begun(plain_text, in_place), single = begun(plain_text, in_place);
    ASSERT_TRUE(together.enter_together(lines).done);
    for (const std::string& line : lines) ASSERT_TRUE(single.enter(line).done) << line;
    EXPECT_TRUE(together.document() == single.document());
    EXPECT_EQ(together.text(), single.text());
    ASSERT_TRUE(together.enter("undo").done);
    EXPECT_EQ(together.text(), plain_text);
    lines.push_back("set d.color red");
    const Session::Answer wrong = together.enter_together(lines);
    EXPECT_TRUE(wrong.refused);
    ASSERT_FALSE(wrong.why.empty());
    EXPECT_EQ(wrong.why.back().what.place.line, 203);
    EXPECT_EQ(together.text(), plain_text);
    lines.pop_back();
  }
}

}  // namespace
}  // namespace betwixt
