// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Compares the estimated memory of undo with the memory that the allocator gets back when undo is dropped.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <malloc.h>

#include <functional>

#include "editor/editor.h"

namespace betwixt {
namespace {

double bytes_allocated() {
  malloc_trim(0);
  const auto all = mallinfo2();
  return static_cast<double>(all.uordblks + all.hblkhd);
}

// A sanitizer has an allocator of its own: it pads what is asked for, and this one stays without use.
bool padded() { return bytes_allocated() == 0; }

// Carries out the lines: the estimate agrees with the freed memory within a fifth.
void expect_about_right(const std::string& base, int lines, const std::function<std::string(int)>& line) {
  Editor editor;
  editor.begin(base, "");
  for (int i = 0; i < lines; ++i) {
    CommandResult result = editor.carry_out(editor.now(), line(i));
    ASSERT_TRUE(result.done) << line(i);
    ASSERT_TRUE(editor.take(std::move(result.after), {{result.line}, result.sheet}));
  }
  const double said = static_cast<double>(editor.undo_bytes());
  const Point now = editor.now();
  const double before = bytes_allocated();
  editor.begin("", "");
  const double freed = before - bytes_allocated();
  EXPECT_GT(said, freed * 0.8) << line(0);
  EXPECT_LT(said, freed * 1.2) << line(0);
}

TEST(UndoBytes, AreAboutWhatIsFreed) {
  if (padded()) GTEST_SKIP() << "sanitizers pad what is allocated";
  const std::string many = "create o{1..3000} sphere\n", ball = "create ball sphere\n";
  expect_about_right(many, 5, [](int i) { return fmt::format("set o*.radius {}", 2 + i); });
  expect_about_right(many, 100, [](int i) { return fmt::format("set o{}.radius 7", 1 + i); });
  expect_about_right(many, 100, [](int i) { return fmt::format("create q{} sphere", i); });
  expect_about_right(ball, 4, [](int i) { return fmt::format("create p{}-{{1..3000}} sphere", i); });
  expect_about_right(ball, 500, [](int i) { return fmt::format("set ball.radius {}", 2 + i); });
  expect_about_right(ball, 300,
                     [](int i) { return fmt::format("at {}f note \"a note that is not short {}\"", i + 1, i); });
  expect_about_right(ball, 300, [](int i) { return fmt::format("at {}t animate e every 1t by rotate(1deg, y)", i); });
}

TEST(UndoBytes, OfTracksToo) {
  if (padded()) GTEST_SKIP() << "sanitizers pad what is allocated";
  std::string track = "create ball sphere\nball.radius\n";
  for (int i = 1; i <= 5000; ++i) track += fmt::format("  {}f {}\n", i, i % 7 + 1);
  expect_about_right(track, 100, [](int i) { return fmt::format("at {}f set ball.radius 9", 6000 + i); });
  expect_about_right(track, 100, [](int i) { return fmt::format("at {}f set ball.radius 9", 10 + 40 * i); });
  expect_about_right(track, 10, [](int) { return "move ball.radius 1f..9000f by 1f"; });
}

TEST(UndoBytes, OfDisplayListsToo) {
  if (padded()) GTEST_SKIP() << "sanitizers pad what is allocated";
  const std::string list = "make l\n  tag x\n  point (0 0)\n";
  expect_about_right(list, 200,
                     [](int i) { return fmt::format("at {}t edit l\n  replace x\n  point ({} 0)", i + 1, i); });
  expect_about_right(list, 100,
                     [](int i) { return fmt::format("make l{}\n  point ({} 0)\n  vector (0 0) (1 1)", i, i); });
}

// A value of `points` with n points.
std::string points(int n, int last) {
  std::string all = "(";
  for (int k = 1; k < n; ++k) all += fmt::format("({} 0 {}) ", k, k % 7);
  return all + fmt::format("({} 0 0))", last);
}

TEST(UndoBytes, OfWhatValuesHold) {
  if (padded()) GTEST_SKIP() << "sanitizers pad what is allocated";
  const std::string cap = "create cap text text=\"a\"\n", line = "create c{1..50} curve points=((0 0 0) (1 1 1))\n";
  const std::string ball = "create ball sphere\n", many = "create o{1..2000} sphere\n";
  expect_about_right(cap, 200, [](int i) { return fmt::format("set cap.text \"n{}\"", i); });
  expect_about_right(cap, 200, [](int i) { return fmt::format("set cap.text \"{}{}\"", std::string(1000, 'x'), i); });
  expect_about_right(line, 100, [](int i) { return fmt::format("set c1.points {}", points(1000, i)); });
  expect_about_right(line, 20, [](int i) { return fmt::format("set c*.points {}", points(100, i)); });
  expect_about_right(line, 20, [](int i) { return fmt::format("set c*.points ((i 0 0) ({} 0 0))", i); });
  expect_about_right(line, 100, [](int i) { return fmt::format("at {}f c1.points {}", i + 1, points(100, i)); });
  expect_about_right(ball, 200, [](int i) { return fmt::format("set ball.radius = \"return {} + t * 2\"", i); });
  expect_about_right(many, 3, [](int i) { return fmt::format("set o*.radius = \"return t + {}\"", i); });
  expect_about_right(many, 3, [](int i) { return fmt::format("set o*.position (i {} 0)", i); });
}

TEST(UndoBytes, OfManySmallTracks) {
  if (padded()) GTEST_SKIP() << "sanitizers pad what is allocated";
  const std::string many = "create o{1..2000} sphere\no*.position\n  1f (0 0 0)\n  24f (1 0 0) linear\n";
  expect_about_right(many, 200, [](int i) { return fmt::format("at 12f o{}.position (1 0 0)", i + 1); });
  expect_about_right(many, 3, [](int i) { return fmt::format("at {}f o*.position (1 0 0)", i + 30); });
  expect_about_right(many, 3, [](int) { return "scale o*.position 1f..24f (1 2 1)"; });
  expect_about_right(many, 100, [](int i) { return fmt::format("filter o{}.position delay by=6f", i + 1); });
  expect_about_right(many, 100, [](int i) { return fmt::format("create q{} like o1", i); });
  expect_about_right(many, 100, [](int i) { return fmt::format("rename o{} p{}", i + 1, i + 1); });
  expect_about_right(many, 1, [](int) { return "remove o{1..1999}"; });
}

TEST(UndoBytes, OfWhatIsCopiedAsAWhole) {
  if (padded()) GTEST_SKIP() << "sanitizers pad what is allocated";
  const std::string base = "create o{1..500} sphere\ncreate eye camera\n";
  expect_about_right(base, 100, [](int i) { return fmt::format("alias a{} = o{{1..{}}}", i, i + 100); });
  expect_about_right(base, 200, [](int i) { return fmt::format("let a{} = \"{}\"", i, std::string(200, 'x')); });
  expect_about_right(base, 100, [](int i) { return fmt::format("define d{} number", i); });
  expect_about_right(base, 100, [](int i) { return fmt::format("procedure p{} lua \"return {}\"", i, i); });
  expect_about_right(base, 200, [](int i) { return fmt::format("dial /fader/{} to o{}.radius", i, i + 1); });
  expect_about_right(base, 200, [](int i) { return fmt::format("at {}f look through eye", i + 1); });
  expect_about_right("make l\n  point (0 0)\n", 100, [](int i) { return fmt::format("edit l\n  point ({} 0)", i); });
}

// Undone steps are kept for redo.
TEST(UndoBytes, OfWhatWasUndone) {
  if (padded()) GTEST_SKIP() << "sanitizers pad what is allocated";
  Editor editor;
  editor.begin("create c curve points=((0 0 0) (1 1 1))\n", "");
  for (int i = 0; i < 100; ++i) {
    CommandResult result = editor.carry_out(editor.now(), i % 2 ? fmt::format("set c.points {}", points(1000, i))
                                                                : fmt::format("create p{}-{{1..200}} sphere", i));
    ASSERT_TRUE(result.done);
    ASSERT_TRUE(editor.take(std::move(result.after), {{result.line}, ""}));
  }
  const std::size_t standing = editor.undo_bytes();
  for (int i = 0; i < 100; ++i) ASSERT_TRUE(editor.undo());
  const double said = static_cast<double>(editor.undo_bytes());
  for (int i = 0; i < 100; ++i) ASSERT_TRUE(editor.redo());
  EXPECT_EQ(editor.undo_bytes(), standing);
  for (int i = 0; i < 100; ++i) ASSERT_TRUE(editor.undo());
  const Point now = editor.now();
  const double before = bytes_allocated();
  editor.begin("", "");
  const double freed = before - bytes_allocated();
  EXPECT_GT(said, freed * 0.8);
  EXPECT_LT(said, freed * 1.2);
}

}  // namespace
}  // namespace betwixt
