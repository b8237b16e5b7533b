// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "editor/set_aside.h"

#include <gtest/gtest.h>

#include "betwixt/language.h"
#include "support/folder.h"

namespace betwixt {
namespace {

TEST(SetAside, KeepsEachOnceAsAScript) {
  const Folder folder;
  const std::string script = folder / "live.bx";
  const std::vector<SetAside> first = {{"command 2", {{"set ball.radius 2"}, ""}, "there is no 'ball'\nand more"},
                                       {"command 5", {{"  9f 3"}, "ball.radius\n  1f 2"}, "so it is"}};
  ASSERT_TRUE(set_aside(script, first));
  const std::string text =
      "# Set aside, command 2: there is no 'ball'\n# and more\nset ball.radius 2\n"
      "# Set aside, command 5: so it is\nball.radius\n  1f 2\n  9f 3\n";
  EXPECT_EQ(folder.get("live.bx.set-aside"), text);
  ASSERT_TRUE(set_aside(script, first));
  EXPECT_EQ(folder.get("live.bx.set-aside"), text) << "a start that was stopped does it again";
  ASSERT_TRUE(set_aside(script, std::vector<SetAside>{{"command 1", {{"hide ball"}, ""}, "why"}}));
  const std::string all = folder.get("live.bx.set-aside");
  EXPECT_EQ(all, text + "# Set aside, command 1: why\nhide ball\n");
  EXPECT_FALSE(has_errors(load_text("create ball sphere\n" + all, "").diagnostics));
}

// The lines that are wrong go, each with the rows below it; all else stays, byte for byte.
TEST(SetAside, TakesWrongLinesOutOfAText) {
  struct Case {
    const char *text, *left;
    std::vector<const char*> gone;
  };
  const Case cases[] = {
      {"rate 24\nset a.radius 2\nrate 25", "rate 24\nrate 25", {"set a.radius 2"}},
      {"create b sphere\nb.radius\n  1f 2\n  2f red\n  3f 4\n",
       "create b sphere\nb.radius\n  1f 2\n  3f 4\n",
       {"  2f red"}},
      {"a.radius\n  1f 2\n\n  2f 3\nrate 25\n", "rate 25\n", {"a.radius\n  1f 2\n\n  2f 3"}},
      {"# one\nset a.position (1\n2\n3)\n# two\n", "# one\n# two\n", {"set a.position (1\n2\n3)"}},
      {"hang a on b\nrate 25\nset c.radius 2", "rate 25\n", {"hang a on b", "set c.radius 2"}},
  };
  for (const Case& c : cases) {
    const auto mended = without_errors(c.text, "f", SIZE_MAX, load_text(c.text, "f").diagnostics);
    ASSERT_TRUE(mended) << c.text;
    EXPECT_EQ(mended->text, c.left);
    ASSERT_EQ(mended->lines.size(), c.gone.size()) << c.text;
    for (std::size_t i = 0; i < c.gone.size(); ++i) EXPECT_EQ(mended->lines[i].step.lines[0], c.gone[i]);
    EXPECT_FALSE(has_errors(load_text(mended->text, "f").diagnostics)) << mended->text;
  }
}

TEST(SetAside, LeavesWhatOthersWrote) {
  const std::string text = "set a.radius 2\nset b.radius 2\n";
  const Diagnostics errors = load_text(text, "f").diagnostics;
  EXPECT_TRUE(without_errors(text, "f", 16, errors));
  EXPECT_FALSE(without_errors(text, "f", 15, errors)) << "the second line is behind what may be changed";
  EXPECT_FALSE(without_errors(text, "g", SIZE_MAX, errors)) << "the errors are in another file";
  EXPECT_FALSE(without_errors(text, "f", SIZE_MAX, {}));
}

}  // namespace
}  // namespace betwixt
