// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Filled outlines between two others: letter by letter, contour by contour.
#include "exchange/outline_morph.h"

#include <algorithm>
#include <deque>
#include <map>
#include <mutex>
#include <optional>

#include "exchange/code_match.h"
#include "exchange/outlines.h"
#include "exchange/shapes.h"
#include "exchange/text_match.h"
#include "scene/kinds.h"

namespace betwixt {
namespace {

bool has_letters(const Shape& s) { return row_of(s.kind).fill == Fill::outline && !row_of(s.kind).contours; }

Box bounds(const Contour& c, Box b = {}) {
  for (const Vec3 p : c) b.add(p);
  return b;
}
Vec3 middle(const Contour& c) { return bounds(c).middle(); }

// Maps a point of the box `from` to the box `to`.
Vec3 carried(Vec3 p, const Box& from, const Box& to) {
  for (int i = 0; i < 3; ++i) {
    const double span = from.high[i] - from.low[i];
    p[i] = lerp(to.low[i], to.high[i], span > 0 ? (p[i] - from.low[i]) / span : 0.5);
  }
  return p;
}

// A unit of pairing. Its islands are sorted by decreasing size.
struct DrawnGlyph {
  std::string text;
  std::vector<Island> islands;
  Box place;
  std::vector<Contour> contours;  // as they are in the outline
  std::string part;               // of a formula, or of code
  std::size_t at = 0;             // its first byte in the text
};

DrawnGlyph glyph(std::string text, std::vector<Contour> contours, Vec3 toward, bool single) {
  DrawnGlyph made{std::move(text), {}, {}, {}, {}, 0};
  std::vector<std::pair<double, Contour*>> sorted;
  // The first contour of a polygon is never a hole; contours of the opposite direction are.
  const bool turned = single && !contours.empty() && turn(contours.front(), toward) < 0;
  for (Contour& c : contours) {
    if (turned) std::reverse(c.begin(), c.end());
    sorted.emplace_back(turn(c, toward), &c);
  }
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const auto& a, const auto& b) { return std::abs(a.first) > std::abs(b.first); });
  for (const auto& [area, c] : sorted)
    if (area >= 0) made.islands.push_back({*c, {}});
  for (const auto& [area, c] : sorted) {
    if (area >= 0) continue;
    const auto home = std::find_if(made.islands.rbegin(), made.islands.rend(),
                                   [hole = c](const Island& i) { return contains(i.outer, hole->front()); });
    if (home != made.islands.rend()) home->holes.push_back(*c);
  }
  for (const auto& island : made.islands) made.place = bounds(island.outer, made.place);
  return made;
}

std::vector<DrawnGlyph> glyphs(const Outline& outline, bool single) {
  const Vec3 toward = facing(outline.contours);
  std::vector<DrawnGlyph> all;
  for (std::size_t i = 0; i < outline.letters.size(); ++i) {
    const auto at = [&](std::size_t n) { return outline.contours.begin() + static_cast<std::ptrdiff_t>(n); };
    const std::size_t end = i + 1 < outline.letters.size() ? outline.letters[i + 1].first : outline.contours.size();
    const Letter& letter = outline.letters[i];
    const std::size_t first = letter.first;
    all.push_back(glyph(letter.text, {at(first), at(end)}, toward, single));
    if (all.back().islands.empty()) {
      all.pop_back();
      continue;
    }
    all.back().contours.assign(at(first), at(end)), all.back().part = letter.part, all.back().at = letter.at;
  }
  return all;
}

// Two contours with the same number of points, which are interpolated point by point.
struct Pair {
  Contour from, to;
};

// Returns the arc length at each point, from 0 to 1, with one more entry for the return to the first point.
std::vector<double> arc(const Contour& c) {
  std::vector<double> at{0};
  for (std::size_t i = 0; i < c.size(); ++i) at.push_back(at.back() + length(c[(i + 1) % c.size()] - c[i]));
  const double whole = at.back();
  for (double& a : at) a = whole > 0 ? a / whole : 0;
  at.back() = 1;
  return at;
}

Vec3 point_at(const Contour& c, const std::vector<double>& arc, double u) {
  const auto next = std::clamp<std::ptrdiff_t>(std::upper_bound(arc.begin(), arc.end(), u) - arc.begin(), 1,
                                               static_cast<std::ptrdiff_t>(c.size()));
  const auto i = static_cast<std::size_t>(next - 1);
  const double span = arc[i + 1] - arc[i];
  return lerp(c[i], c[(i + 1) % c.size()], span > 0 ? std::clamp((u - arc[i]) / span, 0.0, 1.0) : 0);
}

