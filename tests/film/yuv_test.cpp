// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "film/yuv.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

namespace betwixt {
namespace {

// The same by the book, in f64: every pixel to Y'CbCr, then 1 2 1 across and 1 1 down around each chroma site, times
// the opacity where there is one.
std::vector<double> by_the_book(const Picture& p, bool alpha = false) {
  const int w = (p.width + 1) / 2 * 2, h = (p.height + 1) / 2 * 2;
  const auto at = [&](int x, int y) {
    x = std::clamp(x, 0, p.width - 1), y = std::clamp(y, 0, p.height - 1);
    return &p.rgba[static_cast<std::size_t>(4 * (y * p.width + x))];
  };
  const auto ycc = [&](int x, int y) {
    const std::uint8_t* c = at(x, y);
    const double r = c[0] / 255.0, g = c[1] / 255.0, b = c[2] / 255.0, luma = 0.2126 * r + 0.7152 * g + 0.0722 * b;
    return std::array<double, 3>{16 + 219 * luma, 128 + 224 * (b - luma) / 1.8556, 128 + 224 * (r - luma) / 1.5748};
  };
  std::vector<double> out;
  for (int y = 0; y < h; ++y)
    for (int x = 0; x < w; ++x) out.push_back(ycc(x, y)[0]);
  for (std::size_t c = 1; c < 3; ++c)
    for (int y = 0; y < h; y += 2)
      for (int x = 0; x < w; x += 2) {
        double sum = 0, all = 0;
        for (int row = y; row < y + 2; ++row)
          for (int column = x - 1; column < x + 2; ++column) {
            const double weight = (column == x ? 2 : 1) * (alpha ? at(column, row)[3] : 1);
            sum += weight * ycc(column, row)[c], all += weight;
          }
        out.push_back(all > 0 ? sum / all : 128);
      }
  for (int y = 0; alpha && y < h; ++y)
    for (int x = 0; x < w; ++x) out.push_back(at(x, y)[3]);
  return out;
}

TEST(Yuv, AgreesWithTheDefinition) {
  std::mt19937 random(11);
  for (const auto& [w, h] : {std::pair{1, 1}, {2, 2}, {1, 4}, {5, 3}, {16, 9}, {33, 17}, {64, 4}, {71, 3}}) {
    Picture p{w, h, {}};
    for (int i = 0; i < w * h * 4; ++i) p.rgba.push_back(static_cast<std::uint8_t>(random() & 255));
    for (int i = 3; i < w * h * 4; i += 4)  // clear, opaque and all between
      p.rgba[static_cast<std::size_t>(i)] = static_cast<std::uint8_t>(i % 3 == 0   ? 0
                                                                      : i % 3 == 1 ? 255
                                                                                   : random() & 255);
    for (const bool alpha : {false, true}) {
      std::vector<std::uint8_t> made;
      to_yuv420(p, alpha, made);
      const auto expected = by_the_book(p, alpha);
      ASSERT_EQ(made.size(), expected.size());
      for (std::size_t i = 0; i < made.size(); ++i)
        EXPECT_NEAR(made[i], expected[i], 0.58) << w << "x" << h << " at " << i << (alpha ? " with opacity" : "");
    }
  }
}

// What a pixel becomes depends on its neighbours only, wherever it stands in a row: many are worked out at once.
TEST(Yuv, PicturesAreThoseOfTheirParts) {
  std::mt19937 random(12);
  constexpr int wide = 83, part = 6;
  Picture all{wide, 2, {}};
  for (int i = 0; i < 2 * wide; ++i)
    for (int k = 0; k < 4; ++k) all.rgba.push_back(k == 3 ? 255 : static_cast<std::uint8_t>(random() & 255));
  std::vector<std::uint8_t> made, piece;
  to_yuv420(all, false, made);
  for (int x = 0; x + part <= wide; x += 2) {
    Picture p{part, 2, {}};
    for (int y = 0; y < 2; ++y) {
      const auto from = all.rgba.begin() + 4 * (y * wide + x);
      p.rgba.insert(p.rgba.end(), from, from + 4 * part);
    }
    to_yuv420(p, false, piece);
    for (int k = 0; k < part; ++k)
      EXPECT_EQ(piece[static_cast<std::size_t>(k)], made[static_cast<std::size_t>(x + k)]) << x << " " << k;
    // The first and the last column of the part have no neighbours there.
    const auto middle = static_cast<std::size_t>(2 * part + 1),
               there = static_cast<std::size_t>(2 * (wide + 1) + x / 2 + 1);
    EXPECT_EQ(piece[middle], made[there]) << x;
    EXPECT_EQ(piece[middle + part / 2], made[there + (wide + 1) / 2]) << x;
  }
}

TEST(Yuv, BlackAndWhiteAreTheEndsOfTheRange) {
  std::vector<std::uint8_t> made;
  to_yuv420({1, 1, {255, 255, 255, 255}}, false, made);
  EXPECT_EQ(made, (std::vector<std::uint8_t>{235, 235, 235, 235, 128, 128}));
  to_yuv420({1, 1, {0, 0, 0, 0}}, false, made);
  EXPECT_EQ(made, (std::vector<std::uint8_t>{16, 16, 16, 16, 128, 128}));
  to_yuv420({1, 1, {0, 0, 0, 0}}, true, made);
  EXPECT_EQ(made, (std::vector<std::uint8_t>{16, 16, 16, 16, 128, 128, 0, 0, 0, 0}));
}

// A green leaf at the border of nothing is as green as within.
TEST(Yuv, WhatIsClearColorsNothing) {
  std::vector<std::uint8_t> bordered, whole;
  to_yuv420({2, 2, {0, 200, 0, 255, 0, 0, 0, 0, 0, 200, 0, 255, 0, 0, 0, 0}}, true, bordered);
  to_yuv420({2, 2, {0, 200, 0, 255, 0, 200, 0, 255, 0, 200, 0, 255, 0, 200, 0, 255}}, true, whole);
  EXPECT_EQ(bordered[4], whole[4]);
  EXPECT_EQ(bordered[5], whole[5]);
}

}  // namespace
}  // namespace betwixt
