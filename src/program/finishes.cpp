// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The finishes of drawables: which functions make one, and their values at a time.
#include <algorithm>

#include "program/given_values.h"

namespace betwixt {
namespace {

// Returns whether a material may need a finish at some time.
bool may_be_named(const Drawable& d) { return !d.made_of || !d.made_of->plain; }

// The light of each channel relative to another, for colours that a material's own color changes with.
double times(double part, double from, double to) { return from > 0 ? std::min(part * to / from, 1.0) : part; }

}  // namespace

std::optional<FinishUse> finish_use(const CompiledFilm& film, std::uint32_t object, const Drawable& d) {
  FinishUse use;
  const bool any = find_given(use, film, object) || may_be_named(d);
  use.colored = &film.find_shown(object, fn::color) != &film.defaults[fn::color];
  return any ? std::optional(use) : std::nullopt;
}

// Sets the finish, and the material's own colour; returns whether the finish differs from the last one.
bool Evaluator::take_finish(std::uint32_t i, const MaterialRow& made_of, Looks& now, Asking& asking) {
  const FinishUse& use = compiled_.finishes[static_cast<std::size_t>(compiled_.drawables[i].finish)];
  const bool any = std::any_of(use.bound.begin(), use.bound.end(), [](const Binding* b) { return b != nullptr; });
  if (made_of.plain && (!any || made_of.old == Material::glow)) return false;  // as it always was
  Finish f = made_of.plain ? finish_of(made_of.old, now.shininess) : made_of.finish;
  if (!made_of.plain && !use.colored) now.color = made_of.color;
  if (use.colored && f.pattern != Pattern::none)
    for (int k = 0; k < 3; ++k) f.second[k] = times(f.second[k], made_of.color[k], now.color[k]);
  const GivenValues of(use, compiled_, numbers_, now_, asking);
  of.share(fn::metalness, f.metalness), of.share(fn::roughness, f.roughness);
  double strength = 1;
  of.color(fn::emission, f.emission), of.number(fn::emission_strength, strength);
  f.emission = std::max(strength, 0.0) * f.emission;
  of.share(fn::clearcoat, f.clearcoat), of.share(fn::clearcoat_roughness, f.clearcoat_roughness);
  of.color(fn::sheen, f.sheen), of.share(fn::sheen_roughness, f.sheen_roughness);
  of.share(fn::transmission, f.transmission), of.number(fn::ior, f.ior), of.number(fn::thickness, f.thickness);
  f.ior = std::clamp(f.ior, 1.0, 4.0), f.thickness = std::max(f.thickness, 0.0);
  of.number(fn::normal_strength, f.normal_strength);
  of.picture(fn::normal_map, f.normals), of.picture(fn::roughness_map, f.roughness_map);
  of.picture(fn::metalness_map, f.metalness_map), of.picture(fn::occlusion_map, f.occlusion_map);
  of.picture(fn::emission_map, f.emission_map);
  const std::string projection = of.word(fn::texture_projection);
  f.projection = projection == "box"  ? PictureProjection::box
                 : projection == "uv" ? PictureProjection::uv
                                      : PictureProjection::automatic;
  of.pair(fn::texture_tile, f.tile_x, f.tile_y), of.pair(fn::texture_move, f.move_x, f.move_y);
  of.number(fn::texture_turn, f.turn);
  now.finish = i;
  if (finishes_.size() < looks.size()) finishes_.resize(looks.size());
  if (finishes_[i] && *finishes_[i] == f) return false;
  finishes_[i] = std::make_shared<const Finish>(f);
  return true;
}

}  // namespace betwixt
