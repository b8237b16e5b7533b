// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests several films in tabs: each has its own undo, journal, playhead and selection, and keys act in the tab in
// front.
#include "studio/shell/films.h"

#include <QTest>
#include <QtWidgets>

#include "studio/course/film_chooser.h"
#include "studio/film.h"
#include "studio/shell/recovery.h"
#include "studio/shell/theme.h"

using namespace betwixt;
using namespace betwixt::studio;

namespace {

const QByteArray first_text = "create ball sphere radius=1\n", second_text = "create hand box\nrange 1f 48f\n";

struct Desk {
  QTemporaryDir folder;
  Films films;

  Desk() {
    QDir::setCurrent(folder.path());
    write("a.bx", first_text), write("b.bx", second_text);
    films.current().workspace().open({}, Session::Earlier::discard);
    films.resize(1200, 800);
    films.show();
  }
  ~Desk() { QDir::setCurrent(QDir::tempPath()); }
  static void write(const QString& name, const QByteArray& text) {
    QFile f(name);
    if (f.open(QIODevice::WriteOnly)) f.write(text);
  }
  static QByteArray content(const QString& name) {
    QFile f(name);
    return f.open(QIODevice::ReadOnly) ? f.readAll() : QByteArray();
  }
  Workspace& now() { return films.current().workspace(); }
  QStringList names() {
    QStringList all;
    for (int i = 0; i < films.tabs().count(); ++i) all << films.tabs().tabText(i);
    return all;
  }
  void press(const char* keys) {
    films.activateWindow();  // a closed question has left it without the keys
    if (!QTest::qWaitForWindowActive(&films)) qFatal("the window does not become active");
    QTest::keySequence(films.windowHandle(), QKeySequence(keys));
  }
  // Answers the next questions with the buttons of these names.
  static void answer(QStringList buttons, int* asked, QString* question = nullptr) {
    auto* look = new QTimer(qApp);
    QObject::connect(look, &QTimer::timeout, look, [=]() mutable {
      auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
      if (!box || !box->isVisible()) return;
      ++*asked;
      if (question) *question = box->text();
      const QString button = buttons.takeFirst();
      if (buttons.isEmpty()) look->stop(), look->deleteLater();
      for (QAbstractButton* b : box->buttons())
        if (b->text().remove('&') == button) return b->click();
      box->reject();
    });
    look->start(20);
  }
};

}  // namespace

class FilmsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() { set_theme(*qApp, Theme::dark); }

  void anUntouchedFilmGivesWayAndOneInUseDoesNot() {
    Desk d;
    QVERIFY(!d.films.tabs().isVisible());
    d.films.open("a.bx");
    QCOMPARE(d.names(), QStringList{"a.bx"});
    QVERIFY(!d.films.tabs().isVisible());
    d.films.open("b.bx");
    QCOMPARE(d.names(), (QStringList{"a.bx", "b.bx"}));
    QVERIFY(d.films.tabs().isVisible());
    QVERIFY(d.films.windowTitle().startsWith("b.bx"));
    QVERIFY(d.now().document().find("hand"));
    d.films.current().open_example();  // as in a film that the program begins with
    QCOMPARE(d.names().size(), 2);
    d.films.open("b.bx");
    QCOMPARE(d.names(), (QStringList{"a.bx", "b.bx"}));
    // What cannot be opened leaves no tab.
    d.films.open("no.bx");
    QCOMPARE(d.names(), (QStringList{"a.bx", "b.bx"}));
    QVERIFY(d.films.windowTitle().startsWith("b.bx"));
  }

  // File, New: Escape leaves the films that are there; a film that is chosen gets a tab of its own.
  void newLeavesWhatIsThere() {
    Desk d;
    d.films.open("a.bx");
    d.films.current().new_film();
    auto* chooser = d.films.current().findChild<FilmChooser*>();
    QVERIFY(QTest::qWaitForWindowExposed(chooser));
    QTest::keyClick(chooser, Qt::Key_Escape);
    QCOMPARE(d.names(), QStringList{"a.bx"});
    QCOMPARE(QByteArray::fromStdString(d.now().text()), first_text);
    QTRY_VERIFY(!d.films.current().findChild<FilmChooser*>());
    d.films.current().new_film();
    d.films.current().findChild<FilmChooser*>()->accept();
    QCOMPARE(d.names(), (QStringList{"a.bx", "new film"}));
  }

  void theWindowHasTheIcon() {
    Desk d;
    QVERIFY(!d.films.windowIcon().isNull());
    const QColor ball = d.films.windowIcon().pixmap(128, 128).toImage().pixelColor(82, 50);  // the gold ball
    QVERIFY2(ball.red() > 200 && ball.green() > 130 && ball.blue() < 120, qPrintable(ball.name()));
  }

  void aFilmThatIsOpenIsShownAgain() {
    Desk d;
    d.films.open("a.bx"), d.films.open("b.bx");
    QVERIFY(QDir().mkdir("sub") && QFile::link(d.folder.filePath("a.bx"), "sub/link.bx"));
    for (const QString& name :
         {QString("a.bx"), d.folder.filePath("a.bx"), QString("sub/../a.bx"), QString("sub/link.bx")}) {
      d.films.go_to(*d.films.windows()[1]);
      d.films.open(name);
      QCOMPARE(d.films.tabs().count(), 2);
      QCOMPARE(d.films.tabs().currentIndex(), 0);
    }
  }

  void undoPlayheadSelectionAndJournalAreSeparate() {
    Desk d;
    d.films.open("a.bx");
    Workspace& a = d.now();
    a.say(std::string("set ball.radius 2"));
    a.select({a.document().find("ball")});
    d.films.open("b.bx");
    Workspace& b = d.now();
    QVERIFY(&a != &b);
    b.say(std::string("create foot box"));
    b.go_to(b.document().rate().frame(12));
    QCOMPARE(d.names(), (QStringList{"a.bx *", "b.bx *"}));
    QVERIFY(d.content(".a.bx.journal").contains("ball.radius"));
    QVERIFY(d.content(".b.bx.journal").contains("foot") && !d.content(".b.bx.journal").contains("radius"));
    QVERIFY(b.selected().empty() && a.selected().size() == 1);
    QVERIFY(a.time() != b.time());
    b.undo();
    QCOMPARE(QByteArray::fromStdString(b.text()), second_text);
    QCOMPARE(d.names(), (QStringList{"a.bx *", "b.bx"}));
    QVERIFY(a.text().find("radius=2") != std::string::npos);
    d.films.go_to(*d.films.windows()[0]);
    d.press("Ctrl+Z");
    QCOMPARE(QByteArray::fromStdString(a.text()), first_text);
  }

  void keysActInTheFilmInFront() {
    Desk d;
    d.films.open("a.bx");
    Workspace& a = d.now();
    a.say(std::string("create x box")), a.say(std::string("create y box"));
    d.films.open("b.bx");
    Workspace& b = d.now();
    b.say(std::string("create z box"));
    const std::string of_a = a.text();
    d.press("Ctrl+Z");
    QCOMPARE(QByteArray::fromStdString(b.text()), second_text);
    QCOMPARE(a.text(), of_a);
    d.press("Space");
    QVERIFY(b.playhead().playing() && !a.playhead().playing());
    d.press("Ctrl+Tab");
    QCOMPARE(&d.now(), &a);
    QVERIFY(!b.playhead().playing());  // it stops in a tab that is left
    d.press("Ctrl+Z");
    QVERIFY(!a.document().find("y") && a.document().find("x"));
    d.press("Ctrl+Shift+Tab");
    QCOMPARE(&d.now(), &b);
    d.press("Ctrl+Shift+Tab");  // round the end
    QCOMPARE(&d.now(), &a);
    d.press("Ctrl+Z");
    QCOMPARE(QByteArray::fromStdString(a.text()), first_text);
  }

  void closingAsks() {
    Desk d;
    d.films.open("a.bx");
    d.now().say(std::string("set ball.radius 2"));
    d.films.open("b.bx");
    d.films.go_to(*d.films.windows()[0]);
    int asked = 0;
    QString question;
    Desk::answer({"Stay"}, &asked, &question);
    d.press("Ctrl+W");
    QCOMPARE(asked, 1);
    QVERIFY2(question.contains("'a.bx'"), qPrintable(question));
    QCOMPARE(d.names().size(), 2);
    Desk::answer({"Discard"}, &asked);
    d.press("Ctrl+W");
    QCOMPARE(asked, 2);
    QCOMPARE(d.names(), QStringList{"b.bx"});
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    QVERIFY(!QFile::exists(".a.bx.journal"));
    QCOMPARE(d.content("a.bx"), first_text);
    QVERIFY(d.films.isVisible());
    d.press("Ctrl+W");  // the last one, which is saved
    QCOMPARE(asked, 2);
    QVERIFY(!d.films.isVisible());
  }

  void quitAsksForEachFilm() {
    Desk d;
    for (const char* file : {"a.bx", "b.bx"}) d.films.open(file), d.now().say(std::string("create x box"));
    int asked = 0;
    Desk::answer({"Save", "Stay"}, &asked);
    QVERIFY(!d.films.close());
    QCOMPARE(asked, 2);
    QVERIFY(d.films.isVisible());
    QCOMPARE(d.names(), (QStringList{"a.bx", "b.bx *"}));
    QVERIFY(d.content("a.bx").contains("create x box"));
    QCOMPARE(d.films.tabs().currentIndex(), 1);  // the film of the question
    QVERIFY(d.now().say(std::string("create y box")));
    Desk::answer({"Discard"}, &asked);
    QVERIFY(d.films.close());
    QCOMPARE(asked, 3);
    QCOMPARE(d.content("b.bx"), second_text);
    QVERIFY(!QFile::exists(".a.bx.journal") && !QFile::exists(".b.bx.journal"));
  }

  void quitInTheConsoleLeavesOneFilmIfAnotherStays() {
    Desk d;
    d.films.open("a.bx"), d.now().say(std::string("create x box"));
    d.films.open("b.bx");
    int asked = 0;
    Desk::answer({"Stay"}, &asked);
    d.now().say(std::string("quit"));
    QTRY_COMPARE(asked, 1);
    QTRY_COMPARE(d.names(), QStringList{"a.bx *"});
    QVERIFY(d.films.isVisible());
    QVERIFY(d.now().say(std::string("create y box")));
    d.now().undo(), d.now().undo();
  }

  void filmsWithoutFilesHaveJournalsOfTheirOwn() {
    Desk d;
    d.films.current().begin_film({});
    d.now().say(std::string("create one box"));
    Window& second = d.films.place_for_another();
    second.begin_film({});
    QVERIFY(second.workspace().session().may_change());
    QVERIFY(second.workspace().say(std::string("create two box")));
    QVERIFY(d.content(".betwixt.journal").contains("one") && !d.content(".betwixt.journal").contains("two"));
    QVERIFY(d.content(".betwixt-2.journal").contains("two"));
    QCOMPARE(d.names().size(), 2);
    for (Window* w : d.films.windows()) w->workspace().undo();
    QVERIFY(d.films.close());
    QVERIFY(!QFile::exists(".betwixt.journal") && !QFile::exists(".betwixt-2.journal"));
  }

  void filmsWithoutFilesComeBackAfterACrash() {
    const QTemporaryDir folder;
    QDir::setCurrent(folder.path());
    QByteArray lost;
    {
      Workspace then({}, ".betwixt-2.journal");
      then.open({}, Session::Earlier::discard);
      then.say(std::string("create two box"));
      lost = Desk::content(".betwixt-2.journal");
    }
    const auto crash = [&] { Desk::write(".betwixt-2.journal", lost); };
    crash();
    QCOMPARE(recovered_text({}, ".betwixt-2.journal"), std::optional<std::string>("create two box\n"));
    for (const auto earlier : {Session::Earlier::recover, Session::Earlier::discard}) {
      crash();
      Films films;
      films.current().workspace().open({}, Session::Earlier::discard);
      films.recover_others(earlier);
      const bool back = earlier == Session::Earlier::recover;
      QCOMPARE(films.tabs().count(), back ? 2 : 1);
      QCOMPARE(films.tabs().currentIndex(), 0);
      if (!back) continue;
      QCOMPARE(QByteArray::fromStdString(films.windows()[1]->workspace().text()), QByteArray("create two box\n"));
      films.windows()[1]->workspace().undo();
    }
    QDir::setCurrent(QDir::tempPath());
  }

  void panelsBesideTheWindowGoWithTheirFilm() {
    Desk d;
    d.films.open("a.bx");
    auto* dock = qobject_cast<QDockWidget*>(d.films.current().panel("outliner")->parentWidget());
    dock->setFloating(true);
    QVERIFY(dock->isVisible());
    d.films.open("b.bx");
    QVERIFY(!dock->isVisible());
    d.films.go_on(1);
    QVERIFY(dock->isVisible() && dock->isFloating());
  }

  void tabsAreOrderedByHand() {
    Desk d;
    d.films.open("a.bx"), d.films.open("b.bx");
    QTabBar& tabs = d.films.tabs();
    QVERIFY(QTest::qWaitForWindowActive(&d.films));
    const QPoint from = tabs.tabRect(1).center(), to(tabs.tabRect(0).left() + 2, from.y());
    QTest::mousePress(&tabs, Qt::LeftButton, {}, from);
    for (int i = 1; i <= 6; ++i) {
      QMouseEvent move(QEvent::MouseMove, from + (to - from) * i / 6, tabs.mapToGlobal(from + (to - from) * i / 6),
                       Qt::NoButton, Qt::LeftButton, {});
      QApplication::sendEvent(&tabs, &move);
    }
    QTest::mouseRelease(&tabs, Qt::LeftButton, {}, to);
    QTest::qWait(400);  // it glides into its place
    QCOMPARE(d.names(), (QStringList{"b.bx", "a.bx"}));
    QVERIFY(d.films.windowTitle().startsWith("b.bx"));
    QVERIFY(d.films.windows()[0]->workspace().document().find("hand"));
    d.press("Ctrl+Tab");
    QVERIFY(d.films.windowTitle().startsWith("a.bx"));
  }

  void anotherLanguageLeavesANewFilmUntouched() {
    Desk d;
    d.films.current().open_example();
    QVERIFY(d.films.current().is_untouched());
    d.films.speak_anew();
    QVERIFY(d.films.current().is_untouched() && d.films.current().is_saved());
    QVERIFY(d.films.close());  // without a question
  }

  void anotherLanguageKeepsTheFilms() {
    Desk d;
    d.films.open("a.bx"), d.now().say(std::string("create x box"));
    d.films.open("b.bx");
    d.now().go_to(d.now().document().rate().frame(12));
    const Time t = d.now().time();
    d.films.speak_anew();
    QCOMPARE(d.names(), (QStringList{"a.bx *", "b.bx"}));
    QCOMPARE(d.films.tabs().currentIndex(), 1);
    QVERIFY(d.now().time() == t);
    int asked = 0;
    Desk::answer({"Discard"}, &asked);  // the new windows answer for their films
    QVERIFY(d.films.close());
    QCOMPARE(asked, 1);
  }
};

QTEST_MAIN(FilmsTest)
#include "films_test.moc"
