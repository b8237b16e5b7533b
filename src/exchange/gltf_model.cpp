// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "exchange/gltf_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>

#include "base/files.h"
#include "exchange/pictures.h"
#include "exchange/unpacking.h"

namespace betwixt {
namespace {

namespace gltf = tinygltf;

constexpr std::size_t most_elements = 50'000'000;

// ---- callbacks of the parser

bool file_exists(const std::string& path, void* files) { return static_cast<FileSource*>(files)->has(path); }
std::string same_path(const std::string& path, void*) { return path; }
bool read_file(std::vector<unsigned char>* out, std::string* error, const std::string& path, void* files) {
  auto bytes = static_cast<FileSource*>(files)->read(path);
  if (!bytes)
    *error = bytes.error().message;
  else
    out->assign(bytes->begin(), bytes->end());
  return static_cast<bool>(bytes);
}
bool write_nothing(std::string*, const std::string&, const std::vector<unsigned char>&, void*) { return false; }
// Pictures are decoded when a part needs them. Those in the file's buffers are located then, because their offsets have
// not been checked here.
bool keep_encoded(gltf::Image* image, int, std::string*, std::string*, int, int, const unsigned char* bytes, int size,
                  void*) {
  if (image->bufferView < 0) image->image.assign(bytes, bytes + size);
  return true;
}

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

std::shared_ptr<const Picture> opaque(const std::shared_ptr<const Picture>& picture) {
  const auto& bytes = picture->rgba;
  bool any = false;
  for (std::size_t i = 3; i < bytes.size(); i += 4) any = any || bytes[i] != 255;
  if (!any) return picture;
  auto made = std::make_shared<Picture>(*picture);
  for (std::size_t i = 3; i < bytes.size(); i += 4) made->rgba[i] = 255;
  return made;
}

// Cuts holes where the alpha is below the limit. The edge is as wide as a pixel, so that it is smooth.
std::shared_ptr<const Picture> cut_at(const Picture& p, double limit) {
  auto made = std::make_shared<Picture>(p);
  const auto alpha = [&](int x, int y) {
    const auto i = static_cast<std::size_t>((y + p.height) % p.height) * static_cast<std::size_t>(p.width) +
                   static_cast<std::size_t>((x + p.width) % p.width);
    return p.rgba[4 * i + 3] / 255.0;
  };
  for (int y = 0; y < p.height; ++y)
    for (int x = 0; x < p.width; ++x) {
      const double steep =
          std::max(std::hypot(alpha(x + 1, y) - alpha(x - 1, y), alpha(x, y + 1) - alpha(x, y - 1)) / 2, 1.0 / 255);
      const double share = std::clamp((alpha(x, y) - limit) / steep + 0.5, 0.0, 1.0);
      const auto i = static_cast<std::size_t>(y) * static_cast<std::size_t>(p.width) + static_cast<std::size_t>(x);
      made->rgba[4 * i + 3] = static_cast<std::uint8_t>(std::lround(255 * share));
    }
  return made;
}

// Returns the parser's first message, on one line.
std::string first_line(std::string text) {
  if (text.empty()) return "it is not glTF 2.0";
  text.erase(std::min(text.find('\n'), text.size()));
  while (!text.empty() && (text.back() == '.' || text.back() == ' ')) text.pop_back();
  return text;
}

}  // namespace

Result<std::unique_ptr<GltfModel>> GltfModel::open(const std::string& path, FileSource& files, const std::string& as) {
  const auto bytes = files.read(path);
  if (!bytes) return bytes.error();
  if (bytes->empty()) return fail(ErrorCode::file, fmt::format("{} is empty", path));
  auto out = std::make_unique<GltfModel>(path, as);
  gltf::TinyGLTF parser;
  parser.SetFsCallbacks({file_exists, same_path, read_file, write_nothing, &files});
  parser.SetImageLoader(keep_encoded, nullptr);
  std::string error, warning;
  const std::string folder = (std::filesystem::path(".") / path).parent_path().string();
  const auto length = static_cast<unsigned>(bytes->size());
  try {
    const bool binary = bytes->starts_with("glTF");
    if (binary && bytes->size() >= 8 && (*bytes)[4] == 1) return out->of_another_version("1.0");
    const bool read =
        binary ? parser.LoadBinaryFromMemory(&out->model_, &error, &warning, as_bytes(*bytes).data(), length, folder)
               : parser.LoadASCIIFromString(&out->model_, &error, &warning, bytes->data(), length, folder);
    if (!read && bytes->find("KHR_draco_mesh_compression") != std::string::npos)  // the parser would not report it
      return out->error("it uses Draco compression, which is not supported");
    if (out->model_.asset.version.starts_with("1")) return out->of_another_version(out->model_.asset.version);
    if (!read) return out->error(first_line(error));
  } catch (const std::exception& e) {
    return out->error(first_line(e.what()));
  }
  if (const Status known = out->known(); !known) return known.error();
  return out;
}

Error GltfModel::of_another_version(const std::string& version) const {
  return error(fmt::format("it is glTF {}; only glTF 2 is supported", version));
}

Status GltfModel::known() const {
  if (model_.asset.version.rfind("2", 0) != 0) return of_another_version(model_.asset.version);
  for (const auto& needed : model_.extensionsRequired)
    if (needed.rfind("KHR_materials_", 0) != 0 && needed != "KHR_texture_transform" &&
        needed != "KHR_lights_punctual" && needed != "KHR_mesh_quantization")
      return error(fmt::format("it needs the extension {}, which is not supported", needed));
  return Nothing{};
}

std::vector<int> GltfModel::roots() const {
  const gltf::Scene* scene = gltf_at(model_.scenes, std::max(model_.defaultScene, 0));
  if (scene != nullptr && !scene->nodes.empty()) return scene->nodes;
  // Without a scene, takes every node without a parent.
  std::vector<bool> child(model_.nodes.size());
  for (const auto& n : model_.nodes)
    for (const int c : n.children)
      if (gltf_at(model_.nodes, c) != nullptr) child[static_cast<std::size_t>(c)] = true;
  std::vector<int> free;
  for (std::size_t i = 0; i < child.size(); ++i)
    if (!child[i]) free.push_back(static_cast<int>(i));
  return free;
}

Mat4 GltfModel::transform(const gltf::Node& n) {
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

// Depth first with an explicit stack, because a chain of nodes may be as long as the file.
Status GltfModel::each_node(const std::function<Status(int, int)>& use) const {
  std::vector<bool> visited(model_.nodes.size());
  const std::vector<int> first = roots();
  std::vector<std::pair<int, int>> open;
  for (auto root = first.rbegin(); root != first.rend(); ++root) open.emplace_back(*root, -1);
  while (!open.empty()) {
    const auto [i, parent] = open.back();
    open.pop_back();
    const gltf::Node* n = gltf_at(model_.nodes, i);
    if (n == nullptr) return error(fmt::format("there is no node {}", i));
    if (visited[static_cast<std::size_t>(i)])
      return error(fmt::format("node {} is below itself or has two parents", i));
    visited[static_cast<std::size_t>(i)] = true;
    if (const Status s = use(i, parent); !s) return s;
    for (auto c = n->children.rbegin(); c != n->children.rend(); ++c) open.emplace_back(*c, i);
  }
  return Nothing{};
}

Result<Mesh> GltfModel::triangles(const gltf::Primitive& primitive, const std::string& uv_set) const {
  Mesh piece;
  if (primitive.mode >= 0 && primitive.mode < TINYGLTF_MODE_TRIANGLES) return piece;  // points and lines
  if (primitive.attributes.count("POSITION") == 0) return piece;
  if (const Status s = vectors(primitive.attributes, "POSITION", piece.positions); !s) return s.error();
  if (const Status s = vectors(primitive.attributes, "NORMAL", piece.normals); !s) return s.error();
  if (const Status s = vectors(primitive.attributes, uv_set, piece.uvs); !s) return s.error();
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
        return error(fmt::format("a triangle uses vertex {}, but there are only {}", n, piece.positions.size()));
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
  return piece;
}

// Returns `count` elements of `size` bytes in a buffer view, after checking the bounds.
Result<GltfModel::Elements> GltfModel::elements(int view_index, std::size_t offset, std::size_t stride,
                                                std::size_t size, std::size_t count) const {
  const auto* view = gltf_at(model_.bufferViews, view_index);
  if (view == nullptr) return error(fmt::format("there is no buffer view {}", view_index));
  const auto* buffer = gltf_at(model_.buffers, view->buffer);
  if (buffer == nullptr) return error(fmt::format("there is no buffer {}", view->buffer));
  const std::size_t have = buffer->data.size();
  const bool inside = view->byteOffset <= have && view->byteLength <= have - view->byteOffset &&
                      offset <= view->byteLength && count <= most_elements && stride <= 65536 &&
                      (count == 0 || (count - 1) * stride + size <= view->byteLength - offset);
  if (!inside) return error(fmt::format("buffer view {} is shorter than its data", view_index));
  return Elements{buffer->data.data() + view->byteOffset + offset, stride};
}

Result<GltfNumbers> GltfModel::accessor(int i, std::size_t width) const {
  const gltf::Accessor* a = gltf_at(model_.accessors, i);
  if (a == nullptr) return error(fmt::format("there is no accessor {}", i));
  const int components = gltf::GetNumComponentsInType(static_cast<std::uint32_t>(a->type));
  const int bytes = gltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(a->componentType));
  if (components != static_cast<int>(width) || bytes < 1 || bytes > 4)
    return error(fmt::format("accessor {} has the wrong type", i));
  if (a->count > most_elements) return error(fmt::format("accessor {} has too many elements", i));
  const auto part = static_cast<std::size_t>(bytes);
  if (const Status fits = unpack(a->count * width * sizeof(float), path_); !fits) return fits.error();
  GltfNumbers out{{}, width};
  out.values.resize(a->count * width);
  if (a->bufferView >= 0 || !a->sparse.isSparse) {
    const auto* view = gltf_at(model_.bufferViews, a->bufferView);
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

// Replaces the elements that a sparse accessor lists.
Status GltfModel::replace(const gltf::Accessor& a, std::size_t part, GltfNumbers& out) const {
  const auto& sparse = a.sparse;
  const int index_bytes = gltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(sparse.indices.componentType));
  if (sparse.count < 0 || index_bytes < 1 || index_bytes > 4 || sparse.indices.byteOffset < 0 ||
      sparse.values.byteOffset < 0)
    return error("a sparse accessor is not valid");
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
    if (!(i >= 0 && i < static_cast<double>(out.count()))) return error("a sparse accessor is not valid");
    for (std::size_t k = 0; k < out.width; ++k)
      out.values[static_cast<std::size_t>(i) * out.width + k] =
          number(what->first + e * size + k * part, a.componentType, a.normalized);
  }
  return Nothing{};
}

Status GltfModel::look(int i, MeshPart& look, std::string& uv_set) {
  uv_set = "TEXCOORD_0";
  if (i < 0) return Nothing{};
  const gltf::Material* m = gltf_at(model_.materials, i);
  if (m == nullptr) return error(fmt::format("there is no material {}", i));
  const auto& base = m->pbrMetallicRoughness;
  for (std::size_t k = 0; k < 3 && k < base.baseColorFactor.size(); ++k)
    if (const double c = base.baseColorFactor[k]; std::isfinite(c)) look.color[k] = static_cast<float>(c);
  if (base.baseColorTexture.index < 0) return Nothing{};
  uv_set = fmt::format("TEXCOORD_{}", base.baseColorTexture.texCoord);
  auto found = picture(base.baseColorTexture.index);
  if (!found) return found.error();
  look.texture = with_alpha_of(*m, *found);
  return Nothing{};
}

// A texture is transparent only as far as the material says.
std::shared_ptr<const Picture> GltfModel::with_alpha_of(const gltf::Material& m,
                                                        const std::shared_ptr<const Picture>& picture) {
  const auto& base = m.pbrMetallicRoughness.baseColorFactor;
  const double cut = m.alphaMode == "MASK" ? m.alphaCutoff / (base.size() == 4 ? std::max(base[3], 1e-6) : 1.0) : 0;
  if (m.alphaMode == "BLEND" || !std::isfinite(cut)) return picture;
  auto& known = cut_[{picture, cut}];
  if (!known) known = cut > 0 ? cut_at(*picture, cut) : opaque(picture);
  return known;
}

Result<std::shared_ptr<const Picture>> GltfModel::picture(int number) {
  const gltf::Texture* texture = gltf_at(model_.textures, number);
  const gltf::Image* image = texture == nullptr ? nullptr : gltf_at(model_.images, texture->source);
  if (image == nullptr) return error(fmt::format("there is no texture {}, which a material needs", number));
  auto& known = pictures_[texture->source];
  if (!known && image->bufferView < 0 && image->image.empty() && !image->uri.empty())
    return fail(ErrorCode::file, fmt::format("there is no picture {}, which {} needs", image->uri, path_));
  if (!known) {
    std::span<const std::uint8_t> bytes = image->image;
    if (const auto* view = gltf_at(model_.bufferViews, image->bufferView)) {
      const auto there = elements(image->bufferView, 0, 1, 1, view->byteLength);
      if (!there) return there.error();
      bytes = {there->first, view->byteLength};
    }
    auto picture = decode_picture(bytes, image->uri.empty() ? fmt::format("picture {} in {}", texture->source, path_)
                                                            : fmt::format("{} of {}", image->uri, path_));
    if (!picture) return picture.error();
    known = *picture;
  }
  return known;
}

}  // namespace betwixt
