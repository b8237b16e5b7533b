// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "exchange/sounds.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <numbers>

#include "support/folder.h"
#include "support/waves.h"

namespace betwixt {
namespace {

constexpr double tau = 2 * std::numbers::pi;

class Sounds : public testing::Test {
 protected:
  std::string path(const std::string& name) const { return (folder_.path() / name).string(); }
  std::string made(const std::string& name, const std::vector<float>& samples, std::uint32_t rate = 48'000,
                   std::uint16_t channels = 2) const {
    write_wave(path(name), samples, rate, channels);
    return path(name);
  }
  std::string fails(const std::string& file) const {
    const auto read = read_sound(file);
    return read ? "it was read" : read.error().message;
  }
  const Folder folder_;
};

TEST_F(Sounds, ASineIsAsLoudAsTheRootOfAHalf) {
  const auto sine = [](double t) { return 0.8 * std::sin(tau * 440 * t); };
  const auto sound = read_sound(made("a.wav", wave_of(2, sine)));
  ASSERT_TRUE(sound);
  EXPECT_EQ((*sound)->seconds, 2);
  for (const double at : {0.1, 0.5, 1.2345, 1.9}) EXPECT_NEAR((*sound)->loudness(at), 0.8 * std::sqrt(0.5), 1e-3) << at;
  EXPECT_NEAR((*sound)->loudness(0), 0.8 * 0.5, 1e-2);  // half of the 50 ms lies before the beginning
  for (const double at : {-1.0, 2.5, 1e9, -1e9}) EXPECT_EQ((*sound)->loudness(at), 0) << at;
  EXPECT_EQ((*sound)->onsets.size(), 1u);
}

// By the sum over the samples themselves.
TEST_F(Sounds, LoudnessIsTheRootOfTheMeanSquare) {
  std::vector<float> noise;
  std::uint32_t seed = 1;
  for (int i = 0; i < 2 * 48'000; ++i)
    noise.push_back(static_cast<float>((seed = seed * 1664525 + 1013904223) / 4294967296.0 - 0.5));
  const auto sound = read_sound(made("n.wav", noise));
  ASSERT_TRUE(sound);
  for (const int ms : {25, 100, 333, 900}) {
    double sum = 0;
    for (int i = 2 * 48 * (ms - 25); i < 2 * 48 * (ms + 25); ++i)
      sum += static_cast<double>(noise[static_cast<std::size_t>(i)]) * noise[static_cast<std::size_t>(i)];
    EXPECT_NEAR((*sound)->loudness(ms / 1000.0), std::sqrt(sum / (2 * 48 * 50)), 1e-9) << ms;
  }
}

TEST_F(Sounds, TicksAreFoundWhereTheyAre) {
  const std::vector<double> ticks{0.25, 0.5, 1.003, 1.75, 2.5};
  const auto click = [&](double t) {
    for (const double k : ticks)
      if (t >= k && t < k + 0.05) return std::exp(-200 * (t - k)) * std::sin(tau * 1000 * (t - k));
    return 0.0;
  };
  for (const double bed : {0.0, 0.02}) {  // of a hum below
    const auto sound =
        read_sound(made("t.wav", wave_of(3, [&](double t) { return click(t) + bed * std::sin(tau * 100 * t); })));
    ASSERT_TRUE(sound);
    std::vector<double> found = (*sound)->onsets;
    if (bed > 0) {
      ASSERT_FALSE(found.empty());
      EXPECT_LT(found.front(), 0.02);  // the hum itself
      found.erase(found.begin());
    }
    ASSERT_EQ(found.size(), ticks.size()) << bed;
    for (std::size_t i = 0; i < ticks.size(); ++i) EXPECT_NEAR(found[i], ticks[i], 0.002) << i;
    EXPECT_EQ((*sound)->onsets_between(0.4, 1.5), 2u);
    EXPECT_EQ((*sound)->onsets_between(1.5, 0.4), 0u);
  }
}

TEST_F(Sounds, OneChannelOrSixAtAnyRateAreHeard) {
  const auto sine = [](double t) { return 0.5 * std::sin(tau * 300 * t); };
  for (const auto& [rate, channels] :
       {std::pair(44'100, 1), std::pair(8'000, 1), std::pair(96'000, 2), std::pair(22'050, 6)}) {
    const auto sound = read_sound(made("c.wav", wave_of(1, sine, rate, channels), static_cast<std::uint32_t>(rate),
                                       static_cast<std::uint16_t>(channels)));
    ASSERT_TRUE(sound) << rate << " " << channels;
    EXPECT_NEAR((*sound)->seconds, 1, 0.002) << rate << " " << channels;
    EXPECT_GT((*sound)->loudness(0.5), 0.2) << rate << " " << channels;
  }
}

TEST_F(Sounds, WhatIsNoneIsRefusedInWords) {
  EXPECT_EQ(fails(path("none.wav")), "there is no file '" + path("none.wav") + "'");
  EXPECT_EQ(fails(folder_.path().string()), folder_.path().string() + " is a folder, not a file");
  std::ofstream(path("noise.wav")) << "RIFFxxxxWAVEnothing at all";
  EXPECT_TRUE(fails(path("noise.wav")).starts_with(path("noise.wav") + " is broken or not a sound: "))
      << fails(path("noise.wav"));
  made("heard.wav", wave_of(0.1, [](double) { return 0.5; }));
  // A list of other files is none, whatever it is called.
  std::ofstream(path("list.wav")) << "ffconcat version 1.0\nfile heard.wav\n";
  std::ofstream(path("list.m3u8")) << "#EXTM3U\n#EXT-X-TARGETDURATION:3\n#EXTINF:3,\nheard.wav\n#EXT-X-ENDLIST\n";
  for (const char* name : {"list.wav", "list.m3u8"})
    EXPECT_TRUE(fails(path(name)).starts_with(path(name) + " is broken or not a sound: ")) << fails(path(name));
  EXPECT_EQ(fails(made("empty.wav", {})), path("empty.wav") + " is broken or not a sound: it has no sound");
  const std::string was = std::getenv("PATH");
  ::setenv("PATH", folder_.path().c_str(), 1);
  EXPECT_EQ(fails(path("heard.wav")), "sounds need the program ffmpeg, which is not installed");
  ::setenv("PATH", was.c_str(), 1);
}

// Silence in blocks of 82 bytes, each of 131,072 samples, 6,000 of them a second.
std::string silence(std::uint32_t blocks) {
  static constexpr std::string_view block(
      "\x77\x76\x70\x6b\x4a\x00\x00\x00\x10\x04\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00"
      "\x00\x00\x02\x00\x20\x19\x00\x00\xff\xff\x47\x8a\x02\x01\x57\x56\x03\x02\x40\x40"
      "\x3f\x00\x04\x04\x00\xff\x00\xff\x00\xff\x00\xff\x05\x06\x00\x00\x00\x00\x00\x00"
      "\x00\x00\x00\x00\x00\x00\x09\x02\x00\x08\x00\x00\x8a\x03\x00\x00\xff\xff\x07\x00"
      "\x00\x00",
      82);
  std::string out;
  for (std::uint32_t i = 0; i < blocks; ++i) {
    std::string one(block);
    const std::uint32_t all = i == 0 ? ~0U : 0, first = i << 17;
    std::memcpy(one.data() + 12, &all, sizeof all), std::memcpy(one.data() + 16, &first, sizeof first);
    out += one;
  }
  return out;
}

// 2,460 bytes may last 324 s, and are 655: nobody reads hours of nothing unless the caller says so.
TEST_F(Sounds, LastNoLongerThanTheirSizeAllows) {
  const auto put = [&](const char* name, std::uint32_t blocks) {
    std::ofstream(path(name), std::ios::binary) << silence(blocks);
    return path(name);
  };
  const auto good = read_sound(put("good.wv", 10));
  ASSERT_TRUE(good) << good.error().message;
  EXPECT_NEAR((*good)->seconds, 10 * 131'072.0 / 6000, 0.01);
  const auto long_one = read_sound(put("long.wv", 30));
  ASSERT_FALSE(long_one);
  EXPECT_EQ(long_one.error().code, ErrorCode::range);
  const auto any = read_sound(path("long.wv"), true);
  ASSERT_TRUE(any) << any.error().message;
  EXPECT_NEAR((*any)->seconds, 30 * 131'072.0 / 6000, 0.01);
}

}  // namespace
}  // namespace betwixt
