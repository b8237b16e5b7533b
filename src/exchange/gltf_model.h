// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// A glTF 2 file with all indices checked, from which meshes and scenes are made.
#pragma once

#include <tiny_gltf.h>

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "exchange/assembly.h"

namespace betwixt {

// The numbers of an accessor, element by element.
struct GltfNumbers {
  std::vector<double> values;
  std::size_t width = 1;  // numbers for each element
  std::size_t count() const { return values.size() / width; }
};

template <class T>
const T* gltf_at(const std::vector<T>& all, int i) {
  return i >= 0 && static_cast<std::size_t>(i) < all.size() ? &all[static_cast<std::size_t>(i)] : nullptr;
}

class GltfModel {
 public:
  // Reads the file. `as`: the expected kind of file, for errors. Errors: file.
  static Result<std::unique_ptr<GltfModel>> open(const std::string& path, FileSource&, const std::string& as);
  GltfModel(std::string path, std::string as) : path_(std::move(path)), as_(std::move(as)) {}

  const tinygltf::Model& model() const { return model_; }
  const std::string& path() const { return path_; }
  Error error(const std::string& what) const { return Assembly(path_, as_).error(what); }

  std::vector<int> roots() const;
  // Calls use(node, its parent or -1) for all nodes of the scene, parents first. Stops at an error of `use`.
  Status each_node(const std::function<Status(int node, int parent)>& use) const;
  static Mat4 transform(const tinygltf::Node&);

  // Returns the triangles of a primitive; an empty mesh for points or lines.
  Result<Mesh> triangles(const tinygltf::Primitive&, const std::string& uv_set) const;
  // Reads the colour and texture of a material, and the set of texture coordinates that it uses.
  Status look(int material, MeshPart& look, std::string& uv_set);
  // Returns the picture of a texture, read once. Errors: file.
  Result<std::shared_ptr<const Picture>> picture(int texture);

  Result<GltfNumbers> accessor(int i, std::size_t width) const;
  // Reads an attribute into positions, normals or texture coordinates. Leaves `out` empty if the file lacks it.
  template <std::size_t N>
  Status vectors(const std::map<std::string, int>& attributes, const std::string& name,
                 std::vector<std::array<float, N>>& out) const;

 private:
  struct Elements {
    const unsigned char* first = nullptr;
    std::size_t stride = 0;
  };
  Status known() const;
  Error of_another_version(const std::string&) const;
  Result<Elements> elements(int view, std::size_t offset, std::size_t stride, std::size_t size,
                            std::size_t count) const;
  Status replace(const tinygltf::Accessor&, std::size_t part, GltfNumbers& out) const;

  std::shared_ptr<const Picture> with_alpha_of(const tinygltf::Material&, const std::shared_ptr<const Picture>&);

  std::string path_, as_;
  tinygltf::Model model_;
  std::map<int, std::shared_ptr<const Picture>> pictures_;
  // With holes where their alpha is below a limit, or opaque for the limit 0.
  std::map<std::pair<std::shared_ptr<const Picture>, double>, std::shared_ptr<const Picture>> cut_;
};

template <std::size_t N>
Status GltfModel::vectors(const std::map<std::string, int>& attributes, const std::string& name,
                          std::vector<std::array<float, N>>& out) const {
  const auto attribute = attributes.find(name);
  if (attribute == attributes.end()) return Nothing{};
  const auto numbers = accessor(attribute->second, N);
  if (!numbers) return numbers.error();
  out.resize(numbers->count());
  for (std::size_t i = 0; i < out.size(); ++i)
    for (std::size_t k = 0; k < N; ++k) out[i][k] = static_cast<float>(numbers->values[i * N + k]);
  return Nothing{};
}

}  // namespace betwixt
