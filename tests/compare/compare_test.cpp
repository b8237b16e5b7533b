// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests the words about two films.
#include "betwixt/compare.h"

#include <gtest/gtest.h>

#include "support/loaded_film.h"

namespace betwixt {
namespace {

std::vector<std::string> words(std::string_view old, std::string_view now) {
  std::vector<std::string> all;
  for (const FilmChange& c : compare(read(old).document, read(now).document)) all.push_back(c.words);
  return all;
}
using Words = std::vector<std::string>;

constexpr const char* film =
    "rate 24\nrange 1f 72f\ncreate ball sphere color=red\ncreate lamp light\n"
    "ball.position\n  1f (0 10 0)\n  12f (4 1 0) linear\n  24f (8 10 0)\n";
std::string with(std::string_view old, std::string_view now) {
  std::string text = film;
  text.replace(text.find(old), old.size(), now);
  return text;
}

TEST(Compare, SaysNothingAboutLayoutAndComments) {
  EXPECT_EQ(words(film, film), Words());
  EXPECT_EQ(words(film, with("rate 24\n", "# a film\nrate   24 # fps\n\n")), Words());
  EXPECT_EQ(words(film, with("  12f (4 1 0) linear\n  24f (8 10 0)\n", "  24f (8, 10, 0)\n  12f (4 1 0) linear\n")),
            Words());
}

TEST(Compare, SaysWhatHasChanged) {
  EXPECT_EQ(words(film, with("color=red", "color=gold")), Words{"ball: color changed from red to gold"});
  EXPECT_EQ(words(film, with(" color=red", "")), Words{"ball: color no longer set (it was red)"});
  EXPECT_EQ(words(film, with("color=red", "color=red radius=2")), Words{"ball: radius set to 2"});
  EXPECT_EQ(words(film, with("create lamp light\n", "")), Words{"lamp removed (light)"});
  EXPECT_EQ(words(film, with("create lamp", "create eye camera\ncreate lamp")), Words{"eye added (camera)"});
  EXPECT_EQ(words(film, with("create lamp", "create sun")), Words{"lamp renamed to sun"});
  EXPECT_EQ(words(film, with("ball sphere", "ball box")), Words{"ball: kind changed from sphere to box"});
  EXPECT_EQ(words(film, with("range 1f 72f", "range 1f 80f")), Words{"film: range changed from 1f 72f to 1f 80f"});
  EXPECT_EQ(words(film, with("  24f (8 10 0)", "  24f (8 9 0)")),
            Words{"ball.position: event at 24f changed from (8 10 0) to (8 9 0)"});
  EXPECT_EQ(words(film, with("  24f (8 10 0)", "  30f (8 10 0)")), Words{"ball.position: event moved from 24f to 30f"});
  EXPECT_EQ(words(film, with("  24f (8 10 0)\n", "")), Words{"ball.position: event removed at 24f: (8 10 0)"});
  EXPECT_EQ(words(film, with("  24f (8 10 0)\n", "  24f (8 10 0)\n  30f (1 2 3) hold\n")),
            Words{"ball.position: event added at 30f: (1 2 3) hold"});
  EXPECT_EQ(words(film, with("  1f (0 10 0)\n  12f (4 1 0) linear\n  24f (8 10 0)\n",
                             "  6f (0 10 0)\n  17f (4 1 0) linear\n  29f (8 10 0)\n")),
            Words{"ball.position: 3 events moved by 5f (from 1f, 12f, 24f)"});
}

TEST(Compare, FramesStayAtAnotherRate) {
  EXPECT_EQ(words(with("rate 24\nrange 1f 72f\n", "rate 25\n"), with("rate 24\nrange 1f 72f\n", "rate 30\n")),
            Words{"film: rate changed from 25 to 30"});
}

}  // namespace
}  // namespace betwixt
