// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "render/edges.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <optional>

#include "render/bloom.h"
#include "render/curves.h"
#include "render/encoding.h"

namespace betwixt {
namespace {

constexpr double reach = 1.5;  // how far from the middle samples count, pixels
// What a line may change at most: four samples are off by no more.
constexpr double most_change = 0.25;

constexpr float far_away = 9;  // pixels

// As in the shader that makes the marks (canvas.cpp).
float brightness(const PixelLight& c) { return 0.35F * c[0] + 0.5F * c[1] + 0.15F * c[2] + 0.25F * c[3]; }
float least_difference(float high) { return 0.03F * high + 0.002F; }
float bright_samples(int mark) {
  return static_cast<float>((mark & 1) + (mark >> 1 & 1) + (mark >> 2 & 1) + (mark >> 3 & 1));
}
bool is_mixed(int mark) { return mark > 0 && mark < EdgeSmoother::several; }

PixelLight mix_of(const PixelLight& a, const PixelLight& b, float share) {
  PixelLight c;
  for (std::size_t i = 0; i < c.size(); ++i) c[i] = a[i] + share * (b[i] - a[i]);
  return c;
}
float largest_difference(const PixelLight& a, const PixelLight& b) {
  float most = 0;
  for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, std::abs(a[i] - b[i]));
  return most;
}
// Returns 1 up to `full`, 0 from `none` on.
float trust(float x, float full, float none) { return std::clamp((none - x) / (none - full), 0.0F, 1.0F); }

// The share of a pixel that is further than `away` from its middle in a direction.
double share_beyond(double x, double y, double away) {
  const double most = std::max(std::abs(x), std::abs(y)), least = std::min(std::abs(x), std::abs(y));
  const double corner = 0.5 * (most + least), side = 0.5 * (most - least), d = std::abs(away);
  double rest = 0;
  if (d <= side)
    rest = 0.5 - d / most;
  else if (d < corner)
    rest = (corner - d) * (corner - d) / (2 * most * least);
  return away > 0 ? rest : 1 - rest;
}

// The pixels of both kinds of pictures, as light.
class BytePixels {
 public:
  explicit BytePixels(Picture& p) : width(p.width), height(p.height), rgba_(p.rgba) {
    for (std::size_t i = 0; i < 256; ++i)
      light_of_[i] = static_cast<float>(light_of_signal(static_cast<double>(i) / 255));
  }
  int mark(std::size_t i) const { return rgba_[4 * i + 3]; }
  PixelLight light(std::size_t i) const {
    return {light_of_[rgba_[4 * i]], light_of_[rgba_[4 * i + 1]], light_of_[rgba_[4 * i + 2]], 0};
  }
  void set(std::size_t i, const PixelLight& c) {
    for (std::size_t k = 0; k < 3; ++k)
      rgba_[4 * i + k] = static_cast<std::uint8_t>(255 * encoded_as_drawn(c[k]) + 0.5F);
  }
  // Writes 1 where a row has marks, otherwise 0.
  void find_marks(std::size_t y, std::uint8_t* out) const {
    const std::uint8_t* const row = &rgba_[4 * y * static_cast<std::size_t>(width)];
    for (std::size_t x = 0; x < static_cast<std::size_t>(width); ++x) out[x] = pixel_at(row + 4 * x) > 0xffffff ? 1 : 0;
  }
  void take_marks_away() {
    for (std::size_t i = 0; i < rgba_.size(); i += 4) {
      const std::uint32_t opaque = pixel_at(&rgba_[i]) | 0xff000000U;
      std::memcpy(&rgba_[i], &opaque, 4);
    }
  }

  const int width, height;

