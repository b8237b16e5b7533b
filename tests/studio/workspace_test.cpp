// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests the workspace that all panels share, and the window around them.
#include "studio/shell/workspace.h"

#include <QTest>
#include <QtWidgets>

#include "betwixt/language.h"
#include "scene/functions.h"
#include "studio/panels/live_panel.h"
#include "studio/panels/server_panel.h"
#include "studio/shell/actions.h"
#include "studio/shell/control_names.h"
#include "studio/shell/export_dialog.h"
#include "studio/shell/manual.h"
#include "studio/shell/palette.h"
#include "studio/shell/theme.h"
#include "studio/shell/window.h"
#include "studio/viewport/viewport.h"
#include "syntax/tokens.h"

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

  void anotherFilmBeginsAtItsStartWithNothingSelected() {
    const QString other = folder_.filePath("other.bx");
    put(other, "range 5f 20f\ncreate box box\ncreate far box\n");
    Workspace workspace;
    QVERIFY(workspace.open(film_));
    workspace.select({workspace.document().find("ball")});
    workspace.go_to(workspace.document().rate().frame(13));
    QVERIFY(workspace.say("open " + as_one_word(other.toStdString())));
    QVERIFY(workspace.document().find("far") && workspace.selected().empty() && workspace.events_selected().empty());
    QCOMPARE(workspace.time(), workspace.document().range().first);
  }

  void linesGoWhereTheyBelongAndBack() {
    Workspace workspace;
    QVERIFY(workspace.open(film_));
    QVERIFY(workspace.say(std::string("at 24f ball.position (5 0 0)")));
    QCOMPARE(QByteArray::fromStdString(workspace.text()), QByteArray(ball).replace("(9 0 0)", "(5 0 0)"));
    QVERIFY(workspace.say(std::vector<std::string>{"set ball.color red", "create b box"}));
    QCOMPARE(QByteArray::fromStdString(workspace.text()),
             QByteArray(ball).replace("(9 0 0)", "(5 0 0)") + "set ball.color red\ncreate b box\n");
    workspace.undo();
    workspace.undo();
    QCOMPARE(QByteArray::fromStdString(workspace.text()), ball);
    workspace.redo();
    QCOMPARE(QByteArray::fromStdString(workspace.text()), QByteArray(ball).replace("(9 0 0)", "(5 0 0)"));
  }

  void lookingAheadChangesNothing() {
    Workspace workspace;
    workspace.open(film_);
    const Document before = workspace.document();
    QVERIFY(workspace.look_ahead({"at 24f ball.position (5 0 0)"}));
    QVERIFY(!(workspace.document() == before));
    QCOMPARE(QByteArray::fromStdString(workspace.text()), ball);
    QVERIFY(!workspace.look_ahead({"nonsense"}));
    workspace.look_back();
    QVERIFY(workspace.document() == before);
  }

  void typingShowsAtOnceAndIsOneStep() {
    Workspace workspace;
    workspace.open(film_);
    QByteArray text = ball;
    for (const char* digit : {"(9 1 0)", "(9 12 0)", "(9 12.5 0)"}) {
      text.replace(text.indexOf("(9 "), text.indexOf(")", text.indexOf("(9 ")) - text.indexOf("(9 ") + 1, digit);
      workspace.retype(text.toStdString());
    }
    QCOMPARE(std::get<Vec3>(workspace.program().read((*find_targets("ball.position", workspace.document()))[0],
                                                     workspace.document().rate().frame(24)))
                 .y,
             12.5);
    QCOMPARE(workspace.session().unsaved(), std::size_t{0});
    workspace.settle_typing();
    QCOMPARE(workspace.session().unsaved(), std::size_t{1});
    QCOMPARE(QByteArray::fromStdString(workspace.text()), text);
    workspace.undo();
    QCOMPARE(QByteArray::fromStdString(workspace.text()), ball);
  }

  void whatOthersWriteIsPutTogether() {
    Workspace workspace;
    workspace.open(film_);
    QVERIFY(workspace.say(std::string("at 24f ball.position (5 0 0)")));
    put(film_, QByteArray(ball).replace("# round", "# a ball"));
    QTRY_COMPARE(QByteArray::fromStdString(workspace.text()),
                 QByteArray(ball).replace("# round", "# a ball").replace("(9 0 0)", "(5 0 0)"));
    QVERIFY(workspace.say(std::string("save")));
    QCOMPARE(contents(film_), QByteArray(ball).replace("# round", "# a ball").replace("(9 0 0)", "(5 0 0)"));
  }
  void whatBothHaveChangedIsAsked() {
    for (const std::string answer : {"theirs", "ours", "both"}) {
      init();
      Workspace workspace;
      Session::Question question;
      workspace.ask = [&](const Session::Question& q) { return question = q, answer; };
      workspace.open(film_);
      QVERIFY(workspace.say(std::string("at 24f ball.position (5 0 0)")));
      put(film_, QByteArray(ball).replace("(9 0 0)", "(7 0 0)"));
      QTRY_VERIFY(!question.text.empty());
      QCOMPARE(question.choices, (std::vector<std::string>{"theirs", "ours", "both"}));
      const QByteArray text = QByteArray::fromStdString(workspace.text());
      QCOMPARE(text.contains("(5 0 0)"), answer != "theirs");
      QCOMPARE(text.contains("(7 0 0)"), answer != "ours");
      workspace.ask = {};
    }
  }

  void quittingIsGuarded() {
    Workspace workspace;
    Window window(workspace);
    workspace.open(film_);
    window.show();
    QVERIFY(workspace.say(std::string("set ball.color red")));
    Session::Question question;
    std::string answer = "stay";
    workspace.ask = [&](const Session::Question& q) { return question = q, answer; };
    window.close();
    QVERIFY(window.isVisible());
    QCOMPARE(question.choices, (std::vector<std::string>{"save", "discard", "stay"}));
    QCOMPARE(question.text, std::string("1 command is not saved"));
    answer = "save";
    window.close();
    QVERIFY(!window.isVisible());
    QCOMPARE(contents(film_), ball + "set ball.color red\n");
  }

  void playsAPart() {
    Workspace workspace;
    workspace.open(film_);
    const Rate rate = workspace.document().rate();
    workspace.playhead().loop(false);
    workspace.set_range(std::pair(rate.frame(5), rate.frame(8)));
    workspace.go_to(rate.frame(13));
    workspace.play(1);
    QCOMPARE(workspace.time(), rate.frame(5));
    QTRY_VERIFY(!workspace.playhead().playing());
    QCOMPARE(workspace.time(), rate.frame(8));
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

  // For people who cannot see the controls, or cannot use a mouse.
  void everyControlHasANameAndCanBeReached() {
    Workspace workspace;
    Window window(workspace);
    workspace.open(film_);
    window.show();
    for (const bool selected : {false, true}) {
      if (selected) workspace.select({workspace.document().find("ball")});
      for (QDockWidget* dock : window.findChildren<QDockWidget*>()) {
        dock->show(), dock->raise();
        QCoreApplication::processEvents();
        int controls = 0;
        for (QWidget* w : QList{dock->widget()} + dock->widget()->findChildren<QWidget*>()) {
          if (!w->isVisible() || !is_control(*w)) continue;
          ++controls;
          const QString who = dock->objectName() + ": " + w->metaObject()->className() + " " + w->objectName();
          QVERIFY2(w->accessibleName().size() > 1, qPrintable(who));
          const bool part = qobject_cast<QLineEdit*>(w) && qobject_cast<QComboBox*>(w->parentWidget());
          if (qobject_cast<QAbstractButton*>(w) && w->isEnabled() && !part)
            QVERIFY2(w->focusPolicy() & Qt::TabFocus, qPrintable(who + " cannot be reached by keys"));
        }
        QVERIFY2(controls > 0, qPrintable(dock->objectName()));
      }
    }
  }

  // All panels are shown, and a thing is selected that the next film does not have.
  void anotherFilmFollowsWhateverIsSelected() {
    Workspace workspace;
    Window window(workspace);
    window.open_example();
    window.set_layout("all");
    window.show();
    for (QDockWidget* dock : window.findChildren<QDockWidget*>()) dock->show(), dock->raise();
    for (int k = 0; k < 3; ++k) {
      for (const char* name : {"ball", "eye"}) {
        window.open_example();
        workspace.select({workspace.document().find(name)});
        window.viewport().await_picture();
        window.grab();
        QCoreApplication::processEvents();
        k == 1 ? window.open_example() : window.begin_film({});
        QCoreApplication::processEvents();
        window.grab();
        QVERIFY(workspace.selected().empty());
      }
    }
  }

  void whatIsUndoneIsNotSelected() {
    Workspace workspace;
    workspace.open(film_);
    workspace.say(std::string("create more box"));
    workspace.select({workspace.document().find("more")});
    workspace.undo();
    QVERIFY(workspace.selected().empty());
  }

  // In a field in which nothing was typed, ctrl-Z is that of the film.
  void undoWorksInFields() {
    Workspace workspace;
    Window window(workspace);
    workspace.open(film_);
    window.show();
    window.activateWindow();
    window.show_panel("properties");
    workspace.select({workspace.document().find("ball")});
    QVERIFY(QTest::qWaitForWindowActive(&window));
    const std::string before = workspace.text();
    workspace.say(std::string("set ball.radius 3"));
    auto* name = window.findChild<QLineEdit*>("name");
    name->setFocus();
    QTest::keyClick(name, Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(workspace.text(), before);
    QTest::keyClicks(name, "x");  // now it is that of the field
    QTest::keyClick(name, Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(name->text(), QString("ball"));
  }

  void newCamerasLookFromTheView() {
    Workspace workspace;
    Window window(workspace);
    workspace.open(film_);
    window.viewport().set_free(true);
    window.viewport().look_along({-1, 0, 0});
    const Vec3 eye = translation_of(workspace.view()->world);
    auto* menu = window.findChild<QToolButton*>("add")->menu();
    for (QAction* group : menu->actions())
      for (QAction* a : group->menu() ? group->menu()->actions() : QList<QAction*>())
        if (a->text() == "camera") a->trigger();
    QVERIFY(!workspace.selected().empty());
    const ObjectId camera = workspace.selected().back();
    const Value at = workspace.program().read(Target(camera, fn::position), workspace.time());
    QVERIFY(length(std::get<Vec3>(at) - eye) < 0.02 * length(eye));
    window.viewport().set_free(false);
    QCOMPARE(window.viewport().film_camera(), camera);  // the first one of this film
    QVERIFY(!workspace.view());
  }

  void textIsLargerOrSmaller() {
    Workspace workspace;
    Window window(workspace);
    workspace.open(film_);
    window.show();
    const double before = QApplication::font().pointSizeF();
    const auto* title = window.findChild<QLineEdit*>("name");  // with a font of its own
    const double titled = title->font().pointSizeF();
    window.set_text_size(1.5);
    QVERIFY(std::abs(QApplication::font().pointSizeF() - 1.5 * before) < 0.1);
    QVERIFY(std::abs(title->font().pointSizeF() - 1.5 * titled) < 0.1);
    window.set_text_size(100);
    QCOMPARE(window.text_size(), 2.5);
    window.set_text_size(1);
    QVERIFY(std::abs(QApplication::font().pointSizeF() - before) < 0.1);
  }

  // Every row of words belongs to an action, and words of other programs lead to it.
  void thePaletteKnowsTheWordsOfOtherPrograms() {
    Workspace workspace;
    Window window(workspace);
    const auto first = [&](const char* letters) {
      Palette palette(window);
      QTest::keyClicks(palette.findChild<QLineEdit*>(), letters);
      return palette.findChild<QListWidget*>()->item(0)->text();
    };
    for (const auto& [letters, name] : {std::pair("keyframe", "Insert event at playhead"),
                                        {"interpol", "Twerper by its picture"},
                                        {"parent", "Group"},
                                        {"delete", "Remove"},
                                        {"orthographic", "Perspective"},
                                        {"motion path", "Ways"}})
      QVERIFY2(first(letters).contains(name), qPrintable(QString(letters) + ": " + first(letters)));
    for (const ActionRow& row : action_rows())
      if (row.name == "Go to curves") QVERIFY(row.also.find("easing") != row.also.npos);
  }

  void thePaletteFindsByLetters() {
    QVERIFY(fit("und", "Undo") > fit("und", "Round"));
    QCOMPARE(fit("xyz", "Undo"), 0);
    Workspace workspace;
    Window window(workspace);
    workspace.open(film_);
    Palette palette(window);
    auto* line = palette.findChild<QLineEdit*>();
    QTest::keyClicks(line, "set ball.color red");
    QTest::keyClick(line, Qt::Key_Return);
    QVERIFY(workspace.text().ends_with("set ball.color red\n"));
    Palette again(window);
    line = again.findChild<QLineEdit*>();
    QTest::keyClicks(line, "undo");
    QTest::keyClick(line, Qt::Key_Return);
    QCOMPARE(QByteArray::fromStdString(workspace.text()), ball);
    Palette third(window);
    line = third.findChild<QLineEdit*>();
    QTest::keyClicks(line, "select ball");
    QTest::keyClick(line, Qt::Key_Return);
    QCOMPARE(workspace.selected(), std::vector{workspace.document().find("ball")});
  }

  void theExportShowsTheLineItStandsFor() {
    Workspace workspace;
    workspace.open(film_);
    ExportDialog dialog(workspace);
    dialog.findChild<QLineEdit*>("out")->setText("a film.mp4");
    QCOMPARE(dialog.command(), "betwixt render " + film_ + " -o 'a film.mp4'");
    workspace.set_range(std::pair(workspace.document().rate().frame(2), workspace.document().rate().frame(5)));
    ExportDialog part(workspace);
    part.findChild<QLineEdit*>("out")->setText("x.gif");
    QCOMPARE(part.command(), "betwixt render " + film_ + " -o x.gif --frames 2f..5f");
  }

  // The dialog shows the settings of the last time, those of each film.
  void theExportKeepsItsSettings() {
    Workspace workspace, other;
    workspace.open(film_), other.open(film_);
    {
      ExportDialog dialog(workspace);
      dialog.findChildren<QComboBox*>()[0]->setCurrentText("1920x1080");
      dialog.findChildren<QSpinBox*>()[0]->setValue(16);
      dialog.findChild<QLineEdit*>("out")->setText("x.gif");
    }
    const ExportDialog again(workspace), fresh(other);
    QCOMPARE(again.command(), "betwixt render " + film_ + " -o x.gif --size 1920x1080 --samples 16");
    QVERIFY2(!fresh.command().contains("1920"), qPrintable(fresh.command()));
    workspace.open({}, Session::Earlier::discard);  // another film in the same tab
    QVERIFY(!ExportDialog(workspace).command().contains("1920"));
  }

  void helpHasTheManualAndTheVersion() {
    Workspace workspace;
    Window window(workspace);
    window.show();
    window.show_about();
    auto* about = window.findChild<QMessageBox*>("about");
    QVERIFY(about && about->isVisible());
    QFile changes(SOURCE_DIR "/CHANGELOG.md");
    QVERIFY(changes.open(QIODevice::ReadOnly));
    const QString version = QString::fromUtf8(changes.readAll()).section("\n## ", 1, 1).section(' ', 0, 0);
    QVERIFY2(about->text().contains("Betwixt " + version) && about->text().contains("Apache License"),
             qPrintable(about->text()));
    about->close();
    Manual manual(SOURCE_DIR "/docs");
    manual.show();
    auto* page = manual.findChild<ManualPage*>();
    QVERIFY(page->toPlainText().contains("The studio shows a film"));
    page->go(QUrl("language.md"));
    QVERIFY(page->source().path().endsWith("/docs/language.md"));
    page->backward();
    QVERIFY(page->source().path().endsWith("/docs/studio.md"));
    page->go(QUrl("#beginning-a-film"));
    QCOMPARE(page->textCursor().block().text(), "Beginning a film");
    auto* search = manual.findChild<QLineEdit*>("manual_search");
    search->setText("ripple edit");
    QTest::keyClick(search, Qt::Key_Return);
    QCOMPARE(page->textCursor().selectedText(), "ripple edit");
    QVERIFY(manual.isVisible());
  }

  void controlsAreLearnedAndRecorded() {
    Workspace workspace;
    workspace.open(film_);
    LivePanel live(workspace);
    live.findChild<QLineEdit*>("target")->setText("ball.radius");
    live.findChild<QPushButton*>("learn")->setChecked(true);
    live.obey({"/fader/1", {0.5}, {}, {}});
    QVERIFY2(workspace.text().ends_with("dial /fader/1 to ball.radius\n"), workspace.text().c_str());
    live.obey({"/fader/1", {2.5}, {}, {}});  // is seen at once
    const auto radius = [&](double frame) {
      return std::get<double>(workspace.program().read((*find_targets("ball.radius", workspace.document()))[0],
                                                       workspace.document().rate().frame(frame)));
    };
    QCOMPARE(radius(1), 2.5);
    workspace.look_back();
    QCOMPARE(radius(1), 1.0);
    live.findChild<QCheckBox*>("record")->setChecked(true);
    workspace.playhead().loop(false);
    workspace.play(1);
    live.obey({"/fader/1", {3.0}, {}, {}});
    QTest::qWait(200);
    live.obey({"/fader/1", {4.0}, {}, {}});
    workspace.pause();
    QVERIFY2(workspace.text().find("ball.radius\n") != std::string::npos ||
                 workspace.text().find("at 1f ball.radius 3") != std::string::npos,
             workspace.text().c_str());
    QCOMPARE(radius(1), 3.0);
    const Document recorded = workspace.document();
    QVERIFY(load_text(workspace.text(), film_.toStdString()).document == recorded);
    workspace.undo();
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
    Workspace workspace;
    Window window(workspace);
    workspace.open(film_);
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
#include "workspace_test.moc"
