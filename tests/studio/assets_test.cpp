// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Assets: the files of the film's folder as pictures, looks that are dragged onto objects, and other shapes for
// objects.
#include <QtTest/QtTest>
#include <QtWidgets>

#include "betwixt/language.h"
#include "betwixt/pick.h"
#include "studio/assets/asset_files.h"
#include "studio/assets/asset_panel.h"
#include "studio/assets/look_lines.h"
#include "studio/film.h"
#include "studio/objects/object_actions.h"
#include "studio/panels/outliner.h"
#include "studio/shell/theme.h"
#include "studio/shell/window.h"
#include "studio/viewport/viewport.h"

namespace betwixt::studio {

class AssetsTest : public QObject {
  Q_OBJECT

  static constexpr const char* film =
      "create eye camera position=(0 0 10)\n"
      "create ball sphere position=(-2 0 0)\n"
      "create hand box\n"
      "ball.color\n  1f red\n  24f blue\n"
      "couple ball to hand\n";

  struct Shown : Film {
    Shown() : Film(film) {
      for (const char* name : {"cow.obj", "sub/dog.obj"}) {
        QDir().mkpath(QFileInfo(folder.filePath(name)).path());
        QFile::copy(SOURCE_DIR "/examples/meshes/spot.obj", folder.filePath(name));
      }
      QImage(40, 20, QImage::Format_RGB32).save(folder.filePath("sky.png"));
      QFile other(folder.filePath("other.bx")), notes(folder.filePath("notes.txt"));
      if (other.open(QIODevice::WriteOnly)) other.write("create box box\n");
      if (notes.open(QIODevice::WriteOnly)) notes.write("no asset");
      QFile broken(folder.filePath("broken.obj"));
      if (broken.open(QIODevice::WriteOnly)) broken.write("\1\2\3");
      other.close(), notes.close(), broken.close();
      window = std::make_unique<Window>(workspace);
      window->resize(1300, 850);
      window->show();
      window->show_panel("assets");
      window->viewport().await_picture();
    }
    AssetPanel& assets() { return *static_cast<AssetPanel*>(window->panel("assets")); }
    AssetList& list(const char* name) { return *assets().findChild<AssetList*>(name); }
    QListWidgetItem* row(const char* in, const QString& name) {
      const auto found = list(in).findItems(name, Qt::MatchExactly);
      return found.isEmpty() ? nullptr : found[0];
    }
    QPoint spot(const char* name) {
      const Value v = workspace.program().read(Target(id(name), Query::world), workspace.time());
      return window->viewport().scope().spot(translation_of(*std::get<Matrix>(v)))->toPoint();
    }
    // Drags a row to a place, as the toolkit reports it.
    void drag(const char* in, const QString& name, QWidget& onto, QPoint at, Qt::KeyboardModifiers keys = {},
              bool drop = true) {
      const std::unique_ptr<QMimeData> data(
          list(in).model()->mimeData({list(in).model()->index(list(in).row(row(in, name)), 0)}));
      QDragEnterEvent enter(at, Qt::CopyAction, data.get(), Qt::LeftButton, keys);
      QCoreApplication::sendEvent(&onto, &enter);
      QVERIFY(enter.isAccepted());
      QDragMoveEvent move(at, Qt::CopyAction, data.get(), Qt::LeftButton, keys);
      QCoreApplication::sendEvent(&onto, &move);
      if (!drop) return;
      QDropEvent let(at, Qt::CopyAction, data.get(), Qt::LeftButton, keys);
      QCoreApplication::sendEvent(&onto, &let);
    }
    std::unique_ptr<Window> window;
  };

 private Q_SLOTS:
  void initTestCase() {
    QStandardPaths::setTestModeEnabled(true);
    QDir(QStandardPaths::writableLocation(QStandardPaths::GenericCacheLocation) + "/betwixt").removeRecursively();
    set_theme(*qApp, Theme::dark);
  }

