// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Painting of the dope sheet. The work is bounded by the number of pixels, however long the tracks are.
#include <QPainter>
#include <QScrollBar>
#include <algorithm>
#include <cmath>

#include "scene/document.h"
#include "studio/shell/keys.h"
#include "studio/shell/theme.h"
#include "studio/timeline/sheet_pane.h"

namespace betwixt::studio {
namespace {

// Returns whether a value stays constant between two equal events, at three samples.
bool stays_between(const Program& program, const Target& t, Time a, Time b) {
  const std::vector<double> at_first = numbers(program.read(t, a));
  for (const int part : {1, 2, 3})
    if (numbers(program.read(t, a + Time{(b - a).flicks / 4 * part})) != at_first) return false;
  return true;
}

QColor color_of(Type type) {
  const Colors& c = colors();
  switch (type) {
    case Type::vector:
    case Type::pair:
      return c.event;
    case Type::rotation:
    case Type::orientation:
    case Type::angle:
      return c.z;
    case Type::scalar:
      return c.accent;
    case Type::color:
      return c.x;
    case Type::boolean:
      return c.note;
    case Type::attachment:
    case Type::motion:
      return c.cut;
    default:
      return c.dim;
  }
}

void diamond(QPainter& p, double x, double y, double r) {
  const QPointF points[] = {{x - r, y}, {x, y - r}, {x + r, y}, {x, y + r}};
  p.drawConvexPolygon(points, 4);
}

// A group of events so close that they share one sign.
struct Mark {
  double from, to;
  Time first, last;
};

}  // namespace

void SheetPane::paint_track(QPainter& p, const Target& target, double y, bool whole) const {
  const Document& d = workspace_.document();
  const Colors& c = colors();
  const Type type = spec_of(d.scene(), target.function).type;
  const QColor color = whole ? c.dim : color_of(type);
  const double r = whole ? half() * 0.75 : half();
  const Time left = time_at(axis_.gutter() - 2 * r), right = time_at(width() + 2 * r);
  std::vector<Mark> marks;
  for (auto e = next_event(d, target, left); e && *e <= right;) {
    const double x = x_of(*e);
    if (!marks.empty() && x - marks.back().to < r)
      marks.back().to = x, marks.back().last = *e;
    else
      marks.push_back({x, x, *e, *e});
    e = next_event(d, target, std::max(*e + Time{1}, time_at(std::floor(x) + 1)));
  }
  const auto view = betwixt::track(d, target);
  const bool steps = view && (view->twerper == "hold" || (view->twerper.empty() && view->default_twerper == "hold"));
  // Paints a segment between events: a bar if the value holds, a line if it changes.
  const auto way = [&](double from, double to, Time at) {
    bool holds = steps, releases = false;
    const Value *value = nullptr, *comes = nullptr;
    each_event(d, target, at, at, [&](const EventView& e) {
      holds = e.twerper == "hold" || (steps && e.twerper.empty()), releases = e.what == EventView::What::release;
      value = e.value;
    });
    if (const auto next = next_event(d, target, at + Time{1}); next && value)
      each_event(d, target, *next, *next, [&](const EventView& e) {
        comes = e.cut_from ? e.cut_from : e.value;
        // Between equal events a smooth curve may overshoot.
        holds = holds || (comes && *comes == *value && stays_between(workspace_.program(), target, at, *next));
      });
    const bool* shown = value ? std::get_if<bool>(value) : nullptr;
    if (releases || (shown && !*shown)) return;
    const auto* painted = value ? std::get_if<Color>(value) : nullptr;
    const auto* other = comes ? std::get_if<Color>(comes) : nullptr;
    if (painted) {
      QLinearGradient fill(from, 0, to, 0);
      fill.setColorAt(0, swatch(*painted)), fill.setColorAt(1, swatch(holds || !other ? *painted : *other));
      p.fillRect(QRectF(from, y - r * 0.7, to - from, r * 1.4), fill);
      return;
    }
    const double h = holds ? r : 1;
    p.fillRect(QRectF(from, y - h / 2, to - from, h), faint(color, holds ? 0.3F : 0.5F));
  };
  if (!whole) {
    const auto before = event_before(d, target, left);
    if (before) way(axis_.gutter(), marks.empty() ? width() : marks.front().from, *before);
    for (std::size_t i = 0; i + 1 < marks.size(); ++i)
      if (marks[i + 1].from - marks[i].to > 2 * r) way(marks[i].to, marks[i + 1].from, marks[i].last);
    if (!marks.empty())
      if (const auto after = next_event(d, target, right)) way(marks.back().to, x_of(*after), marks.back().last);
  }
  for (const Mark& m : marks) {
    const bool on = picked_.any(target, m.first, m.last);
    p.setBrush(on ? c.selected : color);
    p.setPen(QPen(on ? c.accent : c.back, on ? 1.5 : 1));
    if (m.to > m.from)
      p.drawRect(QRectF(m.from - r / 2, y - r, m.to - m.from + r, 2 * r));
    else
      diamond(p, m.from, y, on ? r * 1.15 : r);
  }
}

void SheetPane::paint_row(QPainter& p, std::size_t row) const {
  const SheetRow& r = rows_[row];
  const Colors& c = colors();
  const double top = row_top(row);
  if (r.whole) p.fillRect(QRectF(0, top, width(), line_height()), c.raised);
  if (row == current_ && hasFocus()) p.fillRect(QRectF(0, top, width(), line_height()), faint(c.accent, 0.12F));
  p.setPen(faint(c.line, 0.5F));
  p.drawLine(QPointF(0, top + line_height() - 0.5), QPointF(width(), top + line_height() - 0.5));
}

void SheetPane::paint_names(QPainter& p) const {
  const Colors& c = colors();
  const int w = axis_.gutter(), indent = line_height();
  p.save();
  p.setClipRect(0, ruler_height() + 1, w, height());
  for (std::size_t i = row_at(ruler_height() + 1).value_or(0); i < rows_.size() && row_top(i) < height(); ++i) {
    const SheetRow& r = rows_[i];
    const double top = row_top(i), y = top + line_height() / 2.0;
    const bool selected = std::ranges::find(workspace_.selected(), r.object) != workspace_.selected().end();
    const std::string all = r.whole ? workspace_.name(r.object) : workspace_.document().name(r.target);
    QString name = QString::fromStdString(r.whole ? all : all.substr(all.find('.') + 1));
    if (!r.whole && r.target.layer) name += tr(" on %1").arg(QString::fromStdString(workspace_.name(r.target.layer)));
    if (r.whole) {
      const double a = line_height() * 0.2, x = indent * 0.5;
      p.setPen(Qt::NoPen), p.setBrush(c.dim);
      p.drawPolygon(r.open ? QPolygonF({{x - a, y - a / 2}, {x + a, y - a / 2}, {x, y + a}})
                           : QPolygonF({{x - a / 2, y - a}, {x + a, y}, {x - a / 2, y + a}}));
    }
    p.setPen(r.whole ? (selected ? c.accent : c.text) : c.dim);
    const QRectF box(indent + (r.whole ? 0 : indent * 0.5), top, w - indent * (r.whole ? 1.2 : 1.7), line_height());
    p.drawText(box, Qt::AlignVCenter, fontMetrics().elidedText(name, Qt::ElideMiddle, static_cast<int>(box.width())));
  }
  p.restore();
  p.setPen(c.line);
  p.drawLine(w, 0, w, height());
}

void SheetPane::paint_content(QPainter& p) {
  const Colors& c = colors();
  p.fillRect(rect(), c.back);
  const std::size_t first = row_at(ruler_height() + 1).value_or(0);
  for (std::size_t i = first; i < rows_.size() && row_top(i) < height(); ++i) paint_row(p, i);
  paint_lines(p, ruler_height() + 1, height());
  paint_names(p);
  p.setClipRect(time_box());
  p.setRenderHint(QPainter::Antialiasing);
  for (std::size_t i = first; i < rows_.size() && row_top(i) < height(); ++i)
    for (const Target& t : tracks_of_row(workspace_.document(), rows_[i]))
      paint_track(p, t, row_top(i) + line_height() / 2.0, rows_[i].whole);
  p.setRenderHint(QPainter::Antialiasing, false);
  if (const auto around = box()) {
    p.setPen(QPen(faint(c.accent, 0.8F), 1)), p.setBrush(faint(c.accent, 0.06F));
    p.drawRect(*around);
    p.fillRect(QRectF(around->left() - 1, around->top(), 3, around->height()), c.accent);
    p.fillRect(QRectF(around->right() - 1, around->top(), 3, around->height()), c.accent);
  }
  if (hand_ == Hand::box && dragging()) {
    p.setPen(QPen(c.accent, 1, Qt::DashLine)), p.setBrush(faint(c.accent, 0.1F));
    p.drawRect(QRectF(from_, to_).normalized());
  }
  p.setClipping(false);
  paint_ruler(p);
  if (rows_.empty()) {
    p.setPen(c.dim);
    const bool nothing = !only_selected_ || workspace_.selected().empty();
    p.drawText(time_box(), Qt::AlignCenter,
               with_keys(!choice_.search.empty() ? tr("No track has this name.")
                         : nothing ? tr("There are no events yet. Select an object and press {Insert event at "
                                        "playhead} to write one at the playhead.")
                                   : tr("The selection has no events yet. Press {Insert event at playhead} to write "
                                        "one at the playhead.")));
  }
}

}  // namespace betwixt::studio
