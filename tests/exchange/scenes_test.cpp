// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests hostile scene files: cut off, in circles, out of all bounds. Each is refused with a message, or the result is
// valid.
#include <fmt/format.h>
#include <sys/mman.h>

#include <cstring>
#include <fstream>
#include <random>
#include <set>
#include <sstream>

#include "base/files.h"
#include "exchange/files.h"
#include "exchange/scene_file.h"
#include "exchange/wire_format.h"

namespace betwixt {
namespace {

const std::string scenes = SOURCE_DIR "/tests/commands/data/scenes/";
const char* const files[] = {"skin", "morph", "cubic", "step", "stage"};

const MayRead all = [](const std::string&) { return true; };

std::string contents(const std::string& name) {
  std::ifstream in(scenes + name, std::ios::binary);
  std::ostringstream out;
  out << in.rdbuf();
  return out.str();
}

// One file, in this process.
class OneFile final : public FileSource {
 public:
  explicit OneFile(std::string bytes) : bytes_(std::move(bytes)) {}
  bool has(const std::string& path) override { return path.starts_with("it."); }
  Result<std::string> read(const std::string& path) override {
    return path.starts_with("it.") ? Result<std::string>(bytes_) : fail(ErrorCode::file, "nothing else is there");
  }

 private:
  std::string bytes_;
};
Result<std::shared_ptr<const SceneFile>> parsed(const std::string& bytes, const std::string& kind = "glb") {
  OneFile files(bytes);
  return parse_scene("it." + kind, files);
}

// A file of glTF 2 with `json` instead of `was` in its text.
std::string with(const std::string& file, const std::string& was, const std::string& json) {
  std::string bytes = contents(file + ".glb");
  std::uint32_t length = 0, rest = 0;
  std::memcpy(&length, bytes.data() + 12, 4);
  std::string text = bytes.substr(20, length);
  const auto at = text.find(was);
  EXPECT_NE(at, std::string::npos) << was;
  text.replace(at, was.size(), json);
  text.resize((text.size() + 3) / 4 * 4, ' ');
  std::string out = bytes.substr(0, 20) + text + bytes.substr(20 + length);
  length = static_cast<std::uint32_t>(text.size()), rest = static_cast<std::uint32_t>(out.size());
  std::memcpy(out.data() + 12, &length, 4), std::memcpy(out.data() + 8, &rest, 4);
  return out;
}

void refused(const std::string& bytes, const std::string& why) {
  const auto scene = parsed(bytes);
  ASSERT_FALSE(scene) << why;
  EXPECT_NE(scene.error().message.find(why), std::string::npos) << scene.error().message;
}

TEST(SceneFiles, ThatLieAreRefusedByTheirLie) {
  refused(with("skin", "\"children\":[3]", "\"children\":[0]"), "is below itself or has two parents");
  refused(with("skin", "\"children\":[3]", "\"children\":[77]"), "there is no node 77");
  refused(with("skin", "\"mesh\":0", "\"mesh\":9"), "there is no mesh 9");
  refused(with("skin", "\"skin\":0", "\"skin\":9"), "there is no skin 9");
  refused(with("skin", "\"joints\":[1,2,3]", "\"joints\":[1,2,9]"), "joint 9 of a skin is not a node");
  refused(with("skin", "\"joints\":[1,2,3]", "\"joints\":[1]"), "a vertex uses joint");
  refused(with("skin", "\"joints\":[1,2,3]", "\"joints\":[]"), "0 joints");
  refused(with("skin", "\"joints\":[1,2,3]", "\"joints\":[1,2,3,3,2]"), "fewer matrices than joints");
  refused(with("skin", "\"target\":{\"node\":2", "\"target\":{\"node\":300"), "moves node 300");
  refused(with("skin", "\"sampler\":0", "\"sampler\":50"), "has no sampler 50");
  refused(with("skin", "\"count\":3,\"type\":\"SCALAR\"", "\"count\":300000000,\"type\":\"SCALAR\""), "");
  refused(with("morph", "\"weights\":[0.25,0]", "\"weights\":[0.25,0,1,2,3]"), "more weights than targets");
  refused(with("stage", "\"camera\":0", "\"camera\":7"), "there is no camera 7");
  refused(with("stage", "{\"light\":0}", "{\"light\":7}"), "a light that does not exist");
  // A picture that is said to lie beyond its buffer: nobody looks at it, and then somebody does.
  const auto picture = [](const std::string& material) {
    return "{\"asset\":{\"version\":\"2.0\"},\"buffers\":[{\"byteLength\":36,\"uri\":\"data:application/"
           "octet-stream;base64," +
           std::string(48, 'A') +
           "\"}],\"bufferViews\":[{\"buffer\":0,\"byteLength\":36},{\"buffer\":0,\"byteOffset\":30,\"byteLength\":"
           "900000}],"
           "\"images\":[{\"bufferView\":1,\"mimeType\":\"image/png\"}],\"textures\":[{\"source\":0}],\"materials\":[" +
           material +
           "],\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"count\":3,\"type\":\"VEC3\"}],"
           "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0},\"material\":0}]}],\"nodes\":[{\"mesh\":0}]}";
  };
  const auto left = parsed(picture("{}"), "gltf");  // its triangle is a point
  ASSERT_FALSE(left);
  EXPECT_NE(left.error().message.find("it has no triangles"), std::string::npos) << left.error().message;
  const auto looked_at = parsed(picture("{\"pbrMetallicRoughness\":{\"baseColorTexture\":{\"index\":0}}}"), "gltf");
  ASSERT_FALSE(looked_at);
  EXPECT_NE(looked_at.error().message.find("buffer view 1 is shorter than its data"), std::string::npos)
      << looked_at.error().message;
  refused("{\"asset\":{\"version\":\"1.0\"}}", "it is glTF 1.0; only glTF 2 is supported");
  refused(std::string("glTF\1\0\0\0\24\0\0\0\0\0\0\0", 16), "it is glTF 1.0; only glTF 2 is supported");
}

// Cut anywhere, with a byte changed, with two: all sorts of damage.
TEST(SceneFiles, OfAnyDamageAreRefusedOrSound) {
  std::mt19937 random(1);
  int sound_ones = 0;
  for (const char* name : files) {
    const std::string whole = contents(std::string(name) + ".glb");
    for (int i = 0; i < 250; ++i) {
      std::string bytes = whole;
      if (i % 5 == 0) bytes.resize(random() % whole.size());
      for (unsigned k = 0; k < random() % 4 && !bytes.empty(); ++k)
        bytes[random() % bytes.size()] = static_cast<char>(i % 2 ? '0' + random() % 10 : random());
      const auto scene = parsed(bytes);
      if (scene) {
        ASSERT_TRUE(sound(**scene));
        ++sound_ones;
      } else {
        ASSERT_FALSE(scene.error().message.empty());
      }
    }
  }
  EXPECT_GT(sound_ones, 100);
}

TEST(SceneFiles, OfOtherFormatsThatAreDamagedAreRefusedOrSound) {
  std::mt19937 random(2);
  const std::string whole = contents("bones.bvh");
  for (int i = 0; i < 300; ++i) {
    std::string bytes = whole;
    if (i % 5 == 0) bytes.resize(random() % whole.size());
    for (unsigned k = 0; k < random() % 4 && !bytes.empty(); ++k)
      bytes[random() % bytes.size()] = static_cast<char>(32 + random() % 90);
    const auto scene = parsed(bytes, "bvh");
    ASSERT_TRUE(!scene || sound(**scene));
  }
  for (const char* kind : {"bvh", "fbx", "dae", "glb", "gltf"}) {
    EXPECT_FALSE(parsed("", kind));
    EXPECT_FALSE(parsed(std::string(5000, 'x'), kind)) << kind;
  }
}

struct Memory {
  OpenFile file{::memfd_create("test", MFD_CLOEXEC)};
  explicit Memory(const std::string& bytes = {}) { EXPECT_EQ(write_all(file.fd(), bytes), 0); }
  std::string bytes() const {
    std::string out;
    EXPECT_EQ(read_all(file.fd(), out), 0);
    return out;
  }
};

TEST(SceneFiles, AreHandedOverAsTheyAre) {
  for (const char* name : files) {
    const auto scene = parsed(contents(std::string(name) + ".glb"));
    ASSERT_TRUE(scene);
    Memory memory;
    ASSERT_EQ(write_parsed(*scene, memory.file.fd()), 0);
    Parsed got;
    ASSERT_EQ(read_parsed(memory.file.fd(), got), 0);
    const SceneFile &is = *std::get<std::shared_ptr<const SceneFile>>(got), &wanted = **scene;
    Memory again;
    ASSERT_EQ(write_parsed(std::get<std::shared_ptr<const SceneFile>>(got), again.file.fd()), 0);
    EXPECT_EQ(again.bytes(), memory.bytes()) << name;
    ASSERT_EQ(is.nodes.size(), wanted.nodes.size());
    for (std::size_t i = 0; i < is.nodes.size(); ++i) {
      EXPECT_EQ(is.nodes[i].name, wanted.nodes[i].name);
      EXPECT_EQ(is.nodes[i].rotation, wanted.nodes[i].rotation);
      EXPECT_EQ(is.nodes[i].joints, wanted.nodes[i].joints);
    }
    EXPECT_EQ(is.left_out, wanted.left_out);
    // Whoever hands over may lie.
    std::mt19937 random(3);
    const std::string whole = memory.bytes();
    for (int i = 0; i < 400; ++i) {
      std::string bytes = whole;
      for (unsigned k = 0; k < 1 + random() % 3; ++k) bytes[random() % bytes.size()] = static_cast<char>(random());
      if (i % 7 == 0) bytes.resize(random() % bytes.size());
      const Memory lie(bytes);
      if (read_parsed(lie.file.fd(), got) != 0) continue;
      const auto* taken = std::get_if<std::shared_ptr<const SceneFile>>(&got);
      ASSERT_TRUE(!taken || sound(**taken));
    }
  }
}

// Through the process apart, as it is used.
TEST_F(Files, ScenesComeThroughTheJail) {
  const auto scene = load_scene(scenes + "skin.glb", all);
  ASSERT_TRUE(scene) << scene.error().message;
  EXPECT_EQ((*scene)->nodes.size(), 5U);
  EXPECT_EQ((*scene)->clips.size(), 2U);
  const auto bones = load_scene(scenes + "bones.bvh", all);
  ASSERT_TRUE(bones) << bones.error().message;
  EXPECT_TRUE((*bones)->meshes.empty());
  const auto missing = load_scene(at("none.glb"), all);
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().message, "there is no file '" + at("none.glb") + "'");
}

// Names that collide, that cannot be, that are none.
TEST(SceneFiles, GiveEveryNodeANameOfItsOwn) {
  std::string nodes;
  for (int i = 0; i < 300; ++i)
    nodes += fmt::format("{}{{\"name\":\"{}\"}}", i ? "," : "", i % 3 == 0 ? "A" : i % 3 == 1 ? "A-2" : "");
  const auto scene = parsed("{\"asset\":{\"version\":\"2.0\"},\"nodes\":[" + nodes + "]}", "gltf");
  ASSERT_TRUE(scene) << scene.error().message;
  std::set<std::string> names;
  for (const SceneNode& n : (*scene)->nodes) names.insert(n.name);
  EXPECT_EQ(names.size(), 300U);
  EXPECT_TRUE(names.contains("A") && names.contains("A-2") && names.contains("node"));
}

// Collada, by hand: a node that turns from one key to the next, and a triangle on it.
TEST(SceneFiles, ColladaBringsItsKeys) {
  const std::string text = R"(<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1"><asset><up_axis>Y_UP</up_axis></asset>
<library_geometries><geometry id="g" name="g"><mesh><source id="p"><float_array id="pa" count="9">0 0 0 1 0 0 0 1 0</float_array>
<technique_common><accessor source="#pa" count="3" stride="3"><param name="X" type="float"/><param name="Y" type="float"/>
<param name="Z" type="float"/></accessor></technique_common></source><vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<triangles count="1"><input semantic="VERTEX" source="#v" offset="0"/><p>0 1 2</p></triangles></mesh></geometry></library_geometries>
<library_animations><animation id="a"><source id="t"><float_array id="ta" count="2">0 2</float_array><technique_common>
<accessor source="#ta" count="2" stride="1"><param name="TIME" type="float"/></accessor></technique_common></source>
<source id="o"><float_array id="oa" count="6">0 0 0 4 2 0</float_array><technique_common><accessor source="#oa" count="2" stride="3">
<param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source>
<sampler id="s"><input semantic="INPUT" source="#t"/><input semantic="OUTPUT" source="#o"/></sampler>
<channel source="#s" target="Door/move"/></animation></library_animations>
<library_visual_scenes><visual_scene id="sc" name="sc"><node id="Door" name="Door"><translate sid="move">0 0 0</translate>
<instance_geometry url="#g"/></node></visual_scene></library_visual_scenes><scene><instance_visual_scene url="#sc"/></scene></COLLADA>)";
  const auto scene = parsed(text, "dae");
  ASSERT_TRUE(scene) << scene.error().message;
  ASSERT_EQ((*scene)->clips.size(), 1U);
  const SceneTrack* move = nullptr;
  for (const SceneTrack& t : (*scene)->clips[0].tracks)
    if (t.path == SceneTrack::position) move = &t;
  ASSERT_TRUE(move);
  EXPECT_EQ((*scene)->nodes[move->node].name, "Door");
  EXPECT_EQ(move->times, (std::vector<double>{0, 2}));
  EXPECT_EQ(move->values, (std::vector<double>{0, 0, 0, 4, 2, 0}));
  EXPECT_EQ((*scene)->meshes.size(), 1U);
  EXPECT_EQ((*scene)->left_out.at(0), "the curves between keys are left out: all interpolation is linear");
}

}  // namespace
}  // namespace betwixt
