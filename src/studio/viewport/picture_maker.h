// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Renders pictures for windows. A thread makes the latest picture wanted and drops earlier ones. If pictures are slow
// and a hand moves something, it makes drafts: fewer samples, then smaller pictures. Another thread makes the whole
// picture as soon as the hand rests; so a hand that moves on does not wait for it.
#pragma once

#include <QImage>
#include <QObject>
#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "betwixt/evaluation.h"
#include "betwixt/render.h"
#include "studio/shell/marks.h"

namespace betwixt::studio {

struct PictureWanted {
  Program program;
  Time time;
  RenderOptions options;
  std::optional<Camera> eye;                        // the eye; nullopt: the film's camera
  std::shared_ptr<const Marks> left_out = nullptr;  // objects that the picture does not show; null: none
  std::uint64_t number = 0;                         // given back with the picture
  bool moves = false;                               // more such requests are about to follow: a draft will do
};
struct PictureMade {
  QImage image;
  Time time;
  std::optional<Program> program;     // of the picture
  Camera eye;                         // the camera used
  std::vector<std::string> problems;  // errors of code, and why there is no image
  bool draft = false;
  std::uint64_t number = 0;  // of the request
};

// Removes objects from a frame.
void leave_out(const Marks*, Frame&);

class PictureMaker : public QObject {
  Q_OBJECT
 public:
  PictureMaker();
  ~PictureMaker() override;
  void want(PictureWanted);
  void want_nothing();  // drops requests
  // Renders a picture at once, in the calling thread.
  static PictureMade make(const PictureWanted&);

 Q_SIGNALS:
  void made(const betwixt::studio::PictureMade&);

 private:
  void make_first();  // the latest request, as a draft if the whole picture takes long
  void make_whole();  // what was a draft

  std::mutex mutex_;
  std::condition_variable changed_;
  std::optional<PictureWanted> wanted_, rough_;  // rough_: shown as a draft, and no newer request has come
  std::uint64_t asked_ = 0;                      // the number of requests
  double seconds_ = 0;                           // that the last whole picture took
  bool over_ = false;
  std::thread first_, whole_;
};

}  // namespace betwixt::studio
