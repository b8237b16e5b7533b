// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The desk that all panels work at, and what stands around them.
#include "studio/desk.h"

#include <QTest>
#include <QtWidgets>

#include "betwixt/language.h"
#include "studio/actions.h"
#include "studio/asking.h"
#include "studio/export_dialog.h"
#include "studio/live_panel.h"
#include "studio/palette.h"
#include "studio/server_panel.h"
#include "studio/theme.h"
#include "studio/viewport.h"
#include "studio/window.h"

using namespace betwixt;
using namespace betwixt::studio;

namespace {

const QByteArray ball =
    "create ball sphere  # round\n"
    "ball.position\n"
    "  1f  (0 0 0)\n"
    "  24f (9 0 0)\n";

QByteArray contents(const QString& name) {
  QFile file(name);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray("(it is not there)");
}
void put(const QString& name, const QByteArray& text) {
  QFile file(name);
  QVERIFY(file.open(QIODevice::WriteOnly));
  file.write(text);
}

}  // namespace

class DeskTest : public QObject {
  Q_OBJECT
  QTemporaryDir folder_;
  QString film_;

 private Q_SLOTS:
  void initTestCase() { set_theme(*qApp, Theme::dark); }
  void init() {
    film_ = folder_.filePath("film.bx");
    QFile::remove(folder_.filePath(".film.bx.journal"));
    put(film_, ball);
  }

  void linesGoWhereTheyBelongAndBack() {
    Desk desk;
    QVERIFY(desk.open(film_));
    QVERIFY(desk.say(std::string("at 24f ball.position (5 0 0)")));
    QCOMPARE(QByteArray::fromStdString(desk.text()), QByteArray(ball).replace("(9 0 0)", "(5 0 0)"));
    QVERIFY(desk.say(std::vector<std::string>{"set ball.color red", "create b box"}));
    QCOMPARE(QByteArray::fromStdString(desk.text()),
             QByteArray(ball).replace("(9 0 0)", "(5 0 0)") + "set ball.color red\ncreate b box\n");
    desk.undo();
    desk.undo();
    QCOMPARE(QByteArray::fromStdString(desk.text()), ball);
    desk.redo();
    QCOMPARE(QByteArray::fromStdString(desk.text()), QByteArray(ball).replace("(9 0 0)", "(5 0 0)"));
  }

  void lookingAheadChangesNothing() {
    Desk desk;
    desk.open(film_);
    const Document before = desk.document();
    QVERIFY(desk.look_ahead({"at 24f ball.position (5 0 0)"}));
    QVERIFY(!(desk.document() == before));
    QCOMPARE(QByteArray::fromStdString(desk.text()), ball);
    QVERIFY(!desk.look_ahead({"nonsense"}));
    desk.look_back();
    QVERIFY(desk.document() == before);
  }

  void typingShowsAtOnceAndIsOneStep() {
    Desk desk;
    desk.open(film_);
    QByteArray text = ball;
    for (const char* digit : {"(9 1 0)", "(9 12 0)", "(9 12.5 0)"}) {
      text.replace(text.indexOf("(9 "), text.indexOf(")", text.indexOf("(9 ")) - text.indexOf("(9 ") + 1, digit);
      desk.retype(text.toStdString());
    }
    QCOMPARE(std::get<Vec3>(desk.program().read((*find_targets("ball.position", desk.document()))[0],
                                                desk.document().rate().frame(24)))
                 .y,
             12.5);
    QCOMPARE(desk.session().unsaved(), std::size_t{0});
    desk.settle_typing();
    QCOMPARE(desk.session().unsaved(), std::size_t{1});
    QCOMPARE(QByteArray::fromStdString(desk.text()), text);
    desk.undo();
    QCOMPARE(QByteArray::fromStdString(desk.text()), ball);
  }

  void whatOthersWriteIsPutTogether() {
    Desk desk;
    desk.open(film_);
    QVERIFY(desk.say(std::string("at 24f ball.position (5 0 0)")));
    put(film_, QByteArray(ball).replace("# round", "# a ball"));
    QTRY_COMPARE(QByteArray::fromStdString(desk.text()),
                 QByteArray(ball).replace("# round", "# a ball").replace("(9 0 0)", "(5 0 0)"));
    QVERIFY(desk.say(std::string("save")));
    QCOMPARE(contents(film_), QByteArray(ball).replace("# round", "# a ball").replace("(9 0 0)", "(5 0 0)"));
  }
  void whatBothHaveChangedIsAsked() {
    for (const std::string answer : {"theirs", "ours", "both"}) {
      init();
      Desk desk;
      std::string question;
      desk.ask = [&](const std::string& q) { return question = q, answer; };
      desk.open(film_);
      QVERIFY(desk.say(std::string("at 24f ball.position (5 0 0)")));
      put(film_, QByteArray(ball).replace("(9 0 0)", "(7 0 0)"));
      QTRY_VERIFY(!question.empty());
      QCOMPARE(answers_of(question), (std::vector<std::string>{"theirs", "ours", "both"}));
      const QByteArray text = QByteArray::fromStdString(desk.text());
      QCOMPARE(text.contains("(5 0 0)"), answer != "theirs");
      QCOMPARE(text.contains("(7 0 0)"), answer != "ours");
      desk.ask = {};
    }
  }

