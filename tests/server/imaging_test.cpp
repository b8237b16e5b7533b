// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The imaging server without sockets, at times that the tests say. (C16, C97, C133; R-E1c)
#include "server/imaging.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <random>

#include "support/folder.h"

namespace betwixt {
namespace {

constexpr Nanos second = 1'000'000'000;
// The first moment of a tick.
Nanos tick(std::int64_t n) { return (n * second + 29) / 30; }

bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

class Stage {
 public:
  explicit Stage(Imaging::Options options = {}, const std::string& file = "", const std::string& save = "")
      : imaging(std::move(options)) {
    const auto begun = imaging.begin(file, save, false, 0);
    EXPECT_TRUE(begun) << (begun ? "" : begun.error().message);
  }
  std::string say(Imaging::Host host, const std::string& line, Nanos now = 0) {
    return imaging.enter(host, line, now).line;
  }
  void done(Imaging::Host host, const std::string& line, Nanos now = 0) {
    const std::string answer = say(host, line, now);
    EXPECT_TRUE(holds(answer, "\"ok\":true")) << line << "\n" << answer;
  }
  void refused(Imaging::Host host, const std::string& line, const std::string& why, Nanos now = 0) {
    const std::string answer = say(host, line, now);
    EXPECT_TRUE(holds(answer, "\"ok\":false") && holds(answer, why)) << line << "\n" << answer;
  }
  // Whoever loads the history has this document. (R-E1c)
  void expect_history() const {
    const Loaded again = load_text(imaging.history(), "");
    EXPECT_FALSE(has_errors(again.diagnostics)) << to_string(again.diagnostics[0]) << imaging.history();
    EXPECT_TRUE(again.document == imaging.document()) << imaging.history();
  }
  Imaging imaging;
};

// shows: C101 C99
TEST(Imaging, AnswersEveryLineOnce) {
  Stage s;
  const auto host = s.imaging.arrive();
  EXPECT_EQ(s.say(host, "create ball sphere"), "{\"line\":1,\"ok\":true,\"tick\":0}\n");
  EXPECT_EQ(s.say(host, "", tick(7)), "{\"line\":2,\"ok\":true,\"tick\":7}\n");
  EXPECT_EQ(s.say(host, "# a remark\r\n", tick(7)), "{\"line\":3,\"ok\":true,\"tick\":7}\n");
  EXPECT_EQ(s.say(host, "  set ball.radius two", tick(8)),
            "{\"line\":4,\"ok\":false,\"tick\":8,\"error\":\"'two' is not a number\",\"hint\":\"usage: set TARGET "
            "VALUE, as in set "
            "ball.color red\",\"column\":19}\n");
  EXPECT_EQ(s.say(host, "set ball.position (1", tick(8)), "{\"line\":5,\"ok\":true,\"tick\":8,\"more\":true}\n");
  EXPECT_EQ(s.say(host, "2 3)", tick(9)), "{\"line\":6,\"ok\":true,\"tick\":9}\n");
  EXPECT_EQ(s.say(host, "eval ball.position at 2s", tick(9)),
            "{\"line\":7,\"ok\":true,\"tick\":9,\"seconds\":2,\"values\":{\"ball.position\":[1,2,3]}}\n");
  s.refused(host, "creat ball box", "did you mean 'create'?");
  s.refused(host, "evla ball", "did you mean 'eval'?");
  s.expect_history();
}

TEST(Imaging, SaysNoInWords) {
  Stage s;
  const auto host = s.imaging.arrive();
  for (const auto& [line, why] : std::vector<std::pair<std::string, std::string>>{
           {"open other.bx", "a server has one document"},
           {"load ./swirl.so", "plug-ins are programs"},
           {"plot ball.position", "they write no files here"},
           {"play", "a server always plays"},
           {"save elsewhere.bx", "a host cannot choose the file"},
           {"save", "this server keeps no history"},
           {"end", "no bundle is open"},
           {"eval", "what shall be evaluated?"},
           {"eval ball at", "a time is missing behind 'at'\",\"hint\":\"as in eval ball at 24f\""},
           {"point (0 0)", "'point' is a row of a display list, not a command\",\"hint\":\"rows are indented"},
           {"help plot", "they write no files here"},
           {"help play", "a server always plays"},
           {"eval ball", "there is no object 'ball'"},
           {"subscribe", "to what?"},
           {"subscribe gossip", "there are no events called 'gossip'"},
           {"seek", "to which time?"},
           {"seek soon", "soon"},
           {"undo", "there is nothing to undo"},
           {"redo", "there is nothing to redo"},
           {"help nothing", "there is no help about 'nothing'"},
           {"time flies", "'flies' is one word too many"},
           {"quit now", "'now' is one word too many"},
           {"use /etc/passwd", "/etc/passwd"},
           {"  12f 3", "no sheet is open"},
           {std::string("create b\0ll sphere", 18), "this is not a text"},
           {"create b\xffll sphere", "this is not a text"},
           {"ev\xff", "this is not a text"},
           {std::string(Imaging::longest_line + 1, 'x'), "a line is at most 1048576 bytes long"},
       })
    s.refused(host, line, why);
  EXPECT_EQ(s.imaging.history(), "");
  EXPECT_TRUE(s.imaging.enter(host, "quit", 0).quit);
}

// shows: C16
TEST(Imaging, TwoHostsSheetsDoNotMix) {
  Stage s;
  const auto a = s.imaging.arrive(), b = s.imaging.arrive();
  s.done(a, "create {left,right} sphere");
  s.done(a, "left.position");
  s.done(b, "right.position");
  s.done(a, "  1f (1 0 0)");
  s.done(b, "  1f (0 1 0)");
  s.done(a, "  11f (2 0 0)");
  s.done(a, "  21f (3 0 0)");
  s.done(b, "  11f (0 2 0)");
  s.done(b, "  21f (0");
  s.done(b, "3 0)");
  EXPECT_TRUE(holds(s.say(a, "eval left.position right.position at 11f"),
                    "\"left.position\":[2,0,0],\"right.position\":[0,2,0]"));
  EXPECT_EQ(
      s.imaging.history(),
      "create {left,right} sphere\nleft.position\n  1f (1 0 0)\nright.position\n  1f (0 1 0)\nleft.position\n  "
      "11f (2 0 0)\n  21f (3 0 0)\nright.position\n  11f (0 2 0)\n# bundle\nright.position\n  21f (0\n3 0)\n# end\n");
  s.expect_history();
}

// shows: C125 R-E14
TEST(Imaging, BundlesAreAtomic) {
  Stage s;
  const auto a = s.imaging.arrive(), b = s.imaging.arrive();
  for (const char* line :
       {"bundle", "create ball sphere", "ball.radius", "  1f 2", "animate spin every 2t by rotate(9deg, y)"})
    EXPECT_EQ(s.say(a, line, tick(3)), "");
  s.refused(b, "eval ball.radius", "there is no object 'ball'", tick(3));
  EXPECT_EQ(s.say(a, "end", tick(5)), "{\"line\":6,\"ok\":true,\"tick\":6}\n");
  EXPECT_EQ(
      s.imaging.history(),
      "# bundle\ncreate ball sphere\nball.radius\n  1f 2\nat 6t animate spin every 2t by rotate(9deg, y)\n# end\n");
  s.expect_history();

  const Document before = s.imaging.document();
  for (const char* line :
       {"bundle", "set ball.radius 3", "set ball.radius many", "create ball box", "eval ball.radius"})
    EXPECT_EQ(s.say(a, line), "");
  const std::string no = s.say(a, "end");
  EXPECT_TRUE(holds(no, "\"ok\":false") && holds(no, "\"errors\":[{\"line\":9,") && holds(no, "{\"line\":10,")) << no;
  EXPECT_TRUE(s.imaging.document() == before);
  EXPECT_EQ(s.say(a, "bundle"), "");
  EXPECT_EQ(s.say(a, "bundle"), "");
  s.refused(a, "end", "a bundle is open already");
  EXPECT_EQ(s.say(a, "bundle"), "");
  EXPECT_EQ(s.say(a, std::string(Imaging::longest_line + 1, 'x')), "");
  s.refused(a, "end", "bytes long");

  EXPECT_EQ(s.say(a, "bundle"), "");
  EXPECT_EQ(s.say(a, "remove ball"), "");
  s.imaging.leave(a);  // dies in the middle
  EXPECT_TRUE(s.imaging.document() == before);
  s.done(b, "undo");
  s.refused(b, "eval ball.radius", "there is no object");
  s.done(b, "redo");
  EXPECT_TRUE(s.imaging.document() == before);
}

// A display list is made row by row, by two hosts at once, and shown; the clock begins with it. (C66, C80)
TEST(Imaging, DisplayListsAreMadeRowByRow) {
  Stage s;
  const auto a = s.imaging.arrive(), b = s.imaging.arrive();
  s.done(a, "make star");
  s.done(b, "make scene");
  s.done(a, "  color red");
  s.done(b, "  begin spin");
  s.done(a, "  tag corner");
  s.done(a, "  polygon (0 2 0) (-0.5 0 0) (0.5 0 0)");
  s.done(b, "  call star");
  s.done(b, "  end");
  s.done(b, "edit star");
  s.done(b, "  replace corner");
  s.done(b, "  polygon (0 3 0) (-0.5 0 0) (0.5 0 0)");
  s.done(b, "  color blue");
  s.done(b, "start scene", tick(50));
  EXPECT_TRUE(holds(s.say(b, "time", tick(53)), "\"tick\":3,"));
  for (const char* line : {"bundle", "make other", "  begin spin", "  end", "animate spin every 1t by rotate(1deg, y)"})
    EXPECT_EQ(s.say(a, line, tick(53)), "");
  s.done(a, "end", tick(53));
  s.expect_history();
  s.done(a, "undo");
  s.done(a, "undo");
  s.expect_history();
}

// A live command takes effect so many ticks after it came; one with a time, at its time. (R-E1a, R-E1c)
// shows: C2 C100 R-E1c
TEST(Imaging, CommandsAboutEnvironmentsAreStamped) {
  Imaging::Options options;
  options.latency = 3;
  Stage s(options);
  const auto host = s.imaging.arrive();
  s.done(host, "create ball sphere");
  s.done(host, "set ball.environments (slide)");
  EXPECT_EQ(s.say(host, "animate slide every 2t by translate(1 0 0)", tick(10) + 5),
            "{\"line\":3,\"ok\":true,\"tick\":13}\n");
  s.done(host, "halt slide", tick(20));
  s.done(host, "at 40t animate slide every 1t by translate(0 1 0)", tick(20));
  EXPECT_EQ(
      s.imaging.history(),
      "create ball sphere\nat 3t ball.environments (slide)\nat 13t animate slide every 2t by translate(1 0 0)\nat "
      "23t halt slide\nat 40t animate slide every 1t by translate(0 1 0)\n");
  // A is M from tick 13 on, and once more at 15, 17, 19, 21, 23: six steps; then M' at 41, 42.
  const auto x = [&](const char* at) { return s.say(host, std::string("eval ball.world at ") + at); };
  EXPECT_TRUE(holds(x("12t"), "[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1]")) << x("12t");
  EXPECT_TRUE(holds(x("13t"), ",1,")) << x("13t");
  EXPECT_TRUE(holds(x("39t"), "6")) << x("39t");
  s.expect_history();
}

// shows: C97 C109 C113 C123 C133
TEST(Imaging, TimeIsTheHosts) {
  Imaging::Options options;
  options.wait = true;
  Stage s(options);
  const auto host = s.imaging.arrive();
  const auto now = [&](Nanos t) { return s.say(host, "time", t); };
  EXPECT_TRUE(holds(now(5 * second), "\"tick\":0,\"seconds\":0,\"slot\":0,\"running\":false,\"host\":1"));
  s.done(host, "start", 5 * second);
  EXPECT_TRUE(holds(now(5 * second + tick(67)), "\"tick\":67,")) << now(5 * second + tick(67));
  EXPECT_TRUE(holds(now(5 * second + tick(67)), "\"slot\":7,\"running\":true"));
  s.done(host, "pause", 8 * second);
  EXPECT_TRUE(holds(now(100 * second), "\"seconds\":3,"));
  s.done(host, "go", 100 * second);
  EXPECT_TRUE(holds(now(101 * second), "\"seconds\":4,"));
  s.done(host, "seek 90t", 101 * second);
  EXPECT_TRUE(holds(now(102 * second), "\"tick\":120,"));
  s.done(host, "seek -1t", 102 * second);
  EXPECT_TRUE(holds(now(102 * second), "\"tick\":-1,\"seconds\":-0.0333")) << now(102 * second);
  EXPECT_TRUE(holds(now(102 * second), "\"slot\":29"));
}

// shows: C124 C130 R-E1
TEST(Imaging, MomentsAndTimesFit) {
  EXPECT_TRUE(rc::check("the first moment of a time has that time, the one before has not", [] {
    Transport t;
    t.running = true;
    t.since = *rc::gen::inRange<std::int64_t>(0, std::int64_t{1} << 60);
    t.at = Time{*rc::gen::inRange<std::int64_t>(-(std::int64_t{1} << 60), std::int64_t{1} << 60)};
    const Time asked = t.at + Time{*rc::gen::inRange<std::int64_t>(1, std::int64_t{1} << 60)};
    const Nanos m = t.when(asked);
    RC_ASSERT(t.time(m) >= asked);
    RC_ASSERT(t.time(m - 1) < asked);
  }));
}

TEST(Imaging, TellsThoseWhoAsked) {
  Stage s;
  const auto a = s.imaging.arrive(), b = s.imaging.arrive();
  s.done(a, "subscribe changes notes");
  EXPECT_TRUE(s.imaging.frames_wanted());
  s.done(b, "create ball sphere");
  s.done(b, "at 1s note \"there\"");
  auto told = s.imaging.events();
  ASSERT_EQ(told.size(), 2u);
  EXPECT_EQ(told[0].to, a);
  EXPECT_EQ(told[0].line, "{\"event\":\"change\",\"tick\":0,\"host\":2,\"commands\":\"create ball sphere\"}\n");
  s.imaging.shown({1, Time{}, 0, {}});
  EXPECT_TRUE(s.imaging.events().empty());
  s.imaging.shown({30, from_seconds(1.2), 0, {}});
  told = s.imaging.events();
  ASSERT_EQ(told.size(), 1u);
  EXPECT_EQ(told[0].line, "{\"event\":\"note\",\"seconds\":1,\"note\":\"there\"}\n");
  s.imaging.shown({31, from_seconds(1.3), 0, {}});
  EXPECT_TRUE(s.imaging.events().empty());
  s.done(a, "unsubscribe");
  s.done(b, "subscribe frames");
  s.imaging.shown({31, from_seconds(1.25), 1500, {}});
  told = s.imaging.events();
  ASSERT_EQ(told.size(), 1u);
  EXPECT_EQ(told[0].line, "{\"event\":\"frame\",\"frame\":31,\"seconds\":1.25,\"late\":1.5}\n");
}

// What touches is told to whoever asked, as the time goes by. (C148, C150)
// shows: C149 C150 C151
TEST(Imaging, TellsOfContacts) {
  Stage s;
  const auto a = s.imaging.arrive(), b = s.imaging.arrive();
  for (const char* line :
       {"create ball sphere", "create wall box position=(5 0 0)", "create eye camera position=(0 0 20)",
        "ball.position", "  0t (0 0 0)", "  30t (5 0 0) linear", "set ball.color red"})
    s.done(b, line);
  s.done(a, "subscribe contacts");
  std::string told;
  for (int t = 0; t <= 30; ++t) {
    s.imaging.shown({t + 1, from_seconds(t / 30.0), 0, {}});
    for (const auto& e : s.imaging.events()) {
      told += e.line;
      EXPECT_EQ(e.to, a);
    }
  }
  EXPECT_TRUE(holds(told, "{\"event\":\"view\",\"object\":\"ball\",\"state\":\"in\",\"tick\":0}\n")) << told;
  EXPECT_TRUE(holds(told, "{\"event\":\"contact\",\"state\":\"begin\",\"a\":\"ball\",\"b\":\"wall\",")) << told;
  s.done(b, "subscribe contacts");  // is told what holds already
  s.imaging.shown({31, from_seconds(1.0), 0, {}});
  EXPECT_EQ(s.imaging.events().size(), 2u);
}

// More environments than allowed are refused; those that are there stay as they are. (C120, R-E8)
// shows: C120 R-E8
TEST(Imaging, HasACeiling) {
  Imaging::Options options;
  options.ceilings.environments = 3;
  Stage s(options);
  const auto host = s.imaging.arrive();
  s.done(host, "animate e{1..3} every 1t by rotate(1deg, y)");
  const Document before = s.imaging.document();
  s.refused(host, "animate e4 every 1t by rotate(1deg, y)", "there would be more than 3 environments");
  EXPECT_TRUE(s.imaging.document() == before);
  s.done(host, "animate e3 every 2t by rotate(1deg, y)");
  s.done(host, "kill e1");
  s.done(host, "animate e4 every 1t by rotate(1deg, y)");
}

TEST(Imaging, HasACeilingOfObjects) {
  Imaging::Options options;
  options.ceilings.objects = 3;
  Stage s(options);
  const auto host = s.imaging.arrive();
  s.done(host, "create a{1..3} sphere");
  const Document before = s.imaging.document();
  s.refused(host, "create b sphere", "there would be more than 3 objects, removed ones included");
  s.refused(host, "animate e every 1t by rotate(1deg, y)", "more than 3 objects");
  s.say(host, "bundle");
  s.say(host, "set a1.radius 2");
  s.say(host, "create b sphere");
  s.refused(host, "end", "line 6: there would be more than 3 objects");
  EXPECT_TRUE(s.imaging.document() == before);
  s.done(host, "set a{1..3}.radius 2");  // what is there may change
  s.done(host, "remove a1");
  s.refused(host, "create b sphere", "more than 3 objects");
  for (int i = 0; i < 3; ++i) s.done(host, "undo");
  s.done(host, "create b sphere");
  s.expect_history();
}

// A row under a pattern is an event for each; so are those of components, velocities and environments.
TEST(Imaging, HasACeilingOfEvents) {
  Imaging::Options options;
  options.ceilings.events = 6;
  Stage s(options);
  const auto host = s.imaging.arrive();
  s.done(host, "create a{1..2} sphere");
  s.done(host, "at 1f a{1..2}.radius 2");
  s.done(host, "at 1f a1.position.x 2");
  s.done(host, "at 1f a1.rotation.velocity (0deg 90deg 0deg)");
  s.done(host, "animate e every 1t by rotate(1deg, y)");
  EXPECT_TRUE(holds(s.say(host, "stats"), "\"objects\":3,\"events\":5,"));
  s.refused(host, "at 2f a{1..2}.radius 3", "there would be more than 6 events");
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
  Imaging::Options options;
  options.ceilings.history = 60;  // bytes
  Stage s(options, "", folder / "live.bx");
  const auto host = s.imaging.arrive(), other = s.imaging.arrive();
  s.done(host, "create a sphere");  // 16, and for every step its sheet's line: 1
  s.done(host, "set a.radius 2");   // 15 + 1
  s.done(host, "set a.radius 3");   // 49 so far
  EXPECT_TRUE(holds(s.say(host, "stats"), "\"history\":49"));
  const Document before = s.imaging.document();
  s.refused(host, "set a.radius 4", "the history would be longer than 60 bytes");
  EXPECT_TRUE(s.imaging.document() == before);
  s.done(host, "eval a.radius");
  s.done(other, "# nothing");
  s.done(other, "undo");
  s.done(other, "set a.radius 4");
  s.expect_history();
  EXPECT_EQ(folder.get("live.bx"), "create a sphere\nset a.radius 2\nset a.radius 4\n");
}

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
    s.done(host, "ball.radius");
    s.done(host, "  1f 2");
    s.done(host, "  9f 3");
    s.done(host, "create box box");
    s.done(host, "undo");
    s.done(host, "save");
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
TEST(Imaging, HelpIsForHosts) {
  Stage s;
  const auto host = s.imaging.arrive();
  const std::string all = s.say(host, "help");
  for (const char* word : {"Words of the shell", "\\n  plot ", "\\n  open ", "\\n  play "})
    EXPECT_FALSE(holds(all, word)) << word;
  for (const char* word : {"bundle ", "subscribe ", "animate ", "Rows of display lists"}) EXPECT_TRUE(holds(all, word));
  EXPECT_TRUE(holds(s.say(host, "help bundle"), "done together, all at one moment or none; end has the answer"));
  const std::string events = s.say(host, "help subscribe");
  for (const char* topic : {"changes", "contacts", "frames", "notes"})
    EXPECT_TRUE(holds(events, fmt::format("\\n  {} ", topic))) << events;
  EXPECT_TRUE(holds(s.say(host, "help quit"), "Ends the connection"));
}

// shows: R-E12 R-E16
TEST(Imaging, AHostMayEditAListFromATimeOn) {
  Stage s;
  const auto a = s.imaging.arrive(), b = s.imaging.arrive();
  for (const char* line : {"make l", "  tag x", "  point (1 0)", "start l"}) s.done(a, line, tick(1));
  s.done(a, "at 300t edit l", tick(10));
  s.done(b, "at 200t make m", tick(10));
  s.done(a, "  replace x", tick(11));
  s.done(b, "  point (3 0)", tick(11));
  s.done(a, "  vector (0 0) (2 0)", tick(12));
  s.done(a, "edit l", tick(13));
  s.done(a, "  call m", tick(13));
  const auto shown = [&](const char* name, int t) {
    const std::string answer = s.say(a, fmt::format("eval {}.display at {}t", name, t), tick(20));
    return holds(answer, fmt::format("\"{}.display\":true", name));
  };
  for (const auto& [t, point, vector, called] :
       {std::tuple(199, true, false, false), std::tuple(200, true, false, true), std::tuple(299, true, false, true),
        std::tuple(300, false, true, true)}) {
    EXPECT_EQ(shown("l/point-1", t), point) << t;
    EXPECT_EQ(shown("l/vector-1", t), vector) << t;
    EXPECT_EQ(shown("l/m-1/point-1", t), called) << t;
  }
  s.expect_history();
  EXPECT_TRUE(holds(s.imaging.history(), "at 10s edit l\n  replace x 0\n  vector (0 0) (2 0)\n"))
      << s.imaging.history();
  s.done(b, "undo", tick(30));
  s.done(b, "undo", tick(30));
  EXPECT_FALSE(shown("l/vector-1", 300));
  s.expect_history();
}

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