  void filesOfTheFolderAreListed() {
    Shown s;
    QStringList all;
    QTRY_COMPARE(s.list("asset_files").count(), 5);
    for (int i = 0; i < 5; ++i) all << s.list("asset_files").item(i)->toolTip();
    QCOMPARE(all, (QStringList{"broken.obj", "cow.obj", "other.bx", "sky.png", "sub/dog.obj"}));
    s.assets().findChild<QLineEdit*>("asset_search")->setText("dog");
    QVERIFY(s.row("asset_files", "cow.obj")->isHidden());
    QVERIFY(!s.row("asset_files", "dog.obj")->isHidden());
  }

  void filesThatComeAndGoAreListed() {
    Shown s;
    QTRY_COMPARE(s.list("asset_files").count(), 5);
    QImage(8, 8, QImage::Format_RGB32).save(s.folder.filePath("sub/new.png"));
    QTRY_VERIFY(s.row("asset_files", "new.png"));
    QFile::remove(s.folder.filePath("sub/new.png"));
    QTRY_VERIFY(!s.row("asset_files", "new.png"));
    QCOMPARE(s.list("asset_files").count(), 5);
  }

  void posesAreNotScripts() {
    Shown s;
    QDir(s.folder.path()).mkdir("poses");
    QFile pose(s.folder.filePath("poses/wave.bx"));
    QVERIFY(pose.open(QIODevice::WriteOnly));
    pose.write("create ball group\nset ball.rotation euler(0 45deg 0)\n");
    pose.close();
    QTRY_VERIFY(s.row("asset_files", "wave"));
    QVERIFY(s.row("asset_files", "wave")->toolTip().startsWith("pose wave"));
    QCOMPARE(asset_sort(pose.fileName()), AssetSort::pose);
    const std::string before = s.workspace.session().file();
    emit s.list("asset_files").itemActivated(s.row("asset_files", "wave"));
    QCOMPARE(s.workspace.session().file(), before);  // it is not opened
  }

