// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Where things were and will be some frames away, as tinted silhouettes.
#pragma once

#include <QImage>
#include <functional>
#include <optional>

#include "betwixt/frame.h"
#include "studio/desk.h"
#include "studio/handles.h"

namespace betwixt::studio {

// Fills what an item covers, or draws its edges where it has only these.
void paint_silhouette(QPainter&, const Scope&, const Item&, const QColor&);

class Ghosts {
 public:
  explicit Ghosts(const Desk& desk) : desk_(desk) {}
  void forget() { image_.reset(); }
  // Of what is selected and what hangs on it; of all that moves where nothing is.
  void paint(QPainter&, const Scope&, const Camera& eye, const Frame& now,
             const std::function<std::vector<ObjectId>()>& which);

 private:
  struct Kept {
    QImage image;
    Time time;
    Camera eye;
    QRectF box;
  };
  const Desk& desk_;
  std::optional<Kept> image_;
};

}  // namespace betwixt::studio
