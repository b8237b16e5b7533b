// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "exchange/parser_process.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <thread>

#include "base/base64.h"
#include "betwixt/picture.h"
#include "exchange/drawing.h"
#include "exchange/files.h"
#include "exchange/meshes.h"
#include "exchange/pictures.h"
#include "exchange/scene_file.h"
#include "exchange/unpacking.h"

namespace betwixt {
namespace {

const MayRead anything = [](const std::string&) { return true; };
const std::string examples = SOURCE_DIR "/examples/meshes/", data = SOURCE_DIR "/tests/exchange/data/";

void expect_same(const Picture& a, const Picture& b) {
  EXPECT_EQ(a.width, b.width);
  EXPECT_EQ(a.height, b.height);
  EXPECT_TRUE(a.rgba == b.rgba);
}

std::string repeated(std::string_view what, std::size_t times) {
  std::string out;
  for (std::size_t i = 0; i < times; ++i) out += what;
  return out;
}

// Of two triangles; nodes in nodes, `deep` times.
std::string collada(std::size_t deep) {
  return "<?xml version=\"1.0\"?><COLLADA xmlns=\"http://www.collada.org/2005/11/COLLADASchema\" version=\"1.4.1\">"
         "<library_geometries><geometry id=\"g\"><mesh><source id=\"p\"><float_array id=\"a\" count=\"12\">"
         "0 0 0 1 0 0 1 1 0 0 1 0</float_array><technique_common><accessor source=\"#a\" count=\"4\" stride=\"3\">"
         "<param name=\"X\" type=\"float\"/><param name=\"Y\" type=\"float\"/><param name=\"Z\" type=\"float\"/>"
         "</accessor></technique_common></source><vertices id=\"v\"><input semantic=\"POSITION\" source=\"#p\"/>"
         "</vertices><polylist count=\"2\"><input semantic=\"VERTEX\" source=\"#v\" offset=\"0\"/><vcount>3 3</vcount>"
         "<p>0 1 2 0 2 3</p></polylist></mesh></geometry></library_geometries><library_visual_scenes>"
         "<visual_scene id=\"s\">" +
         repeated("<node>", deep) + "<instance_geometry url=\"#g\"/>" + repeated("</node>", deep) +
         "</visual_scene></library_visual_scenes><scene><instance_visual_scene url=\"#s\"/></scene></COLLADA>";
}

// 16384 x 16384 pixels of gray in four megabytes: 128 pixels a packet.
std::string large_picture() {
  std::string tga("\0\0\x0b\0\0\0\0\0\0\0\0\0\0\x40\0\x40\x08\0", 18);
  return tga + repeated(std::string_view("\xff\x80", 2), std::size_t{16384} * 128);
}

TEST_F(Files, ReadApartAreTheSame) {
  ASSERT_NE(find_parser(), "") << "or nothing of this is tested";
  put("good.dae", collada(1));
  for (const std::string& path :
       {examples + "spot.obj", examples + "2CylinderEngine.glb", data + "BoxTextured.glb", at("good.dae")}) {
    LocalFiles files(anything);
    const auto apart = load_mesh(path, anything), here = parse_mesh(path, files);
    ASSERT_TRUE(apart && here) << path;
    const Mesh &a = **apart, &b = **here;
    EXPECT_TRUE(a.positions == b.positions && a.normals == b.normals && a.uvs == b.uvs) << path;
    EXPECT_TRUE(a.triangles == b.triangles && a.edges == b.edges && a.closed == b.closed) << path;
    ASSERT_EQ(a.parts.size(), b.parts.size());
    for (std::size_t i = 0; i < a.parts.size(); ++i) {
      EXPECT_EQ(a.parts[i].first, b.parts[i].first);
      EXPECT_EQ(a.parts[i].count, b.parts[i].count);
      EXPECT_EQ(a.parts[i].color, b.parts[i].color);
      ASSERT_EQ(a.parts[i].texture == nullptr, b.parts[i].texture == nullptr);
      if (a.parts[i].texture) expect_same(*a.parts[i].texture, *b.parts[i].texture);
    }
  }
  const Picture paint{3, 2, std::vector<std::uint8_t>(24, 77)};
  ASSERT_TRUE(write_png(at("paint.png"), paint));
  expect_same(**read_picture(at("paint.png")), paint);
  const LinearPicture light{2, 2, {0, 0.5F, 40, 1, 0.25F, 0, 0, 0.5F, 0, 0, 0, 0, 1, 1, 1, 1}};
  ASSERT_TRUE(write_exr(at("light.exr"), light));
  const auto apart = read_linear_picture(at("light.exr"));
  ASSERT_TRUE(apart) << apart.error().message;
  EXPECT_EQ(apart->width, 2);
  EXPECT_EQ(apart->height, 2);
  EXPECT_EQ(apart->rgba, light.rgba);
}

TEST_F(Files, ThatEndTheirReaderAreErrors) {
  put("deep.dae", collada(50'000));
  put("deep.fbx", "; FBX 7.4.0 project file\n" + repeated("A: {", 50'000) + repeated("}", 50'000));
  for (const char* name : {"deep.dae", "deep.fbx"}) {
    const auto mesh = load_mesh(at(name), anything);
    ASSERT_FALSE(mesh) << name;
    EXPECT_EQ(mesh.error().code, ErrorCode::file);
    EXPECT_EQ(mesh.error().message, at(name) + " is damaged: the program that reads it crashed");
  }
  EXPECT_TRUE(load_mesh(put("good.dae", collada(3)), anything)) << "the next one is read as ever";
}

TEST_F(Files, TakeNoMoreThanTheirCeilings) {
  put("large.tga", large_picture());
  const ParserCeilings plenty = parser_ceilings("large.tga", 4 << 20, true);
  const auto why = [&](const ParserCeilings& most) {
    const auto parsed = parse_apart(ParserTask::picture, at("large.tga"), anything, true, most);
    const Error* error = parsed ? std::get_if<Error>(&*parsed) : nullptr;
    return error ? error->message : "";
  };
  EXPECT_EQ(why({plenty.memory, 1, 60}), "reading " + at("large.tga") + " takes more than 1 s");
  EXPECT_EQ(why({plenty.memory, 60, 1}), why({plenty.memory, 1, 60}));
  EXPECT_NE(why({std::uint64_t{300} << 20, 60, 60}), "");
}

// A file of some bytes that would become gigabytes is refused before it does, unless the caller says so.
TEST_F(Files, UnpackToNoMoreThanAHundredTimesTheirSize) {
  const auto sparse = [](std::size_t points) {
    return fmt::format(
        R"({{"asset":{{"version":"2.0"}},"accessors":[{{"componentType":5126,"count":{},"type":"VEC3","sparse":{{"count":1,)"
        R"("indices":{{"bufferView":0,"componentType":5121}},"values":{{"bufferView":0}}}}}}],"buffers":[{{"byteLength":16,)"
        R"("uri":"data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAAAAAA=="}}],"bufferViews":[{{"buffer":0,"byteLength":)"
        R"(16}}],"meshes":[{{"primitives":[{{"attributes":{{"POSITION":0}}}}]}}],"nodes":[{{"mesh":0}}],"scenes":[{{"nodes":)"
        R"([0]}}]}})",
        points);
  };
  // 12 bytes a point: 5.5 million are 63 MiB, 6 million 69.
  const auto good = load_mesh(put("good.gltf", sparse(5'400'000)), anything);
  EXPECT_EQ(good.error().code, ErrorCode::file) << "all points are one: no triangles";
  const auto mesh = load_mesh(put("bomb.gltf", sparse(6'000'000)), anything);
  ASSERT_FALSE(mesh);
  EXPECT_EQ(mesh.error().code, ErrorCode::range);
  const auto any = load_mesh(at("bomb.gltf"), anything, true);
  EXPECT_EQ(any.error().code, ErrorCode::file);
  const auto picture = load_picture(put("large.tga", large_picture()), false);
  ASSERT_FALSE(picture);
  EXPECT_EQ(picture.error().code, ErrorCode::range);
  const Picture gray{4096, 4096,
                     std::vector<std::uint8_t>(4 * 4096 * 4096, 77)};  // 64 MiB, within what any file may be
  ASSERT_TRUE(write_png(at("gray.png"), gray));
  EXPECT_TRUE(load_picture(at("gray.png"), false));
}

// A chunk of a PNG: its length, its type, its data, and their CRC.
std::string chunk(const std::string& type, const std::string& data) {
  const auto number = [](std::uint32_t n) {
    return std::string{static_cast<char>(n >> 24), static_cast<char>(n >> 16), static_cast<char>(n >> 8),
                       static_cast<char>(n)};
  };
  std::uint32_t crc = 0xffffffff;
  for (const char c : type + data) {
    crc ^= static_cast<std::uint8_t>(c);
    for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ ((crc & 1) * 0xedb88320);
  }
  return number(static_cast<std::uint32_t>(data.size())) + type + data + number(~crc);
}

// Some bytes that say that 16,384 by 16,384 pixels follow: a GiB. The size is refused before the pixels are missed.
TEST_F(Files, ThatSayTheyAreLargePicturesAreRefused) {
  const std::string png = "\x89PNG\r\n\x1a\n" + chunk("IHDR", std::string("\0\0\x40\0\0\0\x40\0\x08\0\0\0\0", 13)) +
                          chunk("IDAT", "x") + chunk("IEND", "");
  const std::string jpeg("\xff\xd8\xff\xc0\0\x0b\x08\x40\0\x40\0\x01\x01\x11\0", 15);
  const std::string bmp(
      "BM\x3a\0\0\0\0\0\0\0\x36\0\0\0\x28\0\0\0\0\x40\0\0\0\x40\0\0\1\0\x18\0\0\0\0\0\4\0\0\0\0\0\0\0\0"
      "\0\0\0\0\0\0\0\0\0\0\0",
      54);
  const std::string tga("\0\0\x02\0\0\0\0\0\0\0\0\0\0\x40\0\x40\x18\0", 18);
  for (const auto& [name, bytes] : {std::pair("a.png", png), {"a.jpg", jpeg}, {"a.bmp", bmp}, {"a.tga", tga}}) {
    const auto picture = load_picture(put(name, bytes), false);
    ASSERT_FALSE(picture) << name;
    EXPECT_EQ(picture.error().code, ErrorCode::range) << name << ": " << picture.error().message;
  }
  // So is a mesh that wears one.
  const std::string triangle("\0\0\0\0\0\0\0\0\0\0\0\0\0\0\x80\x3f\0\0\0\0\0\0\0\0\0\0\0\0\0\0\x80\x3f\0\0\0\0", 36);
  const auto mesh = load_mesh(
      put("a.gltf",
          fmt::format(
              R"({{"asset":{{"version":"2.0"}},"accessors":[{{"componentType":5126,"count":3,"type":"VEC3","bufferView":0}}],)"
              R"("buffers":[{{"byteLength":36,"uri":"data:application/octet-stream;base64,{}"}}],"bufferViews":[{{"buffer":0,)"
              R"("byteLength":36}}],"images":[{{"uri":"a.png"}}],"textures":[{{"source":0}}],"materials":[{{)"
              R"("pbrMetallicRoughness":{{"baseColorTexture":{{"index":0}}}}}}],"meshes":[{{"primitives":[{{"attributes":{{)"
              R"("POSITION":0}},"material":0}}]}}],"nodes":[{{"mesh":0}}],"scenes":[{{"nodes":[0]}}]}})",
              base64(triangle))),
      anything);
  ASSERT_FALSE(mesh);
  EXPECT_EQ(mesh.error().code, ErrorCode::range) << mesh.error().message;
}

// Every reader counts what it makes: none has room when a counter has given away all that any file may become.
TEST_F(Files, OfEveryKindAreCounted) {
  constexpr std::uint64_t any_file = std::uint64_t{64} << 20;
  ASSERT_TRUE(write_png(at("a.png"), Picture{2, 2, std::vector<std::uint8_t>(16, 77)}));
  put("a.ply",
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 1\nproperty list uchar int vertex_index\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  put("a.stl",
      "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n"
      "endfacet\nendsolid a\n");
  put("a.dae", collada(1));
  put("a.svg", "<svg viewBox='0 0 9 9'><rect width='9' height='9'/></svg>");
  put("a.bvh",
      "HIERARCHY\nROOT hips\n{\nOFFSET 0 0 0\nCHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation\n"
      "End Site\n{\nOFFSET 0 1 0\n}\n}\nMOTION\nFrames: 2\nFrame Time: 0.04\n0 0 0 0 0 0\n1 0 0 0 0 0\n");
  LocalFiles files(anything);
  const auto expect_counted = [&](const auto& parse, const std::string& path) {
    const auto whole = parse(path, files);
    EXPECT_TRUE(whole) << path << ": " << (whole ? "" : whole.error().message);
    Unpacking counter(false);
    ASSERT_TRUE(counter.take(any_file, "others"));
    const auto none = parse(path, files);
    ASSERT_FALSE(none) << path;
    EXPECT_EQ(none.error().code, ErrorCode::range) << path << ": " << none.error().message;
  };
  for (const std::string& mesh :
       {at("a.ply"), at("a.stl"), at("a.dae"), examples + "spot.obj", examples + "2CylinderEngine.glb"})
    expect_counted(parse_mesh, mesh);
  for (const std::string& scene : {at("a.dae"), at("a.bvh"), examples + "figure.glb"})
    expect_counted(parse_scene, scene);
  expect_counted(parse_picture, at("a.png"));
  expect_counted(parse_drawing, at("a.svg"));
}

// What is counted: each file that was read, whatever was made of them, to the byte.
TEST(Unpacking, AddsUp) {
  EXPECT_TRUE(unpack(std::uint64_t{1} << 40, "a")) << "nobody counts";
  constexpr std::uint64_t mebibyte = 1 << 20;
  Unpacking all(false);
  all.read(1000), all.read(500);
  const std::uint64_t allowed = 64 * mebibyte + 150'000;
  EXPECT_TRUE(unpack(allowed - 10, "a"));
  EXPECT_FALSE(unpack(11, "a"));
  EXPECT_TRUE(unpack(10, "a"));
  EXPECT_FALSE(unpack(1, "a"));
  {
    Unpacking large(false);
    large.read(std::uint64_t{1} << 40);
    EXPECT_TRUE(unpack(1024 * mebibyte, "a"));
    EXPECT_FALSE(unpack(1, "a"));
    EXPECT_FALSE(unpack(UINT64_MAX, "a"));
  }
  EXPECT_FALSE(unpack(1, "a")) << "the one outside goes on";
}

TEST_F(Files, AreReadByManyAtOnce) {
  put("good.dae", collada(1)), put("deep.dae", collada(50'000));
  std::vector<std::thread> threads;
  std::array<int, 4> read{};
  for (std::size_t t = 0; t < read.size(); ++t)
    threads.emplace_back([&, t] {
      for (int i = 0; i < 5; ++i) {
        read[t] += load_mesh(at("good.dae"), anything) ? 1 : 0;
        read[t] += load_mesh(at("deep.dae"), anything) ? 100 : 0;
      }
    });
  for (auto& t : threads) t.join();
  EXPECT_EQ(read, (std::array{5, 5, 5, 5}));
}

TEST_F(Files, ParserIsLookedForInItsPlaces) {
  const std::string beside = find_parser();
  EXPECT_TRUE(beside.ends_with("/betwixt-parser"));
  ::setenv("BETWIXT_PARSER", put("mine", "").c_str(), 1);
  EXPECT_EQ(find_parser(), "") << "it cannot be run";
  ::setenv("BETWIXT_PARSER", "/bin/sh", 1);
  EXPECT_EQ(find_parser(), "/bin/sh");
  ::unsetenv("BETWIXT_PARSER");
}

}  // namespace
}  // namespace betwixt
