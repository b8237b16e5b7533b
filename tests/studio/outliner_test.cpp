// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests changes of parents in the outliner by drag and drop.
#include "studio/panels/outliner.h"

#include <QMenu>
#include <QTest>

#include "studio/film.h"

namespace betwixt::studio {

class OutlinerTest : public QObject {
  Q_OBJECT

  struct Shown : Film {
    Outliner panel{workspace};
    OutlinerTree& tree{*panel.findChild<OutlinerTree*>("outliner_tree")};
    QLineEdit& pattern{*panel.findChild<QLineEdit*>("pattern")};
    explicit Shown(const QByteArray& text) : Film(text) {
      panel.resize(300, 500);
      panel.show();
      if (!QTest::qWaitForWindowActive(&panel)) qFatal("no window");
    }
    QAbstractItemModel& model() { return *tree.model(); }
    // "car(wheel1 wheel2) ball"
    QString told(const QModelIndex& of = {}) {
      QString all;
      for (int i = 0; i < model().rowCount(of); ++i) {
        const QModelIndex at = model().index(i, 0, of);
        const QString below = told(at);
        all += (i > 0 ? " " : "") + at.data().toString() + (below.isEmpty() ? "" : "(" + below + ")");
      }
      return all;
    }
    QModelIndex at(const char* name, int column = 0) {
      return static_cast<OutlinerModel&>(model()).index_of(id(name), column);
    }
    QPoint place(const char* name, int column = 0) { return tree.visualRect(at(name, column)).center(); }
    void click(const char* name, Qt::KeyboardModifiers held = {}, int column = 0) {
      QTest::mouseClick(tree.viewport(), Qt::LeftButton, held, place(name, column));
    }
    void drag(const char* name, QPoint to, Qt::KeyboardModifiers held = {}) {
      QWidget* w = tree.viewport();
      const QPoint from = place(name);
      QTest::mousePress(w, Qt::LeftButton, {}, from);
      for (const QPoint p : {from + (to - from) / 2, to}) {
        QMouseEvent move(QEvent::MouseMove, p, w->mapToGlobal(p), Qt::NoButton, Qt::LeftButton, held);
        QCoreApplication::sendEvent(w, &move);
      }
      QTest::mouseRelease(w, Qt::LeftButton, held, to);
    }
    QPoint nowhere() { return {tree.viewport()->width() / 2, tree.viewport()->height() - 5}; }
    bool display(const char* name) { return std::get<bool>(value(std::string(name) + ".display")); }
  };

 private Q_SLOTS:
  void shows_what_hangs_on_what() {
    Shown s(
        "rate 24\ncreate car group\ncreate car/wheel{1..2} cylinder\ncreate ball sphere\n"
        "create hand box\nat 13f attach ball to hand\n");
    QCOMPARE(s.told(), "car(wheel1 wheel2) ball hand");
    s.workspace.go_to(s.at_time("13f"));
    QCOMPARE(s.told(), "car(wheel1 wheel2) hand(ball)");
    s.workspace.go_to(s.at_time("1f"));
    QCOMPARE(s.told(), "car(wheel1 wheel2) ball hand");
  }

  void selects_both_ways() {
    Shown s("create a sphere\ncreate b sphere\ncreate c sphere\n");
    s.click("b");
    QCOMPARE(s.selected(), "b");
    s.click("a", Qt::ControlModifier);
    QCOMPARE(s.selected(), "b a");  // the last one leads
    s.workspace.select({s.id("c")});
    QVERIFY(s.tree.selectionModel()->isSelected(s.at("c")));
    QVERIFY(!s.tree.selectionModel()->isSelected(s.at("a")));
  }

  void filters_by_pattern() {
    Shown s("create car group\ncreate car/wheel{1..3} cylinder\ncreate ball sphere\n");
    QTest::keyClicks(&s.pattern, "car/wheel[12]");
    QCOMPARE(s.told(), "car(wheel1 wheel2)");
    s.pattern.setText("all");  // a part of a name
    QCOMPARE(s.told(), "ball");
    s.pattern.clear();
    QCOMPARE(s.told(), "car(wheel1 wheel2 wheel3) ball");
  }

