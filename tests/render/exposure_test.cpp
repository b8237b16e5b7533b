// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Compares motion blur and depth of field with closed forms, for edges and discs, and tests objects that jump.
#include <fmt/format.h>

#include <algorithm>
#include <random>

#include "render/exposure_scenes.h"
#include "render/scenes.h"
#include "support/loaded_film.h"

namespace betwixt {
namespace {

struct Taken {
  explicit Taken(std::string_view script, int width = 96, int height = 54, int samples = 4,
                 const std::string& style = "shaded")
      : film(script), evaluation(film.program), width(width) {
    RenderOptions options;
    options.width = width, options.height = height, options.samples = samples, options.linear = true;
    options.style = style;
    renderer = *make_renderer(options);
  }
  LinearPicture at(std::string_view time, int subframes = 64, std::optional<double> shutter = {}) {
    LinearPicture out;
    const Status taken =
        renderer->render_blurred(evaluation, *parse_time(time, film.loaded.document), {subframes, shutter}, out);
    EXPECT_TRUE(taken) << (taken ? "" : taken.error().message);
    return out;
  }
  LinearPicture sharp(std::string_view time) {
    LinearPicture out;
    evaluation.to(*parse_time(time, film.loaded.document));
    EXPECT_TRUE(renderer->render(evaluation, out));
    return out;
  }
  LoadedFilm film;
  Evaluation evaluation;
  std::unique_ptr<Renderer> renderer;
  int width;
};

double light(const LinearPicture& p, int x, int y, int channel = 1) {
  return static_cast<double>(
      p.rgba[4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(p.width) + static_cast<std::size_t>(x)) +
             static_cast<std::size_t>(channel)]);
}

// Each sample knows when it is covered to half a picture's share of the time; a pixel has four.
TEST(Exposure, AnEdgeThatMovesIsTheClosedForm) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> any(0, 1);
  double off = 0;
  int pixels = 0;
  for (int k = 0; k < 14; ++k) {
    // 1 frame is twice the shutter's time. Of round numbers all subframes fall between samples, or upon them.
    const double gone = k < 4 ? std::array{8.0, 16.0, 32.0, 4.0}[static_cast<std::size_t>(k)] : 3 + 40 * any(random);
    const double first = k < 4 ? 10 : 5 + 30 * any(random);
    const bool up = k % 3 == 2;
    const double far = up ? std::min(gone, 30.0) : gone, start = up ? std::min(first, 15.0) : first;
    // Its right border (or its lower one) at `start` pixels from the left (the top), at frame 1.
    const auto place = [&](double at) {
      return up ? fmt::format("(0 {} 0)", 2.7 - at / 10 + 10) : fmt::format("({} 0 0)", -4.8 + at / 10 - 10);
    };
    Taken film(drawn_film(
        fmt::format("create wall rectangle size=(20 20) color=white\nwall.position\n  1f {} linear\n  2f {}\n",
                    place(start), place(start + 2 * far))));
    for (const int subframes : {64, 256}) {
      const LinearPicture picture = film.at("1f", subframes);
      for (int i = 0; i < (up ? 54 : 96); ++i) {
        const double is = up ? light(picture, 48, i) : light(picture, i, 27),
                     wanted = share_swept(start - i, start + far - i);
        EXPECT_NEAR(is, wanted, subframes == 64 ? 3.0 / 255 : 1.5 / 255)
            << "pixel " << i << " of an edge that goes " << far << " from " << start << (up ? " down" : "");
        if (subframes == 64 && wanted > 0 && wanted < 1) off += std::abs(is - wanted), ++pixels;
      }
    }
  }
  EXPECT_LT(off / pixels, 0.7 / 255);
}

TEST(Exposure, WhatStandsStillIsOnePicture) {
  const std::string still =
      "create ball sphere radius=1 color=gold\ncreate lamp light position=(3 4 5)\n"
      "create eye camera position=(0 1 8) look-at=(0 0 0)\nset eye.shutter 360deg\n"
      "ball.position\n  1f (0 0 0) linear\n  5f (0 0 0) linear\n  9f (3 0 0)\n";
  Taken film(still);
  EXPECT_EQ(film.at("2f").rgba, film.sharp("2f").rgba);
  EXPECT_EQ(film.at("12f").rgba, film.sharp("12f").rgba);
  EXPECT_NE(film.at("6f").rgba, film.sharp("6f").rgba);
  EXPECT_EQ(film.at("6f", 64, 0.0).rgba, film.sharp("6f").rgba);  // an instant
  EXPECT_EQ(film.at("6f", 1).rgba, film.sharp("6f").rgba);
}

