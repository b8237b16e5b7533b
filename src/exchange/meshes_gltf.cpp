// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <tiny_gltf.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <optional>

#include "base/files.h"
#include "exchange/assembly.h"
#include "exchange/pictures.h"

namespace betwixt {
namespace {

namespace gltf = tinygltf;

constexpr std::size_t most_elements = 50'000'000;

// ---- what the parser asks for while it reads

bool file_exists(const std::string& path, void* shelf) { return static_cast<Shelf*>(shelf)->has(path); }
std::string same_path(const std::string& path, void*) { return path; }
bool read_file(std::vector<unsigned char>* out, std::string* error, const std::string& path, void* shelf) {
  auto bytes = static_cast<Shelf*>(shelf)->read(path);
  if (!bytes)
    *error = bytes.error().message;
  else
    out->assign(bytes->begin(), bytes->end());
  return static_cast<bool>(bytes);
}
bool write_nothing(std::string*, const std::string&, const std::vector<unsigned char>&, void*) { return false; }
// Pictures are decoded when a part needs them.
bool keep_encoded(gltf::Image* image, int, std::string*, std::string*, int, int, const unsigned char* bytes, int size,
                  void*) {
  image->image.assign(bytes, bytes + size);
  return true;
}

// ---- the model, with every index checked

template <class T>
const T* at(const std::vector<T>& all, int i) {
  return i >= 0 && static_cast<std::size_t>(i) < all.size() ? &all[static_cast<std::size_t>(i)] : nullptr;
}

// Numbers of an accessor, one element after the other.
struct Numbers {
  std::vector<double> values;
  std::size_t width = 1;  // numbers an element
  std::size_t count() const { return values.size() / width; }
};

double number(const unsigned char* bytes, int type, bool normalized) {
  const auto as = [&]<class T>(T value, double most) {
    std::memcpy(&value, bytes, sizeof value);
    const auto n = static_cast<double>(value);
    return normalized && most > 0 ? std::max(n / most, -1.0) : n;
  };
  switch (type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
      return as(std::int8_t{}, 127);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return as(std::uint8_t{}, 255);
    case TINYGLTF_COMPONENT_TYPE_SHORT:
      return as(std::int16_t{}, 32767);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return as(std::uint16_t{}, 65535);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
      return as(std::uint32_t{}, 4294967295.0);
    default:
      return as(float{}, 0);
  }
}

struct Elements {
  const unsigned char* first = nullptr;
  std::size_t stride = 0;
};

class Reader {
 public:
  Reader(const gltf::Model& model, const std::string& path) : model_(model), path_(path), assembly_(path) {}

  Result<std::shared_ptr<const Mesh>> scene() && {
    if (model_.asset.version.rfind("2", 0) != 0)
      return assembly_.error(fmt::format("it is glTF {}, and only glTF 2 can be read", model_.asset.version));
    for (const auto& needed : model_.extensionsRequired)
      if (needed.rfind("KHR_materials_", 0) != 0 && needed != "KHR_texture_transform" &&
          needed != "KHR_lights_punctual" && needed != "KHR_mesh_quantization")
        return assembly_.error(fmt::format("it needs the extension {}, which is not known here", needed));
    visited_.resize(model_.nodes.size());
    for (const int root : roots())
      if (const Status s = node(root, {}); !s) return s.error();
    return std::move(assembly_).finish();
  }

 private:
  std::vector<int> roots() const {
    const gltf::Scene* scene = at(model_.scenes, std::max(model_.defaultScene, 0));
    if (scene != nullptr && !scene->nodes.empty()) return scene->nodes;
    // Without a scene: every node that hangs on no other.
    std::vector<bool> child(model_.nodes.size());
    for (const auto& n : model_.nodes)
      for (const int c : n.children)
        if (at(model_.nodes, c) != nullptr) child[static_cast<std::size_t>(c)] = true;
    std::vector<int> free;
    for (std::size_t i = 0; i < child.size(); ++i)
      if (!child[i]) free.push_back(static_cast<int>(i));
    return free;
  }

