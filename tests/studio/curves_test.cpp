// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/curves/curves.h"

#include <QMenu>

#include "betwixt/language.h"
#include "hands.h"
#include "studio/curves/curve_pane.h"

using namespace betwixt;
using namespace betwixt::studio;

namespace {

const std::string head = "rate 24\nrange 1f 49f\ncreate ball sphere\n";
const std::string film = head + R"(ball.position.x
  1f 0 linear
  25f 24 linear
  49f 0
)";
using What = Handle::What;

// The panel with the ball's curves.
struct Shown {
  Film at;
  Curves panel{at.workspace};
  CurvePane& pane;
  TimeAxis& axis{TimeAxis::of(at.workspace)};
  explicit Shown(const std::string& text = film) : at(text), pane(*panel.findChild<CurvePane*>("curve_pane")) {
    show(panel, 1000, 500);
    at.workspace.select({at.find("ball")});
    pane.finish(), pane.fit();
  }
  QPoint place(double frame, double value) const { return pane.place(0, at.frame(frame), value).toPoint(); }
  int left() const { return axis.gutter(); }
  double value(double frame) const {
    return *pane.samples().final(0, static_cast<std::size_t>(place(frame, 0).x() - left()));
  }
  // Of a handle of the first line.
  Handle handle(double frame, What what) const {
    for (const Handle& h : studio::handles(at.workspace.document(), pane.lines().front(), at.frame(frame)))
      if (h.what == what) return h;
    qFatal("there is no such handle");
  }
  Lines put(double frame, What what, double to, double value, bool both = false) const {
    return handle_lines(at.workspace.document(), pane.lines().front(), handle(frame, what), at.frame(to), value, both);
  }
};

}  // namespace

class CurvesTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void each_curve_has_its_own_colour() {
    Shown s(
        "rate 24\ncreate ball sphere\nball.position\n  1f (0 0 0)\n  9f (1 2 3)\nball.rotation\n  1f (0 0 0)\n"
        "  9f (0 90deg 0)\nball.scale\n  1f (1 1 1)\n  9f (1 2 1)\nball.radius\n  1f 1\n  9f 2\n");
    QCOMPARE(s.pane.lines().size(), std::size_t(10));
    std::vector<QColor> seen;
    for (const CurveLine& line : s.pane.lines()) {
      const QColor c = s.pane.color(line);
      for (const QColor& other : seen)
        QVERIFY2(
            std::abs(c.red() - other.red()) + std::abs(c.green() - other.green()) + std::abs(c.blue() - other.blue()) >
                30,
            line.name.c_str());
      seen.push_back(c);
    }
  }
  void a_curve_is_what_the_program_says() {
    Shown s;
    QCOMPARE(s.pane.lines().size(), std::size_t(1));
    QCOMPARE(s.pane.lines()[0].name, "position.x");
    const double pixel = 48.0 / (s.place(49, 0).x() - s.place(1, 0).x());
    for (const double frame : {5., 13., 25., 30.})
      QVERIFY(std::abs(s.value(frame) - (frame <= 25 ? frame - 1 : 49 - frame)) <= pixel);
    s.at.workspace.say("set ball.position.y = \"2 * t\"");
    s.pane.finish();
    QCOMPARE(s.pane.lines().size(), std::size_t(2));
  }
  void every_number_of_a_value_has_a_line() {
    Shown s(head +
            "ball.rotation\n 1f (0 0 90deg)\nball.color\n 1f red\nball.display\n 1f on\n 9f off\n"
            "at 1f ball.position.velocity (1 0 0)\n");
    std::string names;
    for (const CurveLine& l : s.pane.lines()) names += l.name + " ";
    QCOMPARE(names,
             "position.velocity.x position.velocity.y position.velocity.z position.x position.y position.z "
             "rotation.x rotation.y rotation.z color display ");
    const auto angle = std::ranges::find(s.pane.lines(), "rotation.z", &CurveLine::name) - s.pane.lines().begin();
    QCOMPARE(s.pane.samples().final(static_cast<std::size_t>(angle), 300), std::optional(90.0));
  }
  void what_a_velocity_alone_makes_is_seen() {
    Shown s(film + "at 1f ball.position.y.velocity 2\n");
    std::string names;
    for (const CurveLine& l : s.pane.lines()) names += l.name + " ";
    QCOMPARE(QString::fromStdString(names), "position.x position.y.velocity position.y ");
    const auto column = static_cast<std::size_t>(s.place(25, 0).x() - s.left());
    QVERIFY(std::abs(*s.pane.samples().final(2, column) - 2) < 0.02);  // two metres in a second
  }
  void what_filters_make_lies_over_what_was_said() {
    Shown s(film + "filter ball.position.x limit high=10\n");
    QVERIFY(s.pane.samples().has_bare(0));
    const auto column = static_cast<std::size_t>(s.place(25, 0).x() - s.left());
    QCOMPARE(s.pane.samples().final(0, column), std::optional(10.0));
    QVERIFY(*s.pane.samples().bare(0, column) > 23);
    Shown plain;
    QVERIFY(!plain.pane.samples().has_bare(0));
  }
  void a_point_is_dragged_in_time_and_value() {
    Shown s;
    drag(s.pane, s.place(25, 24), s.place(31, 18));
    QVERIFY(s.at.said.size() == 1 && s.at.said[0].starts_with("move ball.position.x 25f..25f by 6f\nat 31f "));
    const Target x = s.pane.lines()[0].target;
    QCOMPARE(event_before(s.at.workspace.document(), x, s.at.frame(49)), s.at.frame(31));
    const double value = numbers(s.at.workspace.program().read(x, s.at.frame(31)))[0];
    QVERIFY(std::abs(value - 18) < 0.2);
    QCOMPARE(value, std::round(value * 100) / 100);  // no more digits than pixels tell
    QCOMPARE(s.at.workspace.events_selected().size(), std::size_t(1));
    QCOMPARE(s.at.workspace.events_selected()[0].time, s.at.frame(31));
    s.at.workspace.undo();
    QCOMPARE(s.at.workspace.text(), film);
  }
  void shift_keeps_to_one_axis() {
    Shown s;
    drag(s.pane, s.place(25, 24), s.place(31, 23), Qt::ShiftModifier);
    QCOMPARE(s.at.said, std::vector<std::string>{"move ball.position.x 25f..25f by 6f"});
    s.at.workspace.undo();
    drag(s.pane, s.place(25, 24), s.place(26, 12), Qt::ShiftModifier);
    QVERIFY(s.at.said.back().starts_with("at 25f ball.position.x 1"));
    QVERIFY(s.at.said.back().ends_with(" linear"));
  }
  void what_is_dragged_can_be_called_off() {
    Shown s;
    drag(s.pane, s.place(25, 24), s.place(31, 18), Qt::NoModifier, true);
    QVERIFY(s.at.workspace.looks_ahead());
    QTest::keyClick(&s.pane, Qt::Key_Escape);
    QTest::mouseRelease(&s.pane, Qt::LeftButton, Qt::NoModifier, s.place(31, 18));
    QVERIFY(s.at.is(film));
    QCOMPARE(s.at.workspace.text(), film);
  }
  void handles_say_what_they_are() {
    Shown s(head + "ball.position.x\n 1f 0 fcurve\n 25f 10 hermite\n 49f 0\n");
    QCOMPARE(s.handle(1, What::handle_out).time, s.at.frame(9));  // a third of the way off, at its own value
    QCOMPARE(s.handle(1, What::handle_out).value, 0.0);
    QCOMPARE(s.put(1, What::handle_out, 13, 4), Lines{"at 1f ball.position.x 0 fcurve handle-out=(12f 4)"});
    QCOMPARE(s.put(25, What::handle_in, 19, 8), Lines{"at 25f ball.position.x 10 hermite handle-in=(6f -2)"});
    // 8 in 8 frames is 24 a second.
    QCOMPARE(s.put(25, What::tangent_out, 33, 18), Lines{"at 25f ball.position.x 10 hermite tangent-out=24"});
    QCOMPARE(s.put(49, What::tangent_in, 41, 8), Lines{"at 49f ball.position.x 0 tangent-in=-24"});
    QCOMPARE(s.put(49, What::ease_in, 45, 0), Lines{"at 49f ball.position.x 0 ease-in=4f"});
    Shown b(head + "ball.position.x\n 1f 0 bezier(0.25 0.1 0.25 1)\n 25f 10\n");
    QCOMPARE(b.handle(1, What::bezier_start).time, b.at.frame(7));
    QCOMPARE(b.handle(1, What::bezier_start).value, 1.0);
    QCOMPARE(b.put(1, What::bezier_start, 13, 5), Lines{"at 1f ball.position.x 0 bezier(0.5 0.5 0.25 1)"});
    QCOMPARE(b.put(1, What::bezier_end, 13, 20), Lines{"at 1f ball.position.x 0 bezier(0.25 0.1 0.5 2)"});
    for (const Lines& lines : {b.put(1, What::bezier_end, 13, 20), b.put(1, What::ease_out, 5, 0)})
      QVERIFY(b.at.workspace.say(lines));
  }
  void an_ease_is_drawn() {
    Shown s;
    QTest::mouseClick(&s.pane, Qt::LeftButton, Qt::NoModifier, s.place(1, 0));
    QCOMPARE(s.at.workspace.events_selected().size(), std::size_t(1));
    QPoint bar;
    for (const auto& [line, h] : s.pane.handles())
      if (h.what == What::ease_out) bar = s.pane.place(line, h).toPoint();
    drag(s.pane, bar, QPoint(bar.x() + s.place(9, 0).x() - s.place(1, 0).x(), bar.y()));
    QCOMPARE(s.at.said, std::vector<std::string>{"at 1f ball.position.x 0 linear ease-out=8f"});
    s.at.workspace.undo();
    QCOMPARE(s.at.workspace.text(), film);
  }
  void metres_and_degrees_fill_the_height() {
    Shown s(film + "ball.rotation.z\n  1f 0 linear\n  25f 360deg\n");
    QTest::keyClick(&s.pane, Qt::Key_N);
    // The ends of both lie at the same height, and a hand moves each in its own measure.
    QCOMPARE(s.pane.place(0, s.at.frame(25), 24), s.pane.place(1, s.at.frame(25), 360));
    QCOMPARE(s.pane.place(0, s.at.frame(1), 0), s.pane.place(1, s.at.frame(1), 0));
    const QPoint at = s.pane.place(1, s.at.frame(25), 360).toPoint();
    s.at.workspace.select_events({{s.pane.lines()[1].target, s.at.frame(25)}});
    QTest::mouseClick(&s.pane, Qt::LeftButton, Qt::NoModifier, {10, 40});  // the first line is put away
    drag(s.pane, at, s.pane.place(1, s.at.frame(25), 180).toPoint(), Qt::ShiftModifier);
    QVERIFY(s.at.said.size() == 1 && s.at.said[0].starts_with("at 25f ball.rotation.z 1"));
    const double angle = numbers(s.at.workspace.program().read(s.pane.lines()[1].target, s.at.frame(25)))[0];
    QVERIFY(std::abs(angle - pi) < 0.03);
  }
  void the_twerper_is_chosen_beside_the_curve() {
    Shown s;
    QTest::mouseClick(&s.pane, Qt::LeftButton, Qt::NoModifier, s.place(25, 24));
    s.pane.grab();
    QCOMPARE(s.pane.twerper_boxes().size(), std::size_t(1));
    QTest::mouseClick(&s.pane, Qt::LeftButton, Qt::NoModifier, s.pane.twerper_boxes()[0].center().toPoint());
    auto* menu = s.pane.findChild<QMenu*>("twerpers");
    QVERIFY(menu);
    for (QAction* a : menu->actions())
      if (a->text() == "smooth") a->trigger();
    menu->close();
    QCOMPARE(s.at.said, std::vector<std::string>{"at 25f ball.position.x 24 smooth"});
  }
  void a_double_click_writes_an_event_on_the_curve() {
    Shown s;
    QTest::mouseDClick(&s.pane, Qt::LeftButton, Qt::NoModifier, s.place(13, 12));
    QCOMPARE(s.at.said, std::vector<std::string>{"at 13f ball.position.x 12 linear"});
  }
  void a_swing_is_marked_and_auto_ends_it() {
    Shown s(head + "ball.scale.y\n  13f 0.5\n  16f 1\n  34f 1\n  37f 0.5\n");
    QCOMPARE(s.pane.swings().size(), std::size_t(1));
    const auto& [line, swing] = s.pane.swings()[0];
    QCOMPARE(s.pane.lines()[line].name, "scale.y");
    QCOMPARE(swing.at, s.at.frame(25));
    QVERIFY(std::abs(swing.value - (1 + 0.5 * 6 * 18 / 21 / 4)) < 1e-9);
    QVERIFY(s.at.workspace.say(std::string("at 16f ball.scale.y 1 auto")));
    s.pane.finish();
    QVERIFY(s.pane.swings().empty());
  }
  void values_are_zoomed_and_fitted() {
    Shown s;
    const int before = s.place(1, 0).y() - s.place(1, 24).y();
    const QPoint at = s.place(1, 12);
    QWheelEvent wheel(at, s.pane.mapToGlobal(at), {}, {0, 240}, Qt::NoButton, Qt::ControlModifier, Qt::NoScrollPhase,
                      false);
    QApplication::sendEvent(&s.pane, &wheel);
    QVERIFY(s.place(1, 0).y() - s.place(1, 24).y() > before * 1.3);
    QVERIFY(std::abs(s.place(1, 12).y() - at.y()) <= 1);
    QTest::keyClick(&s.pane, Qt::Key_F);
    QVERIFY(std::abs(s.place(1, 0).y() - s.place(1, 24).y() - before) <= 2);
  }
};

QTEST_MAIN(CurvesTest)
#include "curves_test.moc"
