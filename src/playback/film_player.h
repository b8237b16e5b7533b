// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Pictures of films for viewers: one after the other, in any order of times, and in sizes that change.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "betwixt/evaluation.h"
#include "betwixt/render.h"

namespace betwixt {

// Keeps the renderers used last, because making one takes longer than most pictures. Use it from one thread at a time.
class RendererCache {
 public:
  // Keeps `most` renderers. It looks in `spares`, unless that is null, before it makes one, and leaves its own there at
  // the end.
  explicit RendererCache(std::size_t most = 1, RendererCache* spares = nullptr) : most_(most), spares_(spares) {}
  ~RendererCache();
  RendererCache(const RendererCache&) = delete;
  RendererCache& operator=(const RendererCache&) = delete;

  // Returns the renderer for these options, valid until the next call. Errors: those of make_renderer.
  Result<Renderer*> get(const RenderOptions&);
  void clear() { kept_.clear(); }

 private:
  struct Kept {
    RenderOptions options;
    std::unique_ptr<Renderer> renderer;
  };
  std::optional<Kept> take(const RenderOptions&);
  void make_room();

  const std::size_t most_;
  RendererCache* const spares_;
  std::vector<Kept> kept_;  // the one used last is at the end
};

// Evaluates and draws programs. Keeps an evaluation, so that a picture costs only what differs from the one before. Use
// it from one thread at a time.
class FilmPlayer {
 public:
  explicit FilmPlayer(std::size_t renderers = 1, RendererCache* spares = nullptr) : renderers_(renderers, spares) {}
  // Evaluates a program at a time. It may be an edited program, or that of another film. `eye` replaces its camera.
  const Evaluation& evaluate(const Program&, Time, const std::optional<Camera>& eye = {});
  // Draws what was evaluated last. Errors: those of make_renderer and of Renderer::render.
  Status draw(const RenderOptions&, Picture& out);
  Status draw(const Frame&, const RenderOptions&, Picture& out);  // draws this frame instead
  // The same, to the surface of the graphics system (Renderer::show).
  Status show(const RenderOptions&);
  // Frees the renderers until the next picture.
  void rest() { renderers_.clear(); }

 private:
  std::optional<Evaluation> evaluation_;
  RendererCache renderers_;
};

}  // namespace betwixt
