// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// File, New: the films to begin with, with their pictures.
#include "app/templates.h"

#include <QtTest/QtTest>
#include <QtWidgets>

#include "betwixt/language.h"
#include "studio/course/film_chooser.h"
#include "studio/shell/example.h"
#include "studio/shell/theme.h"
#include "studio/shell/window.h"
#include "studio/viewport/picture_maker.h"

namespace betwixt::studio {

class TemplatesTest : public QObject {
  Q_OBJECT

  static QListWidget& films(FilmChooser& chooser) { return *chooser.findChild<QListWidget*>("films"); }
  static FilmChooser& asked(Window& window) {
    auto* chooser = window.findChild<FilmChooser*>();
    if (!chooser) qFatal("nothing is asked");
    return *chooser;
  }

 private Q_SLOTS:
  void initTestCase() {
    QStandardPaths::setTestModeEnabled(true);  // a cache folder of its own
    QDir(QStandardPaths::writableLocation(QStandardPaths::GenericCacheLocation) + "/betwixt").removeRecursively();
    set_theme(*qApp, Theme::dark);
  }

  // The picture in the list is the picture of the film, also when it comes from the cache.
  void eachFilmHasItsPicture() {
    for (int time = 0; time < 2; ++time) {
      FilmChooser chooser({}, nullptr);
      chooser.show();
      QListWidget& list = films(chooser);
      QCOMPARE(list.count(), static_cast<int>(film_templates().size()) + 1);
      int row = 0;
      for (const FilmTemplate& t : film_templates()) {
        QCOMPARE(list.item(row)->text().toStdString(), t.title);
        const Document d = load_text(t.text, "expected").document;
        RenderOptions o;
        o.width = 320, o.height = 180;
        const QImage expected = PictureMaker::make({Program::compile(d), d.rate().frame(t.shown_frame), o, {}})
                                    .image.convertedTo(QImage::Format_RGB32);
        const auto shown = [&] {
          return list.item(row)->icon().pixmap(320, 180, QIcon::Normal).toImage().convertedTo(QImage::Format_RGB32);
        };
        QTRY_COMPARE_WITH_TIMEOUT(shown(), expected, 20'000);
        ++row;
      }
    }
  }

  // A chosen film has exactly its text, and another film may replace it without a question.
  void enterBeginsAFilm() {
    Workspace workspace;
    Window window(workspace);
    window.show();
    workspace.begin_with("create box1 box\n");
    window.begin_film("create box2 box\n");
    for (const FilmTemplate& t : film_templates()) {
      window.new_film();  // asks nothing: the film is as it began
      FilmChooser& chooser = asked(window);
      QVERIFY(QTest::qWaitForWindowExposed(&chooser));
      QListWidget& list = films(chooser);
      for (int row = 0; QString::fromStdString(std::string(t.title)) != list.item(row)->text(); ++row)
        list.setCurrentRow(row + 1);
      QTest::keyClick(&list, Qt::Key_Return);
      QCOMPARE(workspace.text(), std::string(t.text));
      QVERIFY(!window.isWindowModified());
      QTRY_VERIFY(!window.findChild<FilmChooser*>());
    }
    workspace.say(std::string("create more box"));
    QVERIFY(window.isWindowModified());
    workspace.undo();
    QCOMPARE(workspace.text(), std::string(film_templates().back().text));
  }

  void escapeLeavesTheFilmThatIsThere() {
    Workspace workspace;
    Window window(workspace);
    window.show();
    window.open_example();
    window.new_film();
    QVERIFY(QTest::qWaitForWindowExposed(&asked(window)));
    QCOMPARE(workspace.text(), example_film);
    QTest::keyClick(&asked(window), Qt::Key_Escape);
    QCOMPARE(workspace.text(), example_film);
    QTRY_VERIFY(!window.findChild<FilmChooser*>());
    window.new_film();
    asked(window).findChild<QPushButton*>("nothing")->click();
    QCOMPARE(workspace.text(), "");
    QVERIFY(!window.isWindowModified());
  }

  void filmsThatAreThereAndTheCourseAreOffered() {
    QTemporaryDir folder;
    const QString file = folder.filePath("mine.bx");
    QFile out(file);
    QVERIFY(out.open(QIODevice::WriteOnly) && out.write("create mine box\n") > 0);
    out.close();
    QSettings("betwixt", "studio").setValue("recent", QStringList{folder.filePath("gone.bx"), file});
    Workspace workspace;
    Window window(workspace);
    window.show();
    window.open_example();
    window.new_film();
    auto* recent = asked(window).findChild<QListWidget*>("opened_last");
    QVERIFY(recent);
    QCOMPARE(recent->count(), 1);
    QCOMPARE(recent->item(0)->text(), "mine.bx");
    QVERIFY(asked(window).findChild<QPushButton*>("open"));
    recent->setCurrentRow(0);
    QTest::keyClick(recent, Qt::Key_Return);
    QCOMPARE(workspace.text(), "create mine box\n");
    QTRY_VERIFY(!window.findChild<FilmChooser*>());
    window.new_film();
    asked(window).findChild<QPushButton*>("course")->click();
    QVERIFY(window.panel("course")->isVisible());
    QCOMPARE(workspace.text(), "create mine box\n");
    QSettings("betwixt", "studio").remove("recent");
  }
};

}  // namespace betwixt::studio

QTEST_MAIN(betwixt::studio::TemplatesTest)
#include "templates_test.moc"
