// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Where an imaging server's frames go. A frame is drawn while the one before it stands, and shown at its moment: what
// looks on never sees half a picture. (C103, C129)
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "betwixt/evaluation.h"
#include "betwixt/render.h"
#include "server/imaging.h"

namespace betwixt {

// One thread makes it, draws and ends it; another one shows what was drawn. Never two at a time.
class Screen {
 public:
  virtual ~Screen() = default;
  virtual Status draw(const Evaluation&) = 0;
  virtual Status show(const Shown&) = 0;  // what was drawn last; quick, and without the graphics interface
};
using NewScreen = std::function<Result<std::unique_ptr<Screen>>()>;

// A film, every picture of which stands until the next; it is whole when the screen ends, else `trouble` was called,
// from another thread. Errors of the makers: those of renderers, of films, and machine (no shared memory).
NewScreen film_screen(const std::string& path, const RenderOptions&, Rate, std::function<void(const Error&)> trouble);
// Pictures in shared memory: docs/server.md says how they lie there.
NewScreen ring_screen(const std::string& name, const RenderOptions&);

}  // namespace betwixt