  static Mat4 transform(const gltf::Node& n) {
    Mat4 m;
    if (n.matrix.size() == 16) {
      std::copy(n.matrix.begin(), n.matrix.end(), m.m.begin());
      return m;
    }
    if (n.translation.size() == 3) m = translation({n.translation[0], n.translation[1], n.translation[2]});
    if (n.rotation.size() == 4)
      m = m * rotation(normalize(Quat{n.rotation[3], n.rotation[0], n.rotation[1], n.rotation[2]}));
    if (n.scale.size() == 3) m = m * scaling({n.scale[0], n.scale[1], n.scale[2]});
    return m;
  }

  // Depth first with a stack of its own: a chain of nodes may be as long as the file.
  Status node(int root, const Mat4& world) {
    std::vector<std::pair<int, Mat4>> open{{root, world}};
    while (!open.empty()) {
      const auto [i, parent] = open.back();
      open.pop_back();
      const gltf::Node* n = at(model_.nodes, i);
      if (n == nullptr) return assembly_.error(fmt::format("there is no node {}", i));
      if (visited_[static_cast<std::size_t>(i)])
        return assembly_.error(fmt::format("node {} hangs on itself or on two others", i));
      visited_[static_cast<std::size_t>(i)] = true;
      const Mat4 own = parent * transform(*n);
      if (n->mesh >= 0)
        if (const Status s = mesh(n->mesh, own); !s) return s;
      for (auto c = n->children.rbegin(); c != n->children.rend(); ++c) open.emplace_back(*c, own);
    }
    return Nothing{};
  }

  Status mesh(int i, const Mat4& world) {
    const gltf::Mesh* mesh = at(model_.meshes, i);
    if (mesh == nullptr) return assembly_.error(fmt::format("there is no mesh {}", i));
    for (const auto& primitive : mesh->primitives)
      if (const Status s = add(primitive, world); !s) return s;
    return Nothing{};
  }

  Status add(const gltf::Primitive& primitive, const Mat4& world) {
    if (primitive.mode >= 0 && primitive.mode < TINYGLTF_MODE_TRIANGLES) return Nothing{};  // points and lines
    if (primitive.attributes.count("POSITION") == 0) return Nothing{};
    Mesh piece;
    MeshPart look;
    std::string uv_set;
    if (const Status s = material(primitive.material, look, uv_set); !s) return s;
    if (const Status s = vectors(primitive, "POSITION", piece.positions); !s) return s;
    if (const Status s = vectors(primitive, "NORMAL", piece.normals); !s) return s;
    if (const Status s = vectors(primitive, uv_set, piece.uvs); !s) return s;
    std::vector<std::uint32_t> indices(piece.positions.size());
    if (primitive.indices < 0) {
      for (std::uint32_t i = 0; i < indices.size(); ++i) indices[i] = i;
    } else {
      const auto numbers = accessor(primitive.indices, 1);
      if (!numbers) return numbers.error();
      indices.assign(numbers->values.size(), 0);
      for (std::size_t i = 0; i < indices.size(); ++i) {
        const double n = numbers->values[i];
        if (!(n >= 0 && n < static_cast<double>(piece.positions.size())))
          return assembly_.error(
              fmt::format("a triangle wants vertex {}, but there are only {}", n, piece.positions.size()));
        indices[i] = static_cast<std::uint32_t>(n);
      }
    }
    for (std::size_t i = 0; i + 2 < indices.size(); ++i) {
      if (primitive.mode == TINYGLTF_MODE_TRIANGLE_STRIP) {
        const std::size_t odd = i % 2;
        piece.triangles.insert(piece.triangles.end(), {indices[i], indices[i + 1 + odd], indices[i + 2 - odd]});
      } else if (primitive.mode == TINYGLTF_MODE_TRIANGLE_FAN) {
        piece.triangles.insert(piece.triangles.end(), {indices[0], indices[i + 1], indices[i + 2]});
      } else if (i % 3 == 0) {
        piece.triangles.insert(piece.triangles.end(), {indices[i], indices[i + 1], indices[i + 2]});
      }
    }
    return assembly_.add(std::move(piece), world, std::move(look));
  }

