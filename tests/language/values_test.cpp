// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests every form of a time, a length and a value.
#include "support/loaded_film.h"

namespace betwixt {
namespace {

const double pi_ = 3.14159265358979323846;

double seconds(std::string_view text, const char* head = "") {
  const auto t = parse_time(text, read(head).document);
  EXPECT_TRUE(t) << text << ": " << (t ? "" : t.error().message);
  return t ? t->seconds() : -1e9;
}

TEST(Times, AllForms) {
  EXPECT_DOUBLE_EQ(seconds("1f"), 0);
  EXPECT_DOUBLE_EQ(seconds("24f"), 23 / 24.0);
  EXPECT_NEAR(seconds("24.5f"), 23.5 / 24, 1e-9);
  EXPECT_DOUBLE_EQ(seconds("2.5s"), 2.5);
  EXPECT_DOUBLE_EQ(seconds(".5s"), 0.5);
  EXPECT_DOUBLE_EQ(seconds("500ms"), 0.5);
  EXPECT_DOUBLE_EQ(seconds("90t"), 3);
  EXPECT_DOUBLE_EQ(seconds("0t"), 0);
  EXPECT_DOUBLE_EQ(seconds("90t", "ticks 60"), 1.5);
  EXPECT_DOUBLE_EQ(seconds("00:01:02.5"), 62.5);
  EXPECT_DOUBLE_EQ(seconds("01:00:00"), 3600);
  EXPECT_DOUBLE_EQ(seconds("1:30"), 90);
  EXPECT_DOUBLE_EQ(seconds("-00:00:01"), -1);
  EXPECT_DOUBLE_EQ(seconds("-2.5s"), -2.5);
  EXPECT_DOUBLE_EQ(seconds("-23f"), -1);
  EXPECT_DOUBLE_EQ(seconds("0f"), -1 / 24.0);
  EXPECT_DOUBLE_EQ(seconds("26f", "rate 25"), 1);
}

TEST(Times, NtscIsExactForAnHour) {
  const Document d = read("rate 30000/1001").document;
  EXPECT_EQ(parse_time("30001f", d)->flicks, 1001 * flicks_per_second);
  EXPECT_EQ(parse_time("108001f", d)->flicks, 108000 * (flicks_per_second * 1001 / 30000));
  EXPECT_EQ(read("rate 29.97").document.rate(), (Rate{2997, 100}));
  EXPECT_EQ(format_time(*parse_time("30001f", d), d), "30001f");
}

TEST(Times, NotATime) {
  const Document d;
  for (const auto& [text, message] : std::vector<std::pair<const char*, const char*>>{
           {"", "a time is missing here"},
           {"24", "a time needs a unit"},
           {"24q", "'q' is not a unit of time"},
           {"soon", "'soon' is not a time"},
           {"nan", "'nan' is not a time"},
           {"inf", "'inf' is not a time"},
           {"1e400s", "'1e400' is too large for a number"},
           {"1e10s", "a time must be within 146 years (4.6e9 s)"},
           {"99999999999999999999f", "a time must be within 146 years (4.6e9 s)"},
           {"1:2:3:4", "a clock time must be hours:minutes:seconds"},
           {"24f 25f", "'24f 25f' is not a time"}}) {
    const auto t = parse_time(text, d);
    ASSERT_FALSE(t) << text;
    EXPECT_EQ(t.error().message, message) << text;
  }
}

TEST(Times, LengthsCountFromNothing) {
  // 12 frames of ease on either side of a second: speed 1/(1 - 1/2) = 2 in the middle, from rest to rest.
  const LoadedFilm s("create b sphere\nb.position.x\n 1f 0 linear ease-out=12f\n 25f 1 ease-in=500ms\n");
  EXPECT_NEAR(s.numbers("b.position.x", "13f")[0], 0.5, 1e-12);
  EXPECT_NEAR(s.numbers("b.position.x", "7f")[0], 0.125, 1e-12);
  const LoadedFilm moved("create b sphere\nb.position.x\n 1f 1\n 13f 2\nmove b.position.x 1f..13f by 12f\n");
  EXPECT_NEAR(moved.numbers("b.position.x", "13f")[0], 1, 1e-12);
  EXPECT_NEAR(moved.numbers("b.position.x", "25f")[0], 2, 1e-12);
}

TEST(Values, Colors) {
  const LoadedFilm s(
      "create a sphere color=gold\ncreate b sphere color=#ffcc00\ncreate c sphere color=rgb(1 0.8 0)\n"
      "create d sphere color=#fc0\ncreate e sphere color=hsv(120deg 1 0.5)\ncreate f sphere color=(0.1, 0.2, 0.3)\n"
      "create g sphere color=#FFCC00\n");
  expect_numbers(s, {{"a.color", "1f", {1, 215 / 255.0, 0}},
                     {"b.color", "1f", {1, 0.8, 0}},
                     {"c.color", "1f", {1, 0.8, 0}},
                     {"d.color", "1f", {1, 0.8, 0}},
                     {"e.color", "1f", {0, 0.5, 0}},
                     {"f.color", "1f", {0.1, 0.2, 0.3}}});
}

// shows: G24
TEST(Values, ColorsBlendInLight) {
  const LoadedFilm s("create a sphere\na.color\n 1f black\n 25f white\n");
  // Half the light is sRGB 1.055·0.5^(1/2.4) - 0.055.
  expect_numbers(s, "a.color.r", "13f", {1.055 * std::pow(0.5, 1 / 2.4) - 0.055}, 1e-9);
  const LoadedFilm numbers("create a sphere\na.color\n 1f black\n 25f white\ntwerper a.color linear in=srgb\n");
  expect_numbers(numbers, "a.color.r", "13f", {0.5});
}

// A matrix gives the rotation that has these rows.
// shows: S9
TEST(Values, RotationMatrices) {
  const LoadedFilm s(
      "create a box rotation=matrix(0 -1 0 1 0 0 0 0 1)\ncreate b box\nset b.rotation matrix(0.36 0.48 -0.8 -0.8 0.6 0 "
      "0.48 0.64 0.6)\n");
  expect_numbers(s, "a.world", "1f", {0, -1, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1});
  expect_numbers(s, "b.world", "1f", {0.36, 0.48, -0.8, 0, -0.8, 0.6, 0, 0, 0.48, 0.64, 0.6, 0, 0, 0, 0, 1});
  const auto error = [](const std::string& numbers) {
    return errors(read("create a box\nset a.rotation matrix(" + numbers + ")\n")).at(0);
  };
  EXPECT_EQ(error("2 0 0 0 1 0 0 0 1"), "2:16: column 1 of this matrix has the length 2, not 1");
  EXPECT_EQ(error("1 0.6 0 0 0.8 0 0 0 1"), "2:16: columns 1 and 2 of this matrix are not perpendicular");
  EXPECT_EQ(error("1 0 0 0 1 0 0 0 -1"), "2:16: this matrix mirrors, so it is no rotation");
  EXPECT_EQ(error("1 0 0 0 1 0 0 0").substr(0, 2), "2:");
}

// shows: G29 G70
TEST(Values, Rotations) {
  const LoadedFilm s(
      "create a box rotation=euler(0 90deg 0)\ncreate b box rotation=axis(0 1 0, 0.25turn)\n"
      "create c box rotation=quat(1 0 1 0)\ncreate d box rotation=axis(y, 1.57rad)\ncreate e box rotation=euler(0 0 "
      "0)\n"
      "create f box rotation.z=2turn\n");
  expect_numbers(s, "a.rotation", "1f", {0, pi_ / 2, 0});
  const double h = std::sqrt(0.5);
  expect_numbers(s, {{"b.rotation", "1f", {h, 0, h, 0}},
                     {"c.rotation", "1f", {h, 0, h, 0}},
                     {"d.rotation", "1f", {std::cos(0.785), 0, std::sin(0.785), 0}},
                     {"f.rotation.z", "1f", {4 * pi_}}});
  // A quarter turn about y takes x to -z.
  expect_numbers(s, {{"a.world", "1f", {0, 0, 1, 0, 0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 0, 1}},
                     {"b.world", "1f", {0, 0, 1, 0, 0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 0, 1}}});
}

TEST(Values, QuaternionsTakeTheShortWay) {
  const LoadedFilm s(
      "create a box\na.rotation\n 1f axis(z, 10deg)\n 5f quat(-0.9659258262890683 0 0 -0.25881904510252074)\n");
  const double h = 10 * pi_ / 180;  // a quarter of the way is 15°, half of it 20°
  expect_numbers(s, "a.rotation", "3f", {std::cos(h), 0, 0, std::sin(h)});
  const LoadedFilm far("create a box\na.rotation\n 1f quat(1 0 0 0)\n 5f axis(z, 170deg)\n");
  const double q = 42.5 / 2 * pi_ / 180;
  expect_numbers(far, "a.rotation", "2f", {std::cos(q), 0, 0, std::sin(q)});
}

// shows: G29
TEST(Values, UnitsBooleansTextsShapesAims) {
  const LoadedFilm s(
      "create c camera position=(1m 20cm 30mm) lens=50mm\ncreate k camera fov=50deg look-at=(1 2 3)\n"
      "create o camera height=10\ncreate b box size=(1 2 3)\ncreate s sphere radius=25cm\n"
      "create t text text=\"a \\\"b\\\"\\n\\tc\" font=\"DejaVu Sans\" size=2 depth=0.5\n"
      "create u text text=\"\"\"two\nlines \"quoted\" \"\"\"\n"
      "create sun light shines=sun intensity=2 range=60\nset b.geometry shape(s)\nset s.display off\nset c.look-at b\n"
      "create p polygon points=((0 0) (1 0) (1 1 2))\ncreate l polyline points=((0 0) (1 0)) width=0.1\n"
      "create q points points=((0 0)) size=0.2\ncreate plain plane size=(2 3)\ncreate r torus radius=2 tube=0.5\n");
  expect_numbers(s, {{"c.position", "1f", {1, 0.2, 0.03}},
                     {"c.lens", "1f", {50}},
                     {"k.fov", "1f", {50 * pi_ / 180}},
                     {"k.look-at", "1f", {1, 2, 3}},
                     {"s.radius", "1f", {0.25}}});
  EXPECT_EQ(s.text("t.text", "1f"), "a \"b\"\n\tc");
  EXPECT_EQ(s.text("u.text", "1f"), "two\nlines \"quoted\" ");
  EXPECT_EQ(s.text("sun.shines", "1f"), "sun");
  EXPECT_EQ(std::get<ObjectId>(s.read("b.geometry", "1f")), s.loaded.document.find("s"));
  EXPECT_EQ(std::get<ObjectId>(s.read("c.look-at", "1f")), s.loaded.document.find("b"));
  expect_numbers(s, "s.display", "1f", {0});
  EXPECT_EQ(*std::get<Points>(s.read("p.points", "1f")), (std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 2}}));
}

