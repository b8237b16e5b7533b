// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Work that takes long is done beside the window, which goes on. No test waits for a time: work ends when the window
// has seen what it shall see.
#include "studio/beside.h"

#include <QTest>
#include <QtWidgets>
#include <condition_variable>
#include <mutex>

#include "studio/film.h"
#include "studio/theme.h"
#include "studio/window.h"

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

class BesideTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() { set_theme(*qApp, Theme::dark); }

  void theWindowGoesOnMeanwhile() {
    studio::Beside beside;
    beside.set_patience(0);
    Gate gate;
    bool heard = true;
    std::thread::id who;
    QTimer::singleShot(0, this, [&] { heard = beside.hears(), gate.open(); });
    beside.carry_out([&] { who = std::this_thread::get_id(), gate.pass(); });
    QVERIFY(!heard);
    QVERIFY(who != std::this_thread::get_id());
    QVERIFY(beside.hears());
  }

  void itTellsHowFarItIs() {
    studio::Beside beside;
    beside.set_patience(0);
    Gate half;
    float seen = 0;
    int over = 0;
    connect(&beside, &studio::Beside::takes_long, this, [&](float share) {
      seen = std::max(seen, share);
      if (share == 0.5F) half.open();
    });
    connect(&beside, &studio::Beside::over, this, [&] { ++over; });
    beside.carry_out([&] { HowFar::tell(1, 2), half.pass(); });
    QCOMPARE(seen, 0.5F);
    QCOMPARE(over, 1);
    beside.carry_out([] {});
    beside.carry_out([] {});
    QVERIFY(beside.hears());
  }

  // Before anybody is told that it takes long, and after.
  void workAsksInTheWindow() {
    for (const int patience : {0, 100'000}) {
      studio::Beside beside;
      beside.set_patience(patience);
      std::thread::id who;
      bool inner = false;
      beside.carry_out([&] {
        beside.in_window([&] {
          who = std::this_thread::get_id();
          if (beside.hears()) beside.carry_out([&] { inner = true; });
        });
      });
      QVERIFY(who == std::this_thread::get_id());
      QVERIFY(inner);
    }
  }

  void aLineIsCarriedOutBesideTheWindowThatShowsIt() {
    Film film("create ball sphere\n");
    Window window(film.desk);
    window.show();
    film.desk.beside().set_patience(0);
    auto* bar = window.findChild<QProgressBar*>("work");
    QVERIFY(bar && bar->isHidden());
    bool seen = false, refused = false;
    connect(&film.desk.beside(), &studio::Beside::takes_long, this, [&] {
      seen = seen || bar->isVisible();
      refused = refused || !film.desk.say(std::string("set ball.radius 9"));  // nobody is heard meanwhile
    });
    QVERIFY(film.desk.say(std::string("set ball.radius 3")));
    QVERIFY(seen && refused);
    QVERIFY(bar->isHidden());
    QCOMPARE(film.radius("ball"), 3.0);
    film.desk.undo();
    QCOMPARE(film.radius("ball"), 1.0);
    film.desk.retype("create ball sphere radius=5\n");
    film.desk.settle_typing();
    QCOMPARE(film.radius("ball"), 5.0);
    QCOMPARE(film.text(), QString("create ball sphere radius=5\n"));
  }

  // A question of the session is asked here, and what is said for its sake is done.
  void aQuestionIsAskedInTheWindow() {
    Film film("create ball sphere\n");
    film.desk.beside().set_patience(0);
    QFile other(film.folder.filePath("other.bx"));
    QVERIFY(other.open(QIODevice::WriteOnly) && other.write("create box1 box\n") > 0);
    other.close();
    QVERIFY(film.desk.say(std::string("set ball.radius 3")));
    bool here = false;
    film.desk.ask = [&](const std::string&) -> std::optional<std::string> {
      here = QThread::currentThread() == qApp->thread();
      return "discard";
    };
    QVERIFY(film.desk.say("open " + quoted_word(other.fileName().toStdString())));
    QVERIFY(here);
    QVERIFY(film.desk.document().find("box1"));
  }
};

QTEST_MAIN(BesideTest)
#include "beside_test.moc"
