// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/curves/curve_pane.h"

#include <QContextMenuEvent>
#include <QLineF>
#include <QMenu>
#include <algorithm>
#include <cmath>

#include "betwixt/object.h"
#include "scene/document.h"
#include "studio/shell/text_of.h"
#include "studio/timeline/event_actions.h"
#include "studio/timeline/key_lines.h"
#include "studio/viewport/hand.h"

namespace betwixt::studio {
namespace {

constexpr double patience = 6;  // ms of sampling between two checks for user input

}  // namespace

CurvePane::CurvePane(Workspace& workspace, QWidget* parent) : TimePane(workspace, parent) {
  setObjectName("curve_pane");
  more_.setInterval(0);
  connect(&more_, &QTimer::timeout, this, &CurvePane::go_on);
  connect(&workspace, &Workspace::document_changed, this, &CurvePane::lay_out);
  connect(&workspace, &Workspace::selection_changed, this, [this] {
    picked_ = PickedTimes(workspace_.events_selected());
    shown_ == workspace_.selected() ? update() : lay_out();
  });
  connect(&axis_, &TimeAxis::changed, this, &CurvePane::sample);
}

void CurvePane::showEvent(QShowEvent* e) {
  TimePane::showEvent(e);
  lay_out();
}

void CurvePane::resizeEvent(QResizeEvent* e) {
  TimePane::resizeEvent(e);
  middle_ = ruler_height() + (height() - ruler_height()) / 2.0;
  if (fit_ == std::pair(center_, scale_)) fitted_ = false;  // the user has not zoomed since the fit
  lay_out();
}

void CurvePane::lay_out() {
  if (!isVisible()) return;
  shown_ = workspace_.selected();
  const auto lines = curve_lines(workspace_.document(), shown_);
  const auto names = [](const std::vector<CurveLine>& all) {
    std::vector<std::pair<Target, int>> out;
    for (const CurveLine& l : all) out.emplace_back(l.target, l.part);
    return out;
  };
  if (names(lines) != names(lines_) && !workspace_.looks_ahead()) fitted_ = false;
  if (lines.size() != lines_.size()) fitted_ = false;
  laid_out_ = workspace_.document();
  lines_ = lines, base_.resize(lines_.size()), unit_.resize(lines_.size(), 1),
  picked_ = PickedTimes(workspace_.events_selected());
  swings_.clear();
  for (std::size_t i = 0; i < lines_.size(); ++i)
    if (auto far = swing(workspace_.document(), lines_[i])) swings_.emplace_back(i, *std::move(far));
  sample();
}

void CurvePane::sample() {
  if (!isVisible()) return;
  // The axis follows another film before this pane does.
  if (&laid_out_.scene() != &workspace_.document().scene()) return lay_out();
  std::vector<Time> columns;
  for (int x = axis_.gutter(); x < width(); ++x) columns.push_back(time_at(x));
  samples_.begin(workspace_.program(), lines_, std::move(columns));
  go_on();
}

void CurvePane::go_on() {
  samples_.work(patience) ? more_.start() : more_.stop();
  if (!std::exchange(fitted_, true) && samples_.columns() > 0) fit();
  update();
}

void CurvePane::finish() {
  samples_.work(1e9);
  more_.stop();
  update();
}

double CurvePane::strip(std::size_t line) const {
  int below = 0;
  for (std::size_t i = 0; i < line; ++i) below += seen(i) && lines_[i].swatch ? 1 : 0;
  return height() - (below + 0.5) * line_height();
}

QPointF CurvePane::place(std::size_t line, const Handle& h) const {
  if (lines_[line].swatch) return {x_of(h.time), strip(line)};
  QPointF at = place(line, h.time, h.value);
  // Eases have their handles below the point, so that you can reach them even when their length is 0.
  const double stub = reach() * 1.5;
  if (h.what == Handle::What::ease_out) at = {std::max(at.x(), x_of(h.from) + stub), at.y() + 2.2 * reach()};
  if (h.what == Handle::What::ease_in) at = {std::min(at.x(), x_of(h.from) - stub), at.y() + 2.2 * reach()};
  return at;
}

std::vector<std::pair<std::size_t, Handle>> CurvePane::points() const {
  std::vector<std::pair<std::size_t, Handle>> all;
  const Time left = time_at(axis_.gutter() - reach()), right = time_at(width() + reach());
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    const CurveLine& line = lines_[i];
    if (!seen(i) || !line.tracked) continue;
    // One point for each pixel is enough.
    for (auto t = next_event(workspace_.document(), line.target, left); t && *t <= right;
         t = next_event(workspace_.document(), line.target, std::max(*t + Time{1}, time_at(std::floor(x_of(*t)) + 1))))
      each_event(workspace_.document(), line.target, *t, *t, [&](const EventView& e) {
        const auto value = e.value ? shown(line, *e.value) : std::nullopt;
        if (value) all.push_back({i, {Handle::What::point, {line.target, *t}, *t, *value, *t, *value}});
      });
  }
  return all;
}

