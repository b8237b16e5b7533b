// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/timeline/sheet_pane.h"

#include <fmt/format.h>

#include <QContextMenuEvent>
#include <QLineEdit>
#include <QMenu>
#include <QScrollBar>
#include <algorithm>
#include <cmath>

#include "language/values.h"
#include "studio/shell/text_of.h"
#include "studio/timeline/event_actions.h"
#include "studio/timeline/key_lines.h"

namespace betwixt::studio {

SheetPane::SheetPane(Workspace& workspace, QWidget* parent)
    : TimePane(workspace, parent), scroll_(new QScrollBar(Qt::Vertical, this)) {
  setObjectName("sheet_pane");
  connect(scroll_, &QScrollBar::valueChanged, this, [this] { update(); });
  connect(&workspace, &Workspace::document_changed, this, [this] { workspace_.looks_ahead() ? update() : lay_out(); });
  connect(&workspace, &Workspace::selection_changed, this, [this] {
    if (only_selected_ && choice_.objects != workspace_.selected()) return lay_out();
    keep_selection();
    update();
  });
  lay_out();
}

void SheetPane::show_only_selected(bool only) { only_selected_ = only, lay_out(); }
void SheetPane::search(const std::string& what) { choice_.search = what, lay_out(); }

void SheetPane::lay_out() {
  choice_.objects = only_selected_ ? workspace_.selected() : std::vector<ObjectId>();
  rows_ = sheet_rows(workspace_.document(), choice_);
  current_ = std::min(current_, rows_.empty() ? 0 : rows_.size() - 1);
  const int shown = height() - ruler_height(), all = static_cast<int>(rows_.size()) * line_height();
  scroll_->setRange(0, std::max(0, all - shown));
  scroll_->setPageStep(std::max(1, shown)), scroll_->setSingleStep(line_height());
  scroll_->setVisible(all > shown);
  keep_selection();
  update();
}

void SheetPane::resizeEvent(QResizeEvent* e) {
  TimePane::resizeEvent(e);
  const int w = scroll_->sizeHint().width();
  scroll_->setGeometry(width() - w, ruler_height(), w, height() - ruler_height());
  lay_out();
}

double SheetPane::row_top(std::size_t row) const {
  return ruler_height() + 1 + static_cast<double>(row) * line_height() - scroll_->value();
}

std::optional<std::size_t> SheetPane::row_at(double y) const {
  const double row = std::floor((y - row_top(0)) / line_height());
  if (y < ruler_height() || row < 0 || row >= static_cast<double>(rows_.size())) return std::nullopt;
  return static_cast<std::size_t>(row);
}

QPointF SheetPane::place(std::size_t row, Time t) const { return {x_of(t), row_top(row) + line_height() / 2.0}; }

void SheetPane::keep_selection() {
  std::vector<EventAt> shown = workspace_.events_selected();
  for (EventAt& e : shown) e.time = retimed(e.time).value_or(e.time);
  picked_ = PickedTimes(shown);
}

std::optional<QRectF> SheetPane::box() const {
  if (workspace_.events_selected().size() < 2) return std::nullopt;
  const auto [first, last] = span(workspace_.events_selected());
  if (first == last) return std::nullopt;
  std::optional<std::size_t> top, bottom;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const auto of_object = picked_.tracks().lower_bound({rows_[i].object, 0});
    const bool any = rows_[i].whole ? !rows_[i].open && of_object != picked_.tracks().end() &&
                                          of_object->first.object == rows_[i].object
                                    : picked_.tracks().contains(rows_[i].target);
    if (any) bottom = i, top = top.value_or(i);
  }
  if (!top) return std::nullopt;
  const double a = x_of(retimed(first).value_or(first)), b = x_of(retimed(last).value_or(last));
  return QRectF(QPointF(a - 2 * half(), row_top(*top) + 1), QPointF(b + 2 * half(), row_top(*bottom + 1) - 1));
}

