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
  void set(const View&, int side);  // `side`: pixels drawn for one of the picture, along a side
  void draw(const Batch&, const Instances&) const;
  // Things through which one sees, each of which covers what is behind it once.
  void draw_transparent(const Batches&, const Instances&, const View&, int side);

 private:
  static void set(const gl::Program&, const View&, int side);
  static void draw_edges(const Batch&, const Instances&);
  gl::Program program_, layer_;  // the latter made when it is wanted
};

}  // namespace betwixt
