// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Compares exported motion in the plane (CSS, SVG and Lottie) with the film, and tests what these formats refuse.
// tests/peers checks the files with browsers, rlottie and readers of USD.
#include "export/planar.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <random>
#include <set>
#include <sstream>

#include "betwixt/language.h"
#include "betwixt/pose.h"
#include "export/formats.h"
#include "export/planar_look.h"
#include "export/planar_order.h"
#include "scene/functions.h"

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
    const auto motions = planar_motions(film.program, film.options, in_unit);
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
  const auto motions = planar_motions(film.program, film.options);
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
  EXPECT_EQ(refusal("create b sphere\n", make_css), "the camera has perspective, but a drawing is flat");
  EXPECT_EQ(
      refusal("film flat\ncreate b circle\nb.rotation\n  1f euler(0 0 0) linear\n  24f euler(0 80deg 0)\n", make_css),
      "'b' rotates out of the plane of the picture");
  EXPECT_EQ(refusal("film flat\ncreate b torus\n", make_lottie), "'b' is a torus, which is not flat");
  EXPECT_EQ(refusal("film flat\ncreate b torus\n", make_svg), "'b' is a torus, which is not flat");
  EXPECT_EQ(
      refusal("film flat\ncreate eye camera height=9 position=(9 0 9) look-at=(0 0 0)\ncreate b circle\n", make_lottie),
      "the camera does not look along -z, but a drawing is in the plane of x and y");
  EXPECT_EQ(refusal("film flat\n", make_css), "the film has no visible objects");
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

// ---- What changes its looks

std::vector<DrawnPart> parts_at(const PlanarForms& forms, Time t) {
  std::size_t i = 0;
  while (i + 1 < forms.size() && forms[i + 1].from <= t) ++i;
  std::vector<DrawnPart> out = forms[i].parts;
  if (!forms[i].goes_on || i + 1 == forms.size()) return out;
  const double s = (t - forms[i].from).seconds() / (forms[i + 1].from - forms[i].from).seconds();
  for (std::size_t k = 0; k < out.size(); ++k)
    for (std::size_t n = 0; n < out[k].points.size(); ++n)
      out[k].points[n] = (1 - s) * out[k].points[n] + s * forms[i + 1].parts[k].points[n];
  return out;
}
Box box_of(const std::vector<DrawnPart>& parts) {
  Box all;
  for (const DrawnPart& part : parts)
    for (const Vec3 p : part.points) all.add(p);
  return all;
}
struct Drawn : Film {
  explicit Drawn(const std::string& text) : Film(text), drawn(planar_film(program, options, made)) {
    EXPECT_TRUE(drawn) << drawn.error().message;
  }
  const PlanarThing& of(const char* name) const {
    return *std::find_if(drawn->things.begin(), drawn->things.end(),
                         [&](const PlanarThing& t) { return t.motion.id == (*this)[name]; });
  }
  Exported made;
  Result<PlanarFilm> drawn;
};

TEST(PlanarLook, OutlinesAreThoseOfEachFrame) {
  const Drawn film(
      "film flat\nrange 1f 73f\ncreate box rectangle size=(1 1)\nbox.size\n  1f (1 1) smooth\n  30f (3 2) hold\n"
      "  50f (2 0.5) ease-in-out\n  73f (1 4)\ncreate disc circle\nat 1f disc.radius 1 linear\nat 73f disc.radius 3\n");
  ASSERT_EQ(film.drawn->things.size(), 2U);
  EXPECT_EQ(film.of("disc").look.filled.size(), 2U) << "what grows evenly is two outlines";
  EXPECT_LT(film.of("box").look.filled.size(), 60U);
  for (int f = 1; f <= 73; ++f) {
    const Time t = film.loaded.document.rate().frame(f);
    const auto size = std::get<Vec3>(film.program.read({film["box"], *find_built_in(Kind::rectangle, "size")}, t));
    const Box box = box_of(parts_at(film.of("box").look.filled, t)),
              disc = box_of(parts_at(film.of("disc").look.filled, t));
    EXPECT_NEAR(box.high.x, size.x / 2, 2e-4) << f;
    EXPECT_NEAR(box.high.y, size.y / 2, 2e-4) << f;
    EXPECT_NEAR(disc.high.x, 1 + 2 * (f - 1) / 72.0, 2e-4) << f;
  }
}