std::vector<EventAt> SheetPane::events_at(const QPointF& at) const {
  std::vector<EventAt> found;
  const auto row = row_at(at.y());
  if (!row || at.x() < axis_.gutter()) return found;
  const Time here = time_at(at.x()), from = time_at(at.x() - half() - 1), to = time_at(at.x() + half() + 1);
  std::optional<std::int64_t> nearest;
  for (const Target& t : tracks_of_row(workspace_.document(), rows_[*row]))
    for (auto e = next_event(workspace_.document(), t, from); e && *e <= to;
         e = next_event(workspace_.document(), t, *e + Time{1})) {
      const std::int64_t away = std::abs((*e - here).flicks);
      if (nearest && away > *nearest) continue;
      if (nearest != away || (!found.empty() && found.back().time != *e)) found.clear();
      nearest = away, found.push_back({t, *e});
    }
  return found;
}

std::vector<EventAt> SheetPane::events_in(const QRectF& box) const {
  std::vector<EventAt> found;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const double y = row_top(i) + line_height() / 2.0;
    if (y + half() < box.top() || y - half() > box.bottom() || (rows_[i].whole && rows_[i].open)) continue;
    for (const Target& t : tracks_of_row(workspace_.document(), rows_[i]))
      each_event(workspace_.document(), t, time_at(box.left()), time_at(box.right()), [&](const EventView& e) {
        found.push_back({t, e.time});
      });
  }
  return found;
}

void SheetPane::press_name(QMouseEvent* e, std::size_t row) {
  const SheetRow& r = rows_[row];
  const bool arrow = e->position().x() < line_height();
  if (r.whole && arrow) {
    choice_.open[r.object.index] = !r.open;
    return lay_out();
  }
  std::vector<ObjectId> ids;
  if (e->modifiers() & Qt::ControlModifier) ids = workspace_.selected();
  std::erase(ids, r.object);
  ids.push_back(r.object);
  if (!only_selected_) workspace_.select(std::move(ids));
  std::vector<EventAt> all;  // the row's events: a click on its name selects them
  if (e->modifiers() & Qt::ShiftModifier) all = workspace_.events_selected();
  for (const Target& t : tracks_of_row(workspace_.document(), r))
    each_event(workspace_.document(), t, earliest_time, latest_time, [&](const EventView& v) {
      all.push_back({t, v.time});
    });
  workspace_.select_events(std::move(all));
}

void SheetPane::press(QMouseEvent* e) {
  hand_ = Hand::none;
  from_ = to_ = e->position();
  const auto row = row_at(from_.y());
  if (row) current_ = *row;
  if (e->button() != Qt::LeftButton) return update();
  if (row && from_.x() < axis_.gutter()) return press_name(e, *row);
  was_ = is_ = span(workspace_.events_selected());
  if (const auto around = box()) {
    const double reach = half() + 2;
    const bool level = from_.y() >= around->top() && from_.y() <= around->bottom();
    if (level && std::abs(from_.x() - around->left()) < reach) hand_ = Hand::stretch_left;
    if (level && std::abs(from_.x() - around->right()) < reach) hand_ = Hand::stretch_right;
  }
  const std::vector<EventAt> here = events_at(from_);
  if (!here.empty()) {
    const bool were = std::ranges::all_of(here, [&](const EventAt& x) { return picked_.has(x); });
    std::vector<EventAt> all = workspace_.events_selected();
    if (e->modifiers() & Qt::ShiftModifier) {
      std::erase_if(all, [&](const EventAt& x) { return std::ranges::find(here, x) != here.end(); });
      if (!were) all.insert(all.end(), here.begin(), here.end());
    } else if (!were) {
      all = here;
    }
    workspace_.select_events(std::move(all));
    hand_ = Hand::move, held_ = here.front().time;
    was_ = is_ = span(workspace_.events_selected());
  } else if (hand_ == Hand::none) {
    hand_ = Hand::box;
    before_ = e->modifiers() & Qt::ShiftModifier ? workspace_.events_selected() : std::vector<EventAt>();
    workspace_.select_events(before_);
  }
  update();
}