  void questionsBelowAListAreUnderstood() {
    const std::string asked =
        "  at 1f ball.position (1 2 3)\n  undo\n9 commands of an earlier session were not saved: recover, discard or "
        "show? ";
    QCOMPARE(answers_of(asked), (std::vector<std::string>{"recover", "discard", "show"}));
  }

  void quittingIsGuarded() {
    Desk desk;
    Window window(desk);
    desk.open(film_);
    window.show();
    QVERIFY(desk.say(std::string("set ball.color red")));
    std::string question, answer = "stay";
    desk.ask = [&](const std::string& q) { return question = q, answer; };
    window.close();
    QVERIFY(window.isVisible());
    QCOMPARE(answers_of(question), (std::vector<std::string>{"save", "discard", "stay"}));
    QCOMPARE(words_of(question), "1 command is not saved.");
    QCOMPARE(words_of("File 'a.bx' exists: overwrite? (yes/no) "), "File 'a.bx' exists: overwrite?");
    answer = "save";
    window.close();
    QVERIFY(!window.isVisible());
    QCOMPARE(contents(film_), ball + "set ball.color red\n");
  }

  void playsBothWaysAndInAPart() {
    Desk desk;
    desk.open(film_);
    Transport& t = desk.transport();
    const Rate rate = desk.document().rate();
    const auto at = [&](double seconds) {
      return t.now(Transport::Clock::now() + std::chrono::milliseconds(static_cast<int>(1000 * seconds)));
    };
    desk.go_to(rate.frame(3));
    t.loop(false), t.play(1);
    QCOMPARE(at(0.52), rate.frame(15));  // half a second at 24 a second
    QCOMPARE(at(100), rate.frame(24));   // stays at the end
    t.pause(), desk.go_to(rate.frame(13)), t.play(-1);
    QCOMPARE(at(0.48), rate.frame(2));
    t.loop(true);
    const Time now = at(0.0), later = at(1.0);  // 24 frames: once around
    QCOMPARE(now, later);
    desk.pause();
    desk.set_range(std::pair(rate.frame(5), rate.frame(8)));
    desk.go_to(rate.frame(5)), t.play(1);
    for (double s = 0; s < 2; s += 0.01) QVERIFY(at(s) >= rate.frame(5) && at(s) <= rate.frame(8));
  }

  void everyActionSaysWhatItDoesAndHasKeysOfItsOwn() {
    std::map<QString, std::string_view> keys;
    for (const ActionRow& row : action_rows()) {
      QVERIFY2(row.sentence.ends_with('.'), std::string(row.name).c_str());
      for (const QString& k :
           QString::fromUtf8(row.keys.data(), static_cast<int>(row.keys.size())).split("; ", Qt::SkipEmptyParts)) {
        const QString sequence = QKeySequence(k).toString();
        QVERIFY2(!sequence.isEmpty(), qPrintable(k));
        QVERIFY2(keys.emplace(sequence, row.name).second, qPrintable(k + " twice"));
      }
    }
  }

  void thePaletteFindsByLetters() {
    QVERIFY(fit("und", "Undo") > fit("und", "Round"));
    QCOMPARE(fit("xyz", "Undo"), 0);
    Desk desk;
    Window window(desk);
    desk.open(film_);
    Palette palette(window);
    auto* line = palette.findChild<QLineEdit*>();
    QTest::keyClicks(line, "set ball.color red");
    QTest::keyClick(line, Qt::Key_Return);
    QVERIFY(desk.text().ends_with("set ball.color red\n"));
    Palette again(window);
    line = again.findChild<QLineEdit*>();
    QTest::keyClicks(line, "undo");
    QTest::keyClick(line, Qt::Key_Return);
    QCOMPARE(QByteArray::fromStdString(desk.text()), ball);
    Palette third(window);
    line = third.findChild<QLineEdit*>();
    QTest::keyClicks(line, "select ball");
    QTest::keyClick(line, Qt::Key_Return);
    QCOMPARE(desk.selected(), std::vector{desk.document().find("ball")});
  }

