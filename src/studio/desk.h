// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What all panels work at: a film and what is done to it, where its time is, what is selected. Everything that a hand
// does is a line of the language, which stands in the console, in the script and in the journal, and which one undo
// takes back.
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

#undef slots  // a word of Qt's that the scene has for itself

#include "betwixt/object.h"
#include "betwixt/program.h"
#include "betwixt/session.h"
#include "betwixt/track.h"
#include "studio/beside.h"
#include "studio/transport.h"

namespace betwixt::studio {

// An event that is selected.
struct EventAt {
  Target target;
  Time time;
  friend bool operator==(const EventAt&, const EventAt&) = default;
};

// As one word of a line.
std::string quoted_word(const std::string&);

class Desk : public QObject {
  Q_OBJECT
 public:
  explicit Desk(const LoadOptions& = {});
  ~Desk() override;

  // Who answers questions, "save, discard or stay?", with one of their words; none: nobody does, and nothing is lost.
  std::function<std::optional<std::string>(const std::string& question)> ask;
  // Goes on with a script; "": a new film. What is said stands in the console; false: nothing has changed.
  bool open(const QString& file, Session::Earlier = Session::Earlier::ask);
  // A new film has this text; nobody has said it.
  void begin_with(const std::string& text);
  // Looks whether somebody else has changed the file: what both changed is put together, or asked about.
  void look_at_file();
  Session& session() { return *session_; }
  const Session& session() const { return *session_; }

  // Where what takes long is done. While it does not hear, lines are not carried out.
  Beside& beside() { return beside_; }

  // What is shown: the film, or what it would be, while a hand is still moving something.
  const Document& document() const { return document_; }
  const Program& program() const { return program_; }
  bool looks_ahead() const { return ahead_; }

  // Carries lines out, several as one step. True where they were done; what is wrong with them is in the console, and
  // the last thing said is in `last_said`.
  bool say(const std::string& line);
  bool say(const std::vector<std::string>& lines);
  // Shows what lines would do while a hand moves something. Lines that cannot be carried out leave what is shown.
  bool look_ahead(const std::vector<std::string>& lines);
  void show_ahead(Document);  // the same, of what somebody else has worked out
  // Shows what another text would do; when typing rests it becomes one step.
  void retype(std::string text);
  void settle_typing();  // now
  void look_back();      // shows what there is
  void undo() { say(std::string("undo")); }
  void redo() { say(std::string("redo")); }
  const std::string& last_said() const { return last_said_; }
  // All lines that were carried out since the script was opened: said again, one after the other, they make the film.
  const std::vector<std::string>& session_lines() const { return lines_; }
  // The author's text with all that was done; with what is being typed. Its errors and warnings.
  const std::string& text() const { return text_; }
  const Diagnostics& diagnostics() const { return diagnostics_; }

  // Time. The playhead is where the picture is.
  Transport& transport() { return transport_; }
  const Transport& transport() const { return transport_; }
  Time time() const { return time_; }
  void go_to(Time);
  void step(int frames);     // on whole frames; stops
  void play(int direction);  // the direction it plays in already: stops
  void pause();
  // The part that is played; none: the film's own range.
  void set_range(std::optional<std::pair<Time, Time>>);
  double frames_shown() const { return shown_rate_; }  // a second, while it plays
  void picture_shown();                                // is told by whoever shows pictures

  // What is selected: objects, the last one leads; events.
  const std::vector<ObjectId>& selected() const { return selected_; }
  void select(std::vector<ObjectId>);
  const std::vector<EventAt>& events_selected() const { return events_; }
  void select_events(std::vector<EventAt>);
  // The line of the script that the cursor is in, 1…; 0: nowhere. Panels light up what it speaks of.
  int script_line() const { return script_line_; }
  void set_script_line(int);

  // How names and times stand in lines.
  std::string name(ObjectId id) const { return document_.name(id); }
  std::string when(Time t) const;  // "24f", or seconds between frames

 Q_SIGNALS:
  void opened();            // another script
  void named();             // the same one has another name
  void document_changed();  // or what is shown of it
  void text_changed();      // not while it is only looked ahead
  void time_changed();
  void playing_changed();
  void jumped();  // the playhead was put elsewhere
  void selection_changed();
  void script_line_changed();
  void said(const QString& line, const QString& answer, bool refused);
  void colors_changed();
  void wants_to_quit();  // "quit" was said and may be done

 private:
  void tick();
  void take_over();
  void know_file();
  Status play_part(const Document&, const std::string& frames);
  void show(Document);
  bool answer(const std::string& line, const Session::Answer&);
  // What the session answers, beside the window.
  template <class F>
  auto asked(F&& f);

  std::unique_ptr<Session> session_;
  Beside beside_;
  Document document_;
  Program program_;
  bool ahead_ = false;
  std::string text_, last_said_;
  std::vector<std::string> lines_;
  Diagnostics diagnostics_;
  QFileSystemWatcher watcher_;
  QTimer file_rests_;      // editors write in several goes
  std::string file_text_;  // what the file held when we last looked
  bool typing_ = false;    // text_ is not the session's
  QTimer typing_settles_, clock_;
  Transport transport_;
  std::optional<std::pair<Time, Time>> range_;
  Time time_;
  std::vector<ObjectId> selected_;
  std::vector<EventAt> events_;
  int script_line_ = 0;
  int shown_ = 0;
  double shown_rate_ = 0;
  Transport::Clock::time_point counted_since_;
};

}  // namespace betwixt::studio
