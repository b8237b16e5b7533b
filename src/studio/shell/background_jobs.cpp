// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/shell/background_jobs.h"

#include <QEventLoop>
#include <QTimer>
#include <chrono>
#include <utility>

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
    (*work)();
    {
      const std::lock_guard lock(mutex_);
      done_ = true;
    }
    changed_.notify_all();
    emit done();
  }
}

void BackgroundJobs::carry_out(const std::function<void()>& work) {
  if (at_work_) return work();  // the running work waits for an answer
  at_work_ = true;
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
}

// Runs the event loop without user input.
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
  const auto tell = [this] {
    const std::lock_guard lock(mutex_);
    share_ = progress_ ? progress_->share() : 0;
  };
  QTimer again;
  connect(&again, &QTimer::timeout, this, [&] { tell(), emit takes_long(share_); });
  again.start(50);
  tell(), emit takes_long(share_);
  const auto under_way = [this] {
    const std::lock_guard lock(mutex_);
    return !done_;
  };
  {
    std::unique_lock lock(mutex_);
    answer(lock);  // a question from before the loop began
  }
  while (under_way()) loop.exec(QEventLoop::ExcludeUserInputEvents);
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
