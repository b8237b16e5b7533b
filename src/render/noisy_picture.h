// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// A picture of the light of surfaces that is not exact yet, and what is known of these surfaces: the input of the
// denoiser. Each number of a pixel has its own plane, with a margin, so that neighbours need no checks.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace betwixt::traced {

class Plane {
 public:
  static constexpr int tile = 32;    // pixels; the sides are rounded up to it
  static constexpr int margin = 12;  // pixels around that
  Plane(int width, int height) : stride_(padded(width)), values_(stride_ * padded(height)) {}
  // Returns a row. Rows and columns begin at -margin.
  float* row(int y) { return values_.data() + at(y); }
  const float* row(int y) const { return values_.data() + at(y); }

 private:
  static constexpr std::size_t padded(int pixels) {
    return static_cast<std::size_t>((pixels + tile - 1) / tile * tile + 2 * margin);
  }
  std::size_t at(int y) const { return static_cast<std::size_t>(y + margin) * stride_ + margin; }
  std::size_t stride_;
  std::vector<float> values_;
};
using Planes = std::array<Plane, 3>;

struct NoisyPicture {
  NoisyPicture(int wide, int tall) : width(wide), height(tall) {}
  static Planes three(int width, int height) {
    return {Plane(width, height), Plane(width, height), Plane(width, height)};
  }

  int width, height;
  // The light that two halves of the samples see, which are independent of each other; and the variance of the mean of
  // both, as the samples by themselves suggest.
  Planes first = three(width, height), second = three(width, height), variance = three(width, height);
  Planes albedo = three(width, height);  // the light is divided by it
  // Means over the surfaces that a pixel sees, in eye space. The normals are shorter the more they differ.
  Planes normal = three(width, height), place = three(width, height);
  Plane seen{width, height};     // how much of the pixel is surfaces; where it is 0, all other numbers are too
  Plane samples{width, height};  // the number of samples
  // The variance of the distance from the eye, metres squared; of the mean.
  Plane spread{width, height};
  // The size of a pixel at the distance 1, or at any distance for orthographic pictures.
  double pixel = 1e-3;
  bool orthographic = false;
};

}  // namespace betwixt::traced
