// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/script/script_panel.h"

#include <QHBoxLayout>
#include <QMouseEvent>
#include <QPainter>
#include <QShortcut>
#include <QVBoxLayout>

#include "studio/shell/text_of.h"
#include "studio/shell/theme.h"

namespace betwixt::studio {
namespace {

constexpr std::size_t most_said = 200;
constexpr int most_rows = 5;

}  // namespace

ScriptPanel::ScriptPanel(Workspace& workspace, QWidget* parent)
    : QWidget(parent),
      workspace_(workspace),
      edit_(new ScriptEdit(workspace, this)),
      margin_(new QWidget(this)),
      strip_(new QListWidget(this)),
      sought_(new QLineEdit(this)) {
  setObjectName("script_panel");
  setWindowTitle(tr("Script"));
  margin_->setObjectName("script_margin");
  margin_->installEventFilter(this);
  strip_->setObjectName("script_errors");
  strip_->setFrameShape(QFrame::NoFrame);
  strip_->setUniformItemSizes(true);
  strip_->setFocusPolicy(Qt::NoFocus);
  auto* text = new QHBoxLayout;
  text->setSpacing(0);
  text->addWidget(margin_);
  text->addWidget(edit_, 1);
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(0, 0, 0, 0);
  all->setSpacing(0);
  all->addLayout(text, 1);
  sought_->setObjectName("script_sought");
  sought_->setPlaceholderText(tr("find; Enter: next, Shift+Enter: previous"));
  sought_->hide();
  sought_->installEventFilter(this);
  all->addWidget(sought_);
  all->addWidget(strip_);
  auto* key = new QShortcut(QKeySequence::Find, this);
  key->setContext(Qt::WidgetWithChildrenShortcut);
  connect(key, &QShortcut::activated, this, [this] {
    const QString marked = edit_->textCursor().selectedText();
    if (!marked.isEmpty() && !marked.contains(QChar::ParagraphSeparator)) sought_->setText(marked);
    sought_->show(), sought_->setFocus(), sought_->selectAll();
  });
  connect(sought_, &QLineEdit::returnPressed, this,
          [this] { find(QGuiApplication::keyboardModifiers() & Qt::ShiftModifier); });
  setFocusProxy(edit_);
  connect(edit_, &ScriptEdit::margin_changed, margin_, [this] {
    margin_->setFixedWidth(edit_->margin_width());
    margin_->update();
  });
  connect(&workspace, &Workspace::document_changed, this, &ScriptPanel::list_diagnostics);
  connect(strip_, &QListWidget::itemClicked, this, [this](QListWidgetItem* i) {
    edit_->go_to_line(i->data(Qt::UserRole).toInt(), i->data(Qt::UserRole + 1).toInt());
  });
  margin_->setFixedWidth(edit_->margin_width());
  list_diagnostics();
}

QSize ScriptPanel::sizeHint() const {
  const QFontMetrics m = edit_->fontMetrics();
  return {edit_->margin_width() + 60 * m.horizontalAdvance('m'), 24 * m.lineSpacing()};
}

// Finds the next place; searches from the other end if there is none.
void ScriptPanel::find(bool backwards) {
  edit_->fill_all();
  const auto how = backwards ? QTextDocument::FindBackward : QTextDocument::FindFlags();
  if (sought_->text().isEmpty() || edit_->find(sought_->text(), how)) return;
  QTextCursor c = edit_->textCursor();
  c.movePosition(backwards ? QTextCursor::End : QTextCursor::Start);
  edit_->setTextCursor(c);
  edit_->find(sought_->text(), how);
}

bool ScriptPanel::eventFilter(QObject* of, QEvent* e) {
  if (of == sought_ && e->type() == QEvent::KeyPress && static_cast<QKeyEvent*>(e)->key() == Qt::Key_Escape) {
    sought_->hide(), edit_->setFocus();
    return true;
  }
  if (of != margin_) return false;
  if (e->type() == QEvent::Paint) {
    QPainter p(margin_);
    edit_->paint_margin(p, margin_->rect());
    return true;
  }
  if (e->type() == QEvent::MouseButtonPress) {
    const auto* press = static_cast<QMouseEvent*>(e);
    edit_->go_to_line(edit_->cursorForPosition({0, press->pos().y()}).blockNumber() + 1);
    return true;
  }
  return false;
}

// Lists the diagnostics, each with its line; a click moves the cursor there.
void ScriptPanel::list_diagnostics() {
  strip_->clear();
  for (const Diagnostic& d : workspace_.diagnostics()) {
    if (d.severity == Severity::notice || static_cast<std::size_t>(strip_->count()) >= most_said) continue;
    const Place& at = d.what.place;
    const bool here = at.file.empty() || at.file == workspace_.session().file();
    QString text = here ? tr("line %1: ").arg(at.line) : QString("%1:%2: ").arg(at.file.c_str()).arg(at.line);
    if (at.line == 0) text.clear();
    text += QString::fromStdString(d.what.message);
    if (!d.what.hint.empty()) text += " — " + QString::fromStdString(d.what.hint);
    auto* item = new QListWidgetItem(text, strip_);
    item->setForeground(d.severity == Severity::error ? colors().error : colors().warning);
    item->setToolTip(tip_of(text));
    item->setData(Qt::UserRole, here ? at.line : 0);
    item->setData(Qt::UserRole + 1, at.column);
  }
  strip_->setVisible(strip_->count() > 0);
  if (strip_->count() > 0) strip_->setFixedHeight(std::min(most_rows, strip_->count()) * strip_->sizeHintForRow(0) + 4);
}

}  // namespace betwixt::studio
