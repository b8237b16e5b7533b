// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Reads a scene of BVH, FBX or Collada from assimp: nodes, meshes with skins, cameras, lights, and keys with linear
// interpolation.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/files.h"
#include "exchange/assimp_model.h"
#include "exchange/scene_maker.h"
#include "exchange/unpacking.h"

namespace betwixt {
namespace {

Vec3 vec(const aiVector3D& v) { return {v.x, v.y, v.z}; }
bool same(Vec3 a, Vec3 b) { return length(a - b) <= 1e-6 * (1 + length(b)); }

class AssimpScene : SceneMaker {
 public:
  explicit AssimpScene(AssimpModel& file) : file_(file), scene_(file.scene()) {}

  Result<std::shared_ptr<const SceneFile>> read() && {
    for (const auto& step : {&AssimpScene::nodes, &AssimpScene::meshes, &AssimpScene::animations})
      if (const Status s = (this->*step)(); !s) return s.error();
    cameras(), lights();
    if (!sound(out_)) return file_.error("it has numbers that are not valid");
    return std::make_shared<const SceneFile>(std::move(out_));
  }

 private:
  Status nodes() {
    std::vector<std::pair<const aiNode*, std::int32_t>> open{{scene_.mRootNode, -1}};
    while (!open.empty()) {
      const auto [node, parent] = open.back();
      open.pop_back();
      if (out_.nodes.size() >= most_nodes) return file_.error(fmt::format("it has more than {} nodes", most_nodes));
      const auto number = static_cast<std::int32_t>(out_.nodes.size());
      SceneNode made;
      made.parent = parent;
      made.name = names_.give(node->mName.C_Str(), node->mNumMeshes > 0 ? "mesh" : "node");
      const Mat4 own = AssimpModel::matrix(node->mTransformation);
      if (!put_transform(parent < 0 ? file_.upright() * own : own, made))
        leave_out("shear is not supported: a sheared node is drawn without it");
      out_.nodes.push_back(std::move(made));
      nodes_.push_back(node);
      known_.try_emplace(node->mName.C_Str(), number);
      for (unsigned i = node->mNumChildren; i-- > 0;) open.emplace_back(node->mChildren[i], number);
    }
    return Nothing{};
  }

  // ---- meshes

  Status meshes() {
    SceneNames names;
    std::map<std::vector<unsigned>, std::int32_t> known;
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      std::vector<unsigned> parts(nodes_[i]->mMeshes, nodes_[i]->mMeshes + nodes_[i]->mNumMeshes);
      std::erase_if(parts, [&](unsigned m) { return m >= scene_.mNumMeshes; });
      if (parts.empty()) continue;
      const auto [at, fresh] = known.try_emplace(parts, -1);
      if (fresh) {
        SceneMesh made;
        if (const Status s = mesh(parts, made); !s) return s;
        if (made.mesh) {
          made.name = names.give(out_.nodes[i].name, "mesh");
          at->second = static_cast<std::int32_t>(out_.meshes.size());
          out_.meshes.push_back(std::move(made));
        }
      }
      out_.nodes[i].mesh = at->second;
      if (at->second >= 0) out_.nodes[i].joints = joints_of(parts);
    }
    return Nothing{};
  }

  // Returns the bones of all parts, part by part.
  std::vector<std::uint32_t> joints_of(const std::vector<unsigned>& parts) const {
    std::vector<std::uint32_t> out;
    for (const unsigned m : parts)
      for (unsigned b = 0; b < scene_.mMeshes[m]->mNumBones; ++b)
        out.push_back(static_cast<std::uint32_t>(known_.at(scene_.mMeshes[m]->mBones[b]->mName.C_Str())));
    return out;
  }

