// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/shell/text_diff.h"

#include <algorithm>
#include <string>
#include <string_view>

#include "compare/line_merge.h"
#include "studio/shell/text_of.h"

namespace betwixt::studio {
namespace {

using Sign = DiffLine::Sign;
std::vector<std::string_view> lines_of(const std::string& text) {
  std::vector<std::string_view> all;
  std::string_view left = text;
  for (;;) {
    const std::size_t feed = left.find('\n');
    all.push_back(left.substr(0, feed));
    if (feed == left.npos) return all;
    left.remove_prefix(feed + 1);
  }
}

}  // namespace

std::vector<DiffLine> text_diff(const QString& before, const QString& after, int around) {
  if (before == after) return {};
  const std::string was = before.toStdString(), is = after.toStdString();
  const auto a = lines_of(was), b = lines_of(is);
  const std::vector<int> equal = equal_lines(a, b);
  std::vector<DiffLine> all;
  const auto add = [&](Sign sign, std::string_view line) { all.push_back({sign, text_of(line)}); };
  std::size_t k = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (equal[i] < 0) {
      add(Sign::removed, a[i]);
      continue;
    }
    while (k < static_cast<std::size_t>(equal[i])) add(Sign::added, b[k++]);
    add(Sign::same, a[i]), ++k;
  }
  while (k < b.size()) add(Sign::added, b[k++]);
  // Only the lines around a change stay.
  std::vector<bool> near(all.size());
  const auto count = static_cast<qsizetype>(all.size());
  for (qsizetype i = 0; i < count; ++i)
    if (all[static_cast<std::size_t>(i)].sign != Sign::same)
      for (qsizetype k = std::max<qsizetype>(0, i - around); k <= std::min(count - 1, i + around); ++k)
        near[static_cast<std::size_t>(k)] = true;
  std::vector<DiffLine> shown;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (near[i])
      shown.push_back(std::move(all[i]));
    else if (shown.empty() || shown.back().sign != Sign::gap)
      shown.push_back({Sign::gap, {}});
  }
  return shown;
}

}  // namespace betwixt::studio
