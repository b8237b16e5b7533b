// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "render/grade.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "render/bloom.h"
#include "render/curves.h"
#include "render/look_table.h"

namespace betwixt {
namespace {

using Rows = std::array<Vec3, 3>;
constexpr Vec3 product(const Rows& m, Vec3 v) { return {dot(m[0], v), dot(m[1], v), dot(m[2], v)}; }
constexpr Rows product(const Rows& a, const Rows& b) {
  Rows m;
  for (std::size_t i = 0; i < 3; ++i) m[i] = a[i].x * b[0] + a[i].y * b[1] + a[i].z * b[2];
  return m;
}

float sound(float x) { return x > 0 ? std::min(x, 1e6F) : 0; }  // NaN becomes 0
Vec3 sound_light(const float* p) {
  return {static_cast<double>(sound(p[0])), static_cast<double>(sound(p[1])), static_cast<double>(sound(p[2]))};
}

// ---- white balance

constexpr Rows xyz_of_rgb{{{0.4123907993, 0.3575843394, 0.1804807884},
                           {0.2126390059, 0.7151686788, 0.0721923154},
                           {0.0193308187, 0.1191947798, 0.9505321522}}};
constexpr Rows rgb_of_xyz{{{3.2409699419, -1.5373831776, -0.4986107603},
                           {-0.9692436363, 1.8759675015, 0.0415550574},
                           {0.0556300797, -0.2039769589, 1.0569715142}}};
constexpr Rows bradford{{{0.8951, 0.2664, -0.1614}, {-0.7502, 1.7135, 0.0367}, {0.0389, -0.0685, 1.0296}}};
constexpr Rows bradford_inverse{{{0.9869929055, -0.1470542564, 0.1599626517},
                                 {0.4323052697, 0.5183602715, 0.0492912282},
                                 {-0.0085286646, 0.0400428217, 0.9684866958}}};

// The colour of a light of this temperature as seen by Bradford's cones: up to 4000 K that of a black body, by
// Krystek's fit of the Planckian locus (1985); from 6500 K on that of daylight, which is a little greener; and between
// them both.
Vec3 cones_of(double kelvin) {
  const double t = kelvin;
  const double u =
      (0.860117757 + 1.54118254e-4 * t + 1.28641212e-7 * t * t) / (1 + 8.42420235e-4 * t + 7.08145163e-7 * t * t);
  const double v =
      (0.317398726 + 4.22806245e-5 * t + 4.20481691e-8 * t * t) / (1 - 2.89741816e-5 * t + 1.61456053e-7 * t * t);
  const double day = std::clamp((t - 4000) / 2500, 0.0, 1.0), du = u - 0.0026647 * day, dv = v + 0.0018897 * day;
  const double x = 3 * du / (2 * du - 8 * dv + 4), y = 2 * dv / (2 * du - 8 * dv + 4);
  return product(bradford, Vec3{x / y, 1, (1 - x - y) / y});
}

// ---- views

// Hable's curve (Uncharted 2), scaled so that middle grey stays what it is.
double filmic(double light) {
  const auto curve = [](double x) {
    return (x * (0.15 * x + 0.05) + 0.004) / (x * (0.15 * x + 0.5) + 0.06) - 0.02 / 0.3;
  };
  constexpr double white = 11.2, scale = 2.927523;
  return curve(std::min(scale * light, white)) / curve(white);
}

// AgX, by Troy Sobotka; its curve as Benjamin Wrensch fitted it. The result is a signal for the screen.
constexpr Rows agx_in{{{0.842479062253094, 0.0784335999999992, 0.0792237451477643},
                       {0.0423282422610123, 0.878468636469772, 0.0791661274605434},
                       {0.0423756549057051, 0.0784336, 0.879142973793104}}};
constexpr Rows agx_out{{{1.19687900512017, -0.0980208811401368, -0.0990297440797205},
                        {-0.0528968517574562, 1.15190312990417, -0.0989611768448433},
                        {-0.0529716355144438, -0.0980434501171241, 1.15107367264116}}};
double agx_curve(double light) {
  constexpr double least = -12.47393, most = 4.026069;
  const double stops = std::clamp(own_log2(std::max(light, 1e-10)), least, most), x = (stops - least) / (most - least);
  return -0.00232 + x * (0.1191 + x * (0.4298 + x * (-6.868 + x * (31.96 + x * (-40.14 + x * 15.5)))));
}
Vec3 agx(Vec3 light) {
  const Vec3 c = product(agx_in, light);
  return product(agx_out, Vec3{agx_curve(c.x), agx_curve(c.y), agx_curve(c.z)});
}

// Khronos' neutral tone mapping without its toe, as the styles have it.
Vec3 neutral_view(Vec3 c) {
  constexpr double start = 0.8, room = 1 - start;
  const double peak = std::max({c.x, c.y, c.z}), over = peak - start;
  if (!(over > 0)) return c;
  const double shown = start + room * over / (room + over), left = 1 / (0.15 * (peak - shown) + 1);
  return left * (shown / peak) * c + (1 - left) * Vec3{shown, shown, shown};
}

Vec3 signals(Vec3 light) { return {signal_of(light.x), signal_of(light.y), signal_of(light.z)}; }

Vec3 by_view(Vec3 light, const Development& how) {
  switch (how.grade.view) {
    case Grade::agx: {
      const Vec3 s = agx(light);
      return {std::clamp(s.x, 0.0, 1.0), std::clamp(s.y, 0.0, 1.0), std::clamp(s.z, 0.0, 1.0)};
    }
    case Grade::filmic:
      return signals({filmic(light.x), filmic(light.y), filmic(light.z)});
    case Grade::neutral:
      return signals(how.cut ? light : neutral_view(light));
    case Grade::plain:
      break;
  }
  return signals(light);
}

// Mixes what a table makes with the picture before it.
Vec3 by_table(Vec3 light, const Development& how) {
  const ColorTable& table = *how.grade.table;
  const double share = how.grade.table_share;
  const bool of_picture = table.takes == ColorTable::picture;
  Vec3 before;
  if (of_picture || share < 1) before = of_picture ? by_view(light, how) : signals(light);
  const Vec3 after = looked_up(table, of_picture ? before : light);
  return share < 1 ? (1 - share) * before + share * after : after;
}

bool keeps_highlights(const Development& how) {
  return how.peak > 1 && !how.grade.table && how.grade.view <= Grade::plain;
}
// Shows light on a screen with room for highlights: rolls it off at the peak instead of at white. The result is a
// signal of the light's share of the peak.
Vec3 with_highlights(Vec3 light, const Development& how) {
  const Vec3 share = (1 / how.peak) * light;
  return signals(how.grade.view == Grade::neutral && !how.cut ? neutral_view(share) : share);
}

Vec3 viewed(Vec3 light, const Development& how) {
  if (keeps_highlights(how)) return with_highlights(light, how);
  return how.grade.table ? by_table(light, how) : by_view(light, how);
}

// ---- edges of bright light

// A pixel at the edge of bright light is the mean of two lights. Its picture is the mean of their pictures: that of the
// mean light would be nearly as bright as the brighter one, so edges would have steps.
class BrightEdges {
 public:
  BrightEdges(const LinearPicture& picture, const Development& how) : picture_(picture), how_(how) {
    for (std::vector<float>& row : peaks_) row.resize(static_cast<std::size_t>(picture.width));
  }
  // Goes to a row; each call is for the next one.
  void to_row(int y) {
    if (y_ != y - 1)
      for (const int near : {y - 1, y}) fill(near);
    fill(y + 1), y_ = y;
  }
  // Returns the signals of a pixel.
  Vec3 at(int x) const {
    const Vec3 plain = viewed(light_at(x, y_), how_);
    if (!(std::max({most_[0], most_[1], most_[2]}) > 1)) return plain;
    const Found f = look_around(x);
    const double range = f.high - f.low, here = peak(x, y_);
    const double contrast = std::clamp((f.high / (f.low + 0.05) - 2) / 4, 0.0, 1.0);
    if (!(f.high > 1) || !(contrast > 0) || here <= f.low || here >= f.high) return plain;
    const double share = (here - f.low) / range;
    const Vec3 dark = viewed(light_at(f.low_x, f.low_y), how_), bright = viewed(light_at(f.high_x, f.high_y), how_);
    Vec3 s;
    for (int c = 0; c < 3; ++c) {
      const double both = (1 - share) * light_of_signal(dark[c]) + share * light_of_signal(bright[c]);
      s[c] = (1 - contrast) * plain[c] + contrast * signal_of(both);
    }
    return s;
  }

