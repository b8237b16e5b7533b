// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// betwixt present: shows a film as a talk. It plays from one step to the next, and waits there.
#include <fmt/format.h>
#include <poll.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <map>
#include <memory>

#include "app/command.h"
#include "app/hearing.h"
#include "app/presentation.h"
#include "app/speaker_page.h"
#include "app/stage_window.h"
#include "app/subcommand.h"
#include "base/counted.h"
#include "base/tell_user.h"
#include "playback/film_player.h"
#include "playback/playhead.h"

namespace betwixt {
namespace {

struct PresentCall {
  std::string file, frames, notes = "window", pdf;
  PictureCall picture{{.device = Device::automatic}};
  bool in_window = false, mute = false, stats = false, keep_old = false;
  int quality = 0;
};

using PresentClock = std::chrono::steady_clock;

class Talk {
 public:
  Talk(const Document& document, const PresentCall& call, const FrameList& frames)
      : program_(Program::compile(document)),
        call_(call),
        frames_(frames),
        stops_(stops_of(document, frames)),
        hearing_(Hearing::open(program_, frames, false)) {
    head_.set(frames.rate, Time{}, frames.rate.span(frames.count - 1));
    head_.loop(false);
  }

  Status run(const std::string& title) {
    auto stage = StageWindow::open(title, 1280, 720, !call_.in_window);
    if (!stage) return stage.error();
    stage_ = *std::move(stage);
    fills_ = !call_.in_window;
    if (call_.notes == "window") {
      auto speaker = StageWindow::open(title + " – notes", 1100, 720, false);
      if (!speaker) return speaker.error();
      speaker_ = *std::move(speaker);
    }
    go_to(0);
    while (!quit_ && !stop_requested()) {
      if (Status s = show(); !s) return s;
      if (Status s = show_notes(); !s) return s;
      if (head_.playing() || !prepare()) wait();
      listen();
      follow();
    }
    if (call_.stats) say_stats();
    return Nothing{};
  }

 private:
  int count() const { return static_cast<int>(stops_.size()); }
  // The playhead counts from the first frame.
  Time own(Time t) const { return t - frames_.time(0); }
  Time now() const { return frames_.time(0) + (head_.playing() ? std::min(head_.now(), own(target())) : head_.now()); }
  // Where the film waits next.
  Time target() const { return stops_[static_cast<std::size_t>(std::min(at_ + 1, count() - 1))].time; }
  Time here() const { return stops_[static_cast<std::size_t>(at_)].time; }

  void go_to(int stop) {
    at_ = std::clamp(stop, 0, count() - 1);
    head_.pause(), head_.go_to(own(here()));
    held_ = blank_ = false, noted_ = -1;
  }
  void press(StageKey key) {
    const bool on_the_way = head_.playing() || held_;
    if (key != StageKey::blank) blank_ = false;
    switch (key) {
      case StageKey::next:
        if (on_the_way) return go_to(at_ + 1);
        if (at_ + 1 == count()) return;
        // The first picture that differs, at once: the one of the step has been there.
        head_.go_to(std::min(own(here()) + frames_.rate.span(1), own(target()))), head_.play(1);
        return;
      case StageKey::previous:
        return go_to(on_the_way ? at_ : at_ - 1);
      case StageKey::first:
        return go_to(0);
      case StageKey::last:
        return go_to(count() - 1);
      case StageKey::blank:
        blank_ = !blank_;
        return;
      case StageKey::pause:
        if (head_.playing())
          head_.pause(), held_ = true;
        else if (held_)
          head_.play(1), held_ = false;
        return;
      case StageKey::fill:
        return stage_->fill_screen(fills_ = !fills_);
      case StageKey::quit:
        quit_ = true;
    }
  }
  void take(const StageWindow::Events& events) {
    for (const StageKey key : events.keys) {
      pressed_ = pressed_.value_or(PresentClock::now());
      press(key);
    }
    stale_ |= events.uncovered;
    quit_ |= events.closed;
  }
  void listen() {
    take(stage_->events());
    if (speaker_) take(speaker_->events());
  }
  // Waits at the next step.
  void follow() {
    if (head_.playing() && (head_.now() >= own(target()) || head_.ended())) {
      const bool blank = blank_;
      go_to(at_ + 1), blank_ = blank;
    }
    if (hearing_) hearing_->follow(program_, head_.place(), call_.mute);
  }
  void wait() {
    const double seconds = head_.playing() ? std::min(head_.until_next(), 0.05) : 0.1;
    std::array<pollfd, 2> all{pollfd{stage_->connection(), POLLIN, 0}, pollfd{-1, POLLIN, 0}};
    if (speaker_) all[1].fd = speaker_->connection();
    ::poll(all.data(), all.size(), std::max(1, static_cast<int>(1000 * seconds)));
  }

