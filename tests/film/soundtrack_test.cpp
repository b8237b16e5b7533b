// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Blocks of a film's sound must equal the same parts of the whole sound.
#include "film/soundtrack.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "betwixt/film.h"
#include "betwixt/language.h"
#include "film/films.h"
#include "support/waves.h"

namespace betwixt {
namespace {

class Blocks : public Film {
 protected:
  Program program(const std::string& script) const {
    std::ofstream(folder_ / "film.bx") << script;
    const Loaded l = load_file((folder_ / "film.bx").string());
    EXPECT_FALSE(has_errors(l.diagnostics)) << script;
    return Program::compile(l.document);
  }
  void SetUp() override {
    Film::SetUp();
    std::uint32_t state = 1;
    const auto noise = [&](double) { return (state = state * 1664525u + 1013904223u) / 4294967296.0 - 0.5; };
    write_wave((folder_ / "long.wav").string(), wave_of(3, noise));
    write_wave((folder_ / "other.wav").string(), wave_of(0.7, noise, 44'100, 1), 44'100, 1);
  }
};

// Beginnings between samples, gains that are curves, fades, one file twice, another rate; and a film that does not
// begin at 0, at a rate whose frames are no whole samples.
TEST_F(Blocks, AreTheWholeToTheBit) {
  const Program p = program(
      "rate 60000/1001\nrange 8f 150f\n"
      "create a sound file=\"long.wav\" at=12.5f from=0.3s until=2.2s fade-in=0.3s fade-out=0.5s\n"
      "a.gain\n  12f 0 ease-in-out\n  60f 1.5 fcurve\n  100f 0.2\n"
      "create b sound file=\"other.wav\" at=-3f gain=0.5\n"
      "create c sound file=\"long.wav\" at=77.3f\n"
      "create d sound file=\"other.wav\" at=140f\n");
  const Time first = p.document().rate().frame(8);
  std::vector<float> whole(2 * 110'000);
  ASSERT_TRUE(mix_sounds(p, first, whole));
  EXPECT_GT(std::count_if(whole.begin(), whole.end(), [](float v) { return v != 0; }), 150'000);
  Soundtrack track(first);
  ASSERT_TRUE(track.await(p, 0, 110'000, 60));
  std::minstd_rand chance(1);
  const auto any = [&](int from, int to) { return std::uniform_int_distribution<std::size_t>(from, to)(chance); };
  for (const int most : {40, 1'000, 20'000}) {
    std::vector<float> joined;
    while (joined.size() < whole.size()) {
      std::vector<float> stereo(std::min(2 * any(1, most), whole.size() - joined.size()), 9.0f);
      ASSERT_TRUE(track.mix(p, static_cast<std::int64_t>(joined.size() / 2), stereo));
      joined.insert(joined.end(), stereo.begin(), stereo.end());
    }
    EXPECT_TRUE(joined == whole) << "blocks of up to " << most;
  }
  for (int i = 0; i < 100; ++i) {
    const std::size_t from = any(0, 100'000);
    std::vector<float> stereo(2 * any(1, 10'000));
    ASSERT_TRUE(track.mix(p, static_cast<std::int64_t>(from), stereo));
    EXPECT_TRUE(std::equal(stereo.begin(), stereo.end(), whole.begin() + static_cast<std::ptrdiff_t>(2 * from)))
        << from;
  }
}

TEST_F(Blocks, FollowAnotherProgram) {
  const Program one = program("create a sound file=\"long.wav\"\n");
  const Program half = program("create a sound file=\"long.wav\" gain=0.5\n");
  Soundtrack track(Time{});
  ASSERT_TRUE(track.await(one, 4'800, 960, 60));
  std::vector<float> loud(1920), soft(1920);
  ASSERT_TRUE(track.mix(one, 4'800, loud) && track.mix(half, 4'800, soft));
  for (std::size_t i = 0; i < loud.size(); ++i) ASSERT_EQ(soft[i], loud[i] / 2);
}

// The file has gone since the script was read: nothing is waited for, nothing is heard.
TEST_F(Blocks, WhatHasGoneIsSilent) {
  const Program p = program("create a sound file=\"long.wav\"\n");
  std::filesystem::remove(folder_ / "long.wav");
  Soundtrack track(Time{});
  ASSERT_TRUE(track.await(p, 0, 960, 60));
  std::vector<float> stereo(1920, 9.0f);
  ASSERT_TRUE(track.mix(p, 0, stereo));
  EXPECT_EQ(stereo, std::vector<float>(1920));
}

}  // namespace
}  // namespace betwixt
