// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/curves/curve_samples.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "scene/document.h"

namespace betwixt::studio {
namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

// Returns whether a layer, a filter, a velocity or an obstacle changes the value of the track.
bool is_laid_over(const Document& d, const Target& t) {
  if (t.velocity || t.layer) return false;
  if (t.function == fn::position && d.scene().objects[t.object.index].find(fn::obstacles)) return true;
  for (const Slot& slot : d.scene().objects[t.object.index].slots) {
    if (slot.function != t.function) continue;
    const bool reigned = !slot.velocity.track->events.empty() ||
                         std::ranges::any_of(slot.velocity.components, [](auto& c) { return !c->events.empty(); });
    if (slot.layer || !slot.filters.empty() || reigned) return true;
  }
  return false;
}

}  // namespace

void CurveSamples::begin(const Program& program, std::vector<CurveLine> lines, std::vector<Time> columns) {
  program_ = program, lines_ = std::move(lines), times_ = std::move(columns);
  const Document& d = program.document();
  targets_.clear(), target_of_.clear(), bare_programs_.clear(), laid_over_.clear();
  std::vector<ObjectId> objects;
  for (const CurveLine& line : lines_) {
    const auto known = std::ranges::find(targets_, line.target);
    target_of_.push_back(static_cast<std::size_t>(known - targets_.begin()));
    if (known == targets_.end()) targets_.push_back(line.target);
    laid_over_.push_back(line.tracked && is_laid_over(d, line.target));
    if (std::ranges::find(objects, line.target.object) == objects.end()) objects.push_back(line.target.object);
  }
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    const ObjectId layer = lines_[i].target.layer;
    if (!laid_over_[i] && !layer) continue;
    if (std::ranges::find(bare_programs_, layer, &std::pair<ObjectId, Program>::first) == bare_programs_.end())
      bare_programs_.emplace_back(layer, Program::compile(bare_tracks(d, objects, layer), program));
  }
  order_.clear(), next_ = 0;
  for (std::size_t step = 32; step > 0; step /= 2)
    for (std::size_t i = 0; i < times_.size(); i += step)
      if (step == 32 || i % (2 * step) != 0) order_.push_back(i);
  final_.assign(lines_.size() * times_.size(), nothing), bare_ = final_;
  colors_.assign(final_.size(), std::nullopt);
}

void CurveSamples::sample(std::size_t column) {
  const Time t = times_[column];
  std::vector<Target> plain;
  for (Target target : targets_) plain.push_back(target.layer ? Target{} : target);
  std::vector<Target> asked;
  for (const Target& target : plain)
    if (target.object) asked.push_back(target);
  const std::vector<Value> values = program_->read(asked, t);
  const auto value_of = [&](std::size_t i) -> Value {
    std::size_t k = 0;
    for (std::size_t j = 0; j < i; ++j) k += plain[j].object ? 1 : 0;
    return values[k];
  };
  const auto bare_value = [&](const Target& target) -> Value {
    Target bare = target;
    bare.layer = {};
    for (const auto& [layer, program] : bare_programs_)
      if (layer == target.layer) return program.read(bare, t);
    return {};
  };
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    const std::size_t place = i * times_.size() + column;
    const CurveLine& line = lines_[i];
    const Value v = line.target.layer ? bare_value(line.target) : value_of(target_of_[i]);
    final_[place] = shown(line, v).value_or(nothing);
    if (const Color* c = std::get_if<Color>(&v)) colors_[place] = *c;
    if (laid_over_[i]) bare_[place] = shown(line, bare_value(line.target)).value_or(nothing);
  }
}

bool CurveSamples::work(double milliseconds) {
  const auto begin = std::chrono::steady_clock::now();
  while (next_ < order_.size()) {
    sample(order_[next_++]);
    if (std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count() > milliseconds)
      break;
  }
  return next_ < order_.size();
}

std::optional<double> CurveSamples::at(const Numbers& of, std::size_t line, std::size_t column) const {
  const double v = of[line * times_.size() + column];
  return std::isnan(v) ? std::nullopt : std::optional(v);
}

std::optional<Color> CurveSamples::color(std::size_t line, std::size_t column) const {
  return colors_[line * times_.size() + column];
}

}  // namespace betwixt::studio
