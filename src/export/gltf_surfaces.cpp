// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "export/gltf_surfaces.h"

#include <fmt/format.h>

#include <algorithm>

#include "betwixt/picture.h"
#include "export/fit.h"
#include "program/compiled.h"

namespace betwixt::gltf {
namespace {

bool see_through(const Picture& p) {
  for (std::size_t i = 3; i < p.rgba.size(); i += 4)
    if (p.rgba[i] != 255) return true;
  return false;
}

}  // namespace

Result<std::size_t> Surfaces::add_mesh(const Seen& s, std::size_t form, const std::string& name) {
  const Seen::Form& f = s.forms[form];
  Json attributes = attributes_of(f), targets = Json::array();
  Json primitives = Json::array();
  std::vector<MeshPart> parts = f.mesh->parts;
  if (parts.empty()) {
    parts.emplace_back();
    parts[0].count = static_cast<std::uint32_t>(f.mesh->triangles.size());
  }
  if (s.skin >= 0)
    add_rig(*f.mesh->rig, !program_.compiled().skins[static_cast<std::size_t>(s.skin)].joints.empty(), attributes,
            targets);
  for (const MeshPart& part : parts) {
    if (part.count == 0) continue;
    const auto first = f.mesh->triangles.begin() + part.first;
    const Result<std::size_t> look = material(s, part, name);
    if (!look) return look.error();
    primitives.push_back(
        {{"attributes", attributes}, {"indices", indices({first, first + part.count})}, {"material", *look}});
    if (!targets.empty()) primitives.back()["targets"] = targets;
  }
  if (primitives.empty()) {  // lines
    MeshPart line;
    const Result<std::size_t> look = material(s, line, name);
    if (!look) return look.error();
    Json only{{"POSITION", attributes["POSITION"]}};
    primitives.push_back({{"attributes", only}, {"indices", indices(f.mesh->edges)}, {"material", *look}, {"mode", 1}});
  }
  // Equal meshes are stored once.
  const auto [same, fresh] = meshes_known_.try_emplace(primitives.dump(), meshes.size());
  if (fresh)
    meshes.push_back(
        {{"name", s.forms.size() > 1 ? fmt::format("{} {}", name, form + 1) : name}, {"primitives", primitives}});
  if (fresh && !targets.empty()) {
    Json names = Json::array();
    for (const Rig::Target& t : f.mesh->rig->targets) names.push_back(t.name);
    meshes.back()["extras"] = {{"targetNames", names}};
  }
  return same->second;
}

std::size_t Surfaces::indices(std::vector<std::uint32_t> all) {
  const auto [known, fresh] = indices_.try_emplace(all, 0);
  if (fresh) known->second = film_.buffer.whole(all);
  return known->second;
}

Result<std::size_t> Surfaces::material(const Seen& s, const MeshPart& part, const std::string& name) {
  std::array<double, 4> tint{1, 1, 1, 1};
  for (std::size_t i = 0; i < 3; ++i) tint[i] = part.color[i];
  const bool tinted = part.tinted;
  const Channel color = colors(s, tint, tinted);
  const bool flat = flat_film();
  std::array<double, 4> still = within_one(color.pieces.front().begin);
  if (!color.constant()) {
    // Most programs do not play this, so they show the object as it is when it is most opaque.
    for (const KeyPiece& p : color.pieces)
      for (const auto& at : {p.begin, p.end})
        if (at[3] > still[3] + 1e-6) still = within_one(at);
    leave_out(film_.made,
              "colors and opacity that change need KHR_animation_pointer, which three.js reads with an add-on and "
              "Blender ignores");
  }
  if (s.finish && color.constant())
    for (std::size_t i = 0; i < 3; ++i)
      still[i] = std::clamp(s.own_color[static_cast<int>(i)], 0.0, 1.0) * static_cast<double>(part.color[i]);
  Json pbr{{"baseColorFactor", numbers(still, 4)},
           {"metallicFactor", s.material == Material::metal ? 1 : 0},
           {"roughnessFactor",
            s.material == Material::matte ? 1 : static_cast<float>(1 - std::clamp(s.shininess, 0.0, 1.0))}};
  if (s.video) leave_out(film_.made, "videos become still pictures: those that are shown first");
  const auto& picture = s.texture ? s.texture : part.texture;
  if (picture) {
    const Result<std::size_t> texture = add_texture(picture);
    if (!texture) return texture.error();
    pbr["baseColorTexture"] = {{"index", *texture}};
  }
  Json m{{"pbrMetallicRoughness", pbr}, {"doubleSided", true}};
  if (s.finish)
    if (Status added = add_finish(*s.finish, m); !added) return added.error();
  const bool clear = std::any_of(color.pieces.begin(), color.pieces.end(),
                                 [](const KeyPiece& p) { return p.begin[3] < 1 || p.end[3] < 1; });
  if (clear || (picture && see_through(*picture))) m["alphaMode"] = "BLEND";
  if (s.material == Material::glow || flat) {
    m["extensions"] = {{"KHR_materials_unlit", Json::object()}};
    film_.use("KHR_materials_unlit");
  }
  // A material that varies belongs to one object; all its meshes share it.
  std::string key = m.dump();
  if (!color.constant()) key += fmt::format(" {} {} {} {}", s.id.index, tint[0], tint[1], tint[2]);
  const auto [known, fresh] = materials_known_.try_emplace(key, materials.size());
  if (!fresh) return known->second;
  Json named{{"name", name}};
  named.update(m);
  materials.push_back(named);
  if (!color.constant())
    film_.point(fmt::format("/materials/{}/pbrMetallicRoughness/baseColorFactor", known->second), color);
  return known->second;
}

namespace {

// Returns green of one picture and blue of another as one picture, as glTF wants roughness and metalness.
std::shared_ptr<const Picture> packed(const std::shared_ptr<const Picture>& rough,
                                      const std::shared_ptr<const Picture>& metal) {
  if (rough == metal) return rough;
  const Picture& size = rough ? *rough : *metal;
  auto made =
      std::make_shared<Picture>(Picture{size.width, size.height, std::vector<std::uint8_t>(size.rgba.size(), 255)});
  const auto at = [&](const std::shared_ptr<const Picture>& p, int x, int y, std::size_t channel) -> std::uint8_t {
    if (!p) return 255;
    const int there_x = x * p->width / made->width, there_y = y * p->height / made->height;
    return p->rgba[4 * (static_cast<std::size_t>(there_y) * static_cast<std::size_t>(p->width) +
                        static_cast<std::size_t>(there_x)) +
                   channel];
  };
  for (int y = 0; y < made->height; ++y)
    for (int x = 0; x < made->width; ++x) {
      const auto k =
          4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(made->width) + static_cast<std::size_t>(x));
      made->rgba[k + 1] = at(rough, x, y, 1), made->rgba[k + 2] = at(metal, x, y, 2);
    }
  return made;
}

std::array<double, 4> of_color(Vec3 c) { return {c.x, c.y, c.z, 1}; }

}  // namespace