TEST(PlanarLook, TrimsAreTheCurvesOfTheFilm) {
  const Drawn film(
      "film flat\nrange 1f 49f\ncreate way line to=(4 0 0)\nway.trim\n  1f (0 0) ease-in-out\n  25f (0 1) linear\n"
      "  49f (0.5 1)\n");
  const auto& trim = film.of("way").look.trim;
  ASSERT_TRUE(trim);
  EXPECT_EQ(film.of("way").look.stroked.size(), 1U) << "the line itself stays as it is";
  const FunctionId f = *find_built_in(Kind::line, "trim");
  for (double s = 0; s <= 2; s += 0.037) {
    const auto n = numbers(film.program.read({film["way"], f}, from_seconds(s)));
    EXPECT_NEAR(value_at(trim->from, from_seconds(s)), n[0], 1e-3) << s;
    EXPECT_NEAR(value_at(trim->to, from_seconds(s)), n[1], 1e-3) << s;
  }
}

TEST(PlanarLook, ALineThatIsDrawnOnIsOneLine) {
  const Drawn film(
      "film flat\nrange 1f 73f\ncreate paper group\nat 1f..73f paper.motion T(6 0)\ncreate pen circle radius=0.1\n"
      "at 1f..73f pen.motion R(1turn @ 2 0)\ncreate wave trace of=pen within=paper\ncreate tail trace of=pen "
      "last=1s\n");
  for (const char* name : {"wave", "tail"}) {
    const PlanarLook& look = film.of(name).look;
    ASSERT_EQ(look.stroked.size(), 1U) << name;
    ASSERT_TRUE(look.trim) << name;
    EXPECT_NEAR(value_at(look.trim->to, film.options.until), 1, 1e-6) << name;
  }
  // A second of three, of a circle that is gone round once.
  const PlanarTrim& tail = *film.of("tail").look.trim;
  EXPECT_NEAR(value_at(tail.to, film.options.until) - value_at(tail.from, film.options.until), 1.0 / 3, 2e-3);
  EXPECT_NEAR(value_at(tail.from, from_seconds(0.5)), 0, 1e-3);
  // The pen is where the line ends, on its paper.
  const PlanarThing& wave = film.of("wave");
  const Time end = film.options.until;
  const Vec3 tip = transform_point(matrix_at(wave.motion, end), wave.look.stroked[0].parts[0].points.back());
  const Vec3 pen = translation_of(pose(film.program, film["pen"], end).world);
  EXPECT_LT(std::hypot(tip.x - pen.x, tip.y - pen.y), 1e-3);
}

TEST(PlanarLook, CardsThatTurnAreSeenAsTheyAre) {
  const Drawn film(
      "film flat\nrange 1f 49f\ncreate card rectangle size=(2 1)\nat 1f card.rotation.y 0deg linear\n"
      "at 49f card.rotation.y 180deg\n");
  EXPECT_TRUE(film.of("card").motion.steps.empty());
  for (int f = 1; f <= 49; ++f) {
    const Time t = film.loaded.document.rate().frame(f);
    EXPECT_NEAR(box_of(parts_at(film.of("card").look.filled, t)).high.x, std::abs(std::cos(pi * (f - 1) / 48)), 5e-4)
        << f;
  }
}

TEST(PlanarLook, CamerasMoveGrowAndRoll) {
  const Drawn film(
      "film flat\nrange 1f 49f\ncreate eye camera height=9\neye.position\n  1f (0 0 9) smooth\n  49f (2 1 9)\n"
      "eye.height\n  1f 9 linear\n  49f 3\nat 1f eye.rotation.z 0deg linear\nat 49f eye.rotation.z 400deg\n"
      "look through eye\ncreate b circle position=(1 2 0)\n");
  for (int i = 0; i <= 48; ++i) {
    const Time t = film.loaded.document.rate().frame(1 + i);
    const Camera c = film.program.frame(t).camera;
    const Vec3 seen = transform_point(*inverse(c.world), {1, 2, 0});
    const Vec3 page = transform_point(matrix_at({{}, film.drawn->view.steps}, t), {1, 2, 0});
    EXPECT_LT(std::hypot(page.x - 9 / c.height * seen.x, page.y - 9 / c.height * seen.y), 2e-3) << i;
  }
}

TEST(PlanarLook, LeavesOutWhatIsNoDrawingByName) {
  const Drawn film("film flat\ncreate a circle\ncreate hoop torus\ncreate ball sphere radius=2\n");
  EXPECT_EQ(film.made.left_out, std::vector<std::string>{"left out, as a torus is not flat: 'hoop'"});
  ASSERT_EQ(film.drawn->things.size(), 2U);
  EXPECT_NEAR(box_of(film.of("ball").look.filled[0].parts).high.y, 2, 0.01) << "a ball is a disc from the front";
}

