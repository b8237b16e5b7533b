// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests motion blur and depth of field of the style `traced`, whose rays each have their own time and their own point
// of the lens, against closed forms.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "render/exposure_scenes.h"
#include "render/pixel_sampler.h"
#include "render/scenes.h"
#include "render/traced.h"
#include "support/loaded_film.h"

namespace betwixt {
namespace {

struct TracedTake {
  explicit TracedTake(std::string_view script, int samples, int width = 96, int height = 54, bool denoise = false,
                      unsigned threads = 0)
      : film(script), evaluation(film.program) {
    RenderOptions options;
    options.width = width, options.height = height, options.samples = samples, options.style = "traced";
    options.linear = options.unclamped = true, options.denoise = denoise;
    renderer = *make_traced(options, threads);
  }
  Time time(std::string_view at) const { return *parse_time(at, film.loaded.document); }
  LinearPicture at(std::string_view when, int subframes = 16, std::optional<double> shutter = {}) {
    LinearPicture out;
    const Status taken = renderer->render_blurred(evaluation, time(when), {subframes, shutter}, out);
    EXPECT_TRUE(taken) << (taken ? "" : taken.error().message);
    return out;
  }
  LinearPicture sharp(std::string_view when) {
    LinearPicture out;
    evaluation.to(time(when));
    EXPECT_TRUE(renderer->render(evaluation, out));
    return out;
  }
  LoadedFilm film;
  Evaluation evaluation;
  std::unique_ptr<Renderer> renderer;
};

double lightness(const LinearPicture& p, int x, int y, std::size_t channel = 1) {
  const auto row = static_cast<std::size_t>(y) * static_cast<std::size_t>(p.width);
  return static_cast<double>(p.rgba[4 * (row + static_cast<std::size_t>(x)) + channel]);
}

// The root of the mean square of the difference.
double rms_difference(const LinearPicture& a, const LinearPicture& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.rgba.size(); ++i) sum += std::pow(static_cast<double>(a.rgba[i] - b.rgba[i]), 2);
  return std::sqrt(sum / static_cast<double>(a.rgba.size()));
}

TEST(TracedExposure, AnEdgeThatMovesIsALine) {
  for (const double gone : {4.0, 16.3, 37.0}) {
    TracedTake film(
        drawn_film(fmt::format("create wall rectangle size=(20 20) color=white\nwall.position\n  1f ({} 0 0) linear\n"
                               "  2f ({} 0 0)\n",
                               -4.8 + 1 - 10, -4.8 + 1 + gone / 5 - 10)),
        256);
    const LinearPicture p = film.at("1f");
    double mean = 0;
    for (int i = 0; i < 96; ++i) {
      const double wanted = share_swept(10 - i, 10 + gone - i);
      double row = 0;
      for (int y = 0; y < 54; ++y) {
        row += lightness(p, i, y) / 54;
        EXPECT_NEAR(lightness(p, i, y), wanted, 0.04) << i << " " << y << " gone " << gone;
      }
      mean += std::abs(row - wanted) / gone;
    }
    EXPECT_LT(mean, 0.002) << gone;
  }
}

// A bar that turns evenly covers a place at the distance r from its middle for 4 asin(w / r) of a whole turn, where w
// is half its width. One and a quarter turns take five steps at least, or the bar would be shorter in between.
TEST(TracedExposure, ABarThatTurnsIsFansOfArcs) {
  TracedTake film(drawn_film("create bar rectangle size=(5 0.6) color=white\nbar.rotation.z\n  1f 0deg linear\n"
                             "  2f 720deg\n"),
                  256);
  const LinearPicture p = film.at("1f");
  const auto covered = [](double x, double y) {
    const double r = std::hypot(x, y), along = std::sqrt(r * r - 9);
    return r <= 3 ? 1 : along > 25 ? 0 : 4 * std::asin(3 / r) / (2 * pi);
  };
  for (const int ring : {5, 9, 15, 20, 24, 27}) {
    double mean = 0, wanted = 0;
    int pixels = 0;
    for (int y = 0; y < 54; ++y)
      for (int x = 0; x < 96; ++x) {
        if (static_cast<int>(std::hypot(x + 0.5 - 48, y + 0.5 - 27)) != ring) continue;
        mean += lightness(p, x, y), ++pixels;
        for (int k = 0; k < 64; ++k) wanted += covered(x + (k % 8 + 0.5) / 8 - 48, y + (k / 8 + 0.5) / 8 - 27) / 64;
      }
    EXPECT_NEAR(mean / pixels, wanted / pixels, ring == 24 ? 0.01 : 0.004) << ring;  // its end is a chord
  }
}

// The corners of its triangles move, by themselves.
TEST(TracedExposure, WhatGrowsIsALine) {
  for (const char* kind : {"rectangle size=(4 20)", "rectangle corner=0.5 size=(4 20)"}) {
    TracedTake film(
        drawn_film(fmt::format("create wall {} color=white\nwall.size\n  1f (4 20) linear\n  2f (12 20)\n", kind)), 64);
    const LinearPicture p = film.at("1f");
    for (int x = 48; x < 96; ++x) {
      double column = 0;
      for (int y = 0; y < 54; ++y) column += lightness(p, x, y) / 54;
      EXPECT_NEAR(column, share_swept(20 + 48 - x, 40 + 48 - x), 0.02) << kind << " " << x;
    }
  }
}

// Whatever the camera does, what moves with it stands still: as sharp as without a shutter. Everything else does not.
TEST(TracedExposure, WhatMovesWithTheCameraIsSharp) {
  TracedTake film(
      "rate 24\nrange 1f 24f\nbackground black\ncreate eye camera position=(0 0 10) rotation=euler(0 0 0)\n"
      "set eye.shutter 180deg\ncreate eye/near rectangle size=(1 1) position=(0 0 -5) color=white material=glow\n"
      "eye.rotation.y\n  1f 0deg linear\n  2f 120deg\neye.position.x\n  1f 0 linear\n  2f 3\n"
      "create far sphere radius=0.5 position=(-2 2.3 0) color=white material=glow\n",
      64);
  const LinearPicture p = film.at("1f"), sharp = film.sharp("1f");
  double most = 0, other = 0;
  for (int y = 16; y < 54; ++y)
    for (int x = 0; x < 96; ++x) most = std::max(most, std::abs(lightness(p, x, y) - lightness(sharp, x, y)));
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 96; ++x) other = std::max(other, std::abs(lightness(p, x, y) - lightness(sharp, x, y)));
  EXPECT_EQ(lightness(sharp, 48, 27), 1);
  EXPECT_LT(most, 0.15);  // edges lie otherwise in their pixels
  EXPECT_GT(other, 0.3);
}

