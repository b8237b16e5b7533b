// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/shell/key_focus.h"

#include <QApplication>
#include <QKeyEvent>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QTextDocument>
#include <QVariant>

namespace betwixt::studio {
namespace {

constexpr const char* follows = "follows_pointer";

bool somebody_types() {
  const QWidget* const has = QApplication::focusWidget();
  if (const auto* line = qobject_cast<const QLineEdit*>(has)) return line->isModified();
  const auto* text = qobject_cast<const QPlainTextEdit*>(has);
  return text && !text->document()->isEmpty();
}

}  // namespace

void follow_pointer(QWidget& w) { w.setProperty(follows, true); }

bool KeyFocus::eventFilter(QObject* on, QEvent* e) {
  if (e->type() == QEvent::Enter && on->property(follows).toBool()) {
    auto* w = static_cast<QWidget*>(on);
    if (w->isActiveWindow() && !QApplication::activePopupWidget() && !somebody_types())
      w->setFocus(Qt::OtherFocusReason);
  }
  if (e->type() == QEvent::ShortcutOverride)
    if (const auto* line = qobject_cast<QLineEdit*>(on); line && !line->isModified()) {
      const auto* key = static_cast<QKeyEvent*>(e);
      if (key->matches(QKeySequence::Undo) || key->matches(QKeySequence::Redo)) return e->ignore(), true;
    }
  return QObject::eventFilter(on, e);
}

}  // namespace betwixt::studio
