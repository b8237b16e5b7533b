// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Pyramids of pictures, each half as large as the one before. A picture grows by linear interpolation, K: its rows sum
// to 1, so what is even stays even. It shrinks by the transpose of K with the areas of the pixels as weights, so the
// sum of the light stays. Repeated, both give smooth splines.
#include "render/bloom.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <thread>
#include <vector>

#include "base/in_parallel.h"
#include "render/curves.h"

namespace betwixt {
namespace {

struct Axis {
  int count = 0;
  std::vector<float> area;  // of each pixel along the axis, in pixels of the picture
};

struct PyramidLevel {
  Axis x, y;
  std::vector<float> rgba;
  float* at(int i, int j) {
    return &rgba[4 * (static_cast<std::size_t>(j) * static_cast<std::size_t>(x.count) + static_cast<std::size_t>(i))];
  }
  const float* at(int i, int j) const { return const_cast<PyramidLevel*>(this)->at(i, j); }
};

// The two pixels of a smaller picture between which a pixel is, and its share of the first.
struct Pair {
  int first = 0, second = 0;
  float share = 1;
};
Pair pair_of(int fine, int coarse_count) {
  const int half = fine / 2, before = fine % 2 == 0 ? half - 1 : half;
  return {std::clamp(before, 0, coarse_count - 1), std::min(before + 1, coarse_count - 1),
          fine % 2 == 0 ? 0.25F : 0.75F};
}

// What a pixel of a smaller picture takes of four pixels in a row; those outside the picture have a share of 0.
struct Taps {
  std::array<int, 4> at{};
  std::array<float, 4> share{};
};
struct HalvedAxis {
  Axis axis;
  std::vector<Taps> taps;
};
HalvedAxis halved_axis(const Axis& fine) {
  HalvedAxis h;
  h.axis.count = (fine.count + 1) / 2;
  h.axis.area.assign(static_cast<std::size_t>(h.axis.count), 0);
  h.taps.resize(static_cast<std::size_t>(h.axis.count));
  const auto give = [&](int to, int from, float share) {
    const float area = share * fine.area[static_cast<std::size_t>(from)];
    Taps& t = h.taps[static_cast<std::size_t>(to)];
    const auto place = static_cast<std::size_t>(from - (2 * to - 1));
    t.at[place] = from, t.share[place] += area, h.axis.area[static_cast<std::size_t>(to)] += area;
  };
  for (int i = 0; i < fine.count; ++i) {
    const Pair p = pair_of(i, h.axis.count);
    give(p.first, i, p.share), give(p.second, i, 1 - p.share);
  }
  for (std::size_t i = 0; i < h.taps.size(); ++i)
    for (float& s : h.taps[i].share) s /= h.axis.area[i];
  return h;
}

PyramidLevel half_size(const PyramidLevel& fine) {
  HalvedAxis x = halved_axis(fine.x), y = halved_axis(fine.y);
  PyramidLevel made{std::move(x.axis), std::move(y.axis), {}};
  made.rgba.resize(4 * static_cast<std::size_t>(made.x.count) * static_cast<std::size_t>(made.y.count));
  for_rows(made.x.count, made.y.count, [&](int first, int end) {
    for (int j = first; j < end; ++j) {
      const Taps& down = y.taps[static_cast<std::size_t>(j)];
      for (int i = 0; i < made.x.count; ++i) {
        const Taps& across = x.taps[static_cast<std::size_t>(i)];
        std::array<float, 4> sum{};
        for (std::size_t a = 0; a < 4; ++a)
          for (std::size_t b = 0; b < 4; ++b) {
            const float share = down.share[a] * across.share[b];
            const float* const from = fine.at(across.at[b], down.at[a]);
            for (std::size_t c = 0; c < 4; ++c) sum[c] += share * from[c];
          }
        std::copy(sum.begin(), sum.end(), made.at(i, j));
      }
    }
  });
  return made;
}

// fine = kept · fine + grown · (coarse, enlarged)
void add_larger(PyramidLevel& fine, const PyramidLevel& coarse, float kept, float grown) {
  for_rows(fine.x.count, fine.y.count, [&](int first, int end) {
    for (int j = first; j < end; ++j) {
      const Pair down = pair_of(j, coarse.y.count);
      for (int i = 0; i < fine.x.count; ++i) {
        const Pair across = pair_of(i, coarse.x.count);
        const float *const p = coarse.at(across.first, down.first), *const q = coarse.at(across.second, down.first),
                           *const r = coarse.at(across.first, down.second),
                           *const s = coarse.at(across.second, down.second);
        float* const to = fine.at(i, j);
        for (std::size_t c = 0; c < 4; ++c) {
          const float above = across.share * p[c] + (1 - across.share) * q[c];
          const float below = across.share * r[c] + (1 - across.share) * s[c];
          to[c] = kept * to[c] + grown * (down.share * above + (1 - down.share) * below);
        }
      }
    }
  });
}

PyramidLevel as_level(LinearPicture& p) {
  const auto axis = [](int count) { return Axis{count, std::vector<float>(static_cast<std::size_t>(count), 1.0F)}; };
  return {axis(p.width), axis(p.height), std::move(p.rgba)};
}

bool is_picture(const LinearPicture& p) {
  return p.width > 0 && p.height > 0 &&
         p.rgba.size() == 4 * static_cast<std::size_t>(p.width) * static_cast<std::size_t>(p.height);
}

// How much of the spread light is blurred to a width, given as the logarithm of its share of the picture's height: as
// much to each doubling of the width, a little less to the wide ones, and the ends are soft, so that pictures of all
// sizes look alike.
double share_of_width(double log_width) {
  const double inner = std::clamp(log_width + 9.5, 0.0, 1.0), outer = std::clamp(-1.5 - log_width, 0.0, 1.0);
  return std::min(inner, outer) * own_exp2(-0.25 * (log_width + 9.5));
}

// One pass of a Gaussian along x or y; what is outside mirrors the inside.
void blur_along(PyramidLevel& l, double variance, bool across) {
  if (!(variance > 1e-4)) return;
  const int reach = std::max(1, static_cast<int>(std::ceil(3.2 * std::sqrt(variance))));
  std::vector<float> weights(static_cast<std::size_t>(2 * reach + 1));
  double sum = 0;
  const auto bell = [&](int k) { return own_exp2(-0.5 * k * k / variance * std::numbers::log2e); };
  for (int k = -reach; k <= reach; ++k) sum += bell(k);
  for (int k = -reach; k <= reach; ++k)
    weights[static_cast<std::size_t>(k + reach)] = static_cast<float>(bell(k) / sum);
  const int count = across ? l.x.count : l.y.count;
  const auto mirrored = [count](int i) {
    const int turn = ((i % (2 * count)) + 2 * count) % (2 * count);
    return turn < count ? turn : 2 * count - 1 - turn;
  };
  PyramidLevel from = l;
  for_rows(l.x.count, l.y.count, [&](int first, int end) {
    for (int j = first; j < end; ++j)
      for (int i = 0; i < l.x.count; ++i) {
        std::array<float, 4> total{};
        for (int k = -reach; k <= reach; ++k) {
          const float* const p = across ? from.at(mirrored(i + k), j) : from.at(i, mirrored(j + k));
          for (std::size_t c = 0; c < 4; ++c) total[c] += weights[static_cast<std::size_t>(k + reach)] * p[c];
        }
        std::copy(total.begin(), total.end(), l.at(i, j));
      }
  });
}

}  // namespace

void for_rows(int width, int height, const std::function<void(int first, int end)>& work) {
  constexpr int pixels_of_a_thread = 1 << 15;
  const auto worth = static_cast<std::size_t>(
      std::max(static_cast<std::int64_t>(width) * height / pixels_of_a_thread, std::int64_t{1}));
  const std::size_t parts = std::min<std::size_t>(
      {worth, std::max(std::thread::hardware_concurrency(), 1U), static_cast<std::size_t>(std::max(height, 1))});
  in_parallel(parts, [&](std::size_t part) {
    const auto bound = [&](std::size_t k) { return static_cast<int>(static_cast<std::size_t>(height) * k / parts); };
    work(bound(part), bound(part + 1));
  });
}

void spread_light(LinearPicture& picture, double share) {
  if (!is_picture(picture) || !(share > 0)) return;
  std::vector<PyramidLevel> levels;
  levels.push_back(as_level(picture));
  // The levels' shares of the light; what would be spread over less than a pixel stays where it is.
  const double height = own_log2(picture.height);
  std::vector<double> shares{0};
  for (int k = -20; k < 0; ++k) shares[0] += share_of_width(k + 1 - height);
  for (int k = 1; share_of_width(k - height) > 0 || k < height - 5; ++k) {
    shares.push_back(share_of_width(k - height));
    levels.push_back(half_size(levels.back()));
  }
  double sum = 0;
  for (const double s : shares) sum += s;
  if (levels.size() > 1 && sum > 0) {
    for (double& s : shares) s *= share / sum;
    const std::vector<float> before = levels[0].rgba;
    for (std::size_t k = levels.size() - 1; k > 0; --k) {
      const double kept = k == 1 ? 1 - share + shares[0] : shares[k - 1];
      const double grown = k == levels.size() - 1 ? shares[k] : 1;
      add_larger(levels[k - 1], levels[k], static_cast<float>(kept), static_cast<float>(grown));
    }
    for (std::size_t i = 3; i < before.size(); i += 4) levels[0].rgba[i] = before[i];
  }
  picture.rgba = std::move(levels[0].rgba);
}

void blur_light(LinearPicture& picture, double deviation) {
  if (!is_picture(picture) || !(deviation > 0.01)) return;
  const double variance = std::min(deviation, 4096.0) * std::min(deviation, 4096.0);
  std::vector<PyramidLevel> levels;
  levels.push_back(as_level(picture));
  // To halve a picture and to enlarge it again adds 1.5 pixels of it to the variance.
  double area = 1, added = 0;
  while (variance - (added + 1.5 * area) >= 3 * 4 * area && levels.back().x.count + levels.back().y.count > 16) {
    added += 1.5 * area, area *= 4;
    levels.push_back(half_size(levels.back()));
  }
  const double left = std::max(variance - added, 0.0) / area;
  blur_along(levels.back(), left, true), blur_along(levels.back(), left, false);
  for (std::size_t k = levels.size() - 1; k > 0; --k) add_larger(levels[k - 1], levels[k], 0, 1);
  picture.rgba = std::move(levels[0].rgba);
}

}  // namespace betwixt
