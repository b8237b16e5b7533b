// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/assets/small_pictures.h"

#include <QCryptographicHash>
#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>
#include <algorithm>
#include <utility>

#include "studio/viewport/picture_maker.h"

namespace betwixt::studio {
namespace {

constexpr int most_kept = 1000;  // in the cache folder; the oldest go first

QDir cache_folder() {
  QDir folder(QStandardPaths::writableLocation(QStandardPaths::GenericCacheLocation) + "/betwixt/pictures");
  folder.mkpath(".");
  return folder;
}

QString file_of(const QDir& folder, const QString& of) {
  const QByteArray number =
      QCryptographicHash::hash(BETWIXT_VERSION " " + of.toUtf8(), QCryptographicHash::Sha1).toHex();
  return folder.filePath(QString::fromLatin1(number) + ".png");
}

void remove_oldest(const QDir& folder) {
  const QFileInfoList all = folder.entryInfoList({"*.png"}, QDir::Files, QDir::Time);
  for (qsizetype i = most_kept; i < all.size(); ++i) QFile::remove(all[i].filePath());
}

}  // namespace

SmallPictures::SmallPictures(QObject* parent) : QObject(parent), worker_([this] { work(); }) {}

SmallPictures::~SmallPictures() {
  {
    const std::lock_guard lock(mutex_);
    over_ = true;
  }
  changed_.notify_one();
  worker_.join();
}

std::optional<QImage> SmallPictures::picture(const QString& of, std::function<QImage()> make) {
  const std::lock_guard lock(mutex_);
  if (const auto there = made_.find(of); there != made_.end()) return there->second;
  if (std::ranges::find(wanted_, of, &Wanted::of) == wanted_.end()) wanted_.push_back({of, std::move(make)});
  changed_.notify_one();
  return std::nullopt;
}

void SmallPictures::want_none() {
  const std::lock_guard lock(mutex_);
  wanted_.clear();
}

void SmallPictures::work() {
  const QDir folder = cache_folder();
  remove_oldest(folder);
  while (true) {
    Wanted next;
    {
      std::unique_lock lock(mutex_);
      changed_.wait(lock, [&] { return over_ || !wanted_.empty(); });
      if (over_) return;
      next = std::move(wanted_.front());
      wanted_.pop_front();
      if (made_.contains(next.of)) continue;
    }
    const QString file = file_of(folder, next.of);
    QImage image(file);
    if (image.isNull()) {
      image = next.make();
      if (!image.isNull()) image.save(file);
    }
    {
      const std::lock_guard lock(mutex_);
      made_[next.of] = image;
    }
    emit made(next.of);
  }
}

QImage film_picture(const Document& d, double frame, QSize size) {
  RenderOptions o;
  o.width = size.width(), o.height = size.height();
  o.linear = d.transparent();  // otherwise the picture is opaque
  return PictureMaker::make({Program::compile(d), d.rate().frame(frame), o, {}}).image;
}

}  // namespace betwixt::studio