std::vector<std::pair<std::size_t, Handle>> CurvePane::handles() const {
  std::vector<std::pair<std::size_t, Handle>> all;
  constexpr std::size_t most = 200;
  for (const EventAt& e : workspace_.events_selected())
    for (std::size_t i = 0; i < lines_.size() && all.size() < most; ++i)
      if (seen(i) && lines_[i].target == e.target && !lines_[i].swatch)
        for (const Handle& h : studio::handles(workspace_.document(), lines_[i], e.time)) {
          // An ease applies to all numbers of the value, so it gets one bar.
          const bool ease = h.what == Handle::What::ease_in || h.what == Handle::What::ease_out;
          const bool first = std::ranges::none_of(
              all, [&](const auto& known) { return known.second.what == h.what && known.second.event == h.event; });
          if (h.what != Handle::What::point && (first || !ease)) all.push_back({i, h});
        }
  return all;
}

template <class All>
static auto nearest(const CurvePane& pane, const All& all, const QPointF& at, double reach)
    -> std::optional<typename All::value_type> {
  std::optional<typename All::value_type> best;
  double away = reach;
  for (const auto& one : all)
    if (const double d = QLineF(pane.place(one.first, one.second), at).length(); d <= away) best = one, away = d;
  return best;
}

std::optional<std::pair<std::size_t, Handle>> CurvePane::point_at(const QPointF& at) const {
  if (at.x() < axis_.gutter()) return std::nullopt;
  return nearest(*this, points(), at, reach() * 1.3);
}

std::optional<std::pair<std::size_t, Handle>> CurvePane::handle_at(const QPointF& at) const {
  if (at.x() < axis_.gutter()) return std::nullopt;
  return nearest(*this, handles(), at, reach());
}

void CurvePane::press_name(QMouseEvent* e) {
  const auto i = static_cast<std::size_t>((e->position().y() - ruler_height() - 2) / line_height());
  if (e->position().y() < ruler_height() || i >= lines_.size()) return;
  const std::string name = lines_[i].name;
  if (e->modifiers() & Qt::AltModifier) {  // shows this one alone, or all again
    const bool alone = hidden_.size() + 1 == lines_.size() && !hidden_.contains(name);
    hidden_.clear();
    for (const CurveLine& l : lines_)
      if (!alone && l.name != name) hidden_.insert(l.name);
  } else if (!hidden_.erase(name)) {
    hidden_.insert(name);
  }
  update();
}

void CurvePane::press(QMouseEvent* e) {
  from_ = to_ = e->position();
  hand_ = Hand::none, by_ = {};
  if (e->button() != Qt::LeftButton) return;
  if (from_.x() < axis_.gutter()) return press_name(e);
  if (const auto handle = handle_at(from_)) {
    std::tie(line_, held_) = *handle, hand_ = Hand::handle;
    return update();
  }
  const bool adds = e->modifiers() & Qt::ShiftModifier;
  if (const auto point = point_at(from_)) {
    std::tie(line_, held_) = *point, hand_ = Hand::points;
    active_ = {lines_[line_].target, lines_[line_].part};
    std::vector<EventAt> all = workspace_.events_selected();
    if (!is_selected(held_.event)) {
      if (!adds) all.clear();
      all.push_back(held_.event);
    }
    return workspace_.select_events(std::move(all));
  }
  if (press_twerper(from_)) return;
  hand_ = Hand::box;
  before_ = adds ? workspace_.events_selected() : std::vector<EventAt>();
  workspace_.select_events(before_);
}

