// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Words that are begun are completed where they stand.
#include "betwixt/session.h"
#include "editor/author.h"
#include "support/small_film.h"

namespace betwixt {
namespace {

TEST(Session, CompletesWhatIsBegun) {
  const Folder folder;
  Session s = opened(folder, small_film);
  const auto one = [&](const char* line) {
    const auto all = s.complete(line);
    return all.size() == 1 ? all[0] : fmt::format("{} of them", all.size());
  };
  EXPECT_EQ(one("desc"), "describe");
  EXPECT_EQ(one("set ba"), "ball");
  EXPECT_EQ(one("set ball.rad"), "ball.radius");
  EXPECT_EQ(one("create x sph"), "sphere");
  EXPECT_EQ(one("at 5f ball.radius 1 bez"), "bezier");
  EXPECT_EQ(one("twerper ball.radius hol"), "hold");
  EXPECT_EQ(one("set nobody.rad"), "0 of them");
}

// shows: G22
TEST(Session, CompletesFiltersAndTwerpersWhereTheyStand) {
  const Folder folder;
  Session s = opened(folder, small_film);
  expect_done(s, "procedure wobbly filter lua \"input()\"");
  expect_done(s, "procedure springy twerper lua \"u\"");
  using Words = std::vector<std::string>;
  EXPECT_EQ(s.complete("filter ball.position wob"), (Words{"wobble", "wobbly"}));
  EXPECT_EQ(s.complete("filter ball.position sp"), (Words{"spring"}));
  expect_done(s, "ball.radius");
  for (const char* row : {"  1f 2 ", "1f 2 "}) {  // a person need not indent
    EXPECT_EQ(s.complete(std::string(row) + "spr"), (Words{"springy"})) << row;
    EXPECT_EQ(s.complete(std::string(row) + "bez"), (Words{"bezier"})) << row;
  }
}

}  // namespace
}  // namespace betwixt
