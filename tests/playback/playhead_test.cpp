// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Which frame is due. The expected ones are counted by hand: 24 frames a second.
#include "playback/playhead.h"

#include <gtest/gtest.h>

#include <thread>

namespace betwixt {
namespace {

const Rate rate{24, 1};

Playhead over(double first, double last, bool loop) {
  Playhead t;
  t.loop(loop);
  t.set(rate, rate.frame(first), rate.frame(last));
  t.go_to(t.first());
  return t;
}
Playhead::Clock::time_point in(double seconds) {
  return Playhead::Clock::now() + std::chrono::milliseconds(static_cast<int>(1000 * seconds));
}
double frame_at(const Playhead& t, double seconds) { return rate.frame_number(t.now(in(seconds))); }

TEST(Playhead, PlaysBothWays) {
  Playhead t = over(1, 24, false);
  t.go_to(rate.frame(3)), t.play(1);
  EXPECT_EQ(frame_at(t, 0.52), 15);  // half a second later
  EXPECT_EQ(frame_at(t, 100), 24);   // stays at the end
  t.pause(), t.go_to(rate.frame(13)), t.play(-1);
  EXPECT_EQ(frame_at(t, 0.48), 2);
  EXPECT_EQ(frame_at(t, 100), 1);
  t.loop(true);
  EXPECT_EQ(frame_at(t, 0), frame_at(t, 1));  // 24 frames: once around
}

TEST(Playhead, PlaysAtOtherSpeeds) {
  for (const double speed : {0.5, 2.0}) {
    Playhead t = over(1, 240, false);
    t.speed(speed), t.play(1);
    EXPECT_EQ(frame_at(t, 2.02), 1 + 48 * speed);
    EXPECT_FALSE(t.place().playing);  // without sound
    EXPECT_NEAR(t.until_next(in(0)), 1 / (24 * speed), 0.005);
    t.speed(1);
    EXPECT_EQ(frame_at(t, 1.02), 25);
    EXPECT_TRUE(t.place().playing);
  }
}

TEST(Playhead, StaysInItsPart) {
  Playhead t = over(5, 8, true);
  for (const int direction : {1, -1}) {
    t.pause(), t.go_to(rate.frame(20)), t.play(direction);
    std::set<double> seen;
    for (double s = 0; s < 2; s += 0.01) seen.insert(frame_at(t, s));
    EXPECT_EQ(seen, (std::set<double>{5, 6, 7, 8})) << direction;
  }
}

TEST(Playhead, EndsAfterTheFrameAtTheEndHasHadItsTime) {
  for (const double last : {4.0, 4.5})  // 4 frames of 42 ms
    for (const int direction : {1, -1}) {
      Playhead t = over(1, last, false);
      t.play(direction);
      EXPECT_FALSE(t.ended(in(0.13))) << last << ' ' << direction;
      EXPECT_EQ(frame_at(t, 0.13), direction > 0 ? 4 : last == 4 ? 1 : 2);
      EXPECT_TRUE(t.ended(in(last == 4 ? 0.17 : 0.19))) << last << ' ' << direction;
      t.loop(true);
      EXPECT_FALSE(t.ended(in(100)));
    }
  Playhead one = over(7, 7, false);
  one.play(1);
  EXPECT_FALSE(one.ended(in(0.03)));
  EXPECT_TRUE(one.ended(in(0.05)));
  EXPECT_EQ(one.now(in(0.05)), rate.frame(7));
}

TEST(Playhead, BeginsAgainFromTheEnd) {
  Playhead t = over(1, 24, false);
  t.go_to(t.last()), t.play(1);
  EXPECT_EQ(frame_at(t, 0.01), 1);
  t.pause(), t.go_to(t.first()), t.play(-1);
  EXPECT_EQ(frame_at(t, 0.01), 24);
}

TEST(Playhead, SaysWhenAnotherFrameIsDue) {
  for (const int direction : {1, -1}) {
    Playhead t = over(1, 24, true);
    t.go_to(rate.frame(12)), t.play(direction);
    for (const double s : {0.0, 0.05, 0.3}) {
      const auto clock = in(s);
      const auto later = [&](double part) {
        return clock + std::chrono::duration_cast<Playhead::Clock::duration>(
                           std::chrono::duration<double>(part * t.until_next(clock)));
      };
      EXPECT_EQ(t.now(later(0.9)), t.now(clock)) << s;
      EXPECT_EQ(rate.frame_number(t.now(later(1.1))), rate.frame_number(t.now(clock)) + direction) << s;
    }
  }
}

// Messages of a fader come 100 times a second.
TEST(Playhead, ChangesDuringPlaybackDoNotSlowItDown) {
  for (const int direction : {1, -1}) {
    Playhead often = over(1, 240, true), seldom = often;
    for (Playhead* t : {&often, &seldom}) t->go_to(rate.frame(120));
    often.play(direction), seldom.play(direction);
    for (int k = 0; k < 150; ++k) {  // the end of the film changes, or stays
      often.set(rate, rate.frame(1), rate.frame(k % 3 ? 240 : 240 + k));
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    const auto clock = Playhead::Clock::now();
    const double a = rate.frame_number(often.now(clock)), b = rate.frame_number(seldom.now(clock));
    EXPECT_NEAR(a, b, 1);
    EXPECT_GE(direction * (a - 120), 15);
    const Playhead::Place sound = often.place();
    EXPECT_EQ(sound.playing, direction > 0);
    if (direction < 0) continue;
    const double heard = 1 + sound.frame + 24 * std::chrono::duration<double>(clock - sound.since).count();
    EXPECT_GE(heard, a);
    EXPECT_LT(heard, a + 1);
  }
}

// A loop would put a message from before the start at the last frame.
TEST(Playhead, AMessageFromBeforeTheStartBelongsToTheFirstFrame) {
  for (const bool loop : {true, false})
    for (const int direction : {1, -1}) {
      Playhead t = over(1, 48, loop);
      const Time begin = direction > 0 ? t.first() : t.last();
      t.go_to(begin);
      const auto before = in(-0.01);
      t.play(direction);
      EXPECT_EQ(t.now(before), begin);
      t.set(rate, rate.frame(1), rate.frame(48));  // a message before it has been shown
      EXPECT_EQ(t.now(before), begin);
      t.go_to(rate.frame(24));
      EXPECT_EQ(t.now(before), rate.frame(24));
    }
}

}  // namespace
}  // namespace betwixt
