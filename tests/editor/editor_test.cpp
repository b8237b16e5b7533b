// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "editor/editor.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "betwixt/language.h"
#include "editor/history.h"

namespace betwixt {
namespace {

Status say(Editor& editor, const std::string& line) {
  CommandResult result = editor.carry_out(editor.now(), line);
  EXPECT_TRUE(result.done) << line;
  return editor.take(std::move(result.after), {{result.line}, result.sheet});
}

TEST(Editor, CarryingOutChangesNothing) {
  Editor editor;
  editor.begin("create ball sphere\n", "");
  const Document before = editor.now().document;
  EXPECT_TRUE(editor.carry_out(editor.now(), "set ball.radius 2").done);
  const CommandResult wrong = editor.carry_out(editor.now(), "set ball.radius two");
  EXPECT_FALSE(wrong.done);
  ASSERT_EQ(wrong.said.size(), 1u);
  EXPECT_EQ(wrong.said[0].what.place.file, "");
  EXPECT_EQ(wrong.said[0].what.place.line, 1);
  EXPECT_EQ(wrong.said[0].what.place.column, 17);
  EXPECT_TRUE(editor.now().document == before);
  EXPECT_TRUE(editor.steps().empty());
}

// What cannot be kept is not done, nor taken back, nor done again.
TEST(Editor, NothingIsDoneThatItsSinkCannotKeep) {
  Editor editor;
  editor.begin("", "");
  bool full = false;
  std::string told;
  editor.keep([&](Did what, const Step& step) -> Status {
    if (full) return fail(ErrorCode::machine, "the disk is full");
    told += static_cast<char>(what) + step.lines[0] + std::to_string(editor.steps().size() - (what == Did::undo)) + " ";
    return Nothing{};
  });
  EXPECT_TRUE(say(editor, "rate 25"));
  EXPECT_TRUE(say(editor, "rate 30"));
  EXPECT_TRUE(editor.undo());
  full = true;
  const Document before = editor.now().document;
  for (const Status& s : {say(editor, "rate 12"), editor.undo(), editor.redo()})
    EXPECT_EQ(s.error().message, "the disk is full");
  EXPECT_TRUE(editor.now().document == before);
  full = false;
  EXPECT_TRUE(editor.redo());
  EXPECT_EQ(told, "crate 250 crate 301 urate 301 rrate 301 ");
}

TEST(Editor, SheetsOfSeveralAuthorsStandSideBySide) {
  Editor editor;
  editor.begin("create {a,b} sphere\n", "");
  std::shared_ptr<const OpenSheet> sheets[2];
  const auto enter = [&](int who, const std::string& line) {
    Point from = editor.now();
    from.script.left = sheets[who];
    CommandResult result = editor.carry_out(from, line);
    EXPECT_TRUE(result.done) << line;
    sheets[who] = result.after.script.left;
    if (result.opens) return;
    EXPECT_TRUE(editor.take(std::move(result.after), {{result.line}, result.sheet}));
  };
  enter(0, "a.radius");
  enter(1, "b.radius");
  enter(0, "  1f 2");
  enter(1, "  1f 3");
  enter(1, "  9f 4");
  EXPECT_EQ(as_script("", editor.steps()), "a.radius\n  1f 2\nb.radius\n  1f 3\n  9f 4\n");
  EXPECT_TRUE(load_text(as_script(editor.base(), editor.steps()), "").document == editor.now().document);
}

// What rows go to while others change what names mean: the text that has the sheet's line above each row says it.
TEST(Editor, ASheetMeansWhatItsLineWouldMeanNow) {
  Editor editor;
  editor.begin("create b1 sphere\nmake l\n  tag x\n  point (0 0)\nstart l\n", "");
  std::string text = editor.base();
  std::shared_ptr<const OpenSheet> sheet;  // of one; the other says whole commands
  const auto row = [&](const std::string& line) {
    Point from = editor.now();
    from.script.left = sheet;
    CommandResult result = editor.carry_out(from, line);
    if (!result.done) return result.said.at(0).what.message;
    if (line[0] == ' ') text += result.sheet + "\n";
    text += line + "\n";
    sheet = result.after.script.left;
    EXPECT_TRUE(editor.take(std::move(result.after), {{result.line}, result.sheet}));
    EXPECT_TRUE(load_text(text, "").document == editor.now().document) << text;
    return std::string();
  };
  const auto other = [&](const std::string& line) {
    EXPECT_TRUE(say(editor, line));
    text += line + "\n";
  };
  for (const char* line : {"b*.radius", "  1f 2"}) EXPECT_EQ(row(line), "");
  other("at 5f b1.radius 3");
  EXPECT_EQ(row("  9f 4"), "");
  other("create b2 sphere");
  EXPECT_EQ(row("  10f 4"), "");
  EXPECT_EQ(row("b1.position"), "");
  EXPECT_EQ(row("  1f (1 0 0)"), "");
  other("rename b1 moon");
  EXPECT_NE(row("  2f (2 0 0)"), "");
  for (const char* line : {"edit l", "  replace x", "  point (1 0)"}) EXPECT_EQ(row(line), "");
  other("make m");
  EXPECT_EQ(row("  point (2 0)"), "");
  other("at 9f edit l");
  EXPECT_EQ(row("  point (3 0)"), "");
  other("delete l");
  EXPECT_NE(row("  point (4 0)"), "");
}

// LoadOptions::now: what is stamped where, and that the history makes the same document without it.
TEST(Editor, WhatHappensNowStandsWithItsTime) {
  Editor editor;
  editor.begin(
      "create ball sphere\nprocedure both command lua \"run('animate f every 2t by rotate(1deg, y)')\"\nmake l\n  "
      "point (0 0)\n",
      "");
  const Time now = Rate{30, 1}.span(7);
  const auto enter = [&](const std::string& line, const std::string& stands, bool stamped) {
    CommandResult result = editor.carry_out(editor.now(), line, now);
    ASSERT_TRUE(result.done) << line << ": " << result.said.at(0).what.message;
    EXPECT_EQ(result.line, stands);
    EXPECT_EQ(result.stamped, stamped) << line;
    EXPECT_TRUE(editor.take(std::move(result.after), {{result.line}, result.sheet}));
    const Loaded again = load_text(as_script(editor.base(), editor.steps()), "");
    EXPECT_EQ(has_errors(again.diagnostics), line.starts_with("  begin")) << line;  // its end is still to come
    EXPECT_TRUE(again.document == editor.now().document) << line;
  };
  enter("  animate  e every 1t by rotate(1deg, y)", "at 7t animate  e every 1t by rotate(1deg, y)", true);
  enter("set  ball.environments (e)  # in", "at 7t ball.environments (e)  # in", true);
  enter("set ball.drive (e)", "at 7t ball.drive (e)", true);
  enter("set ball.radius 2", "set ball.radius 2", false);
  enter("at 9t halt e", "at 9t halt e", false);
  enter("halt x*", "at 7t halt x*", true);
  enter("both", "both", false);
  enter("edit l", "edit l", false);
  enter("  begin e  # here", "  begin e since 7t  # here", false);
  enter("  end", "  end", false);
}

// Whatever is done, taken back and done again: what stands makes the document.
TEST(Editor, WhatStandsMakesTheDocument) {
  EXPECT_TRUE(rc::check([] {
    const auto depth = *rc::gen::inRange<std::size_t>(1, 5);
    Editor editor({}, {.steps = depth});
    editor.begin("create ball sphere\n", "");
    std::vector<std::string> standing, undone;
    std::size_t known = 0;  // documents that can be gone back to
    for (const int what : *rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 6))) {
      if (what < 3) {
        standing.push_back(fmt::format("set ball.radius {}", standing.size() + 2 + static_cast<std::size_t>(what)));
        undone.clear();
        RC_ASSERT(static_cast<bool>(say(editor, standing.back())));
        known = std::min(known + 1, depth);
      } else if (what < 5) {
        RC_ASSERT(static_cast<bool>(editor.undo()) == (known > 0));
        if (known == 0) continue;
        undone.push_back(standing.back()), standing.pop_back(), --known;
      } else {
        RC_ASSERT(static_cast<bool>(editor.redo()) == !undone.empty());
        if (undone.empty()) continue;
        standing.push_back(undone.back()), undone.pop_back(), ++known;
      }
      std::string text = "create ball sphere\n";
      for (const std::string& line : standing) text += line + "\n";
      RC_ASSERT(as_script(editor.base(), editor.steps()) == text);
      RC_ASSERT(load_text(text, "").document == editor.now().document);
      RC_ASSERT(editor.undone().size() == undone.size());
    }
  }));
}

