// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The sections of the film on the ruler, blocks that the user drags and stretches, and the steps of a talk.
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "studio/shell/text_of.h"
#include "studio/shell/theme.h"
#include "studio/timeline/ruler.h"
#include "studio/timeline/section_lines.h"
#include "studio/timeline/time_words.h"

namespace betwixt::studio {
namespace {

constexpr int most_section_rows = 4;  // what overlaps more than that shares the last row

QColor section_color(std::size_t number) {
  const Colors& c = colors();
  const QColor all[] = {c.accent, c.note, c.cut, c.z};
  return all[number % std::size(all)];
}

}  // namespace

std::vector<SectionBlock> section_blocks(const std::vector<Section>& sections) {
  std::vector<SectionBlock> blocks;
  std::vector<std::size_t> order;
  for (const Section& s : sections) order.push_back(blocks.size()), blocks.push_back({s});
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return blocks[i].section.begin; });
  std::vector<Time> ends;  // of the last block in each row
  for (const std::size_t i : order) {
    const Section& s = blocks[i].section;
    auto free = std::ranges::find_if(ends, [&](Time end) { return end <= s.begin; });
    if (free == ends.end() && ends.size() < most_section_rows) free = ends.insert(free, s.end);
    if (free == ends.end()) --free;
    blocks[i].row = static_cast<int>(free - ends.begin());
    *free = std::max(*free, s.end);
  }
  return blocks;
}

QRectF Ruler::section_box(const SectionBlock& block) const {
  const double a = x_of(block.section.begin), b = std::max(a + 3, x_of(block.section.end));
  return {a, ruler_height() + line_height() * (2.5 + block.row), b - a, line_height() * 0.9};
}

std::optional<std::size_t> Ruler::block_at(const QPointF& at) const {
  for (std::size_t i = sections_.size(); i-- > 0;)
    if (section_box(sections_[i]).contains(at)) return i;
  return std::nullopt;
}

// A narrow block has no edge, so that it can be moved.
bool Ruler::at_section_end(const SectionBlock& block, const QPointF& at) const {
  const QRectF box = section_box(block);
  const double near = line_height() * 0.3;
  return block.section.end > block.section.begin && box.width() > 3 * near && at.x() > box.right() - near;
}

void Ruler::paint_sections(QPainter& p) const {
  const Colors& c = colors();
  for (std::size_t i = 0; i < sections_.size(); ++i) {
    const QRectF box = section_box(sections_[i]);
    if (box.right() < axis_.gutter() || box.left() > width()) continue;
    const bool dragged = section_ && section_->name == sections_[i].section.name;
    p.fillRect(box.adjusted(0, 0, -1, 0), faint(section_color(i), dragged ? 0.6F : 0.3F));
    p.fillRect(QRectF(box.left(), box.top(), 2, box.height()), section_color(i));
    p.setPen(dragged ? c.selected : c.text);
    // The name stays in view while the beginning of the block is not.
    const QRectF words = QRectF(box).adjusted(std::max(0.0, axis_.gutter() - box.left()) + 6, 0, -4, 0);
    if (words.width() < fontMetrics().averageCharWidth()) continue;
    p.drawText(
        words, Qt::AlignVCenter,
        fontMetrics().elidedText(text_of(sections_[i].section.name), Qt::ElideRight, static_cast<int>(words.width())));
  }
}

void Ruler::describe() {
  constexpr std::size_t most = 20;
  QStringList said;
  for (std::size_t i = 0; i < std::min(most, sections_.size()); ++i)
    said += tr("section %1 from %2 to %3")
                .arg(text_of(sections_[i].section.name), text_of(workspace_.when(sections_[i].section.begin)),
                     text_of(workspace_.when(sections_[i].section.end)));
  for (std::size_t i = 0; i < std::min(most, steps_.size()); ++i)
    said += tr("step %1 at %2").arg(text_of(steps_[i].text), text_of(workspace_.when(steps_[i].time)));
  setAccessibleDescription(said.join(", "));
}

// A step's box ends at the next one.
QRectF Ruler::step_box(std::size_t i) const {
  const double x = x_of(steps_[i].time), flag = line_height() * 0.5;
  const double words = steps_[i].text.empty() ? 0 : fontMetrics().horizontalAdvance(text_of(steps_[i].text)) + 6;
  double w = flag + words;
  if (i + 1 < steps_.size()) w = std::min(w, std::max(3.0, x_of(steps_[i + 1].time) - x - 2));
  return {x, ruler_height() + line_height() * steps_top(), w, line_height() * 0.9};
}

