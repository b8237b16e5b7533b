// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/shell/word_edit.h"

#include <QHeaderView>
#include <QKeyEvent>
#include <QScreen>
#include <QTextBlock>

#include "editor/completion.h"
#include "editor/help.h"
#include "studio/shell/text_of.h"
#include "studio/shell/text_size.h"
#include "studio/shell/theme.h"

namespace betwixt::studio {
namespace {

constexpr int most_rows = 12;

}  // namespace

WordEdit::WordEdit(Workspace& workspace, QWidget* parent)
    : QPlainTextEdit(parent), workspace_(workspace), words_(new QTreeWidget(this)) {
  setUndoRedoEnabled(false);
  setFont(script_font());
  setFrameShape(QFrame::NoFrame);
  words_->setObjectName("words");
  words_->setWindowFlags(Qt::ToolTip);
  words_->setAttribute(Qt::WA_ShowWithoutActivating);
  words_->setFocusPolicy(Qt::NoFocus);
  words_->setColumnCount(2);
  words_->header()->hide();
  words_->setRootIsDecorated(false);
  words_->setUniformRowHeights(true);
  words_->setVerticalScrollBarPolicy(Qt::ScrollBarAsNeeded);
  words_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  connect(words_, &QTreeWidget::itemClicked, this, [this](QTreeWidgetItem* i) { put(i->text(0)); });
}

std::string WordEdit::said_so_far() const {
  return textCursor().block().text().left(textCursor().positionInBlock()).toStdString();
}

void WordEdit::offer_words() {
  const std::vector<std::string> all = workspace_.session().complete(said_so_far());
  words_->hide();
  if (all.empty()) return;
  if (all.size() == 1) return put(QString::fromStdString(all[0]));
  words_->clear();
  const std::optional<Kind> kind = kind_at(said_so_far(), workspace_.document());
  for (const std::string& word : all) {
    auto* item = new QTreeWidgetItem(words_, {QString::fromStdString(word), text_of(sentence_of(word, kind))});
    item->setForeground(1, colors().dim);
  }
  words_->setCurrentItem(words_->topLevelItem(0));
  words_->resizeColumnToContents(0);
  words_->resizeColumnToContents(1);
  const int rows = std::min<int>(most_rows, static_cast<int>(all.size()));
  const int em = fontMetrics().horizontalAdvance('m');
  words_->resize(std::min(words_->columnWidth(0) + words_->columnWidth(1) + 3 * em, 70 * em),
                 rows * words_->sizeHintForRow(0) + 4);
  // Below the word, or above it at the end of the screen.
  const QRect screen = this->screen()->availableGeometry();
  QPoint at = viewport()->mapToGlobal(cursorRect().bottomLeft());
  if (at.y() + words_->height() > screen.bottom())
    at.setY(viewport()->mapToGlobal(cursorRect().topLeft()).y() - words_->height());
  at.setX(std::max(screen.left(), std::min(at.x(), screen.right() - words_->width())));
  words_->move(at);
  words_->show();
}

void WordEdit::put(const QString& word) {
  words_->hide();
  const std::string before = WordEdit::said_so_far();
  const QString begun = text_of(std::string_view(before).substr(begun_word(before)));
  QTextCursor c = textCursor();
  c.movePosition(QTextCursor::Left, QTextCursor::KeepAnchor, static_cast<int>(begun.size()));
  c.insertText(word);
  setTextCursor(c);
}

// Handles the list's keys while it is open.
bool WordEdit::chooses(QKeyEvent* e) {
  if (!words_->isVisible()) return false;
  const int at = words_->indexOfTopLevelItem(words_->currentItem()), all = words_->topLevelItemCount();
  const auto go = [&](int to) { words_->setCurrentItem(words_->topLevelItem(std::clamp(to, 0, all - 1))); };
  switch (e->key()) {
    case Qt::Key_Up:
      return go(at == 0 ? all - 1 : at - 1), true;
    case Qt::Key_Down:
      return go(at + 1 == all ? 0 : at + 1), true;
    case Qt::Key_PageUp:
      return go(at - most_rows), true;
    case Qt::Key_PageDown:
      return go(at + most_rows), true;
    case Qt::Key_Return:
    case Qt::Key_Enter:
    case Qt::Key_Tab:
      return put(words_->currentItem()->text(0)), true;
    case Qt::Key_Escape:
      return words_->hide(), true;
    default:
      return false;
  }
}

void WordEdit::keyPressEvent(QKeyEvent* e) {
  if (chooses(e)) return;
  if (e->matches(QKeySequence::Undo)) return workspace_.undo();
  if (e->matches(QKeySequence::Redo)) return workspace_.redo();
  if (e->key() == Qt::Key_Space && e->modifiers() == Qt::ControlModifier) return offer_words();
  const bool open = words_->isVisible();
  QPlainTextEdit::keyPressEvent(e);
  if (!open) return;
  const bool goes_on =
      (!e->text().isEmpty() && e->text()[0].isPrint() && e->text() != " ") || e->key() == Qt::Key_Backspace;
  words_->hide();
  if (goes_on && workspace_.session().complete(said_so_far()).size() > 1) offer_words();
}

void WordEdit::focusOutEvent(QFocusEvent* e) {
  words_->hide();
  QPlainTextEdit::focusOutEvent(e);
}

}  // namespace betwixt::studio
