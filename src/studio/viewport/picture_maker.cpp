// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/viewport/picture_maker.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "playback/film_player.h"

namespace betwixt::studio {
namespace {

// Pictures that follow each other within this time, as in playback or a drag, may be coarser.
constexpr std::chrono::milliseconds flows{150};
constexpr double slow = 0.040, quick = 0.012;  // seconds a picture: above, coarser; below, finer

// Levels of coarseness: as wanted; one sample a pixel; half the width and height.
constexpr int coarsest = 2;
RenderOptions coarser(RenderOptions o, int by) {
  const auto is_style = [&](const Style& s) { return s.name == o.style; };
  const auto style = std::ranges::find_if(styles(), is_style);
  if (by > 0 && style != styles().end() && style->takes(1)) o.samples = 1;
  if (by > 1) o.width = std::max(1, o.width / 2), o.height = std::max(1, o.height / 2);
  return o;
}

class Maker {
 public:
  PictureMade make(const PictureWanted& w, int coarse = 0) {
    PictureMade m;
    m.time = w.time, m.program = w.program;
    const Evaluation& evaluation = film_.evaluate(w.program, w.time, w.eye);
    m.eye = evaluation.camera(), m.problems = evaluation.problems();
    Picture& p = picture_;
    if (Status s = film_.draw(coarser(w.options, coarse), p); !s) {
      m.problems.push_back(s.error().message);
      return m;
    }
    m.image = QImage(p.rgba.data(), p.width, p.height, 4 * p.width, QImage::Format_RGBA8888)
                  .convertToFormat(w.program.document().transparent() ? QImage::Format_ARGB32_Premultiplied
                                                                      : QImage::Format_RGB32);
    return m;
  }

 private:
  FilmPlayer film_{coarsest + 1};
  Picture picture_;
};

}  // namespace

PictureMaker::PictureMaker() {
  qRegisterMetaType<PictureMade>();
  worker_ = std::thread([this] { work(); });
}

PictureMaker::~PictureMaker() {
  {
    const std::lock_guard lock(mutex_);
    over_ = true;
  }
  changed_.notify_one();
  worker_.join();
}

void PictureMaker::want(PictureWanted w) {
  {
    const std::lock_guard lock(mutex_);
    wanted_ = std::move(w);
  }
  changed_.notify_one();
}

void PictureMaker::work() {
  using Clock = std::chrono::steady_clock;
  Maker maker;
  int coarse = 0;                      // level for pictures in quick succession
  Clock::time_point before;            // time of the last request
  std::optional<PictureWanted> rough;  // the picture last shown coarser than wanted
  while (true) {
    std::optional<PictureWanted> next;
    {
      std::unique_lock lock(mutex_);
      const auto due = [&] { return over_ || wanted_; };
      if (rough)
        changed_.wait_for(lock, flows, due);
      else
        changed_.wait(lock, due);
      if (over_) return;
      next = std::exchange(wanted_, std::nullopt);
    }
    const auto now = Clock::now();
    if (!next) {  // no new request: render it as wanted
      emit made(maker.make(*std::exchange(rough, std::nullopt)));
      continue;
    }
    const bool follows = now - std::exchange(before, now) < flows;
    const int by = follows ? coarse : 0;
    PictureMade picture = maker.make(*next, by);
    const double took = std::chrono::duration<double>(Clock::now() - now).count();
    if (follows && took > slow) coarse = std::min(coarse + 1, coarsest);
    if (follows && took < quick) coarse = std::max(coarse - 1, 0);
    if (by > 0) rough = std::move(next);
    if (by == 0) rough.reset();
    before = Clock::now();  // rendering time is no pause
    emit made(picture);
  }
}

PictureMade PictureMaker::make(const PictureWanted& w) { return Maker().make(w); }

}  // namespace betwixt::studio
