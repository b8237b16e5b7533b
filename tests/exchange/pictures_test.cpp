// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <filesystem>
#include <random>
#include <string>

#include "betwixt/picture.h"
#include "exchange/files.h"
#include "support/told.h"

namespace betwixt {
namespace {

namespace fs = std::filesystem;

Picture gradient() {
  Picture p{7, 5, {}};
  for (int i = 0; i < 4 * 7 * 5; ++i) p.rgba.push_back(static_cast<std::uint8_t>(i * 37));
  return p;
}

TEST_F(Files, PicturesComeBackAsTheyWent) {
  const Picture p = gradient();
  ASSERT_TRUE(write_png(at("p.png"), p));
  const auto q = read_picture(at("p.png"));
  ASSERT_TRUE(q) << q.error().message;
  EXPECT_EQ((*q)->width, 7);
  EXPECT_EQ((*q)->height, 5);
  EXPECT_EQ((*q)->rgba, p.rgba);
  EXPECT_NE(folder_.get("p.png").find("sRGB"), std::string::npos);
  // A BMP of one blue pixel, written by hand.
  const std::string bmp(
      "BM\x3a\0\0\0\0\0\0\0\x36\0\0\0\x28\0\0\0\1\0\0\0\1\0\0\0\1\0\x18\0\0\0\0\0\4\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0"
      "\0\xff\0\0\0",
      58);
  const auto blue = read_picture(put("b.bmp", bmp));
  ASSERT_TRUE(blue) << blue.error().message;
  EXPECT_EQ((*blue)->rgba, (std::vector<std::uint8_t>{0, 0, 255, 255}));
}

// The writer chooses filters by the pixels: none if many repeat.
TEST_F(Files, PicturesOfAnyKindComeBackAsTheyWent) {
  std::mt19937 random(7);
  for (const int colors : {1, 3, 200})
    for (const int clear : {0, 1, 100})
      for (const auto& [width, height] : {std::pair{1, 1}, {1, 40}, {40, 1}, {37, 53}}) {
        Picture p{width, height, {}};
        for (int i = 0; i < width * height; ++i) {
          for (int c = 0; c < 3; ++c) p.rgba.push_back(static_cast<std::uint8_t>(random() % unsigned(colors)));
          const bool seen_through = clear == 100 ? random() % 3 == 0 : clear == 1 && i == width * height - 1;
          p.rgba.push_back(seen_through ? 254 : 255);
        }
        ASSERT_TRUE(write_png(at("p.png"), p));
        const auto q = read_picture(at("p.png"));
        ASSERT_TRUE(q) << q.error().message;
        EXPECT_EQ((*q)->rgba, p.rgba) << colors << ' ' << clear << ' ' << width << 'x' << height;
      }
}

TEST_F(Files, PicturesAreNeverHalfWritten) {
  const auto message = [](const Status& s) { return s ? std::string() : s.error().message; };
  ASSERT_TRUE(write_png(at("p.png"), gradient()));
  const Status there = write_png(at("p.png"), gradient(), false);
  EXPECT_EQ(told(there), "file");
  EXPECT_TRUE(mentions(there, at("p.png")));
  EXPECT_TRUE(write_png(at("p.png"), gradient(), true));
  EXPECT_TRUE(write_png(at("new.png"), gradient(), false));
  EXPECT_TRUE(mentions(write_png(at("no/p.png"), gradient()), at("no/p.png")));
  fs::create_directory(at("d.png"));
  const Status folder = write_png(at("d.png"), gradient());
  EXPECT_EQ(told(folder), "file");
  EXPECT_TRUE(mentions(folder, at("d.png")));
  const auto full = write_png("/dev/full", gradient());
  EXPECT_EQ(told(full), "machine");
  EXPECT_TRUE(mentions(full, "/dev/full"));
  EXPECT_EQ(message(write_png(at("x.png"), Picture{2, 2, {1}})), "a picture of 2 by 2 pixels cannot be written");
  EXPECT_EQ(folder_.names(), (std::vector<std::string>{"d.png", "new.png", "p.png"}));
}

TEST_F(Files, BrokenPicturesHaveAMessage) {
  const auto message = [](const std::string& path) {
    const auto p = read_picture(path);
    return p ? std::string() : p.error().message;
  };
  EXPECT_EQ(told(read_picture(at("none.png"))), "file " + at("none.png"));
  EXPECT_TRUE(mentions(read_picture(at("none.png")), at("none.png")));
  EXPECT_EQ(message(put("e.png", "")), at("e.png") + " is empty");
  EXPECT_EQ(message(put("w.png", "words")), "the picture format of " + at("w.png") + " is not supported");
  EXPECT_EQ(message(put("h.png", "\x89PNG\r\n\x1a\n")).find(at("h.png") + " is broken or not a picture: "), 0U);
  const auto words = read_picture(put("j.jpg", "\xff\xd8\xff\xe0 words"));
  EXPECT_EQ(told(words), "file");
  EXPECT_TRUE(mentions(words, at("j.jpg")));
  ASSERT_TRUE(write_png(at("p.png"), gradient()));
  fs::resize_file(at("p.png"), fs::file_size(at("p.png")) / 2);
  EXPECT_EQ(told(read_picture(at("p.png"))), "file");
  EXPECT_TRUE(mentions(read_picture(at("p.png")), at("p.png")));
  Picture wide{16385, 1, std::vector<std::uint8_t>(4 * 16385)};
  ASSERT_TRUE(write_png(at("wide.png"), wide));
  EXPECT_EQ(message(at("wide.png")), at("wide.png") + " has 16385 by 1 pixels; each side must have from 1 to 16384");
}

}  // namespace
}  // namespace betwixt
