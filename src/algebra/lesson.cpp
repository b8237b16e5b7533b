// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "algebra/lesson.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "algebra/plan.h"
#include "algebra/text.h"
#include "base/json.h"
#include "betwixt/symbols.h"

namespace betwixt::algebra::lesson {
namespace {

template <class Range, class Write>
std::string json_list(const Range& range, Write write) {
  std::string out = "[";
  for (const auto& x : range) out += (out.size() > 1 ? "," : "") + write(x);
  return out + "]";
}
std::string json_list(const std::vector<double>& numbers) { return json_list(numbers, json_number); }
std::string json_place(Vec3 v) { return json_list(std::vector<double>{v.x, v.y, v.z}); }
std::string json_rows(const Mat4& m) {
  std::vector<double> numbers;
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 4; ++c) numbers.push_back(m(r, c));
  return json_list(numbers);
}

// Reads a motion, even one that cannot be shown.
Result<Motion> understood(std::string_view text) {
  auto motion = parse_motion(text);
  if (!motion) return motion;
  for (const Factor& f : motion->factors)
    if (!f.about.empty())
      return fail(ErrorCode::name, fmt::format("there is no object '{}' here", f.about),
                  "write the centre as a point: @ 0 1");
  return motion;
}

std::string refused(const Error& e) {
  const int column = e.place.line > 0 ? e.place.column : 0;
  return fmt::format("{{\"error\":{{\"message\":{},\"hint\":{},\"column\":{},\"length\":{}}}}}", json_text(e.message),
                     json_text(e.hint), column, column > 0 ? e.place.length : 0);
}

std::string factor_json(const Factor& f) {
  const std::string text = json_text(to_string(Motion{{f}}));
  if (f.kind == Factor::Kind::translate)
    return fmt::format("{{\"kind\":\"T\",\"text\":{},\"by\":{}}}", text, json_place(f.by));
  if (f.kind == Factor::Kind::rotate)
    return fmt::format("{{\"kind\":\"R\",\"text\":{},\"turns\":{},\"centre\":{},\"axis\":{}}}", text,
                       json_number(f.angle / (2 * pi)), json_place(f.centre), json_place(normalize(f.axis)));
  return fmt::format("{{\"kind\":\"S\",\"text\":{},\"by\":{},\"centre\":{},\"linear\":{}}}", text, json_place(f.by),
                     json_place(f.centre), f.law == Factor::Law::linear);
}

// Returns the matrix in symbols, or why it is not written out.
std::string symbols_json(const Motion& motion) {
  const auto symbols = in_symbols(motion);
  if (!symbols) return fmt::format("{{\"why\":{}}}", json_text(symbols.error().message));
  const auto letter = [&](const Symbol& l) {
    return fmt::format("{{\"name\":{},\"factor\":{},\"means\":{}}}", json_text(l.name), l.factor,
                       json_text(meaning_of(l, motion)));
  };
  const auto sum = [&](const std::vector<Term>& terms) { return json_text(to_string(terms, *symbols)); };
  return fmt::format("{{\"letters\":{},\"sums\":{}}}", json_list(symbols->letters, letter),
                     json_list(symbols->sums, sum));
}

// Returns the same for one factor, with the letters that it has in the whole string.
std::string symbols_json(const Motion& motion, std::size_t factor) {
  Motion alone = motion;
  for (std::size_t i = 0; i < alone.factors.size(); ++i)
    if (i != factor) alone.factors[i] = translate_by({});
  return symbols_json(alone);
}

// Returns the part of a factor at t: displacement, degrees or scales.
Vec3 part_of(const Factor& f, double t) {
  if (f.kind == Factor::Kind::translate) return t * f.by;
  if (f.kind == Factor::Kind::rotate) return {t * f.angle * 180 / pi, 0, 0};
  const Mat4 m = at({{f}}, t);
  return {m(0, 0), m(1, 1), m(2, 2)};
}

// ---- How a string is compiled

std::string pair_text(double x, double y) { return fmt::format("({}, {})", written(x), written(y)); }
std::string offset_text(const Offset<double>& o, double steps) {
  const bool still = o.x == 0 && o.y == 0;
  if (o.fixed()) return still ? "" : pair_text(o.x, o.y);
  const std::string drift = "t " + pair_text(o.drift_x * steps, o.drift_y * steps);
  return still ? drift : pair_text(o.x, o.y) + " + " + drift;
}
std::string block_text(const Block& b) {
  if (b.linear) return fmt::format("S({} {} linear)", written(1 + b.slope_x), written(1 + b.slope_y));
  std::string text;
  if (!b.turns.none()) text = "R(" + angle_text(angle_of(b.turns)) + ")";
  if (b.log_x == 0 && b.log_y == 0) return text;
  const double x = std::exp(b.log_x), y = std::exp(b.log_y);
  return text + (text.empty() ? "" : " ") +
         (x == y ? fmt::format("S({:.12g})", x) : fmt::format("S({:.12g} {:.12g})", x, y));
}
// (1, 4) + R(1rad) (p + (-1, -4))
std::string compiled_text(const Motion& motion, std::int64_t steps) {
  const Canonical<double> string = canonical<double>(motion, steps);
  std::string text = "p", inner = offset_text(string.offsets.back(), static_cast<double>(steps));
  if (!inner.empty()) text += " + " + inner;
  for (std::size_t i = string.blocks.size(); i-- > 0;) {
    const std::string outer = offset_text(string.offsets[i], static_cast<double>(steps));
    text =
        (outer.empty() ? "" : outer + " + ") + block_text(string.blocks[i]) + (text == "p" ? " p" : " (" + text + ")");
  }
  return text;
}

// ---- Methods

std::string printed_json(const Cost& step, const Cost& before, const Cost& after) {
  return fmt::format(",\"printed\":{{\"step\":{},\"before\":{},\"after\":{},\"operations\":{}}}",
                     json_text(to_string(step)), json_text(to_string(before)), json_text(to_string(after)),
                     step.per_point * static_cast<long long>(counted_for) + step.besides);
}

struct Taught {
  std::string name;
  Method method;
  bool linear_law = false;
  std::string printed;  // JSON; of the source's row
};

constexpr std::int64_t most_shown_steps = 2'000;  // for everything that is drawn or measured step by step

std::string method_json(const Taught& way, const Motion& motion, std::int64_t steps, const Places& points) {
  const Motion taught = way.linear_law ? by_linear_law(motion) : motion;
  std::string out = fmt::format("{{\"name\":{},\"method\":{},\"linear\":{}{}", json_text(way.name),
                                json_text(name_of(way.method)), way.linear_law, way.printed);
  const Result<Count> count = count_operations(taught, steps, way.method, counted_for);
  if (!count)
    return out + fmt::format(",\"refused\":{},\"hint\":{}}}", json_text(count.error().message),
                             json_text(count.error().hint));
  const std::vector<Mat4> frames = stepped(taught, way.method, std::min(steps, most_shown_steps));
  const Gap gap = gap_between(taught, frames, points);
  return out + fmt::format(
                   ",\"does\":{},\"step\":{},\"before\":{},\"functions\":{},\"operations\":{},\"gap\":{},\"at\":{},"
                   "\"frames\":{}}}",
                   json_text(count->kernel), json_text(to_string(count->step)), json_text(to_string(count->before)),
                   count->before.functions,
                   count->step.per_point * static_cast<long long>(counted_for) + count->step.besides,
                   json_number(gap.most), json_number(gap.at), json_list(frames, json_rows));
}

}  // namespace

