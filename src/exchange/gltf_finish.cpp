// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "exchange/gltf_finish.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace betwixt {
namespace {

namespace gltf = tinygltf;

double bounded(double x, double low, double high, double otherwise) {
  return std::isfinite(x) ? std::clamp(x, low, high) : otherwise;
}

// An extension of a material; absent members have their defaults.
class Extension {
 public:
  Extension(const gltf::Material& m, const char* name) {
    if (const auto found = m.extensions.find(name); found != m.extensions.end()) value_ = found->second;
  }
  explicit operator bool() const { return value_.IsObject(); }
  double number(const char* name, double otherwise, double low = 0, double high = 1) const {
    if (!value_.Has(name) || !value_.Get(name).IsNumber()) return otherwise;
    return bounded(value_.Get(name).GetNumberAsDouble(), low, high, otherwise);
  }
  Vec3 color(const char* name, Vec3 otherwise) const {
    if (!value_.Has(name) || !value_.Get(name).IsArray() || value_.Get(name).ArrayLen() != 3) return otherwise;
    Vec3 c;
    for (std::size_t i = 0; i < 3; ++i) {
      const gltf::Value& part = value_.Get(name).Get(i);
      c[static_cast<int>(i)] = part.IsNumber() ? bounded(part.GetNumberAsDouble(), 0, 1e4, 0) : 0;
    }
    return c;
  }
  // Says that pictures of the extension are left out.
  void leave_pictures(const char* what, std::initializer_list<const char*> names, const SayLeftOut& leave_out) const {
    for (const char* name : names)
      if (value_.Has(name))
        return leave_out(fmt::format("pictures of {} are left out: the factors apply everywhere", what));
  }