TEST(Exposure, HasTheSameBitsWhateverWasTakenBefore) {
  const std::string script = drawn_film(
      "create a circle radius=0.6 color=gold\ncreate b rectangle size=(1 1) color=red\n"
      "a.position\n  1f (-4 0 0) linear\n  9f (4 2 0)\nb.rotation\n  1f euler(0 0 0) linear\n"
      "  9f euler(0 0 500deg)\n");
  Taken one(script), other(script);
  const LinearPicture third = one.at("3f"), fourth = one.at("4.3f");
  EXPECT_EQ(other.at("4.3f").rgba, fourth.rgba);
  other.sharp("8f");
  EXPECT_EQ(other.at("3f").rgba, third.rgba);
}

// The expected picture: the sum of single pictures.
TEST(Exposure, IsTheSumOfSharpPictures) {
  Taken film(
      "create bar box size=(3 0.3 0.3) color=tomato\ncreate lamp light position=(3 4 5) range=40 shadow=off\n"
      "create eye camera position=(0 1 8) look-at=(0 0 0)\nset eye.shutter 1f\nbackground navy\n"
      "bar.rotation\n  1f euler(0 0 0) linear\n  5f euler(0 0 400deg)\n",
      96, 54, 16);
  const LinearPicture taken = film.at("2f");
  std::vector<double> sum(taken.rgba.size());
  constexpr int many = 256;
  for (int k = 0; k < many; ++k) {
    const LinearPicture one = film.sharp(fmt::format("{}f", 2 + (k + 0.5) / many));
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += static_cast<double>(one.rgba[i]) / many;
  }
  double most = 0, mean = 0;
  for (std::size_t i = 0; i < sum.size(); ++i) {
    const double off = std::abs(sum[i] - static_cast<double>(taken.rgba[i]));
    most = std::max(most, off), mean += off / static_cast<double>(sum.size());
  }
  EXPECT_LT(most, 0.03);
  EXPECT_LT(mean, 0.001);
}

// A jump between frames, after a third of the shutter's time: the jumping object is drawn once, as before the jump, and
// moving objects next to it are still blurred.
TEST(Exposure, NothingBlursAcrossWhatJumps) {
  const std::string moving =
      "create m circle radius=0.5 color=white position=(0 2 0)\nm.position\n  1f (-4 2 0) linear\n"
      "  9f (4 2 0)\n";
  const std::string jumps[] = {
      "create j rectangle size=(2 2) color=white\nj.position\n  1f (-3 -1 0) hold\n  3.15f (3 -1 0)\n",
      "create j rectangle size=(2 2) color=white\nj.display\n  1f on\n  3.15f off\n",
      "create j rectangle size=(2 2) color=white position=(0 -1 0)\nj.color\n  1f white hold\n  3.15f red\n",
      "create j text text=\"I\" size=2 position=(0 -1 0)\nj.text\n  1f \"I\"\n  3.15f \"II\"\n",
      "create j rectangle size=(2 2) position=(0 -1 0)\nj.geometry\n  1f none\n  3.15f shape(m)\n",
      "create h group position=(3 -1 0)\ncreate j rectangle size=(2 2) color=white\nat 3.15f hang j on h\n",
      "create j rectangle size=(2 2) color=white\nj.position\n  1f (-3 -1 0) hold\n  2.05f (3 -1 0) hold\n"
      "  3.1f (-3 -1 0)\nextend j.position cycle\n",
      "create j rectangle size=(2 2) color=white\nlayer up add\non up j.position\n  1f (-3 -1 0) hold\n  3.15f (3 -1 "
      "0)\n"};
  for (const std::string& jump : jumps) {
    SCOPED_TRACE(jump);
    Taken film(drawn_film(moving + jump));
    const LinearPicture taken = film.at("3f"), sharp = film.sharp("3f"), later = film.sharp("3.4f");
    bool differs = false;
    for (int y = 20; y < 54; ++y)  // below what moves
      for (int x = 0; x < 96; ++x) {
        EXPECT_NEAR(light(taken, x, y), light(sharp, x, y), 1e-6) << x << " " << y;
        differs = differs || std::abs(light(sharp, x, y) - light(later, x, y)) > 0.5;
      }
    EXPECT_TRUE(differs);
    double blurred = 0;
    for (int x = 0; x < 96; ++x) blurred = std::max(blurred, std::abs(light(taken, x, 7) - light(sharp, x, 7)));
    EXPECT_GT(blurred, 0.3);
  }
}

