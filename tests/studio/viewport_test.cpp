// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/viewport/viewport.h"

#include <QDropEvent>
#include <QFile>
#include <QMimeData>
#include <QTemporaryDir>
#include <QTest>
#include <QWheelEvent>
#include <set>

#include "betwixt/language.h"
#include "studio/shell/theme.h"
#include "studio/shell/window.h"
#include "studio/viewport/navigation.h"

namespace betwixt::studio {
namespace {

// A drawing is 16 m by 9 m: here a metre is 50 pixels, and (0 0) is in the middle.
constexpr int width = 800, height = 450;
QPoint at(double x, double y) { return {int(std::lround(400 + 50 * x)), int(std::lround(225 - 50 * y))}; }

struct Film {
  QTemporaryDir folder;  // journals lie where one works
  bool there = QDir::setCurrent(folder.path());
  Workspace workspace;
  Viewport view{workspace};
  explicit Film(const std::vector<std::string>& lines) {
    workspace.open("");
    view.resize(width, height);
    view.show();
    const bool said = workspace.say(lines);
    if (!said) qFatal("%s", workspace.last_said().c_str());
    view.await_picture();
    view.setFocus();
  }
  ObjectId find(const char* name) const { return workspace.document().find(name); }
  QStringList selected() const {
    QStringList names;
    for (const ObjectId id : workspace.selected()) names << QString::fromStdString(workspace.name(id));
    return names;
  }
  void select(const char* name) { workspace.select({find(name)}); }
  void drag(QPoint from, QPoint to, Qt::KeyboardModifiers keys = {}) {
    QTest::mousePress(&view, Qt::LeftButton, keys, from);
    for (int i = 1; i <= 4; ++i) move(from + (to - from) * i / 4, keys);
    QTest::mouseRelease(&view, Qt::LeftButton, keys, to);
  }
  void move(QPoint p, Qt::KeyboardModifiers keys = {}) {
    QMouseEvent e(QEvent::MouseMove, p, view.mapToGlobal(p), Qt::NoButton, Qt::LeftButton, keys);
    QApplication::sendEvent(&view, &e);
  }
  void keys(const char* all) { QTest::keyClicks(&view, all); }
  QString value(const char* target, const char* time = "1f") {
    const auto found = find_targets(target, workspace.document());
    const Value v = workspace.program().read((*found)[0], *parse_time(time, workspace.document()));
    QStringList out;
    for (const double n : numbers(v)) out << QString::number(n, 'g', 6);
    return out.join(' ');
  }
  QString text() const { return QString::fromStdString(workspace.text()); }
};

const std::vector<std::string> two = {"film flat", "create ball disc radius=1",
                                      "create card rectangle size=(2 2) position=(4 0 0)"};

}  // namespace

class ViewportTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:

  void a_click_selects() {
    Film f(two);
    QTest::mouseClick(&f.view, Qt::LeftButton, {}, at(0.5, 0));
    QCOMPARE(f.selected(), QStringList{"ball"});
    QTest::mouseClick(&f.view, Qt::LeftButton, Qt::ShiftModifier, at(4.9, 0.9));
    QCOMPARE(f.selected(), (QStringList{"ball", "card"}));
    QTest::mouseClick(&f.view, Qt::LeftButton, Qt::ShiftModifier, at(-0.5, 0.3));
    QCOMPARE(f.selected(), QStringList{"card"});
    QTest::mouseClick(&f.view, Qt::LeftButton, {}, at(-0.5, 0.3));
    QCOMPARE(f.selected(), QStringList{"ball"});
    QTest::mouseClick(&f.view, Qt::LeftButton, {}, at(0, 3));
    QCOMPARE(f.selected(), QStringList{});
  }

  void a_box_selects_what_is_inside() {
    Film f(two);
    f.drag(at(-2, 2), at(2, -2));
    QCOMPARE(f.selected(), QStringList{"ball"});
    f.drag(at(2, 2), at(6, -2), Qt::ShiftModifier);
    QCOMPARE(f.selected(), (QStringList{"ball", "card"}));
    f.drag(at(-2, 2), at(0.5, -2));  // half of it
    QCOMPARE(f.selected(), QStringList{});
  }

