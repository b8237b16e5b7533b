// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "render/flat.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

#include "base/stages.h"
#include "render/encoding.h"
#include "render/lighting.h"

namespace betwixt {
namespace {

// Comparisons of boxes of objects that are deep, for one picture: more would take longer than drawing them otherwise.
constexpr std::size_t most_compared = 200'000;
constexpr double same_depth = 2e-7;  // metres per metre of depth: what f32 can tell apart

// Returns whether the film is a drawing before a plain background, without pictures on objects.
bool is_drawing(const Columns& c) {
  const Surroundings& around = c.surroundings;
  if (!around.flat || around.fog || around.ground || (around.sky && !around.clear)) return false;
  return std::all_of(c.looks.begin(), c.looks.end(),
                     [](const Evaluation::Look& l) { return !l.visible || l.texture == Evaluation::Look::none; });
}

// Returns the background of a row of the picture: at 0 the top, at 1 the bottom.
Vec3 behind_row(const Scenery& s, double at) {
  const bool given = s.background && finite(*s.background);
  if (s.surroundings.clear || (s.plain() && !given)) return {};
  if (s.plain()) return *s.background;
  const Vec3 top = s.background.value_or(Lighting::above);
  const Vec3 bottom = s.background ? *s.surroundings.below : Lighting::beneath;
  const double part = s.background ? at : at * at * (3 - 2 * at);
  return top + part * (bottom - top);
}

bool boxes_meet(const Area& a, const Area& b) {
  return a.left() < b.right() && b.left() < a.right() && a.top() < b.bottom() && b.top() < a.bottom();
}

}  // namespace

bool FlatPainter::draw(const Columns& columns, Picture& out) {
  if (!is_drawing(columns)) return false;
  const InStage stage(Stage::draw);
  const bool other_things = update(columns), other_scenery = scenery_.take(columns);
  if (!flat_) {
    picture_ = {};
    return false;
  }
  if (other_scenery || picture_.rgba.empty()) mark_all();
  if (other_things || other_scenery || picture_.rgba.empty()) fill(picture_);
  rows_.assign(rows_.size(), {0, 0});
  out = picture_;
  return true;
}

bool FlatPainter::draw(const Columns& columns, LinearPicture& out) {
  if (!is_drawing(columns)) return false;
  const InStage stage(Stage::draw);
  const bool other_things = update(columns), other_scenery = scenery_.take(columns);
  if (other_things || other_scenery) picture_ = {};
  if (!flat_) return false;
  fill(out);
  return true;
}

// Returns false if nothing differs from the previous picture.
bool FlatPainter::update(const Columns& columns) {
  if (!things_.take(columns)) return false;
  const std::vector<Thing>& all = things_.all();
  for (std::size_t i = all.size(); i < painted_.size(); ++i) mark(painted_[i]);
  painted_.resize(all.size());
  std::vector<char> renewed(all.size(), things_.all_changed() ? 1 : 0);
  const auto renew = [&](std::uint32_t i) {
    mark(painted_[i]);
    outline(painted_[i], all[i]);
    mark(painted_[i]);
    renewed[i] = 1;
  };
  if (things_.all_changed())
    for (std::uint32_t i = 0; i < all.size(); ++i) renew(i);
  else
    for (const std::uint32_t i : things_.changed()) renew(i);
  const std::vector<std::uint32_t> before = std::exchange(order_, {});
  flat_ = sort();
  find_seams();
  // The others must keep their order.
  const auto same = [&](std::vector<std::uint32_t> from, std::vector<std::uint32_t> to) {
    const auto is_new = [&](std::uint32_t i) { return i >= renewed.size() || renewed[i] != 0; };
    std::erase_if(from, is_new), std::erase_if(to, is_new);
    return from == to;
  };
  if (things_.all_changed() || !same(before, order_)) mark_all();
  return true;
}

void FlatPainter::mark(const Painted& one) {
  for (const Paint& p : one.parts) {
    const int left = std::max(static_cast<int>(p.area.left()), 0);
    const int right = std::min(static_cast<int>(p.area.right()) + 2, width_);
    for (int y = p.area.top(); y < p.area.bottom(); ++y) {
      Span& row = rows_[static_cast<std::size_t>(y)];
      row = row.left < row.right ? Span{std::min(row.left, left), std::max(row.right, right)} : Span{left, right};
    }
  }
}

void FlatPainter::find_seams() {
  std::vector<const LongEdges*> edges;
  for (const Painted& p : painted_) edges.push_back(&p.edges);
  auto found = sharing_edges(edges);
  for (std::size_t i = 0; i < found.size(); ++i) {
    Painted& p = painted_[i];
    if (p.beside != found[i]) mark(p), p.beside = std::move(found[i]);
  }
}

// Finds an order from back to front; returns false if there is none that is right for each pixel.
bool FlatPainter::sort() {
  order_.clear();
  for (std::uint32_t i = 0; i < painted_.size(); ++i) {
    if (!painted_[i].good) return false;
    if (!painted_[i].parts.empty()) order_.push_back(i);
  }
  const auto slack = [&](std::uint32_t i) { return same_depth * std::abs(painted_[i].front); };
  std::stable_sort(order_.begin(), order_.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return painted_[a].front > painted_[b].front; });
  // Of those at one depth the later ones are in front.
  for (std::size_t first = 0; first < order_.size();) {
    std::size_t end = first + 1;
    while (end < order_.size() && painted_[order_[first]].front - painted_[order_[end]].front <= slack(order_[first]))
      ++end;
    const auto begin = order_.begin();
    std::sort(begin + static_cast<std::ptrdiff_t>(first), begin + static_cast<std::ptrdiff_t>(end));
    first = end;
  }
  std::size_t left = most_compared;
  for (std::size_t k = 0; k < order_.size(); ++k) {
    const Painted& one = painted_[order_[k]];
    for (std::size_t j = k; j-- > 0 && painted_[order_[j]].front < one.back - slack(order_[k]);) {
      for (const Paint& a : one.parts)
        for (const Paint& b : painted_[order_[j]].parts)
          if (left-- == 0 || boxes_meet(a.area, b.area)) return false;
    }
  }
  return true;
}