// Rods that swing before a bright sky, of few samples with the denoiser: no pixel is far from that of many samples.
TEST(TracedExposure, EdgesBeforeASkyHaveNoDots) {
  const std::string script =
      "rate 24\nrange 1f 24f\nsky day hour=15\nground #a9b89a\n"
      "create a{1..5} cylinder radius=0.06 height=1.4 position=(i*0.8-2.4 0.9 0) color=tomato\n"
      "a{1..5}.rotation.z\n  1f i*13deg linear\n  25f i*13deg+90deg\n"
      "create eye camera position=(0 0.9 6) look-at=(0 0.9 0) lens=60mm\nset eye.shutter 360deg\n";
  TracedTake few(script, 16, 160, 90, true), many(script, 256, 160, 90);
  Picture p, exact;
  to_shown(few.at("6f"), p), to_shown(many.at("6f"), exact);
  int most = 0;
  for (std::size_t i = 0; i < p.rgba.size(); ++i) most = std::max(most, std::abs(p.rgba[i] - exact.rgba[i]));
  EXPECT_LT(most, 28);
}

// A colour that changes evenly is seen as its mean, and so is what fades.
TEST(TracedExposure, ColorsAndOpacitiesAreMeans) {
  TracedTake film(drawn_film("create a rectangle size=(4 4) position=(-2.4 0 0) color=black\na.color\n"
                             "  1f black linear\n  2f white\n"
                             "create b rectangle size=(4 4) position=(2.4 0 0) color=white\nb.transparency\n"
                             "  1f 0 linear\n  2f 1\n"),
                  64);
  const LinearPicture p = film.at("1f"), middle = film.sharp("1.25f");
  double a = 0;
  for (int k = 0; k < 16; ++k) a += lightness(film.sharp(fmt::format("{}f", 1 + (k + 0.5) / 32)), 24, 27) / 16;
  EXPECT_NEAR(lightness(p, 24, 27), a, 0.01);
  EXPECT_NEAR(lightness(p, 72, 27), 0.75, 0.01);
  EXPECT_NEAR(lightness(middle, 72, 27), 0.75, 0.01);
}

