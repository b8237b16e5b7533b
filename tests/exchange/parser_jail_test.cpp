// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "exchange/parser_jail.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <functional>

#include "exchange/files.h"

namespace betwixt {
namespace {

// What a process that has given up something can still do, a letter each.
std::string left_over(const std::string& folder, const std::string& file, const std::function<void()>& give_up) {
  int told[2] = {-1, -1};
  EXPECT_EQ(::pipe(told), 0);
  const int open_before = ::open(file.c_str(), O_RDONLY);
  const pid_t child = ::fork();
  if (child == 0) {
    give_up();
    std::string can;
    char byte = 0;
    const auto say = [&](char what, bool done) {
      if (done) can += what;
    };
    say('r', ::read(open_before, &byte, 1) == 1 && byte == 'x');
    say('o', ::open(file.c_str(), O_RDONLY) >= 0);
    say('O', ::open("/etc/hostname", O_RDONLY) >= 0);
    say('w', ::open((folder + "/new").c_str(), O_WRONLY | O_CREAT, 0666) >= 0);
    say('u', ::unlink(file.c_str()) == 0);
    say('m', ::chmod(file.c_str(), 0777) == 0);
    say('t', ::truncate(file.c_str(), 0) == 0);
    say('l', ::open(folder.c_str(), O_RDONLY | O_DIRECTORY) >= 0);
    say('e', ::open("/proc/self/environ", O_RDONLY) >= 0);
    say('s', ::socket(AF_INET, SOCK_STREAM, 0) >= 0);
    say('k', ::kill(::getppid(), 0) == 0);
    const pid_t other = ::fork();
    if (other == 0) ::_exit(0);
    say('f', other > 0);
    say('x', ::access("/bin/sh", X_OK) == 0);
    (void)!::write(told[1], can.data(), can.size());
    ::_exit(0);
  }
  ::close(told[1]);
  ::close(open_before);
  std::string can;
  char byte = 0;
  while (::read(told[0], &byte, 1) == 1) can += byte;
  ::close(told[0]);
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_TRUE(WIFEXITED(status));
  return can;
}

TEST_F(Files, AreAllThatAParserHas) {
  const std::string file = put("x", "x");
  EXPECT_EQ(left_over(folder_.path().string(), file,
                      [] {
                        give_up_all_but_reading({std::uint64_t{1} << 40, 20, 20});
                      }),
            "r");
  EXPECT_EQ(::access(file.c_str(), F_OK), 0);
}

// A program of another author may start, and be looked for; it opens the file that it is given, and nothing else of
// ours.
TEST_F(Files, AreReadByOtherProgramsOneByOne) {
  const std::string file = put("x", "x"), other = put("y", "x");
  const auto give_up = [](const std::string& only) {
    return [only] { give_up_all_but_one_file(only, "/bin/sh", {std::uint64_t{1} << 50, 20, 20}); };
  };
  EXPECT_EQ(left_over(folder_.path().string(), file, give_up(file)), "rox");
  EXPECT_EQ(left_over(folder_.path().string(), file, give_up(other)), "rx");
  EXPECT_EQ(::access(file.c_str(), F_OK), 0);
}

// It has its folder, whose file it may also remove, and nothing else of ours.
TEST_F(Files, AreChangedByOtherProgramsInOneFolder) {
  const std::string outside = put("x", "x");
  const Folder own;
  const std::string inside = own.put("x", "x");
  const auto give_up = [&] {
    give_up_all_but_one_folder(own.path().string(), "/bin/sh", {std::uint64_t{1} << 50, 20, 20});
  };
  EXPECT_EQ(left_over(own.path().string(), inside, give_up), "rowulx");
  EXPECT_EQ(left_over(folder_.path().string(), outside, give_up), "rx");
  EXPECT_EQ(::access(outside.c_str(), F_OK), 0);
}

}  // namespace
}  // namespace betwixt
