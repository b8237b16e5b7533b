// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Moves, rotates and scales objects by script lines: `at 24f ball.position (1 2 3)` if the track has events, otherwise
// `set ball.position (1 2 3)`.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scene/axes.h"
#include "studio/shell/workspace.h"

namespace betwixt::studio {

// Rounds to as many decimals as the step has: (1.23456, 0.02) is 1.23.
double rounded(double v, double step);
// Returns the largest of 1, 2 or 5 times a power of ten that is at most the argument.
double step_below(double at_most);
// Returns the three angles of an orientation that are nearest to `angles`, whole turns included.
Vec3 angles_near(Quat, Vec3 angles);

// Returns a value of a rotation, three angles or a quaternion, as a quaternion of unit length.
Quat orientation_of(const Value&);
// Returns a value as a line writes it for this target.
std::string value_words(const Document&, const Target&, const Value&);

// Returns the line that gives a target a value now: an event if the track has events or `make_event` is set. The other
// parts of an existing event stay.
std::string line_for(const Document&, const Target&, const Value&, Time, bool make_event);

// Returns the lines that give an object a world transform: they set its position and rotation, and clear its look-at.
std::vector<std::string> lines_to_bring(const Program&, ObjectId, const Mat4& world, Time, double step, bool always);

class Hand {
 public:
  // Grabs objects at a time. An object that hangs on another grabbed one moves with it, and is not moved twice.
  // `always`: each change becomes an event.
  Hand(const Program&, Time, const std::vector<ObjectId>&, bool always);

  bool empty() const { return held_.empty(); }
  Vec3 place() const { return place_; }       // of the leading object, in the world
  const Vec3* axes() const { return axes_; }  // the leading object's axes, of unit length
  // Returns why some object cannot be moved (position), rotated (rotation) or scaled (scale). Returns "" if all can.
  std::string refusal(std::uint16_t function) const;

  // `step`: metres of a pixel; it sets how the numbers are rounded.
  std::vector<std::string> move(Vec3 by, double step) const;
  // Rotates about place().
  std::vector<std::string> turn(Vec3 axis, double angle, double step) const;
  // Gives each object an orientation in the world.
  std::vector<std::string> turn_to(Quat world) const;
  // Scales along the objects' own axes. If the three factors are equal the objects also move away from place().
  std::vector<std::string> scale(Vec3 factors, double step) const;

 private:
  struct Held {
    ObjectId id;
    Vec3 position, scale{1, 1, 1};
    Value rotation;
    Vec3 place;                     // in the world
    Mat4 back;                      // the linear part of the transform from the world to the position's space
    std::optional<AxesSpace> axes;  // its position is numbers of these
    Quat parent;                    // the parents' rotation
    bool still[3];                  // position, rotation, scale: computed by code, so fixed
    bool aims = false;              // has a look-at target
  };
  void take(ObjectId);
  void put_position(const Held&, Vec3 by, double step, std::vector<std::string>& lines) const;
  void put_rotation(const Held&, Quat to, std::optional<std::pair<Vec3, double>> way,
                    std::vector<std::string>& lines) const;
  void put(const Held&, std::uint16_t function, const Vec3& before, const Vec3& after, double least,
           std::vector<std::string>& lines) const;

  Program program_;
  Time time_;
  bool always_, derived_ = false;
  std::vector<Held> held_;
  Vec3 place_, axes_[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
};

}  // namespace betwixt::studio
