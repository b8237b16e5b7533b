// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The course: each exercise by "Show me" alone, and back again.
#include <QtTest/QtTest>
#include <QtWidgets>

#include "betwixt/language.h"
#include "studio/course/course_panel.h"
#include "studio/course/course_pointer.h"
#include "studio/shell/theme.h"
#include "studio/shell/window.h"
#include "studio/viewport/viewport.h"

namespace betwixt::studio {

class CourseTest : public QObject {
  Q_OBJECT

  Workspace workspace_;
  std::unique_ptr<Window> window_;
  CoursePanel& course() { return *static_cast<CoursePanel*>(window_->panel("course")); }

  void begin(std::size_t exercise) {
    workspace_.open("", Session::Earlier::discard);
    course().begin(exercise);
    QCOMPARE(course().step_number(), std::size_t(0));
  }

 private Q_SLOTS:
  void initTestCase() {
    QStandardPaths::setTestModeEnabled(true);
    set_theme(*qApp, Theme::dark);
    window_ = std::make_unique<Window>(workspace_);
    window_->resize(1400, 900);
    window_->show();
    QVERIFY(QTest::qWaitForWindowExposed(window_.get()));
    window_->show_panel("course");
  }

  void exercisesAreReadFromRows() {
    QCOMPARE(exercises().size(), std::size_t(5));
    const auto read =
        read_exercises("exercise A\n| create b box\nstep Do it.\n  point widget add\n  until there box 2\n");
    QVERIFY(read);
    QCOMPARE((*read)[0].film, "create b box\n");
    QCOMPARE((*read)[0].steps[0].until[0], "there box 2");
    for (const char* wrong : {"step Do it.", "exercise A\nuntil there box 1", "exercise A\nstep B\nuntil nonsense",
                              "exercise A\nstep B\nuntil there box"})
      QVERIFY2(!read_exercises(wrong), wrong);
  }

  // Each step is not done before and done after; nothing else than its lines is needed.
  void showMeDoesEachStep() {
    for (std::size_t e = 0; e < exercises().size(); ++e) {
      const Exercise& exercise = exercises()[e];
      begin(e);
      const Loaded film = load_text(exercise.film, "film");
      QVERIFY2(film.diagnostics.empty(), qPrintable(QString::fromStdString(exercise.name)));
      for (std::size_t i = 0; i < exercise.steps.size(); ++i) {
        const QString where = QString::fromStdString(exercise.name + ": " + exercise.steps[i].words);
        QVERIFY2(course().step() == &exercise.steps[i], qPrintable(where));
        QVERIFY2(!is_done(exercise.steps[i], *window_), qPrintable(where));
        course().show_me();
        QVERIFY2(is_done(exercise.steps[i], *window_), qPrintable(where));
      }
      QVERIFY(!course().step());
      workspace_.pause();
      QVERIFY(workspace_.diagnostics().empty());
      // Back leads to the beginning, and the step before is not skipped although its condition may still hold.
      for (std::size_t i = exercise.steps.size(); i > 0; --i) {
        course().back();
        QCOMPARE(course().step_number(), i - 1);
      }
      QCOMPARE(workspace_.text(), exercise.film);
    }
  }

  void theFrameIsAroundThePlace() {
    begin(0);
    auto& pointer = *window_->findChild<QWidget*>("course_pointer");
    auto& add = *window_->findChild<QWidget*>("add");
    QVERIFY(pointer.isVisible());
    QCOMPARE(QRect(pointer.mapTo(window_.get(), QPoint()), pointer.size()).center(),
             QRect(add.mapTo(window_.get(), QPoint()), add.size()).center());
    QVERIFY(pointer.width() > add.width());
    window_->panel("course")->parentWidget()->hide();
    QVERIFY(!pointer.isVisible());
    window_->show_panel("course");
    course().findChild<QPushButton*>("all_exercises")->click();
    QVERIFY(!pointer.isVisible());
    QVERIFY(!course().step());
  }
};

}  // namespace betwixt::studio

QTEST_MAIN(betwixt::studio::CourseTest)
#include "course_test.moc"
