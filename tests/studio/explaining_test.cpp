// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests what teachers do by hand: charts, plots, code and diagrams that are added from menus, entrances, annotations
// and connections, and their icons and fields.
#include <QTest>
#include <QtWidgets>
#include <set>

#include "betwixt/pick.h"
#include "commands/verbs.h"
#include "scene/kinds.h"
#include "studio/film.h"
#include "studio/objects/creating.h"
#include "studio/objects/object_actions.h"
#include "studio/objects/staging.h"
#include "studio/panels/properties.h"
#include "studio/shell/actions.h"
#include "studio/shell/palette.h"
#include "studio/shell/window.h"
#include "studio/shown_properties.h"
#include "studio/viewport/kind_icons.h"
#include "studio/viewport/viewport.h"

namespace betwixt {
std::span<const Verb> entrances_verbs();
std::span<const Verb> annotations_verbs();
std::span<const Verb> connecting_verbs();
std::span<const Verb> callouts_verbs();
std::span<const Verb> dimensioning_verbs();
}  // namespace betwixt

namespace betwixt::studio {
namespace {

QAction* found_in(const QMenu& menu, const QString& text) {
  for (QAction* a : menu.actions()) {
    if (a->text() == text) return a;
    if (a->menu())
      if (QAction* deeper = found_in(*a->menu(), text)) return deeper;
  }
  return nullptr;
}

const CreatedKind& created(Kind k) {
  for (const CreatedKind& row : created_kinds())
    if (row.kind == k) return row;
  qFatal("no row");
}

const StagingRow& staging(const char* name) {
  for (const StagingRow& row : staging_rows())
    if (std::string_view(row.name) == name) return row;
  qFatal("no action %s", name);
}

// The items of the frame that show something, of an object and all below it.
int shown_of(const Film& film, const std::string& name) {
  int count = 0;
  for (const Item& item : film.workspace.program().frame(film.workspace.time()).items) {
    const std::string of = film.workspace.name(item.id);
    count += of == name || of.starts_with(name + "/") ? 1 : 0;
  }
  return count;
}

}  // namespace

class ExplainingTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  // ---- Adding objects

  void each_kind_is_in_the_menu_once() {
    const std::set<Kind> parts{Kind::bar, Kind::dot};
    for (const KindRow& row : kinds()) {
      int count = 0;
      for (const CreatedKind& made : created_kinds()) count += made.kind == row.kind ? 1 : 0;
      const bool by_hand = (row.placed || row.kind == Kind::sound) && !parts.contains(row.kind);
      QVERIFY2(count == (by_hand ? 1 : 0), std::string(row.name).c_str());
    }
    Film film("film flat\n");
    QMenu menu;
    QWidget over;
    fill_kinds(menu, film.workspace, &over);
    QVERIFY(menu.actions().size() <= 10);
    for (const QAction* group : menu.actions()) QVERIFY(group->menu() && group->menu()->actions().size() <= 16);
    QCOMPARE(found_in(menu, "vector-field")->associatedObjects().size(), 1);
  }

  void each_kind_shows_something_at_once() {
    const std::set<Kind> no_shape{Kind::group, Kind::light, Kind::camera, Kind::sound, Kind::mesh, Kind::video};
    for (const QByteArray& film_text :
         {QByteArray("film flat\nrange 1f 24f\n"), QByteArray("range 1f 24f\nground on\n")})
      for (const CreatedKind& row : created_kinds()) {
        if (no_shape.contains(row.kind)) continue;
        Film film(film_text + "create ball sphere position=(30 0 0)\n");
        film.select("ball");  // for a trace
        const QString before = film.text();
        const std::string kind(name_of(row.kind)), name = kind + "1";
        create_of_kind(film.workspace, row, nullptr);
        QVERIFY2(film.id(name.c_str()), (kind + ": " + film.workspace.last_said()).c_str());
        QCOMPARE(film.selected(), name);
        if (row.kind != Kind::trace) QVERIFY2(shown_of(film, name) > 0, kind.c_str());
        film.workspace.undo();  // one step, with its axes
        QCOMPARE(film.text(), before);
      }
  }

