// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests the imaging server without sockets, with a clock that the tests set. (C16, C97, C133; R-E1c)
#include "server/imaging.h"

#include <rapidcheck.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "server/stage.h"
#include "support/fake_programs.h"

namespace betwixt {
namespace {

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

// A long command is computed in the background while other hosts continue. If they change the document, it is computed
// again.
TEST(Imaging, LinesThatTakeLongLetOthersGoOn) {
  Stage s;
  const auto slow = s.imaging.arrive(), quick = s.imaging.arrive();
  s.done(slow, "create b{1..3} box");
  int meanwhile = 0, works = 0;
  bool wanted = true;
  s.imaging.work_beside([&](const std::function<void()>& work, Imaging::Claim) {
    ++works;
    if (meanwhile > 0) {
      work();  // of a document that will be another one
      s.done(quick, fmt::format("create ball{} sphere", meanwhile--));
      return wanted;
    }
    work();
    return wanted;
  });
  s.done(quick, "create quick sphere");
  EXPECT_EQ(works, 0) << "what is quick is done at once";
  meanwhile = 2;
  s.done(slow, "set b*.size (7 7 7)");
  EXPECT_EQ(works, 3);
  EXPECT_TRUE(holds(s.say(slow, "eval b2.size.x ball1.radius ball2.radius"),
                    "\"b2.size.x\":7,\"ball1.radius\":1,\"ball2.radius\":1"));
  // A host that disconnects cancels its open request.
  wanted = false;
  EXPECT_EQ(s.say(slow, "set b*.size (9 9 9)"), "");
  wanted = true;
  EXPECT_TRUE(holds(s.say(quick, "eval b3.size.x"), "\"b3.size.x\":7"));
  s.expect_history();
}

// After several interruptions a command is waited for, but only by commands that would interrupt it again.
TEST(Imaging, WhoIsAlwaysInterruptedIsWaitedFor) {
  Stage s;
  const auto slow = s.imaging.arrive(), quick = s.imaging.arrive(), bundles = s.imaging.arrive();
  s.done(slow, "create b{1..3} box");
  int works = 0;
  std::vector<std::string> later;
  s.imaging.work_beside([&](const std::function<void()>& work, Imaging::Claim) {
    work();
    if (++works < 4) {
      EXPECT_FALSE(s.imaging.waits());
      s.done(quick, fmt::format("create ball{} sphere", works));
    } else if (works == 4) {
      EXPECT_TRUE(s.imaging.waits());
      for (const char* line : {"create x sphere", "set ball1.radius 2", "undo", "redo", "ball1.position", "use x.bx",
                               "start l", "set b*.size (9 9 9)"}) {
        const auto reply = s.imaging.enter(quick, line, 0);
        EXPECT_TRUE(reply.later && reply.line.empty()) << line;
      }
      for (const char* line : {"time", "list", "describe ball1", "stats", "history", "notes", "help", "names", "pause",
                               "go", "subscribe changes", "# nothing", ""})
        EXPECT_FALSE(s.imaging.enter(quick, line, 0).later) << line;
      EXPECT_TRUE(holds(s.say(quick, "eval ball3.radius b1.size.x"), "\"ball3.radius\":1,\"b1.size.x\":1"));
      s.say(quick, "set ball1.position (1");  // goes on in the next line …
      EXPECT_TRUE(s.imaging.enter(quick, "2 3)", 0).later);
      EXPECT_EQ(s.say(bundles, "bundle"), "");
      EXPECT_EQ(s.say(bundles, "create z sphere"), "");
      EXPECT_TRUE(s.imaging.enter(bundles, "end", 0).later);
    }
    return true;
  });
  s.done(slow, "set b*.size (8 8 8)");
  EXPECT_GE(works, 4);
  EXPECT_FALSE(s.imaging.waits());
  // Waiting lines are carried out then, and keep their line numbers.
  const std::string rest = s.say(quick, "2 3)");
  EXPECT_TRUE(holds(rest, "\"line\":19,\"ok\":true")) << rest;
  EXPECT_TRUE(holds(s.say(bundles, "end"), "\"line\":3,\"ok\":true"));
  EXPECT_TRUE(holds(s.say(slow, "eval b3.size.x z.radius"), "\"b3.size.x\":8,\"z.radius\":1"));
  s.expect_history();
}

// No other command waits for a command that takes too long by itself. In the end it is refused.
TEST(Imaging, NobodyWaitsForWhatTakesLong) {
  Imaging::Options options;
  options.most_waited = -1;
  Stage s(options);
  const auto slow = s.imaging.arrive(), quick = s.imaging.arrive();
  s.done(slow, "create b{1..3} box");
  int works = 0;
  s.imaging.work_beside([&](const std::function<void()>& work, Imaging::Claim claim) {
    EXPECT_EQ(claim, Imaging::Claim::fair);
    work();
    EXPECT_FALSE(s.imaging.waits());
    s.done(quick, fmt::format("create ball{} sphere", ++works));
    return true;
  });
  const std::string answer = s.say(slow, "create many{1..6000} sphere");
  EXPECT_TRUE(holds(answer, "other hosts changed the document during each of 12 attempts")) << answer;
  EXPECT_TRUE(holds(answer, "split the command, or repeat it when they are idle"));
  EXPECT_EQ(works, 12);
  EXPECT_TRUE(holds(s.say(quick, "eval ball12.radius"), "\"ball12.radius\":1"));
  s.imaging.work_beside({});
  s.refused(slow, "set many1.radius 2", "");
  s.expect_history();
}

// A file is read once for a command, even if the document changes meanwhile and the command is computed again.
TEST(Imaging, WhatWasReadIsKeptForTheNextTry) {
  const Folder folder;
  folder.put("show.bx", "create ball sphere\n");
  Stage s({}, folder / "show.bx");
  const auto slow = s.imaging.arrive(), quick = s.imaging.arrive();
  int works = 0;
  s.imaging.work_beside([&](const std::function<void()>& work, Imaging::Claim) {
    work();
    std::filesystem::remove(folder / "m.obj");
    if (++works < 3) s.done(quick, fmt::format("set ball.radius {}", works));
    return true;
  });
  folder.put("m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  s.done(slow, "create m mesh file=\"m.obj\"");
  EXPECT_EQ(works, 3);
  s.refused(slow, "create n mesh file=\"other.obj\"", "other.obj");
  EXPECT_EQ(s.imaging.document().scene().meshes->at("m.obj")->triangles.size(), 3u);
  EXPECT_TRUE(holds(s.say(slow, "eval ball.radius"), "\"ball.radius\":2"));
}

// The server answers questions about many objects from one version of the document, beside other lines.
TEST(Imaging, QuestionsAboutManyLetOthersGoOn) {
  Stage s;
  const auto asks = s.imaging.arrive(), changes = s.imaging.arrive();
  for (const char* line : {"create b{1..3} box", "alias all = b{1..3}", "at 1f note \"before\"", "set b1.size (5 5 5)"})
    s.done(asks, line);
  int works = 0;
  s.imaging.work_beside([&](const std::function<void()>& work, Imaging::Claim) {
    if (++works == 1) {
      for (const char* line : {"set b1.size (7 7 7)", "create b4 box", "at 1f note later"}) s.say(changes, line);
    }
    work();
    return true;
  });
  for (const auto& [question, before] :
       {std::pair{"eval b*.size.x", "\"b1.size.x\":5,\"b2.size.x\":1,\"b3.size.x\":1}"},
        {"eval all.size.x", "\"b1.size.x\":5,\"b2.size.x\":1,\"b3.size.x\":1}"},
        {"describe b1", "size             (5 5 5)"},
        {"history", "set b1.size (5 5 5)\\n\""},
        {"list b*", "b3  box       0 events\\n\""}}) {
    works = 0;
    const std::string answer = s.say(asks, question);
    EXPECT_TRUE(holds(answer, "\"ok\":true") && holds(answer, before)) << answer;
    EXPECT_GE(works, 1) << question;
    s.done(changes, "undo"), s.done(changes, "undo");
  }
  s.refused(asks, "eval " + std::string(Imaging::longest_question, 'x'), "'eval' can have at most 65536 bytes");
}

// An alias of many objects and rows below a pattern are long commands, although they do not look like it.
TEST(Imaging, WhateverSpeaksOfManyIsWorkedOutBeside) {
  Stage s;
  const auto host = s.imaging.arrive();
  for (const char* line : {"create {a,b} sphere", "alias both = a b"}) s.done(host, line);
  int works = 0;
  s.imaging.work_beside([&](const std::function<void()>& work, Imaging::Claim) { return ++works, work(), true; });
  const auto beside = [&](const char* line) {
    works = 0;
    s.done(host, line);
    return works == 1;
  };
  EXPECT_TRUE(beside("set both.radius 2"));
  EXPECT_TRUE(beside("at 3f both.radius 2"));
  EXPECT_FALSE(beside("set a.radius 3"));
  EXPECT_TRUE(beside("both.position"));
  EXPECT_TRUE(beside("  4f (1 0 0)"));
  EXPECT_FALSE(beside("b.position"));
  EXPECT_FALSE(beside("  5f (1 0 0)"));
  EXPECT_TRUE(beside("{a,b}.position"));
  EXPECT_TRUE(beside("  6f (1 0 0)"));
  s.expect_history();
}

// A few values without code are answered at once. Questions that may take long are not.
TEST(Imaging, WhatIsQuicklyKnownIsSaidAtOnce) {
  Stage s;
  const auto host = s.imaging.arrive();
  s.done(host, "create ball sphere");
  s.done(host, "ball.position");
  s.done(host, "  1f (0 0 0) linear");
  s.done(host, "  9f (8 0 0)");
  s.done(host, "create {slow,code} sphere");
  s.done(host, "slow.position");
  s.done(host, "  1f (0 0 0) linear");
  s.done(host, "  999999f (8 0 0)");
  for (const char* width : {"0.001s", "0.04s", "1.7s", "71s", "3600s"})
    s.done(host, fmt::format("filter slow.position smooth width={}", width));
  s.done(host, "set code.radius = \"t + 1\"");
  int works = 0;
  s.imaging.work_beside([&](const std::function<void()>& work, Imaging::Claim) {
    ++works;
    work();
    return true;
  });
  EXPECT_TRUE(holds(s.say(host, "eval ball.position.x ball.world at 5f"), "\"ball.position.x\":4,"));
  EXPECT_EQ(works, 0);
  EXPECT_TRUE(holds(s.say(host, "eval code.radius at 1s"), "\"code.radius\":2}"));
  EXPECT_EQ(works, 1);
  EXPECT_TRUE(holds(s.say(host, "eval slow.position at 5000s"), "\"slow.position\":["));
  EXPECT_EQ(works, 2);
  EXPECT_TRUE(holds(s.say(host, "eval ball.in-view"), "\"ball.in-view\":true"));
  EXPECT_EQ(works, 3);
  EXPECT_TRUE(holds(s.say(host, "eval *.radius"), "\"ball.radius\":1"));
  EXPECT_EQ(works, 4);
}

TEST(Imaging, SaysNoInWords) {
  Stage s;
  const auto host = s.imaging.arrive();
  for (const auto& [line, why] : std::vector<std::pair<std::string, std::string>>{
           {"open other.bx", "a server has one document"},
           {"load ./swirl.so", "plug-ins are programs"},
           {"plot ball.position", "it would write a file on the server"},
           {"play", "a server always plays"},
           {"save elsewhere.bx", "a host cannot choose the file"},
           {"save", "this server saves no history"},
           {"end", "no bundle is open"},
           {"eval", "a target is missing here"},
           {"eval ball at", "a time is missing after 'at'\",\"hint\":\"as in eval ball at 24f\""},
           {"point (0 0)", "'point' is a row of a display list, not a command\",\"hint\":\"rows are indented"},
           {"help plot", "it would write a file on the server"},
           {"help play", "a server always plays"},
           {"eval ball", "'ball'"},
           {"subscribe", "a kind of event is missing here"},
           {"subscribe gossip", "there is no kind of event 'gossip'"},
           {"seek", "a time is missing here"},
           {"seek soon", "soon"},
           {"undo", "there is nothing to undo"},
           {"redo", "there is nothing to redo"},
           {"help nothing", "there is no help for 'nothing'"},
           {"time flies", "'flies' is not expected here"},
           {"quit now", "'now'"},
           {"use /etc/passwd", "/etc/passwd"},
           {"  12f 3", "no sheet is open"},
           {std::string("create b\0ll sphere", 18), "this is not a text"},
           {"create b\xffll sphere", "this is not a text"},
           {"ev\xff", "this is not a text"},
           {std::string(Imaging::longest_line + 1, 'x'), "a line can have at most 1048576 bytes"},
       })
    s.refused(host, line, why);
  EXPECT_EQ(s.imaging.history(), "");
  EXPECT_TRUE(s.imaging.enter(host, "quit", 0).quit);
}

// shows: C16
TEST(Imaging, TwoHostsSheetsDoNotMix) {
  Stage s;
  const auto a = s.imaging.arrive(), b = s.imaging.arrive();
  for (const auto& [host, line] : {std::pair{a, "create {left,right} sphere"},
                                   {a, "left.position"},
                                   {b, "right.position"},
                                   {a, "  1f (1 0 0)"},
                                   {b, "  1f (0 1 0)"},
                                   {a, "  11f (2 0 0)"},
                                   {a, "  21f (3 0 0)"},
                                   {b, "  11f (0 2 0)"},
                                   {b, "  21f (0"},
                                   {b, "3 0)"}})
    s.done(host, line);
  EXPECT_TRUE(holds(s.say(a, "eval left.position right.position at 11f"),
                    "\"left.position\":[2,0,0],\"right.position\":[0,2,0]"));
  EXPECT_EQ(s.imaging.history(),
            "create {left,right} sphere\nleft.position\n  1f (1 0 0)\nright.position\n  1f (0 1 0)\nleft.position\n  "
            "11f (2 0 0)\n  21f (3 0 0)\nright.position\n  11f (0 2 0)\nright.position\n  21f (0\n3 0)\n");
  s.expect_history();
}

// Two hosts make display lists row by row at once, and show them, while the clock runs. (C66, C80)
TEST(Imaging, DisplayListsAreMadeRowByRow) {
  Stage s;
  const auto a = s.imaging.arrive(), b = s.imaging.arrive();
  s.done(a, "make star");
  s.done(b, "make scene");
  s.done(a, "  color red");
  s.done(b, "  begin spin");
  s.done(a, "  tag corner");
  s.done(a, "  polygon (0 2 0) (-0.5 0 0) (0.5 0 0)");
  for (const char* line : {"  call star", "  end", "edit star", "  replace corner",
                           "  polygon (0 3 0) (-0.5 0 0) (0.5 0 0)", "  color blue"})
    s.done(b, line);
  s.done(b, "start scene", tick(50));
  EXPECT_TRUE(holds(s.say(b, "time", tick(53)), "\"tick\":53,"));
  for (const char* line : {"bundle", "make other", "  begin spin", "  end", "animate spin every 1t by rotate(1deg, y)"})
    EXPECT_EQ(s.say(a, line, tick(53)), "");
  s.done(a, "end", tick(53));
  s.expect_history();
  s.done(a, "undo");
  s.done(a, "undo");
  s.expect_history();
}

// A live command takes effect a fixed number of ticks after it arrives; a command with a time, at its time. (R-E1a,
// R-E1c)
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

// Motions continue whenever a host sends `start`, because the clock belongs to the server.
// shows: C80
TEST(Imaging, StartTurnsNoClockBack) {
  Stage s;
  const auto a = s.imaging.arrive(), b = s.imaging.arrive();
  for (const char* line :
       {"create {left,right} sphere", "set left.environments (drift)", "animate drift every 1t by translate(1 0 0)"})
    s.done(a, line, tick(9));  // from tick 10 on, where A is M
  for (const char* line : {"set right.environments (rise)", "animate rise every 2t by translate(0 1 0)"})
    s.done(b, line, tick(99));
  EXPECT_TRUE(holds(s.say(b, "start", tick(100)), "\"ok\":true,\"tick\":100}"));
  const auto at = [&](const char* what, std::int64_t t) { return s.say(a, std::string("eval ") + what, tick(t)); };
  EXPECT_TRUE(holds(at("left.world", 100), "[1,0,0,0,0,1,0,0,0,0,1,0,91,0,0,1]") ||
              holds(at("left.world", 100), "[1,0,0,91,0,1,0,0,0,0,1,0,0,0,0,1]"))
      << at("left.world", 100);
  EXPECT_TRUE(holds(at("left.world", 110), "101"));
  EXPECT_TRUE(holds(at("right.world", 110), ",6,"));  // at 100, 102 … 110
  s.done(b, "pause", tick(120));
  s.done(b, "make l", tick(130));
  s.done(b, "start l", tick(200));  // the clock stood at 120
  EXPECT_TRUE(holds(s.say(a, "time", tick(210) + 1), "\"tick\":130,"));
}

TEST(Imaging, KilledEnvironmentsAreUnknown) {
  Stage s;
  const auto host = s.imaging.arrive();
  s.done(host, "animate {spin,drift} every 1t by translate(1 0 0)", tick(1));
  s.done(host, "kill spin", tick(9));
  EXPECT_TRUE(holds(s.say(host, "eval spin.every", tick(9)), "\"spin.every\":1"));
  for (const char* line : {"eval spin.every", "eval spin.world", "eval spin", "eval spin.by at 20t"})
    s.refused(host, line, "the environment 'spin' no longer exists: it was killed", tick(11));
  EXPECT_TRUE(holds(s.say(host, "eval spin.every at 5t", tick(11)), "\"spin.every\":1"));
  EXPECT_TRUE(holds(s.say(host, "eval *.every", tick(11)), "\"values\":{\"drift.every\":1}"));
  s.done(host, "animate spin every 3t by translate(1 0 0)", tick(20));
  EXPECT_TRUE(holds(s.say(host, "eval spin.every", tick(22)), "\"spin.every\":3"));
}

// A server without a script has no folder, so it reads no files.
TEST(Imaging, WithoutAScriptNothingIsRead) {
  const Folder folder;
  folder.put("other.bx", "create precious sphere\n");
  folder.put("show.bx", "");
  std::filesystem::current_path(folder / "");
  Stage without, with({}, "show.bx");
  without.refused(without.imaging.arrive(), "use other.bx", "this server has no script, so it reads no files");
  with.done(with.imaging.arrive(), "use other.bx");
  std::filesystem::current_path("/");
}

// Commands of hosts cannot start programs (TeX), even if the author's script may.
TEST(Imaging, HostsRunNoLaTeX) {
  const FakePrograms fake;
  fake.draw(fraction_drawing);
  const Folder folder;
  Imaging::Options options;
  options.load.tex = true;
  Stage s(options, folder.put("film.bx", "create f text tex=\"x\"\n"));
  const auto host = s.imaging.arrive();
  s.refused(host, "create g text tex=\"\\\\newcommand\"", "LaTeX typesets only the formulas of the server's script");
  s.done(host, "create g text tex=\"x\"");
  EXPECT_EQ(fake.latex_calls(), 1U);
}

// Programs read the list, people the text. Other output is no warning.
TEST(Imaging, WarningsAreAList) {
  Stage s;
  using Json = nlohmann::json;
  const auto host = s.imaging.arrive();
  const Json one = Json::parse(s.say(host, "halt b*"));
  ASSERT_EQ(one["warnings"].size(), 1U) << one;
  EXPECT_EQ(one["said"], one["warnings"][0].get<std::string>() + "\n");
  EXPECT_FALSE(Json::parse(s.say(host, "create ball sphere")).contains("warnings"));
  EXPECT_FALSE(Json::parse(s.say(host, "help animate")).contains("warnings"));
  for (const char* line : {"bundle", "halt c*", "halt d*"}) s.say(host, line);
  EXPECT_EQ(Json::parse(s.say(host, "end"))["warnings"].size(), 2U);
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

TEST(Imaging, HelpIsForHosts) {
  Stage s;
  const auto host = s.imaging.arrive();
  const std::string all = s.say(host, "help");
  for (const char* word : {"Shell commands", "\\n  open ", "\\n  play "}) EXPECT_FALSE(holds(all, word)) << word;
  for (const char* word : {"bundle ", "subscribe ", "animate ", "Rows of display lists"}) EXPECT_TRUE(holds(all, word));
  EXPECT_TRUE(holds(s.say(host, "help bundle"), "together, at one moment: all or none; end has the answer"));
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

}  // namespace
}  // namespace betwixt
