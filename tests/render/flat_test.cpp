// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Flat pictures: coverage against exact areas, and whole pictures against those of the graphics interface.
#include "render/flat.h"

#include <fmt/format.h>

#include <algorithm>
#include <random>
#include <set>

#include "betwixt/language.h"
#include "betwixt/program.h"
#include "render/scenes.h"

namespace betwixt {
namespace {

using Corner = std::array<double, 2>;
using Polygon = std::vector<Corner>;

// Cuts a polygon at a line: keeps what is on the side where sign·(p[axis] - at) > 0 (Sutherland and Hodgman).
Polygon cut(const Polygon& p, std::size_t axis, double at, double sign) {
  Polygon out;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Corner &a = p[i], &b = p[(i + 1) % p.size()];
    const double da = sign * (a[axis] - at), db = sign * (b[axis] - at);
    if (da > 0) out.push_back(a);
    if ((da > 0) != (db > 0)) {
      const double s = da / (da - db);
      out.push_back({a[0] + s * (b[0] - a[0]), a[1] + s * (b[1] - a[1])});
    }
  }
  return out;
}

double area(const Polygon& p) {
  double twice = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Corner &a = p[i], &b = p[(i + 1) % p.size()];
    twice += a[0] * b[1] - b[0] * a[1];
  }
  return std::abs(twice) / 2;
}

double in_pixel(const Polygon& p, int x, int y) {
  return area(cut(cut(cut(cut(p, 0, x, 1), 0, x + 1, -1), 1, y, 1), 1, y + 1, -1));
}

std::vector<std::vector<float>> coverage(const std::vector<Polygon>& polygons, int width, int height) {
  Area all(width, height);
  for (const Polygon& p : polygons)
    for (std::size_t i = 0; i < p.size(); ++i) {
      const Corner &a = p[i], &b = p[(i + 1) % p.size()];
      all.add(static_cast<float>(a[0]), static_cast<float>(a[1]), static_cast<float>(b[0]), static_cast<float>(b[1]));
    }
  all.finish();
  std::vector<std::vector<float>> rows(static_cast<std::size_t>(height));
  std::vector<float> sums(static_cast<std::size_t>(width) + 2), room(sums.size());
  CoverageRows reader(all);
  for (int y = 0; y < height; ++y) {
    std::vector<float>& row = rows[static_cast<std::size_t>(y)];
    row.assign(static_cast<std::size_t>(width), 0);
    if (all.empty() || y < all.top() || y >= all.bottom()) continue;
    const RowCoverage covered = reader.next(y, sums, room);
    std::copy(covered.of.begin(), covered.of.end(), row.begin() + covered.first);
    EXPECT_TRUE(std::all_of(sums.begin(), sums.end(), [](float s) { return s == 0; }));
  }
  return rows;
}

TEST(Flat, CoverageIsTheAreaInThePixel) {
  constexpr int width = 23, height = 17;
  std::mt19937 random(3);
  for (int k = 0; k < 400; ++k) {
    // Convex: on a circle. Half of them reach across the borders, some are many times as large as the picture.
    const double size = k % 7 == 0 ? 2000 : k % 2 == 0 ? 30 : 6;
    const auto number = [&](double from, double to) { return std::uniform_real_distribution(from, to)(random); };
    const double x = number(-5, width + 5), y = number(-5, height + 5), squeeze = number(0.02, 1);
    std::vector<double> angles(3 + random() % 5);
    for (double& a : angles) a = number(0, 2 * pi);
    std::sort(angles.begin(), angles.end());
    Polygon p;
    for (const double a : angles) p.push_back({x + size * std::cos(a), y + squeeze * size * std::sin(a)});
    const auto got = coverage({p}, width, height);
    for (int row = 0; row < height; ++row)
      for (int column = 0; column < width; ++column)
        ASSERT_NEAR(got[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)], in_pixel(p, column, row),
                    size > 1000 ? 4e-3 : 4e-4)
            << k << ": " << column << ' ' << row;
  }
}

TEST(Flat, TrianglesOfAnAreaLeaveNoSeams) {
  const Corner middle{9.37, 7.81};
  std::vector<Polygon> fan;
  for (int i = 0; i < 37; ++i) {
    const auto at = [&](int k) {
      const double a = 2 * pi * (k % 37) / 37;
      return Corner{middle[0] + 7 * std::cos(a), middle[1] + 7 * std::sin(a)};
    };
    fan.push_back({middle, at(i), at(i + 1)});
  }
  const auto got = coverage(fan, 20, 16);
  for (int y = 3; y < 13; ++y)
    for (int x = 5; x < 14; ++x) EXPECT_EQ(got[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)], 1) << x << y;
}