  void what_needs_axes_gets_those_that_are_there() {
    Film film("film flat\ncreate a axes\ncreate b axes\ncreate f plot on=a of=\"x\"\n");
    const auto lines = [&](Kind k) { return creating_lines(film.workspace, created(k)).lines; };
    QCOMPARE(lines(Kind::plot), Lines{"create plot1 plot on=b of=\"sin(x - t)\""});
    film.select("a");
    QCOMPARE(lines(Kind::scatter), Lines{"create scatter1 scatter on=a of=((1 2) (2 -1) (3 2.5))"});
    film.select("f");  // the tangent is that of the plot
    QCOMPARE(lines(Kind::tangent), Lines{"create tangent1 tangent on=a of=f at=1"});
    QCOMPARE(lines(Kind::plot), Lines{"create plot1 plot on=a of=\"sin(x - t)\""});
    // A surface needs axes in space.
    const Lines surface{"create axes1 axes size=(6 4 6)", "create surface1 surface on=axes1 of=\"sin(x) * cos(y)\""};
    QCOMPARE(lines(Kind::surface), surface);
    QVERIFY(film.workspace.say(surface));
    film.workspace.select({});
    QCOMPARE(lines(Kind::surface), Lines{"create surface2 surface on=axes1 of=\"sin(x) * cos(y)\""});
  }

  void a_trace_needs_an_object() {
    Film film("create ball sphere\n");
    const QString before = film.text();
    QString why;
    connect(&film.workspace, &Workspace::said, this, [&](const QString&, const QString& answer) { why = answer; });
    create_of_kind(film.workspace, created(Kind::trace), nullptr);
    QCOMPARE(film.text(), before);
    QVERIFY(why.contains("select"));
  }

  void all_kinds_stand_on_the_ground_with_all_their_pieces() {
    const std::set<Kind> elsewhere{Kind::light, Kind::camera, Kind::group, Kind::mesh,
                                   Kind::sound, Kind::video,  Kind::trace};
    for (const CreatedKind& row : created_kinds()) {
      if (elsewhere.contains(row.kind)) continue;
      Film film("ground on\n");
      create_of_kind(film.workspace, row, nullptr);
      double lowest = 1e9;
      for (const Item& item : film.workspace.program().frame(film.workspace.time()).items)
        for (const Vec3& corner : drawn(item).corners) lowest = std::min(lowest, corner.y);
      QVERIFY2(lowest > -0.01 && lowest < 1.5, qPrintable(QString::number(lowest) + "\n" + film.text()));
    }
    // A surface is a landscape: its axes lie.
    Film film("ground on\n");
    create_of_kind(film.workspace, created(Kind::surface), nullptr);
    const Value world = film.workspace.program().read(Target(film.id("axes1"), Query::world), {});
    QVERIFY(length(transform_vector(*std::get<Matrix>(world), {0, 0, 1}) - Vec3{0, 1, 0}) < 1e-9);
  }

  // ---- Entrances, annotations, connections

  void each_word_of_the_language_has_an_action() {
    for (const auto verbs :
         {entrances_verbs(), annotations_verbs(), connecting_verbs(), callouts_verbs(), dimensioning_verbs()})
      for (const Verb& verb : verbs) {
        const auto has = [&](const StagingRow& row) { return row.verb == verb.word; };
        QVERIFY2(std::ranges::any_of(staging_rows(), has), std::string(verb.word).c_str());
      }
    // All are in the menu Animation, and in the menu of the selection.
    Film film("film flat\ncreate a circle\ncreate b circle position=(4 0)\n");
    film.workspace.select({film.id("a"), film.id("b")});
    Window window(film.workspace);
    const auto* animation = window.menuBar()->findChild<QMenu*>("Animation");
    QVERIFY(animation);
    QMenu menu;
    ObjectActions::of(film.workspace).fill(menu);
    for (const StagingRow& row : staging_rows()) {
      QVERIFY2(found_in(*animation, row.name), row.name);
      QVERIFY2(found_in(menu, row.name), row.name);
    }
  }

