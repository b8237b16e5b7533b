// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Gradients in pictures against closed forms: by distance along a line, by distance from a point, by angle; the same in
// flat films, lit ones and traced ones.
#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "betwixt/language.h"
#include "betwixt/program.h"
#include "render/scenes.h"
#include "render/traced.h"

namespace betwixt::gradient_test {
namespace {

Program film_of(const std::string& script) {
  const Loaded loaded = load_text("film flat\n" + script, "film.bx");
  EXPECT_TRUE(loaded.diagnostics.empty())
      << (loaded.diagnostics.empty() ? "" : to_string(loaded.diagnostics[0])) << script;
  return Program::compile(loaded.document);
}

constexpr int width = 160, height = 90;  // ten pixels are a metre

Picture drawn(const std::string& script, std::string_view style = "shaded", Time t = {}) {
  return scenes::draw(film_of(script).frame(t), {width, height, 16, std::string(style)});
}
// Drawn by the graphics interface: fog that is far away.
Picture by_shader(const std::string& script, Time t = {}) {
  return drawn(script + "fog black from 1000 to 2000\n", "shaded", t);
}

using Light = std::array<double, 3>;
Light light_of(int rgb) {
  return {scenes::decoded((rgb >> 16) / 255.0), scenes::decoded((rgb >> 8 & 255) / 255.0),
          scenes::decoded((rgb & 255) / 255.0)};
}
Light mixed(const Light& a, const Light& b, double s) {
  s = std::clamp(s, 0.0, 1.0);
  return {(1 - s) * a[0] + s * b[0], (1 - s) * a[1] + s * b[1], (1 - s) * a[2] + s * b[2]};
}

// Compares the pixels at which `there` with their light; both get metres from the middle of the picture.
void expect_light(const Picture& got, const std::function<bool(double, double)>& there,
                  const std::function<Light(double, double)>& wanted, int most, const char* what) {
  int seen = 0;
  for (int j = 0; j < height; ++j)
    for (int i = 0; i < width; ++i) {
      const double x = (i + 0.5 - width / 2.0) / 10, y = (height / 2.0 - j - 0.5) / 10;
      if (!there(x, y)) continue;
      ++seen;
      const scenes::Pixel p = scenes::pixel(got, i, j);
      const Light l = wanted(x, y);
      const int off = std::max({std::abs(p.r - scenes::encoded_byte(l[0])), std::abs(p.g - scenes::encoded_byte(l[1])),
                                std::abs(p.b - scenes::encoded_byte(l[2]))});
      ASSERT_LE(off, most) << what << ' ' << x << ' ' << y;
    }
  EXPECT_GT(seen, 100) << what;
}
// The same in each way of drawing.
void expect_everywhere(const std::string& script, const std::function<bool(double, double)>& there,
                       const std::function<Light(double, double)>& wanted) {
  expect_light(drawn(script), there, wanted, 1, "flat");
  expect_light(by_shader(script), there, wanted, 2, "shaded");
  expect_light(drawn(script, "traced"), there, wanted, 3, "traced");
}

// A rectangle of 8 by 4 metres about (1 0.5), a little inside.
bool on_card(double x, double y) { return std::abs(x - 1) < 3.85 && std::abs(y - 0.5) < 1.85; }
constexpr const char* card = "create card rectangle size=(8 4) position=(1 0.5) color=#ff6600 gradient-color=#1b0060 ";
const Light orange = light_of(0xff6600), violet = light_of(0x1b0060);

TEST(Gradient, LinearOnesGoFromTheCornerFarthestBackToTheOneFarthestAhead) {
  for (const int degrees : {0, 30, 90, 145, 250}) {
    const double dx = std::cos(degrees * pi / 180), dy = std::sin(degrees * pi / 180);
    double low = 1e9, high = -1e9;
    for (const double x : {-3.0, 5.0})
      for (const double y : {-1.5, 2.5}) low = std::min(low, x * dx + y * dy), high = std::max(high, x * dx + y * dy);
    expect_everywhere(
        fmt::format("{} gradient=linear gradient-turn={}deg\n", card, degrees), on_card,
        [&](double x, double y) { return mixed(orange, violet, (x * dx + y * dy - low) / (high - low)); });
  }
}

TEST(Gradient, RadialOnesTouchTheSides) {
  // Away from where it ends, and from its middle: a pixel there is the mean of what goes over unevenly.
  const auto away_from = [](auto place) {
    return [=](double x, double y) {
      const double t = place(x, y);
      return on_card(x, y) && t > 0.1 && std::abs(t - 1) > 0.06;
    };
  };
  const auto whole = [](double x, double y) { return std::hypot((x - 1) / 4, (y - 0.5) / 2); };
  expect_everywhere(fmt::format("{} gradient=radial\n", card), away_from(whole),
                    [&](double x, double y) { return mixed(orange, violet, whole(x, y)); });
  const auto circle = [](double x, double y) { return std::hypot(x - 1, y - 0.5) / 4; };
  expect_everywhere(fmt::format("{} gradient=circular\n", card), away_from(circle),
                    [&](double x, double y) { return mixed(orange, violet, circle(x, y)); });
  // A quarter of the width to the left, an eighth of the height up; half as large.
  const auto moved = [](double x, double y) { return std::hypot((x + 1) / 2, y - 1); };
  expect_everywhere(fmt::format("{} gradient=radial gradient-move=(-0.25 0.125) gradient-size=0.5\n", card),
                    away_from(moved), [&](double x, double y) { return mixed(orange, violet, moved(x, y)); });
}

TEST(Gradient, ConicOnesGoRoundByAngle) {
  const auto seam = [](double x, double y) {
    const double across = -std::sin(2.0) * (x - 1) + std::cos(2.0) * (y - 0.5);
    return on_card(x, y) && std::hypot(x - 1, y - 0.5) > 1 &&
           (std::abs(across) > 0.2 || std::cos(2.0) * (x - 1) + std::sin(2.0) * (y - 0.5) < 0);
  };
  const auto turn = [](double x, double y) {
    const double a = (std::atan2(y - 0.5, x - 1) - 2.0) / (2 * pi);
    return a - std::floor(a);
  };
  expect_everywhere(fmt::format("{} gradient=conic gradient-turn=2rad\n", card), seam,
                    [&](double x, double y) { return mixed(orange, violet, turn(x, y)); });
  // Half a turn, and back.
  expect_everywhere(
      fmt::format("{} gradient=conic gradient-turn=2rad gradient-size=0.5 gradient-spread=reflect\n", card),
      [&](double x, double y) { return seam(x, y) && std::abs(turn(x, y) - 0.5) > 0.05; },
      [&](double x, double y) { return mixed(orange, violet, 1 - std::abs(1 - 2 * turn(x, y))); });
}

TEST(Gradient, RepeatsAndManyStops) {
  const Light stops[] = {light_of(0xffffff), light_of(0x008000), light_of(0x000080)};
  // A third of the width, three times; the second stop is at a quarter.
  const auto away = [](double x, double y) {
    const double part = (x + 3) / (8.0 / 3);
    return on_card(x, y) && std::abs(part - std::round(part)) > 0.06 && std::abs(part - std::floor(part) - 0.25) > 0.06;
  };
  expect_everywhere(fmt::format("{} gradient=linear gradient-size=1/3 gradient-spread=repeat "
                                "gradient-stops=\"#fff, green 25%, navy\"\n",
                                card),
                    away, [&](double x, double) {
                      const double part = (x + 3) / (8.0 / 3), t = part - std::floor(part);
                      return t < 0.25 ? mixed(stops[0], stops[1], t / 0.25)
                                      : mixed(stops[1], stops[2], (t - 0.25) / 0.75);
                    });
}

TEST(Gradient, FadesWithoutADarkEdge) {
  // Orange goes to nothing before white: its share of the light is its opacity, the rest is white.
  const std::string script =
      fmt::format("background white\n{} gradient=linear gradient-stops=\"first, transparent\"\n", card);
  expect_everywhere(script, on_card, [](double x, double) { return mixed(orange, light_of(0xffffff), (x + 3) / 8); });
  expect_everywhere(fmt::format("background white\n{} transparency=0.5 gradient=linear "
                                "gradient-stops=\"first, second/40%\"\n",
                                card),
                    on_card, [](double x, double) {
                      const double t = (x + 3) / 8, opacity = 0.5 * ((1 - t) + 0.4 * t);
                      Light l{};
                      for (std::size_t k = 0; k < 3; ++k)
                        l[k] = 0.5 * ((1 - t) * orange[k] + 0.4 * t * violet[k]) + (1 - opacity);
                      return l;
                    });
}

TEST(Gradient, GoesAlongWithTheObject) {
  // Turned by a right angle, and twice as high as wide is half as high.
  const std::string script =
      "create g group rotation=(0deg 0deg 90deg)\ncreate g/card rectangle size=(4 8) scale=(1 0.5 1) color=#ff6600 "
      "gradient-color=#1b0060 gradient=linear\n";
  expect_everywhere(
      script, [](double x, double y) { return std::abs(x) < 1.85 && std::abs(y) < 1.85; },
      [](double, double y) { return mixed(orange, violet, (y + 2) / 4); });
}

TEST(Gradient, EdgesBetweenColoursAreExactInFlatFilms) {
  // The edge is in the middle of a pixel's 37 hundredths: 3 m to the left and 3.437 to the right of it.
  const double at = (3 + 0.437) / 8;
  const std::string script = fmt::format(
      "{} gradient=linear gradient-stops=\"red 0%, red {:.6f}%, blue {:.6f}%, blue 100%\"\n", card, 100 * at, 100 * at);
  const Picture flat = drawn(script), shaded = by_shader(script);
  for (const auto& [p, most] : {std::pair(&flat, 1), std::pair(&shaded, 6)}) {
    EXPECT_EQ(scenes::pixel(*p, 83, 40), (scenes::Pixel{255, 0, 0, 255}));
    EXPECT_EQ(scenes::pixel(*p, 85, 40), (scenes::Pixel{0, 0, 255, 255}));
    EXPECT_NEAR(scenes::pixel(*p, 84, 40).r, scenes::encoded_byte(0.37), most);
    EXPECT_NEAR(scenes::pixel(*p, 84, 40).b, scenes::encoded_byte(0.63), most);
  }
}

TEST(Gradient, StrokesHaveTheirOwn) {
  const std::string script =
      "create card rectangle size=(8 4) color=#00ff00 stroke-width=0.8 stroke=#ff6600 stroke-gradient=linear "
      "stroke-gradient-color=#1b0060\n";
  const auto on_stroke = [](double x, double y) {
    return std::abs(x) < 4.3 && std::abs(y) < 2.3 && (std::abs(x) > 3.7 || std::abs(y) > 1.7);
  };
  expect_everywhere(script, on_stroke, [](double x, double) { return mixed(orange, violet, (x + 4) / 8); });
  expect_everywhere(
      script, [](double x, double y) { return std::abs(x) < 3.5 && std::abs(y) < 1.5; },
      [](double, double) { return light_of(0x00ff00); });
  // Without a colour of its own, a stroke has that of the object, and its gradient is enough to draw it.
  expect_everywhere(
      "create card rectangle size=(8 4) color=#ff6600 fill=off stroke-width=0.8 gradient=linear "
      "gradient-color=#1b0060\n",
      on_stroke, [](double x, double) { return mixed(orange, violet, (x + 4) / 8); });
  expect_everywhere(
      "create card rectangle size=(8 4) color=#ff6600 stroke-width=0.8 stroke-gradient=linear "
      "stroke-gradient-color=#1b0060\n",
      on_stroke, [](double x, double) { return mixed(orange, violet, (x + 4) / 8); });
}

TEST(Gradient, LinesAndWhatIsDrawnOfThemDoNotMoveIt) {
  const std::string line =
      "create l line position=(-4 0) to=(8 0 0) width=1 color=#ff6600 gradient-color=#1b0060 gradient=linear ";
  const auto on_line = [](double x, double y) { return std::abs(y) < 0.35 && x > -3.8 && x < -0.2; };
  const Picture whole = drawn(line + "\n"), half = drawn(line + "trim=(0 0.5)\n");
  expect_light(
      whole, on_line, [](double x, double) { return mixed(orange, violet, (x + 4.5) / 9); }, 8, "line");
  for (int i = 45; i < 78; ++i) EXPECT_EQ(scenes::pixel(whole, i, 45), scenes::pixel(half, i, 45)) << i;
  EXPECT_EQ(scenes::pixel(half, 110, 45), scenes::pixel(half, 5, 5));
  // Letters keep their colours while a text is typed.
  const std::string text = "create t text text=\"HHHH\" size=4 align=left position=(-7 -1) gradient=linear ";
  const Picture all = drawn(text + "\n"), one = drawn(text + "typed=1\n");
  int same = 0;
  for (int i = 12; i < 40; ++i)
    if (scenes::pixel(one, i, 50).r > 40) same += scenes::pixel(one, i, 50) == scenes::pixel(all, i, 50) ? 1 : -100;
  EXPECT_GT(same, 3);
}

TEST(Gradient, MovesWithItsTracks) {
  const Program film = film_of(
      "rate 24\ncreate card rectangle gradient=linear gradient-color=black\n"
      "card.color\n  1f white linear\n  25f black\ncard.gradient-color\n  1f black linear\n  25f white\n"
      "card.gradient-turn\n  1f 0deg linear\n  25f 90deg\ncard.gradient\n  1f linear\n  19f radial\n  22f none\n");
  const Rate rate{24, 1};
  const auto fill = [&](int n) { return film.frame(rate.frame(n)).items.at(0).gradients; };
  const auto at = fill(7);
  ASSERT_TRUE(at);
  EXPECT_EQ(at->fill.kind, GradientKind::linear);
  EXPECT_NEAR(at->fill.turn, pi / 8, 1e-9);
  EXPECT_NEAR(at->fill.stops.at(0).color.x, 0.75, 1e-9);  // a quarter of the way, in light
  EXPECT_NEAR(at->fill.stops.at(1).color.x, 0.25, 1e-9);
  EXPECT_EQ(fill(20)->fill.kind, GradientKind::radial);
  EXPECT_EQ(fill(23), nullptr);
  Evaluation e(film);
  e.to(rate.frame(3)), e.to(rate.frame(4));
  EXPECT_EQ(e.changed().size(), 1U);
  e.to(rate.frame(40)), e.to(rate.frame(41));
  EXPECT_EQ(e.changed().size(), 0U);
}

TEST(Gradient, PicturesWhilePlayingAreThoseOfTheFrames) {
  const std::string script =
      "rate 24\ncreate a circle radius=2 gradient=conic stroke=red stroke-gradient=linear position=(-3 0)\n"
      "create b circle radius=2 gradient=radial gradient-stops=\"first, second, transparent\" position=(1 0)\n"
      "create c circle radius=2 gradient=linear position=(4 0)\ncreate d circle radius=2 gradient=linear position=(4 "
      "3)\n"
      "a.gradient-turn\n  1f 0deg linear\n  25f 90deg\nb.gradient-color\n  1f red linear\n  25f lime\n"
      "c.radius\n  1f 2 linear\n  25f 3\n";
  for (const char* more : {"", "fog black from 1000 to 2000\n"}) {
    const Program p = film_of(script + more), other = film_of("create s circle gradient=linear\n");
    const auto playing = scenes::renderer({80, 45, 4, "shaded"}), single = scenes::renderer({80, 45, 4, "shaded"});
    Evaluation e(p);
    Picture played, alone;
    for (int k = 0; k < 12; ++k) {
      if (k % 7 == 3) e.use(other);
      if (k % 7 == 4) e.use(p);
      e.to(Rate{24, 1}.frame(1 + 7 * k % 25));
      ASSERT_TRUE(playing->render(e, played));
      ASSERT_TRUE(single->render(Frame{}, alone));
      ASSERT_TRUE(single->render(e.frame(), alone));
      EXPECT_EQ(played.rgba, alone.rgba) << k << more;
    }
  }
}

TEST(Gradient, AnyNumberOfThreadsMakesTheSamePicture) {
  const Frame frame = film_of(
                          "create a circle radius=3 gradient=conic gradient-stops=\"red, gold/50%, lime, red\"\n"
                          "create b rectangle size=(9 1) gradient=radial stroke-gradient=linear\n")
                          .frame({});
  Picture one;
  for (const unsigned threads : {1U, 2U, 7U}) {
    const auto r = make_traced({64, 36, 4, "traced"}, threads);
    ASSERT_TRUE(r);
    Picture p;
    ASSERT_TRUE((*r)->render(frame, p));
    if (threads == 1) one = p;
    EXPECT_EQ(p.rgba, one.rgba) << threads;
  }
}

// Lit surfaces of both kinds have it: a ball whose upper half is red and whose lower half is blue.
TEST(Gradient, BallsAndFinishesHaveIt) {
  for (const std::string more : {"", "set ball.roughness 0.4\n"})
    for (const std::string_view style : {"shaded", "traced"}) {
      const Loaded loaded = load_text(
          "create ball sphere radius=2 gradient=linear gradient-turn=90deg gradient-stops=\"blue 49%, red 51%\"\n"
          "create eye camera height=9 position=(0 0 20)\n" +
              more,
          "film.bx");
      ASSERT_FALSE(has_errors(loaded.diagnostics));
      const Picture p =
          scenes::draw(Program::compile(loaded.document).frame({}), {width, height, 4, std::string(style)});
      const scenes::Pixel up = scenes::pixel(p, 80, 35), down = scenes::pixel(p, 80, 55);
      EXPECT_GT(up.r, 2 * up.b) << style << more;
      EXPECT_GT(down.b, 2 * down.r) << style << more;
    }
}

}  // namespace
}  // namespace betwixt::gradient_test
