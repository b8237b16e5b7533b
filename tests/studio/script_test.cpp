// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests the script panel: typing in it, and changes by others.
#include <QScrollBar>
#include <QTest>
#include <QTreeWidget>
#include <random>

#include "studio/film.h"
#include "studio/script/script_panel.h"

namespace betwixt::studio {

class ScriptTest : public QObject {
  Q_OBJECT

  struct Shown : Film {
    ScriptPanel panel{workspace};
    ScriptEdit& edit{*panel.findChild<ScriptEdit*>("script")};
    QListWidget& errors{*panel.findChild<QListWidget*>("script_errors")};
    explicit Shown(const QByteArray& text) : Film(text) {
      panel.resize(600, 400);
      panel.show();
      edit.setFocus();
      if (!QTest::qWaitForWindowActive(&panel)) qFatal("no window");
    }
    QString text() const { return edit.toPlainText(); }
    QString films() const { return QString::fromStdString(workspace.text()); }
    void put_cursor(int line, int column) {
      QTextCursor c(edit.document()->findBlockByNumber(line - 1));
      c.movePosition(QTextCursor::Right, QTextCursor::MoveAnchor, column);
      edit.setTextCursor(c);
    }
    QPoint at(int line, int column) {
      QTextCursor c(edit.document()->findBlockByNumber(line - 1));
      c.movePosition(QTextCursor::Right, QTextCursor::MoveAnchor, column);
      return edit.cursorRect(c).center();
    }
  };

