// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/viewport/motion_handles.h"

#include <QLineF>
#include <algorithm>
#include <cmath>

#include "betwixt/language.h"
#include "betwixt/object.h"
#include "betwixt/track.h"
#include "language/values.h"
#include "scene/functions.h"
#include "studio/shell/theme.h"

namespace betwixt::studio {
namespace {

constexpr double grip_pixels = 9, knob = 5;
constexpr int arc_pieces = 48;

Vec3 place_of(const Program& program, ObjectId id, Time t) {
  const Value v = program.read(Target(id, Query::world), t);
  const auto* m = std::get_if<Matrix>(&v);
  return m ? translation_of(**m) : Vec3{};
}

// The transform of the object's parent, or the identity.
Mat4 parent_space(const Program& program, ObjectId id, Time t) {
  for (const AttachmentSpan& a : attachments(program.document(), id))
    if (a.from <= t && t < a.until && a.to.parent && !a.computed) {
      const Value v = program.read(Target(a.to.parent, Query::world), t);
      if (const auto* m = std::get_if<Matrix>(&v)) return **m;
    }
  return {};
}

struct Acting {
  Time from, until;
  Motion motion;
};
std::optional<Acting> acting(const Document& d, ObjectId id, Time t) {
  const std::vector<EventView> all = events(d, Target(id, fn::motion));
  for (std::size_t i = 0; i + 1 < all.size(); ++i) {
    const auto* moves = all[i].value ? std::get_if<Moves>(all[i].value) : nullptr;
    if (moves && !(**moves).factors.empty() && all[i].time <= t && t <= all[i + 1].time)
      return Acting{all[i].time, all[i + 1].time, **moves};
  }
  return std::nullopt;
}

}  // namespace

std::string MotionRow::line(const Motion& m) const { return "at " + time + " " + target + " " + to_string(m) + rest; }

std::optional<MotionRow> motion_row(const Document& d, ObjectId id, Time t) {
  const auto found = acting(d, id, t);
  if (!found) return std::nullopt;
  const Target target(id, fn::motion);
  MotionRow row{d.name(target), format_time(found->from, d) + ".." + format_time(found->until, d), found->motion, {}};
  const std::string rows = write_rows(d, target);
  const std::string begins = "  " + row.time + " ";
  const std::size_t at = rows.find(begins);
  if (at == std::string::npos) return std::nullopt;
  const std::string line = rows.substr(at + begins.size(), rows.find('\n', at) - at - begins.size());
  const std::string said = to_string(found->motion);
  if (!line.starts_with(said)) return std::nullopt;
  row.rest = line.substr(said.size());
  return row;
}

std::optional<MotionHandles> MotionHandles::make(const Program& program, ObjectId id, Time t) {
  const Document& d = program.document();
  const auto row = motion_row(d, id, t);
  const auto found = acting(d, id, t);
  if (!row || !found) return std::nullopt;
  MotionHandles made;
  made.row_ = *row;
  made.space_ = parent_space(program, id, t);
  const auto back = inverse(made.space_);
  if (!back) return std::nullopt;
  made.back_ = *back;
  const auto then = inverse(parent_space(program, id, found->from));
  if (!then) return std::nullopt;
  const auto& factors = found->motion.factors;
  for (const Factor& f : factors) {
    const ObjectId about = f.about.empty() ? ObjectId{} : d.find(f.about);
    made.about_.push_back(about ? transform_point(*then, place_of(program, about, found->from)) : f.centre);
  }
  Vec3 p = transform_point(*then, place_of(program, id, found->from));
  made.from_.resize(factors.size()), made.to_.resize(factors.size());
  for (std::size_t k = factors.size(); k-- > 0;) {
    Factor plain = factors[k];
    plain.centre = made.about_[k], plain.about.clear();
    made.from_[k] = p;
    p = transform_point(at(Motion{{plain}}, 1), p);
    made.to_[k] = p;
  }
  return made;
}

Vec3 MotionHandles::centre(std::size_t k) const { return about_[k]; }

std::optional<Vec3> MotionHandles::place(Part part) const {
  const Factor& f = row_.motion.factors[part.factor];
  if (part.grip == Grip::end) {
    // At its centre, a rotation or scaling has no arm to grab.
    const bool at_centre = f.kind != Factor::Kind::translate && length(from_[part.factor] - centre(part.factor)) < 1e-9;
    return at_centre ? std::nullopt : std::optional(in_world(to_[part.factor]));
  }
  if (f.kind == Factor::Kind::translate || !f.about.empty()) return std::nullopt;
  return in_world(centre(part.factor));
}

std::optional<MotionHandles::Part> MotionHandles::part_at(const Scope& s, QPointF p) const {
  std::optional<Part> found;
  double nearest = grip_pixels;
  for (std::size_t k = 0; k < row_.motion.factors.size(); ++k)
    for (const Grip grip : {Grip::end, Grip::centre}) {
      const auto at = place({k, grip});
      const auto spot = at ? s.spot(*at) : std::nullopt;
      if (!spot || QLineF(*spot, p).length() >= nearest) continue;
      nearest = QLineF(*spot, p).length(), found = Part{k, grip};
    }
  return found;
}

void MotionHandles::paint(QPainter& p, const Scope& s, std::optional<Part> hot) const {
  p.save();
  p.setRenderHint(QPainter::Antialiasing);
  const Colors& colors = picture_colors();
  for (std::size_t k = 0; k < row_.motion.factors.size(); ++k) {
    Factor f = row_.motion.factors[k];
    f.centre = centre(k), f.about.clear();
    QPolygonF way;
    // Of many turns, the last one is enough.
    const double first = std::max(0.0, 1 - 2 * pi / std::max(std::abs(f.angle), 2 * pi));
    for (int i = 0; i <= arc_pieces; ++i) {
      const double t = f.kind == Factor::Kind::rotate ? first + (1 - first) * i / arc_pieces : double(i) / arc_pieces;
      if (const auto spot = s.spot(in_world(transform_point(at(Motion{{f}}, t), from_[k])))) way << *spot;
    }
    const auto middle = s.spot(in_world(centre(k)));
    const auto end = s.spot(in_world(to_[k]));
    const auto line = [&](const QPolygonF& of, const QColor& color, double wide) {
      p.setPen(QPen(QColor(0, 0, 0, 90), wide + 2, Qt::SolidLine, Qt::RoundCap));
      p.drawPolyline(of);
      p.setPen(QPen(color, wide, Qt::SolidLine, Qt::RoundCap));
      p.drawPolyline(of);
    };
    line(way, colors.event, 2);
    if (f.kind != Factor::Kind::translate && middle && end) line(QPolygonF() << *middle << *end, colors.dim, 1);
    const auto dot = [&](QPointF at, Part part) {
      p.setBrush(hot == part ? colors.selected : colors.event);
      p.setPen(QPen(QColor(0, 0, 0, 140), 1));
      part.grip == Grip::centre
          ? p.drawRect(QRectF(at - QPointF(knob - 1, knob - 1), QSizeF(2 * knob - 2, 2 * knob - 2)))
          : p.drawEllipse(at, knob, knob);
    };
    for (const Grip grip : {Grip::centre, Grip::end})
      if (const auto at = place({k, grip}))
        if (const auto spot = s.spot(*at)) dot(*spot, {k, grip});
    if (end) {
      const QString word = QString::fromStdString(to_string(Motion{{row_.motion.factors[k]}}));
      p.setPen(colors.text);
      p.drawText(*end + QPointF(knob + 4, -knob - 2), word.size() > 40 ? word.left(40) + "…" : word);
    }
  }
  p.restore();
}

Vec3 MotionHandles::under(const Scope& s, QPointF p, Vec3 near) const {
  return transform_point(back_, s.place(p, s.depth(in_world(near))));
}

Motion MotionHandles::dragged(const Scope& s, Part part, QPointF to, double turned, bool snap) const {
  Motion out = row_.motion;
  Factor& f = out.factors[part.factor];
  const Vec3 from = from_[part.factor], middle = centre(part.factor);
  const double pixel = s.metres(s.depth(in_world(from))), step = snap ? step_below(50 * pixel) : pixel;
  const auto round_all = [&](Vec3 v) {
    return snap ? Vec3{std::round(v.x / step) * step, std::round(v.y / step) * step, std::round(v.z / step) * step}
                : Vec3{rounded(v.x, step), rounded(v.y, step), rounded(v.z, step)};
  };
  if (part.grip == Grip::centre) {
    f.centre = round_all(under(s, to, middle));
  } else if (f.kind == Factor::Kind::translate) {
    f.by = round_all(under(s, to, to_[part.factor]) - from);
  } else if (f.kind == Factor::Kind::scale) {
    const Vec3 arm = to_[part.factor] - middle, now = under(s, to, to_[part.factor]) - middle;
    const double ratio = dot(now, arm) / std::max(dot(arm, arm), 1e-30);
    const double least = f.law == Factor::Law::linear ? -1e9 : 0.01;
    for (int i = 0; i < 3; ++i) {
      const bool flat = i == 2 && f.by.z == 1 && is_planar(row_.motion);  // a drawing stays flat
      if (!flat)
        f.by[i] = std::max(least, snap ? std::round(f.by[i] * ratio * 10) / 10 : rounded(f.by[i] * ratio, 0.01));
    }
  } else {
    // The pointer's ray meets the plane in which the arm turns.
    const Vec3 axis = normalize(f.axis);
    const Ray ray = s.ray(to);
    const Vec3 eye = transform_point(back_, ray.from), along = transform_point(back_, ray.from + ray.along) - eye;
    const double slope = dot(along, axis);
    if (std::abs(slope) < 1e-6) return out;
    const Vec3 hit = eye + dot(middle - eye, axis) / slope * along - middle;
    const Vec3 arm = from - middle - dot(from - middle, axis) * axis;
    double angle = std::atan2(dot(cross(arm, hit), axis), dot(arm, hit));
    angle += 2 * pi * std::round((turned - angle) / (2 * pi));
    const double degrees = angle * 180 / pi;
    f.angle = (snap ? std::round(degrees / 15) * 15 : std::round(degrees)) * pi / 180, f.angle_rest = 0;
  }
  return out;
}

}  // namespace betwixt::studio