  void an_arrow_moves_along_an_axis() {
    Film f(two);
    const QString before = f.text();
    f.select("ball");
    f.drag(at(1.2, 0), at(3.2, 0.7));
    QCOMPARE(f.value("ball.position"), QString("2 0 0"));
    QCOMPARE(f.text(), before + "set ball.position (2 0 0)\n");
    f.workspace.undo();
    QCOMPARE(f.text(), before);
    QCOMPARE(f.value("ball.position"), QString("0 0 0"));
    f.drag(at(0, 1.2), at(1, 0.2));
    QCOMPARE(f.value("ball.position"), QString("0 -1 0"));
  }

  void where_there_are_events_one_more_is_made() {
    Film f({"film flat", "create ball disc", "at 1f ball.position (0 0 0)", "at 25f ball.position (4 0 0) linear"});
    f.select("ball");
    f.workspace.go_to(f.workspace.document().rate().frame(25));
    f.drag(at(4, 1.2), at(4, 2.2));
    QCOMPARE(f.value("ball.position", "25f"), QString("4 1 0"));
    QVERIFY(f.text().contains("  25f (4 1 0) linear\n"));  // its twerper stays
    f.workspace.go_to(f.workspace.document().rate().frame(13));
    f.view.take(Tool::move);
    f.keys("y2\r");
    const auto all = events(f.workspace.document(), {f.find("ball"), 0});
    QCOMPARE(all.size(), std::size_t(3));
    QCOMPARE(std::get<Vec3>(*all[1].value).y, 2 + f.value("ball.position", "13f").split(' ')[1].toDouble() - 2);
  }

  // The places are those of matrix products: R takes (1 0) to (0 1), then T takes it to (3 2).
  void factors_of_a_motion_have_handles() {
    Film f({"film flat", "create wheel disc radius=0.3 position=(1 0 0)",
            "at 1f..25f wheel.motion T(3 1) R(90deg @ 0 0) back-out ease-out=3f"});
    f.select("wheel");
    const auto last = [&] { return f.text().trimmed().split('\n').last(); };
    f.drag(at(3, 2), at(4, 3));  // the tip of the way
    QVERIFY2(last().contains("wheel.motion T(4 2) R(90deg) back-out ease-out=3f"), qPrintable(last()));
    QCOMPARE(f.value("wheel.world.x", "25f"), QString("4"));
    QCOMPARE(f.value("wheel.world.y", "25f"), QString("3"));
    f.workspace.undo();
    QVERIFY(last().contains("T(3 1)"));
    f.drag(at(0, 1), at(-1, 0));  // the arm of the rotation
    QVERIFY2(last().contains("T(3 1) R(180deg)"), qPrintable(last()));
    QCOMPARE(f.value("wheel.world.x", "25f"), QString("2"));
    f.drag(at(0, 0), at(0, 1));  // its centre: (1 0) goes to (-1 2), and then by (3 1)
    QVERIFY2(last().contains("T(3 1) R(180deg @ 0 1)"), qPrintable(last()));
    QCOMPARE(f.value("wheel.world.x", "25f"), QString("2"));
    QCOMPARE(f.value("wheel.world.y", "25f"), QString("3"));
  }

  void turning_round_counts_on() {
    Film f({"film flat", "create wheel disc radius=0.3 position=(1 0 0)", "at 1f..25f wheel.motion R(90deg)"});
    f.select("wheel");
    QTest::mousePress(&f.view, Qt::LeftButton, {}, at(0, 1));
    for (int k = 1; k <= 36; ++k) {
      const double a = (90 + 10 * k) * pi / 180;
      f.move(at(1.5 * std::cos(a), 1.5 * std::sin(a)));
    }
    QTest::mouseRelease(&f.view, Qt::LeftButton, {}, at(0, 1.5));
    QVERIFY2(f.text().contains("R(450deg)"), qPrintable(f.text()));
    QCOMPARE(f.value("wheel.world.y", "25f"), QString("1"));
  }

