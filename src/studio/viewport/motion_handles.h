// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Handles at the factors of a motion: the way of a translation, the centre and the angle of a rotation, the centre and
// the growth of a scaling. A drag rewrites the row of the motion.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "betwixt/algebra.h"
#include "studio/viewport/handles.h"

namespace betwixt::studio {

// A motion that acts at a time, as the script has it.
struct MotionRow {
  std::string target;  // "wheel.motion"
  std::string time;    // "1f..48f"
  Motion motion;
  std::string rest;  // what follows the motion in the row: twerper and eases

  // The line that gives the row another motion.
  std::string line(const Motion&) const;
};
// Returns nullopt if no motion acts on the object then, or if it is computed or on a layer.
std::optional<MotionRow> motion_row(const Document&, ObjectId, Time);

class MotionHandles {
 public:
  enum class Grip : std::uint8_t { end, centre };  // of the way, the angle or the growth; the point that stays
  struct Part {
    std::size_t factor = 0;
    Grip grip = Grip::end;
    friend bool operator==(const Part&, const Part&) = default;
  };

  // Returns nullopt if there is nothing to grab.
  static std::optional<MotionHandles> make(const Program&, ObjectId, Time);

  const MotionRow& row() const { return row_; }
  // Returns the place of a handle in the world, for the motion of the row. A centre that is an object has none.
  std::optional<Vec3> place(Part) const;
  std::optional<Part> part_at(const Scope&, QPointF) const;
  void paint(QPainter&, const Scope&, std::optional<Part> hot) const;
  // Returns the motion after a drag of a handle to a point. `turned`: the angle before, so that whole turns count.
  // `snap`: rounds to steps of 15 degrees, tenths, or the grid.
  Motion dragged(const Scope&, Part, QPointF to, double turned, bool snap) const;

 private:
  Vec3 centre(std::size_t factor) const;  // in the space of the motion
  Vec3 in_world(Vec3 p) const { return transform_point(space_, p); }
  Vec3 under(const Scope&, QPointF, Vec3 near) const;  // the point of the motion's space at the depth of another

  MotionRow row_;
  Mat4 space_, back_;            // from the space of the motion to the world, and back
  std::vector<Vec3> from_, to_;  // for each factor, where it takes the object from and to
  std::vector<Vec3> about_;      // the places of centres that are objects
};

}  // namespace betwixt::studio
