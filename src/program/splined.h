// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Shapes on a spline through shapes of one topology.
#pragma once

#include <optional>

#include "scene/shape_blend.h"
#include "track/curve.h"

namespace betwixt {

struct Splined {
  const Value* one = nullptr;  // the shape of this value alone …
  std::optional<Shape> sum;    // … or a new shape
};

// `shape_of`: returns a value's shape, as a shared pointer that stays valid during the call. Returns nullopt if the
// shapes differ in topology.
template <class ShapeOf>
std::optional<Splined> splined(const StepTrack& track, const Between& w, ShapeOf&& shape_of) {
  const auto alike = [&](const Value& a, const Value& b) { return one_topology(*shape_of(a), *shape_of(b)); };
  const auto values = track.values();
  if (!alike(values[w.a], values[w.b])) return std::nullopt;
  const Weights four = track.weigh(w, alike);
  std::vector<ShapeShare> shares;
  for (const std::size_t k : {1u, 0u, 2u, 3u}) {  // properties without numbers come from the first one
    const Value& v = values[four.values[k]];
    if (four.weights[k] == 1) return Splined{&v, std::nullopt};
    if (four.weights[k] != 0) shares.push_back({shape_of(v).get(), four.weights[k]});
  }
  return Splined{nullptr, sum_of(shares)};
}

}  // namespace betwixt
