// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/desk.h"

#include <QDir>
#include <QFileInfo>
#include <algorithm>

#include "app/command.h"
#include "base/files.h"
#include "betwixt/language.h"
#include "editor/placing.h"

namespace betwixt::studio {
namespace {

// Turns each line into a comment.
std::string commented(const std::string& text) {
  std::string out = "# ";
  for (const char c : text) (out += c) += c == '\n' ? "# " : "";
  return out + "\n";
}

constexpr int typing_settles_after = 1000;  // ms: text typed until then is one step in the journal
constexpr int file_rests_after = 150;       // ms
constexpr int ticks_a_second = 120;         // how often playback checks which frame is due

}  // namespace

std::string quoted_word(const std::string& word) {
  return word.find_first_of(" \t,#") == std::string::npos ? word : "\"" + word + "\"";
}

Desk::Desk(const LoadOptions& options) : program_(Program::compile(Document())) {
  Session::Doors doors;
  doors.ask = [this](const std::string& question) {
    std::optional<std::string> said;
    beside_.in_window([&] {
      if (ask) said = ask(question);
    });
    return said;
  };
  doors.ask_about_line = doors.ask;
  doors.play = [this](const Document& d, const std::string& frames) {
    Status done = Nothing{};
    beside_.in_window([&] { done = play_part(d, frames); });
    return done;
  };
  doors.load = [](const std::string& file) { return use_plugin(file); };
  session_ = std::make_unique<Session>(std::move(doors), options);
  session_->keep_in_place();
  typing_settles_.setSingleShot(true), typing_settles_.setInterval(typing_settles_after);
  clock_.setInterval(1000 / ticks_a_second), clock_.setTimerType(Qt::PreciseTimer);
  connect(&typing_settles_, &QTimer::timeout, this, &Desk::settle_typing);
  file_rests_.setSingleShot(true), file_rests_.setInterval(file_rests_after);
  connect(&watcher_, &QFileSystemWatcher::fileChanged, &file_rests_, qOverload<>(&QTimer::start));
  connect(&watcher_, &QFileSystemWatcher::directoryChanged, &file_rests_, qOverload<>(&QTimer::start));
  connect(&file_rests_, &QTimer::timeout, this, &Desk::look_at_file);
  connect(&clock_, &QTimer::timeout, this, &Desk::tick);
}
Desk::~Desk() = default;

template <class F>
auto Desk::asked(F&& f) {
  std::optional<decltype(f(*session_))> out;
  beside_.carry_out([&] { out.emplace(f(*session_)); });
  return *std::move(out);
}

bool Desk::open(const QString& file, Session::Earlier earlier) {
  if (!beside_.hears()) return false;
  settle_typing();
  const Session::Answer a = asked([&](Session& s) { return s.open(file.toStdString(), earlier); });
  const bool done = answer({}, a);
  if (!done) return false;
  selected_.clear(), events_.clear(), range_.reset(), script_line_ = 0, lines_.clear();
  take_over();
  know_file();
  pause();
  go_to(document_.range().first);
  emit opened();
  emit selection_changed();
  return true;
}

void Desk::begin_with(const std::string& text) {
  if (!beside_.hears()) return;
  (void)asked([&](Session& s) { return s.enter(Session::rewrite_line(1, 0, text)); });
  take_over();
}

// Stores an answer of the session and emits it.
bool Desk::answer(const std::string& line, const Session::Answer& a) {
  last_said_ = a.said;
  if (a.done && !line.empty()) lines_.push_back(line);
  if (!line.empty() || !a.said.empty())
    emit said(QString::fromStdString(line), QString::fromStdString(a.said), a.refused);
  return a.done;
}

bool Desk::say(const std::string& line) {
  if (!beside_.hears()) return false;
  settle_typing();
  const std::string file = session_->file();
  const Session::Answer a = asked([&](Session& s) { return s.enter(line); });
  const bool done = answer(line, a);
  take_over();
  if (done && (line.starts_with("save") || file != session_->file())) know_file();
  if (file != session_->file()) line.starts_with("save") ? emit named() : emit opened();
  if (a.quit) emit wants_to_quit();
  return done;
}

bool Desk::say(const std::vector<std::string>& lines) {
  if (!beside_.hears()) return false;
  settle_typing();
  std::string all;
  for (const std::string& line : lines) all += (all.empty() ? "" : "\n") + line;
  const bool done = answer(all, asked([&](Session& s) { return s.enter_together(lines); }));
  take_over();
  return done;
}

bool Desk::look_ahead(const std::vector<std::string>& lines) {
  if (!beside_.hears()) return false;
  Result<Document> next = asked([&](Session& s) { return s.look_ahead(lines); });
  if (!next) return false;
  ahead_ = true;
  show(*std::move(next));
  return true;
}

void Desk::show_ahead(Document next) {
  if (!beside_.hears()) return;
  ahead_ = true;
  show(std::move(next));
}

void Desk::look_back() {
  if (ahead_ && beside_.hears()) take_over();
}

// Watches the file for changes by other programs. Editors replace a file by another one, so its folder is watched too.
void Desk::know_file() {
  const std::string& name = session_->file();
  const auto there = read_whole(name);
  file_text_ = there ? *there : "";
  if (!watcher_.files().isEmpty()) watcher_.removePaths(watcher_.files());
  if (!watcher_.directories().isEmpty()) watcher_.removePaths(watcher_.directories());
  if (name.empty()) return;
  const QFileInfo info(QString::fromStdString(name));
  if (info.exists()) watcher_.addPath(info.filePath());
  if (info.dir().exists()) watcher_.addPath(info.dir().path());
}

void Desk::look_at_file() {
  if (!beside_.hears()) return file_rests_.start();
  const auto theirs = read_whole(session_->file());
  if (!theirs || *theirs == file_text_) return;
  settle_typing();
  const std::string ours = session_->text();
  std::optional<std::string> both = merge(file_text_, ours, *theirs);
  if (!both && ask) {
    const auto chosen = ask("The file was changed by someone else, in the same lines as here: theirs, ours or both? ");
    // For "both", their text follows as comments, because two films in one script would be no film. The user merges
    // them.
    if (chosen && *chosen == "theirs") both = *theirs;
    if (chosen && *chosen == "both")
      both = ours + "\n# ---- the file, as someone else has changed it\n" + commented(*theirs);
  }
  if (both && *both != ours) {
    const LineChange c = change_between(ours, *both);
    say(Session::rewrite_line(c.lines.first, c.lines.last, c.others));
  }
  if (const Status s = session_->go_on_from_file(); !s) emit said({}, QString::fromStdString(s.error().message), true);
  know_file();
  take_over();
}

Status Desk::play_part(const Document& document, const std::string& frames) {
  if (!frames.empty()) {
    const auto part = read_frames(frames.find("..") == std::string::npos ? frames + ".." : frames, document, "play");
    if (!part) return part.error();
    set_range(std::pair(part->first, part->last));
    go_to(part->first);
  }
  if (!transport_.playing()) QTimer::singleShot(0, this, [this] { play(1); });
  return Nothing{};
}

void Desk::retype(std::string text) {
  constexpr int soon = 50;  // ms
  if (!beside_.hears()) return QTimer::singleShot(soon, this, [this, text = std::move(text)] { retype(text); });
  Loaded loaded = asked([&](Session& s) {
    const LineChange c = change_between(s.text(), text);
    return s.look_ahead(c.lines.first, c.lines.last, c.others);
  });
  typing_ = ahead_ = true;
  text_ = std::move(text), diagnostics_ = std::move(loaded.diagnostics);
  // Do not restart the timer at each key: a crash after long typing without a pause would lose it all.
  if (!typing_settles_.isActive()) typing_settles_.start();
  show(std::move(loaded.document));
}

void Desk::settle_typing() {
  if (!beside_.hears()) return typing_settles_.start();
  typing_settles_.stop();
  if (!std::exchange(typing_, false)) return;
  const std::string before = session_->text();
  if (before != text_) {
    const LineChange c = change_between(before, text_);
    const std::string line = Session::rewrite_line(c.lines.first, c.lines.last, c.others);
    answer(line, asked([&](Session& s) { return s.enter(line); }));
  }
  take_over();
}

void Desk::take_over() {
  ahead_ = false;
  text_ = session_->text(), diagnostics_ = session_->diagnostics();
  show(session_->document());
  emit text_changed();
}

void Desk::show(Document next) {
  Program program = asked([&](Session&) { return Program::compile(next, program_); });
  document_ = std::move(next), program_ = std::move(program);
  const auto part = range_.value_or(document_.range());
  transport_.set(document_.rate(), part.first, part.second);
  const auto gone = [&](ObjectId id) { return document_.name(id).empty(); };
  const std::size_t selected = selected_.size(), events = events_.size();
  std::erase_if(selected_, gone);
  if (!ahead_)
    std::erase_if(events_, [&](const EventAt& e) {
      bool there = false;
      if (!gone(e.target.object))
        each_event(document_, e.target, e.time, e.time, [&](const EventView&) { there = true; });
      return !there;
    });
  emit document_changed();
  if (selected != selected_.size() || events != events_.size()) emit selection_changed();
}

void Desk::tick() {
  const Time due = transport_.now();
  if (transport_.ended()) pause();
  if (due == time_) return;
  time_ = due;
  emit time_changed();
}

void Desk::go_to(Time t) {
  transport_.go_to(t);
  emit jumped();
  if (t == time_) return;
  time_ = t;
  emit time_changed();
}

void Desk::step(int frames) {
  pause();
  const Rate rate = document_.rate();
  const double frame = rate.frame_number(time_);
  go_to(rate.frame((frames > 0 ? std::floor(frame) : std::ceil(frame)) + frames));
}

void Desk::play(int direction) {
  if (transport_.direction() == direction) return pause();
  transport_.play(direction);
  shown_ = 0, shown_rate_ = 0, counted_since_ = Transport::Clock::now();
  clock_.start();
  tick();
  emit playing_changed();
}

void Desk::pause() {
  if (!transport_.playing()) return;
  transport_.pause();
  clock_.stop();
  emit playing_changed();
}

void Desk::set_range(std::optional<std::pair<Time, Time>> range) {
  range_ = range;
  const auto part = range_.value_or(document_.range());
  transport_.set(document_.rate(), part.first, part.second);
  emit playing_changed();
}

void Desk::picture_shown() {
  if (!transport_.playing()) return;
  ++shown_;
  const auto now = Transport::Clock::now();
  const double gone = std::chrono::duration<double>(now - counted_since_).count();
  if (gone < 0.5) return;
  shown_rate_ = shown_ / gone, shown_ = 0, counted_since_ = now;
  emit playing_changed();
}

void Desk::select(std::vector<ObjectId> ids) {
  std::erase_if(ids, [&](ObjectId id) { return document_.name(id).empty(); });
  if (ids == selected_) return;
  selected_ = std::move(ids);
  emit selection_changed();
}

void Desk::select_events(std::vector<EventAt> events) {
  if (events == events_) return;
  events_ = std::move(events);
  emit selection_changed();
}

void Desk::set_script_line(int line) {
  if (line == script_line_) return;
  script_line_ = line;
  emit script_line_changed();
}

std::string Desk::when(Time t) const { return format_time(t, document_); }

}  // namespace betwixt::studio
