// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Smooth edges from four samples a pixel. Four samples know only within a quarter of a pixel where an edge is. But the
// samples of the pixels around lie along the same edge. Where a straight line parts all 36 into brighter and darker
// ones, it says more exactly how much of the pixel is bright.
//
// The canvas leaves a mark in each pixel: a bit for each sample that is one of the brighter ones; 0 if all are alike;
// `several` if there are more than two colours. In bytes it is the opacity; in floats each bit is the sign of a
// channel.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "betwixt/linear_picture.h"
#include "betwixt/mesh.h"

namespace betwixt {

using PixelLight = std::array<float, 4>;  // with its opacity, or 0 in opaque pictures
class EdgeSmoother {
 public:
  static constexpr int several = 15;

  // `places`: x and y of the four samples, from the middle of a pixel; y as the rows of pictures.
  explicit EdgeSmoother(const std::vector<float>& places);
  // Smooths the edges of a picture with marks and takes the marks away.
  void finish(Picture&) const;  // becomes opaque
  void finish(LinearPicture&) const;

  // Returns which share of a pixel is bright: of the marks of nine pixels, row by row, the fifth is its own.
  double bright_share(const std::array<int, 9>& marks) const;

 private:
  static constexpr int samples = 36, directions = 128;
  // Four numbers at once: those of a pixel's samples.
  using Four = float __attribute__((vector_size(16)));
  struct Direction {
    double x = 0, y = 0;        // unit length
    std::array<Four, 9> along;  // how far each sample is in it
  };
  template <class Pixels>
  std::optional<PixelLight> smoothed(const Pixels&, int x, int y) const;
  template <class Pixels>
  void finish(Pixels&) const;

  // For each mark of each pixel: towards where it is brighter, seen from the middle one.
  std::array<std::array<std::array<double, 2>, 16>, 9> toward_{};
  // For each mark of each pixel: what puts the samples far away that are dark, or bright, or too far to count.
  std::array<std::array<Four, 16>, 9> if_bright_{}, if_dark_{};
  std::array<Direction, directions> directions_;
};

}  // namespace betwixt
