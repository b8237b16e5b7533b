// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// A .glb, read back by the specification of glTF 2.0, must have the motion of the film. tests/peers checks the files
// with three.js, Blender and the validator.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <numeric>
#include <random>

#include "betwixt/export.h"
#include "betwixt/language.h"
#include "betwixt/pose.h"
#include "scene/materials.h"
#include "scene/patterns.h"
#include "support/folder.h"

namespace betwixt {
namespace gltf_test {

using Json = nlohmann::json;
using Numbers = std::vector<double>;

std::uint32_t word(const std::string& bytes, std::size_t at) {
  std::uint32_t w = 0;
  std::memcpy(&w, bytes.data() + at, sizeof w);
  return w;
}

// The container: 12 bytes of head, then chunks of JSON and of bytes, each a multiple of four long.
struct Glb {
  explicit Glb(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    const std::string all{std::istreambuf_iterator<char>(in), {}};
    EXPECT_EQ(all.substr(0, 4), "glTF");
    EXPECT_EQ(word(all, 4), 2u);
    EXPECT_EQ(word(all, 8), all.size());
    const std::size_t text = word(all, 12);
    EXPECT_EQ(word(all, 16), 0x4E4F534Au);  // "JSON"
    EXPECT_EQ(text % 4, 0u);
    json = Json::parse(all.substr(20, text));
    EXPECT_EQ(word(all, 24 + text), 0x004E4942u);  // "BIN"
    EXPECT_EQ(28 + text + word(all, 20 + text), all.size());
    bytes = all.substr(28 + text);
  }

  // The floats of an accessor, `width` for each element.
  std::vector<Numbers> floats(int accessor) const {
    static const std::map<std::string, std::size_t> widths{{"SCALAR", 1}, {"VEC3", 3}, {"VEC4", 4}};
    const Json& a = json["accessors"][static_cast<std::size_t>(accessor)];
    const Json& view = json["bufferViews"][a["bufferView"].get<std::size_t>()];
    EXPECT_EQ(a["componentType"], 5126);
    const std::size_t width = widths.at(a["type"]), from = view.value("byteOffset", 0u) + a.value("byteOffset", 0u);
    std::vector<Numbers> out(a["count"], Numbers(width));
    EXPECT_LE(from + out.size() * width * 4, bytes.size());
    for (std::size_t i = 0; i < out.size(); ++i)
      for (std::size_t k = 0; k < width; ++k) {
        float f = 0;
        std::memcpy(&f, bytes.data() + from + 4 * (i * width + k), sizeof f);
        out[i][k] = f;
      }
    return out;
  }