// Steps that cannot be undone share one copy of the document. The result is the same as with a copy for each.
TEST(Editor, RestoringAtOnceIsLikeOneByOne) {
  EXPECT_TRUE(rc::check([] {
    const auto pick = [](int n) { return *rc::gen::inRange(0, n); };
    std::vector<Step> steps;
    for (int k = 0; k < 30; ++k) {
      const std::string o = fmt::format("o{}", pick(4)), sheet = fmt::format("{}.radius", o);
      const Step all[] = {{{fmt::format("create {} sphere", o)}, ""},
                          {{fmt::format("set {}.radius {}", o, 1 + pick(9))}, ""},
                          {{fmt::format("  {}f {}", pick(9), 1 + pick(9))}, sheet},
                          {{fmt::format("  {}f red", pick(9))}, sheet},
                          {{fmt::format("remove {}", o)}, ""},
                          {{fmt::format("create {} box", o), fmt::format("hide {}", o), "hide o2"}, ""},
                          {{"# a remark"}, ""},
                          {{fmt::format("let a{} = {}", k, pick(9))}, ""},
                          {{fmt::format("make l{}", pick(2)), "  point (0 0)"}, ""}};
      steps.push_back(all[pick(static_cast<int>(std::size(all)))]);
    }
    const std::size_t standing = static_cast<std::size_t>(20 + pick(11));
    Editor at_once({}, {static_cast<std::size_t>(pick(10)), UndoLimits::without_limit}), one_by_one;
    at_once.begin("create o0 sphere\n", ""), one_by_one.begin("create o0 sphere\n", "");
    const auto left_out = at_once.restore(steps, standing), expected = one_by_one.restore(steps, standing);
    RC_ASSERT(left_out.size() == expected.size());
    for (std::size_t i = 0; i < left_out.size(); ++i) {
      RC_ASSERT(left_out[i].number == expected[i].number);
      RC_ASSERT(has_errors(left_out[i].why));
    }
    RC_ASSERT(std::ranges::equal(at_once.steps(), one_by_one.steps()));
    RC_ASSERT(at_once.now().document == one_by_one.now().document);
    RC_ASSERT(load_text(as_script(at_once.base(), at_once.steps()), "").document == at_once.now().document);
  }));
}

