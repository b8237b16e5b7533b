// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests films with more colours and more light, as ffmpeg and ffprobe see them.
#include <algorithm>
#include <cmath>
#include <cstring>

#include "betwixt/picture.h"
#include "film/films.h"
#include "film/formats.h"

namespace betwixt {
namespace {

LinearPicture of_light(int width, int height, std::array<float, 3> c) {
  LinearPicture p{width, height, {}};
  for (int i = 0; i < width * height; ++i) p.rgba.insert(p.rgba.end(), {c[0], c[1], c[2], 1});
  return p;
}
std::function<Result<LinearPainter>()> lit(std::array<float, 3> c) {
  return [c]() -> Result<LinearPainter> {
    return LinearPainter([c](int, LinearPicture& out) -> Status { return out = of_light(64, 64, c), Nothing{}; });
  };
}
// Luma, Cb and Cr of 10 bits in the middle of the k-th picture.
std::array<int, 3> middle_of(const std::string& raw, std::size_t k) {
  std::array<int, 3> all{};
  for (std::size_t plane = 0; plane < 3 && raw.size() >= 64 * 64 * 6 * (k + 1); ++plane) {
    const std::size_t at = 2 * ((3 * k + plane) * 64 * 64 + 32 * 64 + 32);
    all[plane] = static_cast<unsigned char>(raw[at]) | static_cast<unsigned char>(raw[at + 1]) << 8;
  }
  return all;
}

FilmOptions square(FilmOptions o, ColorCoding colors) {  // AV1 needs 64 rows
  o.height = 64, o.colors = colors;
  return o;
}

TEST_F(Film, ColorsAreTagged) {
  struct Row {
    ColorCoding colors;
    const char *name, *codec, *tags;
  };
  for (const Row& row : {Row{ColorCoding::pq, "a.mp4", "", "yuv420p10le,tv,bt2020nc,smpte2084,bt2020"},
                         Row{ColorCoding::pq, "b.mp4", "av1", "yuv420p10le,tv,bt2020nc,smpte2084,bt2020"},
                         Row{ColorCoding::hlg, "c.mp4", "h265", "yuv420p10le,tv,bt2020nc,arib-std-b67,bt2020"},
                         Row{ColorCoding::pq, "d.webm", "", "yuv420p10le,tv,bt2020nc,smpte2084,bt2020"},
                         Row{ColorCoding::hlg, "e.mov", "", "yuv444p12le,tv,bt2020nc,arib-std-b67,bt2020"},
                         Row{ColorCoding::p3, "f.mp4", "", "yuv420p10le,tv,bt709,iec61966-2-1,smpte432"},
                         Row{ColorCoding::rec2020, "g.webm", "", "yuv420p10le,tv,bt2020nc,iec61966-2-1,bt2020"}}) {
    FilmOptions o = square(options(row.name, 2), row.colors);
    o.codec = row.codec;
    const auto made = make_linear_film(o, lit({1, 1, 1}));
    ASSERT_TRUE(made) << row.name << ": " << made.error().message;
    EXPECT_EQ(probe(o.path, "pix_fmt,color_range,color_space,color_transfer,color_primaries"), row.tags) << row.name;
  }
}

TEST_F(Film, PqSaysItsScreen) {
  for (const char* codec : {"h265", "av1"}) {
    FilmOptions o = square(options("film.mp4", 2), ColorCoding::pq);
    o.codec = codec;
    ASSERT_TRUE(make_linear_film(o, lit({1, 1, 1})));
    const std::string said = output_of("ffprobe -v error -show_frames -read_intervals '%+#1' '" + o.path + "'");
    for (const char* what : {"Mastering display metadata", "Content light level metadata", "max_content=1000"})
      EXPECT_NE(said.find(what), std::string::npos) << codec << what;
  }
}

// By the equations of BT.2100 and BT.2020, written out for each patch.
TEST_F(Film, LightIsCodedByTheEquations) {
  const auto pq = [](double nits) {
    const double y = std::pow(nits / 10000, 0.1593017578125);
    return std::pow((0.8359375 + 18.8515625 * y) / (1 + 18.6875 * y), 78.84375);
  };
  const auto hlg = [](double e) {
    return e <= 1.0 / 12 ? std::sqrt(3 * e) : 0.17883277 * std::log(12 * e - 0.28466892) + 0.55991073;
  };
  const std::vector<std::array<float, 3>> patches{
      {0, 0, 0}, {0.18F, 0.18F, 0.18F}, {1, 1, 1}, {4, 4, 4}, {9, 9, 9}, {1, 0, 0}, {0, 2, 0}, {0.3F, 0.1F, 3}};
  for (const auto coding : {ColorCoding::pq, ColorCoding::hlg})
    for (const char* name : {"film.mp4", "film.mov", "film.webm"}) {
      FilmOptions o = square(options(name, static_cast<int>(patches.size())), coding);
      if (!o.path.ends_with(".mov")) o.quality = 100;
      ASSERT_TRUE(make_linear_film(o, [&]() -> Result<LinearPainter> {
        return LinearPainter([&](int k, LinearPicture& out) -> Status {
          return out = of_light(64, 64, patches[static_cast<std::size_t>(k)]), Nothing{};
        });
      }));
      const std::string raw = decode(o.path, "yuv444p10le");
      for (std::size_t i = 0; i < patches.size(); ++i) {
        const auto& c = patches[i];
        double n[3];  // nits, in BT.2020
        const double r = static_cast<double>(c[0]), g = static_cast<double>(c[1]), b = static_cast<double>(c[2]);
        n[0] = 203 * (0.627404 * r + 0.329283 * g + 0.043313 * b);
        n[1] = 203 * (0.069097 * r + 0.919540 * g + 0.011362 * b);
        n[2] = 203 * (0.016391 * r + 0.088013 * g + 0.895595 * b);
        for (double& x : n) x = std::min(x, 1000.0);
        const double y = 0.2627 * n[0] + 0.678 * n[1] + 0.0593 * n[2];
        double s[3];
        for (int k = 0; k < 3; ++k)
          s[k] = coding == ColorCoding::pq ? pq(n[k]) : y > 0 ? hlg(n[k] / 1000 * std::pow(y / 1000, 1 / 1.2 - 1)) : 0;
        const double luma = 0.2627 * s[0] + 0.678 * s[1] + 0.0593 * s[2];
        const auto [is, cb, cr] = middle_of(raw, i);
        const std::string what = std::string(name) + " " + std::to_string(c[0]) + " " + std::to_string(c[2]);
        EXPECT_NEAR(is, 64 + 876 * luma, 4) << what;
        EXPECT_NEAR(cb, 512 + 896 * (s[2] - luma) / 1.8814, 4) << what;
        EXPECT_NEAR(cr, 512 + 896 * (s[0] - luma) / 1.4746, 4) << what;
      }
    }
}

TEST_F(Film, NumberedPicturesSayTheirCoding) {
  FilmOptions o = square(options("p-%d.png", 1), ColorCoding::hlg);
  ASSERT_TRUE(make_linear_film(o, lit({2, 0.5F, 0.25F})));
  const std::string png = own_.get("p-1.png");
  const std::size_t at = png.find("cICP");
  ASSERT_NE(at, png.npos);
  EXPECT_EQ(png.substr(at + 4, 4), std::string("\x09\x12\0\x01", 4));
  const auto back = read_linear_picture((folder_ / "p-1.png").string());
  ASSERT_TRUE(back);
  EXPECT_NEAR(back->rgba[0], 2, 2e-3);
  EXPECT_NEAR(back->rgba[2], 0.25, 1e-3);

  o = square(options("e-%d.exr", 1), ColorCoding::rec2020);
  ASSERT_TRUE(make_linear_film(o, lit({2, 0.5F, 0.25F})));
  const auto light = read_linear_picture((folder_ / "e-1.exr").string());
  ASSERT_TRUE(light);
  EXPECT_NEAR(light->rgba[0], 2, 3e-3);
  EXPECT_NEAR(light->rgba[2], 0.25, 1e-3);
}

TEST_F(Film, ColorsAreRefusedWhereTheyHaveNoPlace) {
  const auto refused = [&](const char* name, ColorCoding colors, const char* codec = "", bool alpha = false) {
    FilmOptions o = options(name);
    o.colors = colors, o.codec = codec, o.alpha = alpha;
    const Status s = check_encoding(o);
    return s ? "" : s.error().message;
  };
  EXPECT_NE(refused("a.gif", ColorCoding::p3), "");
  EXPECT_NE(refused("a.apng", ColorCoding::pq), "");
  EXPECT_NE(refused("a-%d.exr", ColorCoding::pq), "");
  EXPECT_EQ(refused("a-%d.exr", ColorCoding::p3), "");
  EXPECT_NE(refused("a.mp4", ColorCoding::pq, "h264"), "");
  EXPECT_NE(refused("a.webm", ColorCoding::pq, "vp9"), "");
  EXPECT_NE(refused("a.webm", ColorCoding::pq, "", true), "");
  EXPECT_EQ(refused("a.mov", ColorCoding::pq, "", true), "");
  EXPECT_EQ(refused("a.webm", ColorCoding::srgb, "", true), "");
  EXPECT_FALSE(make_film(
      [&] {
        FilmOptions o = options("a.mp4");
        return o.colors = ColorCoding::pq, o;
      }(),
      painting([](int, Picture& out) -> Status {
        return out = plain(64, 48, {9, 9, 9}), Nothing{};
      })));
}

}  // namespace
}  // namespace betwixt
