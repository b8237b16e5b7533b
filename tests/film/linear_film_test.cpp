// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests films of linear light and transparent films, as ffmpeg reads them.
#include <algorithm>
#include <cmath>

#include "betwixt/picture.h"
#include "film/films.h"
#include "film/formats.h"
#include "film/sink.h"
#include "support/told.h"

namespace betwixt {
namespace {

double encoded(double l) { return l <= 0.0031308 ? 12.92 * l : 1.055 * std::pow(l, 1 / 2.4) - 0.055; }

// In 16 columns each of 4 pixels: ever less light from the left, ever more of it seen through from the top.
float step(int i) { return static_cast<float>(i) / 15; }
LinearPicture steps() {
  LinearPicture p{64, 64, {}};
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) {
      const float opacity = 1 - step(y / 4), light = opacity * (1 - step(x / 4));
      p.rgba.insert(p.rgba.end(), {light, light, light, opacity});
    }
  return p;
}
std::function<Result<LinearPainter>()> showing(const LinearPicture& p) {
  return [p]() -> Result<LinearPainter> {
    return LinearPainter([p](int, LinearPicture& out) { return out = p, Nothing{}; });
  };
}
FilmOptions of_steps(FilmOptions o) {
  o.width = o.height = 64, o.frames = 1;
  return o;
}

bool told(const std::vector<std::string>& words, const std::string& option, const std::string& value) {
  for (std::size_t i = 0; i + 1 < words.size(); ++i)
    if (words[i] == option && words[i + 1] == value) return true;
  return false;
}

TEST(FilmArguments, WhatIsClearIsSaidToTheEncoder) {
  FilmOptions o;
  o.width = 3, o.height = 5;
  for (const bool alpha : {false, true}) {
    o.alpha = alpha;
    const auto words = [&](const char* ending) { return encoder_arguments(o, *find_format(ending), "f"); };
    EXPECT_TRUE(told(words(".webm"), "-pix_fmt", alpha ? "yuva420p" : "yuv420p"));
    EXPECT_EQ(told(words(".webm"), "-auto-alt-ref", "0"), alpha);
    EXPECT_TRUE(told(words(".webm"), "-video_size", "4x6"));
    EXPECT_TRUE(told(words(".mov"), "-pix_fmt", "rgba64le"));
    EXPECT_TRUE(told(words(".mov"), "-pix_fmt", alpha ? "yuva444p10le" : "yuv444p10le"));
    EXPECT_TRUE(told(words(".mov"), "-video_size", "3x5"));
    EXPECT_TRUE(told(words(".mov"), "-alpha_bits", alpha ? "16" : "0"));
    for (const char* ending : {".gif", ".apng"}) EXPECT_TRUE(told(words(ending), "-pix_fmt", "rgba")) << ending;
  }
}

TEST(FilmNames, SayWhatFilmsCanHave) {
  const auto what = [](const std::string& path) {
    return std::array{takes_sound(path), takes_alpha(path), takes_16_bits(path), takes_unclamped_light(path)};
  };
  EXPECT_EQ(what("a.mp4"), (std::array{true, false, false, false}));
  EXPECT_EQ(what("a.webm"), (std::array{true, true, false, false}));
  EXPECT_EQ(what("a.MOV"), (std::array{true, true, true, false}));
  EXPECT_EQ(what("a.gif"), (std::array{false, true, false, false}));
  EXPECT_EQ(what("a.apng"), (std::array{false, true, false, false}));
  EXPECT_EQ(what("a-%d.png"), (std::array{false, true, false, false}));
  EXPECT_EQ(what("a-%d.exr"), (std::array{false, true, true, true}));
  EXPECT_EQ(what("a.tiff"), (std::array{false, false, false, false}));
}

// Light of every opacity: straight, and as bright as it is where something covers it.
TEST_F(Film, WhatIsClearComesBack) {
  const LinearPicture p = steps();
  for (const std::string name : {"film.webm", "film.mov", "film.apng", "film-%d.png"}) {
    FilmOptions o = of_steps(options(name));
    o.alpha = true;
    const auto made = make_linear_film(o, showing(p));
    ASSERT_TRUE(made) << name << ": " << made.error().message;
    const std::string all = decode(o.path, "rgba", name == "film.webm" ? "-c:v libvpx-vp9" : "");
    ASSERT_EQ(all.size(), 4U * 64 * 64) << name;
    const bool exact = name.find("png") != std::string::npos;
    for (int y = 2; y < 64; y += 4)
      for (int x = 2; x < 64; x += 4) {
        const auto at = [&](int c) {
          return static_cast<unsigned char>(all[static_cast<std::size_t>(4 * (64 * y + x) + c)]);
        };
        const double opacity = 1 - step(y / 4), light = 255 * encoded(1 - step(x / 4));
        EXPECT_NEAR(at(3), 255 * opacity, exact ? 0.51 : 3) << name << ' ' << x << ' ' << y;
        EXPECT_NEAR(at(1) * opacity, light * opacity, exact ? 0.51 : 6) << name << ' ' << x << ' ' << y;
      }
  }
}

TEST_F(Film, ProResIsTaggedAndHasTenBits) {
  for (const bool alpha : {false, true}) {
    FilmOptions o = of_steps(options("film.mov"));
    o.alpha = alpha;
    ASSERT_TRUE(make_linear_film(o, showing(steps())));
    EXPECT_EQ(
        probe(o.path, "codec_name,profile,codec_tag_string,color_range,color_space,color_transfer,color_primaries"),
        "prores,4444,ap4h,tv,bt709,bt709,bt709");
    const std::string format = probe(o.path, "pix_fmt");
    EXPECT_EQ(format.find("yuva444p"), alpha ? 0 : std::string::npos) << format;
  }
  // Of 600 steps of grey near each other more are told apart than bytes could.
  LinearPicture fine{600, 64, {}};
  for (int i = 0; i < 600 * 64; ++i) {
    const float light = 0.2F + 0.1F * static_cast<float>(i % 600) / 600;
    fine.rgba.insert(fine.rgba.end(), {light, light, light, 1});
  }
  FilmOptions o = of_steps(options("fine.mov"));
  o.width = 600;
  ASSERT_TRUE(make_linear_film(o, showing(fine)));
  const std::string all = decode(o.path, "gray16le");
  ASSERT_EQ(all.size(), 2U * 600 * 64);
  std::vector<int> seen;
  for (int x = 0; x < 600; ++x)
    seen.push_back(static_cast<unsigned char>(all[static_cast<std::size_t>(2 * (600 * 32 + x))]) +
                   256 * static_cast<unsigned char>(all[static_cast<std::size_t>(2 * (600 * 32 + x) + 1)]));
  std::sort(seen.begin(), seen.end());
  const auto different = std::unique(seen.begin(), seen.end()) - seen.begin();
  EXPECT_GT(different, 60) << "bytes have 27 there";
}

// Where a film has no opacity, what is seen through is over black, in light: half of white is 188, not 128.
TEST_F(Film, WithoutOpacityItIsOverBlack) {
  const LinearPicture half{64, 48, std::vector<float>(4 * 64 * 48, 0.5F)};
  Picture shown;
  to_shown(half, shown);
  ASSERT_EQ(shown.rgba[0], 255);
  ASSERT_EQ(shown.rgba[3], 128);
  const auto bytes = painting([&](int, Picture& out) -> Status { return out = shown, Nothing{}; });
  for (const std::string name : {"film.mp4", "film.webm", "film.mov", "film.apng"}) {
    FilmOptions o = options(name, 2);
    o.alpha = name == "film.mp4";  // which cannot
    for (const bool linear : {false, true}) {
      ASSERT_TRUE(linear ? make_linear_film(o, showing(half)) : make_film(o, bytes));
      const std::string all = decode(o.path, "rgba");
      EXPECT_NEAR(static_cast<unsigned char>(all[4 * (64 * 24 + 32)]), 188, 3) << name << linear;
      EXPECT_EQ(static_cast<unsigned char>(all[4 * (64 * 24 + 32) + 3]), 255) << name << linear;
    }
  }
}

TEST_F(Film, NumberedPicturesOfLight) {
  LinearPicture bright = steps();
  bright.rgba[0] = 7;
  FilmOptions o = of_steps(options("f-%02d.exr"));
  o.frames = 2;
  ASSERT_TRUE(make_linear_film(o, showing(bright)));
  EXPECT_EQ(files(), (std::vector<std::string>{"f-01.exr", "f-02.exr"}));
  const auto back = read_linear_picture((folder_ / "f-01.exr").string());
  ASSERT_TRUE(back);
  EXPECT_EQ(back->rgba[0], 7);
  // Only those that are missing, or cut, or of another size.
  fs::remove(folder_ / "f-01.exr");
  o.only_missing = true;
  const auto again = make_linear_film(o, showing(bright));
  ASSERT_TRUE(again);
  EXPECT_EQ(again->found, 1);
  fs::resize_file(folder_ / "f-02.exr", fs::file_size(folder_ / "f-02.exr") - 9);
  ASSERT_EQ(make_linear_film(o, showing(bright))->found, 1);
  EXPECT_EQ(own_.get("f-02.exr"), own_.get("f-01.exr"));

  FilmOptions sixteen = of_steps(options("g-%d.png"));
  sixteen.bits = 16;
  ASSERT_TRUE(make_linear_film(sixteen, showing(steps())));
  EXPECT_EQ(probe(folder_ / "g-1.png", "pix_fmt"), "rgba64be");
}

TEST_F(Film, DepthThatCannotBeHadIsAnError) {
  const auto message = [&](FilmOptions o) {
    const auto made = make_film(o, gray_steps());
    return made ? std::string() : made.error().message;
  };
  EXPECT_EQ(message(options("f-%d.exr")), "pictures of linear light are needed for f-%d.exr");
  FilmOptions o = options("f-%d.png");
  o.bits = 16;
  EXPECT_NE(message(o).find("f-%d.png"), std::string::npos) << message(o);
  o.bits = 12;
  EXPECT_EQ(message(o), "a channel of a PNG must have 8 or 16 bits");
  for (const std::string name : {"f.mp4", "f.mov", "f-%d.exr"}) {
    o = options(name), o.bits = 16;
    EXPECT_EQ(message(o), "--bits 16 is only for numbered PNG; .mov and .exr always have more than 8 bits") << name;
  }
  EXPECT_EQ(files(), std::vector<std::string>{});
  const auto small = make_linear_film(options("f.mov"), showing(steps()));  // 64x48 was wanted
  ASSERT_FALSE(small);
  EXPECT_EQ(told(small), "range");
  EXPECT_TRUE(mentions(small, "64x64") && mentions(small, "64x48"));
}

}  // namespace
}  // namespace betwixt
