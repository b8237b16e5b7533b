// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Rates of change of values.
#include <algorithm>
#include <cmath>

#include "program/compiled.h"
#include "program/integrals.h"
#include "track/operations.h"

namespace betwixt {
namespace {

Quat turn_of(const Value& v) {
  const auto* q = std::get_if<Quat>(&v);
  const auto* e = std::get_if<Angles>(&v);
  return q ? *q : from_angles(e ? e->xyz : Vec3{});
}

// Returns the rotation vector from one orientation to another, the short way.
Vec3 turning(const Value& from, const Value& to) {
  Quat d = turn_of(to) * conjugate(turn_of(from));
  if (d.w < 0) d = -d;
  const Vec3 v{d.x, d.y, d.z};
  const double l = length(v);
  return l > 1e-15 ? (2 * std::atan2(l, d.w) / l) * v : Vec3{};
}

// Returns the slope at the first of three equidistant values; negative `seconds` means they go backwards in time.
std::optional<Value> slope(const Value (&v)[3], double seconds, Type type) {
  if (std::holds_alternative<Quat>(v[0]) || std::holds_alternative<Quat>(v[1]))
    return Value((1 / (2 * seconds)) * (4 * turning(v[0], v[1]) - turning(v[0], v[2])));
  const auto near = add_scaled(v[1], v[0], -1), far = add_scaled(v[2], v[0], -1);
  if (!near || !far) return std::nullopt;
  double one[4] = {}, two[4] = {};
  to_numbers(*near, one), to_numbers(*far, two);
  for (int i = 0; i < 4; ++i) one[i] = (4 * one[i] - two[i]) / (2 * seconds);
  return value_of_numbers(type, one);
}

// Takes the rate from a velocity in force or from the curve. Returns false if neither gives one.
bool said_velocity(const Program::Compiled& film, const LivePart& part, Time t, bool coming, Asking& asking,
                   double* out) {
  if (part.pieces.empty()) return false;
  const Time just_before{t.flicks - 1};
  const Piece& p = part.pieces[part.piece_at(coming ? just_before : t)];
  if (p.reign >= 0) {
    const Curve& rate = film.reigns[static_cast<std::size_t>(p.reign)].velocity();
    film.set.evaluate(rate, coming ? just_before : t, out);
    if (!coming) return true;
    double earlier[4] = {};  // extrapolates to the time itself
    film.set.evaluate(rate, {t.flicks - 2}, earlier);
    for (std::size_t i = 0; i < rate.channels; ++i) out[i] += out[i] - earlier[i];
    return true;
  }
  if (p.integral >= 0) {
    rate_at(film, *film.integrals[static_cast<std::size_t>(p.integral)], coming ? just_before : t, asking, out);
    return true;
  }
  if (p.scripted || row_of(part.type).light) return false;
  if (p.primary.count > 0) film.set.derivative(p.primary, t, out, coming);
  return p.primary.count > 0;
}

}  // namespace

std::optional<Value> Program::Compiled::velocity(std::uint32_t object, FunctionId f, Time t, Asking& asking,
                                                 bool coming) const {
  const Binding& b = find(object, f);
  const Type type = spec_of(document.scene(), f).type;
  if (!has_velocity(type)) return std::nullopt;
  const auto as_rate = [&](const double* n, bool orientation) -> Value {
    return orientation ? Value(vec3(n)) : value_of_numbers(type, n);
  };
  double n[4] = {};
  if (b.live < 0 && !row_of(type).light) {
    if (b.channels == 0) return std::nullopt;
    for (std::uint32_t i = 0; i < b.curves; ++i) {
      const CurveUse& use = curves[b.first_curve + i];
      set.derivative(use.curve, t, n + (use.offset - b.offset), coming);
    }
    return as_rate(n, b.orientation);
  }
  if (b.live >= 0) {  // a velocity in force gives the rate itself, and so do plain pieces
    const Live& live = lives[static_cast<std::size_t>(b.live)];
    const LiveStrand& own = live.strands[0];
    bool all = live.strands.size() == 1 && own.filters.empty() && !own.parts.empty();
    bool orientation = false;
    for (const LivePart& part : own.parts) {
      all = all && said_velocity(*this, part, t, coming, asking, n + std::max(part.component, 0));
      orientation = orientation || part.orientation;
    }
    if (all) return as_rate(n, orientation);
  }
  // Takes three values close together. Values are continuous from the right, so the rate before t uses values that end
  // just before it.
  const std::int64_t h = (coming ? -1 : 1) * (flicks_per_second / 8192);
  const auto at = [&](std::int64_t steps) -> Value {
    const Time when{t.flicks + steps * h - (coming ? 1 : 0)};
    if (b.live >= 0) return live_value(b.live, when, asking);
    double x[4] = {};
    evaluate(b, when, asking, x);
    return to_srgb(vec3(x));
  };
  return slope({at(0), at(1), at(2)}, Time{h}.seconds(), type);
}

}  // namespace betwixt
