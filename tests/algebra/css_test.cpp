// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "betwixt/css.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <random>
#include <set>
#include <sstream>

#include "algebra/precise.h"

namespace betwixt {
namespace {

Motion read(const std::string& list, Vec3 origin = {}) {
  const auto motion = from_css(list, origin);
  EXPECT_TRUE(motion) << list << ": " << (motion ? "" : motion.error().message);
  return motion ? *motion : Motion{};
}

Motion parsed(const std::string& text) {
  const auto motion = parse_motion(text);
  EXPECT_TRUE(motion) << text;
  return motion ? *motion : Motion{};
}

CssList listed(const std::string& list) {
  const auto functions = parse_css(list);
  EXPECT_TRUE(functions) << list << ": " << (functions ? "" : functions.error().message);
  return functions ? *functions : CssList{};
}

// Function by function, with nothing lost.
Mat4 between(const CssList& from, const CssList& to, double t) {
  const CssBetween now = css_between(from, to, t);
  EXPECT_EQ(now.mixed, 0u);
  EXPECT_EQ(now.short_way, 0u);
  EXPECT_FALSE(now.jumps);
  return now.matrix;
}

// About another origin than 0 0.
Mat4 about(Vec3 origin, const Mat4& m) { return translation(origin) * m * translation(-origin); }

void expect_near(const Mat4& a, const Mat4& b, double tolerance, const std::string& what) {
  for (int r = 0; r < 4; ++r)
    for (int c = 0; c < 4; ++c) EXPECT_NEAR(a(r, c), b(r, c), tolerance) << what << ", " << r << " " << c;
}

Mat4 rows(std::initializer_list<double> n) {
  Mat4 m;
  auto value = n.begin();
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 4; ++c) m(r, c) = *value++;
  return m;
}

// ---- Reading

TEST(CssRead, EveryFunctionIsOneFactor) {
  const auto linear = [](Vec3 by) { return scale_by(by, {}, Factor::Law::linear); };
  const std::pair<const char*, Factor> all[] = {
      {"translate(10px, 20px)", translate_by({10, 20, 0})},
      {"translate(10px)", translate_by({10, 0, 0})},
      {"translateX(-1.5px)", translate_by({-1.5, 0, 0})},
      {"translateY(.5px)", translate_by({0, 0.5, 0})},
      {"translateZ(+2e1px)", translate_by({0, 0, 20})},
      {"translate3d(1px, 0, -3px)", translate_by({1, 0, -3})},
      {"rotate(90deg)", rotate_by(pi / 2)},
      {"rotate(-100grad)", rotate_by(-pi / 2)},
      {"rotate(2.5rad)", rotate_by(2.5)},
      {"rotate(3turn)", rotate_by(6 * pi)},
      {"rotate(0)", rotate_by(0)},
      {"rotateX(1rad)", rotate_by(1, {}, {1, 0, 0})},
      {"rotateY(1rad)", rotate_by(1, {}, {0, 1, 0})},
      {"rotateZ(1rad)", rotate_by(1)},
      {"rotate3d(1, -2, .5, 1rad)", rotate_by(1, {}, {1, -2, 0.5})},
      {"scale(2)", linear({2, 2, 1})},
      {"scale(2, 0)", linear({2, 0, 1})},
      {"scaleX(-1)", linear({-1, 1, 1})},
      {"scaleY(2)", linear({1, 2, 1})},
      {"scaleZ(2)", linear({1, 1, 2})},
      {"scale3d(1, 2, 3)", linear({1, 2, 3})},
  };
  for (const auto& [list, factor] : all) EXPECT_EQ(read(list), Motion{{factor}}) << list;
}

TEST(CssRead, BlanksCommentsAndCapitalsAreThoseOfCss) {
  const Motion plain = read("translate(1px, 2px) rotate(90deg) scale(2)");
  ASSERT_EQ(plain.factors.size(), 3u);
  EXPECT_EQ(read("\n translate(  1px,2PX )ROTATE(90Deg)/* by half */\tsCale(2 /* and more */)/*"), plain);
  for (const char* nothing : {"", "none", " NONE ", "/**/none/**/", " \n\t"}) EXPECT_EQ(read(nothing), Motion{});
  EXPECT_EQ(read("translate(1e3px, 1E-3px)"), read("translate(1000px, 0.001px)"));
}

TEST(CssRead, TheOriginIsTheCentreOfWhatHasOne) {
  const Vec3 o{5, -6, 7};
  EXPECT_EQ(read("translateX(1px) rotate(1rad) scaleX(2)", o),
            (Motion{{translate_by({1, 0, 0}), rotate_by(1, o), scale_by({2, 1, 1}, o, Factor::Law::linear)}}));
}

TEST(CssRead, WhatCannotBeReadIsToldWithItsPlace) {
  struct Bad {
    std::string list;
    int column, length;
    ErrorCode code;
    const char* message;
    const char* hint;
  };
  const char* what = "supported: translate(), rotate() and scale(), also with X, Y, Z or 3d after the name";
  const char* px = "units are px in cm mm q pt pc, em rem and vw vh vmin vmax";
  const char* units = "units are deg, grad, rad, turn";
  const Bad all[] = {
      {"rotate(1turn) matrix(1, 0, 0, 1, 0, 0)", 15, 6, ErrorCode::type,
       "matrix() is not a translation, rotation or scaling", what},
      {"Matrix3D(1)", 1, 8, ErrorCode::type, "matrix3d() is not a translation, rotation or scaling", what},
      {"skew(1deg)", 1, 4, ErrorCode::type, "skew() is not a translation, rotation or scaling", what},
      {"skewx(1deg)", 1, 5, ErrorCode::type, "skewX() is not a translation, rotation or scaling", what},
      {"skewY(1deg)", 1, 5, ErrorCode::type, "skewY() is not a translation, rotation or scaling", what},
      {"perspective(1px)", 1, 11, ErrorCode::type, "perspective() is not a translation, rotation or scaling", what},
      {"spin(1deg)", 1, 4, ErrorCode::name, "'spin' is not a CSS transform", what},
      {"/* ä */ größe(2)", 9, 5, ErrorCode::name, "'größe' is not a CSS transform", what},
      {"none rotate(1deg)", 1, 4, ErrorCode::syntax, "'none' must be alone", ""},
      {"rotate(1deg) none", 14, 4, ErrorCode::syntax, "'none' must be alone", ""},
      {"rotate(1deg), scale(2)", 13, 1, ErrorCode::syntax, "expected a CSS transform here",
       "as in translate(10px, 20px) rotate(90deg)"},
      {"rotate(1deg);", 13, 1, ErrorCode::syntax, "expected a CSS transform here",
       "as in translate(10px, 20px) rotate(90deg)"},
      {"rotate (1deg)", 7, 1, ErrorCode::syntax, "'(' is missing directly after rotate", ""},
      {"rotate", 7, 1, ErrorCode::syntax, "'(' is missing directly after rotate", ""},
      {"rotate(1deg", 12, 1, ErrorCode::syntax, "')' is missing", ""},
      {"scale(2 3)", 9, 1, ErrorCode::syntax, "expected ',' or ')' here", ""},
      {"scale(,2)", 7, 1, ErrorCode::syntax, "expected a number here", ""},
      {"scale(2,)", 9, 1, ErrorCode::syntax, "expected a number here", ""},
      {"scale(two)", 7, 3, ErrorCode::syntax, "expected a number here", ""},
      {"scale(inf)", 7, 3, ErrorCode::syntax, "expected a number here", ""},
      {"scale(-)", 7, 1, ErrorCode::syntax, "expected a number here", ""},
      {"scale(+ 2)", 7, 1, ErrorCode::syntax, "expected a number here", ""},
      {"scale(2.)", 8, 1, ErrorCode::syntax, "expected ',' or ')' here", ""},
      {"scale(var(--a))", 7, 3, ErrorCode::type, "var() is not supported",
       "write the number, or use calc(), min(), max() or clamp()"},
      {"scale(1e999)", 7, 5, ErrorCode::range, "'1e999' is too large or too small", ""},
      {"scale(1e-999)", 7, 6, ErrorCode::range, "'1e-999' is too large or too small", ""},
      {"rotate(1e308turn)", 8, 9, ErrorCode::range, "'1e308turn' is too large or too small", ""},
      {"scale(50%)", 9, 1, ErrorCode::type, "expected a number without a unit here, not '%'",
       "write 0.5 instead of 50%"},
      {"scale(2px)", 8, 2, ErrorCode::type, "expected a number without a unit here, not 'px'", ""},
      {"translate(10px, 50%)", 19, 1, ErrorCode::type, "'%' is not a unit of length here",
       "use px, or give the size of the element, to which percentages refer"},
      {"translate(1em)", 12, 2, ErrorCode::type, "'em' is not a unit of length here", "use px, or give the font size"},
      {"translate(1ex)", 12, 2, ErrorCode::type, "'ex' is not a unit of length here", px},
      {"translateY(20)", 12, 2, ErrorCode::type, "a length needs its unit: 20", "px"},
      {"rotate(35)", 8, 2, ErrorCode::type, "an angle needs its unit: 35", units},
      {"rotate(35px)", 10, 2, ErrorCode::type, "'px' is not a unit of angle", units},
      {"rotate3d(0, 1px, 0, 1deg)", 14, 2, ErrorCode::type, "expected a number without a unit here, not 'px'", ""},
      {"rotate3d(0, 1, 0, 1)", 19, 1, ErrorCode::type, "an angle needs its unit: 1", units},
      {"scale(2) rotate3d(0, 0, 0, 1deg)", 10, 23, ErrorCode::range, "this axis has no direction", ""},
      {"rotate3d(1e308, 1e308, 1e308, 1deg)", 1, 35, ErrorCode::range, "this axis has no direction", ""},
      {"translate()", 1, 11, ErrorCode::syntax, "translate() takes one or two lengths", ""},
      {"translate(1px, 2px, 3px)", 1, 21, ErrorCode::syntax, "translate() takes one or two lengths", ""},
      {"translateX(1px, 2px)", 1, 17, ErrorCode::syntax, "translateX() takes one length", ""},
      {"translate3d(1px, 2px)", 1, 21, ErrorCode::syntax, "translate3d() takes three lengths", ""},
      {"rotate()", 1, 8, ErrorCode::syntax, "rotate() takes one angle", ""},
      {"rotate3d(1, 2, 3)", 1, 17, ErrorCode::syntax, "rotate3d() takes three numbers and an angle", ""},
      {"scale(1, 2, 3)", 1, 13, ErrorCode::syntax, "scale() takes one or two numbers", ""},
      {"scaleZ()", 1, 8, ErrorCode::syntax, "scaleZ() takes one number", ""},
      {"scale3d(1)", 1, 10, ErrorCode::syntax, "scale3d() takes three numbers", ""},
  };
  for (const Bad& bad : all) {
    const auto motion = from_css(bad.list);
    ASSERT_FALSE(motion) << bad.list;
    const Error& e = motion.error();
    EXPECT_EQ(e.message, bad.message) << bad.list;
    EXPECT_EQ(e.hint, bad.hint) << bad.list;
    EXPECT_EQ(e.code, bad.code) << bad.list;
    EXPECT_EQ(e.place.line, 1) << bad.list;
    EXPECT_EQ(e.place.column, bad.column) << bad.list;
    EXPECT_EQ(e.place.length, bad.length) << bad.list;
  }
}

TEST(CssRead, AListHasAnEnd) {
  std::string list;
  for (int i = 0; i < 10'000; ++i) list += "scale(1)";
  EXPECT_TRUE(from_css(list));
  const auto motion = from_css(list + "scale(1)");
  ASSERT_FALSE(motion);
  EXPECT_EQ(motion.error().message, "there can be at most 10000 transforms");
  EXPECT_EQ(motion.error().place.column, 80'001);
}

TEST(CssRead, NoTextBreaksIt) {
  std::mt19937 random(3);
  const std::string parts[] = {"translate", "rotate3d", "scale", "(", ")",  ",",  " ",    "1",    "-",   ".", "e",
                               "+",         "px",       "deg",   "%", "/*", "*/", "none", "\xC3", "9e9", "0", "calc("};
  for (int round = 0; round < 20'000; ++round) {
    std::string list;
    for (unsigned n = random() % 12; n > 0; --n) list += parts[random() % std::size(parts)];
    const auto motion = from_css(list);
    if (motion)
      EXPECT_TRUE(check(*motion)) << list;
    else
      EXPECT_FALSE(motion.error().message.empty()) << list;
  }
}

// ---- In between

// Matrices worked out by hand.
TEST(Css, IsInBetweenWhereTheSpecificationPutsIt) {
  // y points down and rotate(90deg) takes x to y: (1, 0) to (0, 1).
  expect_near(at(read("rotate(90deg)"), 1), rows({0, -1, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0}), 1e-15, "rotate");
  // Half of it: moved by (5, 10), turned by 45 degrees, scaled by 1.5 in x and 2 in y.
  const double c = std::sqrt(0.5);
  expect_near(at(read("translate(10px, 20px) rotate(90deg) scale(2, 3)"), 0.5),
              rows({1.5 * c, -2 * c, 0, 5, 1.5 * c, 2 * c, 0, 10, 0, 0, 1, 0}), 1e-15, "half");
  // rotateX takes y to z, rotateY takes z to x.
  expect_near(at(read("rotateX(90deg)"), 1), rows({1, 0, 0, 0, 0, 0, -1, 0, 0, 1, 0, 0}), 1e-15, "rotateX");
  expect_near(at(read("rotateY(90deg)"), 1), rows({0, 0, 1, 0, 0, 1, 0, 0, -1, 0, 0, 0}), 1e-15, "rotateY");
  // A third of a turn about the diagonal takes x to y to z.
  expect_near(at(read("rotate3d(2, 2, 2, 240deg)"), 0.5), rows({0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0, 0}), 1e-15,
              "diagonal");
  // The linear law goes through zero: 1 -> -1 is 0 half way.
  expect_near(at(read("scale(-1, 4)"), 0.5), rows({0, 0, 0, 0, 0, 2.5, 0, 0, 0, 0, 1, 0}), 0, "scale");
  // About (10, 0) a quarter turn takes 0 to (10, -10), and translations do not mind the origin.
  expect_near(at(read("translate(3px) rotate(90deg)", {10, 0, 0}), 1), rows({0, -1, 0, 13, 1, 0, 0, -10, 0, 0, 1, 0}),
              1e-14, "origin");
}

// CSS moves the whole list to the origin and back. In a motion each factor stands about it.
TEST(Css, TheOriginOfTheListIsThatOfEachFunction) {
  const std::string list =
      "translate3d(4px, 5px, 6px) rotate3d(1, 2, 3, 700deg) translateY(9px) scale3d(2, -1, 0.5) rotateX(50deg)";
  const Vec3 o{30, -40, 50};
  for (const double t : {0.0, 0.3, 0.5, 1.0, 1.7})
    expect_near(at(read(list, o), t), translation(o) * at(read(list), t) * translation(-o), 1e-12, std::to_string(t));
}

TEST(Css, FromNoneItIsTheMotion) {
  const std::string text = "rotate(3turn) translate(10px, 20px) scale(0, -2) rotateY(-50deg)";
  const Vec3 origin{1, 2, 3};
  const Motion m = read(text, origin);
  for (const double t : {-0.5, 0.0, 0.25, 0.7, 1.0, 2.0}) {
    expect_near(about(origin, between({}, listed(text), t)), at(m, t), 1e-12, "there");
    expect_near(about(origin, between(listed(text), {}, 1 - t)), at(m, t), 1e-12, "back");
  }
}

TEST(Css, ListsThatMatchGoFunctionByFunction) {
  // Kinds match, whatever the axes of moving and scaling, in the plane or in space.
  expect_near(between(listed("translateX(2px) scale(2)"), listed("translateZ(4px) scaleZ(3)"), 0.5),
              rows({1.5, 0, 0, 1, 0, 1.5, 0, 0, 0, 0, 2, 2}), 0, "kinds");
  // 10 to 900 degrees, turns and all: 455 = 95 half way.
  expect_near(between(listed("rotate(10deg)"), listed("rotateZ(900deg)"), 0.5), at(read("rotate(95deg)"), 1), 1e-14,
              "turns");
  // The shorter one is padded.
  expect_near(between(listed("rotate(20deg)"), listed("rotate(40deg) scale(3) translateX(4px)"), 0.5),
              at(read("rotate(30deg) scale(2) translateX(2px)"), 1), 1e-14, "padded");
  // No turn at all has no axis of its own.
  expect_near(between(listed("rotateX(0deg)"), listed("rotateY(90deg)"), 0.5), at(read("rotateY(45deg)"), 1), 1e-15,
              "axis");
  expect_near(between(listed("rotateX(90deg)"), listed("rotateY(0)"), 0.5), at(read("rotateX(45deg)"), 1), 1e-15,
              "axis");
  expect_near(between(listed("rotate3d(1, 2, 3, 20deg)"), listed("rotate3d(10, 20, 30, 40deg)"), 0.5),
              at(read("rotate3d(1, 2, 3, 30deg)"), 1), 1e-15, "length");
  // The ends are exact.
  EXPECT_EQ(at(read("scale3d(0.1, -1e-20, 1e20)"), 1), scaling({0.1, -1e-20, 1e20}));
  EXPECT_EQ(between(listed("scale3d(0.1, 1, 1)"), listed("scale3d(1, 0.1, 3)"), 1), scaling({1, 0.1, 3}));
  EXPECT_EQ(between(listed("scale3d(0.1, 1, 1)"), listed("scale3d(1, 0.1, 3)"), 0), scaling({0.1, 1, 1}));
  EXPECT_EQ(between(listed("translateX(0.1px)"), listed("translateX(1e15px)"), 0), at(read("translateX(0.1px)"), 1));
  EXPECT_EQ(between(listed("translateX(1e15px)"), listed("translateX(0.1px)"), 1), at(read("translateX(0.1px)"), 1));
}

// ---- All of CSS

TEST(CssRead, WhatIsNoMotionIsAMatrix) {
  const double t = std::tan(0.5);
  const std::pair<const char*, Mat4> all[] = {
      {"skew(0.5rad)", rows({1, t, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0})},
      {"skew(0.5rad, -0.5rad)", rows({1, t, 0, 0, -t, 1, 0, 0, 0, 0, 1, 0})},
      {"skewX(0.5rad)", rows({1, t, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0})},
      {"SKEWY(0.5rad)", rows({1, 0, 0, 0, t, 1, 0, 0, 0, 0, 1, 0})},
      {"matrix(1, 2, 3, 4, 5, 6)", rows({1, 3, 0, 5, 2, 4, 0, 6, 0, 0, 1, 0})},
      {"matrix3d(1,2,3,0, 4,5,6,0, 7,8,9,0, 10,11,12,1)", rows({1, 4, 7, 10, 2, 5, 8, 11, 3, 6, 9, 12})},
      {"perspective(none)", Mat4()},
      {"translate(50%, 25%) rotate(0)", translation({50, 5, 0})},
      {"translate(1in, 1pc)", translation({96, 16, 0})},
      {"translate3d(2.54cm, 25.4mm, 101.6Q)", translation({96, 96, 96})},
      {"translateX(72pt)", translation({96, 0, 0})},
      {"translate(calc(1in + 2 * (3px - 50%)), min(3px, 2px, 1in))", translation({2, 2, 0})},
      {"translateX(calc(-1 * (10px - 4px) / 3))", translation({-2, 0, 0})},
      {"translateX(clamp(1px, 10%, 5px)) translateY(max(1px,-2px))", translation({5, 1, 0})},
      {"scale(calc(1 + 1), CALC(2 * calc(3 - 1) / 8))", scaling({2, 0.5, 1})},
      {"matrix(calc(2), 0, 0, max(1, 3), 0, 0)", scaling({2, 3, 1})},
  };
  for (const auto& [list, m] : all) {
    const auto read = parse_css(list, CssPage{100, 20});
    ASSERT_TRUE(read) << list << ": " << read.error().message;
    expect_near(matrix_of(*read), m, 1e-13, list);
  }
  expect_near(matrix_of(listed("rotate(calc(1turn / 8 + 45deg))")), rows({0, -1, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0}), 1e-15,
              "turned");
  // The eye is 500 pixels away, and never nearer than one.
  EXPECT_EQ(matrix_of(listed("perspective(500px)"))(3, 2), -1 / 500.0);
  EXPECT_EQ(matrix_of(listed("perspective(0)"))(3, 2), -1);
  // The page gives the other units their size.
  const CssPage page{100, 20, 16, 10, 800, 600};
  EXPECT_EQ(matrix_of(*parse_css("translate3d(2em, 3REM, calc(1em - 1px))", page)), translation({32, 30, 15}));
  EXPECT_EQ(matrix_of(*parse_css("translate3d(5vw, 5vh, 0) translate(1vmin, min(1vmax, 50%))", page)),
            translation({40 + 6, 30 + 8, 0}));
  EXPECT_EQ(from_css("translate(50%, 50%)", {}, CssPage{10, 30})->factors[0].by, (Vec3{5, 15, 0}));
}

TEST(CssRead, WhatCannotBeWorkedOutIsTold) {
  const std::tuple<const char*, int, const char*> all[] = {
      {"translateX(calc(1px + 1))", 21, "numbers, lengths and angles cannot be added to each other"},
      {"translateX(calc(1px +1px))", 21, "'+' needs a space on both sides"},
      {"translateX(calc(1px * 1px))", 21, "one of the two factors must be a number without a unit"},
      {"translateX(calc(1px / 1px))", 21, "a divisor must be a number without a unit"},
      {"translateX(calc(1px / 0))", 21, "a divisor must not be 0"},
      {"translateX(calc(1deg))", 12, "expected a length here, not an angle"},
      {"scale(calc(1px))", 7, "expected a number without a unit here, not a length"},
      {"scale(calc(1, 2))", 13, "expected ')' here"},
      {"scale(clamp(1, 2))", 7, "clamp() needs a minimum, a value and a maximum"},
      {"scale(min(1, 1px))", 7, "the values of min() must be of the same kind"},
      {"scale(calc((1 + 2))", 20, "')' is missing"},
      {"scale(sin(1))", 7, "sin() is not supported"},
      {"translateX(calc(1em))", 18, "'em' is not a unit of length here"},
      {"translateX(calc(1e300px * 1e300))", 12, "'calc(1e300px * 1e300)' is too large or too small"},
      {"translateX(5%)", 13, "'%' is not a unit of length here"},
      {"translateZ(5%)", 13, "'%' is not a unit of length here"},
      {"perspective(-1px)", 13, "a distance must not be negative"},
      {"matrix(1, 2)", 1, "matrix() takes six numbers"},
      {"rotate(1e17turn)", 8, "'1e17turn' is too large or too small"},
  };
  for (const auto& [list, column, message] : all) {
    const auto read = parse_css(list);
    ASSERT_FALSE(read) << list;
    EXPECT_EQ(read.error().message, message) << list;
    EXPECT_EQ(read.error().place.column, column) << list;
  }
  EXPECT_FALSE(parse_css("scale(" + std::string(5000, '(')));
  std::string deep = "scale(";
  for (int i = 0; i < 5000; ++i) deep += "calc(";
  EXPECT_EQ(parse_css(deep).error().message, "brackets can be at most 100 levels deep");
}

TEST(CssRead, NoTextOfAllOfCssBreaksIt) {
  std::mt19937 random(4);
  const std::string parts[] = {"skew", "matrix3d", "perspective", "(",    ")",   ",",  " ",  "1",
                               "-",    "+",        "*",           "/",    "px",  "%",  "in", "calc(",
                               "min(", "clamp(",   "0",           "none", "9e9", "deg"};
  for (int round = 0; round < 20'000; ++round) {
    std::string list = round % 2 ? "translateX(calc(" : "";
    for (unsigned n = random() % 12; n > 0; --n) list += parts[random() % std::size(parts)];
    const auto read = parse_css(list, CssPage{100, 50});
    EXPECT_TRUE(read || !read.error().message.empty()) << list;
  }
}

// The whole of what a browser does is shown in css_platform.txt; here that it says what it loses.
TEST(Css, WhatIsLostIsSaid) {
  const auto now = [](const char* from, const char* to) { return css_between(listed(from), listed(to), 0.5); };
  const CssBetween differ = now("translateX(1px) rotate(720deg)", "translateX(1px) scale(2)");
  EXPECT_EQ(differ.mixed, 2u);
  expect_near(differ.matrix, rows({1.5, 0, 0, 1, 0, 1.5, 0, 0, 0, 0, 1, 0}), 1e-15, "turns are lost");
  EXPECT_EQ(now("skewX(1deg)", "skewY(1deg)").mixed, 1u);
  // The short way from a quarter turn about x to one about y is about an axis between them.
  const CssBetween axes = now("scale(1) rotateX(90deg)", "scale(1) rotateY(90deg)");
  EXPECT_EQ(axes.short_way, 2u);
  EXPECT_EQ(axes.mixed, 0u);
  const double h = 0.5 / std::sqrt(1.5), w = 1 / std::sqrt(1.5);
  expect_near(axes.matrix, rotation(Quat{w, h, h, 0}), 1e-15, "between two axes");
  EXPECT_EQ(now("rotate(1deg)", "rotate3d(0, 0, -1, 1deg)").short_way, 1u);
  const CssBetween flat = now("matrix(1, 1, 0, 0, 0, 100)", "matrix(1, 0, 0, 1, 0, 0)");
  EXPECT_TRUE(flat.jumps);
  EXPECT_EQ(flat.matrix, Mat4());
  EXPECT_EQ(css_between(listed("scaleX(0) skew(0)"), listed("skew(0) scaleX(0)"), 0.49).matrix, scaling({0, 1, 1}));
}

TEST(Css, ManyTurnsKeepTheirFraction) {
  const double turns = 0.25 * 1 + 0.12345 / 4;  // 123456789.12345 / 4 is 30864197 and these
  expect_near(css_between({}, listed("rotate(123456789.12345turn)"), 0.25).matrix, at(parsed("R(1turn)"), turns), 1e-15,
              "a quarter");
  expect_near(css_between(listed("rotate(100000000turn)"), listed("rotate(49382715649.38grad)"), 1).matrix,
              at(parsed("R(1turn)"), 0.12345), 1e-15, "in gradians");
}

// ---- Writing

TEST(CssWrite, SaysWhatItWasGiven) {
  const std::tuple<const char*, const char*, const char*> all[] = {
      {"", "none", "none"},
      {"T(10 20)", "translate(0px, 0px)", "translate(10px, 20px)"},
      {"T(0 0 0.5)", "translate3d(0px, 0px, 0px)", "translate3d(0px, 0px, 0.5px)"},
      {"R(90deg)", "rotate(0deg)", "rotate(90deg)"},
      {"R(-2.5turn)", "rotate(0deg)", "rotate(-900deg)"},
      {"R(35deg axis y)", "rotate3d(0, 1, 0, 0deg)", "rotate3d(0, 1, 0, 35deg)"},
      {"S(2 linear)", "scale3d(1, 1, 1)", "scale3d(2, 2, 2)"},
      {"S(2 -1 linear)", "scale(1, 1)", "scale(2, -1)"},
      {"S(1)", "scale(1, 1)", "scale(1, 1)"},
      // One centre for all: a translation minds none.
      {"T(1 1) R(1rad @ 3 4) T(2 2) S(2 3 @ 3 4 linear) T(5 5)",
       "translate(0px, 0px) translate(3px, 4px) rotate(0deg) translate(0px, 0px) scale(1, 1) translate(0px, 0px) "
       "translate(-3px, -4px)",
       "translate(1px, 1px) translate(3px, 4px) rotate(1rad) translate(2px, 2px) scale(2, 3) translate(5px, 5px) "
       "translate(-3px, -4px)"},
      {"R(1rad @ 3 4) R(1rad)", "translate(3px, 4px) rotate(0deg) translate(-3px, -4px) rotate(0deg)",
       "translate(3px, 4px) rotate(1rad) translate(-3px, -4px) rotate(1rad)"},
      {"R(1rad @ 3 4) R(1rad @ 0 0 5)",
       "translate(3px, 4px) rotate(0deg) translate(-3px, -4px) translate3d(0px, 0px, 5px) rotate(0deg) "
       "translate3d(0px, 0px, -5px)",
       "translate(3px, 4px) rotate(1rad) translate(-3px, -4px) translate3d(0px, 0px, 5px) rotate(1rad) "
       "translate3d(0px, 0px, -5px)"},
  };
  for (const auto& [motion, from, to] : all) {
    const auto lists = to_css(parsed(motion));
    ASSERT_TRUE(lists) << motion;
    EXPECT_EQ(lists->from, from);
    EXPECT_EQ(lists->to, to);
  }
}

TEST(CssWrite, WhatHasNoCssIsRefused) {
  const auto refused = [](const Motion& motion, const char* message, ErrorCode code) {
    const auto lists = to_css(motion);
    ASSERT_FALSE(lists) << message;
    EXPECT_EQ(lists.error().message, message);
    EXPECT_EQ(lists.error().code, code);
  };
  refused(parsed("T(1 2) S(2)"), "factor 2: it scales by the exponential law, but CSS scales by the linear law",
          ErrorCode::type);
  refused(parsed("R(1turn @ hub)"), "factor 1: its centre is the object 'hub', but CSS has no objects",
          ErrorCode::type);
  refused({{rotate_by(NAN)}}, "factor 1, R: its angle is not finite", ErrorCode::range);
}

// What is written reads back as the same numbers, and moves as the motion does.
TEST(CssWrite, ReadsBackAsTheSameMotion) {
  std::mt19937 random(8);
  for (int round = 0; round < 1000; ++round) {
    Motion motion = random_motion(random, 1 + round % 9, round % 2 == 1);
    for (Factor& f : motion.factors) f.law = Factor::Law::linear;
    const auto lists = to_css(motion);
    ASSERT_TRUE(lists);
    const Motion to = read(lists->to);
    for (const Factor& f : motion.factors)
      EXPECT_TRUE(std::any_of(to.factors.begin(), to.factors.end(), [&](const Factor& g) {
        return g.kind == f.kind && g.by == f.by && g.angle == f.angle && g.axis == f.axis;
      })) << lists->to;
    for (const double t : {0.0, 0.3, 1.0}) {
      const Mat4 expected = at(motion, t);
      double size = 1;
      for (const double x : expected.m) size = std::max(size, std::abs(x));
      expect_near(between(listed(lists->from), listed(lists->to), t), expected, 1e-11 * size, lists->to);
    }
  }
}

// ---- Beside a browser

// One row of css_chromium.txt, which tools/browser.sh writes.
struct Answer {
  std::string from, to, origin;
  double t = 0;
  Mat4 matrix;
  std::vector<double> places;
};

std::vector<double> numbers(const std::string& text) {
  std::istringstream in(text);
  std::vector<double> n;
  for (double x = 0; in >> x;) n.push_back(x);
  return n;
}

std::vector<Answer> answers(const std::string& file) {
  std::ifstream in(file);
  std::vector<Answer> rows;
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || line[0] == '#') continue;
    std::istringstream row(line);
    Answer a;
    std::string t, matrix, places;
    for (std::string* cell : {&a.from, &a.to, &a.origin, &t, &matrix, &places}) std::getline(row, *cell, '\t');
    a.t = std::stod(t);
    const std::vector<double> m = numbers(matrix);
    EXPECT_EQ(m.size(), 16u) << line;
    std::copy_n(m.begin(), std::min<std::size_t>(16, m.size()), a.matrix.m.begin());
    a.places = numbers(places);
    EXPECT_EQ(a.places.size(), 6u) << line;
    rows.push_back(std::move(a));
  }
  return rows;
}

std::string answers_file() {
  const char* other = std::getenv("BETWIXT_CSS_ANSWERS");
  return other != nullptr ? other : SOURCE_DIR "/tests/algebra/css_chromium.txt";
}

// Chromium works in f64, with angles in f64 too. Lengths, the numbers of scale() and the direction of an axis it rounds
// to f32, and it tells places on the screen in f32: of a few hundred pixels that is some 1e-5.
TEST(CssInChromium, IsWhereTheBrowserPutsIt) {
  const std::vector<Answer> all = answers(answers_file());
  ASSERT_GE(all.size(), 250u);
  std::set<std::string> lists;
  double turned = 0, rest = 0, moved = 0, pixels = 0;
  for (const Answer& a : all) {
    const std::string pair = a.from + " to " + a.to;
    lists.insert(pair);
    const Mat4 m = between(listed(a.from), listed(a.to), a.t);
    const bool rounded = pair.find("scale") != std::string::npos || pair.find("rotate3d") != std::string::npos;
    double& worst = rounded ? rest : turned;
    for (int r = 0; r < 4; ++r) {
      for (int c = 0; c < 3; ++c) worst = std::max(worst, std::abs(m(r, c) - a.matrix(r, c)));
      moved = std::max(moved, std::abs(m(r, 3) - a.matrix(r, 3)));
    }
    const std::vector<double> o = numbers(a.origin);
    const Vec3 origin{o.at(0), o.at(1), o.at(2)};
    const Mat4 shown = about(origin, m);
    const Vec3 points[] = {{0, 0, 0}, {100, 0, 0}, {37, -81, 0}};
    for (std::size_t p = 0; p < std::size(points); ++p) {
      const Vec3 place = transform_point(shown, points[p]);
      const double off = std::hypot(place.x - a.places.at(2 * p), place.y - a.places.at(2 * p + 1));
      EXPECT_LE(off, 1e-4) << pair << " at " << a.t;
      pixels = std::max(pixels, off);
    }
  }
  EXPECT_GE(lists.size(), 250u);
  EXPECT_LE(turned, 1e-12);
  EXPECT_LE(rest, 1e-6);
  EXPECT_LE(moved, 1e-4);
  if (std::getenv("BETWIXT_CSS_ANSWERS") == nullptr) return;
  std::cout << lists.size() << " pairs of lists, " << all.size() << " frames; largest differences:\n"
            << turned << " in the matrix where all numbers are f64 (no scale, no rotate3d), " << rest << " elsewhere\n"
            << moved << " px in its translation, " << pixels << " px in the places of points\n";
}

// The lists that are written for these motions are among those that the browser was given.
TEST(CssInChromium, ShowsTheMotionsThatAreWritten) {
  const std::vector<Answer> all = answers(answers_file());
  for (const char* text : {"R(2.5turn @ 1 2)", "T(6.28 0) R(-1turn @ 0 1)",
                           "R(35deg @ 3 4) T(100 0) S(2 0.5 @ 3 4 linear) R(0.1rad @ 1e-7 5)",
                           "T(1 2 50) R(3turn @ 1 2 3 axis 1 2 3) S(2 1 -3 @ 1 2 3 linear)"}) {
    const Motion motion = parsed(text);
    const auto lists = to_css(motion);
    ASSERT_TRUE(lists);
    int found = 0;
    for (const Answer& a : all)
      if (a.from == lists->from && a.to == lists->to) {
        ++found;
        expect_near(at(motion, a.t), a.matrix, 1e-4, text);
      }
    EXPECT_GE(found, 1) << text << ": " << lists->from << " to " << lists->to;
  }
}

}  // namespace
}  // namespace betwixt
