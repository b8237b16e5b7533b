// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What the picture shows: parts of the film, through the eyes of its objects, with guides. None of it changes the film.
#include "studio/viewport/looking.h"

#include <QInputDialog>
#include <QTest>

#include "betwixt/pick.h"
#include "studio/hands.h"
#include "studio/viewport/views.h"

namespace betwixt::studio {
namespace {

struct Shown : Film {
  Viewport view{workspace};
  QString before;
  explicit Shown(const std::string& text) : Film(text), before(this->text()) {
    view.resize(800, 450);
    view.show();
    view.await_picture();
    view.setFocus();
  }
  QString text() const { return QString::fromStdString(workspace.text()); }
  Target target_of(const char* words) const { return find_targets(words, workspace.document())->front(); }
  void select(const char* name) { workspace.select({find(name)}); }
  QImage picture() {
    view.await_picture();
    return view.grab().toImage();
  }
  QPoint spot(Vec3 place) const { return view.scope().spot(place)->toPoint(); }
};

const char* const three = R"(film flat
create ball disc radius=1 color=red
create card rectangle size=(2 2) position=(4 0 0)
create arm disc radius=0.3 position=(0 -3 0)
couple arm to ball keep-world
)";

}  // namespace

class LookingTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:

  void what_is_isolated_is_seen_alone() {
    Shown f(three);
    QVERIFY(f.view.hit(f.spot({4, 0, 0})));
    f.select("ball");
    f.view.isolate();
    QCOMPARE(f.view.frame().items.size(), std::size_t{2});  // with what hangs on it
    QVERIFY(!f.view.hit(f.spot({4, 0, 0})));
    QVERIFY(f.view.hit(f.spot({0, -3, 0})));
    const QColor there = f.picture().pixelColor(f.spot({4.5, 0.5, 0}));
    QCOMPARE(there, f.picture().pixelColor(f.spot({6, 3, 0})));  // nothing but the background
    f.workspace.say(std::string("create new disc position=(4 0 0)"));
    QVERIFY(f.view.hit(f.spot({4, 0, 0})));  // what is new is seen
    f.workspace.undo();
    f.view.isolate();
    QCOMPARE(f.view.frame().items.size(), std::size_t{3});
    QCOMPARE(f.text(), f.before);
    f.workspace.select({});
    f.view.isolate();
    QVERIFY(!f.workspace.left_out());
    QVERIFY(!f.view.refusal().isEmpty());
  }

  void one_looks_through_a_light_and_back() {
    Shown f(R"(create ball sphere
create key light shines=sun position=(0 9 0)
create lamp light position=(5 2 1)
lamp.rotation.y
  1f 0deg linear
  25f 90deg
create eye camera position=(0 0 10)
create other camera position=(0 3 8) fov=30deg
)");
    const Camera film = f.view.frame().camera;
    f.select("key");
    f.view.look_through();
    const Projection sun = f.view.scope().projection;
    QVERIFY(sun.orthographic());
    QVERIFY(length(sun.forward() - Vec3{0, -1, 0}) < 1e-9);  // a sun shines to the middle of the world
    QVERIFY(f.view.hit(f.view.rect().center()) && f.view.hit(f.view.rect().center())->id == f.find("ball"));
    f.select("lamp");
    f.view.look_through();
    QVERIFY(length(f.view.scope().projection.forward() - Vec3{0, 0, -1}) < 1e-9);
    f.workspace.go_to(f.frame(25));  // the view goes with it
    QVERIFY(length(f.view.scope().projection.forward() - Vec3{-1, 0, 0}) < 1e-9);
    QVERIFY(length(f.view.scope().projection.eye() - Vec3{5, 2, 1}) < 1e-9);
    f.view.look_through();
    QVERIFY(!f.view.is_free());
    QCOMPARE(f.view.frame().camera, film);
    f.select("other");
    f.view.look_through();
    const Camera c = eye_of(f.workspace.program(), f.find("other"), f.frame(1), f.view.frame());
    QCOMPARE(c.fov, 30 * pi / 180);
    f.workspace.say(std::string("look through other"));  // the film's own way gives the same camera
    QCOMPARE(f.workspace.program().frame(f.frame(25)).camera, c);
    f.workspace.undo();
    f.view.look_along({0, 0, -1});  // moving on makes it a free view
    QVERIFY(f.view.is_free() && !f.view.looks_through());
    f.select("lamp");
    f.workspace.go_to(f.frame(1));
    f.view.bring_selected();
    const Value w = f.workspace.program().read(Target(f.find("lamp"), Query::world), f.frame(1));
    QVERIFY(length(translation_of(*std::get<Matrix>(w)) - f.view.scope().projection.eye()) < 0.1);
    f.workspace.undo();
    QCOMPARE(f.text(), f.before);
  }

  void guides_are_where_they_should_be() {
    Shown f("film flat\nbackground black\nsize 800x450\n");
    ViewportSwitches s = f.view.switches();
    const auto lit = [&](const QImage& image, double x, double y) {
      for (int i = -1; i <= 1; ++i)
        for (int j = -1; j <= 1; ++j)
          if (qGray(image.pixel(static_cast<int>(x) + i, static_cast<int>(y) + j)) > 100) return true;
      return false;
    };
    QVERIFY(!lit(f.picture(), 40, 225));
    s.safe = true;
    f.view.set_switches(s);
    QVERIFY(lit(f.picture(), 40, 225));  // a twentieth of the width
    QVERIFY(lit(f.picture(), 80, 225));
    QVERIFY(!lit(f.picture(), 267, 225));
    s.thirds = true;
    f.view.set_switches(s);
    QVERIFY(lit(f.picture(), 266.7, 225));
    QVERIFY(lit(f.picture(), 400, 300));
    f.view.set_free(true);
    QVERIFY(!lit(f.picture(), 40, 225));  // a free view has no frame
  }

  void guides_are_dragged_out_of_rulers_and_back() {
    Shown f(three);
    QTest::mouseClick(&f.view, Qt::LeftButton, {}, QPoint(300, 4));
    QVERIFY(f.view.switches().own_guides.empty());  // no rulers yet
    f.view.flip(&ViewportSwitches::guides);
    const auto guides = [&] {
      QStringList all;
      for (const Guide& g : f.view.switches().own_guides) all << in_words(g);
      return all.join(", ");
    };
    const auto number = [&](const char* of) {
      return std::get<double>(f.workspace.program().read(f.target_of(of), f.workspace.time()));
    };
    drag(f.view, {300, 4}, {300, f.spot({0, 2, 0}).y()}, Qt::ControlModifier);
    QCOMPARE(guides(), "y 2");
    drag(f.view, {4, 300}, {f.spot({-5, 0, 0}).x(), 300}, Qt::ControlModifier);
    QCOMPARE(guides(), "y 2, x -5");
    // It is painted where its coordinate is.
    const QColor on = f.picture().pixelColor(f.spot({-5, 3, 0}));
    QVERIFY(on != f.picture().pixelColor(f.spot({-4, 3, 0})));
    // Its line moves it, also during the drag; Escape puts it back.
    drag(f.view, f.spot({-5, 3, 0}), f.spot({-3, 3, 0}), Qt::ControlModifier, true);
    QCOMPARE(guides(), "y 2, x -3");
    QTest::keyClick(&f.view, Qt::Key_Escape);
    QCOMPARE(guides(), "y 2, x -5");
    QTest::mouseRelease(&f.view, Qt::LeftButton, {}, f.spot({-3, 3, 0}));
    drag(f.view, f.spot({-5, 3, 0}), f.spot({-3, 3, 0}), Qt::ControlModifier);
    QCOMPARE(guides(), "y 2, x -3");
    // The middle of an object goes to them, and so do its sides.
    f.select("ball");
    drag(f.view, f.spot({0.5, -0.5, 0}), f.spot({-2.5, 1.5, 0}) + QPoint(3, -4));
    QCOMPARE(number("ball.position.x"), -3.0);
    QCOMPARE(number("ball.position.y"), 2.0);
    f.workspace.undo();
    f.select("ball");
    drag(f.view, f.spot({0.5, -0.5, 0}), f.spot({-1.5, 0, 0}) + QPoint(4, 0));
    QCOMPARE(number("ball.position.x"), -2.0);  // its left side lies on the guide
    f.workspace.undo();
    QCOMPARE(f.text(), f.before);
    // In a view along x there is no upright guide for x, and in perspective there are no rulers.
    f.view.look_along({-1, 0, 0});
    drag(f.view, {4, 300}, {400, 300}, Qt::ControlModifier);
    QVERIFY(guides().startsWith("y 2, x -3, z"));
    f.view.toggle_perspective();
    drag(f.view, {4, 300}, {500, 300});
    QCOMPARE(f.view.switches().own_guides.size(), std::size_t{3});
    f.view.set_free(false);
    // Where they came from, they go away; and outside.
    drag(f.view, {f.spot({-3, 0, 0}).x(), 4}, {4, 200});
    QVERIFY(!guides().contains("x"));
    drag(f.view, {4, f.spot({0, 2, 0}).y()}, {4, -20});
    QVERIFY(!guides().contains("y"));
    QCOMPARE(f.text(), f.before);
  }

  void guides_are_made_without_a_mouse_and_kept_by_film() {
    QCOMPARE(guide_of(" x=2.5 "), std::optional(Guide{0, 2.5}));
    QCOMPARE(guide_of("Z -1"), std::optional(Guide{2, -1}));
    for (const char* bad : {"", "x", "w 2", "x two", "xy 2", "x 1 2", "x nan"}) QVERIFY(!guide_of(bad));
    Shown f(three);
    f.view.guide_selection();
    QVERIFY(!f.view.refusal().isEmpty());
    f.select("card");
    f.view.guide_selection();
    QVERIFY(f.view.switches().guides);
    QCOMPARE(f.view.switches().own_guides, (Guides{{0, 4}, {1, 0}}));
    const auto type = [&](const char* words) {
      QTimer::singleShot(0, &f.view, [words] {
        auto* dialog = qobject_cast<QInputDialog*>(QApplication::activeModalWidget());
        dialog->setTextValue(words);
        QTest::keyClick(dialog, Qt::Key_Return);
      });
      f.view.ask_guide();
    };
    type("y 1.25");
    QCOMPARE(f.view.switches().own_guides.back(), (Guide{1, 1.25}));
    type("y 1.25");
    QCOMPARE(f.view.switches().own_guides.size(), std::size_t{2});
    type("up");
    QVERIFY(f.view.refusal().contains("x 2.5"));
    f.view.guide_selection();
    QVERIFY(f.view.switches().own_guides.empty());
    // In the settings they stand by film.
    const Guides all{{0, 4}, {1, -0.1}};
    keep_guides("/films/a.bx", all), keep_guides("/films/b.bx", {{2, 1}}), keep_guides("", all);
    QCOMPARE(kept_guides("/films/a.bx"), all);
    keep_guides("/films/a.bx", {});
    QVERIFY(kept_guides("/films/a.bx").empty() && kept_guides("").empty());
    QCOMPARE(kept_guides("/films/b.bx"), (Guides{{2, 1}}));
    keep_guides("/films/b.bx", {});
    QCOMPARE(f.text(), f.before);
  }

  void what_is_moved_snaps_to_points_and_surfaces() {
    Shown f(three);
    ViewportSwitches s = f.view.switches();
    s.snaps = true;
    f.view.set_switches(s);
    const auto pull = [&](Vec3 from, Vec3 to, QPoint beside, Qt::KeyboardModifiers keys = {}) {
      f.select("ball");
      drag(f.view, f.spot(from), f.spot(to) + beside, keys);
      return f.workspace.program().read(f.target_of("ball.position"), f.workspace.time());
    };
    QCOMPARE(std::get<Vec3>(pull({0.5, -0.5, 0}, {3, 1, 0}, {4, -3})), (Vec3{3, 1, 0}));  // a corner of the card
    f.workspace.undo();
    QCOMPARE(std::get<Vec3>(pull({0.5, -0.5, 0}, {4, 0, 0}, {-5, 2})), (Vec3{4, 0, 0}));  // its middle
    f.workspace.undo();
    const Vec3 on_it = std::get<Vec3>(pull({0.5, -0.5, 0}, {3.5, 0.5, 0}, {}));  // its surface
    QVERIFY(length(on_it - Vec3{3.5, 0.5, 0}) < 0.03);
    f.workspace.undo();
    // Along an axis it goes as far as the point is.
    f.select("ball");
    drag(f.view, f.spot({1.2, 0, 0}), f.spot({3, 1, 0}) + QPoint(3, 3));
    QCOMPARE(std::get<Vec3>(f.workspace.program().read(f.target_of("ball.position"), f.workspace.time())),
             (Vec3{3, 0, 0}));
    f.workspace.undo();
    // What hangs on it is no target.
    const Vec3 free = std::get<Vec3>(pull({0.5, -0.5, 0}, {0, -3, 0}, {2, 0}));
    QVERIFY(length(free - Vec3{-0.46, -2.5, 0}) < 0.05);
    f.workspace.undo();
    QCOMPARE(f.text(), f.before);
  }

  void control_goes_to_the_lines_of_the_grid_that_is_shown() {
    Shown f("film flat\ncreate ball disc radius=1 position=(0.3 0.2 0)\n");
    f.select("ball");
    const auto place = [&] {
      return std::get<Vec3>(f.workspace.program().read(f.target_of("ball.position"), f.workspace.time()));
    };
    drag(f.view, f.spot({0.8, -0.3, 0}), f.spot({3.4, 0.9, 0}), Qt::ControlModifier);
    QVERIFY(length(place() - Vec3{0.3, 0.2, 0}) > 2 && std::abs(place().x - std::round(place().x)) > 0.2);  // steps
    f.workspace.undo();
    f.view.flip(&ViewportSwitches::grid);
    drag(f.view, f.spot({0.8, -0.3, 0}), f.spot({3.4, 0.9, 0}), Qt::ControlModifier);
    QCOMPARE(place(), (Vec3{3, 1, 0}));  // the lines are a metre apart
    f.workspace.undo();
    drag(f.view, f.spot({1.5, 0.2, 0}), f.spot({3.1, 0.9, 0}), Qt::ControlModifier);  // the arrow along x
    QCOMPARE(place(), (Vec3{2, 0.2, 0}));
    f.workspace.undo();
    QCOMPARE(f.text(), f.before);
  }

  void two_clicks_measure() {
    Shown f(three);
    ViewportSwitches s = f.view.switches();
    s.measures = true;
    f.view.set_switches(s);
    QTest::mouseClick(&f.view, Qt::LeftButton, {}, f.spot({0, 0, 0}) + QPoint(2, 2));
    QTest::mouseClick(&f.view, Qt::LeftButton, {}, f.spot({3, -1, 0}) + QPoint(-3, 1));
    QCOMPARE(f.view.measure_words(), QString("3.16 m (3 -1 0)"));  // the root of 10
    QVERIFY(f.workspace.selected().empty());
    QTest::keyClick(&f.view, Qt::Key_Escape);
    QVERIFY(!f.view.switches().measures);
    QVERIFY(f.view.measure_words().isEmpty());
    QCOMPARE(f.text(), f.before);
  }

  void events_have_ghosts() {
    Shown f(R"(film flat
background black
create ball disc radius=0.5
ball.position.x
  1f -5
  13f 0
  49f 6
)");
    f.workspace.go_to(f.frame(25));
    const auto around = Ghosts::events_around(f.workspace.document(), f.frame(25), {f.find("ball")});
    QVERIFY(around.first == f.frame(13) && around.second == f.frame(49));
    const auto at_event = Ghosts::events_around(f.workspace.document(), f.frame(13), {f.find("ball")});
    QVERIFY(at_event.first == f.frame(1) && at_event.second == f.frame(49));
    f.select("ball");
    ViewportSwitches s = f.view.switches();
    s.trails = s.handles = false;
    f.view.set_switches(s);
    const auto lit = [&](double x) { return qGray(f.picture().pixel(f.spot({x, 0.2, 0}))) > 20; };
    QVERIFY(!lit(0) && !lit(6));
    s.key_ghosts = true;
    f.view.set_switches(s);
    QVERIFY(lit(0) && lit(6) && !lit(-5));
  }

  // The meshes of ghosts stay for the next picture; nobody else holds them.
  void meshes_of_ghosts_are_held() {
    Film f("create ball sphere radius=0.7\nball.position\n  1f (0 0 0)\n  13f (2 0 0)\n  25f (4 0 0)\n");
    const auto held = [&](double frame) {
      const Frame at = f.workspace.program().frame(f.frame(frame));
      const std::weak_ptr<const Mesh> mesh = drawn(at.items.at(0)).mesh;
      return !mesh.expired();
    };
    QVERIFY(!held(7));
    Ghosts ghosts(f.workspace);
    QImage picture(400, 300, QImage::Format_ARGB32_Premultiplied);
    const Camera eye = f.workspace.program().frame(f.frame(7)).camera;
    const Scope scope{Projection(eye, 4.0 / 3), QRectF(0, 0, 400, 300)};
    for (const double frame : {7.0, 8.0}) {
      QPainter p(&picture);
      ghosts.paint(p, scope, eye, f.workspace.program().frame(f.frame(frame)), {.events = true},
                   [&] { return std::vector{f.find("ball")}; });
      p.end();
      QVERIFY(held(frame));
    }
  }

  void four_views_show_one_film() {
    Film f("create ball sphere position=(1 2 3)\ncreate eye camera position=(0 0 20)\n");
    const std::string before = f.workspace.text();
    Views views(f.workspace);
    views.resize(1000, 800);
    views.show();
    QVERIFY(QTest::qWaitForWindowExposed(&views));
    views.set_four(true);
    QApplication::processEvents();
    QCOMPARE(views.all().size(), std::size_t{4});
    auto* top = views.findChild<Viewport*>("top_view");
    auto* right = views.findChild<Viewport*>("right_view");
    QVERIFY(top->width() > 450 && top->height() > 350);
    QVERIFY(length(top->scope().projection.forward() - Vec3{0, -1, 0}) < 1e-9);
    QVERIFY(top->scope().projection.orthographic() && right->scope().projection.orthographic());
    QVERIFY(!views.first().is_free());
    for (Viewport* view : views.all()) {  // the ball is seen and selected in each of them
      f.workspace.select({});
      QTest::mouseClick(view, Qt::LeftButton, {}, view->scope().spot({1, 2, 3})->toPoint());
      QCOMPARE(f.workspace.selected(), std::vector{f.find("ball")});
      QCOMPARE(&views.active(), view);
    }
    // From above, a move to the right and up is one along x and -z; the height stays.
    const auto at = top->scope().spot({1, 2, 3})->toPoint();
    const auto to = top->scope().spot({2, 2, 2})->toPoint();
    ViewportSwitches s = top->switches();
    s.handles = false;
    top->set_switches(s);
    QCOMPARE(right->switches(), s);  // one set of tools
    drag(*top, at, to);
    const Vec3 place = std::get<Vec3>(
        f.workspace.program().read(find_targets("ball.position", f.workspace.document())->front(), f.workspace.time()));
    QVERIFY(length(place - Vec3{2, 2, 2}) < 0.05);
    QCOMPARE(place.y, 2.0);
    f.workspace.undo();
    QVERIFY(!f.workspace.view());  // new cameras do not look from a side
    views.set_four(false);
    QCOMPARE(&views.active(), &views.first());
    QVERIFY(!top->isVisible());
    QCOMPARE(f.workspace.text(), before);
  }
};

}  // namespace betwixt::studio

QTEST_MAIN(betwixt::studio::LookingTest)
#include "looking_test.moc"
