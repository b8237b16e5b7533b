// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/shell/text_size.h"

#include <QApplication>
#include <QEvent>
#include <QFontDatabase>
#include <QScreen>
#include <QWidget>
#include <utility>

namespace betwixt::studio {
namespace {

const QFont& font_at_first_start() {
  static const QFont first = QApplication::font();
  return first;
}

class MeasuredByText : public QObject {
 public:
  MeasuredByText(QWidget& w, std::function<void()> measure) : QObject(&w), measure_(std::move(measure)) {
    w.installEventFilter(this);
    measure_();
  }
  bool eventFilter(QObject* on, QEvent* e) override {
    const bool filtered = QObject::eventFilter(on, e);
    if (e->type() == QEvent::FontChange && on == parent()) measure_();
    return filtered;
  }

 private:
  const std::function<void()> measure_;
};

}  // namespace

void size_all_text(double size) {
  QFont f = font_at_first_start();
  f.setPointSizeF(f.pointSizeF() * size);
  QApplication::setFont(f);
}

double size_of_all_text() { return QApplication::font().pointSizeF() / font_at_first_start().pointSizeF(); }

QFont script_font() {
  QFont f = QFontDatabase::systemFont(QFontDatabase::FixedFont);
  f.setPointSizeF(f.pointSizeF() * size_of_all_text());
  return f;
}

void measure_by_text(QWidget& w, std::function<void()> measure) { new MeasuredByText(w, std::move(measure)); }

void resize_on_screen(QWidget& window, QSize size) {
  window.resize(size.boundedTo(window.screen()->availableSize() * 9 / 10));
}

}  // namespace betwixt::studio
