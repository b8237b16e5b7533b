// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Onion skin: tinted silhouettes of the objects some frames before and after the playhead, and at the events around it.
#pragma once

#include <QImage>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "betwixt/frame.h"
#include "studio/shell/workspace.h"
#include "studio/viewport/handles.h"

namespace betwixt::studio {

// The meshes of the last painting: while they are held, the next one need not make them again.
using HeldShapes = std::vector<std::shared_ptr<const Mesh>>;

// Fills the area that an item covers, and draws its edges.
void paint_silhouette(QPainter&, const Scope&, const Item&, const QColor&, HeldShapes&);

class Ghosts {
 public:
  explicit Ghosts(const Workspace& workspace) : workspace_(workspace) {}
  void forget() { image_.reset(); }
  struct Kinds {
    bool frames = false, events = false;
    friend bool operator==(const Kinds&, const Kinds&) = default;
  };
  // Paints the objects of `which` where they differ from now. If it returns none, paints all moving objects, but not
  // those at events.
  void paint(QPainter&, const Scope&, const Camera& eye, const Frame& now, Kinds,
             const std::function<std::vector<ObjectId>()>& which);
  // Returns the nearest times before and after `now` at which one of the objects has an event.
  static std::pair<std::optional<Time>, std::optional<Time>> events_around(const Document&, Time now,
                                                                           const std::vector<ObjectId>&);

 private:
  struct Kept {
    QImage image;
    Time time;
    Camera eye;
    QRectF box;
    Kinds kinds;
  };
  struct Moment {
    Time time;
    double opacity;
  };
  std::vector<Moment> moments(Time now, Kinds, const std::vector<ObjectId>&) const;

  const Workspace& workspace_;
  std::optional<Kept> image_;
  HeldShapes held_;
};

}  // namespace betwixt::studio
