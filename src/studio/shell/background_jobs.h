// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Runs slow work on a worker thread, so that the window still draws and shows the progress. User input waits in a
// queue until the work ends; only what stops the work is let through.
#pragma once

#include <QEvent>
#include <QObject>
#include <QPointer>
#include <QWidget>
#include <atomic>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

#undef slots

#include "base/work_progress.h"

class QMouseEvent;

namespace betwixt::studio {

class BackgroundJobs : public QObject {
  Q_OBJECT
 public:
  explicit BackgroundJobs(QObject* parent = nullptr);
  ~BackgroundJobs() override;

  // Runs the work and returns when it is done, or when it has been stopped: then it returns false. Only work that
  // changes copies may be stopped (Cancellation). Do not call it while `hears` is false.
  bool carry_out(const std::function<void()>& work, bool may_stop = false);
  void stop() { stop_ = true; }
  // The control that stops the work; Escape does so too.
  void set_stopper(QWidget* stopper) { stopper_ = stopper; }
  // Returns true if no work is running, or if it waits for an answer; then carry_out() runs its argument at once, in
  // the calling thread.
  bool hears() const { return !at_work_ || answers_; }
  // Runs a function in the window's thread, whatever thread calls, and returns when it is done.
  void in_window(const std::function<void()>& work);
  // Sets how long carry_out() blocks before it emits takes_long(). With 0 it emits it for all work, however short.
  void set_patience(int milliseconds) { patience_ = milliseconds; }

 Q_SIGNALS:
  void takes_long(float share, bool may_stop);  // progress, 0 to 1; repeated until the work ends
  void over();
  void done();  // emitted by the worker, like this one:
  void asks();

 private:
  void run();
  void wait();
  void answer(std::unique_lock<std::mutex>&);
  bool eventFilter(QObject*, QEvent*) override;
  bool is_at_stopper(const QObject*, const QMouseEvent&) const;

  std::mutex mutex_;
  std::condition_variable changed_;
  const std::function<void()>*wanted_ = nullptr, *question_ = nullptr;
  const WorkProgress* progress_ = nullptr;
  bool done_ = false, ends_ = false;
  float share_ = 0;
  bool at_work_ = false, answers_ = false;  // used by the window's thread only
  int patience_ = 100;
  bool may_stop_ = false, stopped_ = false;
  std::atomic<bool> stop_ = false;
  QPointer<QWidget> stopper_;
  std::vector<std::pair<QPointer<QObject>, std::unique_ptr<QEvent>>> waiting_;  // input during the work
  std::thread worker_;
};

}  // namespace betwixt::studio
