// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests the synchronization of sound with a fake device and a fake clock. Each sample pair of the film is its own
// index.
#include "film/sound_stream.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace betwixt {
namespace {

constexpr std::int64_t block = SoundStream::block, second = 48'000;

// Plays what it was given, a pair a pair's time; then nothing.
struct KeptSound : SoundOutput {
  std::vector<float> given, played;  // left and right
  std::size_t heard = 0;             // of what it was given
  std::int64_t waiting() override { return static_cast<std::int64_t>((given.size() - heard) / 2); }
  void write(std::span<const float> stereo) override { given.insert(given.end(), stereo.begin(), stereo.end()); }
  void forget() override { given.clear(), heard = 0; }
  void play(std::int64_t pairs) {
    const std::size_t wanted = 2 * static_cast<std::size_t>(pairs), has = std::min(wanted, given.size() - heard);
    const auto from = given.begin() + static_cast<std::ptrdiff_t>(heard);
    played.insert(played.end(), from, from + static_cast<std::ptrdiff_t>(has));
    played.resize(played.size() + wanted - has);
    heard += has;
  }
  std::int64_t time() const { return static_cast<std::int64_t>(played.size() / 2); }
  float left(std::int64_t pair) const { return played[2 * static_cast<std::size_t>(pair)]; }
};

// What a film has: its k-th pair is k + 1 a million times smaller, and the negative of it.
bool places(std::int64_t from, std::span<float> stereo) {
  for (std::size_t i = 0; i < stereo.size(); i += 2)
    stereo[i + 1] = -(stereo[i] = static_cast<float>(from + static_cast<std::int64_t>(i / 2) + 1) * 1e-6f);
  return true;
}
constexpr float number(std::int64_t pair) { return static_cast<float>(pair + 1) * 1e-6f; }

class Stream : public ::testing::Test {
 protected:
  // For so many pairs, from a place of the film on, looking in every 10 ms; the clock of the film may be another one.
  void play(std::int64_t from, std::int64_t pairs, double faster = 1) {
    for (std::int64_t gone = 0; gone < pairs; gone += 480) {
      stream.fill(device, from + std::llround(static_cast<double>(gone) * faster));
      device.play(480);
    }
  }
  void pause(std::int64_t pairs) {
    for (; pairs > 0; pairs -= 480) stream.fill(device, std::nullopt), device.play(480);
  }
  // Each pair played from `time` on is the film's, from that place on.
  void expect_places(std::int64_t time, std::int64_t pairs, std::int64_t place) const {
    for (std::int64_t i = 0; i < pairs; ++i) {
      ASSERT_EQ(device.left(time + i), number(place + i)) << i;
      ASSERT_EQ(device.played[2 * static_cast<std::size_t>(time + i) + 1], -number(place + i)) << i;
    }
  }
  // Nothing jumps by more than a fade of 5 ms can: what is clicked is much more.
  void expect_no_clicks(std::int64_t from, float loudest) const {
    for (std::int64_t i = from + 1; i < device.time(); ++i)
      ASSERT_LE(std::abs(device.left(i) - device.left(i - 1)), loudest / 100) << i;
  }
  KeptSound device;
  SoundStream stream{places, 10 * second, false};
};

TEST_F(Stream, GoesOnFromSampleToSampleFromTheFirst) {
  play(0, 9 * second);
  expect_places(0, 9 * second, 0);
}
TEST_F(Stream, SomebodyLateMissesNothing) {
  play(block - 1, second);
  expect_places(0, second, 0);
}
TEST_F(Stream, EndsWithTheFilm) {
  play(0, 11 * second);
  expect_places(0, 10 * second, 0);
  for (std::int64_t i = 10 * second; i < 11 * second; ++i) ASSERT_EQ(device.left(i), 0) << i;
}

TEST_F(Stream, GoesWhereThePicturesGo) {
  for (const std::int64_t to : {7 * second, second / 2}) {
    SCOPED_TRACE(to);
    device = {}, stream = SoundStream(places, 10 * second, false);
    play(2 * second, second);
    play(to, second);
    // What was under way, the ways down and up, and it is where it should be.
    const std::int64_t after = SoundStream::ahead + block + 240;
    expect_places(second + after, second - after, to + after);
    expect_no_clicks(0, 0.4f);
  }
}

TEST_F(Stream, IsSilentInPauses) {
  play(3 * second, second);
  pause(second);
  const std::int64_t quiet = second + SoundStream::ahead + block;
  for (std::int64_t i = quiet; i < 2 * second; ++i) ASSERT_EQ(device.left(i), 0) << i;
  // Goes on at once, in step: silence that was waiting is not waited for.
  play(4 * second, second);
  expect_places(2 * second + 240, second - 240, 4 * second + 240);
  expect_no_clicks(0, 0.3f);
}
TEST_F(Stream, FromItsBeginningAgainItMissesNothing) {
  play(3 * second, second);
  pause(second);
  play(0, second);
  expect_places(2 * second, second, 0);
}

TEST_F(Stream, ALoopGoesOnFromItsStartToTheSample) {
  constexpr std::int64_t length = second + 333;
  stream = SoundStream(places, length, true);
  play(0, 5 * second);
  for (std::int64_t i = 0; i < 5 * second; ++i) ASSERT_EQ(device.left(i), number(i % length)) << i;
}
TEST_F(Stream, AFilmShorterThanABlockLoopsToo) {
  for (const std::int64_t length : {1, 7, 961}) {
    device = {}, stream = SoundStream(places, length, true);
    play(0, second);
    for (std::int64_t i = 0; i < second; ++i) ASSERT_EQ(device.left(i), number(i % length)) << i;
  }
}

// Clocks that differ by a thousandth, more than any do: it is never off by more than what nobody hears, and goes back
// now and then.
TEST_F(Stream, FollowsAnotherClock) {
  for (const double faster : {1.001, 0.999}) {
    SCOPED_TRACE(faster);
    constexpr std::int64_t length = 300 * second;
    device = {}, stream = SoundStream(places, length, false);
    play(second, 100 * second, faster);
    std::int64_t in_step = 0, furthest = 0;
    for (std::int64_t i = 0; i < device.time(); ++i) {
      const auto place = std::llround(static_cast<double>(device.left(i)) * 1e6 - 1);
      const auto due = second + std::llround(static_cast<double>(i) * faster);
      if (std::abs(place - due) > SoundStream::tolerance + block) continue;  // fades
      ++in_step, furthest = std::max<std::int64_t>(furthest, std::abs(place - due));
    }
    EXPECT_GT(in_step, 99 * second);
    EXPECT_GT(furthest, SoundStream::tolerance / 2) << "the clocks did not differ";
  }
}

TEST_F(Stream, WhatIsNotKnownYetIsSilentAndThenInStep) {
  bool known = true;
  stream =
      SoundStream([&](std::int64_t from, std::span<float> s) { return known && places(from, s); }, 10 * second, false);
  play(second, second);
  known = false;
  play(2 * second, second);
  for (std::int64_t i = second + SoundStream::ahead + block; i < 2 * second; ++i) ASSERT_EQ(device.left(i), 0) << i;
  known = true;
  play(3 * second, second);
  expect_places(2 * second + 240, second - 240, 3 * second + 240);
  expect_no_clicks(0, 0.2f);
}

// It ran dry for half a second, as where the machine was asleep.
TEST_F(Stream, ComesBackAfterAGap) {
  play(0, second);
  device.play(second / 2);
  play(3 * second / 2, second);
  const std::int64_t after = 3 * second / 2 + SoundStream::ahead + block;
  expect_places(after, device.time() - after, after);
}

TEST_F(Stream, TwoFilmsDoNotKnowOfEachOther) {
  KeptSound other;
  SoundStream second_stream([](std::int64_t from, std::span<float> s) { return places(from + 100'000, s); }, second,
                            true);
  for (std::int64_t t = 0; t < 2 * second; t += 480) {
    stream.fill(device, t), second_stream.fill(other, t);
    device.play(480), other.play(480);
  }
  expect_places(0, 2 * second, 0);
  for (std::int64_t i = 0; i < 2 * second; ++i) ASSERT_EQ(other.left(i), number(100'000 + i % second)) << i;
}

}  // namespace
}  // namespace betwixt