// Rotates the start of `c`, to a corner or between two, so that its points travel least from `with`.
Contour aligned(const Contour& with, const Contour& c) {
  constexpr std::size_t samples = 64;
  const auto arc_with = arc(with), arc_c = arc(c);
  const Vec3 shift = middle(c) - middle(with);
  std::array<Vec3, samples> wanted;
  for (std::size_t k = 0; k < samples; ++k)
    wanted[k] = point_at(with, arc_with, static_cast<double>(k) / samples) + shift;
  double best = 0, least = INFINITY;
  const auto attempt = [&](double start) {
    double travel = 0;
    for (std::size_t k = 0; k < samples && travel < least; ++k) {
      const double v = static_cast<double>(k) / samples + start;
      const Vec3 d = point_at(c, arc_c, v < 1 ? v : v - 1) - wanted[k];
      travel += dot(d, d);
    }
    if (travel < least) least = travel, best = start;
  };
  for (std::size_t i = 0; i < c.size(); i += 1 + c.size() / 128) attempt(arc_c[i]);
  for (std::size_t k = 0; k < samples; ++k) attempt(static_cast<double>(k) / samples);
  const auto next = std::lower_bound(arc_c.begin(), arc_c.end() - 1, best) - arc_c.begin();
  Contour turned(c.begin() + next, c.end());
  turned.insert(turned.end(), c.begin(), c.begin() + next);
  if (arc_c[static_cast<std::size_t>(next)] != best) turned.insert(turned.begin(), point_at(c, arc_c, best));
  return turned;
}

// Adds the other's corners to each contour. At both ends this divides only straight sides.
Pair paired(const Contour& a, const Contour& b) {
  const Contour c = aligned(a, b);
  const auto arc_a = arc(a), arc_c = arc(c);
  std::vector<double> at = arc_a;
  at.insert(at.end(), arc_c.begin(), arc_c.end());
  std::sort(at.begin(), at.end());
  at.erase(std::unique(at.begin(), at.end(), [](double p, double q) { return q - p < 1e-9; }), at.end());
  if (at.size() > 1) at.pop_back();  // 1 equals 0
  Pair pair;
  for (const double u : at) {
    pair.from.push_back(point_at(a, arc_a, u));
    pair.to.push_back(point_at(c, arc_c, u));
  }
  return pair;
}

// The part of a morph that does not depend on its progress.
struct Morph {
  Shape a, b;
  std::vector<Pair> pairs;
  Winding winding = Winding::positive;
};

// A contour without a partner shrinks to a point, or grows out of one.
enum class Way : std::uint8_t { shrink, grow };
void lone(const Contour& c, Vec3 point, Way way, std::vector<Pair>& out) {
  Contour still(c.size(), point);
  out.push_back(way == Way::shrink ? Pair{c, std::move(still)} : Pair{std::move(still), c});
}
void lone(const Island& island, Vec3 point, Way way, std::vector<Pair>& out) {
  lone(island.outer, point, way, out);
  for (const auto& hole : island.holes) lone(hole, point, way, out);
}

Vec3 middle(const Island& island) { return middle(island.outer); }

// Pairs the parts of two places: the largest first, each with the nearest free one. A part left over shrinks to, or
// grows from, the corresponding point of the other place.
template <class Part, class F>
void pair_parts(const std::vector<Part>& a, const std::vector<Part>& b, const Box& place_a, const Box& place_b, F both,
                std::vector<Pair>& out) {
  const bool swapped = a.size() > b.size();
  const auto &fewer = swapped ? b : a, &more = swapped ? a : b;
  const Box &from = swapped ? place_b : place_a, &to = swapped ? place_a : place_b;
  std::vector<bool> taken(more.size());
  for (const auto& part : fewer) {
    const Vec3 wanted = carried(middle(part), from, to);
    std::size_t best = more.size();
    double least = INFINITY;
    for (std::size_t i = 0; i < more.size(); ++i)
      if (const double d = length(middle(more[i]) - wanted); !taken[i] && d < least) least = d, best = i;
    taken[best] = true;
    both(swapped ? more[best] : part, swapped ? part : more[best]);
  }
  for (std::size_t i = 0; i < more.size(); ++i)
    if (!taken[i]) lone(more[i], carried(middle(more[i]), to, from), swapped ? Way::shrink : Way::grow, out);
}

void pair_glyphs(const DrawnGlyph& a, const DrawnGlyph& b, std::vector<Pair>& out) {
  const auto holes = [&](const Contour& p, const Contour& q) { out.push_back(paired(p, q)); };
  const auto outers = [&](const Island& p, const Island& q) {
    out.push_back(paired(p.outer, q.outer));
    pair_parts(p.holes, q.holes, bounds(p.outer), bounds(q.outer), holes, out);
  };
  pair_parts(a.islands, b.islands, a.place, b.place, outers, out);
}

