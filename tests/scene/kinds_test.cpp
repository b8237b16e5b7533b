// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "scene/kinds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

#include "scene/document.h"
#include "scene/topology.h"

namespace betwixt {
namespace {

Shape shape_of(Kind kind) {
  Shape s;
  s.kind = kind;
  s.size = {3, 2, 5}, s.radius = 1.5, s.height = 4, s.tube = 0.25, s.width = 0.5;
  s.points = std::vector<Vec3>{{0, 0, 0}, {2, 1, 0}, {1, 3, -1}};
  if (kind == Kind::plane) s.size.z = 1;
  if (kind == Kind::surface) s.points = std::vector<Vec3>{{0, 0, 0}, {2, 1, 0}, {0, 3, -1}, {2, 3, 1}};  // two by two
  return s;
}

// The points that its triangles have, in object space.
std::vector<Vec3> corners(const Shape& s) {
  const KindRow& row = row_of(s.kind);
  const Vec3 by = row.measures ? row.measures(s) : Vec3{1, 1, 1};
  std::vector<Vec3> points;
  for (const auto& p : row.mesh(s, {96}).positions) points.push_back(by * widen(p));
  return points;
}

TEST(Kinds, EachHasOneRowWithItsWords) {
  std::set<Kind> seen;
  std::set<std::string_view> names;
  for (const KindRow& row : kinds()) {
    EXPECT_TRUE(seen.insert(row.kind).second) << row.name;
    EXPECT_TRUE(names.insert(row.name).second) << row.name;
    EXPECT_EQ(find_kind(row.name), row.kind);
    EXPECT_EQ(&row_of(row.kind), &row);
    EXPECT_FALSE(row.sentence.empty()) << row.name;
    EXPECT_EQ(row.example.empty(), !row.placed) << row.name;  // the others have commands of their own
  }
  for (int k = 0; k <= static_cast<int>(Kind::sound); ++k) EXPECT_TRUE(seen.count(static_cast<Kind>(k))) << k;
  EXPECT_EQ(find_kind("blob"), std::nullopt);
  EXPECT_EQ(a_kind(Kind::sphere), "a sphere");
  EXPECT_EQ(a_kind(Kind::environment), "an environment");
}

TEST(Kinds, WhatIsDrawnHasAnExtentAndTriangles) {
  for (const KindRow& row : kinds()) {
    EXPECT_EQ(drawable(row.kind), row.fill != Fill::nothing) << row.name;
    EXPECT_EQ(row.extent != nullptr, drawable(row.kind)) << row.name;
    EXPECT_EQ(row.mesh != nullptr, row.fill == Fill::surface) << row.name;
    EXPECT_TRUE(row.placed || !drawable(row.kind)) << row.name;
  }
}

TEST(Kinds, ExtentsHoldTheTrianglesClosely) {
  for (const KindRow& row : kinds()) {
    if (row.fill != Fill::surface) continue;
    const Shape s = shape_of(row.kind);
    const Extent e = extent(s);
    Vec3 low = e.high, high = e.low;
    for (const Vec3 p : corners(s))
      for (int i = 0; i < 3; ++i) low[i] = std::min(low[i], p[i]), high[i] = std::max(high[i], p[i]);
    for (int i = 0; i < 3; ++i) {
      EXPECT_NEAR(low[i], e.low[i], 0.02) << row.name << i;
      EXPECT_NEAR(high[i], e.high[i], 0.02) << row.name << i;
      EXPECT_GE(low[i], e.low[i] - 1e-6) << row.name << i;
      EXPECT_LE(high[i], e.high[i] + 1e-6) << row.name << i;
    }
  }
}

TEST(Kinds, RoundOnesReachAsFarAsTheirTriangles) {
  std::mt19937 chance(7);
  std::uniform_real_distribution<double> any(-2, 2);
  for (const KindRow& row : kinds()) {
    if (!row.reach) continue;
    const Shape s = shape_of(row.kind);
    const auto points = corners(s);
    for (int n = 0; n < 50; ++n) {
      const Vec3 r{any(chance), any(chance), any(chance)};
      double farthest = 0;
      for (const Vec3 p : points) farthest = std::max(farthest, dot(r, p));
      EXPECT_NEAR(row.reach(s, r), farthest, 0.005 * row.reach(s, r)) << row.name;
      EXPECT_GE(row.reach(s, r), farthest - 1e-6) << row.name;
    }
  }
}

// Every word of a row's shared functions is one, and no row that is not shared is named.
TEST(Functions, SharedOnesAreNamedByTheirKinds) {
  std::set<std::string> shared;
  for (const KindRow& row : kinds()) {
    std::string words(row.functions);
    for (std::size_t at = 0; at < words.size();) {
      const std::string word = words.substr(at, words.find(' ', at) - at);
      EXPECT_TRUE(find_built_in(row.kind, word)) << row.name << ' ' << word;
      shared.insert(word);
      at += word.size() + 1;
    }
  }
  EXPECT_EQ(shared, (std::set<std::string>{"radius", "height", "points"}));
}

// What each kind can be told, as the language's page lists it, beside what all have.
TEST(Functions, KindsHaveTheirs) {
  const std::vector<std::pair<Kind, std::set<std::string>>> own{
      {Kind::group,
       {"opacity", "blend", "mask", "blur", "glow", "glow-size", "drop-shadow", "shadow-color", "shadow-opacity"}},
      {Kind::sphere, {"radius"}},
      {Kind::box, {"size", "corner"}},
      {Kind::cylinder, {"radius", "height"}},
      {Kind::cone, {"radius", "height"}},
      {Kind::torus, {"radius", "tube"}},
      {Kind::plane, {"size"}},
      {Kind::polyline, {"points", "width", "dash", "trim"}},
      {Kind::line, {"to", "width", "dash", "trim"}},
      {Kind::points, {"points", "size"}},
      {Kind::mesh, {"file", "joints"}},
      {Kind::sound, {"file", "words", "at", "from", "until", "gain", "fade-in", "fade-out"}},
      {Kind::light, {"range", "intensity", "shines", "shadow", "shape", "size", "cone", "cone-edge", "picture"}},
      {Kind::camera, {"lens", "fov", "height", "roll", "shutter", "f-stop", "focus"}},
      {Kind::curve, {"points", "width", "smooth", "closed", "dash", "trim"}},
      {Kind::trace, {"of", "within", "point", "from", "until", "last", "width", "dash", "trim"}}},
      flat{{Kind::disc, {"radius"}},
           {Kind::polygon, {"points", "holes"}},
           {Kind::text, {"text", "tex", "part", "font", "size", "align", "weight", "slant", "typed", "wrap", "anchor"}},
           {Kind::rectangle, {"size", "corner"}},
           {Kind::video, {"file", "height", "corner", "at", "from", "until", "speed", "loop", "time"}},
           {Kind::ring, {"radius", "inner"}},
           {Kind::arc, {"radius", "from", "to", "width", "value", "room"}},
           {Kind::regular, {"sides", "radius"}},
           {Kind::star, {"points", "radius", "inner"}},
           {Kind::gear, {"teeth", "module", "inner"}},
           {Kind::arrow, {"to", "width"}}};
  const Scene s;
  // What all have is what groups and cameras have.
  const auto of_groups = function_names(s, Kind::group), of_cameras = function_names(s, Kind::camera);
  std::set<std::string> common;
  for (const auto name : of_groups)
    if (std::find(of_cameras.begin(), of_cameras.end(), name) != of_cameras.end()) common.emplace(name);
  EXPECT_EQ(common.size(), 30U);
  const std::set<std::string> finishes{
      "metalness",           "roughness",       "emission",           "emission-strength", "clearcoat",
      "clearcoat-roughness", "sheen",           "sheen-roughness",    "transmission",      "ior",
      "thickness",           "normal-strength", "normal-map",         "roughness-map",     "metalness-map",
      "occlusion-map",       "emission-map",    "texture-projection", "texture-tile",      "texture-move",
      "texture-turn"};
  const std::set<std::string> times{"texture-at",    "texture-from", "texture-until",
                                    "texture-speed", "texture-loop", "texture-time"};
  std::set<std::string> gradients;
  for (const std::string before : {"", "stroke-"})
    for (const char* after : {"", "-color", "-stops", "-turn", "-move", "-size", "-spread"})
      gradients.insert(before + "gradient" + after);
  const std::set<std::string> outlines{"depth", "fill", "stroke", "stroke-width", "stroke-round", "dash", "trim"};
  for (const bool is_flat : {false, true})
    for (const auto& [kind, names] : is_flat ? flat : own) {
      std::set<std::string> all(common.begin(), common.end());
      all.insert(names.begin(), names.end());
      if (is_flat) all.insert(outlines.begin(), outlines.end());
      if (drawable(kind)) all.insert(finishes.begin(), finishes.end());
      for (const std::string& name : gradients)
        if (drawable(kind) && (is_flat || !name.starts_with("stroke"))) all.insert(name);
      if (drawable(kind) && kind != Kind::video) all.insert(times.begin(), times.end());
      const auto has = function_names(s, kind);
      EXPECT_EQ(std::set<std::string>(has.begin(), has.end()), all) << name_of(kind);
    }
  EXPECT_EQ(function_names(s, Kind::layer), (std::vector<std::string_view>{"weight", "mode"}));
  EXPECT_TRUE(function_names(s, Kind::environment).empty());
}

TEST(Functions, NamesTheProgramUsesAreThoseOfTheRows) {
  const std::vector<std::pair<FunctionId, std::string>> some{{fn::position, "position"},
                                                             {fn::rotation, "rotation"},
                                                             {fn::attach_position, "attach-position"},
                                                             {fn::color, "color"},
                                                             {fn::geometry, "geometry"},
                                                             {fn::display, "display"},
                                                             {fn::material, "material"},
                                                             {fn::texture, "texture"},
                                                             {fn::radius, "radius"},
                                                             {fn::box_size, "size"},
                                                             {fn::point_size, "size"},
                                                             {fn::height, "height"},
                                                             {fn::points, "points"},
                                                             {fn::text, "text"},
                                                             {fn::font, "font"},
                                                             {fn::file, "file"},
                                                             {fn::range, "range"},
                                                             {fn::shines, "shines"},
                                                             {fn::fov, "fov"},
                                                             {fn::camera_height, "height"},
                                                             {fn::look_at, "look-at"},
                                                             {fn::attachment, "attachment"},
                                                             {fn::weight, "weight"},
                                                             {fn::mode, "mode"},
                                                             {fn::environments, "environments"},
                                                             {fn::drive, "drive"},
                                                             {fn::transform, "transform"},
                                                             {fn::motion, "motion"},
                                                             {fn::casts, "shadow"},
                                                             {fn::casting, "shadow"}};
  for (const auto& [id, name] : some) EXPECT_EQ(built_in_functions()[id].name, name);
  EXPECT_GE(built_in_functions().size(), std::size_t{fn::count});
}

// One row says it for all of a name; where a value can be written, the row says how.
TEST(Functions, EachIsExplainedForItsKinds) {
  std::set<std::pair<std::string, std::string_view>> explained;
  for (const FunctionSpec& f : built_in_functions()) {
    ASSERT_FALSE(f.sentence.empty()) << f.name;
    EXPECT_EQ(f.sentence.back(), '.') << f.name;
    EXPECT_TRUE(explained.insert({f.name, f.sentence}).second) << f.name << " of other kinds has the same sentence";
  }
}

}  // namespace
}  // namespace betwixt
