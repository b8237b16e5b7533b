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

struct Point {
  double x, y, depth;
};

// Moves points of a mesh to the picture: x and y in pixels.
class Projection {
 public:
  Projection(const View& v, const Instance& instance) : width_(v.width), height_(v.height) {
    Mat4 m;
    for (int i = 0; i < 3; ++i)
      for (int k = 0; k < 4; ++k) m(i, k) = static_cast<double>(instance.rows[static_cast<std::size_t>(4 * i + k)]);
    all_ = v.clip() * m;
    for (int k = 0; k < 4; ++k) depth_[static_cast<std::size_t>(k)] = -dot(v.backward, {m(0, k), m(1, k), m(2, k)});
  }
  const Mat4& to_clip() const { return all_; }
  Point operator()(const std::array<float, 3>& p) const {
    const double x = static_cast<double>(p[0]), y = static_cast<double>(p[1]), z = static_cast<double>(p[2]);
    const auto row = [&](int i) { return all_(i, 0) * x + all_(i, 1) * y + all_(i, 2) * z + all_(i, 3); };
    const double w = row(3);
    return {0.5 * width_ * (row(0) / w + 1), 0.5 * height_ * (row(1) / w + 1),
            depth_[0] * x + depth_[1] * y + depth_[2] * z + depth_[3]};
  }

 private:
  double width_, height_;
  Mat4 all_;
  std::array<double, 4> depth_;
};

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

void FlatPainter::outline(Painted& to, const Thing& t) const {
  to.parts.clear();
  to.good = true;
  if (!t.visible) return;
  to.good = t.surface && !t.ball && t.texture == nullptr && t.mesh != nullptr && !t.mesh->see_through;
  if (!to.good) return;
  const Projection project(things_.view(), t.instance);
  const Mesh& mesh = *t.mesh->mesh;
  std::vector<Point> points;
  points.reserve(mesh.positions.size());
  for (const auto& p : mesh.positions) points.push_back(project(p));
  to.front = to.back = points.empty() ? 0 : points.front().depth;
  for (const Point& p : points) {
    to.front = std::min(to.front, p.depth), to.back = std::max(to.back, p.depth);
    to.good = to.good && p.depth > 1e-9 && std::abs(p.x) < 1e7 && std::abs(p.y) < 1e7;
  }
  if (!to.good) return;
  Store::need_twins(*t.mesh);
  const std::vector<std::uint32_t>& corners = mesh.triangles;
  const Vec3 half = t.mesh->box.half();
  const bool thick = !t.pressed && half.z > 1e-6 * std::max(half.x, half.y);
  const double outside = t.mirrored ? 1 : -1;  // the sign of a triangle that is seen from outside: y goes down
  // The sign of the area of each triangle as seen; 0 if it is not drawn.
  std::vector<signed char> seen(corners.size() / 3);
  std::vector<std::uint32_t> part_of(seen.size());
  for (std::size_t p = 0; p < t.mesh->parts.size(); ++p) {
    const StoredPart& part = t.mesh->parts[p];
    to.good = to.good && part.texture == nullptr;
    for (std::size_t k = part.first; k + 2 < part.first + part.count; k += 3) {
      const Point &a = points[corners[k]], &b = points[corners[k + 1]], &c = points[corners[k + 2]];
      const double area = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
      if (area != 0 && !(t.closed && area * outside < 0)) seen[k / 3] = area < 0 ? -1 : 1;
      part_of[k / 3] = static_cast<std::uint32_t>(p);
    }
  }
  for (std::size_t p = 0; p < t.mesh->parts.size(); ++p) {
    const StoredPart& part = t.mesh->parts[p];
    Paint paint;
    paint.area = Area(width_, height_);
    for (std::size_t k = part.first; k < part.first + part.count / 3 * 3; ++k) {
      const std::size_t triangle = k / 3, other = t.mesh->twins[k] / 3;
      // Edges within an area have an opposite one beside: the two would cancel.
      if (seen[triangle] == 0 || (other != triangle && seen[other] == seen[triangle] && part_of[other] == p)) continue;
      const Point &a = points[corners[k]], &b = points[corners[k % 3 == 2 ? k - 2 : k + 1]];
      const Point &start = seen[triangle] < 0 ? b : a, &end = seen[triangle] < 0 ? a : b;
      paint.area.add(static_cast<float>(start.x), static_cast<float>(start.y), static_cast<float>(end.x),
                     static_cast<float>(end.y));
    }
    if (paint.area.empty()) continue;
    paint.area.finish();
    const auto channel = [&](std::size_t i) {
      return std::min((part.tinted ? t.instance.color[i] : 1.F) * part.color[i], 1.F);
    };
    paint.color = {channel(0), channel(1), channel(2)};
    paint.opacity = t.instance.color[3];
    if (const Gradient* const gradient = gradient_of(t.gradients.get(), part.tinted, part.stroke)) {
      const auto rows = rows_from_pixels(placed_gradient(*gradient, t.gradient_box, t.to_object), project.to_clip(),
                                         width_, height_, t.mesh->box.middle().z);
      if (rows)
        paint.graded =
            std::make_shared<const Graded>(Graded{GradientColors(*gradient), *rows, is_even(*gradient, *rows, width_)});
      to.good = to.good && rows && !thick;
    }
    to.parts.push_back(std::move(paint));
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

template <bool light, class Put>
void FlatPainter::paint(const std::vector<Span>& rows, const Put& put) const {
  const auto width = static_cast<std::size_t>(width_);
  struct Reader {
    const Paint* paint;
    CoverageRows rows;
  };
  std::vector<std::vector<Reader>> readers;  // of each object
  for (const std::uint32_t i : order_) {
    readers.emplace_back();
    for (const Paint& p : painted_[i].parts) readers.back().push_back({&p, CoverageRows(p.area)});
  }
  std::vector<float> sums(width + 2), room(width + 2);
  std::vector<Color> row(width);
  // The parts of an object meet at their borders: they are added, so that nothing behind them shows there.
  std::vector<Color> joint(width, Color{0, 0, 0});
  for (int y = 0; y < height_; ++y) {
    const Span& span = rows[static_cast<std::size_t>(y)];
    if (span.left >= span.right) continue;
    const Vec3 behind = behind_row(scenery_, (y + 0.5) / height_);
    Color empty{static_cast<float>(behind.x), static_cast<float>(behind.y), static_cast<float>(behind.z)};
    if (light && !scenery_.surroundings.clear) empty.opacity = 1;
    std::fill(row.begin(), row.end(), empty);
    for (std::vector<Reader>& parts : readers) {
      std::size_t first = width, end = 0;
      for (Reader& r : parts) {
        const Paint& p = *r.paint;
        if (y < p.area.top() || y >= p.area.bottom()) continue;
        if (p.area.right() + 1 < static_cast<float>(span.left) || p.area.left() > static_cast<float>(span.right))
          continue;
        const RowCoverage covered = r.rows.next(y, sums, room);
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