TEST(Values, TextsEndLinesTheSameWayEverywhere) {
  const LoadedFilm s("create u text text=\"\"\"two\r\nlines\"\"\"\r\n");
  EXPECT_EQ(s.text("u.text", "1f"), "two\nlines");
}

TEST(Values, CommentsCommasContinuation) {
  const LoadedFilm s(
      "# a comment\n#\ncreate b sphere position=(1, 2, 3), color=#ffcc00   # gold\n"
      "set b.pivot (1   # one\n  2\n\n  3)\nb.position  # a sheet\n  1f (0\n 0 0)\n# between rows\n\n  2f (1 1 1)  # "
      "last");
  expect_numbers(s, {{"b.pivot", "1f", {1, 2, 3}}, {"b.color", "1f", {1, 0.8, 0}}, {"b.position", "2f", {1, 1, 1}}});
}

TEST(Values, ReadBackWhatIsWritten) {
  const char* text =
      "create b box rotation=euler(90deg 1rad 0.1turn) color=hsv(0.1 0.3 0.7) size=(0.1 0.2 0.30000000000000004)\n"
      "create c camera lens=35mm look-at=(1e-300 2e300 -0)\n";
  const Document d = read(text).document;
  EXPECT_EQ(load_text(write(d), "again").document, d);
}

