// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The pictures of the videos of these tests say their own numbers: a column for each bit, white or black.
#include "exchange/videos.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>
#include <thread>

#include "exchange/kept_frames.h"
#include "exchange/video_index.h"
#include "support/folder.h"

namespace betwixt {
namespace {

constexpr int bits = 8, column = 16, high = 64;

class Videos : public testing::Test {
 protected:
  std::string path(const std::string& name) const { return (folder_.path() / name).string(); }
  static void run(const std::string& command) { ASSERT_EQ(std::system(command.c_str()), 0) << command; }
  // Makes a video of numbered pictures at 24 a second. `filter`: after the numbering.
  std::string made(const std::string& name, const std::string& options, int count = 200,
                   const std::string& filter = "null") const {
    run("ffmpeg -v error -y -f lavfi -i color=black:size=" + std::to_string(bits * column) + "x" +
        std::to_string(high) + ":rate=24 -vf \"geq=lum='235*mod(floor(N/pow(2,floor(X/16))),2)':cb=128:cr=128," +
        filter + "\" -frames:v " + std::to_string(count) + " -pix_fmt yuv420p " + options + " '" + path(name) + "'");
    return path(name);
  }
  std::string copied(const std::string& from, const std::string& name, const std::string& options = "") const {
    run("ffmpeg -v error -y -i '" + from + "' -c copy " + options + " '" + path(name) + "'");
    return path(name);
  }
  static std::shared_ptr<const Video> opened(const std::string& file) {
    const auto read = read_video(file);
    EXPECT_TRUE(read) << (read ? "" : read.error().message);
    return read ? read->video : nullptr;
  }
  static std::string fails(const std::string& file) {
    const auto read = read_video(file);
    return read ? "it was read" : read.error().message;
  }
  // The number that a picture says. `turned`: it is turned, so the bits are rows: 1 from the top, -1 from the bottom.
  static int number_in(const Picture& p, int turned = 0) {
    int number = 0;
    for (int k = 0; k < bits; ++k) {
      const int along = k * column + column / 2, x = turned == 0 ? along : p.width / 2;
      const int y = turned == 0 ? p.height / 2 : turned > 0 ? along : p.height - 1 - along;
      if (p.rgba[4 * static_cast<std::size_t>(y * p.width + x)] > 127) number |= 1 << k;
    }
    return number;
  }
  static int shown(const Video& v, double second) {
    const auto picture = v.picture(v.picture_at(second));
    EXPECT_TRUE(picture) << (picture ? "" : picture.error().message);
    return picture ? number_in(**picture) : -1;
  }
  const Folder folder_;
};

constexpr const char* b_frames = "-c:v libx264 -bf 3 -g 60";

TEST_F(Videos, EveryTimeShowsItsPictureInAnyOrder) {
  const std::string mp4 = made("a.mp4", b_frames);
  for (const std::string& file :
       {mp4, copied(mp4, "a.mkv"), copied(mp4, "a.mov"), copied(mp4, "a.avi"),
        made("a.webm", "-c:v libvpx-vp9 -g 70 -deadline realtime -cpu-used 8"),
        made("m.avi", "-c:v mpeg4 -bf 2 -q:v 2"),
        made("o.mp4", "-c:v libx264 -bf 3 -x264-params open-gop=1:keyint=50:min-keyint=50")}) {
    const auto v = opened(file);
    ASSERT_TRUE(v);
    EXPECT_EQ(v->begins.size(), 200u) << file;
    EXPECT_EQ(v->width, bits * column) << file;
    EXPECT_EQ(v->height, high) << file;
    EXPECT_EQ(v->aspect, 2) << file;
    EXPECT_NEAR(v->seconds(), 200 / 24.0, 1e-3) << file;
    std::vector<int> order(200);
    for (int i = 0; i < 200; ++i) order[static_cast<std::size_t>(i)] = i;
    std::shuffle(order.begin(), order.end(), std::mt19937(7));
    order.resize(20);
    for (const int n : {0, 1, 2, 3, 100, 99, 98, 60, 59, 199, 197, 120, 119}) order.push_back(n);
    for (const int n : order) {
      EXPECT_EQ(shown(*v, n / 24.0), n) << file;
      EXPECT_EQ(shown(*v, (n + 0.9) / 24.0), n) << file;
    }
    EXPECT_EQ(shown(*v, -5), 0);
    EXPECT_EQ(shown(*v, 1e6), 199);
  }
}

// The pictures with the numbers 0 1 4 9 16 … stay at their times.
TEST_F(Videos, VariableRatesAreShownByTheirTimes) {
  std::string squares = "eq(n,0)";
  for (int k = 1; k < 14; ++k) squares += "+eq(n," + std::to_string(k * k) + ")";
  for (const char* name : {"v.mp4", "v.mkv"}) {
    const std::string file = made(name, std::string(b_frames) + " -fps_mode vfr", 14, "select='" + squares + "'");
    const auto v = opened(file);
    ASSERT_TRUE(v);
    EXPECT_EQ(v->begins.size(), 14u);
    for (int n = 0; n < 169; ++n) {
      const int root = static_cast<int>(std::sqrt(n + 1e-9));
      EXPECT_EQ(shown(*v, n / 24.0), root * root) << name << " " << n;
    }
  }
}

TEST_F(Videos, FlagsOfRotationAreHonoured) {
  const std::string file = made("a.mp4", b_frames, 60);
  const auto left = opened(copied(file, "l.mp4", "-metadata:s:v rotate=90")),
             right = opened(copied(file, "r.mp4", "-metadata:s:v rotate=270")),
             over = opened(copied(file, "o.mp4", "-metadata:s:v rotate=180"));
  ASSERT_TRUE(left && right && over);
  EXPECT_EQ(left->width, high);
  EXPECT_EQ(left->height, bits * column);
  EXPECT_EQ(left->aspect, 0.5);
  // ffmpeg writes a turn by 90 degrees against the clock: the left side is down.
  EXPECT_EQ(number_in(**left->picture(37), -1), 37);
  EXPECT_EQ(number_in(**right->picture(37), 1), 37);
  EXPECT_EQ(number_in(**over->picture(37)), 0b10100100);
}

TEST_F(Videos, PixelsNeedNotBeSquares) {
  const auto v = opened(made("a.mp4", b_frames, 5, "setsar=2/1"));
  ASSERT_TRUE(v);
  EXPECT_EQ(v->width, bits * column);
  EXPECT_EQ(v->aspect, 4);
}

TEST_F(Videos, ColorsAreThoseOfTheStandardThatTheFileNames) {
  // Pure red, 255 0 0, is another triple of luma and chroma in BT.601 and in BT.709.
  for (const char* matrix : {"bt709", "smpte170m"}) {
    const std::string file = path(std::string(matrix) + ".mp4");
    run("ffmpeg -v error -y -f lavfi -i color=red:size=64x64:rate=24 -frames:v 3 -vf scale=out_color_matrix=" +
        std::string(matrix) + ":out_range=tv,format=yuv444p -c:v libx264 -qp 0 -colorspace " + matrix + " '" + file +
        "'");
    const auto v = opened(file);
    ASSERT_TRUE(v);
    const auto p = *v->picture(1);
    for (const auto& [at, is] : {std::pair{0, 254}, {1, 0}, {2, 0}, {3, 255}})
      EXPECT_NEAR(p->rgba[4 * 32 * 64 + static_cast<std::size_t>(at)], is, 2) << matrix << at;
  }
}

TEST_F(Videos, TransparencyIsKept) {
  const std::string file = path("t.webm");
  run("ffmpeg -v error -y -f lavfi -i color=red@0.5:size=64x64:rate=24,format=rgba -frames:v 4 -c:v libvpx-vp9 "
      "-pix_fmt yuva420p '" +
      file + "'");
  const auto v = opened(file);
  ASSERT_TRUE(v);
  EXPECT_NEAR((*v->picture(2))->rgba[3], 128, 2);
}

TEST_F(Videos, ThreadsGetTheSamePictures) {
  const auto v = opened(made("a.mp4", b_frames));
  const auto w = opened(path("a.mp4"));
  ASSERT_TRUE(v && w);
  std::vector<std::vector<std::uint8_t>> one(200), other(200);
  for (std::size_t n = 0; n < 200; ++n) one[n] = (*v->picture(n))->rgba;
  std::vector<std::thread> threads;
  for (std::size_t k = 0; k < 4; ++k)
    threads.emplace_back([&, k] {
      for (std::size_t n = 199 - k; n < 200; n -= 4) other[n] = (*w->picture(n))->rgba;
    });
  for (std::thread& t : threads) t.join();
  EXPECT_TRUE(one == other);
}

TEST_F(Videos, WhatIsLeftOfATruncatedFileIsUsed) {
  const std::string whole = made("a.mkv", b_frames), part = path("b.mkv");
  std::filesystem::copy_file(whole, part);
  std::filesystem::resize_file(part, std::filesystem::file_size(whole) * 6 / 10);
  const auto v = opened(part);
  ASSERT_TRUE(v);
  EXPECT_GT(v->begins.size(), 50u);
  EXPECT_LT(v->begins.size(), 160u);
  EXPECT_EQ(shown(*v, 30 / 24.0), 30);
  EXPECT_TRUE(v->picture(v->begins.size() - 1));

  const std::string fast = copied(made("a.mp4", b_frames), "fast.mp4", "-movflags faststart");
  std::filesystem::resize_file(fast, std::filesystem::file_size(fast) * 6 / 10);
  const auto read = read_video(fast);
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_NE(read->warning.find("fast.mp4 is damaged, so not all of it is shown"), std::string::npos) << read->warning;
  EXPECT_EQ(shown(*read->video, 30 / 24.0), 30);
}

TEST_F(Videos, WhatIsNoVideoIsSaidInWords) {
  EXPECT_EQ(fails(path("none.mp4")), "there is no file '" + path("none.mp4") + "'");
  std::ofstream(path("empty.mp4")).close();
  EXPECT_NE(fails(path("empty.mp4")).find("empty.mp4 is broken or not a video: "), std::string::npos);
  std::ofstream garbage(path("g.mp4"), std::ios::binary);
  std::mt19937 random(5);
  for (int i = 0; i < 10'000; ++i) garbage.put(static_cast<char>(random()));
  garbage.close();
  EXPECT_NE(fails(path("g.mp4")).find("g.mp4 is broken or not a video: "), std::string::npos);
  run("ffmpeg -v error -y -f lavfi -i sine=duration=1 '" + path("s.mp4") + "'");
  EXPECT_EQ(fails(path("s.mp4")), path("s.mp4") + " is broken or not a video: it has no pictures");
  const std::string cut = made("a.mp4", b_frames);
  std::filesystem::resize_file(cut, std::filesystem::file_size(cut) / 2);  // its table of pictures is at the end
  EXPECT_NE(fails(cut).find("a.mp4 is broken or not a video: "), std::string::npos) << fails(cut);
  std::ofstream(path("list.mp4")) << "#EXTM3U\n#EXTINF:1,\n/etc/passwd\n";
  EXPECT_NE(fails(path("list.mp4")).find("is broken or not a video"), std::string::npos);
}

TEST_F(Videos, DamageInTheMiddleShowsWhatCanBeDecoded) {
  const std::string file = made("a.mkv", b_frames);
  std::fstream f(file, std::ios::binary | std::ios::in | std::ios::out);
  f.seekp(static_cast<std::streamoff>(std::filesystem::file_size(file) / 2));
  for (int i = 0; i < 400; ++i) f.put('\x55');
  f.close();
  const auto v = opened(file);
  ASSERT_TRUE(v);
  for (std::size_t n = 0; n < v->begins.size(); ++n) {
    const auto p = v->picture(n);
    ASSERT_TRUE(p);
    EXPECT_EQ((*p)->width, bits * column);
  }
  EXPECT_EQ(shown(*v, 5 / 24.0), 5);
}

TEST_F(Videos, AFileThatChangesIsNoticed) {
  const std::string file = made("a.mp4", b_frames);
  const auto v = opened(file);
  ASSERT_TRUE(v);
  std::filesystem::remove(file);
  const auto read = v->picture(150);
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().message, file + " has changed, or is gone, since it was loaded");
}

TEST(VideoIndexes, LinesAreRead) {
  VideoIndex index;
  EXPECT_TRUE(
      take_lines("packet|pts=2002|duration=1001|flags=K_\npacket|pts=4004|duration=1001|flags=__\n"
                 "packet|pts=3003|duration=1001|flags=__\npacket|pts=1001|duration=1001|flags=_D\n"
                 "stream|codec_name=h264|width=1920|height=1080|sample_aspect_ratio=4:3|color_space=bt709|"
                 "avg_frame_rate=30000/1001|time_base=1/30000|side_data|rotation=-90\n",
                 index));
  EXPECT_EQ(index.times, (std::vector<std::int64_t>{2002, 3003, 4004}));
  EXPECT_EQ(index.keys, (std::vector<std::size_t>{0}));
  EXPECT_EQ(index.width, 1080);
  EXPECT_EQ(index.height, 1920);
  EXPECT_NEAR(index.aspect, 1080.0 / (1920 * 4 / 3.0), 1e-12);
  const VideoTimes times = times_of(index);
  constexpr std::int64_t picture = 23'543'520;  // 1001/30000 s
  EXPECT_EQ(times.begins, (std::vector<std::int64_t>{0, picture, 2 * picture}));
  EXPECT_EQ(times.end, 3 * picture);
}

TEST(VideoIndexes, NonsenseIsNoIndex) {
  for (const char* lines : {"", "packet|pts=1\n", "stream|width=-3|height=x|time_base=0/0\n", "|||\n=\n",
                            "packet|pts=999999999999999999999|flags=K_\n"}) {
    VideoIndex index;
    take_lines(lines, index);
    EXPECT_GE(index.width, 0);
    EXPECT_GT(index.clock_den, 0);
  }
}

TEST(FramesInMemory, AreBounded) {
  KeptFrames kept(1000);
  const auto picture = std::make_shared<const Picture>(Picture{10, 10, std::vector<std::uint8_t>(400)});
  const int a = 0, b = 0;
  kept.add(&a, 1, picture), kept.add(&a, 2, picture);
  EXPECT_TRUE(kept.find(&a, 1));  // used last
  kept.add(&b, 1, picture);
  EXPECT_EQ(kept.bytes(), 800u);
  EXPECT_FALSE(kept.find(&a, 2));
  EXPECT_TRUE(kept.find(&a, 1));
  kept.forget(&a);
  EXPECT_FALSE(kept.find(&a, 1));
  EXPECT_TRUE(kept.find(&b, 1));
  EXPECT_EQ(kept.bytes(), 400u);
}

}  // namespace
}  // namespace betwixt