  void growths_and_what_cannot_be_dragged() {
    Film f({"film flat", "create sun disc position=(-3 -3 0)", "create wheel disc radius=0.3 position=(1 0 0)",
            "at 1f..25f wheel.motion S(2) R(90deg @ sun)"});
    f.select("wheel");
    // R about the sun takes (1 0) to (-3 -3) + (-3 4); S doubles it.
    QCOMPARE(f.value("wheel.world.x", "25f"), QString("-12"));
    const QString before = f.text();
    f.drag(at(-3, -3), at(-2, -3));  // a centre that is an object stays, and the object is not selected by a drag
    QVERIFY(f.text().contains("R(90deg @ sun)"));
    Film g({"film flat", "create wheel disc radius=0.3 position=(1 0 0)", "at 1f..25f wheel.motion S(2)"});
    g.select("wheel");
    g.drag(at(2, 0), at(3, 1));
    QVERIFY2(g.text().contains("wheel.motion S(3 3)") || g.text().contains("wheel.motion S(3)"), qPrintable(g.text()));
    QTest::mousePress(&g.view, Qt::LeftButton, {}, at(3, 0));
    g.move(at(4, 0));
    QTest::keyClick(&g.view, Qt::Key_Escape);
    QTest::mouseRelease(&g.view, Qt::LeftButton, {}, at(4, 0));
    QCOMPARE(g.value("wheel.world.x", "25f"), QString("3"));
  }

  void a_motion_is_found_with_what_follows_it() {
    Film f({"create a box", "at 1f..25f a.motion T(1 0 0) R(1turn axis y) sine-in", "at 30f..40f a.motion T(0 1 0)",
            "create b box", "at 1f b.position (1 2 3)"});
    const Document& d = f.workspace.document();
    const auto at_frame = [&](double k) { return motion_row(d, f.find("a"), d.rate().frame(k)); };
    QVERIFY(at_frame(12) && at_frame(12)->motion.factors.size() == 2);
    QCOMPARE(QString::fromStdString(at_frame(12)->line(Motion{{translate_by({2, 0, 0})}})),
             QString("at 1f..25f a.motion T(2 0) sine-in"));
    QVERIFY(!at_frame(27) && !at_frame(50));
    QVERIFY(at_frame(30));
    QVERIFY(!motion_row(d, f.find("b"), d.rate().frame(1)));
  }

  void of_components_those_with_tracks_get_rows() {
    Film f({"film flat", "create ball disc", "at 1f ball.position.x 0", "at 25f ball.position.x 0"});
    f.select("ball");
    f.drag(at(0, 0), at(2, 1));
    QVERIFY(f.text().contains("ball.position.x\n  1f 2\n"));
    QVERIFY(f.text().contains("set ball.position.y 1\n"));
    QCOMPARE(f.value("ball.position", "1f"), QString("2 1 0"));
    QCOMPARE(f.value("ball.position", "25f"), QString("0 1 0"));
  }

  void auto_key_makes_an_event_of_all() {
    Film f(two);
    ViewportSwitches s = f.view.switches();
    s.auto_key = true;
    f.view.set_switches(s);
    f.select("ball");
    f.workspace.go_to(f.workspace.document().rate().frame(12));
    f.drag(at(1.2, 0), at(2.2, 0));
    QVERIFY(f.text().endsWith("at 12f ball.position (1 0 0) auto\n"));
  }

  void keys_take_and_numbers_say_how_much() {
    Film f(two);
    f.select("ball");
    f.keys("gx1.5\r");
    QCOMPARE(f.value("ball.position"), QString("1.5 0 0"));
    f.keys("gy-2\r");
    QCOMPARE(f.value("ball.position"), QString("1.5 -2 0"));
    f.keys("r90\r");
    QVERIFY(f.text().contains("set ball.rotation euler(0 0 90deg)"));
    f.keys("r360\r");
    QVERIFY(f.text().contains("set ball.rotation euler(0 0 450deg)"));
    f.keys("s2\r");
    QCOMPARE(f.value("ball.scale"), QString("2 2 2"));
    f.keys("sx0.5\r");
    QCOMPARE(f.value("ball.scale"), QString("1 2 2"));
  }

