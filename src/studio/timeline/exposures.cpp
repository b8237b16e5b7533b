// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/timeline/exposures.h"

#include <fmt/format.h>

#include <QContextMenuEvent>
#include <QLineEdit>
#include <QMenu>
#include <QPainter>
#include <QScrollBar>
#include <algorithm>
#include <cmath>

#include "betwixt/track.h"
#include "language/values.h"
#include "studio/shell/theme.h"
#include "studio/timeline/event_actions.h"
#include "studio/timeline/time_words.h"

namespace betwixt::studio {
namespace {

constexpr int frames_beyond = 100;  // rows after the film's end

}  // namespace

Exposures::Exposures(Workspace& workspace, QWidget* parent)
    : QWidget(parent),
      workspace_(workspace),
      down_(new QScrollBar(Qt::Vertical, this)),
      across_(new QScrollBar(Qt::Horizontal, this)) {
  setObjectName("exposures");
  setFocusPolicy(Qt::StrongFocus);
  for (QScrollBar* bar : {down_, across_}) connect(bar, &QScrollBar::valueChanged, this, [this] { update(); });
  connect(&workspace, &Workspace::document_changed, this, [this] { workspace_.looks_ahead() ? update() : lay_out(); });
  connect(&workspace, &Workspace::selection_changed, this, [this] {
    if (only_selected_ && choice_.objects != workspace_.selected()) return lay_out();
    picked_ = PickedTimes(workspace_.events_selected());
    update();
  });
  connect(&workspace, &Workspace::time_changed, this, &Exposures::show_frame);
  lay_out();
}

QSize Exposures::sizeHint() const { return {40 * line_height(), 10 * line_height()}; }
int Exposures::line_height() const { return fontMetrics().height() * 5 / 4; }
int Exposures::side() const { return 7 * fontMetrics().averageCharWidth(); }
int Exposures::column_width() const { return 20 * fontMetrics().averageCharWidth(); }

void Exposures::show_only_selected(bool only) { only_selected_ = only, lay_out(); }
void Exposures::search(const std::string& what) { choice_.search = what, lay_out(); }

void Exposures::lay_out() {
  if (!isVisible()) return;
  choice_.objects = only_selected_ ? workspace_.selected() : std::vector<ObjectId>();
  columns_ = sheet_tracks(workspace_.document(), choice_);
  picked_ = PickedTimes(workspace_.events_selected());
  current_ = std::min(current_, columns_.empty() ? 0 : columns_.size() - 1);
  const Rate rate = workspace_.document().rate();
  const auto [from, to] = workspace_.document().range();
  first_ = static_cast<int>(std::floor(rate.frame_number(from)));
  const int frames = static_cast<int>(std::ceil(rate.frame_number(to))) - first_ + frames_beyond;
  const int shown = std::max(1, (height() - head()) / line_height()), wide = std::max(1, width() - side());
  down_->setRange(0, std::max(0, frames - shown)), down_->setPageStep(shown);
  const int all = static_cast<int>(std::min<std::size_t>(columns_.size(), 100'000)) * column_width();
  across_->setRange(0, std::max(0, all - wide)), across_->setPageStep(wide), across_->setSingleStep(column_width());
  across_->setVisible(all > wide);
  update();
}

void Exposures::resizeEvent(QResizeEvent*) {
  const int w = down_->sizeHint().width(), h = across_->sizeHint().height();
  down_->setGeometry(width() - w, head(), w, height() - head());
  across_->setGeometry(side(), height() - h, width() - w - side(), h);
  lay_out();
}

void Exposures::show_frame() {
  const int frame = static_cast<int>(std::floor(workspace_.document().rate().frame_number(workspace_.time())));
  const int row = frame - first_, shown = down_->pageStep();
  if (row < down_->value() || row >= down_->value() + shown - 1) down_->setValue(row - shown / 2);
  update();
}

QRectF Exposures::cell(std::size_t column, int frame) const {
  return QRectF(side() + static_cast<double>(column) * column_width() - across_->value(),
                head() + static_cast<double>(frame - first_ - down_->value()) * line_height(), column_width(),
                line_height());
}

int Exposures::frame_at(double y) const {
  return first_ + down_->value() + static_cast<int>(std::floor((y - head()) / line_height()));
}

std::optional<std::size_t> Exposures::column_at(double x) const {
  const double column = std::floor((x - side() + across_->value()) / column_width());
  if (x < side() || column < 0 || column >= static_cast<double>(columns_.size())) return std::nullopt;
  return static_cast<std::size_t>(column);
}

std::vector<EventAt> Exposures::events_in(std::size_t column, int first, int last) const {
  std::vector<EventAt> found;
  each_event(workspace_.document(), columns_[column], begin(first), begin(last + 1) - Time{1}, [&](const EventView& e) {
    found.push_back({columns_[column], e.time});
  });
  return found;
}

bool Exposures::event(QEvent* e) {
  if (e->type() == QEvent::ShortcutOverride) {
    const auto* k = static_cast<QKeyEvent*>(e);
    const bool mine = (k->key() == Qt::Key_Escape && hand_ != Hand::none) || key(k->key(), k->modifiers(), false);
    if (mine) return e->accept(), true;
  }
  if (e->type() == QEvent::Show) lay_out();
  return QWidget::event(e);
}

void Exposures::mousePressEvent(QMouseEvent* e) {
  from_ = to_ = e->position(), by_ = {};
  hand_ = Hand::none;
  if (e->button() != Qt::LeftButton || from_.y() < head()) return;
  const int frame = frame_at(from_.y());
  const auto column = column_at(from_.x());
  if (from_.x() < side()) {
    hand_ = Hand::scrub;
    workspace_.pause(), workspace_.go_to(begin(frame));
    return;
  }
  const bool adds = e->modifiers() & Qt::ShiftModifier;
  const auto here = column ? events_in(*column, frame, frame) : std::vector<EventAt>();
  if (column) current_ = *column, workspace_.pause(), workspace_.go_to(begin(frame));
  std::vector<EventAt> all = workspace_.events_selected();
  const auto selected = [&](const EventAt& x) { return std::ranges::find(all, x) != all.end(); };
  if (here.empty()) {
    hand_ = Hand::box;
    before_ = adds ? all : std::vector<EventAt>();
    return workspace_.select_events(before_);
  }
  hand_ = Hand::move;
  const bool were = std::ranges::all_of(here, selected);
  if (adds) {
    std::erase_if(all, [&](const EventAt& x) { return std::ranges::find(here, x) != here.end(); });
    if (!were) all.insert(all.end(), here.begin(), here.end());
  } else if (!were) {
    all = here;
  }
  workspace_.select_events(std::move(all));
}

void Exposures::mouseMoveEvent(QMouseEvent* e) {
  to_ = e->position();
  const int first = frame_at(from_.y()), last = frame_at(to_.y());
  if (hand_ == Hand::scrub) workspace_.go_to(begin(last));
  if (hand_ == Hand::box) {
    std::vector<EventAt> all = before_;
    const double left = std::min(from_.x(), to_.x()), right = std::max(from_.x(), to_.x());
    for (std::size_t i = column_at(std::max<double>(left, side())).value_or(columns_.size());
         i < columns_.size() && cell(i, first).left() <= right; ++i)
      for (const EventAt& x : events_in(i, std::min(first, last), std::max(first, last)))
        if (std::ranges::find(before_, x) == before_.end()) all.push_back(x);
    workspace_.select_events(std::move(all));
    update();
  }
  if (hand_ == Hand::move) {
    const Time by = begin(last) - begin(first);
    if (by == by_) return;
    by_ = by;
    by == Time{}
        ? workspace_.look_back()
        : void(workspace_.look_ahead(move_lines(workspace_.session().document(), workspace_.events_selected(), by)));
  }
}

void Exposures::mouseReleaseEvent(QMouseEvent*) {
  const Hand was = std::exchange(hand_, Hand::none);
  workspace_.look_back();
  if (was == Hand::move && by_ != Time{}) EventActions::of(workspace_).move(by_);
  by_ = {};
  update();
}

void Exposures::call_off() {
  const Hand was = std::exchange(hand_, Hand::none);
  workspace_.look_back();
  if (was == Hand::box) workspace_.select_events(before_);
  update();
}

void Exposures::mouseDoubleClickEvent(QMouseEvent* e) {
  const auto column = column_at(e->position().x());
  if (e->button() == Qt::LeftButton && column && e->position().y() >= head())
    edit(*column, frame_at(e->position().y()));
}

void Exposures::contextMenuEvent(QContextMenuEvent* e) {
  const auto column = column_at(e->pos().x());
  if (column && workspace_.events_selected().empty() && e->pos().y() >= head())
    workspace_.select_events(events_in(*column, frame_at(e->pos().y()), frame_at(e->pos().y())));
  QMenu menu;
  EventActions::of(workspace_).fill(menu);
  menu.exec(e->globalPos());
}

void Exposures::wheelEvent(QWheelEvent* e) {
  const QPoint by = e->angleDelta();
  const bool across = e->modifiers() & Qt::ShiftModifier || std::abs(by.x()) > std::abs(by.y());
  if (across)
    across_->setValue(across_->value() - (by.x() + by.y()) / 2);
  else
    down_->setValue(down_->value() - by.y() / 40);
  e->accept();
}

// Text typed into a cell becomes its event; an empty text deletes the event.
void Exposures::edit(std::size_t column, int frame) {
  const Target target = columns_[column];
  const auto here = events_in(column, frame, frame);
  const EventAt at = here.empty() ? EventAt{target, begin(frame)} : here.front();
  const std::string before = write_event(workspace_.document(), target, at.time);
  delete words_;
  words_ = new QLineEdit(QString::fromStdString(before), this);
  words_->setObjectName("cell_words");
  QRect box = cell(column, frame).toRect();
  box.setWidth(std::max(box.width(), fontMetrics().horizontalAdvance(words_->text()) + 2 * line_height()));
  words_->setGeometry(box);
  words_->show(), words_->setFocus(), words_->selectAll();
  connect(words_, &QLineEdit::editingFinished, this, [this, at, before] {
    if (!words_) return;
    const std::string said = words_->text().trimmed().toStdString();
    words_->deleteLater(), words_ = nullptr;
    if (said.empty() && !before.empty())
      workspace_.say(clear_lines(workspace_.document(), {at}));
    else if (said != before)
      workspace_.say(fmt::format("{}at {} {} {}", layer_words(workspace_.document(), at.target),
                                 workspace_.when(at.time), workspace_.document().name(at.target), said));
    setFocus();
  });
}

bool Exposures::key(int key, Qt::KeyboardModifiers with, bool act) {
  if (EventActions::of(workspace_).key(key, with, act)) return true;
  const auto mine = [&](bool is, auto&& does) { return is && (act ? does() : void(), true); };
  const bool plain = with == Qt::NoModifier && !columns_.empty();
  const int frame = static_cast<int>(std::floor(workspace_.document().rate().frame_number(workspace_.time())));
  const auto column = [&](int by) {
    current_ =
        static_cast<std::size_t>(std::clamp(static_cast<int>(current_) + by, 0, static_cast<int>(columns_.size()) - 1));
    const int left = static_cast<int>(current_) * column_width();
    across_->setValue(std::clamp(across_->value(), left + column_width() - (width() - side()), left));
    update();
  };
  switch (key) {
    case Qt::Key_Up:
      return mine(plain, [&] { workspace_.step(-1); });
    case Qt::Key_Down:
      return mine(plain, [&] { workspace_.step(1); });
    case Qt::Key_Left:
      return mine(plain, [&] { column(-1); });
    case Qt::Key_Right:
      return mine(plain, [&] { column(1); });
    case Qt::Key_Return:
    case Qt::Key_Enter:
    case Qt::Key_F2:
      return mine(plain, [&] { edit(current_, frame); });
    default:
      return false;
  }
}

void Exposures::keyPressEvent(QKeyEvent* e) {
  if (e->key() == Qt::Key_Escape && hand_ != Hand::none) return call_off();
  if (!key(e->key(), e->modifiers(), true)) QWidget::keyPressEvent(e);
}

// Paints the values of events, and a line between two of them: a thick one where the value holds.
void Exposures::paint_column(QPainter& p, std::size_t column, int first, int last) const {
  const Colors& c = colors();
  const Document& d = workspace_.document();
  const Target& target = columns_[column];
  const double w = column_width();
  const auto line = [&](int from, int to, Time at) {
    bool holds = false;
    each_event(d, target, at, at, [&](const EventView& e) {
      const auto track = betwixt::track(d, target);
      holds = (e.twerper.empty() && track ? track->default_twerper : e.twerper) == "hold";
    });
    const QRectF top = cell(column, from), bottom = cell(column, to);
    p.setPen(QPen(faint(c.dim, 0.7F), holds ? 3 : 1));
    p.drawLine(QPointF(top.left() + w / 2, top.top() + 2), QPointF(top.left() + w / 2, bottom.bottom() - 2));
  };
  std::optional<Time> before = event_before(d, target, begin(first));
  int free = first;  // the first row below the last value
  int row = first - 1;
  each_event(d, target, begin(first), begin(last + 1) - Time{1}, [&](const EventView& e) {
    const int frame = static_cast<int>(std::floor(d.rate().frame_number(e.time)));
    if (before && frame - 1 >= free) line(free, frame - 1, *before);
    const bool again = frame == row;
    const QRectF box = cell(column, frame);
    if (picked_.has({target, e.time})) p.fillRect(box.adjusted(1, 0, -1, -1), faint(c.accent, 0.35F));
    const auto* color = e.value ? std::get_if<Color>(e.value) : nullptr;
    if (color) p.fillRect(QRectF(box.left() + 3, box.top() + 3, box.height() - 6, box.height() - 6), swatch(*color));
    p.setPen(c.text);
    const QRectF words = box.adjusted(color ? box.height() : 4, 0, -4, 0);
    const bool between = d.rate().frame(frame) != e.time;
    const QString said = again ? "…" : QString::fromStdString(write_event(d, target, e.time));
    p.drawText(words, again ? Qt::AlignRight | Qt::AlignVCenter : Qt::AlignVCenter,
               fontMetrics().elidedText(between ? "~ " + said : said, Qt::ElideRight, static_cast<int>(words.width())));
    before = e.time, free = frame + 1, row = frame;
  });
  if (before && next_event(d, target, begin(last + 1)) && free <= last) line(free, last, *before);
}

void Exposures::paintEvent(QPaintEvent*) {
  QPainter p(this);
  const Colors& c = colors();
  p.fillRect(rect(), c.back);
  const int first = first_ + down_->value(), last = frame_at(height());
  const auto range = workspace_.document().range();
  const int playhead = static_cast<int>(std::floor(workspace_.document().rate().frame_number(workspace_.time())));
  const int second = std::max(1, static_cast<int>(std::lround(workspace_.document().rate().per_second())));
  for (int f = first; f <= last; ++f) {
    const QRectF row(0, cell(0, f).top(), width(), line_height());
    const bool outside = begin(f) < range.first || begin(f) > range.second;
    if (outside) p.fillRect(row, faint(c.line, 0.35F));
    if (f == playhead) p.fillRect(row, faint(c.playhead, 0.22F));
    p.setPen(faint(c.line, (f - 1) % second == 0 ? 1.0F : 0.4F));  // seconds get stronger lines
    p.drawLine(row.topLeft(), row.topRight());
    p.setPen(f == playhead ? c.text : c.dim);
    p.drawText(QRectF(0, row.top(), side() - 5, line_height()), Qt::AlignRight | Qt::AlignVCenter, QString::number(f));
  }
  const std::size_t left = column_at(side()).value_or(0);
  p.save();
  p.setClipRect(side(), 0, width(), height());
  for (std::size_t i = left; i < columns_.size() && cell(i, first).left() < width(); ++i) {
    const QRectF top = cell(i, first);
    paint_column(p, i, first, last);
    p.fillRect(QRectF(top.left(), 0, column_width(), head()), c.raised);
    const std::string name = workspace_.document().name(columns_[i]), object = workspace_.name(columns_[i].object);
    const auto words = [&](double y, const std::string& s, const QColor& color) {
      p.setPen(color);
      p.drawText(QRectF(top.left() + 4, y, column_width() - 8, line_height()), Qt::AlignVCenter,
                 fontMetrics().elidedText(QString::fromStdString(s), Qt::ElideMiddle, column_width() - 8));
    };
    words(2, object, c.text);
    const std::string layer = columns_[i].layer ? " on " + workspace_.name(columns_[i].layer) : "";
    words(2 + line_height(), name.substr(object.size() + 1) + layer, c.dim);
    p.setPen(c.line);
    p.drawLine(QPointF(top.right(), 0), QPointF(top.right(), height()));
    if (i == current_ && hasFocus()) {
      p.setPen(QPen(c.accent, 1)), p.setBrush(Qt::NoBrush);
      p.drawRect(cell(i, playhead).adjusted(0, 0, -1, -1));
    }
  }
  if (hand_ == Hand::box) {
    p.setPen(QPen(c.accent, 1, Qt::DashLine)), p.setBrush(faint(c.accent, 0.1F));
    p.drawRect(QRectF(from_, to_).normalized());
  }
  p.restore();
  p.setPen(c.line);
  p.drawLine(side(), 0, side(), height()), p.drawLine(0, head(), width(), head());
}

}  // namespace betwixt::studio
