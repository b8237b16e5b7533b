// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests SVG with closed forms, and hostile files. tests/app/svg_test.sh compares pictures with those of rsvg-convert.
#include <gtest/gtest.h>
#include <sys/mman.h>

#include <array>
#include <cmath>
#include <random>

#include "base/files.h"
#include "betwixt/gradient.h"
#include "exchange/drawing.h"
#include "exchange/files.h"
#include "exchange/outlines.h"
#include "exchange/svg_path.h"
#include "exchange/svg_style.h"
#include "exchange/wire_format.h"

namespace betwixt {
namespace {

// 100 by 100, so that a user unit is a centimetre.
std::string svg(const std::string& inside) {
  return "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 100 100'>" + inside + "</svg>";
}
DrawingFile drawing(const std::string& inside) {
  const auto read = read_svg(svg(inside), "x.svg");
  EXPECT_TRUE(read) << (read ? "" : read.error().message);
  return read ? **read : DrawingFile{};
}
DrawnThing only(const std::string& inside) {
  const DrawingFile d = drawing(inside);
  EXPECT_EQ(d.things.size(), 1U) << inside;
  return d.things.empty() ? DrawnThing{} : d.things[0];
}
std::string refusal(const std::string& text) {
  const auto read = read_svg(text, "x.svg");
  EXPECT_FALSE(read) << text.substr(0, 200);
  return read ? "" : read.error().message + (read.error().hint.empty() ? "" : "; " + read.error().hint);
}
std::string names(const DrawingFile& d) {
  std::string all;
  for (const DrawnThing& t : d.things)
    all += t.name + (t.group ? ":" : "") + (t.above == DrawnThing::nothing ? "" : "<" + d.things[t.above].name) + " ";
  return all;
}
double area(const Contour& c) { return turn(c, {0, 0, 1}) / 2; }
void expect_at(Vec3 got, double x, double y) {
  EXPECT_NEAR(got.x, x, 1e-9);
  EXPECT_NEAR(got.y, y, 1e-9);
}

TEST(Svg, AMetreHighAboutItsMiddle) {
  const DrawnThing t = only("<rect x='60' y='10' width='20' height='10' fill='#ff8000'/>");
  expect_at(t.at, 0.2, 0.35);  // its own middle: (70, 15)
  ASSERT_EQ(t.points.size(), 4U);
  expect_at(t.points[0], -0.1, 0.05);
  EXPECT_EQ(t.color, (Color{1, 128 / 255.0, 0}));
  EXPECT_EQ(t.name, "rect");
  const auto wide = read_svg("<svg width='4cm' height='2cm'><rect width='100%' height='50%'/></svg>", "x.svg");
  ASSERT_TRUE(wide);
  EXPECT_NEAR((*wide)->width, 2, 1e-12);
  expect_at((*wide)->things[0].at, 0, 0.25);
  EXPECT_NEAR(std::abs(area((*wide)->things[0].points)), 2 * 0.5, 1e-12);
}

TEST(Svg, ShapesHaveTheAreasOfTheirFormulas) {
  const auto size = [](const std::string& shape) { return std::abs(area(only(shape).points)) * 1e4; };
  EXPECT_NEAR(size("<circle cx='50' cy='50' r='30'/>"), pi * 900, 2);
  EXPECT_NEAR(size("<ellipse cx='50' cy='50' rx='30' ry='10' transform='rotate(33)'/>"), pi * 300, 1.5);
  EXPECT_NEAR(size("<rect width='40' height='30' rx='5'/>"), 1200 - (4 - pi) * 25, 0.3);
  EXPECT_NEAR(size("<rect width='40' height='30' rx='99' ry='5'/>"), 1200 - (4 - pi) * 20 * 5, 0.5);
  EXPECT_NEAR(size("<path d='M0 0 A20 20 0 0 1 40 0 Z'/>"), pi * 200, 0.5);
  EXPECT_NEAR(size("<path d='M0,0a20,20,0,0140,0z'/>"), pi * 200, 0.5) << "flags need nothing between them";
  EXPECT_NEAR(size("<path d='M0 0 A1 1 0 1 0 40 0 Z'/>"), pi * 200, 0.5) << "radii that are too small grow";
  EXPECT_NEAR(size("<path d='M20 0 A20 20 0 1 1 0 20 L20 20 Z'/>"), pi * 300, 0.6) << "three quarters";
  EXPECT_NEAR(size("<path d='M0 0 Q 20 40 40 0 z'/>"), 2.0 / 3 * 40 * 20, 0.7) << "Archimedes";
  EXPECT_NEAR(size("<path d='M0 0 q 20 40 40 0 t 40 0 v 30 H 0'/>"), 80 * 30, 0.7) << "a bow up is one down";
  EXPECT_NEAR(size("<path d='M0 0 C0 40 40 40 40 0z'/>"), 40 * 40 * 0.6, 0.7);
  EXPECT_NEAR(size("<rect width='10' height='10' transform='skewX(40) scale(2,3)'/>"), 600, 1e-6);
  EXPECT_NEAR(size("<g transform='matrix(1 1 0 2 0 0), rotate(20 3,4)'><rect width='10' height='10'/></g>"), 200, 1e-6);
}

// A ring of any rule has one hole; two squares that touch nowhere are two things.
TEST(Svg, HolesAreRight) {
  const std::string twice = "M0 0h60v60h-60z ", inner = "M20 20h20v20h-20z", other = "M20 20v20h20v-20z";
  for (const auto& [d, rule, holes] :
       std::vector<std::tuple<std::string, std::string, int>>{{twice + inner, "evenodd", 1},
                                                              {twice + inner, "nonzero", 0},
                                                              {twice + other, "evenodd", 1},
                                                              {twice + other, "nonzero", 1}}) {
    const DrawnThing t = only("<path fill-rule='" + rule + "' d='" + d + "'/>");
    EXPECT_EQ(t.holes.size(), holes ? 5U : 0U) << rule << ' ' << d;
    if (holes) {
      EXPECT_NEAR(area({t.holes.begin(), t.holes.end() - 1}), -0.04, 1e-12);
    }
  }
  const DrawingFile apart = drawing("<path id='two' d='M0 0h9v9z M50 50h9v9z'/>");
  EXPECT_EQ(names(apart), "two: two/part-1<two two/part-2<two ");
  const DrawnThing island = only("<path fill-rule='evenodd' d='M0 0h90v90h-90z M10 10h70v70h-70z' stroke='red'/>");
  EXPECT_TRUE(island.strokes) << "where nothing crosses, what is filled and stroked is one";
}

TEST(Svg, IdsBecomeNames) {
  EXPECT_EQ(
      names(drawing("<g id='body'><circle id='left eye' r='1'/><g><circle r='1'/></g></g><path id='7' d='M0 0h1v1'/>"
                    "<circle r='2'/><g id='empty'/>")),
      "body: left-eye<body circle<body path-7 circle-2 ");
  EXPECT_EQ(
      names(drawing("<defs><g id='w'><circle id='hub' r='1'/></g></defs><use id='front' href='#w'/><use href='#w'/>")),
      "front: w:<front hub<w w-2: hub-2<w-2 ");
  EXPECT_EQ(names(drawing("<rect id='-' width='1' height='1'/><rect id='-' width='1' height='1'/>"
                          "<rect id='rect-2' width='1' height='1'/><rect id='été' width='1' height='1'/>")),
            "rect rect-2 rect-2-2 t ");
}

TEST(Svg, LaterThingsAreInFront) {
  const DrawingFile d =
      drawing("<rect width='9' height='9'/><g id='g'><rect width='9' height='9'/></g><circle r='1'/>");
  double before = -1;
  for (const DrawnThing& t : d.things) {
    if (t.group) continue;
    const double z = t.at.z + (t.above == DrawnThing::nothing ? 0 : d.things[t.above].at.z);
    EXPECT_GT(z, before);
    before = z;
  }
  EXPECT_LE(before, 0.1);
}

TEST(Svg, WhatIsSaidLastAndNearestCounts) {
  const auto color = [](const std::string& inside) { return only(inside).color; };
  const Color red{1, 0, 0}, lime{0, 1, 0}, blue{0, 0, 1};
  EXPECT_EQ(color("<g fill='blue'><circle r='1'/></g>"), blue);
  EXPECT_EQ(color("<style>circle { fill: lime }</style><g fill='blue'><circle r='1' fill='red'/></g>"), lime);
  EXPECT_EQ(color("<style>.a.b{fill:red} #x{fill:blue} circle,.a{fill:lime}</style><circle id='x' class='b a' r='1'/>"),
            blue);
  EXPECT_EQ(color("<style><![CDATA[/* no */ .a{fill:lime !important}]]></style><circle class='a' r='1'/>"), lime);
  EXPECT_EQ(color("<style>*{fill:lime}</style><circle style='fill : red;' r='1'/>"), red);
  EXPECT_EQ(color("<g color='lime'><circle fill='currentColor' r='1'/></g>"), lime);
  EXPECT_EQ(color("<circle fill='#0f0' r='1'/>"), lime);
  EXPECT_EQ(color("<circle fill='rgb(0 100% 0)' r='1'/>"), lime);
  EXPECT_EQ(color("<circle fill='hsl(240deg, 100%, 50%)' r='1'/>"), blue);
  EXPECT_EQ(color("<circle fill='url(#none) red' r='1'/>"), red);
  EXPECT_EQ(only("<circle r='1'/>").color, (Color{0, 0, 0}));
  const DrawnThing seen = only("<g opacity='.5'><circle fill='#ff000080' fill-opacity='50%' r='1'/></g>");
  EXPECT_NEAR(seen.transparency, 1 - 0.5 * 0.5 * 128 / 255, 1e-12);
}

TEST(Svg, StrokesAreLinesAlongThem) {
  const DrawnThing line = only("<line x1='10' y1='50' x2='90' y2='50' stroke='red' stroke-width='4'/>");
  EXPECT_FALSE(line.fills);
  EXPECT_EQ(line.color, (Color{1, 0, 0}));
  EXPECT_NEAR(line.stroke_width, 0.04, 1e-12);
  EXPECT_NEAR(line.trim_to, 0.5, 1e-12) << "there, and not back";
  const DrawnThing corner = only("<path d='M0 0h30v40' stroke='red' fill='none' stroke-linecap='round'/>");
  EXPECT_EQ(corner.points.size(), 4U) << "there and back";
  EXPECT_TRUE(corner.round);
  const DrawnThing square = only("<path d='M10 0h30' stroke='red' stroke-width='2' stroke-linecap='square'/>");
  EXPECT_NEAR(square.points[2].x - square.points[0].x, 0.32, 1e-12);
  const DrawnThing filled = only("<path d='M0 0h30v40' stroke='red'/>");
  EXPECT_TRUE(filled.fills && filled.strokes);
  EXPECT_NEAR(filled.trim_to, 70.0 / 120, 1e-12) << "its way back is filled, not stroked";
  EXPECT_EQ(names(drawing("<path id='p' fill='none' stroke='red' d='M0 0h9M0 9h9M0 20h9v9z'/>")),
            "p: p/part-1<p p/part-2<p ")
      << "what is open, and what is closed";
  const DrawnThing scaled = only("<g transform='scale(2 8)'><path d='M0 0h9v9z' stroke='red' stroke-width='1'/></g>");
  EXPECT_NEAR(scaled.stroke_width, 0.04, 1e-12) << "what the area grows by, on the average";
  const DrawnThing dashed = only("<path d='M0 0h9' stroke='red' stroke-dasharray='3,2'/>");
  EXPECT_NEAR(dashed.dash.x, 0.03, 1e-12);
  EXPECT_NEAR(dashed.dash.y, 0.02, 1e-12);
  EXPECT_EQ(names(drawing("<path id='p' d='M0 0h9v9z' stroke='red' stroke-opacity='.5'/>")),
            "p: p/part-1<p p/part-2<p ");
}

TEST(Svg, SaysWhatItLeavesOut) {
  const auto said = [](const std::string& inside) {
    std::string all;
    for (const std::string& s : drawing("<circle r='1'/>" + inside).left_out) all += s + "; ";
    return all;
  };
  EXPECT_EQ(said(""), "");
  EXPECT_EQ(said("<image id='photo'/>"), "<image> is left out (in 'photo'); ");
  EXPECT_EQ(said("<g clip-path='url(#c)' id='hat'/>"), "clip-path is left out (in 'hat'); ");
  EXPECT_EQ(said("<linearGradient id='g'><stop stop-color='red'/><stop offset='1' stop-color='blue'/></linearGradient>"
                 "<rect id='sky' width='1' height='1' fill='url(#g)'/>"),
            "");
  std::string many = "<linearGradient id='g'>";
  for (int i = 0; i < 17; ++i) many += "<stop stop-color='red'/>";
  EXPECT_EQ(said(many + "</linearGradient><rect id='sky' width='1' height='1' fill='url(#g)'/>"),
            "of gradients with more than 16 stops the middle colour is used (in 'sky'); ");
  EXPECT_EQ(said("<radialGradient id='g' fx='0.2'><stop stop-color='red'/><stop offset='1' stop-color='blue'/>"
                 "</radialGradient><rect id='sky' width='1' height='1' fill='url(#g)'/>"),
            "the focus of a radial gradient is in its middle (in 'sky'); ");
  EXPECT_EQ(said("<use href='#nothing'/>"), "a use of 'nothing', which does not exist, is left out; ");
  EXPECT_EQ(said("<path id='p' d='M0 0h9v9 oops'/>"), "a path with an error is drawn up to the error (in 'p'); ");
  EXPECT_NE(said("<style>g > path { fill: red }</style>").find("a style rule"), std::string::npos);
  const DrawnThing middle = only(
      "<linearGradient id='a'><stop stop-color='red'/><stop offset='100%' stop-color='blue'/></linearGradient>"
      "<linearGradient id='b' href='#a'/><circle r='1' fill='url(#b)'/>");
  EXPECT_EQ(middle.color, (Color{0.5, 0, 0.5}));
}

// Where a linear gradient begins and ends on the outline, as the guide says: through the middle of the box, moved, from
// the corner farthest back to the one farthest ahead.
std::array<Vec3, 2> ends_of(const DrawnThing& t, const DrawnGradient& g) {
  Box box;
  for (const Vec3 p : t.points) box.add(p);
  const double width = box.high.x - box.low.x, height = box.high.y - box.low.y;
  const Vec3 along{std::cos(g.turn), std::sin(g.turn), 0};
  const Vec3 middle = 0.5 * (box.low + box.high) + Vec3{g.move_x * width, g.move_y * height, 0};
  const double half = g.size * (width * std::abs(along.x) + height * std::abs(along.y)) / 2;
  return {middle - half * along + t.at, middle + half * along + t.at};
}

TEST(Svg, GradientsAreThoseOfTheShape) {
  const std::string stops = "<stop stop-color='#f00'/><stop offset='1' stop-color='#00f' stop-opacity='0.5'/>";
  // In user units, through a transform; the same by the box, from corner to corner of a square.
  const DrawnThing turned = only(
      "<linearGradient id='g' gradientUnits='userSpaceOnUse' x1='10' y1='20' x2='40' y2='60' spreadMethod='reflect'>" +
      stops + "</linearGradient><rect x='5' y='5' width='40' height='60' fill='url(#g)'/>");
  EXPECT_EQ(turned.gradient.kind, static_cast<std::uint32_t>(GradientKind::linear));
  EXPECT_EQ(turned.gradient.spread, static_cast<std::uint32_t>(GradientSpread::reflect));
  // What is at right angles to the gradient has one colour: only the places along it count.
  const auto along = [&](Vec3 p) { return dot(p, {0.6, -0.8, 0}); };
  const auto [from, to] = ends_of(turned, turned.gradient);
  EXPECT_NEAR(along(from), along({-0.4, 0.3, 0}), 1e-9);
  EXPECT_NEAR(along(to), along({-0.1, -0.1, 0}), 1e-9);
  EXPECT_NEAR(turned.gradient.turn, std::atan2(-0.8, 0.6), 1e-9);
  const DrawnThing corner = only("<linearGradient id='g' x2='1' y2='1'>" + stops +
                                 "</linearGradient><rect x='20' y='20' width='40' height='40' fill='url(#g)'/>");
  const auto [a, b] = ends_of(corner, corner.gradient);
  expect_at(a, -0.3, 0.3), expect_at(b, 0.1, -0.1);
  EXPECT_TRUE(corner.gradient.stops.starts_with("#ff0000 0%, ")) << corner.gradient.stops;
  EXPECT_TRUE(corner.gradient.stops.ends_with(", #0000ff80 100%")) << corner.gradient.stops;
  EXPECT_NE(corner.gradient.stops.find("#800080bf 50%"), std::string::npos) << corner.gradient.stops;
  // A line has no height. Along it, half of the gradient is where 30 (x - 10) + 40 (10 - 20) is 1250: at 65.
  const DrawnThing line =
      only("<linearGradient id='g' gradientUnits='userSpaceOnUse' x1='10' y1='20' x2='40' y2='60'>" + stops +
           "</linearGradient><path d='M10 10H50' fill='none' stroke='url(#g)'/>");
  EXPECT_NEAR(line.gradient.move_x, (65 - 30) / 40.0, 1e-9);
  EXPECT_EQ(line.gradient.move_y, 0);
  // A circle of user units, and an ellipse of the box; a stroke has its own.
  const DrawnThing ball = only("<radialGradient id='g' gradientUnits='userSpaceOnUse' cx='60' cy='40' r='10'>" + stops +
                               "</radialGradient><rect width='80' height='40' fill='url(#g)' stroke='url(#g)'/>");
  EXPECT_EQ(ball.gradient.kind, static_cast<std::uint32_t>(GradientKind::circular));
  EXPECT_NEAR(ball.gradient.size, 0.25, 1e-9);
  EXPECT_NEAR(ball.gradient.move_x, 0.25, 1e-9);
  EXPECT_NEAR(ball.gradient.move_y, -0.5, 1e-9);
  EXPECT_EQ(ball.stroke_gradient.stops, ball.gradient.stops);
  const DrawnThing egg = only("<radialGradient id='g' r='0.25'>" + stops +
                              "</radialGradient><rect width='80' height='40' fill='url(#g)'/>");
  EXPECT_EQ(egg.gradient.kind, static_cast<std::uint32_t>(GradientKind::radial));
  EXPECT_NEAR(egg.gradient.size, 0.5, 1e-9);
  // One without a direction, and one with a single colour.
  const DrawnThing none = only("<linearGradient id='g' x2='0'>" + stops +
                               "</linearGradient><rect width='8' height='4' "
                               "fill='url(#g)'/>");
  EXPECT_EQ(none.gradient.kind, 0U);
  EXPECT_TRUE(none.gradient.stops.empty());
  EXPECT_EQ(only("<linearGradient id='g'><stop stop-color='lime'/></linearGradient><rect width='8' height='4' "
                 "fill='url(#g)'/>")
                .color,
            (Color{0, 1, 0}));
}

TEST(Svg, RefusesWhatItCannotTake) {
  EXPECT_NE(refusal(svg("<g><text id='title'>Hello</text></g>")).find("the text 'title' may have another font"),
            std::string::npos);
  EXPECT_NE(refusal(svg("<text>Hello</text>")).find("turn texts into paths"), std::string::npos);
  EXPECT_EQ(drawing("<text display='none'>Hello</text><circle r='1'/>").things.size(), 1U)
      << "what is not drawn is none";
  EXPECT_NE(refusal("<html/>").find("begins with <html>"), std::string::npos);
  EXPECT_NE(refusal(svg("<circle r='1'/>").substr(0, 70)).find("line 1 is not XML"), std::string::npos);
  EXPECT_NE(refusal("").find("not XML"), std::string::npos);
  EXPECT_NE(refusal("\x1f\x8b\x08").find("gunzip"), std::string::npos);
  EXPECT_NE(refusal(svg("")).find("draws nothing"), std::string::npos);
  EXPECT_NE(refusal("<svg width='0' height='9'><circle r='1'/></svg>").find("size"), std::string::npos);
  EXPECT_NE(refusal(svg("<g id='a'><use href='#a'/></g>")).find("'a' uses itself"), std::string::npos);
  EXPECT_NE(refusal(svg("<g id='a'><use href='#b'/></g><g id='b'><use href='#a'/></g>")).find("uses itself"),
            std::string::npos);
  EXPECT_NE(refusal(svg("<rect width='9' height='9' transform='scale(1e6) scale(1e6)'/>")).find("x.svg"),
            std::string::npos);
  std::string deep;
  for (int i = 0; i < 100'000; ++i) deep += "<g>";
  EXPECT_FALSE(read_svg(svg(deep), "x.svg"));
  for (int i = 0; i < 100'000; ++i) deep += "</g>";
  EXPECT_NE(refusal(svg(deep)).find("deep"), std::string::npos);
}

// A billion of things in a few lines.
TEST(Svg, ThingsThatMultiplyEnd) {
  std::string laughs = "<defs><circle id='x0' r='1'/>";
  for (int i = 1; i < 12; ++i) {
    laughs += "<g id='x" + std::to_string(i) + "'>";
    for (int k = 0; k < 10; ++k) laughs += "<use href='#x" + std::to_string(i - 1) + "'/>";
    laughs += "</g>";
  }
  EXPECT_NE(refusal(svg(laughs + "</defs><use href='#x11'/>")).find("at most"), std::string::npos);
}

// Whatever is cut off or changed in a good file, what comes of it can be handed over, or is an error in words.
TEST(Svg, SurvivesDamage) {
  const std::string good = svg(
      "<style>.a{fill:#123}</style><defs><g id='f'><circle r='4'/></g></defs><g id='b' class='a' transform='rotate(9)'>"
      "<path d='M1 2c3 4 5 6 7 8S1 2 3 4a5 6 7 1 0 9 9z' stroke='red' stroke-dasharray='1 2'/><use href='#f' "
      "x='3'/></g>");
  std::mt19937 random(1);
  for (int i = 0; i < 2000; ++i) {
    std::string bad = good;
    if (i % 4 == 0) bad.resize(random() % bad.size());
    for (unsigned k = 0; k < i % 5U && !bad.empty(); ++k)
      bad[random() % bad.size()] = "<>/'=#.-e09AzM \0\xff"[random() % 16];
    const auto read = read_svg(bad, "x.svg");
    if (!read) {
      EXPECT_FALSE(read.error().message.empty());
      continue;
    }
    const OpenFile memory(::memfd_create("test", MFD_CLOEXEC));
    Parsed taken;
    EXPECT_EQ(write_parsed(*read, memory.fd()), 0);
    EXPECT_EQ(read_parsed(memory.fd(), taken), 0) << bad;
  }
}

TEST(Svg, ComesOverAsItWent) {
  const auto read =
      read_svg(svg("<g id='g'><path id='p' d='M0 0h60v60h-60z M20 20v20h20v-20z' stroke='red' opacity='.3'/>"
                   "<path d='M0 0h9' stroke='lime' stroke-dasharray='1 2' stroke-linecap='round'/></g>"
                   "<image/><linearGradient id='f' x1='.1' spreadMethod='repeat'><stop stop-color='red'/>"
                   "<stop offset='1'/></linearGradient><rect width='9' height='5' fill='url(#f)' stroke='url(#f)'/>"),
               "x.svg");
  ASSERT_TRUE(read);
  const OpenFile memory(::memfd_create("test", MFD_CLOEXEC));
  Parsed taken;
  ASSERT_EQ(write_parsed(*read, memory.fd()), 0);
  ASSERT_EQ(read_parsed(memory.fd(), taken), 0);
  const DrawingFile &a = **read, &b = *std::get<std::shared_ptr<const DrawingFile>>(taken);
  EXPECT_EQ(a.width, b.width);
  EXPECT_EQ(a.left_out, b.left_out);
  EXPECT_EQ(names(a), names(b));
  for (std::size_t i = 0; i < a.things.size(); ++i) {
    const DrawnThing &x = a.things[i], &y = b.things[i];
    EXPECT_TRUE(x.at == y.at && x.points == y.points && x.holes == y.holes && x.color == y.color &&
                x.stroke == y.stroke && x.dash == y.dash);
    EXPECT_TRUE(x.fills == y.fills && x.strokes == y.strokes && x.round == y.round && x.trim_to == y.trim_to &&
                x.stroke_width == y.stroke_width && x.transparency == y.transparency);
    EXPECT_TRUE(x.gradient == y.gradient && x.stroke_gradient == y.stroke_gradient);
  }
}

class SvgFiles : public Files {};
TEST_F(SvgFiles, AreReadInAProcessOfTheirOwn) {
  const std::string path = put("a.svg", svg("<circle r='1'/>"));
  const auto all = [](const std::string&) { return true; };
  const auto read = load_drawing(path, all);
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ((*read)->things[0].name, "circle");
  EXPECT_FALSE(load_drawing(path, [](const std::string&) { return false; }));
  EXPECT_FALSE(load_drawing(at("none.svg"), all));
  EXPECT_FALSE(load_drawing(put("b.svg", "nonsense"), all));
}

}  // namespace
}  // namespace betwixt