 private:
  gltf::Value value_;
};

void add_extensions(const gltf::Material& m, Finish& f, const SayLeftOut& leave_out) {
  if (const Extension coat(m, "KHR_materials_clearcoat"); coat) {
    f.clearcoat = coat.number("clearcoatFactor", 0), f.clearcoat_roughness = coat.number("clearcoatRoughnessFactor", 0);
    coat.leave_pictures("clear coats", {"clearcoatTexture", "clearcoatRoughnessTexture", "clearcoatNormalTexture"},
                        leave_out);
  }
  if (const Extension sheen(m, "KHR_materials_sheen"); sheen) {
    f.sheen = sheen.color("sheenColorFactor", {}), f.sheen_roughness = sheen.number("sheenRoughnessFactor", 0);
    sheen.leave_pictures("sheen", {"sheenColorTexture", "sheenRoughnessTexture"}, leave_out);
  }
  if (const Extension through(m, "KHR_materials_transmission"); through) {
    f.transmission = through.number("transmissionFactor", 0);
    through.leave_pictures("transmission", {"transmissionTexture"}, leave_out);
  }
  if (const Extension ior(m, "KHR_materials_ior"); ior) f.ior = ior.number("ior", 1.5, 1, 4);
  if (const Extension volume(m, "KHR_materials_volume"); volume) {
    f.thickness = volume.number("thicknessFactor", 0, 0, 1e6);
    volume.leave_pictures("thickness", {"thicknessTexture"}, leave_out);
  }
  if (const Extension specular(m, "KHR_materials_specular"); specular) {
    f.specular = specular.number("specularFactor", 1);
    specular.leave_pictures("reflectance", {"specularTexture", "specularColorTexture"}, leave_out);
  }
  if (const Extension strength(m, "KHR_materials_emissive_strength"); strength)
    f.emission = strength.number("emissiveStrength", 1, 0, 1e6) * f.emission;
}

// The transform of a texture turns after scaling, ours before: they agree where it scales both ways alike.
void add_transform(const gltf::TextureInfo& info, Finish& f, const SayLeftOut& leave_out) {
  const auto found = info.extensions.find("KHR_texture_transform");
  if (found == info.extensions.end()) return;
  const gltf::Value& v = found->second;
  const auto pair = [&](const char* name, double& x, double& y) {
    if (!v.Has(name) || !v.Get(name).IsArray() || v.Get(name).ArrayLen() != 2) return;
    x = bounded(v.Get(name).Get(0).GetNumberAsDouble(), -1e6, 1e6, x),
    y = bounded(v.Get(name).Get(1).GetNumberAsDouble(), -1e6, 1e6, y);
  };
  pair("scale", f.tile_x, f.tile_y), pair("offset", f.move_x, f.move_y);
  if (v.Has("rotation")) f.turn = -bounded(v.Get("rotation").GetNumberAsDouble(), -1e3, 1e3, 0);
  if (f.turn != 0 && f.tile_x != f.tile_y) leave_out("texture transforms that turn and scale unevenly are not exact");
}

Result<std::shared_ptr<const Finish>> finish_of(GltfModel& model, const gltf::Material& m, const std::string& uv_set,
                                                const SayLeftOut& leave_out) {
  const auto& pbr = m.pbrMetallicRoughness;
  Finish f;
  f.metalness = bounded(pbr.metallicFactor, 0, 1, 1), f.roughness = bounded(pbr.roughnessFactor, 0, 1, 1);
  const bool between = f.metalness > 0 && f.metalness < 1;
  for (std::size_t i = 0; i < 3 && i < m.emissiveFactor.size(); ++i)
    f.emission[static_cast<int>(i)] = bounded(m.emissiveFactor[i], 0, 1e4, 0);
  Status read = Nothing{};
  const auto picture = [&](int texture, int coordinates, std::shared_ptr<const Picture>& to) {
    if (texture < 0 || !read) return;
    if (fmt::format("TEXCOORD_{}", coordinates) != uv_set)
      return leave_out("pictures with other texture coordinates than the colour are left out");
    auto found = model.picture(texture);
    if (!found)
      read = found.error();
    else
      to = *found;
  };
  picture(pbr.metallicRoughnessTexture.index, pbr.metallicRoughnessTexture.texCoord, f.roughness_map);
  f.metalness_map = f.roughness_map;
  picture(m.normalTexture.index, m.normalTexture.texCoord, f.normals);
  picture(m.occlusionTexture.index, m.occlusionTexture.texCoord, f.occlusion_map);
  picture(m.emissiveTexture.index, m.emissiveTexture.texCoord, f.emission_map);
  if (!read) return read.error();
  f.normal_strength = bounded(m.normalTexture.scale, -10, 10, 1);
  add_transform(pbr.baseColorTexture, f, leave_out);
  const Finish before = f;
  add_extensions(m, f, leave_out);
  const bool dark = f.emission == Vec3{};
  // A shininess is not quite a roughness: only our own files mean one.
  const bool ours = model.model().asset.generator.starts_with("Betwixt");
  const bool plain = ours && !between && dark && !f.has_pictures() && f == before && f.tile_x == 1 && f.tile_y == 1 &&
                     f.turn == 0 && f.move_x == 0 && f.move_y == 0;
  return plain ? nullptr : std::make_shared<const Finish>(f);
}

}  // namespace

Status put_surface(GltfModel& model, const gltf::Material& m, const std::string& uv_set, const SayLeftOut& leave_out,
                   SceneMesh& to) {
  const auto& pbr = m.pbrMetallicRoughness;
  const bool painted = pbr.metallicRoughnessTexture.index >= 0;
  to.material = bounded(pbr.metallicFactor, 0, 1, 1) >= 0.5 && !painted ? Material::metal : Material::plastic;
  to.shininess = 1 - bounded(pbr.roughnessFactor, 0, 1, 1);
  if (m.alphaMode == "BLEND" && pbr.baseColorFactor.size() == 4)
    to.transparency = 1 - bounded(pbr.baseColorFactor[3], 0, 1, 1);
  if (m.extensions.contains("KHR_materials_unlit")) to.material = Material::glow;
  static const std::set<std::string_view> known{"KHR_materials_unlit",        "KHR_materials_emissive_strength",
                                                "KHR_materials_clearcoat",    "KHR_materials_sheen",
                                                "KHR_materials_transmission", "KHR_materials_ior",
                                                "KHR_materials_volume",       "KHR_materials_specular"};
  for (const auto& [name, value] : m.extensions)
    if (!known.contains(name)) leave_out(fmt::format("the material extension {} is left out", name.substr(0, 60)));
  if (to.material == Material::glow) return Nothing{};
  auto finish = finish_of(model, m, uv_set, leave_out);
  if (!finish) return finish.error();
  to.finish = *finish;
  return Nothing{};
}

}  // namespace betwixt