  void an_action_writes_one_line_for_each_object_in_one_step() {
    Film film("film flat\nrange 1f 96f\ncreate a circle\ncreate b circle position=(4 0)\n");
    film.workspace.select({film.id("a"), film.id("b")});
    film.workspace.go_to(film.at_time("24f"));
    const QString before = film.text();
    for (const StagingRow& row : staging_rows()) {
      if (row.sort == StagingSort::text || row.sort == StagingSort::unmark || row.sort == StagingSort::angle) continue;
      stage(film.workspace, row);
      const QString wrote = film.text().mid(before.size()),
                    word = QString::fromUtf8(row.verb.data(), qsizetype(row.verb.size()));
      QVERIFY2(film.text().startsWith(before), qPrintable(film.text()));
      const bool both = row.sort == StagingSort::connect || row.sort == StagingSort::morph;
      QCOMPARE(wrote.count('\n'), both ? 1 : 2);
      QVERIFY2(wrote.startsWith("at 24f " + word + " a"), qPrintable(wrote));
      film.workspace.undo();
      QCOMPARE(film.text(), before);
    }
    stage(film.workspace, staging("Fade in"));
    QCOMPARE(film.text(), before + "at 24f fade-in a\nat 24f fade-in b\n");
    film.workspace.undo();
    stage(film.workspace, staging("Connect by a curve"));
    QCOMPARE(film.text(), before + "at 24f connect a to b curved\n");
    film.workspace.undo();
    film.workspace.select({film.id("b"), film.id("a")});  // the order of selection is the direction
    stage(film.workspace, staging("Morph into the second"));
    QCOMPARE(film.text(), before + "at 24f morph b into a\n");
    film.workspace.undo();
    film.workspace.go_to(film.at_time("1f"));  // from the beginning on
    stage(film.workspace, staging("Connect straight"));
    QCOMPARE(film.text(), before + "connect b to a\n");
    film.workspace.undo();
    stage(film.workspace, staging("Dimension"));
    QCOMPARE(film.text(), before + "dimension b to a\n");
  }

  void an_angle_needs_three_objects() {
    Film film(
        "film flat\nrange 1f 96f\ncreate a circle\ncreate b circle position=(4 0)\ncreate c circle position=(4 3)\n");
    film.workspace.go_to(film.at_time("24f"));
    const QString before = film.text();
    film.workspace.select({film.id("c"), film.id("b")});
    stage(film.workspace, staging("Angle"));
    QCOMPARE(film.text(), before);
    QMenu two, three;
    ObjectActions::of(film.workspace).fill(two);
    QVERIFY(!found_in(two, "Angle")->isEnabled() && found_in(two, "Dimension")->isEnabled());
    film.workspace.select({film.id("c"), film.id("b"), film.id("a")});
    ObjectActions::of(film.workspace).fill(three);
    QVERIFY(found_in(three, "Angle")->isEnabled() && !found_in(three, "Dimension")->isEnabled());
    stage(film.workspace, staging("Angle"));
    QCOMPARE(film.text(), before + "at 24f angle c b a\n");
  }

  void the_menu_carries_an_entrance_out() {
    Film film("film flat\nrange 1f 96f\ncreate a circle\n");
    film.select("a");
    film.workspace.go_to(film.at_time("24f"));
    QMenu menu;
    ObjectActions::of(film.workspace).fill(menu);
    found_in(menu, "Fade in")->trigger();
    const auto seen = [&](const char* when) {
      film.workspace.go_to(film.at_time(when));
      return std::get<double>(film.value("a.transparency"));
    };
    QVERIFY(std::abs(seen("36f") - 0.5) < 1e-9);  // halfway through a second of 24 frames
    QCOMPARE(seen("48f"), 0.0);
    film.workspace.go_to(film.at_time("12f"));
    QCOMPARE(shown_of(film, "a"), 0);
    // Two things are needed for a connection.
    QVERIFY(!found_in(menu, "Connect straight")->isVisible() || !found_in(menu, "Connect and morph")->isEnabled());
  }

