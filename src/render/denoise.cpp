// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "render/denoise.h"

#include <algorithm>
#include <cmath>

#include "render/shared_work.h"

namespace betwixt::traced {
namespace {

constexpr int tile = Plane::tile;
constexpr int radius = 7;                          // of the neighbourhood that is averaged
constexpr int widest_patch = 3;                    // the largest radius of the surroundings that are compared
constexpr int bordered = tile + 2 * widest_patch;  // of a tile's differences
static_assert(radius + widest_patch <= Plane::margin);

// The numbers of a tile, and of a border around it.
using Cells = std::array<std::array<float, bordered>, bordered>;
using TileCells = std::array<std::array<float, tile>, tile>;

struct Pass {
  const Planes* guide;     // compared
  const Planes* variance;  // of the guide
  int patch;               // the radius of the surroundings
  float ease;              // how many variances of difference halve the weight, about
  const Planes* light;     // averaged
  Planes* out;
};

// Near exp(-x), and 0 from 16. Only products, which are the same on every processor.
float falloff(float x) {
  float e = std::max(1 - x * 0.0625F, 0.0F);
  e *= e, e *= e, e *= e;
  return e * e;
}

// One tile of a pass. Functions are called for one neighbour (dx, dy) of all pixels at once.
class Tile {
 public:
  Tile(const NoisyPicture& p, const Pass& pass, int left, int top) : p_(p), pass_(pass), left_(left), top_(top) {}

  void filter() {
    for (auto* cells : {&sum_[0], &sum_[1], &sum_[2], &weights_})
      for (auto& row : *cells) row.fill(0);
    for (int dy = -radius; dy <= radius; ++dy)
      for (int dx = -radius; dx <= radius; ++dx) {
        compare(dx, dy);
        smooth(differences_), smooth(both_);
        add(dx, dy);
      }
    write();
  }

 private:
  // How much the pixels differ, in units of what noise explains, at each place where both have light.
  void compare(int dx, int dy) {
    const int border = pass_.patch;
    for (int y = -border; y < tile + border; ++y) {
      float* const difference = differences_[static_cast<std::size_t>(y + border)].data();
      float* const both = both_[static_cast<std::size_t>(y + border)].data();
      const float* const a = p_.seen.row(top_ + y) + left_ - border;
      const float* const b = p_.seen.row(top_ + y + dy) + left_ - border + dx;
      for (int x = 0; x < tile + 2 * border; ++x) both[x] = a[x] > 0 && b[x] > 0 ? 1.0F : 0.0F, difference[x] = 0;
      for (std::size_t c = 0; c < 3; ++c) add_difference(c, y, dx, dy, difference);
      for (int x = 0; x < tile + 2 * border; ++x) difference[x] *= both[x];
    }
  }
  void add_difference(std::size_t c, int y, int dx, int dy, float* difference) const {
    const int from = left_ - pass_.patch;
    const float* const a = (*pass_.guide)[c].row(top_ + y) + from;
    const float* const b = (*pass_.guide)[c].row(top_ + y + dy) + from + dx;
    const float* const va = (*pass_.variance)[c].row(top_ + y) + from;
    const float* const vb = (*pass_.variance)[c].row(top_ + y + dy) + from + dx;
    const float ease = pass_.ease;
    for (int x = 0; x < tile + 2 * pass_.patch; ++x) {
      const float off = a[x] - b[x], noise = va[x] + vb[x], least = 1e-6F + 1e-5F * (a[x] * a[x] + b[x] * b[x]);
      difference[x] += (off * off - va[x] - std::min(va[x], vb[x])) / (least + ease * noise);
    }
  }
  // Adds up the surroundings of each pixel, always in the same order.
  void smooth(Cells& cells) {
    const auto side = static_cast<std::size_t>(2 * pass_.patch);
    for (std::size_t y = 0; y < tile + side; ++y) {
      auto& row = cells[y];
      std::array<float, tile> sums{};
      for (std::size_t k = 0; k <= side; ++k)
        for (std::size_t x = 0; x < tile; ++x) sums[x] += row[x + k];
      std::copy(sums.begin(), sums.end(), row.begin());
    }
    for (std::size_t y = 0; y < tile; ++y)
      for (std::size_t k = 1; k <= side; ++k)
        for (std::size_t x = 0; x < tile; ++x) cells[y][x] += cells[y + k][x];
  }

