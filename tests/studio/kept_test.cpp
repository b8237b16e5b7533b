// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests what must not be lost: a start with any stored settings, the time during playback, and text typed without a
// pause.
#include <QTest>
#include <QtWidgets>

#include "studio/film.h"
#include "studio/script/script_edit.h"
#include "studio/shell/theme.h"
#include "studio/shell/transport.h"
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

  // What is set again and again while it plays is where it would be without: messages of a fader come 100 times a
  // second.
  void nothingSlowsDownThatIsSetWhileItPlays() {
    const Rate rate{24, 1};
    for (const int direction : {1, -1}) {
      Transport often, seldom;
      for (Transport* t : {&often, &seldom}) t->set(rate, rate.frame(1), rate.frame(240)), t->go_to(rate.frame(120));
      often.play(direction), seldom.play(direction);
      for (int k = 0; k < 150; ++k) {  // the end of the film changes, or stays
        often.set(rate, rate.frame(1), rate.frame(k % 3 ? 240 : 240 + k));
        QTest::qSleep(5);
      }
      const auto clock = Transport::Clock::now();
      const double a = rate.frame_number(often.now(clock)), b = rate.frame_number(seldom.now(clock));
      QVERIFY2(std::abs(a - b) <= 1, qPrintable(QString("%1 %2").arg(a).arg(b)));
      QVERIFY(direction * (a - 120) >= 15);
      if (direction < 0) continue;
      // The sound starts from here.
      const auto [frame, since] = often.place();
      const double heard = 1 + frame + 24 * std::chrono::duration<double>(clock - since).count();
      QVERIFY2(heard >= a && heard < a + 1, qPrintable(QString("%1 %2").arg(heard).arg(a)));
    }
  }

  // A message from before the start that is read after it: a loop would put it at the last frame.
  void whatCameBeforeItPlayedBelongsToTheBeginning() {
    const Rate rate{24, 1};
    for (const bool loop : {true, false})
      for (const int direction : {1, -1}) {
        const Time begin = rate.frame(direction > 0 ? 1 : 48);
        Transport t;
        t.loop(loop);
        t.set(rate, rate.frame(1), rate.frame(48));
        t.go_to(begin);
        const auto before = Transport::Clock::now() - std::chrono::milliseconds(10);
        t.play(direction);
        QCOMPARE(t.now(before), begin);
        t.set(rate, rate.frame(1), rate.frame(48));  // a message before it has been shown
        QCOMPARE(t.now(before), begin);
        t.go_to(rate.frame(24));
        QCOMPARE(t.now(before), rate.frame(24));
      }
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
