// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// A program that shares all parts that an edit did not change must equal a program compiled from nothing.
#include <rapidcheck.h>

#include "betwixt/language.h"
#include "editor/author.h"
#include "support/plain_film.h"

namespace betwixt {
namespace {

void expect_one_program(const Document& d, const Program& shared, std::mt19937_64& random) {
  const Program alone = Program::compile(d);
  for (int k = 0; k < 6; ++k) {
    const Time t = d.rate().frame(0.5 * static_cast<double>(random() % 160));
    RC_ASSERT(differing(seen_alone(shared, t), seen_alone(alone, t)).empty());
    RC_ASSERT(same_frame(shared.frame(t), alone.frame(t)));
    RC_ASSERT(shared.next_change(t) == alone.next_change(t));
  }
}

TEST(Recompiling, SharesOnlyWhatIsTheSame) {
  EXPECT_TRUE(rc::check([] {
    const Folder folder;
    const auto seed = *rc::gen::arbitrary<std::uint64_t>();
    std::mt19937_64 random(seed);
    PlainFilm film(seed);
    Session s = opened(folder, film.script().c_str());
    Program program = Program::compile(s.document());
    for (int k = 0; k < 12; ++k) {
      static const char* const others[] = {"undo",
                                           "undo",
                                           "redo",
                                           "delete o3",
                                           "create o9 sphere radius=2",
                                           "at 20f o9.radius 3",
                                           "rename o4 p4",
                                           "procedure girth lua \"3\"",
                                           "procedure girth lua \"t\"",
                                           "set o2.scale = \"vec(girth(), #self, 1)\"",
                                           "set o5.position = \"vec(1, 2, 3)\"",
                                           "define heat number = 3",
                                           "layer sway add",
                                           "on sway at 10f o2.position (1 1 1)",
                                           "at 30f o1.position.velocity (1 0 0)",
                                           "at 3f o0.rotation (0 90deg 0)"};
      std::string lines = random() % 2 ? film.line() : others[random() % std::size(others)];
      if (!lines.ends_with('\n')) lines += '\n';
      for (std::size_t at = 0; at < lines.size(); at = lines.find('\n', at) + 1)
        s.enter(lines.substr(at, lines.find('\n', at) - at));
      s.enter("");
      program = Program::compile(s.document(), program);
      expect_one_program(s.document(), program, random);
    }
  }));
}

// Constant code is replaced by its value, which a procedure may change.
TEST(Recompiling, ConstantCodeFollowsItsProcedure) {
  const Folder folder;
  Session s = opened(folder, "film flat\ncreate a{1..2} circle\nprocedure girth lua \"2\"\n");
  s.enter("set a*.radius = \"girth() * i\"");
  Program program = Program::compile(s.document());
  const auto radius = [&](double seconds) {
    program = Program::compile(s.document(), program);
    return numbers(program.read(find_targets("a2.radius", s.document())->front(), from_seconds(seconds)))[0];
  };
  EXPECT_EQ(radius(0), 4);
  s.enter("create b circle");
  EXPECT_EQ(radius(0), 4);
  s.enter("procedure girth lua \"3\"");
  EXPECT_EQ(radius(0), 6);
  s.enter("procedure girth lua \"3 + t\"");
  EXPECT_EQ(radius(0), 6);
  EXPECT_EQ(radius(2), 10);
  s.enter("undo");
  EXPECT_EQ(radius(2), 6);
}

// The same of a text that is changed: what it has in common with the film before is shared, and no more.
TEST(Recompiling, OfATextSharesOnlyWhatIsTheSame) {
  EXPECT_TRUE(rc::check([] {
    const Folder folder;
    const auto seed = *rc::gen::arbitrary<std::uint64_t>();
    std::mt19937_64 random(seed);
    PlainFilm film(seed);
    Session s;
    s.edit_in_place();
    folder.put("film.bx", film.script().c_str());
    s.open(folder / "film.bx");
    Program program = Program::compile(s.document());
    for (int k = 0; k < 12; ++k) {
      std::vector<std::string> lines;
      const std::string text = s.text();
      for (std::size_t at = 0; at < text.size(); at = text.find('\n', at) + 1)
        lines.push_back(text.substr(at, text.find('\n', at) + 1 - at));
      const int at = 1 + static_cast<int>(random() % lines.size());
      const std::string& there = lines[random() % lines.size()];
      const int last = at - static_cast<int>(random() % 2);
      s.enter(Session::rewrite_line(at, last, random() % 3 == 0 ? "" : there));
      RC_ASSERT(load_text(s.text(), folder / "film.bx").document == s.document());
      program = Program::compile(s.document(), program);
      expect_one_program(s.document(), program, random);
    }
  }));
}

}  // namespace
}  // namespace betwixt
