// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests poses: copied, mirrored, kept in files, used in part; and new keys: breakdowns, holds, where something changed.
#include "studio/poses/poses.h"

#include <QApplication>
#include <QClipboard>
#include <QDialog>
#include <QTest>
#include <QTimer>
#include <random>

#include "betwixt/math.h"
#include "betwixt/object.h"
#include "betwixt/track.h"
#include "studio/film.h"
#include "studio/poses/mixed.h"
#include "studio/poses/pose_actions.h"
#include "studio/shell/window.h"
#include "studio/timeline/event_actions.h"
#include "studio/timeline/key_lines.h"
#include "studio/viewport/viewport.h"
#include "track/twerpers.h"

namespace betwixt::studio {

constexpr const char* man =
    "range 1f 48f\n"
    "create man group position=(3 1 0)\n"
    "create man/{left,right} group\n"
    "set man/left.position (0 0 0.2)\n"
    "set man/right.position (0 0 -0.2)\n"
    "create man/{left,right}/knee group position=(0 -0.5 0)\n"
    "create man/{left,right}/knee/foot sphere radius=0.1 position=(0.1 -0.5 0.02)\n"
    "man/left.rotation\n"
    "  1f (0 0 0)\n"
    "  24f (10deg 20deg 30deg)\n"
    "man/left/knee.rotation.z\n"
    "  1f 0\n"
    "  24f -40deg\n";

class PosesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void a_window_that_tries_an_amount_stands_beside_the_picture() {
    Film film("range 1f 48f\ncreate ball sphere\nball.position\n  1f (0 0 0)\n  24f (4 0 0)\n");
    Window window(film.workspace);
    window.resize(1300, 850), window.show();
    QVERIFY(QTest::qWaitForWindowActive(&window));
    film.select("ball");
    film.workspace.go_to(film.at_time("12f"));
    QRect trial;
    QTimer::singleShot(100, &window, [&] {
      auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
      if (!dialog) return;
      trial = dialog->geometry();
      dialog->reject();
    });
    window.ask_breakdown();
    const Viewport& view = window.viewport();
    QVERIFY(!trial.isEmpty());
    QVERIFY(window.geometry().contains(trial));
    QVERIFY(!trial.intersects(QRect(view.mapToGlobal(QPoint()), view.size())));
  }

  static Vec3 world(const Film& f, const char* name) {
    const Value v = f.workspace.program().read(Target(f.id(name), Query::world), f.workspace.time());
    return translation_of(*std::get<Matrix>(v));
  }

 private Q_SLOTS:
  void a_pose_comes_back_at_another_time() {
    Film f(man);
    const QString before = f.text();
    f.select("man");
    f.workspace.go_to(f.at_time("24f"));
    const Vec3 foot = world(f, "man/left/knee/foot");
    PoseActions::of(f.workspace).copy();
    const QString copied = QApplication::clipboard()->text();
    QVERIFY2(
        copied.startsWith("# pose of man\n") && copied.contains("set man/left.rotation euler(10deg 20deg 30deg)\n"),
        qPrintable(copied));
    QVERIFY(!copied.contains("set man.position"));  // a character keeps its place
    f.workspace.go_to(f.at_time("40f"));
    QVERIFY(f.workspace.say(std::string("at 40f man.position (9 1 0)")));
    QVERIFY(f.workspace.say(std::string("at 44f man/left.rotation (0 0 0)")));
    PoseActions::of(f.workspace).paste(false);
    const Vec3 there = world(f, "man/left/knee/foot");
    QVERIFY(length(there - (foot + Vec3{6, 0, 0})) < 1e-6);
    QVERIFY2(f.text().contains("  40f euler(10deg 20deg 30deg)"), qPrintable(f.text()));
    QVERIFY2(!f.text().contains("man/right.rotation"), qPrintable(f.text()));  // nothing that is the same already
    f.workspace.undo(), f.workspace.undo(), f.workspace.undo();
    QCOMPARE(f.text(), before);
  }