// Indexes of letters that become each other.
using Partners = std::vector<std::pair<std::size_t, std::size_t>>;

// Pairs letters at the least cost: 0 for a letter that stays, 1 for a replacement, a little over 1/2 for one that
// appears or disappears. Among equal costs it prefers letters at similar places in their texts.
Partners partners(const std::vector<DrawnGlyph>& a, const std::vector<DrawnGlyph>& b) {
  constexpr std::size_t most_cells = 1'000'000;
  constexpr double other = 1, missing = 0.55;
  const std::size_t n = a.size(), m = b.size(), row = m + 1;
  Partners found;
  if (n >= most_cells / row) {  // too long for the table: in order
    for (std::size_t i = 0; i < std::min(n, m); ++i) found.emplace_back(i, i);
    return found;
  }
  const auto apart = [&](std::size_t i, std::size_t j) {
    const auto place = [](std::size_t k, std::size_t of) {
      return (static_cast<double>(k) + 0.5) / static_cast<double>(of);
    };
    return 0.04 / static_cast<double>(std::max(n, m)) * std::abs(place(i, n) - place(j, m));
  };
  const auto change = [&](std::size_t i, std::size_t j) { return (a[i].text == b[j].text ? 0 : other) + apart(i, j); };
  std::vector<double> cost((n + 1) * row);  // of everything before letter i and letter j
  const auto at = [&](std::size_t i, std::size_t j) -> double& { return cost[i * row + j]; };
  for (std::size_t i = 0; i <= n; ++i)
    for (std::size_t j = 0; j <= m; ++j) {
      if (i == 0 || j == 0)
        at(i, j) = missing * static_cast<double>(i + j);
      else
        at(i, j) = std::min({at(i - 1, j - 1) + change(i - 1, j - 1), at(i - 1, j) + missing, at(i, j - 1) + missing});
    }
  for (std::size_t i = n, j = m; i > 0 && j > 0;) {
    const double without_i = at(i - 1, j) + missing, without_j = at(i, j - 1) + missing;
    if (at(i - 1, j - 1) + change(i - 1, j - 1) <= std::min(without_i, without_j))
      found.emplace_back(--i, --j);
    else if (without_i <= without_j)
      --i;
    else
      --j;
  }
  std::reverse(found.begin(), found.end());
  return found;
}

// Returns the point between two successive letters, or beside the only one if the other is missing or in another line.
Vec3 gap(const Box* before, const Box* after) {
  const auto beside = [](const Box& b, double x) { return Vec3{x, b.middle().y, b.middle().z}; };
  if (before == nullptr) return beside(*after, after->low.x);
  const Vec3 left = beside(*before, before->high.x);
  if (after == nullptr || after->middle().x <= before->middle().x) return left;
  return 0.5 * (left + beside(*after, after->low.x));
}

// Adds the letters from `first` up to `last`, which have no partner. `before` and `after` are the places of their
// neighbours' partners.
void lone_glyphs(const std::vector<DrawnGlyph>& all, std::size_t first, std::size_t last, const Box* before,
                 const Box* after, Way way, std::vector<Pair>& out) {
  for (std::size_t i = first; i < last; ++i) {
    const Vec3 point = before == nullptr && after == nullptr ? all[i].place.middle() : gap(before, after);
    for (const auto& island : all[i].islands) lone(island, point, way, out);
  }
}

// ---- Signs that go to equal signs

// The same sign has the same contours, in any place and size; a delimiter that is put together may have others.
void pair_signs(const DrawnGlyph& a, const DrawnGlyph& b, std::vector<Pair>& out) {
  const bool alike = std::equal(a.contours.begin(), a.contours.end(), b.contours.begin(), b.contours.end(),
                                [](const Contour& p, const Contour& q) { return p.size() == q.size(); });
  if (!alike) return pair_glyphs(a, b, out);
  for (std::size_t i = 0; i < a.contours.size(); ++i) out.push_back({a.contours[i], b.contours[i]});
}

// Returns the text with all its parts.
Outline whole_outline(Shape s) {
  s.parts = {}, s.only_parts = false;
  return outline_of(s);
}

// Returns the letters of code that go where others are.
Partners pairs_of_code(const Shape& a, const std::vector<DrawnGlyph>& from, const Shape& b,
                       const std::vector<DrawnGlyph>& to) {
  const auto partner = match_code(*a.text, *b.text, *b.language);
  std::map<std::size_t, std::size_t> there;  // by the first byte
  for (std::size_t j = 0; j < to.size(); ++j) there[to[j].at] = j;
  Partners out;
  for (std::size_t i = 0; i < from.size(); ++i)
    if (from[i].at < partner.size())
      if (const auto j = there.find(partner[from[i].at]); j != there.end()) out.emplace_back(i, j->second);
  return out;
}

