// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The gradients of drawables: which functions make them, and their values at a time.
#include <algorithm>

#include "program/given_values.h"
#include "scene/gradient_stops.h"

namespace betwixt {
namespace {

// The functions of a stroke's gradient, from those of a fill's.
constexpr int to_stroke = fn::stroke_gradient - fn::gradient;

}  // namespace

std::optional<GradientUse> gradient_use(const CompiledFilm& film, std::uint32_t object) {
  GradientUse use;
  find_given(use, film, object);
  return use.at(fn::gradient) || use.at(fn::stroke_gradient) ? std::optional(use) : std::nullopt;
}

// Sets the gradients; returns whether they differ from the last ones. The colour is that of the object already.
bool Evaluator::take_gradients(std::uint32_t i, Looks& now, Asking& asking) {
  const GradientUse& use = compiled_.gradients[static_cast<std::size_t>(compiled_.drawables[i].gradients)];
  const GivenValues of(use, compiled_, numbers_, now_, asking);
  // `offset`: 0 for the fill's, or to_stroke.
  const auto made = [&](int offset, Vec3 first) {
    const auto own = [&](FunctionId f) { return static_cast<FunctionId>(f + offset); };
    Gradient g;
    of.choice(own(fn::gradient), fn::gradient, g.kind);
    if (g.kind == GradientKind::none) return g;
    of.choice(own(fn::gradient_spread), fn::gradient_spread, g.spread);
    Vec3 second;
    of.color(own(fn::gradient_color), second);
    of.number(own(fn::gradient_turn), g.turn), of.pair(own(fn::gradient_move), g.move_x, g.move_y);
    of.number(own(fn::gradient_size), g.size), g.size = std::clamp(g.size, 0.001, 1e6);
    g.stops = stops_of(of.word(own(fn::gradient_stops)), first, second);
    return g;
  };
  Vec3 stroke = now.color;
  if (now.shape != nothing && shape(now.shape)) {
    const Vec3 own = shape(now.shape)->stroke;
    if (own.x >= 0 || own.y >= 0 || own.z >= 0) stroke = own;
  }
  const Gradients all{made(0, now.color), made(to_stroke, stroke)};
  if (all.fill.kind == GradientKind::none && all.stroke.kind == GradientKind::none) return false;
  now.gradients = i;
  if (gradients_.size() < looks.size()) gradients_.resize(looks.size());
  if (gradients_[i] && *gradients_[i] == all) return false;
  gradients_[i] = std::make_shared<const Gradients>(all);
  return true;
}

}  // namespace betwixt
