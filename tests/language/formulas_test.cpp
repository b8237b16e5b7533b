// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests formulas, `let` and positions in patterns, through whole films.
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

// A function, an object or a layer may be called as a place is.
TEST(Formulas, ANameIsNoPlace) {
  const std::string rows = "  1f 0 linear\n  11f 10\n";
  for (const char* name : {"n", "i", "i2"}) {
    const std::string of = fmt::format("define {} number\ncreate a{{1..4}} box\na*.{}\n", name, name) + rows;
    const LoadedFilm s(of + fmt::format("stagger a*.{} by 2f\n", name));
    for (int i = 1; i <= 4; ++i) expect_numbers(s, fmt::format("a{}.{}", i, name), "11f", {12.0 - 2 * i});
    const LoadedFilm copied(of + fmt::format("copy a1.{0} 1f..11f to 21f on a2.{0}\nset a*.size (i n 1)\n", name));
    expect_numbers(copied, fmt::format("a2.{}", name), "26f", {5});
    expect_numbers(copied, "a3.size", "1f", {3, 4, 1});
  }
  const LoadedFilm objects("create n{1..4} sphere\nlayer i add\nn*.radius\n" + rows + "stagger n*.radius by 2f\n" +
                           "at 1f+i*2f n*.position.x i\non i set n*.scale (1 1 1)\non i stagger n*.scale by 1f\n");
  for (int i = 1; i <= 4; ++i) expect_numbers(objects, fmt::format("n{}.radius", i), "11f", {12.0 - 2 * i});
  expect_numbers(objects, "n4.position.x", "9f", {4});
  expect_numbers(
      LoadedFilm("create n sphere\ncreate b{1..3} box\nn.radius\n" + rows + "move b*.position 1f..i*2f by i*1f\n"),
      "n.radius", "6f", {5});
}

TEST(Formulas, GiveHuesAndWhatFiltersAreTold) {
  const LoadedFilm s(
      "create b{1..6} box\nset b*.color hsv(i*60deg 1 1)\ncreate c{1..6} box\nset c*.color hsv(i/6 1 1)\n"
      "let tilt = 30deg\nset b6.color hsv(2*tilt 1 1)\n"
      "filter b*.position.y wobble amount=0.1*i frequency=i/4\nfilter b*.rotation.z wobble amount=i*10deg\n");
  const std::vector<std::vector<double>> wheel{{1, 1, 0}, {0, 1, 0}, {0, 1, 1}, {0, 0, 1}, {1, 0, 1}};
  for (int i = 1; i <= 5; ++i) {
    expect_numbers(s, fmt::format("b{}.color", i), "1f", wheel[static_cast<std::size_t>(i) - 1]);
    expect_numbers(s, fmt::format("c{}.color", i), "1f", wheel[static_cast<std::size_t>(i) - 1]);
    expect_numbers(s, fmt::format("b{}.position.y", i), "13f", {0.1 * i * std::sin(pi * i / 4)});
    expect_numbers(s, fmt::format("b{}.rotation.z", i), "7f", {i * pi / 18});
  }
  expect_numbers(s, "b6.color", "1f", {1, 1, 0});
  EXPECT_EQ(first_error("create a box color=hsv(2*1f 1 1)\n"), "1:24: expected a plain number here, not a time");
  EXPECT_EQ(first_error("create a box\nfilter a.position wobble frequency=2*1f\n"),
            "2:36: frequency must be a plain number, without a unit");
}

TEST(Formulas, AllOfAPatternOrNothing) {
  const Loaded l = read(
      "create q{1..3} box position=(i 0 1/(i-2))\ncreate a{1..3} sphere\nset a*.radius 2-i\na*.position.x\n  1f 3\n  "
      "9f 1/(i-3)\n");
  EXPECT_EQ(all_told(l), (std::vector<std::string>{"range 1:34 1/(i-2)", "range 3:15 2-i", "range 6:6 1/(i-3)"}));
  EXPECT_EQ(l.document.names().size(), 3u);
  const LoadedFilm same("create a{1..3} sphere\na*.position.x\n  1f 3\n");
  EXPECT_EQ(write(l.document), write(same.loaded.document));
}

TEST(Formulas, ErrorsByTheirPlace) {
  const std::string ball = "create b sphere\n";
  const std::pair<const char*, const char*> table[] = {{"set b.radius 2f+3deg", "type 2:14 2f+3deg"},
                                                       {"set b.radius 3deg*2", "type 2:14 3deg*2"},
                                                       {"set b.position (1 2*3s 0)", "type 2:19 2*3s"},
                                                       {"set b.rotation euler(0 0 3*2)", "type 2:26 3*2"},
                                                       {"at 2*3 b.radius 2", "type 2:4 2*3"},
                                                       {"move b.radius 1f..9f by 2*3", "type 2:25 2*3"},
                                                       {"set b.radius (1 2 3)", "type 2:14 ("},
                                                       {"set b.radius 1e300*1e300", "range 2:14 1e300*1e300"},
                                                       {"at 1e300*1f b.radius 2", "range 2:4 1e300*1f"},
                                                       {"set b.radius nosuch*2", "name 2:14 nosuch"},
                                                       {"let x = y*2\nlet y = x*2", "name 2:9 y"},
                                                       {"let x = x+1", "name 2:9 x"},
                                                       {"let a = 1\nlet a = 2", "name 3:5 a"},
                                                       {"let again a = 2", "name 2:11 a"},
                                                       {"let sin = 2", "name 2:5 sin"},
                                                       {"let i = 2", "name 2:5 i"},
                                                       {"let red = 2", "name 2:5 red"},
                                                       {"let 2x = 2", "syntax 2:5 2x"},
                                                       {"let a-b = 2", "syntax 2:5 a-b"},
                                                       {"let a", "syntax 2:6"},
                                                       {"let a =", "syntax 2:8"},
                                                       {"let a = 2 3", "syntax 2:11 3"},
                                                       {"set b.radius i1", "name 2:14 i1"},
                                                       {"set b.radius i5", "name 2:14 i5"}};
  for (const auto& [line, words] : table) EXPECT_EQ(told(ball + line + "\n"), words) << line;
  EXPECT_EQ(told("let a = 1\nlet again a = a+1\ncreate b sphere radius=a\n"), "");
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
    return told("let k = 3\ncreate a sphere\na.motion\n  1f..24f " + motion + "\n");
  };
  EXPECT_EQ(error("R(2*q @ a)"), "name 4:15 q");
  EXPECT_EQ(error("R(2*k @ a)"), "type 4:13 2*k");
  EXPECT_EQ(error("T(1 0) R(k*1deg @ so)"), "name 4:29 so");
  EXPECT_EQ(error("T(1/0 0)"), "range 4:13 1/0");
  EXPECT_EQ(error("\"T(k 0)\""), "syntax 4:11 \"T(k 0)\"");
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
  EXPECT_EQ(told("let beat = 12f\ncreate b sphere\nset b.radius = \"beat\"\n"), "type 3:16 \"beat\"");
  EXPECT_EQ(told("let k = 2\ncreate b sphere\nset b.radius = \"k +\"\n"), "syntax 3:16 \"k +\"");
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