  RenderOptions options() const {
    RenderOptions o = call_.picture.of(program_.document());
    const auto [width, height] = stage_->size();
    const double scale = std::min(static_cast<double>(width) / o.width, static_cast<double>(height) / o.height);
    o.width = std::max(2, static_cast<int>(std::lround(o.width * scale)));
    o.height = std::max(2, static_cast<int>(std::lround(o.height * scale)));
    return o;
  }
  Status draw(Time t, Picture& out) {
    film_.evaluate(program_, t);
    return film_.draw(options(), out);
  }
  // Returns the picture of a step, from those that are kept.
  Result<const Picture*> still(int stop) {
    const RenderOptions o = options();
    Picture& kept = stills_[stop];
    if (kept.width != o.width || kept.height != o.height)
      if (Status s = draw(stops_[static_cast<std::size_t>(stop)].time, kept); !s) return s.error();
    return &kept;
  }
  // Draws the picture of a step that a key may ask for next. Returns false if all are there.
  bool prepare() {
    const RenderOptions o = options();
    std::erase_if(stills_, [&](const auto& one) {
      return one.first != 0 && one.first != count() - 1 && std::abs(one.first - at_) > 2;
    });
    for (const int stop : {at_ - 1, at_ + 1, at_, 0, count() - 1}) {
      if (stop < 0 || stop >= count()) continue;
      const auto there = stills_.find(stop);
      if (there != stills_.end() && there->second.width == o.width && there->second.height == o.height) continue;
      const auto drawn = still(stop);
      noted_ = -1;  // the notes show it
      return static_cast<bool>(drawn);
    }
    return false;
  }

