// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "scene/materials.h"

#include <algorithm>

namespace betwixt {
namespace {

// Reflectances of metals at normal incidence, and albedos of other materials, are measured ones from the literature on
// physically based shading, in linear sRGB.
MaterialRow plain(std::string_view word, Material old) { return {word, old, true, {1, 1, 1}, finish_of(old, 0)}; }

MaterialRow metal(std::string_view word, Vec3 color, double roughness) {
  Finish f;
  f.metalness = 1, f.roughness = roughness;
  return {word, Material::metal, false, color, f};
}
MaterialRow insulator(std::string_view word, Vec3 color, double roughness) {
  Finish f;
  f.roughness = roughness;
  return {word, Material::plastic, false, color, f};
}
MaterialRow patterned(MaterialRow row, Pattern pattern, Vec3 second, double bumps) {
  row.finish.pattern = pattern, row.finish.second = second, row.finish.pattern_bumps = bumps;
  return row;
}
MaterialRow coated(MaterialRow row, double coat, double roughness) {
  row.finish.clearcoat = coat, row.finish.clearcoat_roughness = roughness;
  return row;
}
MaterialRow clear(std::string_view word, Vec3 color, double roughness, double ior, double thickness) {
  MaterialRow row = insulator(word, color, roughness);
  row.finish.transmission = 1, row.finish.ior = ior, row.finish.thickness = thickness;
  return row;
}
MaterialRow cloth(MaterialRow row, Vec3 sheen, double roughness) {
  row.finish.sheen = sheen, row.finish.sheen_roughness = roughness;
  return row;
}
MaterialRow waxy(MaterialRow row, double specular) {
  row.finish.specular = specular;
  return row;
}

const MaterialRow rows[] = {
    plain("plastic", Material::plastic),
    plain("matte", Material::matte),
    plain("metal", Material::metal),
    plain("glow", Material::glow),
    // Metals.
    metal("gold", {1.0, 0.71, 0.29}, 0.18),
    metal("silver", {0.96, 0.95, 0.91}, 0.12),
    metal("copper", {0.95, 0.60, 0.43}, 0.22),
    metal("brass", {0.88, 0.69, 0.36}, 0.24),
    metal("bronze", {0.70, 0.46, 0.25}, 0.32),
    metal("chrome", {0.60, 0.61, 0.62}, 0.03),
    metal("aluminium", {0.91, 0.92, 0.92}, 0.28),
    metal("iron", {0.53, 0.51, 0.49}, 0.45),
    metal("titanium", {0.54, 0.50, 0.45}, 0.34),
    metal("steel", {0.62, 0.61, 0.60}, 0.22),
    patterned(metal("brushed-steel", {0.62, 0.61, 0.60}, 0.30), Pattern::brushed, {0.50, 0.49, 0.48}, 0.02),
    patterned(metal("hammered-copper", {0.95, 0.60, 0.43}, 0.25), Pattern::hammered, {0.72, 0.40, 0.26}, 0.06),
    patterned(metal("rust", {0.50, 0.48, 0.46}, 0.42), Pattern::rust, {0.22, 0.07, 0.025}, 0.03),
    // Plastics and lacquers.
    insulator("gloss", {0.80, 0.80, 0.80}, 0.08),
    insulator("satin", {0.80, 0.80, 0.80}, 0.32),
    insulator("rubber", {0.035, 0.035, 0.037}, 0.72),
    coated(insulator("car-paint", {0.50, 0.015, 0.02}, 0.42), 1, 0.03),
    patterned(coated(metal("metallic-paint", {0.05, 0.14, 0.40}, 0.42), 1, 0.03), Pattern::flakes, {0.25, 0.42, 0.75},
              0.02),
    // Clear ones.
    clear("glass", {0.98, 1.0, 0.99}, 0.0, 1.5, 0.5),
    clear("frosted-glass", {0.97, 1.0, 0.99}, 0.38, 1.5, 0.3),
    clear("water", {0.93, 0.98, 1.0}, 0.0, 1.33, 1.0),
    patterned(insulator("sea", {0.010, 0.045, 0.065}, 0.04), Pattern::waves, {0.020, 0.105, 0.115}, 0.16),
    clear("ice", {0.86, 0.94, 0.98}, 0.16, 1.31, 0.6),
    clear("diamond", {1.0, 1.0, 1.0}, 0.0, 2.42, 0.5),
    clear("amber", {0.90, 0.42, 0.06}, 0.05, 1.55, 0.5),
    clear("soap-film", {1.0, 1.0, 1.0}, 0.0, 1.33, 0.0),
    // Earth and stone.
    coated(insulator("porcelain", {0.86, 0.86, 0.83}, 0.28), 1, 0.04),
    insulator("clay", {0.42, 0.20, 0.12}, 0.86),
    insulator("plaster", {0.82, 0.81, 0.78}, 0.92),
    patterned(insulator("concrete", {0.42, 0.41, 0.39}, 0.84), Pattern::concrete, {0.28, 0.275, 0.265}, 0.012),
    patterned(insulator("marble", {0.84, 0.83, 0.81}, 0.16), Pattern::marble, {0.24, 0.25, 0.27}, 0),
    patterned(insulator("granite", {0.36, 0.33, 0.32}, 0.26), Pattern::granite, {0.08, 0.08, 0.085}, 0),
    patterned(insulator("bricks", {0.36, 0.11, 0.065}, 0.88), Pattern::bricks, {0.50, 0.48, 0.44}, 0.10),
    patterned(insulator("tiles", {0.80, 0.80, 0.78}, 0.12), Pattern::tiles, {0.36, 0.35, 0.33}, 0.05),
    patterned(insulator("sand", {0.62, 0.48, 0.30}, 0.95), Pattern::sand, {0.46, 0.33, 0.19}, 0.05),
    patterned(insulator("snow", {0.90, 0.92, 0.95}, 0.75), Pattern::sand, {0.82, 0.86, 0.93}, 0.03),
    patterned(insulator("asphalt", {0.080, 0.080, 0.083}, 0.9), Pattern::sand, {0.035, 0.035, 0.037}, 0.03),
    patterned(insulator("grass", {0.13, 0.22, 0.035}, 0.85), Pattern::grass, {0.025, 0.075, 0.012}, 0.03),
    // Wood.
    patterned(insulator("oak", {0.42, 0.25, 0.12}, 0.48), Pattern::wood, {0.26, 0.135, 0.055}, 0.012),
    patterned(insulator("walnut", {0.16, 0.080, 0.040}, 0.42), Pattern::wood, {0.075, 0.035, 0.017}, 0.012),
    patterned(insulator("pine", {0.66, 0.45, 0.24}, 0.52), Pattern::wood, {0.50, 0.28, 0.115}, 0.012),
    patterned(coated(insulator("parquet", {0.42, 0.24, 0.11}, 0.36), 0.6, 0.12), Pattern::planks, {0.25, 0.125, 0.05},
              0.03),
    // Soft ones.
    patterned(insulator("leather", {0.16, 0.062, 0.028}, 0.46), Pattern::leather, {0.09, 0.032, 0.014}, 0.05),
    patterned(cloth(insulator("fabric", {0.30, 0.34, 0.42}, 0.92), {0.16, 0.17, 0.20}, 0.5), Pattern::fabric,
              {0.19, 0.22, 0.28}, 0.04),
    cloth(insulator("velvet", {0.20, 0.012, 0.03}, 0.95), {0.75, 0.20, 0.26}, 0.32),
    waxy(insulator("skin", {0.72, 0.42, 0.31}, 0.42), 0.7),
    waxy(insulator("wax", {0.84, 0.72, 0.50}, 0.36), 0.7),
    insulator("paper", {0.86, 0.85, 0.80}, 0.97),
    patterned(insulator("checker", {0.75, 0.75, 0.75}, 0.5), Pattern::checker, {0.045, 0.045, 0.05}, 0),
};

}  // namespace

Finish finish_of(Material material, double shininess) {
  Finish f;
  f.metalness = material == Material::metal ? 1 : 0;
  f.roughness = material == Material::matte ? 1 : 0.8 + shininess * (0.05 - 0.8);
  f.specular = material == Material::matte ? 0 : 1;
  return f;
}

std::span<const MaterialRow> materials() { return rows; }

const MaterialRow& material_row(std::string_view word) {
  const auto* const found =
      std::find_if(std::begin(rows), std::end(rows), [word](const MaterialRow& r) { return r.word == word; });
  return found == std::end(rows) ? rows[0] : *found;
}

std::string material_words() {
  std::string all;
  for (const MaterialRow& r : rows) all += (all.empty() ? "" : "|") + std::string(r.word);
  return all;
}

}  // namespace betwixt