std::optional<std::size_t> Ruler::step_at(const QPointF& at) const {
  const auto behind = std::ranges::upper_bound(steps_, time_at(at.x() + 2), {}, &Pause::time);
  if (behind == steps_.begin()) return std::nullopt;
  const auto i = static_cast<std::size_t>(behind - steps_.begin() - 1);
  return step_box(i).adjusted(-2, 0, 0, 0).contains(at) ? std::optional(i) : std::nullopt;
}

void Ruler::paint_steps(QPainter& p) const {
  const Colors& c = colors();
  const auto first = std::ranges::lower_bound(steps_, time_at(-width()), {}, &Pause::time);
  double free = -1e9;  // of steps that overlap, paint the first
  for (auto step = first; step != steps_.end() && x_of(step->time) <= width(); ++step) {
    if (x_of(step->time) < free) continue;
    const QRectF box = step_box(static_cast<std::size_t>(step - steps_.begin()));
    free = box.left() + 3;
    const double flag = std::min(line_height() * 0.45, box.width());
    const QColor color = step_ == step->time ? c.selected : c.event;
    p.fillRect(QRectF(box.left() - 1, box.top(), 2, box.height()), color);
    p.setPen(Qt::NoPen), p.setBrush(color);
    p.drawPolygon(
        QPolygonF({box.topLeft(), box.topLeft() + QPointF(flag, flag / 2), box.topLeft() + QPointF(0, flag)}));
    p.setBrush(Qt::NoBrush), p.setPen(c.text);
    const QRectF words = box.adjusted(flag + 3, 0, 0, 0);
    if (words.width() >= fontMetrics().averageCharWidth())
      p.drawText(words, Qt::AlignVCenter | Qt::TextSingleLine,
                 fontMetrics().elidedText(text_of(step->text).simplified(), Qt::ElideRight,
                                          static_cast<int>(std::ceil(words.width()))));
  }
}

void Ruler::write_step(Time t) {
  Pause step{t, {}, {}};
  bool there = false;
  for (const Pause& p : steps_)
    if (p.time == t) step = p, there = true;
  const QRect box(static_cast<int>(x_of(t)), ruler_height() + static_cast<int>(line_height() * steps_top()), 0, 0);
  write_words(box, step.text, tr("the name of the step at %1").arg(text_of(workspace_.when(t))),
              [this, step, there](const std::string& said) {
                if (there && said == step.text) return;
                Pause now = step;
                now.text = said;
                workspace_.say(write_pause(now, workspace_.document().rate()));
              });
}

QString Ruler::step_tip(const Pause& step) const {
  const QString name = step.text.empty() ? tr("a step") : tr("step: %1").arg(text_of(step.text));
  const QString help = "\n" + tr("click it to go there, drag it to move it, double click it to name it");
  return (step.note.empty() ? name : name + "\n" + text_of(step.note)) + help;
}

// Returns the line that writes the opener of the dragged section anew; "" if it says the same.
std::string Ruler::section_moving(const QMouseEvent& e) const {
  const std::optional<SectionLine> line = section_line(workspace_.text(), section_->name);
  if (!line) return {};
  const Time edge = stretches_ ? section_->end : section_->begin;
  Time to = edge + (time_at(e.position().x()) - time_at(from_.x()));
  if (!(e.modifiers() & Qt::ControlModifier)) to = nearest_frame(to);
  if (to == edge || (stretches_ && to <= section_->begin)) return {};
  const double length = static_cast<double>((to - section_->begin).flicks);
  std::string now;
  if (!stretches_) {
    now = section_at(line->text, workspace_.when(to));
  } else if (section_has_length(line->text)) {
    now = section_for(line->text, length_words(workspace_, Time{std::llround(length * section_->speed)}));
  } else {
    const double before = static_cast<double>((section_->end - section_->begin).flicks);
    now = section_speed(line->text, std::clamp(section_->speed * before / length, 0.001, 1000.0));
  }
  return now == line->text ? "" : Session::rewrite_line(line->number, line->number, now);
}

QString Ruler::section_tip(const SectionBlock& block, const QPointF& at) const {
  if (at_section_end(block, at)) return tr("the end of the section: drag it");
  return tr("section %1 from %2 to %3")
             .arg(text_of(block.section.name), text_of(workspace_.when(block.section.begin)),
                  text_of(workspace_.when(block.section.end))) +
         "\n" + tr("click it to go there, drag it to move it");
}

}  // namespace betwixt::studio
