// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/poses/mixed.h"

#include <algorithm>
#include <cmath>

#include "betwixt/math.h"
#include "studio/viewport/hand.h"
#include "track/track.h"
#include "track/twerpers.h"

namespace betwixt::studio {
namespace {

double between(double a, double b, double share) { return a + (b - a) * share; }

Color mixed_colors(Color a, Color b, double share) {
  const Vec3 from = to_linear(a), to = to_linear(b);
  const auto channel = [&](int i) { return to_srgb(std::clamp(between(from[i], to[i], share), 0.0, 1.0)); };
  return {channel(0), channel(1), channel(2)};
}

double six_decimals(double v) {
  const double out = std::abs(v) < 1e9 ? std::round(v * 1e6) / 1e6 : v;
  return out == 0 ? 0 : out;
}

}  // namespace

Value mixed(const Value& a, const Value& b, double share) {
  const auto turns = [](const Value& v) {
    return std::holds_alternative<Angles>(v) || std::holds_alternative<Quat>(v);
  };
  if (a.index() == b.index()) {
    if (const auto* from = std::get_if<double>(&a)) return between(*from, std::get<double>(b), share);
    if (const auto* from = std::get_if<Vec3>(&a)) return *from + (std::get<Vec3>(b) - *from) * share;
    if (const auto* from = std::get_if<Angles>(&a))
      return Angles{from->xyz + (std::get<Angles>(b).xyz - from->xyz) * share};
    if (const auto* from = std::get_if<Color>(&a)) return mixed_colors(*from, std::get<Color>(b), share);
  }
  if (turns(a) && turns(b)) {
    const Quat from = orientation_of(a), to = orientation_of(b);
    return slerp(from, dot(from, to) < 0 ? -to : to, share);
  }
  return share < 0.5 ? a : b;
}

Value written_plain(const Value& v, bool angle) {
  constexpr double degree = pi / 180;
  const auto each = [](Vec3 w, double unit) {
    for (int i = 0; i < 3; ++i) w[i] = six_decimals(w[i] / unit) * unit;
    return w;
  };
  if (const auto* number = std::get_if<double>(&v))
    return angle ? six_decimals(*number / degree) * degree : six_decimals(*number);
  if (const auto* place = std::get_if<Vec3>(&v)) return each(*place, 1);
  if (const auto* angles = std::get_if<Angles>(&v)) return Angles{each(angles->xyz, degree)};
  if (const auto* q = std::get_if<Quat>(&v))
    return Quat{six_decimals(q->w), six_decimals(q->x), six_decimals(q->y), six_decimals(q->z)};
  return v;
}

}  // namespace betwixt::studio
