// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "scene/kinds.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "scene/kind_rows.h"

namespace betwixt {

Detail Detail::for_pixels(double radius) {
  constexpr int steps[] = {8, 12, 16, 24, 32, 48, 64, 96, 128, 192, 256};
  // A circle of radius r is off its polygon of n sides by r (1 - cos(pi / n)): by 0.2 for n = 5 sqrt(r).
  const double wanted = 5 * std::sqrt(radius);
  const auto* enough = std::find_if(std::begin(steps), std::end(steps) - 1, [&](int n) { return n >= wanted; });
  return {*enough, false};
}
int Detail::around_thin(double share) const {
  return std::max(6, 2 * static_cast<int>(std::ceil(around / 2.0 * std::sqrt(share))));
}

std::span<const KindRow> kinds() { return kind_rows; }

const KindRow& row_of(Kind kind) {
  static const auto by_kind = [] {
    std::array<const KindRow*, 64> all{};  // bits of FunctionSpec::kinds
    all.fill(&kind_rows[0]);
    for (const KindRow& row : kind_rows) all[static_cast<std::size_t>(row.kind)] = &row;
    return all;
  }();
  return *by_kind[static_cast<std::size_t>(kind) % by_kind.size()];
}

std::optional<Kind> find_kind(std::string_view name) {
  if (name == "disc") return Kind::disc;  // its other name
  for (const KindRow& row : kind_rows)
    if (row.name == name) return row.kind;
  return std::nullopt;
}

std::string written_of(const KindRow& row) {
  std::string all(row.written);
  if (row.deep) all += " depth=0 fill=on stroke=none stroke-width=0.05 stroke-round=off";
  if (row.deep || row.line) all += " dash=(0 0) trim=(0 1)";
  return all;
}

std::string a_kind(Kind kind) { return std::string(row_of(kind).article) + " " + std::string(name_of(kind)); }

Extent extent(const Shape& s) {
  const auto of = row_of(s.kind).extent;
  return of ? of(s) : Extent{};
}

}  // namespace betwixt
