// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/viewport/handles.h"

#include <QLineF>
#include <QPainterPath>
#include <cmath>

#include "studio/shell/theme.h"

namespace betwixt::studio {
namespace {

constexpr double grip = 7;  // pixels around a handle in which it can be grabbed
constexpr double fineness = 0.1;
constexpr double snap_angle = 15;
constexpr double guide_reach = 8;   // pixels
constexpr double exact = 1e-6;      // metres
constexpr double snap_pixels = 20;  // snap steps are at least this large

constexpr Part axes_parts[] = {Part::x, Part::y, Part::z}, planes[] = {Part::yz, Part::zx, Part::xy};

int axis_of(Part p) { return p == Part::x || p == Part::yz ? 0 : p == Part::y || p == Part::zx ? 1 : 2; }
bool is_axis(Part p) { return p == Part::x || p == Part::y || p == Part::z; }
bool is_plane(Part p) { return p == Part::yz || p == Part::zx || p == Part::xy; }

QColor color_of(Part p) {
  const Colors& c = picture_colors();
  if (p == Part::all) return c.text;
  return axis_of(p) == 0 ? c.x : axis_of(p) == 1 ? c.y : c.z;
}

double length(QPointF p) { return std::hypot(p.x(), p.y()); }

double distance(const QPolygonF& line, QPointF p) {
  double nearest = 1e9;
  for (int i = 0; i + 1 < line.size(); ++i) {
    const QPointF d = line[i + 1] - line[i];
    const double l = QPointF::dotProduct(d, d);
    const double s = l > 0 ? std::clamp(QPointF::dotProduct(p - line[i], d) / l, 0.0, 1.0) : 0;
    nearest = std::min(nearest, length(p - line[i] - s * d));
  }
  return nearest;
}

// Returns two directions perpendicular to an axis.
std::pair<Vec3, Vec3> across(Vec3 axis) {
  const Vec3 one = normalize(cross(axis, std::abs(axis.y) < 0.9 ? Vec3{0, 1, 0} : Vec3{1, 0, 0}));
  return {one, cross(axis, one)};
}

}  // namespace

std::optional<QPointF> Scope::spot(Vec3 place) const {
  const auto s = projection.spot(place);
  if (!s) return std::nullopt;
  return QPointF(box.left() + s->x * box.width(), box.top() + s->y * box.height());
}
QPointF Scope::in_picture(QPointF p) const {
  return {(p.x() - box.left()) / box.width(), (p.y() - box.top()) / box.height()};
}
Ray Scope::ray(QPointF p) const {
  const QPointF at = in_picture(p);
  return projection.ray(at.x(), at.y());
}
Vec3 Scope::place(QPointF p, double depth) const {
  const QPointF at = in_picture(p);
  return projection.place(at.x(), at.y(), depth);
}
double Scope::metres(double depth) const { return projection.height(depth) / std::max(1.0, box.height()); }
double Scope::depth(Vec3 place) const { return dot(place - projection.eye(), projection.forward()); }

// ---- Handles

Handles::Handles(const Scope& s, Tool tool, Vec3 place, const Vec3 axes[3], double reach) : tool_(tool) {
  const auto middle = s.spot(place);
  if (!middle) return;
  middle_ = *middle, seen_ = true;
  const double metres = s.metres(s.depth(place)) * reach;
  tool == Tool::turn ? add_rings(s, place, axes, metres) : add_arrows(s, place, axes, metres);
}

void Handles::add_arrows(const Scope& s, Vec3 place, const Vec3 axes[3], double reach) {
  if (tool_ == Tool::move)
    for (int i = 0; i < 3; ++i) {
      const Vec3 a = axes[(i + 1) % 3], b = axes[(i + 2) % 3];
      if (std::abs(dot(axes[i], normalize(place - s.projection.eye()))) < 0.25 && !s.projection.orthographic())
        continue;
      if (std::abs(dot(axes[i], s.projection.forward())) < 0.25) continue;  // seen from its edge
      Shape square{planes[i], {}, true};
      for (const auto& [u, v] : {std::pair(0.3, 0.3), {0.5, 0.3}, {0.5, 0.5}, {0.3, 0.5}, {0.3, 0.3}})
        if (const auto spot = s.spot(place + reach * (u * a + v * b))) square.line << *spot;
      if (square.line.size() == 5) shapes_.push_back(std::move(square));
    }
  for (int i = 0; i < 3; ++i) {
    const auto end = s.spot(place + reach * axes[i]);
    if (!end || length(*end - middle_) < 2 * grip) continue;  // seen from its end
    shapes_.push_back({axes_parts[i], QPolygonF() << middle_ + 0.18 * (*end - middle_) << *end, false});
  }
  shapes_.push_back({Part::all, QPolygonF(QRectF(middle_ - QPointF(grip, grip), QSizeF(2 * grip, 2 * grip))), true});
}

void Handles::add_rings(const Scope& s, Vec3 place, const Vec3 axes[3], double reach) {
  constexpr int corners = 64;
  for (int i = 0; i < 3; ++i) {
    // An orthographic view draws a ring seen from its edge as a line: leave it out.
    if (s.projection.orthographic() && std::abs(dot(axes[i], s.projection.forward())) < 1e-6) continue;
    const auto [u, v] = across(axes[i]);
    const bool whole = std::abs(dot(axes[i], s.projection.forward())) > 0.98;
    QPolygonF arc;
    const auto finish = [&] {
      if (arc.size() > 1) shapes_.push_back({axes_parts[i], arc, false});
      arc.clear();
    };
    for (int k = 0; k <= corners; ++k) {
      const double angle = 2 * pi * k / corners;
      const Vec3 out = std::cos(angle) * u + std::sin(angle) * v;
      const auto spot = s.spot(place + reach * out);
      // The far half of a ring is left out, so that it hides nothing.
      if (!spot || (!whole && dot(out, s.projection.forward()) > 0.05))
        finish();
      else
        arc << *spot;
    }
    finish();
  }
  QPolygonF ring;
  const double radius = reach / s.metres(s.depth(place)) * 1.18;
  for (int k = 0; k <= corners; ++k)
    ring << middle_ + radius * QPointF(std::cos(2 * pi * k / corners), std::sin(2 * pi * k / corners));
  shapes_.push_back({Part::all, ring, false});
}

Part Handles::part_at(QPointF p) const {
  Part part = Part::none;
  double nearest = grip;
  for (const Shape& s : shapes_) {
    if (s.closed && s.line.containsPoint(p, Qt::OddEvenFill)) return s.part;
    const double d = distance(s.line, p);
    if (d < nearest) nearest = d, part = s.part;
  }
  return part;
}

void Handles::paint(QPainter& p, Part hot) const {
  if (!seen_) return;
  p.save();
  p.setRenderHint(QPainter::Antialiasing);
  for (const Shape& s : shapes_) {
    QColor color = color_of(s.part);
    if (s.part == hot) color = picture_colors().event;
    // A dark line below the bright one makes it visible on any picture.
    p.setPen(QPen(QColor(0, 0, 0, 90), s.part == hot ? 6 : 4.5, Qt::SolidLine, Qt::RoundCap));
    p.setBrush(Qt::NoBrush);
    if (!s.closed) p.drawPolyline(s.line);
    p.setPen(QPen(color, s.part == hot ? 3.5 : 2.25, Qt::SolidLine, Qt::RoundCap));
    if (s.closed) {
      QColor inside = color;
      inside.setAlpha(s.part == hot ? 150 : s.part == Part::all ? 40 : 80);
      p.setBrush(inside);
      p.setPen(QPen(color, 1.25));
      s.part == Part::all ? p.drawEllipse(s.line.boundingRect()) : p.drawPolygon(s.line);
      continue;
    }
    p.drawPolyline(s.line);
    if (tool_ == Tool::turn) continue;
    const QPointF end = s.line.last(), way = (end - s.line.first()) / length(end - s.line.first());
    const QPointF side(-way.y(), way.x());
    p.setBrush(color), p.setPen(QPen(QColor(0, 0, 0, 90), 1));
    if (tool_ == Tool::move)
      p.drawPolygon(QPolygonF() << end + 9 * way << end - 4 * way + 5.5 * side << end - 4 * way - 5.5 * side);
    else
      p.drawRect(QRectF(end - QPointF(5, 5), QSizeF(10, 10)));
  }
  p.restore();
}

// ---- Dragging handles

Pull::Pull(const Scope& s, Tool tool, Part part, Hand hand, QPointF from, bool own_axes)
    : scope_(s),
      tool_(tool),
      part_(part),
      hand_(std::move(hand)),
      from_(from),
      last_(from),
      at_(from),
      own_axes_(own_axes) {
  step_ = scope_.metres(scope_.depth(hand_.place()));
}

// Scaling always uses the object's own axes.
Vec3 Pull::axis(int i) const {
  if (own_axes_ || tool_ == Tool::scale) return hand_.axes()[i];
  Vec3 a{};
  a[i] = 1;
  return a;
}

bool Pull::is_along(int i) const {
  return is_axis(part_) ? axis_of(part_) == i : is_plane(part_) && axis_of(part_) != i;
}

void Pull::move_to(QPointF p, bool fine, bool snap) {
  snap_ = snap;
  const auto middle = scope_.spot(hand_.place());
  const QPointF before = at_;
  at_ += (fine ? fineness : 1) * (p - last_);
  last_ = p;
  if (!middle) return;
  const QPointF a = before - *middle, b = at_ - *middle;
  // Anticlockwise on the screen, where y points down.
  const double by = std::atan2(-(a.x() * b.y() - a.y() * b.x()), QPointF::dotProduct(a, b));
  turned_ += by * 180 / pi;
}

void Pull::constrain(Part p) { part_ = part_ == p ? Part::all : p; }

void Pull::use(Tool t) { tool_ = t, from_ = at_ = last_, turned_ = 0, typed_.clear(); }

bool Pull::type(const QString& key) {
  if (key.size() != 1) return false;
  const QChar c = key[0];
  if (c == '-')
    typed_ = typed_.startsWith('-') ? typed_.mid(1) : "-" + typed_;
  else if (c.isDigit() || (c == '.' && !typed_.contains('.')))
    typed_ += c;
  else
    return false;
  return true;
}

bool Pull::erase() {
  if (typed_.isEmpty()) return false;
  typed_.chop(1);
  return true;
}

std::optional<double> Pull::typed() const {
  bool good = false;
  const double v = typed_.toDouble(&good);
  return good ? std::optional(v) : std::nullopt;
}

// Returns the distance along an axis, from the hand's place to the point nearest to the pointer's ray.
double Pull::along(Vec3 axis, QPointF p) const {
  const Ray ray = scope_.ray(p);
  const Vec3 from = hand_.place() - ray.from;
  const double b = dot(axis, ray.along), c = 1 - b * b;
  if (c < 1e-4) return 0;  // the axis points at the eye
  return (b * dot(ray.along, from) - dot(axis, from)) / c;
}

Vec3 Pull::way_of_pointer() const {
  if (target_ && !typed()) {
    const Vec3 by = *target_ - hand_.place();
    if (!is_axis(part_) && !is_plane(part_)) return by;
    const Vec3 a = axis(axis_of(part_)), along = dot(by, a) * a;
    return is_axis(part_) ? along : by - along;
  }
  const double depth = scope_.depth(hand_.place());
  const double grid = step_below(snap_pixels * step_ * 2.5);
  const auto snapped = [&](double v) { return snap_ ? std::round(v / grid) * grid : v; };
  if (is_axis(part_) && snap_ && lines_ > 0 && !typed() && !own_axes_) {
    const int i = axis_of(part_);
    const double free = along(axis(i), at_) - along(axis(i), from_);
    return (std::round((hand_.place()[i] + free) / lines_) * lines_ - hand_.place()[i]) * axis(i);
  }
  if (is_axis(part_) || typed()) {
    const Vec3 a = axis(is_axis(part_) ? axis_of(part_) : is_plane(part_) ? (axis_of(part_) + 1) % 3 : 0);
    return typed().value_or(snapped(along(a, at_) - along(a, from_))) * a;
  }
  Vec3 by = scope_.place(at_, depth) - scope_.place(from_, depth);
  if (is_plane(part_)) {
    const Vec3 n = axis(axis_of(part_));
    const auto meet = [&](QPointF p) -> std::optional<Vec3> {
      const Ray r = scope_.ray(p);
      const double slope = dot(r.along, n);
      if (std::abs(slope) < 1e-3) return std::nullopt;
      const double t = dot(hand_.place() - r.from, n) / slope;
      return t >= 0 ? std::optional(r.from + t * r.along) : std::nullopt;
    };
    const auto a = meet(from_), b = meet(at_);
    by = a && b ? *b - *a : by - dot(by, n) * n;
  }
  if (!snap_) return by;
  if (lines_ > 0) {
    for (int i = 0; i < 3; ++i)
      if (part_ == Part::all || is_along(i))
        by[i] = std::abs(by[i]) < 1e-9 ? by[i]
                                       : std::round((hand_.place()[i] + by[i]) / lines_) * lines_ - hand_.place()[i];
    return by;
  }
  Vec3 out{};
  for (int i = 0; i < 3; ++i) out = out + snapped(dot(by, axis(i))) * axis(i);
  return out;
}

// Returns how far to go so that the place or a side of the box lies on the nearest guide within reach.
std::optional<double> Pull::way_to_guide(int axis, double by) const {
  const double from = hand_.place()[axis];
  std::optional<double> found;
  double nearest = guide_reach * step_;
  for (const Guide& g : guides_)
    for (const double side :
         {from, around_.empty() ? from : around_.low[axis], around_.empty() ? from : around_.high[axis]})
      if (const double away = std::abs(side + by - g.at); g.axis == axis && away < nearest)
        nearest = away, found = g.at - side;
  return found;
}

std::pair<Vec3, double> Pull::way() const {
  Vec3 by = way_of_pointer();
  if (typed() || target_) return {by, exact};
  if (own_axes_ && is_axis(part_)) return {by, step_};
  bool guided = false;
  Vec3 to = by;
  for (int i = 0; i < 3; ++i) {
    if (part_ != Part::all && !is_along(i)) continue;
    const auto there = way_to_guide(i, by[i]);
    guided = guided || there;
    if (there || std::abs(by[i]) > 1e-9)
      to[i] = there.value_or(rounded(hand_.place()[i] + by[i], step_) - hand_.place()[i]);
  }
  return guided ? std::pair(to, exact) : std::pair(by, step_);
}

Vec3 Pull::turned_about() const { return is_axis(part_) ? axis(axis_of(part_)) : -scope_.projection.forward(); }

double Pull::angle() const {
  if (const auto t = typed()) return *t;
  const Vec3 a = turned_about(), to_eye = -scope_.projection.forward();
  const double facing = dot(a, to_eye);
  double degrees = facing < 0 ? -turned_ : turned_;
  if (std::abs(facing) < 0.3) {  // a ring seen from its edge follows the pointer along its line
    const Vec3 way = normalize(cross(a, to_eye));
    const auto middle = scope_.spot(hand_.place()), end = scope_.spot(hand_.place() + 10 * step_ * way);
    if (middle && end && length(*end - *middle) > 0)
      degrees = QPointF::dotProduct(at_ - from_, *end - *middle) / length(*end - *middle);
  }
  return snap_ ? std::round(degrees / snap_angle) * snap_angle : degrees;
}

Vec3 Pull::factors() const {
  double factor = 1;
  if (const auto t = typed()) {
    factor = *t;
  } else {
    const auto middle = scope_.spot(hand_.place());
    if (!middle) return {1, 1, 1};
    if (is_axis(part_)) {
      const double first = along(axis(axis_of(part_)), from_);
      if (std::abs(first) > 2 * step_) factor = along(axis(axis_of(part_)), at_) / first;
    } else if (length(from_ - *middle) > 2 * grip) {
      factor = length(at_ - *middle) / length(from_ - *middle);
    } else {  // from the middle: right and up enlarge
      factor = std::exp(((at_ - from_).x() - (at_ - from_).y()) / 100);
    }
    if (snap_) factor = std::round(factor * 10) / 10;
  }
  factor = rounded(factor, 0.001);
  if (part_ == Part::all || part_ == Part::none) return {factor, factor, factor};
  Vec3 out{1, 1, 1};
  for (int i = 0; i < 3; ++i)
    if ((i == axis_of(part_)) == is_axis(part_)) out[i] = factor;
  return out;
}

std::vector<std::string> Pull::lines() const {
  if (tool_ == Tool::move) return std::apply([&](Vec3 by, double step) { return hand_.move(by, step); }, way());
  if (tool_ == Tool::turn) return hand_.turn(turned_about(), angle() * pi / 180, step_);
  return hand_.scale(factors(), step_);
}

std::string Pull::in_words() const {
  const char* names[] = {"", " x", " y", " z", " y and z", " z and x", " x and y", ""};
  const std::string on = names[static_cast<int>(part_)];
  const auto number = [](double v, double step) { return QString::number(rounded(v, step)).toStdString(); };
  if (tool_ == Tool::turn) return "turn" + (is_axis(part_) ? " about" + on : "") + ": " + number(angle(), 0.1) + "°";
  if (tool_ == Tool::scale) {
    const Vec3 f = factors();
    const int shown = is_axis(part_) ? axis_of(part_) : is_plane(part_) ? (axis_of(part_) + 1) % 3 : 0;
    return "scale" + on + ": × " + number(f[shown], 0.001);
  }
  const auto [w, step] = way();
  if (is_axis(part_)) return "move" + on + ": " + number(dot(w, axis(axis_of(part_))), step) + " m";
  return "move" + on + ": (" + number(w.x, step) + " " + number(w.y, step) + " " + number(w.z, step) + ") m";
}

}  // namespace betwixt::studio
