// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests how copies of the process find the command that ends it.
#include "editor/crash_recovery.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <thread>

#include "support/folder.h"

namespace betwixt {
namespace {

TEST(Trial, FindsTheCommandThatEndsTheProcess) {
  for (const std::size_t bad : {0u, 1u, 37u, 98u, 99u}) {
    const auto found = find_culprit(100, [&](std::size_t n) {
      if (n > bad) std::raise(SIGKILL);
    });
    ASSERT_TRUE(found) << bad;
    EXPECT_EQ(found->number, bad);
    EXPECT_EQ(found->how, "signal 9");
  }
}

TEST(Trial, FindsNothingWhereNoCommandIsToBlame) {
  EXPECT_FALSE(find_culprit(100, [](std::size_t) {}));
  EXPECT_FALSE(find_culprit(0, [](std::size_t) { std::raise(SIGKILL); }));
  EXPECT_FALSE(find_culprit(5, [](std::size_t) { std::raise(SIGKILL); })) << "it dies without any";
}

TEST(Trial, SaysHowACopyEnds) {
  EXPECT_EQ(dies_of([] { ::_exit(3); }), "exit code 3");
  EXPECT_EQ(dies_of([] { std::abort(); }), "signal 6");
  EXPECT_EQ(dies_of([] { throw 7; }), "signal 6");
}

// What the copy does stays in the copy; one that closes its files closes none of ours.
TEST(Trial, ChangesNothingHere) {
  const Folder folder;
  int n = 0;
  const int file = ::dup(STDERR_FILENO);
  EXPECT_FALSE(dies_of([&] { n = 1; }));
  EXPECT_EQ(n, 0);
  EXPECT_EQ(::close(file), 0);
}

TEST(Trial, AProcessWithOtherThreadsIsNotCopied) {
  std::atomic<bool> over{false};
  std::thread other([&] { over.wait(false); });
  EXPECT_FALSE(dies_of([] { std::abort(); }));
  over = true, over.notify_all();
  other.join();
}

TEST(StartMark, StaysWhereAStartEnds) {
  const Folder folder;
  const std::string script = folder / "live.bx";
  { EXPECT_FALSE(StartMark(script).found()); }
  EXPECT_TRUE(dies_of([&] {
    const StartMark mark(script);
    std::raise(SIGKILL);
  }));
  { EXPECT_TRUE(StartMark(script).found()); }
  { EXPECT_FALSE(StartMark(script).found()); }
  EXPECT_TRUE(folder.names().empty());
}

}  // namespace
}  // namespace betwixt
