// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/shell/workspace.h"

#include <QDir>
#include <QFileInfo>
#include <algorithm>

#include "app/command.h"
#include "base/files.h"
#include "betwixt/language.h"
#include "editor/journal.h"
#include "editor/placing.h"
#include "scene/document.h"
#include "syntax/texts.h"

namespace betwixt::studio {
namespace {

constexpr int typing_settles_after = 1000;  // ms: text typed until then is one step in the journal
constexpr int file_rests_after = 150;       // ms
constexpr int ticks_a_second = 120;         // how often playback checks which frame is due

// "film.bx" of `"film.bx"`.
std::string word_in(std::string words) {
  QString word = QString::fromStdString(words).trimmed();
  if (word.size() > 1 && word.startsWith('"')) word = word.mid(1, word.size() - 2).replace("\\\"", "\"");
  return word.toStdString();
}

}  // namespace

Workspace::Workspace(const LoadOptions& options, const std::string& nameless_journal)
    : options_(options),
      nameless_journal_(nameless_journal.empty() ? journal_path("") : nameless_journal),
      program_(Program::compile(Document())) {
  make_session();
  typing_settles_.setSingleShot(true), typing_settles_.setInterval(typing_settles_after);
  clock_.setInterval(1000 / ticks_a_second), clock_.setTimerType(Qt::PreciseTimer);
  connect(&typing_settles_, &QTimer::timeout, this, &Workspace::settle_typing);
  file_rests_.setSingleShot(true), file_rests_.setInterval(file_rests_after);
  connect(&watcher_, &QFileSystemWatcher::fileChanged, &file_rests_, qOverload<>(&QTimer::start));
  connect(&watcher_, &QFileSystemWatcher::directoryChanged, &file_rests_, qOverload<>(&QTimer::start));
  connect(&file_rests_, &QTimer::timeout, this, &Workspace::look_at_file);
  connect(&clock_, &QTimer::timeout, this, &Workspace::tick);
}
Workspace::~Workspace() = default;

void Workspace::make_session() {
  Session::Callbacks callbacks;
  callbacks.ask = [this](const Session::Question& question) {
    std::optional<std::string> said;
    jobs_.in_window([&] {
      if (ask) said = ask(question);
    });
    return said;
  };
  callbacks.ask_about_line = callbacks.ask;
  callbacks.play = [this](const Document& d, const std::string& frames) {
    Status done = Nothing{};
    jobs_.in_window([&] { done = play_part(d, frames); });
    return done;
  };
  callbacks.load_plugin = [](const std::string& file) { return use_plugin(file); };
  session_.reset();  // its journal is free for the next one
  session_ = std::make_unique<Session>(std::move(callbacks), options_);
  session_->keep_nameless_in(nameless_journal_);
  session_->edit_in_place();
}

std::string Workspace::journal_of(const std::string& file) const {
  return file.empty() ? nameless_journal_ : journal_path(file);
}

template <class F>
auto Workspace::asked(F&& f) {
  std::optional<decltype(f(*session_))> out;
  jobs_.carry_out([&] { out.emplace(f(*session_)); });
  return *std::move(out);
}

template <class F>
auto Workspace::tried(F&& f) {
  std::optional<decltype(f(*session_))> out;
  const bool done = jobs_.carry_out([&] { out.emplace(f(*session_)); }, true);
  if (!done) out.reset();
  return out;
}

Workspace::Left Workspace::leaving() const {
  const auto content = [](const std::string& name) {
    const auto there = read_whole(name);
    return there ? std::optional<std::string>(*there) : std::nullopt;
  };
  const std::string& file = session_->file();
  return {file, file.empty() ? std::nullopt : content(file), content(journal_of(file))};
}

// After a stop the session may be in the middle of a film. It begins again with the one that was open before: its
// journal has all its steps.
void Workspace::begin_again(const Left& left) {
  session_.reset();
  const auto now = read_whole(left.file);
  const bool same = left.file.empty() || (left.text && now && *now == *left.text);
  if (same && left.journal) (void)write_whole(journal_of(left.file), *left.journal, true);
  make_session();
  (void)asked([&](Session& s) { return s.open(left.file, Session::Earlier::recover); });
  take_over();
  know_file();
  emit said({}, tr("stopped; the film is as it was before"), false);
}

bool Workspace::open(const QString& file, Session::Earlier earlier) {
  if (!jobs_.hears()) return false;
  settle_typing();
  const Left before = leaving();
  opening_ = file.toStdString();
  const auto a = tried([&](Session& s) { return s.open(opening_, earlier); });
  if (!a) return begin_again(before), false;
  const bool done = answer({}, *a);
  if (!done) return false;
  selected_.clear(), events_.clear(), range_.reset(), script_line_ = 0, lines_.clear();
  emit selection_changed();  // before the other film comes: its objects have the numbers of the old ones
  leave_out(nullptr);
  take_over();
  know_file();
  pause();
  go_to(document_.range().first);
  emit opened();
  return true;
}

void Workspace::begin_with(const std::string& text) {
  if (!jobs_.hears()) return;
  (void)asked([&](Session& s) { return s.enter(Session::rewrite_line(1, 0, text)); });
  take_over();
}

// Stores an answer of the session and emits it.
bool Workspace::answer(const std::string& line, const Session::Answer& a) {
  last_said_ = a.said;
  if (a.done && !line.empty()) lines_.push_back(line);
  if (!line.empty() || !a.said.empty())
    emit said(QString::fromStdString(line), QString::fromStdString(a.said), a.refused);
  return a.done;
}

// Enters lines. The user may stop them, but not what only goes back or writes a file.
Session::Answer Workspace::entered(const std::string& lines, const std::function<Session::Answer(Session&)>& enter) {
  const std::string word = lines.substr(0, lines.find_first_of(" \n"));
  if (word == "undo" || word == "redo" || word == "save" || word == "quit") return asked(enter);
  const std::string text = session_->text();
  const std::optional<Left> left = word == "open" ? std::optional(leaving()) : std::nullopt;
  if (const auto a = tried(enter)) return *a;
  if (left) {
    begin_again(*left);
  } else if (session_->text() != text) {  // the step was done, and only what follows it was stopped
    (void)asked([&](Session& s) { return s.enter("undo"); });
  }
  return {false, false, false, tr("stopped; the film is as it was before").toStdString() + "\n"};
}

bool Workspace::say(const std::string& line) {
  if (!jobs_.hears()) return false;
  settle_typing();
  const std::string file = session_->file();
  if (line.starts_with("open ")) opening_ = word_in(line.substr(5));
  const Session::Answer a = entered(line, [&](Session& s) { return s.enter(line); });
  const bool done = answer(line, a), saved = line.starts_with("save"), other = file != session_->file();
  if (other && !saved) {  // the objects of the other film have the numbers of the old ones
    selected_.clear(), events_.clear(), range_.reset(), script_line_ = 0;
    emit selection_changed();
    leave_out(nullptr);
  }
  take_over();
  if (done && (saved || other)) know_file();
  if (other && !saved) pause(), go_to(document_.range().first);
  if (other) saved ? emit named() : emit opened();
  if (a.quit) emit wants_to_quit();
  return done;
}

bool Workspace::say(const std::vector<std::string>& lines) {
  if (lines.size() < 2) return !lines.empty() && say(lines[0]);
  if (!jobs_.hears()) return false;
  settle_typing();
  std::string all;
  for (const std::string& line : lines) all += (all.empty() ? "" : "\n") + line;
  const bool done = answer(all, entered(all, [&](Session& s) { return s.enter_together(lines); }));
  take_over();
  return done;
}

bool Workspace::look_ahead(const std::vector<std::string>& lines) {
  if (!jobs_.hears()) return false;
  Result<Document> next = asked([&](Session& s) { return s.look_ahead(lines); });
  if (!next) return false;
  ahead_ = true;
  show(*std::move(next));
  return true;
}

void Workspace::show_ahead(Document next) {
  if (!jobs_.hears()) return;
  ahead_ = true;
  show(std::move(next));
}

void Workspace::look_back() {
  if (ahead_ && jobs_.hears()) take_over();
}

// Watches the file for changes by other programs. Editors replace a file by another one, so its folder is watched too.
void Workspace::know_file() {
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

void Workspace::look_at_file() {
  if (!jobs_.hears()) return file_rests_.start();
  const auto theirs = read_whole(session_->file());
  if (!theirs || *theirs == file_text_) return;
  settle_typing();
  const std::string ours = session_->text();
  std::optional<std::string> both = merge(file_text_, ours, *theirs);
  if (!both && ask) {
    const auto chosen = ask({{}, "another program changed the same lines of the file", {"theirs", "ours", "both"}});
    // For "both", their text follows as comments, because two films in one script would be no film. The user merges
    // them.
    if (chosen && *chosen == "theirs") both = *theirs;
    if (chosen && *chosen == "both")
      both = ours + "\n# ---- the file, as another program changed it\n" + as_comment(*theirs);
  }
  if (both && *both != ours) {
    const LineChange c = change_between(ours, *both);
    say(Session::rewrite_line(c.lines.first, c.lines.last, c.others));
  }
  if (const Status s = session_->go_on_from_file(); !s) emit said({}, QString::fromStdString(s.error().message), true);
  know_file();
  take_over();
}

Status Workspace::play_part(const Document& document, const std::string& frames) {
  if (!frames.empty()) {
    const auto part = read_frames(frames.find("..") == std::string::npos ? frames + ".." : frames, document, "play");
    if (!part) return part.error();
    set_range(std::pair(part->first, part->last));
    go_to(part->first);
  }
  if (!playhead_.playing()) QTimer::singleShot(0, this, [this] { play(1); });
  return Nothing{};
}

void Workspace::retype(std::string text) {
  constexpr int soon = 50;  // ms
  if (!jobs_.hears()) return QTimer::singleShot(soon, this, [this, text = std::move(text)] { retype(text); });
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

void Workspace::settle_typing() {
  if (!jobs_.hears()) return typing_settles_.start();
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

void Workspace::take_over() {
  ahead_ = false;
  text_ = session_->text(), diagnostics_ = session_->diagnostics();
  show(session_->document());
  emit text_changed();
}

void Workspace::show(Document next) {
  Program program = asked([&](Session&) { return Program::compile(next, program_); });
  document_ = std::move(next), program_ = std::move(program);
  const auto part = range_.value_or(document_.range());
  playhead_.set(document_.rate(), part.first, part.second);
  const auto gone = [&](ObjectId id) { return find_object(document_.scene(), id) == nullptr; };
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

void Workspace::select(std::vector<ObjectId> ids) {
  std::erase_if(ids, [&](ObjectId id) { return document_.name(id).empty(); });
  if (ids == selected_) return;
  selected_ = std::move(ids);
  emit selection_changed();
}

void Workspace::select_events(std::vector<EventAt> events) {
  if (events == events_) return;
  events_ = std::move(events);
  emit selection_changed();
}

void Workspace::leave_out(std::shared_ptr<const Marks> objects) {
  if (left_out_ == objects) return;
  left_out_ = std::move(objects);
  emit left_out_changed();
}

void Workspace::set_kept(std::vector<KeptAt> kept) {
  kept_ = std::move(kept);
  emit kept_changed();
}

void Workspace::set_makes_events(bool makes) {
  if (std::exchange(makes_events_, makes) != makes) emit makes_events_changed();
}

void Workspace::set_script_line(int line) {
  if (line == script_line_) return;
  script_line_ = line;
  emit script_line_changed();
}

std::string Workspace::when(Time t) const { return format_time(t, document_); }

}  // namespace betwixt::studio
