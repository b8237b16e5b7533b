// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests entrances and exits: the events that they write.
#include "support/loaded_film.h"

namespace betwixt {
namespace {

TEST(Entrances, WritePlainEvents) {
  const LoadedFilm s(
      "create title text text=\"abcdé\"\ncreate way line to=(3 0)\ncreate ball sphere transparency=0.25\n"
      "at 25f write title\nat 25f draw way for 12f\nat 25f fade-in ball\nat 73f fade-out ball for 24f\n");
  expect_numbers(s, {{"title.display", "24f", {0}},
                     {"title.display", "25f", {1}},
                     {"title.typed", "25f", {0}},
                     {"title.typed", "37f", {2.5}},
                     {"title.typed", "49f", {20000}},  // a longer text is not cut off
                     {"way.trim", "25f", {0, 0, 0}},
                     {"way.trim", "37f", {0, 1, 0}},
                     {"ball.transparency", "25f", {1}},
                     {"ball.transparency", "37f", {0.625}},
                     {"ball.transparency", "60f", {0.25}},
                     {"ball.transparency", "85f", {0.625}},
                     {"ball.display", "96f", {1}},
                     {"ball.display", "97f", {0}}});
  // The same events as rows of a sheet.
  const LoadedFilm rows(
      "create ball sphere\nat 1f hide ball\nat 25f show ball\nat 25f ball.scale (0 0 0) ease-out\n"
      "at 49f ball.scale (1 1 1) hold\n");
  EXPECT_TRUE(LoadedFilm("create ball sphere\nat 25f grow ball\n").loaded.document == rows.loaded.document);
}

TEST(Entrances, TakeAllBelow) {
  const LoadedFilm s(
      "create man group\ncreate man/arm box\ncreate man/leg box\nat 25f fade-in man\nat 49f shrink man\n");
  expect_numbers(s, {{"man/arm.transparency", "25f", {1}},
                     {"man/leg.transparency", "49f", {0}},
                     {"man/leg.display", "24f", {0}},
                     {"man.scale", "73f", {0, 0, 0}},
                     {"man/arm.scale", "73f", {1, 1, 1}}});
}

TEST(Entrances, MorphEndsAsTheOther) {
  const LoadedFilm s(
      "create a rectangle color=red\ncreate b circle color=blue position=(3 1)\nat 25f morph a into b for 24f\n");
  expect_numbers(s, {{"b.display", "1f", {0}},
                     {"a.display", "48f", {1}},
                     {"a.display", "49f", {0}},
                     {"b.display", "49f", {1}},
                     {"a.position", "49f", {3, 1, 0}},
                     {"a.color", "49f", {0, 0, 1}}});
}

TEST(Entrances, SayWhatIsWrong) {
  const std::string head = "create ball sphere\ncreate lamp light\n";
  for (const auto& [line, told] : std::vector<std::pair<std::string, std::string>>{
           {"at 1f write", "3:12: the name of an object is missing here"},
           {"at 1f write lamp", "3:13: 'lamp' is a light, which has no picture"},
           {"at 1f grow ball for 0f", "3:12: the length must be greater than 0"},
           {"at 1f grow ball till 3f", "3:17: 'till' is not expected here"},
           {"at 1f morph ball", "3:17: 'into' is missing here"},
           {"at 1f morph ball into lamp", "3:23: 'lamp' is a light, which has no shape"},
           {"at 1f morph ball into ball", "3:23: an object cannot become itself"}}) {
    const auto got = errors(load_text(head + line + "\n", "wrong.bx"));
    ASSERT_EQ(got.size(), 1u) << line;
    EXPECT_EQ(got[0], told) << line;
  }
}

}  // namespace
}  // namespace betwixt