bool CurvePane::press_twerper(const QPointF& at) {
  if (std::ranges::none_of(words_, [&](const QRectF& box) { return box.contains(at); })) return false;
  auto* menu = new QMenu(this);
  menu->setObjectName("twerpers");
  menu->setAttribute(Qt::WA_DeleteOnClose);
  EventActions::of(workspace_).fill_twerpers(*menu);
  menu->popup(mapToGlobal(at.toPoint()));
  return true;
}

Lines CurvePane::said_by(QMouseEvent* e) {
  QPointF at = e->position();
  if (e->modifiers() & Qt::ShiftModifier) {  // along one axis
    const QPointF way = at - from_;
    std::abs(way.x()) > std::abs(way.y()) ? at.setY(from_.y()) : at.setX(from_.x());
  }
  const bool still_x = at.x() == from_.x(), still_y = at.y() == from_.y() || lines_[line_].swatch;
  Time t = still_x ? held_.time : time_at(x_of(held_.time) + at.x() - from_.x());
  if (!(e->modifiers() & Qt::ControlModifier) && !still_x) t = nearest_frame(t);
  const double step = unit_[line_] / scale_;
  const double value = still_y ? held_.value : rounded(held_.value - (at.y() - from_.y()) * step, step);
  const Document& d = workspace_.session().document();
  if (hand_ == Hand::points) {
    by_ = t - held_.event.time;
    return point_lines(d, lines_[line_], workspace_.events_selected(), by_, value - held_.value);
  }
  return handle_lines(d, lines_[line_], held_, t, value, !(e->modifiers() & Qt::AltModifier));
}

void CurvePane::drag(QMouseEvent* e) {
  to_ = e->position();
  if (hand_ == Hand::none || ((to_ - from_).manhattanLength() < 3 && !workspace_.looks_ahead())) return;
  if (hand_ == Hand::box) {
    std::vector<EventAt> all = before_;
    const QRectF box = QRectF(from_, to_).normalized();
    for (const auto& [line, h] : points())
      if (box.contains(place(line, h)) && std::ranges::find(all, h.event) == all.end()) all.push_back(h.event);
    return workspace_.select_events(std::move(all));
  }
  const Lines lines = said_by(e);
  lines.empty() ? workspace_.look_back() : void(workspace_.look_ahead(lines));
}

void CurvePane::release(QMouseEvent* e) {
  const Hand was = std::exchange(hand_, Hand::none);
  const bool moved = (e->position() - from_).manhattanLength() >= 3;
  if (moved && (was == Hand::points || was == Hand::handle)) {
    hand_ = was;
    const Lines lines = said_by(e);
    hand_ = Hand::none;
    workspace_.look_back();
    if (was == Hand::points)
      EventActions::of(workspace_).retime(lines, [this](Time t) { return t + by_; });
    else if (!lines.empty())
      workspace_.say(lines);
  }
  workspace_.look_back();
  by_ = {};
  update();
}

void CurvePane::call_off() {
  const Hand was = std::exchange(hand_, Hand::none);
  workspace_.look_back();
  by_ = {};
  if (was == Hand::box) workspace_.select_events(before_);
  update();
}

const LineSwing* CurvePane::swing_at(const QPointF& at) const {
  for (const auto& [line, far] : swings_)
    if (seen(line) && QLineF(place(line, far.at, far.value), at).length() < 2 * reach()) return &far;
  return nullptr;
}