// Adds what glTF and its extensions can say of a finish.
Status Surfaces::add_finish(const Finish& f, Json& m) {
  Json& pbr = m["pbrMetallicRoughness"];
  pbr["metallicFactor"] = f.metalness, pbr["roughnessFactor"] = f.roughness;
  const auto extend = [&](const char* name, Json what) {
    m["extensions"][name] = std::move(what);
    film_.use(name);
  };
  const auto picture = [&](const std::shared_ptr<const Picture>& p, Json& to, const char* name) -> Status {
    if (!p) return Nothing{};
    const Result<std::size_t> texture = add_texture(p);
    if (!texture) return texture.error();
    to[name] = {{"index", *texture}};
    return Nothing{};
  };
  std::shared_ptr<const Picture> both;
  if (f.roughness_map || f.metalness_map) {
    auto& known = packed_[{f.roughness_map.get(), f.metalness_map.get()}];
    if (!known) known = packed(f.roughness_map, f.metalness_map);
    both = known;
  }
  for (const Status& s :
       {picture(both, pbr, "metallicRoughnessTexture"), picture(f.normals, m, "normalTexture"),
        picture(f.occlusion_map, m, "occlusionTexture"), picture(f.emission_map, m, "emissiveTexture")})
    if (!s) return s;
  if (f.normals) m["normalTexture"]["scale"] = f.normal_strength;
  if (const double most = std::max({f.emission.x, f.emission.y, f.emission.z}); most > 0) {
    m["emissiveFactor"] = numbers(of_color(1 / std::max(most, 1.0) * f.emission), 3);
    if (most > 1) extend("KHR_materials_emissive_strength", {{"emissiveStrength", most}});
  }
  if (f.clearcoat > 0)
    extend("KHR_materials_clearcoat",
           {{"clearcoatFactor", f.clearcoat}, {"clearcoatRoughnessFactor", f.clearcoat_roughness}});
  if (!(f.sheen == Vec3{}))
    extend("KHR_materials_sheen",
           {{"sheenColorFactor", numbers(of_color(f.sheen), 3)}, {"sheenRoughnessFactor", f.sheen_roughness}});
  if (f.transmission > 0) extend("KHR_materials_transmission", {{"transmissionFactor", f.transmission}});
  if (f.transmission > 0 && f.thickness > 0)  // a body has one side
    extend("KHR_materials_volume", {{"thicknessFactor", f.thickness}}), m["doubleSided"] = false;
  if (f.ior != 1.5) extend("KHR_materials_ior", {{"ior", f.ior}});
  if (f.pattern != Pattern::none)
    leave_out(film_.made, "the patterns of materials such as oak are left out: their mean color and roughness stay");
  if (f.tile_x == 1 && f.tile_y == 1 && f.move_x == 0 && f.move_y == 0 && f.turn == 0) return Nothing{};
  const Json transform{{"scale", {f.tile_x, f.tile_y}}, {"offset", {f.move_x, f.move_y}}, {"rotation", -f.turn}};
  for (Json* to : {&pbr["baseColorTexture"], &pbr["metallicRoughnessTexture"], &m["normalTexture"],
                   &m["occlusionTexture"], &m["emissiveTexture"]})
    if (to->is_object()) (*to)["extensions"]["KHR_texture_transform"] = transform, film_.use("KHR_texture_transform");
  for (const char* name : {"baseColorTexture", "metallicRoughnessTexture"})
    if (pbr[name].is_null()) pbr.erase(name);
  for (const char* name : {"normalTexture", "occlusionTexture", "emissiveTexture"})
    if (m[name].is_null()) m.erase(name);
  return Nothing{};
}