 private:
  struct Found {
    double low = 1e30, high = -1;
    int low_x = 0, low_y = 0, high_x = 0, high_y = 0;
  };
  Found look_around(int x) const {
    Found f;
    for (int j = std::max(y_ - 1, 0); j <= std::min(y_ + 1, picture_.height - 1); ++j)
      for (int i = std::max(x - 1, 0); i <= std::min(x + 1, picture_.width - 1); ++i) {
        const double is = peak(i, j);
        if (is < f.low) f.low = is, f.low_x = i, f.low_y = j;
        if (is > f.high) f.high = is, f.high_x = i, f.high_y = j;
      }
    return f;
  }
  const float* pixel_at(int x, int y) const {
    return &picture_.rgba[4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture_.width) +
                               static_cast<std::size_t>(x))];
  }
  Vec3 light_at(int x, int y) const { return sound_light(pixel_at(x, y)); }
  static std::size_t kept(int y) { return static_cast<std::size_t>((y + 3) % 3); }
  double peak(int x, int y) const { return static_cast<double>(peaks_[kept(y)][static_cast<std::size_t>(x)]); }
  void fill(int y) {
    most_[kept(y)] = 0;
    if (y < 0 || y >= picture_.height) return;
    for (int x = 0; x < picture_.width; ++x) {
      const float* const p = pixel_at(x, y);
      const float is = std::max({sound(p[0]), sound(p[1]), sound(p[2])});
      peaks_[kept(y)][static_cast<std::size_t>(x)] = is, most_[kept(y)] = std::max(most_[kept(y)], is);
    }
  }
  const LinearPicture& picture_;
  const Development& how_;
  int y_ = -2;
  std::array<std::vector<float>, 3> peaks_;  // of three rows: the brightest channel of each pixel
  std::array<float, 3> most_{};              // and that of the row
};