// A small lamp becomes a disc of the diameter A·|d − f|/d, measured at the distance f, as bright everywhere. Two
// subframes would be two spots.
TEST(TracedExposure, WhatIsOutOfFocusIsAnEvenDisc) {
  for (const double depth : {4.0, 24.0}) {
    const double aperture = 0.035 / 0.02, scale = 60 / (18.0 / 35);  // metres; pixels a unit of tangent
    const double radius = 0.5 * aperture * std::abs(1 / depth - 1.0 / 8) * scale, own = 1.4;
    TracedTake film(fmt::format("create spot sphere radius={} color=white material=glow position=({} {} {})\n"
                                "background black\ncreate eye camera position=(0 0 0) look-at=(0 0 -1)\n"
                                "set eye.f-stop 0.02\nset eye.focus 8\n",
                                own * depth / scale, 5 * depth / scale, 2 * depth / scale, -depth),
                    256, 120, 68);
    const LinearPicture taken = film.at("1f", 2), sharp = film.sharp("1f");
    const double middle_x = 65, middle_y = 32;
    double all = 0, square = 0, inner = 0, wanted = 0, left = 0;
    for (int y = 0; y < 68; ++y)
      for (int x = 0; x < 120; ++x) {
        const double l = lightness(taken, x, y), dx = x + 0.5 - middle_x, dy = y + 0.5 - middle_y;
        const double away = std::hypot(dx, dy);
        all += l, square += l * away * away, wanted += lightness(sharp, x, y);
        inner += away < radius / std::sqrt(2) ? l : 0, left += dx < 0 ? l : 0;
        EXPECT_TRUE(away < radius + own + 1 || l == 0) << x << " " << y;
      }
    EXPECT_NEAR(all, wanted, 0.03 * wanted) << depth;
    EXPECT_NEAR(std::sqrt(square / all), std::sqrt((radius * radius + own * own) / 2), 0.1 + 0.02 * radius) << depth;
    EXPECT_NEAR(inner / all, 0.5, 0.06) << depth;  // half of the disc's area
    EXPECT_NEAR(left / all, 0.5, 0.03) << depth;
  }
}

TEST(TracedExposure, WithoutShutterAndLensItIsTheSharpPicture) {
  const std::string script =
      "create ball sphere radius=1 color=gold\ncreate lamp light position=(3 4 5)\nground on\n"
      "create eye camera position=(0 1 8) look-at=(0 0 0)\nset eye.shutter 180deg\n"
      "ball.position\n  1f (0 0 0) linear\n  5f (0 0 0) linear\n  9f (3 0 0)\n";
  for (const bool denoise : {false, true}) {
    TracedTake film(script, 8, 64, 36, denoise);
    EXPECT_EQ(film.at("6f", 16, 0.0).rgba, film.sharp("6f").rgba);
    EXPECT_EQ(film.at("2f").rgba, film.sharp("2f").rgba);
    EXPECT_EQ(film.at("6f", 1).rgba, film.sharp("6f").rgba);
    EXPECT_NE(film.at("6f").rgba, film.sharp("6f").rgba);
  }
}

