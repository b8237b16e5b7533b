// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "editor/plain_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "betwixt/language.h"
#include "betwixt/program.h"
#include "language/json.h"
#include "language/values.h"

namespace betwixt {
namespace {

// Replaces numbers that are nearly 0 beside the other numbers by 0, such as the sine of half a turn. JSON output is
// exact.
Value without_dust(Value r) {
  constexpr double dust = 1e-14;
  const auto clean = [](const std::vector<double*>& all, double largest) {
    for (const double* n : all) largest = std::max(largest, std::abs(*n));
    for (double* n : all)
      if (std::abs(*n) < dust * largest) *n = 0;
  };
  std::vector<double*> all;
  if (const auto* matrix = std::get_if<Matrix>(&r)) {  // the linear part and the translation have different scales
    Mat4 m = **matrix;
    for (std::size_t i = 0; i < 12; ++i) all.push_back(&m.m[i]);
    clean(all, 0);
    clean({&m.m[12], &m.m[13], &m.m[14]}, 1);
    return Matrix(m);
  }
  if (auto* p = std::get_if<Vec3>(&r)) all = {&p->x, &p->y, &p->z};
  if (auto* a = std::get_if<Angles>(&r)) all = {&a->xyz.x, &a->xyz.y, &a->xyz.z};
  if (auto* q = std::get_if<Quat>(&r)) all = {&q->w, &q->x, &q->y, &q->z};
  clean(all, 0);
  return r;
}

bool is_world(const Target& t) { return t.query() == Query::world && t.component < 0; }

}  // namespace

std::string plain_value(const Value& exact, const Target& t, const Document& d) {
  Value r = without_dust(exact);
  // Rounds angles so that people read whole degrees, even if the last bits differ.
  const auto degrees = [](double& angle) {
    if (const double rounded = std::round(angle * (180 / pi) * 1e9) / 1e9; std::isfinite(rounded))
      angle = rounded * (pi / 180);
  };
  if (auto* a = std::get_if<Angles>(&r))
    for (int i = 0; i < 3; ++i) degrees(a->xyz[i]);
  if (auto* n = std::get_if<double>(&r); n && !t.query()) {
    const Type whole = spec_of(d.scene(), t.function).type;
    if (row_of(t.component < 0 ? whole : component_type(whole)).angles) degrees(*n);
  }
  if (const auto* m = std::get_if<Matrix>(&r)) return write_matrix(**m);
  if (const auto* n = std::get_if<double>(&r); n && t.query()) return write_number(*n);
  if (const auto* b = std::get_if<bool>(&r); b && t.query()) return *b ? "on" : "off";
  if (const auto* names = std::get_if<Names>(&r); names && t.query())
    return fmt::format("({})", fmt::join(**names, " "));
  return write_value(r, spec_of(d.scene(), t.function), t.component,
                     [&](ObjectId id) { return id ? d.name(id) : std::string(); });
}

Result<std::vector<Target>> targets_of(const Document& d, std::vector<std::string> patterns,
                                       const std::function<void(const std::string&)>& nothing) {
  if (patterns.empty()) patterns = d.names();
  std::vector<Target> targets;
  std::set<std::tuple<std::uint32_t, std::uint16_t, int, bool>> named;  // to list each target once
  for (const std::string& pattern : patterns) {
    const auto found = find_targets(pattern, d);
    if (!found) return found.error();
    if (found->empty() && nothing) nothing(pattern);
    for (const Target& t : *found)
      if (named.insert({t.object.index, t.function, t.component, t.velocity}).second) targets.push_back(t);
  }
  return targets;
}

std::string values_json(const Document& d, const Program& program, const std::vector<Target>& targets,
                        const std::vector<std::pair<std::string, Time>>& times,
                        const std::function<void(const std::vector<std::string>&)>& problems) {
  std::string out = "{\"times\":[";
  for (std::size_t i = 0; i < times.size(); ++i) {
    out += fmt::format("{}{{\"at\":{},\"seconds\":{},\"values\":{{", i ? "," : "", json_text(times[i].first),
                       write_number(times[i].second.seconds()));
    std::vector<std::string> said;
    const auto values = program.read(targets, times[i].second, &said);
    if (problems) problems(said);
    for (std::size_t k = 0; k < targets.size(); ++k)
      out += fmt::format("{}{}:{}", k ? "," : "", json_text(d.name(targets[k])), json(values[k], targets[k], d));
    out += "}}";
  }
  return out + "]}";
}

Result<std::string> values_at(const Document& d, std::vector<std::string> patterns,
                              const std::vector<std::pair<std::string, Time>>& times) {
  if (patterns.empty()) patterns = d.names();
  std::vector<Target> targets;
  std::size_t wide = 0;
  const auto place = [&](const Target& t) { return d.name(t.object) + " is at"; };
  for (const std::string& pattern : patterns) {
    const auto found = find_targets(pattern, d);
    if (!found) return found.error();
    for (const Target& t : *found) {
      targets.push_back(t);
      wide = std::max({wide, d.name(t).size(), is_world(t) ? place(t).size() : 0});
    }
  }
  if (targets.empty()) return std::string("nothing has this name\n");
  const Program program = Program::compile(d);
  std::string said;
  for (const auto& [text, t] : times) {
    std::vector<std::string> problems;
    const std::vector<Value> all = program.read(targets, t, &problems);
    if (times.size() > 1) said += fmt::format("{} ({} s)\n", text, write_number(t.seconds()));
    const auto row = [&](const std::string& name, const std::string& value) {
      said += fmt::format("{}{:{}}  {}\n", times.size() > 1 ? "  " : "", name, wide, value);
    };
    for (std::size_t i = 0; i < all.size(); ++i) {
      row(d.name(targets[i]), plain_value(all[i], targets[i], d));
      const auto* world = std::get_if<Matrix>(&all[i]);
      if (world && is_world(targets[i])) row(place(targets[i]), write_vector(translation_of(**world)));
    }
    for (const std::string& p : problems) said += fmt::format("warning: {}\n", p);
  }
  return said;
}

}  // namespace betwixt