  void a_mirrored_pose_is_the_mirror_image() {
    Film f(man);
    const QString before = f.text();
    f.select("man");
    f.workspace.go_to(f.at_time("24f"));
    const Vec3 left = world(f, "man/left/knee/foot");
    const Vec3 right = world(f, "man/right/knee/foot");
    PoseActions::of(f.workspace).copy();
    PoseActions::of(f.workspace).paste(true);
    const auto image = [](Vec3 v) { return Vec3{v.x, v.y, -v.z}; };  // the root stands at z = 0
    QVERIFY(length(world(f, "man/right/knee/foot") - image(left)) < 1e-6);
    QVERIFY(length(world(f, "man/left/knee/foot") - image(right)) < 1e-6);
    const Value knee = f.value("man/right.rotation");
    const double degree = pi / 180;
    QVERIFY(length(std::get<Angles>(knee).xyz - Vec3{-10 * degree, -20 * degree, 30 * degree}) < 1e-9);
    QCOMPARE(std::get<Angles>(f.value("man/right/knee.rotation")).xyz.z, -40 * degree);
    QCOMPARE(std::get<Angles>(f.value("man/left.rotation")).xyz, Vec3{});
    // Mirrored twice it is the same pose.
    const Pose pose = pose_of(f.workspace.program(), {f.id("man")}, f.workspace.time());
    const Pose twice =
        mirrored(mirrored(pose, f.workspace.program(), f.workspace.time()), f.workspace.program(), f.workspace.time());
    QCOMPARE(twice.parts.size(), pose.parts.size());
    for (const Pose::Part& part : pose.parts)
      QVERIFY(std::ranges::any_of(twice.parts, [&](const Pose::Part& other) {
        return other.object == part.object && other.function == part.function && other.value == part.value;
      }));
    f.workspace.undo();
    QCOMPARE(f.text(), before);
  }

  void names_of_sides_are_whole_words() {
    Film f(
        "create {bright,Arm_L,Arm_R,lamp,RightArm,LeftArm} sphere\nset bright.radius 2\nset lamp.radius 3\n"
        "set LeftArm.radius 4\nset Arm_L.radius 5\nat 1f {bright,Arm_L,Arm_R,lamp,RightArm,LeftArm}.radius 7\n");
    std::vector<ObjectId> all;
    for (const char* name : {"bright", "Arm_L", "Arm_R", "lamp", "RightArm", "LeftArm"}) all.push_back(f.id(name));
    QVERIFY2(std::ranges::all_of(all, [](ObjectId id) { return bool(id); }), qPrintable(f.text()));
    const Program& program = f.workspace.program();
    const Pose pose = pose_of(program, all, f.workspace.time());
    const Pose other = mirrored(pose, program, f.workspace.time());
    for (std::size_t i = 0; i < pose.parts.size(); ++i) {
      const std::string& name = pose.parts[i].object;
      const std::string wanted = name == "Arm_L"      ? "Arm_R"
                                 : name == "Arm_R"    ? "Arm_L"
                                 : name == "LeftArm"  ? "RightArm"
                                 : name == "RightArm" ? "LeftArm"
                                                      : name;
      QCOMPARE(other.parts[i].object, wanted);
    }
  }

  void a_pose_goes_to_another_character_and_in_part() {
    Film f(QByteArray(man) + "create twin like man\n");
    QVERIFY2(f.id("twin/left/knee"), qPrintable(f.text()));
    f.select("man");
    f.workspace.go_to(f.at_time("24f"));
    PoseActions& poses = PoseActions::of(f.workspace);
    QVERIFY(poses.keep("bent knee"));
    QCOMPARE(poses.kept(), QStringList{"bent knee"});
    f.workspace.go_to(f.at_time("1f"));
    f.select("twin");
    const auto pose = poses.read("bent knee");
    QVERIFY(pose.has_value());
    QCOMPARE(pose->root, std::string("twin"));
    QVERIFY(f.workspace.say(poses.lines(*pose, false, 0.5)));
    QVERIFY(std::abs(std::get<Angles>(f.value("twin/left/knee.rotation")).xyz.z + 20 * pi / 180) < 1e-8);
    QCOMPARE(std::get<Angles>(f.value("man/left/knee.rotation")).xyz.z, 0.0);
    f.workspace.undo();
    QVERIFY(!poses.read("none such").has_value());
    QVERIFY(!poses.keep("../escapes"));
    QVERIFY(poses.forget("bent knee") && poses.kept().isEmpty());
  }

