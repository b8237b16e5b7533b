// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/viewport/picture_maker.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <utility>

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

// Keeps renderers and an evaluation from one picture to the next.
class Maker {
 public:
  PictureMade make(const PictureWanted& w, int coarse = 0) {
    PictureMade m;
    m.time = w.time, m.program = w.program;
    const auto kept = renderer_for(coarser(w.options, coarse), coarse);
    if (!kept) {
      m.problems.push_back(kept.error().message);
      return m;
    }
    if (!evaluation_)
      evaluation_.emplace(w.program);
    else if (&evaluation_->program().compiled() != &w.program.compiled())
      evaluation_->use(w.program);
    evaluation_->look_from(w.eye);
    evaluation_->to(w.time);
    m.eye = evaluation_->camera(), m.problems = evaluation_->problems();
    Picture& p = (*kept)->picture;
    if (Status s = (*kept)->renderer->render(*evaluation_, p); !s) {
      m.problems.push_back(s.error().message);
      return m;
    }
    m.image = QImage(p.rgba.data(), p.width, p.height, 4 * p.width, QImage::Format_RGBA8888)
                  .convertToFormat(QImage::Format_RGB32);
    return m;
  }

 private:
  struct Kept {
    RenderOptions options;
    std::unique_ptr<Renderer> renderer;
    Picture picture;  // the last one; reused if nothing differs
  };
  Result<Kept*> renderer_for(const RenderOptions& o, int coarse) {
    Kept& kept = kept_[static_cast<std::size_t>(coarse)];
    const RenderOptions& k = kept.options;
    if (kept.renderer && o.width == k.width && o.height == k.height && o.samples == k.samples && o.style == k.style)
      return &kept;
    kept.renderer.reset();
    auto made = make_renderer(o);
    if (!made) return made.error();
    kept = {o, *std::move(made), {}};
    return &kept;
  }

  std::array<Kept, coarsest + 1> kept_;
  std::optional<Evaluation> evaluation_;
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