Result<Motion> read(std::string_view text, const Places& points) {
  auto motion = understood(text);
  if (!motion) return motion;
  if (auto bad = can_be_shown(*motion, points); !bad) return bad.error();
  return motion;
}

std::string string_answer(std::string_view text, const Places& points) {
  const auto motion = read(text, points);
  if (!motion) return refused(motion.error());
  std::vector<std::string> alone;
  for (std::size_t i = 0; i < motion->factors.size(); ++i) alone.push_back(symbols_json(*motion, i));
  return fmt::format("{{\"text\":{},\"planar\":{},\"unit\":{},\"factors\":{},\"symbols\":{},\"alone\":{}}}",
                     json_text(to_string(*motion)), is_planar(*motion), json_number(unit_for(*motion, points)),
                     json_list(motion->factors, factor_json), symbols_json(*motion),
                     json_list(alone, [](const std::string& s) { return s; }));
}

std::string frames_answer(std::string_view text, double from, double to, int count, bool linear_law) {
  const auto motion = understood(text);
  if (!motion) return refused(motion.error());
  const Motion shown = linear_law ? by_linear_law(*motion) : *motion;
  std::vector<Mat4> frames;
  for (int k = 0; k <= count; ++k) frames.push_back(at(shown, count == 0 ? from : from + (to - from) * k / count));
  return fmt::format("{{\"frames\":{}}}", json_list(frames, json_rows));
}

