// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The script editor's text and the film's: passes on what the user types, and shows what was changed elsewhere.
#include <QScrollBar>

#include "editor/placing.h"
#include "studio/script/script_edit.h"
#include "studio/shell/text_of.h"
#include "studio/shell/theme.h"

namespace betwixt::studio {
namespace {

constexpr std::size_t at_once = 400'000;     // bytes; longer texts are read after a pause in typing
constexpr std::size_t first_part = 100'000;  // bytes of a long text that the editor shows first, and then adds at once
constexpr int least_pause = 50;              // ms
constexpr int flash_lasts = 700;             // ms
constexpr int most_flashing = 200;           // lines

QString without_returns(std::string_view text) { return text_of(text).replace("\r\n", "\n"); }

}  // namespace

void ScriptEdit::changed_here(int at, int removed, int added) {
  if (removed == 0 && added == 0) return;
  if (typed_) follow_typing(at, removed, added);
  const int first = document()->findBlock(at).blockNumber();
  const int last = document()->findBlock(at + added).blockNumber();
  states_changed(first, (last < 0 ? blockCount() - 1 : last) - first + 1);
  colored_ = false;
}

void ScriptEdit::typed() {
  if (taking_) return;
  if (known_.size() < at_once) return pass_on();
  if (pass_on_soon_.isActive()) return;
  pass_on_soon_.start(passed_on_.isValid() ? std::max(0, pause_ - static_cast<int>(passed_on_.elapsed())) : 0);
}

// Applies a change to the copy of a long text. Reading all of the document would take ten times as long. A character
// beyond ASCII has more bytes than places in the document; then the sizes differ, and there is no copy.
void ScriptEdit::follow_typing(int at, int removed, int added) {
  const auto from = static_cast<std::size_t>(at), gone = static_cast<std::size_t>(removed);
  if (taking_ || from + gone > typed_->size() || at + added >= document()->characterCount()) return typed_.reset();
  QTextCursor c(document());
  c.setPosition(at);
  c.setPosition(at + added, QTextCursor::KeepAnchor);
  typed_->replace(from, gone, c.selectedText().replace(QChar::ParagraphSeparator, '\n').toStdString());
  if (typed_->size() + 1 != static_cast<std::size_t>(document()->characterCount())) typed_.reset();
}

std::string ScriptEdit::whole_text() {
  if (typed_) return *typed_;
  QString raw = document()->toRawText();
  raw.replace(QChar::ParagraphSeparator, '\n');
  if (crlf_) raw.replace("\n", "\r\n");
  std::string text = raw.toStdString();
  if (text.size() > at_once && text.size() + 1 == static_cast<std::size_t>(document()->characterCount())) typed_ = text;
  return text;
}

// Passes the typed text on as the film's: a long one at once after a pause, and then not again before twice the time
// that reading it took, at most two seconds.
void ScriptEdit::pass_on() {
  if (!workspace_.jobs().hears()) return pass_on_soon_.start(least_pause);
  pass_on_soon_.stop();
  QElapsedTimer took;
  took.start();
  std::string text = whole_text();
  if (text == known_) return;
  known_ = text;
  workspace_.retype(std::move(text));
  pause_ = static_cast<int>(std::clamp<qint64>(2 * took.elapsed(), least_pause, 2000));
  passed_on_.start();
}

// A long text fills the editor part by part, so that the first picture does not wait for it. A key gets all the rest.
void ScriptEdit::fill() {
  if (!filling()) return fills_.stop();
  const std::size_t from = *filled_, feed = known_.find('\n', std::min(from + first_part, known_.size()));
  const std::size_t end = feed == std::string::npos ? known_.size() : feed + 1;
  taking_ = true;
  QTextCursor c(document());
  c.movePosition(QTextCursor::End);
  c.insertText(without_returns(std::string_view(known_).substr(from, end - from)));
  taking_ = false;
  filled_ = end;
  if (end < known_.size()) return;
  filled_.reset(), fills_.stop();
  setReadOnly(!may_type());
}

void ScriptEdit::fill_all() {
  while (filling()) fill();
}

void ScriptEdit::inputMethodEvent(QInputMethodEvent* e) {
  fill_all();
  WordEdit::inputMethodEvent(e);
}

bool ScriptEdit::may_type() const { return !filling() && workspace_.session().may_change(); }

// Takes over changes made elsewhere. Replaces only the text that differs.
void ScriptEdit::take_text() {
  const std::string& now = workspace_.text();
  if (now == known_) return;
  fill_all();
  if (pass_on_soon_.isActive()) {  // both sides have changes: merge them if possible
    pass_on_soon_.stop();
    const std::string ours = whole_text();
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
  typed_.reset();
  if (before.empty() && now.size() > at_once) {
    filled_ = now.find('\n', first_part) + 1;
    setPlainText(without_returns(std::string_view(now).substr(0, *filled_)));
    setReadOnly(true);
    fills_.start(0);
  } else if (before.empty()) {
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

}  // namespace betwixt::studio
