// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "server/multilevel_queue.h"

#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <system_error>

#include "base/cancellation.h"

namespace betwixt {

using namespace std::chrono_literals;

namespace {

constexpr auto look_again = 10ms;  // from one look for overdue threads to the next

}  // namespace

const std::array<MultilevelQueue::Terms, 4> MultilevelQueue::terms{{{5ms, 4}, {50ms, 9}, {1s, 14}, {0ms, 19}}};

MultilevelQueue::~MultilevelQueue() {
  end();
  for (Lane& lane : lanes_)
    for (Worker& w : lane.workers) w.thread.join();
}

void MultilevelQueue::end() {
  const std::lock_guard lock(mutex_);
  ended_ = true;
  for (Lane& lane : lanes_) {
    lane.changed.notify_all();
    for (Job* job : lane.waiting) job->changed.notify_one();
  }
}

void MultilevelQueue::look() {
  const std::lock_guard lock(mutex_);
  for (Lane& lane : lanes_)
    for (Job* job : lane.waiting)
      if (*job->gone) job->changed.notify_one();
}

bool MultilevelQueue::run(const std::function<void()>& work, const std::atomic<bool>& gone) {
  std::unique_lock lock(mutex_);
  Job job{&work, &gone, Job::State::waits, {}, {}, {}};
  for (std::size_t lane = 0; job.state != Job::State::done; ++lane) {
    while (lane + 1 < lanes_.size() && job.used > terms[lane].most) ++lane;
    if (gone || ended_) return false;
    enter(lock, std::min(lane, lanes_.size() - 1), job);
  }
  if (job.failed) std::rethrow_exception(job.failed);
  return job.state == Job::State::done && !gone && !ended_;
}

// Waits for the job's turn and its end, or until it is cancelled.
void MultilevelQueue::enter(std::unique_lock<std::mutex>& lock, std::size_t lane, Job& job) {
  job.state = Job::State::waits;
  if (!staffed(lane)) {  // no thread can be started: work on this one
    lock.unlock();
    const Job::State end = work(job, lane);
    lock.lock();
    job.state = end;
    return;
  }
  std::deque<Job*>& waiting = lanes_[lane].waiting;
  waiting.push_back(&job), ++lanes_[lane].others;
  lanes_[lane].changed.notify_one();
  const auto over = [&] {
    return job.state > Job::State::runs || (job.state == Job::State::waits && (*job.gone || ended_));
  };
  while (!over()) {
    if (job.state != Job::State::waits || waiting.front() != &job) {
      job.changed.wait(lock);
      continue;
    }
    job.changed.wait_for(lock, look_again);  // the first in the queue looks for overdue threads
    if (!over() && job.state == Job::State::waits)
      look_for_late(lane), staffed(lane), lanes_[lane].changed.notify_one();
  }
  if (job.state == Job::State::waits) leave(lane, std::find(waiting.begin(), waiting.end(), &job));
}

void MultilevelQueue::leave(std::size_t at, std::deque<Job*>::iterator job) {
  Lane& lane = lanes_[at];
  lane.waiting.erase(job), --lane.others;
  if (!lane.waiting.empty()) lane.waiting.front()->changed.notify_one();
}

// Marks the threads that overstay, and lowers their priority. Other threads take their places.
void MultilevelQueue::look_for_late(std::size_t at) {
  const auto now = Clock::now();
  for (Worker& w : lanes_[at].workers) {
    if (w.late || !w.since || now - *w.since < patience_[at]) continue;
    w.late = true;
    ::setpriority(PRIO_PROCESS, static_cast<id_t>(w.id), terms.back().nice);
  }
}

// Returns true if the lane has a worker for the job, now or later. Starts one if needed.
bool MultilevelQueue::staffed(std::size_t at) {
  std::list<Worker>& workers = lanes_[at].workers;
  std::erase_if(workers, [](Worker& w) {
    if (w.ended) w.thread.join();
    return w.ended;
  });
  const auto number_of = [&](const auto& which) {
    return static_cast<std::size_t>(std::count_if(workers.begin(), workers.end(), which));
  };
  const std::size_t in_time = number_of([](const Worker& w) { return !w.late; });
  const std::size_t idle = number_of([](const Worker& w) { return !w.late && !w.since; });
  if (idle > lanes_[at].waiting.size() || in_time >= side_by_side || workers.size() >= most_workers) return true;
  Worker& w = workers.emplace_back();
  try {
    w.thread = std::thread([this, at, &w] { serve(at, w); });
  } catch (const std::system_error&) {
    workers.pop_back();
    return in_time > 0;
  }
  return true;
}

void MultilevelQueue::serve(std::size_t at, Worker& self) {
  std::unique_lock lock(mutex_);
  self.id = static_cast<int>(::syscall(SYS_gettid));
  ::setpriority(PRIO_PROCESS, static_cast<id_t>(self.id), terms[at].nice);
  Lane& lane = lanes_[at];
  while (!self.late) {
    lane.changed.wait(lock, [&] { return ended_ || !lane.waiting.empty(); });
    if (ended_) return;
    Job& job = *lane.waiting.front();
    leave(at, lane.waiting.begin());
    job.state = Job::State::runs;
    self.since = Clock::now();
    lock.unlock();
    const Job::State end = work(job, at);
    lock.lock();
    self.since.reset();
    job.state = end;
    job.changed.notify_one();
    memory_.soon();
  }
  self.ended = true;
}

MultilevelQueue::Job::State MultilevelQueue::work(Job& job, std::size_t lane) {
  const auto before = Cancellation::used();
  try {
    const Cancellation wanted(*job.gone, ended_, lanes_[lane].others, terms[lane].most);
    (*job.work)();
    job.used = Cancellation::used() - before;
  } catch (const Cancelled&) {
    job.used = Cancellation::used() - before;
    return Job::State::unfinished;
  } catch (...) {
    job.failed = std::current_exception();
  }
  return Job::State::done;
}

}  // namespace betwixt