// A drawing of many kinds, in front of each other. Half of the opaque ones are at one depth; there the graphics
// interface draws what is transparent last.
std::string drawing(std::mt19937& random, bool clear) {
  const auto number = [&](double from, double to) { return std::uniform_real_distribution(from, to)(random); };
  std::string out = "film flat\n";
  if (random() % 2 == 0) out += fmt::format("background #{:06x}\n", random() % 0x1000000);
  if (random() % 2 == 0) out += "create eye camera height=12 position=(0 0 20)\n";
  const std::array kinds{"circle radius={1:.3f}",
                         "rectangle size=({1:.3f} {0:.3f})",
                         "star radius={0:.3f} inner={1:.3f}/2",
                         "regular sides=5 radius={1:.3f}",
                         "ring radius={0:.3f} inner={0:.3f}*0.8",
                         "text text=\"Ag\" size={0:.3f}",
                         "line to=({0:.3f} {1:.3f} 0) width=0.1",
                         "polyline points=((0 0) ({0:.3f} {1:.3f}) ({1:.3f} 0)) width=0.15",
                         "circle radius={1:.3f} fill=off stroke=white stroke-width=0.2"};
  for (int i = 0; i < 14; ++i) {
    const double a = number(1, 3), b = number(0.5, 2);
    out += fmt::format("create o{} ", i) + fmt::format(fmt::runtime(kinds[random() % kinds.size()]), a, b) +
           fmt::format(" position=({:.3f} {:.3f} {:.2f}) rotation=(0deg 0deg {}deg) color=#{:06x}{}\n", number(-7, 7),
                       number(-4, 4), i % 2 == 0 && !clear ? 0 : number(-1, 1), random() % 360, random() % 0x1000000,
                       clear && i % 3 == 0 ? " transparency=0.6" : "");
  }
  return out + "o1.position.x\n  1f 0\n  24f 3\no2.color\n  1f red\n  24f blue\n";
}

Program program_of(const std::string& script) {
  const Loaded loaded = load_text(script, "film.bx");
  EXPECT_TRUE(loaded.diagnostics.empty())
      << (loaded.diagnostics.empty() ? "" : to_string(loaded.diagnostics[0])) << script;
  return Program::compile(loaded.document);
}

Picture drawn(const std::string& script, RenderOptions options) {
  Picture out;
  EXPECT_TRUE(scenes::renderer(options)->render(program_of(script).frame({}), out));
  return out;
}

LinearPicture drawn_light(const std::string& script, RenderOptions options) {
  options.linear = true;
  LinearPicture out;
  EXPECT_TRUE(scenes::renderer(options)->render(program_of(script).frame({}), out));
  return out;
}

