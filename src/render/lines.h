// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Edges as lines a little more than a pixel wide.
#pragma once

#include "render/batches.h"

namespace betwixt {

class Lines {
 public:
  static Result<Lines> create();
  void set(const View&, int side);  // `side`: drawn pixels for one of the picture, along a side
  void draw(const Batch&, const Instances&) const;
  // Draws transparent objects; each covers its background once.
  void draw_transparent(const Batches&, const Instances&, const View&, int side);

 private:
  static void set(const gl::Program&, const View&, int side);
  static void draw_edges(const Batch&, const Instances&);
  gl::Program program_, layer_;  // the latter is made on first use
};

}  // namespace betwixt
