// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// A window of a talk, on a display of the X Window System: it can fill the screen, and tells which keys were pressed.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "betwixt/mesh.h"
#include "betwixt/result.h"

namespace betwixt {

enum class StageKey : std::uint8_t { next, previous, first, last, blank, pause, fill, quit };

class StageWindow {
 public:
  // Errors: machine (no display, or one without full colours).
  static Result<std::unique_ptr<StageWindow>> open(const std::string& title, int width, int height, bool fills_screen);
  virtual ~StageWindow() = default;
  virtual std::pair<int, int> size() const = 0;
  // Shows the picture in the middle of the window, over black.
  virtual void show(const Picture&) = 0;
  virtual void fill_screen(bool) = 0;
  virtual int connection() const = 0;  // a file descriptor that can be read when events come
  // Takes the keys that have been pressed. `uncovered`: the picture must be shown again. The window may have another
  // size then.
  struct Events {
    std::vector<StageKey> keys;
    bool uncovered = false, closed = false;
  };
  virtual Events events() = 0;
};

}  // namespace betwixt