TEST(Flat, PicturesAreThoseOfSixtyFourSamples) {
  constexpr int width = 320, height = 180, fine = 8;
  const auto graphics = scenes::renderer({fine * width, fine * height, 1, "shaded"});
  const auto painter = scenes::renderer({width, height, 4, "shaded"});
  std::mt19937 random(11);
  for (int k = 0; k < 6; ++k) {
    const bool clear = k >= 3;
    const std::string script = drawing(random, clear);
    const Frame frame = program_of(script).frame(Rate{24, 1}.frame(9));
    Picture got, large;
    FlatPainter alone(width, height);
    ASSERT_TRUE(alone.draw(FrameColumns(frame).columns(), got)) << script;
    Picture by_renderer;
    ASSERT_TRUE(painter->render(frame, by_renderer));
    EXPECT_EQ(by_renderer.rgba, got.rgba);
    ASSERT_TRUE(graphics->render(frame, large));
    double squares = 0;
    int inside = 0;
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        std::array<double, 3> sum{};
        bool same = true;
        const scenes::Pixel first = scenes::pixel(large, fine * x, fine * y);
        // Details are finer in the large picture, so borders may differ by parts of a pixel.
        for (int dy = -4; same && dy < fine + 4; dy += 3)
          for (int dx = -4; same && dx < fine + 4; dx += 3)
            same = scenes::pixel(large, std::clamp(fine * x + dx, 0, fine * width - 1),
                                 std::clamp(fine * y + dy, 0, fine * height - 1)) == first;
        for (int s = 0; s < fine * fine; ++s) {
          const scenes::Pixel p = scenes::pixel(large, fine * x + s % fine, fine * y + s / fine);
          same = same && p == first;
          sum[0] += scenes::decoded(p.r / 255.0), sum[1] += scenes::decoded(p.g / 255.0);
          sum[2] += scenes::decoded(p.b / 255.0);
        }
        const scenes::Pixel p = scenes::pixel(got, x, y);
        for (const auto& [mine, theirs] : {std::pair{p.r, sum[0]}, {p.g, sum[1]}, {p.b, sum[2]}}) {
          const double d = mine - scenes::encoded_byte(theirs / (fine * fine));
          squares += d * d;
        }
        EXPECT_EQ(p.a, 255);
        if (!same) continue;
        ++inside;
        // Blended colours are rounded once here, and to few bits for each layer there.
        const int most = clear ? 10 : 0;
        ASSERT_LE(std::max({std::abs(p.r - first.r), std::abs(p.g - first.g), std::abs(p.b - first.b)}), most)
            << x << ' ' << y << '\n'
            << script;
      }
    const double mean = squares / (3.0 * width * height);
    EXPECT_GT(10 * std::log10(255 * 255 / mean), 40) << script;
    EXPECT_GT(inside, width * height / 2);
  }
}

// A filled shape and its stroke meet: what is behind must not show between them.
TEST(Flat, PartsOfAnObjectLeaveNoSeam) {
  const Picture out = drawn(
      "film flat\nbackground #00ff00\ncreate a regular sides=6 radius=3 color=#0000ff stroke=#0000ff stroke-width=0.7 "
      "rotation=(0deg 0deg 17deg)\n",
      {160, 90, 4, "shaded"});
  int blue = 0;
  for (int y = 20; y < 70; ++y)
    for (int x = 55; x < 105; ++x) {
      if (std::hypot(x - 79.5, y - 44.5) > 26) continue;
      EXPECT_EQ(scenes::pixel(out, x, y), (scenes::Pixel{0, 0, 255, 255})) << x << ' ' << y;
      ++blue;
    }
  EXPECT_GT(blue, 1500);
}

// Slices of one colour are a whole disc, and light is the same: nothing of the background is between them.
TEST(Flat, SlicesOfAPieLeaveNoSeam) {
  const std::string script =
      "film flat\nbackground #00ff00\ncreate p pie of=(5 3 2.2 4.1) radius=3 rotation=(0deg 0deg 11deg)\n"
      "set p/*.color #0000ff\n";
  const RenderOptions options{160, 90, 4, "shaded"};
  const Picture out = drawn(script, options);
  const LinearPicture light = drawn_light(script, options);
  int blue = 0;
  for (int y = 20; y < 70; ++y)
    for (int x = 55; x < 105; ++x) {
      if (std::hypot(x - 79.5, y - 44.5) > 26) continue;
      EXPECT_EQ(scenes::pixel(out, x, y), (scenes::Pixel{0, 0, 255, 255})) << x << ' ' << y;
      const float* const at = &light.rgba[4 * static_cast<std::size_t>(160 * y + x)];
      EXPECT_LT(at[1], 1e-3F) << x << ' ' << y;
      EXPECT_NEAR(at[2], 1, 1e-3) << x << ' ' << y;
      ++blue;
    }
  EXPECT_GT(blue, 1500);
}

// What lies exactly over another object is drawn as it is over any other: a share of its edges shows what is below.
TEST(Flat, WhatCoversAnotherIsNotBesideIt) {
  const auto edge = [](const std::string& below) {
    return drawn("film flat\nbackground #00ff00\n" + below + "create b rectangle size=(4.05 3.03) color=#0000ff\n",
                 {160, 90, 4, "shaded"});
  };
  const Picture both = edge("create a rectangle size=(4.05 3.03) color=#ff0000\n"), one = edge("");
  int partly = 0;
  for (int x = 0; x < 160; ++x) {
    const double share = scenes::decoded(scenes::pixel(one, x, 45).b / 255.0);
    if (share < 0.05 || share > 0.95) continue;
    ++partly;
    EXPECT_NEAR(scenes::decoded(scenes::pixel(both, x, 45).g / 255.0), (1 - share) * (1 - share), 0.02) << x;
    EXPECT_NEAR(scenes::decoded(scenes::pixel(both, x, 45).b / 255.0), share, 0.02) << x;
  }
  EXPECT_EQ(partly, 2);
}