std::optional<Time> SheetPane::retimed(Time t) const {
  if (is_ == was_) return std::nullopt;
  if (hand_ == Hand::move) return t + (is_.first - was_.first);
  if (hand_ != Hand::stretch_left && hand_ != Hand::stretch_right) return std::nullopt;
  const double factor = (is_.second - is_.first).seconds() / (was_.second - was_.first).seconds();
  return is_.first + Time{std::llround(static_cast<double>((t - was_.first).flicks) * factor)};
}

Lines SheetPane::lines() const {
  if (is_ == was_) return {};
  if (hand_ == Hand::move)
    return move_lines(workspace_.session().document(), workspace_.events_selected(), is_.first - was_.first);
  return stretch_lines(workspace_.session().document(), workspace_.events_selected(), was_, is_);
}

void SheetPane::drag(QMouseEvent* e) {
  to_ = e->position();
  if (hand_ == Hand::none || ((to_ - from_).manhattanLength() < 3 && is_ == was_)) return;
  if (hand_ == Hand::box) {
    std::vector<EventAt> all = before_;
    for (const EventAt& x : events_in(QRectF(from_, to_).normalized()))
      if (std::ranges::find(before_, x) == before_.end()) all.push_back(x);
    workspace_.select_events(std::move(all));
    return update();
  }
  const Time by = time_at(to_.x()) - time_at(from_.x()), frame = workspace_.document().rate().span(1);
  const bool free = e->modifiers() & Qt::ControlModifier;
  const auto to = [&](Time t) { return free ? t + by : nearest_frame(t + by); };
  auto is = was_;
  if (hand_ == Hand::move) is = {was_.first + (to(held_) - held_), was_.second + (to(held_) - held_)};
  if (hand_ == Hand::stretch_left) is.first = std::min(to(was_.first), was_.second - frame);
  if (hand_ == Hand::stretch_right) is.second = std::max(to(was_.second), was_.first + frame);
  if (is == is_) return;
  is_ = is;
  keep_selection();
  const Lines said = lines();
  said.empty() ? workspace_.look_back() : void(workspace_.look_ahead(said));
  update();
}

void SheetPane::release(QMouseEvent*) {
  const Lines said = hand_ == Hand::box || hand_ == Hand::none ? Lines() : lines();
  workspace_.look_back();
  if (!said.empty()) EventActions::of(workspace_).retime(said, [this](Time t) { return retimed(t).value_or(t); });
  hand_ = Hand::none;
  keep_selection();
  update();
}

void SheetPane::call_off() {
  const Hand was = std::exchange(hand_, Hand::none);
  workspace_.look_back();
  if (was == Hand::box) workspace_.select_events(before_);
  keep_selection();
  update();
}

void SheetPane::hover(QMouseEvent* e) {
  const auto here = events_at(e->position());
  QString words;
  for (const EventAt& x : here)
    if (const Event* event = find_event(workspace_.document(), x); event && words.size() < 2000)
      words += QString::fromStdString(event_line(workspace_.document(), x.target, *event)) + "\n";
  setToolTip(tip_of(words.trimmed()));
  if (const auto around = box(); around && here.empty() && std::abs(e->position().x() - axis_.gutter()) >= 4) {
    const double x = e->position().x();
    const bool side = std::min(std::abs(x - around->left()), std::abs(x - around->right())) < half() + 2;
    if (side && e->position().y() >= around->top() && e->position().y() <= around->bottom())
      setCursor(Qt::SizeHorCursor);
  }
}

void SheetPane::go_to_row(int by) {
  if (rows_.empty()) return;
  current_ =
      static_cast<std::size_t>(std::clamp(static_cast<int>(current_) + by, 0, static_cast<int>(rows_.size()) - 1));
  const int top = static_cast<int>(current_) * line_height();
  scroll_->setValue(std::clamp(scroll_->value(), top + 2 * line_height() - (height() - ruler_height()), top));
  update();
}