  // Into positions, normals or texture coordinates; nothing where the file has none.
  template <std::size_t N>
  Status vectors(const gltf::Primitive& primitive, const std::string& name, std::vector<std::array<float, N>>& out) {
    const auto attribute = primitive.attributes.find(name);
    if (attribute == primitive.attributes.end()) return Nothing{};
    const auto numbers = accessor(attribute->second, N);
    if (!numbers) return numbers.error();
    out.resize(numbers->count());
    for (std::size_t i = 0; i < out.size(); ++i)
      for (std::size_t k = 0; k < N; ++k) out[i][k] = static_cast<float>(numbers->values[i * N + k]);
    return Nothing{};
  }

  // `count` elements of `size` bytes in a buffer view; checked to lie within it.
  Result<Elements> elements(int view_index, std::size_t offset, std::size_t stride, std::size_t size,
                            std::size_t count) const {
    const auto* view = at(model_.bufferViews, view_index);
    if (view == nullptr) return assembly_.error(fmt::format("there is no buffer view {}", view_index));
    const auto* buffer = at(model_.buffers, view->buffer);
    if (buffer == nullptr) return assembly_.error(fmt::format("there is no buffer {}", view->buffer));
    const std::size_t have = buffer->data.size();
    const bool inside = view->byteOffset <= have && view->byteLength <= have - view->byteOffset &&
                        offset <= view->byteLength && count <= most_elements && stride <= 65536 &&
                        (count == 0 || (count - 1) * stride + size <= view->byteLength - offset);
    if (!inside) return assembly_.error(fmt::format("buffer view {} ends before its data does", view_index));
    return Elements{buffer->data.data() + view->byteOffset + offset, stride};
  }

  Result<Numbers> accessor(int i, std::size_t width) const {
    const gltf::Accessor* a = at(model_.accessors, i);
    if (a == nullptr) return assembly_.error(fmt::format("there is no accessor {}", i));
    const int components = gltf::GetNumComponentsInType(static_cast<std::uint32_t>(a->type));
    const int bytes = gltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(a->componentType));
    if (components != static_cast<int>(width) || bytes < 1 || bytes > 4)
      return assembly_.error(fmt::format("accessor {} has the wrong type", i));
    if (a->count > most_elements) return assembly_.error(fmt::format("accessor {} has too many elements", i));
    const auto part = static_cast<std::size_t>(bytes);
    Numbers out{{}, width};
    out.values.resize(a->count * width);
    if (a->bufferView >= 0 || !a->sparse.isSparse) {
      const auto* view = at(model_.bufferViews, a->bufferView);
      const std::size_t stride = view != nullptr && view->byteStride > 0 ? view->byteStride : part * width;
      const auto from = elements(a->bufferView, a->byteOffset, stride, part * width, a->count);
      if (!from) return from.error();
      for (std::size_t e = 0; e < a->count; ++e)
        for (std::size_t k = 0; k < width; ++k)
          out.values[e * width + k] = number(from->first + e * stride + k * part, a->componentType, a->normalized);
    }
    if (a->sparse.isSparse)
      if (const Status s = replace(*a, part, out); !s) return s.error();
    return out;
  }

  // Elements that a sparse accessor gives by themselves.
  Status replace(const gltf::Accessor& a, std::size_t part, Numbers& out) const {
    const auto& sparse = a.sparse;
    const int index_bytes = gltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(sparse.indices.componentType));
    if (sparse.count < 0 || index_bytes < 1 || index_bytes > 4 || sparse.indices.byteOffset < 0 ||
        sparse.values.byteOffset < 0)
      return assembly_.error("a sparse accessor makes no sense");
    const auto count = static_cast<std::size_t>(sparse.count), size = part * out.width;
    const auto step = static_cast<std::size_t>(index_bytes);
    const auto where =
        elements(sparse.indices.bufferView, static_cast<std::size_t>(sparse.indices.byteOffset), step, step, count);
    if (!where) return where.error();
    const auto what =
        elements(sparse.values.bufferView, static_cast<std::size_t>(sparse.values.byteOffset), size, size, count);
    if (!what) return what.error();
    for (std::size_t e = 0; e < count; ++e) {
      const double i = number(where->first + e * step, sparse.indices.componentType, false);
      if (!(i >= 0 && i < static_cast<double>(out.count()))) return assembly_.error("a sparse accessor makes no sense");
      for (std::size_t k = 0; k < out.width; ++k)
        out.values[static_cast<std::size_t>(i) * out.width + k] =
            number(what->first + e * size + k * part, a.componentType, a.normalized);
    }
    return Nothing{};
  }

