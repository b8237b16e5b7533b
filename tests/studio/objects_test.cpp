// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests edits of whole objects: copies, instances, groups, mirrors, alignment, the clipboard, and removal.
#include <QApplication>
#include <QClipboard>
#include <QTest>

#include "betwixt/pick.h"
#include "studio/film.h"
#include "studio/objects/object_actions.h"
#include "studio/viewport/viewport.h"

namespace betwixt::studio {

class ObjectsTest : public QObject {
  Q_OBJECT

  struct Shown : Film {
    using Film::Film;
    ObjectActions& act{ObjectActions::of(workspace)};
    void select(std::initializer_list<const char*> names) {
      std::vector<ObjectId> all;
      for (const char* name : names) all.push_back(id(name));
      workspace.select(all);
    }
    // Where an object is in the world at a time.
    Vec3 place(const char* name, const char* when = "1f") {
      const Value v = workspace.program().read(Target(id(name), Query::world), at_time(when));
      return translation_of(*std::get<Matrix>(v));
    }
    void expect(const char* name, Vec3 wanted, const char* when = "1f") {
      const Vec3 is = place(name, when);
      if (!(length(is - wanted) < 2e-3)) qWarning("%s is at %g %g %g", name, is.x, is.y, is.z);
      QVERIFY(length(is - wanted) < 2e-3);
    }
    // One undo takes the last action back.
    void undone_is(const QString& text) {
      workspace.undo();
      QCOMPARE(this->text(), text);
      workspace.redo();
    }
  };
  static constexpr const char* arm =
      "rate 24\nrange 1f 24f\ncreate base box position=(1 0 0)\ncreate arm box position=(0 1 0)\ncouple arm to base\n"
      "create base/lamp sphere position=(0 2 0)\ncreate far sphere position=(0 0 5)\n"
      "base.position.x\n  1f 1 linear\n  24f 3\n";

 private Q_SLOTS:
  void a_duplicate_has_all_that_hangs_on_it() {
    Shown s(arm);
    const QString before = s.text();
    s.select({"base"});
    s.act.duplicate();
    QCOMPARE(s.selected(), "base2");
    for (const char* when : {"1f", "12f", "24f"}) {
      s.expect("base2", s.place("base", when), when);
      s.expect("arm2", s.place("arm", when), when);
      s.expect("base2/lamp", s.place("base/lamp", when), when);
    }
    QVERIFY(!s.id("far2"));
    s.workspace.say(std::string("set base2.position.y 7"));  // the copied arm follows the copied base
    s.expect("arm2", Vec3{1, 8, 0});
    s.expect("arm", Vec3{1, 1, 0});
    s.workspace.undo();
    s.undone_is(before);
    s.select({"base2"});
    s.act.duplicate();
    QCOMPARE(s.selected(), "base3");
  }

  void copies_do_not_get_the_names_of_aliases() {
    Shown s("create ball sphere\nalias ball2 = ball\n");
    s.select({"ball"});
    s.act.duplicate();
    QCOMPARE(s.selected(), "ball3");
  }

  void a_copied_child_keeps_its_parent() {
    Shown s(arm);
    s.select({"arm"});
    s.act.duplicate();
    QCOMPARE(s.selected(), "arm2");
    s.expect("arm2", s.place("arm", "24f"), "24f");
    QVERIFY(!s.id("base2"));
  }

  void instances_follow() {
    Shown s("create ball sphere radius=1\n");
    s.select({"ball"});
    s.act.instance();
    QCOMPARE(s.selected(), "ball2");
    s.workspace.say(std::string("set ball.radius 3"));
    QCOMPARE(s.radius("ball2"), 3.0);
    s.select({"ball2"});
    s.act.instance();  // of the same kind
    QCOMPARE(s.selected(), "ball3");
    s.workspace.say(std::string("set ball.radius 4"));
    QCOMPARE(s.radius("ball3"), 4.0);
    QCOMPARE(s.text().count("define kind"), 1);
  }

  void a_mirrored_twin_mirrors_all_motion() {
    Shown s(arm);
    s.select({"base", "arm"});
    s.act.mirror(Axis::x);
    QCOMPARE(s.selected(), "base2");
    for (const char* when : {"1f", "12f", "24f"})
      for (const auto& [one, twin] : {std::pair("base", "base2"), {"arm", "arm2"}}) {
        const Vec3 p = s.place(one, when);
        s.expect(twin, Vec3{-p.x, p.y, p.z}, when);
      }
  }

