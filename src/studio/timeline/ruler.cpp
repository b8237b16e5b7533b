// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/timeline/ruler.h"

#include <fmt/format.h>

#include <QApplication>
#include <QClipboard>
#include <QContextMenuEvent>
#include <QLineEdit>
#include <QMenu>
#include <QPainter>
#include <QToolTip>
#include <algorithm>
#include <cmath>

#include "betwixt/object.h"
#include "language/values.h"
#include "studio/shell/text_of.h"
#include "studio/shell/theme.h"
#include "studio/timeline/event_actions.h"
#include "studio/timeline/section_lines.h"
#include "studio/timeline/time_words.h"

namespace betwixt::studio {

Ruler::Ruler(Workspace& workspace, QWidget* parent) : TimePane(workspace, parent) {
  setObjectName("ruler");
  setContextMenuPolicy(Qt::DefaultContextMenu);
  connect(&workspace, &Workspace::document_changed, this, &Ruler::follow_film);
  connect(&workspace, &Workspace::opened, this, &Ruler::follow_film);
  connect(&workspace, &Workspace::kept_changed, this, [this] { QWidget::update(); });
  follow_film();
}

double Ruler::steps_top() const { return 2.5 + section_rows_; }
double Ruler::sounds_top() const { return steps_top() + (steps_.empty() ? 0 : 1); }

double Ruler::sound_pitch() const { return words_shown_ ? 2.4 : 1.5; }

double Ruler::bottom() const {
  int rows = 0;
  for (const SoundBar& bar : sounds_) rows = std::max(rows, bar.row + 1);
  return sounds_top() + sound_pitch() * rows;
}

// The frame numbers, the part to play, cuts, notes, sections, steps and sounds.
QSize Ruler::sizeHint() const {
  return {20 * line_height(), ruler_height() + static_cast<int>(std::lround(line_height() * bottom()))};
}

void Ruler::follow_film() {
  const int before = sizeHint().height();
  sounds_ = sound_bars(workspace_.program());
  std::vector<SectionBlock> blocks = section_blocks(workspace_.document().sections());
  if (section_ && blocks.size() == sections_.size())  // while one is dragged, each stays in its row
    for (std::size_t i = 0; i < blocks.size(); ++i) blocks[i].row = sections_[i].row;
  sections_ = std::move(blocks);
  section_rows_ = 0;
  for (const SectionBlock& block : sections_) section_rows_ = std::max(section_rows_, block.row + 1);
  words_shown_ = std::ranges::any_of(sounds_, [](const SoundBar& s) { return s.words != nullptr; });
  steps_ = workspace_.document().pauses();
  describe();
  if (sizeHint().height() != before) updateGeometry();
  update();
}

QRect Ruler::part_box() const {
  const int top = ruler_height() + 2;
  return {axis_.gutter(), top, width() - axis_.gutter(), line_height() / 3};
}

Ruler::Edge Ruler::edge_at(const QPointF& at) const {
  if (!part_box().adjusted(0, -3, 0, 3).contains(at.toPoint())) return Edge::none;
  const auto [from, to] = workspace_.document().range();
  const double near = line_height() * 0.4, a = std::abs(at.x() - x_of(from)), b = std::abs(at.x() - x_of(to));
  return std::min(a, b) > near ? Edge::none : b <= a ? Edge::last : Edge::first;
}

QRectF Ruler::sound_box(const SoundBar& bar) const {
  const double a = x_of(bar.from), b = std::max(a + 3, x_of(bar.to));
  return {a, ruler_height() + line_height() * (sounds_top() + sound_pitch() * bar.row), b - a, line_height() * 1.4};
}

std::optional<std::size_t> Ruler::sound_at(const QPointF& at) const {
  for (std::size_t i = sounds_.size(); i-- > 0;)
    if (sound_box(sounds_[i]).contains(at)) return i;
  return std::nullopt;
}

void Ruler::paint_content(QPainter& p) {
  p.fillRect(rect(), colors().back);
  paint_ruler(p);
  paint_lines(p, ruler_height() + 1, height());
  p.setClipRect(time_box());
  paint_part(p), paint_cuts(p), paint_notes(p), paint_sections(p), paint_steps(p), paint_sounds(p);
  p.setClipping(false);
  const QRect left(0, ruler_height(), axis_.gutter() - 6, height() - ruler_height());
  p.setPen(colors().dim);
  const auto lane = [&](double top, const QString& what) {
    p.drawText(QRectF(left.x() + 4, top, left.width() - 4, line_height()), Qt::AlignRight | Qt::AlignVCenter, what);
  };
  if (!workspace_.document().cuts().empty()) lane(ruler_height() + line_height() * 0.4, tr("cameras"));
  if (!workspace_.document().notes(earliest_time, latest_time).empty())
    lane(ruler_height() + line_height() * 1.4, tr("notes"));
  if (!sections_.empty()) lane(ruler_height() + line_height() * 2.5, tr("sections"));
  if (!steps_.empty()) lane(ruler_height() + line_height() * steps_top(), tr("steps"));
  if (!sounds_.empty()) lane(ruler_height() + line_height() * (sounds_top() + 0.1), tr("sounds"));
}

void Ruler::paint_part(QPainter& p) const {
  const Colors& c = colors();
  const QRect box = part_box();
  const auto bar = [&](Time from, Time to, QColor color) {
    const double a = x_of(from), b = std::max(a + 2, x_of(to));
    p.fillRect(QRectF(a, box.y(), b - a, box.height()), color);
  };
  auto [from, to] = workspace_.document().range();
  if (edge_to_) edge_ == Edge::first ? from = *edge_to_ : to = *edge_to_;
  bar(from, to, edge_to_ ? c.accent : c.line);
  const Playhead& played = workspace_.playhead();
  if (played.first() != from || played.last() != to) bar(played.first(), played.last(), c.accent);
}

// Below the frame numbers: the frames whose pictures are in memory; drafts are pale.
void Ruler::paint_over(QPainter& p) const {
  const std::vector<KeptAt>& kept = workspace_.kept();
  const Time frame = workspace_.document().rate().span(1);
  p.setClipRect(time_box());
  for (std::size_t i = 0, from = 0; i < kept.size(); ++i) {
    const bool goes_on = i + 1 < kept.size() && kept[i + 1].time <= kept[i].time + frame;
    if (goes_on && kept[i + 1].draft == kept[i].draft) continue;
    const double a = x_of(kept[from].time), b = x_of(kept[i].time + frame);
    p.fillRect(QRectF(a, ruler_height() - 3, b - a, 3), kept[i].draft ? faint(colors().note, 0.4F) : colors().note);
    from = i + 1;
  }
  p.setClipping(false);
}

void Ruler::paint_cuts(QPainter& p) const {
  const Colors& c = colors();
  const auto& cuts = workspace_.document().cuts();
  const double top = ruler_height() + line_height() * 0.5, h = line_height() * 0.85;
  const Time left = time_at(axis_.gutter()), right = time_at(width());
  auto cut = cuts.upper_bound(left);
  if (cut != cuts.begin()) --cut;
  for (; cut != cuts.end() && cut->first <= right; ++cut) {
    const auto next = std::next(cut);
    const double a = std::max<double>(axis_.gutter(), cut->first == earliest_time ? 0 : x_of(cut->first));
    const double b = next == cuts.end() ? width() : x_of(next->first);
    QColor back = c.cut;
    back.setAlphaF(0.18F);
    p.fillRect(QRectF(a, top, b - a - 1, h), back);
    p.fillRect(QRectF(a, top, 2, h), c.cut);
    p.setPen(c.text);
    const QString camera = QString::fromStdString(workspace_.name(cut->second));
    p.drawText(QRectF(a + 6, top, b - a - 8, h), Qt::AlignVCenter,
               fontMetrics().elidedText(camera, Qt::ElideRight, static_cast<int>(std::max(0.0, b - a - 8))));
  }
}

// Paints the loudness of each sound, pixel by pixel.
void Ruler::paint_sounds(QPainter& p) const {
  const Colors& c = colors();
  for (const SoundBar& bar : sounds_) {
    const QRectF box = sound_box(bar);
    const bool selected = std::ranges::find(workspace_.selected(), bar.id) != workspace_.selected().end();
    p.fillRect(box, faint(c.accent, selected ? 0.35F : 0.15F));
    const double left = std::max<double>(box.left(), axis_.gutter()), right = std::min<double>(box.right(), width());
    p.setPen(QPen(c.accent, 1));
    for (double x = std::floor(left) + 0.5; x < right; ++x) {
      const double loud = bar.peak > 0 ? std::min(1.0, bar.loudness(time_at(x), time_at(x + 1)) / bar.peak) : 0;
      const double h = loud * box.height() / 2;
      p.drawLine(QPointF(x, box.center().y() - h), QPointF(x, box.center().y() + h));
    }
    p.setPen(selected ? c.selected : c.text);
    p.drawText(QRectF(std::max<double>(left, box.left()) + 4, box.top(), box.width(), line_height()), Qt::AlignVCenter,
               QString::fromStdString(bar.name));
    if (bar.words) paint_words(p, bar);
  }
}

void Ruler::press(QMouseEvent* e) {
  from_ = e->position();
  note_ = note_at(from_);
  edge_ = e->modifiers() & Qt::AltModifier ? Edge::none : edge_at(from_);
  sound_.reset();
  if (const auto i = sound_at(from_); i && !note_ && edge_ == Edge::none) {
    sound_ = sounds_[*i].id, sound_from_ = sounds_[*i].from;
    workspace_.select({*sound_});
  }
  section_.reset(), clicked_.reset();
  if (const auto i = block_at(from_); i && !note_ && edge_ == Edge::none)
    section_ = sections_[*i].section, stretches_ = at_section_end(sections_[*i], from_), clicked_ = section_->begin;
  step_.reset();
  if (const auto i = step_at(from_)) clicked_ = step_ = steps_[*i].time;
  if (const auto at = word_at(from_)) clicked_ = sounds_[at->bar].time_of_word(at->word);
  if (part_box().contains(from_.toPoint()) && e->modifiers() & Qt::AltModifier) note_.reset();
  update();
}

// Returns the time to which the film's first or last frame is dragged.
Time Ruler::edge_time(const QMouseEvent& e) const {
  const auto [from, to] = workspace_.document().range();
  const Time there = nearest_frame(time_at(e.position().x()));
  return edge_ == Edge::first ? std::min(there, to) : std::max(there, from);
}

std::string Ruler::moving(const QMouseEvent& e) const {
  if (edge_ != Edge::none) {
    auto [from, to] = workspace_.document().range();
    const auto before = std::pair(from, to);
    edge_ == Edge::first ? from = edge_time(e) : to = edge_time(e);
    return std::pair(from, to) == before ? "" : fmt::format("range {} {}", workspace_.when(from), workspace_.when(to));
  }
  if (sound_) {
    Time to = sound_from_ + (time_at(e.position().x()) - time_at(from_.x()));
    if (!(e.modifiers() & Qt::ControlModifier)) to = nearest_frame(to);
    return to == sound_from_ ? "" : fmt::format("set {}.at {}", workspace_.name(*sound_), workspace_.when(to));
  }
  if (section_) return section_moving(e);
  if (!note_ && !step_) return {};
  const Time from = note_ ? *note_ : *step_;
  Time to = from + (time_at(e.position().x()) - time_at(from_.x()));
  if (!(e.modifiers() & Qt::ControlModifier)) to = nearest_frame(to);
  return to == from ? ""
                    : fmt::format("move {} {} by {}", note_ ? "notes" : "steps", segment_words(workspace_, from, from),
                                  length_words(workspace_, to - from));
}

void Ruler::drag(QMouseEvent* e) {
  if ((e->position() - from_).manhattanLength() < 3) return;
  if (edge_ != Edge::none) {  // without a preview of the film, which would change the scale of the ruler
    edge_to_ = edge_time(*e);
    return update();
  }
  const std::string line = moving(*e);
  line.empty() ? workspace_.look_back() : void(workspace_.look_ahead({line}));
}

void Ruler::release(QMouseEvent* e) {
  const bool moved = (e->position() - from_).manhattanLength() >= 3;
  const std::string line = moved ? moving(*e) : "";
  if (moved && section_ && line.empty() && !section_line(workspace_.text(), section_->name))
    QToolTip::showText(e->globalPosition().toPoint(), tr("the section is in a file that the script uses"), this);
  section_.reset();
  workspace_.look_back();
  edge_ = Edge::none, edge_to_.reset(), sound_.reset();
  if (clicked_ && !moved) workspace_.pause(), workspace_.go_to(*clicked_);
  if (line.empty()) return;
  if (workspace_.say(line)) note_.reset(), step_.reset();
}

void Ruler::call_off() {
  section_.reset();
  workspace_.look_back();
  note_.reset(), step_.reset(), edge_ = Edge::none, edge_to_.reset(), sound_.reset();
}

void Ruler::hover(QMouseEvent* e) {
  const auto note = note_at(e->position());
  const Edge edge = edge_at(e->position());
  const auto section = block_at(e->position());
  const bool sizes = edge != Edge::none || (section && at_section_end(sections_[*section], e->position()));
  setCursor(sizes ? Qt::SizeHorCursor : Qt::ArrowCursor);
  QString words;
  if (section) words = section_tip(sections_[*section], e->position());
  if (edge != Edge::none)
    words = edge == Edge::first ? tr("the film's first frame: drag it") : tr("the film's last frame: drag it");
  if (const auto step = step_at(e->position())) words = step_tip(steps_[*step]);
  if (const auto at = word_at(e->position())) words = text_of(sounds_[at->bar].moment_of_word(at->word));
  if (note)
    for (const Note& n : workspace_.document().notes(*note, *note))
      words += QString::fromStdString(note_line(n) + "\n");
  setToolTip(tip_of(words.trimmed()));
}

bool Ruler::key(int key, Qt::KeyboardModifiers modifiers, bool act) {
  if ((!note_ && !step_) || (key != Qt::Key_Delete && key != Qt::Key_Backspace))
    return EventActions::of(workspace_).key(key, modifiers, act);
  if (!act) return true;
  workspace_.say(note_ ? fmt::format("clear notes {}", workspace_.when(*note_))
                       : fmt::format("clear steps {}", workspace_.when(*step_)));
  note_.reset(), step_.reset();
  return true;
}

void Ruler::mouseDoubleClickEvent(QMouseEvent* e) {
  if (e->button() != Qt::LeftButton || e->position().x() < axis_.gutter()) return;
  if (const auto step = step_at(e->position())) return write_step(steps_[*step].time);
  const auto note = note_at(e->position());
  write_note(note ? *note : time_at(e->position(), e->modifiers()),
             note ? std::optional<std::size_t>(0) : std::nullopt);
}

void Ruler::contextMenuEvent(QContextMenuEvent* e) {
  if (const auto at = word_at(e->pos())) {
    const QString moment = text_of(sounds_[at->bar].moment_of_word(at->word));
    if (moment.isEmpty()) return;
    QApplication::clipboard()->setText(moment);
    return QToolTip::showText(e->globalPos(), tip_of(tr("copied: %1").arg(moment)), this);
  }
  const Time t = nearest_frame(time_at(e->pos().x()));
  const auto note = note_at(e->pos());
  QMenu menu;
  menu.setToolTipsVisible(true);
  const auto row = [&](const QString& what, const std::string& line) {
    QAction* a = menu.addAction(what);
    a->setToolTip(tip_of(QString::fromStdString(line)));
    connect(a, &QAction::triggered, this, [this, line] { workspace_.say(line); });
  };
  if (note) row(tr("Delete note"), fmt::format("clear notes {}", workspace_.when(*note)));
  if (note) add_colors(*menu.addMenu(tr("Colour of the note")), *note);
  connect(menu.addAction(tr("Add note here…")), &QAction::triggered, this, [this, t] { write_note(t, std::nullopt); });
  if (const auto step = step_at(e->pos()))
    row(tr("Delete step"), fmt::format("clear steps {}", workspace_.when(steps_[*step].time)));
  connect(menu.addAction(tr("Add step here…")), &QAction::triggered, this, [this, t] { write_step(t); });
  QMenu* cameras = menu.addMenu(tr("Look through, from %1 on").arg(QString::fromStdString(workspace_.when(t))));
  for (const ObjectId id : objects(workspace_.document()))
    if (kind(workspace_.document(), id) == Kind::camera) {
      const std::string line = fmt::format("at {} look through {}", workspace_.when(t), workspace_.name(id));
      connect(cameras->addAction(QString::fromStdString(workspace_.name(id))), &QAction::triggered, this,
              [this, line] { workspace_.say(line); });
    }
  cameras->setEnabled(!cameras->isEmpty());
  menu.addSeparator();
  connect(menu.addAction(tr("Set play range start here")), &QAction::triggered, this,
          [this, t] { workspace_.set_range(std::pair(t, std::max(t, workspace_.playhead().last()))); });
  connect(menu.addAction(tr("Set play range end here")), &QAction::triggered, this,
          [this, t] { workspace_.set_range(std::pair(std::min(t, workspace_.playhead().first()), t)); });
  connect(menu.addAction(tr("Clear play range")), &QAction::triggered, this,
          [this] { workspace_.set_range(std::nullopt); });
  menu.exec(e->globalPos());
}

}  // namespace betwixt::studio
