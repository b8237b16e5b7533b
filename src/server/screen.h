// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Where the server's frames go. A frame is drawn while the one before is still visible, and shown at its moment (double
// buffering): a viewer never sees half a picture.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "betwixt/evaluation.h"
#include "betwixt/render.h"
#include "server/imaging.h"

namespace betwixt {

// One thread creates, draws on and destroys a screen; another one shows the drawn frame. Never both at once.
class Screen {
 public:
  virtual ~Screen() = default;
  virtual Status draw(const Evaluation&) = 0;
  virtual Status show(const Shown&) = 0;  // the frame drawn last; fast, and without graphics calls
};
using NewScreen = std::function<Result<std::unique_ptr<Screen>>()>;

// Writes a film file; each picture lasts until the next. The file is complete when the screen is destroyed. If writing
// fails, another thread calls `trouble`. Errors of both functions: the renderer's, the film's, machine (no shared
// memory).
NewScreen film_screen(const std::string& path, const RenderOptions&, Rate, std::function<void(const Error&)> trouble);
// Writes pictures to shared memory, in the layout of docs/server.md.
NewScreen ring_screen(const std::string& name, const RenderOptions&);

}  // namespace betwixt
