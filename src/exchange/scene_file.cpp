// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "exchange/scene_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/files.h"
#include "exchange/scene_names.h"

namespace betwixt {
namespace {

constexpr std::size_t longest_name = 60;

bool ascii_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

std::string plain(std::string_view wanted, std::string_view otherwise) {
  std::string out;
  for (const char c : wanted.substr(0, longest_name)) {
    const bool fits = ascii_letter(c) || (c >= '0' && c <= '9') || c == '_';
    if (fits || (!out.empty() && out.back() != '-')) out += fits ? c : '-';
  }
  while (!out.empty() && out.back() == '-') out.pop_back();
  if (out.empty()) return std::string(otherwise);
  return ascii_letter(out[0]) ? out : std::string(otherwise) + "-" + out;
}

bool tracks_fit(const SceneFile& s, const SceneTrack& t) {
  if (t.node >= s.nodes.size() || t.path > SceneTrack::weights || t.way > SceneTrack::cubic || t.times.empty())
    return false;
  const SceneNode& n = s.nodes[t.node];
  const std::size_t per = t.way == SceneTrack::cubic ? 3 : 1;
  std::size_t width = t.path == SceneTrack::rotation ? 4 : 3;
  if (t.path == SceneTrack::weights) {
    if (n.mesh < 0) return false;
    const auto& rig = s.meshes[static_cast<std::size_t>(n.mesh)].mesh->rig;
    width = rig ? rig->targets.size() : 0;
  }
  return width > 0 && t.values.size() == t.times.size() * per * width && finite(t.values) && finite(t.times) &&
         std::is_sorted(t.times.begin(), t.times.end()) && std::abs(t.times.front()) < 1e8 &&
         std::abs(t.times.back()) < 1e8;
}

bool known(std::int32_t i, std::size_t count) { return i >= -1 && i < static_cast<std::int64_t>(count); }

bool turns(Quat q) { return std::isfinite(dot(q, q)) && dot(q, q) > 0; }

bool sound_node(const SceneFile& s, std::size_t i) {
  const SceneNode& n = s.nodes[i];
  if (n.parent < -1 || n.parent >= static_cast<std::int64_t>(i) || !known(n.mesh, s.meshes.size()) ||
      !known(n.camera, s.cameras.size()) || !known(n.light, s.lights.size()))
    return false;
  if (!finite(n.position) || !turns(n.rotation) || !finite(n.scale) || !finite(n.weights)) return false;
  const Rig* rig = n.mesh >= 0 ? s.meshes[static_cast<std::size_t>(n.mesh)].mesh->rig.get() : nullptr;
  if (n.joints.size() != (rig ? rig->inverse_bind.size() : 0)) return false;
  if (n.weights.size() > (rig ? rig->targets.size() : 0)) return false;
  return std::all_of(n.joints.begin(), n.joints.end(), [&](std::uint32_t j) { return j < s.nodes.size(); });
}

}  // namespace

std::string SceneNames::give(std::string_view wanted, std::string_view otherwise) {
  const std::string base = plain(wanted, otherwise);
  if (taken_.insert(base).second) return base;
  int& n = next_.try_emplace(base, 2).first->second;
  for (;; ++n)
    if (std::string numbered = fmt::format("{}-{}", base, n); taken_.insert(numbered).second) return numbered;
}

std::span<const NamedPicture> pictures_of_finish() {
  static constexpr NamedPicture rows[] = {{"normals", &Finish::normals},
                                          {"roughness", &Finish::roughness_map},
                                          {"metalness", &Finish::metalness_map},
                                          {"occlusion", &Finish::occlusion_map},
                                          {"emission", &Finish::emission_map}};
  return rows;
}

std::string scene_of(const std::string& path) { return path.substr(0, path.find('#')); }

bool put_transform(const Mat4& m, SceneNode& to) {
  to.position = translation_of(m);
  to.scale = {length(column(m, 0)), length(column(m, 1)), length(column(m, 2))};
  if (determinant(m) < 0) to.scale.x = -to.scale.x;
  Mat4 turn;
  for (int c = 0; c < 3; ++c)
    for (int i = 0; i < 3 && to.scale[c] != 0; ++i) turn(i, c) = m(i, c) / to.scale[c];
  to.rotation = from_matrix(turn);
  const Mat4 again = translation(to.position) * rotation(to.rotation) * scaling(to.scale);
  return std::equal(again.m.begin(), again.m.end(), m.m.begin(),
                    [&](double a, double b) { return std::abs(a - b) <= 1e-5 * (1 + length(to.scale)); });
}

bool sound(const SceneFile& s) {
  if (s.nodes.size() > most_nodes) return false;
  for (const SceneMesh& m : s.meshes)
    if (!m.mesh || m.material > Material::glow || !(m.shininess >= 0 && m.shininess <= 1) ||
        !(m.transparency >= 0 && m.transparency <= 1))
      return false;
  for (std::size_t i = 0; i < s.nodes.size(); ++i)
    if (!sound_node(s, i)) return false;
  for (const SceneCamera& c : s.cameras)
    if (!(c.fov >= 0 && c.fov < 3.2) || !(c.height >= 0 && c.height < 1e9)) return false;
  for (const SceneLight& l : s.lights)
    if (!finite(l.color) || !(l.intensity >= 0 && l.intensity < 1e9) || !(l.range >= 0 && l.range < 1e9)) return false;
  for (const SceneClip& c : s.clips)
    for (const SceneTrack& t : c.tracks)
      if (!tracks_fit(s, t)) return false;
  return true;
}

Result<std::shared_ptr<const SceneFile>> parse_scene(const std::string& path, FileSource& files) {
  const std::string kind = ending(path);
  if (kind == "gltf" || kind == "glb") return load_gltf_scene(path, files);
  for (const char* known : {"bvh", "dae", "fbx"})
    if (kind == known) return load_scene_by_assimp(path, files);
  const auto bytes = files.read(path);  // a missing file is reported before a wrong ending
  if (!bytes) return bytes.error();
  return fail(ErrorCode::file, fmt::format("the format of the scene {} is not supported", path),
              "supported: glTF (.gltf .glb), .bvh .dae .fbx and drawings (.svg)");
}

}  // namespace betwixt
