// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The workers of the quarantine: threads that answer questions for its maker.
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <new>
#include <system_error>

#include "base/cancellation.h"
#include "exchange/geometry.h"
#include "server/quarantine.h"

namespace betwixt {

static constexpr std::size_t all_workers = 10;

std::size_t Quarantine::busy_slow() {
  return static_cast<std::size_t>(
      std::count_if(workers_.begin(), workers_.end(), [](const auto& w) { return w->slow && !w->rests(); }));
}

// Returns nullptr if all are busy.
Quarantine::Worker* Quarantine::idle_worker() {
  for (const auto& w : workers_)
    if (w->rests()) return w.get();
  return nullptr;
}

// Starts all workers at once: a new thread may block on the process's memory lock, and later frames must not.
void Quarantine::engage() {
  if (!workers_.empty()) return;
  for (std::size_t i = 0; i < all_workers; ++i) {
    auto made = std::make_unique<Worker>();
    try {
      made->thread = std::thread([this, w = made.get()] { work(*w); });
    } catch (const std::system_error&) {
      return;
    }
    workers_.push_back(std::move(made));
  }
}

// Sets a worker's priority. A slow one ranks below hosts' lines, but only a little: a thread that hardly runs would
// keep the process's memory locked. If the system refuses to raise a priority again, it stays unchanged.
void Quarantine::step(const Worker& w) const {
  constexpr int slow_nice = 5;
  if (w.steps) ::setpriority(PRIO_PROCESS, static_cast<id_t>(w.id.load()), w.slow ? slow_nice : options_.nice);
}

void Quarantine::give(Worker& w, std::shared_ptr<Batch> batch) {
  ++batch->users;
  {
    const std::lock_guard lock(w.mutex);
    w.given.swap(batch), w.idle = false;
  }
  if (batch) batch->leave();  // the worker had not started it
  w.bell.signal();
}

void Quarantine::work(Worker& w) {
  w.id = static_cast<int>(::syscall(SYS_gettid));
  w.steps = options_.nice < 0 && ::setpriority(PRIO_PROCESS, static_cast<id_t>(w.id.load()), options_.nice) == 0;
  while (!over_) {
    w.bell.wait();
    std::shared_ptr<Batch> batch;
    {
      const std::lock_guard lock(w.mutex);
      w.at = std::move(w.given), batch = w.at;
      w.given.reset();
    }
    if (!batch) continue;
    step(w);
    serve(w, *batch);
    batch->leave();
    const bool late = (w.slow || batch->closed) && !batch->items.empty();
    {
      const std::lock_guard lock(w.mutex);
      w.at.reset(), w.idle = !w.given;
    }
    done_.signal();
    if (late && options_.heard) options_.heard();
  }
}

void Quarantine::serve(Worker& w, Batch& batch) {
  const std::size_t size = batch.items.size();
  for (std::size_t i; !over_ && (i = batch.next++) < size;) {
    Item& item = batch.items[i];
    w.item = i, w.begun = options_.now();
    const Nanos before = size == 1 ? Cancellation::used().count() : w.begun.load();
    work_out_item(item, batch);
    item.took = (size == 1 ? Cancellation::used().count() : options_.now()) - before;
    w.begun = 0;
    item.done = true;
    if (w.slow) return;  // the next worker takes the rest
  }
}

void Quarantine::work_out_item(Item& item, const Batch& batch) const {
  try {
    const Cancellation wanted(item.unwanted, over_, nobody_, {});
    item.answer = work_out(batch.program.compiled(), item.question, batch.time);
    Answer& a = item.answer;
    if (a.shape) a.mesh = a.toward ? realise_blend(*a.shape, *a.toward, a.blend).mesh : realise(*a.shape).mesh;
    item.answered = true;
  } catch (const Cancelled&) {
  } catch (const std::exception&) {  // out of memory: keeps the last answer
  }
}

}  // namespace betwixt
