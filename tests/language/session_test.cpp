// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Sessions: what was done can be taken back, saved and recovered, and every word has help that holds.
#include "betwixt/session.h"

#include <rapidcheck.h>
#include <stdlib.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>

#include "language/help.h"
#include "language/journal.h"
#include "language/reader.h"
#include "language/script.h"
#include "support/small_film.h"

namespace betwixt {
namespace {

namespace fs = std::filesystem;

// A folder of its own for each test, gone at its end.
class Folder {
 public:
  Folder() {
    char name[] = "/tmp/betwixt-session-XXXXXX";
    at_ = ::mkdtemp(name);
  }
  ~Folder() { fs::remove_all(at_); }
  std::string operator/(const std::string& name) const { return (at_ / name).string(); }
  void put(const std::string& name, const std::string& text) const { std::ofstream(at_ / name) << text; }
  std::string get(const std::string& name) const {
    std::ifstream in(at_ / name);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  bool has(const std::string& name) const { return fs::exists(at_ / name); }

 private:
  fs::path at_;
};

Session::Doors answering(std::vector<std::string> answers, std::string* asked = nullptr) {
  Session::Doors doors;
  doors.ask = [answers, asked, k = std::size_t{0}](const std::string& q) mutable -> std::optional<std::string> {
    if (asked) *asked += q;
    if (k == answers.size()) return std::nullopt;
    return answers[k++];
  };
  return doors;
}

void expect_done(Session& s, const std::string& line) {
  const auto answer = s.enter(line);
  EXPECT_TRUE(answer.done) << line << "\n" << answer.said;
}

const char* const author =
    "# by hand\nrate 24\ncreate ball sphere  # round\nball.position\n  1f (0 10 0)\n  24f (8 10 0)";

// shows: G22 G60
TEST(Session, UndoAndRedoWalkThroughAllDocuments) {
  const Folder folder;
  Session s;
  s.open(folder / "film.bx");
  std::vector<Document> all{s.document()};
  for (const char* line :
       {"create ball sphere", "ball.position", "  1f (0 0 0)", "  9f (1 0 0) linear", "remove ball"}) {
    expect_done(s, line);
    all.push_back(s.document());
  }
  for (std::size_t k = all.size() - 1; k-- > 0;) {
    expect_done(s, "undo");
    EXPECT_TRUE(s.document() == all[k]) << k;
  }
  EXPECT_FALSE(s.enter("undo").done);
  for (std::size_t k = 1; k < all.size(); ++k) {
    expect_done(s, "redo");
    EXPECT_TRUE(s.document() == all[k]) << k;
  }
  EXPECT_FALSE(s.enter("redo").done);
}

// shows: G22
TEST(Session, AWrongLineChangesNothingAndIsNoStep) {
  const Folder folder;
  Session s;
  s.open(folder / "film.bx");
  expect_done(s, "create ball sphere");
  const Document before = s.document();
  const auto answer = s.enter("set bal.radius 2");
  EXPECT_FALSE(answer.done);
  EXPECT_NE(answer.said.find("did you mean 'ball'?"), std::string::npos) << answer.said;
  EXPECT_TRUE(s.document() == before);
  EXPECT_EQ(s.unsaved(), 1u);
  EXPECT_NE(s.enter("hlep").said.find("did you mean 'help'?"), std::string::npos);
  // Rows below a refused sheet do not go to the sheet above it.
  expect_done(s, "ball.position");
  EXPECT_FALSE(s.enter("bal.color").done);
  EXPECT_FALSE(s.enter("  1f (1 2 3)").done);
}

// shows: G59
TEST(Session, NoCommandSwitchesAContext) {
  const Folder folder;
  Session s;
  s.open(folder / "film.bx");
  // Names say what is meant: other commands and words of the shell may stand between any two lines.
  for (const char* line : {"create a sphere", "create b box", "set a.radius 2", "list", "set b.size (1 2 3)",
                           "help set", "at 5f a.position (1 0 0)", "describe b", "at 5f b.position (0 1 0)"})
    expect_done(s, line);
  EXPECT_EQ(s.text(),
            "create a sphere\ncreate b box\nset a.radius 2\nset b.size (1 2 3)\nat 5f a.position (1 0 0)\n"
            "at 5f b.position (0 1 0)\n");
  // Neither does looking, between the rows of a sheet.
  std::string wanted = s.text() + "a.color\n";
  expect_done(s, "a.color");
  for (const char* look : {"list", "describe b", "help set", "help", "notes", "list a*"}) {
    const std::string row = fmt::format("  {}f red", wanted.size());
    expect_done(s, row);
    expect_done(s, look);
    wanted += row + "\n";
  }
  EXPECT_EQ(s.text(), wanted);
}

// shows: G7
TEST(Session, WhatIsShownIsTheFilmAsItIsByThen) {
  const Folder folder;
  std::optional<Document> shown;
  std::string asked;
  Session::Doors doors = answering({});
  doors.play = [&](const Document& d, const std::string& frames) {
    shown = d, asked = frames;
    return Status(Nothing{});
  };
  doors.plot = [&](const Document& d, const std::string& target, const std::string&) {
    shown = d, asked = target;
    return Status(Nothing{});
  };
  Session s(std::move(doors));
  folder.put("film.bx", author);
  s.open(folder / "film.bx");
  for (const char* line : {"hide ball", "show ball", "undo", "undo", "redo", "ball.position", "  9f (1 2 3)"}) {
    expect_done(s, line);
    for (const auto& [look, words] : {std::pair("play 1f..9f", "1f..9f"), {"plot ball.position", "ball.position"}}) {
      shown.reset();
      expect_done(s, look);
      ASSERT_TRUE(shown) << line << ", " << look;
      EXPECT_TRUE(*shown == s.document()) << line << ", " << look;
      EXPECT_EQ(asked, words);
    }
  }
}

// shows: G22
TEST(Session, SavingKeepsTheAuthorsText) {
  const Folder folder;
  folder.put("film.bx", author);
  Session s;
  s.open(folder / "film.bx");
  expect_done(s, "set ball.radius 2");
  expect_done(s, "undo");
  expect_done(s, "set ball.radius 3  # larger");
  expect_done(s, "save");
  EXPECT_EQ(folder.get("film.bx"), std::string(author) + "\nset ball.radius 3  # larger\n");
  EXPECT_EQ(s.unsaved(), 0u);
  expect_done(s, "undo");  // what has been saved can be taken back too
  EXPECT_EQ(s.unsaved(), 1u);
  expect_done(s, "save");
  EXPECT_EQ(folder.get("film.bx"), author);
  expect_done(s, "quit");
  EXPECT_FALSE(folder.has(".film.bx.journal"));
}

// shows: G22
TEST(Session, OverwritingIsAsked) {
  const Folder folder;
  folder.put("other.bx", "# precious\n");
  std::string asked;
  Session s(answering({"maybe", "no", "yes"}, &asked));
  s.open(folder / "film.bx");
  expect_done(s, "rate 25");
  EXPECT_FALSE(s.enter("save " + folder / "other.bx").done);
  EXPECT_NE(asked.find("exists: overwrite? (yes/no)"), std::string::npos) << asked;
  EXPECT_EQ(folder.get("other.bx"), "# precious\n");
  expect_done(s, "save " + folder / "other.bx");
  EXPECT_EQ(folder.get("other.bx"), "rate 25\n");
}

// shows: G22
TEST(Session, QuittingIsGuarded) {
  const Folder folder;
  std::string asked;
  Session s(answering({"stay", "save"}, &asked));
  s.open(folder / "film.bx");
  expect_done(s, "rate 25");
  EXPECT_FALSE(s.enter("quit").quit);
  EXPECT_NE(asked.find("1 command is not saved: save, discard or stay?"), std::string::npos);
  EXPECT_TRUE(s.enter("quit").quit);
  EXPECT_EQ(folder.get("film.bx"), "rate 25\n");
}

// shows: G22
TEST(Session, NobodyAnsweringLosesNothing) {
  const Folder folder;
  {
    Session s;
    s.open(folder / "film.bx");
    expect_done(s, "rate 25");
    EXPECT_TRUE(s.enter("quit").quit);
  }
  Session s;
  EXPECT_TRUE(s.open(folder / "film.bx", Session::Earlier::recover).done);
  EXPECT_EQ(s.text(), "rate 25\n");
}

// shows: G22
TEST(Session, TheSecondMayOnlyLook) {
  const Folder folder;
  folder.put("film.bx", author);
  Session first, second;
  first.open(folder / "film.bx");
  EXPECT_NE(second.open(folder / "film.bx").said.find("may only look"), std::string::npos);
  EXPECT_FALSE(second.may_change());
  EXPECT_FALSE(second.enter("rate 25").done);
  EXPECT_FALSE(second.enter("save").done);
  expect_done(second, "list");
  expect_done(first, "rate 25");
}

// shows: G22
TEST(Session, AJournalOfAnotherTextIsKeptAside) {
  const Folder folder;
  folder.put("film.bx", author);
  {
    Session s;
    s.open(folder / "film.bx");
    expect_done(s, "rate 25");
  }
  folder.put("film.bx", "# all new\n");
  Session s;
  EXPECT_NE(s.open(folder / "film.bx").said.find("kept as"), std::string::npos);
  EXPECT_EQ(s.text(), "# all new\n");
  EXPECT_NE(folder.get(".film.bx.journal.1").find("rate 25"), std::string::npos);
}

// A random author at work: a session, and lines that mean something to it.
std::string random_line(std::mt19937_64& random) {
  const auto n = [&](unsigned below) { return static_cast<int>(random() % below); };
  switch (n(12)) {
    case 0:
      return fmt::format("create o{} box", n(6));
    case 1:
      return fmt::format("o{}.position", n(6));
    case 2:
    case 3:
      return fmt::format("  {}f ({} {} 0)", n(60), n(9), n(9));
    case 4:
      return fmt::format("set o{}.size (1\n {} 1)", n(6), n(9) + 1);
    case 5:
      return fmt::format("at {}f o{}.color gold  # shiny", n(60), n(6));
    case 6:
      return fmt::format("remove o{}", n(6));
    case 7:
      return "# a remark";
    case 8:
      return fmt::format("copy o{}.position 1f..30f to 31f", n(6));
    case 9:
      return fmt::format("rate {}", 24 + n(3));
    default:
      return n(3) ? "undo" : "redo";
  }
}

// shows: G22 G60
TEST(Session, SavingAndRecoveringGiveTheSameDocument) {
  EXPECT_TRUE(rc::check([] {
    std::mt19937_64 random(*rc::gen::arbitrary<std::uint64_t>());
    const Folder folder;
    folder.put("film.bx", author);
    Document last;
    std::string text;
    std::size_t unsaved = 0;
    {
      Session s;
      s.open(folder / "film.bx");
      for (auto k = random() % 40; k > 0; --k) {
        s.enter(random_line(random));
        if (random() % 12 == 0) s.enter("save");
      }
      last = s.document(), text = s.text(), unsaved = s.unsaved();
    }  // ends without saving
    {
      Session s;
      const auto begun = s.open(folder / "film.bx", Session::Earlier::recover);
      if (!(s.document() == last) || s.text() != text || s.unsaved() != unsaved) RC_FAIL(text + "\n" + begun.said);
      s.enter("save");
    }
    RC_ASSERT(folder.get("film.bx") == text);
    if (!(load_file(folder / "film.bx").document == last)) RC_FAIL(text);
  }));
}

// shows: G22
TEST(Journal, ATornRecordIsSeenAndDroppedWhereverItWasCut) {
  const Folder folder;
  std::vector<std::size_t> sizes;
  {
    auto j = *Journal::open(folder / "j");
    ASSERT_TRUE(j->begin(fingerprint("text")));
    sizes.push_back(folder.get("j").size());
    for (const char* line : {"set a.b 1", "at 1f a.text \"é\n\"", "rate 25"}) {
      ASSERT_TRUE(j->append(Did::command, line));
      sizes.push_back(folder.get("j").size());
    }
  }
  const std::string whole = folder.get("j");
  for (std::size_t cut = sizes[0]; cut <= whole.size(); ++cut) {
    folder.put("j", whole.substr(0, cut));
    auto j = *Journal::open(folder / "j");
    const auto kept = std::count_if(sizes.begin() + 1, sizes.end(), [&](std::size_t n) { return n <= cut; });
    EXPECT_EQ(j->records().size(), static_cast<std::size_t>(kept)) << cut;
    EXPECT_FALSE(j->damaged()) << cut;
    EXPECT_EQ(j->torn() > 0, std::find(sizes.begin(), sizes.end(), cut) == sizes.end()) << cut;
    ASSERT_TRUE(j->append(Did::undo, ""));
    j.reset();
    EXPECT_EQ((*Journal::open(folder / "j"))->records().size(), static_cast<std::size_t>(kept) + 1) << cut;
  }
  for (std::size_t at = sizes[1]; at < sizes[2]; ++at) {  // a bit that has changed
    std::string changed = whole;
    changed[at] = static_cast<char>(changed[at] ^ 1);
    folder.put("j", changed);
    EXPECT_LE((*Journal::open(folder / "j"))->records().size(), 1u) << at;
  }
}

// shows: G22
TEST(Help, EveryWordIsExplained) {
  std::vector<std::string_view> words;
  for (const auto& [verb, usage] : Reader::words()) words.push_back(verb);
  words.insert(words.end(), twerper_names.begin() + 1, twerper_names.end());
  words.insert(words.end(), kind_names.begin(), kind_names.end());
  for (const FunctionSpec& f : built_in_functions()) words.push_back(f.name);
  for (const std::string_view w : words)
    EXPECT_TRUE(std::any_of(help_entries().begin(), help_entries().end(), [&](const auto& e) { return e.word == w; }))
        << w;
  const Folder folder;
  Session s;
  s.open(folder / "film.bx");
  for (const HelpEntry& e : help_entries()) {
    const auto answer = s.enter(fmt::format("help {}", e.word));
    EXPECT_TRUE(answer.done) << e.word;
    EXPECT_NE(answer.said.find(e.sentence), std::string::npos) << e.word;
  }
  EXPECT_NE(s.enter("help sphre").said.find("did you mean 'sphere'?"), std::string::npos);
}

// shows: G22
TEST(Help, ExamplesRun) {
  for (const HelpEntry& e : help_entries()) {
    if (!in_a_film(e)) continue;
    const Folder folder;
    folder.put("film.bx", small_film);
    folder.put("colors.bx", "background navy\n");
    Session s;
    const auto begun = s.open(folder / "film.bx");
    EXPECT_EQ(begun.said, "");
    std::istringstream lines{std::string(e.example)};
    for (std::string line; std::getline(lines, line);) {
      const auto answer = s.enter(line);
      EXPECT_TRUE(answer.done) << e.word << ": " << line << "\n" << answer.said;
    }
  }
}

TEST(Session, CompletesWhatIsBegun) {
  const Folder folder;
  folder.put("film.bx", small_film);
  Session s;
  s.open(folder / "film.bx");
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
  folder.put("film.bx", small_film);
  Session s;
  s.open(folder / "film.bx");
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
TEST(Session, CtrlCAtAQuestionStays) {
  const Folder folder;
  folder.put("other.bx", "rate 30\n");
  Session s(answering({std::string(Session::called_off), std::string(Session::called_off), "discard"}));
  s.open(folder / "film.bx");
  expect_done(s, "rate 25");
  EXPECT_FALSE(s.enter("quit").quit);
  EXPECT_EQ(s.enter("save " + folder / "other.bx").said, "not saved\n");
  EXPECT_EQ(folder.get("other.bx"), "rate 30\n");
  EXPECT_EQ(s.unsaved(), 1u);
  const auto missing = s.enter("open " + folder / "nowhere.bx");  // nothing is asked
  EXPECT_EQ(missing.said.substr(0, missing.said.find('\n')), "error: there is no file '" + folder / "nowhere.bx" + "'");
  EXPECT_EQ(s.unsaved(), 1u);
  EXPECT_TRUE(s.enter("quit").quit);
}

// shows: G22 G104
TEST(Session, LayersAreListedWithWhatIsOnThem) {
  const Folder folder;
  folder.put("film.bx",
             "create ball sphere\nlayer sway add weight=0.5\non sway ball.position\n  1f (0 0 0)\n  9f (1 0 0)\n"
             "at 1f sway.weight 0.25\n");
  Session s;
  s.open(folder / "film.bx");
  EXPECT_EQ(s.enter("list").said, "ball  sphere    0 events\nsway  layer     3 events\n");
  EXPECT_NE(s.enter("describe sway").said.find("  on ball.position 2 events\n"), std::string::npos);
  EXPECT_EQ(s.enter("describe ball.radius").said, "ball.radius  1\n");
  EXPECT_EQ(s.enter("describe sway.weight").said, "sway.weight\n  1f       0.25\n");
  // Rows below a refused sheet of a layer have nowhere to go.
  EXPECT_TRUE(s.enter("on swey ball.position").refused);
  EXPECT_EQ(s.enter("  1f (0 0 0)").said, "error: this row has no sheet: the line that should open it was refused\n");
}

// shows: G59
TEST(Session, RenamingKeepsWhatAPatternOfAnAliasMeant) {
  const Script s(
      "create b1 sphere\ncreate b2 sphere\ncreate c sphere\nalias all = b* c\nrename b1 moon\nset all.radius 3\n");
  expect_numbers(s, {{"moon.radius", "1f", {3}}, {"b2.radius", "1f", {3}}, {"c.radius", "1f", {3}}});
  EXPECT_EQ(s.loaded.document.scene().aliases->at("all"), (std::vector<std::string>{"b*", "moon", "c"}));
}

TEST(Session, LinesThatGoOn) {
  EXPECT_TRUE(Session::needs_more("set a.points ((0 0)"));
  EXPECT_TRUE(Session::needs_more("set a.text \"\"\"one"));
  EXPECT_FALSE(Session::needs_more("set a.text \"\"\"one\ntwo\"\"\""));
  EXPECT_FALSE(Session::needs_more("set a.text \"(\"  # (("));
  EXPECT_FALSE(Session::needs_more("set a.text \"never closed"));
}

// shows: G22
TEST(Session, AnyLinesDoNotCrash) {
  EXPECT_TRUE(rc::check([] {
    const Folder folder;
    Session s;
    s.open(folder / "film.bx");
    for (const auto& line : *rc::gen::arbitrary<std::vector<std::string>>()) {
      s.enter(line);
      s.complete(line);
      Session::needs_more(line);
    }
    RC_ASSERT(load_text(s.text(), folder / "film.bx").document == s.document());
  }));
}

}  // namespace
}  // namespace betwixt
