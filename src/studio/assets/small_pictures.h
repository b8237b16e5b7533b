// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Small pictures of films and files for lists. A thread of its own makes them, one after another, and keeps them in the
// user's cache folder.
#pragma once

#include <QImage>
#include <QObject>
#include <condition_variable>
#include <deque>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "betwixt/document.h"

namespace betwixt::studio {

class SmallPictures : public QObject {
  Q_OBJECT
 public:
  explicit SmallPictures(QObject* parent = nullptr);
  ~SmallPictures() override;

  // `of` says all that the picture depends on. Returns nullopt until it is made; made() follows then. A null image
  // means that there is no picture. The worker calls `make`, which must not use the window.
  std::optional<QImage> picture(const QString& of, std::function<QImage()> make);
  // Forgets all requests that have not begun.
  void want_none();

 Q_SIGNALS:
  void made(const QString& of);

 private:
  struct Wanted {
    QString of;
    std::function<QImage()> make;
  };
  void work();

  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Wanted> wanted_;
  std::map<QString, QImage> made_;
  bool over_ = false;
  std::thread worker_;
};

// Draws a film at a frame. The image is null if that fails.
QImage film_picture(const Document&, double frame, QSize);

}  // namespace betwixt::studio