  // How unlike the surfaces of two pixels are.
  void compare_surfaces(int y, int dx, int dy, std::array<float, tile>& unlike) const {
    constexpr float turned = 0.1F;  // the square of a difference of normals
    unlike.fill(0);
    for (std::size_t c = 0; c < 3; ++c) {
      const float* const n = p_.normal[c].row(top_ + y) + left_;
      const float* const m = p_.normal[c].row(top_ + y + dy) + left_ + dx;
      for (int x = 0; x < tile; ++x) unlike[static_cast<std::size_t>(x)] += (n[x] - m[x]) * (n[x] - m[x]);
    }
    const auto row = [&](const Plane& plane, int down, int right) {
      return plane.row(top_ + y + down) + left_ + right;
    };
    std::array<const float*, 3> n, a, b;
    for (std::size_t c = 0; c < 3; ++c)
      n[c] = row(p_.normal[c], 0, 0), a[c] = row(p_.place[c], 0, 0), b[c] = row(p_.place[c], dy, dx);
    const float *const va = row(p_.spread, 0, 0), *const vb = row(p_.spread, dy, dx);
    const float *const ta = row(p_.samples, 0, 0), *const tb = row(p_.samples, dy, dx);
    for (int x = 0; x < tile; ++x) {
      // `samples` has the variance of the normals by now, and `spread` is in sizes of pixels.
      const float turn = std::max(unlike[static_cast<std::size_t>(x)] - ta[x] - std::min(ta[x], tb[x]), 0.0F);
      const float off = n[0][x] * (b[0][x] - a[0][x]) + n[1][x] * (b[1][x] - a[1][x]) + n[2][x] * (b[2][x] - a[2][x]);
      const float gone = std::max(off * off - va[x] - std::min(va[x], vb[x]), 0.0F);
      unlike[static_cast<std::size_t>(x)] = turn / (turned + ta[x] + tb[x]) + gone / (pixel_size(a, x) + va[x] + vb[x]);
    }
  }
  // Returns the square of the size of a pixel at this place.
  float pixel_size(const std::array<const float*, 3>& at, int x) const {
    const auto pixel = static_cast<float>(p_.pixel * p_.pixel);
    if (p_.orthographic) return pixel;
    return pixel * (at[0][x] * at[0][x] + at[1][x] * at[1][x] + at[2][x] * at[2][x]) + 1e-30F;
  }

  void add(int dx, int dy) {
    std::array<float, tile> unlike;
    for (int y = 0; y < std::min(tile, p_.height - top_); ++y) {
      const auto i = static_cast<std::size_t>(y);
      compare_surfaces(y, dx, dy, unlike);
      const float* const there = p_.seen.row(top_ + y + dy) + left_ + dx;
      std::array<float, tile> weight;
      for (std::size_t x = 0; x < tile; ++x) {
        const float light = std::max(differences_[i][x] / std::max(3 * both_[i][x], 1.0F), 0.0F);
        weight[x] = there[x] * falloff(light + unlike[x]);
        weights_[i][x] += weight[x];
      }
      for (std::size_t c = 0; c < 3; ++c) {
        const float* const light = (*pass_.light)[c].row(top_ + y + dy) + left_ + dx;
        for (std::size_t x = 0; x < tile; ++x) sum_[c][i][x] += weight[x] * light[x];
      }
    }
  }

  void write() const {
    for (int y = 0; y < std::min(tile, p_.height - top_); ++y)
      for (std::size_t c = 0; c < 3; ++c) {
        const float* const seen = p_.seen.row(top_ + y) + left_;
        float* const out = (*pass_.out)[c].row(top_ + y) + left_;
        for (int x = 0; x < std::min(tile, p_.width - left_); ++x) {
          const auto i = static_cast<std::size_t>(y), j = static_cast<std::size_t>(x);
          out[x] = seen[x] > 0 ? sum_[c][i][j] / weights_[i][j] : 0;
        }
      }
  }

