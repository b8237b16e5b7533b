// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/shell/text_diff.h"

#include <QStringList>
#include <algorithm>

namespace betwixt::studio {
namespace {

using Sign = DiffLine::Sign;
constexpr qsizetype most_pairs =
    4'000'000;  // above that, all lines between the first and the last change count as changed

// The changes between two runs of lines, by their longest common subsequence.
std::vector<DiffLine> changes_between(const QStringList& before, const QStringList& after) {
  std::vector<DiffLine> all;
  const qsizetype n = before.size(), m = after.size();
  if (n * m > most_pairs) {
    for (const QString& l : before) all.push_back({Sign::removed, l});
    for (const QString& l : after) all.push_back({Sign::added, l});
    return all;
  }
  std::vector<int> common(static_cast<std::size_t>((n + 1) * (m + 1)));
  const auto at = [&](qsizetype i, qsizetype k) -> int& { return common[static_cast<std::size_t>(i * (m + 1) + k)]; };
  for (qsizetype i = n - 1; i >= 0; --i)
    for (qsizetype k = m - 1; k >= 0; --k)
      at(i, k) = before[i] == after[k] ? at(i + 1, k + 1) + 1 : std::max(at(i + 1, k), at(i, k + 1));
  qsizetype i = 0, k = 0;
  while (i < n || k < m) {
    if (i < n && k < m && before[i] == after[k])
      all.push_back({Sign::same, before[i++]}), ++k;
    else if (i < n && (k == m || at(i + 1, k) >= at(i, k + 1)))
      all.push_back({Sign::removed, before[i++]});
    else
      all.push_back({Sign::added, after[k++]});
  }
  return all;
}

}  // namespace

std::vector<DiffLine> text_diff(const QString& before, const QString& after, int around) {
  const QStringList a = before.split('\n'), b = after.split('\n');
  qsizetype head = 0, tail = 0;
  const qsizetype least = std::min(a.size(), b.size());
  while (head < least && a[head] == b[head]) ++head;
  while (tail < least - head && a[a.size() - 1 - tail] == b[b.size() - 1 - tail]) ++tail;
  if (head == a.size() && head == b.size()) return {};
  std::vector<DiffLine> all;
  for (qsizetype i = 0; i < head; ++i) all.push_back({Sign::same, a[i]});
  for (DiffLine& l : changes_between(a.mid(head, a.size() - head - tail), b.mid(head, b.size() - head - tail)))
    all.push_back(std::move(l));
  for (qsizetype i = a.size() - tail; i < a.size(); ++i) all.push_back({Sign::same, a[i]});
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
