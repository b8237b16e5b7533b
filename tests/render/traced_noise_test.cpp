// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests the noise of the style `traced`: the denoiser, adaptive sampling, and what is told of the work.
#include <algorithm>
#include <atomic>
#include <thread>

#include "base/work_progress.h"
#include "render/traced.h"
#include "render/traced_scenes.h"

namespace betwixt {
namespace {

using namespace traced_scenes;

TEST(TracedNoise, AnyNumberOfThreadsMakesTheSamePicture) {
  for (const int samples : {5, 16, RenderOptions::auto_samples})
    for (const bool denoise : {false, true}) {
      RenderOptions options = with(64, 36, samples);
      options.denoise = denoise;
      Picture one;
      for (const unsigned threads : {1U, 2U, 5U}) {
        const auto r = make_traced(options, threads);
        ASSERT_TRUE(r);
        Picture p;
        ASSERT_TRUE((*r)->render(apart(), p));  // what was drawn before
        ASSERT_TRUE((*r)->render(some_of_all(), p));
        if (threads == 1) one = p;
        EXPECT_EQ(p.rgba, one.rgba) << threads << " " << samples << " " << denoise;
      }
    }
}

// Balls before a wall, in the light of one that glows: only paths that meet it by chance see its light.
Frame by_a_glowing_ball() {
  Frame f = everywhere({0.05, 0.05, 0.05});
  f.items.push_back(item(square(), translation({0, 0, -1}) * scaling({20, 20, 1}), {0.8, 0.7, 0.6}, Material::matte));
  f.items.push_back(item(sphere(1.5), translation({2, -1, 0.6}), {0.8, 0.2, 0.2}, Material::matte));
  f.items.push_back(item(sphere(1), translation({-2, -1.5, 0.2}), {0.3, 0.5, 0.9}, Material::matte));
  f.items.push_back(item(sphere(1.2), translation({-1, 2, 1.5}), {3, 3, 2.5}, Material::glow));
  return f;
}

// Closer to the picture of many samples than four times as many samples without the denoiser are.
TEST(TracedNoise, TheDenoiserIsWorthFourTimesTheSamples) {
  RenderOptions many = with(96, 54, 1024), four = with(96, 54, 64);
  many.denoise = four.denoise = false;
  const Frame f = by_a_glowing_ball();
  const Picture exact = draw(f, many);
  const Picture few = draw(f, with(96, 54, 16));
  EXPECT_GT(psnr(few, exact), psnr(draw(f, four), exact) + 1);
  EXPECT_NEAR(mean(few) / mean(exact), 1, 0.05);
  EXPECT_NEAR(mean(draw(f, with(96, 54, RenderOptions::auto_samples))) / mean(exact), 1, 0.05);
}

// Drawings have no light to denoise, and no pixel gets worse.
TEST(TracedNoise, DrawingsStayAsTheyAre) {
  Frame f = some_of_all();
  f.surroundings.flat = true;
  RenderOptions raw = with(64, 36, 16), many = with(64, 36, 1024);
  raw.denoise = many.denoise = false;
  const Picture exact = draw(f, many);
  EXPECT_GE(psnr(draw(f, with(64, 36, 16)), exact), psnr(draw(f, raw), exact));
}

// The light of a hollow ball, as above. Its noise is known: the light is the same everywhere.
TEST(TracedNoise, AsManySamplesAsTheNoiseNeeds) {
  const double a = 0.85, range = 10, radius = 3, window = 1 - radius * radius / (range * range);
  Frame f = everywhere({1, 1, 1});
  f.lights = {lamp({0, 0, 0}, range)};
  f.lights[0].color = {0.2, 0.2, 0.2};
  f.camera = {};
  f.camera.world = translation({1, 0.5, 0});
  f.items.push_back(item(sphere(), scaling({radius, radius, radius}), {a, a, a}, Material::matte));
  const double expected = a * 0.8 * 0.2 * window * window / (1 - a);
  const auto error = [&](int samples) {
    RenderOptions options = with(40, 24, samples);
    options.linear = options.unclamped = true, options.denoise = false;
    LinearPicture p;
    EXPECT_TRUE(renderer(options)->render(f, p));
    double sum = 0;
    for (std::size_t i = 0; i < p.rgba.size(); i += 4)
      sum += std::pow(static_cast<double>(p.rgba[i]) / expected - 1, 2);
    return std::sqrt(sum / (40 * 24));
  };
  EXPECT_GT(error(16), 0.03);
  EXPECT_LT(error(RenderOptions::auto_samples), 0.03);
  EXPECT_GT(error(RenderOptions::auto_samples), 0.01);  // no more work than that
}

TEST(TracedNoise, OtherStylesTakeAutoAsTheirUsualNumber) {
  for (const char* const style : {"shaded", "wireframe", "hidden-line"}) {
    const Frame f = apart();
    EXPECT_EQ(draw(f, {48, 27, RenderOptions::auto_samples, style}).rgba, draw(f, {48, 27, 4, style}).rgba) << style;
  }
}

TEST(TracedNoise, TellsHowMuchIsDone) {
  const WorkProgress watching;
  EXPECT_EQ(watching.share(), 0);
  const auto r = make_traced(with(320, 180, 64), 1);
  std::vector<float> told;
  std::atomic<bool> done = false;
  std::thread reader([&] {
    while (!done)
      if (const float share = watching.share(); told.empty() || share != told.back()) told.push_back(share);
  });
  Picture p;
  EXPECT_TRUE((*r)->render(some_of_all(), p));
  done = true;
  reader.join();
  EXPECT_GT(told.size(), 3U);
  EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
  EXPECT_EQ(watching.share(), 1);
}

}  // namespace
}  // namespace betwixt
