// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The difference of two texts, as lines.
#pragma once

#include <QString>
#include <vector>

namespace betwixt::studio {

struct DiffLine {
  enum class Sign { same, added, removed, gap } sign;  // a gap stands for lines that are the same
  QString text;
  friend bool operator==(const DiffLine&, const DiffLine&) = default;
};

// Returns the lines that were added and removed, each with a few of the lines around it.
std::vector<DiffLine> text_diff(const QString& before, const QString& after, int around = 2);

}  // namespace betwixt::studio