void CurvePane::hover(QMouseEvent* e) {
  const auto handle = handle_at(e->position());
  const auto point = handle ? handle : point_at(e->position());
  QString words;
  if (point)
    if (const Event* event = find_event(workspace_.document(), point->second.event))
      words = QString::fromStdString(event_line(workspace_.document(), point->second.event.target, *event));
  if (const LineSwing* far = point ? nullptr : swing_at(e->position())) words = text_of(far->words);
  setToolTip(tip_of(words));
  if (point && e->position().x() > axis_.gutter() + 4) setCursor(handle ? Qt::CrossCursor : Qt::SizeAllCursor);
}

bool CurvePane::key(int key, Qt::KeyboardModifiers with, bool act) {
  if (key == Qt::Key_F && with == Qt::NoModifier) {
    if (act) finish(), fit();
    return true;
  }
  if ((key == Qt::Key_Home || key == Qt::Key_Period) && with == Qt::NoModifier) {
    if (act) key == Qt::Key_Home ? frame_all() : frame_selection();
    return true;
  }
  if (key == Qt::Key_N && with == Qt::NoModifier) {
    if (act) let_each_fill(!each_fills_);
    return true;
  }
  if (key == Qt::Key_A && with == Qt::ControlModifier) {
    if (!act) return true;
    std::vector<EventAt> all;
    for (const CurveLine& line : lines_)
      if (line.tracked && line.part == 0)
        each_event(workspace_.document(), line.target, earliest_time, latest_time, [&](const EventView& v) {
          all.push_back({line.target, v.time});
        });
    workspace_.select_events(std::move(all));
    return true;
  }
  // Moves the values of the selected events up or down by a small step.
  const bool up = key == Qt::Key_Up, down = key == Qt::Key_Down;
  if ((up || down) && with == Qt::ControlModifier && !workspace_.events_selected().empty()) {
    const auto line = std::ranges::find(lines_, workspace_.events_selected().back().target, &CurveLine::target);
    if (line == lines_.end()) return false;
    const double pixels = 10 * unit_[static_cast<std::size_t>(line - lines_.begin())] / scale_;
    const double step = rounded(pixels, pixels);
    if (act)
      workspace_.say(point_lines(workspace_.document(), *line, workspace_.events_selected(), {}, up ? step : -step));
    return true;
  }
  return EventActions::of(workspace_).key(key, with, act);
}

void CurvePane::wheel(QWheelEvent* e) {
  if (!(e->modifiers() & Qt::ControlModifier)) return zoom_time(e);
  const double at = level_at(e->position().y());
  scale_ = std::clamp(scale_ * std::pow(1.0015, e->angleDelta().y()), 1e-9, 1e9);
  center_ = at - (middle_ - e->position().y()) / scale_;
  update();
}

void CurvePane::pan(double by) { center_ += by / scale_, update(); }

// Inserts an event on the nearest curve.
void CurvePane::mouseDoubleClickEvent(QMouseEvent* e) {
  const QPointF at = e->position();
  if (e->button() != Qt::LeftButton || at.x() < axis_.gutter() || in_ruler(at) || point_at(at)) return;
  const auto column = static_cast<std::size_t>(at.x() - axis_.gutter());
  std::optional<std::size_t> best;
  double away = 4 * reach();
  for (std::size_t i = 0; i < lines_.size() && column < samples_.columns(); ++i) {
    const auto v = samples_.has_bare(i) ? samples_.bare(i, column) : samples_.final(i, column);
    if (!seen(i) || !v || lines_[i].target.velocity || std::abs(y_of(i, *v) - at.y()) > away) continue;
    best = i, away = std::abs(y_of(i, *v) - at.y());
  }
  if (!best) return;
  const Target t = lines_[*best].target;
  const Time time = time_at(at, e->modifiers());
  if (workspace_.say(insert_lines(workspace_.document(), workspace_.program(), {t}, time)))
    workspace_.select_events({{t, time}});
}

void CurvePane::contextMenuEvent(QContextMenuEvent* e) {
  if (const auto point = point_at(e->pos()); point && !is_selected(point->second.event))
    workspace_.select_events({point->second.event});
  QMenu menu;
  EventActions::of(workspace_).fill(menu);
  menu.addSeparator();
  fill_curve_menu(menu);
  menu.exec(e->globalPos());
}

}  // namespace betwixt::studio
