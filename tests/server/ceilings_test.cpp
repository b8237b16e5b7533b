// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests the limits on the size of a document and its history. (R-E8)
#include "betwixt/picture.h"
#include "server/stage.h"

namespace betwixt {
namespace {

Imaging::Options at_most(std::size_t Ceilings::*of_what, std::size_t most) {
  Imaging::Options options;
  options.ceilings.*of_what = most;
  return options;
}

// It is refused, and nothing is otherwise than before.
void changes_nothing(Stage& s, Imaging::Host host, const std::string& line, const std::string& why) {
  const Document before = s.imaging.document();
  s.refused(host, line, why);
  EXPECT_TRUE(s.imaging.document() == before) << line;
}

TEST(Imaging, HasACeilingOfObjects) {
  Stage s(at_most(&Ceilings::objects, 3));
  const auto host = s.imaging.arrive();
  s.done(host, "create a{1..3} sphere");
  changes_nothing(s, host, "create b sphere", "the film would have more than 3 objects, including removed ones");
  changes_nothing(s, host, "animate e every 1t by rotate(1deg, y)", "more than 3 objects");
  s.say(host, "bundle");
  s.say(host, "set a1.radius 2");
  s.say(host, "create b sphere");
  changes_nothing(s, host, "end", "line 6: the film would have more than 3 objects");
  s.done(host, "set a{1..3}.radius 2");  // what is there may change
  s.done(host, "remove a1");
  s.refused(host, "create b sphere", "more than 3 objects");
  for (int i = 0; i < 3; ++i) s.done(host, "undo");
  s.done(host, "create b sphere");
  s.expect_history();
}

// A row under a pattern is an event for each; so are those of components, velocities and environments.
TEST(Imaging, HasACeilingOfEvents) {
  Stage s(at_most(&Ceilings::events, 6));
  const auto host = s.imaging.arrive();
  for (const char* line : {"create a{1..2} sphere", "at 1f a{1..2}.radius 2", "at 1f a1.position.x 2",
                           "at 1f a1.rotation.velocity (0deg 90deg 0deg)", "animate e every 1t by rotate(1deg, y)"})
    s.done(host, line);
  EXPECT_TRUE(holds(s.say(host, "stats"), "\"objects\":3,\"events\":5,"));
  s.refused(host, "at 2f a{1..2}.radius 3", "the film would have more than 6 events");
  s.done(host, "at 1f a{1..2}.radius 3");  // in their place
  s.done(host, "at 2f a1.radius 3");
  s.refused(host, "halt e", "more than 6 events");
  s.done(host, "undo");
  s.done(host, "halt e");
  s.expect_history();
}

TEST(Imaging, WhatWasThereMayBeMoreThanTheCeilings) {
  const Folder folder;
  folder.put("show.bx", "create a{1..4} sphere\nat 1f a{1..4}.radius 2\n");
  Imaging::Options options;
  options.ceilings = {1, 2, 3, 40};
  Stage s(options, folder / "show.bx");
  const auto host = s.imaging.arrive();
  s.done(host, "at 1f a1.radius 3");
  s.refused(host, "at 2f a1.radius 3", "more than 3 events");
  s.refused(host, "create b sphere", "more than 2 objects");
}

TEST(Imaging, HasACeilingOfItsHistory) {
  const Folder folder;
  Stage s(at_most(&Ceilings::history, 60), "", folder / "live.bx");  // bytes
  const auto host = s.imaging.arrive(), other = s.imaging.arrive();
  s.done(host, "create a sphere");  // 16, and for every step its sheet's line: 1
  s.done(host, "set a.radius 2");   // 15 + 1
  s.done(host, "set a.radius 3");   // 49 so far
  EXPECT_TRUE(holds(s.say(host, "stats"), "\"history\":49"));
  changes_nothing(s, host, "set a.radius 4", "the history cannot be longer than 60 bytes");
  s.done(host, "eval a.radius");
  s.done(other, "# nothing");
  s.done(other, "undo");
  s.done(other, "set a.radius 4");
  s.expect_history();
  s.done(other, "save");
  EXPECT_EQ(folder.get("live.bx"), "create a sphere\nset a.radius 2\nset a.radius 4\n");
}

// Each object's own points count. Shared points count once. Points that are replaced do not count.
TEST(Imaging, HasACeilingOfBytes) {
  Stage s(at_most(&Ceilings::values, 10'000));
  const auto host = s.imaging.arrive();
  const auto points = [](std::size_t n, const char* x) {
    std::string all = "(";
    for (std::size_t i = 0; i < n; ++i) all += fmt::format("({} {})", x, i);
    return all + ")";
  };
  s.done(host, "create l{1..40} polygon");
  const char* const why = "lists of names, code and the contents of files would have more than 10000 bytes";
  changes_nothing(s, host, "set l*.points " + points(20, "i"), why);  // 40 times 480 bytes
  s.done(host, "set l*.points " + points(300, "1"));                  // 7,200
  changes_nothing(s, host, "set l1.points " + points(200, "2"), why);
  s.say(host, "bundle");
  for (int i = 1; i < 4; ++i) s.say(host, fmt::format("set l{}.points {}", i, points(50, "3")));
  changes_nothing(s, host, "end", why);
  s.done(host, "set l*.points " + points(300, "4"));  // in their place
  s.done(host, "set l*.points ((0 0) (1 1))");
  s.done(host, "set l{1..10}.points " + points(20, "i"));
  s.done(host, "undo");
  s.done(host, "undo");
  changes_nothing(s, host, "set l1.points " + points(200, "2"), why);
  s.done(host, "redo");
  s.done(host, "set l1.points " + points(200, "2"));
  s.expect_history();
}

TEST(Imaging, TextsAndCodeCountToo) {
  Stage s(at_most(&Ceilings::values, 10'000));
  const auto host = s.imaging.arrive();
  s.done(host, "create t{1..4} text");
  changes_nothing(s, host, "set t1.text \"" + std::string(10'001, 'x') + "\"", "more than 10000 bytes");
  changes_nothing(s, host, "set t1.position.x = \"1 + " + std::string(10'000, ' ') + "t\"", "more than 10000 bytes");
  s.done(host, "set t1.text \"" + std::string(6'000, 'x') + "\"");
  changes_nothing(s, host, "set t2.text \"" + std::string(6'000, 'y') + "\"", "more than 10000 bytes");
  s.done(host, "set t1.text \"short\"");
  s.done(host, "set t2.text \"" + std::string(6'000, 'y') + "\"");
}

// Pictures count as they are unpacked: here 400 bytes, with five letters of its name. What one shows already, another
// may show, too.
TEST(Imaging, ContentsOfFilesCount) {
  const Folder folder;
  folder.put("show.bx", "create a sphere\ncreate b sphere\n");
  for (const char* name : {"1.png", "2.png"})
    ASSERT_TRUE(write_png(folder / name, Picture{10, 10, std::vector<std::uint8_t>(400, 9)}));
  const std::string first = "set a.texture \"1.png\"";
  for (const auto& [most, column] : {std::pair<std::size_t, int>(399, 15), {404, 1}}) {
    Stage s(at_most(&Ceilings::values, most), folder / "show.bx");
    const auto host = s.imaging.arrive();
    changes_nothing(s, host, first, fmt::format("\"column\":{}", column));
    changes_nothing(s, host, first, fmt::format("would have more than {} bytes", most));
  }
  Stage s(at_most(&Ceilings::values, 410), folder / "show.bx");
  const auto host = s.imaging.arrive();
  s.done(host, first);
  changes_nothing(s, host, "set b.texture \"2.png\"", "\"column\":15");
  s.done(host, "set b.texture \"1.png\"");
  for (int i = 0; i < 2; ++i) s.done(host, "undo");
  s.done(host, "set b.texture \"2.png\"");
  folder.put("more.bx", "# more\nset a.texture \"1.png\"\n");
  changes_nothing(s, host, "use more.bx", "more.bx:2:15: ");
  s.say(host, "bundle");
  s.say(host, "set a.radius 2");
  s.say(host, first);
  changes_nothing(s, host, "end", "\"errors\":[{\"line\":10,");
}

// After undo and redo, the counts are right.
TEST(Imaging, CountsAreThoseOfTheDocumentThatIsGoneBackTo) {
  Stage s;
  const auto host = s.imaging.arrive();
  const auto events = [&] {
    const std::string answer = s.say(host, "stats");
    const auto at = answer.find("\"events\":") + 9;
    return answer.substr(at, answer.find(',', at) - at);
  };
  for (const char* line : {"create a{1..5} sphere", "at 1f a*.radius 2"}) s.done(host, line);
  s.done(host, "at 2f a1.radius 3");
  EXPECT_EQ(events(), "6");
  s.done(host, "undo");
  EXPECT_EQ(events(), "5");
  s.done(host, "undo");
  EXPECT_EQ(events(), "0");
  for (int i = 0; i < 2; ++i) s.done(host, "redo");
  EXPECT_EQ(events(), "6");
}

// More environments than allowed are refused; those that are there stay as they are. (C120, R-E8)
// shows: C120 R-E8
TEST(Imaging, HasACeiling) {
  Stage s(at_most(&Ceilings::environments, 3));
  const auto host = s.imaging.arrive();
  s.done(host, "animate e{1..3} every 1t by rotate(1deg, y)");
  changes_nothing(s, host, "animate e4 every 1t by rotate(1deg, y)", "the film would have more than 3 environments");
  s.done(host, "animate e3 every 2t by rotate(1deg, y)");
  s.done(host, "kill e1");
  s.done(host, "animate e4 every 1t by rotate(1deg, y)");
}

}  // namespace
}  // namespace betwixt