bool SheetPane::key(int key, Qt::KeyboardModifiers with, bool act) {
  if (EventActions::of(workspace_).key(key, with, act)) return true;
  const auto mine = [&](bool is, auto&& does) { return is && (act ? does() : void(), true); };
  const bool row = !rows_.empty();
  switch (key) {
    case Qt::Key_Up:
      return mine(row, [&] { go_to_row(-1); });
    case Qt::Key_Down:
      return mine(row, [&] { go_to_row(1); });
    case Qt::Key_Return:
    case Qt::Key_Enter:  // opens or closes an object; on a track, selects the event at or before the playhead
      return mine(row, [&] {
        const SheetRow r = rows_[current_];
        if (r.whole) return choice_.open[r.object.index] = !r.open, lay_out();
        if (const auto t = event_before(workspace_.document(), r.target, workspace_.time() + Time{1}))
          workspace_.select_events({{r.target, *t}});
      });
    case Qt::Key_F2:
      return mine(workspace_.events_selected().size() == 1, [&] { edit(workspace_.events_selected().front()); });
    case Qt::Key_A:
      return mine(with == Qt::ControlModifier,
                  [&] { workspace_.select_events(events_in(QRectF(-1e9, -1e9, 2e9, 2e9))); });
    case Qt::Key_Home:
      return mine(with == Qt::ControlModifier, [&] { axis_.fit_again(), axis_.fit(time_box().width()); });
    default:
      return false;
  }
}

void SheetPane::wheel(QWheelEvent* e) {
  if (e->modifiers() & (Qt::ControlModifier | Qt::ShiftModifier) || !scroll_->isVisible()) return zoom_time(e);
  scroll_->setValue(scroll_->value() - e->angleDelta().y() / 2);
}

void SheetPane::pan(double by) { scroll_->setValue(scroll_->value() - static_cast<int>(by)); }

void SheetPane::mouseDoubleClickEvent(QMouseEvent* e) {
  const auto row = row_at(e->position().y());
  if (!row || e->button() != Qt::LeftButton) return;
  if (e->position().x() < axis_.gutter()) {
    if (rows_[*row].whole) choice_.open[rows_[*row].object.index] = !rows_[*row].open, lay_out();
    return;
  }
  const auto here = events_at(e->position());
  if (!here.empty()) return edit(here.front());
  if (rows_[*row].whole) return;
  const Target t = rows_[*row].target;
  const Time at = time_at(e->position(), e->modifiers());
  if (!t.velocity && workspace_.say(insert_lines(workspace_.document(), workspace_.program(), {t}, at)))
    workspace_.select_events({{t, at}});
}

// Edits the part of an event's row after the time.
void SheetPane::edit(const EventAt& at) {
  const Event* e = find_event(workspace_.document(), at);
  if (!e) return;
  delete words_;
  words_ = new QLineEdit(this);
  words_->setObjectName("event_words");
  const std::string before = write_event(workspace_.document(), at.target, *e);
  words_->setText(QString::fromStdString(before));
  double y = 0;
  for (std::size_t i = 0; i < rows_.size(); ++i)
    if (rows_[i].object == at.target.object && (rows_[i].whole || rows_[i].target == at.target)) y = row_top(i);
  words_->setGeometry(std::min(static_cast<int>(x_of(at.time)), std::max(0, width() - 16 * line_height())),
                      static_cast<int>(y), 16 * line_height(), line_height());
  words_->show(), words_->setFocus(), words_->selectAll();
  connect(words_, &QLineEdit::editingFinished, this, [this, at, before] {
    if (!words_) return;
    const std::string said = words_->text().toStdString();
    words_->deleteLater(), words_ = nullptr;
    if (said != before && !said.empty())
      workspace_.say(fmt::format("{}at {} {} {}", layer_words(workspace_.document(), at.target),
                                 workspace_.when(at.time), workspace_.document().name(at.target), said));
    setFocus();
  });
}

void SheetPane::contextMenuEvent(QContextMenuEvent* e) {
  const auto here = events_at(e->pos());
  if (!here.empty() && !picked_.has(here.front())) workspace_.select_events(here);
  QMenu menu;
  EventActions::of(workspace_).fill(menu);
  menu.exec(e->globalPos());
}

}  // namespace betwixt::studio
