// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Motion paths: dots at the positions of each frame around the playhead, larger at events.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "studio/shell/workspace.h"
#include "studio/viewport/handles.h"

namespace betwixt::studio {

class Trails {
 public:
  explicit Trails(const Workspace& workspace) : workspace_(workspace) {}
  void forget() { ways_.clear(); }
  // Returns false if some paths need more time than one picture may take; the next call continues.
  bool paint(QPainter&, const Scope&, Time now);
  // Returns the event with a dot at this point, or nullopt.
  std::optional<EventAt> event_at(const Scope&, QPointF, Time now) const;
  // Returns the first and the last frame of a path.
  static std::pair<int, int> frames(const Workspace&, Time now);

 private:
  struct Way {
    std::map<int, Vec3> places;  // by frame
    std::map<int, EventAt> events;
    bool moves() const;
  };
  bool find(Way&, ObjectId, int first, int last, int now);
  void paint(QPainter&, const Scope&, const Way&, int first, int last, double now) const;

  const Workspace& workspace_;
  std::map<std::uint32_t, Way> ways_;
};

}  // namespace betwixt::studio
