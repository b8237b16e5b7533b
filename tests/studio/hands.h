// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// A film at a desk, and hands on a panel, for tests.
#pragma once

#include <QTemporaryDir>
#include <QtTest/QtTest>
#include <fstream>
#include <string>
#include <vector>

#include "studio/desk.h"

namespace betwixt::studio {

// A desk at which this text is open; what is said is kept.
struct Film {
  QTemporaryDir folder;
  Desk desk;
  std::vector<std::string> said;
  explicit Film(const std::string& text) {
    const std::string file = folder.path().toStdString() + "/film.bx";
    std::ofstream(file) << text;
    if (!desk.open(QString::fromStdString(file))) qFatal("%s", desk.last_said().c_str());
    QObject::connect(&desk, &Desk::said, [this](const QString& line, const QString& answer, bool refused) {
      said.push_back((refused ? "refused: " + answer : line).toStdString());
    });
  }
  // What the film is, made from a text by itself.
  bool is(const std::string& text) const { return desk.document() == load_text(text, "expected").document; }
  Time frame(double n) const { return desk.document().rate().frame(n); }
  ObjectId find(const std::string& name) const { return desk.document().find(name); }
};

inline void show(QWidget& panel, int w, int h) {
  panel.resize(w, h);
  panel.show();
  QVERIFY(QTest::qWaitForWindowExposed(&panel));
}

// Presses, moves there in a few steps, and lets go; without letting go where `held`.
inline void drag(QWidget& on, QPoint from, QPoint to, Qt::KeyboardModifiers keys = Qt::NoModifier, bool held = false,
                 Qt::MouseButton button = Qt::LeftButton) {
  QTest::mousePress(&on, button, keys, from);
  for (int i = 1; i <= 4; ++i) {
    const QPointF at = from + (to - from) * (i / 4.0);
    QMouseEvent move(QEvent::MouseMove, at, on.mapToGlobal(at), Qt::NoButton, button, keys);
    QApplication::sendEvent(&on, &move);
  }
  if (!held) QTest::mouseRelease(&on, button, keys, to);
}

}  // namespace betwixt::studio
