// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The course: exercises, step by step. It shows where each step is done, and notices when it is done.
#pragma once

#include <QTimer>
#include <QWidget>
#include <vector>

#include "studio/course/exercise.h"

class QLabel;
class QProgressBar;
class QPushButton;
class QStackedWidget;

namespace betwixt::studio {

class CoursePointer;
class Window;

class CoursePanel : public QWidget {
  Q_OBJECT
 public:
  explicit CoursePanel(Window&);
  QSize sizeHint() const override { return {24 * fontMetrics().horizontalAdvance('m'), 300}; }

  // Begins an exercise with its film, if the user agrees to leave the present one.
  void begin(std::size_t exercise);
  void show_me();
  void back();
  // Goes to the next step if this one is done.
  void tell();
  void look();
  // The exercise and the step at work; nullptr if there is none, or if all steps are done.
  const Exercise* exercise() const { return exercise_; }
  const CourseStep* step() const;
  std::size_t step_number() const { return step_; }

 protected:
  void showEvent(QShowEvent*) override;
  void hideEvent(QHideEvent*) override;

 private:
  void go_to(std::size_t step);
  void leave();
  std::size_t steps_of_film() const;

  Window& window_;
  Workspace& workspace_;
  CoursePointer* pointer_;
  QTimer looks_;
  const Exercise* exercise_ = nullptr;
  std::size_t step_ = 0;
  std::vector<std::size_t> begun_;  // how many steps of undo the film had when each step began
  bool waits_ = false;              // the step was done when it began: it must be undone before it can be done
  QStackedWidget* pages_;
  QLabel *title_, *words_;
  QProgressBar* progress_;
  QPushButton *show_, *back_, *next_;
};

}  // namespace betwixt::studio
