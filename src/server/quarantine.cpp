// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "server/quarantine.h"

#include <fmt/format.h>
#include <pthread.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <map>
#include <new>
#include <system_error>
#include <tuple>

#include "base/cancellation.h"
#include "exchange/geometry.h"
#include "language/json.h"
#include "server/frame_clock.h"

namespace betwixt {
namespace {

constexpr std::size_t slow_workers = 2;  // workers that answer slow questions again
constexpr std::size_t kept_free = 3;     // workers reserved for values known to be quick
constexpr int quick_again = 3;           // quick answers in a row before a value leaves the quarantine
constexpr Nanos longest = 32;            // shares of elapsed time: four frames
constexpr std::size_t most_named = 20;   // values named in the statistics

Nanos processor_time(std::thread& thread) {
  clockid_t clock{};
  timespec t{};
  if (::pthread_getcpuclockid(thread.native_handle(), &clock) != 0 || ::clock_gettime(clock, &t) != 0) return 0;
  return static_cast<Nanos>(t.tv_sec) * 1'000'000'000 + t.tv_nsec;
}

}  // namespace

Quarantine::Quarantine(Options options) : options_(std::move(options)) {}

Quarantine::~Quarantine() {
  over_ = true;
  for (const auto& w : workers_) w->bell.signal();
  for (const auto& w : workers_) w->thread.join();
}

// ---- on the maker's thread

bool Quarantine::ask(const Program& program, Time t) {
  waited_ = 0;
  const Program::Compiled& c = program.compiled();
  if (!c.may_take_long()) return forget(), false;
  if (sources_.empty() || &program_.compiled() != &c) adopt(program);
  time_ = t, ++turn_;
  for (Source& s : sources_) {
    s.due = may_take_long(c, s.question, t);
    if (!s.due && s.pace == Pace::slow) set_pace(s, Pace::unknown);
  }
  for (const auto& w : workers_)  // it may still work on a question of an earlier frame
    if (overstays(*w)) w->slow ? find_slow(*w) : leave_behind(*w);
  const bool came = gather(), answered = ask_quick();
  ask_slow();
  count_late();
  return came || answered;
}

// A function of an object keeps its pace and its last answer in the next program. If the object was edited, or another
// one that its code has read, the maker does not compute it itself before a worker has answered again.
void Quarantine::adopt(const Program& program) {
  const Program::Compiled& c = program.compiled();
  const Scene& scene = c.document.scene();
  const Scene& old = sources_.empty() ? scene : program_.document().scene();
  const auto same_object = [&](std::uint32_t i) { return scene.objects.same(i, old.objects); };
  std::map<std::tuple<Question::What, std::uint32_t, FunctionId>, std::size_t> before;
  for (std::size_t i = 0; i < sources_.size(); ++i)
    before[{sources_[i].question.what, sources_[i].object, sources_[i].function}] = i;
  std::vector<Source> now;
  first_.fill(nobody);
  for (const Question& q : questions_of(c)) {
    if (q.index == 0) first_[q.what] = now.size();
    Source s;
    std::tie(s.object, s.function) = subject_of(c, q);
    const auto known = before.find({q.what, s.object, s.function});
    if (known != before.end()) {
      Source& was = sources_[known->second];
      const auto spec = [&](const Scene& in) -> const FunctionSpec& { return spec_of(in, s.function); };
      const bool alike = spec(old).name == spec(scene).name && spec(old).type == spec(scene).type;
      const bool same = q.what == Question::camera || (same_object(s.object) && scene.procedures.same(old.procedures));
      if (alike) {
        if (was.pending && !same) was.pending->items[was.item].unwanted = true, was.pending.reset();
        s = std::move(was);
        was.pending.reset();
        if (s.pending) s.pending->items[s.item].source = now.size();
        const auto& read = s.answer.read;
        s.edited = s.edited || !same || !std::all_of(read.begin(), read.end(), same_object);
      }
    }
    s.question = q, s.current = false;
    s.constant = q.what == Question::shape && c.drawables[c.slow_shapes[q.index]].shape < c.shapes.size();
    now.push_back(std::move(s));
  }
  for (Source& s : sources_)
    if (s.pending) s.pending->items[s.item].unwanted = true, s.pending->items[s.item].source = nobody;
  sources_ = std::move(now);
  engage();
  ++edition_;
  release(std::exchange(program_, program));
}

void Quarantine::forget() {
  if (sources_.empty()) return;
  for (Source& s : sources_)
    if (s.pending) s.pending->items[s.item].unwanted = true, s.pending->items[s.item].source = nobody;
  sources_.clear();
  release(std::exchange(program_, Program()));
  count_late();
}

// Gives the program to a worker, because freeing it may take long.
void Quarantine::release(Program program) {
  Worker* const w = idle_worker();
  if (!w) return;
  w->slow = true;
  const auto batch = std::make_shared<Batch>(std::move(program), Time{}, 0);
  give(*w, batch);
  batch->leave();
}

std::size_t Quarantine::place_of(const Question& q) const {
  return first_[q.what] == nobody ? nobody : first_[q.what] + q.index;
}

const Answer* Quarantine::answer(const Question& q) const {
  const std::size_t i = place_of(q);
  return i < sources_.size() && sources_[i].known ? &sources_[i].answer : nullptr;
}

bool Quarantine::quick(const Question& q) const {
  const std::size_t i = place_of(q);
  return i < sources_.size() && sources_[i].pace == Pace::quick && !sources_[i].edited;
}

// Takes the late answers that have arrived.
bool Quarantine::gather() {
  bool news = false;
  for (Source& s : sources_)
    if (s.pending && s.pending->items[s.item].done) {
      const auto batch = std::exchange(s.pending, nullptr);
      news = take(s, batch->items[s.item], *batch) || news;
    }
  return news;
}

bool Quarantine::take(Source& s, Item& item, const Batch& batch) {
  if (!item.answered) return false;
  s.answer = std::move(item.answer);
  s.known = true, s.at = batch.time, s.asked = turn_;
  s.current = item.edition == edition_;
  s.edited = s.edited && !s.current;
  s.streak = item.took <= options_.share ? s.streak + 1 : 0;
  const bool quick = s.pace == Pace::unknown ? item.took <= 2 * options_.share : s.streak >= quick_again;
  if (s.due && (s.pace == Pace::unknown || quick)) set_pace(s, quick ? Pace::quick : Pace::slow);
  return true;
}

std::shared_ptr<Quarantine::Batch> Quarantine::batch_of(const std::vector<std::size_t>& sources) {
  auto batch = std::make_shared<Batch>(program_, time_, sources.size());
  for (std::size_t i = 0; i < sources.size(); ++i) {
    batch->items[i].question = sources_[sources[i]].question, batch->items[i].source = sources[i];
    batch->items[i].edition = edition_;
  }
  return batch;
}

// Returns the questions to ask, the one with the oldest answer first. Those never answered or edited come last, because
// they may be slow.
std::vector<std::size_t> Quarantine::quick_ones() {
  std::vector<std::size_t> quick, unknown;
  const bool room = busy_slow() + kept_free < workers_.size();
  for (std::size_t i = 0; i < sources_.size(); ++i) {
    const Source& s = sources_[i];
    if (s.pending || s.pace == Pace::slow || answered(s)) continue;
    if (s.pace == Pace::quick && !s.edited)
      quick.push_back(i);
    else if (room || s.pace == Pace::quick)
      unknown.push_back(i);
  }
  if (std::exchange(left_out_, false)) {
    const auto earlier = [&](std::size_t a, std::size_t b) { return sources_[a].asked < sources_[b].asked; };
    std::stable_sort(quick.begin(), quick.end(), earlier), std::stable_sort(unknown.begin(), unknown.end(), earlier);
  }
  quick.insert(quick.end(), unknown.begin(), unknown.end());
  return quick;
}

bool Quarantine::ask_quick() {
  const std::vector<std::size_t> wanted = quick_ones();
  if (wanted.empty()) return false;
  const auto batch = batch_of(wanted);
  const Nanos begun = options_.now();
  await(batch);
  waited_ = options_.now() - begun;
  return close(batch);
}

// The next worker continues the batch of a worker that was left behind.
void Quarantine::await(const std::shared_ptr<Batch>& batch) {
  while (batch->next < batch->items.size()) {
    Worker* const w = idle_worker();
    if (!w) return;
    w->slow = false;
    give(*w, batch);
    while (!w->slow && !w->rests()) {
      const Nanos now = options_.now();
      if (overstays(*w))
        leave_behind(*w);
      else if (now >= until_)
        return;
      else
        done_.wait(monotonic_now() + std::clamp<Nanos>(until_ - now, 50'000, options_.share / 2));
    }
    if (!w->slow || busy_slow() + kept_free >= workers_.size()) return;
  }
}

// Returns true if the worker has used more than its share of processor time, or has waited too long for something.
bool Quarantine::overstays(Worker& w) {
  const Nanos begun = w.begun;
  if (begun == 0) return false;
  const Nanos time = options_.now() - begun;
  if (time <= options_.share) return false;
  const Nanos used = processor_time(w.thread);
  if (w.watched != begun) w.watched = begun, w.used = used;
  return time > longest * options_.share || used - w.used > options_.share;
}

void Quarantine::leave_behind(Worker& w) {
  w.slow = true;
  step(w);
  const std::lock_guard lock(w.mutex);
  if (w.given) w.given->leave(), w.given.reset(), w.idle = !w.at;
  if (!w.at || w.item >= w.at->items.size()) return;
  const std::size_t source = w.at->items[w.item].source;
  if (source < sources_.size()) set_pace(sources_[source], Pace::slow);
}

// On a busy machine the first question about a value may be asked in the background at once.
void Quarantine::find_slow(Worker& w) {
  const std::unique_lock lock(w.mutex, std::try_to_lock);  // the maker waits for no slow worker
  if (!lock || !w.at || w.item >= w.at->items.size()) return;
  const std::size_t source = w.at->items[w.item].source;
  if (source < sources_.size() && sources_[source].pace == Pace::unknown) set_pace(sources_[source], Pace::slow);
}

// Closes the batch and takes its answers. Questions already begun stay pending.
bool Quarantine::close(const std::shared_ptr<Batch>& batch) {
  batch->closed = true;
  const std::size_t size = batch->items.size(), begun = std::min(batch->next.exchange(size), size);
  bool any = false;
  left_out_ = begun < size;
  for (std::size_t i = 0; i < begun; ++i) {
    Source& s = sources_[batch->items[i].source];
    if (batch->items[i].done)
      any = take(s, batch->items[i], *batch) || any;
    else
      s.pending = batch, s.item = i;
  }
  batch->leave();
  return any;
}

void Quarantine::ask_slow() {
  std::vector<std::size_t> waiting;
  for (std::size_t i = 0; i < sources_.size(); ++i)
    if (const Source& s = sources_[i]; !s.pending && (late(s) || (s.pace == Pace::unknown && !answered(s))))
      waiting.push_back(i);
  if (waiting.empty()) return;
  std::stable_sort(waiting.begin(), waiting.end(),
                   [&](std::size_t a, std::size_t b) { return sources_[a].asked < sources_[b].asked; });
  for (const std::size_t i : waiting) {
    Worker* const w = busy_slow() < slow_workers ? idle_worker() : nullptr;
    if (!w) return;
    w->slow = true;
    Source& s = sources_[i];
    s.asked = turn_, s.item = 0, s.pending = batch_of({i});
    give(*w, s.pending);
    s.pending->leave();
  }
}

void Quarantine::set_pace(Source& s, Pace pace) {
  const bool told = s.question.what != Question::camera && (s.pace == Pace::slow) != (pace == Pace::slow);
  s.pace = pace;
  if (pace == Pace::slow) s.streak = 0;
  if (told) turns_.push_back({name(s), pace == Pace::slow, s.known ? 1000 * (time_ - s.at).seconds() : 0});
}

std::string Quarantine::name(const Source& s) const {
  const Document& film = program_.document();
  return s.question.what == Question::shape ? film.name(ObjectId{s.object})
                                            : film.name(Target{{s.object}, s.function, -1});
}

void Quarantine::count_late() {
  std::size_t slow = 0;
  std::string named_ones;
  std::size_t all = 0;
  for (Source& s : sources_) {
    if (!named(s) && s.frames == 0) continue;
    const bool is_late = named(s) && late(s);
    if (is_late) ++s.frames;
    if (named(s)) ++slow;
    if (++all > most_named) continue;
    named_ones += fmt::format("{}{{\"target\":{},\"late_ms\":{:.1f},\"frames\":{}}}", all > 1 ? "," : "",
                              json_text(name(s)), is_late && s.known ? 1000 * (time_ - s.at).seconds() : 0.0, s.frames);
  }
  const std::lock_guard lock(told_in_use_);
  told_ = fmt::format("\"quarantine\":{},\"quarantined\":[{}]", slow, named_ones);
}

std::string Quarantine::stats() const {
  const std::lock_guard lock(told_in_use_);
  return told_.empty() ? "\"quarantine\":0,\"quarantined\":[]" : told_;
}

std::vector<std::string> Quarantine::late() const {
  std::vector<std::string> all;
  for (const Source& s : sources_)
    if (named(s) && all.size() < most_named)
      all.push_back(fmt::format(
          "{} takes longer than a frame: it is computed in the background and shown when it is ready", name(s)));
  return all;
}

}  // namespace betwixt
