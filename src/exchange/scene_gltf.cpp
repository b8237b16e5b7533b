// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Reads a scene of glTF 2: nodes, meshes with skins and morph targets, cameras, lights, animation.
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "exchange/gltf_finish.h"
#include "exchange/gltf_model.h"
#include "exchange/scene_maker.h"
#include "exchange/unpacking.h"
#include "scene/functions.h"
#include "scene/kinds.h"

namespace betwixt {
namespace {

namespace gltf = tinygltf;

class GltfScene : SceneMaker {
 public:
  explicit GltfScene(GltfModel& file) : file_(file), model_(file.model()) {}

  Result<std::shared_ptr<const SceneFile>> read() && {
    for (const auto& step : {&GltfScene::nodes, &GltfScene::seen, &GltfScene::animations})
      if (const Status s = (this->*step)(); !s) return s.error();
    const auto& used = model_.extensionsUsed;
    if (std::find(used.begin(), used.end(), "KHR_animation_pointer") != used.end())
      leave_out("animated colours, opacity and lenses (KHR_animation_pointer) keep their first values");
    if (const auto* shown = gltf_at(model_.scenes, std::max(model_.defaultScene, 0));
        shown && shown->extras.Has("cuts"))
      leave_out("cuts between cameras are left out: write them as look through CAMERA");
    if (model_.scenes.size() > 1) leave_out("only the default scene of the file is read; the others are left out");
    if (!sound(out_)) return file_.error("it has numbers that are not valid");
    return std::make_shared<const SceneFile>(std::move(out_));
  }

 private:
  // ---- nodes

  Status nodes() {
    number_.assign(model_.nodes.size(), -1);
    return file_.each_node([&](int i, int parent) -> Status {
      if (out_.nodes.size() >= most_nodes) return file_.error(fmt::format("it has more than {} nodes", most_nodes));
      const gltf::Node& n = model_.nodes[static_cast<std::size_t>(i)];
      number_[static_cast<std::size_t>(i)] = static_cast<std::int32_t>(out_.nodes.size());
      SceneNode made;
      made.parent = parent < 0 ? -1 : number_[static_cast<std::size_t>(parent)];
      made.name = names_.give(n.name, n.mesh >= 0 ? "mesh" : n.camera >= 0 ? "camera" : "node");
      place(n, made);
      out_.nodes.push_back(std::move(made));
      return Nothing{};
    });
  }

  void place(const gltf::Node& n, SceneNode& to) {
    if (n.matrix.size() == 16) {
      if (!put_transform(GltfModel::transform(n), to))
        leave_out("shear is not supported: a sheared node is drawn without it");
      return;
    }
    const auto vector = [](const std::vector<double>& v) { return Vec3{v[0], v[1], v[2]}; };
    if (n.translation.size() == 3) to.position = vector(n.translation);
    if (n.rotation.size() == 4)
      to.rotation = normalize(Quat{n.rotation[3], n.rotation[0], n.rotation[1], n.rotation[2]});
    if (n.scale.size() == 3) to.scale = vector(n.scale);
  }

  // ---- meshes, cameras and lights

  Status seen() {
    for (std::size_t i = 0; i < model_.nodes.size(); ++i) {
      if (number_[i] < 0) continue;
      const gltf::Node& n = model_.nodes[i];
      const auto at = static_cast<std::size_t>(number_[i]);
      if (n.mesh >= 0)
        if (const Status s = put_mesh(n, at); !s) return s;
      SceneNode& to = out_.nodes[at];
      if (n.camera >= 0)
        if (const Status s = put_camera(n.camera, to); !s) return s;
      if (const auto light = n.extensions.find("KHR_lights_punctual"); light != n.extensions.end())
        if (const Status s = put_light(light->second, to); !s) return s;
    }
    return Nothing{};
  }

