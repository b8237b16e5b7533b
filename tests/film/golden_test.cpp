// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Compares pictures with checked ones (tests/golden/README.md lists what each must show). There is a tolerance, because
// processors round differently. After an intended change, look at the new pictures in the folder that a failure names,
// then copy them to tests/golden.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "betwixt/language.h"
#include "betwixt/picture.h"
#include "betwixt/program.h"
#include "betwixt/render.h"

namespace betwixt {
namespace {

struct Golden {
  const char *name, *script, *time, *style;
};

void PrintTo(const Golden& g, std::ostream* out) { *out << g.name; }

class GoldenPicture : public ::testing::TestWithParam<Golden> {};

struct Difference {
  double mean = 0;     // levels of 255
  double far_off = 0;  // part of the pixels that differ by more than 40 levels
};

Difference compare(const Picture& a, const Picture& b) {
  Difference d;
  for (std::size_t i = 0; i < a.rgba.size(); i += 4) {
    int most = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const int off = std::abs(a.rgba[i + k] - b.rgba[i + k]);
      d.mean += off;
      most = std::max(most, off);
    }
    d.far_off += most > 40;
  }
  d.mean /= static_cast<double>(a.rgba.size()) * 3 / 4;
  d.far_off /= static_cast<double>(a.rgba.size()) / 4;
  return d;
}

// shows: G56
TEST_P(GoldenPicture, LooksAsItDid) {
  const Golden& g = GetParam();
  const Loaded loaded = load_file(std::string(SOURCE_DIR "/") + g.script);
  ASSERT_FALSE(has_errors(loaded.diagnostics));
  const auto time = parse_time(g.time, loaded.document);
  ASSERT_TRUE(time);
  RenderOptions options;
  options.width = 320, options.height = 180, options.style = g.style;
  auto renderer = make_renderer(options);
  ASSERT_TRUE(renderer) << renderer.error().message;
  Picture picture;
  ASSERT_TRUE((*renderer)->render(Program::compile(loaded.document).frame(*time), picture));

  const auto folder = std::filesystem::temp_directory_path() / "betwixt-golden";
  std::filesystem::create_directories(folder);
  const std::string made = (folder / g.name).string() + ".png";
  ASSERT_TRUE(write_png(made, picture));
  const auto golden = read_picture(std::string(SOURCE_DIR "/tests/golden/") + g.name + ".png");
  ASSERT_TRUE(golden) << "there is no golden picture; look at " << made;
  ASSERT_EQ((*golden)->width, picture.width);
  ASSERT_EQ((*golden)->height, picture.height);
  const Difference d = compare(picture, **golden);
  EXPECT_LT(d.mean, 0.5) << "look at " << made;
  EXPECT_LT(d.far_off, 0.0015) << "look at " << made;
}

INSTANTIATE_TEST_SUITE_P(All, GoldenPicture,
                         ::testing::Values(Golden{"bounce", "examples/bounce.bx", "10f", "shaded"},
                                           Golden{"solar", "examples/solar.bx", "60f", "shaded"},
                                           Golden{"menagerie", "examples/menagerie.bx", "90f", "shaded"},
                                           Golden{"title-before", "examples/title.bx", "1f", "shaded"},
                                           Golden{"title-between", "examples/title.bx", "48f", "shaded"},
                                           Golden{"title-after", "examples/title.bx", "96f", "shaded"},
                                           Golden{"two-stars", "examples/two-stars.bx", "48f", "shaded"},
                                           Golden{"frisbee", "examples/frisbee.bx", "45f", "shaded"},
                                           Golden{"kinds", "tests/golden/kinds.bx", "1f", "shaded"},
                                           Golden{"kinds-wireframe", "tests/golden/kinds.bx", "1f", "wireframe"},
                                           Golden{"kinds-hidden-line", "tests/golden/kinds.bx", "1f", "hidden-line"}));

}  // namespace
}  // namespace betwixt
