// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/panels/lines_editor.h"

#include <QFocusEvent>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QPlainTextEdit>
#include <algorithm>

#include "language/values.h"
#include "studio/shell/text_of.h"
#include "studio/shell/text_size.h"
#include "studio/shell/theme.h"
#include "syntax/texts.h"

namespace betwixt::studio {
namespace {

constexpr int least_lines = 3, most_lines = 12;  // that are seen without scrolling
constexpr std::size_t most_edited = 20'000;      // characters; a longer text is only shown

class TextLines : public QPlainTextEdit {
 public:
  TextLines(QWidget* parent, std::function<void(const QString&)> say) : QPlainTextEdit(parent), say_(std::move(say)) {
    setTabChangesFocus(true);
    setLineWrapMode(QPlainTextEdit::NoWrap);
    setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    setFont(script_font());
    measure_by_text(*this, [this] { fit_height(); });
    connect(this, &QPlainTextEdit::textChanged, this, [this] { fit_height(); });
  }
  void show_value(const QString& text) {
    if (hasFocus() && document()->isModified()) return;
    shown_ = text;
    if (text != toPlainText()) put(text);
  }

 protected:
  bool event(QEvent* e) override {
    // In the window, ctrl-Return goes to the console.
    if (e->type() == QEvent::ShortcutOverride && accepts(*static_cast<QKeyEvent*>(e))) return e->accept(), true;
    return QPlainTextEdit::event(e);
  }
  void keyPressEvent(QKeyEvent* e) override {
    if (accepts(*e)) return pass_on();
    if (e->key() != Qt::Key_Escape) return QPlainTextEdit::keyPressEvent(e);
    put(shown_), clearFocus();
  }
  void focusOutEvent(QFocusEvent* e) override {
    QPlainTextEdit::focusOutEvent(e);
    if (e->reason() != Qt::PopupFocusReason) pass_on();
  }

 private:
  static bool accepts(const QKeyEvent& e) {
    return (e.key() == Qt::Key_Return || e.key() == Qt::Key_Enter) && e.modifiers() & Qt::ControlModifier;
  }
  void put(const QString& text) {
    setPlainText(text);
    document()->setModified(false);
  }
  void pass_on() {
    if (!document()->isModified() || isReadOnly()) return;
    document()->setModified(false);
    say_(toPlainText());
  }
  void fit_height() {
    const int lines = std::clamp(blockCount() + 1, least_lines, most_lines);
    setFixedHeight(lines * fontMetrics().lineSpacing() + 2 * frameWidth() +
                   static_cast<int>(2 * document()->documentMargin()));
  }
  std::function<void(const QString&)> say_;
  QString shown_;
};

class LinesEditor : public ValueEditor {
 public:
  explicit LinesEditor(QWidget* parent)
      : ValueEditor(parent),
        text_(
            new TextLines(this, [this](const QString& t) { Q_EMIT said(-1, text_of(write_text(t.toStdString()))); })) {
    text_->setObjectName("value");
    text_->setToolTip(tr("Ctrl+Return takes the text over, Escape brings the old one back"));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(text_);
  }
  void show_value(const Value& v, const Target&, const Document&) override {
    const auto* text = std::get_if<Text>(&v);
    if (!text) return;
    const bool cut = (**text).size() > most_edited;
    text_->setReadOnly(cut);
    text_->show_value(cut ? text_of(**text).left(most_edited) + "…" : text_of(**text));
  }

 private:
  TextLines* text_;
};

}  // namespace

ValueEditor* make_lines_editor(QWidget* parent) { return new LinesEditor(parent); }

}  // namespace betwixt::studio