  Json json;
  std::string bytes;
};

Numbers normalised(Numbers v) {
  double length = 0;
  for (const double x : v) length += x * x;
  for (double& x : v) x /= std::sqrt(length);
  return v;
}

Numbers slerp(const Numbers& a, Numbers b, double u) {
  double cosine = 0;
  for (int k = 0; k < 4; ++k) cosine += a[k] * b[k];
  if (cosine < 0) {
    cosine = -cosine;
    for (double& x : b) x = -x;
  }
  const double angle = std::acos(std::min(cosine, 1.0));
  const double p = angle < 1e-9 ? 1 - u : std::sin((1 - u) * angle) / std::sin(angle);
  const double q = angle < 1e-9 ? u : std::sin(u * angle) / std::sin(angle);
  Numbers out(4);
  for (int k = 0; k < 4; ++k) out[k] = p * a[k] + q * b[k];
  return out;
}

// Appendix C of the specification: STEP, LINEAR (slerp for rotations) and CUBICSPLINE with in-tangent, value,
// out-tangent.
Numbers sampled(const Glb& file, const Json& sampler, bool turn, double t) {
  const auto times = file.floats(sampler["input"]), values = file.floats(sampler["output"]);
  const std::string how = sampler.value("interpolation", "LINEAR");
  const std::size_t each = how == "CUBICSPLINE" ? 3 : 1, middle = each / 2;
  const auto value = [&](std::size_t i) { return values[each * i + middle]; };
  if (t <= times.front()[0]) return value(0);
  if (t >= times.back()[0]) return value(times.size() - 1);
  std::size_t i = 0;
  while (times[i + 1][0] <= t) ++i;
  const double length = times[i + 1][0] - times[i][0], u = (t - times[i][0]) / length;
  if (how == "STEP") return value(i);
  if (how == "LINEAR" && turn) return slerp(value(i), value(i + 1), u);
  Numbers out(value(i).size());
  for (std::size_t k = 0; k < out.size(); ++k) {
    const double a = value(i)[k], b = value(i + 1)[k];
    out[k] = a + (b - a) * u;
    if (how == "CUBICSPLINE") {
      const double leaving = length * values[3 * i + 2][k], arriving = length * values[3 * i + 3][k];
      out[k] = (2 * u * u * u - 3 * u * u + 1) * a + (u * u * u - 2 * u * u + u) * leaving +
               (3 * u * u - 2 * u * u * u) * b + (u * u * u - u * u) * arriving;
    }
  }
  return turn ? normalised(out) : out;
}

// A node's matrix in the world.
Mat4 world(const Glb& file, std::size_t node, double t) {
  const Json& n = file.json["nodes"][node];
  Numbers move = n.value("translation", Numbers{0, 0, 0}), turn = n.value("rotation", Numbers{0, 0, 0, 1}),
          grow = n.value("scale", Numbers{1, 1, 1});
  for (const Json& animation : file.json.value("animations", Json::array()))
    for (const Json& channel : animation["channels"]) {
      if (channel["target"].value("node", file.json["nodes"].size()) != node) continue;
      const std::string path = channel["target"]["path"];
      const Numbers v =
          sampled(file, animation["samplers"][channel["sampler"].get<std::size_t>()], path == "rotation", t);
      (path == "translation" ? move : path == "rotation" ? turn : grow) = v;
    }
  const Mat4 own = translation({move[0], move[1], move[2]}) * rotation({turn[3], turn[0], turn[1], turn[2]}) *
                   scaling({grow[0], grow[1], grow[2]});
  for (std::size_t up = 0; up < file.json["nodes"].size(); ++up)
    for (const Json& child : file.json["nodes"][up].value("children", Json::array()))
      if (child == node) return world(file, up, t) * own;
  return own;
}

const char* const film =
    "rate 24\nrange 1f 73f\n"
    "create ball sphere\nball.position\n  1f (-5 0 1) linear\n  20f (0 3 0) bezier(0.3 1.4 0.2 1)\n  49f (5 -2 0) "
    "hold\n"
    "  61f (0 0 0) ease-in=6f\n  73f (2 2 0)\nball.scale\n  1f (1 1 1) smooth\n  33f (2 0.5 1)\n  73f (1 1 1)\n"
    "ball.rotation\n  1f axis(y 0deg) slerp\n  30f axis(y 170deg) slerp\n  37f axis(x 40deg)\n"
    "create arm group position=(1 -2 3)\narm.rotation.z\n  1f 0deg linear\n  37f 720deg ease-in=12f\n  73f 90deg\n"
    "create arm/tip box position=(1.5 0 0)\narm/tip.position.y\n  1f 0 smooth\n  11f 2\n  73f -1\n"
    "create still cone position=(3 1 4) scale=(1 2 1)\n";

// The matrices of all objects at many times, in both styles of keys.
TEST(Gltf, AFileReadBySpecificationIsWhereTheFilmIs) {
  const Folder folder;
  const Loaded loaded = load_text(film, "test.bx");
  ASSERT_FALSE(has_errors(loaded.diagnostics)) << to_string(loaded.diagnostics.front());
  const Program program = Program::compile(loaded.document);
  for (const KeyStyle style : {KeyStyle::cubic, KeyStyle::linear, KeyStyle::baked}) {
    ExportOptions options;
    options.path = folder / "x.glb";
    std::tie(options.from, options.until) = loaded.document.range();
    options.keys.style = style;
    ASSERT_TRUE(export_film(program, options));
    const Glb file(options.path);
    std::mt19937 random(7);
    for (const char* name : {"ball", "arm", "arm/tip", "still"}) {
      std::size_t node = 0;
      while (file.json["nodes"][node]["name"] != name) ++node;
      for (int k = 0; k < 60; ++k) {
        // Baked keys are exact on frames only.
        const double frame = style == KeyStyle::baked ? random() % 73 : random() % 72001 / 1000.0;
        const Time t = loaded.document.rate().frame(1 + frame);
        const auto found = find_targets(std::string(name) + ".world", loaded.document);
        ASSERT_TRUE(found);
        const Mat4 is = world(file, node, frame / 24), due = *std::get<Matrix>(program.read(found->front(), t));
        for (int r = 0; r < 3; ++r)
          for (int c = 0; c < 4; ++c)
            EXPECT_NEAR(is(r, c), due(r, c), 5e-4) << name << " at frame " << 1 + frame << ", " << r << " " << c;
      }
    }
  }
}

// As Blender's importer and assimp read it: the values alone, straight from one to the next, whatever a sampler says;
// of a node's channels the last one counts, and one without a node is the translation of the node that is read first,
// children before their parents.
Mat4 by_values(const Glb& file, std::size_t node, double t) {
  Glb straight = file;
  Json first = file.json["scenes"][0]["nodes"][0];
  while (file.json["nodes"][first.get<std::size_t>()].contains("children"))
    first = file.json["nodes"][first.get<std::size_t>()]["children"][0];
  Json kept = Json::array();
  for (Json channel : file.json["animations"][0]["channels"]) {
    if (!channel["target"].contains("node")) channel["target"] = {{"node", first}, {"path", "translation"}};
    std::erase_if(kept.get_ref<Json::array_t&>(), [&](const Json& k) { return k["target"] == channel["target"]; });
    kept.push_back(channel);
  }
  straight.json["animations"][0]["channels"] = kept;
  for (Json& s : straight.json["animations"][0]["samplers"]) {
    EXPECT_NE(s["interpolation"], "CUBICSPLINE");
    s["interpolation"] = "LINEAR";
  }
  return world(straight, node, t);
}

TEST(Gltf, WhatIsUsualIsPlayedAlikeByThoseWhoKnowValuesOnly) {
  const Folder folder;
  const std::string text = std::string(film) +
                           "create sign box color=red\nsign.color\n  1f red\n  73f blue\nsign.position\n"
                           "  1f (0 0 0) hold\n  24f (3 0 0) hold\n  47f (0 1 0)\n";
  const Loaded loaded =
      load_text("create post group position=(7 0 0)\ncreate post/lamp box position=(1 2 3)\n" + text, "test.bx");
  ASSERT_FALSE(has_errors(loaded.diagnostics)) << to_string(loaded.diagnostics.front());
  const Program program = Program::compile(loaded.document);
  ExportOptions options;
  options.path = folder / "x.glb";
  std::tie(options.from, options.until) = loaded.document.range();
  options.keys = usual_keys(options.path);
  EXPECT_EQ(options.keys.style, KeyStyle::linear);
  ASSERT_TRUE(export_film(program, options));
  const Glb file(options.path);
  for (const char* name : {"post", "post/lamp", "ball", "arm", "arm/tip", "still", "sign"}) {
    std::size_t node = 0;
    while (file.json["nodes"][node]["name"] != name) ++node;
    const auto found = find_targets(std::string(name) + ".world", loaded.document);
    ASSERT_TRUE(found);
    for (int frame = 0; frame < 73; ++frame) {
      // Who counts in milliseconds, by floats, is later or earlier by that.
      const double seconds = static_cast<float>(frame / 24.0F * 1000.0F) / 1000.0;
      const Mat4 is = by_values(file, node, std::max(seconds, frame / 24.0)),
                 due = *std::get<Matrix>(program.read(found->front(), loaded.document.rate().frame(1 + frame)));
      for (int r = 0; r < 3; ++r)
        for (int c = 0; c < 4; ++c) EXPECT_NEAR(is(r, c), due(r, c), 1e-3) << name << " at frame " << 1 + frame;
    }
  }
}

// The whole film of a text as glTF, with the usual keys.
Glb as_glb(const std::string& text) {
  const Folder folder;
  const Loaded loaded = load_text(text, "test.bx");
  ExportOptions options;
  options.path = folder / "x.glb";
  std::tie(options.from, options.until) = loaded.document.range();
  options.keys = usual_keys(options.path);
  EXPECT_TRUE(export_film(Program::compile(loaded.document), options));
  return Glb(options.path);
}

// Steps of code, of which no track knows: each has its own pair of keys, wherever others end.
TEST(Gltf, StepsThatOnlyCodeKnowsAreAllThere) {
  for (const double rate : {23.1, 31.7, 36.57, 47.3, 61.1}) {
    const Glb file = as_glb(fmt::format("range 1f 97f\ncreate b box\nset b.position.x = \"floor(t * {})\"\n", rate));
    for (double frame = 0; frame <= 96; frame += 0.37) {
      const double t = frame / 24, steps = t * rate;
      if (std::ceil(steps) - steps < 0.02 * rate / 24) continue;  // it is on its way
      EXPECT_NEAR(by_values(file, 0, t)(0, 3), std::floor(steps), 1e-3) << rate << " at frame " << 1 + frame;
    }
  }
}

// What jumps just behind a frame has not begun to do so in that frame.
TEST(Gltf, WholeFramesAreThereHoweverSoonAJumpFollows) {
  for (const double late : {0.0004, 0.003, 0.006, 0.0104, 0.02, 0.5}) {
    const Glb file =
        as_glb(fmt::format("range 1f 49f\ncreate b box\nset b.position.x = \"floor(t * 24 - {})\"\n", late));
    for (int frame = 0; frame <= 48; ++frame)
      EXPECT_NEAR(by_values(file, 0, frame / 24.0)(0, 3), frame - 1, 1e-3) << late << " behind frame " << 1 + frame;
  }
}

// A program that reads nodes as matrices must find the rotation of what grows out of nothing.
TEST(Gltf, NoNodeThatGrowsRestsAtAScaleOfZero) {
  const Glb file = as_glb(
      "range 1f 49f\ncreate b box rotation.z=30deg\nb.scale\n  1f (0 0 0) smooth\n  25f (1 1 1)\nhide b\n"
      "at 12f show b\n");
  int growing = 0;
  for (const Json& node : file.json["nodes"]) {
    if (!node.contains("scale")) continue;
    ++growing;
    for (const double x : node["scale"]) EXPECT_GT(x, 0) << node;
  }
  EXPECT_EQ(growing, 2);
  EXPECT_NEAR(world(file, 0, 0)(0, 0), 0, 1e-5);
  EXPECT_NEAR(world(file, 0, 1)(0, 0), std::cos(std::acos(-1) / 6), 1e-5);
}

// Programs that do not play colors show what fades in, in its own color.
TEST(Gltf, WhatFadesInRestsOpaque) {
  const Glb file = as_glb(
      "range 1f 49f\ncreate b box color=red\nat 1f b.transparency 1 linear\nat 25f b.transparency 0\n"
      "create still box color=blue transparency=0.25\n");
  ASSERT_EQ(file.json["materials"].size(), 2u);
  const auto factor = [&](std::size_t i) {
    return file.json["materials"][i]["pbrMetallicRoughness"]["baseColorFactor"].get<std::vector<double>>();
  };
  EXPECT_EQ(factor(0), (std::vector<double>{1, 0, 0, 1}));
  EXPECT_EQ(factor(1), (std::vector<double>{0, 0, 1, 0.75}));
}

TEST(Gltf, FinishesGoWithTheirExtensions) {
  const Glb file = as_glb(
      "range 1f 2f\ncreate a box material=gold\ncreate b box color=red roughness=0.3 clearcoat=1 "
      "clearcoat-roughness=0.05\n"
      "create c sphere material=glass\ncreate d box emission=orange emission-strength=3 sheen=#ff0000\n"
      "create e box metalness=0.5 color=white\n");
  ASSERT_EQ(file.json["materials"].size(), 5u);
  const auto m = [&](std::size_t i) { return file.json["materials"][i]; };
  const Json gold = m(0)["pbrMetallicRoughness"];
  EXPECT_EQ(gold["metallicFactor"], 1);
  EXPECT_NEAR(gold["roughnessFactor"], 0.18, 1e-6);
  EXPECT_NEAR(gold["baseColorFactor"][1], 0.71, 1e-6);
  EXPECT_EQ(m(1)["extensions"]["KHR_materials_clearcoat"]["clearcoatFactor"], 1);
  EXPECT_NEAR(m(1)["extensions"]["KHR_materials_clearcoat"]["clearcoatRoughnessFactor"], 0.05, 1e-6);
  EXPECT_EQ(m(1)["pbrMetallicRoughness"]["baseColorFactor"][0], 1);
  EXPECT_EQ(m(2)["extensions"]["KHR_materials_transmission"]["transmissionFactor"], 1);
  EXPECT_EQ(m(2)["extensions"]["KHR_materials_volume"]["thicknessFactor"], 0.5);
  EXPECT_NEAR(m(3)["extensions"]["KHR_materials_emissive_strength"]["emissiveStrength"], 3, 1e-6);
  EXPECT_EQ(m(3)["emissiveFactor"][0], 1);
  EXPECT_EQ(m(3)["extensions"]["KHR_materials_sheen"]["sheenColorFactor"][0], 1);
  EXPECT_EQ(m(4)["pbrMetallicRoughness"]["metallicFactor"], 0.5);
}

// Other programs have no patterns, so they get their mean: that of the points on a large box, chosen at random.
TEST(Gltf, PatternsBecomeTheirMean) {
  for (const char* name : {"metallic-paint", "concrete", "rust"}) {
    const Glb file = as_glb(fmt::format("range 1f 2f\ncreate a box material={}\n", name));
    const MaterialRow& row = material_row(name);
    std::mt19937 random(5);
    std::uniform_real_distribution<double> place(-10, 10);
    constexpr int count = 20000;
    Vec3 color;
    double roughness = 0;
    for (int k = 0; k < count; ++k) {
      Vec3 at{place(random), place(random), place(random)}, normal;
      at[k % 3] = 10, normal[k % 3] = 1;
      const PatternPoint p = pattern_at(row.finish, row.color, at, normal, 0);
      color = color + 1.0 / count * p.color, roughness += p.roughness / count;
    }
    const Json pbr = file.json["materials"][0]["pbrMetallicRoughness"];
    for (int i = 0; i < 3; ++i)
      EXPECT_NEAR(pbr["baseColorFactor"][static_cast<std::size_t>(i)], color[i], 0.01) << name;
    EXPECT_NEAR(pbr["roughnessFactor"], roughness, 0.01) << name;
  }
}

// 6 plots with 4 million triangles each, if each frame had its own: fewer meshes are kept, evenly over the film.
TEST(Gltf, AFilmWithTooManyShapesKeepsFewerOfThem) {
  const Glb file = as_glb(
      "range 1f 241f\nfilm flat\ndefine freq number 1\ncreate ax axes x=(0 10) y=(-2 2) numbers=off\n"
      "create p{1..6} plot on=ax of=\"sin(x * value('ax.freq') + i)\"\nax.freq\n  1f 1 linear\n  241f 2\n");
  std::size_t triangles = 0, shapes = 0;
  for (const Json& mesh : file.json["meshes"])
    for (const Json& part : mesh["primitives"])
      triangles += file.json["accessors"][part["indices"].get<std::size_t>()]["count"].get<std::size_t>() / 3, ++shapes;
  EXPECT_LT(triangles, 6'000'000u);
  EXPECT_GT(shapes, 6u * 24);
  // One shape of a plot is visible at each frame: it is as large as the object, the others have no size.
  std::map<double, double> visible;
  const Json& film = file.json["animations"][0];
  for (const Json& channel : film["channels"]) {
    const std::size_t node = channel["target"].value("node", std::size_t{0});
    if (!file.json["nodes"][node].value("name", "").starts_with("p1 shape ")) continue;
    const Json& sampler = film["samplers"][channel["sampler"].get<std::size_t>()];
    for (int frame = 0; frame <= 240; frame += 40) visible[frame] += sampled(file, sampler, false, frame / 24.0)[0];
  }
  EXPECT_EQ(visible.size(), 7u);
  for (const auto& [frame, sum] : visible) EXPECT_NEAR(sum, 1, 1e-3) << frame;
}

TEST(Gltf, EachFormatHasItsUsualKeys) {
  EXPECT_EQ(usual_keys("a.gltf").metres, 1e-3);
  EXPECT_EQ(usual_keys("a.glb", KeyStyle::cubic).metres, 1e-4);
  EXPECT_EQ(usual_keys("a.usda").style, KeyStyle::linear);
  for (const char* path : {"a.json", "a.css", "a.js", "a.svg"}) {
    EXPECT_EQ(usual_keys(path).style, KeyStyle::cubic);
    EXPECT_EQ(usual_keys(path).metres, 1e-4);
  }
}

}  // namespace gltf_test
}  // namespace betwixt
