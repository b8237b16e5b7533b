// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Helpers for tests of panels: a film in a workspace, and mouse drags.
#pragma once

#include <QTemporaryDir>
#include <QtTest/QtTest>
#include <fstream>
#include <string>
#include <vector>

#include "studio/shell/workspace.h"

namespace betwixt::studio {

// A workspace with a film of this text. Keeps the lines and answers of its console.
struct Film {
  QTemporaryDir folder;
  Workspace workspace;
  std::vector<std::string> said;
  explicit Film(const std::string& text) {
    const std::string file = folder.path().toStdString() + "/film.bx";
    std::ofstream(file) << text;
    if (!workspace.open(QString::fromStdString(file))) qFatal("%s", workspace.last_said().c_str());
    QObject::connect(&workspace, &Workspace::said, [this](const QString& line, const QString& answer, bool refused) {
      said.push_back((refused ? "refused: " + answer : line).toStdString());
    });
  }
  // Returns whether the document equals the document of this text.
  bool is(const std::string& text) const { return workspace.document() == load_text(text, "expected").document; }
  Time frame(double n) const { return workspace.document().rate().frame(n); }
  ObjectId find(const std::string& name) const { return workspace.document().find(name); }
};

inline void show(QWidget& panel, int w, int h) {
  panel.resize(w, h);
  panel.show();
  QVERIFY(QTest::qWaitForWindowExposed(&panel));
}

// Presses a button, moves the mouse in a few steps, and releases the button unless `held`.
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
