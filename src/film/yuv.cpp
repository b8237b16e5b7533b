// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "film/yuv.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <utility>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace betwixt {
namespace {

// Fixed point with 16 fractional bits. Kr = 0.2126, Kb = 0.0722 (ITU-R BT.709); 219 steps of luma, 224 of chroma.
constexpr int fixed(double x) { return static_cast<int>(x * 65536 + (x < 0 ? -0.5 : 0.5)); }
constexpr double kr = 0.2126, kb = 0.0722, luma = 219.0 / 255, chroma = 224.0 / 255;
constexpr int yr = fixed(luma * kr), yb = fixed(luma * kb), yg = fixed(luma) - yr - yb;
constexpr int br = fixed(-chroma / 2 * kr / (1 - kb)), bb = fixed(chroma / 2), bg = -br - bb;
constexpr int rr = fixed(chroma / 2), rb = fixed(-chroma / 2 * kb / (1 - kr)), rg = -rr - rb;

struct Sum {
  int r, g, b, weight;
};

// Computes luma from column x on.
void luma_from(int x, const std::uint8_t* rgba, int width, std::uint8_t* out) {
  for (; x < width; ++x) {
    const std::uint8_t* p = rgba + 4 * x;
    out[x] = static_cast<std::uint8_t>((yr * p[0] + yg * p[1] + yb * p[2] + (16 << 16) + 32768) >> 16);
  }
}

// Computes a row of chroma from two rows of pixels, from the even column x on: weights 1 2 1 across (centred on the
// even pixel), 1 1 down, 8 in all; times the opacity, if there is one, so that transparent pixels do not colour
// borders.
void chroma_from(int x, const std::uint8_t* a, const std::uint8_t* b, int width, bool alpha, std::uint8_t* cb,
                 std::uint8_t* cr) {
  const auto column = [&](int at) {
    const std::uint8_t *p = a + 4 * at, *q = b + 4 * at;
    const int s = alpha ? p[3] : 1, t = alpha ? q[3] : 1;
    return Sum{s * p[0] + t * q[0], s * p[1] + t * q[1], s * p[2] + t * q[2], s + t};
  };
  const auto put = [](std::uint8_t& to, int v) {
    to = static_cast<std::uint8_t>(std::clamp((v + (128 << 19) + (1 << 18)) >> 19, 16, 240));
  };
  Sum left = column(std::max(x - 1, 0));
  for (; x < width; x += 2) {
    const Sum here = column(x), right = column(std::min(x + 1, width - 1));
    int r = left.r + 2 * here.r + right.r, g = left.g + 2 * here.g + right.g, u = left.b + 2 * here.b + right.b;
    if (alpha) {
      const int weight = std::max(left.weight + 2 * here.weight + right.weight, 1);
      for (int* sum : {&r, &g, &u}) *sum = (8 * *sum + weight / 2) / weight;
    }
    put(cb[x / 2], br * r + bg * g + bb * u);
    put(cr[x / 2], rr * r + rg * g + rb * u);
    left = right;
  }
}

#if defined(__SSE2__)

// The same numbers, several pixels at once, in instructions that all processors of this kind have: films spent more
// time here than in drawing. Both return the column from which on nothing is done.

static_assert(yg % 2 == 0 && yg / 2 < 32768, "half of the factor of green fits 16 bits");
__m128i pair_of(int low, int high) { return _mm_set1_epi32((high * 65536) | (low & 0xffff)); }
__m128i load(const std::uint8_t* p) { return _mm_loadu_si128(reinterpret_cast<const __m128i*>(p)); }

int luma_of_many(const std::uint8_t* rgba, int width, std::uint8_t* out) {
  const __m128i bytes = _mm_set1_epi32(0x00ff00ff), byte = _mm_set1_epi32(0xff);
  const __m128i red_blue = pair_of(yr, yb), green = pair_of(yg / 2, yg / 2), rest = _mm_set1_epi32((16 << 16) + 32768);
  const auto four = [&](const std::uint8_t* p) {
    const __m128i pixels = load(p), g = _mm_and_si128(_mm_srli_epi32(pixels, 8), byte);
    const __m128i twice = _mm_or_si128(g, _mm_slli_epi32(g, 16));
    const __m128i sum =
        _mm_add_epi32(_mm_madd_epi16(_mm_and_si128(pixels, bytes), red_blue), _mm_madd_epi16(twice, green));
    return _mm_srli_epi32(_mm_add_epi32(sum, rest), 16);
  };
  int x = 0;
  for (; x + 16 <= width; x += 16) {
    const std::uint8_t* p = rgba + 4 * x;
    const __m128i low = _mm_packs_epi32(four(p), four(p + 16)), high = _mm_packs_epi32(four(p + 32), four(p + 48));
    _mm_storeu_si128(reinterpret_cast<__m128i*>(out + x), _mm_packus_epi16(low, high));
  }
  return x;
}

int chroma_of_many(const std::uint8_t* a, const std::uint8_t* b, int width, std::uint8_t* cb, std::uint8_t* cr) {
  const __m128i bytes = _mm_set1_epi32(0x00ff00ff), byte = _mm_set1_epi32(0xff);
  const __m128i rest = _mm_set1_epi32((128 << 19) + (1 << 18));
  const __m128i b1 = pair_of(br, bb), b2 = pair_of(bg, 0), r1 = pair_of(rr, rb), r2 = pair_of(rg, 0);
  // Sums of even and of odd columns, as 16-bit numbers in lanes of 32 bits.
  struct Columns {
    __m128i even, odd;
  };
  const auto apart = [](__m128i low, __m128i high) {
    const __m128 l = _mm_castsi128_ps(low), h = _mm_castsi128_ps(high);
    return Columns{_mm_castps_si128(_mm_shuffle_ps(l, h, 0x88)), _mm_castps_si128(_mm_shuffle_ps(l, h, 0xdd))};
  };
  const auto weighed = [](const Columns& c, __m128i before) {
    const __m128i left = _mm_or_si128(_mm_slli_si128(c.odd, 4), before);
    return _mm_add_epi16(_mm_add_epi16(left, c.odd), _mm_slli_epi16(c.even, 1));
  };
  const auto put = [&](std::uint8_t* to, __m128i sum) {
    const __m128i wide = _mm_srai_epi32(_mm_add_epi32(sum, rest), 19), narrow = _mm_packs_epi32(wide, wide);
    const __m128i kept = _mm_min_epi16(_mm_max_epi16(narrow, _mm_set1_epi16(16)), _mm_set1_epi16(240));
    const int four = _mm_cvtsi128_si32(_mm_packus_epi16(kept, kept));
    std::memcpy(to, &four, 4);
  };
  if (width < 8) return 0;
  const auto column = [&](int i) { return a[i] + b[i]; };
  __m128i red_blue = _mm_cvtsi32_si128(column(0) | (column(2) << 16)), green = _mm_cvtsi32_si128(column(1));
  int x = 0;
  for (; x + 8 <= width; x += 8) {
    const __m128i a0 = load(a + 4 * x), a1 = load(a + 4 * x + 16), b0 = load(b + 4 * x), b1_ = load(b + 4 * x + 16);
    const auto both = [&](__m128i p, __m128i q) {
      return _mm_add_epi16(_mm_and_si128(p, bytes), _mm_and_si128(q, bytes));
    };
    const auto greens = [&](__m128i p, __m128i q) {
      return _mm_add_epi16(_mm_and_si128(_mm_srli_epi32(p, 8), byte), _mm_and_si128(_mm_srli_epi32(q, 8), byte));
    };
    const Columns rb_ = apart(both(a0, b0), both(a1, b1_)), g = apart(greens(a0, b0), greens(a1, b1_));
    const __m128i s = weighed(rb_, red_blue), t = weighed(g, green);
    put(cb + x / 2, _mm_add_epi32(_mm_madd_epi16(s, b1), _mm_madd_epi16(t, b2)));
    put(cr + x / 2, _mm_add_epi32(_mm_madd_epi16(s, r1), _mm_madd_epi16(t, r2)));
    red_blue = _mm_srli_si128(rb_.odd, 12), green = _mm_srli_si128(g.odd, 12);
  }
  return x;
}

#else

int luma_of_many(const std::uint8_t*, int, std::uint8_t*) { return 0; }
int chroma_of_many(const std::uint8_t*, const std::uint8_t*, int, std::uint8_t*, std::uint8_t*) { return 0; }

#endif

void luma_row(const std::uint8_t* rgba, int width, std::uint8_t* out) {
  luma_from(luma_of_many(rgba, width, out), rgba, width, out);
}

void chroma_row(const std::uint8_t* a, const std::uint8_t* b, int width, bool alpha, std::uint8_t* cb,
                std::uint8_t* cr) {
  chroma_from(alpha ? 0 : chroma_of_many(a, b, width, cb, cr), a, b, width, alpha, cb, cr);
}

}  // namespace

