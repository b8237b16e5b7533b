// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Projection and picking: maps points of the world to points of a picture and back, and finds the object at a point. A
// point of a picture has coordinates from (0 0) at the top left to (1 1) at the bottom right.
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
  Vec3 from, along;  // `along` has unit length
};

// The projection of a camera, for a picture whose width / height is `aspect`.
class Projection {
 public:
  struct Spot {
    double x = 0, y = 0, depth = 0;  // depth: metres in front of the eye, along the view axis
  };
  struct Rectangle {
    double left = 0, top = 0, right = 0, bottom = 0;
    bool holds(const Rectangle& o) const {
      return left <= o.left && top <= o.top && o.right <= right && o.bottom <= bottom;
    }
  };

  Projection(const Camera&, double aspect);

  // Returns the point of the picture, or std::nullopt if `place` is not in front of the eye.
  std::optional<Spot> spot(Vec3 place) const;
  // Returns the ray through a point of the picture. It starts at the eye (perspective) or at the camera's plane
  // (orthographic).
  Ray ray(double x, double y) const;
  // Returns the point of the world at a point of the picture and a depth.
  Vec3 place(double x, double y, double depth) const;
  // Returns the height of the picture at this depth, in metres.
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
  double sx_, sy_, shift_x_, shift_y_, aspect_;  // as in View
};

// The triangles and edges of an item in the world: three corners for each triangle, two for each edge.
struct Drawn {
  std::vector<Vec3> corners;
  std::shared_ptr<const Mesh> mesh;  // never null
};
// Returns them in the detail that a shape needs if it reaches this many pixels from its centre. 0: the least detail
// that picking allows.
Drawn drawn(const Item&, double pixels = 0);

// Returns the smallest rectangle around the item. The rectangle is unbounded if part of the item is not in front of the
// eye. Returns std::nullopt if no part of it is.
std::optional<Projection::Rectangle> rectangle_around(const Drawn&, const Projection&);

struct Hit {
  ObjectId id;
  Vec3 place;        // a point of its surface, in the world
  double depth = 0;  // metres in front of the eye
};
// Returns the nearest object at a point of the picture. If there is none, returns an object with an edge within the
// distance `slack`, so that thin and small objects are easy to hit. `slack` is in heights of the picture. Returns
// std::nullopt if there is no such object.
std::optional<Hit> pick(const Frame&, const Projection&, double x, double y, double slack = 0);
// Returns all objects at a point of the picture, the nearest first.
std::vector<Hit> pick_through(const Frame&, const Projection&, double x, double y);
// Returns the objects that are wholly inside a rectangle, in the order of the frame.
std::vector<ObjectId> pick_within(const Frame&, const Projection&, const Projection::Rectangle&);

}  // namespace betwixt