  Status put_mesh(const gltf::Node& n, std::size_t at) {
    const gltf::Mesh* mesh = gltf_at(model_.meshes, n.mesh);
    if (mesh == nullptr) return file_.error(fmt::format("there is no mesh {}", n.mesh));
    if (n.skin >= 0 && gltf_at(model_.skins, n.skin) == nullptr)
      return file_.error(fmt::format("there is no skin {}", n.skin));
    const auto [known, fresh] = meshes_.try_emplace({n.mesh, n.skin});
    if (fresh) {
      auto made = read_mesh(*mesh, n.skin);
      if (!made) return made.error();
      for (SceneMesh& m : *made) {
        known->second.push_back(static_cast<std::int32_t>(out_.meshes.size()));
        m.name = mesh_names_.give(mesh->name.empty() ? out_.nodes[at].name : mesh->name, "mesh");
        out_.meshes.push_back(std::move(m));
      }
    }
    for (std::size_t k = 0; k < known->second.size(); ++k) {
      if (k > 0) {  // what has another surface is an object of its own
        SceneNode more;
        more.parent = static_cast<std::int32_t>(at);
        more.name = names_.give(out_.nodes[at].name, "mesh");
        if (out_.nodes.size() >= most_nodes) return file_.error(fmt::format("it has more than {} nodes", most_nodes));
        out_.nodes.push_back(std::move(more));
      }
      SceneNode& to = k > 0 ? out_.nodes.back() : out_.nodes[at];
      to.mesh = known->second[k];
      if (const Status s = put_rig(n, *mesh, to); !s) return s;
    }
    return Nothing{};
  }

  Status put_rig(const gltf::Node& n, const gltf::Mesh& mesh, SceneNode& to) const {
    const auto& rig = out_.meshes[static_cast<std::size_t>(to.mesh)].mesh->rig;
    if (rig && !rig->inverse_bind.empty())
      for (const int joint : model_.skins[static_cast<std::size_t>(n.skin)].joints) {
        if (gltf_at(model_.nodes, joint) == nullptr || number_[static_cast<std::size_t>(joint)] < 0)
          return file_.error(fmt::format("joint {} of a skin is not a node of the scene", joint));
        to.joints.push_back(static_cast<std::uint32_t>(number_[static_cast<std::size_t>(joint)]));
      }
    if (rig) to.weights = n.weights.empty() ? mesh.weights : n.weights;
    if (rig && to.weights.size() > rig->targets.size()) return file_.error("a mesh has more weights than targets");
    return Nothing{};
  }

  // Returns the mesh; one without a rig as a mesh for each of its surfaces. Empty if it has no triangles.
  Result<std::vector<SceneMesh>> read_mesh(const gltf::Mesh& mesh, int skin) {
    struct Group {
      SceneMesh surface;
      Assembly all;
    };
    std::vector<Group> groups;
    const bool rigged = skin >= 0 || std::any_of(mesh.primitives.begin(), mesh.primitives.end(),
                                                 [](const auto& p) { return !p.targets.empty(); });
    const std::vector<std::string> targets = target_names(mesh);
    const auto say = [this](std::string what) { leave_out(std::move(what)); };
    for (const gltf::Primitive& p : mesh.primitives) {
      MeshPart look;
      std::string uv_set;
      if (const Status s = file_.look(p.material, look, uv_set); !s) return s.error();
      auto piece = file_.triangles(p, uv_set);
      if (!piece) return piece.error();
      if (piece->triangles.empty()) {
        leave_out("points, lines and meshes without triangles are left out");
        continue;
      }
      SceneMesh surface;
      if (const gltf::Material* m = gltf_at(model_.materials, p.material))
        if (const Status s = put_surface(file_, *m, uv_set, say, surface); !s) return s.error();
      auto group = std::find_if(groups.begin(), groups.end(), [&](const Group& g) { return same(g.surface, surface); });
      if (group == groups.end() && rigged && !groups.empty()) {
        leave_out(
            "of a mesh with joints or morph targets and several materials, the parts keep their colours and textures, "
            "but "
            "all shine like the first one");
        group = groups.begin();
      }
      if (group == groups.end())
        group = groups.insert(group, {surface, Assembly(file_.path(), "scene", Assembly::Normals::flat)});
      if (p.attributes.contains("COLOR_0")) leave_out("vertex colours are left out");
      if (p.attributes.contains("JOINTS_1"))
        leave_out("each vertex uses its four strongest joints; the others are left out");
      Status added = Nothing{};
      if (rigged) {
        auto rig = rig_of(p, skin, targets);
        if (!rig) return rig.error();
        added = group->all.add(*std::move(piece), {}, std::move(look), *std::move(rig));
      } else {
        added = group->all.add(*std::move(piece), {}, std::move(look));
      }
      if (!added) return added.error();
    }
    std::vector<SceneMesh> out;
    for (Group& g : groups) {
      auto made = std::move(g.all).finish();
      if (!made) return made.error();
      g.surface.mesh = *std::move(made);
      out.push_back(std::move(g.surface));
    }
    return out;
  }