  void theExportShowsTheLineItStandsFor() {
    Desk desk;
    desk.open(film_);
    ExportDialog dialog(desk);
    dialog.findChild<QLineEdit*>("out")->setText("a film.mp4");
    QCOMPARE(dialog.command(), "betwixt render " + film_ + " -o 'a film.mp4'");
    desk.set_range(std::pair(desk.document().rate().frame(2), desk.document().rate().frame(5)));
    ExportDialog part(desk);
    part.findChild<QLineEdit*>("out")->setText("x.gif");
    QCOMPARE(part.command(), "betwixt render " + film_ + " -o x.gif --frames 2f..5f");
  }

  void controlsAreLearnedAndRecorded() {
    Desk desk;
    desk.open(film_);
    LivePanel live(desk);
    live.findChild<QLineEdit*>("target")->setText("ball.radius");
    live.findChild<QPushButton*>("learn")->setChecked(true);
    live.obey({"/fader/1", {0.5}, {}, {}});
    QVERIFY2(desk.text().ends_with("dial /fader/1 to ball.radius\n"), desk.text().c_str());
    live.obey({"/fader/1", {2.5}, {}, {}});  // is seen at once
    const auto radius = [&](double frame) {
      return std::get<double>(
          desk.program().read((*find_targets("ball.radius", desk.document()))[0], desk.document().rate().frame(frame)));
    };
    QCOMPARE(radius(1), 2.5);
    desk.look_back();
    QCOMPARE(radius(1), 1.0);
    live.findChild<QCheckBox*>("record")->setChecked(true);
    desk.transport().loop(false);
    desk.play(1);
    live.obey({"/fader/1", {3.0}, {}, {}});
    QTest::qWait(200);
    live.obey({"/fader/1", {4.0}, {}, {}});
    desk.pause();
    QVERIFY2(desk.text().find("ball.radius\n") != std::string::npos ||
                 desk.text().find("at 1f ball.radius 3") != std::string::npos,
             desk.text().c_str());
    QCOMPARE(radius(1), 3.0);
    const Document recorded = desk.document();
    QVERIFY(load_text(desk.text(), film_.toStdString()).document == recorded);
    desk.undo();
    QCOMPARE(radius(1), 1.0);
  }

  void aServerIsWatchedAndSteered() {
    const QString program = QCoreApplication::applicationDirPath() + "/betwixt", place = folder_.filePath("stage.sock");
    if (!QFileInfo::exists(program)) QSKIP("the program betwixt has not been built here");
    QProcess server;
    server.start(program, {"serve", "--socket", place});
    QTRY_VERIFY_WITH_TIMEOUT(QFileInfo::exists(place), 20000);
    ServerPanel panel;
    panel.show();
    panel.join(place);
    QTRY_VERIFY_WITH_TIMEOUT(panel.joined(), 10000);
    QStringList answers;
    connect(&panel, &ServerPanel::answered, this,
            [&](const QString& line, const QString& answer) { answers << line + answer; });
    auto* line = panel.findChild<QLineEdit*>("line");
    for (const char* said : {"create ball sphere", "animate slide every 1t by translate(0.02 0 0)", "nonsense"}) {
      QTest::keyClicks(line, said);
      QTest::keyClick(line, Qt::Key_Return);
    }
    QTRY_COMPARE_WITH_TIMEOUT(answers.size(), 3, 10000);
    QVERIFY(answers[0].contains("\"ok\":true") && answers[2].contains("\"ok\":false"));
    QTRY_VERIFY_WITH_TIMEOUT(panel.document().find("ball") && panel.document().find("slide"), 10000);
    QTRY_COMPARE(panel.findChild<QListWidget*>("environments")->count(), 1);
    QTest::mouseClick(panel.findChild<QPushButton*>("pause"), Qt::LeftButton);
    QTRY_COMPARE_WITH_TIMEOUT(panel.findChild<QPushButton*>("pause")->text(), QString("Go"), 10000);
    panel.leave();
    QVERIFY(!panel.joined());
    server.terminate();
    QVERIFY(server.waitForFinished(10000));
    panel.join("/no/such/place");
    QTRY_VERIFY(!panel.joined());
  }

  void screenshotsOfEveryLayout() {
    Desk desk;
    Window window(desk);
    desk.open(film_);
    window.resize(1280, 800);
    window.show();
    for (const QString& layout : Window::layouts()) {
      QVERIFY(window.set_layout(layout));
      QApplication::processEvents();
      window.viewport().await_picture();
      QCOMPARE(window.grab().size(), QSize(1280, 800));
    }
    QVERIFY(!window.set_layout("none such"));
  }
};

QTEST_MAIN(DeskTest)
#include "desk_test.moc"