void to_yuv420(const Picture& in, bool alpha, std::vector<std::uint8_t>& out) {
  const int w = in.width, h = in.height, half_w = (w + 1) / 2, half_h = (h + 1) / 2;
  const std::size_t wide = 2 * static_cast<std::size_t>(half_w),
                    plane = static_cast<std::size_t>(half_w) * static_cast<std::size_t>(half_h);
  out.resize((alpha ? 10 : 6) * plane);
  const auto row = [&](int y) {
    return in.rgba.data() + static_cast<std::size_t>(std::min(y, h - 1)) * static_cast<std::size_t>(w) * 4;
  };
  for (int y = 0; y < half_h; ++y) {
    for (int k = 2 * y; k < 2 * y + 2; ++k) {
      std::uint8_t* to = out.data() + static_cast<std::size_t>(k) * wide;
      luma_row(row(k), w, to);
      if (w % 2 == 1) to[w] = to[w - 1];
    }
    std::uint8_t* cb = out.data() + 4 * plane + static_cast<std::size_t>(y) * static_cast<std::size_t>(half_w);
    chroma_row(row(2 * y), row(2 * y + 1), w, alpha, cb, cb + plane);
  }
  for (int y = 0; alpha && y < 2 * half_h; ++y) {
    std::uint8_t* to = out.data() + 6 * plane + static_cast<std::size_t>(y) * wide;
    for (int x = 0; x < 2 * half_w; ++x) to[x] = row(y)[4 * std::min(x, w - 1) + 3];
  }
}