FlatPainter::Bytes FlatPainter::as_drawn(const Color& c) {
  return {byte_of(encoded_as_drawn(c.r)), byte_of(encoded_as_drawn(c.g)), byte_of(encoded_as_drawn(c.b)), 255};
}

template <bool light>
FlatPainter::Color FlatPainter::over(const Color& below, const Color& c, float opacity) {
  const float rest = 1 - opacity;
  Color sum{below.r * rest + c.r * opacity, below.g * rest + c.g * opacity, below.b * rest + c.b * opacity};
  if constexpr (light) sum.opacity = below.opacity * rest + opacity;
  return sum;
}

// Returns the colour of a gradient at a pixel, with its opacity.
FlatPainter::Color FlatPainter::graded_at(const Graded& g, std::size_t x, int y) {
  const double px = static_cast<double>(x) + 0.5, py = y + 0.5;
  const auto row = [&](std::size_t r) { return g.rows[r][0] * px + g.rows[r][1] * py + g.rows[r][2]; };
  const double by = 1 / row(2), u = by * row(0), v = by * row(1);
  const auto slope = [&](std::size_t r, double is, std::size_t k) { return by * (g.rows[r][k] - is * g.rows[2][k]); };
  const GradientLight l = g.colors.has_edges()
                              ? g.colors.around(u, v, slope(0, u, 0), slope(1, v, 0), slope(0, u, 1), slope(1, v, 1))
                              : g.colors.at(u, v);
  const double share = 1 / std::max(l.opacity, 1e-6);
  const auto shown = [&](double c) { return static_cast<float>(std::min(share * c, 1.0)); };
  return {shown(l.light.x), shown(l.light.y), shown(l.light.z), static_cast<float>(l.opacity)};
}

FlatPainter::Color FlatPainter::plus(const Color& sum, const Color& c, float opacity) {
  return {sum.r + c.r * opacity, sum.g + c.g * opacity, sum.b + c.b * opacity, sum.opacity + opacity};
}

// Adds a part's colours to a row: over what is there, or, if it is one of several parts, to their sum.
template <bool light, bool alone>
void FlatPainter::lay(const Paint& p, const RowCoverage& covered, int y, Color* row) {
  auto x = static_cast<std::size_t>(covered.first);
  const auto put = [](Color& to, const Color& c, float opacity) {
    to = alone ? over<light>(to, c, opacity) : plus(to, c, opacity);
  };
  if (!p.graded) {
    for (const float share : covered.of) put(row[x++], p.color, share * p.opacity);
    return;
  }
  const bool even = p.graded->even;
  const Color of_row = even ? graded_at(*p.graded, 0, y) : Color{0, 0, 0};
  for (const float share : covered.of) {
    if (share > 0) {
      const Color c = even ? of_row : graded_at(*p.graded, x, y);
      put(row[x], {c.r, c.g, c.b}, share * p.opacity * c.opacity);
    }
    ++x;
  }
}

template <bool light>
void FlatPainter::lay_beside(std::uint32_t number, const Painted& one, const RowCoverage& covered, int y, Color* row,
                             Seam* seams) {
  const Color& c = one.parts.front().color;
  auto x = static_cast<std::size_t>(covered.first);
  for (const float share : covered.of) {
    Seam& seam = seams[x];
    Color& to = row[x++];
    if (share <= 0 || share >= 1) {
      if (share >= 1) to = over<light>(to, c, 1);
      continue;
    }
    const bool meets = seam.row == y && to == seam.result &&
                       std::find(one.beside.begin(), one.beside.end(), seam.owner) != one.beside.end();
    if (!meets) seam.below = to, seam.sum = {0, 0, 0};
    // Those before keep what is left of the pixel.
    const float before = seam.sum.opacity, kept = before > 0 ? std::min(before, 1 - share) / before : 0;
    seam.sum = {kept * seam.sum.r, kept * seam.sum.g, kept * seam.sum.b, kept * before};
    seam.sum = plus(seam.sum, c, share);
    const float rest = 1 - seam.sum.opacity;
    to = {seam.below.r * rest + seam.sum.r, seam.below.g * rest + seam.sum.g, seam.below.b * rest + seam.sum.b};
    if constexpr (light) to.opacity = seam.below.opacity * rest + seam.sum.opacity;
    seam.row = y, seam.owner = number, seam.result = to;
  }
}

