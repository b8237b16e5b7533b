// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "editor/placing.h"

#include <random>

#include "betwixt/language.h"
#include "editor/author.h"
#include "editor/row_change.h"

namespace betwixt {
namespace {

// What a text becomes where lines are said.
std::string placed(const std::string& text, const std::vector<std::string>& lines) {
  const Folder folder;
  folder.put("film.bx", text);
  Session s;
  s.edit_in_place();
  const std::string file = folder / "film.bx";
  EXPECT_TRUE(s.open(file).done);
  for (const std::string& line : lines) {
    const Session::Answer a = s.enter(line);
    EXPECT_TRUE(a.done) << line << ": " << a.said;
  }
  EXPECT_TRUE(load_text(s.text(), file).document == s.document()) << s.text();
  for (std::size_t i = 0; i < lines.size(); ++i) EXPECT_TRUE(s.enter("undo").done);
  EXPECT_EQ(s.text(), text);
  for (std::size_t i = 0; i < lines.size(); ++i) EXPECT_TRUE(s.enter("redo").done);
  return s.text();
}

const std::string ball =
    "# a ball\n"
    "create ball sphere color=gold radius=0.5  # round\n"
    "ball.position\n"
    "  1f  (0 0 0)        # here it begins\n"
    "  # then it flies\n"
    "  12f (5 3 0) linear\n"
    "  24f (9 0 0)\n"
    "\n"
    "set ball.shininess 0.3\n";

std::string with(std::string text, const std::string& was, const std::string& is) {
  const std::size_t at = text.find(was);
  EXPECT_NE(at, std::string::npos) << was;
  return text.replace(at, was.size(), is);
}

// A session that goes on from a journal which is kept beside it as `journal`, as after a crash; null if it cannot.
std::unique_ptr<Session> after_a_crash(const Folder& folder) {
  folder.put(".film.bx.journal", folder.get("journal"));
  auto again = std::make_unique<Session>();
  again->edit_in_place();
  return again->open(folder / "film.bx", Session::Earlier::recover).done ? std::move(again) : nullptr;
}

TEST(Placing, AnEventThatIsChangedChangesItsRow) {
  EXPECT_EQ(placed(ball, {"at 1f ball.position (0 1 0)"}), with(ball, "(0 0 0) ", "(0 1 0) "));
  EXPECT_EQ(placed(ball, {"at 12f ball.position (5 4 0) hold"}), with(ball, "(5 3 0) linear", "(5 4 0) hold"));
}
TEST(Placing, AnEventThatIsMovedTakesItsRowAlong) {
  EXPECT_EQ(placed(ball, {"move ball.position 12f..12f by 3f"}), with(ball, "12f (5", "15f (5"));
  EXPECT_EQ(placed(ball, {"move ball.position 12f..12f by 20f"}),
            with(with(ball, "  # then it flies\n  12f (5 3 0) linear\n", ""), "  24f (9 0 0)\n",
                 "  24f (9 0 0)\n  # then it flies\n  32f (5 3 0) linear\n"));
  EXPECT_EQ(placed(ball, {"move ball.position 1f..24f by 1s"}),
            with(with(with(ball, "  1f  ", "  25f  "), "  12f", "  36f"), "  24f", "  48f"));
}
TEST(Placing, NewEventsGoIntoTheSheet) {
  EXPECT_EQ(placed(ball, {"at 18f ball.position (7 2 0)"}), with(ball, "  24f", "  18f (7 2 0)\n  24f"));
  EXPECT_EQ(placed(ball, {"at 30f ball.position (7 2 0)"}),
            with(ball, "  24f (9 0 0)\n", "  24f (9 0 0)\n  30f (7 2 0)\n"));
}
TEST(Placing, WhatIsClearedIsGone) {
  EXPECT_EQ(placed(ball, {"clear ball.position 24f"}), with(ball, "  24f (9 0 0)\n", ""));
}
TEST(Placing, ValuesAreSaidWhereTheyWere) {
  EXPECT_EQ(placed(ball, {"set ball.shininess 0.5"}), with(ball, "0.3", "0.5"));
  EXPECT_EQ(placed(ball, {"set ball.color red"}), with(ball, "gold", "red"));
  EXPECT_EQ(placed(ball, {"set ball.radius 2"}), with(ball, "radius=0.5", "radius=2"));
  EXPECT_EQ(placed(ball, {"set ball.transparency 0.5"}), ball + "set ball.transparency 0.5\n");
}
TEST(Placing, ASecondEventMakesASheet) {
  EXPECT_EQ(placed(ball, {"at 12f ball.color red", "at 6f ball.color blue", "at 18f ball.color gold hold"}),
            ball + "ball.color\n  6f blue\n  12f red\n  18f gold hold\n");
  const std::string line = "create b box\nat 12f b.position.x 3  # out\ncreate c box\n";
  EXPECT_EQ(placed(line, {"at 1f b.position.x 0"}),
            "create b box\nb.position.x\n  1f 0\n  12f 3  # out\ncreate c box\n");
}
TEST(Placing, WhatWasSaidTwiceIsGone) {
  const std::string twice = "create b box\nat 12f b.position (1 0 0)\nat 12f b.position (2 0 0)\n";
  EXPECT_EQ(placed(twice, {"clear b.position 12f"}), "create b box\n");
  EXPECT_EQ(placed(twice, {"move b.position 12f..12f by 2f"}), "create b box\nat 14f b.position (2 0 0)\n");
  EXPECT_EQ(placed(twice, {"at 12f b.position (3 0 0)"}), with(twice, "(2 0 0)", "(3 0 0)"));
}
TEST(Placing, WhatIsSaidOnceOfAFilmIsSaidOnce) {
  const std::string film = "rate 24\nrange 1f 48f  # two seconds\nsky on\nbackground #102030\ncreate b box\n";
  EXPECT_EQ(placed(film, {"range 1f 96f", "sky off", "background navy to black", "ground on"}),
            "rate 24\nrange 1f 96f  # two seconds\nsky off\nbackground navy to black\ncreate b box\nground on\n");
}
TEST(Placing, ANameIsChangedWhereItStands) {
  EXPECT_EQ(placed("create ball sphere\ncreate ball/kid box\ncreate balloon box # a ball it is not\nball.position\n  "
                   "1f (0 0 0)\n"
                   "at 4f attach balloon to ball keep-world\n",
                   {"rename ball sun"}),
            "create sun sphere\ncreate sun/kid box\ncreate balloon box # a ball it is not\nsun.position\n  1f (0 0 0)\n"
            "at 4f attach balloon to sun keep-world\n");
  EXPECT_EQ(placed("create b{1..3} box\n", {"rename b2 two"}), "create b{1..3} box\nrename b2 two\n");
}
TEST(Placing, WhatIsNewGoesToTheEnd) {
  EXPECT_EQ(placed(ball, {"create box2 box"}), ball + "create box2 box\n");
  EXPECT_EQ(placed(ball, {"at 12f ball.color red"}), ball + "at 12f ball.color red\n");
  EXPECT_EQ(placed(ball, {"ball.color", "  1f red", "  5f blue"}), ball + "ball.color\n  1f red\n  5f blue\n");
}
TEST(Placing, RowsForManyChangeTogetherOrNotAtAll) {
  const std::string many =
      "create b{1..3} box\n"
      "b*.position\n"
      "  1f (0 0 0)\n"
      "  12f (1 0 0)\n";
  EXPECT_EQ(placed(many, {"move b*.position 12f..12f by 6f"}), with(many, "12f", "18f"));
  EXPECT_EQ(placed(many, {"at 12f b2.position (4 0 0)"}), many + "at 12f b2.position (4 0 0)\n");
  EXPECT_EQ(placed(many, {"at 12f b*.position (4 0 0)"}), with(many, "(1 0 0)", "(4 0 0)"));
}
TEST(Placing, LinesOfOneEventAndOtherWaysOfTime) {
  const std::string lines =
      "create ball sphere\n"
      "at 0.5s ball.position (1 0 0)\n"
      "at 1s ball.position (2 0 0) hold # stays\n"
      "ball.rotation\n"
      "  0s (0 0 0)\n"
      "  +6f (90deg 0 0)\n"
      "  +6f (0 0 0)\n";
  EXPECT_EQ(placed(lines, {"move ball.position 1s..1s by 1s"}), with(lines, "at 1s", "at 2s"));
  EXPECT_EQ(placed(lines, {"clear ball.position 0.5s"}), with(lines, "at 0.5s ball.position (1 0 0)\n", ""));
  EXPECT_EQ(placed(lines, {"at 13f ball.rotation (0 45deg 0)"}), with(lines, "  +6f (0 0 0)", "  +6f (0 45deg 0)"));
}
TEST(Placing, TextsWithoutALastNewLine) {
  const std::string open = "create ball sphere\nball.position\n  1f (0 0 0)\n  9f (1 0 0)";
  EXPECT_EQ(placed(open, {"at 9f ball.position (2 0 0)"}), with(open, "(1 0 0)", "(2 0 0)"));
  EXPECT_EQ(placed(open, {"at 12f ball.position (2 0 0)"}), open + "\n  12f (2 0 0)\n");
  EXPECT_EQ(placed(open, {"create b box"}), open + "\ncreate b box\n");
}

// Whatever is said, the text makes the film, and taken back it is what it was.
TEST(Placing, TheTextAlwaysMakesTheFilm) {
  const Folder folder;
  const std::string text =
      "create a sphere\ncreate b box color=red\ncreate g{1..3} sphere\nlayer sway add\n"
      "a.position\n  1f (0 0 0)\n  8f (1 2 3) hold\n  +4f (2 2 2)\n"
      "b.position # goes\n  1f (0 0 0)\n\n  10f (5 5 5) # there\n  20f (9 9 9)\n"
      "g*.position.x\n  1f 0\n  5f 2\nat 3f a.radius 2\nat 9f a.radius 1\n"
      "on sway b.position\n  4f (0 1 0)\n  6f (0 0 0)\n"
      "a.rotation\n  1f (0 0 0)\n  9f (0 90deg 0)\nset g2.color blue\n"
      "move b.position 10f..20f by 2f\n";
  std::mt19937 random(11);
  const auto pick = [&](const std::vector<std::string>& all) { return all[random() % all.size()]; };
  const auto frame = [&] { return fmt::format("{}f", 1 + random() % 24); };
  const std::vector<std::string> vectors{"a.position", "b.position", "g*.position", "g2.position"};
  for (int round = 0; round < 12; ++round) {
    folder.put("film.bx", text);
    Session s;
    s.edit_in_place();
    ASSERT_TRUE(s.open(folder / "film.bx").done);
    int steps = 0;
    for (int i = 0; i < 60; ++i) {
      const std::string t =
          pick({"a.position", "b.position", "g*.position.x", "a.radius", "a.rotation", "g1.position"});
      std::string line;
      const std::string vector = fmt::format("({} {} 0)", random() % 9, random() % 9);
      switch (random() % 12) {
        case 0:
          line = fmt::format("at {} {} {} {}", frame(), pick(vectors), vector, pick({"", "hold", "linear", "smooth"}));
          break;
        case 1:
          line = fmt::format("at {} a.radius {}", frame(), 1 + random() % 5);
          break;
        case 2:
          line = fmt::format("move {} {}..{} by {}f", t, "1f", frame(), random() % 7);
          break;
        case 3:
          line = fmt::format("clear {} {}", t, frame());
          break;
        case 4:
          line = fmt::format("stretch {} 1f..{} by 2", t, frame());
          break;
        case 5:
          line = fmt::format("reverse {} 1f..{}", t, frame());
          break;
        case 6:
          line = fmt::format("set {} {}", pick({"a.color", "b.color", "g2.color", "g*.color"}),
                             pick({"red", "gold", "#123456"}));
          break;
        case 7:
          line = fmt::format("copy {} 1f..6f to {}", t, frame());
          break;
        case 8:
          line = fmt::format("at {} {} a to b keep-world", frame(), pick({"attach", "couple"}));
          break;
        case 9:
          line = fmt::format("on sway at {} b.position {}", frame(), vector);
          break;
        case 10:
          line = pick({"undo", "redo"});
          break;
        case 11:
          line = fmt::format("at {} a.rotation (0 {}deg 0)", frame(), random() % 360);
          break;
      }
      const bool done = s.enter(line).done;
      if (done) steps += line == "undo" ? -1 : 1;
      const Loaded again = load_text(s.text(), folder / "film.bx");
      ASSERT_TRUE(again.document == s.document()) << "round " << round << " after " << line << "\n" << s.text();
    }
    while (steps-- > 0) ASSERT_TRUE(s.enter("undo").done);
    EXPECT_EQ(s.text(), text);
  }
}

// What was done in place comes back after the program was killed: text and film.
TEST(Placing, IsRecovered) {
  for (const bool saved : {false, true}) {
    const Folder folder;
    std::string text;
    Document document;
    {
      auto s = std::make_unique<Session>();
      s->edit_in_place();
      folder.put("film.bx", ball);
      ASSERT_TRUE(s->open(folder / "film.bx").done);
      expect_done(*s, "at 12f ball.position (5 5 5)");
      if (saved) expect_done(*s, "save");
      if (saved) expect_done(*s, "undo");  // of what the file holds
      if (saved) expect_done(*s, "redo");
      expect_done(*s, "rewrite 2..2 \"create ball sphere\"");
      expect_done(*s, "set ball.shininess 0.9");
      expect_done(*s, "undo");
      expect_done(*s, "move ball.position 24f..24f by 6f");
      text = s->text(), document = s->document();
      folder.put("journal", folder.get(".film.bx.journal"));
    }
    const auto again = after_a_crash(folder);
    ASSERT_TRUE(again);
    EXPECT_EQ(again->text(), text);
    EXPECT_TRUE(again->document() == document);
    expect_done(*again, "undo");
    EXPECT_NE(again->text(), text);
  }
}
// Somebody else wrote into the file: what is here and not there is not saved, and comes back.
TEST(Placing, GoesOnFromAFileThatOthersChanged) {
  const Folder folder;
  folder.put("film.bx", ball);
  std::string text;
  {
    Session s;
    s.edit_in_place();
    s.open(folder / "film.bx");
    expect_done(s, "at 24f ball.position (1 1 1)");
    const std::string theirs = with(ball, "# a ball", "# their ball");
    folder.put("film.bx", theirs);
    text = *merge(ball, s.text(), theirs);
    const LineChange c = change_between(s.text(), text);
    expect_done(s, Session::rewrite_line(c.lines.first, c.lines.last, c.others));
    EXPECT_EQ(s.text(), text);
    ASSERT_TRUE(s.go_on_from_file());
    EXPECT_EQ(s.unsaved(), 1u);
    folder.put("journal", folder.get(".film.bx.journal"));
  }
  const auto again = after_a_crash(folder);
  ASSERT_TRUE(again);
  EXPECT_EQ(again->text(), text);
  expect_done(*again, "save");
  EXPECT_EQ(folder.get("film.bx"), text);
  EXPECT_EQ(again->unsaved(), 0u);
}

// A shell that finds such a journal goes on in the same way.
TEST(Placing, IsRecoveredByAShell) {
  const Folder folder;
  folder.put("film.bx", ball);
  {
    Session s;
    s.edit_in_place();
    s.open(folder / "film.bx");
    expect_done(s, "rewrite 4..4 \"  1f (7 7 7)\"");
    folder.put("journal", folder.get(".film.bx.journal"));
  }
  folder.put(".film.bx.journal", folder.get("journal"));
  Session shell;
  ASSERT_TRUE(shell.open(folder / "film.bx", Session::Earlier::recover).done);
  EXPECT_NE(shell.text().find("(7 7 7)"), std::string::npos);
  EXPECT_EQ(shell.text().find("rewrite"), std::string::npos);
}

TEST(Rewriting, ChangesLinesOfTheText) {
  EXPECT_EQ(placed(ball, {"rewrite 2..2 \"create ball sphere radius=2\""}),
            with(ball, "create ball sphere color=gold radius=0.5  # round", "create ball sphere radius=2"));
  EXPECT_EQ(placed(ball, {"rewrite 4..7 \"  1f (1 2 3)\\n\"", "at 1f ball.position (3 2 1)"}),
            "# a ball\ncreate ball sphere color=gold radius=0.5  # round\nball.position\n  1f (3 2 1)\n\nset "
            "ball.shininess 0.3\n");
  EXPECT_EQ(placed("a b\n", {"rewrite 2..1 \"create x box\\n\""}), "a b\ncreate x box\n");
  EXPECT_EQ(placed("", {"rewrite 1..0 \"create x box\""}), "create x box");
}
TEST(Rewriting, SaysWhatItTakes) {
  Session s;
  s.edit_in_place();
  s.open("");
  for (const char* line : {"rewrite", "rewrite 1", "rewrite a..b \"\"", "rewrite 1..2", "rewrite 1..0 \"x\" y"})
    EXPECT_NE(s.enter(line).said.find("rewrite FIRST..LAST"), std::string::npos) << line;
  EXPECT_NE(s.enter("rewrite 3..4 \"x\"").said.find("there are no lines 3..4"), std::string::npos);
}

// A row that is changed by itself gives the film that the whole text gives.
TEST(RowChange, IsWhatTheWholeTextMakes) {
  const Folder folder;
  const std::string text =
      "rate 24\ncreate ball sphere\ncreate hand box\n"
      "ball.position\n  1f (0 0 0)\n  # up\n  12f (2 3 0) linear ease-in=2f\n  24f (4 0 0)\n\n"
      "ball.scale.x\n  1f 1\n  9f 2 hold\n"
      "hand.rotation\n  1f (0 0 0)\n  24f (0 90deg 0)\n"
      "ball.color\n  1f red\n  24f blue\n"
      "at 12f attach ball to hand keep-world\nat 20f letgo ball\nat 5f note \"x\"\nset hand.color gold\n"
      "at 9f hand.position (1 2 3)\n";
  std::mt19937 random(3);
  int quick = 0;
  for (const std::string more :
       {"", "move ball.position 1f..24f by 2f\n", "copy ball.position 1f..9f to 30f\n", "let a = 2\n",
        "at 12f ball.position (9 9 9)\n", "b*.position\n  3f (1 1 1)\n", "rate 30\n", "create two like ball\n",
        "at 20f fall ball\n", "bake ball.position 1f..9f\n"}) {
    folder.put("film.bx", text + more);
    Session s;
    s.edit_in_place();
    ASSERT_TRUE(s.open(folder / "film.bx").done);
    for (int i = 0; i < 60; ++i) {
      std::vector<std::string> lines;
      const std::string now = s.text();
      for (std::size_t at = 0; at < now.size(); at = now.find('\n', at) + 1)
        lines.push_back(now.substr(at, now.find('\n', at) + 1 - at));
      const std::size_t k = random() % lines.size();
      if (lines[k][0] != ' ') continue;
      std::string row = lines[k];
      switch (random() % 4) {
        case 0:
          row.replace(2, row.find(' ', 2) - 2, fmt::format("{}f", 1 + random() % 30));
          break;
        case 1:
          row.replace(2, row.find(' ', 2) - 2, fmt::format("{}s", 0.25 * static_cast<double>(random() % 8)));
          break;
        case 2:
          std::ranges::replace(row, '0', static_cast<char>('1' + random() % 9));
          break;
        case 3:
          row.insert(row.size() - 1, random() % 2 ? " hold" : " x");
          break;
      }
      quick +=
          commands_of(now, *replace_lines(now, {static_cast<int>(k) + 1, static_cast<int>(k) + 1}, row), s.document())
              .has_value();
      const Loaded ahead = s.look_ahead(static_cast<int>(k) + 1, static_cast<int>(k) + 1, row);
      s.enter(Session::rewrite_line(static_cast<int>(k) + 1, static_cast<int>(k) + 1, row));
      const Loaded whole = load_text(s.text(), folder / "film.bx");
      ASSERT_TRUE(whole.document == s.document()) << row << s.text();
      ASSERT_TRUE(whole.document == ahead.document) << row << s.text();
      ASSERT_EQ(has_errors(whole.diagnostics), has_errors(s.diagnostics())) << row;
      if (random() % 3 == 0) s.enter("undo");
    }
  }
  EXPECT_GT(quick, 20);  // it is not always read as a whole
}

TEST(ChangeBetween, AndBackIsTheSameText) {
  std::mt19937 random(7);
  const auto text = [&] {
    std::string s;
    for (unsigned n = random() % 6; n > 0; --n)
      s += std::string(1 + random() % 2, static_cast<char>('a' + random() % 3)) + "\n";
    if (!s.empty() && random() % 3 == 0) s.pop_back();
    return s;
  };
  for (int i = 0; i < 20000; ++i) {
    const std::string a = text(), b = text();
    const LineChange c = change_between(a, b);
    const auto e = replace_lines(a, c.lines, c.others);
    ASSERT_TRUE(e) << a << "|" << b;
    std::string there = a;
    put_into(there, {*e});
    ASSERT_EQ(there, b) << a << "|" << b << "|" << c.lines.first << ".." << c.lines.last;
    take_back(there, {*e});
    ASSERT_EQ(there, a);
  }
}
TEST(WholeLines, AreWhatAnEditTouches) {
  std::mt19937 random(9);
  for (int i = 0; i < 20000; ++i) {
    std::string text;
    for (unsigned n = random() % 12; n > 0; --n) text += "ab\n"[random() % 3];
    const std::size_t at = random() % (text.size() + 1), size = random() % (text.size() - at + 1);
    TextEdit e{at, text.substr(at, size), ""};
    for (unsigned n = random() % 3; n > 0; --n) e.inserted += "xy\n"[random() % 3];
    const TextEdit whole = whole_lines(text, e);
    ASSERT_EQ(text.substr(whole.at, whole.removed.size()), whole.removed);
    ASSERT_TRUE(whole.at == 0 || text[whole.at - 1] == '\n');
    const std::size_t end = whole.at + whole.removed.size();
    ASSERT_TRUE(end == text.size() || end == 0 || text[end - 1] == '\n') << text << "|" << at << "+" << size;
    std::string one = text, other = text;
    put_into(one, {e}), put_into(other, {whole});
    ASSERT_EQ(one, other);
  }
}
TEST(Merge, TakesBothWhereTheyDoNotMeet) {
  const std::string base = "1\n2\n3\n4\n5\n6\n";
  EXPECT_EQ(merge(base, "1\nX\n3\n4\n5\n6\n", "1\n2\n3\n4\nY\n6\n7\n"), "1\nX\n3\n4\nY\n6\n7\n");
  EXPECT_EQ(merge(base, "1\nX\n3\n4\n5\n6\n", "1\nY\n3\n4\n5\n6\n"), std::nullopt);
  EXPECT_EQ(merge(base, base, "new\n"), "new\n");
  EXPECT_EQ(merge(base, "ours\n", base), "ours\n");
}

// Lines that are said together find their places one by one.
TEST(Placing, LinesOfOneStepAreEachInTheirPlace) {
  Session s;
  const std::string text =
      "rate 24\nrange 1f 24f\ncreate ball sphere radius=1\ncreate cube box position=(1 2 3)\n"
      "ball.position\n  1f (0 0 0)\n  12f (1 0 0)\n";
  s.begin(text, "film.bx");
  s.edit_in_place();
  ASSERT_TRUE(s.enter_together({"set ball.radius 2", "move ball.position 12f..12f by 3f", "range 1f 48f",
                                "set cube.position (3 2 1)", "create more sphere"})
                  .done);
  EXPECT_EQ(s.text(),
            "rate 24\nrange 1f 48f\ncreate ball sphere radius=2\ncreate cube box position=(3 2 1)\n"
            "ball.position\n  1f (0 0 0)\n  15f (1 0 0)\ncreate more sphere\n");
  EXPECT_TRUE(load_text(s.text(), "film.bx").document == s.document());
  ASSERT_TRUE(s.enter("undo").done);
  EXPECT_EQ(s.text(), text);
  ASSERT_TRUE(s.enter("redo").done);
  EXPECT_NE(s.text(), text);
  // Lines that build on each other.
  ASSERT_TRUE(s.enter_together({"create hand box", "couple ball to hand", "set ball.radius 3"}).done);
  EXPECT_TRUE(load_text(s.text(), "film.bx").document == s.document());
  EXPECT_TRUE(s.text().find("radius=3") != std::string::npos) << s.text();
}

}  // namespace
}  // namespace betwixt
