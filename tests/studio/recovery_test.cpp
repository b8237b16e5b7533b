// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests the question after a crash: it shows the difference, and changes nothing until the user decides.
#include "studio/shell/recovery.h"

#include <QTest>
#include <QtWidgets>

#include "editor/journal.h"
#include "studio/film.h"
#include "studio/shell/text_diff.h"
#include "studio/shell/theme.h"
#include "studio/shell/window.h"

using namespace betwixt;
using namespace betwixt::studio;
using Sign = DiffLine::Sign;

namespace {

const QByteArray saved = "# a film\ncreate ball sphere radius=0.5\ncreate box1 box\n";

QByteArray content(const QString& name) {
  QFile f(name);
  return f.open(QIODevice::ReadOnly) ? f.readAll() : QByteArray();
}

// A folder with a film and the journal of a session that crashed.
struct Crashed {
  QTemporaryDir folder;
  QString file = folder.filePath("film.bx"), journal = folder.filePath(".film.bx.journal");
  QString text;  // that was lost

  Crashed() {
    QByteArray kept;
    {
      Film film(saved);
      film.workspace.say(std::string("set ball.radius 2"));
      film.workspace.say(std::string("create hand box"));
      text = film.text();
      kept = content(film.folder.filePath(".film.bx.journal"));
    }
    QDir::setCurrent(folder.path());
    write(file, saved), write(journal, kept);
  }
  static void write(const QString& name, const QByteArray& text) {
    QFile f(name);
    if (f.open(QIODevice::WriteOnly)) f.write(text);
  }
};

}  // namespace

class RecoveryTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() { set_theme(*qApp, Theme::dark); }

  void theDifferenceOfTexts() {
    const std::vector<DiffLine> all = text_diff("a\nb\nc\nd\ne\nf", "a\nb\nc\nX\nd\ne2\nf", 1);
    const std::vector<DiffLine> wanted{{Sign::gap, ""},      {Sign::same, "c"},   {Sign::added, "X"}, {Sign::same, "d"},
                                       {Sign::removed, "e"}, {Sign::added, "e2"}, {Sign::same, "f"}};
    QVERIFY(all == wanted);
    QVERIFY(text_diff("a\nb", "a\nb").empty());
    QCOMPARE(text_diff("", "a").size(), 2U);
    // Added and removed lines turn one text into the other, whatever they are.
    for (unsigned seed = 1; seed < 200; ++seed) {
      QStringList a, b;
      unsigned r = seed;
      const auto next = [&] { return (r = r * 1103515245 + 12345) >> 16 & 3; };
      for (unsigned i = 0; i < seed % 13; ++i) a << QString::number(next());
      for (unsigned i = 0; i < seed % 11; ++i) b << QString::number(next());
      const QString before = a.join('\n'), after = b.join('\n');
      if (before == after) continue;
      QStringList back, forth;
      for (const DiffLine& l : text_diff(before, after, 1000)) {
        if (l.sign != Sign::added) back << l.text;
        if (l.sign != Sign::removed) forth << l.text;
      }
      QCOMPARE(back.join('\n'), before);
      QCOMPARE(forth.join('\n'), after);
    }
  }

  void theRecoveredTextIsReadFromCopies() {
    const Crashed then;
    const QByteArray journal = content(then.journal);
    QVERIFY(!journal.isEmpty());
    const auto text = recovered_text(then.file.toStdString());
    QVERIFY(text);
    QCOMPARE(QString::fromStdString(*text), then.text);
    QCOMPARE(content(then.file), saved);
    QCOMPARE(content(then.journal), journal);
    QCOMPARE(QDir(then.folder.path()).entryList(QDir::Files | QDir::Hidden).size(), 2);
  }

  void theQuestionShowsTheLinesAndDoesWhatIsChosen() {
    for (const QString choice : {"recover", "discard", "later"}) {
      const Crashed then;
      Workspace workspace;
      Window window(workspace);
      bool asked = false;
      QTimer look;
      connect(&look, &QTimer::timeout, this, [&] {
        auto* question = qobject_cast<Recovery*>(QApplication::activeModalWidget());
        if (!question || !question->is_read()) return;
        asked = true;
        const QString lines = question->findChild<QTextBrowser*>("lines")->toPlainText();
        QVERIFY2(lines.contains("− create ball sphere radius=0.5") && lines.contains("+ create ball sphere radius=2"),
                 qPrintable(lines));
        QVERIFY(lines.contains("+ create hand box"));
        QVERIFY2(question->findChild<QLabel*>("counts")->text().startsWith("lines added: 2, lines removed: 1"),
                 qPrintable(question->findChild<QLabel*>("counts")->text()));
        question->findChild<QPushButton*>(choice)->click();
      });
      look.start(20);
      const bool opened = workspace.open(then.file);
      QVERIFY(asked);
      QCOMPARE(opened, choice != "later");
      if (choice == "recover") QCOMPARE(QString::fromStdString(workspace.text()), then.text);
      if (choice == "discard") QCOMPARE(QByteArray::fromStdString(workspace.text()), saved);
      if (choice == "later") QVERIFY(!content(then.journal).isEmpty());
      QCOMPARE(content(then.file), saved);
    }
  }
};

QTEST_MAIN(RecoveryTest)
#include "recovery_test.moc"
