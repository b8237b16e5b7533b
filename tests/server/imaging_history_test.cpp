// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What hosts said is a script, which makes the same document. (R-E1c)
#include <rapidcheck.h>

#include <random>

#include "server/stage.h"

namespace betwixt {
namespace {

TEST(Imaging, UndoHasADepth) {
  Imaging::Options options;
  options.undo = 2;
  Stage s(options);
  const auto host = s.imaging.arrive();
  for (const char* line : {"create a sphere", "create b sphere", "create c sphere"}) s.done(host, line);
  s.done(host, "undo");
  s.done(host, "undo");
  s.refused(host, "undo", "no more than 2 commands can be undone");
  EXPECT_EQ(s.imaging.history(), "create a sphere\n");
  s.expect_history();
  s.done(host, "redo");
  s.done(host, "create d sphere");
  s.refused(host, "redo", "nothing to redo");
  EXPECT_EQ(s.imaging.history(), "create a sphere\ncreate b sphere\ncreate d sphere\n");
}

// What was answered is in the file, and another server goes on with it.
TEST(Imaging, KeepsItsHistory) {
  const Folder folder;
  folder.put("show.bx", "create ball sphere");
  {
    Stage s({}, folder / "show.bx", folder / "live.bx");
    const auto host = s.imaging.arrive();
    for (const char* line : {"ball.radius", "  1f 2", "  9f 3", "create box box", "undo", "save"}) s.done(host, line);
    for (const char* line : {"bundle", "set ball.color red", "halt nobody*"}) s.say(host, line, tick(4));
    s.done(host, "end", tick(4));
    EXPECT_TRUE(s.imaging.sync());
    EXPECT_EQ(folder.get("live.bx"),
              "create ball sphere\nball.radius\n  1f 2\n  9f 3\n# bundle\nset ball.color red\nat 5t halt nobody*\n# "
              "end\n");
    EXPECT_EQ(folder.get("live.bx"), s.imaging.history());
    Imaging other({});
    const auto twice = other.begin("", folder / "live.bx", false, 0);
    ASSERT_FALSE(twice);
    EXPECT_TRUE(holds(twice.error().message, "another server keeps its history")) << twice.error().message;
  }
  const std::string whole = folder.get("live.bx");
  folder.put("live.bx", whole + "# bundle\nset ball.color blue\nset ball.pos");  // killed in the middle
  Imaging again({});
  const auto begun = again.begin("", folder / "live.bx", false, 0);
  ASSERT_TRUE(begun) << begun.error().message;
  EXPECT_TRUE(holds(begun->back().what.message, "was never finished and is left out: # bundle"));
  EXPECT_EQ(folder.get("live.bx"), whole);
  EXPECT_TRUE(again.document() == load_text(whole, "").document);
}

TEST(Imaging, LeavesFilesAlone) {
  const Folder folder;
  folder.put("show.bx", "create ball sphere\n");
  folder.put("other.bx", "create box box\n");
  const auto why = [&](const std::string& file, const std::string& save) {
    Imaging i({});
    const auto begun = i.begin(file, save, false, 0);
    return begun ? "" : begun.error().message;
  };
  EXPECT_TRUE(holds(why(folder / "show.bx", folder / "other.bx"), "is there already"));
  EXPECT_TRUE(holds(why(folder / "none.bx", ""), "there is no file"));
  EXPECT_TRUE(holds(why(folder / "show.bx", "/tmp/betwixt-elsewhere.bx"), "is not beside"));
  EXPECT_EQ(folder.get("other.bx"), "create box box\n");
}

// Random hosts: whatever they say in whatever order, the history makes the document.
// shows: R-E12
TEST(Imaging, HistoriesMakeTheDocument) {
  EXPECT_TRUE(rc::check("the history loads as the document", [] {
    std::mt19937 random(static_cast<unsigned>(*rc::gen::inRange(0, 1'000'000)));
    const auto pick = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
    Imaging imaging({});
    RC_ASSERT(imaging.begin("", "", false, 0));
    const Imaging::Host hosts[] = {imaging.arrive(), imaging.arrive(), imaging.arrive()};
    Nanos now = 0;
    for (int k = 0; k < 60; ++k) {
      now += pick(100) * 1'000'000;
      const auto o = [&] { return fmt::format("o{}", pick(4)); };
      const auto e = [&] { return fmt::format("e{}", pick(3)); };
      const std::string lines[] = {
          fmt::format("create {} sphere", o()),
          fmt::format("set {}.radius {}", o(), 1 + pick(5)),
          fmt::format("{}.position", o()),
          fmt::format("  {}f ({} 0 0)", pick(50), pick(9)),
          fmt::format("  {}f ({} 1 0)", pick(50), pick(9)),
          fmt::format("animate {} every {}t by rotate({}deg, y)", e(), 1 + pick(4), pick(90)),
          fmt::format("halt {}", e()),
          fmt::format("kill {}", e()),
          fmt::format("set {}.environments ({} {})", o(), e(), e()),
          fmt::format("remove {}", o()),
          "undo",
          "redo",
          "bundle",
          "end",
          "# said",
          "seek 10t",
          fmt::format("at {}t animate {} every 1t by translate(1 0 0)", pick(200), e()),
          fmt::format("make l{}", pick(2)),
          fmt::format("at {}t make l{}", pick(200), pick(2)),
          fmt::format("edit l{}", pick(2)),
          fmt::format("at {}t edit l{}", pick(200), pick(2)),
          fmt::format("at {}t delete l{}", pick(200), pick(2)),
          fmt::format("delete l{}", pick(2)),
          fmt::format("start l{}", pick(2)),
          "  point (0 0)",
          fmt::format("  color {}", pick(2) ? "red" : "blue"),
          fmt::format("  tag t{}", pick(2)),
          fmt::format("  replace t{}", pick(2)),
          fmt::format("  call l{}", pick(2)),
      };
      imaging.enter(hosts[pick(3)], lines[pick(static_cast<int>(std::size(lines)))], now);
    }
    const Loaded again = load_text(imaging.history(), "");
    if (has_errors(again.diagnostics) || !(again.document == imaging.document()))
      RC_FAIL(imaging.history() + (again.diagnostics.empty() ? "" : to_string(again.diagnostics[0])));
  }));
}

}  // namespace
}  // namespace betwixt
