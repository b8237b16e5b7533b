// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/shell/number_field.h"

#include <QApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "studio/shell/control_names.h"
#include "studio/shell/text_size.h"

namespace betwixt::studio {
namespace {

constexpr double pixels_a_step = 2;
constexpr int margin = 4;  // beside the number

// Returns the step of a drag: about a hundredth of the value.
double step_of(double value, const QString& unit) {
  if (unit == "deg" || unit == "f") return 1;
  return std::pow(10.0, std::max(-2.0, std::floor(std::log10(std::max(std::abs(value), 1e-9))) - 2));
}

// Returns the length of the number before its unit, or -1 if the text is no number with a unit.
qsizetype number_length(const QString& text) {
  qsizetype n = 0;
  while (n < text.size() && (text[n].isDigit() || text[n] == '.' || (text[n] == '-' && n == 0))) ++n;
  for (qsizetype i = n; i < text.size(); ++i)
    if (!text[i].isLetter()) return -1;
  return n > 0 ? n : -1;
}

}  // namespace

NumberField::NumberField(QWidget* parent) : QLineEdit(parent) {
  setFrame(false);
  setAlignment(Qt::AlignRight);
  setCursor(Qt::SizeHorCursor);
  setContextMenuPolicy(Qt::NoContextMenu);
  measure_by_text(*this,
                  [this] { setMinimumWidth(fontMetrics().horizontalAdvance("-00.00") + 2 * margin), abridge(); });
  setToolTip(how_to());
}

void NumberField::show_value(const QString& text) {
  if (held() || text == shown_) return;
  shown_ = text;
  abridge();
}

// Shows as much of the value as there is room for: without its unit, then with fewer digits. A number whose end is cut
// off would look like another one.
void NumberField::abridge() {
  if (shown_.isEmpty() || held() || pressing_) return;
  const int room = hasFocus() ? QWIDGETSIZE_MAX : width() - 2 * margin;
  const auto fits = [&](const QString& text) { return fontMetrics().horizontalAdvance(text) <= room; };
  QString text = shown_;
  const qsizetype n = number_length(shown_);
  if (!fits(text) && n > 0) text = shown_.left(n);
  for (int digits = 6; n > 0 && digits > 0 && !fits(text); --digits)
    text = QString::number(shown_.left(n).toDouble(), 'g', digits);
  abridged_ = text != shown_;
  setToolTip((abridged_ ? shown_ + "\n" : "") + how_to());
  if (text != this->text()) show_text(*this, text);
}

void NumberField::show_whole() {
  if (std::exchange(abridged_, false)) show_text(*this, shown_);
}

QString NumberField::how_to() {
  return tr("Drag sideways, or click and type. Shift: ten times as fast, Ctrl: a tenth.");
}

QString NumberField::moved(double steps) const {
  const qsizetype n = number_length(pressed_);
  if (n < 0) return pressed_;
  const double value = pressed_.left(n).toDouble();
  const QString unit = pressed_.mid(n);
  const double step = step_of(value, unit.isEmpty() ? unit_ : unit) * (std::abs(steps) < 1 ? 0.1 : 1);
  const double to = std::clamp(value + steps * step_of(value, unit.isEmpty() ? unit_ : unit), low_, high_);
  const int digits = std::max(0, static_cast<int>(-std::floor(std::log10(step) + 1e-9)) + (steps != std::round(steps)));
  QString text = QString::number(to, 'f', digits);
  if (text.contains('.')) {
    while (text.endsWith('0')) text.chop(1);
    if (text.endsWith('.')) text.chop(1);
  }
  return (text == "-0" ? QString("0") : text) + (unit.isEmpty() ? unit_ : unit);
}

void NumberField::mousePressEvent(QMouseEvent* e) {
  if (editing_ || e->button() != Qt::LeftButton || isReadOnly()) return QLineEdit::mousePressEvent(e);
  show_whole();
  pressing_ = true, pressed_ = text(), pressed_x_ = e->globalPosition().x();
}

void NumberField::mouseMoveEvent(QMouseEvent* e) {
  if (!pressing_) return QLineEdit::mouseMoveEvent(e);
  const double way = e->globalPosition().x() - pressed_x_;
  if (!dragging_ && std::abs(way) < QApplication::startDragDistance() / 2.0) return;
  if (!std::exchange(dragging_, true)) setFocus();  // focus, so that Escape can cancel
  double steps = std::round(way / pixels_a_step);
  if (e->modifiers() & Qt::ShiftModifier) steps *= 10;
  if (e->modifiers() & Qt::ControlModifier) steps /= 10;
  setText(moved(steps));
  Q_EMIT looked(text());
}

void NumberField::mouseReleaseEvent(QMouseEvent* e) {
  if (!pressing_) return QLineEdit::mouseReleaseEvent(e);
  pressing_ = false;
  if (std::exchange(dragging_, false)) {
    shown_.clear();
    clearFocus();
    if (text() != pressed_) Q_EMIT said(text());
    return;
  }
  setFocus(Qt::MouseFocusReason);
  editing_ = true;
  setCursor(Qt::IBeamCursor);
  selectAll();
}

void NumberField::finish() {
  editing_ = false;
  const bool changed = isModified();
  setModified(false);
  if (!changed) return;
  QString typed = text().trimmed();
  bool number = false;
  (void)typed.toDouble(&number);
  if (number) typed += unit_;
  shown_.clear();
  Q_EMIT said(typed);
}

void NumberField::keyPressEvent(QKeyEvent* e) {
  const int step = e->key() == Qt::Key_Up ? 1 : e->key() == Qt::Key_Down ? -1 : 0;
  if (e->key() == Qt::Key_Escape) {
    if (pressing_ || dragging_) {
      pressing_ = dragging_ = false;
      setText(pressed_);
      Q_EMIT called_off();
    }
    editing_ = false;
    setText(shown_), setModified(false), clearFocus();
  } else if (e->key() == Qt::Key_Return || e->key() == Qt::Key_Enter) {
    finish();
    selectAll();
  } else if (step != 0 && !isReadOnly()) {
    pressed_ = text();
    setText(moved(step * (e->modifiers() & Qt::ShiftModifier ? 10 : 1)));
    setModified(true);
    finish();
  } else {
    QLineEdit::keyPressEvent(e);
  }
}

void NumberField::focusInEvent(QFocusEvent* e) {
  show_whole();
  QLineEdit::focusInEvent(e);
}

void NumberField::focusOutEvent(QFocusEvent* e) {
  finish();
  setCursor(Qt::SizeHorCursor);
  QLineEdit::focusOutEvent(e);
  abridge();
}

void NumberField::resizeEvent(QResizeEvent* e) {
  QLineEdit::resizeEvent(e);
  abridge();
}

void NumberField::paintEvent(QPaintEvent* e) {
  QLineEdit::paintEvent(e);
  if (!color_.isValid()) return;
  QPainter p(this);
  p.fillRect(QRect(0, 2, 2, height() - 4), color_);
}

}  // namespace betwixt::studio
