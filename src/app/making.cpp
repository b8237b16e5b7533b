// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "app/making.h"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include "app/command.h"
#include "base/counted.h"
#include "base/tell_user.h"
#include "base/work_progress.h"
#include "film/output.h"

namespace betwixt {
namespace {

// "1.9 s", "4 min 12 s", "2 h 05 min"
std::string duration(double seconds) {
  if (seconds < 60) return fmt::format("{:.1f} s", seconds);
  const int whole = static_cast<int>(std::min(seconds, 1e9));
  if (whole < 3600) return fmt::format("{} min {} s", whole / 60, whole % 60);
  return fmt::format("{} h {:02} min", whole / 3600, whole / 60 % 60);
}

// Shows the progress in one line on a terminal; prints nothing elsewhere.
class Bar {
 public:
  Bar(int frames, bool lines) : lines_(lines), shown_(lines || ::isatty(STDERR_FILENO) == 1), frames_(frames) {}
  ~Bar() { wipe(); }
  void show(int done, double seconds) {
    if (!shown_ || seconds < next_) return;
    next_ = seconds + 0.1;
    const double rate = seconds > 0 ? done / seconds : 0;
    if (lines_) return fmt::print(stderr, "{{\"done\":{},\"frames\":{},\"per_second\":{:.1f}}}\n", done, frames_, rate);
    std::string tail = fmt::format(" {}/{}", done, frames_);
    if (done == frames_) tail += "  finishing the file";
    if (done > 0 && done < frames_)
      tail += fmt::format("  {:.1f} frames/s  {} left", rate, duration((frames_ - done) / rate));
    draw(static_cast<double>(done) / frames_, tail);
  }
  // Of one picture. What lasts less than a second is not shown.
  void show_part(double part, double seconds) {
    if (!shown_ || seconds < std::max(next_, 1.0) || !(part > 0)) return;
    next_ = seconds + 0.1;
    draw(part, fmt::format(" {:.0f} %  {} left", 100 * part, duration(seconds * (1 - part) / part)));
  }
  void wipe() {
    if (drawn_) fmt::print(stderr, "\r\x1b[K");
    drawn_ = false;
  }

 private:
  void draw(double part, const std::string& tail) {
    const int wide = std::clamp(columns() - static_cast<int>(tail.size()) - 4, 0, 40);
    const int full = static_cast<int>(wide * part);
    fmt::print(stderr, "\r\x1b[K[{:#>{}}{: >{}}]{}", "", full, "", wide - full, tail);
    std::fflush(stderr);
    drawn_ = true;
  }
  static int columns() {
    winsize size{};
    return ::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
  }
  const bool lines_;  // for programs that read the output
  const bool shown_;
  const int frames_;
  double next_ = 0;
  bool drawn_ = false;
};

}  // namespace

Progress shown_progress(const FilmOptions& options, bool in_lines) {
  catch_stops();
  return [bar = std::make_shared<Bar>(options.frames, in_lines)](int done, int, double seconds) {
    bar->show(done, seconds);
    return !stop_requested();
  };
}

Status shown_picture(const std::function<Status()>& work) {
  if (::isatty(STDERR_FILENO) != 1) return work();
  const WorkProgress progress;
  const auto began = std::chrono::steady_clock::now();
  std::mutex mutex;
  std::condition_variable ended;
  bool over = false;
  std::thread watcher([&] {
    Bar bar(1, false);
    std::unique_lock lock(mutex);
    while (!ended.wait_for(lock, std::chrono::milliseconds(100), [&] { return over; }))
      bar.show_part(static_cast<double>(progress.share()),
                    std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count());
  });
  Status done = work();
  {
    const std::lock_guard lock(mutex);
    over = true;
  }
  ended.notify_one();
  watcher.join();
  return done;
}

void say_not_clear(const std::string& path) {
  tell_user(fmt::format(
      "betwixt: notice: {} has no transparency, so transparent parts are black; .webm, .mov and pictures have it\n",
      path));
}

int say_made(const Result<FilmStats>& made, const FilmOptions& options) {
  if (!made && stop_requested()) {
    tell_user(fmt::format("betwixt: stopped; {}\n",
                          options.only_missing
                              ? "the finished pictures are kept; run the same command again to continue"
                              : options.path + " was not made"));
    if (const auto place = read_output(options.path); place && !place->format && !options.only_missing)
      fmt::print(stderr, "  with --missing you can stop and continue later\n");
    return interrupted;
  }
  if (!made) return complain(made.error(), wrong_call);
  const int painted = made->frames - made->found;
  tell_user(fmt::format("{} in {}, {}", counted(painted, "frame"), duration(made->seconds), options.path));
  if (made->found > 0) fmt::print(stderr, "; {} already {} there", made->found, made->found == 1 ? "was" : "were");
  fmt::print(stderr, "\n");
  return all_done;
}

}  // namespace betwixt
