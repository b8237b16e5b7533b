// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The notes of the ruler; other tools call them markers.
#include <fmt/format.h>

#include <QLineEdit>
#include <QMenu>
#include <algorithm>

#include "language/values.h"
#include "studio/shell/theme.h"
#include "studio/timeline/ruler.h"

namespace betwixt::studio {
namespace {

// The colours to choose from, by the names that the script gets.
constexpr const char* note_colors[] = {"tomato", "orange", "gold", "limegreen", "deepskyblue", "orchid", "silver"};

}  // namespace

std::string Ruler::note_line(const Note& note) const {
  return fmt::format("at {} note {}{}", workspace_.when(note.time), write_text(note.text),
                     note.color ? " color=" + write_color(*note.color) : "");
}

QRectF Ruler::note_box(Time t) const {
  const double top = ruler_height() + line_height() * 1.45;
  const auto there = workspace_.document().notes(t, t);
  const double words = there.empty() ? 0 : fontMetrics().horizontalAdvance(QString::fromStdString(there[0].text));
  // A note's box ends at the next note.
  double w = words + line_height() * 0.6;
  const auto next = workspace_.document().notes(t + Time{1}, time_at(x_of(t) + w));
  if (!next.empty()) w = std::max(line_height() * 0.4, x_of(next[0].time) - x_of(t) - 2);
  return {x_of(t), top, w, line_height() * 0.95};
}

std::optional<Time> Ruler::note_at(const QPointF& at) const {
  std::optional<Time> found;
  const auto all = workspace_.document().notes(time_at(at.x() - width()), time_at(at.x() + 3));
  for (const Note& n : all)
    if (note_box(n.time).adjusted(-2, 0, 0, 0).contains(at)) found = n.time;
  return found;
}

void Ruler::paint_notes(QPainter& p) const {
  const Colors& c = colors();
  double free = -1e9;  // of notes that overlap, paint the first
  for (const Note& n : workspace_.document().notes(time_at(-width()), time_at(width()))) {
    const double x = x_of(n.time);
    if (x < free) continue;
    const QRectF box = note_box(n.time);
    const QColor color = n.color ? swatch(*n.color) : c.note;
    QColor back = color;
    back.setAlphaF(note_ == n.time ? 0.5F : 0.2F);
    p.fillRect(box, back);
    p.fillRect(QRectF(x - 1, box.y(), 2, box.height()), note_ == n.time ? c.selected : color);
    p.setPen(c.text);
    const QString text = fontMetrics().elidedText(QString::fromStdString(n.text).simplified(), Qt::ElideRight,
                                                  static_cast<int>(box.width()) - 6);
    p.drawText(box.adjusted(5, 0, 0, 0), Qt::AlignVCenter, text);
    free = x + 3;
  }
}

void Ruler::write_words(const QRect& box, const std::string& before, const QString& hint,
                        const std::function<void(const std::string&)>& done) {
  delete words_;
  words_ = new QLineEdit(this);
  words_->setObjectName("note_words");
  words_->setText(QString::fromStdString(before)), words_->setPlaceholderText(hint);
  words_->setGeometry(std::min(box.x(), std::max(0, width() - 12 * line_height())), box.y() - 2, 12 * line_height(),
                      line_height() + 4);
  words_->show(), words_->setFocus(), words_->selectAll();
  connect(words_, &QLineEdit::editingFinished, this, [this, done] {
    if (!words_) return;
    const std::string said = words_->text().toStdString();
    words_->deleteLater(), words_ = nullptr;
    done(said);
    setFocus();
  });
}

void Ruler::write_note(Time t, std::optional<std::size_t> which) {
  const auto there = workspace_.document().notes(t, t);
  const auto done = [this, t, which, there](const std::string& said) {
    std::vector<std::string> lines;
    const auto line = [&](Note note, const std::string& text) {
      note.text = text;
      if (!text.empty()) lines.push_back(note_line(note));
    };
    if (!which) {
      line({t, {}, {}}, said);
    } else if (there[*which].text != said) {
      lines.push_back(fmt::format("clear notes {}", workspace_.when(t)));
      for (std::size_t i = 0; i < there.size(); ++i) line(there[i], i == *which ? said : there[i].text);
    }
    if (!lines.empty()) workspace_.say(lines);
  };
  write_words(note_box(t).toRect(), which ? there[*which].text : "",
              tr("a note at %1").arg(QString::fromStdString(workspace_.when(t))), done);
}

void Ruler::add_note() { write_note(workspace_.time(), std::nullopt); }

void Ruler::add_colors(QMenu& menu, Time t) {
  const std::vector<Note> notes = workspace_.document().notes(t, t);
  const auto add = [&](const QString& name, const std::string& color) {
    QAction* const action = menu.addAction(name, this, [this, notes, t, color] {
      std::vector<std::string> lines{fmt::format("clear notes {}", workspace_.when(t))};
      for (Note note : notes) {
        note.color.reset();
        lines.push_back(note_line(note) + (color.empty() ? "" : " color=" + color));
      }
      workspace_.say(lines);
    });
    QPixmap icon(16, 16);
    icon.fill(color.empty() ? colors().note : QColor(QString::fromStdString(color)));
    action->setIcon(icon);
  };
  add(tr("default"), {});
  for (const char* color : note_colors) add(color, color);
}

}  // namespace betwixt::studio