  Status mesh(const std::vector<unsigned>& parts, SceneMesh& out) {
    std::vector<Mat4> binds;
    for (const unsigned m : parts)
      for (unsigned b = 0; b < scene_.mMeshes[m]->mNumBones; ++b) {
        const aiBone& bone = *scene_.mMeshes[m]->mBones[b];
        if (!known_.contains(bone.mName.C_Str())) return file_.error("a vertex uses a joint that does not exist");
        binds.push_back(AssimpModel::matrix(bone.mOffsetMatrix));
        if (!finite(binds.back())) return file_.error("a skin has a number that is not finite");
      }
    if (binds.size() > most_joints)
      return file_.error(fmt::format("a skin has {} joints; the limit is {}", binds.size(), most_joints));
    Assembly all(file_.path(), "scene");
    bool any = false;
    std::size_t first = 0;
    for (const unsigned m : parts) {
      const aiMesh& from = *scene_.mMeshes[m];
      Mesh piece = file_.piece(m);
      if (from.mNumAnimMeshes > 0) leave_out("morph targets are left out: only those of glTF are supported");
      if (from.HasVertexColors(0)) leave_out("vertex colours are left out");
      if (piece.triangles.empty()) leave_out("points, lines and meshes without triangles are left out");
      MeshPart look = file_.look(from.mMaterialIndex);
      if (!any && from.mMaterialIndex < scene_.mNumMaterials) surface_of(*scene_.mMaterials[from.mMaterialIndex], out);
      any = any || !piece.triangles.empty();
      Status added = Nothing{};
      if (binds.empty()) {
        added = all.add(std::move(piece), {}, std::move(look));
      } else {
        Rig rig = rig_of(from, first);
        rig.inverse_bind = binds;
        added = all.add(std::move(piece), {}, std::move(look), std::move(rig));
      }
      if (!added) return added;
      first += from.mNumBones;
    }
    if (!any) return Nothing{};
    auto made = std::move(all).finish();
    if (!made) return made.error();
    out.mesh = *std::move(made);
    return Nothing{};
  }