 private:
  // Whole pixels are faster than bytes; the opacity is on top.
  static std::uint32_t pixel_at(const std::uint8_t* bytes) {
    std::uint32_t pixel = 0;
    std::memcpy(&pixel, bytes, 4);
    return pixel;
  }
  std::vector<std::uint8_t>& rgba_;
  std::array<float, 256> light_of_;
};

// Pictures of light have half floats, so that those that store them have the very same light.
float as_half(float x) {
  constexpr float normal = 6.103515625e-5F, step = 5.9604644775390625e-8F;  // the least normal one, and what is below
  if (x < normal) return step * static_cast<float>(static_cast<int>(x / step + 0.5F));
  std::uint32_t bits = 0;
  std::memcpy(&bits, &x, 4);
  bits = (bits + 0xfff + (bits >> 13 & 1)) & ~0x1fffU;
  std::memcpy(&x, &bits, 4);
  return x;
}

class FloatPixels {
 public:
  explicit FloatPixels(LinearPicture& p) : width(p.width), height(p.height), rgba_(p.rgba) {}
  int mark(std::size_t i) const {
    int m = 0;
    for (std::size_t k = 0; k < 4; ++k) m |= rgba_[4 * i + k] < 0 ? 1 << k : 0;
    return m;
  }
  PixelLight light(std::size_t i) const {
    PixelLight c;
    for (std::size_t k = 0; k < 4; ++k) c[k] = std::abs(rgba_[4 * i + k]);
    return c;
  }
  void set(std::size_t i, const PixelLight& c) {
    for (std::size_t k = 0; k < 3; ++k) rgba_[4 * i + k] = as_half(c[k]);
    rgba_[4 * i + 3] = as_half(std::min(c[3], 1.0F));
  }
  void find_marks(std::size_t y, std::uint8_t* out) const {
    const float* const row = &rgba_[4 * y * static_cast<std::size_t>(width)];
    for (std::size_t x = 0; x < static_cast<std::size_t>(width); ++x) {
      const float* const c = row + 4 * x;
      out[x] = std::min(std::min(c[0], c[1]), std::min(c[2], c[3])) < 0 ? 1 : 0;
    }
  }
  void take_marks_away() {
    for (float& x : rgba_)
      if (x < 0) x = x < -1e-6F ? -x : 0;
  }

  const int width, height;

 private:
  std::vector<float>& rgba_;
};

// A pixel and those around it, row by row.
struct NinePixels {
  std::array<int, 9> marks{};
  std::array<PixelLight, 9> lights{};
};
// Returns what there is around a pixel, if it is one line, perhaps.
template <class Pixels>
std::optional<NinePixels> around_edge(const Pixels& p, int x, int y) {
  NinePixels all;
  std::array<std::size_t, 9> at{};
  int mixed = 0;
  for (std::size_t j = 0; j < 9; ++j) {
    const int column = std::clamp(x + static_cast<int>(j % 3) - 1, 0, p.width - 1);
    const int row = std::clamp(y + static_cast<int>(j / 3) - 1, 0, p.height - 1);
    at[j] = static_cast<std::size_t>(row) * static_cast<std::size_t>(p.width) + static_cast<std::size_t>(column);
    all.marks[j] = p.mark(at[j]);
    if (all.marks[j] >= EdgeSmoother::several) return std::nullopt;
    mixed += is_mixed(all.marks[j]) ? 1 : 0;
  }
  if (mixed < 2) return std::nullopt;  // the edge of a pattern, or a point
  for (std::size_t j = 0; j < 9; ++j) all.lights[j] = p.light(at[j]);
  return all;
}

// The colours on both sides of an edge.
struct EdgeSides {
  PixelLight dark, bright;
  float sure = 1;  // 0 to 1
};

class MeanLight {
 public:
  void add(const PixelLight& c) {
    for (std::size_t i = 0; i < c.size(); ++i) sum_[i] += c[i];
    ++count_;
  }
  bool empty() const { return count_ == 0; }
  PixelLight mean() const {
    const float part = 1 / static_cast<float>(count_);
    return {part * sum_[0], part * sum_[1], part * sum_[2], part * sum_[3]};
  }

