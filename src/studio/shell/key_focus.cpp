// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/shell/key_focus.h"

#include <QApplication>
#include <QKeyEvent>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QTextDocument>
#include <QVariant>

#include "studio/shell/keys.h"
#include "studio/viewport/viewport.h"

namespace betwixt::studio {
namespace {

constexpr const char* follows = "follows_pointer";

bool somebody_types() {
  const QWidget* const has = QApplication::focusWidget();
  if (const auto* line = qobject_cast<const QLineEdit*>(has)) return line->isModified();
  const auto* text = qobject_cast<const QPlainTextEdit*>(has);
  return text && !text->document()->isEmpty();
}

// Whether the widget uses keys for something else at the moment.
bool is_busy(const QObject& on) {
  const auto* picture = qobject_cast<const Viewport*>(&on);
  return picture && picture->pulls();
}

}  // namespace

// Gives the widget the key that it knows instead of the one that the user has chosen for it.
bool KeyFocus::translate(QObject& on, QKeyEvent& e) {
  if (!on.isWidgetType() || is_busy(on)) return false;
  const QKeyCombination pressed = key_of(e);
  const auto known = Keys::of_user().translated(on.objectName(), pressed);
  if (known == pressed) return false;
  e.ignore();
  if (!known) return true;
  QKeyEvent other(e.type(), known->key(), known->keyboardModifiers(), {}, e.isAutoRepeat());
  other.ignore();
  on.event(&other);  // the widget alone, and no key of the window
  e.setAccepted(other.isAccepted());
  return true;
}

void follow_pointer(QWidget& w) { w.setProperty(follows, true); }

bool KeyFocus::eventFilter(QObject* on, QEvent* e) {
  if (e->type() == QEvent::Enter && on->property(follows).toBool()) {
    auto* w = static_cast<QWidget*>(on);
    if (w->isActiveWindow() && !QApplication::activePopupWidget() && !somebody_types())
      w->setFocus(Qt::OtherFocusReason);
  }
  if ((e->type() == QEvent::ShortcutOverride || e->type() == QEvent::KeyPress) &&
      translate(*on, static_cast<QKeyEvent&>(*e)))
    return true;
  if (e->type() == QEvent::ShortcutOverride)
    if (const auto* line = qobject_cast<QLineEdit*>(on); line && !line->isModified()) {
      const auto* key = static_cast<QKeyEvent*>(e);
      if (key->matches(QKeySequence::Undo) || key->matches(QKeySequence::Redo)) return e->ignore(), true;
    }
  return QObject::eventFilter(on, e);
}

}  // namespace betwixt::studio
