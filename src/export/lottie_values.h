// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Values and groups of a Lottie.
#pragma once

#include <cmath>

#include "export/json.h"
#include "export/planar.h"

namespace betwixt::lottie {

inline Json still(Json v) { return {{"a", 0}, {"k", std::move(v)}}; }
inline Json key(double at, Json value, const PlanarCurve* c) {
  Json k{{"t", at}, {"s", std::move(value)}};
  if (!c) return k;
  if (c->shape == PlanarCurve::held) {
    k["h"] = 1;
    return k;
  }
  const auto handle = [](double x, double y) { return Json{{"x", {x}}, {"y", {y}}}; };
  k["o"] = handle(c->x1, c->shape == PlanarCurve::cubic ? c->y1 : 1.0 / 3);
  k["i"] = handle(c->x2, c->shape == PlanarCurve::cubic ? c->y2 : 2.0 / 3);
  return k;
}
inline Json listed(Json v) { return v.is_array() ? v : Json::array({std::move(v)}); }
inline double rounded(double v) { return std::round(v * 1e4) / 1e4; }
inline Json group(Json items) {
  items.push_back({{"ty", "tr"},
                   {"p", still({0, 0})},
                   {"a", still({0, 0})},
                   {"s", still({100, 100})},
                   {"r", still(0)},
                   {"o", still(100)}});
  return {{"ty", "gr"}, {"it", std::move(items)}};
}

}  // namespace betwixt::lottie