  // A mesh looks as a film shows it; a picture is scaled; what is broken has no picture.
  void filesHavePictures() {
    Shown s;
    const QImage cow = asset_picture(s.folder.filePath("cow.obj"), {64, 48});
    QCOMPARE(cow.size(), QSize(64, 48));
    QVERIFY(qAlpha(cow.pixel(0, 0)) == 0 && qAlpha(cow.pixel(32, 24)) == 255);
    QCOMPARE(asset_picture(s.folder.filePath("sky.png"), {64, 64}).size(), QSize(64, 32));
    QVERIFY(asset_picture(s.folder.filePath("broken.obj"), {64, 48}).isNull());
    QVERIFY(asset_picture(s.folder.filePath("other.bx"), {64, 48}).isNull());
    const auto shown = [&] { return s.row("asset_files", "cow.obj")->icon().pixmap(200, 200).toImage(); };
    QTRY_VERIFY(s.row("asset_files", "cow.obj"));
    const QImage first = shown();
    QTRY_VERIFY_WITH_TIMEOUT(shown() != first, 20'000);
  }

  void aFileIsDraggedIntoThePicture() {
    Shown s;
    const QString before = s.text();
    QTRY_VERIFY(s.row("asset_files", "dog.obj"));
    s.drag("asset_files", "dog.obj", s.window->viewport(), {300, 200});
    QVERIFY2(s.text().contains("create dog mesh file=\"sub/dog.obj\" position="), qPrintable(s.text()));
    s.workspace.undo();
    QCOMPARE(s.text(), before);
    emit s.list("asset_files").itemActivated(s.row("asset_files", "cow.obj"));
    QVERIFY(s.text().contains("create cow mesh file=\"cow.obj\""));
    QCOMPARE(s.selected(), "cow");
  }

  // Before the drop the picture shows what it will do. A function with events gets another event.
  void aLookIsDraggedOntoAnObject() {
    Shown s;
    const QString before = s.text();
    Viewport& picture = s.window->viewport();
    s.drag("asset_looks", "metal", picture, s.spot("hand"), {}, false);
    QVERIFY(s.workspace.looks_ahead());
    QCOMPARE(s.text(), before);
    QDragLeaveEvent leave;
    QCoreApplication::sendEvent(&picture, &leave);
    QVERIFY(!s.workspace.looks_ahead());
    s.drag("asset_looks", "metal", picture, s.spot("hand"));
    QVERIFY2(s.text().contains("create hand box material=metal\n") || s.text().contains("set hand.material metal\n"),
             qPrintable(s.text()));
    s.drag("asset_looks", "tomato", picture, s.spot("ball"));
    QVERIFY2(s.text().contains("  1f tomato\n"), qPrintable(s.text()));
    s.workspace.undo();
    s.workspace.undo();
    QCOMPARE(s.text(), before);
    auto& tree = *s.window->findChild<OutlinerTree*>();
    s.window->show_panel("outliner");
    const QPoint row = tree.visualRect(static_cast<OutlinerModel*>(tree.model())->index_of(s.id("hand"))).center();
    s.drag("asset_looks", "teal", *tree.viewport(), row);
    QCOMPARE(s.workspace.program().read(s.target("hand.color"), s.workspace.time()), Value(from_hex(0x008080)));
  }

  // Name, tracks and attachments of the object stay, and so does its colour.
  void anObjectGetsAnotherShape() {
    Shown s;
    const QString before = s.text();
    QTRY_VERIFY(s.row("asset_files", "cow.obj"));
    s.drag("asset_files", "cow.obj", s.window->viewport(), s.spot("ball"), Qt::AltModifier);
    QVERIFY2(s.text().contains("shape(cow)"), qPrintable(s.text()));
    const auto corners = [](const Document& d, const char* name) {
      const Frame frame = Program::compile(d).frame(d.range().first);
      for (const Item& item : frame.items)
        if (item.id == d.find(name)) return drawn(item, 100).corners.size();
      return std::size_t(0);
    };
    const Document plain =
        load_text("create cow mesh file=\"cow.obj\"\n", s.folder.filePath("film.bx").toStdString()).document;
    QVERIFY(corners(plain, "cow") > 1000);
    QCOMPARE(corners(s.workspace.document(), "ball"), corners(plain, "cow"));
    QCOMPARE(corners(s.workspace.document(), "cow"), std::size_t(0));  // it is hidden
    QCOMPARE(s.events_of("ball.color"), std::size_t(2));
    QVERIFY(!attachments(s.workspace.document(), s.id("ball")).empty());
    s.workspace.undo();
    QCOMPARE(s.text(), before);
    s.workspace.say(std::string("create calf mesh file=\"cow.obj\""));
    const QString with_calf = s.text();
    QCOMPARE(shape_lines(s.workspace.document(), {s.id("calf")}, "sub/dog.obj", "dog"),
             (Lines{"set calf.file \"sub/dog.obj\""}));
    s.select("hand");
    ObjectActions& act = ObjectActions::of(s.workspace);
    act.replace("sphere");
    QVERIFY2(s.text().contains("shape(sphere1)"), qPrintable(s.text()));
    act.replace("");
    QCOMPARE(corners(s.workspace.document(), "hand"), corners(load_text(film, "film").document, "hand"));
    s.workspace.undo();
    s.workspace.undo();
    QCOMPARE(s.text(), with_calf);
  }

 private:
  static Color from_hex(unsigned rgb) {
    return {((rgb >> 16) & 255) / 255.0, ((rgb >> 8) & 255) / 255.0, (rgb & 255) / 255.0};
  }
};

}  // namespace betwixt::studio

QTEST_MAIN(betwixt::studio::AssetsTest)
#include "assets_test.moc"
