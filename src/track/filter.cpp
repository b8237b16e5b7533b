// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "track/filter.h"

#include <algorithm>
#include <bit>
#include <limits>

#include "track/filter_call.h"
#include "track/track.h"

namespace betwixt {

namespace {

using namespace filters;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double far = 1e12;  // larger than any number of a film

// Returns a number from -1 to 1 for each point of a lattice.
double slope_at(double point, double seed, int component) {
  std::uint64_t h = static_cast<std::uint64_t>(component) * 0x9e3779b97f4a7c15;
  for (const double part : {seed + 0.0, point + 0.0}) {  // + 0.0: -0 is 0
    h += std::bit_cast<std::uint64_t>(part) + 0x9e3779b97f4a7c15;
    h = (h ^ (h >> 30)) * 0xbf58476d1ce4e5b9;
    h = (h ^ (h >> 27)) * 0x94d049bb133111eb;
    h ^= h >> 31;
  }
  return static_cast<double>(h >> 11) * 0x1p-52 - 1;
}
// Gradient noise from -1 to 1: 0 at the points of the lattice, with a random slope there; two continuous derivatives.
// Each component has a shifted lattice, so that they are not 0 at the same time.
double noise_at(double x, double seed, int component) {
  x += component / 3.0;
  const double point = std::floor(x), u = x - point;
  const double fade = u * u * u * (u * (u * 6 - 15) + 10);
  const double a = slope_at(point, seed, component) * u, b = slope_at(point + 1, seed, component) * (u - 1);
  return 2 * (a + fade * (b - a));
}

// Adds to each component; rotates an orientation by that angle about its own axes.
template <class F>
Value add(const Value& v, F&& to_component) {
  if (const auto* q = std::get_if<Quat>(&v))
    return *q * from_angles({to_component(0), to_component(1), to_component(2)});
  Sample n = numbers(v);
  for (int i = 0; i < n.count; ++i) n.n[i] += to_component(i);
  return value_of(v, n.n);
}
Value noise(const FilterCall& told, Input& input, double seconds) {
  const Vec3 amount = told.triple("amount");
  const double x = seconds * told.number("frequency"), seed = told.number("seed");
  return add(look(input, seconds), [&](int i) {
    const int c = told.component(i);
    return amount[c] * noise_at(x, seed, c);
  });
}
Value wobble(const FilterCall& told, Input& input, double seconds) {
  const Vec3 amount = told.triple("amount");
  const double turns = seconds * told.number("frequency") + told.number("phase");
  const double sine = std::sin(2 * pi * (turns - std::floor(turns)));
  return add(look(input, seconds), [&](int i) { return amount[told.component(i)] * sine; });
}

template <class F>
Value each(const Value& v, F&& of_component) {
  if (std::holds_alternative<Quat>(v)) return v;
  Sample n = numbers(v);
  for (int i = 0; i < n.count; ++i) n.n[i] = of_component(n.n[i]);
  return value_of(v, n.n);
}
Value limit(const FilterCall& told, Input& input, double seconds) {
  const double low = told.number("low"), high = told.number("high");
  return each(look(input, seconds), [&](double x) { return std::min(std::max(x, low), high); });
}
Value quantise(const FilterCall& told, Input& input, double seconds) {
  const double by = told.number("by");
  return each(look(input, seconds), [&](double x) {
    const double steps = std::round(x / by);
    return std::abs(steps) < 0x1p53 ? steps * by : x;  // beyond that, doubles are coarser than the steps
  });
}

Value delay(const FilterCall& told, Input& input, double seconds) { return look(input, seconds - told.number("by")); }
Value steps(const FilterCall& told, Input& input, double seconds) {
  constexpr double half_a_flick = 0.5 / static_cast<double>(flicks_per_second);  // 0.58333 s is 7 twelfths
  const double rate = told.number("rate");
  return look(input, std::floor((seconds + half_a_flick) * rate) / rate);
}

}  // namespace

bool operator==(const Filter& a, const Filter& b) {
  return a.name == b.name && Procedure{a.code} == Procedure{b.code} && a.parameters == b.parameters &&
         a.component == b.component && a.segment == b.segment && a.off == b.off;
}

const std::vector<FilterSpec>& built_in_filters() {
  static const std::vector<FilterSpec> all{
      {.name = "smooth",
       .sentence = "Averages the values over a window of time, `width` long, around each moment.",
       .example = "filter ball.position smooth width=0.3s",
       .parameters = {{"width", Type::scalar, 0.5, 1e-3, 3600, true}},
       .value = smooth,
       .on_grid = true},
      {.name = "spring",
       .sentence = "Follows like a weight on a spring: late, and with oscillation: `frequency` times a second; from "
                   "`damping` 1 on "
                   "without.",
       .example = "filter ball.position spring frequency=3",
       .parameters = {{"frequency", Type::scalar, 2, 1e-2, 100}, {"damping", Type::scalar, 0.3, 0.05, 4}},
       .value = spring,
       .on_grid = true},
      {.name = "noise",
       .sentence = "Adds random motion, the same every time; `frequency` is per second.",
       .example = "filter ball.position noise amount=(0.1 0.1 0) frequency=4",
       .parameters = {{"amount", Type::vector, 1, -far, far, false, true},
                      {"frequency", Type::scalar, 1, 0, 1000},
                      {"seed", Type::scalar, 0, -far, far}},
       .value = noise},
      {.name = "wobble",
       .sentence = "Adds a sine wave; `frequency` is per second, `phase` in turns.",
       .example = "filter ball.position wobble amount=(0 0.2 0) frequency=2",
       .parameters = {{"amount", Type::vector, 1, -far, far, false, true},
                      {"frequency", Type::scalar, 1, 0, 1000},
                      {"phase", Type::scalar, 0, -1e6, 1e6}},
       .value = wobble},
      {.name = "delay",
       .sentence = "Delays the values; a negative length makes them earlier.",
       .example = "filter ball.position delay by=6f",
       .parameters = {{"by", Type::scalar, 0.25, -longest_seconds, longest_seconds, true}},
       .value = delay,
       .any_type = true},
      {.name = "steps",
       .sentence = "Holds each value until the next step; `rate` is steps a second.",
       .example = "filter ball.position steps rate=8",
       .parameters = {{"rate", Type::scalar, 12, 1e-3, 1000}},
       .value = steps,
       .any_type = true},
      {.name = "limit",
       .sentence = "Keeps the values between `low` and `high`; one that is not given is no limit.",
       .example = "filter ball.radius limit high=3",
       .parameters = {{"low", Type::scalar, -infinity, -infinity, infinity, false, true},
                      {"high", Type::scalar, infinity, -infinity, infinity, false, true}},
       .value = limit,
       .orientations = false},
      {.name = "quantise",
       .sentence = "Rounds the values to whole multiples of a step.",
       .example = "filter ball.position quantise by=0.5",
       .parameters = {{"by", Type::scalar, 0.1, 1e-9, far, false, true}},
       .value = quantise,
       .orientations = false}};
  return all;
}

const FilterSpec* find_filter(std::string_view name) {
  for (const FilterSpec& spec : built_in_filters())
    if (spec.name == name) return &spec;
  return nullptr;
}

bool suits(const FilterSpec& spec, Type type) {
  if (type == Type::orientation) return spec.orientations;
  if (has_velocity(type)) return true;
  return spec.any_type && type != Type::attachment;  // a parent is not a value over time
}

Result<Value> apply(const Filter& filter, Input& input, double seconds) {
  const auto within = [&] {
    const auto t = from_seconds(std::clamp(seconds, -longest_seconds, longest_seconds));
    return !filter.segment || (filter.segment->first <= t && t <= filter.segment->second);
  };
  if (!within()) return input.at(seconds);
  if (filter.code) return filter.code->filter(input, seconds, filter.parameters);
  const FilterSpec* spec = find_filter(filter.name);
  if (!spec) return input.at(seconds);
  Value made = spec->value({filter, *spec}, input, seconds);
  if (!spec->orientations && std::holds_alternative<Quat>(made))
    return fail(ErrorCode::type, "an orientation has no separate angles", "write the track as euler(x y z)");
  return made;
}

}  // namespace betwixt
