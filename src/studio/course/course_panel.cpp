// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/course/course_panel.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QStackedWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "studio/course/course_pointer.h"
#include "studio/shell/keys.h"
#include "studio/shell/scrolled.h"
#include "studio/shell/text_of.h"
#include "studio/shell/window.h"
#include "studio/viewport/viewport.h"

namespace betwixt::studio {
namespace {

constexpr int looks_after = 100;            // ms: how often the panel looks whether a step is done
constexpr std::size_t most_steps = 10'000;  // of undo that are counted

QString in_words(const std::string& text) { return QCoreApplication::translate("Course", text.c_str()); }

}  // namespace

CoursePanel::CoursePanel(Window& window)
    : window_(window),
      workspace_(window.workspace()),
      pointer_(new CoursePointer(window)),
      pages_(new QStackedWidget(this)),
      title_(new QLabel(this)),
      words_(new QLabel(this)),
      progress_(new QProgressBar(this)),
      show_(new QPushButton(tr("Show me"), this)),
      back_(new QPushButton(tr("Back"), this)),
      next_(new QPushButton(tr("All exercises"), this)) {
  setObjectName("course");
  setWindowTitle(tr("Course"));
  auto* whole = new QVBoxLayout(this);
  whole->setContentsMargins(0, 0, 0, 0), whole->addWidget(pages_);
  auto* list = new QWidget(this);
  auto* rows = new QVBoxLayout(list);
  auto* welcome = new QLabel(
      tr("Each exercise takes some minutes. It shows you each step, and notices when you have done it."), this);
  welcome->setWordWrap(true);
  rows->addWidget(welcome);
  for (std::size_t i = 0; i < exercises().size(); ++i) {
    auto* button = new QPushButton(in_words(exercises()[i].name), this);
    button->setObjectName(QString("exercise_%1").arg(i));
    button->setToolTip(in_words(exercises()[i].about));
    rows->addWidget(button);
    connect(&Keys::of_user(), &Keys::changed, this, [this] {
      if (exercise_) tell();
    });
    connect(button, &QPushButton::clicked, this, [this, i] { begin(i); });
  }
  rows->addStretch(1);
  auto* page = new QWidget(this);
  auto* column = new QVBoxLayout(page);
  title_->setTextFormat(Qt::PlainText);
  words_->setObjectName("course_words");
  words_->setTextFormat(Qt::PlainText), words_->setWordWrap(true);
  QFont larger = font();
  larger.setPointSizeF(larger.pointSizeF() * 1.25);
  words_->setFont(larger), words_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  progress_->setTextVisible(false), progress_->setMaximumHeight(fontMetrics().height() / 2);
  progress_->setAccessibleName(tr("Progress of the exercise"));
  show_->setObjectName("show_me"), show_->setToolTip(tr("does this step for you"));
  back_->setObjectName("course_back"), back_->setToolTip(tr("takes this step and the one before it back"));
  next_->setObjectName("all_exercises"), next_->setToolTip(tr("shows the list of exercises"));
  auto* below = new QWidget(this);
  auto* buttons = new QHBoxLayout(below);
  buttons->setContentsMargins(0, 0, 0, 0);
  buttons->addWidget(next_), buttons->addWidget(back_), buttons->addWidget(show_);
  column->addWidget(title_), column->addWidget(progress_), column->addWidget(words_, 1),
      column->addWidget(new Scrolled(below, Qt::Horizontal, this));
  pages_->addWidget(new Scrolled(list, Qt::Vertical, this));
  pages_->addWidget(new Scrolled(page, Qt::Vertical, this));
  connect(show_, &QPushButton::clicked, this, &CoursePanel::show_me);
  connect(back_, &QPushButton::clicked, this, &CoursePanel::back);
  connect(next_, &QPushButton::clicked, this, &CoursePanel::leave);
  looks_.setInterval(looks_after);
  connect(&window_.workspace(), &Workspace::opened, this, [this] {
    if (exercise_) leave();
  });
  connect(&looks_, &QTimer::timeout, this, &CoursePanel::look);
}

const CourseStep* CoursePanel::step() const {
  return exercise_ && step_ < exercise_->steps.size() ? &exercise_->steps[step_] : nullptr;
}

std::size_t CoursePanel::steps_of_film() const {
  const auto history = workspace_.session().history(most_steps);
  return static_cast<std::size_t>(std::ranges::count_if(history, &Session::PastStep::stands));
}

void CoursePanel::begin(std::size_t exercise) {
  if (!window_.may_leave()) return;
  window_.begin_film(exercises().at(exercise).film);
  exercise_ = &exercises().at(exercise);  // another film has ended the exercise before
  ViewportSwitches switches = window_.viewport().switches();
  switches.tool = Tool::move, switches.handles = true, switches.auto_key = false;
  window_.viewport().set_switches(switches);
  pages_->setCurrentIndex(1);
  begun_.clear();
  go_to(0);
}

void CoursePanel::go_to(std::size_t number) {
  const bool back = number < step_;
  step_ = number;
  begun_.resize(number);
  begun_.push_back(steps_of_film());
  const int all = static_cast<int>(exercise_->steps.size());
  progress_->setRange(0, all), progress_->setValue(static_cast<int>(number));
  const CourseStep* now = step();
  title_->setText(now ? tr("%1 — step %2 of %3").arg(in_words(exercise_->name)).arg(number + 1).arg(all)
                      : in_words(exercise_->name));
  tell();
  show_->setEnabled(now), back_->setEnabled(number > 0);
  waits_ = back && now && is_done(*now, window_);
  look();
}

// The sentence of the step, with the keys that the user has chosen.
void CoursePanel::tell() {
  const CourseStep* now = step();
  words_->setText(with_keys(now ? in_words(now->words)
                                : tr("Done. The film is yours: save it with {Save}, or choose another exercise.")));
}

void CoursePanel::look() {
  const CourseStep* now = step();
  if (!now || !isVisible()) return pointer_->point_at("");
  if (!workspace_.looks_ahead()) {
    const bool done = is_done(*now, window_);
    if (done && !waits_) return go_to(step_ + 1);
    waits_ = waits_ && done;
  }
  pointer_->point_at(with_names(now->point, workspace_));
}

void CoursePanel::show_me() {
  if (const CourseStep* now = step()) {
    waits_ = false;
    show_how(*now, window_);
    look();
  }
}

void CoursePanel::back() {
  if (!exercise_ || step_ == 0) return;
  workspace_.pause();
  workspace_.settle_typing();
  for (std::size_t more = steps_of_film(); more > begun_[step_ - 1]; --more) workspace_.undo();
  go_to(step_ - 1);
}

void CoursePanel::leave() {
  exercise_ = nullptr;
  pages_->setCurrentIndex(0);
  pointer_->point_at("");
}

void CoursePanel::showEvent(QShowEvent* e) {
  QWidget::showEvent(e);
  looks_.start();
}

void CoursePanel::hideEvent(QHideEvent* e) {
  QWidget::hideEvent(e);
  looks_.stop();
  pointer_->point_at("");
}

}  // namespace betwixt::studio
