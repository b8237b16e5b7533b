// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "exchange/assimp_model.h"

#include <assimp/config.h>
#include <assimp/material.h>
#include <assimp/postprocess.h>
#include <fmt/format.h>

#include <algorithm>
#include <assimp/IOStream.hpp>
#include <assimp/IOSystem.hpp>
#include <cstring>
#include <filesystem>

#include "base/files.h"
#include "exchange/pictures.h"

namespace betwixt {
namespace {

// A file in memory.
class Stream : public Assimp::IOStream {
 public:
  explicit Stream(std::string bytes) : bytes_(std::move(bytes)) {}
  size_t Read(void* to, size_t size, size_t count) override {
    if (size == 0) return 0;
    count = std::min(count, (bytes_.size() - at_) / size);
    if (count > 0) std::memcpy(to, bytes_.data() + at_, size * count);
    at_ += size * count;
    return count;
  }
  size_t Write(const void*, size_t, size_t) override { return 0; }
  aiReturn Seek(size_t offset, aiOrigin origin) override {
    const size_t base = origin == aiOrigin_SET ? 0 : origin == aiOrigin_CUR ? at_ : bytes_.size();
    if (base + offset > bytes_.size()) return aiReturn_FAILURE;  // a negative offset wraps around, as intended
    at_ = base + offset;
    return aiReturn_SUCCESS;
  }
  size_t Tell() const override { return at_; }
  size_t FileSize() const override { return bytes_.size(); }
  void Flush() override {}

 private:
  std::string bytes_;
  size_t at_ = 0;
};

// Read-only access to a files.
class Files : public Assimp::IOSystem {
 public:
  explicit Files(FileSource& files) : files_(files) {}
  bool Exists(const char* path) const override { return files_.has(path); }
  char getOsSeparator() const override { return '/'; }
  Assimp::IOStream* Open(const char* path, const char* mode) override {
    if (std::strpbrk(mode, "wa+") != nullptr) return nullptr;
    auto bytes = files_.read(path);
    return bytes ? new Stream(std::move(*bytes)) : nullptr;
  }
  void Close(Assimp::IOStream* stream) override { delete stream; }

 private:
  FileSource& files_;
};

// Returns the sides of polygons in the file; empty if none has more than three corners.
std::vector<std::uint32_t> drawn_edges(const aiMesh& mesh) {
  std::vector<std::uint32_t> edges;
  bool polygons = false;
  for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
    const aiFace& face = mesh.mFaces[f];
    polygons = polygons || face.mNumIndices > 3;
    for (unsigned i = 0; i < face.mNumIndices && face.mNumIndices >= 3; ++i)
      edges.insert(edges.end(), {face.mIndices[i], face.mIndices[(i + 1) % face.mNumIndices]});
  }
  if (!polygons) edges.clear();
  return edges;
}

bool has_empty_face(const aiMesh& mesh) {
  return std::any_of(mesh.mFaces, mesh.mFaces + mesh.mNumFaces, [](const aiFace& f) { return f.mNumIndices == 0; });
}

// Returns whether the Collada text is complete, with only whole numbers in its lists of indices. Otherwise the importer
// would create endless indices.
bool has_proper_indices(std::string_view text) {
  for (std::size_t at = text.find('<'); at != text.npos; at = text.find('<', at + 1)) {
    const std::size_t end = text.find_first_of("> \t\r\n/", at + 1);
    if (end == text.npos) return false;
    const std::string_view tag = text.substr(at + 1, end - at - 1);
    if (tag != "p" && tag != "vcount" && tag != "v" && tag != "h") continue;
    const std::size_t content = text.find('>', end);
    if (content == text.npos) return false;
    const std::size_t stop = text.find_first_not_of("0123456789+- \t\r\n", content + 1);
    if (text[content - 1] != '/' && (stop == text.npos || text[stop] != '<')) return false;
  }
  return text.find("</COLLADA") != text.npos;
}

}  // namespace

AssimpModel::AssimpModel(std::string path, FileSource& files, std::string as)
    : path_(std::move(path)), as_(std::move(as)), files_(files) {
  importer_.SetIOHandler(new Files(files));  // the importer owns it
}

Result<std::unique_ptr<AssimpModel>> AssimpModel::open(const std::string& path, FileSource& files,
                                                       const std::string& as) {
  const auto text = files.read(path);  // for our own message if the file is missing
  if (!text) return text.error();
  if (text->empty()) return fail(ErrorCode::file, fmt::format("{} is empty", path));
  if (ending(path) == "dae" && !has_proper_indices(*text))
    return Assembly(path, as).error("it is incomplete, or an index list contains something other than numbers");
  // The importer frees embedded pictures of a damaged text FBX twice, so such files are read without pictures.
  const bool textures = text->starts_with("Kaydara FBX Binary") || text->find("Content:") == std::string::npos;
  try {
    auto out = std::make_unique<AssimpModel>(path, files, as);
    if (const Status s = out->read(textures, as == "scene"); !s) return s.error();
    return out;
  } catch (const std::exception& e) {
    return Assembly(path, as).error(e.what());
  }
}

