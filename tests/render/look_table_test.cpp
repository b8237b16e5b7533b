// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests what look files and configurations of colours make of light, against formulas.
#include "render/look_table.h"

#include <cmath>
#include <random>

#include "exchange/color_table.h"
#include "render/grade.h"
#include "render/scenes.h"
#include "support/folder.h"

namespace betwixt {
namespace {

using namespace scenes;

std::shared_ptr<const ColorTable> table_of(const std::string& path, const ColorQuery& query = {}) {
  const auto read = load_colors(path, query, [](const std::string&) { return true; });
  EXPECT_TRUE(read) << (read ? "" : read.error().message);
  return read ? *read : nullptr;
}
Pixel shown(Vec3 light, const Grade& grade) {
  Development how;
  how.grade = grade;
  LinearPicture p{1, 1, {}};
  for (const double c : {light.x, light.y, light.z, 1.0}) p.rgba.push_back(static_cast<float>(c));
  Picture out;
  develop(p, how, out);
  return pixel(out, 0, 0);
}

// A table is linear in each tetrahedron, so linear functions are exact, and greys come from greys alone.
TEST(LookTables, InterpolateLinearFunctionsExactly) {
  ColorTable t;
  t.size = 5;
  for (int b = 0; b < 5; ++b)
    for (int g = 0; g < 5; ++g)
      for (int r = 0; r < 5; ++r)
        for (const int c : {r + 2 * g, 4 * b + r, g + b}) t.signals.push_back(static_cast<std::uint16_t>(2000 * c));
  std::mt19937 random(3);
  std::uniform_real_distribution<double> share(0, 1);
  for (int i = 0; i < 1000; ++i) {
    const Vec3 c{share(random), share(random), share(random)}, is = looked_up(t, c);
    EXPECT_NEAR(is.x * 65535, 8000 * (c.x + 2 * c.y), 1e-6);
    EXPECT_NEAR(is.y * 65535, 8000 * (4 * c.z + c.x), 1e-6);
    EXPECT_NEAR(is.z * 65535, 8000 * (c.y + c.z), 1e-6);
  }
  EXPECT_EQ(looked_up(t, {9, 9, 9}).x, looked_up(t, {1, 1, 1}).x);
  EXPECT_EQ(looked_up(t, {-1, std::nan(""), 0}).y, 0);
  t.least = {-1, -1, -1}, t.most = {1, 3, 1};
  EXPECT_NEAR(looked_up(t, {0, 1, 0}).x * 65535, 8000 * (0.5 + 2 * 0.5), 1e-6);
}

TEST(LookTables, ChangeThePictureOfAView) {
  const Folder folder;
  folder.put("swap.cube", "LUT_3D_SIZE 2\n0 0 0\n0 1 0\n1 0 0\n1 1 0\n0 0 1\n0 1 1\n1 0 1\n1 1 1\n");
  Grade g;
  g.view = Grade::agx;
  const Pixel before = shown({0.5, 0.2, 0.1}, g);
  g.table = table_of(folder / "swap.cube");
  const Pixel after = shown({0.5, 0.2, 0.1}, g);
  EXPECT_EQ(after, (Pixel{before.g, before.r, before.b, 255}));
  g.table_share = 0.5;
  EXPECT_NEAR(shown({0.5, 0.2, 0.1}, g).r, (before.r + before.g) / 2.0, 1);
  g.table_share = 0;
  EXPECT_EQ(shown({0.5, 0.2, 0.1}, g), before);
}

TEST(LookTables, OfLightKnowTheirDomain) {
  const Folder folder;
  folder.put("light.cube", "LUT_1D_SIZE 5\nDOMAIN_MAX 4 4 4\n0 0 0\n.2 .2 .2\n.4 .4 .4\n.6 .6 .6\n1 1 1\n");
  Grade g;
  g.view = Grade::plain, g.table = table_of(folder / "light.cube", {.of_light = true});
  EXPECT_EQ(shown({1.5, 0.5, 9}, g), (Pixel{77, 26, 255, 255}));  // 0.3, 0.1 and 1 of 255
}

#ifdef BETWIXT_OCIO

constexpr const char* spaces =
    "ocio_profile_version: 2\nroles: {default: lin_srgb, aces_interchange: ap0}\ndisplays:\n  screen:\n"
    "    - !<View> {name: Logarithm, colorspace: logarithm}\n    - !<View> {name: Mixed, colorspace: mixed}\n"
    "    - !<View> {name: Root, colorspace: root}\n    - !<View> {name: Aces, colorspace: ap0}\n"
    "looks:\n  - !<Look> {name: Graded, process_space: lin_srgb, transform: !<CDLTransform> {slope: [1.2, 1, 0.9], "
    "offset: [0.01, 0.02, 0], power: [1.1, 1, 0.8], sat: 1.4}}\ncolorspaces:\n  - !<ColorSpace> {name: lin_srgb}\n"
    "  - !<ColorSpace> {name: logarithm, from_scene_reference: !<LogAffineTransform> {base: 2, log_side_slope: 0.06, "
    "log_side_offset: 0.7, lin_side_slope: 1, lin_side_offset: 0.001}}\n"
    "  - !<ColorSpace> {name: root, from_scene_reference: !<ExponentTransform> {value: 0.5}}\n"
    "  - !<ColorSpace> {name: mixed, from_scene_reference: !<GroupTransform> {children: [!<MatrixTransform> {matrix: "
    "[0.6, 0.3, 0.1, 0, 0.1, 0.8, 0.1, 0, 0.05, 0.15, 0.8, 0, 0, 0, 0, 1]}, !<ExponentTransform> {value: 0.4545}]}}\n"
    "  - !<ColorSpace> {name: ap0}\n";

class Configurations : public testing::Test {
 protected:
  Configurations() { folder_.put("c.ocio", spaces); }
  // Returns the largest and the mean difference from a formula, of 255, over light up to 100 and colours of all kinds.
  template <class F>
  std::pair<double, double> apart(const ColorQuery& query, const F& formula, double most_stops = 6) const {
    const auto table = table_of(folder_ / "c.ocio", query);
    std::mt19937 random(7);
    std::uniform_real_distribution<double> stops(-9, most_stops), share(0, 1);
    double most = 0, sum = 0;
    constexpr int count = 20000;
    for (int i = 0; i < count && table; ++i) {
      const double bright = std::exp2(stops(random));
      const Vec3 c = bright * Vec3{share(random), share(random), share(random)}, is = looked_up(*table, c),
                 to = formula(c);
      for (int k = 0; k < 3; ++k) {
        const double off = 255 * std::abs(is[k] - std::clamp(to[k], 0.0, 1.0));
        most = std::max(most, off), sum += off / 3;
      }
    }
    return {most, sum / count};
  }
  const Folder folder_;
};

TEST_F(Configurations, LogarithmsAreWithinASixteenthOfAByte) {
  const auto by = [](double x) { return 0.06 * std::log2(x + 0.001) + 0.7; };
  const auto [most, mean] = apart({.through = "Logarithm"}, [&](Vec3 c) { return Vec3{by(c.x), by(c.y), by(c.z)}; });
  EXPECT_LT(most, 1.0 / 16);
  EXPECT_LT(mean, 0.01);
}

TEST_F(Configurations, MixedChannelsAreWithinTwoBytesBelowWhite) {
  const auto power = [](double x) { return std::pow(x, 0.4545); };
  const auto mixed = [&](Vec3 c) {
    return Vec3{power(0.6 * c.x + 0.3 * c.y + 0.1 * c.z), power(0.1 * c.x + 0.8 * c.y + 0.1 * c.z),
                power(0.05 * c.x + 0.15 * c.y + 0.8 * c.z)};
  };
  const auto [most, mean] = apart({.through = "Mixed"}, mixed, 0);
  RecordProperty("most", std::to_string(most)), RecordProperty("mean", std::to_string(mean));
  EXPECT_LT(most, 2);  // in the dark, where the root is steep
  EXPECT_LT(mean, 0.15);
}

// The formula of ASC CDL: slope, offset, power, then saturation by the weights of Rec.709.
TEST_F(Configurations, LooksAreThoseOfTheirFormula) {
  const auto graded = [](Vec3 c) {
    const auto one = [](double x, double slope, double offset, double power) {
      return std::pow(std::max(x * slope + offset, 0.0), power);
    };
    Vec3 s{one(c.x, 1.2, 0.01, 1.1), one(c.y, 1, 0.02, 1), one(c.z, 0.9, 0, 0.8)};
    const double luma = 0.2126 * s.x + 0.7152 * s.y + 0.0722 * s.z;
    for (int k = 0; k < 3; ++k) s[k] = std::sqrt(std::max(luma + 1.4 * (s[k] - luma), 0.0));
    return s;
  };
  const auto [most, mean] = apart({.through = "Root", .look = "Graded"}, graded, -1);
  RecordProperty("most", std::to_string(most)), RecordProperty("mean", std::to_string(mean));
  EXPECT_LT(mean, 0.3);
  EXPECT_LT(most, 16);  // at the edge of what saturation cuts off
}

TEST_F(Configurations, PlaceWhiteExactly) {
  const auto table = table_of(folder_ / "c.ocio", {.through = "Root"});
  ASSERT_TRUE(table);
  EXPECT_NEAR(looked_up(*table, {1, 1, 1}).x, 1, 2e-5);
  EXPECT_NEAR(looked_up(*table, {0.25, 0.25, 0.25}).y, 0.5, 1e-4);
  EXPECT_EQ(looked_up(*table, {0, 0, 0}).z, 0);
}

#endif

}  // namespace
}  // namespace betwixt
