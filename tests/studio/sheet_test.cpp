// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/timeline/sheet.h"

#include <QElapsedTimer>
#include <QLineEdit>
#include <QToolButton>

#include "betwixt/language.h"
#include "hands.h"
#include "studio/shell/window.h"
#include "studio/timeline/exposures.h"
#include "studio/timeline/sheet_pane.h"

using namespace betwixt;
using namespace betwixt::studio;

namespace {

const std::string head = "rate 24\nrange 1f 100f\ncreate ball sphere\ncreate box box\n";
const std::string film = head + R"(ball.position
  1f (0 0 0)
  24f (1 0 0)
  48f (2 0 0) linear
ball.color
  24f red
  48f blue
box.position
  24f (0 1 0)
)";

// The panel with its rows: ball, position, color, box, position.
struct Shown {
  Film at;
  Sheet panel{at.workspace};
  SheetPane& pane;
  explicit Shown(const std::string& text = film) : at(text), pane(*panel.findChild<SheetPane*>("sheet_pane")) {
    show(panel, 1000, 400);
  }
  QPoint place(std::size_t row, double frame) const { return pane.place(row, at.frame(frame)).toPoint(); }
  std::vector<double> selected(const std::string& target) const {
    std::vector<double> frames;
    for (const EventAt& e : at.workspace.events_selected())
      if (at.workspace.document().name(e.target) == target)
        frames.push_back(at.workspace.document().rate().frame_number(e.time));
    std::ranges::sort(frames);
    return frames;
  }
};
using Frames = std::vector<double>;

}  // namespace

class SheetTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void rows_are_objects_and_their_tracks() {
    Shown s;
    QCOMPARE(s.pane.rows().size(), std::size_t(5));
    s.at.workspace.select({s.at.find("box")});
    QCOMPARE(s.pane.rows().size(), std::size_t(2));
    s.panel.findChild<QToolButton*>("only_selected")->click();
    QCOMPARE(s.pane.rows().size(), std::size_t(5));
    QTest::keyClicks(s.panel.findChild<QLineEdit*>("search"), "b*.col");
    QCOMPARE(s.pane.rows().size(), std::size_t(2));
    QCOMPARE(s.at.workspace.document().name(s.pane.rows()[1].target), "ball.color");
    QTest::mouseClick(&s.pane, Qt::LeftButton, Qt::NoModifier, {3, s.place(0, 1).y()});
    QCOMPARE(s.pane.rows().size(), std::size_t(1));
  }
  void a_click_a_box_and_shift_select() {
    Shown s;
    QTest::mouseClick(&s.pane, Qt::LeftButton, Qt::NoModifier, s.place(1, 24));
    QCOMPARE(s.selected("ball.position"), Frames{24});
    QTest::mouseClick(&s.pane, Qt::LeftButton, Qt::ShiftModifier, s.place(2, 48));
    QCOMPARE(s.selected("ball.color"), Frames{48});
    QCOMPARE(s.selected("ball.position"), Frames{24});
    QTest::mouseClick(&s.pane, Qt::LeftButton, Qt::ShiftModifier, s.place(1, 24));
    QCOMPARE(s.selected("ball.position"), Frames{});
    drag(s.pane, s.place(1, 15), s.place(2, 55) + QPoint(0, 3));
    QCOMPARE(s.selected("ball.position"), (Frames{24, 48}));
    QCOMPARE(s.selected("ball.color"), (Frames{24, 48}));
    QTest::mouseClick(&s.pane, Qt::LeftButton, Qt::NoModifier, s.place(0, 24));  // all of the ball's
    QCOMPARE(s.selected("ball.position"), (Frames{24, 48}));                     // was selected already, and stays
    QTest::mouseClick(&s.pane, Qt::LeftButton, Qt::NoModifier, s.place(1, 70));
    QVERIFY(s.at.workspace.events_selected().empty());
    QTest::mouseClick(&s.pane, Qt::LeftButton, Qt::NoModifier, s.place(0, 24));
    QCOMPARE(s.selected("ball.position"), Frames{24});
    QCOMPARE(s.selected("ball.color"), Frames{24});
    QVERIFY(s.at.said.empty());
  }
  void what_is_dragged_moves_and_stays_selected() {
    Shown s;
    drag(s.pane, s.place(1, 15), s.place(2, 55) + QPoint(0, 3));
    const int by = s.place(0, 30).x() - s.place(0, 24).x();
    drag(s.pane, s.place(1, 24), s.place(1, 24) + QPoint(by + 1, 0));
    QCOMPARE(s.at.said, std::vector<std::string>{"move ball.{position,color} 24f..48f by 6f"});
    QVERIFY(s.at.is(head + "ball.position\n 1f (0 0 0)\n 30f (1 0 0)\n 54f (2 0 0) linear\n"
                           "ball.color\n 30f red\n 54f blue\nbox.position\n 24f (0 1 0)\n"));
    QCOMPARE(s.selected("ball.color"), (Frames{30, 54}));
    QVERIFY(load_text(s.at.workspace.text(), "again").document == s.at.workspace.document());
    s.at.workspace.undo();
    QCOMPARE(s.at.workspace.text(), film);
    QVERIFY(s.at.is(film));
  }
  void what_is_dragged_is_seen_and_can_be_called_off() {
    Shown s;
    QTest::mouseClick(&s.pane, Qt::LeftButton, Qt::NoModifier, s.place(1, 24));
    const int by = s.place(0, 30).x() - s.place(0, 24).x();
    drag(s.pane, s.place(1, 24), s.place(1, 24) + QPoint(by, 0), Qt::NoModifier, true);
    QVERIFY(s.at.workspace.looks_ahead());
    QVERIFY(s.at.is(head + "ball.position\n 1f (0 0 0)\n 30f (1 0 0)\n 48f (2 0 0) linear\n"
                           "ball.color\n 24f red\n 48f blue\nbox.position\n 24f (0 1 0)\n"));
    QTest::keyClick(&s.pane, Qt::Key_Escape);
    QVERIFY(s.at.is(film));
    QTest::mouseRelease(&s.pane, Qt::LeftButton, Qt::NoModifier, s.place(1, 30));
    QVERIFY(s.at.said.empty());
    QCOMPARE(s.selected("ball.position"), Frames{24});
  }
  void a_side_of_the_box_stretches() {
    Shown s;
    drag(s.pane, s.place(1, 10), s.place(2, 55) + QPoint(0, 3));
    const auto box = s.pane.box();
    QVERIFY(box);
    const QPoint side(static_cast<int>(std::lround(box->right())), static_cast<int>(box->center().y()));
    drag(s.pane, side, side + QPoint(s.place(0, 72).x() - s.place(0, 48).x(), 0));
    QCOMPARE(s.at.said, std::vector<std::string>{"stretch ball.{position,color} 24f..48f by 2"});
    QCOMPARE(s.selected("ball.color"), (Frames{24, 72}));
    s.at.workspace.undo();
    QVERIFY(s.at.is(film));
  }
  void keys_do_what_they_say() {
    Shown s;
    drag(s.pane, s.place(1, 10), s.place(2, 55) + QPoint(0, 3));
    QTest::keyClick(&s.pane, Qt::Key_R);
    QTest::keyClick(&s.pane, Qt::Key_C, Qt::ControlModifier);
    s.at.workspace.go_to(s.at.frame(60));
    QTest::keyClick(&s.pane, Qt::Key_V, Qt::ControlModifier);
    QCOMPARE(s.selected("ball.color"), (Frames{60, 84}));
    QTest::keyClick(&s.pane, Qt::Key_Right, Qt::ControlModifier);
    QTest::keyClick(&s.pane, Qt::Key_X);
    s.at.workspace.select({s.at.find("box")});
    s.at.workspace.go_to(s.at.frame(12));
    QTest::keyClick(&s.pane, Qt::Key_K);
    QCOMPARE(s.at.said, (std::vector<std::string>{
                            "reverse ball.{position,color} 24f..48f", "copy ball.{position,color} 24f..48f to 60f",
                            "move ball.{position,color} 60f..84f by 1f", "clear ball.{position,color} 61f..85f",
                            "at 12f box.position (0 1 0) auto"}));
    for (int i = 0; i < 5; ++i) s.at.workspace.undo();
    QCOMPARE(s.at.workspace.text(), film);
  }
  void a_double_click_writes_an_event_or_another_value() {
    Shown s;
    QTest::mouseDClick(&s.pane, Qt::LeftButton, Qt::NoModifier, s.place(1, 60));
    QCOMPARE(s.at.said, std::vector<std::string>{"at 60f ball.position (2 0 0) linear"});
    QTest::mouseDClick(&s.pane, Qt::LeftButton, Qt::NoModifier, s.place(2, 24));
    auto* words = s.pane.findChild<QLineEdit*>("event_words");
    QCOMPARE(words->text(), "red");
    QTest::keyClicks(words, "green hold");
    QTest::keyClick(words, Qt::Key_Return);
    QCOMPARE(s.at.said.back(), "at 24f ball.color green hold");
  }
  void columns_have_values_in_cells() {
    Shown s;
    s.panel.findChild<QToolButton*>("columns")->click();
    auto& cells = *s.panel.findChild<Exposures*>("exposures");
    QCOMPARE(cells.columns().size(), std::size_t(3));
    const auto at = [&](std::size_t column, int frame) { return cells.cell(column, frame).center().toPoint(); };
    // A value is written into an empty cell, another one over it, and it is wiped out.
    for (const char* words : {"gold", "blue hold", ""}) {
      QTest::mouseDClick(&cells, Qt::LeftButton, Qt::NoModifier, at(1, 3));
      auto* edit = cells.findChild<QLineEdit*>("cell_words");
      edit->selectAll();
      QTest::keyClick(edit, Qt::Key_Backspace);
      QTest::keyClicks(edit, words);
      QTest::keyClick(edit, Qt::Key_Return);
      QApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    }
    QCOMPARE(s.at.said,
             (std::vector<std::string>{"at 3f ball.color gold", "at 3f ball.color blue hold", "clear ball.color 3f"}));
    QVERIFY(s.at.is(film));
    drag(cells, at(0, 1), at(0, 5));
    QCOMPARE(s.at.said.back(), "move ball.position 1f..1f by 4f");
    QCOMPARE(s.selected("ball.position"), Frames{5});
    QTest::keyClick(&cells, Qt::Key_Delete);
    QCOMPARE(s.at.said.back(), "clear ball.position 5f");
    QCOMPARE(s.at.workspace.time(), s.at.frame(1));
    QTest::keyClick(&cells, Qt::Key_Down);
    QCOMPARE(s.at.workspace.time(), s.at.frame(2));
  }
  // 1,000 objects with 1,000 events each.
  void a_million_events_are_painted_at_once() {
    std::string text = "rate 24\ncreate b{1..1000} box\nb{1..1000}.position.x\n";
    for (int i = 1; i <= 1000; ++i) text += "  " + std::to_string(i) + "f " + std::to_string(i % 7) + "\n";
    Shown s(text);
    QCOMPARE(s.pane.rows().size(), std::size_t(1000));
    QImage picture(s.pane.size(), QImage::Format_RGB32);
    s.pane.render(&picture);
    QElapsedTimer clock;
    clock.start();
    for (int i = 0; i < 10; ++i) s.pane.update(), s.pane.render(&picture);
    qInfo("a picture of the sheet takes %.1f ms", clock.nsecsElapsed() / 1e7);
  }

  // Tab goes from the rows to each control that one sees, and Shift-Tab back.
  void tabReachesEveryControl() {
    Film made("rate 24\nrange 1f 48f\ncreate ball sphere\nball.position\n  1f (0 0 0)\n  12f (2 0 0)\n");
    Window window(made.workspace);
    window.resize(1400, 1000);
    window.show();
    QVERIFY(QTest::qWaitForWindowActive(&window));
    QWidget* sheet = window.panel("sheet");
    for (const bool columns : {false, true}) {
      auto* last = sheet->findChild<QToolButton*>("columns");
      last->setChecked(columns);
      QStringList wanted{columns ? "exposures" : "sheet_pane", "search", "only_selected", "columns"};
      for (const bool back : {false, true}) {
        back ? last->setFocus() : sheet->setFocus();
        QStringList reached;
        while (sheet->isAncestorOf(QApplication::focusWidget())) {
          reached << QApplication::focusWidget()->objectName();
          QVERIFY2(reached.size() <= wanted.size(), qPrintable(reached.join(' ')));
          back ? QTest::keyClick(window.windowHandle(), Qt::Key_Backtab, Qt::ShiftModifier)
               : QTest::keyClick(window.windowHandle(), Qt::Key_Tab);
        }
        if (back) std::ranges::reverse(reached);
        QCOMPARE(reached, wanted);
      }
    }
  }
};

QTEST_MAIN(SheetTest)
#include "sheet_test.moc"
