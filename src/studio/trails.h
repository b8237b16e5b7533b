// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The ways that things go: where they are at each frame around the playhead, larger where there is an event.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "studio/desk.h"
#include "studio/handles.h"

namespace betwixt::studio {

class Trails {
 public:
  explicit Trails(const Desk& desk) : desk_(desk) {}
  void forget() { ways_.clear(); }
  // False: not all of it was found in the time that one picture may take; it goes on with the next.
  bool paint(QPainter&, const Scope&, Time now);
  // The event whose dot is there.
  std::optional<EventAt> event_at(const Scope&, QPointF, Time now) const;
  // The frames that a trail shows, both included.
  static std::pair<int, int> frames(const Desk&, Time now);

 private:
  struct Way {
    std::map<int, Vec3> places;  // by frames
    std::map<int, EventAt> events;
    bool moves() const;
  };
  bool find(Way&, ObjectId, int first, int last, int now);
  void paint(QPainter&, const Scope&, const Way&, int first, int last, double now) const;

  const Desk& desk_;
  std::map<std::uint32_t, Way> ways_;
};

}  // namespace betwixt::studio