TEST(Flat, LayersBlendInLinearLight) {
  const Picture out = drawn(
      "film flat\nbackground #204060\ncreate a rectangle size=(2 2) color=#808080 transparency=0.25\n"
      "create b rectangle size=(2 2) position=(0 0 0.1) color=#ff8000 transparency=0.6\n",
      {64, 36, 4, "shaded"});
  const auto blended = [](int below, int a, int b) {
    const auto light = [](int byte) { return scenes::decoded(byte / 255.0); };
    return scenes::encoded_byte(0.4 * light(b) + 0.6 * (0.75 * light(a) + 0.25 * light(below)));
  };
  const scenes::Pixel at = scenes::pixel(out, 32, 18);
  EXPECT_NEAR(at.r, blended(0x20, 0x80, 0xff), 1);
  EXPECT_NEAR(at.g, blended(0x40, 0x80, 0x80), 1);
  EXPECT_NEAR(at.b, blended(0x60, 0x80, 0x00), 1);
}

TEST(Flat, PicturesWhilePlayingAreThoseOfTheFrames) {
  std::mt19937 random(5);
  const Program p = program_of(drawing(random, true)), solid = program_of("create s sphere\n");
  const auto playing = scenes::renderer({80, 45, 4, "shaded"}), single = scenes::renderer({80, 45, 4, "shaded"});
  Evaluation e(p);
  Picture played, alone;
  for (int k = 0; k < 30; ++k) {
    if (k % 7 == 3) e.use(solid);  // drawn by the graphics interface
    if (k % 7 == 4) e.use(p);
    e.to(Rate{24, 1}.frame(static_cast<int>(random() % 30)));
    ASSERT_TRUE(playing->render(e, played));
    ASSERT_TRUE(single->render(Frame{}, alone));
    ASSERT_TRUE(single->render(e.frame(), alone));
    EXPECT_EQ(played.rgba, alone.rgba) << k;
  }
}

// Only what changes is drawn again: in place, colour, depth, size or visibility, above and below what rests.
TEST(Flat, PicturesOfFewChangesAreThoseOfNewPainters) {
  std::mt19937 random(9);
  const auto any = [&](double from, double to) { return std::uniform_real_distribution(from, to)(random); };
  for (int film = 0; film < 30; ++film) {
    std::string script = film % 3 == 0 ? "film flat\nbackground #102030 to #405060\n" : "film flat\n";
    for (int k = 0; k < 12; ++k)
      script +=
          fmt::format("create s{} {} color=#{:06x} transparency={} position=({:.2f} {:.2f} {})\n", k,
                      k % 3 == 0   ? "star"
                      : k % 3 == 1 ? "rectangle"
                                   : "circle",
                      random() & 0xffffff, k % 4 == 0 ? 0.5 : 0.0, any(-9, 9), any(-5, 5), k % 5 == 0 ? 0.1 : 0.0);
    for (int k = 0; k < 3; ++k) {
      const char* const tracks[] = {"position.x", "position.z", "transparency", "scale.y", "scale.x", "position.y"};
      script += fmt::format("s{}.{}\n  1f {:.2f} linear\n  12f {:.2f}\n", random() % 12, tracks[random() % 6],
                            any(0, 1), any(0, 1));
    }
    script += fmt::format("at 5f hide s{0}\nat 9f show s{0}\n", random() % 12);
    const Program p = program_of(script);
    FlatPainter playing(80, 45);
    Picture played, alone;
    for (int k = 0; k < 25; ++k) {
      const Frame frame = p.frame(Rate{24, 1}.frame(static_cast<int>(1 + random() % 12)));
      ASSERT_TRUE(playing.draw(FrameColumns(frame).columns(), played)) << script;
      ASSERT_TRUE(FlatPainter(80, 45).draw(FrameColumns(frame).columns(), alone));
      const auto differs = std::mismatch(played.rgba.begin(), played.rgba.end(), alone.rgba.begin()).first;
      const auto at = (differs - played.rgba.begin()) / 4;
      ASSERT_TRUE(differs == played.rgba.end())
          << script << "differs at " << at % 80 << ", " << at / 80 << " in picture " << k;
    }
  }
}

