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
  static bool has_display();  // one that answers
  // Errors: machine (no display, or one without full colours).
  static Result<std::unique_ptr<Window>> open(const std::string& title, int width, int height);
  virtual ~Window() = default;
  // Gets a picture ready; it must have the window's size …
  virtual void draw(const Picture&) = 0;
  // … and puts it there whole.
  virtual void show() = 0;
  // Somebody closed it, or the display has gone: nothing is shown any more.
  virtual bool closed() = 0;
};

}  // namespace betwixt
