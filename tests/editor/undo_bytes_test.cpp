// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What undo is thought to keep, beside what the allocator gets back when it is forgotten.
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

// Says so many lines; the estimate may be half of what is freed, or twice as much, but not further off.
void expect_about_right(const std::string& base, int lines, const std::function<std::string(int)>& line) {
  Editor editor;
  editor.begin(base, "");
  for (int i = 0; i < lines; ++i) {
    Deed deed = editor.carry_out(editor.now(), line(i));
    ASSERT_TRUE(deed.done) << line(i);
    ASSERT_TRUE(editor.take(std::move(deed.after), {{deed.line}, deed.sheet}));
  }
  const double said = static_cast<double>(editor.undo_bytes());
  const Point now = editor.now();
  const double before = bytes_allocated();
  editor.begin("", "");
  const double freed = before - bytes_allocated();
  EXPECT_GT(said, freed * 0.45) << line(0);
  EXPECT_LT(said, freed * 2.2) << line(0);
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

}  // namespace
}  // namespace betwixt
