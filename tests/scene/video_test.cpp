// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "scene/video.h"

#include <gtest/gtest.h>

#include "betwixt/time.h"

namespace betwixt {
namespace {

// Ten pictures at 24 a second.
struct Ten final : Video {
  Ten() {
    for (int i = 0; i < 10; ++i) begins.push_back(i * flicks_per_second / 24);
    end = 10 * flicks_per_second / 24, slack = 700;
  }
  Result<std::shared_ptr<const Picture>> picture(std::size_t) const override {
    return std::make_shared<const Picture>();
  }
};

std::vector<std::size_t> shown(const VideoPart& part, int first, int count) {
  std::vector<std::size_t> all;
  for (int f = first; f < first + count; ++f) all.push_back(picture_shown(Ten(), part, f / 24.0));
  return all;
}
using Numbers = std::vector<std::size_t>;

TEST(VideoTime, PlaysFromItsTimeAndStandsStillAround) {
  EXPECT_EQ(shown({.at = 2 / 24.0, .until = 1e6}, 0, 5), (Numbers{0, 0, 0, 1, 2}));
  EXPECT_EQ(shown({.at = 2 / 24.0, .until = 1e6}, 10, 4), (Numbers{8, 9, 9, 9}));
  EXPECT_EQ(shown({.until = 1e6}, 1000, 1), (Numbers{9}));
}
TEST(VideoTime, APartIsPlayed) {
  EXPECT_EQ(shown({.from = 3 / 24.0, .until = 6 / 24.0}, 0, 5), (Numbers{3, 4, 5, 5, 5}));
  EXPECT_EQ(shown({.from = 5 / 24.0, .until = 2 / 24.0}, 0, 2), (Numbers{2, 2}));  // nothing is between them
}
TEST(VideoTime, Loops) {
  EXPECT_EQ(shown({.from = 3 / 24.0, .until = 6 / 24.0, .loop = true}, 0, 7), (Numbers{3, 4, 5, 3, 4, 5, 3}));
  for (int k = 0; k < 10'000; ++k)
    ASSERT_EQ(picture_shown(Ten(), {.until = 1e6, .loop = true}, k / 24.0), static_cast<std::size_t>(k % 10)) << k;
}
TEST(VideoTime, HasASpeed) {
  EXPECT_EQ(shown({.until = 1e6, .speed = 0.5}, 0, 5), (Numbers{0, 0, 1, 1, 2}));
  EXPECT_EQ(shown({.until = 1e6, .speed = 3}, 0, 5), (Numbers{0, 3, 6, 9, 9}));
  EXPECT_EQ(shown({.until = 1e6, .speed = 0}, 0, 3), (Numbers{0, 0, 0}));
  EXPECT_EQ(shown({.until = 1e6, .speed = -1}, 0, 4), (Numbers{9, 8, 7, 6}));
  EXPECT_EQ(shown({.until = 1e6, .speed = -1}, 8, 3), (Numbers{1, 0, 0}));
  EXPECT_EQ(shown({.until = 1e6, .speed = -1, .loop = true}, 8, 4), (Numbers{1, 0, 9, 8}));
}
TEST(VideoTime, FollowsATrack) {
  const Ten v;
  EXPECT_EQ(picture_at_time(v, 4.5 / 24, false), 4u);
  EXPECT_EQ(picture_at_time(v, -1, false), 0u);
  EXPECT_EQ(picture_at_time(v, 12 / 24.0, false), 9u);
  EXPECT_EQ(picture_at_time(v, 12 / 24.0, true), 2u);
  EXPECT_EQ(v.picture_at(1e300), 9u);
}
TEST(VideoTime, EndingsNameVideos) {
  EXPECT_TRUE(names_video("a/b.MP4"));
  EXPECT_TRUE(names_video("x.webm"));
  EXPECT_FALSE(names_video("mp4"));
  EXPECT_FALSE(names_video("a.png"));
}

}  // namespace
}  // namespace betwixt