  Status show() {
    const Time t = now();
    const bool same = shown_ == t && shown_blank_ == blank_ && shown_size_ == stage_->size() && !stale_;
    if (same && !pressed_) return Nothing{};
    if (!same) {
      const bool stands = !head_.playing() && !held_ && t == here();
      if (blank_) {
        const auto [width, height] = stage_->size();
        picture_ = {width, height, {}};
        picture_.rgba.resize(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
        stage_->show(picture_);
      } else if (stands) {
        const auto picture = still(at_);
        if (!picture) return picture.error();
        stage_->show(**picture);
      } else {
        if (Status s = draw(t, picture_); !s) return s;
        stage_->show(picture_);
      }
      shown_ = t, shown_blank_ = blank_, shown_size_ = stage_->size(), stale_ = false;
    }
    if (pressed_) {
      delays_.push_back(1000 * std::chrono::duration<double>(PresentClock::now() - *pressed_).count());
      pressed_.reset();
    }
    return Nothing{};
  }

  std::string clock() const {
    const auto seconds = static_cast<int>(Playhead::seconds_since(begun_));
    return fmt::format("{:02}:{:02}", seconds / 60, seconds % 60);
  }
  Status show_notes() {
    const Pause& stop = stops_[static_cast<std::size_t>(at_)];
    const std::string number = fmt::format("{} / {}", at_ + 1, count());
    if (call_.notes == "terminal") {
      if (noted_ == at_) return Nothing{};
      noted_ = at_;
      fmt::print("{}  {}  {}\n", clock(), number, stop.text);
      if (!stop.note.empty()) fmt::print("{}\n", in_lines(stop.note, 78));
      std::fflush(stdout);
      return Nothing{};
    }
    if (!speaker_ || (noted_ == at_ && noted_clock_ == clock() && noted_size_ == speaker_->size())) return Nothing{};
    noted_ = at_, noted_clock_ = clock(), noted_size_ = speaker_->size();
    const auto kept = [&](int k) { return stills_.contains(k) ? &stills_[k] : nullptr; };
    const auto [width, height] = speaker_->size();
    Picture page;
    if (Status s = page_.draw(
            {stop.text, stop.note, noted_clock_, number, kept(at_), at_ + 1 < count() ? kept(at_ + 1) : nullptr}, width,
            height, page);
        !s)
      return s;
    speaker_->show(page);
    return Nothing{};
  }

  void say_stats() {
    if (delays_.empty()) return;
    std::sort(delays_.begin(), delays_.end());
    tell_user(fmt::format("from key to picture: {} keys, median {:.1f} ms, at most {:.1f} ms; a frame is {:.1f} ms\n",
                          delays_.size(), delays_[delays_.size() / 2], delays_.back(),
                          1000 / frames_.rate.per_second()));
  }

  const Program program_;
  const PresentCall& call_;
  const FrameList frames_;
  const std::vector<Pause> stops_;
  const std::unique_ptr<Hearing> hearing_;  // null if the film has no sounds
  std::unique_ptr<StageWindow> stage_, speaker_;
  Playhead head_;
  int at_ = 0;  // the stop that was left last
  bool held_ = false, blank_ = false, fills_ = true, quit_ = false, stale_ = true;
  FilmPlayer film_;
  std::map<int, Picture> stills_;  // of stops
  Picture picture_;
  Time shown_ = earliest_time;
  bool shown_blank_ = false;
  std::pair<int, int> shown_size_;
  SpeakerPage page_;
  int noted_ = -1;
  std::string noted_clock_;
  std::pair<int, int> noted_size_;
  PresentClock::time_point begun_ = PresentClock::now();
  std::optional<PresentClock::time_point> pressed_;  // a key whose picture is not shown yet
  std::vector<double> delays_;                       // ms
};

int present(PresentCall& call) {
  const std::optional<Document> document = open_script(call.file);
  if (!document) return wrong_input;
  const Result<FrameList> frames = read_frames(call.frames, *document);
  if (!frames) return complain(frames.error(), wrong_call);
  if (document->pauses().empty())
    tell_user("betwixt: notice: this film has no steps, so it waits only at its end; write at 24f step \"…\"\n");
  catch_stops();
  if (!call.pdf.empty()) {
    const Result<int> pages = write_steps_as_pdf(Program::compile(*document), *frames, call.picture.of(*document),
                                                 call.quality, call.pdf, !call.keep_old);
    if (!pages) return complain(pages.error(), wrong_input);
    tell_user(fmt::format("{}, {}\n", counted(static_cast<std::size_t>(*pages), "page"), call.pdf));
    return all_done;
  }
  Talk talk(*document, call, *frames);
  if (const Status s = talk.run(std::filesystem::path(call.file).stem().string()); !s)
    return complain(s.error(), machine_failed);
  return stop_requested() ? interrupted : all_done;
}

const Enlisted enlisted_present(present, [](PresentCall& call) -> Subcommand {
  return {
      .rank = 31,
      .name = "present",
      .sentence = "shows a film as a talk: it plays from step to step, and waits at each",
      .takes = joined({{script_parameter(call.file),
                        frames_parameter(call.frames),
                        section_parameter(call.frames),
                        {.name = "--notes",
                         .value = "WHERE",
                         .sentence = "where the speaker's notes, the next picture and the clock are",
                         .into = &call.notes,
                         .words_only = true,
                         .words = {"window", "terminal", "off"}},
                        flag("--window", "does not fill the screen", call.in_window),
                        flag("--mute", "plays without sound", call.mute),
                        file_option("--pdf", "OUT.pdf", "writes a page for each step, and shows nothing", &call.pdf),
                        quality_parameter(call.quality, "the quality of the pages' pictures"),
                        flag("--no-overwrite", "keeps an existing file", call.keep_old),
                        flag("--stats", "prints at the end how long the pictures took after the keys", call.stats)},
                       picture_parameters(call.picture)}),
      .note =
          "Keys: right, down, space, page down and a click go on; if the film plays, they end the step at once. Left, "
          "up, backspace, page up and a right click go back to the step before. Home and end, b blanks the screen, p "
          "pauses, f fills the screen or not, q quits.",
      .example = "betwixt present examples/talk.bx --notes terminal",
      .manual =
          "A step is written `at 24f step \"The proof\" note=\"Ask who knows it\"` in the script. Without steps the "
          "film "
          "waits at its beginning and its end. The second window has the notes of the step, its picture, that of the "
          "next one, and the time since the beginning. It takes the same keys. `betwixt web --present` makes a page "
          "that does the same."};
});

}  // namespace
}  // namespace betwixt
