// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// A session must redo the commands that an earlier session did not save.
#include <rapidcheck.h>

#include <filesystem>
#include <random>

#include "betwixt/language.h"
#include "betwixt/session.h"
#include "editor/author.h"

namespace betwixt {
namespace {

// shows: G22
TEST(Session, NobodyAnsweringLosesNothing) {
  const Folder folder;
  {
    Session s = opened(folder);
    expect_done(s, "rate 25");
    EXPECT_TRUE(s.enter("quit").quit);
  }
  Session s;
  EXPECT_TRUE(s.open(folder / "film.bx", Session::Earlier::recover).done);
  EXPECT_EQ(s.text(), "rate 25\n");
}

// shows: G22
TEST(Session, AJournalOfAnotherTextIsKeptAside) {
  const Folder folder;
  folder.put("film.bx", author);
  {
    Session s = opened(folder);
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

// A command that cannot be carried out any more is set aside, with those that need it; the rest is recovered.
TEST(Session, WhatCannotBeRecoveredIsSetAside) {
  for (const bool in_place : {false, true}) {
    const Folder folder;
    folder.put("more.bx", "create extra sphere\n");
    folder.put("film.bx", "create ball sphere\n");
    {
      Session s;
      ASSERT_TRUE(s.open(folder / "film.bx").done);
      if (in_place) s.edit_in_place();
      for (const char* line : {"set ball.radius 2", "use more.bx", "set extra.radius 3", "undo", "hide extra",
                               "set ball.color red", "undo", "redo"})
        expect_done(s, line);
    }
    std::filesystem::remove(folder / "more.bx");
    Session s;
    const auto opened = s.open(folder / "film.bx", Session::Earlier::recover);
    ASSERT_TRUE(opened.done) << opened.said;
    EXPECT_NE(opened.said.find("2 commands of the history"), std::string::npos) << opened.said;
    EXPECT_TRUE(s.document() == load_text("create ball sphere\nset ball.radius 2\nset ball.color red\n", "").document)
        << s.text();
    EXPECT_EQ(s.unsaved(), 2U);
    const std::string aside = folder.get("film.bx.set-aside");
    EXPECT_NE(aside.find("\nuse more.bx\n"), std::string::npos) << aside;
    EXPECT_NE(aside.find("\nhide extra\n"), std::string::npos) << aside;
    EXPECT_EQ(aside.find("radius 3"), std::string::npos) << "it had been undone";
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
      Session s = opened(folder);
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

}  // namespace
}  // namespace betwixt