  // Keeps the four strongest joints of each vertex. A vertex without joints follows the first one.
  Rig rig_of(const aiMesh& mesh, std::size_t first) {
    std::vector<std::vector<std::pair<float, std::uint16_t>>> all(mesh.mNumVertices);
    for (unsigned b = 0; b < mesh.mNumBones; ++b)
      for (unsigned w = 0; w < mesh.mBones[b]->mNumWeights; ++w)
        if (const aiVertexWeight& one = mesh.mBones[b]->mWeights[w];
            one.mVertexId < all.size() && one.mWeight > 0 && std::isfinite(one.mWeight))
          all[one.mVertexId].emplace_back(one.mWeight, static_cast<std::uint16_t>(first + b));
    Rig rig;
    for (auto& some : all) {
      std::sort(some.begin(), some.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
      if (some.size() > 4)
        leave_out("each vertex uses its four strongest joints; the others are left out"), some.resize(4);
      if (some.empty()) some.emplace_back(1.0F, std::uint16_t{0});
      float sum = 0;
      for (const auto& [weight, joint] : some) sum += weight;
      auto& joints = rig.joints.emplace_back();
      auto& weights = rig.weights.emplace_back();
      for (std::size_t k = 0; k < some.size(); ++k) joints[k] = some[k].second, weights[k] = some[k].first / sum;
    }
    return rig;
  }

  static void surface_of(const aiMaterial& m, SceneMesh& to) {
    float number = 1;
    if (m.Get(AI_MATKEY_OPACITY, number) == aiReturn_SUCCESS && number >= 0 && number <= 1)
      to.transparency = 1 - static_cast<double>(number);
  }

  // ---- cameras and lights: each on a node of its own, with its direction

  bool stand(const char* on, const char* what, Vec3 at, Vec3 direction, SceneNode& out) {
    const auto node = known_.find(on);
    if (node == known_.end() || !finite(at) || !finite(direction) || !(length(direction) > 0)) return false;
    out.parent = node->second;
    out.name = names_.give(fmt::format("{}-{}", out_.nodes[static_cast<std::size_t>(node->second)].name, what), what);
    return put_transform(look_at(at, at + normalize(direction)), out);
  }

  void cameras() {
    for (unsigned i = 0; i < scene_.mNumCameras; ++i) {
      const aiCamera& c = *scene_.mCameras[i];
      SceneNode node;
      if (!stand(c.mName.C_Str(), "camera", vec(c.mPosition), vec(c.mLookAt), node)) continue;
      node.camera = static_cast<std::int32_t>(out_.cameras.size());
      const double fov = c.mHorizontalFOV;
      out_.cameras.push_back({fov > 0.01 && fov < 3.1 ? fov : 0.9, 0});
      out_.nodes.push_back(std::move(node));
    }
  }

  void lights() {
    for (unsigned i = 0; i < scene_.mNumLights; ++i) {
      const aiLight& l = *scene_.mLights[i];
      if (l.mType == aiLightSource_AMBIENT) {
        leave_out("ambient light is left out: set it by the command ambient");
        continue;
      }
      SceneNode node;
      const bool sun = l.mType == aiLightSource_DIRECTIONAL;
      if (!stand(l.mName.C_Str(), "light", vec(l.mPosition), sun ? vec(l.mDirection) : Vec3{0, 0, -1}, node)) continue;
      if (l.mType == aiLightSource_SPOT)
        leave_out("spotlights are not supported: a spotlight shines in all directions");
      SceneLight made;
      made.sun = sun;
      const Vec3 color{l.mColorDiffuse.r, l.mColorDiffuse.g, l.mColorDiffuse.b};
      const double most = std::max({color.x, color.y, color.z});
      if (most > 0 && finite(color)) made.color = 1 / most * color;
      if (!sun) leave_out("the intensity and the range of lamps are left out: they have Betwixt's defaults");
      node.light = static_cast<std::int32_t>(out_.lights.size());
      out_.lights.push_back(made);
      out_.nodes.push_back(std::move(node));
    }
  }

  // ---- animation

  Status animations() {
    std::size_t numbers = 0;
    for (unsigned a = 0; a < scene_.mNumAnimations; ++a) {
      const aiAnimation& from = *scene_.mAnimations[a];
      const double rate = from.mTicksPerSecond > 0 ? from.mTicksPerSecond : 25;
      SceneClip clip;
      clip.name = from.mName.C_Str();
      for (unsigned c = 0; c < from.mNumChannels; ++c) {
        const aiNodeAnim& channel = *from.mChannels[c];
        const auto node = known_.find(channel.mNodeName.C_Str());
        if (node == known_.end()) continue;
        const std::uint64_t more = std::uint64_t{4} * channel.mNumPositionKeys +
                                   std::uint64_t{5} * channel.mNumRotationKeys +
                                   std::uint64_t{4} * channel.mNumScalingKeys;
        if (const Status fits = unpack(more * sizeof(double), file_.path()); !fits) return fits;
        if ((numbers += more) > most_scene_numbers)
          return file_.error("its animation has more than 100 million numbers");
        const SceneNode& rest = out_.nodes[static_cast<std::size_t>(node->second)];
        const auto add = [&](SceneTrack::Path path, auto* keys, unsigned count, auto&& put, auto&& stays) {
          SceneTrack t;
          t.node = static_cast<std::uint32_t>(node->second), t.path = path;
          for (unsigned k = 0; k < count; ++k) t.times.push_back(keys[k].mTime / rate), put(keys[k].mValue, t.values);
          if (count > 1 || (count == 1 && !stays(keys[0].mValue))) clip.tracks.push_back(std::move(t));
        };
        const auto three = [](const aiVector3D& v, std::vector<double>& to) { to.insert(to.end(), {v.x, v.y, v.z}); };
        const auto four = [](const aiQuaternion& q, std::vector<double>& to) {
          to.insert(to.end(), {q.x, q.y, q.z, q.w});
        };
        add(SceneTrack::position, channel.mPositionKeys, channel.mNumPositionKeys, three,
            [&](const aiVector3D& v) { return same(vec(v), rest.position); });
        add(SceneTrack::rotation, channel.mRotationKeys, channel.mNumRotationKeys, four, [&](const aiQuaternion& q) {
          return std::abs(dot(Quat{q.w, q.x, q.y, q.z}, rest.rotation)) > 1 - 1e-12;
        });
        add(SceneTrack::scale, channel.mScalingKeys, channel.mNumScalingKeys, three,
            [&](const aiVector3D& v) { return same(vec(v), rest.scale); });
      }
      if (ending(file_.path()) != "bvh") leave_out("the curves between keys are left out: all interpolation is linear");
      out_.clips.push_back(std::move(clip));
    }
    return Nothing{};
  }

  AssimpModel& file_;
  const aiScene& scene_;
  std::vector<const aiNode*> nodes_;           // by number
  std::map<std::string, std::int32_t> known_;  // by the file's names, the first of each
};

}  // namespace

Result<std::shared_ptr<const SceneFile>> load_scene_by_assimp(const std::string& path, FileSource& files) {
  return read_scene<AssimpModel, AssimpScene>(path, files);
}

}  // namespace betwixt
