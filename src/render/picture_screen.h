// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Shows a finished picture on the surface of the graphics system (only web pages have one).
#pragma once

#include <optional>

#include "betwixt/mesh.h"
#include "betwixt/result.h"
#include "render/gl.h"

namespace betwixt {

class PictureScreen {
 public:
  PictureScreen() = default;
  PictureScreen(const PictureScreen&) = delete;
  PictureScreen& operator=(const PictureScreen&) = delete;
  ~PictureScreen();
  Status show(const Picture&);  // errors: machine

 private:
  std::optional<gl::Context> context_;  // these are made on first use
  gl::Program program_;
  gl::Texture texture_;
  int width_ = 0, height_ = 0;  // of the texture
};

}  // namespace betwixt
