// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Twerpers by name: Penner's families of easings (easings.net has the same numbers) and those of CSS. A family is
// defined by its slow beginning; its other forms are that one turned about the middle.
#pragma once

#include <cmath>

#include "betwixt/math.h"
#include "track/twerpers.h"

namespace betwixt {
namespace easings {

using Arguments = std::array<double, 4>;
using Ease = double (*)(double s);

inline double sine(double s) { return 1 - std::cos(s * (pi / 2)); }
inline double quad(double s) { return s * s; }
inline double cubic(double s) { return s * s * s; }
inline double quart(double s) { return s * s * s * s; }
inline double quint(double s) { return s * s * s * s * s; }
inline double expo(double s) { return s <= 0 ? 0 : std::exp2(10 * s - 10); }
inline double circ(double s) { return 1 - std::sqrt(std::max(0.0, 1 - s * s)); }
// Overshoots by a tenth; `-in-out` needs a larger constant for it.
inline double goes_back(double s, double c) { return s * s * ((c + 1) * s - c); }
inline double back(double s) { return goes_back(s, 1.70158); }
inline double back_twice(double s) { return goes_back(s, 1.70158 * 1.525); }
inline double swings(double s, double period) {
  return s <= 0 ? 0 : s >= 1 ? 1 : -std::exp2(10 * s - 10) * std::sin((s - 1 - period / 4) * (2 * pi / period));
}
inline double elastic(double s) { return swings(s, 0.3); }
inline double elastic_twice(double s) { return swings(s, 0.45); }
// Parabolas from the ground: the last hop is the shortest.
inline double bounce(double s) {
  const double t = 1 - s, n = 7.5625;
  const auto hop = [&](double middle, double top) { return 1 - (n * (t - middle) * (t - middle) + top); };
  if (t < 1 / 2.75) return hop(0, 0);
  if (t < 2 / 2.75) return hop(1.5 / 2.75, 0.75);
  return t < 2.5 / 2.75 ? hop(2.25 / 2.75, 0.9375) : hop(2.625 / 2.75, 0.984375);
}

template <Ease of>
double in(double s, const Arguments&) {
  return of(s);
}
template <Ease of>
double out(double s, const Arguments&) {
  return 1 - of(1 - s);
}
template <Ease of>
double in_out(double s, const Arguments&) {
  return s < 0.5 ? of(2 * s) / 2 : 1 - of(2 - 2 * s) / 2;
}

// As in CSS. The jumps are 0 at the end of each step, 1 at its start, 2 at neither end, 3 at both.
inline double steps(double s, const Arguments& a) {
  if (s >= 1) return 1;
  const double n = a[0], jumps = a[1], all = jumps == 2 ? n - 1 : jumps == 3 ? n + 1 : n;
  return (std::floor(s * n) + (jumps == 1 || jumps == 3 ? 1 : 0)) / std::max(1.0, all);
}

template <int x1, int y1, int x2, int y2>  // hundredths
double css(double s, const Arguments&) {
  return bezier_factor(s, {x1 / 100.0, y1 / 100.0, x2 / 100.0, y2 / 100.0});
}

constexpr std::string_view by_sine =
    "Eases along a part of a sine: -in begins slowly, -out ends slowly, -in-out does both.";
constexpr std::string_view by_quad = "Eases along a parabola: -in begins slowly, -out ends slowly, -in-out does both.";
constexpr std::string_view by_cubic =
    "Eases along a cubic curve, t³: -in begins slowly, -out ends slowly, -in-out does both.";
constexpr std::string_view by_quart =
    "Eases along a curve of the fourth degree, t⁴: -in begins slowly, -out ends slowly, -in-out does both.";
constexpr std::string_view by_quint =
    "Eases along a curve of the fifth degree, t⁵: -in begins slowly, -out ends slowly, -in-out does both.";
constexpr std::string_view by_expo =
    "Eases along an exponential curve, 2^(10t): -in begins slowly, -out ends slowly, -in-out does both.";
constexpr std::string_view by_circ =
    "Eases along a quarter of a circle: -in begins slowly, -out ends slowly, -in-out does both.";
constexpr std::string_view by_back =
    "Eases along a cubic curve that overshoots: -in begins slowly, -out ends slowly, -in-out does both.";
constexpr std::string_view by_elastic =
    "Eases like an elastic band: -in begins slowly, -out ends slowly, -in-out does both.";
constexpr std::string_view by_bounce =
    "Eases like a bouncing ball: -in begins slowly, -out ends slowly, -in-out does both.";
constexpr TwerperArgument of_steps[] = {{"how many steps", 1, 1e6, true}};
constexpr std::string_view where_steps_jump[] = {"end", "start", "none", "both"};

inline constexpr TwerperRow rows[] = {
    {.name = "ease",
     .sentence = "Begins quickly and ends slowly, as `ease` of CSS.",
     .example = "at 12f ball.radius 2 ease",
     .factor = css<25, 10, 25, 100>,
     .costly = true},
    {.name = "ease-in",
     .sentence =
         "Begins slowly, as in CSS. (Not the option ease-in=4f, with which a track arrives slowly at its event.)",
     .example = "at 12f ball.radius 2 ease-in",
     .factor = css<42, 0, 100, 100>,
     .costly = true,
     .reversed = "ease-out"},
    {.name = "ease-out",
     .sentence = "Ends slowly, as in CSS. (Not the option ease-out=4f, with which a track leaves its event slowly.)",
     .example = "at 12f ball.radius 2 ease-out",
     .factor = css<0, 0, 58, 100>,
     .costly = true,
     .reversed = "ease-in"},
    {.name = "ease-in-out",
     .sentence = "Begins and ends slowly, as in CSS.",
     .example = "at 12f ball.radius 2 ease-in-out",
     .factor = css<42, 0, 58, 100>,
     .costly = true,
     .reversed = "ease-in-out"},
    {.name = "steps",
     .sentence = "In n equal steps, as `steps()` of CSS: the value jumps at the end of each step (the default), at its "
                 "start, at neither "
                 "end or at both.",
     .written = "steps(n) or steps(n start|end|none|both)",
     .example = "at 12f ball.radius 2 steps(4)",
     .factor = steps,
     .arguments = of_steps,
     .words = where_steps_jump,
     .steps = true},
    {.name = "sine-in",
     .sentence = by_sine,
     .example = "at 12f ball.radius 2 sine-in",
     .factor = in<sine>,
     .costly = true,
     .reversed = "sine-out"},
    {.name = "sine-out",
     .sentence = by_sine,
     .example = "at 12f ball.radius 2 sine-out",
     .factor = out<sine>,
     .costly = true,
     .reversed = "sine-in"},
    {.name = "sine-in-out",
     .sentence = by_sine,
     .example = "at 12f ball.radius 2 sine-in-out",
     .factor = in_out<sine>,
     .costly = true,
     .reversed = "sine-in-out"},
    {.name = "quad-in",
     .sentence = by_quad,
     .example = "at 12f ball.radius 2 quad-in",
     .factor = in<quad>,
     .reversed = "quad-out"},
    {.name = "quad-out",
     .sentence = by_quad,
     .example = "at 12f ball.radius 2 quad-out",
     .factor = out<quad>,
     .reversed = "quad-in"},
    {.name = "quad-in-out",
     .sentence = by_quad,
     .example = "at 12f ball.radius 2 quad-in-out",
     .factor = in_out<quad>,
     .reversed = "quad-in-out"},
    {.name = "cubic-in",
     .sentence = by_cubic,
     .example = "at 12f ball.radius 2 cubic-in",
     .factor = in<cubic>,
     .reversed = "cubic-out"},
    {.name = "cubic-out",
     .sentence = by_cubic,
     .example = "at 12f ball.radius 2 cubic-out",
     .factor = out<cubic>,
     .reversed = "cubic-in"},
    {.name = "cubic-in-out",
     .sentence = by_cubic,
     .example = "at 12f ball.radius 2 cubic-in-out",
     .factor = in_out<cubic>,
     .reversed = "cubic-in-out"},
    {.name = "quart-in",
     .sentence = by_quart,
     .example = "at 12f ball.radius 2 quart-in",
     .factor = in<quart>,
     .reversed = "quart-out"},
    {.name = "quart-out",
     .sentence = by_quart,
     .example = "at 12f ball.radius 2 quart-out",
     .factor = out<quart>,
     .reversed = "quart-in"},
    {.name = "quart-in-out",
     .sentence = by_quart,
     .example = "at 12f ball.radius 2 quart-in-out",
     .factor = in_out<quart>,
     .reversed = "quart-in-out"},
    {.name = "quint-in",
     .sentence = by_quint,
     .example = "at 12f ball.radius 2 quint-in",
     .factor = in<quint>,
     .reversed = "quint-out"},
    {.name = "quint-out",
     .sentence = by_quint,
     .example = "at 12f ball.radius 2 quint-out",
     .factor = out<quint>,
     .reversed = "quint-in"},
    {.name = "quint-in-out",
     .sentence = by_quint,
     .example = "at 12f ball.radius 2 quint-in-out",
     .factor = in_out<quint>,
     .reversed = "quint-in-out"},
    {.name = "expo-in",
     .sentence = by_expo,
     .example = "at 12f ball.radius 2 expo-in",
     .factor = in<expo>,
     .costly = true,
     .reversed = "expo-out"},
    {.name = "expo-out",
     .sentence = by_expo,
     .example = "at 12f ball.radius 2 expo-out",
     .factor = out<expo>,
     .costly = true,
     .reversed = "expo-in"},
    {.name = "expo-in-out",
     .sentence = by_expo,
     .example = "at 12f ball.radius 2 expo-in-out",
     .factor = in_out<expo>,
     .costly = true,
     .reversed = "expo-in-out"},
    {.name = "circ-in",
     .sentence = by_circ,
     .example = "at 12f ball.radius 2 circ-in",
     .factor = in<circ>,
     .costly = true,
     .reversed = "circ-out"},
    {.name = "circ-out",
     .sentence = by_circ,
     .example = "at 12f ball.radius 2 circ-out",
     .factor = out<circ>,
     .costly = true,
     .reversed = "circ-in"},
    {.name = "circ-in-out",
     .sentence = by_circ,
     .example = "at 12f ball.radius 2 circ-in-out",
     .factor = in_out<circ>,
     .costly = true,
     .reversed = "circ-in-out"},
    {.name = "back-in",
     .sentence = by_back,
     .example = "at 12f ball.radius 2 back-in",
     .factor = in<back>,
     .reversed = "back-out"},
    {.name = "back-out",
     .sentence = by_back,
     .example = "at 12f ball.radius 2 back-out",
     .factor = out<back>,
     .reversed = "back-in"},
    {.name = "back-in-out",
     .sentence = by_back,
     .example = "at 12f ball.radius 2 back-in-out",
     .factor = in_out<back_twice>,
     .reversed = "back-in-out"},
    {.name = "elastic-in",
     .sentence = by_elastic,
     .example = "at 12f ball.radius 2 elastic-in",
     .factor = in<elastic>,
     .costly = true,
     .reversed = "elastic-out"},
    {.name = "elastic-out",
     .sentence = by_elastic,
     .example = "at 12f ball.radius 2 elastic-out",
     .factor = out<elastic>,
     .costly = true,
     .reversed = "elastic-in"},
    {.name = "elastic-in-out",
     .sentence = by_elastic,
     .example = "at 12f ball.radius 2 elastic-in-out",
     .factor = in_out<elastic_twice>,
     .costly = true,
     .reversed = "elastic-in-out"},
    {.name = "bounce-in",
     .sentence = by_bounce,
     .example = "at 12f ball.radius 2 bounce-in",
     .factor = in<bounce>,
     .reversed = "bounce-out"},
    {.name = "bounce-out",
     .sentence = by_bounce,
     .example = "at 12f ball.radius 2 bounce-out",
     .factor = out<bounce>,
     .reversed = "bounce-in"},
    {.name = "bounce-in-out",
     .sentence = by_bounce,
     .example = "at 12f ball.radius 2 bounce-in-out",
     .factor = in_out<bounce>,
     .reversed = "bounce-in-out"},
    {.name = "match",
     .sentence = "Of texts and formulas: equal signs glide to their new places, others shrink and grow.",
     .example = "create words text text=\"b + a\"\nat 12f words.text \"a + b\" match for 12f",
     .factor = in_out<sine>,
     .matches = true,
     .reversed = "match"},
};

}  // namespace easings
}  // namespace betwixt
