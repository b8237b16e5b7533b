// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests sessions: they carry out lines one by one, and can undo them.
#include "betwixt/session.h"

#include <rapidcheck.h>

#include "betwixt/program.h"
#include "editor/author.h"
#include "scene/document.h"
#include "support/loaded_film.h"

namespace betwixt {
namespace {

// shows: G22 G60
TEST(Session, UndoAndRedoWalkThroughAllDocuments) {
  const Folder folder;
  Session s = opened(folder);
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
  Session s = opened(folder);
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

TEST(Session, WithoutAJournalItBeginsWithATextAndSaysWhereALineIsWrong) {
  const Folder folder;
  Session s;
  s.begin("create ball sphere\nset ball.radius red\n", folder / "film.bx");
  ASSERT_EQ(s.diagnostics().size(), 1u);
  EXPECT_EQ(s.diagnostics()[0].what.place.line, 2);
  expect_done(s, "set ball.radius 2");
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
  const auto one = s.enter("set ball.radis 3");
  ASSERT_EQ(one.why.size(), 1u);
  EXPECT_EQ(one.why[0].what.place.line, 1);
  EXPECT_EQ(one.why[0].caret, 9);
  EXPECT_EQ(to_string(one.why[0]).substr(0, 13), "1:10: error: ");
  // The error has the number of its line. Lines before it may have several lines of text.
  const auto several = s.enter_together({"set ball.position (1 2\n3)", "set bal.radius 2"});
  ASSERT_EQ(several.why.size(), 1u);
  EXPECT_EQ(several.why[0].what.place.line, 3);
  EXPECT_EQ(several.why[0].what.hint, "did you mean 'ball'?");
  expect_done(s, "undo");
  const auto none = s.enter("undo");
  ASSERT_EQ(none.why.size(), 1u);
  EXPECT_EQ(none.why[0].what.message, "there is nothing to undo");
}

// shows: G59
TEST(Session, NoCommandSwitchesAContext) {
  const Folder folder;
  Session s = opened(folder);
  // Each line names its objects, so other lines of any kind may come between two lines.
  for (const char* line : {"create a sphere", "create b box", "set a.radius 2", "list", "set b.size (1 2 3)",
                           "help set", "at 5f a.position (1 0 0)", "describe b", "at 5f b.position (0 1 0)"})
    expect_done(s, line);
  EXPECT_EQ(s.text(),
            "create a sphere\ncreate b box\nset a.radius 2\nset b.size (1 2 3)\nat 5f a.position (1 0 0)\n"
            "at 5f b.position (0 1 0)\n");
  // Questions between the rows of a sheet do not end it either.
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
  Session::Callbacks callbacks = answering({});
  callbacks.play = [&](const Document& d, const std::string& frames) {
    shown = d, asked = frames;
    return Status(Nothing{});
  };
  callbacks.plot = [&](const Document& d, const std::string& target, const std::string&) {
    shown = d, asked = target;
    return Status(Nothing{});
  };
  Session s = opened(folder, author, std::move(callbacks));
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

// shows: G22 G104
TEST(Session, LayersAreListedWithWhatIsOnThem) {
  const Folder folder;
  Session s =
      opened(folder,
             "create ball sphere\nlayer sway add weight=0.5\non sway ball.position\n  1f (0 0 0)\n  9f (1 0 0)\n"
             "at 1f sway.weight 0.25\n");
  EXPECT_EQ(s.enter("list").said, "ball  sphere    0 events\nsway  layer     3 events\n");
  EXPECT_NE(s.enter("describe sway").said.find("  on ball.position 2 events\n"), std::string::npos);
  EXPECT_EQ(s.enter("describe ball.radius").said, "ball.radius  1\n");
  EXPECT_EQ(s.enter("describe sway.weight").said, "sway.weight\n  1f       0.25\n");
  // Rows below a refused sheet of a layer are refused.
  EXPECT_TRUE(s.enter("on swey ball.position").refused);
  EXPECT_EQ(s.enter("  1f (0 0 0)").said,
            "error: this row has no sheet, because the line that should open it has an error\n");
}

// shows: G22
TEST(Session, SaysWhatValuesAreAtTimes) {
  const Folder folder;
  Session s = opened(folder, author);
  EXPECT_EQ(s.enter("eval ball.position.x at 24f").said, "ball.position.x  8\n");
  EXPECT_EQ(s.enter("eval ball.position 1f,24f").said,
            "1f (0 s)\n  ball.position  (0 10 0)\n24f (0.9583333333333334 s)\n  ball.position  (8 10 0)\n");
  EXPECT_EQ(s.enter("eval ball.position").said, "ball.position  (0 10 0)\n");
  EXPECT_TRUE(
      s.enter("eval ball at 24f")
          .said.ends_with("ball.world     matrix(1 0 0 8 0 1 0 10 0 0 1 0 0 0 0 1)\nball is at     (8 10 0)\n"));
  const std::string unknown = s.enter("eval bal at 1f").said;
  EXPECT_TRUE(unknown.starts_with("error: ") && unknown.ends_with("'bal'\n  did you mean 'ball'?\n")) << unknown;
  EXPECT_TRUE(s.enter("eval ball at 12x").refused);
  EXPECT_EQ(s.unsaved(), 0u);
  expect_done(s, "set ball.radius = \"nix.y\"");
  EXPECT_NE(s.enter("eval ball.radius at 1f").said.find("warning: ball.radius: the procedure"), std::string::npos);
}

TEST(Session, ExitIsQuit) {
  const Folder folder;
  EXPECT_TRUE(opened(folder).enter("exit").quit);
}

TEST(Session, SaysHowManyAPatternNamesUnlessItIsQuiet) {
  const Folder folder;
  Session s = opened(folder, author);
  EXPECT_EQ(s.enter("create p{1..7} box position=(i 0 0)").said, "7 objects\n");
  EXPECT_EQ(s.enter("set p{2..4}.color red").said, "3 objects\n");
  EXPECT_EQ(s.enter("set ball.color red").said, "");
  EXPECT_EQ(s.enter("set p7.color hsv(i/n 1 1)").said, "");
  folder.put("more.bx", "create q{1..3} box\nset q*.color red\n");
  EXPECT_EQ(s.enter("use more.bx").said, "");  // whatever its lines are about
  s.keep_quiet();
  EXPECT_EQ(s.enter("create r{1..7} box").said, "");
}

// shows: G7 G13
TEST(Session, TheWayOfDrawingIsAWord) {
  const Folder folder;
  std::string told;
  Session::Callbacks callbacks;
  callbacks.set_play_option = [&](const std::string& what, const std::string& value) -> Result<std::string> {
    if (value == "cubist") return fail(ErrorCode::name, "there is no style 'cubist'");
    told += what + " " + value + "; ";
    return std::string("as said\n");
  };
  Session s = opened(folder, author, std::move(callbacks));
  for (const char* line : {"style wireframe", "samples 16", "size 320x180", "style"})
    EXPECT_EQ(s.enter(line).said, "as said\n") << line;
  EXPECT_EQ(told, "style wireframe; samples 16; size 320x180; style ; ");
  EXPECT_TRUE(s.enter("style cubist").refused);
  EXPECT_TRUE(s.enter("style shaded now").refused);
  EXPECT_EQ(s.unsaved(), 0u);
}

// shows: G27
TEST(Session, PolicyAskAsks) {
  const Folder folder;
  std::string asked;
  Session::Callbacks callbacks;
  callbacks.ask_about_line = answering({"t", "ignore", "translate", std::string(Session::called_off)}, &asked).ask;
  Session s = opened(folder, author, std::move(callbacks));
  EXPECT_TRUE(s.enter("set ball.radius (3 4 0)").done);
  EXPECT_NE(asked.find(read("create ball sphere\nset ball.radius (3 4 0)\n").diagnostics[0].what.message),
            std::string::npos)
      << asked;
  EXPECT_TRUE(asked.ends_with("it can be translated to 'set ball.radius 5': translate or ignore? ")) << asked;
  const std::string before = s.text();
  EXPECT_TRUE(before.ends_with("\nset ball.radius 5\n"));
  EXPECT_EQ(s.enter("set ball.rotation.x 90").said, "ignored\n");
  EXPECT_EQ(s.text(), before);
  expect_done(s, "ball.color");
  expect_done(s, "  3f 0.25 linear");  // a row stays a row, and what follows on it stays
  EXPECT_TRUE(s.text().ends_with("ball.color\n  3f rgb(0.25 0.25 0.25) linear\n")) << s.text();
  const auto off = s.enter("  5f 1");
  EXPECT_FALSE(off.done || off.refused);
  // There is no question if no translation helps, or if the script has another policy.
  asked.clear();
  EXPECT_TRUE(s.enter("set ball.radius 2kg").refused);
  expect_done(s, "policy translate");
  expect_done(s, "set ball.radius (3 4 0)");
  EXPECT_TRUE(s.text().ends_with("\nset ball.radius (3 4 0)\n"));
  EXPECT_EQ(asked, "");
  EXPECT_FALSE(has_errors(load_text(s.text(), "film.bx").diagnostics));
  // A batch session, in which no person answers.
  Session batch = opened(folder, author, answering({"translate"}));
  EXPECT_TRUE(batch.enter("set ball.radius (3 4 0)").refused);
}

// An error in code is reported at once, with its line, and only once.
TEST(Session, CodeIsTriedAsItIsSaid) {
  const Folder folder;
  Session s = opened(folder, author);
  expect_done(s, "show ball");
  const auto said = s.enter("at 9f ball.radius = \"nix.y\"");
  EXPECT_TRUE(said.done);
  EXPECT_TRUE(said.said.starts_with("line:2:22: warning: ball.radius: the procedure \"nix.y\" gives no value"))
      << said.said;
  EXPECT_NE(said.said.find("\n  at 9f ball.radius = \"nix.y\"\n                       ^~~~~\n"), std::string::npos)
      << said.said;
  EXPECT_EQ(s.enter("hide ball").said, "");
  expect_done(s, "procedure worse filter lua \"input() + nix\"");
  EXPECT_TRUE(s.enter("filter ball.position.y worse").said.starts_with("line:5:1: warning: ")) << s.enter("list").said;
  EXPECT_EQ(s.enter("set ball.shininess = \"0.5\"").said, "");
  // The same error of many objects is reported once.
  expect_done(s, "create b{1..17} sphere");
  const std::string many = s.enter("set b*.radius = \"nix.y\"").said;
  EXPECT_NE(many.find("likewise 16 others: b2.radius"), std::string::npos) << many;
  EXPECT_EQ(many.find("warning:"), many.rfind("warning:")) << many;
}

TEST(Session, WhatARefusedLineShouldHaveMade) {
  const Folder folder;
  Session s = opened(folder);
  EXPECT_TRUE(s.enter("create ball sphre").refused);
  EXPECT_NE(s.enter("set ball.radius 2").said.find("line 1, which should have created it, has an error"),
            std::string::npos);
  expect_done(s, "create ball sphere");
  expect_done(s, "set ball.radius 2");
  EXPECT_EQ(s.enter("set ball.radus 2").said.find("was refused"), std::string::npos);
}

// shows: G59
TEST(Session, RenamingKeepsWhatAPatternOfAnAliasMeant) {
  const LoadedFilm s(
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
    Session s = opened(folder);
    for (const auto& line : *rc::gen::arbitrary<std::vector<std::string>>()) {
      s.enter(line);
      s.complete(line);
      Session::needs_more(line);
    }
    RC_ASSERT(load_text(s.text(), folder / "film.bx").document == s.document());
  }));
}

// shows: C28 C69 C71
TEST(DisplayList, A_host_that_edits_again_and_again_makes_nothing_grow) {
  Session session;
  const auto enter = [&](const std::string& line) {
    const auto a = session.enter(line);
    EXPECT_TRUE(a.done) << line << "\n" << a.said;
  };
  enter("make ball");
  enter("  polygon (0 0) (1 0) (0 1)");
  enter("make all");
  enter("  begin spin");  // its end is still to come
  enter("  tag here");
  enter("  translate(0 0 0)");
  enter("  call ball");
  enter("  tag what");
  enter("  call ball");
  enter("  end");
  enter("start all");
  enter("create moon sphere");
  enter("couple moon to all/spin-1/ball-1");
  const ObjectId ball = session.document().find("all/spin-1/ball-1");
  std::size_t size = 0;
  for (int i = 0; i < 200; ++i) {
    enter("edit all");
    enter("  replace here");
    enter(fmt::format("  translate({} 0 0)", i));
    enter("  replace what");
    enter(i % 3 == 0 ? "  text \"x\"" : i % 3 == 1 ? "  point (0 0)" : "  call ball");
    if (i == 3) size = session.document().scene().objects.size();
  }
  EXPECT_EQ(session.document().scene().objects.size(), size);
  EXPECT_EQ(session.document().find("all/spin-1/ball-1"), ball);
  EXPECT_EQ(translation_of(*std::get<Matrix>(
                Program::compile(session.document()).read({session.document().find("moon"), Query::world}, {}))),
            (Vec3{199, 0, 0}));
  // A line that shows an incomplete object gives a message.
  enter("make open");
  enter("  push");
  enter("  tag x");
  EXPECT_EQ(session.enter("start open").said,
            "line:1017:7: warning: in 'open': the 'pop' of this 'push' is missing\n  start open\n        ^~~~\n");
  EXPECT_TRUE(session.enter("make ball").refused);
  EXPECT_TRUE(session.enter("  point (0 0)").refused);
  EXPECT_TRUE(session.enter("undo").done);
}

TEST(LaterLists, A_session_writes_edits_row_by_row_and_takes_them_back) {
  Session session;
  const auto enter = [&](const std::string& line) {
    const auto a = session.enter(line);
    EXPECT_TRUE(a.done) << line << "\n" << a.said;
    return a.said;
  };
  const auto shown = [&](int frame) {
    const Program program = Program::compile(session.document());
    const Scene& scene = session.document().scene();
    std::size_t n = 0;
    for (const ObjectId id : *scene.expansion)
      n += drawable(scene.objects[id.index].kind) &&
           std::get<bool>(program.read({id, fn::display}, Rate{}.frame(frame)));
    return n;
  };
  enter("make a");
  enter("  tag x");
  enter("  point (0 0)");
  enter("start a");
  enter("at 12f edit a");
  enter("  replace x");
  enter("  vector (0 0) (1 1)");
  enter("  vector (0 0) (2 2)");
  EXPECT_EQ(shown(11), 1u);
  EXPECT_EQ(shown(12), 2u);
  EXPECT_EQ(enter("describe a"),
            "a, a display list, the main object\n  tag x\n  point (0 0)\nfrom 12f\n  tag x\n  vector (0 0) (1 1)\n"
            "  vector (0 0) (2 2)\n");
  EXPECT_EQ(enter("list a"), "a  list      1 row, 2 versions\na  group     0 events\n");
  EXPECT_TRUE(load_text(session.text(), "test.bx").document == session.document()) << session.text();
  enter("undo");
  EXPECT_EQ(shown(12), 1u);
  enter("undo");
  enter("undo");
  EXPECT_TRUE(session.document().scene().later_lists->empty());
  // Rows below a refused line are refused.
  EXPECT_TRUE(session.enter("at 12f edit b").refused);
  EXPECT_TRUE(session.enter("  point (0 0)").refused);
}

TEST(Session, WordsInBracesAreOne) {
  const Folder folder;
  Session s = opened(folder, "rate 24\ncreate {a,b} sphere radius=2\ncreate c sphere\n");
  EXPECT_EQ(s.enter("eval {a,b}.radius").said, "a.radius  2\nb.radius  2\n");
  EXPECT_EQ(s.enter("describe {a,b}").said.find("there is no"), std::string::npos);
}

TEST(Session, ARefusedLineAboutWhatIsThereWouldHaveMadeNothing) {
  const Folder folder;
  Session s = opened(folder, "rate 24\n");
  expect_done(s, "layer sway add");
  EXPECT_FALSE(s.enter("layer sway add").done);
  expect_done(s, "remove sway");
  EXPECT_EQ(s.enter("rename sway swing").said.find("which should have created it"), std::string::npos);
  EXPECT_FALSE(s.enter("layer lean add weight=oops").done);
  EXPECT_NE(s.enter("rename lean swing").said.find("line 5, which should have created it"), std::string::npos);
  expect_done(s, "layer lean add");
  expect_done(s, "remove lean");
  EXPECT_EQ(s.enter("rename lean swing").said.find("which should have created it"), std::string::npos);
}

}  // namespace
}  // namespace betwixt