  // Returns names for display functions that differ from ours.
  static std::vector<std::string> target_names(const gltf::Mesh& mesh) {
    SceneNames names;
    for (const char* ours : {"world", "velocity"}) names.take(ours);
    for (const FunctionSpec& f : built_in_functions()) names.take(f.name);
    const gltf::Value said = mesh.extras.IsObject() ? mesh.extras.Get("targetNames") : gltf::Value();
    const std::size_t count = mesh.primitives.empty() ? 0 : mesh.primitives[0].targets.size();
    std::vector<std::string> out;
    for (std::size_t i = 0; i < count; ++i) {
      const gltf::Value* name = said.IsArray() && i < said.ArrayLen() ? &said.Get(i) : nullptr;
      out.push_back(names.give(name && name->IsString() ? name->Get<std::string>() : "", fmt::format("weight-{}", i)));
    }
    return out;
  }

  Result<Rig> rig_of(const gltf::Primitive& p, int skin, const std::vector<std::string>& targets) {
    Rig rig;
    if (p.targets.size() != targets.size()) return file_.error("the parts of a mesh have different morph targets");
    for (std::size_t i = 0; i < targets.size(); ++i) {
      Rig::Target t{targets[i], {}, {}};
      if (const Status s = file_.vectors(p.targets[i], "POSITION", t.positions); !s) return s.error();
      if (const Status s = file_.vectors(p.targets[i], "NORMAL", t.normals); !s) return s.error();
      for (const auto* all : {&t.positions, &t.normals})
        for (const auto& v : *all)
          if (!finite(widened(v))) return file_.error("a morph target has a number that is not finite");
      rig.targets.push_back(std::move(t));
    }
    if (skin < 0) return rig;
    if (const Status s = bind(model_.skins[static_cast<std::size_t>(skin)], rig); !s) return s.error();
    std::vector<std::array<float, 4>> joints;
    if (const Status s = file_.vectors(p.attributes, "JOINTS_0", joints); !s) return s.error();
    if (const Status s = file_.vectors(p.attributes, "WEIGHTS_0", rig.weights); !s) return s.error();
    if (joints.size() != rig.weights.size() || joints.empty())
      return file_.error("some of its vertices have no joints");
    for (std::size_t v = 0; v < joints.size(); ++v) {
      auto& weights = rig.weights[v];
      rig.joints.emplace_back();
      float sum = 0;
      for (std::size_t k = 0; k < 4; ++k) {
        if (!(joints[v][k] >= 0 && joints[v][k] < static_cast<float>(rig.inverse_bind.size())) ||
            !std::isfinite(weights[k]))
          return file_.error(
              fmt::format("a vertex uses joint {}, but there are only {}", joints[v][k], rig.inverse_bind.size()));
        rig.joints[v][k] = static_cast<std::uint16_t>(joints[v][k]);
        sum += weights[k];
      }
      if (!(sum > 0)) weights = {1, 0, 0, 0}, sum = 1;
      for (float& w : weights) w /= sum;
    }
    return rig;
  }
  static Vec3 widened(const std::array<float, 3>& v) { return {v[0], v[1], v[2]}; }