// ---- grain

std::uint64_t stirred(std::uint64_t h) {
  h = (h ^ (h >> 30)) * 0xbf58476d1ce4e5b9ULL;
  h = (h ^ (h >> 27)) * 0x94d049bb133111ebULL;
  return h ^ (h >> 31);
}

// A row of noise of mean 0 and variance 1/3: sums of four even numbers, nearly a normal distribution.
class NoiseRow {
 public:
  NoiseRow(Time time, int width) : seed_(stirred(static_cast<std::uint64_t>(time.flicks) + 0x9e3779b97f4a7c15ULL)) {
    row_.resize(static_cast<std::size_t>(width) + 1);
  }
  const std::vector<float>& at(int y) {
    for (std::size_t x = 0; x < row_.size(); ++x) {
      const std::uint64_t h = stirred(seed_ ^ (static_cast<std::uint64_t>(y) << 32 | x));
      const std::uint64_t sum = (h & 0xffff) + ((h >> 16) & 0xffff) + ((h >> 32) & 0xffff) + (h >> 48);
      row_[x] = static_cast<float>(static_cast<double>(sum) / 65535 - 2);
    }
    return row_;
  }

 private:
  std::uint64_t seed_;
  std::vector<float> row_;
};

// The grain of a row: a grain is a little larger than a pixel. Its variance is 1.
void grain_of_row(NoiseRow& above, NoiseRow& below, int y, std::vector<float>& out) {
  const std::vector<float>&a = above.at(y), &b = below.at(y + 1);
  for (std::size_t x = 0; x < out.size(); ++x) out[x] = 0.8660254F * (a[x] + a[x + 1] + b[x] + b[x + 1]);
}

// ---- pictures

struct ShownPixel {
  Vec3 signal;  // straight
  double opacity = 1;
};

// Strongest in the middle, none on black and white, and none above white.
double grained(double signal, const Development& how, double grain) {
  const auto with = [&](double is) {
    return std::clamp(is + 0.24 * how.grade.grain * grain * is * (1 - is), 0.0, 1.0);
  };
  if (!keeps_highlights(how)) return with(signal);
  const double light = how.peak * light_of_signal(signal);
  return light < 1 ? signal_of(light_of_signal(with(signal_of(light))) / how.peak) : signal;
}

