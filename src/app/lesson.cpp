// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The page's words stand in lesson.html; its script, lesson.js, makes pictures and tables from the data below. It works
// out A(t) by itself; frames of ours let it say how well.
#include "app/lesson.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "algebra/power.h"
#include "app/lesson_page.h"
#include "app/markup.h"
#include "base/files.h"

namespace betwixt {
namespace {

using Json = nlohmann::ordered_json;
using FactorKind = Factor::Kind;
using Law = Factor::Law;
using Points = std::vector<Vec3>;

constexpr std::size_t most_factors = 64, most_points = 50;
constexpr double farthest = 1e9;
constexpr int samples = 120;                // of a slow path
constexpr double most_turns = 24;           // of a path that is sampled for its turns
constexpr std::size_t counted_for = 1'000;  // points that `best` is made for
constexpr std::int64_t drift_steps = 100'000;

// ---- What a page can show

double size_of(const Mat4& m) {
  double most = 0;
  for (const double x : m.m) most = std::isfinite(x) ? std::max(most, std::abs(x)) : INFINITY;
  return most;
}

// What is drawn: every factor by itself, and every factor with those on its right.
bool drawable(const Motion& motion) {
  const std::vector<Factor>& f = motion.factors;
  const auto small = [](Vec3 v) { return std::max(std::abs(v.x), std::abs(v.y)) <= farthest; };
  for (auto i = f.begin(); i != f.end(); ++i) {
    if (!small(i->by) || !small(i->centre) || std::abs(i->angle) > farthest) return false;
    for (int k = 0; k <= 8; ++k)
      if (!(size_of(at({{i, i + 1}}, k / 8.0)) <= farthest && size_of(at({{i, f.end()}}, k / 8.0)) <= farthest))
        return false;
  }
  return true;
}

Status ready(const std::string& path, const Motion& motion, const LessonOptions& options) {
  if (const std::string type = ending(path); type != "html" && type != "htm")
    return fail(ErrorCode::range, fmt::format("a lesson is a .html, not \"{}\"", path));
  if (auto bad = check(motion); !bad) return bad;
  if (!is_planar(motion))
    return fail(ErrorCode::type, "this motion leaves the plane", "a lesson is drawn in the plane");
  if (auto first = frame(motion, 0, options.steps); !first) return first.error();
  if (motion.factors.size() > most_factors)
    return fail(ErrorCode::range, fmt::format("{} factors are too many for a lesson", motion.factors.size()),
                fmt::format("at most {}", most_factors));
  if (options.points.size() > most_points)
    return fail(ErrorCode::range, fmt::format("{} points are too many for a lesson", options.points.size()),
                fmt::format("at most {}", most_points));
  for (const Vec3& p : options.points)
    if (!(std::abs(p.x) <= farthest && std::abs(p.y) <= farthest))
      return fail(ErrorCode::range, "a point lies too far out for a lesson", "numbers up to a thousand million");
  if (!drawable(motion))
    return fail(ErrorCode::range, "this motion goes too far out for a lesson", "numbers up to a thousand million");
  return Nothing{};
}

// ---- The figure

// 1, 2 or 5 times a power of ten, so that the places of its corners are easy to read.
double round_unit(double about) {
  const double power = std::pow(10, std::floor(std::log10(about)));
  return power * (about < 1.5 * power ? 1 : about < 3.5 * power ? 2 : about < 7.5 * power ? 5 : 10);
}

// How wide the letter is: large enough to be seen beside all ways, centres (there and back again) and points.
double unit_for(const Motion& motion, const Points& points) {
  double reach = 0;
  const auto take = [&](Vec3 v) { reach = std::max({reach, std::abs(v.x), std::abs(v.y)}); };
  for (const Factor& f : motion.factors) take(f.kind == FactorKind::translate ? f.by : 2 * f.centre);
  for (const Vec3& p : points) take(p);
  return reach > 1e-300 ? round_unit(0.18 * reach) : 1;
}

Points letter_f(double unit) {
  Points corners{{0, 0}, {.3, 0}, {.3, .6}, {.8, .6}, {.8, .9}, {.3, .9}, {.3, 1.2}, {1, 1.2}, {1, 1.5}, {0, 1.5}};
  for (Vec3& p : corners) p = unit * p;
  return corners;
}

// ---- Data

Json pair(Vec3 p) { return {p.x, p.y}; }
// As CSS and SVG order it: x' = a x + c y + e, y' = b x + d y + f.
Json numbers(const Mat4& m) { return {m(0, 0), m(1, 0), m(0, 1), m(1, 1), m(0, 3), m(1, 3)}; }
Json list(const Points& points) {
  Json all = Json::array();
  for (const Vec3& p : points) all.push_back(pair(p));
  return all;
}
Json list(const std::vector<Mat4>& frames) {
  Json all = Json::array();
  for (const Mat4& m : frames) all.push_back(numbers(m));
  return all;
}

Json data_of(const Factor& f) {
  Json j{{"kind", std::string(1, "TRS"[static_cast<int>(f.kind)])}, {"text", to_string(Motion{{f}})}};
  if (f.kind == FactorKind::translate) return j["by"] = pair(f.by), j;
  j["centre"] = pair(f.centre);
  if (!f.about.empty()) j["about"] = f.about;
  if (f.kind == FactorKind::rotate)
    j["turns"] = (f.axis.z < 0 ? -f.angle : f.angle) / (2 * pi);
  else
    j["by"] = pair(f.by), j["linear"] = f.law == Law::linear;
  return j;
}

Motion linear_law(Motion motion) {
  for (Factor& f : motion.factors)
    if (f.kind == FactorKind::scale) f.law = Law::linear;
  return motion;
}
bool exponential_law(const Motion& motion) { return !(linear_law(motion) == motion); }

std::vector<Mat4> sampled(const Motion& motion, int steps = samples) {
  std::vector<Mat4> frames;
  for (int k = 0; k <= steps; ++k) frames.push_back(*frame(motion, k, steps));
  return frames;
}

double turns_of(const Motion& motion) {
  double turns = 0;
  for (const Factor& f : motion.factors)
    if (f.kind == FactorKind::rotate) turns += std::abs(f.angle) / (2 * pi);
  return turns;
}

// What becomes of three points says what becomes of all.
std::vector<Mat4> stepped(const Motion& motion, Method method, int count) {
  const std::vector<double> x{0, 1, 0}, y{0, 0, 1};
  auto steps = Steps<double>::make(motion, count, method, x, y);
  std::vector<Mat4> frames;
  for (; steps && frames.size() <= static_cast<std::size_t>(count); steps->step()) {
    const auto px = steps->x(), py = steps->y();
    Mat4 m;
    m(0, 3) = px[0], m(0, 0) = px[1] - px[0], m(0, 1) = px[2] - px[0];
    m(1, 3) = py[0], m(1, 0) = py[1] - py[0], m(1, 1) = py[2] - py[0];
    frames.push_back(m);
  }
  return frames;
}

// ---- Other paths to the same end

// `base`: the motion that it is compared with, by its own law or by the linear one. `shown`: its frames are needed, as
// the page cannot work them out.
void add_path(Json& paths, const char* kind, const std::vector<Mat4>& frames, const Motion& base, const char* law,
              const Points& points, bool shown) {
  if (frames.empty()) return;
  const int steps = static_cast<int>(frames.size()) - 1;
  const std::vector<Mat4> wanted = sampled(base, steps);
  double gap = 0, size = 0;
  int where = 0;
  for (int k = 0; k <= steps; ++k)
    for (const Vec3& p : points) {
      const auto i = static_cast<std::size_t>(k);
      const Vec3 is = transform_point(wanted[i], p);
      const double d = length(transform_point(frames[i], p) - is);
      size = std::max(size, length(is));
      if (d > gap) gap = d, where = k;
    }
  if (gap <= 1e-7 * size) return;
  paths.push_back({{"kind", kind}, {"base", law}, {"gap", gap}, {"at", where / static_cast<double>(steps)}});
  if (shown) paths.back()["frames"] = list(frames);
}

std::vector<Mat4> root_path(const Motion& motion) {
  std::vector<Mat4> frames;
  for (int k = 0; k <= samples; ++k) {
    const auto m = algebra::power(at(motion, 1), k / static_cast<double>(samples));
    if (!m || !(size_of(*m) <= farthest)) return {};
    frames.push_back(*m);
  }
  return frames;
}

Json other_paths(const Motion& motion, const Points& points) {
  Json paths = Json::array();
  const double turns = turns_of(motion);
  const int steps = turns > most_turns ? samples : std::max(samples, static_cast<int>(std::ceil(48 * turns)));
  if (!count_operations(motion, samples, Method::differences, 1)) {
    const std::vector<Mat4> root = root_path(motion);
    if (root.empty()) paths.push_back({{"kind", "no root"}});
    add_path(paths, "root", root, motion, "own", points, true);
  }
  const Motion linear = linear_law(motion);
  add_path(paths, "scheme", stepped(linear, Method::geometric, steps), linear, "linear", points, turns <= most_turns);
  if (exponential_law(motion)) add_path(paths, "law", sampled(linear, steps), motion, "own", points, false);
  return paths;
}

// ---- Drift

// 1, 2, 5, 10, ... and the last step but one; the last is the closed form's for every method.
std::vector<std::int64_t> marks(std::int64_t steps) {
  std::vector<std::int64_t> at;
  for (std::int64_t power = 1; power < steps; power *= 10)
    for (const std::int64_t n : {1, 2, 5})
      if (n * power < steps) at.push_back(n * power);
  if (!at.empty() && at.back() != steps - 1) at.push_back(steps - 1);
  return at;
}

// Largest distance so far from where the scheme would be without rounding; null where it is beyond all numbers.
template <class Number>
Json drift(const Motion& motion, Method method, std::int64_t steps, const Points& points, bool renewed) {
  std::vector<Number> x, y;
  std::vector<double> exact_x, exact_y;
  for (const Vec3& p : points) {
    x.push_back(static_cast<Number>(p.x)), y.push_back(static_cast<Number>(p.y));
    // Of the points that the method was given, rounded as they are.
    exact_x.push_back(static_cast<double>(x.back())), exact_y.push_back(static_cast<double>(y.back()));
  }
  auto run = Steps<Number>::make(motion, steps, method, x, y);
  auto exact = Steps<double>::make(motion, steps, method, exact_x, exact_y);
  Json largest = Json::array();
  if (!run || !exact) return largest;
  if (!renewed) run->renew_every(0);
  constexpr int apart = 61;  // no divisor of the steps between renewals: all their phases are looked at
  double worst = 0;
  for (const std::int64_t mark : marks(steps)) {
    while (run->frame() < mark) {
      run->step();
      if (run->frame() != mark && run->frame() > 1000 && run->frame() % apart != 0) continue;
      exact->seek(run->frame());
      for (std::size_t i = 0; i < x.size(); ++i) {
        const double d = std::hypot(static_cast<double>(run->x()[i]) - exact->x()[i],
                                    static_cast<double>(run->y()[i]) - exact->y()[i]);
        worst = std::isfinite(d) ? std::max(worst, d) : INFINITY;
      }
    }
    largest.push_back(std::isfinite(worst) ? Json(worst) : Json());
  }
  return largest;
}

template <class Number>
Json drifts(const Motion& motion, Method method, std::int64_t steps, const Points& points) {
  return {{"alone", drift<Number>(motion, method, steps, points, false)},
          {"renewed", drift<Number>(motion, method, steps, points, true)}};
}

// ---- Methods

Json way(std::string_view name, const Motion& motion, Method method, const LessonOptions& options,
         const Points& points) {
  Json j{{"name", name}};
  const Result<Count> count = count_operations(motion, options.steps, method, counted_for);
  if (!count) {
    j["refused"] = count.error().message, j["hint"] = count.error().hint;
    return j;
  }
  j["does"] = count->kernel;
  j["step"] = to_string(count->step), j["before"] = to_string(count->before);
  j["functions"] = count->before.functions;
  j["operations"] = count->step.per_point * static_cast<long long>(counted_for) + count->step.besides;
  j["f32"] = drifts<float>(motion, method, drift_steps, points);
  j["f64"] = drifts<double>(motion, method, drift_steps, points);
  return j;
}

void add_printed(Json& j, const Cost& step, const Cost& before, const Cost& after) {
  j["printed"] = {{"step", to_string(step)},
                  {"before", to_string(before)},
                  {"after", to_string(after)},
                  {"operations", step.per_point * static_cast<long long>(counted_for) + step.besides}};
}

Json ways(const Motion& motion, const LessonOptions& options, const Points& points) {
  Json all = Json::array();
  const std::optional<Printed> printed = printed_costs(motion);
  for (const Method method : {Method::matrix, Method::geometric, Method::differences, Method::best}) {
    all.push_back(way(name_of(method), motion, method, options, points));
    if (!printed) continue;
    if (method == Method::matrix) add_printed(all.back(), printed->matrix, printed->matrix_before, {});
    if (method != Method::geometric) continue;
    // The source counts it by the linear law.
    if (all.back().contains("refused") && exponential_law(motion))
      all.push_back(way("geometric, linear law", linear_law(motion), method, options, points));
    add_printed(all.back(), printed->geometric, printed->geometric_before, printed->geometric_after);
  }
  return all;
}

Json data_of(const Motion& motion, const LessonOptions& options) {
  const double unit = unit_for(motion, options.points);
  Points points = letter_f(unit);
  const Json figure = list(points);
  points.insert(points.end(), options.points.begin(), options.points.end());
  Json factors = Json::array();
  for (const Factor& f : motion.factors) factors.push_back(data_of(f));
  return {{"text", to_string(motion)},
          {"factors", factors},
          {"unit", unit},
          {"figure", figure},
          {"points", list(options.points)},
          {"steps", options.steps},
          {"countedFor", counted_for},
          {"frames", list(sampled(motion))},
          {"ways", ways(motion, options, points)},
          {"driftSteps", drift_steps},
          {"marks", marks(drift_steps)},
          {"paths", other_paths(motion, points)}};
}

// ---- The page

// Nothing in it can end the element that it stands in.
std::string for_script(const Json& data) {
  std::string out;
  for (const char c : data.dump(-1, ' ', true, Json::error_handler_t::replace)) {
    if (c == '<')
      out += "\\u003c";
    else
      out += c;
  }
  return out;
}

}  // namespace

Status write_lesson(const std::string& path, const Motion& motion, const LessonOptions& options) {
  if (auto bad = ready(path, motion, options); !bad) return bad;
  const std::string text = to_string(motion);
  const std::string page = filled(lesson_html, {{"title", escaped(text.empty() ? "no factors" : text)},
                                                {"style", lesson_css},
                                                {"data", for_script(data_of(motion, options))},
                                                {"script", lesson_js}});
  return write_whole(path, page, true);
}

}  // namespace betwixt
