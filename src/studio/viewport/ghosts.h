// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Onion skin: tinted silhouettes of the objects some frames before and after the playhead.
#pragma once

#include <QImage>
#include <functional>
#include <optional>

#include "betwixt/frame.h"
#include "studio/shell/workspace.h"
#include "studio/viewport/handles.h"

namespace betwixt::studio {

// Fills the area that an item covers, and draws its edges.
void paint_silhouette(QPainter&, const Scope&, const Item&, const QColor&);

class Ghosts {
 public:
  explicit Ghosts(const Workspace& workspace) : workspace_(workspace) {}
  void forget() { image_.reset(); }
  // Paints the objects of `which` where they differ from now, or all moving objects if it returns none.
  void paint(QPainter&, const Scope&, const Camera& eye, const Frame& now,
             const std::function<std::vector<ObjectId>()>& which);

 private:
  struct Kept {
    QImage image;
    Time time;
    Camera eye;
    QRectF box;
  };
  const Workspace& workspace_;
  std::optional<Kept> image_;
};

}  // namespace betwixt::studio