 private:
  PixelLight sum_{};
  int count_ = 0;
};

// Returns the other side of the edge through a pixel, of which this share has the one side's colour.
PixelLight other_side(const PixelLight& mixed, const PixelLight& one, float share) {
  PixelLight c = mix_of(one, mixed, 1 / (1 - share));
  for (float& x : c) x = std::max(x, 0.0F);
  return c;
}

std::optional<EdgeSides> edge_sides(const NinePixels& a) {
  // Pixels through which no edge goes have the colour of one side. Those with an edge part them.
  MeanLight mixed, dark, bright;
  float share = 0;
  for (std::size_t j = 0; j < 9; ++j)
    if (is_mixed(a.marks[j])) mixed.add(a.lights[j]), share += 0.25F * bright_samples(a.marks[j]);
  const bool own = is_mixed(a.marks[4]);
  const PixelLight middle = own ? a.lights[4] : mixed.mean();
  for (std::size_t j = 0; j < 9; ++j)
    if (a.marks[j] == 0) (brightness(a.lights[j]) > brightness(middle) ? bright : dark).add(a.lights[j]);
  if (dark.empty() && bright.empty()) return std::nullopt;
  if (own) {
    share = 0.25F * bright_samples(a.marks[4]);
  } else {
    int count = 0;
    for (const int m : a.marks) count += is_mixed(m) ? 1 : 0;
    share /= static_cast<float>(count);
  }
  EdgeSides s;
  s.dark = dark.empty() ? other_side(middle, bright.mean(), share) : dark.mean();
  s.bright = bright.empty() ? other_side(middle, dark.mean(), 1 - share) : bright.mean();
  const float low = brightness(s.dark), high = brightness(s.bright),
              least = least_difference(high - 0.25F * s.bright[3]);
  const float range = largest_difference(s.dark, s.bright);
  if (!(high - low > least) || !(range < 1e6F)) return std::nullopt;
  // A third colour is of another edge.
  float apart = own ? largest_difference(a.lights[4], mix_of(s.dark, s.bright, share)) : 0;
  for (std::size_t j = 0; j < 9; ++j)
    if (a.marks[j] == 0)
      apart =
          std::max(apart, std::min(largest_difference(a.lights[j], s.dark), largest_difference(a.lights[j], s.bright)));
  s.sure = trust(least, 0.5F * (high - low), high - low) * trust(apart / range, 0.25F, 0.45F);
  return s;
}

}  // namespace

EdgeSmoother::EdgeSmoother(const std::vector<float>& places) {
  std::array<std::array<double, 2>, samples> at{};
  for (std::size_t i = 0; i < samples; ++i)
    for (std::size_t c = 0; c < 2; ++c) {
      const std::size_t pixel = i / 4, number = c == 0 ? pixel % 3 : pixel / 3;
      at[i][c] = static_cast<double>(number) - 1 + static_cast<double>(places[2 * (i % 4) + c]);
    }
  for (std::size_t i = 0; i < samples; ++i) {
    const double weight = std::max(1 - (at[i][0] * at[i][0] + at[i][1] * at[i][1]) / (reach * reach), 0.0);
    for (std::size_t mark = 0; mark < 16; ++mark) {
      const bool bright = (mark >> i % 4 & 1) != 0;
      for (std::size_t c = 0; c < 2; ++c) toward_[i / 4][mark][c] += (bright ? weight : -weight) * at[i][c];
      if_bright_[i / 4][mark][i % 4] = bright && weight > 0 ? 0 : far_away;
      if_dark_[i / 4][mark][i % 4] = !bright && weight > 0 ? 0 : -far_away;
    }
  }
  // Once around a square, anticlockwise from (1 -1).
  for (std::size_t k = 0; k < directions; ++k) {
    const double s = static_cast<double>(k % 32) / 16 - 1;
    constexpr std::array<std::array<double, 4>, 4> sides{{{1, 0, 0, 1}, {0, -1, 1, 0}, {-1, 0, 0, -1}, {0, 1, -1, 0}}};
    const auto& [x, sx, y, sy] = sides[k / 32];
    Direction& d = directions_[k];
    const double length = std::sqrt(1 + s * s);
    d.x = (x + sx * s) / length, d.y = (y + sy * s) / length;
    for (std::size_t i = 0; i < samples; ++i)
      d.along[i / 4][i % 4] = static_cast<float>(d.x * at[i][0] + d.y * at[i][1]);
  }
}

