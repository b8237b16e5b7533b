// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What values are changed with, by their types. What an editor says is text of the language.
#pragma once

#include <QWidget>

#include "studio/desk.h"

namespace betwixt::studio {

class ValueEditor : public QWidget {
  Q_OBJECT
 public:
  using QWidget::QWidget;
  // What it is now; not where a hand is at it.
  virtual void show_value(const Value&, const Target&, const Document&) = 0;

 Q_SIGNALS:
  // While a hand moves something, and when it has: the value, or one of its components; -1: the whole.
  void looked(int component, const QString& text);
  void said(int component, const QString& text);
  void called_off();
};

// Which editor a value of a function has: changes of it need another one.
enum class EditorKind : std::uint8_t { number, numbers, color, boolean, choice, text, object, attachment, words, code };
EditorKind editor_of(const FunctionView&, const Value& now, bool code);
ValueEditor* make_editor(EditorKind, const FunctionView&, Desk&, QWidget* parent);

}  // namespace betwixt::studio
