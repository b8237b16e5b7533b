// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/picture_maker.h"

#include <algorithm>
#include <utility>

namespace betwixt::studio {
namespace {

// A renderer and an evaluation that are kept from one picture to the next.
class Maker {
 public:
  PictureMade make(const PictureWanted& w) {
    PictureMade m;
    m.time = w.time, m.program = w.program;
    const RenderOptions& o = w.options;
    if (!renderer_ || o.width != options_.width || o.height != options_.height || o.samples != options_.samples ||
        o.style != options_.style) {
      options_ = o;
      auto made = make_renderer(o);
      if (!made) {
        renderer_.reset();
        m.problems.push_back(made.error().message);
        return m;
      }
      renderer_ = *std::move(made);
    }
    if (!evaluation_)
      evaluation_.emplace(w.program);
    else if (&evaluation_->program().compiled() != &w.program.compiled())
      evaluation_->use(w.program);
    evaluation_->look_from(w.eye);
    evaluation_->to(w.time);
    m.eye = evaluation_->camera(), m.problems = evaluation_->problems();
    if (Status s = renderer_->render(*evaluation_, picture_); !s) {
      m.problems.push_back(s.error().message);
      return m;
    }
    m.image = QImage(picture_.rgba.data(), picture_.width, picture_.height, 4 * picture_.width, QImage::Format_RGBA8888)
                  .convertToFormat(QImage::Format_RGB32);
    return m;
  }

 private:
  RenderOptions options_;
  std::unique_ptr<Renderer> renderer_;
  std::optional<Evaluation> evaluation_;
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
  Maker maker;
  while (true) {
    std::optional<PictureWanted> next;
    {
      std::unique_lock lock(mutex_);
      changed_.wait(lock, [&] { return over_ || wanted_; });
      if (over_) return;
      next = std::exchange(wanted_, std::nullopt);
    }
    emit made(maker.make(*next));
  }
}

PictureMade PictureMaker::make(const PictureWanted& w) { return Maker().make(w); }

}  // namespace betwixt::studio
