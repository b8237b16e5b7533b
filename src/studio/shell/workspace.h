// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The document that all panels share: the session with its film, the playhead and the selection. Each action of the
// user is a script line. It appears in the console, in the script and in the journal, and one undo takes it back.
#pragma once

#include <QFileSystemWatcher>
#include <QObject>
#include <QString>
#include <QTimer>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#undef slots  // a macro of Qt's; the scene has a member of that name

#include "betwixt/object.h"
#include "betwixt/program.h"
#include "betwixt/session.h"
#include "betwixt/track.h"
#include "playback/playhead.h"
#include "studio/shell/background_jobs.h"
#include "studio/shell/marks.h"

namespace betwixt::studio {

// A selected event.
struct EventAt {
  Target target;
  Time time;
  friend bool operator==(const EventAt&, const EventAt&) = default;
};

struct KeptAt {
  Time time;
  bool draft;
};

class Workspace : public QObject {
  Q_OBJECT
 public:
  // `nameless_journal` is that of a film without a file; "" is the one in the current folder.
  explicit Workspace(const LoadOptions& = {}, const std::string& nameless_journal = {});
  ~Workspace() override;

  // Answers a question with one of its choices. If it is empty or returns nullopt, there is no answer and nothing is
  // lost.
  std::function<std::optional<std::string>(const Session::Question&)> ask;
  // Opens a script; "" starts a new film. The answer appears in the console. Returns false if nothing has changed.
  bool open(const QString& file, Session::Earlier = Session::Earlier::ask);
  // Gives a new film this text, without a line in the console.
  void begin_with(const std::string& text);
  // Checks whether another program has changed the file. Merges both changes, and asks where they conflict.
  void look_at_file();
  // The script that is being opened, while the session asks about it.
  const std::string& opening() const { return opening_; }
  const std::string& nameless_journal() const { return nameless_journal_; }
  Session& session() { return *session_; }
  const Session& session() const { return *session_; }

  // Runs slow work. While its hears() is false the workspace carries out no lines.
  BackgroundJobs& jobs() { return jobs_; }

  // What the panels show: the film, or a preview of it during a drag.
  const Document& document() const { return document_; }
  const Program& program() const { return program_; }
  bool looks_ahead() const { return ahead_; }

  // Carries out lines; several make one undo step, and without any nothing happens. Returns whether that succeeded.
  // Errors appear in the console, and the last answer is in `last_said`.
  bool say(const std::string& line);
  bool say(const std::vector<std::string>& lines);
  // Shows a preview of lines during a drag. Returns false, and changes nothing, if the lines have errors.
  bool look_ahead(const std::vector<std::string>& lines);
  void show_ahead(Document);  // the same, for a document that the caller has computed
  // Shows a preview of another text. It becomes one undo step when typing pauses.
  void retype(std::string text);
  void settle_typing();  // makes the typed text a step now
  void look_back();      // ends the preview
  void undo() { say(std::string("undo")); }
  void redo() { say(std::string("redo")); }
  const std::string& last_said() const { return last_said_; }
  // Returns all lines carried out since the script was opened. Repeated in order, they make the same film.
  const std::vector<std::string>& session_lines() const { return lines_; }
  // Returns the author's text with all changes, including text that is still being typed, and its errors and warnings.
  const std::string& text() const { return text_; }
  const Diagnostics& diagnostics() const { return diagnostics_; }

  // Time. The picture shows the playhead's time.
  Playhead& playhead() { return playhead_; }
  const Playhead& playhead() const { return playhead_; }
  Time time() const { return time_; }
  void go_to(Time);
  void step(int frames);     // to whole frames; stops playback
  void play(int direction);  // stops if it already plays in this direction
  void pause();
  // Sets the part to play; nullopt: the film's own range.
  void set_range(std::optional<std::pair<Time, Time>>);
  double frames_shown() const { return shown_rate_; }  // pictures a second during playback
  void picture_shown();                                // the viewport calls this for each picture

  // The free view of the picture; nullopt: it shows what the film's camera sees. New cameras look from there.
  const std::optional<Camera>& view() const { return view_; }
  void set_view(const std::optional<Camera>& view) { view_ = view; }

  // Isolation: the objects that pictures leave out; null: none. It belongs to the view and changes no film.
  const std::shared_ptr<const Marks>& left_out() const { return left_out_; }
  void leave_out(std::shared_ptr<const Marks>);

  // The pictures that are kept in memory, in order of time.
  const std::vector<KeptAt>& kept() const { return kept_; }
  void set_kept(std::vector<KeptAt>);

  // Auto-key: every edit of a value makes an event at the playhead, in all panels.
  bool makes_events() const { return makes_events_; }
  void set_makes_events(bool);

  // The selection: objects, of which the last one leads, and events.
  const std::vector<ObjectId>& selected() const { return selected_; }
  void select(std::vector<ObjectId>);
  const std::vector<EventAt>& events_selected() const { return events_; }
  void select_events(std::vector<EventAt>);
  // The script line with the cursor, from 1; 0 if there is none. Panels highlight the objects and targets that it
  // names.
  int script_line() const { return script_line_; }
  void set_script_line(int);

  // Names and times as a script line writes them.
  std::string name(ObjectId id) const { return document_.name(id); }
  std::string when(Time t) const;  // "24f", or seconds between frames

 Q_SIGNALS:
  void opened();            // another script
  void named();             // the same script, with another name
  void document_changed();  // or its preview
  void text_changed();      // not for previews
  void time_changed();
  void playing_changed();
  void jumped();  // the playhead moved other than by playback
  void selection_changed();
  void script_line_changed();
  void left_out_changed();
  void kept_changed();
  void said(const QString& line, const QString& answer, bool refused);
  void colors_changed();
  void makes_events_changed();
  void wants_to_quit();  // after "quit", if it may happen

 private:
  void tick();
  void take_over();
  void know_file();
  Status play_part(const Document&, const std::string& frames);
  void show(Document);
  bool answer(const std::string& line, const Session::Answer&);
  Session::Answer entered(const std::string& lines, const std::function<Session::Answer(Session&)>& enter);
  // Calls the session on the worker thread and returns its answer.
  template <class F>
  auto asked(F&& f);
  // The same, but the user may stop it: then there is no answer.
  template <class F>
  auto tried(F&& f);
  void make_session();
  // The film that is open before another one is opened: its file and its journal.
  struct Left {
    std::string file;
    std::optional<std::string> text, journal;
  };
  Left leaving() const;
  void begin_again(const Left&);

  std::string journal_of(const std::string& file) const;

  const LoadOptions options_;
  const std::string nameless_journal_;
  std::unique_ptr<Session> session_;
  std::string opening_;
  BackgroundJobs jobs_;
  Document document_;
  Program program_;
  bool ahead_ = false;
  std::string text_, last_said_;
  std::vector<std::string> lines_;
  Diagnostics diagnostics_;
  QFileSystemWatcher watcher_;
  QTimer file_rests_;      // editors write in several steps
  std::string file_text_;  // the file's content when we last read it
  bool typing_ = false;    // text_ differs from the session's text
  QTimer typing_settles_, clock_;
  Playhead playhead_;
  std::optional<std::pair<Time, Time>> range_;
  Time time_;
  std::optional<Camera> view_;
  std::shared_ptr<const Marks> left_out_;
  std::vector<KeptAt> kept_;
  bool makes_events_ = false;
  std::vector<ObjectId> selected_;
  std::vector<EventAt> events_;
  int script_line_ = 0;
  int shown_ = 0;
  double shown_rate_ = 0;
  Playhead::Clock::time_point counted_since_;
};

}  // namespace betwixt::studio
