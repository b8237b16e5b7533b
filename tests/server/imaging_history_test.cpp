// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The history of the hosts' commands must be a script that makes the same document. (R-E1c)
#include <rapidcheck.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <deque>
#include <filesystem>
#include <functional>
#include <memory>
#include <random>
#include <set>
#include <thread>

#include "betwixt/session.h"
#include "server/stage.h"

namespace betwixt {
namespace {

TEST(Imaging, UndoHasADepth) {
  Imaging::Options options;
  options.undo.steps = 2;
  Stage s(options);
  const auto host = s.imaging.arrive();
  for (const char* line : {"create a sphere", "create b sphere", "create c sphere"}) s.done(host, line);
  s.done(host, "undo");
  s.done(host, "undo");
  s.refused(host, "undo", "no more can be undone: the undo history is limited to 2 commands");
  EXPECT_EQ(s.imaging.history(), "create a sphere\n");
  s.expect_history();
  s.done(host, "redo");
  s.done(host, "create d sphere");
  s.refused(host, "redo", "nothing to redo");
  EXPECT_EQ(s.imaging.history(), "create a sphere\ncreate b sphere\ncreate d sphere\n");
}

// What was answered is in the journal, and another server goes on with it; nothing is written into the file but by
// save.
TEST(Imaging, KeepsItsHistory) {
  const Folder folder;
  folder.put("show.bx", "create ball sphere");
  std::string history;
  {
    Stage s({}, folder / "show.bx", folder / "live.bx");
    const auto host = s.imaging.arrive();
    EXPECT_EQ(folder.get("live.bx"), "create ball sphere");
    for (const char* line : {"ball.radius", "  1f 2", "  9f 3", "create box box", "undo", "save"}) s.done(host, line);
    const std::string saved = "create ball sphere\nball.radius\n  1f 2\n  9f 3\n";
    EXPECT_EQ(folder.get("live.bx"), saved);
    for (const char* line : {"bundle", "set ball.color red", "halt nobody*"}) s.say(host, line, tick(4));
    s.done(host, "end", tick(4));
    for (const char* line : {"ball.radius", "  19f 4"}) s.done(host, line, tick(4));
    EXPECT_TRUE(s.imaging.sync());
    EXPECT_EQ(folder.get("live.bx"), saved);
    history = s.imaging.history();
    EXPECT_EQ(history, saved + "set ball.color red\nat 5t halt nobody*\nball.radius\n  19f 4\n");
    Imaging other({});
    const auto twice = other.begin("", folder / "live.bx", false, 0);
    ASSERT_FALSE(twice);
    EXPECT_TRUE(holds(twice.error().message, "is in use by another server")) << twice.error().message;
  }  // killed, as it were
  {
    Stage again({}, "", folder / "live.bx");
    EXPECT_EQ(again.imaging.history(), history);
    EXPECT_TRUE(again.imaging.document() == load_text(history, "").document);
    const auto host = again.imaging.arrive();
    again.done(host, "undo");
    again.done(host, "undo");  // the bundle as a whole, though another server did it
    EXPECT_EQ(again.imaging.history(), "create ball sphere\nball.radius\n  1f 2\n  9f 3\n");
    again.done(host, "redo");
    history = again.imaging.history();
    EXPECT_TRUE(again.imaging.finish());
  }
  EXPECT_EQ(folder.get("live.bx"), history);
  EXPECT_FALSE(folder.has(".live.bx.journal"));
}

// Wherever its journal is cut, and wherever a bit of it has changed: what was answered, up to a step.
TEST(Imaging, AnExactPrefixOfWhatWasAnsweredIsLeft) {
  const Folder folder;
  const std::string author = "create ball sphere\n# bundle\nset ball.radius 9\n# and no newline";
  folder.put("live.bx", author);
  std::vector<std::pair<std::size_t, std::string>> answered;  // the journal's size then, and the history
  {
    Stage s({}, "", folder / "live.bx");
    const auto host = s.imaging.arrive();
    answered.emplace_back(0, author);
    for (const char* line :
         {"set ball.radius 123456", "ball.position", "  1f (1 0 0)", "  9f (0", "0 1)", "undo", "create ba sphere",
          "bundle", "create box box", "note \"a\nb\"", "end", "redo", "animate spin every 1t by rotate(1deg, y)"}) {
      s.say(host, line);
      ASSERT_TRUE(s.imaging.sync());
      answered.emplace_back(folder.get(".live.bx.journal").size(), s.imaging.history());
    }
  }
  EXPECT_EQ(folder.get("live.bx"), author);
  const std::string whole = folder.get(".live.bx.journal");
  const auto begins = [&](const std::string& journal) {
    folder.put(".live.bx.journal", journal);
    Imaging again({});
    const auto begun = again.begin("", folder / "live.bx", false, 0);
    EXPECT_TRUE(begun) << (begun ? "" : begun.error().message);
    return again.history();
  };
  for (std::size_t cut = 0; cut <= whole.size(); ++cut) {
    std::string expected = author;
    for (const auto& [size, history] : answered)
      if (size <= cut) expected = history;
    EXPECT_EQ(begins(whole.substr(0, cut)), expected) << cut;
  }
  for (std::size_t at = 0; at < whole.size(); at += 3) {
    std::string changed = whole;
    changed[at] = static_cast<char>(changed[at] ^ 4);
    const std::string history = begins(changed);
    EXPECT_TRUE(std::any_of(answered.begin(), answered.end(), [&](const auto& a) { return a.second == history; }))
        << at;
  }
}

// A shell reads what a server has left.
TEST(Imaging, AShellGoesOnWithIt) {
  const Folder folder;
  folder.put("live.bx", "create ball sphere");
  std::string history;
  {
    Stage s({}, "", folder / "live.bx");
    const auto host = s.imaging.arrive();
    for (const char* line : {"bundle", "create box box", "ball.radius", "  1f 3", "end"}) s.say(host, line);
    for (const char* line : {"box.size", "  1f (1 2 3)", "undo", "redo"}) s.done(host, line);
    history = s.imaging.history();
  }
  Session shell;
  const auto opened = shell.open(folder / "live.bx", Session::Earlier::recover);
  ASSERT_TRUE(opened.done) << opened.said;
  EXPECT_EQ(shell.text(), history);
  EXPECT_TRUE(shell.enter("undo").done);
  EXPECT_TRUE(shell.enter("undo").done);
  EXPECT_EQ(shell.text(), "create ball sphere");
}

// Says so much that a checkpoint comes, and waits for it.
std::string many_lines(Stage& s, Imaging::Host host, const Folder& folder, int from, int to) {
  std::string largest;
  for (int i = from; i < to; ++i) {
    s.done(host, fmt::format("set ball.radius {}", i));
    EXPECT_TRUE(s.imaging.sync());
    if (const std::string journal = folder.get(".live.bx.journal"); journal.size() > largest.size()) largest = journal;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return largest;
}

Imaging::Options short_log() {
  Imaging::Options options;
  options.checkpoint = 2000, options.undo.steps = 5;
  return options;
}

// A log that would be endless is written anew as a script, with what can be undone behind it.
TEST(Imaging, ItsLogStaysShort) {
  const Folder folder;
  folder.put("live.bx", "# the author's\ncreate ball sphere\n");
  std::string history;
  {
    Stage s(short_log(), "", folder / "live.bx");
    const auto host = s.imaging.arrive();
    s.done(host, "animate spin every 1t by rotate(1deg, y)");
    s.done(host, "set ball.environments (spin)");
    const std::string largest = many_lines(s, host, folder, 1, 1500);  // 60 kB of records
    EXPECT_LT(largest.size(), 30000u);
    EXPECT_LT(s.imaging.history().size(), 15000u);
    EXPECT_EQ(folder.get("live.bx.orig"), "# the author's\ncreate ball sphere\n");
    s.expect_history();
    s.done(host, "undo");
    history = s.imaging.history();
  }
  Stage again(short_log(), "", folder / "live.bx");
  // A checkpoint that was in progress at the end may have come to stand before the same commands.
  EXPECT_TRUE(load_text(again.imaging.history(), "").document == load_text(history, "").document);
  const auto host = again.imaging.arrive();
  again.done(host, "redo");
  for (int k = 0; k < 5; ++k) again.done(host, "undo");
  EXPECT_TRUE(holds(again.say(host, "eval ball.radius"), "\"ball.radius\":1494"))
      << again.say(host, "eval ball.radius");
}

// Stops between the steps of a checkpoint: the journal that it replaces is still there, with the old script or the new.
TEST(Imaging, ACheckpointMayStopAtAnyMoment) {
  const Folder folder;
  folder.put("live.bx", "create ball sphere\n");
  std::string old_script, new_script, old_journal, history;
  {
    const auto in_place = std::make_shared<std::atomic<bool>>(false);
    Imaging::Options options = short_log();
    options.checkpoint_step = [in_place](const char* step) {
      if (holds(step, "the journal is in place")) *in_place = true;
    };
    Stage s(options, "", folder / "live.bx");
    const auto host = s.imaging.arrive();
    std::filesystem::create_hard_link(folder / ".live.bx.journal", folder / "old");
    old_script = folder.get("live.bx");
    for (int i = 1; !*in_place && i < 100000; ++i) {
      history = s.imaging.history();
      s.done(host, fmt::format("set ball.radius {}", i));
      history = s.imaging.history();
      ASSERT_TRUE(s.imaging.sync());
    }
    new_script = folder.get("live.bx"), old_journal = folder.get("old");
    ASSERT_NE(new_script, old_script);
    ASSERT_NE(folder.get(".live.bx.journal"), old_journal);
  }
  const Document document = load_text(history, "").document;
  for (const std::string& script : {old_script, new_script}) {
    folder.put("live.bx", script);
    folder.put(".live.bx.journal", old_journal);
    folder.put(".live.bx.journal.new", old_journal.substr(0, 100));
    Stage again(short_log(), "", folder / "live.bx");
    EXPECT_TRUE(again.imaging.document() == document) << script;
    again.done(again.imaging.arrive(), "undo");
    again.done(again.imaging.arrive(), "redo");
    EXPECT_TRUE(again.imaging.document() == document) << script;
  }
  // A shell comes in between, and what it finds is the same.
  folder.put("live.bx", new_script);
  folder.put(".live.bx.journal", old_journal);
  Session shell;
  const auto opened = shell.open(folder / "live.bx", Session::Earlier::recover);
  ASSERT_TRUE(opened.done) << opened.said;
  EXPECT_TRUE(load_text(shell.text(), "").document == document);
}

// A kill after any step of a checkpoint, while hosts send commands, loses no answered command.
TEST(Imaging, AKillBetweenTheStepsOfACheckpointLosesNothing) {
  const std::vector<std::string> steps = {"the script is written", "the journal is written",
                                          "both journals take commands", "the script is in place",
                                          "the journal is in place"};
  struct Moment {
    std::string step;
    int answered = 0;
    Folder files;  // as a kill would leave them
  };
  struct Seen {  // also by the thread of a later checkpoint
    std::deque<Moment> moments;
    std::atomic<int> answered{0};
    std::atomic<bool> over{false};
  };
  const auto seen = std::make_shared<Seen>();
  const Folder folder;
  folder.put("live.bx", "create ball sphere\n");
  const auto server = std::this_thread::get_id();
  Imaging::Options options = short_log();
  options.checkpoint_step = [seen, server, live = folder.path()](const char* step) {
    if (seen->over) return;
    // Hosts send commands while another thread is at this step.
    const int before = seen->answered;
    while (std::this_thread::get_id() != server && seen->answered < before + 3) std::this_thread::yield();
    Moment& m = seen->moments.emplace_back();
    m.step = step, m.answered = seen->answered;
    std::filesystem::copy(live, m.files.path(), std::filesystem::copy_options::recursive);
    if (m.step == "the journal is in place") seen->over = true;
  };
  int last = 0;
  std::string history;
  {
    Stage s(options, "", folder / "live.bx");
    const auto host = s.imaging.arrive();
    for (int more = 20; more > 0; more -= seen->over) {
      s.done(host, fmt::format("set ball.radius {}", ++last));
      EXPECT_TRUE(s.imaging.sync());
      seen->answered = last;
    }
    s.done(host, "save");
    EXPECT_FALSE(holds(s.imaging.history(), "set ball.radius 1\n")) << "the checkpoint has replaced it";
    history = s.imaging.history();
    EXPECT_EQ(folder.get("live.bx"), history);
  }
  const auto radius = [](Stage& s) {
    const std::string answer = s.say(s.imaging.arrive(), "eval ball.radius");
    return std::stoi(answer.substr(answer.find("\"ball.radius\":") + 14));
  };
  ASSERT_EQ(seen->moments.size(), steps.size());
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const Moment& m = seen->moments[i];
    EXPECT_EQ(m.step, steps[i]);
    Stage again(short_log(), "", m.files / "live.bx");
    const int found = radius(again);
    EXPECT_TRUE(found >= m.answered && found <= last) << m.step << ": " << m.answered << " " << found;
    again.done(again.imaging.arrive(), "undo");
    EXPECT_EQ(radius(again), found - 1) << m.step;
    again.expect_history();
  }
  Stage again(short_log(), "", folder / "live.bx");
  EXPECT_EQ(again.imaging.history(), history);
}

// A journal that somebody has moved away is written anew by `save`, with all that can be undone.
TEST(Imaging, SaveBeginsAJournalThatWasMoved) {
  const Folder folder;
  std::string history;
  {
    Stage s({}, "", folder / "live.bx");
    const auto host = s.imaging.arrive();
    for (const char* line : {"create ball sphere", "set ball.radius 2", "set ball.radius 3", "undo"})
      s.done(host, line);
    std::filesystem::rename(folder / ".live.bx.journal", folder / "away");
    s.refused(host, "set ball.radius 4", "was moved or removed");
    s.done(host, "save");
    s.done(host, "undo");
    history = s.imaging.history();
    EXPECT_EQ(history, "create ball sphere\n");
  }
  Stage again({}, "", folder / "live.bx");
  EXPECT_EQ(again.imaging.history(), history);
  const auto host = again.imaging.arrive();
  again.done(host, "redo");
  again.done(host, "redo");
  EXPECT_TRUE(holds(again.say(host, "eval ball.radius"), "\"ball.radius\":3"));
}

// The new script beside what is left of the old journal: what was answered, up to a step, and all that is in the
// script.
TEST(Imaging, ACheckpointAndADamagedJournal) {
  const Folder folder;
  folder.put("live.bx", "create ball sphere\n");
  const auto radius = [](Stage& s) {
    const std::string answer = s.say(s.imaging.arrive(), "eval ball.radius");
    return std::stoi(answer.substr(answer.find("\"ball.radius\":") + 14));
  };
  const std::string old_script = folder.get("live.bx");
  int last = 0;
  {
    Stage s(short_log(), "", folder / "live.bx");
    const auto host = s.imaging.arrive();
    std::filesystem::create_hard_link(folder / ".live.bx.journal", folder / "old");
    while (folder.get("live.bx") == old_script && last < 100000) {
      s.done(host, fmt::format("set ball.radius {}", ++last));
      ASSERT_TRUE(s.imaging.sync());
    }
  }
  EXPECT_FALSE(folder.has(".live.bx.checkpoint"));
  const std::string new_script = folder.get("live.bx"), old_journal = folder.get("old");
  const int first = radius(*std::make_unique<Stage>(Imaging::Options(), folder.put("copy.bx", new_script)));
  EXPECT_LE(first, last - 5) << "what can be undone is in the journal";
  int before = first;
  const std::size_t size = old_journal.size();
  for (std::size_t cut = 0; cut <= size; cut = cut == size ? size + 1 : std::min(cut + 997, size)) {
    folder.put("live.bx", new_script);
    folder.put(".live.bx.journal", old_journal.substr(0, cut));
    Stage again(short_log(), "", folder / "live.bx");
    const int found = radius(again);
    EXPECT_TRUE(found >= before && found <= last) << cut;
    before = found;
  }
  EXPECT_EQ(before, last);
}

// Another server starts in the folder. Returns its messages.
std::string goes_on(
    const Folder& folder, const std::function<void(Imaging&)>& then = [](Imaging&) {}) {
  Imaging imaging({});
  const auto begun = imaging.begin("", folder / "live.bx", false, 0);
  EXPECT_TRUE(begun) << (begun ? "" : begun.error().message);
  if (!begun) return "";
  EXPECT_FALSE(has_errors(*begun)) << to_string((*begun)[0]);
  then(imaging);
  std::string said;
  for (const Diagnostic& d : *begun) said += to_string(d);
  return said;
}

// Commands in the last second before the limit of time can be loaded; later ones are refused.
TEST(Imaging, NothingIsStampedBeyondAllTimes) {
  const Folder folder;
  std::string history;
  {
    Stage s({}, "", folder / "live.bx");
    const auto host = s.imaging.arrive();
    s.done(host, "create ball sphere");
    s.done(host, "seek 4599999999s");
    s.done(host, "set ball.drive (e1)");
    s.done(host, "seek 4600000000s");
    s.refused(host, "set ball.drive (e2)", "the present time is beyond the limit");
    s.refused(host, "animate e2 every 1t by rotate(1deg, y)", "the present time is beyond the limit", 5 * second);
    s.say(host, "bundle");
    s.say(host, "set ball.radius 3");
    s.say(host, "halt e*");
    s.refused(host, "end", "line 9: the present time");
    s.done(host, "set ball.radius 2");
    s.expect_history();
    history = s.imaging.history();
  }
  EXPECT_EQ(goes_on(folder, [&](Imaging& again) { EXPECT_EQ(again.history(), history); }), "");
}

const char* const some_mesh = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

// A file that a command needs has gone: the command is set aside, and so are those that need what it made.
TEST(Imaging, WhatCannotBeDoneAgainIsSetAside) {
  const Folder folder;
  folder.put("m.obj", some_mesh);
  {
    Stage s({}, "", folder / "live.bx");
    const auto host = s.imaging.arrive();
    for (const char* line :
         {"create ball sphere", "create m mesh file=\"m.obj\"", "set ball.radius 2", "m.position", "  1f (1 2 3)",
          "save", "create box box", "hang m on ball", "hang box on ball", "undo", "set m.position (1 1 1)", "undo"})
      s.done(host, line);
  }
  std::filesystem::rename(folder / "m.obj", folder / "away");
  const std::string history = "create ball sphere\nset ball.radius 2\ncreate box box\n";
  const std::string said = goes_on(folder, [&](Imaging& again) {
    EXPECT_EQ(again.history(), history);
    const auto host = again.arrive();
    EXPECT_TRUE(holds(again.enter(host, "set-aside", 0).line, "create m mesh"));
    EXPECT_TRUE(holds(again.enter(host, "eval ball.radius", 0).line, "\"ball.radius\":2"));
  });
  EXPECT_TRUE(holds(said, "3 commands") && holds(said, "live.bx.set-aside") && holds(said, "m.obj")) << said;
  const std::string aside = folder.get("live.bx.set-aside");
  for (const char* line : {"\ncreate m mesh file=\"m.obj\"\n", "\nm.position\n  1f (1 2 3)\n", "\nhang m on ball\n"})
    EXPECT_TRUE(holds(aside, line)) << line << aside;
  // Later starts have no message and lose nothing more, and neither does a shell.
  for (int k = 0; k < 2; ++k)
    EXPECT_EQ(goes_on(folder, [&](Imaging& again) { EXPECT_EQ(again.history(), history); }), "");
  EXPECT_EQ(folder.get("live.bx.set-aside"), aside);
  {
    Session shell;
    ASSERT_TRUE(shell.open(folder / "live.bx", Session::Earlier::recover).done);
    EXPECT_EQ(shell.text(), history);
  }
  // When the file is back, the set-aside file is a script that can be carried out.
  std::filesystem::rename(folder / "away", folder / "m.obj");
  folder.put("all.bx", history + aside);
  EXPECT_FALSE(has_errors(load_file(folder / "all.bx").diagnostics));
}

// The same after a server that ended normally: the script has all commands then.
TEST(Imaging, LinesOfTheScriptThatItLeftAreSetAside) {
  const Folder folder;
  folder.put("m.obj", some_mesh);
  folder.put("live.bx", "# the author's\n");
  {
    Stage s({}, "", folder / "live.bx");
    const auto host = s.imaging.arrive();
    for (const char* line : {"create m mesh file=\"m.obj\"", "m.position", "  1f (1 2 3)", "create ball sphere"})
      s.done(host, line);
    ASSERT_TRUE(s.imaging.finish());
  }
  const std::string whole = folder.get("live.bx");
  std::filesystem::remove(folder / "m.obj");
  const std::string left = "# the author's\ncreate ball sphere\n";
  EXPECT_TRUE(holds(goes_on(folder, [&](Imaging& i) { EXPECT_EQ(i.history(), left); }), "2 commands"));
  EXPECT_EQ(folder.get("live.bx"), left);
  EXPECT_EQ(folder.get("live.bx.orig"), whole);
  EXPECT_TRUE(holds(folder.get("live.bx.set-aside"), "m.position\n  1f (1 2 3)\n"));
  EXPECT_EQ(goes_on(folder, [&](Imaging& i) { EXPECT_TRUE(i.finish()); }), "");
  // An error in a line that a person has added stops the start.
  folder.put("live.bx", left + "hide moon of\n");
  Imaging refused({});
  const auto begun = refused.begin("", folder / "live.bx", false, 0);
  ASSERT_TRUE(begun);
  EXPECT_TRUE(has_errors(*begun));
  EXPECT_EQ(folder.get("live.bx"), left + "hide moon of\n");
}

// A start that was killed leaves a mark. The next one tries the history in a copy of the process; it lives, so nothing
// is set aside.
TEST(Imaging, AStartThatWasKilledLosesNothing) {
  const Folder folder;
  std::string history;
  {
    Stage s({}, "", folder / "live.bx");
    const auto host = s.imaging.arrive();
    for (const char* line : {"create ball sphere", "set ball.radius = \"error('procedure:', 0)\"", "undo"})
      s.done(host, line);
    history = s.imaging.history();
  }
  folder.put(".live.bx.starting", "");
  EXPECT_EQ(goes_on(folder, [&](Imaging& i) { EXPECT_EQ(i.history(), history); }), "");
  EXPECT_FALSE(folder.has(".live.bx.starting"));
  EXPECT_FALSE(folder.has("live.bx.set-aside"));
}

// What somebody else has written into the file meanwhile is not lost.
TEST(Imaging, OthersTextsAreNotReplaced) {
  const Folder folder;
  Stage s({}, "", folder / "live.bx");
  const auto host = s.imaging.arrive();
  s.done(host, "create ball sphere");
  folder.put("live.bx", "create precious box\n");
  s.refused(host, "save", "was changed by another program");
  EXPECT_FALSE(s.imaging.finish());
  EXPECT_EQ(folder.get("live.bx"), "create precious box\n");
  EXPECT_TRUE(folder.has(".live.bx.journal"));
}

// What undo keeps is bounded by what it holds, and the last command can always be taken back.
TEST(Imaging, UndoHasASize) {
  Imaging::Options options;
  options.undo.bytes = 1 << 20;
  Stage s(options);
  const auto host = s.imaging.arrive();
  s.done(host, "create o{1..2000} sphere");
  for (int i = 1; i <= 20; ++i) s.done(host, fmt::format("set o*.radius {}", i));
  int undone = 0;
  while (holds(s.say(host, "undo"), "\"ok\":true")) ++undone;
  EXPECT_GE(undone, 1);
  EXPECT_LT(undone, 6);  // 2,000 objects of more than 100 bytes each
  s.refused(host, "undo", "the undo history is limited to 1048576 bytes");
  for (int i = 0; i < undone; ++i) s.done(host, "redo");
  s.expect_history();
}

// Two hosts never have the same names, however many came before; nor any that a history has.
TEST(Imaging, NamesAreGivenOnce) {
  const Folder folder;
  folder.put("show.bx", "animate E1007 every 1t by rotate(1deg, y)\nmake O3001\n  tag T4000\n  point (0 0)\n");
  Stage s({}, folder / "show.bx");
  const auto a = s.imaging.arrive();
  EXPECT_TRUE(holds(s.say(a, "names"), "\"first\":2000,\"last\":2999"));
  s.done(a, "create O5999 sphere");
  EXPECT_EQ(s.say(a, "bundle"), "");
  EXPECT_TRUE(holds(s.say(a, "names"), "\"first\":6000,\"last\":6999"));
  s.done(a, "end");
  std::set<std::string> given;
  for (int i = 0; i < 5000; ++i) EXPECT_TRUE(given.insert(s.say(s.imaging.arrive(), "names")).second);
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
  EXPECT_TRUE(holds(why(folder / "show.bx", folder / "other.bx"), "already exists"));
  EXPECT_TRUE(holds(why(folder / "none.bx", ""), "there is no file"));
  EXPECT_TRUE(holds(why(folder / "show.bx", "/tmp/betwixt-elsewhere.bx"), "is not in the same folder"));
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
          "seek -4600000000s",
          "seek 4600000000s",
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