// Each point's number goes as a track of that number does.
TEST(Values, PointsGoByTheirTwerpers) {
  for (const char* twerper : {"smooth", "bspline", "hermite", "linear"}) {
    const LoadedFilm s(
        fmt::format("create p polyline\np.points\n  1f ((0 0 0) (1 0 0)) {0}\n  7f ((0 5 0) (1 2 0)) {0}\n"
                    "  9f ((3 1 0) (1 7 0)) {0}\n  25f ((0 0 1) (9 0 0))\n"
                    "create a sphere\na.position.y\n  1f 0 {0}\n  7f 5 {0}\n  9f 1 {0}\n  25f 0\n"
                    "create b sphere\nb.position.y\n  1f 0 {0}\n  7f 2 {0}\n  9f 7 {0}\n  25f 0\n",
                    twerper));
    for (double f = 0; f < 27; f += 0.75) {
      const std::string t = fmt::format("{}f", f);
      const auto points = *std::get<Points>(s.read("p.points", t));
      EXPECT_NEAR(points[0].y, s.numbers("a.position.y", t)[0], 1e-12) << twerper << " " << t;
      EXPECT_NEAR(points[1].y, s.numbers("b.position.y", t)[0], 1e-12) << twerper << " " << t;
    }
  }
}

}  // namespace
}  // namespace betwixt
