// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "scene/outline.h"

#include "scene/extent.h"

namespace betwixt {
namespace {

// Keeps the letters that `wanted` says, with their contours.
template <class Wanted>
void keep_letters(Outline& o, const Wanted& wanted) {
  Outline out;
  for (std::size_t i = 0; i < o.letters.size(); ++i) {
    if (!wanted(o.letters[i])) continue;
    const std::size_t end = i + 1 < o.letters.size() ? o.letters[i + 1].first : o.contours.size();
    const std::size_t first = std::exchange(o.letters[i].first, out.contours.size());
    out.letters.push_back(std::move(o.letters[i]));
    for (std::size_t k = first; k < end; ++k) out.contours.push_back(std::move(o.contours[k]));
  }
  o = std::move(out);
}

}  // namespace

bool shows_part(const Shape& s, std::string_view part) {
  const std::string_view all = *s.parts;
  bool listed = false;
  for (std::size_t at = 0; at < all.size() && !listed;) {
    const std::size_t end = std::min(all.find('\n', at), all.size());
    listed = !part.empty() && all.substr(at, end - at) == part;
    at = end + 1;
  }
  return listed == s.only_parts;
}

void keep_shown_parts(Outline& out, const Shape& s) {
  if (s.only_parts || !s.parts->empty()) keep_letters(out, [&](const Letter& l) { return shows_part(s, l.part); });
}

Outline set_formula(const Shape& s) {
  Extent all;  // of the whole, so that letters keep their places while it is typed
  for (const Contour& contour : s.formula->contours)
    for (const Vec3 p : contour) all.add(p);
  Outline out = *s.formula;
  if (s.letters.typed < out.letters.size()) {
    out.contours.resize(out.letters[s.letters.typed].first);
    out.letters.resize(s.letters.typed);
  }
  keep_shown_parts(out, s);
  if (all.empty()) return out;
  const double from = s.letters.align == Align::left    ? all.low.x
                      : s.letters.align == Align::right ? all.high.x
                                                        : all.middle().x;
  const double up = s.letters.anchor == Anchor::top      ? all.high.y
                    : s.letters.anchor == Anchor::middle ? all.middle().y
                    : s.letters.anchor == Anchor::bottom ? all.low.y
                                                         : 0;
  for (Contour& contour : out.contours)
    for (Vec3& p : contour) p = s.size.y * (p - Vec3{from, up, 0});
  return out;
}

}  // namespace betwixt
