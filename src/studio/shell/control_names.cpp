// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/shell/control_names.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QEvent>
#include <QLineEdit>
#include <QMainWindow>
#include <QPlainTextEdit>
#include <QTextDocumentFragment>
#include <QWidget>

namespace betwixt::studio {
namespace {

// Returns the first sentence of a tooltip, without its markup.
QString first_sentence(const QString& tip) {
  return QTextDocumentFragment::fromHtml(tip).toPlainText().section('\n', 0, 0).section(':', 0, 0).trimmed();
}

QString name_for(const QWidget& w) {
  // The field of a list, and the parts of a value, are named as what they belong to.
  if (const QWidget* up = w.parentWidget(); up && !up->accessibleName().isEmpty()) return up->accessibleName();
  if (const auto* button = qobject_cast<const QAbstractButton*>(&w);
      button && button->text().size() > 1 && button->text() != "…")
    return button->text();
  if (!w.toolTip().isEmpty()) return first_sentence(w.toolTip());
  if (const auto* edit = qobject_cast<const QLineEdit*>(&w); edit && !edit->placeholderText().isEmpty())
    return edit->placeholderText();
  for (const QWidget* up = &w; up; up = up->parentWidget())
    if (!up->windowTitle().isEmpty() && !up->isWindow() && !qobject_cast<const QMainWindow*>(up))
      return up->windowTitle();
  return QString(w.objectName()).replace('_', ' ');
}

}  // namespace

bool is_control(const QWidget& w) {
  return qobject_cast<const QAbstractButton*>(&w) || qobject_cast<const QLineEdit*>(&w) ||
         qobject_cast<const QComboBox*>(&w) || qobject_cast<const QAbstractSpinBox*>(&w) ||
         qobject_cast<const QAbstractItemView*>(&w) || qobject_cast<const QPlainTextEdit*>(&w) ||
         (w.focusPolicy() & Qt::TabFocus && w.metaObject()->className() != QByteArray("QScrollArea"));
}

void show_text(QLineEdit& field, const QString& text) {
  field.setText(text);
  field.setModified(false), field.setCursorPosition(0);
}

bool ControlNames::eventFilter(QObject* on, QEvent* e) {
  // The toolkit takes what comes from a screen reader for a text set by the program.
  if (auto* field = qobject_cast<QLineEdit*>(on); field && e->type() == QEvent::FocusIn)
    connect(field, &QLineEdit::textChanged, this, &ControlNames::typed, Qt::UniqueConnection);
  if (e->type() == QEvent::Show)
    if (auto* w = qobject_cast<QWidget*>(on); w && w->accessibleName().isEmpty() && is_control(*w))
      w->setAccessibleName(name_for(*w));
  return QObject::eventFilter(on, e);
}

void ControlNames::typed() {
  if (auto* field = qobject_cast<QLineEdit*>(sender()); field && field->hasFocus()) field->setModified(true);
}

}  // namespace betwixt::studio