const char* const busy_film =
    "rate 24\ncreate ball sphere radius=1 color=gold\ncreate lamp light position=(3 4 5) shadow=soft\nground on\n"
    "create box1 box size=(1 2 1) position=(-1 1 -2) color=tomato\ncreate t text text=\"Ab\" position=(1 2 -1)\n"
    "create eye camera position=(0 1 8) look-at=(0 0 0)\nset eye.shutter 180deg\nset eye.f-stop 0.3\n"
    "box1.rotation.y\n  1f 0deg linear\n  9f 400deg\nball.position\n  1f (-3 0 0) linear\n  9f (3 1 0)\n"
    "lamp.position\n  1f (3 4 5) linear\n  9f (-3 4 5)\neye.position\n  1f (0 1 8) linear\n  9f (2 2 8)\n";

TEST(TracedExposure, AnyNumberOfThreadsAndAnyPictureBeforeMakeTheSameBytes) {
  for (const int samples : {5, RenderOptions::auto_samples}) {
    LinearPicture one;
    for (const unsigned threads : {1U, 3U}) {
      TracedTake film(busy_film, samples, 48, 27, true, threads);
      if (threads > 1) film.at("2.3f"), film.sharp("6f");
      const LinearPicture p = film.at("4f");
      if (threads == 1) one = p;
      EXPECT_EQ(p.rgba, one.rgba) << threads << " " << samples;
    }
  }
}

// Of a film in which all kinds of things move: the mean of many pictures.
TEST(TracedExposure, IsTheMeanOfSharpPictures) {
  std::string film(busy_film);
  film += "set eye.f-stop off\n";
  TracedTake exposed(film, 256, 64, 36), sharp(film, 8, 64, 36);
  const LinearPicture taken = exposed.at("4f");
  LinearPicture mean = taken;
  std::vector<double> sum(taken.rgba.size());
  constexpr int many = 64;
  for (int k = 0; k < many; ++k) {
    const LinearPicture one = sharp.sharp(fmt::format("{}f", 4 + (k + 0.5) / (2 * many)));
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += static_cast<double>(one.rgba[i]) / many;
  }
  for (std::size_t i = 0; i < sum.size(); ++i) mean.rgba[i] = static_cast<float>(sum[i]);
  EXPECT_LT(rms_difference(taken, mean), 0.006);
  EXPECT_GT(rms_difference(taken, exposed.sharp("4f")), 0.02);
}

// What jumps is shown as before the jump, and what moves beside it is blurred.
TEST(TracedExposure, NothingBlursAcrossWhatJumps) {
  const std::string moving =
      "create m circle radius=0.5 color=white position=(0 2 0)\nm.position\n  1f (-4 2 0) linear\n  9f (4 2 0)\n";
  for (const char* jump :
       {"create j rectangle size=(2 2) color=white\nj.position\n  1f (-3 -1 0) hold\n  3.15f (3 -1 0)\n",
        "create j rectangle size=(2 2) color=white\nj.display\n  1f on\n  3.15f off\n",
        "create j rectangle size=(2 2) color=white position=(0 -1 0)\nj.color\n  1f white hold\n  3.15f red\n",
        "create j text text=\"I\" size=2 position=(0 -1 0)\nj.text\n  1f \"I\"\n  3.15f \"II\"\n",
        "create h group position=(3 -1 0)\ncreate j rectangle size=(2 2) color=white\nat 3.15f hang j on h\n"}) {
    TracedTake film(drawn_film(moving + jump), 64);
    const LinearPicture taken = film.at("3f"), sharp = film.sharp("3f"), later = film.sharp("3.4f");
    double most = 0, differs = 0, blurred = 0;
    for (int y = 20; y < 54; ++y)
      for (int x = 0; x < 96; ++x) {
        most = std::max(most, std::abs(lightness(taken, x, y) - lightness(sharp, x, y)));
        differs = std::max(differs, std::abs(lightness(sharp, x, y) - lightness(later, x, y)));
      }
    for (int x = 0; x < 96; ++x) blurred = std::max(blurred, std::abs(lightness(taken, x, 7) - lightness(sharp, x, 7)));
    EXPECT_LT(most, 0.15) << jump;  // the edges' own noise
    EXPECT_GT(differs, 0.5) << jump;
    EXPECT_GT(blurred, 0.3) << jump;
  }
}