// `bare`: accepts files without meshes, and keeps a node's animation in one place.
Status AssimpModel::read(bool textures, bool bare) {
  importer_.SetPropertyBool(AI_CONFIG_IMPORT_FBX_READ_TEXTURES, textures);
  if (bare) {
    importer_.SetPropertyBool(AI_CONFIG_IMPORT_FBX_PRESERVE_PIVOTS, false);
    importer_.SetPropertyBool(AI_CONFIG_IMPORT_NO_SKELETON_MESHES, true);
  }
  const aiScene* scene = importer_.ReadFile(path_, 0);
  if (scene == nullptr) return error(importer_.GetErrorString());
  if (scene->mRootNode == nullptr || (scene->mNumMeshes == 0 && !bare)) return error("it has no triangles");
  for (unsigned i = 0; i < scene->mNumMeshes; ++i) {
    // The next step would crash on such a face.
    if (has_empty_face(*scene->mMeshes[i])) return error("it has a face without corners");
    edges_.push_back(drawn_edges(*scene->mMeshes[i]));
  }
  // Not earlier, because the edges inside a polygon must not be drawn.
  scene_ = scene->mNumMeshes == 0 ? scene : importer_.ApplyPostProcessing(aiProcess_Triangulate);
  if (scene_ == nullptr) return error(importer_.GetErrorString());
  return Nothing{};
}

Mat4 AssimpModel::matrix(const aiMatrix4x4& a) {
  Mat4 m;
  for (unsigned r = 0; r < 4; ++r)
    for (unsigned c = 0; c < 4; ++c) m(static_cast<int>(r), static_cast<int>(c)) = static_cast<double>(a[r][c]);
  return m;
}

Mat4 AssimpModel::upright() const {
  int up = 1, sign = 1;
  if (scene_->mMetaData == nullptr || !scene_->mMetaData->Get("UpAxis", up) || up != 2) return {};
  scene_->mMetaData->Get("UpAxisSign", sign);
  return rotation(axis_angle({1, 0, 0}, sign < 0 ? pi / 2 : -pi / 2));
}

Mesh AssimpModel::piece(unsigned index) const {
  const aiMesh& mesh = *scene_->mMeshes[index];
  Mesh piece;
  const auto vectors = [&](const aiVector3D* from, auto& to) {
    for (unsigned i = 0; from != nullptr && i < mesh.mNumVertices; ++i)
      to.push_back({static_cast<float>(from[i].x), static_cast<float>(from[i].y), static_cast<float>(from[i].z)});
  };
  vectors(mesh.mVertices, piece.positions);
  vectors(mesh.mNormals, piece.normals);
  // In these files v = 0 is the bottom of the picture.
  for (unsigned i = 0; mesh.HasTextureCoords(0) && i < mesh.mNumVertices; ++i)
    piece.uvs.push_back({mesh.mTextureCoords[0][i].x, 1 - mesh.mTextureCoords[0][i].y});
  for (unsigned f = 0; f < mesh.mNumFaces; ++f)
    if (const aiFace& face = mesh.mFaces[f]; face.mNumIndices == 3)
      piece.triangles.insert(piece.triangles.end(), face.mIndices, face.mIndices + 3);
  piece.edges = edges_[index];
  return piece;
}

MeshPart AssimpModel::look(unsigned index) {
  MeshPart part;
  if (index >= scene_->mNumMaterials) return part;
  const aiMaterial& material = *scene_->mMaterials[index];
  aiColor3D color(1, 1, 1);
  aiString name;
  if (material.Get(AI_MATKEY_COLOR_DIFFUSE, color) == aiReturn_SUCCESS && color == color)
    part.color = {color.r, color.g, color.b};
  if (material.GetTexture(aiTextureType_DIFFUSE, 0, &name) == aiReturn_SUCCESS ||
      material.GetTexture(aiTextureType_BASE_COLOR, 0, &name) == aiReturn_SUCCESS)
    part.texture = texture(name);
  return part;
}

// Returns nullptr if the picture is unavailable: these files often name pictures on their author's machine.
std::shared_ptr<const Picture> AssimpModel::texture(const aiString& name) {
  const auto [known, fresh] = pictures_.try_emplace(name.C_Str());
  if (!fresh) return known->second;
  if (const aiTexture* inside = scene_->GetEmbeddedTexture(name.C_Str()); inside != nullptr) {
    // Raw texels, which no supported format contains.
    if (inside->mHeight != 0 || inside->pcData == nullptr) return nullptr;
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(inside->pcData);
    if (auto picture = decode_picture({bytes, inside->mWidth}, name.C_Str())) known->second = *picture;
    return known->second;
  }
  std::string relative = name.C_Str();
  std::replace(relative.begin(), relative.end(), '\\', '/');
  const auto folder = std::filesystem::path(path_).parent_path();
  for (const auto& at : {folder / relative, folder / std::filesystem::path(relative).filename()}) {
    if (!files_.has(at.string())) continue;
    if (auto picture = parse_picture(at.string(), files_)) known->second = *picture;
    break;
  }
  return known->second;
}

}  // namespace betwixt