  Status material(int i, MeshPart& look, std::string& uv_set) {
    uv_set = "TEXCOORD_0";
    if (i < 0) return Nothing{};
    const gltf::Material* m = at(model_.materials, i);
    if (m == nullptr) return assembly_.error(fmt::format("there is no material {}", i));
    const auto& base = m->pbrMetallicRoughness;
    for (std::size_t k = 0; k < 3 && k < base.baseColorFactor.size(); ++k)
      if (const double c = base.baseColorFactor[k]; std::isfinite(c)) look.color[k] = static_cast<float>(c);
    if (base.baseColorTexture.index < 0) return Nothing{};
    uv_set = fmt::format("TEXCOORD_{}", base.baseColorTexture.texCoord);
    const gltf::Texture* texture = at(model_.textures, base.baseColorTexture.index);
    const gltf::Image* image = texture == nullptr ? nullptr : at(model_.images, texture->source);
    if (image == nullptr) return assembly_.error(fmt::format("material {} has a texture that is not there", i));
    auto& known = pictures_[texture->source];
    if (!known) {
      auto picture =
          decode_picture(image->image, image->uri.empty() ? fmt::format("picture {} in {}", texture->source, path_)
                                                          : fmt::format("{} of {}", image->uri, path_));
      if (!picture) return fail(ErrorCode::file, picture.error().message, picture.error().hint);
      known = *picture;
    }
    look.texture = known;
    return Nothing{};
  }

  const gltf::Model& model_;
  const std::string& path_;
  Assembly assembly_;
  std::vector<bool> visited_;
  std::map<int, std::shared_ptr<const Picture>> pictures_;
};

// The parser's first complaint, on one line.
std::string first_line(std::string text) {
  if (text.empty()) return "it is not glTF 2.0";
  text.erase(std::min(text.find('\n'), text.size()));
  while (!text.empty() && (text.back() == '.' || text.back() == ' ')) text.pop_back();
  return text;
}

}  // namespace

Result<std::shared_ptr<const Mesh>> load_gltf(const std::string& path, Shelf& shelf) {
  const auto bytes = shelf.read(path);
  if (!bytes) return bytes.error();
  if (bytes->empty()) return fail(ErrorCode::file, fmt::format("{} is empty", path));
  gltf::TinyGLTF parser;
  parser.SetFsCallbacks({file_exists, same_path, read_file, write_nothing, &shelf});
  parser.SetImageLoader(keep_encoded, nullptr);
  gltf::Model model;
  std::string error, warning;
  const std::string folder = (std::filesystem::path(".") / path).parent_path().string();
  const auto length = static_cast<unsigned>(bytes->size());
  try {
    const bool binary = bytes->starts_with("glTF");
    const bool read =
        binary ? parser.LoadBinaryFromMemory(&model, &error, &warning, as_bytes(*bytes).data(), length, folder)
               : parser.LoadASCIIFromString(&model, &error, &warning, bytes->data(), length, folder);
    if (!read && bytes->find("KHR_draco_mesh_compression") != std::string::npos)  // the parser would not say so
      return Assembly(path).error("it is compressed by Draco, which is not known here");
    if (!read) return Assembly(path).error(first_line(error));
  } catch (const std::exception& e) {
    return Assembly(path).error(first_line(e.what()));
  }
  return Reader(model, path).scene();
}

}  // namespace betwixt