  void escape_calls_off() {
    Film f(two);
    const QString before = f.text();
    f.select("ball");
    f.keys("g");
    f.move(at(1, 1)), f.move(at(2, 1));
    QVERIFY(f.workspace.looks_ahead());
    QTest::keyClick(&f.view, Qt::Key_Escape);
    QVERIFY(!f.workspace.looks_ahead());
    QCOMPARE(f.text(), before);
    QCOMPARE(f.value("ball.position"), QString("0 0 0"));
  }

  void while_it_is_pulled_the_film_is_shown_ahead() {
    Film f(two);
    f.select("ball");
    QTest::mousePress(&f.view, Qt::LeftButton, {}, at(0, 0));
    f.move(at(1, 0)), f.move(at(1, 1));
    QCOMPARE(f.value("ball.position"), QString("1 1 0"));
    QVERIFY(!f.text().contains("position (1 1 0)"));
    QTest::mouseRelease(&f.view, Qt::LeftButton, {}, at(1, 1));
    QVERIFY(f.text().endsWith("set ball.position (1 1 0)\n"));
  }

  void shift_is_finer_and_control_snaps() {
    Film f(two);
    f.select("ball");
    f.drag(at(1.2, 0), at(2.2, 0), Qt::ShiftModifier);
    QCOMPARE(f.value("ball.position"), QString("0.1 0 0"));
    f.workspace.undo();
    f.drag(at(1.2, 0), at(2.34, 0), Qt::ControlModifier);  // a grid of 1 m: 20 pixels are 0.4 m, and more
    QCOMPARE(f.value("ball.position"), QString("1 0 0"));
  }

  void several_go_together_in_one_step() {
    Film f(two);
    const QString before = f.text();
    f.workspace.select({f.find("ball"), f.find("card")});
    f.drag(at(4, 1.2), at(4, 2.2));  // the handles are at the one that leads
    QCOMPARE(f.value("ball.position"), QString("0 1 0"));
    QCOMPARE(f.value("card.position"), QString("4 1 0"));
    f.keys("r90\r");  // about it
    QCOMPARE(f.value("ball.position"), QString("4 -3 0"));
    QCOMPARE(f.value("card.position"), QString("4 1 0"));
    f.workspace.undo(), f.workspace.undo();
    QCOMPARE(f.text(), before);
  }

  void what_hangs_on_another_moves_in_its_space() {
    Film f({"film flat", "create arm rectangle size=(4 1) rotation=euler(0 0 90deg) scale=(2 2 2)",
            "create hand disc radius=0.4 position=(1 0 0)", "couple hand to arm"});
    f.select("hand");  // at (0 2)
    f.drag(at(1.2, 2), at(2.2, 2));
    QCOMPARE(f.value("hand.position"), QString("1 -0.5 0"));  // to the right is its -y, and twice as large
    f.workspace.select({f.find("hand"), f.find("arm")});      // it goes along by itself
    f.keys("gx1\r");
    QCOMPARE(f.value("hand.position"), QString("1 -0.5 0"));
    QCOMPARE(f.value("arm.position"), QString("1 0 0"));
  }

  void what_code_says_is_left_alone() {
    Film f({"film flat", "create ball disc", "set ball.position = \"vec(1, 0, 0)\""});
    const QString before = f.text();
    f.select("ball");
    f.keys("gx1\r");
    QCOMPARE(f.text(), before);
  }

  void the_wheel_keeps_what_is_under_it() {
    Film f(two);
    const Vec3 there = f.view.hit(at(4.5, 0.5))->place;
    QWheelEvent e(at(4.5, 0.5), f.view.mapToGlobal(at(4.5, 0.5)), {}, {0, 240}, Qt::NoButton, {}, Qt::NoScrollPhase,
                  false);
    QApplication::sendEvent(&f.view, &e);
    QVERIFY(f.view.is_free());
    const Scope s = f.view.scope();
    QVERIFY(s.projection.orthographic());
    QVERIFY(QLineF(*s.spot(there), at(4.5, 0.5)).length() < 1e-6);
    QCOMPARE(s.projection.height(1), 9 * 0.85 * 0.85);
    f.keys("0");
    QVERIFY(!f.view.is_free());
    QCOMPARE(f.view.scope().projection.height(1), 9.0);
  }