  void a_drag_couples_attaches_and_hangs() {
    const QByteArray film = "create hand box position=(3 0 0)\ncreate ball sphere\n";
    const std::tuple<Qt::KeyboardModifiers, AttachmentKind> ways[] = {{Qt::NoModifier, AttachmentKind::couple},
                                                                      {Qt::AltModifier, AttachmentKind::attach},
                                                                      {Qt::ShiftModifier, AttachmentKind::hang}};
    for (const auto& [held, how] : ways) {
      Shown s(film);
      s.drag("ball", s.place("hand"), held);
      const auto spans = attachments(s.workspace.document(), s.id("ball"));
      QVERIFY(!spans.empty());
      QCOMPARE(spans[0].to, (Attachment{how, s.id("hand"), false}));
      QCOMPARE(s.told(), "hand(ball)");
      const auto place = [&] { return translation_of(*std::get<Matrix>(s.value("ball.world"))); };
      QCOMPARE(place(), (Vec3{0, 0, 0}));  // it stays, and then moves along
      s.workspace.say(std::string("set hand.position (3 1 0)"));
      QCOMPARE(place(), (Vec3{0, 1, 0}));
      s.workspace.undo();
      s.workspace.undo();
      QCOMPARE(s.text(), film);
      QCOMPARE(s.told(), "hand ball");
    }
  }

  // To something that stands still, it is a child for the whole film; to something that has moved, from now on.
  void later_a_drag_is_timed_only_if_the_parent_has_moved() {
    Shown s(
        "rate 24\nrange 1f 48f\ncreate hand box position=(3 0 0)\ncreate ball sphere\ncreate cart box\n"
        "cart.position.x\n  1f 0\n  48f 9\n");
    s.workspace.go_to(s.at_time("24f"));
    s.drag("ball", s.place("hand"));
    QVERIFY(!s.text().contains("at 24f"));
    s.drag("ball", s.place("cart"));
    QVERIFY2(s.text().contains("at 24f couple ball to cart keep-world"), qPrintable(s.text()));
  }

  void a_drag_to_nowhere_lets_go() {
    Shown s("create hand box\ncreate ball sphere\ncouple ball to hand\n");
    s.drag("ball", s.nowhere());
    QCOMPARE(s.told(), "hand ball");
    QCOMPARE(attachments(s.workspace.document(), s.id("ball")).back().to.kind, AttachmentKind::detach);
  }

  void where_it_hangs_by_time_it_does_so_from_now_on() {
    Shown s("rate 24\ncreate hand box\ncreate ball sphere\nat 1f attach ball to hand\n");
    s.workspace.go_to(s.at_time("25f"));
    s.drag("ball", s.nowhere());
    const auto spans = attachments(s.workspace.document(), s.id("ball"));
    QCOMPARE(spans.back().to.kind, AttachmentKind::letgo);
    QCOMPARE(spans.back().from, s.at_time("25f"));
    s.workspace.go_to(s.at_time("12f"));
    QCOMPARE(s.told(), "hand(ball)");
  }

  void new_things_stand_on_the_ground() {
    Shown s("ground on\n");
    const auto make = [&](const char* kind) {
      for (const QMenu* group : s.panel.findChild<QToolButton*>("add")->menu()->findChildren<QMenu*>())
        for (QAction* a : group->actions())
          if (a->text() == kind) a->trigger();
    };
    make("sphere");
    QVERIFY2(s.text().endsWith("create sphere1 sphere position=(0 1 0)\n"), qPrintable(s.text()));
    make("plane");
    make("group");
    QVERIFY2(s.text().endsWith("create group1 group\n"), qPrintable(s.text()));
    make("light");
    QVERIFY(s.text().endsWith("create light1 light position=(4 8 6)\n"));
  }

  void escape_calls_a_drag_off() {
    Shown s("create hand box\ncreate ball sphere\n");
    QWidget* w = s.tree.viewport();
    QTest::mousePress(w, Qt::LeftButton, {}, s.place("ball"));
    const QPoint to = s.place("hand");
    QMouseEvent move(QEvent::MouseMove, to, w->mapToGlobal(to), Qt::NoButton, Qt::LeftButton, {});
    QCoreApplication::sendEvent(w, &move);
    QTest::keyClick(&s.tree, Qt::Key_Escape);
    QTest::mouseRelease(w, Qt::LeftButton, {}, to);
    QCOMPARE(s.told(), "hand ball");
    QCOMPARE(s.workspace.session().unsaved(), std::size_t{0});
  }

  void several_are_dragged_in_one_step() {
    Shown s("create hand box\ncreate a sphere\ncreate b sphere\n");
    s.click("a");
    s.click("b", Qt::ControlModifier);
    s.drag("a", s.place("hand"));
    QCOMPARE(s.told(), "hand(a b)");
    s.workspace.undo();
    QCOMPARE(s.told(), "hand a b");
  }

