// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests files of linear light: OpenEXR and PNG of 16 bits, written and read back, and damaged files.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <filesystem>
#include <limits>
#include <random>
#include <string>

#include "betwixt/picture.h"
#include "exchange/files.h"
#include "exchange/pictures.h"
#include "support/told.h"

namespace betwixt {
namespace {

namespace fs = std::filesystem;

// Light of up to 40 times white, and what is partly or wholly clear.
LinearPicture light(int width, int height) {
  std::mt19937 random(5);
  std::uniform_real_distribution<float> share(0, 1);
  LinearPicture p{width, height, {}};
  for (int i = 0; i < width * height; ++i) {
    const float opacity = i % 3 == 0 ? 1 : i % 3 == 1 ? share(random) : 0, most = i % 5 == 0 ? 40.0F : 1.0F;
    for (int c = 0; c < 3; ++c) p.rgba.push_back(opacity * most * share(random));
    p.rgba.push_back(opacity);
  }
  return p;
}

TEST_F(Files, LightComesBackFromOpenExrAsHalfFloats) {
  for (const auto& [w, h] : {std::pair{1, 1}, {7, 5}, {33, 17}, {64, 40}}) {
    const LinearPicture p = light(w, h);
    ASSERT_TRUE(write_exr(at("p.exr"), p));
    const auto q = read_linear_picture(at("p.exr"));
    ASSERT_TRUE(q) << q.error().message;
    EXPECT_EQ(q->width, w);
    EXPECT_EQ(q->height, h);
    ASSERT_EQ(q->rgba.size(), p.rgba.size());
    for (std::size_t i = 0; i < p.rgba.size(); ++i)  // eleven bits, or below 2^-14 steps of 2^-24
      ASSERT_NEAR(q->rgba[i], p.rgba[i], std::max(std::ldexp(p.rgba[i], -11), std::ldexp(1.0F, -25))) << i;
    ASSERT_TRUE(write_exr(at("again.exr"), *q));  // what is half a float stays so
    EXPECT_EQ(folder_.get("again.exr"), folder_.get("p.exr"));
  }
}

TEST_F(Files, OpenExrHasNumbersOnly) {
  constexpr float nan = std::numeric_limits<float>::quiet_NaN(), endless = std::numeric_limits<float>::infinity();
  ASSERT_TRUE(write_exr(at("p.exr"), {2, 1, {nan, endless, -endless, 1, 1e9F, 65504, -0.25F, nan}}));
  const auto q = read_linear_picture(at("p.exr"));
  ASSERT_TRUE(q);
  EXPECT_EQ(q->rgba, (std::vector<float>{0, 65504, -65504, 1, 65504, 65504, -0.25F, 0}));
}

TEST_F(Files, SixteenBitsComeBackAsLight) {
  LinearPicture p = light(40, 30);
  for (float& x : p.rgba) x = std::min(x, 1.0F);
  for (std::size_t i = 0; i < p.rgba.size(); ++i) p.rgba[i] = std::min(p.rgba[i], p.rgba[i / 4 * 4 + 3]);
  ASSERT_TRUE(write_png(at("p.png"), p));
  EXPECT_EQ(folder_.get("p.png")[24], 16) << "bits, in the head";
  EXPECT_NE(folder_.get("p.png").find("sRGB"), std::string::npos);
  const auto q = read_linear_picture(at("p.png"));
  ASSERT_TRUE(q) << q.error().message;
  for (std::size_t i = 0; i < p.rgba.size(); ++i) ASSERT_NEAR(q->rgba[i], p.rgba[i], 2e-5) << i;
  // The same with 8 bits, as everybody reads it.
  Picture bytes;
  to_shown(p, bytes);
  const auto eight = read_picture(at("p.png"));
  ASSERT_TRUE(eight);
  for (std::size_t i = 0; i < bytes.rgba.size(); ++i) ASSERT_NEAR((*eight)->rgba[i], bytes.rgba[i], 1) << i;
}

TEST_F(Files, EightBitsAreReadAsLightWithoutLoss) {
  Picture p{16, 16, {}}, q;
  for (int i = 0; i < 256; ++i)
    for (const int v : {i, 255 - i, i * 7 % 256, 255}) p.rgba.push_back(static_cast<std::uint8_t>(v));
  ASSERT_TRUE(write_png(at("p.png"), p));
  const auto light = read_linear_picture(at("p.png"));
  ASSERT_TRUE(light) << light.error().message;
  to_shown(*light, q);
  EXPECT_EQ(q.rgba, p.rgba);
}

// An OpenEXR file by its definition, not compressed: lines of whole channels of floats, which go by their names.
std::string number(std::uint64_t n, int bytes) {
  std::string s;
  for (int i = 0; i < bytes; ++i) s += static_cast<char>(n >> (8 * i));
  return s;
}
std::string plain_exr(const std::string& channels, int left, int top, int width, int height) {
  const auto attribute = [](const std::string& name, const std::string& type, const std::string& value) {
    return name + '\0' + type + '\0' + number(value.size(), 4) + value;
  };
  const auto box = [&](int x, int y) {
    return number(static_cast<std::uint32_t>(x), 4) + number(static_cast<std::uint32_t>(y), 4) +
           number(static_cast<std::uint32_t>(x + width - 1), 4) + number(static_cast<std::uint32_t>(y + height - 1), 4);
  };
  const auto single = [](float x) { return number(std::bit_cast<std::uint32_t>(x), 4); };
  std::string list;
  for (const char name : channels)
    list += std::string(1, name) + '\0' + number(2, 4) + number(0, 4) + number(1, 4) + number(1, 4);
  std::string all = number(20000630, 4) + number(2, 4) + attribute("channels", "chlist", list + '\0') +
                    attribute("compression", "compression", number(0, 1)) +
                    attribute("dataWindow", "box2i", box(left, top)) + attribute("displayWindow", "box2i", box(0, 0)) +
                    attribute("lineOrder", "lineOrder", number(0, 1)) +
                    attribute("pixelAspectRatio", "float", single(1)) +
                    attribute("screenWindowCenter", "v2f", single(0) + single(0)) +
                    attribute("screenWindowWidth", "float", single(1)) + '\0';
  const std::size_t line = 4 * channels.size() * static_cast<std::size_t>(width);
  const std::size_t begin = all.size() + 8 * static_cast<std::size_t>(height);
  for (int y = 0; y < height; ++y) all += number(begin + static_cast<std::size_t>(y) * (line + 8), 8);
  for (int y = 0; y < height; ++y) {
    all += number(static_cast<std::uint32_t>(top + y), 4) + number(line, 4);
    for (std::size_t c = 0; c < channels.size(); ++c)
      for (int x = 0; x < width; ++x) all += single(static_cast<float>(c) + 0.25F * static_cast<float>(y * width + x));
  }
  return all;
}

TEST_F(Files, OpenExrOfOthersIsRead) {
  // Without an opacity it is opaque, wherever its pixels lie.
  const auto opaque = read_linear_picture(put("rgb.exr", plain_exr("BGR", -3, 5, 2, 2)));
  ASSERT_TRUE(opaque) << opaque.error().message;
  EXPECT_EQ(opaque->rgba, (std::vector<float>{2, 1, 0, 1, 2.25, 1.25, 0.25, 1, 2.5, 1.5, 0.5, 1, 2.75, 1.75, 0.75, 1}));
  const auto clear = read_linear_picture(put("rgba.exr", plain_exr("ABGR", 0, 0, 1, 1)));
  ASSERT_TRUE(clear) << clear.error().message;
  EXPECT_EQ(clear->rgba, (std::vector<float>{3, 2, 1, 0}));
  const auto gray = read_linear_picture(put("y.exr", plain_exr("Y", 0, 0, 2, 1)));
  ASSERT_TRUE(gray) << gray.error().message;
  EXPECT_EQ(gray->rgba, (std::vector<float>{0, 0, 0, 1, 0.25, 0.25, 0.25, 1}));
  const auto wide = read_linear_picture(put("wide.exr", plain_exr("Y", 0, 0, 16385, 1)));
  EXPECT_EQ(told(wide), "range");
  EXPECT_TRUE(mentions(wide, at("wide.exr")) && mentions(wide, "16385") && mentions(wide, "16384"));
}

// Radiance: each pixel is three mantissas and a common exponent, in runs of each channel or pixel by pixel.
std::string radiance(int width, int height, bool runs) {
  std::string out =
      "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y " + std::to_string(height) + " +X " + std::to_string(width) + "\n";
  const auto channel = [&](int x, int y, int c) { return static_cast<char>(c == 3 ? 128 + y : 128 + 7 * x % 128 + c); };
  for (int y = 0; y < height; ++y) {
    if (runs) {
      out += {2, 2, static_cast<char>(width / 256), static_cast<char>(width % 256)};
      for (int c = 0; c < 4; ++c) {
        out += static_cast<char>(width);
        for (int x = 0; x < width; ++x) out += channel(x, y, c);
      }
    } else {
      for (int x = 0; x < width; ++x)
        for (int c = 0; c < 4; ++c) out += channel(x, y, c);
    }
  }
  return out;
}

TEST_F(Files, RadianceIsReadWholeOrNotAtAll) {
  for (const bool runs : {false, true}) {
    const std::string whole = radiance(40, 6, runs);
    const auto read = read_linear_picture(put("sky.hdr", whole));
    ASSERT_TRUE(read) << read.error().message;
    for (int y = 0; y < 6; ++y)
      for (int x = 0; x < 40; ++x)
        for (int c = 0; c < 3; ++c)
          EXPECT_FLOAT_EQ(read->rgba[static_cast<std::size_t>(4 * (40 * y + x) + c)],
                          std::ldexp(static_cast<float>((128 + 7 * x % 128 + c) & 255), y - 8));
    for (std::size_t length = 0; length < whole.size(); length += 7) {
      const auto cut = read_linear_picture(put("cut.hdr", whole.substr(0, length)));
      EXPECT_FALSE(cut) << runs << " " << length << " of " << whole.size();
    }
    EXPECT_FALSE(read_linear_picture(put("cut.hdr", whole.substr(0, whole.size() - 1)))) << runs;
  }
}

TEST_F(Files, PicturesOfLightAreNeverHalfWritten) {
  const LinearPicture p = light(7, 5);
  for (const std::string name : {"p.exr", "p.png"}) {
    const auto write = [&](const std::string& path, const LinearPicture& picture, bool overwrite) {
      return name == "p.exr" ? write_exr(path, picture, overwrite) : write_png(path, picture, overwrite);
    };
    ASSERT_TRUE(write(at(name), p, true));
    EXPECT_EQ(told(write(at(name), p, false)), "file");
    EXPECT_TRUE(mentions(write(at(name), p, false), at(name)));
    EXPECT_TRUE(write(at(name), p, true));
    EXPECT_TRUE(mentions(write(at("no/" + name), p, true), at("no/" + name)));
    const Status full = write("/dev/full", p, true);
    EXPECT_EQ(told(full), "machine");
    EXPECT_TRUE(mentions(full, "/dev/full"));
    EXPECT_EQ(told(write(at("x"), {2, 2, {1}}, true)), "range");
    EXPECT_TRUE(mentions(write(at("x"), {2, 2, {1}}, true), "2 by 2"));
    EXPECT_EQ(told(write(at("x"), {0, 0, {}}, true)), "range");
    EXPECT_TRUE(mentions(write(at("x"), {0, 0, {}}, true), "0 by 0"));
  }
  EXPECT_EQ(folder_.names(), (std::vector<std::string>{"p.exr", "p.png"}));
}

// Reads in this process, where the sanitizers look.
Result<std::shared_ptr<const LinearPicture>> read_here(const std::string& path) {
  const MayRead anything = [](const std::string&) { return true; };
  LocalFiles files(anything);
  return parse_linear_picture(path, files);
}

TEST_F(Files, CutOpenExrHasAMessage) {
  ASSERT_TRUE(write_exr(at("p.exr"), light(5, 20)));
  const std::string whole = folder_.get("p.exr");
  for (const std::string& all : {whole, plain_exr("ABGR", 0, 0, 3, 4)})
    for (std::size_t length = 0; length < all.size(); ++length) {
      const auto p = read_here(put("cut.exr", all.substr(0, length)));
      ASSERT_FALSE(p) << length << " bytes of " << all.size();
      EXPECT_EQ(p.error().code, ErrorCode::file);
      EXPECT_NE(p.error().message.find(at("cut.exr")), std::string::npos) << p.error().message;
      EXPECT_EQ(p.error().message.find('\n'), std::string::npos) << p.error().message;
    }
  EXPECT_EQ(told(read_linear_picture(at("none.exr"))), "file " + at("none.exr"));
  EXPECT_TRUE(mentions(read_linear_picture(at("none.exr")), at("none.exr")));
  EXPECT_EQ(told(read_linear_picture(put("w.exr", "words"))), "file");
  EXPECT_TRUE(mentions(read_linear_picture(at("w.exr")), at("w.exr")));
}

// Of bytes that are other than they were comes a picture or a message, and no more.
TEST_F(Files, OpenExrOfChanceBytesIsAPictureOrAMessage) {
  ASSERT_TRUE(write_exr(at("p.exr"), light(9, 20)));
  std::mt19937 random(3);
  int read = 0;
  for (const std::string& whole : {folder_.get("p.exr"), plain_exr("BGR", 0, 0, 9, 20)})
    for (int i = 0; i < 400; ++i) {
      std::string bytes = whole;
      const std::size_t from = i % 2 == 0 ? bytes.size() : 330;  // all, or the head
      for (int k = 0; k <= i % 4; ++k) bytes[4 + random() % (from - 4)] = static_cast<char>(random());
      const auto p = read_here(put("chance.exr", bytes));
      read += static_cast<bool>(p);
      if (p)
        ASSERT_EQ((*p)->rgba.size(),
                  4 * static_cast<std::size_t>((*p)->width) * static_cast<std::size_t>((*p)->height));
      else
        ASSERT_FALSE(p.error().message.empty());
    }
  EXPECT_GT(read, 30) << "most of what was changed are pixels";
}

}  // namespace
}  // namespace betwixt
