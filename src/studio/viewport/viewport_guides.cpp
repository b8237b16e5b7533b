// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Guides of the user, and the rulers out of which they are dragged: the upper one gives lines across, the left one
// upright lines.
#include <QInputDialog>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "language/values.h"
#include "studio/shell/theme.h"
#include "studio/viewport/viewport.h"

namespace betwixt::studio {
namespace {

constexpr double guide_slack = 4;    // pixels beside a guide
constexpr double label_pixels = 60;  // least distance of two numbers

}  // namespace

std::optional<std::pair<int, int>> Viewport::guided_axes() const {
  return switches_.guides && !plain_ ? axes_of(scope().projection) : std::nullopt;
}

double Viewport::ruler() const { return guided_axes() ? std::ceil(fontMetrics().height() * 1.1) : 0; }

double Viewport::place_on(int axis, QPointF p) const { return scope().place(p, 1)[axis]; }

double Viewport::spot_on(int axis, double place) const {
  const Scope s = scope();
  Vec3 at = s.projection.place(0.5, 0.5, 1);
  at[axis] = place;
  const QPointF spot = s.spot(at).value_or(QPointF());
  return axis == guided_axes()->first ? spot.x() : spot.y();
}

Guides Viewport::shown_guides() const {
  Guides all;
  if (const auto axes = guided_axes())
    for (const Guide& g : switches_.own_guides)
      if (g.axis == axes->first || g.axis == axes->second) all.push_back(g);
  return all;
}

// Returns the guide under the pointer. Over an object only the guide's mark in the ruler counts, so that guides are not
// in the way of what lies on them.
std::optional<Guide> Viewport::guide_at(QPointF p) const {
  const Guides all = shown_guides();
  if (all.empty()) return std::nullopt;
  const double edge = ruler();
  for (const Guide& g : all) {
    const bool upright = g.axis == guided_axes()->first;
    if (std::abs((upright ? p.x() : p.y()) - spot_on(g.axis, g.at)) > guide_slack) continue;
    if ((upright ? p.y() : p.x()) < edge || !hit(p)) return g;
  }
  return std::nullopt;
}

bool Viewport::take_guide(QPointF p) {
  const auto axes = guided_axes();
  if (!axes) return false;
  if (const auto h = handles(); h && h->part_at(p) != Part::none) return false;
  const double edge = ruler();
  if (const auto g = guide_at(p)) {
    guide_drag_ = GuideDrag{with_or_without(switches_.own_guides, *g), g, g->axis, g};
  } else if (p.x() < edge || p.y() < edge) {
    guide_drag_ = GuideDrag{switches_.own_guides, {}, p.y() < edge ? axes->second : axes->first, {}};
  } else {
    return false;
  }
  gesture_ = Gesture::guide;
  return true;
}

// With Ctrl it goes to the lines of the grid.
void Viewport::drag_guide(QPointF p, Qt::KeyboardModifiers modifiers) {
  const bool inside = rect().contains(p.toPoint()) && p.x() >= ruler() && p.y() >= ruler();
  const bool along_ruler = guide_drag_->first && QLineF(from_, p).length() < guide_slack;  // a click on its mark
  const Scope s = scope();
  const double step = modifiers & Qt::ControlModifier ? grid_step(s) : step_below(s.metres(1) * 2);
  const bool upright = guide_drag_->axis == guided_axes()->first;
  // Along the ruler that crosses it, a guide moves; it goes away at its own ruler and outside.
  const bool gone = guide_drag_->first ? !rect().contains(p.toPoint()) || (upright ? p.x() : p.y()) < ruler() : !inside;
  guide_drag_->now = along_ruler ? guide_drag_->first
                     : gone      ? std::nullopt
                            : std::optional(Guide{guide_drag_->axis, rounded(place_on(guide_drag_->axis, p), step)});
  Guides all = guide_drag_->others;
  if (guide_drag_->now && std::find(all.begin(), all.end(), *guide_drag_->now) == all.end())
    all.push_back(*guide_drag_->now);
  set_guides(std::move(all));
}

void Viewport::end_guide(bool carry_out) {
  if (!guide_drag_) return;
  const GuideDrag drag = *std::exchange(guide_drag_, std::nullopt);
  gesture_ = Gesture::none;
  Guides all = drag.others;
  const auto last = carry_out ? drag.now : drag.first;
  if (last && std::find(all.begin(), all.end(), *last) == all.end()) all.push_back(*last);
  set_guides(std::move(all));
  unsetCursor();
}

void Viewport::show_cursor_of_guide(QPointF p) {
  const auto g = guide_at(p);
  if (g)
    setCursor(g->axis == guided_axes()->first ? Qt::SplitHCursor : Qt::SplitVCursor);
  else if (cursor().shape() == Qt::SplitHCursor || cursor().shape() == Qt::SplitVCursor)
    unsetCursor();
}

void Viewport::set_guides(Guides all) {
  ViewportSwitches s = switches_;
  s.own_guides = std::move(all);
  set_switches(s);
}

void Viewport::guide_selection() {
  const auto axes = axes_of(scope().projection);
  if (!axes || workspace_.selected().empty() || grip().empty()) {
    refusal_ = !axes ? tr("guides need a view along an axis without perspective: press 1, 3 or 7, and then 5")
                     : tr("select the object through which the guides should go");
    return update();
  }
  ViewportSwitches s = switches_;
  Guides there;
  for (const int axis : {axes->first, axes->second}) there.push_back({axis, rounded(grip().place()[axis], 1e-6)});
  const bool all_there = s.guides && std::all_of(there.begin(), there.end(), [&](const Guide& g) {
                           return std::find(s.own_guides.begin(), s.own_guides.end(), g) != s.own_guides.end();
                         });
  for (const Guide& g : there) {
    std::erase(s.own_guides, g);
    if (!all_there) s.own_guides.push_back(g);
  }
  s.guides = true;
  set_switches(s);
}

void Viewport::ask_guide() {
  bool good = false;
  const QString words =
      QInputDialog::getText(this, tr("Guide at…"), tr("Axis and metres. The same guide once more goes away."),
                            QLineEdit::Normal, "x 0", &good);
  if (!good) return;
  const auto g = guide_of(words);
  if (!g) {
    refusal_ = tr("a guide is an axis and a number, for example x 2.5");
    return update();
  }
  ViewportSwitches s = switches_;
  s.own_guides = with_or_without(s.own_guides, *g), s.guides = true;
  set_switches(s);
}

void Viewport::paint_own_guides(QPainter& p) const {
  const auto axes = guided_axes();
  if (!axes) return;
  p.save();
  p.setRenderHint(QPainter::Antialiasing, false);
  const Guides all = shown_guides();
  for (const bool shade : {true, false}) {
    p.setPen(QPen(shade ? QColor(0, 0, 0, 110) : picture_colors().accent, shade ? 3 : 1));
    for (const Guide& g : all) {
      const double at = spot_on(g.axis, g.at);
      g.axis == axes->first ? p.drawLine(QPointF(at, 0), QPointF(at, height()))
                            : p.drawLine(QPointF(0, at), QPointF(width(), at));
    }
  }
  paint_ruler(p, true), paint_ruler(p, false);
  p.restore();
}

// Paints metres at the upper or left edge, and marks of guides, by which they can be taken too.
void Viewport::paint_ruler(QPainter& p, bool across) const {
  const auto [right, up] = *guided_axes();
  const int axis = across ? right : up;
  const double edge = ruler(), length = across ? width() : height();
  p.save();
  if (!across) p.translate(0, height()), p.rotate(-90);
  const auto spot = [&](double place) { return across ? spot_on(axis, place) : length - spot_on(axis, place); };
  p.fillRect(QRectF(0, 0, length, edge), faint(colors().raised, 0.9f));
  QFont small = font();
  small.setPointSizeF(small.pointSizeF() * 0.75);
  p.setFont(small);
  const double step = 10 * step_below(scope().metres(1) * label_pixels / 5);
  const double a = place_on(axis, {0, 0}), b = place_on(axis, {width() - 1.0, height() - 1.0});
  const double first = std::ceil(std::min(a, b) / step * 10), last = std::floor(std::max(a, b) / step * 10);
  for (double k = first; k <= last && last - first < 2000; ++k) {
    const double x = spot(k * step / 10);
    const bool tall = std::fmod(k, 10) == 0;
    p.setPen(tall ? colors().text : colors().dim);
    p.drawLine(QPointF(x, edge * (tall ? 0.2 : 0.75)), QPointF(x, edge));
    if (tall)
      p.drawText(QRectF(x + 3, 0, 10 * label_pixels, edge * 0.8), Qt::AlignVCenter,
                 QString::fromStdString(write_number(rounded(k * step / 10, step / 10))));
  }
  p.setPen(Qt::NoPen), p.setBrush(picture_colors().accent);
  for (const Guide& g : shown_guides())
    if (g.axis == axis) {
      const double x = spot(g.at);
      p.drawPolygon(QPolygonF{{QPointF(x - 4, edge * 0.4), QPointF(x + 4, edge * 0.4), QPointF(x, edge)}});
    }
  p.restore();
}

}  // namespace betwixt::studio
