// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/viewport/picture_maker.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "playback/film_player.h"

namespace betwixt::studio {
namespace {

// Pictures that follow each other within this time, as in playback or a drag, may be drafts.
constexpr std::chrono::milliseconds flows{100};
constexpr double slow = 0.030, quick = 0.010;  // seconds a picture: above, coarser; below, finer
constexpr double patient = 0.100;              // seconds that a picture may take if nothing moves

// Levels of coarseness: as wanted; one sample a pixel; a half, a quarter, and an eighth of the width and height.
constexpr int coarsest = 4;
RenderOptions coarser(RenderOptions o, int by) {
  const auto is_style = [&](const Style& s) { return s.name == o.style; };
  const auto style = std::ranges::find_if(styles(), is_style);
  if (by > 0 && style != styles().end() && style->takes(1)) o.samples = 1;
  const int part = by > 1 ? 1 << (by - 1) : 1;
  o.width = std::max(1, o.width / part), o.height = std::max(1, o.height / part);
  return o;
}
// Returns the level to begin with if the whole picture takes this long.
int level_for(double seconds) {
  int level = 0;
  for (; level < coarsest && seconds > slow; ++level) seconds /= 2.5;
  return level;
}

using Clock = std::chrono::steady_clock;
double seconds_since(Clock::time_point then) { return std::chrono::duration<double>(Clock::now() - then).count(); }

class Maker {
 public:
  PictureMade make(const PictureWanted& w, int coarse = 0) {
    PictureMade m;
    m.time = w.time, m.program = w.program, m.draft = coarse > 0, m.number = w.number;
    const Evaluation& evaluation = film_.evaluate(w.program, w.time, w.eye);
    m.eye = evaluation.camera(), m.problems = evaluation.problems();
    Picture& p = picture_;
    Status s = Nothing{};
    if (w.left_out) {
      Frame some = evaluation.frame();
      leave_out(w.left_out.get(), some);
      s = film_.draw(some, coarser(w.options, coarse), p);
    } else {
      s = film_.draw(coarser(w.options, coarse), p);
    }
    if (!s) {
      m.problems.push_back(s.error().message);
      return m;
    }
    m.image = QImage(p.rgba.data(), p.width, p.height, 4 * p.width, QImage::Format_RGBA8888)
                  .convertToFormat(w.program.document().transparent() ? QImage::Format_ARGB32_Premultiplied
                                                                      : QImage::Format_RGB32);
    return m;
  }

 private:
  FilmPlayer film_{2};
  Picture picture_;
};

}  // namespace

void leave_out(const Marks* objects, Frame& frame) {
  if (objects) std::erase_if(frame.items, [&](const Item& i) { return (*objects)(i.id); });
}

PictureMaker::PictureMaker() {
  qRegisterMetaType<PictureMade>();
  first_ = std::thread([this] { make_first(); });
  whole_ = std::thread([this] { make_whole(); });
}

PictureMaker::~PictureMaker() {
  {
    const std::lock_guard lock(mutex_);
    over_ = true;
  }
  changed_.notify_all();
  first_.join(), whole_.join();
}

void PictureMaker::want(PictureWanted w) {
  {
    const std::lock_guard lock(mutex_);
    wanted_ = std::move(w);
    rough_.reset();
    ++asked_;
  }
  changed_.notify_all();
}

void PictureMaker::want_nothing() {
  const std::lock_guard lock(mutex_);
  wanted_.reset(), rough_.reset();
  ++asked_;
}

void PictureMaker::make_first() {
  Maker maker;
  int coarse = -1;           // level of drafts; -1: not known yet
  Clock::time_point before;  // when the last picture was ready
  std::unique_lock lock(mutex_);
  while (true) {
    changed_.wait(lock, [&] { return over_ || wanted_; });
    if (over_) return;
    const PictureWanted next = *std::exchange(wanted_, std::nullopt);
    const std::uint64_t number = asked_;
    const bool moves = next.moves || Clock::now() - before < flows;
    if (coarse < 0 || !moves) coarse = level_for(seconds_);
    const int by = moves || seconds_ > patient ? coarse : 0;
    lock.unlock();
    const auto begun = Clock::now();
    const PictureMade picture = maker.make(next, by);
    const double took = seconds_since(begun);
    emit made(picture);
    lock.lock();
    if (by == 0) seconds_ = took, coarse = level_for(took);
    if (by > 0 && took > slow) coarse = std::min(coarse + 1, coarsest);
    if (by > 0 && took < quick) coarse = std::max(coarse - 1, seconds_ > slow ? 1 : 0);
    before = Clock::now();  // rendering time is no pause
    if (by == 0) continue;
    // While requests follow each other, none of them is made whole.
    if (moves) changed_.wait_for(lock, flows, [&] { return over_ || wanted_; });
    if (number == asked_) rough_ = next, changed_.notify_all();
  }
}

void PictureMaker::make_whole() {
  Maker maker;
  std::unique_lock lock(mutex_);
  while (true) {
    changed_.wait(lock, [&] { return over_ || rough_; });
    if (over_) return;
    const PictureWanted next = *std::exchange(rough_, std::nullopt);
    const std::uint64_t number = asked_;
    lock.unlock();
    const auto begun = Clock::now();
    const PictureMade picture = maker.make(next);
    const double took = seconds_since(begun);
    lock.lock();
    seconds_ = took;
    if (number == asked_) emit made(picture);
  }
}

PictureMade PictureMaker::make(const PictureWanted& w) { return Maker().make(w); }

}  // namespace betwixt::studio