  void a_group_moves_nothing() {
    Shown s(arm);
    s.workspace.go_to(s.at_time("12f"));
    const QString before = s.text();
    std::vector<Vec3> were;
    for (const char* when : {"1f", "12f", "24f"}) were.push_back(s.place("arm", when));
    s.select({"base", "arm", "far"});
    s.act.group();
    QCOMPARE(s.selected(), "group1");
    QVERIFY(!s.text().contains("at 12f"));
    std::size_t k = 0;
    for (const char* when : {"1f", "12f", "24f"}) s.expect("arm", were[k++], when);
    s.undone_is(before);
    s.workspace.say(std::string("set group1.position.y 4"));
    const Vec3 moved = s.place("far");
    s.select({"group1"});
    const QString grouped = s.text();
    std::vector<Vec3> base;
    for (const char* when : {"1f", "7f", "12f", "24f"}) base.push_back(s.place("base", when));
    s.act.ungroup();  // `base` has events, and the group has moved: they move
    QVERIFY2(!s.id("group1"), qPrintable(s.text()));
    k = 0;
    for (const char* when : {"1f", "7f", "12f", "24f"}) s.expect("base", base[k++], when);
    s.expect("far", moved);
    QVERIFY(moved.y > 1);
    s.workspace.undo();
    QCOMPARE(s.text(), grouped);
    // A turned group cannot leave events as they are.
    s.workspace.say(std::string("set group1.rotation euler(0 0 90deg)"));
    s.select({"group1"});
    s.act.ungroup();
    QVERIFY(s.id("group1"));
    s.workspace.undo(), s.workspace.undo();
    s.select({"group1"});
    s.act.ungroup();
    QVERIFY(!s.id("group1"));
    s.expect("far", Vec3{0, 0, 5});
  }

  void ungrouped_parts_stay() {
    Shown s("create a sphere position=(1 0 0)\ncreate b sphere position=(-1 0 0)\n");
    s.select({"a", "b"});
    s.act.group();
    s.workspace.say(Lines{"set group1.position (5 1 0)", "set group1.rotation euler(0 0 90deg)"});
    const Vec3 a = s.place("a"), b = s.place("b");
    s.select({"group1"});
    s.act.ungroup();
    QVERIFY(!s.id("group1"));
    s.expect("a", a), s.expect("b", b);
    QVERIFY(length(a - Vec3{1, 0, 0}) > 1);
  }

  void text_goes_to_another_window() {
    Shown s(arm), other("rate 24\nrange 1f 24f\ncreate base sphere\n");
    s.select({"base"});
    s.act.copy();
    const QString copied = QApplication::clipboard()->text();
    QVERIFY2(!copied.contains("far") && !copied.contains("range"), qPrintable(copied));
    other.act.paste();
    QCOMPARE(other.selected(), "base2 arm");
    for (const char* when : {"1f", "12f", "24f"}) {
      other.expect("base2", s.place("base", when), when);
      other.expect("arm", s.place("arm", when), when);
      other.expect("base2/lamp", s.place("base/lamp", when), when);
    }
    s.act.paste();  // into the same film
    QCOMPARE(s.selected(), "base2 arm2");
    const QString text = s.text();
    QApplication::clipboard()->setText("this is no film");
    s.act.paste();
    QCOMPARE(s.text(), text);
  }

  void a_model_of_a_kind_is_pasted_as_a_thing() {
    Shown s("create ball sphere radius=1\n");
    s.select({"ball"});
    s.act.instance();
    s.select({"ball"});
    s.act.copy();
    s.act.paste();
    QCOMPARE(s.selected(), "ball3");
    QCOMPARE(s.text().count("define kind"), 1);
    Shown other("create box box\n");
    other.act.paste();
    QVERIFY(other.id("ball") && other.text().contains("define kind ball-kind like ball"));
  }

  void what_hangs_on_it_goes_along() {
    Shown s(arm);
    const QString before = s.text();
    s.select({"base"});
    s.act.remove();
    QVERIFY(s.id("arm") && !s.id("base") && !s.id("base/lamp"));
    s.workspace.undo();
    s.select({"base"});
    s.act.remove_all();
    QVERIFY(!s.id("arm") && !s.id("base") && !s.id("base/lamp") && s.id("far"));
    s.undone_is(before);
    s.workspace.undo();
    s.select({"far"});
    s.act.cut();
    QVERIFY(!s.id("far"));
    s.act.paste();
    QVERIFY(s.id("far"));
  }

  void aligns_and_distributes() {
    Shown s("create a sphere position=(1 5 0)\ncreate b sphere position=(2 6 1)\ncreate c sphere position=(9 7 2)\n");
    s.select({"a", "b", "c"});
    s.act.align(Axis::y);
    s.expect("a", Vec3{1, 7, 0}), s.expect("b", Vec3{2, 7, 1}), s.expect("c", Vec3{9, 7, 2});
    s.act.distribute(Axis::x);
    s.expect("b", Vec3{5, 7, 1});
  }

