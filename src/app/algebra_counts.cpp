// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// betwixt algebra --count: the cost of the methods, beside the counts that the paper prints.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/algebra.h"
#include "language/json.h"
#include "language/values.h"

namespace betwixt::algebra_command {
namespace {

constexpr Method methods[] = {Method::matrix, Method::geometric, Method::differences, Method::best};

std::string json(const Cost& c) {
  return fmt::format("{{\"per_point\":{},\"besides\":{},\"functions\":{}}}", c.per_point, c.besides, c.functions);
}
// Includes the calls of sines and exponentials.
std::string whole_text(const Cost& c) {
  return to_string(c) + (c.functions == 0 ? "" : fmt::format(", {} f", c.functions));
}

// The paper's geometric method scales by the linear law, so its count is for that law.
Motion counted(const Motion& motion, Method m) {
  Motion as = motion;
  if (m == Method::geometric)
    for (Factor& f : as.factors)
      if (f.kind == Factor::Kind::scale) f.law = Factor::Law::linear;
  return as;
}

std::string row_text(const Printed& p, const Motion& motion) {
  return p.row == "R…R" ? fmt::format("R…R, n = {}", motion.factors.size()) : p.row;
}

struct Counted {
  Method method;
  Result<Count> count;
};
std::vector<Counted> counts(const Call& call, const Asked& asked) {
  std::vector<Counted> all;
  for (const Method m : methods)
    all.push_back({m, count_operations(counted(asked.motion, m), call.steps, m, asked.points.size())});
  return all;
}

// Returns the notes below the tables.
std::string notes(const Call& call, const Asked& asked, const std::vector<Counted>& all) {
  std::string text;
  for (const Counted& c : all)
    if (!c.count) text += fmt::format("  {}: {}\n", name_of(c.method), c.count.error().message);
  if (counted(asked.motion, Method::geometric) != asked.motion)
    text += "  geometric: with the scalings by the linear law\n";
  if (end_only(asked.motion))
    text += fmt::format("  geometric: exact only at the end; in between the error is up to {}\n",
                        write_number(off_the_way(call, asked)));
  return text;
}

}  // namespace

bool end_only(const Motion& motion) {
  const auto row = printed_costs(motion);
  return row && (row->row == "ST" || row->row == "SR");
}

double off_the_way(const Call& call, const Asked& asked) {
  const Motion motion = counted(asked.motion, Method::geometric);
  std::vector<double> x, y;
  for (const Point& p : asked.points) x.push_back(p.at.x), y.push_back(p.at.y);
  auto steps = Steps<double>::make(motion, call.steps, Method::geometric, x, y);
  double most = 0;
  if (!steps) return most;
  const std::int64_t looks = std::min<std::int64_t>(call.steps, 10'000);
  for (std::int64_t i = 0; i <= looks; ++i) {
    const std::int64_t k = looks == call.steps
                               ? i
                               : static_cast<std::int64_t>(static_cast<double>(call.steps) /
                                                           static_cast<double>(looks) * static_cast<double>(i));
    steps->seek(k);
    const Mat4 m = *frame(motion, k, call.steps);
    for (std::size_t p = 0; p < x.size(); ++p) {
      const Vec3 at = transform_point(m, {x[p], y[p], 0});
      most = std::max(most, std::hypot(steps->x()[p] - at.x, steps->y()[p] - at.y));
    }
  }
  return most;
}

std::string count_json(const Call& call, const Asked& asked) {
  std::string out = "{";
  if (const auto paper = printed_costs(asked.motion))
    out += fmt::format(
        "\"row\":{},\"paper\":{{\"matrix\":{},\"geometric\":{},\"matrix_before\":{},\"geometric_before\":{},"
        "\"geometric_after\":{}}},",
        json_text(paper->row), json(paper->matrix), json(paper->geometric), json(paper->matrix_before),
        json(paper->geometric_before), json(paper->geometric_after));
  out += "\"methods\":{";
  const char* between = "";
  for (const auto& [m, c] : counts(call, asked)) {
    out += fmt::format("{}{}:", std::exchange(between, ","), json_text(name_of(m)));
    std::string end;
    if (m == Method::geometric && end_only(asked.motion))
      end = fmt::format(",\"right_at\":\"the end only\",\"off\":{}", json_number(off_the_way(call, asked)));
    out += c ? fmt::format("{{\"kernel\":{},\"ours\":{},\"measured\":{},\"before\":{}{}}}", json_text(c->kernel),
                           json(c->planned), json(c->step), json(c->before), end)
             : fmt::format("{{\"error\":{}}}", json_text(c.error().message));
  }
  return out + "}}";
}

void print_counts(const Call& call, const Asked& asked) {
  const auto paper = printed_costs(asked.motion);
  const std::vector<Counted> all = counts(call, asked);
  const std::string row = paper ? ", row " + row_text(*paper, asked.motion) : "";
  const auto printed = [&](Method m, const Cost& matrix, const Cost& geometric) -> std::string {
    return !paper || m > Method::geometric ? "-" : to_string(m == Method::matrix ? matrix : geometric);
  };
  const Printed none, &p = paper ? *paper : none;
  fmt::print("Operations per step for Np points{}\n\n", paper ? row + " of the paper's first table" : "");
  fmt::print("  {:<12} {:<16} {:<12} {:<12} {}\n", "", "paper", "ours", "measured", "kernel");
  for (const auto& [m, c] : all)
    fmt::print("  {:<12} {:<16} {}\n", name_of(m), printed(m, p.matrix, p.geometric),
               c ? fmt::format("{:<12} {:<12} {}", to_string(c->planned), to_string(c->step), c->kernel) : "-");
  fmt::print("\nOperations before the first step{} (f: sines and exponentials)\n\n",
             paper ? row + " of the paper's second table" : "");
  fmt::print("  {:<12} {:<16} {:<25} {}\n", "", "paper", "measured", "afterwards, paper");
  for (const auto& [m, c] : all)
    fmt::print("  {:<12} {:<16} {:<25} {}\n", name_of(m), printed(m, p.matrix_before, p.geometric_before),
               c ? whole_text(c->before) : "-", printed(m, {}, p.geometric_after));
  const std::string said = notes(call, asked, all);
  fmt::print("{}{}", said.empty() ? "" : "\n", said);
}

}  // namespace betwixt::algebra_command