bool Surfaces::flat_film() {
  if (!flat_) flat_ = program_.frame(options_.from).surroundings.flat;
  return *flat_;
}

// Returns colour and opacity as one channel.
Channel Surfaces::colors(const Seen& s, const std::array<double, 4>& tint, bool tinted) const {
  const auto at = [&](Time t) {
    std::array<double, 4> v{1, 1, 1, 1};
    if (tinted && !s.color.pieces.empty()) v = value_at(s.color, t);
    for (std::size_t i = 0; i < 3; ++i) v[i] *= tint[i];
    v[3] = s.opacity.pieces.empty() ? 1 : value_at(s.opacity, t)[0];
    return within_one(v);
  };
  if ((!tinted || s.color.pieces.empty() || s.color.constant()) && (s.opacity.pieces.empty() || s.opacity.constant()))
    return {4, false, {{KeyPiece::held, options_.from, options_.until, at(options_.from), at(options_.from), {}, {}}}};
  return follow(followed(program_.document(), 4, options_.keys.radians, at),
                keys_of({&s.color, &s.opacity}, options_.from, options_.until), options_.keys);
}

Result<std::size_t> Surfaces::add_texture(const std::shared_ptr<const Picture>& picture) {
  const auto [known, fresh] = textures_known_.try_emplace(picture.get(), textures.size());
  if (!fresh) return known->second;
  const Result<std::string> png = to_png(*picture);
  if (!png) return png.error();
  images.push_back({{"bufferView", film_.buffer.picture(*png)}, {"mimeType", "image/png"}});
  textures.push_back({{"sampler", 0}, {"source", images.size() - 1}});
  pictures_.push_back(picture);
  return known->second;
}

Json Surfaces::attributes_of(const Seen::Form& f) {
  const auto [known, fresh] = attributes_.try_emplace({f.mesh.get(), f.local.m});
  if (!fresh) return known->second;
  Json& attributes = known->second;
  std::vector<float> places, normals, uvs;
  const Mat4 turn =
      Mat4{{1 / f.local(0, 0), 0, 0, 0, 0, 1 / f.local(1, 1), 0, 0, 0, 0, 1 / f.local(2, 2), 0, 0, 0, 0, 1}};
  for (const auto& p : f.mesh->positions) {
    const Vec3 at = transform_point(f.local, {p[0], p[1], p[2]});
    places.insert(places.end(), {static_cast<float>(at.x), static_cast<float>(at.y), static_cast<float>(at.z)});
  }
  for (const auto& n : f.mesh->normals) {
    const Vec3 at = normalize(transform_vector(turn, {n[0], n[1], n[2]}));
    normals.insert(normals.end(), {static_cast<float>(at.x), static_cast<float>(at.y), static_cast<float>(at.z)});
  }
  for (const auto& uv : f.mesh->uvs) uvs.insert(uvs.end(), {uv[0], uv[1]});
  attributes["POSITION"] = film_.buffer.floats(places, 3, Buffer::vertices, true);
  if (normals.size() == places.size()) attributes["NORMAL"] = film_.buffer.floats(normals, 3, Buffer::vertices, false);
  if (!uvs.empty()) attributes["TEXCOORD_0"] = film_.buffer.floats(uvs, 2, Buffer::vertices, false);
  kept_.push_back(f.mesh);
  return attributes;
}

void Surfaces::add_rig(const Rig& rig, bool joints, Json& attributes, Json& targets) {
  if (joints) {
    std::vector<float> weights;
    for (const auto& w : rig.weights) weights.insert(weights.end(), w.begin(), w.end());
    attributes["JOINTS_0"] = film_.buffer.joints(rig.joints, rig.weights);
    attributes["WEIGHTS_0"] = film_.buffer.floats(weights, 4, Buffer::vertices, false);
  }
  for (const Rig::Target& t : rig.targets) {
    Json one = Json::object();
    const auto add = [&](const char* path, const Rig::Vectors& vectors) {
      std::vector<float> all;
      for (const auto& v : vectors) all.insert(all.end(), v.begin(), v.end());
      if (!all.empty()) one[path] = film_.buffer.floats(all, 3, Buffer::vertices, true);
    };
    add("POSITION", t.positions), add("NORMAL", t.normals);
    targets.push_back(one);
  }
}

}  // namespace betwixt::gltf
