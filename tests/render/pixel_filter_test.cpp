// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests the pixel filters against a convolution by the definition: a picture with four times as many pixels a side and
// one sample each has the samples of the filtered picture.
#include "scene/pixel_filter.h"

#include <functional>
#include <map>

#include "render/filter_sampler.h"
#include "render/scenes.h"

namespace betwixt {
namespace {

// The definitions, as the literature has them.
const std::map<std::string, std::pair<double, std::function<double(double)>>> by_definition{
    {"box", {0.5, [](double) { return 1.0; }}},
    {"tent", {1, [](double x) { return 1 - std::abs(x); }}},
    {"gaussian", {1.5, [](double x) { return std::exp(-2 * x * x) - std::exp(-4.5); }}},
    {"mitchell",
     {2,
      [](double x) {
        const double b = 1.0 / 3, c = 1.0 / 3, a = std::abs(x);
        return a < 1
                   ? ((12 - 9 * b - 6 * c) * a * a * a + (-18 + 12 * b + 6 * c) * a * a + (6 - 2 * b)) / 6
                   : ((-b - 6 * c) * a * a * a + (6 * b + 30 * c) * a * a + (-12 * b - 48 * c) * a + (8 * b + 24 * c)) /
                         6;
      }}},
    {"lanczos", {3, [](double x) {
                   const double p = std::acos(-1.0) * x;
                   return x == 0 ? 1 : 3 * std::sin(p) * std::sin(p / 3) / (p * p);
                 }}}};

// Rotated squares, one on top of the other.
Frame squares() {
  Frame f = scenes::frame();
  f.items.clear();
  for (int i = 0; i < 5; ++i) {
    const double s = 4.5 / (i + 1), a = 0.37 * i;
    Mat4 world =
        translation({0.2 * i - 0.3, 0.15 * i, 0.1 * i}) * rotation(axis_angle({0, 0, 1}, a)) * scaling({s, s, s});
    f.items.push_back(scenes::item(scenes::square(), world, i % 2 ? Vec3{1, 1, 1} : Vec3{0.05, 0.3, 0.6}));
  }
  return f;
}

// shows: S6
TEST(PixelFilters, AreTheConvolutionOfTheirDefinition) {
  constexpr int width = 40, height = 30, side = 4;
  const Frame frame = squares();
  const Picture samples = scenes::draw(frame, {width * side, height * side, 1, "shaded"});
  const auto sample = [&](int x, int y, int channel) {
    x = std::clamp(x, 0, width * side - 1), y = std::clamp(y, 0, height * side - 1);
    const auto p = scenes::pixel(samples, x, y);
    return scenes::decoded((channel == 0 ? p.r : channel == 1 ? p.g : p.b) / 255.0);
  };
  ASSERT_EQ(pixel_filters().size(), by_definition.size());
  for (const PixelFilter& filter : pixel_filters()) {
    const std::string name(filter.name);
    if (name == "box") continue;  // the graphics choose where its samples are
    RenderOptions options{width, height, side * side, "shaded"};
    options.pixel_filter = name;
    const Picture is = scenes::draw(frame, options);
    const auto& [radius, weight] = by_definition.at(name);
    int worst = 0, edges = 0;
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x)
        for (int channel = 0; channel < 3; ++channel) {
          double sum = 0, weights = 0;
          for (int v = (y - 4) * side; v < (y + 5) * side; ++v)
            for (int u = (x - 4) * side; u < (x + 5) * side; ++u) {
              const double dx = (u + 0.5) / side - (x + 0.5), dy = (v + 0.5) / side - (y + 0.5);
              if (std::abs(dx) >= radius || std::abs(dy) >= radius) continue;
              const double w = weight(dx) * weight(dy);
              weights += w, sum += w * sample(u, v, channel);
            }
          const auto p = scenes::pixel(is, x, y);
          const int wanted = scenes::encoded_byte(std::clamp(sum / weights, 0.0, 1.0));
          const int got = channel == 0 ? p.r : channel == 1 ? p.g : p.b;
          worst = std::max(worst, std::abs(got - wanted));
          edges += wanted != scenes::encoded_byte(sample(x * side + 2, y * side + 2, channel));
        }
    EXPECT_LE(worst, 2) << name;
    EXPECT_GT(edges, 500) << name << ": the picture has no edges that could fail";
  }
}

TEST(PixelFilters, KeepWhatIsEvenAndAreNamed) {
  Frame plain = scenes::frame();
  plain.items.clear();
  plain.background = Vec3{0.2, 0.5, 0.7};
  for (const char* style : {"shaded", "traced"})
    for (const PixelFilter& filter : pixel_filters()) {
      RenderOptions options{20, 10, 9, style};
      options.pixel_filter = filter.name;
      EXPECT_EQ(scenes::draw(plain, options).rgba, scenes::draw(plain, {20, 10, 9, style}).rgba) << filter.name;
      EXPECT_FALSE(filter.what.empty());
    }
  RenderOptions wrong;
  wrong.pixel_filter = "mitchel";
  const auto made = make_renderer(wrong);
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().code, ErrorCode::name);
}

// The sampler's places have the density of the filter: means over many places are its integrals.
TEST(PixelFilters, AreSampledByTheirWeight) {
  for (const PixelFilter& filter : pixel_filters()) {
    const traced::FilterSampler sampler(filter);
    const auto& [radius, weight] = by_definition.at(std::string(filter.name));
    double mean = 0, square = 0, total = 0, wanted_square = 0, wanted_total = 0;
    for (int i = 0; i < 100'000; ++i) {
      const double u = (i + 0.5) / 100'000;
      const auto [at, sign] = sampler.at(u);
      ASSERT_LE(std::abs(at - 0.5), radius);
      mean += sign * (at - 0.5), square += sign * (at - 0.5) * (at - 0.5), total += sign;
      const double x = radius * (2 * u - 1);
      wanted_square += weight(x) * x * x, wanted_total += weight(x);
    }
    EXPECT_NEAR(mean / total, 0, 1e-6) << filter.name;
    EXPECT_NEAR(square / total, wanted_square / wanted_total, 1e-3) << filter.name;
  }
}

}  // namespace
}  // namespace betwixt
