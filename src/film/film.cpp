// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "betwixt/film.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <system_error>
#include <thread>

#include "base/cancellation.h"
#include "film/sink.h"

namespace betwixt {
namespace {

using Clock = std::chrono::steady_clock;
double since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

constexpr int largest_side = 8192, most_jobs = 256;
constexpr std::chrono::milliseconds wait_beat{50};

Status check(const FilmOptions& o) {
  if (o.frames < 1) return fail(ErrorCode::range, "a film needs at least one frame");
  if (o.width < 1 || o.height < 1 || o.width > largest_side || o.height > largest_side)
    return fail(ErrorCode::range,
                fmt::format("a picture of {}x{} is not possible: each side must have from 1 to {} pixels", o.width,
                            o.height, largest_side));
  if (o.rate.num < 1 || o.rate.den < 1) return fail(ErrorCode::range, "a film needs a rate above 0");
  if (o.bits != 8 && o.bits != 16) return fail(ErrorCode::range, "a channel of a PNG must have 8 or 16 bits");
  if (o.jobs < 0 || o.jobs > most_jobs)
    return fail(ErrorCode::range, fmt::format("the number of jobs must be from 1 to {}", most_jobs));
  return Nothing{};
}

// Software graphics use several cores for one picture, so a second painter would only slow down the first one and the
// encoder. Painters of numbered pictures also compress them, on one core; a second painter fills
// that time.
int jobs_of(const FilmOptions& o, bool pictures) {
  const int cores = static_cast<int>(std::thread::hardware_concurrency());
  const int suitable = std::clamp(pictures ? cores : cores / 4, 1, pictures ? 8 : 4);
  return std::min(o.frames, o.jobs > 0 ? o.jobs : suitable);
}

template <class Made>
Status check(const Made& p, const FilmOptions& o) {
  if (p.width == o.width && p.height == o.height &&
      p.rgba.size() == 4 * static_cast<std::size_t>(p.width) * static_cast<std::size_t>(p.height))
    return Nothing{};
  return fail(ErrorCode::range, fmt::format("a painter made a picture of {}x{} for a film of {}x{}", p.width, p.height,
                                            o.width, o.height));
}

// A painter of either kind, for parcels.
using Filler = std::function<Status(int k, Parcel&)>;
using NewFiller = std::function<Result<Filler>()>;
template <class Paints>
NewFiller filler(const FilmOptions& o, const std::function<Result<Paints>()>& new_painter) {
  return [&o, &new_painter]() -> Result<Filler> {
    Result<Paints> made = new_painter();
    if (!made) return made.error();
    return Filler([&o, painter = *std::move(made)](int k, Parcel& parcel) {
      auto& out = [&]() -> auto& {
        if constexpr (std::is_same_v<Paints, Painter>)
          return parcel.picture;
        else
          return parcel.linear;
      }
      ();
      const Status how = painter(k, out);
      return how ? check(out, o) : how;
    });
  };
}

// A pool of painters. Picture k goes through slot k mod the number of slots, so no more are in memory, and is taken out
// in the order of the film.
class Crew {
 public:
  Crew(const FilmOptions& o, int jobs, const NewFiller& new_filler, Sink& sink)
      : options_(o), new_filler_(new_filler), sink_(sink), slots_(2 * static_cast<std::size_t>(jobs)) {
    try {
      for (int j = 0; j < jobs; ++j) threads_.emplace_back([this] { work(); });
    } catch (const std::system_error& e) {  // continue with fewer
      if (threads_.empty())
        failed_early_ = fail(ErrorCode::machine, fmt::format("cannot start a thread: {}", e.what()));
    }
  }
  ~Crew() {
    {
      const std::lock_guard lock(mutex_);  // so that no thread goes to sleep between its check and its wait
      stop_ = true;
    }
    changed_.notify_all();
    for (std::thread& t : threads_) t.join();
  }

  // Waits for picture k; returns nullopt now and then if it is not finished.
  std::optional<Status> wait(int k) {
    std::unique_lock lock(mutex_);
    changed_.wait_for(lock, wait_beat, [&] { return slot(k).ready || failed_early_; });
    if (slot(k).ready) return slot(k).how;
    if (failed_early_) return Status(*failed_early_);
    return std::nullopt;
  }
  const Parcel& parcel(int k) { return slot(k).parcel; }
  void release(int k) {
    const std::lock_guard lock(mutex_);
    slot(k).ready = false;
    ++taken_;
    changed_.notify_all();
  }

  double painting() const { return painting_; }
  double packing() const { return packing_; }
  int found() const { return found_; }

