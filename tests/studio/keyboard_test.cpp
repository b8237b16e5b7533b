// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests that keys can be changed, that no two actions share one, and that the list of keys is complete and true.
#include <QTest>
#include <QtWidgets>

#include "studio/film.h"
#include "studio/shell/actions.h"
#include "studio/shell/key_sheet.h"
#include "studio/shell/keys.h"
#include "studio/shell/keys_page.h"
#include "studio/shell/palette.h"
#include "studio/shell/theme.h"
#include "studio/shell/window.h"
#include "studio/viewport/viewport.h"

using namespace betwixt;
using namespace betwixt::studio;

namespace {

const QByteArray film_text =
    "rate 24\nrange 1f 48f\ncreate eye camera position=(0 0 14)\ncreate ball sphere radius=0.5\n"
    "ball.position\n  1f (0 0 0)\n  12f (2 3 0)\n  24f (4 0 0)\n";

QSettings settings() { return QSettings("betwixt", "studio"); }
Keys& keys() { return Keys::of_user(); }

struct Studio {
  Film film{film_text};
  Window window{film.workspace};
  Studio() {
    window.resize(1280, 900);
    window.show();
    QVERIFY2(QTest::qWaitForWindowActive(&window), "the window");
    film.select("ball");
  }
  QWidget& widget(const char* name) { return *window.findChild<QWidget*>(name); }
};

bool uses(QWidget& w, QEvent::Type type, int key, Qt::KeyboardModifiers with) {
  QKeyEvent e(type, key, with, key < 128 && !with ? QString(QChar(key)).toLower() : QString());
  type == QEvent::ShortcutOverride ? e.ignore() : e.accept();
  static_cast<QObject&>(w).event(&e);  // without the keys of the window
  return e.isAccepted();
}

QAction* menu_row(const QMenu& menu, const QString& name) {
  for (QAction* a : menu.actions())
    if (a->text() == name) return a;
  qFatal("no row '%s'", qPrintable(name));
}

}  // namespace

class KeyboardTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() { set_theme(*qApp, Theme::dark); }
  void init() {
    settings().clear();
    keys().recall();
  }
  void cleanup() { keys().reset_all(), keys().set_preset("betwixt"); }

  void noTwoActionsOfAPlaceShareAKey() {
    for (const KeyPreset& preset : key_presets()) {
      keys().set_preset(QString::fromUtf8(preset.name.data(), static_cast<int>(preset.name.size())));
      for (const KeyRow& row : keys().rows())
        for (const QKeySequence& key : keys().keys(row)) {
          QVERIFY2(key.count() == 1 && key[0].key() != Qt::Key_unknown, qPrintable(row.id()));
          for (const KeyRow* other : keys().conflicts(row, key))
            QVERIFY2(!other, qPrintable(keys().preset() + ": " + key.toString() + " is the key of " + row.id() +
                                        " and of " + other->id()));
        }
    }
  }

  void rowsAndPresetsAreWhole() {
    QSet<QString> ids;
    for (const KeyRow& row : keys().rows()) {
      QVERIFY2(!ids.contains(row.id()), qPrintable(row.id()));
      ids.insert(row.id());
      QVERIFY2(!row.sentence.empty(), qPrintable(row.id()));
      QVERIFY2(std::ranges::find(key_places(), row.place, &KeyPlace::name) != key_places().end(), qPrintable(row.id()));
    }
    for (const KeyPreset& preset : key_presets())
      for (const KeyPreset::Key& k : preset.changed) {
        const KeyRow* row = keys().row(k.place, k.name);
        QVERIFY2(row, std::string(k.name).c_str());
        QVERIFY2(!row->fixed, std::string(k.name).c_str());
      }
  }

  void aChangedKeyWorksAndTheOldOneDoesNot() {
    Studio s;
    QWidget& picture = s.widget("viewport");
    picture.setFocus();
    keys().set(*keys().row("picture", "Move selection"), {QKeySequence("M")});
    QTest::keyClick(&picture, Qt::Key_G);
    QVERIFY(!s.window.viewport().pulls());
    QTest::keyClick(&picture, Qt::Key_M);
    QVERIFY(s.window.viewport().pulls());
    QTest::keyClick(&picture, Qt::Key_Escape);
    QVERIFY(!s.window.viewport().pulls());
    // Keys of the window.
    const Time before = s.film.workspace.time();
    keys().set(*keys().row("everywhere", "Next frame"), {QKeySequence("G")});
    QTest::keyClick(&picture, Qt::Key_G);
    const Time then = s.film.workspace.time();
    QVERIFY(then > before);
    QTest::keyClick(&picture, Qt::Key_M);
    QVERIFY(s.window.viewport().pulls());
    QCOMPARE(s.film.workspace.time(), then);
    QTest::keyClick(&picture, Qt::Key_Escape);
    keys().reset_all();
    QTest::keyClick(&picture, Qt::Key_G);
    QVERIFY(s.window.viewport().pulls());
    QTest::keyClick(&picture, Qt::Key_Escape);
  }

  void handsOfBlenderAndAfterEffects() {
    Studio s;
    const QString first = s.film.text();
    QWidget& picture = s.widget("viewport");
    picture.setFocus();
    keys().set_preset("blender");
    QTest::keyClick(&picture, Qt::Key_D, Qt::ShiftModifier);
    QVERIFY2(s.film.text().contains("like ball"), qPrintable(s.film.text()));
    QTest::keyClick(&picture, Qt::Key_X);
    QVERIFY2(!s.film.id("ball2"), "X removes");
    // While something moves, X is still the axis.
    s.film.select("ball");
    QTest::keyClick(&picture, Qt::Key_G);
    QTest::keyClick(&picture, Qt::Key_X);
    QVERIFY(s.window.viewport().pulls());
    QTest::keyClick(&picture, Qt::Key_Escape);
    // After a scale, I inserts an event of the scale too.
    QTest::keyClick(&picture, Qt::Key_S);
    QTest::keyClick(&picture, Qt::Key_2);
    QTest::keyClick(&picture, Qt::Key_Return);
    QVERIFY2(s.film.text().endsWith("set ball.scale (2 2 2)\n"), qPrintable(s.film.text()));
    QTest::keyClick(&picture, Qt::Key_I);
    QCOMPARE(s.film.events_of("ball.rotation"), 1);
    QCOMPARE(s.film.events_of("ball.scale"), 1);
    s.film.workspace.undo();  // one step
    QCOMPARE(s.film.events_of("ball.scale"), 0);
    // Shift-A shows the kinds at the pointer.
    QTest::keyClick(&picture, Qt::Key_A, Qt::ShiftModifier);
    auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
    QVERIFY2(menu, "Shift+A");
    menu_row(*menu_row(*menu, "Shapes")->menu(), "torus")->trigger(), menu->close();
    QVERIFY2(s.film.text().contains("create torus1 torus"), qPrintable(s.film.text()));
    QCOMPARE(s.film.workspace.selected(), (std::vector{s.film.id("torus1")}));
    s.film.select("ball");
    keys().set_preset("after-effects");
    QTest::keyClick(&picture, Qt::Key_P);
    QVERIFY(s.window.viewport().pulls());
    QTest::keyClick(&picture, Qt::Key_Escape);
    const Time before = s.film.workspace.time();
    QTest::keyClick(&picture, Qt::Key_PageDown);
    QVERIFY(s.film.workspace.time() > before);
    while (s.film.text() != first) s.film.workspace.undo();
  }

  void hintsNameThePresentKeys() {
    Studio s;
    const auto tip = [&](const char* of) { return s.window.viewport().findChild<QToolButton*>(of)->toolTip(); };
    QVERIFY(tip("move").contains("(W)") && tip("move").contains("press G to"));
    keys().set_preset("after-effects");
    QVERIFY2(tip("move").contains("(V)") && tip("move").contains("press P to"), qPrintable(tip("move")));
    QCOMPARE(with_keys("press {Insert event at playhead}."), "press " + keys().shown("Insert event at playhead") + ".");
    const KeyRow& row = *keys().row("picture", "Handles to move");
    keys().set(row, {});
    QVERIFY2(tip("move").contains("('Handles to move')"), qPrintable(tip("move")));
    // Each hint in braces is an action.
    QFile exercises(SOURCE_DIR "/src/studio/course/exercises.txt"), german(SOURCE_DIR "/src/studio/words/de.po");
    static const QRegularExpression action("\\{([A-Z][^{}]+)\\}");
    int found = 0;
    for (QFile* file : {&exercises, &german}) {
      QVERIFY(file->open(QIODevice::ReadOnly));
      const QString text = QString::fromUtf8(file->readAll());
      for (auto i = action.globalMatch(text); i.hasNext(); ++found) {
        const std::string name = i.next().captured(1).toStdString();
        QVERIFY2(std::ranges::any_of(keys().rows(), [&](const KeyRow& r) { return r.name == name; }), name.c_str());
      }
    }
    QVERIFY(found > 10);
  }

  // The menu Object has the same kinds.
  void theMenuAddsObjects() {
    Studio s;
    const QMenu* kinds = menu_row(*s.window.menuBar()->findChild<QMenu*>("Object"), "Add object")->menu();
    QVERIFY(kinds && kinds->actions().size() > 5);
    menu_row(*menu_row(*kinds, "Shapes")->menu(), "box")->trigger();
    QVERIFY2(s.film.text().endsWith("create box1 box\n"), qPrintable(s.film.text()));
  }

  // Presets are where people look for them: in the menu Edit, in the list of keys, and in the palette.
  void presetsAreFound() {
    Studio s;
    s.window.show_keys();
    auto* sheet = s.window.findChild<KeySheet*>();
    auto* preset = sheet->findChild<QComboBox*>("preset");
    const int blender = preset->findText("Blender");
    QVERIFY(blender > 0);
    preset->setCurrentIndex(blender);
    emit preset->activated(blender);
    QCOMPARE(keys().preset(), "blender");
    QVERIFY(sheet->findChild<QTextBrowser*>()->toPlainText().contains("Shift+D"));
    sheet->close();
    for (const QString words : {"blender", "after effects", "keymap", "preset"}) {
      Palette palette(s.window);
      palette.findChild<QLineEdit*>()->setText(words);
      const auto* found = palette.findChild<QListWidget*>();
      bool there = false;
      for (int i = 0; i < std::min(3, found->count()); ++i)
        there = there || found->item(i)->text().contains("Key preset");
      QVERIFY2(there, qPrintable(words));
    }
    menu_row(*s.window.menuBar()->findChild<QMenu*>("Edit"), "Key preset…")->trigger();
    auto* page = s.window.findChild<KeysPage*>();
    QVERIFY(page && page->isVisible());
    QCOMPARE(page->findChild<QComboBox*>("preset")->currentText(), "Blender");
  }

  void theFileKeepsTheDifferencesOnly() {
    keys().set(*keys().row("picture", "Move selection"), {QKeySequence("M"), QKeySequence("Ctrl+,")});
    keys().set(*keys().row("picture", "Rotate selection"), {QKeySequence("R")});  // no difference
    QSettings file = settings();
    file.beginGroup("keys");
    QCOMPARE(file.allKeys(), QStringList{"picture.move-selection"});
    QCOMPARE(file.value("picture.move-selection").toString(), "M; Ctrl+,");
    keys().recall();
    QCOMPARE(words_of_keys(keys().keys(*keys().row("picture", "Move selection"))), "M; Ctrl+,");
    keys().reset(*keys().row("picture", "Move selection"));
    file.sync();
    QVERIFY(file.allKeys().isEmpty());
    // What is no key, or no row, is left out.
    file.setValue("picture.move-selection", "what no keyboard has"), file.setValue("no.row", "M");
    file.setValue("preset", "of nobody");
    file.sync();
    keys().recall();
    QCOMPARE(words_of_keys(keys().keys(*keys().row("picture", "Move selection"))), "G");
    QCOMPARE(keys().preset(), "betwixt");
  }

  void thePageSetsKeysAndSaysWhoHasThem() {
    KeysPage page;
    page.show();
    auto* rows = page.findChild<QTreeWidget*>("key_rows");
    auto* field = page.findChild<QLineEdit*>("key_field");
    auto* says = page.findChild<QLabel*>("key_says");
    const auto choose = [&](const QString& name) {
      rows->setCurrentItem(rows->findItems(name, Qt::MatchExactly).value(0));
      QVERIFY(rows->currentItem());
    };
    const auto shown = [&](const QString& name) { return rows->findItems(name, Qt::MatchExactly)[0]->text(1); };
    choose("Loop");
    QTest::keyClick(field, Qt::Key_J, Qt::ControlModifier);
    QCOMPARE(shown("Loop"), "Ctrl+J");
    choose("Mute");
    QTest::keyClick(field, Qt::Key_J, Qt::ControlModifier);
    QVERIFY2(says->text().contains("Loop"), qPrintable(says->text()));
    QCOMPARE(shown("Loop"), "Ctrl+J");
    QTest::mouseClick(page.findChild<QPushButton*>("take_key"), Qt::LeftButton);
    QCOMPARE(shown("Mute"), "Ctrl+J");
    QCOMPARE(shown("Loop"), "");
    page.findChild<QLineEdit*>("key_search")->setText("ctrl+j");
    int left = 0;
    for (int i = 0; i < rows->topLevelItemCount(); ++i) left += !rows->topLevelItem(i)->isHidden();
    QCOMPARE(left, 1);
    QTest::mouseClick(page.findChild<QPushButton*>("reset_keys"), Qt::LeftButton);
    QCOMPARE(shown("Loop"), "L");
    QCOMPARE(shown("Mute"), "Ctrl+M");
  }

  void theListIsTrueForChangedKeysAndCanBePrinted() {
    QVERIFY(key_sheet_html().contains(">G</code></td><td>Move selection<"));
    keys().set(*keys().row("picture", "Move selection"), {QKeySequence("M")});
    QVERIFY(key_sheet_html().contains(">M</code></td><td>Move selection *<"));
    QVERIFY(!key_sheet_html("rotate").contains("Move selection"));
    QTemporaryDir folder;
    QCOMPARE(KeySheet::write(folder.filePath("keys.html")), "");
    QCOMPARE(KeySheet::write(folder.filePath("keys.pdf")), "");
    QFile html(folder.filePath("keys.html")), pdf(folder.filePath("keys.pdf"));
    QVERIFY(html.open(QIODevice::ReadOnly) && pdf.open(QIODevice::ReadOnly));
    QVERIFY(html.readAll().contains("Move selection *"));
    QVERIFY(pdf.readAll().startsWith("%PDF"));
    QVERIFY(!KeySheet::write(folder.filePath("no/keys.pdf")).isEmpty());
  }

  // Presses every key in every panel: if the panel uses it, the list has it.
  void everyKeyOfEveryPanelIsInTheList() {
    QList<int> all{Qt::Key_Up,     Qt::Key_Down,   Qt::Key_Left,     Qt::Key_Right,   Qt::Key_Home,
                   Qt::Key_End,    Qt::Key_PageUp, Qt::Key_PageDown, Qt::Key_Delete,  Qt::Key_Backspace,
                   Qt::Key_Return, Qt::Key_Space,  Qt::Key_Insert,   Qt::Key_Plus,    Qt::Key_Minus,
                   Qt::Key_Period, Qt::Key_Comma,  Qt::Key_Slash,    Qt::Key_Asterisk};
    for (int k = Qt::Key_A; k <= Qt::Key_Z; ++k) all << k;
    for (int k = Qt::Key_0; k <= Qt::Key_9; ++k) all << k;
    for (int k = Qt::Key_F1; k <= Qt::Key_F12; ++k) all << k;
    int found = 0;
    std::unique_ptr<Studio> s;
    std::string of;
    for (const char* name : {"viewport", "outliner_tree", "ruler", "sheet_pane", "exposures", "curve_pane", "history"})
      for (const int key : all)
        for (const auto with : {Qt::KeyboardModifiers(), Qt::KeyboardModifiers(Qt::ShiftModifier),
                                Qt::KeyboardModifiers(Qt::ControlModifier), Qt::KeyboardModifiers(Qt::AltModifier),
                                Qt::ControlModifier | Qt::ShiftModifier}) {
          if (!s || of != name) {
            s.reset(), s = std::make_unique<Studio>(), of = name;
            if (of == "exposures") s->window.findChild<QToolButton*>("columns")->setChecked(true);
            s->window.show_panel(of == "curve_pane" ? "curves" : of == "history" ? "history" : "sheet");
            QCoreApplication::processEvents();
          }
          s->film.select("ball");
          const Target position = s->film.target("ball.position");
          s->film.workspace.select_events({{position, s->film.at_time("12f")}});
          QWidget& w = s->widget(name);
          const bool list = qobject_cast<QAbstractItemView*>(&w);
          const bool searches =
              list && key < 128 && (key < Qt::Key_A || !(with & ~Qt::KeyboardModifiers(Qt::ShiftModifier)));
          if (searches) continue;  // letters go to the row of that name
          // In lists, and in panels that want the key before the window does.
          if (!uses(w, list ? QEvent::KeyPress : QEvent::ShortcutOverride, key, with)) continue;
          // Keys such as arrows may have the same meaning whatever is held.
          const QKeySequence pressed(QKeyCombination(with, Qt::Key(key)));
          const QKeySequence bare(key);
          const auto has = [&](const KeyRow& row) {
            return keys().keys(row).contains(pressed) || (key > Qt::Key_Escape && keys().keys(row).contains(bare));
          };
          bool listed = false;
          for (const KeyRow& row : keys().rows())
            for (const KeyPlace& place : key_places())
              listed = listed || (place.name == row.place && has(row) &&
                                  (place.name == "everywhere" ||
                                   std::ranges::find(place.widgets, std::string_view(name)) != place.widgets.end()));
          QVERIFY2(listed, qPrintable(pressed.toString() + " in " + name + " is not in the list"));
          ++found;
          if (list) s.reset();  // the row may be gone
        }
    QVERIFY2(found > 60, qPrintable(QString::number(found)));
  }
};

QTEST_MAIN(KeyboardTest)
#include "keyboard_test.moc"
