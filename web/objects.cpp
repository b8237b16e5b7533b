// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Reads OBJ in pages, with tinyobjloader. Other formats need a large library that pages do not have. `betwixt web`
// converts such files to glTF and puts them into the page under their own names.
#include <fmt/format.h>
#include <tiny_obj_loader.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>

#include "base/files.h"
#include "exchange/assembly.h"
#include "exchange/pictures.h"

namespace betwixt {
namespace {

// The colour of faces without a material, as in the reader of the program.
constexpr std::array<float, 3> without_material{0.6F, 0.6F, 0.6F};

using Corner = tinyobj::index_t;

std::filesystem::path beside(const std::string& path, std::string name) {
  std::replace(name.begin(), name.end(), '\\', '/');
  return std::filesystem::path(path).parent_path() / name;
}

// Returns the materials of the libraries that the text names, as one text.
std::string materials_of(const std::string& path, const std::string& text, FileSource& files) {
  std::string all;
  for (std::size_t at = text.find("mtllib"); at != text.npos; at = text.find("mtllib", at + 1)) {
    if (at > 0 && text[at - 1] != '\n') continue;
    std::string name = text.substr(at + 6, text.find_first_of("\r\n", at) - at - 6);
    name.erase(0, name.find_first_not_of(" \t"));
    name.erase(name.find_last_not_of(" \t") + 1);
    if (const auto library = files.read(beside(path, name).string())) all += *library + '\n';
  }
  return all;
}

// The faces of one material, with a vertex for each corner.
class Piece {
 public:
  Piece(const tinyobj::attrib_t& from, bool normals, bool uvs) : from_(from), normals_(normals), uvs_(uvs) {}

  void face(const Corner* corners, std::size_t count) {
    const auto first = static_cast<std::uint32_t>(mesh_.positions.size());
    for (std::size_t i = 0; i < count; ++i) corner(corners[i]);
    const auto at = [&](std::size_t i) { return first + static_cast<std::uint32_t>(i % count); };
    const std::size_t from = count == 4 && bends_in(first, 1) ? 1 : 0;
    for (std::size_t i = 1; i + 1 < count; ++i)
      mesh_.triangles.insert(mesh_.triangles.end(), {at(from), at(from + i), at(from + i + 1)});
    polygons_ |= count > 3;
    for (std::size_t i = 0; i < count; ++i) mesh_.edges.insert(mesh_.edges.end(), {at(i), at(i + 1)});
  }
  Mesh take() {
    if (!polygons_) mesh_.edges.clear();
    return std::move(mesh_);
  }

 private:
  static std::size_t place(int i, std::size_t wide) { return static_cast<std::size_t>(i) * wide; }
  void corner(const Corner& c) {
    const auto vector = [](const std::vector<float>& all, std::size_t i) {
      return std::array{all[i], all[i + 1], all[i + 2]};
    };
    mesh_.positions.push_back(vector(from_.vertices, place(c.vertex_index, 3)));
    if (normals_) mesh_.normals.push_back(vector(from_.normals, place(c.normal_index, 3)));
    if (uvs_) {
      const std::size_t i = place(c.texcoord_index, 2);
      mesh_.uvs.push_back({from_.texcoords[i], 1 - from_.texcoords[i + 1]});
    }
  }
  // Returns whether a quad is concave at corner `i` or at the opposite one. It is then divided from there.
  bool bends_in(std::uint32_t first, std::size_t i) const {
    const auto p = [&](std::size_t k) {
      const auto& v = mesh_.positions[first + k % 4];
      return Vec3{v[0], v[1], v[2]};
    };
    const auto turn = [&](std::size_t k) { return cross(p(k) - p(k + 3), p(k + 1) - p(k)); };
    const Vec3 normal = turn(0) + turn(1) + turn(2) + turn(3);
    return dot(turn(i), normal) < 0 || dot(turn(i + 2), normal) < 0;
  }

  const tinyobj::attrib_t& from_;
  Mesh mesh_;
  bool normals_, uvs_, polygons_ = false;
};

Result<std::shared_ptr<const Mesh>> load_objects(const std::string& path, const std::string& text, FileSource& files) {
  Assembly assembly(path);
  tinyobj::ObjReader reader;
  tinyobj::ObjReaderConfig how;
  how.triangulate = false;
  if (!reader.ParseFromString(text, materials_of(path, text, files), how)) {
    std::string why = reader.Error();
    why.erase(std::min(why.find('\n'), why.size()));
    return assembly.error(why.empty() ? "it holds no triangles" : why);
  }
  const tinyobj::attrib_t& all = reader.GetAttrib();
  std::map<std::string, std::shared_ptr<const Picture>> pictures;
  for (const tinyobj::shape_t& shape : reader.GetShapes()) {
    std::map<int, std::vector<std::pair<std::size_t, std::size_t>>>
        faces;  // by material: the first corner and the count of each
    std::size_t first = 0;
    for (std::size_t f = 0; f < shape.mesh.num_face_vertices.size(); ++f) {
      const std::size_t count = shape.mesh.num_face_vertices[f];
      if (count > 2) faces[shape.mesh.material_ids[f]].emplace_back(first, count);
      first += count;
    }
    const auto& corners = shape.mesh.indices;
    for (const auto& face_list : faces) {
      const int material = face_list.first;
      const auto& of = face_list.second;
      const auto each = [&](auto has) {
        return std::all_of(of.begin(), of.end(), [&](const auto& face) {
          return std::all_of(&corners[face.first], &corners[face.first] + face.second, has);
        });
      };
      const auto below = [](int i, std::size_t count) { return i >= 0 && static_cast<std::size_t>(i) < count; };
      if (!each([&](const Corner& c) { return below(c.vertex_index, all.vertices.size() / 3); }))
        return assembly.error("it has a corner without a place");
      Piece piece(all, each([&](const Corner& c) { return below(c.normal_index, all.normals.size() / 3); }),
                  each([&](const Corner& c) { return below(c.texcoord_index, all.texcoords.size() / 2); }));
      for (const auto& [from, count] : of) piece.face(&corners[from], count);
      MeshPart look;
      look.color = without_material;
      if (below(material, reader.GetMaterials().size())) {
        const tinyobj::material_t& m = reader.GetMaterials()[static_cast<std::size_t>(material)];
        look.color = {m.diffuse[0], m.diffuse[1], m.diffuse[2]};
        if (!m.diffuse_texname.empty()) {
          const auto [known, fresh] = pictures.try_emplace(m.diffuse_texname);
          const std::string file = beside(path, m.diffuse_texname).string();
          if (fresh && files.has(file))
            if (auto picture = parse_picture(file, files)) known->second = *picture;
          look.texture = known->second;
        }
      }
      if (const Status s = assembly.add(piece.take(), {}, look); !s) return s.error();
    }
  }
  return std::move(assembly).finish();
}

}  // namespace

Result<std::shared_ptr<const Mesh>> load_by_assimp(const std::string& path, FileSource& files) {
  const auto bytes = files.read(path);
  if (!bytes) return bytes.error();
  if (bytes->starts_with("glTF")) return load_gltf(path, files);
  if (ending(path) == "obj") return load_objects(path, *bytes, files);
  return fail(ErrorCode::file, fmt::format("{} cannot be read in a page", path),
              "glTF (.gltf .glb), .obj and .ply can be; a page made by betwixt web brings the others along");
}

}  // namespace betwixt