  Status bind(const gltf::Skin& skin, Rig& rig) const {
    if (skin.joints.empty() || skin.joints.size() > most_joints)
      return file_.error(
          fmt::format("a skin has {} joints; it must have from 1 to {}", skin.joints.size(), most_joints));
    rig.inverse_bind.resize(skin.joints.size());
    if (skin.inverseBindMatrices < 0) return Nothing{};
    const auto numbers = file_.accessor(skin.inverseBindMatrices, 16);
    if (!numbers) return numbers.error();
    if (numbers->count() < rig.inverse_bind.size()) return file_.error("a skin has fewer matrices than joints");
    for (std::size_t j = 0; j < rig.inverse_bind.size(); ++j) {
      Mat4& m = rig.inverse_bind[j];
      std::copy_n(numbers->values.begin() + static_cast<std::ptrdiff_t>(16 * j), 16, m.m.begin());
      if (!finite(m)) return file_.error("a skin has a number that is not finite");
      m(3, 0) = m(3, 1) = m(3, 2) = 0, m(3, 3) = 1;
    }
    return Nothing{};
  }

  static bool same(const SceneMesh& a, const SceneMesh& b) {
    const bool finish = a.finish == b.finish || (a.finish && b.finish && *a.finish == *b.finish);
    return finish && a.material == b.material && a.shininess == b.shininess && a.transparency == b.transparency;
  }

  Status put_camera(int i, SceneNode& to) {
    const gltf::Camera* c = gltf_at(model_.cameras, i);
    if (c == nullptr) return file_.error(fmt::format("there is no camera {}", i));
    SceneCamera made;
    if (c->type == "orthographic") {
      made.height = 2 * std::abs(c->orthographic.ymag);
    } else {
      const double wide = c->perspective.aspectRatio > 0 ? c->perspective.aspectRatio : 16.0 / 9;
      made.fov = 2 * std::atan(wide * std::tan(std::clamp(c->perspective.yfov, 1e-3, 3.0) / 2));
    }
    to.camera = static_cast<std::int32_t>(out_.cameras.size());
    out_.cameras.push_back(made);
    return Nothing{};
  }

  Status put_light(const gltf::Value& said, SceneNode& to) {
    const gltf::Value number = said.IsObject() ? said.Get("light") : gltf::Value();
    const gltf::Light* l = gltf_at(model_.lights, number.IsInt() ? number.GetNumberAsInt() : -1);
    if (l == nullptr) return file_.error("a node has a light that does not exist");
    SceneLight made;
    made.sun = l->type == "directional";
    if (l->color.size() == 3) made.color = {l->color[0], l->color[1], l->color[2]};
    const double intensity = std::isfinite(l->intensity) ? std::clamp(l->intensity, 0.0, 1e6) : 1;
    // A fully lit surface has pi lux. A lamp is equally bright near by; its range ends where a twentieth of the light
    // is left.
    made.intensity = made.sun ? intensity / pi : 1;
    made.range = l->range > 0 ? std::min(l->range, 1e6) : std::max(std::sqrt(20 * intensity / pi), 1e-3);
    if (l->type == "spot") leave_out("spotlights are not supported: a spotlight shines in all directions");
    if (!made.sun && model_.asset.generator != "Betwixt")
      leave_out("lamps fade to 0 at their range, not with the square of the distance");
    to.light = static_cast<std::int32_t>(out_.lights.size());
    out_.lights.push_back(made);
    return Nothing{};
  }

  // ---- animation

  Status animations() {
    std::size_t numbers = 0;
    for (const gltf::Animation& a : model_.animations) {
      SceneClip clip;
      clip.name = a.name;
      for (const gltf::AnimationChannel& c : a.channels) {
        auto made = track(a, c);
        if (!made) return made.error();
        if (made->times.empty()) continue;
        const std::size_t more = made->values.size() + made->times.size();
        if (const Status fits = unpack(more * sizeof(double), file_.path()); !fits) return fits;
        numbers += more;
        if (numbers > most_scene_numbers) return file_.error("its animation has more than 100 million numbers");
        clip.tracks.push_back(*std::move(made));
      }
      out_.clips.push_back(std::move(clip));
    }
    return Nothing{};
  }