  void a_key_frames_what_is_selected() {
    Film f(two);
    f.select("card");
    f.keys("f");
    const Scope s = f.view.scope();
    QVERIFY(QLineF(*s.spot({4, 0, 0}), QPointF(width / 2.0, height / 2.0)).length() < 1e-6);
    QVERIFY(s.projection.height(1) < 4);
  }

  void an_event_is_pulled_by_its_place_on_the_way() {
    Film f({"film flat", "create ball disc", "at 1f ball.position (0 0 0)", "at 25f ball.position (4 0 0) linear"});
    f.select("ball");
    f.view.grab();
    f.drag(at(4, 0), at(4, 1));
    QCOMPARE(f.value("ball.position", "25f"), QString("4 1 0"));
    QCOMPARE(f.value("ball.position", "1f"), QString("0 0 0"));
    QVERIFY(f.text().contains("  25f (4 1 0) linear\n"));
  }

  void what_looks_at_something_says_so() {
    Film f({"film flat", "create ball disc", "create sign box position=(4 0 0) look-at=ball"});
    f.select("sign");
    f.view.take(Tool::turn);
    QVERIFY(f.view.refusal().contains("looks at an object"));
    f.keys("g");
    QVERIFY(f.view.refusal().isEmpty());
    QTest::keyClick(&f.view, Qt::Key_Escape);
  }

  void keys_mean_what_they_mean_in_the_picture() {
    QTemporaryDir folder;
    QDir::setCurrent(folder.path());
    Workspace workspace;
    workspace.open("");
    workspace.say(two);
    Window window(workspace);
    window.show();
    QApplication::setActiveWindow(&window);
    window.viewport().setFocus();
    workspace.select({workspace.document().find("ball")});
    workspace.set_range(std::pair(Time{}, Time{}));
    QTest::keyClicks(&window.viewport(), "gx2\r");  // x is a menu's key too
    QCOMPARE(std::get<Vec3>(workspace.program().read({workspace.document().find("ball"), 0}, {})).x, 2.0);
    QTest::keyClicks(&window.viewport(), "e");
    QCOMPARE(window.viewport().switches().tool, Tool::turn);
    QVERIFY(workspace.playhead().last() == Time{});
    QTest::keyClicks(&window.viewport(), "x");
    QVERIFY(workspace.playhead().last() > Time{});
  }

  void the_camera_comes_to_the_free_eye() {
    Film f({"create ball sphere", "create eye camera position=(6 0 8) look-at=ball"});
    const QString before = f.text();
    f.keys("3");  // from +x, as far away
    f.view.bring_camera();
    QVERIFY(!f.view.is_free());
    QCOMPARE(f.value("eye.position"), QString("9.6 0 0.8"));  // about the ball's nearest place, (0.6 0 0.8)
    QCOMPARE(f.text(),
             "create ball sphere\ncreate eye camera position=(9.6 0 0.8) look-at=none\n"
             "set eye.rotation euler(0 90deg 0)\n");
    f.workspace.undo();
    QCOMPARE(f.text(), before);
  }

