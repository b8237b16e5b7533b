// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests the file that each ending of a name gives, as players see it.
#include "film/formats.h"

#include <algorithm>
#include <random>

#include "film/films.h"
#include "film/sink.h"

namespace betwixt {
namespace {

// shows: G56
TEST_F(Film, EveryEndingHasAllFramesAtItsRate) {
  for (const std::string& name : movies) {
    FilmOptions o = options(name, 10);
    o.rate = {25, 1};
    const auto made = make_film(o, gray_steps());
    ASSERT_TRUE(made) << name << ": " << made.error().message;
    EXPECT_EQ(made->frames, 10);
    EXPECT_EQ(probe(o.path, "width,height,r_frame_rate,nb_read_frames"), "64,48,25/1,10") << name;
  }
  EXPECT_EQ(files(), (std::vector<std::string>{"film.apng", "film.gif", "film.mov", "film.mp4", "film.webm"}));
}

TEST_F(Film, RatesAreExactFractions) {
  FilmOptions o = options("ntsc.mp4");
  o.rate = {30000, 1001};
  ASSERT_TRUE(make_film(o, gray_steps()));
  EXPECT_EQ(probe(o.path, "r_frame_rate"), "30000/1001");
}

TEST_F(Film, GifAndApngLoopForEver) {
  for (const std::string name : {"film.gif", "film.apng"}) ASSERT_TRUE(make_film(options(name), gray_steps()));
  // GIF: the application extension with a count of 0. APNG: acTL with num_plays 0.
  EXPECT_NE(own_.get("film.gif").find(std::string("NETSCAPE2.0\x03\x01\0\0", 15)), std::string::npos);
  const std::string apng = own_.get("film.apng");
  const std::size_t at = apng.find("acTL");
  ASSERT_NE(at, std::string::npos);
  EXPECT_EQ(apng.substr(at + 4, 8), std::string("\0\0\0\6\0\0\0\0", 8));
}

TEST_F(Film, Mp4StartsWithItsIndex) {
  ASSERT_TRUE(make_film(options("film.mp4"), gray_steps()));
  const std::string all = own_.get("film.mp4");
  EXPECT_LT(all.find("moov"), all.find("mdat"));
}

// BT.709 by its definition, from the decoded planes: what comes back is what was painted.
TEST_F(Film, PureColorsComeBack) {
  const std::vector<Rgb> colors{{255, 0, 0},   {0, 255, 0},     {0, 0, 255}, {255, 255, 0},   {0, 255, 255},
                                {255, 0, 255}, {255, 255, 255}, {0, 0, 0},   {128, 128, 128}, {255, 215, 0}};
  for (const std::string name : {"film.mp4", "film.webm"}) {
    FilmOptions o = options(name, static_cast<int>(colors.size()));
    ASSERT_TRUE(make_film(o, painting([&](int k, Picture& out) -> Status {
                            out = plain(64, 48, colors[static_cast<std::size_t>(k)]);
                            return Nothing{};
                          })));
    EXPECT_EQ(probe(o.path, "color_space,color_range"), "tv,bt709") << name;
    const std::string yuv = decode(o.path, "yuv420p");
    const std::size_t size = 64 * 48 * 3 / 2;
    ASSERT_EQ(yuv.size(), size * colors.size()) << name;
    for (std::size_t k = 0; k < colors.size(); ++k) {
      const auto at = [&](std::size_t i) { return static_cast<double>(static_cast<unsigned char>(yuv[k * size + i])); };
      const double y = (at(64 * 24 + 32) - 16) / 219;
      const double cb = (at(64 * 48 + 32 * 12 + 16) - 128) / 224, cr = (at(64 * 60 + 32 * 12 + 16) - 128) / 224;
      const double r = y + 2 * (1 - 0.2126) * cr, b = y + 2 * (1 - 0.0722) * cb;
      const double g = (y - 0.2126 * r - 0.0722 * b) / 0.7152;
      EXPECT_NEAR(255 * r, colors[k][0], 5) << name << " " << k;
      EXPECT_NEAR(255 * g, colors[k][1], 5) << name << " " << k;
      EXPECT_NEAR(255 * b, colors[k][2], 5) << name << " " << k;
    }
    // A player that looks at the tags gets the same.
    const std::string rgb = decode(o.path, "rgb24");
    for (std::size_t k = 0; k < colors.size(); ++k)
      for (std::size_t c = 0; c < 3; ++c)
        EXPECT_NEAR(static_cast<unsigned char>(rgb[(k * 64 * 48 + 64 * 24 + 32) * 3 + c]), colors[k][c], 8)
            << name << " " << k;
  }
}

TEST_F(Film, ApngKeepsEveryBit) {
  std::mt19937 random(7);
  Picture noise{64, 48, {}};
  for (int i = 0; i < 64 * 48 * 4; ++i)
    noise.rgba.push_back(static_cast<std::uint8_t>(i % 4 == 3 ? 255 : random() & 255));
  FilmOptions o = options("film.apng", 1);
  ASSERT_TRUE(make_film(o, painting([&](int, Picture& out) -> Status { return out = noise, Nothing{}; })));
  EXPECT_EQ(decode(o.path, "rgba"), std::string(noise.rgba.begin(), noise.rgba.end()));
}

TEST_F(Film, OddSizesBecomeEvenByRepeatingTheEdge) {
  for (const std::string name : {"odd.mp4", "odd.webm"}) {
    FilmOptions o = options(name, 2);
    o.width = 33, o.height = 17;
    ASSERT_TRUE(make_film(o, painting([](int, Picture& out) -> Status {
                            out = plain(33, 17, {255, 255, 255});
                            return Nothing{};
                          })));
    EXPECT_EQ(probe(o.path, "width,height"), "34,18") << name;
    const std::string gray = decode(o.path, "gray");
    EXPECT_GT(static_cast<unsigned char>(gray[34 * 18 - 1]), 230) << name;  // the corner that was added
  }
}

TEST_F(Film, ASinglePixelIsAFilmToo) {
  for (const std::string& name : movies) {
    FilmOptions o = options(name, 2);
    o.width = o.height = 1;
    const auto made = make_film(o, gray_steps(1, 1));
    EXPECT_TRUE(made) << name << ": " << made.error().message;
  }
}

TEST(FilmArguments, LongGifsDoNotKeepAllTheirPictures) {
  FilmOptions o;
  o.frames = 100000;
  const auto all = encoder_arguments(o, *find_format(".gif"), "x.gif");
  EXPECT_TRUE(std::any_of(all.begin(), all.end(),
                          [](const auto& a) { return a.find("stats_mode=single") != std::string::npos; }));
  EXPECT_EQ(all.back(), "file:x.gif");
}

}  // namespace
}  // namespace betwixt