// Two small discs that cut each other leave a picture to the graphics interface. It keeps the order of making, too.
TEST(Flat, TheGraphicsInterfaceKeepsTheOrder) {
  const std::string script =
      "film flat\ncreate back rectangle size=(9 6) color=#204060\ncreate glow circle radius=3 color=#ffb060 "
      "transparency=0.5\ncreate sun circle radius=1 color=#ffe080\ncreate veil rectangle size=(9 1) position=(0 0.5) "
      "color=#800000 transparency=0.7\ncreate hill rectangle size=(1 1) position=(0.5 0.5) color=#302010\n";
  const std::string cut =
      "create a circle radius=0.05 position=(-6 -4)\ncreate b circle radius=0.05 position=(-6 -4) "
      "rotation=(60deg 0 0)\n";
  const Frame frame = program_of(script + cut).frame({});
  Picture out;
  ASSERT_FALSE(FlatPainter(160, 90).draw(FrameColumns(frame).columns(), out));
  const Picture flat = drawn(script, {160, 90, 4, "shaded"}), graphics = drawn(script + cut, {160, 90, 4, "shaded"});
  std::set<std::array<int, 3>> colors;
  for (const auto& [x, y] : {std::pair{80, 45}, {80, 38}, {84, 41}, {74, 41}, {62, 45}, {60, 41}, {40, 45}, {84, 44}}) {
    const scenes::Pixel is = scenes::pixel(graphics, x, y), expected = scenes::pixel(flat, x, y);
    EXPECT_NEAR(is.r, expected.r, 3) << x << ' ' << y;
    EXPECT_NEAR(is.g, expected.g, 3) << x << ' ' << y;
    EXPECT_NEAR(is.b, expected.b, 3) << x << ' ' << y;
    colors.insert({expected.r, expected.g, expected.b});
  }
  EXPECT_GE(colors.size(), 5U);  // the points lie on different layers
}

TEST(Flat, WhatIsNotFlatIsLeftToTheGraphics) {
  const auto flat = [](const std::string& script) {
    FlatPainter painter(64, 36);
    Picture out;
    const Frame frame = program_of(script).frame({});
    return painter.draw(FrameColumns(frame).columns(), out);
  };
  EXPECT_TRUE(flat("film flat\ncreate c circle\n"));
  EXPECT_TRUE(flat("film flat\n"));
  EXPECT_TRUE(flat("film flat\ncreate b box\n"));  // alone, whatever is in front of what
  EXPECT_TRUE(flat("film flat\ncreate c circle\ncreate d circle position=(0 0 1)\n"));
  EXPECT_FALSE(flat("create c circle\n"));
  EXPECT_FALSE(flat("film flat\nfog white from 5 to 90\ncreate c circle\n"));
  EXPECT_FALSE(flat("film flat\nground on\ncreate c circle\n"));
  EXPECT_FALSE(flat("film flat\ncreate c circle\ncreate d circle rotation=(60deg 0 0)\n"));  // they cut each other
  EXPECT_TRUE(flat("film flat\ncreate c circle\ncreate d circle rotation=(60deg 0 0) position=(9 0 0)\n"));
}

// A line is as flat as everything else: what is a little in front of it hides it, and what is made later at its depth.
TEST(Flat, LinesAreFlat) {
  for (const int samples : {1, 4}) {
    const auto middle = [&](const std::string& circle) {
      const scenes::Pixel at = scenes::pixel(drawn("film flat\n" + circle, {64, 36, samples, "shaded"}), 32, 18);
      return at.r > 200 ? "line" : at.b > 200 ? "circle" : "nothing";
    };
    const std::string line = "create l line to=(4 0 0) position=(-2 0 0) width=0.5 color=red\n";
    EXPECT_STREQ(middle(line + "create c circle color=blue\n"), "circle");
    EXPECT_STREQ(middle("create c circle color=blue\n" + line), "line");
    EXPECT_STREQ(middle(line + "create c circle color=blue position=(0 0 0.01)\n"), "circle");
    EXPECT_STREQ(middle(line + "create c circle color=blue position=(0 0 -0.01)\n"), "line");
  }
}

}  // namespace
}  // namespace betwixt