 private Q_SLOTS:
  void what_is_typed_is_seen_and_is_one_step() {
    Shown s("rate 24\ncreate ball sphere radius=2\n");
    s.put_cursor(2, 27);
    QTest::keyClick(&s.edit, Qt::Key_Backspace);
    QTest::keyClicks(&s.edit, "35");
    QCOMPARE(s.radius("ball"), 35.0);  // at once
    QCOMPARE(s.workspace.session().unsaved(), std::size_t{0});
    s.workspace.settle_typing();
    QCOMPARE(s.films(), "rate 24\ncreate ball sphere radius=35\n");
    QCOMPARE(s.workspace.session().unsaved(), std::size_t{1});
    QTest::keyClick(&s.edit, Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(s.films(), "rate 24\ncreate ball sphere radius=2\n");
    QCOMPARE(s.text(), s.films());
    QCOMPARE(s.radius("ball"), 2.0);
    QTest::keyClick(&s.edit, Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    QCOMPARE(s.text(), "rate 24\ncreate ball sphere radius=35\n");
  }

  void undo_while_typing_takes_it_all_back() {
    Shown s("create ball sphere\n");
    s.put_cursor(2, 0);
    QTest::keyClicks(&s.edit, "hide ball");
    QTest::keyClick(&s.edit, Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(s.text(), "create ball sphere\n");
    QCOMPARE(s.films(), "create ball sphere\n");
  }

  void what_others_do_changes_its_lines_only() {
    Shown s("# above\ncreate ball sphere radius=2\ncreate box1 box\n# below\n");
    s.put_cursor(4, 3);
    QVERIFY(s.workspace.say(std::string("set ball.radius 5")));
    QCOMPARE(s.text(), s.films());
    QCOMPARE(s.edit.textCursor().block().text(), "# below");
    QCOMPARE(s.edit.textCursor().positionInBlock(), 3);
    QVERIFY(!s.edit.extraSelections().isEmpty());  // it flashes
    QVERIFY(s.edit.extraSelections().size() > 1);
    s.workspace.undo();
    QCOMPARE(s.text(), "# above\ncreate ball sphere radius=2\ncreate box1 box\n# below\n");
    QCOMPARE(s.edit.textCursor().positionInBlock(), 3);
  }

  void what_is_seen_stays_when_lines_come_above() {
    QByteArray text;
    for (int i = 0; i < 300; ++i) text += "# line " + QByteArray::number(i) + "\n";
    Shown s("rate 24\n" + text);
    s.edit.verticalScrollBar()->setValue(150);
    const QString top = s.edit.cursorForPosition({2, 2}).block().text();
    QVERIFY(s.workspace.say(Session::rewrite_line(1, 1, "rate 25\n# new\n# new\n")));
    QCOMPARE(s.edit.cursorForPosition({2, 2}).block().text(), top);
  }

  void errors_stand_where_they_are() {
    Shown s("create ball sphere\nset ball.radus 3\n");
    QCOMPARE(s.errors.count(), 1);
    QVERIFY(s.errors.item(0)->text().startsWith("line 2: "));
    QVERIFY(s.edit.said_of(2));
    QVERIFY(!s.edit.said_of(1));
    QCOMPARE(s.edit.said_of(2)->severity, Severity::error);
    s.edit.grab();
    bool wave = false;
    for (const auto& f : s.edit.document()->findBlockByNumber(1).layout()->formats())
      wave |= f.format.underlineStyle() == QTextCharFormat::WaveUnderline;
    QVERIFY(wave);
    s.put_cursor(2, 12);
    QTest::keyClicks(&s.edit, "i");
    QCOMPARE(s.errors.count(), 0);  // radius
    QCOMPARE(s.radius("ball"), 3.0);
  }

  void words_have_their_colours() {
    Shown s("create ball sphere radius=2\n");
    s.edit.grab();
    const auto formats = s.edit.document()->firstBlock().layout()->formats();
    QVERIFY(formats.size() >= 5);
    QVERIFY(formats[0].format.foreground().color() != formats[2].format.foreground().color());
  }

  void the_line_of_the_cursor_selects_what_it_speaks_of() {
    Shown s("create ball sphere\ncreate car box\nball.radius\n  1f 1\n  24f 3\nhide {ball,car}\n");
    s.put_cursor(2, 3);
    QCOMPARE(s.selected(), "car");
    QCOMPARE(s.workspace.script_line(), 2);
    s.put_cursor(5, 3);
    QCOMPARE(s.selected(), "ball");
    s.put_cursor(6, 0);
    QCOMPARE(s.selected(), "ball car");
    QCOMPARE(s.workspace.time(), Time{});
    s.workspace.select({s.workspace.document().find("ball")});
    s.edit.grab();
    QVERIFY(s.edit.speaks(1) && s.edit.speaks(3) && s.edit.speaks(4) && s.edit.speaks(5) && s.edit.speaks(6));
    QVERIFY(!s.edit.speaks(2));
  }

  void a_double_click_on_a_time_goes_there() {
    Shown s("rate 24\ncreate ball sphere\nball.radius\n  1f 1\n  25f 3\n");
    QTest::mouseDClick(s.edit.viewport(), Qt::LeftButton, {}, s.at(5, 3));
    QCOMPARE(s.workspace.time().seconds(), 1.0);
  }

  void numbers_are_dragged() {
    Shown s("create ball sphere radius=2.5\n");
    const QPoint p = s.at(1, 27);
    const int step = std::max(1, s.edit.fontMetrics().averageCharWidth() / 2);
    QTest::mousePress(s.edit.viewport(), Qt::LeftButton, Qt::AltModifier, p);
    QMouseEvent move(QEvent::MouseMove, p + QPoint(7 * step, 0), s.edit.viewport()->mapToGlobal(p), Qt::NoButton,
                     Qt::LeftButton, Qt::AltModifier);
    QCoreApplication::sendEvent(s.edit.viewport(), &move);
    const double now = s.radius("ball");
    QVERIFY(now > 2.5 && now <= 3.3);  // while it is dragged
    QCOMPARE(s.workspace.session().unsaved(), std::size_t{0});
    QTest::mouseRelease(s.edit.viewport(), Qt::LeftButton, Qt::AltModifier, p + QPoint(7 * step, 0));
    QCOMPARE(s.workspace.session().unsaved(), std::size_t{1});
    QCOMPARE(s.radius("ball"), now);
    s.workspace.undo();
    QCOMPARE(s.text(), "create ball sphere radius=2.5\n");
  }

  void numbers_go_by_keys() {
    Shown s("create ball sphere radius=2.5\n");
    s.put_cursor(1, 28);
    QTest::keyClick(&s.edit, Qt::Key_Up, Qt::AltModifier);
    QCOMPARE(s.text(), "create ball sphere radius=2.6\n");
    QTest::keyClick(&s.edit, Qt::Key_Down, Qt::AltModifier | Qt::ShiftModifier);
    QCOMPARE(s.text(), "create ball sphere radius=1.6\n");
    QCOMPARE(s.radius("ball"), 1.6);
  }

  void offers_words_of_rows_too() {
    Shown s("create ball sphere\nball.radius\n  1f 1 lin\n");
    s.put_cursor(3, 10);
    QTest::keyClick(&s.edit, Qt::Key_Space, Qt::ControlModifier);
    QCOMPARE(s.edit.document()->findBlockByNumber(2).text(), "  1f 1 linear");
    s.put_cursor(4, 0);
    QTest::keyClicks(&s.edit, "set ball.rad");
    QTest::keyClick(&s.edit, Qt::Key_Space, Qt::ControlModifier);
    QCOMPARE(s.edit.document()->findBlockByNumber(3).text(), "set ball.radius");
  }

  void rows_go_on_as_rows() {
    Shown s("create ball sphere\n");
    s.put_cursor(2, 0);
    QTest::keyClicks(&s.edit, "ball.radius");
    QTest::keyClick(&s.edit, Qt::Key_Return);
    QTest::keyClicks(&s.edit, "1f 1");
    QTest::keyClick(&s.edit, Qt::Key_Return);
    QTest::keyClicks(&s.edit, "24f 3");
    QCOMPARE(s.text(), "create ball sphere\nball.radius\n  1f 1\n  24f 3");
    s.workspace.settle_typing();
    const auto f = find_targets("ball.radius", s.workspace.document());
    QCOMPARE(events(s.workspace.document(), f->front()).size(), std::size_t{2});
  }

  void words_are_found() {
    Shown s("create ball sphere\ncreate car box\nhide ball\n");
    QTest::keyClick(&s.edit, Qt::Key_F, Qt::ControlModifier);
    auto& sought = *s.panel.findChild<QLineEdit*>("script_sought");
    QVERIFY(sought.isVisible());
    QTest::keyClicks(&sought, "ball");
    const int lines[] = {1, 3, 1};  // again from the top
    for (const int line : lines) {
      QTest::keyClick(&sought, Qt::Key_Return);
      QCOMPARE(s.edit.textCursor().blockNumber() + 1, line);
      QCOMPARE(s.edit.textCursor().selectedText(), "ball");
    }
    QTest::keyClick(&sought, Qt::Key_Escape);
    QVERIFY(!sought.isVisible() && s.edit.hasFocus());
  }

  void endings_of_lines_stay() {
    Shown s("create ball sphere\r\ncreate car box\r\n");
    s.put_cursor(1, 18);
    QTest::keyClicks(&s.edit, " radius=3");
    s.workspace.settle_typing();
    QCOMPARE(s.films(), "create ball sphere radius=3\r\ncreate car box\r\n");
  }

  // A long text is read again when its author rests; what others do until then is put together with it.
  void a_long_script_is_read_when_the_keys_rest() {
    QByteArray text = "create ball sphere radius=2\n";
    for (int i = 0; i < 20'000; ++i) text += "# a remark, one of many, line " + QByteArray::number(i) + "\n";
    Shown s(text + "create car box");
    s.edit.moveCursor(QTextCursor::End);
    QTest::keyClick(&s.edit, Qt::Key_Return);
    QTest::keyClicks(&s.edit, "hide car");
    QVERIFY(!s.workspace.looks_ahead());
    QTRY_VERIFY(s.workspace.looks_ahead());
    QCOMPARE(s.value("car.display"), Value(false));
    s.workspace.settle_typing();
    QTest::keyClick(&s.edit, Qt::Key_Return);
    QTest::keyClicks(&s.edit, "hide ball");
    QVERIFY(s.workspace.say(std::string("set ball.radius 5")));
    QTRY_COMPARE(s.value("ball.display"), Value(false));
    QCOMPARE(s.radius("ball"), 5.0);
    s.workspace.settle_typing();
    QCOMPARE(s.text(), s.films());
    QVERIFY(s.text().startsWith("create ball sphere radius=5\n"));
    QVERIFY(s.text().endsWith("create car box\nhide car\nhide ball"));
  }

  static QByteArray long_text(int lines) {
    QByteArray text("film flat\nrate 24\ncreate a circle\na.position\n");
    for (int i = 1; i <= lines; ++i)
      text += "  " + QByteArray::number(i) + "f (0 " + QByteArray::number(i % 7) + " 0)\n";
    return text;
  }

  // A long script comes in parts. Whoever needs all of it gets it: here a line, a change by others, and a search.
  void a_long_script_fills_the_editor_part_by_part() {
    const QByteArray text = long_text(40'000);
    {
      Shown s(text);
      QTRY_VERIFY(!s.edit.filling());
      QCOMPARE(s.text().toUtf8(), text);
      QVERIFY(!s.edit.isReadOnly());
    }
    Film film(text);
    ScriptPanel panel(film.workspace);
    ScriptEdit& edit = *panel.findChild<ScriptEdit*>("script");
    QVERIFY(edit.filling() && edit.isReadOnly());
    QVERIFY(edit.toPlainText().size() < text.size());
    edit.go_to_line(39'000);
    QCOMPARE(edit.textCursor().blockNumber(), 38999);
    QVERIFY(!edit.filling() && !edit.isReadOnly());

    Film other(text);
    ScriptPanel second(other.workspace);
    other.workspace.say(std::string("set a.radius 3"));
    QVERIFY(!second.findChild<ScriptEdit*>("script")->filling());
    QCOMPARE(second.findChild<ScriptEdit*>("script")->toPlainText().toStdString(), other.workspace.text());
  }

  // What was typed, deleted and pasted, with letters beyond ASCII at times, is the film's text.
  void typing_in_a_long_script_is_followed() {
    Shown s(long_text(40'000));
    QTRY_VERIFY(!s.edit.filling());
    std::mt19937 random(11);
    const auto below = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
    for (int i = 0; i < 60; ++i) {
      s.put_cursor(5 + below(39'000), below(8));
      for (int k = 0, keys = 1 + below(4); k < keys; ++k) switch (below(7)) {
          case 0:
            QTest::keyClick(&s.edit, Qt::Key_Backspace);
            break;
          case 1:
            QTest::keyClick(&s.edit, Qt::Key_Delete);
            break;
          case 2:
            QTest::keyClick(&s.edit, Qt::Key_Return);
            break;
          case 3:
            s.edit.insertPlainText("# one\n  # two\n");
            break;
          case 4:
            s.edit.insertPlainText(i > 40 ? QString::fromUtf8("é€") : "x");
            break;
          case 5: {
            QTextCursor c = s.edit.textCursor();
            c.movePosition(QTextCursor::Down, QTextCursor::KeepAnchor, below(3));
            c.removeSelectedText(), s.edit.setTextCursor(c);
            break;
          }
          default:
            QTest::keyClicks(&s.edit, "7");
        }
      if (i % 3 == 0) QTRY_COMPARE(s.films().size(), s.text().size());
      if (i % 10 == 0) s.workspace.settle_typing();
      if (i % 20 == 0) s.workspace.say(std::string("set a.radius 2"));
    }
    QTRY_VERIFY(s.films() == s.text());
    s.workspace.settle_typing();
    QVERIFY(s.films() == s.text());
  }

  // States of lines below an edit are what they would be if all were read again.
  void a_text_that_is_opened_colours_what_is_below() {
    Shown s("create ball sphere\n# one\ncreate car box\n");
    s.edit.grab();
    s.put_cursor(2, 0);
    QTest::keyClicks(&s.edit, "at 1f note \"\"\"");
    s.edit.grab();
    const auto formats = s.edit.document()->findBlockByNumber(2).layout()->formats();
    QCOMPARE(formats.size(), 1);
    QCOMPARE(formats[0].length, 14);
    for (int i = 0; i < 3; ++i) QTest::keyClick(&s.edit, Qt::Key_Backspace);
    s.edit.grab();
    QVERIFY(s.edit.document()->findBlockByNumber(2).layout()->formats().size() > 1);
  }
};

}  // namespace betwixt::studio

QTEST_MAIN(betwixt::studio::ScriptTest)
#include "script_test.moc"
