// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The file of a film must appear only when it is complete.
#include "film/sink.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/file.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <thread>

#include "film/films.h"

namespace betwixt {
namespace {

TEST_F(Film, StoppingLeavesNothing) {
  for (const std::string name : {"film.mp4", "film.gif", "frame-%04d.png"}) {
    FilmOptions o = options(name, 100000);
    const auto made = make_film(o, gray_steps(), [](int done, int, double) { return done < 3; });
    ASSERT_FALSE(made) << name;
    EXPECT_EQ(files(), std::vector<std::string>{}) << name;
  }
}

TEST_F(Film, AnOldFilmStaysWhenTheNewOneFails) {
  FilmOptions o = options("film.mp4");
  std::ofstream(o.path) << "old";
  const auto broken = painting([](int k, Picture& out) -> Status {
    if (k == 4) return fail(ErrorCode::name, "no such color", "did you mean gold?");
    out = plain(64, 48, {0, 0, 0});
    return Nothing{};
  });
  const auto made = make_film(o, broken);
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().code, ErrorCode::name);
  EXPECT_EQ(made.error().message, "no such color");
  EXPECT_EQ(made.error().hint, "did you mean gold?");
  std::string word;
  std::ifstream(o.path) >> word;
  EXPECT_EQ(word, "old");
  EXPECT_EQ(files(), std::vector<std::string>{"film.mp4"});
}

TEST_F(Film, WhatAKilledMakerLeftGoesWithTheNext) {
  for (const std::string name : {"film.mp4", "frame-%d.png"}) {
    const FilmOptions o = options(name);
    const pid_t maker = ::fork();
    if (maker == 0) {
      const auto dies = painting([](int k, Picture& out) -> Status {
        if (k == 4) ::kill(::getpid(), SIGKILL);
        out = plain(64, 48, {0, 0, 0});
        return Nothing{};
      });
      (void)make_film(o, dies);
      ::_exit(0);
    }
    int status = 0;
    ASSERT_EQ(::waitpid(maker, &status, 0), maker);
    ASSERT_TRUE(WIFSIGNALED(status));
    ASSERT_EQ(files().size(), 1U) << name;
    const fs::path left = folder_ / files()[0];
    // The encoder goes on with what it has; when it has opened the file it makes no other.
    for (int i = 0; i < 500 && fs::is_regular_file(left) && fs::file_size(left) == 0; ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    ASSERT_TRUE(make_film(o, gray_steps()));
    for (const std::string& there : files()) EXPECT_NE(there[0], '.') << there;
    for (const std::string& there : files()) fs::remove(folder_ / there);
  }
}

TEST_F(Film, WhatOthersMakeStays) {
  char host[256] = "";
  ASSERT_EQ(::gethostname(host, sizeof host - 1), 0);
  const std::string here = std::string(".film.") + host + '.', film2 = std::string(".film2.") + host + '.';
  // Another film, another format, a folder, a link, another machine's, one of before machines were said, and one that
  // is being made.
  const std::vector<std::string> others{
      here + "1-0.partial.gif", here + "1-x.partial.mp4", film2 + "1-0.partial.mp4", ".film.elsewhere.1-0.partial.mp4",
      ".film.1-0.partial.mp4",  here + "3-0.partial.mp4", "film.1-0.partial.mp4",    here + "1-0.partial.mp4.txt"};
  for (const std::string& name : others) std::ofstream(folder_ / name) << "others";
  fs::create_directory(folder_ / (here + "4-0.partial.mp4"));
  fs::create_symlink("film2", folder_ / (here + "5-0.partial.mp4"));
  for (const char* name : {"1-0.partial.mp4", "77777-12.partial.mp4"}) std::ofstream(folder_ / (here + name)) << "left";
  const int made = ::open((folder_ / (here + "3-0.partial.mp4")).c_str(), O_RDONLY);
  ASSERT_EQ(::flock(made, LOCK_EX), 0);
  ASSERT_TRUE(make_film(options("film.mp4"), gray_steps()));
  ::close(made);
  auto wanted = others;
  wanted.insert(wanted.end(), {"film.mp4", here + "4-0.partial.mp4", here + "5-0.partial.mp4"});
  auto there = files();
  std::sort(wanted.begin(), wanted.end());
  std::sort(there.begin(), there.end());
  EXPECT_EQ(there, wanted);
}

}  // namespace
}  // namespace betwixt
