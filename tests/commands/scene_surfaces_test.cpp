// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Surfaces of glTF scenes: meshes of several materials, and alpha as each material uses it.
#include <fstream>

#include "betwixt/evaluation.h"
#include "support/folder.h"
#include "support/loaded_film.h"

namespace betwixt {
namespace {

// A triangle with texture coordinates, and a picture of four pixels whose alpha is 0, 85, 170 and 255.
const std::string triangle = "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAAAAAAAAAAAAAAAIA/AAAAAAAAAAAAAIA/";
const std::string four_pixels =
    "iVBORw0KGgoAAAANSUhEUgAAAAQAAAABCAYAAAD5PA/NAAAAFUlEQVR4nGM4wcDAAMShQLwKiP8DACafBR+kbnPFAAAAAElFTkSuQmCC";

// The items of a scene whose mesh is this triangle once for each of these materials.
std::vector<Item> surfaces_of(const Folder& folder, const std::vector<std::string>& materials) {
  std::string primitives, all;
  for (std::size_t i = 0; i < materials.size(); ++i) {
    const std::string comma = i > 0 ? "," : "";
    primitives += comma + R"({"attributes":{"POSITION":0,"TEXCOORD_0":1},"material":)" + std::to_string(i) + "}";
    all += comma + "{" + materials[i] + "}";
  }
  std::ofstream(folder / "it.gltf")
      << R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"name":"pair","mesh":0}],)"
      << R"("meshes":[{"primitives":[)" << primitives << R"(]}],"materials":[)" << all
      << R"(],"textures":[{"source":0}],)"
      << R"("images":[{"uri":"data:image/png;base64,)" << four_pixels << R"("}],)"
      << R"("buffers":[{"byteLength":60,"uri":"data:application/octet-stream;base64,)" << triangle << R"("}],)"
      << R"("bufferViews":[{"buffer":0,"byteLength":36},{"buffer":0,"byteOffset":36,"byteLength":24}],)"
      << R"("accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"},)"
      << R"({"bufferView":1,"componentType":5126,"count":3,"type":"VEC2"}]})";
  const Loaded film = load_text("create it scene file=\"it.gltf\"", folder / "film.bx", {.read_anywhere = true});
  EXPECT_FALSE(has_errors(film.diagnostics)) << said(film.diagnostics);
  return Program::compile(film.document).frame(Time{}).items;
}

TEST(SceneSurfaces, AMeshOfSeveralMaterialsKeepsEach) {
  const Folder folder;
  const auto items = surfaces_of(
      folder, {R"("pbrMetallicRoughness":{"metallicFactor":0.5,"roughnessFactor":0.2})",
               R"("pbrMetallicRoughness":{"metallicFactor":0,"roughnessFactor":0.7},"emissiveFactor":[1,0,0])",
               R"("pbrMetallicRoughness":{"metallicFactor":0.5,"roughnessFactor":0.2})"});
  ASSERT_EQ(items.size(), 2U);
  ASSERT_TRUE(items[0].finish && items[1].finish);
  EXPECT_EQ(items[0].finish->roughness, 0.2);
  EXPECT_EQ(items[0].shape->mesh->triangles.size(), 6U);  // the first and the third are one object
  EXPECT_EQ(items[1].finish->roughness, 0.7);
  EXPECT_EQ(items[1].finish->emission, (Vec3{1, 0, 0}));
  EXPECT_EQ(items[1].shape->mesh->triangles.size(), 3U);
}

TEST(SceneSurfaces, UseAlphaAsTheMaterialSays) {
  const Folder folder;
  const std::string textured = R"("pbrMetallicRoughness":{"metallicFactor":0,"baseColorTexture":{"index":0}})";
  const auto alphas = [&](const std::string& more) {
    const auto items = surfaces_of(folder, {textured + more});
    std::vector<int> found;
    if (items.size() != 1 || items[0].shape->mesh->parts.empty() || !items[0].shape->mesh->parts[0].texture)
      return found;
    const auto& bytes = items[0].shape->mesh->parts[0].texture->rgba;
    for (std::size_t i = 3; i < bytes.size(); i += 4) found.push_back(bytes[i]);
    return found;
  };
  EXPECT_EQ(alphas(""), (std::vector{255, 255, 255, 255}));
  EXPECT_EQ(alphas(R"(,"alphaMode":"BLEND")"), (std::vector{0, 85, 170, 255}));
  EXPECT_EQ(alphas(R"(,"alphaMode":"MASK")"), (std::vector{0, 0, 255, 255}));
  EXPECT_EQ(alphas(R"(,"alphaMode":"MASK","alphaCutoff":0.9)").front(), 0);
  EXPECT_EQ(alphas(R"(,"alphaMode":"MASK","alphaCutoff":0.9)")[2], 0);
}

}  // namespace
}  // namespace betwixt