  // Returns a track without times if we have no equivalent of its target.
  Result<SceneTrack> track(const gltf::Animation& a, const gltf::AnimationChannel& c) {
    SceneTrack out;
    static const std::map<std::string, SceneTrack::Path> paths{{"translation", SceneTrack::position},
                                                               {"rotation", SceneTrack::rotation},
                                                               {"scale", SceneTrack::scale},
                                                               {"weights", SceneTrack::weights}};
    const auto path = paths.find(c.target_path);
    if (path == paths.end())
      return leave_out(fmt::format("animation of '{}' is left out", c.target_path.substr(0, 40))), out;
    if (c.target_node < 0) return out;  // glTF says to ignore a channel without a node
    if (gltf_at(model_.nodes, c.target_node) == nullptr)
      return file_.error(fmt::format("an animation moves node {}, which does not exist", c.target_node));
    if (number_[static_cast<std::size_t>(c.target_node)] < 0) return out;
    const gltf::AnimationSampler* sampler = gltf_at(a.samplers, c.sampler);
    if (sampler == nullptr) return file_.error(fmt::format("an animation has no sampler {}", c.sampler));
    out.node = static_cast<std::uint32_t>(number_[static_cast<std::size_t>(c.target_node)]);
    out.path = path->second;
    if (out.path == SceneTrack::weights && !has_targets(out_.nodes[out.node]))
      return leave_out("weights of meshes that have no morph targets are left out"), out;
    out.way = sampler->interpolation == "STEP"          ? SceneTrack::step
              : sampler->interpolation == "CUBICSPLINE" ? SceneTrack::cubic
                                                        : SceneTrack::linear;
    const std::size_t width = out.path == SceneTrack::rotation ? 4 : out.path == SceneTrack::weights ? 1 : 3;
    auto times = file_.accessor(sampler->input, 1);
    if (!times) return times.error();
    auto values = file_.accessor(sampler->output, width);
    if (!values) return values.error();
    out.times = std::move(times->values), out.values = std::move(values->values);
    if (!std::is_sorted(out.times.begin(), out.times.end()) || !finite(out.times) || !finite(out.values))
      return file_.error("the times of an animation do not increase or are not finite");
    if (out.path == SceneTrack::rotation && out.way == SceneTrack::cubic && goes_round(out))
      leave_out("CUBICSPLINE rotations between quaternions of opposite signs take the short way, not the long one");
    return out;
  }

  // Returns whether two successive keys differ by more than half a turn as they are numbered.
  static bool goes_round(const SceneTrack& t) {
    for (std::size_t i = 16; i + 8 <= t.values.size(); i += 12) {
      double same = 0;
      for (std::size_t k = 0; k < 4; ++k) same += t.values[i + k] * t.values[i + k - 12];
      if (same < 0) return true;
    }
    return false;
  }

  bool has_targets(const SceneNode& n) const {
    const Rig* rig = n.mesh < 0 ? nullptr : out_.meshes[static_cast<std::size_t>(n.mesh)].mesh->rig.get();
    return rig != nullptr && !rig->targets.empty();
  }

  GltfModel& file_;
  const gltf::Model& model_;
  SceneNames mesh_names_;
  std::vector<std::int32_t> number_;                                 // by the file's nodes; -1: not in its scene
  std::map<std::pair<int, int>, std::vector<std::int32_t>> meshes_;  // by mesh and skin; empty: nothing visible
};

}  // namespace

Result<std::shared_ptr<const SceneFile>> load_gltf_scene(const std::string& path, FileSource& files) {
  return read_scene<GltfModel, GltfScene>(path, files);
}

}  // namespace betwixt
