// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Films of programs: the pictures and their painters.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "base/files.h"
#include "betwixt/film.h"
#include "language/captions.h"

namespace betwixt {
namespace {

// A longer film is a mistake in the call.
constexpr double most_frames = 10'000'000;

// The own state of each painter.
struct Easel {
  std::unique_ptr<Renderer> renderer;
  Evaluation evaluation;
};

template <class Made>
Result<std::function<Status(int, Made&)>> painter(const Program& program, const RenderJob& job,
                                                  const TellProblems& problems) {
  Result<std::unique_ptr<Renderer>> renderer = make_renderer(job.pictures);
  if (!renderer) return renderer.error();
  const auto easel = std::make_shared<Easel>(*std::move(renderer), Evaluation(program));
  return std::function([easel, problems, frames = job.frames, blur = job.blur](int k, Made& out) -> Status {
    Status drawn = Nothing{};
    const bool blurred = std::is_same_v<Made, LinearPicture> && blur;
    if constexpr (std::is_same_v<Made, LinearPicture>)
      if (blurred) drawn = easel->renderer->render_blurred(easel->evaluation, frames.time(k), *blur, out);
    if (!blurred) {
      easel->evaluation.to(frames.time(k));
      drawn = easel->renderer->render(easel->evaluation, out);
    }
    if (problems) problems(easel->evaluation.problems());
    return drawn;
  });
}

}  // namespace

Result<FrameList> frames_between(Time first, Time last, Rate rate) {
  const double number = rate.frame_number(first);
  const double count = std::floor(rate.frame_number(last) - number + 1e-6) + 1;
  if (count > most_frames)
    return fail(ErrorCode::range,
                fmt::format("{:.0f} frames are too many for one film; at most {:.0f}", count, most_frames));
  if (std::abs(number) > 1e9) return fail(ErrorCode::range, "this time is too far from the beginning");
  FrameList frames;
  frames.rate = rate;
  frames.first = first, frames.last = last;
  frames.count = std::max(1, static_cast<int>(count));
  frames.number = static_cast<int>(std::floor(number));
  frames.on_grid = number == std::floor(number);
  return frames;
}

RenderJob render_job(const Program& program, const std::string& path, const FrameList& frames, RenderOptions pictures,
                     std::optional<Blur> blur, int bits, ColorCoding colors) {
  const Document& document = program.document();
  pictures.unclamped = takes_unclamped_light(path);
  pictures.linear = (document.transparent() && takes_alpha(path)) || takes_16_bits(path) || bits > 8 || blur ||
                    colors != ColorCoding::srgb;
  pictures.peak = has_highlights(colors) ? peak_nits / white_nits : 1;
  FilmOptions film;
  film.path = path;
  film.frames = frames.count;
  film.first_number = frames.number;
  film.rate = frames.rate;
  film.width = pictures.width, film.height = pictures.height;
  film.alpha = document.transparent();
  film.drawing = document.scene().appearance.flat;
  film.bits = ending(path) == "png" && colors != ColorCoding::srgb ? 16 : bits;
  film.colors = colors;
  film.chapters = chapters_of(document, frames.time(0), frames.time(frames.count - 1) + frames.rate.span(1));
  if (has_sounds(document) && takes_sound(path))
    film.sounds = [program, from = frames.time(0)](std::span<float> stereo) {
      return mix_sounds(program, from, stereo);
    };
  if (takes_captions(path)) {
    const double first = frames.time(0).seconds(), last = frames.time(frames.count).seconds();
    film.captions = write_srt(captions_between(captions_of_film(document.scene()), first, last));
  }
  return {frames, std::move(pictures), blur, std::move(film)};
}

Result<Painter> painter_of(const Program& program, const RenderJob& job, const TellProblems& problems) {
  return painter<Picture>(program, job, problems);
}

Result<LinearPainter> linear_painter_of(const Program& program, const RenderJob& job, const TellProblems& problems) {
  return painter<LinearPicture>(program, job, problems);
}

}  // namespace betwixt
