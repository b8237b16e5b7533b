// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The script editor's margin, and its colours, which it computes only for visible lines.
#include <QPainter>
#include <QTextLayout>

#include "commands/line_head.h"
#include "editor/named_objects.h"
#include "scene/colors.h"
#include "studio/script/script_edit.h"
#include "studio/shell/text_of.h"
#include "studio/shell/theme.h"

namespace betwixt::studio {
namespace {

constexpr int most_above = 200'000;  // lines to search upwards for the start of a sheet
constexpr int states_in_a_row = 20'000;

// Packs a state into the number that a block stores; -1 means none.
int packed(const LineState& s) { return s.brackets * 2 + (s.text ? 1 : 0); }
LineState unpacked(int n) { return n < 0 ? LineState{} : LineState{n / 2, n % 2 != 0}; }

QColor color_of(Meaning m) {
  const Colors& c = colors();
  switch (m) {
    case Meaning::comment:
      return c.dim;
    case Meaning::text:
      return c.note;
    case Meaning::verb:
      return c.accent;
    case Meaning::kind:
      return c.z;
    case Meaning::function:
      return c.warning;
    case Meaning::twerper:
      return c.cut;
    case Meaning::option:
      return c.dim;
    case Meaning::time:
      return c.playhead;
    case Meaning::number:
      return c.event;
    case Meaning::color:
    case Meaning::name:
      return c.text;
  }
  return c.text;
}

// Returns the colour that a word names, or nullopt.
std::optional<QColor> said_color(std::string_view word) {
  if (const auto rgb = named_color(word)) return QColor(static_cast<QRgb>(*rgb));
  const QColor c(text_of(word));
  if (word.starts_with('#') && c.isValid()) return c;
  return std::nullopt;
}

}  // namespace

// Computes the states up to and including a block.
void ScriptEdit::know_states(int last_block) {
  if (stated_ > last_block) return;
  QTextBlock b = document()->findBlockByNumber(stated_);
  LineState s = state_above(b);
  for (; b.isValid() && stated_ <= last_block; b = b.next(), ++stated_) {
    pass_line(b.text().toStdString(), s);
    b.setUserState(packed(s));
  }
}

// Updates the states below changed blocks, down to the first one that stays the same.
void ScriptEdit::states_changed(int first_block, int blocks) {
  if (first_block >= stated_) return;
  QTextBlock b = document()->findBlockByNumber(first_block);
  LineState s = state_above(b);
  for (int n = 0; b.isValid(); b = b.next(), ++n) {
    pass_line(b.text().toStdString(), s);
    const bool same = b.userState() == packed(s);
    b.setUserState(packed(s));
    if (n + 1 >= blocks && same) {  // inserted lines have shifted the rest
      stated_ = std::max(stated_, first_block + n + 1);
      return;
    }
    if (n > blocks + states_in_a_row) break;
  }
  stated_ = b.isValid() ? b.blockNumber() : blockCount();
}

LineState ScriptEdit::state_above(const QTextBlock& b) const {
  return b.previous().isValid() ? unpacked(b.previous().userState()) : LineState{};
}

// Returns the line that opens the sheet of a row, or "" if the line is no row.
std::string ScriptEdit::opener_above(const QTextBlock& block) const {
  std::size_t least = indentation(block.text().toStdString());
  std::string found;
  QTextBlock b = block.previous();
  for (int n = 0; b.isValid() && least > 0 && n < most_above; b = b.previous(), ++n) {
    const std::string line = b.text().toStdString();
    if (empty_line(line) || indentation(line) >= least || state_above(b).goes_on()) continue;
    least = indentation(line);
    if (opens_sheet(line)) found = without_comment(line);
  }
  return found;
}

void ScriptEdit::color_what_is_seen() {
  QTextBlock b = firstVisibleBlock();
  const int from = b.blockNumber();
  const int rows = viewport()->height() / std::max(1, fontMetrics().lineSpacing()) + 1;
  const int to = std::min(blockCount() - 1, from + rows);
  if (colored_ && from == colored_from_ && to == colored_to_) return;
  colored_ = true, colored_from_ = from, colored_to_ = to;
  if (from > stated_ + states_in_a_row && stated_ < blockCount()) {
    know_states(stated_ + states_in_a_row);  // the rest follows in later paint events
    colored_ = false;
    QTimer::singleShot(0, viewport(), [this] { viewport()->update(); });
  } else {
    know_states(to);
  }
  speaking_.all.clear();
  std::string opener = opener_above(b);  // of the sheet that is open
  std::size_t margin = indentation(opener);
  for (; b.isValid() && b.blockNumber() <= to; b = b.next()) {
    const std::string line = b.text().toStdString();
    const bool row = !opener.empty() && indentation(line) > margin;
    if (names_any(line, row ? opener : "", workspace_.document(), workspace_.selected()))
      speaking_.all.push_back(b.blockNumber() + 1);
    color(b, row);
    if (!row && !empty_line(line) && !state_above(b).goes_on())
      opener = std::string(opens_sheet(line) ? without_comment(line) : ""), margin = indentation(line);
  }
  emit margin_changed();
}

void ScriptEdit::color(QTextBlock b, bool row) {
  const QString text = b.text();
  const std::string line = text.toStdString();
  const bool plain = static_cast<qsizetype>(line.size()) == text.size();
  const auto place = [&](std::size_t bytes) {
    return plain ? static_cast<int>(bytes)
                 : static_cast<int>(QString::fromUtf8(line.data(), static_cast<qsizetype>(bytes)).size());
  };
  QList<QTextLayout::FormatRange> all;
  LineState state = state_above(b);
  const auto& selected = workspace_.selected();
  for (const LinePiece& p : line_pieces(line, state, workspace_.document(), row)) {
    QTextCharFormat f;
    f.setForeground(color_of(p.meaning));
    const std::string_view word = std::string_view(line).substr(p.at, p.length);
    if (p.meaning == Meaning::color) {
      if (const auto c = said_color(word)) f.setFontUnderline(true), f.setUnderlineColor(*c);
    } else if (p.meaning == Meaning::name && !selected.empty()) {
      if (names_any(word, {}, workspace_.document(), selected)) {
        QColor lit = colors().accent;
        lit.setAlpha(60);
        f.setBackground(lit);
      }
    }
    const int from = place(p.at);
    all.push_back({from, place(p.at + p.length) - from, f});
  }
  const auto [from, to] = of_lines_.equal_range(b.blockNumber() + 1);
  for (auto i = from; i != to; ++i) {
    const Diagnostic& d = *i->second;
    QTextCharFormat f;
    f.setUnderlineStyle(QTextCharFormat::WaveUnderline);
    f.setUnderlineColor(d.severity == Severity::error     ? colors().error
                        : d.severity == Severity::warning ? colors().warning
                                                          : colors().dim);
    const int at = std::clamp(d.what.place.column - 1, 0, std::max(0, static_cast<int>(text.size()) - 1));
    const int length = std::max(1, std::min(d.what.place.length, static_cast<int>(text.size()) - at));
    all.push_back({at, length, f});
  }
  if (b.layout()->formats() == all) return;
  b.layout()->setFormats(all);
  document()->markContentsDirty(b.position(), b.length());
}

void ScriptEdit::paintEvent(QPaintEvent* e) {
  color_what_is_seen();
  WordEdit::paintEvent(e);
}

int ScriptEdit::margin_width() const {
  const int em = fontMetrics().horizontalAdvance('0');
  return em * (static_cast<int>(QString::number(std::max(99, blockCount())).size()) + 2);
}

// Paints the line numbers, a bar beside lines that name a selected object, and a dot at diagnostics.
void ScriptEdit::paint_margin(QPainter& p, QRect area) {
  const Colors& c = colors();
  p.fillRect(area, c.back);
  p.setFont(font());
  const int em = fontMetrics().horizontalAdvance('0'), high = fontMetrics().height();
  for (QTextBlock b = firstVisibleBlock(); b.isValid(); b = b.next()) {
    const QRectF at = blockBoundingGeometry(b).translated(contentOffset());
    if (at.top() > area.bottom()) break;
    const int line = b.blockNumber() + 1, y = static_cast<int>(at.top());
    if (speaking_.contains(line)) p.fillRect(area.right() - 3, y, 3, static_cast<int>(at.height()), c.accent);
    const Diagnostic* d = said_of(line);
    const bool here = b == textCursor().block();
    p.setPen(d && d->severity == Severity::error ? c.error : d ? c.warning : here ? c.text : c.dim);
    p.drawText(QRect(0, y, area.width() - em, high), Qt::AlignRight, QString::number(line));
    if (!d) continue;
    p.setBrush(p.pen().color());
    p.setRenderHint(QPainter::Antialiasing);
    p.drawEllipse(QRectF(em * 0.2, y + high / 2.0 - em * 0.3, em * 0.6, em * 0.6));
  }
}

}  // namespace betwixt::studio
