// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests smooth edges of four samples a pixel against areas by closed form and by brute force.
#include "render/edges.h"

#include <random>

#include "render/scenes.h"

namespace betwixt {
namespace {

// Where graphics have four samples: the pattern of all common graphics interfaces.
const std::vector<float> usual{-0.125F, -0.375F, 0.375F, -0.125F, -0.375F, 0.125F, 0.125F, 0.375F};

template <class Inside>
std::array<int, 9> marks_of(const Inside& inside) {
  std::array<int, 9> marks{};
  for (std::size_t j = 0; j < 9; ++j)
    for (std::size_t k = 0; k < 4; ++k) {
      const double x = static_cast<double>(j % 3) - 1 + static_cast<double>(usual[2 * k]);
      const double y = static_cast<double>(j / 3) - 1 + static_cast<double>(usual[2 * k + 1]);
      if (inside(x, y)) marks[j] |= 1 << k;
    }
  return marks;
}

template <class Inside>
double area_of(const Inside& inside) {
  constexpr int side = 64;
  int count = 0;
  for (int j = 0; j < side; ++j)
    for (int i = 0; i < side; ++i) count += inside((i + 0.5) / side - 0.5, (j + 0.5) / side - 0.5) ? 1 : 0;
  return static_cast<double>(count) / (side * side);
}

// The root mean square of errors: of the smoothed shares, and of those that four samples have by themselves.
struct Errors {
  double smooth = 0, plain = 0;
};
template <class Shape>
Errors errors_of(const Shape& shape) {
  const EdgeSmoother smoother(usual);
  std::mt19937 random(7);
  Errors e;
  constexpr int trials = 4000;
  for (int i = 0; i < trials; ++i) {
    const auto inside = shape(std::uniform_real_distribution<>(0, 2 * pi)(random),
                              std::uniform_real_distribution<>(-0.75, 0.75)(random));
    const std::array<int, 9> marks = marks_of(inside);
    const double area = area_of(inside), smooth = smoother.bright_share(marks) - area;
    double plain = -area;
    for (int k = 0; k < 4; ++k) plain += marks[4] >> k & 1 ? 0.25 : 0;
    e.smooth += smooth * smooth / trials, e.plain += plain * plain / trials;
  }
  return {std::sqrt(e.smooth), std::sqrt(e.plain)};
}

// shows: 39.4
TEST(Edges, OfStraightLinesAreTwiceAsExact) {
  const Errors e = errors_of([](double turn, double away) {
    return [=](double x, double y) { return std::cos(turn) * x + std::sin(turn) * y > away; };
  });
  EXPECT_GT(e.plain, 0.08);
  EXPECT_LT(e.smooth, 0.047);
}

// shows: 39.4
TEST(Edges, OfDiscsAreMoreExact) {
  for (const double radius : {6.0, 20.0, 200.0}) {
    const Errors e = errors_of([=](double turn, double away) {
      return [=](double x, double y) {
        return std::hypot(x - (away + radius) * std::cos(turn), y - (away + radius) * std::sin(turn)) < radius;
      };
    });
    EXPECT_LT(e.smooth, 0.7 * e.plain) << radius;
  }
}

// shows: 39.4
TEST(Edges, NeverChangeAShareByMoreThanASample) {
  const EdgeSmoother smoother(usual);
  std::mt19937 random(3);
  for (int i = 0; i < 20000; ++i) {
    std::array<int, 9> marks{};
    for (int& m : marks) m = static_cast<int>(random() % 16);
    double plain = 0;
    for (int k = 0; k < 4; ++k) plain += marks[4] >> k & 1 ? 0.25 : 0;
    const double share = smoother.bright_share(marks);
    ASSERT_LE(std::abs(share - plain), 0.2501);
    // Where the bright ones and the dark ones change places, so do the shares.
    for (int& m : marks) m = 15 - m;
    ASSERT_NEAR(smoother.bright_share(marks), 1 - share, 1e-6);
  }
}

// shows: 39.4
TEST(Edges, OfThinLinesAndPointsStay) {
  const EdgeSmoother smoother(usual);
  for (const double width : {0.2, 0.4, 0.6}) {
    const auto marks = marks_of([=](double x, double y) { return std::abs(0.8 * x + 0.6 * y) < 0.5 * width; });
    double plain = 0;
    for (int k = 0; k < 4; ++k) plain += marks[4] >> k & 1 ? 0.25 : 0;
    EXPECT_EQ(smoother.bright_share(marks), plain) << width;
  }
}

Picture picture(int width, int height, const std::function<std::array<int, 4>(int, int)>& pixel) {
  Picture p;
  p.width = width, p.height = height;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (const int c : pixel(x, y)) p.rgba.push_back(static_cast<std::uint8_t>(c));
  return p;
}

// shows: 39.4
TEST(Edges, OfPatternsStayAndPicturesBecomeOpaque) {
  const EdgeSmoother smoother(usual);
  for (const auto& [width, height] : {std::pair(1, 1), {7, 1}, {1, 9}, {8, 8}, {23, 5}}) {
    // A checked pattern: no edge goes through a pixel.
    Picture p = picture(width, height, [](int x, int y) { return std::array{x % 2 * 200, y % 2 * 200, 30, 0}; });
    const Picture before = p;
    smoother.finish(p);
    for (std::size_t i = 0; i < p.rgba.size(); ++i)
      ASSERT_EQ(p.rgba[i], i % 4 == 3 ? 255 : before.rgba[i]) << width << " x " << height;
  }
}

// shows: 39.4
TEST(Edges, AnyMarksAndColoursAreTaken) {
  const EdgeSmoother smoother(usual);
  std::mt19937 random(11);
  for (int trial = 0; trial < 200; ++trial) {
    const int width = 1 + static_cast<int>(random() % 40), height = 1 + static_cast<int>(random() % 9);
    Picture p = picture(width, height, [&](int, int) {
      return std::array{static_cast<int>(random() % 256), static_cast<int>(random() % 256),
                        static_cast<int>(random() % 256), static_cast<int>(random() % 16)};
    });
    LinearPicture light{width, height, {}};
    const std::array<float, 6> odd{0, 1e-30F, 3, 60000, INFINITY, NAN};
    for (std::size_t i = 0; i < p.rgba.size(); ++i)
      light.rgba.push_back(random() % 2 ? odd[random() % 6] : -odd[random() % 6]);
    smoother.finish(p);
    smoother.finish(light);
    for (std::size_t i = 3; i < p.rgba.size(); i += 4) {
      ASSERT_EQ(p.rgba[i], 255);
    }
    for (const float x : light.rgba) ASSERT_FALSE(x < 0);
  }
}

// A white square that is turned, with light that needs no lamps.
Frame turned_square(double angle) {
  Frame f = scenes::frame();
  f.items.clear();
  f.items.push_back(
      scenes::item(scenes::square(), rotation(axis_angle({0, 0, 1}, angle)) * scaling({4, 4, 4}), {1, 1, 1}));
  f.items.back().material = Material::glow;
  return f;
}

// shows: 39.4
TEST(Edges, OfPicturesWithFourSamplesAreNearlyThoseOfSixteen) {
  double four = 0, sixteen = 0;
  for (int i = 1; i < 12; ++i) {
    const Frame f = turned_square(0.13 * i);
    const Picture exact = scenes::draw(f, {8 * 64, 8 * 48, 4, "shaded"});
    const auto error = [&](int samples) {
      const Picture p = scenes::draw(f, {64, 48, samples, "shaded"});
      double sum = 0;
      for (int y = 0; y < 48; ++y)
        for (int x = 0; x < 64; ++x) {
          double mean = 0;
          for (int j = 0; j < 64; ++j)
            mean += scenes::decoded(scenes::pixel(exact, 8 * x + j % 8, 8 * y + j / 8).g / 255.0) / 64;
          const double off = scenes::decoded(scenes::pixel(p, x, y).g / 255.0) - mean;
          sum += off * off;
        }
      return sum;
    };
    four += error(4), sixteen += error(16);
  }
  EXPECT_LT(std::sqrt(four), 2.2 * std::sqrt(sixteen));  // 1.96 times; without smoothing 2.93 times
  EXPECT_GT(std::sqrt(four), 0.5 * std::sqrt(sixteen));
}

}  // namespace
}  // namespace betwixt