Partners pairs_of_signs(const Shape& a, const std::vector<DrawnGlyph>& from, const Shape& b,
                        const std::vector<DrawnGlyph>& to) {
  if (!b.language->empty()) return pairs_of_code(a, from, b, to);
  const auto signs = [](const std::vector<DrawnGlyph>& all) {
    std::vector<MatchedSign> out;
    for (const DrawnGlyph& g : all) out.push_back({g.text, g.part, g.place.middle()});
    return out;
  };
  return match_signs(signs(from), signs(to));
}

// Adds what a shape draws: a sign that goes from a part to no part, or back, belongs to the part.
Morph matched(const Shape& a, const Shape& b) {
  Morph morph{a, b, {}, Winding::positive};
  const auto from = glyphs(whole_outline(a), false), to = glyphs(whole_outline(b), false);
  std::vector<bool> goes(from.size()), comes(to.size());
  for (const auto& [i, j] : pairs_of_signs(a, from, b, to)) {
    goes[i] = comes[j] = true;
    if (shows_part(b, from[i].part.empty() ? to[j].part : from[i].part)) pair_signs(from[i], to[j], morph.pairs);
  }
  const auto alone = [&](const std::vector<DrawnGlyph>& all, const std::vector<bool>& paired, Way way) {
    for (std::size_t i = 0; i < all.size(); ++i)
      if (!paired[i] && shows_part(b, all[i].part))
        for (const Island& island : all[i].islands) lone(island, all[i].place.middle(), way, morph.pairs);
  };
  alone(from, goes, Way::shrink), alone(to, comes, Way::grow);
  return morph;
}

Morph prepare(const Shape& a, const Shape& b) {
  if (b.matches) return matched(a, b);
  Morph morph{a, b, {}, Winding::positive};
  const bool text = has_letters(a) && has_letters(b);
  if (!text) morph.winding = Winding::nonzero;  // a polygon may cross itself
  const auto from = glyphs(outline_of(a), !has_letters(a)), to = glyphs(outline_of(b), !has_letters(b));
  std::size_t i = 0, j = 0;  // the next letters
  const auto up_to = [&](std::size_t next_i, std::size_t next_j) {
    const auto before = [](const auto& all, std::size_t k) { return k > 0 ? &all[k - 1].place : nullptr; };
    const auto after = [](const auto& all, std::size_t k) { return k < all.size() ? &all[k].place : nullptr; };
    lone_glyphs(from, i, next_i, before(to, j), after(to, next_j), Way::shrink, morph.pairs);
    lone_glyphs(to, j, next_j, before(from, i), after(from, next_i), Way::grow, morph.pairs);
  };
  for (const auto& [p, q] : partners(from, to)) {
    up_to(p, q);
    pair_glyphs(from[p], to[q], morph.pairs);
    i = p + 1, j = q + 1;
  }
  up_to(from.size(), to.size());
  return morph;
}

// Caches the last few, because a film uses the same one in successive frames.
std::shared_ptr<const Morph> morph_of(const Shape& a, const Shape& b) {
  static std::mutex mutex;
  static std::deque<std::shared_ptr<const Morph>> recent;
  const auto find = [&] {
    return std::find_if(recent.begin(), recent.end(), [&](const auto& m) { return m->a == a && m->b == b; });
  };
  {
    const std::lock_guard lock(mutex);
    if (const auto i = find(); i != recent.end()) return *i;
  }
  auto made = std::make_shared<const Morph>(prepare(a, b));
  const std::lock_guard lock(mutex);
  if (const auto i = find(); i != recent.end()) return *i;
  recent.push_front(made);
  if (recent.size() > 32) recent.pop_back();
  return made;
}

}  // namespace

bool has_outline(const Shape& s) { return has_letters(s) || row_of(s.kind).contours != nullptr; }

Outline contours_between(const Shape& a, const Shape& b, double s) {
  Outline outline;
  for (const auto& [from, to] : morph_of(a, b)->pairs) {
    Contour c(from.size());
    for (std::size_t i = 0; i < c.size(); ++i) c[i] = lerp(from[i], to[i], s);
    outline.contours.push_back(std::move(c));
  }
  return outline;
}

Mesh outline_between(const Shape& a, const Shape& b, double s) {
  const double depth = lerp(a.depth, b.depth, s);
  return drawn(contours_between(a, b, s), between(pen_of(a), pen_of(b), s), depth, morph_of(a, b)->winding);
}

}  // namespace betwixt