// An object that moves and then jumps is blurred only by its motion before the jump.
TEST(Exposure, ForWhatJumpsTheShutterClosesBefore) {
  // Its right border goes from 10 pixels to 30 while a quarter of a frame passes, then it is elsewhere.
  Taken film(
      drawn_film("create wall rectangle size=(20 20) color=white\nwall.position\n  1f (-13.8 0 0) linear\n"
                 "  1.25f (-11.8 0 0) cut (40 0 0)\n"));
  const LinearPicture picture = film.at("1f");
  for (int i = 0; i < 96; ++i) EXPECT_NEAR(light(picture, i, 27), share_swept(10 - i, 30 - i), 3.0 / 255) << i;
}

TEST(Exposure, NothingBlursAcrossCamerasAndLights) {
  const std::string film =
      "rate 24\ncreate ball sphere radius=1 color=gold\ncreate lamp light position=(3 4 5)\n"
      "create eye camera position=(0 1 8) look-at=(0 0 0)\ncreate side camera position=(8 1 0) look-at=(0 1 0)\n"
      "set {eye,side}.shutter 180deg\n";
  for (const char* jump : {"at 3.15f look through side\n", "lamp.intensity\n  1f 1 hold\n  3.15f 5\n",
                           "eye.lens\n  1f 35mm hold\n  3.15f 90mm\n"}) {
    SCOPED_TRACE(jump);
    Taken taken(film + jump);
    const LinearPicture was = taken.sharp("3f"), now = taken.at("3f");
    double most = 0;
    for (std::size_t i = 0; i < was.rgba.size(); ++i)
      most = std::max(most, static_cast<double>(std::abs(was.rgba[i] - now.rgba[i])));
    EXPECT_LT(most, 1e-6);
    EXPECT_NE(taken.sharp("3.4f").rgba, was.rgba);
  }
}

// A small glowing lamp becomes a disc of diameter A·|d − f|/d, measured at the distance f. Its light is spread evenly,
// so the mean square distance from the centre is half of the square of the radius.
TEST(Exposure, WhatIsOutOfFocusIsADisc) {
  for (const double depth : {4.0, 8.0, 24.0}) {
    Taken film(
        fmt::format("create spot sphere radius={} color=white material=glow position=(0.3 0.2 {})\nbackground black\n"
                    "create eye camera position=(0 0 0) look-at=(0 0 -1)\nset eye.f-stop 0.05\nset eye.focus 8\n",
                    0.01 * depth, -depth),
        240, 135, 16);
    const double aperture = 0.035 / 0.05, scale = 120 / (18.0 / 35);  // metres; pixels a unit of tangent
    const double radius = 0.5 * aperture * std::abs(1 / depth - 1.0 / 8) * scale, own = 0.01 * scale;
    const LinearPicture taken = film.at("1f", 256);
    const LinearPicture sharp = film.sharp("1f");
    double sum = 0, square = 0, all = 0;
    const double middle_x = 120 + scale * 0.3 / depth, middle_y = 67.5 - scale * 0.2 / depth;
    for (int y = 0; y < 135; ++y)
      for (int x = 0; x < 240; ++x) {
        const double l = light(taken, x, y), dx = x + 0.5 - middle_x, dy = y + 0.5 - middle_y;
        sum += l, square += l * (dx * dx + dy * dy), all += light(sharp, x, y);
      }
    EXPECT_NEAR(sum, all, 0.03 * all) << depth;  // none is lost
    EXPECT_NEAR(std::sqrt(square / sum), std::sqrt((radius * radius + own * own) / 2), 0.1 + 0.02 * radius) << depth;
  }
}

// In the style traced the summed pictures share the samples of one picture, and no two use the same samples.
TEST(Exposure, TracedPicturesAreBlurredAlike) {
  const std::string script =
      drawn_film("create a circle radius=0.6 color=gold\na.position\n  1f (-4 0 0) linear\n  5f (4 2 0)\n");
  Taken shaded(script), traced(script, 96, 54, 64, "traced"), again(script, 96, 54, 64, "traced");
  const LinearPicture one = shaded.at("2f", 16), other = traced.at("2f", 16);
  double mean = 0, most = 0;
  for (std::size_t i = 0; i < one.rgba.size(); ++i) {
    const auto off = static_cast<double>(std::abs(one.rgba[i] - other.rgba[i]));
    mean += off / static_cast<double>(one.rgba.size()), most = std::max(most, off);
  }
  EXPECT_LT(mean, 0.003);
  EXPECT_LT(most, 0.15);
  again.at("3f", 16);
  EXPECT_EQ(again.at("2f", 16).rgba, other.rgba);
  EXPECT_EQ(traced.at("12f", 16).rgba, traced.sharp("12f").rgba);
}

