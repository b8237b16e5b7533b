// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/shell/background_jobs.h"

#include <QApplication>
#include <QEventLoop>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QTimer>
#include <chrono>
#include <utility>

#include "base/cancellation.h"

namespace betwixt::studio {

BackgroundJobs::BackgroundJobs(QObject* parent) : QObject(parent), worker_([this] { run(); }) {}

BackgroundJobs::~BackgroundJobs() {
  {
    const std::lock_guard lock(mutex_);
    ends_ = true;
  }
  changed_.notify_all();
  worker_.join();
}

void BackgroundJobs::run() {
  const WorkProgress how_far;
  while (true) {
    const std::function<void()>* work = nullptr;
    {
      std::unique_lock lock(mutex_);
      changed_.wait(lock, [&] { return ends_ || wanted_; });
      if (ends_) return;
      work = std::exchange(wanted_, nullptr);
      progress_ = &how_far;
    }
    WorkProgress::report(0, 1);
    try {
      static const std::atomic<bool> never = false;
      static const std::atomic<int> nobody = 0;
      const Cancellation wanted(stop_, never, nobody, {});
      (*work)();
    } catch (const Cancelled&) {
      stopped_ = true;
    }
    {
      const std::lock_guard lock(mutex_);
      done_ = true;
    }
    changed_.notify_all();
    emit done();
  }
}

bool BackgroundJobs::carry_out(const std::function<void()>& work, bool may_stop) {
  if (at_work_) return work(), true;  // the running work waits for an answer
  at_work_ = true, may_stop_ = may_stop, stopped_ = false, stop_ = false;
  std::unique_lock lock(mutex_);
  done_ = false, wanted_ = &work;
  changed_.notify_all();
  if (patience_ > 0) {
    // Short work blocks the window, which the user cannot notice.
    const auto patient = std::chrono::steady_clock::now() + std::chrono::milliseconds(patience_);
    while (changed_.wait_until(lock, patient, [&] { return done_ || question_; }) && !done_) answer(lock);
  }
  if (!done_) {
    lock.unlock();
    wait();
    lock.lock();
  }
  at_work_ = false;
  return !stopped_;
}

bool BackgroundJobs::is_at_stopper(const QObject* on, const QMouseEvent& e) const {
  if (!stopper_ || !stopper_->isVisible()) return false;
  const QWidget* window = stopper_->window();
  return on == stopper_ ||
         (on == window->windowHandle() &&
          QRect(stopper_->mapTo(window, QPoint()), stopper_->size()).contains(e.position().toPoint()));
}

// Keeps the user's input for later, but for what stops the work. A filter of the application sees an event first on its
// way to a window, and then on its way to a widget.
bool BackgroundJobs::eventFilter(QObject* on, QEvent* e) {
  switch (e->type()) {
    case QEvent::KeyPress:
    case QEvent::KeyRelease:
      if (may_stop_ && !answers_ && static_cast<QKeyEvent*>(e)->key() == Qt::Key_Escape) return stop(), true;
      break;
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonRelease:
    case QEvent::MouseButtonDblClick:
    case QEvent::MouseMove:
      if (may_stop_ && is_at_stopper(on, *static_cast<QMouseEvent*>(e))) return false;
      break;
    case QEvent::Wheel:
    case QEvent::ContextMenu:
    case QEvent::Shortcut:
    case QEvent::ShortcutOverride:
    case QEvent::TouchBegin:
    case QEvent::TouchUpdate:
    case QEvent::TouchEnd:
      break;
    default:
      return false;
  }
  if (answers_) return false;  // a question needs input
  if (on->isWindowType()) waiting_.emplace_back(on, e->clone());
  return on->isWindowType() || e->spontaneous();
}

// Runs the event loop; the user's input waits.
void BackgroundJobs::wait() {
  QEventLoop loop;
  connect(this, &BackgroundJobs::done, &loop, &QEventLoop::quit, Qt::QueuedConnection);
  connect(
      this, &BackgroundJobs::asks, &loop,
      [this] {
        std::unique_lock lock(mutex_);
        answer(lock);
      },
      Qt::QueuedConnection);
  if (may_stop_) qApp->installEventFilter(this);
  const auto tell = [this] {
    const std::lock_guard lock(mutex_);
    share_ = progress_ ? progress_->share() : 0;
  };
  QTimer again;
  connect(&again, &QTimer::timeout, this, [&] { tell(), emit takes_long(share_, may_stop_); });
  again.start(50);
  tell(), emit takes_long(share_, may_stop_);
  const auto under_way = [this] {
    const std::lock_guard lock(mutex_);
    return !done_;
  };
  {
    std::unique_lock lock(mutex_);
    answer(lock);  // a question from before the loop began
  }
  while (under_way()) loop.exec(may_stop_ ? QEventLoop::AllEvents : QEventLoop::ExcludeUserInputEvents);
  qApp->removeEventFilter(this);
  for (auto& [on, event] : std::exchange(waiting_, {}))
    if (on) QCoreApplication::postEvent(on, event.release());
  emit over();
}

// Runs the function that the worker wants in the window's thread; the worker waits for it.
void BackgroundJobs::answer(std::unique_lock<std::mutex>& lock) {
  if (!question_) return;
  const auto* question = question_;
  lock.unlock();
  answers_ = true;
  (*question)();
  answers_ = false;
  lock.lock();
  question_ = nullptr;
  changed_.notify_all();
}

void BackgroundJobs::in_window(const std::function<void()>& work) {
  if (std::this_thread::get_id() != worker_.get_id()) return work();
  std::unique_lock lock(mutex_);
  question_ = &work;
  changed_.notify_all();
  emit asks();
  changed_.wait(lock, [&] { return !question_; });
}

}  // namespace betwixt::studio