  void marks_are_taken_away() {
    const QByteArray begin =
        "film flat\nrange 1f 96f\ncreate a circle\ncreate b circle position=(4 0)\n"
        "create c code text=\"a\\nb\"\n";
    // Each mark alone, once: then there is nothing left.
    for (const StagingRow& row : staging_rows()) {
      if (row.sort != StagingSort::mark) continue;
      Film film(begin);
      film.select("a");
      film.workspace.go_to(film.at_time("12f"));
      stage(film.workspace, row);
      film.workspace.go_to(film.at_time("48f"));
      for (int times = 0; times < 2; ++times) {
        stage(film.workspace, staging("Take marks away"));
        QCOMPARE(film.text().count(" off\n"), 1);
        film.workspace.go_to(film.at_time("72f"));
      }
      QVERIFY2(film.text().endsWith("at 48f " + QString::fromStdString(std::string(row.verb)) + " a off\n"), row.name);
    }
    Film film(begin + "at 12f underline a\nat 12f spotlight a\nat 12f highlight c lines 1..2\n");
    const QString before = film.text();
    film.workspace.go_to(film.at_time("48f"));
    film.workspace.select({film.id("a"), film.id("b"), film.id("c")});
    stage(film.workspace, staging("Take marks away"));
    QCOMPARE(film.text(), before + "at 48f underline a off\nat 48f spotlight a off\nat 48f highlight c off\n");
    QString why;
    connect(&film.workspace, &Workspace::said, this, [&](const QString&, const QString& answer) { why = answer; });
    film.select("b");
    stage(film.workspace, staging("Take marks away"));
    QVERIFY(why.contains("no marks"));
    film.workspace.select({});
    stage(film.workspace, staging("Fade in"));
    QVERIFY(why.contains("select"));
    film.select("a");
    stage(film.workspace, staging("Connect straight"));
    QVERIFY(why.contains("two objects"));
  }

  void a_label_asks_for_its_text() {
    Film film("film flat\nrange 1f 96f\ncreate a circle\n");
    const QString before = film.text();
    film.select("a");
    film.workspace.go_to(film.at_time("24f"));
    const auto answer = [](const QString& text, bool accept) {
      QTimer::singleShot(0, [=] {
        auto* dialog = qobject_cast<QInputDialog*>(QApplication::activeModalWidget());
        if (!dialog) return;
        QCOMPARE(dialog->textValue(), "a");
        dialog->setTextValue(text);
        accept ? dialog->accept() : dialog->reject();
      });
    };
    answer("a \"disc\"", true);
    stage(film.workspace, staging("Label…"));
    QCOMPARE(film.text(), before + "at 24f label a \"a \\\"disc\\\"\"\n");
    QVERIFY(film.id("a-label"));
    film.workspace.undo();
    answer("x", false);
    stage(film.workspace, staging("Callout…"));
    QCOMPARE(film.text(), before);
  }

  // ---- Charts in the picture

  void of_a_chart_the_first_click_takes_the_whole() {
    Film film(
        "film flat\ncreate b columns of=(3 1) keys=(\"x\" \"y\") size=(4 4)\ncreate d diagram of=\"p -> q\" "
        "position=(5 0)\nset d/p.position (0 1)\nset d/q.position (0 -1)\n");
    Viewport view(film.workspace);
    view.resize(800, 450);  // a metre is 50 pixels
    view.show();
    view.await_picture();
    // Where a piece is, by the frame.
    const auto spot = [&](const char* name) {
      Vec3 low{1e9, 1e9, 0}, high{-1e9, -1e9, 0};
      for (const Item& item : film.workspace.program().frame({}).items)
        if (item.id == film.id(name))
          for (const Vec3& c : drawn(item).corners)
            low = {std::min(low.x, c.x), std::min(low.y, c.y), 0},
            high = {std::max(high.x, c.x), std::max(high.y, c.y), 0};
      const Vec3 middle = 0.5 * (low + high);
      return QPoint(int(std::lround(400 + 50 * middle.x)), int(std::lround(225 - 50 * middle.y)));
    };
    const auto click = [&](const char* name) { QTest::mouseClick(&view, Qt::LeftButton, {}, spot(name)); };
    click("b/x");
    QCOMPARE(film.selected(), "b");
    click("b/x");
    QCOMPARE(film.selected(), "b/x");
    click("b/y");  // within the chart, the pieces
    QCOMPARE(film.selected(), "b/y");
    click("d/p");  // nodes are objects of their own
    QCOMPARE(film.selected(), "d/p");
    QTest::mouseClick(&view, Qt::LeftButton, {}, QPoint(20, 20));
    QCOMPARE(film.selected(), "");
    // A drag moves the whole chart by a metre.
    const QPoint from = spot("b/x");
    QTest::mousePress(&view, Qt::LeftButton, {}, from);
    for (int i = 1; i <= 5; ++i) {
      QMouseEvent move(QEvent::MouseMove, from + QPoint(10 * i, 0), view.mapToGlobal(from + QPoint(10 * i, 0)),
                       Qt::NoButton, Qt::LeftButton, {});
      QApplication::sendEvent(&view, &move);
    }
    QTest::mouseRelease(&view, Qt::LeftButton, {}, from + QPoint(50, 0));
    QCOMPARE(film.selected(), "b");
    QVERIFY2(film.text().endsWith("set b.position (1 0 0)\n"), qPrintable(film.text()));
  }

