// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "server/lanes.h"

#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <system_error>

#include "base/still_wanted.h"

namespace betwixt {

using namespace std::chrono_literals;

const std::array<Lanes::Terms, 4> Lanes::terms{{{5ms, 4}, {50ms, 9}, {1s, 14}, {0ms, 19}}};

Lanes::~Lanes() {
  end();
  for (std::thread& t : threads_) t.join();
}

void Lanes::end() {
  const std::lock_guard lock(mutex_);
  ended_ = true;
  for (Lane& lane : lanes_) {
    lane.changed.notify_all();
    for (Job* job : lane.waiting) job->changed.notify_one();
  }
}

void Lanes::look() {
  const std::lock_guard lock(mutex_);
  for (Lane& lane : lanes_)
    for (Job* job : lane.waiting)
      if (*job->gone) job->changed.notify_one();
}

bool Lanes::run(const std::function<void()>& work, const std::atomic<bool>& gone) {
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

// Waits its turn and for its end; or until nobody wants it any more.
void Lanes::enter(std::unique_lock<std::mutex>& lock, std::size_t lane, Job& job) {
  job.state = Job::State::waits;
  if (!staffed(lane)) {  // no thread is to be had: here, then
    lock.unlock();
    const Job::State end = work(job, lane);
    lock.lock();
    job.state = end;
    return;
  }
  std::deque<Job*>& waiting = lanes_[lane].waiting;
  waiting.push_back(&job), ++lanes_[lane].others;
  lanes_[lane].changed.notify_one();
  job.changed.wait(
      lock, [&] { return job.state > Job::State::runs || (job.state == Job::State::waits && (*job.gone || ended_)); });
  if (job.state != Job::State::waits) return;
  waiting.erase(std::find(waiting.begin(), waiting.end(), &job)), --lanes_[lane].others;
}

// There is somebody in the lane who works, sooner or later.
bool Lanes::staffed(std::size_t at) {
  Lane& lane = lanes_[at];
  if (lane.idle > lane.waiting.size() || lane.threads == side_by_side) return true;
  try {
    threads_.emplace_back([this, at] { serve(at); });
    ++lane.threads;
  } catch (const std::system_error&) {
  }
  return lane.threads > 0;
}

void Lanes::serve(std::size_t at) {
  ::setpriority(PRIO_PROCESS, static_cast<id_t>(::syscall(SYS_gettid)), terms[at].nice);
  Lane& lane = lanes_[at];
  std::unique_lock lock(mutex_);
  for (;;) {
    ++lane.idle;
    lane.changed.wait(lock, [&] { return ended_ || !lane.waiting.empty(); });
    --lane.idle;
    if (ended_) return;
    Job& job = *lane.waiting.front();
    lane.waiting.pop_front(), --lane.others;
    job.state = Job::State::runs;
    lock.unlock();
    const Job::State end = work(job, at);
    lock.lock();
    job.state = end;
    job.changed.notify_one();
    memory_.soon();
  }
}

Lanes::Job::State Lanes::work(Job& job, std::size_t lane) {
  const auto before = StillWanted::used();
  try {
    const StillWanted wanted(*job.gone, ended_, lanes_[lane].others, terms[lane].most);
    (*job.work)();
    job.used = StillWanted::used() - before;
  } catch (const NotWanted&) {
    job.used = StillWanted::used() - before;
    return Job::State::unfinished;
  } catch (...) {
    job.failed = std::current_exception();
  }
  return Job::State::done;
}

}  // namespace betwixt
