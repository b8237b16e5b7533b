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

 private:
  gl::Program program_;
};

}  // namespace betwixt
