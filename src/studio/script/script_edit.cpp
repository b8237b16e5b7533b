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

constexpr const char* indent = "  ";

std::size_t bytes_before(const QString& line, int column) {
  return static_cast<std::size_t>(line.left(column).toUtf8().size());
}
int column_of(const std::string& line, std::size_t bytes) {
  return static_cast<int>(QString::fromUtf8(line.data(), static_cast<qsizetype>(bytes)).size());
}

}  // namespace

ScriptEdit::ScriptEdit(Workspace& workspace, QWidget* parent) : WordEdit(workspace, parent) {
  setObjectName("script");
  setLineWrapMode(QPlainTextEdit::NoWrap);
  setTabStopDistance(2 * fontMetrics().horizontalAdvance(' '));
  setMouseTracking(true);
  pass_on_soon_.setSingleShot(true), flash_ends_.setSingleShot(true);
  connect(&pass_on_soon_, &QTimer::timeout, this, &ScriptEdit::pass_on);
  connect(&fills_, &QTimer::timeout, this, &ScriptEdit::fill);
  connect(&flash_ends_, &QTimer::timeout, this, [this] { flashing_.clear(), mark_lines(); });
  connect(document(), &QTextDocument::contentsChange, this, &ScriptEdit::changed_here);
  connect(this, &QPlainTextEdit::textChanged, this, &ScriptEdit::typed);
  connect(this, &QPlainTextEdit::cursorPositionChanged, this, &ScriptEdit::cursor_moved);
  connect(this, &QPlainTextEdit::blockCountChanged, this, &ScriptEdit::margin_changed);
  connect(this, &QPlainTextEdit::updateRequest, this, &ScriptEdit::margin_changed);
  connect(&workspace, &Workspace::text_changed, this, &ScriptEdit::take_text);
  connect(&workspace, &Workspace::document_changed, this, &ScriptEdit::take_diagnostics);
  connect(&workspace, &Workspace::opened, this, [this] {
    setReadOnly(!may_type());
    moveCursor(QTextCursor::Start);
  });
  connect(&workspace, &Workspace::colors_changed, this,
          [this] { colored_ = false, mark_lines(), viewport()->update(); });
  connect(&workspace, &Workspace::selection_changed, this, [this] { colored_ = false, viewport()->update(); });
  connect(&workspace, &Workspace::script_line_changed, this, [this] {
    const int line = workspace_.script_line();
    if (line > 0 && !hasFocus()) show_line(line);
  });
  take_text();
  take_diagnostics();
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
  setFocus();
  show_line(line, column);
}

void ScriptEdit::show_line(int line, int column) {
  if (line > blockCount()) fill_all();
  const QTextBlock b = document()->findBlockByNumber(line - 1);
  if (!b.isValid()) return;
  QTextCursor c(b);
  c.movePosition(QTextCursor::Right, QTextCursor::MoveAnchor, std::min(column - 1, b.length() - 1));
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
  return "at " + std::string(time) + " " + std::string(without_indent(opener)) + std::string(rest);
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
  fill_all();
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
      if (opens_sheet(line) || opens_block(line))
        insertPlainText(QString::fromStdString(line.substr(0, blanks)) + indent);
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