  // A pose of a moving character does not reach back: what had no events keeps its value before.
  void a_pose_begins_at_the_playhead() {
    Film f(QByteArray(man) + "set man/right.rotation (0 0 5deg)\n");
    f.select("man");
    f.workspace.go_to(f.at_time("24f"));
    PoseActions::of(f.workspace).copy();
    f.workspace.go_to(f.at_time("40f"));
    PoseActions::of(f.workspace).paste(true);
    const double degree = pi / 180;
    QVERIFY(length(std::get<Angles>(f.value("man/right.rotation")).xyz -
                   Vec3{-10 * degree, -20 * degree, 30 * degree}) < 1e-9);
    for (const char* when : {"1f", "24f", "39f"}) {
      f.workspace.go_to(f.at_time(when));
      QVERIFY(length(std::get<Angles>(f.value("man/right.rotation")).xyz - Vec3{0, 0, 5 * degree}) < 1e-9);
    }
  }

  void what_is_no_pose_says_so() {
    Film f(man);
    f.select("man");
    QApplication::clipboard()->setText("hello");
    QString said;
    connect(&f.workspace, &Workspace::said, &f.workspace, [&](const QString&, const QString& why) { said = why; });
    const QString before = f.text();
    PoseActions::of(f.workspace).paste(false);
    QVERIFY2(said.contains("this is no pose"), qPrintable(said));
    for (const char* text : {"# pose of man\nset man/left.rotation", "# pose of man\nset none.rotation (0 0 0)",
                             "# pose of man\nset \"man.rotation (0 0 0)", "# pose of man\nset man.nothing 3"}) {
      said.clear();
      QApplication::clipboard()->setText(text);
      PoseActions::of(f.workspace).paste(true);
      QVERIFY2(!said.isEmpty(), text);
    }
    QCOMPARE(f.text(), before);
  }

  void breakdowns_are_between_the_events_beside_them() {
    Film f(
        "range 1f 48f\ncreate ball sphere\nball.position\n  1f (0 0 0)\n  25f (4 2 0) linear\nball.radius\n  1f 2\n");
    const QString before = f.text();
    f.select("ball");
    f.workspace.go_to(f.at_time("7f"));
    EventActions& events = EventActions::of(f.workspace);
    for (const double share : {-0.2, 0.0, 0.25, 0.5, 1.0, 1.2}) {
      QVERIFY(f.workspace.say(events.breakdown(share)));
      QVERIFY(length(std::get<Vec3>(f.value("ball.position")) - Vec3{4, 2, 0} * share) < 1e-6);
      QCOMPARE(f.events_of("ball.position"), std::size_t(3));
      QCOMPARE(f.events_of("ball.radius"), std::size_t(1));
      f.workspace.undo();
    }
    QCOMPARE(f.text(), before);
  }

  void a_hold_keeps_the_last_value() {
    Film f("range 1f 48f\ncreate ball sphere\nball.position.x\n  1f 0\n  25f 4 linear\n  40f 8\n");
    f.select("ball");
    f.workspace.go_to(f.at_time("31f"));
    EventActions::of(f.workspace).hold();
    for (int i = 25; i <= 31; ++i) {
      f.workspace.go_to(f.workspace.document().rate().frame(i));
      QCOMPARE(std::get<Vec3>(f.value("ball.position")).x, 4.0);
    }
    f.workspace.go_to(f.at_time("40f"));
    QCOMPARE(std::get<Vec3>(f.value("ball.position")).x, 8.0);
  }

