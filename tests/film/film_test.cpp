// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Several renderers in parallel must make one correct film.
#include "betwixt/film.h"

#include <atomic>
#include <random>
#include <thread>

#include "base/cancellation.h"
#include "film/films.h"
#include "support/told.h"

namespace betwixt {
namespace {

TEST_F(Film, ManyPaintersKeepTheOrder) {
  FilmOptions o = options("order.apng", 60);
  o.width = o.height = 4;
  o.jobs = 4;
  std::atomic<int> seed{1};
  const auto lazy = [&]() -> Result<Painter> {
    auto random = std::make_shared<std::mt19937>(seed++);
    return Painter([random](int k, Picture& out) -> Status {
      std::this_thread::sleep_for(std::chrono::microseconds((*random)() % 8000));
      out = plain(4, 4, {k, 255 - k, 3 * k});
      return Nothing{};
    });
  };
  ASSERT_TRUE(make_film(o, lazy));
  EXPECT_EQ(seed, 5);  // every job has a painter of its own
  const std::string rgb = decode(o.path, "rgb24");
  ASSERT_EQ(rgb.size(), 60u * 16 * 3);
  for (int k = 0; k < 60; ++k) EXPECT_EQ(static_cast<unsigned char>(rgb[static_cast<std::size_t>(k) * 48]), k);
}

TEST_F(Film, PaintersDoNotRunAheadOfTheEncoder) {
  fake_ffmpeg("exec sleep 1000");  // reads nothing
  FilmOptions o = options("film.mp4", 1000);
  o.width = o.height = 2048;  // 6 MiB a frame: more than the way to the encoder holds
  o.jobs = 3;
  std::atomic<int> painted{0};
  int calls = 0;
  const auto made = make_film(o, painting([&](int, Picture& out) -> Status {
                                ++painted;
                                out = plain(2048, 2048, {1, 2, 3});
                                return Nothing{};
                              }),
                              [&](int done, int, double) {
                                EXPECT_EQ(done, 0);
                                return ++calls < 10;
                              });
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().message, "the film was stopped");
  EXPECT_LE(painted, 6);
  EXPECT_EQ(files(), std::vector<std::string>{"bin"});
}

// Who stops a film does not wait for pictures that take long.
TEST_F(Film, APictureIsGivenUpInTheMiddle) {
  FilmOptions o = options("frame-%04d.png", 10);
  o.jobs = 2;
  const auto made = make_film(o, painting([&](int, Picture&) -> Status {
                                for (;;) Cancellation::check();
                              }),
                              [](int, int, double) { return false; });
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().message, "the film was stopped");
  EXPECT_TRUE(files().empty());
}

TEST_F(Film, OfSeveralFailuresTheFirstInTheFilmIsTold) {
  FilmOptions o = options("film.mp4", 40);
  o.jobs = 4;
  const auto made = make_film(o, painting([](int k, Picture& out) -> Status {
                                if (k < 5) std::this_thread::sleep_for(std::chrono::milliseconds(3));
                                if (k >= 4) return fail(ErrorCode::range, "frame " + std::to_string(k));
                                out = plain(64, 48, {0, 0, 0});
                                return Nothing{};
                              }));
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().message, "frame 4");
}

TEST_F(Film, APainterThatCannotBeMadeIsTold) {
  const auto made =
      make_film(options("film.mp4"), []() -> Result<Painter> { return fail(ErrorCode::machine, "no graphics"); });
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().message, "no graphics");
  EXPECT_TRUE(files().empty());
}

TEST_F(Film, APictureOfAnotherSizeIsRefused) {
  const auto made = make_film(options("film.mp4"), gray_steps(32, 48));
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().message, "a painter made a picture of 32x48 for a film of 64x48");
}

TEST_F(Film, NumbersOutOfBounds) {
  const auto message = [&](auto change) {
    FilmOptions o = options("film.mp4");
    change(o);
    const auto made = make_film(o, gray_steps());
    EXPECT_FALSE(made);
    EXPECT_EQ(told(made), "range");
    return made ? std::string() : made.error().message;
  };
  EXPECT_EQ(message([](FilmOptions& o) { o.frames = 0; }), "a film needs at least one frame");
  EXPECT_EQ(message([](FilmOptions& o) { o.width = 0; }),
            "a picture of 0x48 is not possible: each side must have from 1 to 8192 pixels");
  EXPECT_NE(message([](FilmOptions& o) { o.height = 9000; }).find("64x9000"), std::string::npos);
  EXPECT_EQ(message([](FilmOptions& o) { o.rate = {0, 1}; }), "a film needs a rate above 0");
  EXPECT_EQ(message([](FilmOptions& o) { o.jobs = -1; }), "the number of jobs must be from 1 to 256");
}

TEST_F(Film, ProgressEndsWithAllFrames) {
  int last = -1;
  FilmOptions o = options("film.mp4", 20);
  const auto made = make_film(o, gray_steps(), [&](int done, int frames, double) {
    EXPECT_GE(done, last);
    EXPECT_EQ(frames, 20);
    return last = done, true;
  });
  ASSERT_TRUE(made);
  EXPECT_EQ(last, 20);
  EXPECT_LE(made->encoding, made->seconds + 1);
}

}  // namespace
}  // namespace betwixt