  // What is drawn stays where it is, also if it is turned and scaled; then it turns about its lowest point.
  void pivots_go_to_the_bottom_and_to_the_middle() {
    Shown s(
        "create egg sphere radius=0.5 position=(1 2 0) scale=(1 3 1)\n"
        "create rod box size=(0.2 2 0.2) position=(0 1 0) rotation=euler(0 0 90deg)\n"
        "create eye camera\n");
    const QString before = s.text();
    const auto box = [&](const char* name) {
      Vec3 low{1e9, 1e9, 1e9}, high{-1e9, -1e9, -1e9};
      for (const Item& item : s.workspace.program().frame(s.workspace.time()).items)
        if (item.id == s.id(name))
          for (const Vec3& corner : drawn(item, 200).corners)
            for (int i = 0; i < 3; ++i) low[i] = std::min(low[i], corner[i]), high[i] = std::max(high[i], corner[i]);
      return std::pair(low, high);
    };
    const auto same = [](std::pair<Vec3, Vec3> a, std::pair<Vec3, Vec3> b) {
      return length(a.first - b.first) < 1e-3 && length(a.second - b.second) < 1e-3;
    };
    const auto egg = box("egg"), rod = box("rod");
    s.select({"egg", "rod"});
    s.act.pivot(true);
    QCOMPARE(std::get<Vec3>(s.value("egg.pivot")), (Vec3{0, -0.5, 0}));
    QCOMPARE(std::get<Vec3>(s.value("rod.pivot")), (Vec3{0, -1, 0}));
    QVERIFY(same(box("egg"), egg) && same(box("rod"), rod));
    s.undone_is(before);
    s.workspace.say(std::string("set egg.scale (1 1 1)"));
    QVERIFY(std::abs(box("egg").first.y - egg.first.y) < 1e-3);
    s.act.pivot(false);
    QCOMPARE(std::get<Vec3>(s.value("egg.pivot")), Vec3{});
    s.select({"eye"});
    const QString unchanged = s.text();
    s.act.pivot(true);
    QCOMPARE(s.text(), unchanged);
  }

  void what_falls_bounces_on_the_floor() {
    Shown s(
        "rate 24\nrange 1f 96f\ncreate ball sphere radius=0.5 position=(0 4 0)\ncreate cube box size=(1 2 1) "
        "position=(3 5 0)\n");
    s.select({"ball", "cube"});
    s.act.fall();
    QVERIFY2(s.text().contains("at 1f fall ball ground=0.5 bounce=0.6\n") &&
                 s.text().contains("at 1f fall cube ground=1 bounce=0.6\n"),
             qPrintable(s.text()));
    // It meets the floor after the time that a fall of 3.5 m takes, 20.3 frames, and comes up again.
    double lowest = 9, later = 0;
    for (int f = 1; f <= 40; ++f) {
      const double y = s.place("ball", (std::to_string(f) + "f").c_str()).y;
      lowest = std::min(lowest, y);
      if (f > 24) later = std::max(later, y);
    }
    QVERIFY(lowest > 0.499 && lowest < 0.8);
    QVERIFY(std::abs(later - (0.5 + 0.36 * 3.5)) < 0.05);  // the share of the energy is that of the speed, squared
  }

  void hides_and_shows_all() {
    Shown s(arm);
    s.select({"arm", "far"});
    s.act.hide();
    QVERIFY(!std::get<bool>(s.value("arm.display")) && !std::get<bool>(s.value("far.display")));
    s.act.show_all();
    QVERIFY(std::get<bool>(s.value("arm.display")) && std::get<bool>(s.value("far.display")));
  }

  void keys_work_in_the_picture() {
    Shown s("create ball sphere\n");
    Viewport view(s.workspace);
    view.show();
    s.select({"ball"});
    QTest::keyClick(&view, Qt::Key_D, Qt::ControlModifier);
    QCOMPARE(s.selected(), "ball2");
    QTest::keyClick(&view, Qt::Key_Delete);
    QVERIFY(!s.id("ball2"));
    s.select({"ball"});
    QTest::keyClick(&view, Qt::Key_G, Qt::ControlModifier);
    QCOMPARE(s.selected(), "group1");
    QTest::keyClick(&view, Qt::Key_G, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(!s.id("group1"));
  }

  // Names of copies are free, and all edits are undone to the first text.
  void nothing_selected_does_nothing() {
    Shown s(arm);
    const QString before = s.text();
    s.workspace.select({});
    for (const ObjectActions::Row& row : ObjectActions::rows())
      if (row.run != &ObjectActions::paste) (s.act.*row.run)();
    QCOMPARE(s.text(), before);
  }
};

}  // namespace betwixt::studio

QTEST_MAIN(betwixt::studio::ObjectsTest)
#include "objects_test.moc"
