// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// A film is there when it is whole, and not before.
#include "film/sink.h"

#include "film/films.h"

namespace betwixt {
namespace {

TEST_F(Film, StoppingLeavesNothing) {
  for (const std::string name : {"film.mp4", "film.gif", "frame-%04d.png"}) {
    FilmOptions o = options(name, 100000);
    const auto made = make_film(o, gray_steps(), [](int done, int, double) { return done < 3; });
    ASSERT_FALSE(made) << name;
    EXPECT_EQ(files(), std::vector<std::string>{}) << name;
  }
}

TEST_F(Film, AnOldFilmStaysWhenTheNewOneFails) {
  FilmOptions o = options("film.mp4");
  std::ofstream(o.path) << "old";
  const auto broken = painting([](int k, Picture& out) -> Status {
    if (k == 4) return fail(ErrorCode::name, "no such color", "did you mean gold?");
    out = plain(64, 48, {0, 0, 0});
    return Nothing{};
  });
  const auto made = make_film(o, broken);
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().code, ErrorCode::name);
  EXPECT_EQ(made.error().message, "no such color");
  EXPECT_EQ(made.error().hint, "did you mean gold?");
  std::string word;
  std::ifstream(o.path) >> word;
  EXPECT_EQ(word, "old");
  EXPECT_EQ(files(), std::vector<std::string>{"film.mp4"});
}

}  // namespace
}  // namespace betwixt
