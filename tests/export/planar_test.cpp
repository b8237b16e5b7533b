// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Motion in the plane as curves of pages, beside the film itself; and what drawings refuse. What browsers, rlottie and
// readers of USD make of the files is asked in tests/peers.
#include "export/planar.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <random>

#include "betwixt/language.h"
#include "betwixt/pose.h"
#include "export/formats.h"

namespace betwixt {
namespace {

struct Film {
  explicit Film(const std::string& text) : loaded(load_text(text, "test.bx")) {
    EXPECT_FALSE(has_errors(loaded.diagnostics)) << to_string(loaded.diagnostics.front());
    program = Program::compile(loaded.document);
    std::tie(options.from, options.until) = loaded.document.range();
  }
  ObjectId operator[](const char* name) const { return loaded.document.find(name); }
  Loaded loaded;
  Program program;
  ExportOptions options;
};

// What a page makes of the steps: their product.
Mat4 matrix_at(const PlanarMotion& m, Time t) {
  Mat4 out;
  for (const PlanarStep& s : m.steps) {
    const double v = value_at(s.curves, t);
    const Mat4 one = s.what == PlanarStep::move_x   ? translation({v, 0, 0})
                     : s.what == PlanarStep::move_y ? translation({0, v, 0})
                     : s.what == PlanarStep::turn   ? rotation({std::cos(v / 2), 0, 0, std::sin(v / 2)})
                     : s.what == PlanarStep::grow_x ? scaling({v, 1, 1})
                                                    : scaling({1, v, 1});
    out = out * one;
  }
  return out;
}

const char* const everything =
    "film flat\nrange 1f 73f\n"
    "create ball circle\nball.position\n  1f (-5 0 0) linear\n  25f (0 3 0) bezier(0.3 1.4 0.2 1)\n  49f (5 -2 0) "
    "hold\n"
    "  61f (0 0 0) ease-in=6f\n  73f (2 2 0)\nball.scale\n  1f (1 1 1) smooth\n  40f (2 0.5 1)\n  73f (1 1 1)\n"
    "create arm group position=(1 -2 0) scale=(2 1 1)\narm.rotation.z\n  1f 0deg linear\n  37f 720deg ease-in=12f\n  "
    "73f 90deg\n"
    "create arm/tip circle position=(1.5 0 0)\narm/tip.rotation.z\n  1f 0deg back-out\n  73f -180deg\n"
    "create turner star\nat 1f..73f turner.motion R(1.5turn @ 4 0)\n";

TEST(Planar, IsWhereTheFilmIs) {
  const Film film(everything);
  const auto view = planar_view(film.program, film.options);
  ASSERT_TRUE(view);
  std::mt19937 random(5);
  for (const bool in_unit : {false, true}) {
    const auto motions = planar_motions(film.program, film.options, *view, in_unit);
    ASSERT_TRUE(motions) << motions.error().message;
    ASSERT_EQ(motions->size(), 3U) << "a group draws nothing";
    for (const PlanarMotion& m : *motions)
      for (int i = 0; i < 200; ++i) {
        const Time t{film.options.from.flicks +
                     static_cast<std::int64_t>(random() % 1000'000 * 1e-6 *
                                               static_cast<double>((film.options.until - film.options.from).flicks))};
        const Mat4 page = matrix_at(m, t), world = pose(film.program, m.id, t).world;
        for (const Vec3 p : {Vec3{}, Vec3{1, 0, 0}, Vec3{0, 1, 0}}) {
          const Vec3 off = transform_point(page, p) - transform_point(world, p);
          EXPECT_LT(std::hypot(off.x, off.y), 1e-3) << film.loaded.document.name(m.id) << ' ' << t.seconds();
        }
        if (in_unit)
          for (const PlanarStep& s : m.steps)
            for (const PlanarCurve& c : s.curves) {
              EXPECT_TRUE(c.y1 >= 0 && c.y1 <= 1 && c.y2 >= 0 && c.y2 <= 1);
            }
      }
  }
}

// A curve of CSS is itself, and a bow up and down is cut at its top.
TEST(Planar, WhatCssCanSayIsExact) {
  const Film film(
      "film flat\nrange 1f 49f\ncreate a circle\na.position\n  1f (0 0 0) bezier(0.1 0.7 0.4 1.3)\n  25f (3 1 0) "
      "ease-in-out\n"
      "  49f (5 5 0)\ncreate b circle\nb.position\n  1f (0 0 0) hermite tangent=(0 4 0)\n  49f (0 0 0) hermite "
      "tangent=(0 -4 0)\n");
  const auto motions = planar_motions(film.program, film.options, *planar_view(film.program, film.options));
  ASSERT_TRUE(motions);
  const PlanarCurves& x = (*motions)[0].steps[0].curves;
  ASSERT_EQ(x.size(), 2U);
  EXPECT_EQ((std::array{x[0].x1, x[0].y1, x[0].x2, x[0].y2}), (std::array{0.1, 0.7, 0.4, 1.3}));
  EXPECT_EQ((std::array{x[1].x1, x[1].y1, x[1].x2, x[1].y2}), (std::array{0.42, 0.0, 0.58, 1.0}));
  ASSERT_EQ((*motions)[1].steps.size(), 1U) << "it goes up and down only";
  const PlanarCurves& y = (*motions)[1].steps[0].curves;
  ASSERT_EQ(y.size(), 2U);
  EXPECT_NEAR(y[0].end, 2, 1e-3) << "halfway of 4 m/s over two seconds: 4 * 2 / 8 twice";
  EXPECT_NEAR(y[0].y2, 1, 1e-3) << "it comes to rest there";
}

TEST(Planar, RefusesWhatIsNotFlat) {
  const auto refusal = [](const std::string& text, auto make) {
    const Film film(text);
    Exported made;
    const Result<std::string> out = make(film.program, film.options, made);
    EXPECT_FALSE(out) << text;
    return out ? "" : out.error().message;
  };
  EXPECT_EQ(refusal("create b sphere\n", make_css), "the film is seen in perspective, and a drawing is flat");
  EXPECT_EQ(
      refusal("film flat\ncreate b circle\nb.rotation\n  1f euler(0 0 0) linear\n  24f euler(0 80deg 0)\n", make_css),
      "'b' turns out of the plane of the picture");
  EXPECT_EQ(refusal("film flat\ncreate b sphere\n", make_lottie), "'b' is a sphere, and not flat");
  EXPECT_EQ(refusal("film flat\ncreate b box\n", make_svg), "'b' is a box, and not flat");
  EXPECT_EQ(refusal("film flat\ncreate b circle\nb.radius\n  1f 1 linear\n  24f 2\n", make_lottie),
            "the shape of 'b' changes");
  EXPECT_EQ(
      refusal(
          "film flat\ncreate eye camera height=9\ncreate b circle\neye.position\n  1f (0 0 9) linear\n  24f (2 0 9)\n",
          make_lottie),
      "the camera moves, and a drawing is seen from one place");
  EXPECT_EQ(refusal("film flat\n", make_css), "nothing is drawn in the film");
}

TEST(Planar, NamesAreWordsOfOtherLanguages) {
  const Film film("create car group\ncreate car/wheel circle\ncreate car-wheel circle\n");
  EXPECT_EQ(plain_names(film.loaded.document, {film["car"], film["car/wheel"], film["car-wheel"]}),
            (std::vector<std::string>{"car", "car-wheel", "car-wheel-2"}));
  EXPECT_EQ(short_number(-0.00000001), "0");
  EXPECT_EQ(short_number(12.5), "12.5");
  EXPECT_EQ(short_number(1e-3 / 3), "0.0003333");
}

TEST(Lottie, SaysItsFilm) {
  const Film film(
      "film flat\nsize 640x360\nrange 1f 25f\nrate 24\ncreate a circle radius=0.5 color=red position=(1 1 0)\n"
      "create b rectangle size=(2 1) position=(0 0 1)\nat 13f hide b\n");
  Exported made;
  const auto text = make_lottie(film.program, film.options, made);
  ASSERT_TRUE(text) << text.error().message;
  const auto json = nlohmann::json::parse(*text);
  EXPECT_EQ(json["w"], 640);
  EXPECT_EQ(json["op"], 25.0);
  EXPECT_EQ(json["layers"][0]["nm"], "b") << "what is in front stands first";
  EXPECT_EQ(json["layers"][1]["ks"]["p"]["x"]["k"], 320.0 + 40);
  EXPECT_EQ(json["layers"][1]["ks"]["p"]["y"]["k"], 180.0 - 40);
  const auto& opacity = json["layers"][0]["ks"]["o"]["k"];
  EXPECT_EQ(opacity[0]["s"][0], 100);
  EXPECT_EQ(opacity.back()["s"][0], 0);
}

TEST(Usda, SaysItsFilm) {
  const Film film(
      "rate 24\nrange 1f 25f\ncreate car-1 group\ncreate car-1/wheel sphere radius=2\ncar-1.position\n"
      "  1f (0 0 0) linear\n  13f (6 0 0) hold\n  25f (0 0 0)\n");
  Exported made;
  const auto text = make_usda(film.program, film.options, made);
  ASSERT_TRUE(text) << text.error().message;
  for (const char* part : {"#usda 1.0", "timeCodesPerSecond = 24", "endTimeCode = 24", "def Xform \"car_1\"",
                           "def Xform \"wheel\"", "custom string betwixt:name = \"car-1/wheel\"", "12: (6, 0, 0),",
                           "23.999999: (6, 0, 0),", "24: (0, 0, 0),", "float3 xformOp:scale = (2, 2, 2)"})
    EXPECT_NE(text->find(part), std::string::npos) << part;
}

}  // namespace
}  // namespace betwixt
