// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "scene/outline.h"

#include "scene/extent.h"

namespace betwixt {

Outline set_formula(const Shape& s) {
  Extent all;  // of the whole, so that letters keep their places while it is typed
  for (const Contour& contour : s.formula->contours)
    for (const Vec3 p : contour) all.add(p);
  Outline out = *s.formula;
  if (s.letters.typed < out.letters.size()) {
    out.contours.resize(out.letters[s.letters.typed].first);
    out.letters.resize(s.letters.typed);
  }
  if (all.empty()) return out;
  const double from = s.letters.align == Align::left    ? all.low.x
                      : s.letters.align == Align::right ? all.high.x
                                                        : all.middle().x;
  for (Contour& contour : out.contours)
    for (Vec3& p : contour) p = s.size.y * (p - Vec3{from, 0, 0});
  return out;
}

}  // namespace betwixt
