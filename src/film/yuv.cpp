// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "film/yuv.h"

#include <algorithm>
#include <array>

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

void luma_row(const std::uint8_t* rgba, int width, std::uint8_t* out) {
  for (int x = 0; x < width; ++x) {
    const std::uint8_t* p = rgba + 4 * x;
    out[x] = static_cast<std::uint8_t>((yr * p[0] + yg * p[1] + yb * p[2] + (16 << 16) + 32768) >> 16);
  }
}

// Computes a row of chroma from two rows of pixels: weights 1 2 1 across (centred on the even pixel), 1 1 down, 8 in
// all; times the opacity, if there is one, so that transparent pixels do not colour borders.

void chroma_row(const std::uint8_t* a, const std::uint8_t* b, int width, bool alpha, std::uint8_t* cb,
                std::uint8_t* cr) {
  const auto column = [&](int x) {
    const std::uint8_t *p = a + 4 * x, *q = b + 4 * x;
    const int s = alpha ? p[3] : 1, t = alpha ? q[3] : 1;
    return Sum{s * p[0] + t * q[0], s * p[1] + t * q[1], s * p[2] + t * q[2], s + t};
  };
  const auto put = [](std::uint8_t& to, int v) {
    to = static_cast<std::uint8_t>(std::clamp((v + (128 << 19) + (1 << 18)) >> 19, 16, 240));
  };
  Sum left = column(0);
  for (int x = 0; x < width; x += 2) {
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

}  // namespace betwixt