  void files_that_are_dropped_become_things() {
    Film f({"film flat"});
    QFile mesh("Old cow.obj");
    QVERIFY(mesh.open(QIODevice::WriteOnly));
    mesh.write("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    mesh.close();
    QImage(200, 100, QImage::Format_RGB32).save("sky.png");
    const auto drop = [&](const char* file, QPoint p) {
      QMimeData data;
      data.setUrls({QUrl::fromLocalFile(f.folder.filePath(file))});
      QDragEnterEvent in(p, Qt::CopyAction, &data, Qt::LeftButton, {});
      QApplication::sendEvent(&f.view, &in);
      QVERIFY(in.isAccepted());
      QDropEvent e(p, Qt::CopyAction, &data, Qt::LeftButton, {});
      QApplication::sendEvent(&f.view, &e);
    };
    drop("Old cow.obj", at(2, 1));
    QVERIFY(f.text().endsWith("create old-cow mesh file=\"Old cow.obj\" position=(2 1 0)\n"));
    QCOMPARE(f.selected(), QStringList{"old-cow"});
    drop("sky.png", at(-3, 0));  // a third of 9 m high, twice as wide
    QVERIFY(f.text().endsWith("create sky plane size=(6 3) texture=\"sky.png\" position=(-3 0 0)\n"));
    drop("sky.png", at(-3, 3));
    QCOMPARE(f.selected(), QStringList{"sky2"});
  }

  void scenes_that_are_dropped_keep_their_parts() {
    Film f({"film flat", "range 1f 48f"});
    QFile drawing("logo.svg");
    QVERIFY(drawing.open(QIODevice::WriteOnly));
    drawing.write(
        "<svg xmlns='http://www.w3.org/2000/svg' width='100' height='100'>"
        "<circle id='dot' cx='50' cy='50' r='40' fill='red'/></svg>");
    drawing.close();
    QCOMPARE(QString::fromStdString(f.view.line_for_file(f.folder.filePath("logo.svg"), at(2, 1))),
             QString("create logo scene file=\"logo.svg\" position=(2 1 0)"));
    QVERIFY(f.workspace.say(f.view.line_for_file(f.folder.filePath("logo.svg"), at(2, 1))));
    QVERIFY(f.workspace.document().find("logo/dot"));
    f.workspace.go_to(f.workspace.document().rate().frame(12));
    QVERIFY(f.view.line_for_file("walk.bvh", at(0, 0)).find(" start=12f") != std::string::npos);
  }

  // Pixels of the widget: a film without a background shows a pattern, and auto-key a red frame.
  void what_must_not_be_overlooked_is_seen() {
    Film f({"film flat", "background transparent"});
    f.view.await_picture();
    std::set<QRgb> seen;
    const QImage clear = f.view.grab().toImage();
    for (int x = 0; x < 40; ++x) seen.insert(clear.pixel(clear.width() / 2 + x, clear.height() / 2));
    QCOMPARE(seen.size(), std::size_t{2});
    const QRgb before = clear.pixel(1, clear.height() / 2);
    f.view.flip(&ViewportSwitches::auto_key);
    const QColor frame = f.view.grab().toImage().pixel(1, clear.height() / 2);
    QVERIFY(frame.rgb() != before && frame.red() > 150 && frame.red() > 2 * frame.green());
  }

  // What is read from a dropped file is read beside the window, which shows a sign meanwhile.
  void a_file_that_is_dropped_shows_a_sign() {
    Film f({"create eye camera position=(0 0 10)"});
    QFile mesh("heavy.obj");
    QVERIFY(mesh.open(QIODevice::WriteOnly) && mesh.write("v 0 1 0\nv 1 1 0\nv 0 3 0\nf 1 2 3\n") > 0);
    mesh.close();
    f.workspace.jobs().set_patience(0);
    QSignalSpy signs(&f.workspace.jobs(), &BackgroundJobs::takes_long);
    const std::string line = f.view.line_for_file("heavy.obj", at(0, 0));
    QVERIFY(signs.count() > 0);
    QVERIFY2(line.starts_with("create heavy mesh file=\"heavy.obj\" position=("), line.c_str());
  }

  void a_thing_that_is_dropped_on_lies_below() {
    Film f({"create floor plane size=(20 20) rotation=euler(-90deg 0 0) position=(0 1 0)",
            "create eye camera position=(0 11 10) look-at=(0 1 0)"});
    const std::string line = f.view.line_for_file("cow.ply", at(0, 0));
    QCOMPARE(QString::fromStdString(line), QString("create cow mesh file=\"cow.ply\" position=(0 1 0)"));
  }

  void a_mesh_that_is_dropped_stands_on_what_is_below() {
    Film f({"create floor plane size=(20 20) rotation=euler(-90deg 0 0) position=(0 1 0)",
            "create eye camera position=(0 11 10) look-at=(0 1 0)"});
    const auto write = [](const char* name, const char* text) {
      QFile mesh(name);
      if (mesh.open(QIODevice::WriteOnly)) mesh.write(text);
    };
    write("cow.obj", "v -1 -0.5 0\nv 1 -0.5 0\nv 0 0.5 0\nf 1 2 3\n");
    const std::string before = f.text().toStdString();
    QVERIFY(f.view.import_file("cow.obj", at(0, 0)));
    QVERIFY2(f.text().endsWith("create cow mesh file=\"cow.obj\" position=(0 1.5 0)\n"), qPrintable(f.text()));
    f.workspace.undo();
    QCOMPARE(f.text().toStdString(), before);
    QImage(100, 100, QImage::Format_RGB32).save("sky.png");
    QVERIFY(f.view.line_for_file("sky.png", at(0, 0)).find(" position=(0 2.") != std::string::npos);  // stands too
  }

  void in_the_air_it_is_centred_at_the_pointer() {
    Film f({"create eye camera position=(0 1 10) look-at=(0 5 0)"});
    QFile mesh("cow.obj");
    QVERIFY(mesh.open(QIODevice::WriteOnly));
    mesh.write("v -1 0 0\nv 1 0 0\nv 0 2 0\nf 1 2 3\n");
    mesh.close();
    QImage(100, 100, QImage::Format_RGB32).save("sky.png");
    for (const char* file : {"cow.obj", "sky.png"}) {
      QVERIFY(f.view.import_file(file, at(0, 0)));
      const Document& d = f.workspace.document();
      const Target place = find_targets(d.name(f.workspace.selected()[0]) + ".position", d)->front();
      Vec3 middle = std::get<Vec3>(f.workspace.program().read(place, f.workspace.time()));
      if (file == std::string("cow.obj")) middle.y += 1;
      QVERIFY2(QLineF(*f.view.scope().spot(middle), at(0, 0)).length() < 3, file);
      f.workspace.undo();
    }
  }

  void far_too_large_things_come_with_a_hint() {
    Film f({"create floor plane size=(20 20) rotation=euler(-90deg 0 0)",
            "create eye camera position=(0 4 10) look-at=(0 0 0)"});
    const auto write = [](const char* name, const char* size) {
      QFile mesh(name);
      if (mesh.open(QIODevice::WriteOnly))
        mesh.write(QByteArray("v 0 0 0\nv S 0 0\nv 0 S 0\nf 1 2 3\n").replace("S", size));
    };
    write("good.obj", "2"), write("huge.obj", "1740"), write("tiny.obj", "0.002");
    QStringList hints;
    connect(&f.workspace, &Workspace::said, this, [&](const QString& line, const QString&, bool) {
      if (line.startsWith('#')) hints << line;
    });
    QVERIFY(f.view.import_file("good.obj", at(0, 0)));
    QCOMPARE(hints, QStringList());
    QVERIFY(f.view.import_file("huge.obj", at(0, 0)));
    QCOMPARE(hints.size(), 1);
    QVERIFY2(hints[0].contains("1.74e+03 units") || hints[0].contains("1740 units"), qPrintable(hints[0]));
    const QString line = hints[0].section('`', 1, 1);
    QVERIFY2(f.workspace.say(line.toStdString()), qPrintable(line));
    QVERIFY(f.view.import_file("tiny.obj", at(0, 0)));
    QCOMPARE(hints.size(), 2);
    QVERIFY2(hints[1].contains("set tiny.scale (1000 1000 1000)"), qPrintable(hints[1]));
  }

  void one_turns_around_what_is_selected() {
    Film f({"create ball sphere", "create eye camera position=(0 2 10) look-at=(0 2 0)"});
    f.select("ball");
    const QPointF before = *f.view.scope().spot({0, 0, 0});
    QTest::mousePress(&f.view, Qt::MiddleButton, {}, at(0, 0));
    f.move(at(2, 1));
    QTest::mouseRelease(&f.view, Qt::MiddleButton, {}, at(2, 1));
    QVERIFY(f.view.is_free());
    const Scope s = f.view.scope();
    QVERIFY(QLineF(*s.spot({0, 0, 0}), before).length() < 1e-6);
    QVERIFY(std::abs(length(s.projection.eye()) - std::hypot(2, 10)) < 1e-9);
    QVERIFY(std::abs(s.projection.right().y) < 1e-9);  // upright
    f.keys("7");
    QVERIFY(length(f.view.scope().projection.forward() - Vec3{0, -1, 0}) < 1e-9);
  }
};

}  // namespace betwixt::studio

QTEST_MAIN(betwixt::studio::ViewportTest)
#include "viewport_test.moc"
