// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests the completion of words.
#include "editor/completion.h"

#include <algorithm>

#include "betwixt/session.h"
#include "editor/author.h"
#include "editor/help.h"
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
  EXPECT_TRUE(s.enter("section proof for 1s").done);
  EXPECT_EQ(one("section end after pro"), "proof");
  EXPECT_EQ(one("set nobody.rad"), "0 of them");
  for (const char* numbers : {"eval ball.position at ", "undo ", "at ", "range ", "play "})
    EXPECT_EQ(one(numbers), "0 of them") << numbers;
}

TEST(Session, CompletesParametersAndKindsOfTheFilm) {
  const Folder folder;
  Session s = opened(folder, small_film);
  expect_done(s, "procedure hop command (who object, height number = 2, tint color = none) lua \"1\"");
  expect_done(s, "define kind toy like ball");
  EXPECT_EQ(s.complete("hop he"), std::vector<std::string>{"height="});
  EXPECT_EQ(s.complete("hop who=ba"), std::vector<std::string>{"ball"});
  EXPECT_EQ(s.complete("hop who=ball tint=tom"), std::vector<std::string>{"tomato"});
  EXPECT_EQ(s.complete("create x to"), (std::vector<std::string>{"torus", "toy"}));
  EXPECT_EQ(s.complete("create x toy rad"), std::vector<std::string>{"radius="});
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

// shows: G22
TEST(Session, CompletesWhatCanFollow) {
  const Folder folder;
  Session::Callbacks callbacks;
  callbacks.styles = {"shaded", "wireframe"};
  Session s = opened(folder, small_film, std::move(callbacks));
  expect_done(s, "layer sway add");
  using Words = std::vector<std::string>;
  for (const auto& [line, words] : std::vector<std::pair<std::string, Words>>{
           {"policy ", {"ask", "ignore", "translate"}},
           {"notes o", {"off", "on"}},
           {"clear ball.position ", {"before"}},
           {"extend ball.position ", {"bounce", "cycle", "hold", "linear"}},
           {"extend ball.position cycle ", {"after", "before"}},
           {"layer up ", {"add", "mix"}},
           {"look ", {"through"}},
           {"look through ", {"eye", "for", "wipe=down", "wipe=iris", "wipe=left", "wipe=right", "wipe=up"}},
           {"attach ball t", {"to"}},
           {"on ", {"sway"}},
           {"on sway ext", {"extend"}},
           {"on sway crea", {}},
           {"at 5f fal", {"fall"}},
           {"at 5f crea", {}},
           {"set ball.color gol", {"gold", "goldenrod"}},
           {"set ball.color rg", {"rgb"}},
           {"at 3f ball.color nav", {"navajowhite", "navy"}},
           {"at 3f set ball.display o", {"off", "on"}},
           {"background tea", {"teal"}},
           {"background tr", {"transparent"}},
           {"create x sphere color=teal rad", {"radius="}},
           {"create x sphere color=tea", {"teal"}},
           {"create x sphere material=pl", {"plaster", "plastic"}},
           {"create x sphere material=gl", {"glass", "gloss", "glow"}},
           {"create x light shadow=", {"auto", "off", "on", "soft"}},
           {"create x sphere shadow=", {"off", "on"}},
           {"set ball.position.v", {"ball.position.velocity"}},
           {"set ball.position.", {"ball.position.velocity", "ball.position.x", "ball.position.y", "ball.position.z"}},
           {"eval ball.wor", {"ball.world"}},
           {"set ball.wor", {}},
           {"at 5f ball.radius 2 ease", {"ease", "ease-in", "ease-in-out", "ease-in=", "ease-out", "ease-out="}},
           {"at 5f ball.color red sl", {}},
           {"at 5f ball.position (1 2 3) ben", {}},
           {"at 5f ball.position (1 2 3) sm", {"smooth"}},
           {"at 5f ball.position.velocity re", {"release"}},
           {"at 5f ball.attachment co", {"couple"}},
           {"filter ball.position smooth w", {"width="}},
           {"style ", {"shaded", "wireframe"}},
           {"samples ", {"1", "16", "4", "9", "auto"}},
           {"define heat num", {"number"}},
           {"hide {ball,ey", {"eye"}},
           {"create x sphere color=rgb(1 0 0) rad", {"radius="}},
           {"alias all ", {"="}},
           {"let ey", {}},
       })
    EXPECT_EQ(s.complete(line), words) << line;
  expect_done(s, "ball.color");
  EXPECT_EQ(s.complete("  3f cornf"), (Words{"cornflowerblue"}));
  EXPECT_EQ(s.complete("3f red lin"), (Words{"linear"}));
}

// A word in capitals stands for others in the rows of the verbs; a row with an unknown one would offer it.
TEST(Completion, NoWordInCapitalsIsOffered) {
  const auto in_capitals = [](const std::string& w) {
    return w.size() > 1 && std::ranges::all_of(w, [](char c) { return c >= 'A' && c <= 'Z'; });
  };
  for (const HelpEntry& e : help_entries())
    for (std::string line = std::string(e.word) + " "; line.size() < e.word.size() + 12; line += "x ")
      for (const std::string& w : completions(line, Document(), {.in_shell = true, .folder = "/none"}))
        ASSERT_FALSE(in_capitals(w)) << line << w;
}

TEST(Completion, ADotFollowsWhereATargetStands) {
  for (const char* line : {"ball", "set ball", "move ball", "plot ball", "at 2f ball", "at 2f set ball"})
    EXPECT_TRUE(takes_target(line)) << line;
  for (const char* line : {"hide ball", "at 2f hide ball", "eval ball", "attach ball to hand", "create x like ball"})
    EXPECT_FALSE(takes_target(line)) << line;
}

}  // namespace
}  // namespace betwixt