  void events_come_only_where_something_changed() {
    Film f(
        "range 1f 48f\ncreate a group\ncreate a/b sphere\ncreate a/b/c sphere\ncreate other sphere\n"
        "a.position\n  1f (0 0 0)\n  24f (1 0 0)\na/b.radius\n  1f 2\na/b.position\n  1f (0 0 0) hold\n  24f (1 0 0)\n"
        "a/b/c.radius\n  1f 1\n  24f 2\nother.radius\n  1f 1\n  24f 2\n");
    f.select("a/b");
    f.workspace.go_to(f.at_time("12f"));
    EventActions& events = EventActions::of(f.workspace);
    events.insert_changed();
    QCOMPARE(f.events_of("a/b.position"), std::size_t(2));  // it holds until 24f
    QCOMPARE(f.events_of("a/b.radius"), std::size_t(1));
    events.insert_character();
    QCOMPARE(f.events_of("a.position"), std::size_t(3));
    QCOMPARE(f.events_of("a/b.position"), std::size_t(3));
    QCOMPARE(f.events_of("a/b.radius"), std::size_t(2));
    QCOMPARE(f.events_of("a/b/c.radius"), std::size_t(3));
    QCOMPARE(f.events_of("other.radius"), std::size_t(2));
  }

  void retimed_events_follow_the_curve() {
    Film f(
        "range 1f 101f\ncreate ball sphere\nball.position.x\n  1f 0\n  26f 1\n  51f 2\n  76f 3\n  101f 4\n"
        "set ball.radius = \"1 + t\"\n");
    const QString before = f.text();
    const Document& d = f.workspace.document();
    std::vector<EventAt> all;
    for (const EventView& e : events(d, f.target("ball.position.x")))
      all.push_back({f.target("ball.position.x"), e.time});
    f.workspace.select_events(all);
    QString said;
    connect(&f.workspace, &Workspace::said, &f.workspace, [&](const QString&, const QString& why) { said = why; });
    EventActions::of(f.workspace).warp([](double u) { return u * u; });
    QVERIFY2(said.contains("ball.radius"), qPrintable(said));
    std::vector<Time> times;
    for (const EventView& e : events(d, f.target("ball.position.x"))) times.push_back(e.time);
    QCOMPARE(times,
             (std::vector{f.at_time("1f"), f.at_time("7f"), f.at_time("26f"), f.at_time("57f"), f.at_time("101f")}));
    f.workspace.undo();
    QCOMPARE(f.text(), before);
    // Many events at the same place stay apart, and in order.
    EventActions::of(f.workspace).warp([](double u) { return u < 1 ? 0 : 1.0; });
    QCOMPARE(events(d, f.target("ball.position.x")).size(), std::size_t(5));
    f.workspace.undo();
  }

  void mixtures_of_values() {
    QCOMPARE(std::get<double>(mixed(2.0, 4.0, 0.25)), 2.5);
    const Value half = mixed(Color{0, 0, 0}, Color{1, 1, 1}, 0.5);
    QVERIFY(std::abs(std::get<Color>(half).r - 0.7353569) < 1e-6);  // 50 % of light as sRGB
    const Quat a = from_angles({0, 0, 0}), b = from_angles({0, 0, pi / 2});
    QVERIFY(std::abs(dot(std::get<Quat>(mixed(a, b, 1.0 / 3)), from_angles({0, 0, pi / 6}))) > 1 - 1e-12);
    QCOMPARE(std::get<bool>(mixed(true, false, 0.4)), true);
    QCOMPARE(std::get<bool>(mixed(true, false, 0.6)), false);
  }
};

}  // namespace betwixt::studio

QTEST_MAIN(betwixt::studio::PosesTest)
#include "poses_test.moc"