template <bool light, class Put>
void FlatPainter::paint(const std::vector<Span>& rows, const Put& put) const {
  const auto width = static_cast<std::size_t>(width_);
  struct Reader {
    const Paint* paint;
    CoverageRows rows;
  };
  std::vector<std::vector<Reader>> readers;  // of each object
  bool meeting = false;
  for (const std::uint32_t i : order_) {
    readers.emplace_back();
    meeting |= !painted_[i].beside.empty();
    for (const Paint& p : painted_[i].parts) readers.back().push_back({&p, CoverageRows(p.area)});
  }
  std::vector<float> sums(width + 2), room(width + 2);
  std::vector<Color> row(width);
  // The parts of an object meet at their borders: they are added, so that nothing behind them shows there.
  std::vector<Color> joint(width, Color{0, 0, 0});
  std::vector<Seam> seams(meeting ? width : 0);
  for (int y = 0; y < height_; ++y) {
    const Span& span = rows[static_cast<std::size_t>(y)];
    if (span.left >= span.right) continue;
    const Vec3 behind = behind_row(scenery_, (y + 0.5) / height_);
    Color empty{static_cast<float>(behind.x), static_cast<float>(behind.y), static_cast<float>(behind.z)};
    if (light && !scenery_.surroundings.clear) empty.opacity = 1;
    std::fill(row.begin(), row.end(), empty);
    for (std::size_t k = 0; k < readers.size(); ++k) {
      std::vector<Reader>& parts = readers[k];
      const Painted& one = painted_[order_[k]];
      std::size_t first = width, end = 0;
      for (Reader& r : parts) {
        const Paint& p = *r.paint;
        if (y < p.area.top() || y >= p.area.bottom()) continue;
        if (p.area.right() + 1 < static_cast<float>(span.left) || p.area.left() > static_cast<float>(span.right))
          continue;
        const RowCoverage covered = r.rows.next(y, sums, room);
        if (!one.beside.empty()) {
          lay_beside<light>(order_[k], one, covered, y, row.data(), seams.data());
          continue;
        }
        if (parts.size() == 1) {
          lay<light, true>(p, covered, y, row.data());
          continue;
        }
        lay<light, false>(p, covered, y, joint.data());
        first = std::min(first, static_cast<std::size_t>(covered.first));
        end = std::max(end, static_cast<std::size_t>(covered.first) + covered.of.size());
      }
      for (std::size_t x = first; x < end; ++x) {
        const Color sum = std::exchange(joint[x], Color{0, 0, 0});
        if (sum.opacity <= 0) continue;
        const float opacity = std::min(sum.opacity, 1.F), share = 1 / sum.opacity;
        row[x] = over<light>(row[x], {sum.r * share, sum.g * share, sum.b * share}, opacity);
      }
    }
    put(y, behind, empty, row);
  }
}

void FlatPainter::fill(LinearPicture& out) const {
  out.width = width_, out.height = height_;
  const auto width = static_cast<std::size_t>(width_), height = static_cast<std::size_t>(height_);
  out.rgba.resize(4 * width * height);
  const std::vector<Span> all(height, {0, width_});
  paint<true>(all, [&](int y, const Vec3&, const Color&, const std::vector<Color>& row) {
    float* to = out.rgba.data() + 4 * width * static_cast<std::size_t>(y);
    for (const Color& c : row)
      for (const float channel : {c.r, c.g, c.b, c.opacity}) *to++ = channel;
  });
}

void FlatPainter::fill(Picture& out) const {
  out.width = width_, out.height = height_;
  const auto width = static_cast<std::size_t>(width_);
  out.rgba.resize(4 * width * static_cast<std::size_t>(height_));
  paint<false>(rows_, [&](int y, const Vec3& behind, const Color& empty, const std::vector<Color>& row) {
    // The graphics interface clears with exact colours.
    const Bytes exact{byte_of(encoded(behind.x)), byte_of(encoded(behind.y)), byte_of(encoded(behind.z)), 255};
    const Bytes empty_bytes = scenery_.plain() ? exact : as_drawn(empty);
    const Span& span = rows_[static_cast<std::size_t>(y)];
    std::uint8_t* to =
        out.rgba.data() + 4 * (width * static_cast<std::size_t>(y) + static_cast<std::size_t>(span.left));
    // Most pixels are empty, or equal their neighbour.
    Color last = empty;
    Bytes bytes = empty_bytes;
    for (int x = span.left; x < span.right; ++x, to += 4) {
      const Color& c = row[static_cast<std::size_t>(x)];
      if (c != last) last = c, bytes = c == empty ? empty_bytes : as_drawn(c);
      std::memcpy(to, bytes.data(), 4);
    }
  });
}

}  // namespace betwixt