  const NoisyPicture& p_;
  const Pass& pass_;
  const int left_, top_;
  Cells differences_, both_;
  std::array<TileCells, 3> sum_;
  TileCells weights_;
};

// Runs `item` for each row.
template <class Item>
void for_rows(const NoisyPicture& p, unsigned threads, const Item& item) {
  share_work(
      threads, static_cast<std::size_t>(p.height), [] { return 0; },
      [&](std::size_t y, int) { item(static_cast<int>(y)); });
}

void run(const NoisyPicture& p, unsigned threads, const Pass& pass) {
  const auto across = static_cast<std::size_t>((p.width + tile - 1) / tile);
  const auto down = static_cast<std::size_t>((p.height + tile - 1) / tile);
  share_work(
      threads, across * down, [] { return 0; },
      [&](std::size_t k, int) {
        Tile(p, pass, static_cast<int>(k % across) * tile, static_cast<int>(k / across) * tile).filter();
      });
}

// Divides the light by the albedo, and means by their share.
void prepare(NoisyPicture& p, int y) {
  for (int x = 0; x < p.width; ++x) {
    const auto at = [&](Plane& plane) -> float& { return plane.row(y)[x]; };
    const float seen = at(p.seen);
    if (!(seen > 0)) continue;
    float square = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      const float albedo = at(p.albedo[c]);
      at(p.first[c]) /= albedo, at(p.second[c]) /= albedo, at(p.variance[c]) /= albedo * albedo;
      at(p.normal[c]) /= seen, at(p.place[c]) /= seen;
      square += at(p.normal[c]) * at(p.normal[c]);
    }
    at(p.samples) = std::max(1 - square, 0.0F) / at(p.samples);
  }
}

// Returns the sums of a plane over squares.
Plane summed(const NoisyPicture& p, unsigned threads, const Plane& of, int reach) {
  Plane across(p.width, p.height), both(p.width, p.height);
  for_rows(p, threads, [&](int y) {
    for (int k = -reach; k <= reach; ++k)
      for (int x = 0; x < p.width; ++x) across.row(y)[x] += of.row(y)[x + k];
  });
  for_rows(p, threads, [&](int y) {
    for (int k = -reach; k <= reach; ++k)
      for (int x = 0; x < p.width; ++x) both.row(y)[x] += across.row(y + k)[x];
  });
  return both;
}

float sum_at(const Planes& planes, int x, int y) {
  return planes[0].row(y)[x] + planes[1].row(y)[x] + planes[2].row(y)[x];
}

// Finds single pixels with very much light: they would appear in the means of all pixels around them, as squares, since
// their own variance is an excuse for any difference.
class Sparks {
 public:
  Sparks(NoisyPicture& p, unsigned threads)
      : p_(p),
        threads_(threads),
        first_(p.first),
        second_(p.second),
        light_(p.width, p.height),
        noise_(p.width, p.height),
        count_(p.width, p.height) {}

  // What is above so many times the mean of its neighbours is left out: the more, the brighter it is. Returns the part
  // of it that both halves show: a highlight, in its own place.
  Planes take_out() {
    constexpr int rounds = 4;  // the neighbours of a spark are sparks too, perhaps
    for_rows(p_, threads_, [&](int y) {
      for (int x = 0; x < p_.width; ++x) count_.row(y)[x] = p_.seen.row(y)[x] > 0 ? 1.0F : 0.0F;
    });
    count_ = summed(p_, threads_, count_, radius);
    for (int round = 0; round < rounds; ++round) lessen();
    return rest();
  }

 private:
  float left(int x, int y) const {
    const float before = sum_at(first_, x, y) + sum_at(second_, x, y);
    return before > 0 ? std::clamp((sum_at(p_.first, x, y) + sum_at(p_.second, x, y)) / before, 0.0F, 1.0F) : 1;
  }
  void lessen() {
    for_rows(p_, threads_, [&](int y) {
      for (int x = 0; x < p_.width; ++x) {
        light_.row(y)[x] = std::max(0.5F * (sum_at(p_.first, x, y) + sum_at(p_.second, x, y)), 0.0F);
        noise_.row(y)[x] = sum_at(p_.variance, x, y) * left(x, y) * left(x, y);
      }
    });
    const Plane light = summed(p_, threads_, light_, radius), noise = summed(p_, threads_, noise_, radius);
    for_rows(p_, threads_, [&](int y) {
      for (int x = 0; x < p_.width; ++x) {
        const float others = count_.row(y)[x] - 1;
        if (!(others > 0) || !(p_.seen.row(y)[x] > 0)) continue;
        lessen(x, y, std::max(light.row(y)[x] - light_.row(y)[x], 0.0F) / others,
               std::max(noise.row(y)[x] - noise_.row(y)[x], 0.0F) / others);
      }
    });
  }
  // `mean`, `noise`: the light and the variance of the neighbours. Among pixels of little noise few are alike, so that
  // a noisy one has more weight.
  void lessen(int x, int y, float mean, float noise) {
    constexpr float most = 16, most_noisy = 2;
    const float limit = mean * (noise_.row(y)[x] > most * noise ? most_noisy : most);
    for (Planes* half : {&p_.first, &p_.second})
      if (const float is = sum_at(*half, x, y); is > limit)
        for (Plane& plane : *half) plane.row(y)[x] *= std::max(limit / is * limit, mean) / is;
  }
  // Returns how sure it is that the light of a pixel is there: not at all if four of its samples have all of it.
  float sureness(int x, int y) const {
    float squares = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      const float mean = 0.5F * (first_[c].row(y)[x] + second_[c].row(y)[x]);
      squares += mean * mean;
    }
    return squares > 0 ? std::clamp(1.5F - 6 * sum_at(p_.variance, x, y) / squares, 0.0F, 1.0F) : 0;
  }
  Planes rest() {
    Planes rest = NoisyPicture::three(p_.width, p_.height);
    for_rows(p_, threads_, [&](int y) {
      for (int x = 0; x < p_.width; ++x) {
        const float now = left(x, y), sure = sureness(x, y);
        for (std::size_t c = 0; c < 3; ++c) {
          const float a = first_[c].row(y)[x] - p_.first[c].row(y)[x],
                      b = second_[c].row(y)[x] - p_.second[c].row(y)[x];
          rest[c].row(y)[x] = sure * std::clamp(0.5F * (a + b), 0.0F, 2 * std::max(std::min(a, b), 0.0F));
          p_.variance[c].row(y)[x] *= now * now;
        }
      }
    });
    return rest;
  }

