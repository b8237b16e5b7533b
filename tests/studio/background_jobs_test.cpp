// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests long work in the background, during which the window stays usable. No test waits for a fixed time: work ends
// when the window has seen what it should see.
#include "studio/shell/background_jobs.h"

#include <QTest>
#include <QtWidgets>
#include <condition_variable>
#include <mutex>

#include "studio/film.h"
#include "studio/shell/theme.h"
#include "studio/shell/window.h"
#include "syntax/tokens.h"

using namespace betwixt;
using namespace betwixt::studio;

namespace {

// Closed until it is opened, in whichever thread.
class Gate {
 public:
  void open() {
    const std::lock_guard lock(mutex_);
    open_ = true;
    changed_.notify_all();
  }
  void pass() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return open_; });
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  bool open_ = false;
};

}  // namespace

class BackgroundJobsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() { set_theme(*qApp, Theme::dark); }

  void theWindowGoesOnMeanwhile() {
    BackgroundJobs jobs;
    jobs.set_patience(0);
    Gate gate;
    bool heard = true;
    std::thread::id who;
    QTimer::singleShot(0, this, [&] { heard = jobs.hears(), gate.open(); });
    jobs.carry_out([&] { who = std::this_thread::get_id(), gate.pass(); });
    QVERIFY(!heard);
    QVERIFY(who != std::this_thread::get_id());
    QVERIFY(jobs.hears());
  }

  void itTellsHowFarItIs() {
    BackgroundJobs jobs;
    jobs.set_patience(0);
    Gate half;
    float seen = 0;
    int over = 0;
    connect(&jobs, &BackgroundJobs::takes_long, this, [&](float share) {
      seen = std::max(seen, share);
      if (share == 0.5F) half.open();
    });
    connect(&jobs, &BackgroundJobs::over, this, [&] { ++over; });
    jobs.carry_out([&] { WorkProgress::report(1, 2), half.pass(); });
    QCOMPARE(seen, 0.5F);
    QCOMPARE(over, 1);
    jobs.carry_out([] {});
    jobs.carry_out([] {});
    QVERIFY(jobs.hears());
  }

  // Before anybody is told that it takes long, and after.
  void workAsksInTheWindow() {
    for (const int patience : {0, 100'000}) {
      BackgroundJobs jobs;
      jobs.set_patience(patience);
      std::thread::id who;
      bool inner = false;
      jobs.carry_out([&] {
        jobs.in_window([&] {
          who = std::this_thread::get_id();
          if (jobs.hears()) jobs.carry_out([&] { inner = true; });
        });
      });
      QVERIFY(who == std::this_thread::get_id());
      QVERIFY(inner);
    }
  }

  void aLineIsCarriedOutBesideTheWindowThatShowsIt() {
    Film film("create ball sphere\n");
    Window window(film.workspace);
    window.show();
    film.workspace.jobs().set_patience(0);
    auto* bar = window.findChild<QProgressBar*>("work");
    QVERIFY(bar && bar->isHidden());
    bool seen = false, refused = false;
    connect(&film.workspace.jobs(), &BackgroundJobs::takes_long, this, [&] {
      seen = seen || bar->isVisible();
      refused = refused || !film.workspace.say(std::string("set ball.radius 9"));  // nobody is heard meanwhile
    });
    QVERIFY(film.workspace.say(std::string("set ball.radius 3")));
    QVERIFY(seen && refused);
    QVERIFY(bar->isHidden());
    QCOMPARE(film.radius("ball"), 3.0);
    film.workspace.undo();
    QCOMPARE(film.radius("ball"), 1.0);
    film.workspace.retype("create ball sphere radius=5\n");
    film.workspace.settle_typing();
    QCOMPARE(film.radius("ball"), 5.0);
    QCOMPARE(film.text(), QString("create ball sphere radius=5\n"));
  }

  // A question of the session is asked here, and what is said for its sake is done.
  void aQuestionIsAskedInTheWindow() {
    Film film("create ball sphere\n");
    film.workspace.jobs().set_patience(0);
    QFile other(film.folder.filePath("other.bx"));
    QVERIFY(other.open(QIODevice::WriteOnly) && other.write("create box1 box\n") > 0);
    other.close();
    QVERIFY(film.workspace.say(std::string("set ball.radius 3")));
    bool here = false;
    film.workspace.ask = [&](const Session::Question&) -> std::optional<std::string> {
      here = QThread::currentThread() == qApp->thread();
      return "discard";
    };
    QVERIFY(film.workspace.say("open " + as_one_word(other.fileName().toStdString())));
    QVERIFY(here);
    QVERIFY(film.workspace.document().find("box1"));
  }

  // The user presses Stop while a line makes many events: the film is as before, and works.
  void stopLeavesTheFilmAsItWas() {
    Film film("create ball sphere\n");
    Window window(film.workspace);
    window.resize(1000, 700);
    window.show();
    QVERIFY(QTest::qWaitForWindowActive(&window));
    const QString first = film.text();
    film.workspace.jobs().set_patience(0);
    auto* stop = window.findChild<QPushButton*>("stop");
    QVERIFY(stop && stop->isHidden());
    for (const bool by_key : {false, true}) {
      bool pressed = false;
      const auto waits = connect(&film.workspace.jobs(), &BackgroundJobs::takes_long, this, [&](float, bool may_stop) {
        if (!may_stop || std::exchange(pressed, true)) return;
        QVERIFY(stop->isVisible());
        QCoreApplication::processEvents();
        by_key ? QTest::keyClick(&window, Qt::Key_Escape) : QTest::mouseClick(stop, Qt::LeftButton);
      });
      std::string rows = "ball.position\n";
      for (int i = 1; i < 300'000; ++i) rows += fmt::format("  {}f (1 2 3)\n", i);
      const std::string line = Session::rewrite_line(2, 1, rows);
      QVERIFY(!film.workspace.say(line));
      disconnect(waits);
      QVERIFY(pressed);
      QVERIFY2(film.workspace.last_said().find("stopped") != std::string::npos, film.workspace.last_said().c_str());
      QCOMPARE(film.events_of("ball.position"), 0U);
      QCOMPARE(film.text(), first);
      QVERIFY(stop->isHidden());
    }
    QVERIFY(film.workspace.say(std::string("set ball.radius 3")));
    QCOMPARE(film.radius("ball"), 3.0);
    film.workspace.undo();
    QCOMPARE(film.text(), first);
  }

  void aStoppedOpeningKeepsTheFilmWithItsUnsavedSteps() {
    Film film("create ball sphere\n");
    QByteArray huge = "ball.position\n";
    for (int i = 1; i < 400'000; ++i) huge += "  " + QByteArray::number(i) + "f (1 2 3)\n";
    QFile other(film.folder.filePath("huge.bx"));
    QVERIFY(other.open(QIODevice::WriteOnly) && other.write("create ball sphere\n" + huge) > 0);
    other.close();
    QVERIFY(film.workspace.say(std::string("set ball.radius 3")));
    film.workspace.jobs().set_patience(0);
    bool stopped = false;
    const auto waits = connect(&film.workspace.jobs(), &BackgroundJobs::takes_long, this, [&](float, bool may_stop) {
      if (may_stop && !std::exchange(stopped, true)) film.workspace.jobs().stop();
    });
    QVERIFY(!film.workspace.open(other.fileName()));
    disconnect(waits);
    QVERIFY(stopped);
    QCOMPARE(QFileInfo(QString::fromStdString(film.workspace.session().file())).fileName(), "film.bx");
    QCOMPARE(film.radius("ball"), 3.0);
    QVERIFY(film.workspace.session().unsaved() > 0);
    film.workspace.undo();
    QCOMPARE(film.text(), "create ball sphere\n");
  }

  // Clicks and keys during work come after it.
  void inputWaitsUntilTheWorkIsDone() {
    Film film("create ball sphere\n");
    QWidget window;
    QLineEdit edit(&window);
    window.show();
    QVERIFY(QTest::qWaitForWindowActive(&window));
    edit.setFocus();
    film.workspace.jobs().set_patience(0);
    bool typed = false;
    const auto waits = connect(&film.workspace.jobs(), &BackgroundJobs::takes_long, this, [&](float, bool may_stop) {
      if (!may_stop || std::exchange(typed, true)) return;
      QTest::keyClick(window.windowHandle(), Qt::Key_A);
      QCOMPARE(edit.text(), QString());
    });
    QVERIFY(film.workspace.say(std::string("set ball.radius 3")));
    disconnect(waits);
    QVERIFY(typed);
    QTRY_COMPARE(edit.text(), "a");
    film.workspace.undo();
  }
};

QTEST_MAIN(BackgroundJobsTest)
#include "background_jobs_test.moc"
#include "syntax/tokens.h"
