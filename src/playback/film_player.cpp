// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "playback/film_player.h"

#include <algorithm>
#include <utility>

namespace betwixt {

RendererCache::~RendererCache() {
  if (!spares_) return;
  for (Kept& k : kept_) spares_->make_room(), spares_->kept_.push_back(std::move(k));
}

// Drops the renderer that was not used for the longest time, if another one would be too many.
void RendererCache::make_room() {
  if (kept_.size() == most_) kept_.erase(kept_.begin());
}

std::optional<RendererCache::Kept> RendererCache::take(const RenderOptions& options) {
  const auto found = std::find_if(kept_.begin(), kept_.end(), [&](const Kept& k) { return k.options == options; });
  if (found == kept_.end()) return std::nullopt;
  std::optional<Kept> taken(std::move(*found));
  kept_.erase(found);
  return taken;
}

Result<Renderer*> RendererCache::get(const RenderOptions& options) {
  std::optional<Kept> used = take(options);
  make_room();  // before another renderer is made, because each one needs much memory
  if (!used && spares_) used = spares_->take(options);
  if (!used) {
    Result<std::unique_ptr<Renderer>> made = make_renderer(options);
    if (!made) return made.error();
    used = Kept{options, *std::move(made)};
  }
  return kept_.emplace_back(*std::move(used)).renderer.get();
}

const Evaluation& FilmPlayer::evaluate(const Program& program, Time t, const std::optional<Camera>& eye) {
  if (!evaluation_)
    evaluation_.emplace(program);
  else if (&evaluation_->program().compiled() != &program.compiled())
    evaluation_->use(program);
  evaluation_->look_from(eye);
  evaluation_->to(t);
  return *evaluation_;
}

Status FilmPlayer::draw(const RenderOptions& options, Picture& out) {
  const Result<Renderer*> renderer = renderers_.get(options);
  return renderer ? (*renderer)->render(*evaluation_, out) : renderer.error();
}

Status FilmPlayer::draw(const Frame& frame, const RenderOptions& options, Picture& out) {
  const Result<Renderer*> renderer = renderers_.get(options);
  return renderer ? (*renderer)->render(frame, out) : renderer.error();
}

Status FilmPlayer::show(const RenderOptions& options) {
  const Result<Renderer*> renderer = renderers_.get(options);
  return renderer ? (*renderer)->show(*evaluation_) : renderer.error();
}

}  // namespace betwixt