TEST(PlanarLook, DataAreDiscs) {
  const Drawn film(
      "film flat\ncreate ax axes x=(0 10) y=(0 10) size=(5 5) bare=on\ncreate s scatter on=ax of=((5 5) (10 10)) "
      "size=1\ncreate l line-chart on=ax of=((0 0) (10 10))\n");
  EXPECT_TRUE(film.made.left_out.empty()) << film.made.left_out[0];
  const Box data = box_of(film.of("s").look.filled[0].parts), dot = box_of(film.of("l/1").look.filled[0].parts);
  EXPECT_NEAR(data.high.y, 3, 0.01);
  EXPECT_NEAR(data.low.y, -0.5, 0.01);
  EXPECT_NEAR(dot.high.y, 0.08, 0.001);
}

// At each time every thing that is seen is drawn once, the farthest first.
TEST(PlanarOrder, ThingsThatPassEachOtherAreInOrderAtEachTime) {
  std::mt19937 random(11);
  for (int round = 0; round < 200; ++round) {
    std::vector<PlanarDepths> all(2 + random() % 6);
    for (PlanarDepths& d : all)
      for (int t = 0; t < 10; ++t)
        if (t == 0 || random() % 3 == 0)
          put(d, Time{t}, random() % 5 == 0 ? std::nullopt : std::optional(static_cast<double>(random() % 4)));
    bool whole = false;
    const auto stack = stack_of(all, Time{10}, whole);
    for (int t = 0; t < 10 && whole; ++t) {
      std::vector<std::pair<double, std::size_t>> wanted, got;
      const auto depth = [&](std::size_t thing) {
        std::optional<double> now;
        for (const auto& [at, d] : all[thing])
          if (at.flicks <= t) now = d;
        return now;
      };
      for (std::size_t i = 0; i < all.size(); ++i)
        if (const auto d = depth(i)) wanted.emplace_back(*d, i);
      std::stable_sort(wanted.begin(), wanted.end());
      for (const StackPlace& p : stack) {
        const bool there = p.spans.empty() || std::any_of(p.spans.begin(), p.spans.end(), [&](const auto& s) {
                             return s.first.flicks <= t && t < s.second.flicks;
                           });
        if (const auto d = depth(p.thing); d && there) got.emplace_back(*d, p.thing);
      }
      EXPECT_EQ(got, wanted) << round << ' ' << t;
    }
  }
  bool whole = false;
  EXPECT_EQ(stack_of({{{Time{}, 1.0}}, {{Time{}, 0.0}}}, Time{10}, whole).size(), 2U);
}

const char* const changing =
    "film flat\nsize 640x360\nrange 1f 49f\nrate 24\ncreate a text text=\"1\"\nset a.text = \"string.format('%.0f', 8 "
    "+ 2 * t)\"\n"
    "create b polygon points=((0 1) (-1 -1) (1 -1))\nb.points\n  1f ((0 1) (-1 -1) (1 -1)) linear\n"
    "  49f ((-1 1) (-1 -1) (1 -1) (1 1))\ncreate c circle fill=off stroke=red stroke-width=0.1\n"
    "c.trim\n  1f (0 0) smooth\n  49f (0 1)\n";

TEST(Lottie, OutlinesHaveAsManyPointsInAllKeys) {
  const Film film(changing);
  Exported made;
  const auto text = make_lottie(film.program, film.options, made);
  ASSERT_TRUE(text) << text.error().message;
  std::size_t animated = 0, trims = 0;
  const std::function<void(const nlohmann::json&)> visit = [&](const nlohmann::json& j) {
    if (j.is_object() && j.value("ty", nlohmann::json()) == "tm") {
      ++trims;
      EXPECT_EQ(j["s"]["k"], 0);
      EXPECT_EQ(j["e"]["k"].front()["s"][0], 0);
      EXPECT_NEAR(j["e"]["k"].back()["s"][0].get<double>(), 100, 1e-9);
    }
    if (j.is_object() && j.value("ty", nlohmann::json()) == "sh" && j["ks"]["a"] == 1) {
      ++animated;
      double before = -1;
      for (const auto& k : j["ks"]["k"]) {
        EXPECT_EQ(k["s"][0]["v"].size(), j["ks"]["k"][0]["s"][0]["v"].size());
        EXPECT_EQ(k["s"][0]["i"].size(), k["s"][0]["v"].size());
        EXPECT_GT(k["t"].get<double>(), before);
        before = k["t"];
      }
    }
    if (j.is_structured())
      for (const auto& inner : j) visit(inner);
  };
  visit(nlohmann::json::parse(*text));
  EXPECT_GE(animated, 3U);
  EXPECT_EQ(trims, 1U);
}

