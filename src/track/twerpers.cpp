// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "track/twerpers.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "betwixt/time.h"
#include "track/easings.h"
#include "track/turns.h"

namespace betwixt {
namespace {

// Returns the parameter of a Bezier curve from 0 to 1 with these two handles, each from 0 to 1, whose x is u.
double bezier_parameter(double u, double x1, double x2);

double smoothstep(double s, const std::array<double, 4>&) { return s * s * (3 - 2 * s); }

// ---- Numbers

// Returns the cubic from b to e with these tangents, over the segment.
Cubic hermite(double b, double e, double m1, double m2) {
  return {{b, m1, 3 * (e - b) - 2 * m1 - m2, m1 + m2 - 2 * (e - b)}};
}

// The tangents are those of the parabolas through three neighbours, at their real times.
void smooth_cubics(const Blend& g, Cubic* out) {
  const double h = g.length, h0 = g.length_before, h2 = g.length_after;
  const double before = h / h0 * h, after = h / h2 * h, w1 = 1 / (h0 + h), w2 = 1 / (h + h2);
  for (std::uint32_t i = 0; i < g.channels; ++i) {
    const double a = g.left(i), b = g.from[i], e = g.to[i], d = g.right(i), chord = e - b;
    out[i] = hermite(b, e, ((b - a) * before + chord * h0) * w1, (chord * h2 + (d - e) * after) * w2);
  }
}

// The tangent is the harmonic mean of the slopes on both sides, weighted by their times, or 0 if they differ in sign.
// So the curve rises and falls with the events (Fritsch and Butland 1984).
void auto_cubics(const Blend& g, Cubic* out) {
  const double h = g.length;
  const auto tangent = [h](double a, double ha, double b, double hb) {
    if (!(a * b > 0)) return 0.0;
    const double p = a / ha, q = b / hb, w = 2 * hb + ha, v = hb + 2 * ha;
    return (w + v) / (w / p + v / q) * h;
  };
  for (std::uint32_t i = 0; i < g.channels; ++i) {
    const double chord = g.to[i] - g.from[i];
    const double before = g.before ? g.from[i] - g.before[i] : chord, after = g.after ? g.after[i] - g.to[i] : chord;
    out[i] = hermite(g.from[i], g.to[i], tangent(before, g.before ? g.length_before : h, chord, h),
                     tangent(chord, h, after, g.after ? g.length_after : h));
  }
}

void hermite_cubics(const Blend& g, Cubic* out) {
  const double seconds = g.length / static_cast<double>(flicks_per_second);
  for (std::uint32_t i = 0; i < g.channels; ++i)
    out[i] = hermite(g.from[i], g.to[i], g.tangent_out ? g.tangent_out[i] * seconds : 0,
                     g.tangent_in ? g.tangent_in[i] * seconds : 0);
}

void bspline_cubics(const Blend& g, Cubic* out) {
  for (std::uint32_t i = 0; i < g.channels; ++i) {
    const double a = g.left(i), b = g.from[i], e = g.to[i], d = g.right(i);
    out[i] = {{(a + 4 * b + e) / 6, (e - a) / 2, (a - 2 * b + e) / 2, (d - a + 3 * (b - e)) / 6}};
  }
}

// ---- Orientations

struct Four {
  Quat q0, q1, q2, q3;
};
Four four(const Blend& g) {
  const Quat q1 = quat(g.from), q2 = quat(g.to);
  return {g.before ? quat(g.before) : q1 * conjugate(q2) * q1, q1, q2,
          g.after ? quat(g.after) : q2 * conjugate(q1) * q2};
}

Quat bspline_turn(const Blend& g) {  // cumulative form: the rotation of every step, weighted
  const auto [q0, q1, q2, q3] = four(g);
  const double s = g.s, s2 = s * s, s3 = s2 * s;
  const double b1 = (5 + 3 * s - 3 * s2 + s3) / 6, b2 = (1 + 3 * s + 3 * s2 - 2 * s3) / 6, b3 = s3 / 6;
  return normalize(q0 * power(conjugate(q0) * q1, b1) * power(conjugate(q1) * q2, b2) * power(conjugate(q2) * q3, b3));
}

// The cubic of the four numbers, as in glTF; a missing tangent means rest.
Quat hermite_turn(const Blend& g) {
  if (!g.tangent_out && !g.tangent_in) return slerp(quat(g.from), quat(g.to), smoothstep(g.s, {}));
  Cubic cubics[4];
  hermite_cubics(g, cubics);
  const Quat q{cubics[0].at(g.s), cubics[1].at(g.s), cubics[2].at(g.s), cubics[3].at(g.s)};
  return dot(q, q) > 1e-24 ? normalize(q) : quat(g.from);
}

// Returns the rotation in a time h at the angular velocity of a key, between two rotations a and b with their times. It
// is the velocity of the parabola through all three keys, limited twice: to three times that of either rotation, beyond
// which it would pass a key and come back (Fritsch and Carlson 1980), and to half a turn in the time of either, beyond
// which the direction is lost.
Vec3 through_key(double h, Vec3 a, double ha, Vec3 b, double hb) {
  const Vec3 turn = h / (ha + hb) * (hb / ha * a + ha / hb * b);
  const auto most = [h](Vec3 of, double in) { return std::min(3 * length(of), pi / 2) * (h / in); };
  const double limit = std::min(most(a, ha), most(b, hb)), l = length(turn);
  return l > limit ? limit / l * turn : turn;
}

Quat exp(Vec3 v) { return exp(Quat{0, v.x, v.y, v.z}); }

Quat squad_turn(const Blend& g) {
  const auto [q0, q1, q2, q3] = four(g);
  const auto turn = [](Quat from, Quat to) {
    const Quat l = log(conjugate(from) * to);
    return Vec3{l.x, l.y, l.z};
  };
  const Vec3 before = turn(q0, q1), here = turn(q1, q2), after = turn(q2, q3);
  const Vec3 start = 0.5 * (through_key(g.length, before, g.length_before, here, g.length) - here),
             end = 0.5 * (here - through_key(g.length, here, g.length, after, g.length_after));
  const Quat near = q1 * exp(start), far = q2 * exp(end);
  const double s = g.s, off = 2 * s * (1 - s);
  // Between nearly opposite control points there is no shortest way; their differences then follow the rotation.
  // About one axis the result is the same.
  if (dot(near, far) < -0.9) return normalize(slerp(q1, q2, s) * exp(off * ((1 - s) * start + s * end)));
  return normalize(slerp(slerp(q1, q2, s), slerp(near, far, s), off));
}

// A Bezier curve in time and value through both handles. Each is at most as long as the segment, so time never runs
// back. A missing handle is a third of the segment, at rest.
void fcurve_numbers(const Blend& g, double* out) {
  const auto fit = [&](const double* way, double length) {
    return std::pair(way ? std::min(1.0, length / g.length) : 1.0 / 3,
                     way && length > g.length ? g.length / length : 1);
  };
  const auto [x1, part1] = fit(g.handle_out, g.handle_out_length);
  const auto [x2, part2] = fit(g.handle_in, g.handle_in_length);
  const double p = bezier_parameter(g.s, x1, 1 - x2), q = 1 - p;
  for (std::uint32_t i = 0; i < g.channels; ++i) {
    const double near = g.handle_out ? part1 * g.handle_out[i] : 0, far = g.handle_in ? part2 * g.handle_in[i] : 0;
    const double b = g.from[i], e = g.to[i];
    out[i] = q * q * (q * b + 3 * p * (b + near)) + p * p * (3 * q * (e + far) + p * e);
  }
}

// The index of a named row is its number; append new ones.
constexpr TwerperArgument of_bezier[] = {
    {"x1", 0, 1, false}, {"y1", -1e6, 1e6, false}, {"x2", 0, 1, false}, {"y2", -1e6, 1e6, false}};
constexpr TwerperRow first_rows[] = {
    {.name = "unset"},
    {.name = "hold",
     .sentence = "Keeps the value, then jumps at the next event.",
     .example = "at 12f ball.radius 2 hold"},
    {.name = "linear",
     .sentence = "Linear to the next event; with stops, linear from stop to stop, as in CSS.",
     .written = "linear or linear(0 0.25 25% 75% 1)",
     .example = "at 12f ball.radius 2 linear",
     .stops = true,
     .for_orientations = Twerper::slerp},
    {.name = "smooth",
     .sentence = "Smoothly through all events (Catmull-Rom).",
     .example = "at 12f ball.radius 2 smooth",
     .cubics = smooth_cubics,
     .for_orientations = Twerper::squad},
    {.name = "bspline",
     .sentence = "Softer than smooth; comes near its events, but not through them.",
     .example = "at 12f ball.radius 2 bspline",
     .factor = smoothstep,
     .cubics = bspline_cubics,
     .turn = bspline_turn},
    {.name = "hermite",
     .sentence = "Through all events, with tangents that you set.",
     .written = "hermite [tangent=VALUE]",
     .example = "at 12f ball.radius 2 hermite tangent=0",
     .factor = smoothstep,
     .cubics = hermite_cubics,
     .turn = hermite_turn},
    {.name = "bezier",
     .sentence = "To the next event along a Bezier easing curve, as in CSS.",
     .written = "bezier(x1 y1 x2 y2)",
     .example = "at 12f ball.radius 2 bezier(0.25 0.1 0.25 1)",
     .factor = bezier_factor,
     .costly = true,
     .arguments = of_bezier},
    {.name = "slerp",
     .sentence = "The shortest way between two orientations.",
     .example = "at 12f hand.rotation axis(0 1 0, 90deg) slerp",
     .for_numbers = Twerper::linear},
    {.name = "squad",
     .sentence = "Smoothly through many orientations.",
     .example = "at 12f hand.rotation axis(0 1 0, 90deg) squad",
     .turn = squad_turn,
     .for_numbers = Twerper::smooth},
    {.name = "auto",
     .sentence = "Smooth, without overshooting the values of its events.",
     .example = "at 12f ball.radius 2 auto",
     .cubics = auto_cubics,
     .for_orientations = Twerper::squad},
    {.name = "fcurve",
     .sentence = "To the next event by handles in time and value, like the F-curves of other tools.",
     .written = "fcurve [handle-in=(LENGTH VALUE)] [handle-out=(LENGTH VALUE)]",
     .example = "at 12f ball.radius 2 fcurve handle-out=(8f 0)",
     .factor = smoothstep,
     .numbers = fcurve_numbers},
};
constexpr auto twerper_rows = [] {
  std::array<TwerperRow, std::size(first_rows) + std::size(easings::rows)> all;
  std::copy(std::begin(first_rows), std::end(first_rows), all.begin());
  std::copy(std::begin(easings::rows), std::end(easings::rows), all.begin() + std::size(first_rows));
  return all;
}();
static_assert(std::size(twerper_rows) <= first_own_twerper, "the numbers above are the document's own");

}  // namespace

std::span<const TwerperRow> twerpers() { return twerper_rows; }
const TwerperRow& row_of(Twerper t) { return twerper_rows[static_cast<std::size_t>(t)]; }

const Ease* ease_of(Twerper t) {
  struct Eases {
    std::vector<std::unique_ptr<const Ease>> all;
    Eases() {
      for (const TwerperRow& row : twerper_rows)
        all.push_back(row.factor ? std::make_unique<const Ease>(row.factor, Ease::Arguments{}, row.costly) : nullptr);
    }
  };
  static const Eases& eases = *new Eases;  // never destroyed: other threads may still draw at program exit
  return eases.all[static_cast<std::size_t>(t)].get();
}

std::string_view name_of(Twerper t) { return row_of(t).name; }

std::optional<Twerper> find_twerper(std::string_view name) {
  const auto at = std::find_if(std::begin(twerper_rows) + 1, std::end(twerper_rows),
                               [&](const auto& row) { return row.name == name; });
  if (at == std::end(twerper_rows)) return std::nullopt;
  return static_cast<Twerper>(at - std::begin(twerper_rows));
}

namespace {

double evenly(double a, double b, std::size_t k, std::size_t n) {
  return a + (b - a) * static_cast<double>(k) / static_cast<double>(n);
}

}  // namespace

Stops placed(const std::vector<SaidStop>& said) {
  Stops out;
  for (const SaidStop& s : said) {
    const bool first = out.empty(), last = out.size() + 1 == said.size();
    double latest = 0;
    for (std::size_t i = 0; last && i < out.size(); ++i) latest = std::max(latest, said[i].place.value_or(0));
    out.push_back({s.place.value_or(first ? 0 : std::max(100.0, latest)), s.value});
  }
  for (std::size_t i = 0, j = 1; j < out.size(); ++j) {
    if (j + 1 < out.size() && !said[j].place) continue;
    for (std::size_t k = i + 1; k < j; ++k) out[k][0] = evenly(out[i][0], out[j][0], k - i, j - i);
    i = j;
  }
  return out;
}

std::vector<SaidStop> as_said(const Stops& stops) {
  std::vector<SaidStop> out;
  for (const auto& [place, value] : stops) out.push_back({value, place});
  if (stops.front()[0] == 0) out.front().place.reset();
  if (stops.back()[0] == 100) out.back().place.reset();
  const auto even = [&](std::size_t i, std::size_t j) {
    for (std::size_t k = i + 1; k < j; ++k)
      if (stops[k][0] != evenly(stops[i][0], stops[j][0], k - i, j - i)) return false;
    return true;
  };
  for (std::size_t i = 0; i + 1 < stops.size();) {
    std::size_t j = stops.size() - 1;
    while (j > i + 1 && !even(i, j)) --j;
    for (std::size_t k = i + 1; k < j; ++k) out[k].place.reset();
    i = j;
  }
  return out;
}

double through(const Stops& stops, double s) {
  const double at = 100 * s;
  const auto next =
      std::upper_bound(stops.begin() + 1, stops.end() - 1, at, [](double x, const Stop& stop) { return x < stop[0]; });
  const auto& [x, y] = next[-1];
  const auto& [x2, y2] = *next;
  return x == x2 ? y2 : y + (at - x) / (x2 - x) * (y2 - y);
}

void reverse(Twerper& t, TwerperArguments& a) {
  if (is_own(t)) return;
  const TwerperRow& row = row_of(t);
  if (a.stops) {
    Stops back;
    for (auto stop = a.stops->rbegin(); stop != a.stops->rend(); ++stop)
      back.push_back({100 - (*stop)[0], 1 - (*stop)[1]});
    a.stops = std::make_shared<const Stops>(std::move(back));
  }
  const auto as_bezier = [&](std::array<double, 4> b) {
    t = Twerper::bezier;
    a = TwerperArguments(1 - b[2], 1 - b[3], 1 - b[0], 1 - b[1]);
  };
  if (const auto other = row.reversed.empty() ? std::nullopt : find_twerper(row.reversed)) t = *other;
  if (t == Twerper::bezier) as_bezier(a);
  if (row.name == "ease") as_bezier({0.25, 0.1, 0.25, 1});
  if (row.name == "steps" && a[1] < 2) a[1] = 1 - a[1];  // a jump at the end becomes a jump at the start
}

namespace {

double bezier_at(double p, double q, double s) {
  return ((1 - 3 * q + 3 * p) * s + (3 * q - 6 * p)) * s * s + 3 * p * s;
}

// x rises over [0, 1] because x1 and x2 are within it, so bisection always ends.
double bezier_parameter(double u, double x1, double x2) {
  double low = 0, high = 1, s = u;
  for (int i = 0; i < 60; ++i) {
    const double x = bezier_at(x1, x2, s);
    if (std::abs(x - u) < 1e-15) break;
    (x < u ? low : high) = s;
    const double slope = 3 * (1 - s) * (1 - s) * x1 + 6 * (1 - s) * s * (x2 - x1) + 3 * s * s * (1 - x2);
    const double newton = slope > 1e-9 ? s - (x - u) / slope : low;
    s = newton > low && newton < high ? newton : (low + high) / 2;
  }
  return s;
}

}  // namespace

double bezier_factor(double u, const std::array<double, 4>& xy) {
  return u <= 0 || u >= 1 ? u : bezier_at(xy[1], xy[3], bezier_parameter(u, xy[0], xy[2]));
}

Quat slerp(Quat a, Quat b, double s) {
  const double d = dot(a, b);
  if (d > 1 - 1e-12)
    return normalize({a.w + s * (b.w - a.w), a.x + s * (b.x - a.x), a.y + s * (b.y - a.y), a.z + s * (b.z - a.z)});
  const double angle = std::acos(std::max(-1.0, d)), sine = std::sin(angle);
  if (sine < 1e-12) return a;  // the same orientation with opposite signs: nothing to rotate
  const double p = std::sin((1 - s) * angle) / sine, q = std::sin(s * angle) / sine;
  return {p * a.w + q * b.w, p * a.x + q * b.x, p * a.y + q * b.y, p * a.z + q * b.z};
}

}  // namespace betwixt
