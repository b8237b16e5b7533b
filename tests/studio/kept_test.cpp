// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests what must not be lost: a start with any stored settings, and text typed without a pause.
#include <QTest>
#include <QtWidgets>

#include "studio/film.h"
#include "studio/script/script_edit.h"
#include "studio/shell/theme.h"
#include "studio/shell/window.h"

using namespace betwixt;
using namespace betwixt::studio;

namespace {

QSettings settings() { return QSettings("betwixt", "studio"); }

// Starts the studio as its program does, and looks at it until it stands.
void start_and_close(Qt::WindowStates states = {}) {
  Workspace workspace;
  Window window(workspace, {.remembers = true});
  window.show();
  if (states) window.setWindowState(states);
  QTRY_VERIFY(!settings().contains("starting"));
  window.close();
}

}  // namespace

class KeptTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() { set_theme(*qApp, Theme::dark); }
  void init() { settings().clear(); }

  void itStartsAfterItWasMaximisedAndClosed() {
    start_and_close(Qt::WindowMaximized);
    QVERIFY(settings().contains("geometry"));
    start_and_close();
    start_and_close(Qt::WindowFullScreen);
    start_and_close();
  }

  void aStartThatDidNotFinishIsForgotten() {
    start_and_close();
    const QByteArray panels = settings().value("panels").toByteArray();
    settings().setValue("starting", true);
    settings().setValue("geometry", "what no window has said");
    settings().setValue("panels", "nor this");
    {
      Workspace workspace;
      Window window(workspace, {.remembers = true});
      QVERIFY(!settings().contains("geometry"));
      QVERIFY(!settings().contains("panels"));
    }
    settings().remove("starting");
    settings().setValue("panels", panels.left(panels.size() / 2));
    start_and_close();
  }

  void whatIsTypedWithoutAPauseIsInTheJournal() {
    Film film("create ball sphere\n");
    ScriptEdit edit(film.workspace);
    edit.resize(400, 300);
    edit.show();
    edit.moveCursor(QTextCursor::End);
    QElapsedTimer typed;
    typed.start();
    for (int k = 0; typed.elapsed() < 3000; ++k) {
      if (k % 20 == 0) QTest::keyClick(&edit, Qt::Key_Return), QTest::keyClicks(&edit, "# ");
      QTest::keyClick(&edit, Qt::Key_X);
      QTest::qWait(20);
    }
    // A second's worth may be missing, and what a slow machine adds.
    const std::string kept = film.workspace.session().text();
    QVERIFY2(kept.find("# xxx") != std::string::npos, kept.c_str());
  }
};

QTEST_MAIN(KeptTest)
#include "kept_test.moc"