// A jump at the very end of the exposure is not seen.
TEST(TracedExposure, TheEndOfTheExposureIsNotInIt) {
  TracedTake film(drawn_film("set eye.shutter 360deg\ncreate j rectangle size=(2 2) color=white\nj.position\n"
                             "  1f (-3 0 0) hold\n  4f (3 0 0)\n"
                             "create m circle radius=0.5 position=(0 2 0)\nm.position\n  1f (-4 2 0) linear\n"
                             "  9f (4 2 0)\n"),
                  64);
  const LinearPicture p = film.at("3f");
  EXPECT_EQ(lightness(p, 18, 27), 1);
  EXPECT_EQ(lightness(p, 78, 27), 0);
}

// Code may change what is there at any time: an object of other triangles each time, and one that comes and goes.
TEST(TracedExposure, WhatHasOtherTrianglesIsShownInSteps) {
  TracedTake film(drawn_film("create bar arc radius=2 width=1 color=white\nbar.to\n  1f 10deg linear\n  2f 650deg\n"
                             "create now rectangle size=(1 1) position=(3.5 0 0) color=white\n"
                             "at 1f now.display = \"t < 0.25 / 24\"\n"),
                  64);
  const LinearPicture p = film.at("1f", 32);
  EXPECT_NEAR(lightness(p, 48 + 35, 27), 0.5, 0.1);  // half of the exposure
  // The arc grows evenly: at the angle a it is there for 1 - (a - 10) / 320 of the time.
  for (const double degrees : {60.0, 150.0, 240.0}) {
    const double a = degrees * pi / 180;
    const int x = static_cast<int>(48 + 19 * std::cos(a)), y = static_cast<int>(27 - 19 * std::sin(a));
    const double seen = lightness(p, x, y);
    EXPECT_NEAR(seen, 1 - (degrees - 10) / 320, 0.08) << degrees;
  }
}

// Every place of a pixel, time and point of the lens is met once by each of as many boxes as there are samples.
TEST(PixelSampler, FiveNumbersAreSpreadEvenly) {
  constexpr std::uint32_t count = 64;
  std::vector<std::array<double, 5>> all;
  for (std::uint32_t s = 0; s < count; ++s) all.push_back(traced::PixelSampler(7, s, count).next_5d());
  for (std::size_t d = 0; d < 5; ++d) {
    std::vector<int> in(count);
    for (const auto& one : all) ++in[static_cast<std::size_t>(one[d] * count)];
    EXPECT_EQ(*std::max_element(in.begin(), in.end()), 1) << d;
  }
  for (const auto& [a, b] : {std::pair<std::size_t, std::size_t>{0, 2}, {1, 2}, {3, 4}}) {
    std::vector<int> in(16);
    for (const auto& one : all) ++in[static_cast<std::size_t>(one[a] * 4) * 4 + static_cast<std::size_t>(one[b] * 4)];
    EXPECT_LE(*std::max_element(in.begin(), in.end()), 8) << a << b;
    EXPECT_GE(*std::min_element(in.begin(), in.end()), 1) << a << b;
  }
  traced::PixelSampler two(7, 5, count), five(7, 5, count);
  const auto a = two.next_2d();
  const auto b = five.next_5d();
  EXPECT_EQ(a[0], b[0]);
  EXPECT_EQ(a[1], b[1]);
  EXPECT_EQ(two.next_2d(), five.next_2d());
}

}  // namespace
}  // namespace betwixt
