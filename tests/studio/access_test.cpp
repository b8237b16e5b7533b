// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests work without a mouse and without eyes: a film made with keys only, and the tree that screen readers read.
#include <QTest>
#include <QtWidgets>

#include "studio/film.h"
#include "studio/shell/theme.h"
#include "studio/shell/window.h"

using namespace betwixt;
using namespace betwixt::studio;

namespace {

struct Screen {
  Film film;
  Window window;
  explicit Screen(const QByteArray& text) : film(text), window(film.workspace) {
    window.resize(1400, 1000);
    window.show();
    QVERIFY(QTest::qWaitForWindowActive(&window));
  }
  // Presses keys wherever the focus is.
  void press(const char* keys) { QTest::keySequence(window.windowHandle(), QKeySequence(keys)); }
  void type(const QString& text) {
    for (const QChar c : text) QTest::keyClick(window.windowHandle(), c.toLatin1());
  }
};

// All interfaces below one that can be seen.
void collect(QAccessibleInterface* i, std::vector<QAccessibleInterface*>& all, int depth = 0) {
  if (!i || !i->isValid() || i->state().invisible || depth > 40) return;
  all.push_back(i);
  for (int k = 0; k < std::min(i->childCount(), 200); ++k) collect(i->child(k), all, depth + 1);
}

}  // namespace

class AccessTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() { set_theme(*qApp, Theme::dark); }

  void aFilmIsMadeWithKeysOnly() {
    Screen s("rate 24\nrange 1f 48f\ncreate eye camera position=(0 0 14)\n");
    s.press("Ctrl+Return");  // the console
    s.type("create ball sphere"), s.press("Return");
    QVERIFY(s.film.id("ball"));
    s.type("select"), s.press("Esc");
    s.press("Ctrl+1");  // the picture
    QCOMPARE(QApplication::focusWidget()->objectName(), "viewport");
    s.press("A");
    QVERIFY2(s.film.selected().find("ball") != std::string::npos, s.film.selected().c_str());
    s.film.select("ball");
    s.press("K");  // an event here
    for (int i = 0; i < 12; ++i) s.press("Right");
    s.press("G"), s.press("X"), s.press("2"), s.press("Return");
    QCOMPARE(s.film.events_of("ball.position"), 2U);
    QCOMPARE(std::get<Vec3>(s.film.value("ball.position")), (Vec3{2, 0, 0}));
    s.press("Ctrl+S");
    QFile file(s.film.folder.filePath("film.bx"));
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QByteArray saved = file.readAll();
    QVERIFY2(saved.contains("create ball sphere") && saved.contains("13f"), saved);
    QCOMPARE(s.film.workspace.session().unsaved(), 0U);
  }

  void screenReadersGetNamesRolesAndValues() {
    Screen s("create ball sphere radius=0.25\nball.position\n  1f (0 0 0)\n  9f (1 0 0)\n");
    s.film.select("ball");
    QCoreApplication::processEvents();
    std::vector<QAccessibleInterface*> all;
    collect(QAccessible::queryAccessibleInterface(&s.window), all);
    int controls = 0;
    QStringList nameless;
    bool ball = false, play = false, radius = false;
    for (QAccessibleInterface* i : all) {
      const QString name = i->text(QAccessible::Name);
      const QString what =
          i->object() ? i->object()->objectName() + " (" + i->object()->metaObject()->className() + ")" : "";
      switch (i->role()) {
        case QAccessible::Button:
        case QAccessible::CheckBox:
        case QAccessible::ComboBox:
        case QAccessible::EditableText:
        case QAccessible::SpinBox:
        case QAccessible::Slider:
        case QAccessible::List:
        case QAccessible::Tree:
        case QAccessible::Table:
          if (what.contains("qt_") || what.contains("ScrollBar")) break;
          ++controls;
          if (name.isEmpty()) nameless << what;
          break;
        default:
          break;
      }
      QVERIFY2(i->role() != QAccessible::NoRole || !i->state().focusable, qPrintable(what));
      ball = ball || (i->role() == QAccessible::TreeItem && name == "ball");
      if (i->object() && i->object()->objectName() == "play") {
        play = i->actionInterface() &&
               i->actionInterface()->actionNames().contains(QAccessibleActionInterface::pressAction()) &&
               !name.isEmpty();
      }
      radius = radius || (i->role() == QAccessible::EditableText && i->text(QAccessible::Value) == "0.25");
    }
    QVERIFY2(nameless.isEmpty(), qPrintable(nameless.join(", ")));
    QVERIFY2(controls > 40, qPrintable(QString::number(controls)));
    QVERIFY2(ball, "the outliner has no row 'ball'");
    QVERIFY2(play, "the button that plays");
    QVERIFY2(radius, "the field of the radius");
  }
};

QTEST_MAIN(AccessTest)
#include "access_test.moc"