 private:
  struct Slot {
    Parcel parcel;
    Status how = Nothing{};
    bool ready = false;
  };
  Slot& slot(int k) { return slots_[static_cast<std::size_t>(k) % slots_.size()]; }

  void work() {
    Result<Filler> filler = fail(ErrorCode::machine, "no painter");
    {
      // One at a time, while finished ones paint.
      const std::lock_guard lock(making_);
      filler = new_filler_();
    }
    if (!filler) {
      const std::lock_guard lock(mutex_);
      failed_early_ = filler.error();
      changed_.notify_all();
      return;
    }
    const Cancellation wanted(stop_, stop_, nobody_, {});
    while (const std::optional<int> k = next()) {
      Status how = paint(*filler, *k);
      const std::lock_guard lock(mutex_);
      if (!how) last_ = std::min(last_, *k);
      slot(*k).how = std::move(how);
      slot(*k).ready = true;
      changed_.notify_all();
    }
  }

  // Returns the next picture to paint, once there is room. After a failure only earlier pictures are useful.
  std::optional<int> next() {
    std::unique_lock lock(mutex_);
    const auto over = [&] { return stop_ || next_ >= options_.frames || next_ > last_; };
    changed_.wait(lock, [&] { return over() || next_ < taken_ + static_cast<int>(slots_.size()); });
    return over() ? std::nullopt : std::optional<int>(next_++);
  }

  Status paint(const Filler& filler, int k) {
    Parcel& parcel = slot(k).parcel;
    const auto start = Clock::now();
    if (sink_.stands(k)) {
      const std::lock_guard lock(mutex_);
      ++found_;
      return Nothing{};
    }
    Status how = Nothing{};
    try {
      how = filler(k, parcel);
    } catch (const Cancelled&) {  // in the middle of a picture that takes long
      how = stopped();
    }
    const double painted = since(start);
    if (how) how = sink_.pack(k, parcel);
    const std::lock_guard lock(mutex_);
    painting_ += painted;
    packing_ += since(start) - painted;
    return how;
  }

  const FilmOptions& options_;
  const NewFiller& new_filler_;
  Sink& sink_;
  std::vector<Slot> slots_;
  std::mutex mutex_, making_;
  std::condition_variable changed_;
  int next_ = 0, taken_ = 0, last_ = std::numeric_limits<int>::max();
  std::atomic<bool> stop_ = false;
  const std::atomic<int> nobody_ = 0;  // no one waits for a painter's place
  std::optional<Error> failed_early_;
  double painting_ = 0, packing_ = 0;
  int found_ = 0;  // pictures that existed
  std::vector<std::thread> threads_;
};

Result<FilmStats> make(const FilmOptions& options, const NewFiller& new_filler, const Progress& progress) {
  const auto start = Clock::now();
  if (Status s = check(options); !s) return s.error();
  Result<std::unique_ptr<Sink>> sink = make_sink(options);
  if (!sink) return sink.error();

  FilmStats stats;
  const KeepGoing keep_going = [&, told = start]() mutable {
    if (!progress || Clock::now() - told < wait_beat) return true;
    told = Clock::now();
    return progress(stats.frames, options.frames, since(start));
  };
  const auto encode = [&](const auto& what) {
    const auto begin = Clock::now();
    Status s = what();
    stats.encoding += since(begin);
    return s;
  };

  Crew crew(options, jobs_of(options, (*sink)->single_pictures()), new_filler, **sink);
  for (int k = 0; k < options.frames; ++k) {
    std::optional<Status> ready;
    while (!(ready = crew.wait(k)))
      if (!keep_going()) return stopped();
    if (!*ready) return ready->error();
    if (Status s = encode([&] { return (*sink)->take(crew.parcel(k), keep_going); }); !s) return s.error();
    crew.release(k);
    ++stats.frames;
    if (!keep_going()) return stopped();
  }
  if (Status s = encode([&] { return (*sink)->finish(keep_going); }); !s) return s.error();
  stats.seconds = since(start);
  stats.painting = crew.painting();
  stats.found = crew.found();
  stats.encoding += crew.packing();
  if (progress) progress(stats.frames, options.frames, stats.seconds);
  return stats;
}

}  // namespace

Result<FilmStats> make_film(const FilmOptions& options, const std::function<Result<Painter>()>& new_painter,
                            const Progress& progress) {
  return make(options, filler(options, new_painter), progress);
}

Result<FilmStats> make_linear_film(const FilmOptions& options,
                                   const std::function<Result<LinearPainter>()>& new_painter,
                                   const Progress& progress) {
  return make(options, filler(options, new_painter), progress);
}

}  // namespace betwixt
