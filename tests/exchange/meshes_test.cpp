// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "exchange/meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>

#include "base/base64.h"
#include "betwixt/picture.h"
#include "exchange/files.h"
#include "exchange/scene_file.h"
#include "scene/topology.h"

namespace betwixt {
namespace {

namespace fs = std::filesystem;

bool anything(const std::string&) { return true; }
Result<std::shared_ptr<const Mesh>> load(const std::string& path) { return load_mesh(path, anything); }
const std::string examples = SOURCE_DIR "/examples/meshes/", data = SOURCE_DIR "/tests/exchange/data/";

void expect_error(const std::string& path, const std::string& message) {
  const auto mesh = load(path);
  ASSERT_FALSE(mesh) << path;
  EXPECT_EQ(mesh.error().code, ErrorCode::file);
  EXPECT_EQ(mesh.error().message, message);
}

const std::string cube_obj =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
    "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";

TEST_F(Files, ExamplesLoad) {
  const auto spot = load(examples + "spot.obj"), teapot = load(examples + "teapot.obj"),
             engine = load(examples + "2CylinderEngine.glb");
  ASSERT_TRUE(spot && teapot && engine);
  EXPECT_EQ((*spot)->triangles.size(), 3U * 5856);
  EXPECT_TRUE((*spot)->closed);
  EXPECT_EQ((*spot)->uvs.size(), (*spot)->positions.size());
  EXPECT_NEAR(signed_volume(**spot), 0.718, 0.001);
  EXPECT_EQ((*teapot)->triangles.size(), 3U * 6320);
  EXPECT_NEAR((*teapot)->box().high[0], 3.434, 0.001);
  EXPECT_EQ((*engine)->triangles.size(), 3U * 121496);
  std::uint32_t covered = 0;
  for (const auto& part : (*engine)->parts) {
    EXPECT_EQ(part.first, covered);
    covered += part.count;
  }
  EXPECT_EQ(covered, (*engine)->triangles.size());
  for (const auto& n : (*engine)->normals) EXPECT_NEAR(length(widen(n)), 1, 1e-5);
}

TEST_F(Files, GltfIsKnownByItsFirstBytes) {
  std::ifstream in(data + "BoxTextured.glb", std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(in), {}};
  const auto plain = load(data + "BoxTextured.glb"), other = load(put("box.stl", bytes));
  ASSERT_TRUE(plain && other);
  EXPECT_EQ((*plain)->positions, (*other)->positions);
  EXPECT_EQ((*plain)->triangles, (*other)->triangles);
}

// A roof, 20 degrees from side to side: the specification demands flat faces of a file without normals.
TEST_F(Files, GltfWithoutNormalsIsFlat) {
  const float rise = std::tan(10 * static_cast<float>(pi) / 180);
  const std::vector<float> places{-1, 0, 0, 0, rise, 0, 0, rise, 1, -1, 0, 1, 1, 0, 0, 1, 0, 1};
  const std::string bytes(reinterpret_cast<const char*>(places.data()), places.size() * sizeof(float));
  const auto file = [&](const std::string& more) {
    return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],
      "meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1)" +
           more + R"(}]}],"accessors":[
      {"bufferView":0,"componentType":5126,"count":6,"type":"VEC3","min":[-1,0,0],"max":[1,1,1]},
      {"bufferView":1,"componentType":5121,"count":12,"type":"SCALAR"}],
      "bufferViews":[{"buffer":0,"byteLength":72},{"buffer":0,"byteOffset":72,"byteLength":12}],
      "buffers":[{"byteLength":84,"uri":"data:application/octet-stream;base64,)" +
           base64(bytes + std::string({0, 3, 2, 0, 2, 1, 1, 2, 5, 1, 5, 4})) + "\"}]}";
  };
  const auto roof = load(put("roof.gltf", file("")));
  ASSERT_TRUE(roof) << roof.error().message;
  const auto flat = [](const Mesh& mesh, auto&& normal, auto&& place) {
    ASSERT_EQ(mesh.triangles.size(), 12U);
    for (std::size_t i = 0; i < mesh.triangles.size(); i += 3) {
      const auto* v = &mesh.triangles[i];
      const Vec3 face = normalize(cross(place(v[1]) - place(v[0]), place(v[2]) - place(v[0])));
      for (int k = 0; k < 3; ++k) EXPECT_LT(length(normal(v[k]) - face), 1e-6) << i << " " << k;
    }
  };
  const Mesh& m = **roof;
  flat(
      m, [&](auto v) { return widen(m.normals[v]); }, [&](auto v) { return widen(m.positions[v]); });

  // Where a target raises the roof, its faces are flat again.
  const auto raised = load_scene(put("raised.gltf", file(R"(,"targets":[{"POSITION":0}])")), anything);
  ASSERT_TRUE(raised) << raised.error().message;
  const Mesh& r = *(*raised)->meshes.at(0).mesh;
  const Rig::Target& t = r.rig->targets.at(0);
  ASSERT_EQ(t.normals.size(), r.normals.size());
  flat(
      r, [&](auto v) { return widen(r.normals[v]); }, [&](auto v) { return widen(r.positions[v]); });
  flat(
      r, [&](auto v) { return widen(r.normals[v]) + widen(t.normals[v]); },
      [&](auto v) { return widen(r.positions[v]) + widen(t.positions[v]); });
}

TEST_F(Files, QuadsKeepTheirEdges) {
  const auto cube = load(put("cube.obj", cube_obj));
  ASSERT_TRUE(cube) << cube.error().message;
  EXPECT_EQ((*cube)->triangles.size(), 3U * 12);
  EXPECT_EQ((*cube)->edges.size(), 2U * 12);
  EXPECT_EQ((*cube)->positions.size(), 24U) << "its corners are sharp";
  EXPECT_TRUE((*cube)->closed);
  EXPECT_NEAR(signed_volume(**cube), 1, 1e-6);
}

TEST_F(Files, PlyInAllForms) {
  const std::string head =
      "ply\nformat ascii 1.0\ncomment made by hand\nelement vertex 4\nproperty float x\nproperty float y\nproperty "
      "double z\n"
      "property uchar red\nelement face 1\nproperty list uchar int vertex_index\nend_header\n";
  const auto ascii = load(put("a.ply", head + "0 0 0 255\n2 0 0 255\n2 2 0 255\n0 2 0 255\n4 0 1 2 3\n"));
  ASSERT_TRUE(ascii) << ascii.error().message;
  EXPECT_EQ((*ascii)->edges.size(), 2U * 4);
  EXPECT_EQ((*ascii)->normals[0], (std::array<float, 3>{0, 0, 1}));
  std::string big =
      "ply\nformat binary_big_endian 1.0\nelement vertex 3\nproperty short x\nproperty short y\nproperty short z\n"
      "element face 1\nproperty list uchar uchar vertex_indices\nend_header\n";
  big += std::string("\0\0\0\0\0\0\0\2\0\0\0\0\0\0\0\3\0\0\3\0\1\2", 22);
  const auto binary = load(put("b.ply", big));
  ASSERT_TRUE(binary) << binary.error().message;
  EXPECT_EQ((*binary)->box().high[1], 3);
  expect_error(put("c.ply", big.substr(0, big.size() - 1)),
               at("c.ply") + " cannot be read as a mesh: face 1 of 1 is incomplete or not valid");
  expect_error(put("d.ply", head.substr(0, 60)), at("d.ply") + " cannot be read as a mesh: its header has no end");
  expect_error(put("e.ply", "ply\nformat ascii 1.0\nelement vertex 99999999999\nend_header\n"),
               at("e.ply") + " cannot be read as a mesh: vertex 1 of 99999999999 is incomplete or not valid");
}

TEST_F(Files, EveryBrokenFileHasItsMessage) {
  expect_error(at("none.obj"), "there is no file '" + at("none.obj") + "'");
  fs::create_directory(at("folder.obj"));
  expect_error(at("folder.obj"), at("folder.obj") + " is a folder, not a file");
  expect_error(put("x.doc", "words"), "the format of the mesh " + at("x.doc") + " is not supported");
  for (const char* kind : {"obj", "ply", "stl", "dae", "fbx", "3ds", "gltf", "glb"}) {
    const std::string name = std::string("empty.") + kind;
    expect_error(put(name, ""), at(name) + " is empty");
  }
  std::string garbage;
  for (unsigned i = 0; i < 20000; ++i) garbage += static_cast<char>(i * 2654435761U >> 13);
  for (const char* kind : {"obj", "ply", "stl", "dae", "fbx", "3ds", "gltf", "glb"}) {
    const auto mesh = load(put(std::string("garbage.") + kind, garbage));
    ASSERT_FALSE(mesh) << kind;
    EXPECT_EQ(mesh.error().code, ErrorCode::file);
    EXPECT_EQ(mesh.error().message.find(at(std::string("garbage.") + kind) + " cannot be read as a mesh: "), 0U)
        << mesh.error().message;
  }
  expect_error(put("points.obj", "v 0 0 0\nv 1 1 1\n"),
               at("points.obj") + " cannot be read as a mesh: it has no triangles");
  expect_error(put("nan.obj", "v 0 0 nan\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"),
               at("nan.obj") + " cannot be read as a mesh: the position of a vertex is not finite");
  expect_error(
      put("cut.dae", "<?xml version=\"1.0\"?><COLLADA><asset>"),
      at("cut.dae") +
          " cannot be read as a mesh: it is incomplete, or an index list contains something other than numbers");
  expect_error(put("one.gltf", "{\"asset\":{\"version\":\"1.0\"}}"),
               at("one.gltf") + " cannot be read as a mesh: it is glTF 1.0; only glTF 2 is supported");
  expect_error(put("bare.gltf", "{\"asset\":{\"version\":\"2.0\"}}"),
               at("bare.gltf") + " cannot be read as a mesh: it has no triangles");
  expect_error(data + "RecursiveNodes.gltf",
               data + "RecursiveNodes.gltf cannot be read as a mesh: node 0 is below itself or has two parents");
  expect_error(data + "BoxWithInfinites.glb",
               data + "BoxWithInfinites.glb cannot be read as a mesh: the position of a vertex is not finite");
  expect_error(
      data + "IndexOutOfRange.gltf",
      data + "IndexOutOfRange.gltf cannot be read as a mesh: a triangle uses vertex 255, but there are only 24");
  EXPECT_FALSE(load(put("deep.gltf", std::string(200000, '['))));
}

TEST_F(Files, TexturesComeAlong) {
  const auto box = load(data + "BoxTextured.glb");
  ASSERT_TRUE(box) << box.error().message;
  ASSERT_EQ((*box)->parts.size(), 1U);
  ASSERT_TRUE((*box)->parts[0].texture);
  EXPECT_EQ((*box)->parts[0].texture->width, 211);
  EXPECT_TRUE((*box)->closed);
}

TEST_F(Files, EveryFileIsAskedFor) {
  put("cube.mtl", "newmtl red\nKd 1 0 0\nmap_Kd paint.png\n");
  Picture paint{1, 1, {1, 2, 3, 255}};
  ASSERT_TRUE(write_png(at("paint.png"), paint));
  const std::string path = put("cube.obj", "mtllib cube.mtl\nusemtl red\n" + cube_obj);
  std::set<std::string> asked;
  const auto cube = load_mesh(path, [&](const std::string& p) {
    asked.insert(fs::path(p).filename().string());
    return true;
  });
  ASSERT_TRUE(cube);
  EXPECT_EQ(asked.count("cube.obj") + asked.count("cube.mtl") + asked.count("paint.png"), 3U);
  ASSERT_TRUE((*cube)->parts[0].texture);
  EXPECT_EQ((*cube)->parts[0].color, (std::array<float, 3>{1, 0, 0}));
  const auto refused = load_mesh(path, [](const std::string&) { return false; });
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().message, "reading " + path + " is not allowed");
  const auto bare = load_mesh(path, [&](const std::string& p) { return p == path; });
  ASSERT_TRUE(bare) << bare.error().message;
  EXPECT_FALSE((*bare)->parts[0].texture);
  const auto buffer =
      load_mesh(data + "IndexOutOfRange.gltf", [](const std::string& p) { return p.find(".bin") == p.npos; });
  EXPECT_FALSE(buffer);
}

}  // namespace
}  // namespace betwixt
