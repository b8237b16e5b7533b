// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Draws flat pictures on the processor, without the graphics interface: pictures in which everything shows its own
// colour, and where each pixel can be drawn from back to front. Coverage is exact at edges, and the first picture needs
// no context and no shaders. Of objects at one depth, the later one is in front.
#pragma once

#include "betwixt/linear_picture.h"
#include "betwixt/picture.h"
#include "render/columns.h"
#include "render/coverage.h"
#include "render/flat_seams.h"
#include "render/gradients.h"
#include "render/things.h"

namespace betwixt {

class FlatPainter {
 public:
  FlatPainter(int width, int height)
      : things_(Purpose::surfaces, width, height),
        width_(width),
        height_(height),
        rows_(static_cast<std::size_t>(height), {0, width}) {}
  // Draws into `out`, or returns false if the picture is not flat.
  bool draw(const Columns&, Picture& out);
  bool draw(const Columns&, LinearPicture& out);  // light with opacities

 private:
  struct alignas(16) Color {
    float r, g, b, opacity = 0;  // opacity: of sums, and of pictures of light
    friend bool operator==(const Color&, const Color&) = default;
  };
  // The gradient of a part: its colours, and rows from pixels (x y 1) to its own plane, with a divisor.
  struct Graded {
    GradientColors colors;
    PixelRows rows;
    bool even = false;  // each row of pixels has one colour
  };
  // A part of an object.
  struct Paint {
    Area area;
    Color color;  // linear light, at most 1
    float opacity = 1;
    std::shared_ptr<const Graded> graded;  // in place of the colour; null if it has none
  };
  struct Painted {
    bool good = false;  // whether it can be drawn here
    double front = 0;   // the smallest depth
    double back = 0;    // the largest depth
    std::vector<Paint> parts;
    LongEdges edges;                    // of an object with one opaque colour
    std::vector<std::uint32_t> beside;  // objects that share one of them
  };
  // What is in a pixel whose share an object covers that has others beside it.
  struct Seam {
    int row = -1;  // of the picture; that of another row is over
    std::uint32_t owner = 0;
    Color below{0, 0, 0}, sum{0, 0, 0}, result{0, 0, 0};  // sum: of colours by their shares
  };
  struct Span {  // of a row, in pixels
    int left, right;
  };
  bool update(const Columns&);
  void mark_all() { rows_.assign(rows_.size(), {0, width_}); }
  void mark(const Painted&);
  void outline(Painted&, const Thing&) const;
  bool sort();
  void find_seams();
  // Paints these parts of rows and calls put(y, …, row) for each; light: colours are multiplied by their opacities.
  template <bool light, class Put>
  void paint(const std::vector<Span>& rows, const Put& put) const;
  void fill(Picture& out) const;  // draws rows_
  void fill(LinearPicture& out) const;
  using Bytes = std::array<std::uint8_t, 4>;  // of a pixel
  static Bytes as_drawn(const Color&);
  template <bool light>
  static Color over(const Color& below, const Color&, float opacity);
  template <bool light, bool alone>
  static void lay(const Paint&, const RowCoverage&, int y, Color* row);
  // Adds an object that shares edges with others to a row.
  template <bool light>
  static void lay_beside(std::uint32_t number, const Painted&, const RowCoverage&, int y, Color* row, Seam* seams);
  static Color graded_at(const Graded&, std::size_t x, int y);
  static Color plus(const Color& sum, const Color&, float opacity);  // colours by their opacities

  Things things_;
  Scenery scenery_;
  int width_, height_;
  std::vector<Painted> painted_;
  std::vector<std::uint32_t> order_;  // of the visible ones, from back to front
  bool flat_ = false;                 // whether the columns that were seen last are flat
  Picture picture_;                   // the last one; empty: not drawn
  std::vector<Span> rows_;            // of picture_: what may differ now
};

}  // namespace betwixt