// SVG 1.1, 19.2.6: as many values as times, from 0 to 1, none before the one before; and between two times outlines of
// the same commands.
TEST(Svg, KeyTimesAndOutlinesFit) {
  const Film film(changing);
  Exported made;
  const auto text = make_svg(film.program, film.options, made);
  ASSERT_TRUE(text) << text.error().message;
  const auto word = [](const std::string& element, const std::string& name) {
    const std::size_t at = element.find(" " + name + "=\"");
    if (at == std::string::npos) return std::string();
    const std::size_t begin = at + name.size() + 3;
    return element.substr(begin, element.find('"', begin) - begin);
  };
  const auto split = [](const std::string& list) {
    std::vector<std::string> out;
    std::istringstream in(list);
    for (std::string one; std::getline(in, one, ';');) out.push_back(one);
    return out;
  };
  std::set<std::string> attributes;
  for (std::size_t at = text->find("<animate"); at != std::string::npos; at = text->find("<animate", at + 1)) {
    const std::string element = text->substr(at, text->find("/>", at) - at), name = word(element, "attributeName");
    attributes.insert(name);
    const auto times = split(word(element, "keyTimes")), values = split(word(element, "values"));
    ASSERT_EQ(times.size(), values.size()) << name;
    EXPECT_EQ(times.front(), "0") << name;
    if (word(element, "calcMode") != "discrete") {
      EXPECT_EQ(times.back(), "1") << name;
    }
    for (std::size_t i = 1; i < times.size(); ++i) {
      EXPECT_LE(std::stod(times[i - 1]), std::stod(times[i])) << name;
      if (name != "d" || word(element, "calcMode") == "discrete" || times[i - 1] == times[i]) continue;
      const auto commands = [](std::string d) {
        std::erase_if(d, [](char c) { return std::isalpha(static_cast<unsigned char>(c)) == 0; });
        return d;
      };
      EXPECT_EQ(commands(values[i - 1]), commands(values[i]));
    }
  }
  EXPECT_TRUE(attributes.contains("d") && attributes.contains("stroke-dasharray"));
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

// Four metres by two, of 120 pixels a metre. Colours are those of mixed light, and the place of each is in the file.
TEST(Planar, GradientsAreThoseOfTheFilm) {
  const Film film(
      "film flat\nsize 1920x1080\ncreate card rectangle size=(4 2) position=(1 0.5) "
      "color=#ff6600 gradient=linear gradient-turn=90deg "
      "gradient-color=#000080\ncreate sun circle radius=0.5 color=white gradient=radial stroke=red "
      "stroke-gradient=conic\ncreate way line gradient=linear gradient-stops=\"gold, transparent\"\n");
  const auto light = [](int byte) {
    const double s = byte / 255.0;
    return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
  };
  const auto byte = [](double l) { return 255 * (l <= 0.0031308 ? 12.92 * l : 1.055 * std::pow(l, 1 / 2.4) - 0.055); };
  Exported made;
  const auto svg = make_svg(film.program, film.options, made);
  ASSERT_TRUE(svg) << svg.error().message;
  EXPECT_NE(svg->find("<linearGradient id=\".card.fill\" gradientUnits=\"userSpaceOnUse\" x1=\"0\" y1=\"120\" x2=\"0\" "
                      "y2=\"-120\">"),
            std::string::npos);
  EXPECT_NE(svg->find("fill=\"url(#.card.fill)\""), std::string::npos);
  EXPECT_NE(svg->find("cx=\"0\" cy=\"0\" r=\"1\" gradientTransform=\"translate(0 0) scale(60 60)\">"),
            std::string::npos);
  EXPECT_NE(svg->find("stroke=\"url(#.way.stroke)\""), std::string::npos);
  EXPECT_NE(svg->find("stop-opacity=\"0\""), std::string::npos);
  std::istringstream lines(svg->substr(svg->find(".card.fill")));
  int stops = 0;
  for (std::string line; std::getline(lines, line) && line.find("</linear") == std::string::npos;) {
    double at = 0;
    unsigned rgb = 0;
    if (std::sscanf(line.c_str(), " <stop offset=\"%lf\" stop-color=\"#%6x\"", &at, &rgb) != 2) continue;
    ++stops;
    const int from[] = {0xff, 0x66, 0}, to[] = {0, 0, 0x80};
    for (int k = 0; k < 3; ++k)
      EXPECT_NEAR(rgb >> (16 - 8 * k) & 255, byte((1 - at) * light(from[k]) + at * light(to[k])), 0.6) << at;
  }
  EXPECT_GT(stops, 8);
  EXPECT_TRUE(std::any_of(made.left_out.begin(), made.left_out.end(), [](const std::string& s) {
    return s.starts_with("left out: conic gradients") && s.find("'sun'") != std::string::npos;
  }));
  Exported as_lottie;
  const auto lottie = make_lottie(film.program, film.options, as_lottie);
  ASSERT_TRUE(lottie);
  const auto file = nlohmann::json::parse(*lottie);
  nlohmann::json fill;
  for (const auto& layer : file["layers"])
    if (layer["nm"] == "card") fill = layer["shapes"][0]["it"][1];
  ASSERT_EQ(fill["ty"], "gf");
  EXPECT_EQ(fill["t"], 1);
  EXPECT_EQ(fill["s"]["k"], (nlohmann::json{0.0, 120.0}));
  EXPECT_EQ(fill["e"]["k"], (nlohmann::json{0.0, -120.0}));
  const std::size_t count = fill["g"]["p"];
  EXPECT_EQ(fill["g"]["k"]["k"].size(), 6 * count);  // place, three colours; place, opacity
  EXPECT_NEAR(fill["g"]["k"]["k"][1].get<double>(), 1, 1e-3);
}

TEST(Svg, GroupsAreWrittenAsAWhole) {
  const Film film(
      "film flat\nsize 1920x1080\nrange 1f 25f\nrate 24\ncreate wall circle\ncreate slide group blend=screen "
      "drop-shadow=(0.5 -0.25 0.1)\ncreate card rectangle\nattach card to slide\ncreate inner group blur=0.2\n"
      "attach inner to slide\ncreate dot circle\nattach dot to inner\ncreate hole circle\nset slide.mask hole\n"
      "create a group\ncreate b group\ncreate in-a circle\nattach in-a to a\ncreate in-b circle\nattach in-b to b\n"
      "set a.mask b\nset b.mask a\nslide.opacity\n  1f 0 linear\n  25f 1\n");
  Exported made;
  const auto svg = make_svg(film.program, film.options, made);
  ASSERT_TRUE(svg) << svg.error().message;
  const auto at = [&](const std::string& what, std::size_t from = 0) {
    const std::size_t found = svg->find(what, from);
    EXPECT_NE(found, std::string::npos) << what << '\n' << *svg;
    return found;
  };
  // The picture first; then the group, its own objects, and the group within. 120 pixels are a metre.
  const std::size_t wall = at("<g id=\"wall\""), slide = at("<g id=\"slide\" opacity=\"0\"");
  EXPECT_LT(wall, slide);
  const std::size_t card = at("<g id=\"card\"", slide), inner = at("<g id=\"inner\"", card);
  EXPECT_LT(inner, at("<g id=\"dot\"", inner));
  at("mix-blend-mode:screen");
  at("<feDropShadow in=\"SourceGraphic\" result=\"shadowed\" dx=\"60\" dy=\"30\" stdDeviation=\"12\"");
  at("<feGaussianBlur result=\"blurred\" stdDeviation=\"24\">");
  at("<animate attributeName=\"opacity\"", slide);
  // The mask is in its definition only.
  const std::size_t mask = at("<mask id=\".slide.mask\"");
  EXPECT_GT(at("<g id=\"hole"), mask);
  EXPECT_LT(svg->rfind("<g id=\"hole"), slide);
  EXPECT_TRUE(std::none_of(made.left_out.begin(), made.left_out.end(),
                           [](const std::string& s) { return s.find("of groups") != std::string::npos; }));
  Exported other;
  ASSERT_TRUE(make_lottie(film.program, film.options, other));
  EXPECT_TRUE(std::any_of(other.left_out.begin(), other.left_out.end(),
                          [](const std::string& s) { return s.ends_with("shadow of groups are left out"); }));
}

}  // namespace
}  // namespace betwixt