double EdgeSmoother::bright_share(const std::array<int, 9>& marks) const {
  const double plain = 0.25 * static_cast<double>(bright_samples(marks[4]));
  double x = 0, y = 0;
  for (std::size_t j = 0; j < 9; ++j) {
    const auto& [dx, dy] = toward_[j][static_cast<std::size_t>(marks[j])];
    x += dx, y += dy;
  }
  const double most = std::max(std::abs(x), std::abs(y));
  if (!(most > 1e-3)) return plain;
  // Where on the square of directions it is.
  const int side = x >= std::abs(y) ? 0 : y >= std::abs(x) ? 1 : -x >= std::abs(y) ? 2 : 3;
  const double s = (side == 0 ? y : side == 1 ? -x : side == 2 ? -y : x) / most;
  const int first = 32 * side + static_cast<int>(16 * (s + 1) + 0.5);
  // The line with the widest gap between both sides is the best.
  float gap = -far_away, middle = 0;
  const Direction* best = nullptr;
  for (const int turn : {0, -3, 3, -6, 6}) {
    const Direction& d = directions_[static_cast<std::size_t>((first + turn + directions) % directions)];
    Four low{-far_away, -far_away, -far_away, -far_away}, high = -low;
    for (std::size_t j = 0; j < 9; ++j) {
      const auto mark = static_cast<std::size_t>(marks[j]);
      const Four bright = d.along[j] + if_bright_[j][mark], dark = d.along[j] + if_dark_[j][mark];
      high = bright < high ? bright : high, low = dark > low ? dark : low;
    }
    const float least = std::min({high[0], high[1], high[2], high[3]}),
                most_low = std::max({low[0], low[1], low[2], low[3]});
    if (least - most_low > gap) gap = least - most_low, middle = 0.5F * (most_low + least), best = &d;
  }
  if (best == nullptr) return plain;
  const double share = share_beyond(best->x, best->y, static_cast<double>(middle));
  // Less, the more samples are on the wrong side.
  const auto sure = static_cast<double>(trust(-gap, 0.2F, 0.5F));
  return plain + sure * std::clamp(share - plain, -most_change, most_change);
}

// Returns the light of the middle pixel with a smooth edge, if there is one.
template <class Pixels>
std::optional<PixelLight> EdgeSmoother::smoothed(const Pixels& p, int x, int y) const {
  std::optional<NinePixels> found = around_edge(p, x, y);
  if (!found) return std::nullopt;
  NinePixels& a = *found;
  const std::optional<EdgeSides> sides = edge_sides(a);
  if (!sides) return std::nullopt;
  const float middle = 0.5F * (brightness(sides->dark) + brightness(sides->bright));
  for (std::size_t j = 0; j < 9; ++j)
    if (a.marks[j] == 0 && brightness(a.lights[j]) > middle) a.marks[j] = several;
  const float plain = 0.25F * bright_samples(a.marks[4]);
  const float change = sides->sure * (static_cast<float>(bright_share(a.marks)) - plain);
  if (change == 0) return std::nullopt;
  PixelLight c = a.lights[4];
  for (std::size_t i = 0; i < c.size(); ++i) c[i] = std::max(c[i] + change * (sides->bright[i] - sides->dark[i]), 0.0F);
  return c;
}

template <class Pixels>
void EdgeSmoother::finish(Pixels& p) const {
  struct Change {
    std::size_t at;
    PixelLight light;
  };
  const auto width = static_cast<std::size_t>(p.width), height = static_cast<std::size_t>(p.height);
  std::vector<Change> changes;
  // Whether pixels of a row have marks, with one more at both ends; and whether those of three rows have.
  constexpr std::size_t at_once = 8;
  const std::vector<std::uint8_t> none(width + 2 * at_once);
  std::array<std::vector<std::uint8_t>, 3> rows{none, none, none};
  std::vector<std::uint8_t> near = none;
  const auto take = [&](std::size_t y) {
    if (y < height)
      p.find_marks(y, rows[y % 3].data() + 1);
    else
      rows[y % 3] = none;
  };
  if (height > 0) take(0);
  for (std::size_t y = 0; y < height; ++y) {
    take(y + 1);
    for (std::size_t x = 0; x < near.size(); ++x) near[x] = rows[0][x] | rows[1][x] | rows[2][x];
    for (std::size_t first = 0; first < width; first += at_once) {
      std::uint64_t some = 0, beyond = 0;  // most pixels are far from edges
      std::memcpy(&some, &near[first], at_once), std::memcpy(&beyond, &near[first + 2], at_once);
      if ((some | beyond) == 0) continue;
      for (std::size_t x = first; x < std::min(first + at_once, width); ++x)
        if (near[x] | near[x + 1] | near[x + 2])
          if (const auto light = smoothed(p, static_cast<int>(x), static_cast<int>(y)))
            changes.push_back({y * width + x, *light});
    }
  }
  for (const Change& c : changes) p.set(c.at, c.light);
  p.take_marks_away();
}

void EdgeSmoother::finish(Picture& p) const {
  BytePixels pixels(p);
  finish(pixels);
}
void EdgeSmoother::finish(LinearPicture& p) const {
  FloatPixels pixels(p);
  finish(pixels);
}

}  // namespace betwixt
