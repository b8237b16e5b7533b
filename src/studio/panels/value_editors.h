// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Editors for values, one for each type. They return values as script text.
#pragma once

#include <QWidget>

#include "studio/shell/workspace.h"

namespace betwixt::studio {

class ValueEditor : public QWidget {
  Q_OBJECT
 public:
  using QWidget::QWidget;
  // Shows the current value, unless the user is editing.
  virtual void show_value(const Value&, const Target&, const Document&) = 0;

 Q_SIGNALS:
  // Emitted during a drag, and at its end: the value, or one of its components; -1: the whole value.
  void looked(int component, const QString& text);
  void said(int component, const QString& text);
  void called_off();
};

// The kind of editor for a function's value. If it changes, the row needs another editor.
enum class EditorKind : std::uint8_t {
  number,
  numbers,
  color,
  boolean,
  choice,
  text,
  lines,  // a text of several lines
  object,
  attachment,
  words,
  code
};
EditorKind editor_of(const FunctionView&, Kind of_object, const Value& now, bool code);
ValueEditor* make_editor(EditorKind, const FunctionView&, Workspace&, QWidget* parent);

}  // namespace betwixt::studio
