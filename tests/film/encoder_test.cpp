// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests the messages when the encoding program fails.
#include "film/encoder.h"

#include <sys/mount.h>

#include <random>

#include "film/films.h"

namespace betwixt {
namespace {

TEST_F(Film, WithoutFfmpeg) {
  ::setenv("PATH", folder_.c_str(), 1);
  const auto made = make_film(options("film.mp4"), gray_steps());
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().code, ErrorCode::machine);
  EXPECT_EQ(made.error().message, "ffmpeg is not installed");
  EXPECT_EQ(made.error().hint, "sudo apt-get install ffmpeg");
  EXPECT_TRUE(files().empty());
  EXPECT_TRUE(make_film(options("frame%d.png"), gray_steps()));  // pictures do not need it
}

TEST_F(Film, FfmpegDiesHalfWay) {
  struct Case {
    const char *script, *message;
  };
  for (const Case c :
       {Case{"head -c 20000 >/dev/null; kill -9 $$", "another program ended ffmpeg by signal 9 (Killed)"},
        Case{"echo one >&2; echo two >&2; echo three >&2; echo four >&2; exit 1", "ffmpeg failed: two; three; four"},
        Case{"cat >/dev/null; echo 'late trouble' >&2; exit 1", "ffmpeg failed: late trouble"},
        Case{"exit 1", "ffmpeg failed: it gave no reason"},
        Case{"head -c 20000 >/dev/null", "ffmpeg stopped before the end of the film"},
        Case{"cat >/dev/null; echo 'Error: No space left on device' >&2; exit 1",
             "the disk is full (ffmpeg said: Error: No space left on device)"}}) {
    fake_ffmpeg(c.script);
    const auto made = make_film(options("film.mp4", 2000), gray_steps());
    ASSERT_FALSE(made) << c.script;
    EXPECT_EQ(made.error().code, ErrorCode::machine);
    EXPECT_EQ(made.error().message, c.message);
    EXPECT_EQ(files(), std::vector<std::string>{"bin"});
  }
}

TEST_F(Film, FfmpegSaysThatAllIsWell) {
  struct Case {
    const char *script, *message;
  };
  for (const Case c :
       {Case{"cat >/dev/null", "ffmpeg wrote nothing: it gave no reason"},
        Case{"cat >/dev/null; echo one >&2; echo 'no such codec' >&2", "ffmpeg wrote nothing: one; no such codec"},
        Case{"for f; do :; done; cat >\"${f#file:}\"; echo 'x: No space left on device' >&2",
             "the disk is full (ffmpeg said: x: No space left on device)"}}) {
    fake_ffmpeg(c.script);
    const auto made = make_film(options("film.mp4"), gray_steps());
    ASSERT_FALSE(made) << c.script;
    EXPECT_EQ(made.error().code, ErrorCode::machine);
    EXPECT_EQ(made.error().message, c.message);
    EXPECT_EQ(files(), std::vector<std::string>{"bin"});
  }
}

TEST_F(Film, AFullDisk) {
  const fs::path disk = folder_ / "disk";
  fs::create_directory(disk);
  if (::mount("tmpfs", disk.c_str(), "tmpfs", 0, "size=64k") != 0) GTEST_SKIP() << "only root can make a small disk";
  const auto noise = painting([](int k, Picture& out) -> Status {
    std::mt19937 random(static_cast<unsigned>(k));
    out = plain(64, 48, {0, 0, 0});
    for (std::size_t i = 0; i < out.rgba.size(); ++i) out.rgba[i] = static_cast<std::uint8_t>(random() & 255);
    return Nothing{};
  });
  for (const std::string name : {"film.mp4", "film.webm", "film.gif", "film.apng", "frame%d.png"}) {
    const auto made = make_film(options("disk/" + name, 200), noise);
    EXPECT_FALSE(made) << name;
    if (made) continue;
    EXPECT_EQ(made.error().code, ErrorCode::machine) << name;
    EXPECT_TRUE(made.error().message.find("the disk is full") != std::string::npos ||
                made.error().message.find("no space left") != std::string::npos)
        << name << ": " << made.error().message;
    EXPECT_TRUE(fs::is_empty(disk)) << name;
  }
  ::umount(disk.c_str());
}

}  // namespace
}  // namespace betwixt