  // ---- Icons and fields

  void no_two_kinds_have_the_same_icon() {
    const auto picture = [](Kind k) {
      return kind_icon(k).pixmap(32, 32).toImage().convertToFormat(QImage::Format_ARGB32);
    };
    const auto all = kinds();
    for (std::size_t i = 0; i < all.size(); ++i)
      for (std::size_t k = 0; k < i; ++k) {
        const QImage a = picture(all[i].kind), b = picture(all[k].kind);
        int differ = 0;
        for (int y = 0; y < 32; ++y)
          for (int x = 0; x < 32; ++x) differ += std::abs(qAlpha(a.pixel(x, y)) - qAlpha(b.pixel(x, y))) > 60 ? 1 : 0;
        const std::string names = std::string(all[i].name) + " and " + std::string(all[k].name);
        QVERIFY2(differ > 25, (names + ": " + std::to_string(differ)).c_str());
      }
  }

  // In the window, ctrl-Return elsewhere goes to the console.
  void code_keeps_the_focus_in_the_window() {
    Film film("film flat\ncreate c code text=\"a\"\n");
    Window window(film.workspace);
    window.show();
    QVERIFY(QTest::qWaitForWindowActive(&window));
    window.show_panel("properties");
    film.select("c");
    auto* field = window.panel("properties")->findChild<ValueEditor*>("text")->findChild<QPlainTextEdit*>("value");
    field->setFocus();
    QTest::keyClicks(field, "b");
    QTest::keyClick(field, Qt::Key_Return, Qt::ControlModifier);
    QCOMPARE(*std::get<Text>(film.value("c.text")), std::string("ba"));
    QCOMPARE(QApplication::focusWidget(), field);
  }

  void code_is_edited_in_lines() {
    ShownProperties s("film flat\ncreate c code language=python text=\"a = 1\\nb = \\\"x\\\"\"\n", "c", 500);
    const auto field = [&] { return s.panel.findChild<ValueEditor*>("text")->findChild<QPlainTextEdit*>("value"); };
    QVERIFY(field());
    QVERIFY2(field()->width() > 400, "it has the width of the panel, which is 500");
    QCOMPARE(field()->toPlainText(), "a = 1\nb = \"x\"");
    const QString before = s.text();
    field()->setFocus();
    field()->moveCursor(QTextCursor::End);
    QTest::keyClicks(field(), " + c");
    QTest::keyClick(field(), Qt::Key_Escape);
    QCOMPARE(field()->toPlainText(), "a = 1\nb = \"x\"");
    QCOMPARE(s.text(), before);
    field()->setFocus();
    field()->moveCursor(QTextCursor::End);
    QTest::keyClick(field(), Qt::Key_Return);
    QTest::keyClicks(field(), "c = '\\'");
    QTest::keyClick(field(), Qt::Key_Return, Qt::ControlModifier);
    QCOMPARE(*std::get<Text>(s.value("c.text")), std::string("a = 1\nb = \"x\"\nc = '\\'"));
    s.workspace.undo();
    QCOMPARE(s.text(), before);
    auto* language = s.panel.findChild<ValueEditor*>("language")->findChild<QComboBox*>("value");
    QVERIFY(language && language->findText("rust") >= 0);
  }