std::string moment_answer(std::string_view text, double t) {
  const auto motion = understood(text);
  if (!motion) return refused(motion.error());
  const auto symbols = in_symbols(*motion);
  return fmt::format("{{\"matrix\":{},\"letters\":{},\"parts\":{},\"alone\":{}}}", json_rows(at(*motion, t)),
                     symbols ? json_list(values_of(*symbols, *motion, t)) : "[]",
                     json_list(motion->factors, [t](const Factor& f) { return json_place(part_of(f, t)); }),
                     json_list(motion->factors, [t](const Factor& f) { return json_rows(at({{f}}, t)); }));
}

std::string methods_answer(std::string_view text, std::int64_t steps, const Places& points) {
  const auto motion = read(text);
  if (!motion) return refused(motion.error());
  if (!is_planar(*motion))
    return refused(
        fail(ErrorCode::type, "this motion leaves the plane", "the methods of the paper work only in the plane"));
  if (auto first = frame(*motion, 0, steps); !first) return refused(first.error());
  std::vector<Taught> all;
  const auto source = printed_costs(*motion);
  const bool refuses = !count_operations(*motion, steps, Method::geometric, counted_for);
  for (const Method method : {Method::matrix, Method::geometric, Method::differences, Method::best}) {
    all.push_back({std::string(name_of(method)), method, false, ""});
    if (!source) continue;
    if (method == Method::matrix) all.back().printed = printed_json(source->matrix, source->matrix_before, {});
    if (method != Method::geometric) continue;
    // The source counts it under the linear law.
    if (refuses && by_linear_law(*motion) != *motion) all.push_back({"geometric, linear law", method, true, ""});
    all.back().printed = printed_json(source->geometric, source->geometric_before, source->geometric_after);
  }
  return fmt::format("{{\"countedFor\":{},\"compiled\":{},\"ways\":{}}}", counted_for,
                     json_text(compiled_text(*motion, steps)),
                     json_list(all, [&](const Taught& way) { return method_json(way, *motion, steps, points); }));
}

std::string drift_answer(std::string_view text, Method method, bool linear_law, bool single, const Places& points) {
  const auto motion = read(text);
  if (!motion) return refused(motion.error());
  const Motion taught = linear_law ? by_linear_law(*motion) : *motion;
  const auto run = [&](bool renewed) {
    return json_list(single ? drift<float>(taught, method, drift_steps, points, renewed)
                            : drift<double>(taught, method, drift_steps, points, renewed));
  };
  return fmt::format("{{\"steps\":{},\"marks\":{},\"alone\":{},\"renewed\":{}}}", drift_steps,
                     json_list(drift_marks(drift_steps), [](std::int64_t n) { return std::to_string(n); }), run(false),
                     run(true));
}

std::string ways_answer(std::string_view text, const Places& points) {
  const auto motion = read(text);
  if (!motion) return refused(motion.error());
  constexpr const char* kinds[] = {"root", "no root", "scheme", "law"};
  return fmt::format("{{\"ways\":{}}}", json_list(other_ways(*motion, points), [&](const OtherWay& way) {
                       return fmt::format("{{\"kind\":\"{}\",\"linear\":{},\"gap\":{},\"at\":{},\"frames\":{}}}",
                                          kinds[static_cast<std::size_t>(way.kind)], way.beside_linear,
                                          json_number(way.gap.most), json_number(way.gap.at),
                                          json_list(way.frames, json_rows));
                     }));
}

std::string changed_answer(std::string_view text, std::size_t factor, std::string_view what, Vec3 to) {
  auto motion = read(text);
  if (!motion) return refused(motion.error());
  if (factor >= motion->factors.size())
    return refused(fail(ErrorCode::range, fmt::format("there is no factor {} here", factor + 1)));
  Factor& f = motion->factors[factor];
  if (what == "by") f.by = to;
  if (what == "centre") f.centre = to;
  if (what == "axis") f.axis = to;
  if (what == "angle") f.angle = to.x * pi / 180, f.angle_rest = 0;
  if (what == "linear") f.law = to.x != 0 ? Factor::Law::linear : Factor::Law::exponential;
  if (auto bad = can_be_shown(*motion, {}); !bad) return refused(bad.error());
  return fmt::format("{{\"text\":{}}}", json_text(to_string(*motion)));
}

}  // namespace betwixt::algebra::lesson
