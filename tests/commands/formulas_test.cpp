// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Formulas, `let` and places in patterns, through whole films.
#include <cmath>

#include "betwixt/track.h"
#include "support/loaded_film.h"

namespace betwixt {
namespace {

TEST(Formulas, StandWhereverNumbersDo) {
  const LoadedFilm s(
      "rate 24\nlet beat = 12f\nlet r = 2*sqrt(4)\nlet p = (1 2 3)\nlet warm = hsv(40deg 1 1)\nlet slow = 30deg\n"
      "create a sphere radius=r/2 position=p\nset a.color warm\ncreate b box rotation=euler(slow*2 0 1turn/8) "
      "size=(1+1 20cm*5 1m)\n"
      "at 1f+2*beat a.position.x p.z*2 ease-in=beat/2\nb.position\n  1f (0 0 0) linear\n  beat*3 (beat/1f 0 1-2)\n"
      "create look-out camera lens=1cm*5\nmove b.position 1f..beat*3 by 1s/2\nnotes on\nrange 1f 1f+4*beat\n");
  expect_numbers(s, "a.radius", "1f", {2}, 0);
  expect_numbers(s, "a.position.y", "1f", {2}, 0);
  expect_numbers(s, "a.position.x", "25f", {6}, 0);
  expect_numbers(s, "b.rotation", "1f", {pi / 3, 0, pi / 4}, 1e-15);
  expect_numbers(s, "b.size", "1f", {2, 1, 1}, 0);
  expect_numbers(s, "b.position", "48f", {12, 0, -1}, 1e-12);  // frame 36, and half a second
  expect_numbers(s, "look-out.lens", "1f", {50}, 0);
  EXPECT_EQ(s.loaded.document.range().second.seconds(), 2);
}

TEST(Formulas, PatternsTakeThePlaceOfLoops) {
  const LoadedFilm s(
      "rate 24\ncreate s{1..10} sphere position=(2*cos(i*tau/n) i n)\ncreate g{1..3}-{a,b} box position=(i1 i2 i)\n"
      "at 1f+i*12f s*.radius 0.1*i\ns{3,2}.position.z\n  1f 0\n  1f+i*2f -i linear\n  +12f i*0.5\n  +1f 9\n"
      "set g2-*.rotation euler(0 0 i*15deg)\nmove s*.radius 0f..999f by (n-i)*1f\nlayer up add\n"
      "on up set g*.position.y 10*i\nset g{1,3}-b.shininess i1/10\n");
  for (int i = 1; i <= 10; ++i) {
    const std::string o = fmt::format("s{}", i);
    expect_numbers(s, o + ".position.x", "1f", {2 * std::cos(i * 2 * pi / 10)}, 1e-15);
    expect_numbers(s, o + ".position.y", "1f", {double(i)}, 0);
    EXPECT_EQ(s.loaded.document.names().size(), 17u);
    const auto all = events(s.loaded.document, (*find_targets(o + ".radius", s.loaded.document))[0]);
    ASSERT_EQ(all.size(), 1u);
    EXPECT_EQ(all[0].time, Rate{}.frame(1 + 12 * i + 10 - i)) << i;
    EXPECT_NEAR(std::get<double>(*all[0].value), 0.1 * i, 1e-15);
  }
  // s{3,2}: s3 is the first.
  expect_numbers(s, "s3.position.z", "3f", {-1}, 1e-15), expect_numbers(s, "s2.position.z", "5f", {-2}, 1e-15);
  expect_numbers(s, "s3.position.z", "15f", {0.5}, 1e-15), expect_numbers(s, "s2.position.z", "17f", {1}, 1e-15);
  expect_numbers(s, "s3.position.z", "16f", {9}, 1e-15), expect_numbers(s, "s2.position.z", "18f", {9}, 1e-15);
  expect_numbers(s, "g3-b.position", "1f", {3, 2 + 60, 6}, 1e-15);
  expect_numbers(s, "g2-b.rotation", "1f", {0, 0, pi / 6}, 1e-15);
  expect_numbers(s, "g3-b.shininess", "1f", {0.2}, 1e-15);  // its place in {1,3}
}

TEST(Formulas, AllOfAPatternOrNothing) {
  const Loaded l = read(
      "create q{1..3} box position=(i 0 1/(i-2))\ncreate a{1..3} sphere\nset a*.radius 2-i\na*.position.x\n  1f 3\n  "
      "9f 1/(i-3)\n");
  EXPECT_EQ(errors(l), (std::vector<std::string>{"1:34: this formula divides by zero", "3:15: radius is at least 0",
                                                 "6:6: this formula divides by zero"}));
  EXPECT_EQ(l.document.names().size(), 3u);
  const LoadedFilm same("create a{1..3} sphere\na*.position.x\n  1f 3\n");
  EXPECT_EQ(write(l.document), write(same.loaded.document));
}

TEST(Formulas, ErrorsByTheirPlace) {
  const std::string ball = "create b sphere\n";
  const std::pair<const char*, const char*> table[] = {
      {"set b.radius 2f+3deg", "2:14: a time and an angle cannot be added"},
      {"set b.radius 3deg*2", "2:14: a plain number is wanted here, not an angle"},
      {"set b.position (1 2*3s 0)", "2:19: a plain number is wanted here, not a time"},
      {"set b.rotation euler(0 0 3*2)", "2:26: an angle is wanted here, not a number"},
      {"at 2*3 b.radius 2", "2:4: a time is wanted here, not a number"},
      {"move b.radius 1f..9f by 2*3", "2:25: a length of time is wanted here, not a number"},
      {"set b.radius (1 2 3)", "2:14: a number is wanted here, not a vector"},
      {"set b.radius 1e300*1e300", "2:14: this formula has no finite value"},
      {"at 1e300*1f b.radius 2", "2:4: times reach 146 years (4.6e9 s) and no further"},
      {"set b.radius nosuch*2", "2:14: there is no number 'nosuch'"},
      {"let x = y*2\nlet y = x*2", "2:9: there is no number 'y'"},
      {"let x = x+1", "2:9: there is no number 'x'"},
      {"let a = 1\nlet a = 2", "3:5: there is a 'let a' already"},
      {"let again a = 2", "2:11: there is no 'let a' above that could change"},
      {"let sin = 2", "2:5: 'sin' has a meaning in formulas already"},
      {"let i = 2", "2:5: 'i' has a meaning in formulas already"},
      {"let red = 2", "2:5: 'red' has a meaning in formulas already"},
      {"let 2x = 2", "2:5: '2x' cannot be a name in formulas"},
      {"let a-b = 2", "2:5: 'a-b' cannot be a name in formulas"},
      {"let a", "2:6: '=' is missing here"},
      {"let a =", "2:8: a formula, a vector or a colour is missing here"},
      {"let a = 2 3", "2:11: '3' is not expected here"},
      {"let a = \"x\"", "2:9: this is not a colour"},
      {"set b.radius i1", "2:14: the pattern has no first range that i1 could count"},
      {"set b.radius i5", "2:14: there is no number 'i5'"}};
  for (const auto& [line, words] : table) EXPECT_EQ(first_error(ball + line + "\n"), words) << line;
  EXPECT_EQ(first_error("let a = 1\nlet again a = a+1\ncreate b sphere radius=a\n"), "");
}

// Planets whose years are as i: their places are complex powers of e.
TEST(Formulas, StandInMotions) {
  const LoadedFilm s(
      "rate 24\nlet year = 1turn\nlet far = 2m\ncreate sun sphere position=(1 0 0)\ncreate k sphere\nlet k = 3\n"
      "create p{1..3} sphere position=(1+i 0 0)\np*.motion\n  1f..25f R(year/i @ sun)\n  25f..49f T(k-1 -far i/2) "
      "S(2^i @ k*0 (1-1))\n"
      "create near sphere\nnear.motion\n  1f..25f R(-(45deg+i*45deg) @ k axis (0 0 i)) T(2*cos(60deg) sqrt(4), 0)\n");
  for (int i = 1; i <= 3; ++i) {
    const double angle = pi / i, r = std::exp2(i);  // after half of the segment; what the second one scales by
    const std::string o = fmt::format("p{}", i);
    expect_place(s, o, "13f", {1 + i * std::cos(angle), i * std::sin(angle), 0});
    expect_place(s, o, "49f", {(1 + i * std::cos(2 * angle)) * r + 2, i * std::sin(2 * angle) * r - 2, i / 2.0});
  }
  expect_place(s, "near", "25f", {2, -1, 0});  // (1 2 0) a quarter turn clockwise about the ball k
  const auto error = [](const std::string& motion) {
    return first_error("let k = 3\ncreate a sphere\na.motion\n  1f..24f " + motion + "\n");
  };
  EXPECT_EQ(error("R(2*q @ a)"), "4:15: there is no number 'q'");
  EXPECT_EQ(error("R(2*k @ a)"), "4:13: an angle needs its unit: 6");
  EXPECT_EQ(error("T(1 0) R(k*1deg @ so)"), "4:29: there is no object 'so'");
  EXPECT_EQ(error("T(1/0 0)"), "4:13: this formula divides by zero");
  EXPECT_EQ(error("\"T(k 0)\""), "4:11: a translation has two or three numbers");
}

TEST(Formulas, GiveTheirNamesToCode) {
  const LoadedFilm s(
      "rate 24\nlet k = 0.25\nlet a = 30deg\nlet p = (1 2 3)\nlet warm = rgb(1 0.5 0)\nlet late = 2s\nlet t = 7\n"
      "create b{1..4} sphere\ncreate t{1..3} text\ncreate g{1..2}-{a,b,c} box\n"
      "set b*.radius = \"k * i + n\"\nb*.position\n  1f = \"p * i\"\nset b*.color = \"warm\"\n"
      "set b*.rotation = \"euler(0, 0, a * i)\"\nset b*.shininess = \"clamp(t / late, 0, 1)\"\n"
      "set t*.text = \"({'one', 'two', 'three'})[i]\"\nset g{1..2}-{a,b,c}.pivot = \"vec(i1, i2, i)\"\n"
      "procedure half lua \"... * k * 2\"\nlet again k = 100\nset b1.transparency = \"half(0.5)\"\n"
      "define heft number = \"k\"\nset t*.size = \"local n = 0 for i = 1, 3 do n = n + i end return n\"\n");
  for (int i = 1; i <= 4; ++i) {
    const std::string b = fmt::format("b{}", i);
    expect_numbers(s, b + ".radius", "1f", {0.25 * i + 4});
    expect_numbers(s, b + ".position", "1f", {1.0 * i, 2.0 * i, 3.0 * i});
    expect_numbers(s, b + ".rotation", "1f", {0, 0, i * pi / 6});
    expect_numbers(s, b + ".heft", "1f", {100});
  }
  expect_numbers(s, "b2.color", "1f", {1, 0.5, 0});
  expect_numbers(s, "b2.shininess", "25f", {0.5});  // t is the time still, though a let has that name
  expect_numbers(s, "b1.transparency", "1f", {0.25});
  EXPECT_EQ(s.text("t3.text", "1f"), "three");
  expect_numbers(s, "t2.size", "1f", {6});
  expect_numbers(s, "g2-b.pivot", "1f", {2, 2, 5});
  const LoadedFilm again(write(s.loaded.document));
  EXPECT_EQ(again.text("t2.text", "1f"), "two");
  EXPECT_EQ(first_error("let beat = 12f\ncreate b sphere\nset b.radius = \"beat\"\n"),
            "3:16: 'beat' counts frames, and code counts seconds");
  EXPECT_EQ(first_error("let k = 2\ncreate b sphere\nset b.radius = \"k +\"\n").substr(0, 6), "3:16: ");
}

TEST(Formulas, AScriptThatIsWrittenOutHasWhatTheyCameTo) {
  const LoadedFilm s(
      "let beat = 1f+0.5s\nlet p = (1 2/3 3)\nlet w = gold\nlet a = 30deg/7\nlet l = 2m\n"
      "create b{1..3} sphere position=(i*p.x p.y 0)\nat beat*i b*.color w\n");
  const std::string out = write(s.loaded.document);
  const LoadedFilm again(out);
  EXPECT_TRUE(again.loaded.document == s.loaded.document) << out;
  EXPECT_EQ(write(again.loaded.document), out);
}

}  // namespace
}  // namespace betwixt
