// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests lines typed into the console, and its answers.
#include "studio/shell/console.h"

#include <QTest>
#include <QTreeWidget>

#include "studio/film.h"

namespace betwixt::studio {

class ConsoleTest : public QObject {
  Q_OBJECT

  struct Shown : Film {
    Console console{workspace};
    ConsoleLine& line{*console.findChild<ConsoleLine*>("console_line")};
    QPlainTextEdit& log{*console.findChild<QPlainTextEdit*>("console_log")};
    QLabel& help{*console.findChild<QLabel*>("console_help")};
    Shown() : Film({}) {
      console.show();
      line.setFocus();
    }
    void type(const char* keys) { QTest::keyClicks(&line, keys); }
    void enter(const char* keys) { type(keys), QTest::keyClick(&line, Qt::Key_Return); }
    QTreeWidget& words() { return *line.findChild<QTreeWidget*>("words"); }
  };

 private Q_SLOTS:
  void says_what_is_entered() {
    Shown s;
    s.enter("create ball sphere");
    QCOMPARE(s.workspace.document().names(), std::vector<std::string>{"ball"});
    QVERIFY(QString::fromStdString(s.workspace.text()).endsWith("create ball sphere\n"));
    QVERIFY(s.line.toPlainText().isEmpty());
    QVERIFY(s.log.toPlainText().contains("› create ball sphere"));
    s.enter("undo");
    QVERIFY(s.workspace.document().names().empty());
  }

  void says_what_is_wrong_where() {
    Shown s;
    s.enter("create ball sphre");
    const QString log = s.log.toPlainText();
    QVERIFY(log.contains("error: "));
    QVERIFY(log.contains("sphere"));  // the near miss
    const qsizetype caret = log.indexOf('^');
    QVERIFY(caret > 0);
    // The caret stands below the word: as far in as that is in the line above.
    const QStringList lines = log.split('\n');
    for (qsizetype i = 1; i < lines.size(); ++i)
      if (lines[i].contains('^')) QCOMPARE(lines[i].indexOf('^'), lines[i - 1].indexOf("sphre"));
    QVERIFY(s.log.font().fixedPitch() || QFontInfo(s.log.font()).fixedPitch());
  }

  void remembers() {
    Shown s;
    s.enter("create a sphere");
    s.enter("create b box");
    s.type("hide");
    QTest::keyClick(&s.line, Qt::Key_Up);
    QCOMPARE(s.line.toPlainText(), "create b box");
    QTest::keyClick(&s.line, Qt::Key_Up);
    QTest::keyClick(&s.line, Qt::Key_Up);
    QCOMPARE(s.line.toPlainText(), "create a sphere");
    QTest::keyClick(&s.line, Qt::Key_Down);
    QTest::keyClick(&s.line, Qt::Key_Down);
    QCOMPARE(s.line.toPlainText(), "hide");
  }

  void goes_on_over_lines() {
    Shown s;
    s.enter("create p polygon points=((0 0) (1 0)");
    QVERIFY(s.workspace.document().names().empty());
    s.enter("(1 1))");
    QCOMPARE(s.workspace.document().names(), std::vector<std::string>{"p"});
    QVERIFY(s.line.toPlainText().isEmpty());
  }

  void takes_rows_of_a_sheet() {
    Shown s;
    s.enter("create ball sphere");
    s.enter("ball.radius");
    s.enter("1f 1");
    s.enter("24f 3");
    const auto f = find_targets("ball.radius", s.workspace.document());
    QCOMPARE(events(s.workspace.document(), f->front()).size(), std::size_t{2});
    s.type("48f ");
    QVERIFY(s.help.text().contains("ball.radius"));
  }

  void several_lines_are_said_one_by_one() {
    Shown s;
    s.line.setPlainText("create a sphere\ncreate b box\nball.nothing");
    QTest::keyClick(&s.line, Qt::Key_Return);
    QCOMPARE(s.workspace.document().names(), (std::vector<std::string>{"a", "b"}));
    s.workspace.undo();
    QCOMPARE(s.workspace.document().names(), (std::vector<std::string>{"a"}));
  }

  void offers_words() {
    Shown s;
    s.type("creat");
    QTest::keyClick(&s.line, Qt::Key_Tab);
    QCOMPARE(s.line.toPlainText(), "create");
    s.type(" b s");
    QTest::keyClick(&s.line, Qt::Key_Tab);
    QVERIFY(s.words().isVisible());
    QCOMPARE(s.words().topLevelItem(0)->text(0), "scatter");
    QTest::keyClick(&s.line, Qt::Key_Down);
    QCOMPARE(s.words().currentItem()->text(0), "scene");
    QTest::keyClick(&s.line, Qt::Key_Down);
    QCOMPARE(s.words().currentItem()->text(0), "sound");
    QTest::keyClick(&s.line, Qt::Key_Down);
    QCOMPARE(s.words().currentItem()->text(0), "speech-bubble");
    QTest::keyClick(&s.line, Qt::Key_Down);
    QCOMPARE(s.words().currentItem()->text(0), "sphere");
    QTest::keyClick(&s.line, Qt::Key_Return);
    QCOMPARE(s.line.toPlainText(), "create b sphere");
    QVERIFY(!s.words().isVisible());
    QVERIFY(s.workspace.document().names().empty());
  }

  void helps_while_it_is_written() {
    Shown s;
    QVERIFY(!s.help.isVisible());
    s.type("at 24f hide");
    QVERIFY(s.help.isVisible());
    QVERIFY(s.help.text().contains("hide A or at TIME hide A"));
    s.line.clear();
    s.type("create b sphere");
    QVERIFY(s.help.text().contains("radius=1"));
    s.line.clear();
    s.enter("help sphere");
    QVERIFY(s.log.toPlainText().contains("sphere, a kind of object"));
  }

  void keeps_no_more_than_it_shows() {
    Shown s;
    for (int i = 0; i < 60; ++i) s.enter("help");
    QVERIFY(s.log.blockCount() <= 5000);
  }

  void undo_is_the_films() {
    Shown s;
    s.enter("create ball sphere");
    s.type("half a li");
    QTest::keyClick(&s.line, Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(s.workspace.document().names().empty());
    QCOMPARE(s.line.toPlainText(), "half a li");
  }
};

}  // namespace betwixt::studio

QTEST_MAIN(betwixt::studio::ConsoleTest)
#include "console_test.moc"
