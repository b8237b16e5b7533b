// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Things in a hand that moves, turns and scales them, as lines of the language: `at 24f ball.position (1 2 3)` where
// there are events, else `set ball.position (1 2 3)`.
#pragma once

#include <string>
#include <vector>

#include "studio/desk.h"

namespace betwixt::studio {

// To as many decimals as the step has any meaning for: (1.23456, 0.02) is 1.23.
double rounded(double v, double step);
// 1, 2 or 5 times a power of ten, the largest that is not above.
double step_below(double at_most);
// The three angles of an orientation that are nearest to others, whole turns included.
Vec3 angles_near(Quat, Vec3 angles);

// The line that gives a target a value now: a row where it has events, or where there shall be one; what an event that
// is there says beside its value stays.
std::string line_for(const Document&, const Target&, const Value&, Time, bool make_event);

// The lines that bring an object to a place of the world, turned so: its position and its rotation, and that it looks
// at nothing.
std::vector<std::string> lines_to_bring(const Program&, ObjectId, const Mat4& world, Time, double step, bool always);

class Hand {
 public:
  // Takes hold at a time. What hangs on others that are held goes along by itself, and is not moved twice. `always`:
  // all that changes becomes an event.
  Hand(const Program&, Time, const std::vector<ObjectId>&, bool always);

  bool empty() const { return held_.empty(); }
  Vec3 place() const { return place_; }       // of the one that leads, in the world
  const Vec3* axes() const { return axes_; }  // its own, of unit length
  // Why some of it cannot be moved (position), turned (rotation), scaled (scale); empty: all of it can.
  std::string refusal(std::uint16_t function) const;

  // `step`: what a pixel means, in metres; numbers are as tidy.
  std::vector<std::string> move(Vec3 by, double step) const;
  // About the place.
  std::vector<std::string> turn(Vec3 axis, double angle, double step) const;
  // Each to an orientation in the world.
  std::vector<std::string> turn_to(Quat world) const;
  // Along their own axes; where all three are the same they go away from the place, too.
  std::vector<std::string> scale(Vec3 factors, double step) const;

 private:
  struct Held {
    ObjectId id;
    Vec3 position, scale{1, 1, 1};
    Value rotation;
    Vec3 place;         // in the world
    Mat4 back;          // the linear part of what takes the world to its position's space
    Quat parent;        // what turns it from outside
    bool still[3];      // position, rotation, scale: code says what they are
    bool aims = false;  // it looks at something
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
