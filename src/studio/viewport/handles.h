// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Handles at the selected objects: arrows, rings and boxes along axes, and what a drag of them does.
#pragma once

#include <QPainter>
#include <QPointF>
#include <QPolygonF>
#include <QRectF>
#include <QString>
#include <optional>
#include <string>
#include <vector>

#include "betwixt/pick.h"
#include "studio/viewport/guides.h"
#include "studio/viewport/hand.h"

namespace betwixt::studio {

// The projection of a picture into a widget.
struct Scope {
  Projection projection;
  QRectF box;

  std::optional<QPointF> spot(Vec3 place) const;  // in the widget; nullopt behind the eye
  QPointF in_picture(QPointF) const;              // 0 to 1
  Ray ray(QPointF) const;
  Vec3 place(QPointF, double depth) const;
  double metres(double depth) const;  // of a pixel at this depth
  double depth(Vec3 place) const;
};

enum class Tool { move, turn, scale };
// `all`: in the picture's plane, about the line of sight, or evenly.
enum class Part { none, x, y, z, yz, zx, xy, all };

class Handles {
 public:
  Handles(const Scope&, Tool, Vec3 place, const Vec3 axes[3], double reach);
  Part part_at(QPointF) const;
  void paint(QPainter&, Part hot) const;

 private:
  struct Shape {
    Part part;
    QPolygonF line;
    bool closed = false;  // its inside can be grabbed too
  };
  void add_arrows(const Scope&, Vec3 place, const Vec3 axes[3], double reach);
  void add_rings(const Scope&, Vec3 place, const Vec3 axes[3], double reach);

  Tool tool_;
  QPointF middle_;
  bool seen_ = false;
  std::vector<Shape> shapes_;
};

// A transform in progress, until the user accepts it: by a drag of a handle, or by the mouse and typed numbers.
class Pull {
 public:
  Pull(const Scope&, Tool, Part, Hand, QPointF from, bool own_axes);

  void move_to(QPointF, bool fine, bool snap);
  // Moves the leading object to a place, as far as the part allows it; nullopt: follows the pointer.
  void snap_to(std::optional<Vec3> place) { target_ = place; }
  // While it snaps: goes to multiples of this many metres in the world.
  void snap_to_lines(double metres) { lines_ = metres; }
  // Goes to guides that its place, or a side of the box around what is moved, is near to. Places and numbers come
  // first.
  void snap_to_guides(Guides guides, const Box& around) { guides_ = std::move(guides), around_ = around; }
  std::optional<Vec3> target() const { return tool_ == Tool::move ? target_ : std::nullopt; }
  // Constrains to x, y, z or a plane; the same one again lifts the constraint.
  void constrain(Part);
  void use(Tool);
  // Adds a key to the typed amount, in metres, degrees or as a factor. Returns false if the key is no part of a number.
  bool type(const QString& key);
  bool erase();  // deletes the last typed letter

  std::vector<std::string> lines() const;
  std::string in_words() const;
  Tool tool() const { return tool_; }
  Part part() const { return part_; }
  const Hand& hand() const { return hand_; }
  const Scope& scope() const { return scope_; }
  Vec3 axis(int) const;
  bool is_along(int axis) const;  // whether the part allows this axis

 private:
  std::optional<double> typed() const;
  // The way to go, in metres, and the step to which it is rounded.
  std::pair<Vec3, double> way() const;
  Vec3 way_of_pointer() const;
  std::optional<double> way_to_guide(int axis, double by) const;
  double along(Vec3 axis, QPointF) const;
  double angle() const;
  Vec3 turned_about() const;
  Vec3 factors() const;

  Scope scope_;
  Tool tool_;
  Part part_;
  Hand hand_;
  QPointF from_, last_, at_;
  double turned_ = 0;  // degrees about the middle, whole turns included
  bool own_axes_, snap_ = false;
  std::optional<Vec3> target_;
  double lines_ = 0;  // metres between the lines of the grid to snap to; 0: in steps from where it was
  double step_;       // metres of a pixel
  Guides guides_;
  Box around_;
  QString typed_;
};

}  // namespace betwixt::studio
