// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/curve_pane.h"

#include <QContextMenuEvent>
#include <QMenu>
#include <algorithm>
#include <cmath>

#include "betwixt/object.h"
#include "scene/document.h"
#include "studio/event_hands.h"

namespace betwixt::studio {
namespace {

constexpr double patience = 6;  // ms of sampling between two looks at what hands do

}  // namespace

CurvePane::CurvePane(Desk& desk, QWidget* parent) : TimePane(desk, parent) {
  setObjectName("curve_pane");
  more_.setInterval(0);
  connect(&more_, &QTimer::timeout, this, &CurvePane::go_on);
  connect(&desk, &Desk::document_changed, this, &CurvePane::lay_out);
  connect(&desk, &Desk::selection_changed, this, &CurvePane::lay_out);
  connect(&axis_, &TimeAxis::changed, this, &CurvePane::sample);
}

void CurvePane::showEvent(QShowEvent*) { lay_out(); }

void CurvePane::resizeEvent(QResizeEvent* e) {
  TimePane::resizeEvent(e);
  middle_ = ruler_height() + (height() - ruler_height()) / 2.0;
  lay_out();
}

void CurvePane::lay_out() {
  if (!isVisible()) return;
  const auto lines = curve_lines(desk_.document(), desk_.selected());
  const auto names = [](const std::vector<CurveLine>& all) {
    std::vector<std::pair<Target, int>> out;
    for (const CurveLine& l : all) out.emplace_back(l.target, l.part);
    return out;
  };
  if (names(lines) != names(lines_) && !desk_.looks_ahead()) fitted_ = false;
  lines_ = lines;
  sample();
}

void CurvePane::sample() {
  if (!isVisible()) return;
  std::vector<Time> columns;
  for (int x = axis_.gutter(); x < width(); ++x) columns.push_back(time_at(x));
  samples_.begin(desk_.program(), lines_, std::move(columns));
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

void CurvePane::fit() {
  double low = 1e300, high = -1e300;
  const auto take = [&](std::optional<double> v) {
    if (v && std::isfinite(*v)) low = std::min(low, *v), high = std::max(high, *v);
  };
  for (std::size_t i = 0; i < lines_.size(); ++i)
    for (std::size_t c = 0; seen(i) && !lines_[i].swatch && c < samples_.columns(); ++c)
      take(samples_.final(i, c)), take(samples_.has_bare(i) ? samples_.bare(i, c) : std::nullopt);
  for (const auto& [line, h] : points()) take(h.value);
  if (low > high) low = -1, high = 1;
  const double room = std::max(10.0, (height() - ruler_height()) * 0.8);
  center_ = (low + high) / 2, scale_ = room / std::max(high - low, std::max(1e-9, std::abs(center_) * 1e-6));
  if (high - low < 1e-9) scale_ = room / 2;
  update();
}

QPointF CurvePane::place(const Handle& h) const {
  QPointF at = place(h.time, h.value);
  // Eases lie below the point, and can be taken hold of where there are none.
  const double stub = reach() * 1.5;
  if (h.what == Handle::What::ease_out) at = {std::max(at.x(), x_of(h.from) + stub), at.y() + 2.2 * reach()};
  if (h.what == Handle::What::ease_in) at = {std::min(at.x(), x_of(h.from) - stub), at.y() + 2.2 * reach()};
  return at;
}

bool CurvePane::is_selected(const EventAt& e) const {
  return std::ranges::find(desk_.events_selected(), e) != desk_.events_selected().end();
}

std::vector<std::pair<std::size_t, Handle>> CurvePane::points() const {
  std::vector<std::pair<std::size_t, Handle>> all;
  const Time left = time_at(axis_.gutter() - reach()), right = time_at(width() + reach());
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    const CurveLine& line = lines_[i];
    if (!seen(i) || !line.tracked) continue;
    // One in a pixel is enough.
    for (auto t = next_event(desk_.document(), line.target, left); t && *t <= right;
         t = next_event(desk_.document(), line.target, std::max(*t + Time{1}, time_at(std::floor(x_of(*t)) + 1))))
      each_event(desk_.document(), line.target, *t, *t, [&](const EventView& e) {
        const auto value = e.value ? shown(line, *e.value) : std::nullopt;
        if (value) all.push_back({i, {Handle::What::point, {line.target, *t}, *t, *value, *t, *value}});
      });
  }
  return all;
}

std::vector<std::pair<std::size_t, Handle>> CurvePane::handles() const {
  std::vector<std::pair<std::size_t, Handle>> all;
  constexpr std::size_t most = 200;
  for (const EventAt& e : desk_.events_selected())
    for (std::size_t i = 0; i < lines_.size() && all.size() < most; ++i)
      if (seen(i) && lines_[i].target == e.target && !lines_[i].swatch)
        for (const Handle& h : studio::handles(desk_.document(), lines_[i], e.time))
          if (h.what != Handle::What::point) all.push_back({i, h});
  return all;
}

template <class All>
static auto nearest(const CurvePane& pane, const All& all, const QPointF& at, double reach)
    -> std::optional<typename All::value_type> {
  std::optional<typename All::value_type> best;
  double away = reach;
  for (const auto& one : all)
    if (const double d = QLineF(pane.place(one.second), at).length(); d <= away) best = one, away = d;
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
  if (e->modifiers() & Qt::AltModifier) {  // this one alone, or all again
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
    std::vector<EventAt> all = desk_.events_selected();
    if (!is_selected(held_.event)) {
      if (!adds) all.clear();
      all.push_back(held_.event);
    }
    return desk_.select_events(std::move(all));
  }
  hand_ = Hand::box;
  before_ = adds ? desk_.events_selected() : std::vector<EventAt>();
  desk_.select_events(before_);
}

Lines CurvePane::said_by(QMouseEvent* e) {
  QPointF at = e->position();
  if (e->modifiers() & Qt::ShiftModifier) {  // along one axis
    const QPointF way = at - from_;
    std::abs(way.x()) > std::abs(way.y()) ? at.setY(from_.y()) : at.setX(from_.x());
  }
  const bool still_x = at.x() == from_.x(), still_y = at.y() == from_.y();
  Time t = still_x ? held_.time : time_at(x_of(held_.time) + at.x() - from_.x());
  if (!(e->modifiers() & Qt::ControlModifier) && !still_x) t = nearest_frame(t);
  const double step = 1 / scale_;
  const double value = still_y ? held_.value : rounded(held_.value - (at.y() - from_.y()) * step, step);
  const Document& d = desk_.session().document();
  if (hand_ == Hand::points) {
    by_ = t - held_.event.time;
    return point_lines(d, lines_[line_], desk_.events_selected(), by_, value - held_.value);
  }
  return handle_lines(d, lines_[line_], held_, t, value, !(e->modifiers() & Qt::AltModifier));
}

void CurvePane::drag(QMouseEvent* e) {
  to_ = e->position();
  if (hand_ == Hand::none || ((to_ - from_).manhattanLength() < 3 && !desk_.looks_ahead())) return;
  if (hand_ == Hand::box) {
    std::vector<EventAt> all = before_;
    const QRectF box = QRectF(from_, to_).normalized();
    for (const auto& [line, h] : points())
      if (box.contains(place(h)) && std::ranges::find(all, h.event) == all.end()) all.push_back(h.event);
    return desk_.select_events(std::move(all));
  }
  const Lines lines = said_by(e);
  lines.empty() ? desk_.look_back() : void(desk_.look_ahead(lines));
}

void CurvePane::release(QMouseEvent* e) {
  const Hand was = std::exchange(hand_, Hand::none);
  const bool moved = (e->position() - from_).manhattanLength() >= 3;
  if (moved && (was == Hand::points || was == Hand::handle)) {
    hand_ = was;
    const Lines lines = said_by(e);
    hand_ = Hand::none;
    desk_.look_back();
    if (was == Hand::points)
      EventHands::of(desk_).retime(lines, [this](Time t) { return t + by_; });
    else if (!lines.empty())
      desk_.say(lines);
  }
  desk_.look_back();
  by_ = {};
  update();
}

void CurvePane::call_off() {
  const Hand was = std::exchange(hand_, Hand::none);
  desk_.look_back();
  by_ = {};
  if (was == Hand::box) desk_.select_events(before_);
  update();
}

void CurvePane::hover(QMouseEvent* e) {
  const auto handle = handle_at(e->position());
  const auto point = handle ? handle : point_at(e->position());
  QString words;
  if (point)
    if (const Event* event = find_event(desk_.document(), point->second.event))
      words = QString::fromStdString(event_line(desk_.document(), point->second.event.target, *event));
  setToolTip(words);
  if (point && e->position().x() > axis_.gutter() + 4) setCursor(handle ? Qt::CrossCursor : Qt::SizeAllCursor);
}

bool CurvePane::key(int key, Qt::KeyboardModifiers with, bool act) {
  if ((key == Qt::Key_F || key == Qt::Key_Home) && with == Qt::NoModifier) {
    if (act) finish(), fit();
    return true;
  }
  if (key == Qt::Key_A && with == Qt::ControlModifier) {
    if (!act) return true;
    std::vector<EventAt> all;
    for (const CurveLine& line : lines_)
      if (line.tracked && line.part == 0)
        each_event(desk_.document(), line.target, from_the_beginning, for_good, [&](const EventView& v) {
          all.push_back({line.target, v.time});
        });
    desk_.select_events(std::move(all));
    return true;
  }
  // Values of the selected events, a little up or down.
  const bool up = key == Qt::Key_Up, down = key == Qt::Key_Down;
  if ((up || down) && with == Qt::ControlModifier && !desk_.events_selected().empty()) {
    const auto line = std::ranges::find(lines_, desk_.events_selected().back().target, &CurveLine::target);
    if (line == lines_.end()) return false;
    const double step = rounded(10 / scale_, 10 / scale_);
    if (act) desk_.say(point_lines(desk_.document(), *line, desk_.events_selected(), {}, up ? step : -step));
    return true;
  }
  return EventHands::of(desk_).key(key, with, act);
}

void CurvePane::wheel(QWheelEvent* e) {
  if (!(e->modifiers() & Qt::ControlModifier)) return zoom_time(e);
  const double at = value_at(e->position().y());
  scale_ = std::clamp(scale_ * std::pow(1.0015, e->angleDelta().y()), 1e-9, 1e9);
  center_ = at - (middle_ - e->position().y()) / scale_;
  update();
}

void CurvePane::pan(double by) { center_ += by / scale_, update(); }

// An event where the curve is.
void CurvePane::mouseDoubleClickEvent(QMouseEvent* e) {
  const QPointF at = e->position();
  if (e->button() != Qt::LeftButton || at.x() < axis_.gutter() || in_ruler(at) || point_at(at)) return;
  const auto column = static_cast<std::size_t>(at.x() - axis_.gutter());
  std::optional<std::size_t> best;
  double away = 4 * reach();
  for (std::size_t i = 0; i < lines_.size() && column < samples_.columns(); ++i) {
    const auto v = samples_.has_bare(i) ? samples_.bare(i, column) : samples_.final(i, column);
    if (!seen(i) || !v || lines_[i].target.velocity || std::abs(y_of(*v) - at.y()) > away) continue;
    best = i, away = std::abs(y_of(*v) - at.y());
  }
  if (!best) return;
  const Target t = lines_[*best].target;
  const Time time = time_at(at, e->modifiers());
  if (desk_.say(insert_lines(desk_.document(), desk_.program(), {t}, time))) desk_.select_events({{t, time}});
}

void CurvePane::contextMenuEvent(QContextMenuEvent* e) {
  if (const auto point = point_at(e->pos()); point && !is_selected(point->second.event))
    desk_.select_events({point->second.event});
  QMenu menu;
  EventHands::of(desk_).fill(menu);
  menu.addSeparator();
  connect(menu.addAction(tr("All values") + "\tF"), &QAction::triggered, this, [this] { finish(), fit(); });
  menu.exec(e->globalPos());
}

}  // namespace betwixt::studio