  void a_diagram_changes_as_a_whole() {
    ShownProperties s("film flat\nrange 1f 96f\n\ncreate d diagram of=\"a -> b -> c\"  # steps\n", "d", 500);
    const QString before = s.text();
    const auto layout = [&](const char* word) {
      auto* box = s.panel.findChild<ValueEditor*>("layout")->findChild<QComboBox*>("value");
      box->setCurrentText(word);
      Q_EMIT box->textActivated(word);
    };
    const auto place = [&](const char* node, const char* when) {
      const Value v = s.workspace.program().read(Target(s.id(node), Query::world), s.at_time(when));
      return translation_of(*std::get<Matrix>(v));
    };
    QVERIFY(std::abs(place("d/a", "1f").x - place("d/b", "1f").x) < 1e-6);  // one below the other
    layout("circle");
    QCOMPARE(s.text(), QString(before).replace("\"  #", "\" layout=circle  #"));
    QVERIFY(std::abs(place("d/a", "1f").x - place("d/b", "1f").x) > 0.5);
    s.workspace.undo();
    QCOMPARE(s.text(), before);
    auto* of = s.panel.findChild<ValueEditor*>("of")->findChild<QPlainTextEdit*>("value");
    of->setFocus();
    of->selectAll();
    QTest::keyClicks(of, "a -> z");
    QTest::keyClick(of, Qt::Key_Return, Qt::ControlModifier);
    QCOMPARE(s.text(), QString(before).replace("a -> b -> c", "a -> z"));
    QVERIFY(s.id("d/z") && !s.id("d/b"));
    s.workspace.undo();
    // Later it turns into another one.
    s.workspace.go_to(s.at_time("24f"));
    layout("circle");
    QCOMPARE(s.text(), before + "at 24f rearrange d layout=circle\n");
    QVERIFY(std::abs(place("d/a", "24f").x - place("d/b", "24f").x) < 1e-6);
    QVERIFY(std::abs(place("d/a", "48f").x - place("d/b", "48f").x) > 0.5);
  }

  // ---- The palette

  void the_palette_finds_the_words_of_teachers() {
    Film film("film flat\ncreate a circle\n");
    Window window(film.workspace);
    Palette palette(window);
    auto* list = palette.findChild<QListWidget*>();
    const auto among_first = [&](const char* letters, const char* wanted) {
      palette.findChild<QLineEdit*>()->setText(letters);
      for (int i = 0; i < std::min(8, list->count()); ++i)
        if (list->item(i)->text().contains(wanted)) return true;
      return false;
    };
    for (const auto& [letters, wanted] : {std::pair("chart", "Add object: columns"),
                                          {"graph", "Add object: plot"},
                                          {"code", "Add object: code"},
                                          {"arrow", "Add object: arrow"},
                                          {"arrow", "Connect straight"},
                                          {"label", "Label…"},
                                          {"formula", "Add object: text"},
                                          {"formula", "Add object: plot"},
                                          {"fade", "Fade in"},
                                          {"fade", "Fade out"},
                                          {"appear", "Fade in"},
                                          {"latex", "Add object: text"}})
      QVERIFY2(among_first(letters, wanted), (std::string(letters) + ": " + wanted).c_str());
    // The letters of other words do not come first.
    palette.findChild<QLineEdit*>()->setText("chart");
    QVERIFY2(list->item(0)->text().startsWith("Add object"), qPrintable(list->item(0)->text()));
    palette.findChild<QLineEdit*>()->setText("copy");
    QVERIFY2(list->item(0)->text().startsWith("Object: Copy"), qPrintable(list->item(0)->text()));
    palette.findChild<QLineEdit*>()->setText("columns");
    QTest::keyClick(palette.findChild<QLineEdit*>(), Qt::Key_Return);
    QVERIFY2(film.id("columns1"), qPrintable(film.text()));
  }
};

}  // namespace betwixt::studio

QTEST_MAIN(betwixt::studio::ExplainingTest)
#include "explaining_test.moc"
