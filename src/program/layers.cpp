// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The layers of a frame: groups that are drawn as a whole, and the objects that mask them.
#include <algorithm>
#include <map>

#include "program/evaluator.h"

namespace betwixt {
namespace {

template <std::size_t count>
std::size_t choice_in(const std::array<std::string_view, count>& names, const std::string& name) {
  const auto* const at = std::find(names.begin(), names.end(), name);
  return at == names.end() ? 0 : static_cast<std::size_t>(at - names.begin());
}

double at_least(double x, double least) { return x > least ? x : least; }  // NaN becomes the least

// Sorts layers so that each comes after the one that it is within; returns the new place of each.
std::vector<std::int32_t> sort_by_depth(std::vector<Layer>& layers) {
  const auto depth = [&](std::size_t i) {
    int deep = 0;
    for (std::int32_t at = layers[i].within; at >= 0; at = layers[static_cast<std::size_t>(at)].within) ++deep;
    return deep;
  };
  std::vector<std::pair<int, std::size_t>> order;
  for (std::size_t i = 0; i < layers.size(); ++i) order.emplace_back(depth(i), i);
  std::sort(order.begin(), order.end());
  std::vector<std::int32_t> place(layers.size());
  std::vector<Layer> sorted;
  for (const auto& [deep, i] : order)
    place[i] = static_cast<std::int32_t>(sorted.size()), sorted.push_back(std::move(layers[i]));
  for (Layer& l : sorted) {
    if (l.within >= 0) l.within = place[static_cast<std::size_t>(l.within)];
    for (std::int32_t& mask : l.masks) mask = place[static_cast<std::size_t>(mask)];
  }
  layers = std::move(sorted);
  return place;
}

}  // namespace

// Sets the layer of a group; returns whether it needs one now.
bool Evaluator::layer_at(std::uint32_t node, Layer& l, std::vector<std::uint32_t>& masks, Asking& asking) const {
  const std::uint32_t object = compiled_.nodes[node].object;
  l.object = {object}, l.place = translation_of(world(node));
  if (compiled_.nodes[node].kind != Kind::group) return false;
  const auto number = [&](FunctionId f) { return &numbers_[compiled_.find(object, f).offset]; };
  const auto value = [&](FunctionId f) { return compiled_.value(compiled_.find(object, f), now_, asking); };
  l.opacity = std::min(at_least(*number(fn::opacity), 0), 1.0);
  l.blend = static_cast<LayerBlend>(choice_in(layer_blend_names, *std::get<Text>(value(fn::layer_blend))));
  l.blur = at_least(*number(fn::layer_blur), 0);
  l.glow = at_least(*number(fn::glow), 0), l.glow_size = at_least(*number(fn::glow_size), 0);
  l.shadow = vec3(number(fn::drop_shadow)), l.shadow_color = vec3(number(fn::shadow_color));
  l.shadow.z = at_least(l.shadow.z, 0);
  l.shadow_opacity = std::min(at_least(*number(fn::shadow_opacity), 0), 1.0);
  for (const std::string& name : *std::get<Names>(value(fn::layer_mask))) {
    const ObjectId id = compiled_.document.find(name);
    if (const auto mask = compiled_.node_of_object(id)) masks.push_back(*mask);
  }
  return l.opacity < 1 || l.blend != LayerBlend::normal || !masks.empty() || l.blur > 0 || l.glow > 0 ||
         !(l.shadow == Vec3{});
}

std::vector<Layer> Evaluator::layers(std::vector<std::int32_t>& of_drawables, Asking& asking) const {
  of_drawables.clear();
  std::vector<Layer> found;
  if (compiled_.layers.empty()) return found;
  std::map<std::uint32_t, std::int32_t> number;  // by node
  std::vector<std::vector<std::uint32_t>> masks;
  const auto add = [&](std::uint32_t node, bool wanted) {
    Layer l;
    std::vector<std::uint32_t> by;
    if ((!layer_at(node, l, by, asking) && !wanted) || number.count(node) != 0) return;
    number[node] = static_cast<std::int32_t>(found.size());
    found.push_back(std::move(l)), masks.push_back(std::move(by));
  };
  for (const std::uint32_t node : compiled_.layers) add(node, false);
  for (std::size_t i = 0; i < found.size(); ++i)  // grows
    for (const std::uint32_t node : std::vector(masks[i])) {
      add(node, true);
      found[i].masks.push_back(number[node]);
      found[static_cast<std::size_t>(number[node])].is_mask = true;
    }
  if (found.empty()) return found;
  const auto layer_of = [&](std::int32_t node) {
    for (; node >= 0; node = parent_[static_cast<std::size_t>(node)])
      if (const auto at = number.find(static_cast<std::uint32_t>(node)); at != number.end()) return at->second;
    return std::int32_t{-1};
  };
  for (const auto& [node, i] : number) {
    Layer& l = found[static_cast<std::size_t>(i)];
    if (!l.is_mask) l.within = layer_of(parent_[node]);
  }
  const std::vector<std::int32_t> place = sort_by_depth(found);
  for (std::size_t i = 0; i < looks.size(); ++i) {
    const std::int32_t at = layer_of(static_cast<std::int32_t>(i));
    of_drawables.push_back(at < 0 ? at : place[static_cast<std::size_t>(at)]);
  }
  return found;
}

}  // namespace betwixt
