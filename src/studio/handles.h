// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Handles at what is selected: arrows, rings and boxes along axes, and what is meant by pulling them.
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
#include "studio/hand.h"

namespace betwixt::studio {

// A picture in a widget.
struct Scope {
  Projection projection;
  QRectF box;

  std::optional<QPointF> spot(Vec3 place) const;  // where it is seen
  QPointF in_picture(QPointF) const;              // 0 to 1
  Ray ray(QPointF) const;
  Vec3 place(QPointF, double depth) const;
  double metres(double depth) const;  // that a pixel means there
  double depth(Vec3 place) const;
};

enum class Tool { move, turn, scale };
// `all`: in the picture's plane, about the line of sight, evenly.
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
    bool closed = false;  // its inside counts too
  };
  void add_arrows(const Scope&, Vec3 place, const Vec3 axes[3], double reach);
  void add_rings(const Scope&, Vec3 place, const Vec3 axes[3], double reach);

  Tool tool_;
  QPointF middle_;
  bool seen_ = false;
  std::vector<Shape> shapes_;
};

// What is being done with a hand, until it is let go: by pulling, or by moving about and typing.
class Pull {
 public:
  Pull(const Scope&, Tool, Part, Hand, QPointF from, bool own_axes);

  void move_to(QPointF, bool fine, bool snap);
  // x, y, z and planes; the same one again: all.
  void constrain(Part);
  void use(Tool);
  // A number that says how much, in metres, degrees or times. False: it is no key of one.
  bool type(const QString& key);
  bool erase();  // the last of what was typed

  std::vector<std::string> lines() const;
  std::string in_words() const;
  Tool tool() const { return tool_; }
  Part part() const { return part_; }
  const Hand& hand() const { return hand_; }
  const Scope& scope() const { return scope_; }
  Vec3 axis(int) const;
  bool is_along(int axis) const;  // whether the part lets it go along (or about) that axis alone, or a plane with it

 private:
  std::optional<double> typed() const;
  Vec3 way() const;
  double along(Vec3 axis, QPointF) const;
  double angle() const;
  Vec3 turned_about() const;
  Vec3 factors() const;

  Scope scope_;
  Tool tool_;
  Part part_;
  Hand hand_;
  QPointF from_, last_, at_;
  double turned_ = 0;  // degrees about the middle, whole turns counted
  bool own_axes_, snap_ = false;
  double step_;  // metres of a pixel
  QString typed_;
};

}  // namespace betwixt::studio