// A command that happens now gets its time in the history, so it is refused beyond the limit of time.
TEST(Editor, NothingHappensBeyondAllTimes) {
  Editor editor;
  editor.begin("create ball sphere\n", "");
  for (const double seconds : {-4.61e9, -4.6e9, -1.0, 4.6e9, 4.61e9}) {
    const CommandResult result = editor.carry_out(editor.now(), "set ball.drive (e)", from_seconds(seconds));
    EXPECT_EQ(result.done, std::abs(seconds) <= 4.6e9) << seconds;
    if (result.done) {
      EXPECT_TRUE(editor.carry_out(editor.now(), result.line).done) << result.line;
    } else {
      EXPECT_EQ(result.said.back().what.code, ErrorCode::range);
    }
    EXPECT_TRUE(editor.carry_out(editor.now(), "set ball.radius 2", from_seconds(seconds)).done);
  }
}

// A part that documents copy as a whole is copied for the first line of a draft that changes it, and not again.
TEST(Editor, ADraftCopiesEachPartOnce) {
  Editor editor;
  editor.begin("create {a,b} sphere\nmake l\n  point (0 0)\nstart l\n", "");
  const Document before = editor.now().document;
  Editor::Draft draft(editor, editor.now());
  const auto say = [&](const std::string& line) {
    const CommandResult result = draft.carry_out(line, Time{});
    EXPECT_TRUE(result.done) << line;
    return result.line;
  };
  std::string said;
  const void* parts[5] = {};
  for (int i = 0; i < 4; ++i) {
    for (const std::string& line :
         {fmt::format("at {}f note \"{}\"", 9 - i, i), fmt::format("alias a{} = a b", i), fmt::format("let n{} = 2", i),
          fmt::format("define f{} number n{}", 3 - i, i), std::string("a.position"),
          fmt::format("  {}f (1 2 3)", 2 + i), fmt::format("make l{}", i), std::string("  point (0 0)"),
          std::string("  point (1 0)")})
      said += say(line) + "\n";
    const Scene& s = draft.scene();
    const void* const now[] = {&*s.notes, &*s.aliases, &*s.lets, &*s.defined, &*s.lists};
    for (int k = 0; k < 5; ++k) EXPECT_TRUE(i == 0 || parts[k] == now[k]) << k;
    std::copy(std::begin(now), std::end(now), parts);
  }
  EXPECT_TRUE(draft.sheet_is_open());
  draft.close_sheet();
  EXPECT_FALSE(draft.carry_out("  point (2 0)", Time{}).done);
  const Document after = std::move(draft).point().document;
  EXPECT_TRUE(after == load_text(write(before) + said, "").document);
  EXPECT_TRUE(editor.now().document == before);
}

}  // namespace
}  // namespace betwixt
