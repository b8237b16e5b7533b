// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Pictures for windows: a thread with a renderer of its own makes the newest one that was asked for, and leaves out
// those that came too late. While they follow each other quickly, and take long, they are coarser; the last one is made
// again as it was asked for.
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
  std::optional<Camera> eye;  // where it is seen from; none: through the film's camera
};
struct PictureMade {
  QImage image;
  Time time;
  std::optional<Program> program;     // whose it is
  Camera eye;                         // that it was seen from
  std::vector<std::string> problems;  // of code, and why there is no image
};

class PictureMaker : public QObject {
  Q_OBJECT
 public:
  PictureMaker();
  ~PictureMaker() override;
  void want(PictureWanted);
  // The same at once, for who waits.
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
