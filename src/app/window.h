// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// A window that shows pictures, on a display of the X Window System.
#pragma once

#include <memory>
#include <string>

#include "betwixt/mesh.h"
#include "betwixt/result.h"

namespace betwixt {

class Window {
 public:
  static bool has_display();  // whether there is a display that answers
  // Errors: machine (no display, or one without full colours).
  static Result<std::unique_ptr<Window>> open(const std::string& title, int width, int height);
  virtual ~Window() = default;
  // Prepares a picture; it must have the window's size.
  virtual void draw(const Picture&) = 0;
  // Shows the prepared picture as a whole.
  virtual void show() = 0;
  // Returns whether the window or the display has been closed; then no more pictures show.
  virtual bool closed() = 0;
};

}  // namespace betwixt
