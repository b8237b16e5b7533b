// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "render/scenes.h"

namespace betwixt {
namespace {

Error refused(const RenderOptions& options) {
  const auto r = make_renderer(options);
  EXPECT_FALSE(r);
  return r ? Error{} : r.error();
}

TEST(RenderOptions, SizesOutOfBounds) {
  const std::pair<int, int> sizes[] = {{0, 10}, {10, 0}, {-5, 10}, {8193, 10}, {10, 100000}};
  for (const auto& [w, h] : sizes) {
    const Error e = refused({w, h, 4, "shaded"});
    EXPECT_EQ(e.code, ErrorCode::range);
    EXPECT_EQ(e.message, "a picture of " + std::to_string(w) + "x" + std::to_string(h) + " pixels cannot be drawn");
    EXPECT_EQ(e.hint, "each side must have from 1 to 8192 pixels");
  }
}

TEST(RenderOptions, SamplesThatDoNotExist) {
  for (const int n : {-4, -1, 2, 8, 25}) {
    const Error e = refused({10, 10, n, "shaded"});
    EXPECT_EQ(e.code, ErrorCode::range);
    EXPECT_EQ(e.message, std::to_string(n) + " samples per pixel cannot be drawn");
    EXPECT_EQ(e.hint, "1, 4, 9 or 16");
  }
}

// shows: G13
TEST(RenderOptions, UnknownStyleWithTheNearestOne) {
  const Error near = refused({10, 10, 4, "wirefame"});
  EXPECT_EQ(near.code, ErrorCode::name);
  EXPECT_EQ(near.message, "there is no style 'wirefame'");
  EXPECT_EQ(near.hint, "wireframe");
  EXPECT_EQ(refused({10, 10, 4, "cubist"}).hint, "the styles are shaded, wireframe, hidden-line, traced");
}

// shows: G13
TEST(RenderOptions, EveryStyleAndSampleCountDrawsAnEmptyFrame) {
  for (const Style& style : styles()) {
    EXPECT_FALSE(style.what.empty());
    for (const int samples : {1, 4, 9, 16}) {
      const Picture p = scenes::draw(Frame{}, {33, 17, samples, std::string(style.name)});
      EXPECT_EQ(p.width, 33);
      EXPECT_EQ(p.height, 17);
      EXPECT_EQ(p.rgba.size(), 33U * 17U * 4U);
      EXPECT_EQ(scenes::pixel(p, 5, 5).a, 255);
    }
  }
}

TEST(RenderOptions, SmallestAndLongPictures) {
  const std::pair<int, int> sizes[] = {{1, 1}, {8192, 1}, {1, 8192}};
  for (const auto& [w, h] : sizes) {
    const Picture p = scenes::draw(scenes::frame(), {w, h, 1, "shaded"});
    EXPECT_EQ(p.rgba.size(), static_cast<std::size_t>(w) * static_cast<std::size_t>(h) * 4);
  }
}

}  // namespace
}  // namespace betwixt
