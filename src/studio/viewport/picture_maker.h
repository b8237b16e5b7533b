// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Renders pictures for windows. A thread with a renderer of its own makes the latest picture wanted and drops earlier
// ones. If requests follow each other quickly and pictures are slow, it lowers the quality; after the last request it
// renders again at full quality.
#pragma once

#include <QImage>
#include <QObject>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "betwixt/evaluation.h"
#include "betwixt/render.h"

namespace betwixt::studio {

struct PictureWanted {
  Program program;
  Time time;
  RenderOptions options;
  std::optional<Camera> eye;  // the eye; nullopt: the film's camera
};
struct PictureMade {
  QImage image;
  Time time;
  std::optional<Program> program;     // of the picture
  Camera eye;                         // the camera used
  std::vector<std::string> problems;  // errors of code, and why there is no image
};

class PictureMaker : public QObject {
  Q_OBJECT
 public:
  PictureMaker();
  ~PictureMaker() override;
  void want(PictureWanted);
  // Renders a picture at once, in the calling thread.
  static PictureMade make(const PictureWanted&);

 Q_SIGNALS:
  void made(const betwixt::studio::PictureMade&);

 private:
  void work();

  std::mutex mutex_;
  std::condition_variable changed_;
  std::optional<PictureWanted> wanted_;
  bool over_ = false;
  std::thread worker_;
};

}  // namespace betwixt::studio