// Two styles agree on objects that move, rotate and are out of focus: 35 dB.
TEST(Exposure, TracedBlurIsThatOf64SubframesOfShaded) {
  const std::string script =
      "rate 24\nrange 1f 24f\nambient #303030\ncreate sun light shines=sun position=(2 4 6) shadow=off\n"
      "create a sphere radius=0.8 color=tomato material=matte\ncreate b box color=#60a0e0 material=matte\n"
      "create c torus position=(2 -1 -6) color=gold material=matte\na.position\n  1f (-3 0 0) linear\n  9f (3 1 0)\n"
      "b.rotation.y\n  1f 0deg linear\n  9f 180deg\nset b.position (-1 -1.6 -2)\n"
      "create eye camera position=(0 0 9) look-at=(0 0 0)\nset eye.shutter 180deg\n";
  for (const std::string lens : {"set eye.f-stop 0.1\n", "set eye.f-stop 1e6\n"}) {
    Taken shaded(script + lens, 96, 54, 4), traced(script + lens, 96, 54, 256, "traced");
    Picture one, other;
    to_shown(shaded.at("4f"), one), to_shown(traced.at("4f"), other);
    double squares = 0;
    for (std::size_t i = 0; i < one.rgba.size(); ++i) squares += std::pow(one.rgba[i] - other.rgba[i], 2);
    const double mean = squares / (0.75 * static_cast<double>(one.rgba.size()));  // of three channels
    EXPECT_GT(10 * std::log10(255 * 255 / mean), 35) << lens;
  }
}

TEST(Exposure, FocusIsOnThingsDistancesAndWhatIsLookedAt) {
  const std::string film =
      "create a sphere position=(0 0 -4)\ncreate b sphere position=(1 0 -20)\n"
      "create eye camera position=(0 0 6) look-at=a\nset eye.f-stop 1\n";
  const auto focus = [&](const std::string& more, const char* time = "1f") {
    return LoadedFilm(film + more).frame(time).camera.focus;
  };
  EXPECT_NEAR(focus(""), 10, 1e-12);
  EXPECT_NEAR(focus("set eye.focus b\n"), 26, 1e-12);  // along the axis, not the way there
  EXPECT_NEAR(focus("set eye.focus 3.5\n"), 3.5, 1e-12);
  EXPECT_NEAR(focus("set eye.focus 250cm\n"), 2.5, 1e-12);
  const std::string pulled = "eye.focus\n  1f a linear\n  25f b\n", by_numbers = "eye.focus\n  1f 2 linear\n  25f 4\n";
  EXPECT_NEAR(focus(pulled, "13f"), 18, 1e-9);
  EXPECT_NEAR(focus(by_numbers, "7f"), 2.5, 1e-9);
  EXPECT_NEAR(focus("eye.focus\n  1f b linear\n  25f 2\n", "13f"), 14, 1e-9);  // of both sorts
  const LoadedFilm mixed(film + "eye.focus\n  1f b linear\n  25f 2\n");        // told as the distance that it is
  expect_numbers(mixed, "eye.focus", "13f", {0, 0, -14}, 1e-9);
  for (const char* sharp : {"set eye.f-stop 1e6\n", "set eye.f-stop off\n"})
    EXPECT_EQ(LoadedFilm(film + sharp).frame("1f").camera.aperture, 0);
  EXPECT_NEAR(LoadedFilm(film).frame("1f").camera.aperture, 0.035, 1e-12);
  EXPECT_EQ(LoadedFilm(film + "set eye.height 5\n").frame("1f").camera.aperture, 0);  // parallel rays have none
}

TEST(Exposure, TheShutterIsReadAndWritten) {
  const auto open = [](const std::string& said) {
    return LoadedFilm("rate 30\ncreate eye camera\nset eye.shutter " + said + "\n").frame("1f").camera.shutter;
  };
  EXPECT_NEAR(open("180deg"), 1.0 / 60, 1e-12);
  EXPECT_NEAR(open("0.25turn"), 1.0 / 120, 1e-12);
  EXPECT_NEAR(open("720deg"), 2.0 / 30, 1e-12);
  EXPECT_NEAR(open("0.5f"), 1.0 / 60, 1e-9);
  EXPECT_NEAR(open("10ms"), 0.01, 1e-12);
  EXPECT_EQ(open("off"), 0);
  const LoadedFilm film("create eye camera\nset eye.shutter 180deg\nsubframes 48\n");
  EXPECT_EQ(film.loaded.document.subframes(), 48);
}

}  // namespace
}  // namespace betwixt