// As to_shown: an opacity is raised so far that straight light can be as bright as the pixel.
ShownPixel shown_pixel(const float* p, const BrightEdges& edges, int x, const Development& how, float grain) {
  ShownPixel s;
  if (how.opaque) {
    s.signal = edges.at(x);
  } else {
    const Vec3 light = sound_light(p);
    s.opacity = std::min(std::max({light.x, light.y, light.z, static_cast<double>(sound(p[3]))}), 1.0);
    if (!(s.opacity > 0)) return s;
    s.signal = viewed(1 / s.opacity * light, how);
  }
  if (how.grade.grain > 0)
    for (int c = 0; c < 3; ++c) s.signal[c] = grained(s.signal[c], how, static_cast<double>(grain));
  return s;
}

template <class Put>
void each_shown(const LinearPicture& picture, const Development& how, const Put& put) {
  const auto width = static_cast<std::size_t>(picture.width);
  for_rows(picture.width, picture.height, [&](int first, int end) {
    NoiseRow above(how.time, picture.width), below = above;
    std::vector<float> grain(width);
    BrightEdges edges(picture, how);
    for (int y = first; y < end; ++y) {
      edges.to_row(y);
      if (how.grade.grain > 0) grain_of_row(above, below, y, grain);
      for (std::size_t x = 0; x < width; ++x) {
        const std::size_t at = 4 * (static_cast<std::size_t>(y) * width + x);
        put(at, shown_pixel(&picture.rgba[at], edges, static_cast<int>(x), how, grain[x]));
      }
    }
  });
}

std::uint8_t to_byte(double share) { return static_cast<std::uint8_t>(255 * share + 0.5); }

}  // namespace

Rows white_balance(double kelvin) {
  const Vec3 from = cones_of(kelvin), to = cones_of(6500);
  Rows gains{{{to.x / from.x, 0, 0}, {0, to.y / from.y, 0}, {0, 0, to.z / from.z}}};
  return product(rgb_of_xyz, product(bradford_inverse, product(gains, product(bradford, xyz_of_rgb))));
}

void grade_light(LinearPicture& picture, const Grade& grade) {
  const bool balances = grade.white_balance != Grade().white_balance;
  if (balances || grade.bloom > 0) {
    const Rows m = balances ? white_balance(grade.white_balance) : Rows{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    for_rows(picture.width, picture.height, [&](int first, int end) {
      const std::size_t row = 4 * static_cast<std::size_t>(picture.width);
      for (std::size_t i = row * static_cast<std::size_t>(first); i < row * static_cast<std::size_t>(end); i += 4) {
        float* const p = &picture.rgba[i];
        Vec3 c = sound_light(p);
        if (balances) c = product(m, c);
        for (int k = 0; k < 3; ++k) p[k] = static_cast<float>(std::max(c[k], 0.0));
      }
    });
  }
  if (grade.bloom > 0) spread_light(picture, grade.bloom);
  if (grade.vignette > 0)
    for_rows(picture.width, picture.height, [&](int first, int end) {
      const double half_x = 0.5 * picture.width, half_y = 0.5 * picture.height,
                   corner = half_x * half_x + half_y * half_y;
      for (int y = first; y < end; ++y)
        for (int x = 0; x < picture.width; ++x) {
          const double right = x + 0.5 - half_x, down = y + 0.5 - half_y, away = (right * right + down * down) / corner;
          const auto left = static_cast<float>(1 - grade.vignette * 0.5 * away * (1 + away));
          float* const p = &picture.rgba[4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
                                              static_cast<std::size_t>(x))];
          for (int k = 0; k < 3; ++k) p[k] *= left;
        }
    });
}

void develop(const LinearPicture& picture, const Development& how, Picture& out) {
  out.width = picture.width, out.height = picture.height;
  out.rgba.resize(picture.rgba.size());
  each_shown(picture, how, [&](std::size_t at, const ShownPixel& s) {
    for (int c = 0; c < 3; ++c) out.rgba[at + static_cast<std::size_t>(c)] = to_byte(s.signal[c]);
    out.rgba[at + 3] = to_byte(s.opacity);
  });
}

void develop(LinearPicture& picture, const Development& how) {
  const LinearPicture light = picture;
  const double brightest = keeps_highlights(how) ? how.peak : 1;
  each_shown(light, how, [&](std::size_t at, const ShownPixel& s) {
    for (int c = 0; c < 3; ++c)
      picture.rgba[at + static_cast<std::size_t>(c)] =
          static_cast<float>(s.opacity * brightest * light_of_signal(s.signal[c]));
    picture.rgba[at + 3] = static_cast<float>(s.opacity);
  });
}

}  // namespace betwixt
