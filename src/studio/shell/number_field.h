// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// A field for a number, to type in or to drag sideways. It takes numbers as the script writes them: "2", "45deg",
// "35mm", "tau/4".
#pragma once

#include <QColor>
#include <QLineEdit>

namespace betwixt::studio {

class NumberField : public QLineEdit {
  Q_OBJECT
 public:
  explicit NumberField(QWidget* parent = nullptr);
  // Does nothing while the user edits the field.
  void show_value(const QString&);
  // Sets the unit for numbers typed without one.
  void set_unit(const QString& unit) { unit_ = unit; }
  void set_limits(double low, double high) { low_ = low, high_ = high; }
  void set_color(QColor c) { color_ = c; }
  QSize sizeHint() const override { return {minimumWidth(), QLineEdit::sizeHint().height()}; }
  bool held() const { return dragging_ || (hasFocus() && isModified()); }

 Q_SIGNALS:
  void looked(const QString&);  // during a drag
  void said(const QString&);
  void called_off();

 protected:
  void mousePressEvent(QMouseEvent*) override;
  void mouseMoveEvent(QMouseEvent*) override;
  void mouseReleaseEvent(QMouseEvent*) override;
  void keyPressEvent(QKeyEvent*) override;
  void focusInEvent(QFocusEvent*) override;
  void focusOutEvent(QFocusEvent*) override;
  void resizeEvent(QResizeEvent*) override;
  void paintEvent(QPaintEvent*) override;

 private:
  static QString how_to();
  QString moved(double steps) const;
  void finish();
  void abridge();
  void show_whole();
  QString shown_, unit_, pressed_;
  double low_ = -1e300, high_ = 1e300, pressed_x_ = 0;
  bool pressing_ = false, dragging_ = false, editing_ = false;
  bool abridged_ = false;  // shows less than the whole value, because there is no room
  QColor color_;
};

}  // namespace betwixt::studio