namespace {

// Factors of 2^30 for channels of 16 bits, limited to 64 to 940 and 64 to 960.
struct DeepFactors {
  std::array<std::int64_t, 3> y{}, cb{}, cr{};
};
DeepFactors deep_factors(YuvMatrix matrix) {
  const double r = matrix == YuvMatrix::bt709 ? 0.2126 : 0.2627, b = matrix == YuvMatrix::bt709 ? 0.0722 : 0.0593;
  const auto whole = [](double x) { return static_cast<std::int64_t>(std::llround(x * (1 << 30))); };
  const double tall = 876.0 / 65535, half = 448.0 / 65535;
  return {{whole(tall * r), whole(tall * (1 - r - b)), whole(tall * b)},
          {whole(-half * r / (1 - b)), whole(-half * (1 - r - b) / (1 - b)), whole(half)},
          {whole(half), whole(-half * (1 - r - b) / (1 - r)), whole(-half * b / (1 - r))}};
}

}  // namespace

void to_yuv420_10(int width, int height, const std::vector<std::uint16_t>& rgba, YuvMatrix matrix,
                  std::vector<std::uint8_t>& out) {
  const DeepFactors f = deep_factors(matrix);
  const auto half_w = static_cast<std::size_t>((width + 1) / 2), half_h = static_cast<std::size_t>((height + 1) / 2);
  out.resize(12 * half_w * half_h);
  const auto pixel = [&](std::int64_t x, std::int64_t y) {
    return &rgba[4 * static_cast<std::size_t>(std::clamp<std::int64_t>(y, 0, height - 1) * width +
                                              std::clamp<std::int64_t>(x, 0, width - 1))];
  };
  const auto put = [&](std::size_t at, std::int64_t value) {
    out[2 * at] = static_cast<std::uint8_t>(value & 0xff), out[2 * at + 1] = static_cast<std::uint8_t>(value >> 8);
  };
  const auto sum = [](const std::array<std::int64_t, 3>& by, const auto& c) {
    return by[0] * c[0] + by[1] * c[1] + by[2] * c[2];
  };
  for (std::size_t y = 0; y < 2 * half_h; ++y)
    for (std::size_t x = 0; x < 2 * half_w; ++x)
      put(y * 2 * half_w + x, (sum(f.y, pixel(static_cast<std::int64_t>(x), static_cast<std::int64_t>(y))) +
                               (std::int64_t{64} << 30) + (1 << 29)) >>
                                  30);
  const std::size_t chroma = 4 * half_w * half_h, plane = half_w * half_h;
  for (std::size_t y = 0; y < half_h; ++y)
    for (std::size_t x = 0; x < half_w; ++x) {
      std::array<std::int64_t, 3> c{};
      for (std::int64_t j = 0; j < 2; ++j)
        for (std::int64_t i = -1; i <= 1; ++i) {
          const auto* const p = pixel(2 * static_cast<std::int64_t>(x) + i, 2 * static_cast<std::int64_t>(y) + j);
          for (std::size_t k = 0; k < 3; ++k) c[k] += (i == 0 ? 2 : 1) * std::int64_t{p[k]};
        }
      for (const auto& [by, first] : {std::pair(&f.cb, chroma), std::pair(&f.cr, chroma + plane)})
        put(first + y * half_w + x,
            std::clamp<std::int64_t>((sum(*by, c) + (std::int64_t{512} << 33) + (std::int64_t{1} << 32)) >> 33, 64,
                                     960));
    }
}

}  // namespace betwixt
