// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests how light becomes a picture: published numbers of the views, sums of light, and statistics of grain.
#include "render/grade.h"

#include <numeric>

#include "render/bloom.h"
#include "render/curves.h"
#include "render/scenes.h"

namespace betwixt {
namespace {

using namespace scenes;

LinearPicture plane_of(int width, int height, Vec3 light) {
  LinearPicture p{width, height, {}};
  for (int i = 0; i < width * height; ++i)
    for (const double c : {light.x, light.y, light.z, 1.0}) p.rgba.push_back(static_cast<float>(c));
  return p;
}
double sum_of(const LinearPicture& p, std::size_t channel) {
  double sum = 0;
  for (std::size_t i = channel; i < p.rgba.size(); i += 4) sum += static_cast<double>(p.rgba[i]);
  return sum;
}
Pixel developed(Vec3 light, Grade::View view) {
  Development how;
  how.grade.view = view;
  Picture out;
  develop(plane_of(1, 1, light), how, out);
  return pixel(out, 0, 0);
}
// A frame with a square of this light that fills the picture.
Frame lit_by(Vec3 light, const Grade& grade) {
  Frame f = frame();
  f.items = {item(square(), scaling({30, 30, 30}), light)};
  f.surroundings.grade = grade;
  return f;
}

TEST(Grade, PowersAreThoseOfTheLibrary) {
  for (double x = 1e-9; x < 1e9; x *= 1.37) {
    EXPECT_NEAR(own_log2(x), std::log2(x), 1e-13 * (1 + std::abs(std::log2(x))));
    EXPECT_NEAR(own_power(x, 0.37) / std::pow(x, 0.37), 1, 1e-12);
  }
  EXPECT_EQ(own_log2(1), 0);
  EXPECT_EQ(own_exp2(-3), 0.125);
  for (double x = 0; x <= 1; x += 0.00037) {
    EXPECT_NEAR(light_of_signal(x), decoded(x), 1e-7);
    EXPECT_NEAR(signal_of(decoded(x)), x, 1e-7);
  }
  EXPECT_EQ(signal_of(std::nan("")), 0);
  EXPECT_NEAR(signal_of(7), 1, 1e-12);
}

TEST(Grade, ViewsShowKnownLightAsPublished) {
  // AgX: 0.18 is 10 of the 16.5 stops above black, where the fit of the curve is 0.4967.
  EXPECT_EQ(developed({0.18, 0.18, 0.18}, Grade::agx), (Pixel{127, 127, 127, 255}));
  // Far above white is white, and no light is black.
  EXPECT_GE(developed({40, 40, 40}, Grade::agx).r, 253);
  EXPECT_EQ(developed({0, 0, 0}, Grade::agx), (Pixel{0, 0, 0, 255}));
  // Bright red goes over to white instead of staying red.
  const Pixel red = developed({30, 0, 0}, Grade::agx);
  EXPECT_GT(red.g, 100) << red.r;
  EXPECT_GT(red.r, red.g);
  // Middle grey stays; white is 0.61 in Hable's curve with this scale, worked out by hand.
  EXPECT_EQ(developed({0.18, 0.18, 0.18}, Grade::filmic).r, encoded_byte(0.18));
  EXPECT_NEAR(developed({1, 1, 1}, Grade::filmic).r, encoded_byte(0.612), 1);
  EXPECT_EQ(developed({100, 100, 100}, Grade::filmic).r, 255);
  EXPECT_EQ(developed({1.2, 0.5, 0.2}, Grade::plain), (Pixel{255, encoded_byte(0.5), encoded_byte(0.2), 255}));
  // Below 0.8 the neutral view changes nothing.
  EXPECT_EQ(developed({0.7, 0.5, 0.2}, Grade::neutral).r, encoded_byte(0.7));
  EXPECT_LT(developed({1, 1, 1}, Grade::neutral).r, 250);
}

TEST(Grade, ViewsNeverGetDarkerWithMoreLight) {
  for (const auto view : {Grade::neutral, Grade::plain, Grade::filmic, Grade::agx}) {
    int last = -1;
    for (double x = 1e-5; x < 1e4; x *= 1.02) {
      const int now = developed({x, x, x}, view).g;
      EXPECT_GE(now, last) << x << " in view " << view;
      last = now;
    }
  }
}

// Half of a pixel at the edge of a lamp is covered: its picture is half of that of the lamp.
TEST(Grade, EdgesOfBrightLightAreSmooth) {
  LinearPicture p = plane_of(9, 3, {0, 0, 0});
  for (int y = 0; y < 3; ++y)
    for (int x = 4; x < 9; ++x)
      for (int c = 0; c < 3; ++c) p.rgba[static_cast<std::size_t>(4 * (9 * y + x) + c)] = x == 4 ? 10 : 20;
  for (const auto view : {Grade::plain, Grade::filmic, Grade::agx, Grade::neutral}) {
    Development how;
    how.grade.view = view;
    Picture out;
    develop(p, how, out);
    const double bright = decoded(pixel(out, 7, 1).g / 255.0);
    EXPECT_GT(bright, 0.9);
    EXPECT_NEAR(decoded(pixel(out, 4, 1).g / 255.0), bright / 2, 0.01) << view;
    EXPECT_EQ(pixel(out, 5, 1), pixel(out, 7, 1));
    EXPECT_EQ(pixel(out, 3, 1).g, pixel(out, 0, 1).g);
  }
}

TEST(Grade, WhiteBalanceMakesALampWhite) {
  // Tungsten light (2856 K, illuminant A: x = 0.44757, y = 0.40745) in linear sRGB.
  const double x = 0.44757 / 0.40745, z = (1 - 0.44757 - 0.40745) / 0.40745;
  const Vec3 lamp{3.24097 * x - 1.53738 - 0.49861 * z, -0.96924 * x + 1.87597 + 0.04156 * z,
                  0.05563 * x - 0.20398 + 1.05697 * z};
  const auto m = white_balance(2856);
  const Vec3 seen{dot(m[0], lamp), dot(m[1], lamp), dot(m[2], lamp)};
  EXPECT_NEAR(seen.x / seen.y, 1, 0.01);
  EXPECT_NEAR(seen.z / seen.y, 1, 0.01);
  const auto same = white_balance(6500);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) EXPECT_NEAR(same[static_cast<std::size_t>(i)][j], i == j, 1e-6);
  for (const double k : {1000.0, 40000.0})
    for (const Vec3& row : white_balance(k)) EXPECT_TRUE(finite(row)) << k;
}

TEST(Grade, BloomKeepsTheSumOfTheLight) {
  for (const auto [width, height] : {std::pair{128, 64}, {97, 53}, {1, 200}, {1, 1}, {33, 300}}) {
    LinearPicture p = plane_of(width, height, {0, 0.25, 0});
    p.rgba[0] = 1000;                       // a bright pixel in the corner
    p.rgba[p.rgba.size() / 8 * 4 + 2] = 7;  // and one within
    const double red = sum_of(p, 0), blue = sum_of(p, 2);
    spread_light(p, 0.6);
    EXPECT_NEAR(sum_of(p, 0) / red, 1, 1e-4) << width << "x" << height;
    EXPECT_NEAR(sum_of(p, 2) / blue, 1, 1e-4) << width << "x" << height;
    for (std::size_t i = 1; i < p.rgba.size(); i += 4) ASSERT_NEAR(p.rgba[i], 0.25, 1e-5);  // even light stays even
    for (std::size_t i = 3; i < p.rgba.size(); i += 4) ASSERT_EQ(p.rgba[i], 1);
  }
}

TEST(Grade, BloomSpreadsTheShareThatIsAsked) {
  LinearPicture p = plane_of(256, 256, {0, 0, 0});
  const std::size_t middle = 4 * (128 * 256 + 128);
  p.rgba[middle] = 1;
  spread_light(p, 0.5);
  EXPECT_GT(p.rgba[middle], 0.5);  // and what comes back to the place
  EXPECT_LT(p.rgba[middle], 0.8);
  EXPECT_GT(p.rgba[middle + 4 * 40], 0);
  EXPECT_GT(p.rgba[middle + 4 * 4], p.rgba[middle + 4 * 40]);
}

TEST(Grade, BlursHaveTheDeviationThatIsAsked) {
  for (const double wanted : {0.7, 2.0, 5.5, 17.0}) {
    LinearPicture p = plane_of(257, 257, {0, 0, 0});
    p.rgba[4 * (128 * 257 + 128)] = 1;
    blur_light(p, wanted);
    double variance = 0, sum = 0;
    for (int y = 0; y < 257; ++y)
      for (int x = 0; x < 257; ++x) {
        const double c = static_cast<double>(p.rgba[4 * static_cast<std::size_t>(y * 257 + x)]);
        variance += c * (x - 128) * (x - 128), sum += c;
      }
    EXPECT_NEAR(sum, 1, 1e-3) << wanted;
    EXPECT_NEAR(std::sqrt(variance / sum), wanted, 0.04 * wanted);
  }
}

TEST(Grade, GrainHasNoMeanAndIsTheSameTwice) {
  Development how;
  how.grade.view = Grade::plain, how.grade.grain = 0.5;
  const auto grey = plane_of(200, 200, {0.2140, 0.2140, 0.2140});  // a signal of one half
  Picture a, b, later;
  develop(grey, how, a), develop(grey, how, b);
  how.time = Time{29'400'000};
  develop(grey, how, later);
  EXPECT_EQ(a.rgba, b.rgba);
  EXPECT_NE(a.rgba, later.rgba);
  double sum = 0, square = 0;
  for (std::size_t i = 0; i < a.rgba.size(); i += 4) sum += a.rgba[i], square += a.rgba[i] * a.rgba[i];
  const double mean = sum / 40000, deviation = std::sqrt(square / 40000 - mean * mean);
  EXPECT_NEAR(mean, 127.5, 0.3);
  EXPECT_NEAR(deviation, 255 * 0.24 * 0.5 * 0.25, 0.4);
  Picture black;
  develop(plane_of(50, 50, {0, 0, 0}), how, black);
  EXPECT_EQ(std::accumulate(black.rgba.begin(), black.rgba.end(), 0), 255 * 2500);
}

TEST(Grade, AllStylesAreGraded) {
  Grade g;
  g.view = Grade::agx;
  for (const char* const style : {"shaded", "traced"}) {
    Frame f = lit_by({0.18, 0.18, 0.18}, g);
    EXPECT_NEAR(pixel(draw(f, {20, 20, 4, style}), 10, 10).g, 127, 1) << style;
    f.surroundings.flat = true;
    EXPECT_NEAR(pixel(draw(f, {20, 20, 4, style}), 10, 10).g, 127, 1) << style;
    f.surroundings.grade = {};
    EXPECT_NEAR(pixel(draw(f, {20, 20, 4, style}), 10, 10).g, encoded_byte(0.18), 1) << style;
  }
  Frame lines = lit_by({0, 0, 0}, g);
  lines.background = Vec3{0.18, 0.18, 0.18}, lines.items.clear();
  EXPECT_EQ(pixel(draw(lines, {20, 20, 4, "wireframe"}), 10, 10).g, 127);
}

TEST(Grade, VignetteDarkensTheCornersByItsAmount) {
  Grade g;
  g.vignette = 0.5;
  const Picture p = draw(lit_by({0.6, 0.6, 0.6}, g), {101, 101, 4, "shaded"});
  EXPECT_NEAR(pixel(p, 50, 50).r, encoded_byte(0.6), 1);
  EXPECT_NEAR(pixel(p, 0, 0).r, encoded_byte(0.3), 2);
  EXPECT_NEAR(pixel(p, 0, 50).r, encoded_byte(0.6 * (1 - 0.5 * 0.5 * 0.5 * 1.5)), 2);
}

TEST(Grade, LightForCompositingHasNoViewAndTransparencyStays) {
  Frame f = lit_by({0.18, 0.18, 0.18}, {});
  f.surroundings.grade.view = Grade::agx, f.surroundings.grade.grain = 1, f.surroundings.grade.vignette = 0.25;
  f.surroundings.clear = true, f.items[0].world = scaling({4, 4, 4});
  RenderOptions o{40, 40, 4, "shaded"};
  o.linear = o.unclamped = true;
  LinearPicture p;
  ASSERT_TRUE(renderer(o)->render(f, p));
  const auto at = [&](int x, int y) { return &p.rgba[static_cast<std::size_t>(4 * (40 * y + x))]; };
  EXPECT_NEAR(at(20, 20)[1], 0.18, 0.002);
  EXPECT_EQ(at(1, 1)[3], 0);
  o.unclamped = false, f.surroundings.grade.grain = 0;
  ASSERT_TRUE(renderer(o)->render(f, p));
  EXPECT_NEAR(at(20, 20)[1], decoded(0.4967), 0.003);
  EXPECT_EQ(at(1, 1)[3], 0);
  EXPECT_EQ(at(1, 1)[0], 0);
  Picture straight;
  ASSERT_TRUE(renderer(o)->render(f, straight));
  EXPECT_EQ(pixel(straight, 1, 1), (Pixel{0, 0, 0, 0}));
  EXPECT_EQ(pixel(straight, 20, 20).a, 255);
}

// On a screen with room for highlights, neutral light stays up to 0.8 of the peak, and rolls off to the peak; plain
// light is cut off there. Views that have a white keep it. Flat films are as bright as elsewhere.
TEST(Grade, HighlightsHaveRoomUpToThePeak) {
  RenderOptions o{20, 20, 4, "shaded"};
  o.linear = true, o.peak = 5;
  const auto shown = [&](double light, Grade::View view, bool flat = false, bool grain = false) {
    Grade g;
    g.view = view, g.grain = grain ? 0.5 : 0;
    Frame f = lit_by({light, light, light}, g);
    f.surroundings.flat = flat;
    LinearPicture p;
    EXPECT_TRUE(renderer(o)->render(f, p));
    return static_cast<double>(p.rgba[4 * (20 * 10 + 10)]);
  };
  for (const double light : {0.2, 1.0, 3.9}) EXPECT_NEAR(shown(light, Grade::neutral), light, 0.003 * light) << light;
  EXPECT_NEAR(shown(8, Grade::neutral), 4 + (8 - 4) / (1 + 8 - 4.0), 0.02);  // 0.8 + x / (1 + 5 x) of the peak
  EXPECT_LT(shown(1000, Grade::neutral), 5.001);
  EXPECT_GT(shown(1000, Grade::neutral), 4.9);
  EXPECT_NEAR(shown(4.5, Grade::plain), 4.5, 0.02);
  EXPECT_NEAR(shown(9, Grade::plain), 5, 0.001);
  EXPECT_LE(shown(50, Grade::agx), 1.0001);
  EXPECT_LE(shown(50, Grade::filmic), 1.0001);
  EXPECT_NEAR(shown(0.5, Grade::neutral, true), 0.5, 0.003);
  EXPECT_NEAR(shown(1, Grade::neutral, true), 1, 0.003);
  EXPECT_NEAR(shown(3, Grade::neutral, false, true), 3, 0.01);  // no grain above white
  EXPECT_NE(shown(0.3, Grade::neutral, false, true), shown(0.3, Grade::neutral));
  o.peak = 0.5;
  EXPECT_FALSE(make_renderer(o));
  o.peak = std::nan("");
  EXPECT_FALSE(make_renderer(o));
}

TEST(Grade, BrokenLightIsBlackOrWhiteAndStaysInItsPlace) {
  LinearPicture p = plane_of(64, 64, {0.1, 0.1, 0.1});
  p.rgba[0] = std::nanf(""), p.rgba[5] = INFINITY, p.rgba[10] = -3;
  Development how;
  how.grade.bloom = 0, how.grade.vignette = 1, how.grade.white_balance = 1000, how.grade.view = Grade::filmic;
  grade_light(p, how.grade);
  for (const float c : p.rgba) EXPECT_TRUE(std::isfinite(c));
  how.grade.bloom = 1;
  grade_light(p, how.grade);
  for (const float c : p.rgba) EXPECT_TRUE(std::isfinite(c));
}

}  // namespace
}  // namespace betwixt
