// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/script/script_edit.h"

#include <QElapsedTimer>
#include <QKeyEvent>
#include <QScrollBar>
#include <QToolTip>

#include "commands/line_head.h"
#include "editor/help.h"
#include "editor/named_objects.h"
#include "editor/placing.h"
#include "studio/shell/text_of.h"
#include "studio/shell/theme.h"
#include "syntax/tokens.h"

namespace betwixt::studio {
namespace {

constexpr std::size_t at_once = 400'000;  // bytes; longer texts are read after a pause in typing
constexpr int flash_lasts = 700;          // ms
constexpr int most_flashing = 200;        // lines
constexpr const char* indent = "  ";

std::size_t bytes_before(const QString& line, int column) {
  return static_cast<std::size_t>(line.left(column).toUtf8().size());
}
int column_of(const std::string& line, std::size_t bytes) {
  return static_cast<int>(QString::fromUtf8(line.data(), static_cast<qsizetype>(bytes)).size());
}
QString without_returns(std::string_view text) { return text_of(text).replace("\r\n", "\n"); }

}  // namespace

ScriptEdit::ScriptEdit(Workspace& workspace, QWidget* parent) : WordEdit(workspace, parent) {
  setObjectName("script");
  setLineWrapMode(QPlainTextEdit::NoWrap);
  setTabStopDistance(2 * fontMetrics().horizontalAdvance(' '));
  setMouseTracking(true);
  pass_on_soon_.setSingleShot(true), pass_on_soon_.setInterval(50), flash_ends_.setSingleShot(true);
  connect(&pass_on_soon_, &QTimer::timeout, this, &ScriptEdit::pass_on);
  connect(&flash_ends_, &QTimer::timeout, this, [this] { flashing_.clear(), mark_lines(); });
  connect(document(), &QTextDocument::contentsChange, this, &ScriptEdit::changed_here);
  connect(this, &QPlainTextEdit::textChanged, this, &ScriptEdit::typed);
  connect(this, &QPlainTextEdit::cursorPositionChanged, this, &ScriptEdit::cursor_moved);
  connect(this, &QPlainTextEdit::blockCountChanged, this, &ScriptEdit::margin_changed);
  connect(this, &QPlainTextEdit::updateRequest, this, &ScriptEdit::margin_changed);
  connect(&workspace, &Workspace::text_changed, this, &ScriptEdit::take_text);
  connect(&workspace, &Workspace::document_changed, this, &ScriptEdit::take_diagnostics);
  connect(&workspace, &Workspace::opened, this, [this] {
    setReadOnly(!workspace_.session().may_change());
    moveCursor(QTextCursor::Start);
  });
  connect(&workspace, &Workspace::colors_changed, this,
          [this] { colored_ = false, mark_lines(), viewport()->update(); });
  connect(&workspace, &Workspace::selection_changed, this, [this] { colored_ = false, viewport()->update(); });
  take_text();
  take_diagnostics();
}

void ScriptEdit::changed_here(int at, int removed, int added) {
  if (removed == 0 && added == 0) return;
  const int first = document()->findBlock(at).blockNumber();
  const int last = document()->findBlock(at + added).blockNumber();
  states_changed(first, (last < 0 ? blockCount() - 1 : last) - first + 1);
  colored_ = false;
}

void ScriptEdit::typed() {
  if (taking_) return;
  if (known_.size() < at_once) return pass_on();
  if (!pass_on_soon_.isActive()) pass_on_soon_.start();
}

// Passes the typed text on as the film's. A long text is read again after twice the time that reading it took, at most
// two seconds.
void ScriptEdit::pass_on() {
  if (!workspace_.jobs().hears()) return pass_on_soon_.start();
  pass_on_soon_.stop();
  QString raw = document()->toRawText();
  raw.replace(QChar::ParagraphSeparator, '\n');
  if (crlf_) raw.replace("\n", "\r\n");
  std::string text = raw.toStdString();
  if (text == known_) return;
  known_ = text;
  QElapsedTimer took;
  took.start();
  workspace_.retype(std::move(text));
  pass_on_soon_.setInterval(static_cast<int>(std::clamp<qint64>(2 * took.elapsed(), 50, 2000)));
}

// Takes over changes made elsewhere. Replaces only the text that differs.
void ScriptEdit::take_text() {
  const std::string& now = workspace_.text();
  if (now == known_) return;
  if (pass_on_soon_.isActive()) {  // both sides have changes: merge them if possible
    pass_on_soon_.stop();
    QString raw = document()->toRawText();
    const std::string ours = raw.replace(QChar::ParagraphSeparator, '\n').toStdString();
    if (const auto both = merge(known_, ours, now)) {
      known_ = ours;
      std::string text = *both;
      QMetaObject::invokeMethod(
          this, [this, text] { workspace_.retype(text), take_text(); }, Qt::QueuedConnection);
      return;
    }
  }
  taking_ = true;
  const QTextBlock top = firstVisibleBlock();
  const int top_was = top.blockNumber(), scrolled = verticalScrollBar()->value();
  const std::string before = std::exchange(known_, now);
  crlf_ = now.find("\r\n") != std::string::npos;
  if (before.empty()) {
    setPlainText(without_returns(now));
  } else {
    const LineChange c = change_between(before, now);
    std::size_t from = 0;
    for (int line = 1; line < c.lines.first; ++line) from = before.find('\n', from) + 1;
    std::size_t to = from;
    for (int line = c.lines.first; line <= c.lines.last && to < before.size(); ++line)
      to = std::min(before.find('\n', to), before.size() - 1) + 1;
    const QString gone = without_returns(std::string_view(before).substr(from, to - from));
    const QString come = without_returns(c.others);
    const QStringList old_lines = gone.split('\n'), new_lines = come.split('\n');
    const int first = c.lines.first - 1;
    flashing_.clear();  // the lines changed by the previous step
    if (old_lines.size() == new_lines.size()) {
      for (qsizetype i = 0; i < old_lines.size(); ++i)
        if (old_lines[i] != new_lines[i]) replace(first + static_cast<int>(i), old_lines[i], new_lines[i]);
    } else {
      replace(first, gone, come);
    }
  }
  taking_ = false;
  // Keep the top line in place, whatever was inserted above it.
  if (top.isValid() && top_was > 0 && top.blockNumber() > 0)
    verticalScrollBar()->setValue(scrolled + top.blockNumber() - top_was);
  cursor_moved();
}

// Replaces one text by another, from a block on. The common start and end are not touched.
void ScriptEdit::replace(int first_block, const QString& before, const QString& after) {
  qsizetype head = 0, tail = 0;
  const qsizetype most = std::min(before.size(), after.size());
  while (head < most && before[head] == after[head]) ++head;
  while (tail < most - head && before[before.size() - 1 - tail] == after[after.size() - 1 - tail]) ++tail;
  const QTextBlock block = document()->findBlockByNumber(first_block);
  const int start = block.isValid() ? block.position() : document()->characterCount() - 1;
  QTextCursor c(document());
  c.setPosition(start + static_cast<int>(head));
  c.setPosition(start + static_cast<int>(before.size() - tail), QTextCursor::KeepAnchor);
  c.insertText(after.mid(head, after.size() - head - tail));
  const int from = document()->findBlock(start + static_cast<int>(head)).blockNumber();
  const qsizetype last = std::max(head, after.size() - tail - 1);
  flash(from, document()->findBlock(start + static_cast<int>(last)).blockNumber() - from + 1);
}

void ScriptEdit::flash(int first_block, int blocks) {
  QColor color = colors().accent;
  color.setAlpha(70);
  QTextBlock b = document()->findBlockByNumber(first_block);
  for (int i = 0; i < std::min(blocks, most_flashing) && b.isValid(); ++i, b = b.next()) {
    QTextEdit::ExtraSelection s;
    s.cursor = QTextCursor(b);
    s.format.setBackground(color);
    s.format.setProperty(QTextFormat::FullWidthSelection, true);
    // Flash a line only once: two layers of the colour would make it unreadable.
    flashing_.removeIf([&](const QTextEdit::ExtraSelection& f) { return f.cursor.block() == b; });
    flashing_.push_back(s);
  }
  flash_ends_.start(flash_lasts);
  mark_lines();
}

void ScriptEdit::mark_lines() {
  QTextEdit::ExtraSelection here;
  here.cursor = textCursor();
  here.cursor.clearSelection();
  here.format.setBackground(colors().raised);
  here.format.setProperty(QTextFormat::FullWidthSelection, true);
  QList<QTextEdit::ExtraSelection> all{here};
  all += flashing_;
  setExtraSelections(all);
}

void ScriptEdit::take_diagnostics() {
  diagnostics_ = workspace_.diagnostics();
  of_lines_.clear();
  for (const Diagnostic& d : diagnostics_)
    if (d.what.place.line > 0 && (d.what.place.file.empty() || d.what.place.file == workspace_.session().file()))
      of_lines_.emplace(d.what.place.line, &d);
  colored_ = false;
  viewport()->update();
  emit margin_changed();
}

const Diagnostic* ScriptEdit::said_of(int line) const {
  const Diagnostic* worst = nullptr;
  const auto [from, to] = of_lines_.equal_range(line);
  for (auto i = from; i != to; ++i)
    if (!worst || i->second->severity > worst->severity) worst = i->second;
  return worst;
}

// Passes the cursor's line to the workspace and selects the objects that it names, if the user works in this editor.
void ScriptEdit::cursor_moved() {
  mark_lines();
  if (taking_) return;
  const int line = textCursor().blockNumber() + 1;
  if (line == workspace_.script_line() && hasFocus()) return;
  if (!hasFocus()) return;
  workspace_.set_script_line(line);
  const QTextBlock b = textCursor().block();
  std::vector<ObjectId> meant = objects_named_in(b.text().toStdString(), opener_above(b), workspace_.document());
  if (!meant.empty()) workspace_.select(std::move(meant));
}

void ScriptEdit::go_to_line(int line, int column) {
  const QTextBlock b = document()->findBlockByNumber(line - 1);
  if (!b.isValid()) return;
  QTextCursor c(b);
  c.movePosition(QTextCursor::Right, QTextCursor::MoveAnchor, std::min(column - 1, b.length() - 1));
  setFocus();
  setTextCursor(c);
  centerCursor();
}

// Completes a row of a sheet as if it were a whole command.
std::string ScriptEdit::said_so_far() const {
  const std::string line = WordEdit::said_so_far();
  const std::string opener = opener_above(textCursor().block());
  if (opener.empty() || !indented(line)) return line;
  std::string_view rest = line;
  const std::string_view time = take_piece(rest);
  if (rest.empty()) return line;
  return "at " + std::string(time) + " " + opener + std::string(rest);
}

std::optional<ScriptEdit::Number> ScriptEdit::number_under(const QTextCursor& c) const {
  const QString text = c.block().text();
  const std::string line = text.toStdString();
  const auto n = number_at(line, bytes_before(text, c.positionInBlock()));
  if (!n) return std::nullopt;
  const int at = column_of(line, n->at), length = column_of(line, n->at + n->length) - at;
  return Number{c.blockNumber(), at, length, text.mid(at, length)};
}

void ScriptEdit::put_number(Number& n, const QString& text) {
  QTextCursor c(document()->findBlockByNumber(n.block));
  const int start = c.position() + n.at;
  c.setPosition(start);
  c.setPosition(start + n.length, QTextCursor::KeepAnchor);
  c.insertText(text);
  n.length = static_cast<int>(text.size());
  c.setPosition(start + n.length);
  setTextCursor(c);
  pass_on();
}

void ScriptEdit::keyPressEvent(QKeyEvent* e) {
  const auto held = e->modifiers();
  const int step = e->key() == Qt::Key_Up ? 1 : e->key() == Qt::Key_Down ? -1 : 0;
  if (e->key() == Qt::Key_Escape && scrubbed_) {
    put_number(*scrubbed_, scrubbed_from_);
    return scrubbed_.reset();
  }
  if (step != 0 && (held & Qt::AltModifier) && !isReadOnly()) {
    if (auto n = number_under(textCursor()))
      put_number(*n, QString::fromStdString(stepped(n->text.toStdString(), step * (held & Qt::ShiftModifier ? 10 : 1),
                                                    held & Qt::ControlModifier)));
    return;
  }
  if (e->matches(QKeySequence::Undo) || e->matches(QKeySequence::Redo)) pass_on();
  const bool listed = findChild<QTreeWidget*>("words")->isVisible();
  if (!listed && held == Qt::NoModifier && !isReadOnly()) {
    if (e->key() == Qt::Key_Tab) return insertPlainText(indent);
    // The line after a row is indented like the row.
    if (e->key() == Qt::Key_Return) {
      const std::string line = textCursor().block().text().toStdString();
      const std::size_t blanks = line.size() - without_indent(line).size();
      WordEdit::keyPressEvent(e);
      if (opens_sheet(line))
        insertPlainText(indent);
      else if (blanks < line.size())
        insertPlainText(QString::fromStdString(line.substr(0, blanks)));
      return;
    }
  }
  WordEdit::keyPressEvent(e);
}

void ScriptEdit::mousePressEvent(QMouseEvent* e) {
  if (e->button() == Qt::LeftButton && (e->modifiers() & Qt::AltModifier) && !isReadOnly()) {
    if (auto n = number_under(cursorForPosition(e->position().toPoint()))) {
      scrubbed_ = n, scrubbed_from_ = n->text, scrubbed_x_ = e->position().x();
      viewport()->setCursor(Qt::SizeHorCursor);
      return;
    }
  }
  WordEdit::mousePressEvent(e);
}

void ScriptEdit::mouseMoveEvent(QMouseEvent* e) {
  if (!scrubbed_) return WordEdit::mouseMoveEvent(e);
  const double pixels = std::max(1.0, fontMetrics().averageCharWidth() / 2.0);
  const int steps = static_cast<int>(std::lround((e->position().x() - scrubbed_x_) / pixels));
  put_number(*scrubbed_, QString::fromStdString(stepped(scrubbed_from_.toStdString(),
                                                        steps * (e->modifiers() & Qt::ShiftModifier ? 10 : 1),
                                                        e->modifiers() & Qt::ControlModifier)));
}

void ScriptEdit::mouseReleaseEvent(QMouseEvent* e) {
  if (!scrubbed_) return WordEdit::mouseReleaseEvent(e);
  scrubbed_.reset();
  viewport()->setCursor(Qt::IBeamCursor);
  workspace_.settle_typing();
}

void ScriptEdit::mouseDoubleClickEvent(QMouseEvent* e) {
  const QTextCursor c = cursorForPosition(e->position().toPoint());
  const QString text = c.block().text();
  if (const auto t = time_at(text.toStdString(), bytes_before(text, c.positionInBlock()), workspace_.document()))
    workspace_.go_to(*t);
  WordEdit::mouseDoubleClickEvent(e);
}

void ScriptEdit::focusOutEvent(QFocusEvent* e) {
  pass_on();
  WordEdit::focusOutEvent(e);
}

void ScriptEdit::resizeEvent(QResizeEvent* e) {
  WordEdit::resizeEvent(e);
  emit margin_changed();
}

// Shows a tooltip: the diagnostic of the line, or the help of the word.
bool ScriptEdit::viewportEvent(QEvent* e) {
  if (e->type() != QEvent::ToolTip) return WordEdit::viewportEvent(e);
  const auto* help = static_cast<QHelpEvent*>(e);
  QTextCursor c = cursorForPosition(help->pos());
  QString shown;
  if (const Diagnostic* d = said_of(c.blockNumber() + 1)) {
    shown = QString::fromStdString(d->what.message + (d->what.hint.empty() ? "" : "\n" + d->what.hint));
  } else {
    c.select(QTextCursor::WordUnderCursor);
    const std::string word = c.selectedText().toStdString();
    for (const HelpEntry& entry : help_entries())
      if (entry.word == word && shown.isEmpty())
        shown = QString::fromStdString(word + ": " + std::string(entry.sentence));
  }
  QToolTip::showText(help->globalPos(), tip_of(shown), this);
  return true;
}

}  // namespace betwixt::studio
