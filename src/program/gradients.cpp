// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The gradients of drawables: which functions make them, and their values at a time.
#include <algorithm>

#include "program/compile.h"
#include "program/evaluator.h"
#include "scene/gradient_stops.h"

namespace betwixt {
namespace {

// The functions of a stroke's gradient, from those of a fill's.
constexpr std::size_t to_stroke = fn::stroke_gradient - fn::gradient;

// Returns the place of a word among those of a function, which are in the order of the enumeration.
template <class Enum>
Enum choice(std::string_view words, std::string_view word) {
  std::uint8_t number = 0;
  while (!words.empty()) {
    const std::size_t end = std::min(words.find('|'), words.size());
    if (words.substr(0, end) == word) return static_cast<Enum>(number);
    words.remove_prefix(std::min(end + 1, words.size())), ++number;
  }
  return Enum{};
}

}  // namespace

std::optional<GradientUse> gradient_use(const CompiledFilm& film, std::uint32_t object) {
  GradientUse use;
  for (std::size_t i = 0; i < GradientUse::count; ++i) {
    const auto f = static_cast<FunctionId>(fn::gradient + i);
    if (const Binding& b = film.find_shown(object, f); &b != &film.defaults[f]) use.bound[i] = &b;
  }
  return use.at(fn::gradient) || use.at(fn::stroke_gradient) ? std::optional(use) : std::nullopt;
}

// Sets the gradients; returns whether they differ from the last ones. The colour is that of the object already.
bool Evaluator::take_gradients(std::uint32_t i, Looks& now, Asking& asking) {
  const GradientUse& use = compiled_.gradients[static_cast<std::size_t>(compiled_.drawables[i].gradients)];
  const auto word = [&](std::size_t f) {
    const Binding* const b = use.at(f);
    return b ? *std::get<Text>(compiled_.value(*b, now_, asking)) : std::string();
  };
  const auto numbers = [&](std::size_t f) {
    const Binding* const b = use.at(f);
    return b ? &numbers_[b->offset] : nullptr;
  };
  const auto made = [&](std::size_t offset, Vec3 first) {
    Gradient g;
    const auto words = [&](std::size_t f) -> const std::string& { return built_in_functions()[f].words; };
    g.kind = choice<GradientKind>(words(fn::gradient), word(fn::gradient + offset));
    if (g.kind == GradientKind::none) return g;
    g.spread = choice<GradientSpread>(words(fn::gradient_spread), word(fn::gradient_spread + offset));
    Vec3 second;
    if (const double* const c = numbers(fn::gradient_color + offset)) second = vec3(c);
    if (const double* const turn = numbers(fn::gradient_turn + offset)) g.turn = *turn;
    if (const double* const move = numbers(fn::gradient_move + offset)) g.move_x = move[0], g.move_y = move[1];
    if (const double* const size = numbers(fn::gradient_size + offset)) g.size = std::clamp(*size, 0.001, 1e6);
    g.stops = stops_of(word(fn::gradient_stops + offset), first, second);
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
