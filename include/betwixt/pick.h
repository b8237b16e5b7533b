// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What is where in a picture: from places of the world to places of the picture and back, and what is under a finger.
// Places of a picture go from 0 at its left and its top to 1 at its right and its bottom.
//
// Room: render
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "betwixt/frame.h"
#include "betwixt/mesh.h"

namespace betwixt {

struct Ray {
  Vec3 from, along;  // along: of unit length
};

// How a camera takes pictures, which are `aspect` times as wide as high.
class Projection {
 public:
  struct Spot {
    double x = 0, y = 0, depth = 0;  // depth: metres before the eye, along its axis
  };
  struct Rectangle {
    double left = 0, top = 0, right = 0, bottom = 0;
    bool holds(const Rectangle& o) const {
      return left <= o.left && top <= o.top && o.right <= right && o.bottom <= bottom;
    }
  };

  Projection(const Camera&, double aspect);

  // None: it is not before the eye.
  std::optional<Spot> spot(Vec3 place) const;
  // Through a place of the picture; from the eye on, or where it is orthographic from the camera's plane.
  Ray ray(double x, double y) const;
  Vec3 place(double x, double y, double depth) const;
  // How many metres are seen there from bottom to top.
  double height(double depth) const;

  Vec3 eye() const { return eye_; }
  Vec3 right() const { return right_; }
  Vec3 up() const { return up_; }
  Vec3 forward() const { return -backward_; }
  bool orthographic() const { return orthographic_; }
  double aspect() const { return aspect_; }

 private:
  Vec3 eye_, right_, up_, backward_;
  bool orthographic_;
  double sx_, sy_, shift_x_, shift_y_, aspect_;  // as View's
};

// What an item is drawn with, in the world: three corners for each triangle of the mesh, two for each of its edges.
struct Drawn {
  std::vector<Vec3> corners;
  std::shared_ptr<const Mesh> mesh;  // never null
};
// As fine as for what reaches so many pixels from its middle; 0: as coarse as will do to find it.
Drawn drawn(const Item&, double pixels = 0);

// The smallest rectangle around it; without end where some of it is not before the eye. None: nothing of it is.
std::optional<Projection::Rectangle> rectangle_around(const Drawn&, const Projection&);

struct Hit {
  ObjectId id;
  Vec3 place;        // of its surface, in the world
  double depth = 0;  // metres before the eye
};
// The nearest thing at a place of the picture. Where there is none, one with an edge within `slack`, in heights of the
// picture: lines and small things want no steady hand.
std::optional<Hit> pick(const Frame&, const Projection&, double x, double y, double slack = 0);
// All things at a place of the picture, the nearest first.
std::vector<Hit> pick_through(const Frame&, const Projection&, double x, double y);
// All that lie in a rectangle wholly, in the order of the frame.
std::vector<ObjectId> pick_within(const Frame&, const Projection&, const Projection::Rectangle&);

}  // namespace betwixt
