// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Videos on drawables: the numbers of their pictures, and which one is shown when.
#include <algorithm>

#include "program/compile.h"
#include "program/evaluator.h"

namespace betwixt {

void number_textures(CompiledFilm& c) {
  const Scene& scene = c.document.scene();
  for (const auto& [name, picture] : *scene.pictures) c.textures.push_back(picture);
  std::uint64_t first = c.textures.size();
  for (const auto& [name, video] : *scene.videos) {
    if (first + video->begins.size() >= Evaluation::Look::none) break;
    c.videos.push_back({video, static_cast<std::uint32_t>(first)});
    first += video->begins.size();
  }
}

bool show_video(CompiledFilm& c, std::uint32_t node, Drawable& d) {
  if (c.videos.empty()) return false;
  const std::uint32_t object = c.nodes[node].object;
  const bool is_video = c.nodes[node].kind == Kind::video;
  if (is_video && d.texture == &c.defaults[fn::texture]) d.texture = &c.find(object, fn::video_file);
  if (!d.texture->varies() && !c.video(d.texture->constant)) return false;
  const auto find = [&](FunctionId f) -> const Binding& {
    return c.find_shown(object, is_video ? f : static_cast<FunctionId>(f - fn::video_at + fn::texture_at));
  };
  const Binding& time = find(fn::video_time);
  const bool timed = &time != &c.defaults[time.function];
  const Binding& at = find(fn::video_at);
  std::optional<double> begin;
  if (&at == &c.defaults[at.function]) begin = c.document.range().first.seconds();
  d.video = static_cast<std::int32_t>(c.video_uses.size());
  c.video_uses.push_back({at.offset, find(fn::video_from).offset, find(fn::video_until).offset,
                          find(fn::video_speed).offset, find(fn::video_loop).offset, time.offset, timed, begin});
  return true;
}

const CompiledFilm::NumberedVideo* CompiledFilm::video(const Value& v) const {
  const auto& all = *document.scene().videos;
  const auto found = all.find(*std::get<Text>(v));
  if (found == all.end()) return nullptr;
  const auto at = std::find_if(videos.begin(), videos.end(), [&](const auto& n) { return n.video == found->second; });
  return at == videos.end() ? nullptr : &*at;
}

std::uint32_t CompiledFilm::shown(const NumberedVideo& n, const VideoUse& use, Time t, const double* numbers) const {
  const bool loop = numbers[use.loop] != 0;
  if (use.timed) return n.first + static_cast<std::uint32_t>(picture_at_time(*n.video, numbers[use.time], loop));
  const VideoPart part{use.begin.value_or(numbers[use.at]), numbers[use.from], numbers[use.until], numbers[use.speed],
                       loop};
  return n.first + static_cast<std::uint32_t>(picture_shown(*n.video, part, t.seconds()));
}

namespace {
const CompiledFilm::NumberedVideo& video_of(const CompiledFilm& c, std::uint32_t number) {
  return *std::prev(std::upper_bound(c.videos.begin(), c.videos.end(), number,
                                     [](std::uint32_t n, const auto& video) { return n < video.first; }));
}
}  // namespace

Result<std::shared_ptr<const Picture>> CompiledFilm::picture(std::uint32_t number) const {
  if (number < textures.size()) return textures[number];
  const NumberedVideo& n = video_of(*this, number);
  return n.video->picture(number - n.first);
}

std::pair<const void*, std::uint32_t> CompiledFilm::picture_key(std::uint32_t number) const {
  if (number == Evaluation::Look::none) return {nullptr, 0};
  if (number < textures.size()) return {textures[number].get(), 0};
  const NumberedVideo& n = video_of(*this, number);
  return {n.video.get(), number - n.first};
}

// Returns the number of a texture that is not constant.
std::uint32_t Evaluator::texture(const Drawable& d, Asking& asking) const {
  const Value name = compiled_.value(*d.texture, now_, asking);
  const auto* const video = d.video < 0 ? nullptr : compiled_.video(name);
  if (!video) return compiled_.texture(name);
  return compiled_.shown(*video, compiled_.video_uses[static_cast<std::size_t>(d.video)], now_, numbers_.data());
}

}  // namespace betwixt