  NoisyPicture& p_;
  const unsigned threads_;
  const Planes first_, second_;  // as they were
  Plane light_, noise_, count_;
};

// Samples are spread better than by chance, so their mean is more exact than their differences suggest: how much
// more, the difference between the halves of neighbours says.
void calibrate(NoisyPicture& p, unsigned threads) {
  constexpr int reach = 4;
  for (std::size_t c = 0; c < 3; ++c) {
    Plane off(p.width, p.height);
    for_rows(p, threads, [&](int y) {
      for (int x = 0; x < p.width; ++x) {
        const float d = p.first[c].row(y)[x] - p.second[c].row(y)[x];
        off.row(y)[x] = 0.25F * d * d;
      }
    });
    off = summed(p, threads, off, reach);
    const Plane said = summed(p, threads, p.variance[c], reach);
    for_rows(p, threads, [&](int y) {
      for (int x = 0; x < p.width; ++x)
        if (said.row(y)[x] > 0) p.variance[c].row(y)[x] *= std::min(off.row(y)[x] / said.row(y)[x], 1.0F);
    });
  }
}

// After a pass: the halves become their mean, whose variance their difference shows.
void join_halves(const NoisyPicture& p, unsigned threads, Planes& one, const Planes& other, Planes& variance) {
  for (std::size_t c = 0; c < 3; ++c) {
    for_rows(p, threads, [&](int y) {
      for (int x = 0; x < p.width; ++x) {
        const float a = one[c].row(y)[x], b = other[c].row(y)[x];
        one[c].row(y)[x] = 0.5F * (a + b), variance[c].row(y)[x] = 0.25F * (a - b) * (a - b);
      }
    });
  }
}

}  // namespace

void denoise(NoisyPicture& p, unsigned threads) {
  for_rows(p, threads, [&](int y) { prepare(p, y); });
  const Planes sparks = Sparks(p, threads).take_out();
  calibrate(p, threads);
  // A half has half of the samples.
  Planes doubled = p.variance;
  for (std::size_t c = 0; c < 3; ++c)
    for_rows(p, threads, [&](int y) {
      for (int x = 0; x < p.width; ++x) doubled[c].row(y)[x] *= 2;
    });
  constexpr float strict = 0.25F, easy = 2;
  Planes one = p.first, other = p.second;
  run(p, threads, {&p.second, &doubled, 3, strict, &p.first, &one});
  run(p, threads, {&p.first, &doubled, 3, strict, &p.second, &other});
  join_halves(p, threads, one, other, doubled);
  for (Plane& plane : doubled) {
    plane = summed(p, threads, plane, 1);
    for_rows(p, threads, [&](int y) {
      for (int x = 0; x < p.width; ++x) plane.row(y)[x] /= 9;
    });
  }
  run(p, threads, {&one, &doubled, 1, easy, &one, &p.second});
  for (std::size_t c = 0; c < 3; ++c)
    for_rows(p, threads, [&](int y) {
      for (int x = 0; x < p.width; ++x)
        p.first[c].row(y)[x] = (p.second[c].row(y)[x] + sparks[c].row(y)[x]) * p.albedo[c].row(y)[x];
    });
}

}  // namespace betwixt::traced