  void the_eye_hides_and_shows() {
    Shown s("rate 24\ncreate ball sphere\n");
    s.click("ball", {}, OutlinerModel::eye);
    QVERIFY(!s.display("ball"));
    QCOMPARE(s.events_of("ball.display"), std::size_t{0});
    s.click("ball", {}, OutlinerModel::eye);
    QVERIFY(s.display("ball"));
    s.workspace.say(std::string("at 1f show ball"));
    s.workspace.go_to(s.at_time("13f"));
    s.click("ball", {}, OutlinerModel::eye);
    QVERIFY(!s.display("ball"));
    QCOMPARE(s.events_of("ball.display"), std::size_t{2});
    s.workspace.go_to(s.at_time("12f"));
    QVERIFY(s.display("ball"));
  }

  void renames_and_removes() {
    Shown s("create ball sphere\ncreate car box\n");
    s.click("ball");
    QTest::mouseDClick(s.tree.viewport(), Qt::LeftButton, {}, s.place("ball"));
    auto* line = s.tree.viewport()->findChild<QLineEdit*>();
    QVERIFY(line);
    line->selectAll();
    QTest::keyClicks(line, "globe");
    QTest::keyClick(line, Qt::Key_Return);
    QTRY_COMPARE(s.workspace.document().names(), (std::vector<std::string>{"globe", "car"}));
    QCOMPARE(s.told(), "globe car");
    s.click("car");
    QTest::keyClick(&s.tree, Qt::Key_Delete);
    QCOMPARE(s.workspace.document().names(), std::vector<std::string>{"globe"});
    s.workspace.undo();
    s.workspace.undo();
    QCOMPARE(s.text(), "create ball sphere\ncreate car box\n");
  }

  void makes_objects() {
    Shown s("create sphere1 sphere\n");
    for (const QMenu* group : s.panel.findChild<QToolButton*>("add")->menu()->findChildren<QMenu*>())
      for (QAction* a : group->actions())
        if (a->text() == "sphere") a->trigger();
    QCOMPARE(s.text(), "create sphere1 sphere\ncreate sphere2 sphere\n");
    QCOMPARE(s.selected(), "sphere2");
  }

  void makes_objects_of_own_kinds() {
    Shown s("create man box\ndefine kind human like man\n");
    QMenu* menu = s.panel.findChild<QToolButton*>("add")->menu();
    for (int times = 0; times < 2; ++times) emit menu->aboutToShow();  // no entry twice
    int found = 0;
    QAction* human = nullptr;
    for (QAction* a : menu->actions())
      if (a->text() == "human") ++found, human = a;
    QCOMPARE(found, 1);
    human->trigger();
    QCOMPARE(s.text(), "create man box\ndefine kind human like man\ncreate human1 human\n");
    QVERIFY(s.at("human1").data(Qt::ToolTipRole).toString().endsWith("human"));
  }

  void what_is_folded_stays_so() {
    Shown s("create car group\ncreate car/wheel box\ncreate ball sphere\n");
    s.click("car");
    QTest::keyClick(&s.tree, Qt::Key_Minus);
    s.workspace.say(std::string("create more box"));
    QVERIFY(!s.tree.isExpanded(s.at("car")));
  }

  // The many pieces of axes do not hide the other objects.
  void pieces_of_axes_are_folded_first() {
    Shown s("film flat\ncreate car group\ncreate car/wheel circle\ncreate ax axes\n");
    QVERIFY(s.tree.isExpanded(s.at("car")));
    QVERIFY(!s.tree.isExpanded(s.at("ax")));
    s.workspace.say(std::string("create dot circle on=ax"));  // which is seen at once
    QVERIFY(s.tree.isExpanded(s.at("ax")) && !s.tree.isExpanded(s.at("ax/x")));
    s.tree.collapse(s.at("ax")), s.tree.expand(s.at("ax"));
    s.workspace.say(std::string("create ax2 axes"));
    QVERIFY(s.tree.isExpanded(s.at("ax")) && !s.tree.isExpanded(s.at("ax2")));
    s.tree.collapse(s.at("ax"));
    s.workspace.say(std::string("create more circle"));
    QVERIFY(!s.tree.isExpanded(s.at("ax")));
  }

  void ten_thousand_are_a_tree_too() {
    Shown s("create all group\ncreate all/s{1..10000} sphere\n");
    QCOMPARE(s.model().rowCount(s.at("all")), 10000);
    s.workspace.select({s.id("all/s10000")});
    QVERIFY(s.tree.visualRect(s.at("all/s10000")).isValid());
  }
};

}  // namespace betwixt::studio

QTEST_MAIN(betwixt::studio::OutlinerTest)
#include "outliner_test.moc"
