// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The imaging server without its sockets and its clock: one document, any number of hosts, lines in, answers out. It
// is given the time with every line, so that it can be asked about any.
//
// Source: Animation Imaging Model 3.2, 3.3; 3.3.3 (its locks are a pointer here: R-E14); 4.1.2 (simulated time).
#pragma once

#include <atomic>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "betwixt/contacts.h"
#include "betwixt/program.h"
#include "editor/checkpoint.h"
#include "editor/editor.h"
#include "editor/history.h"
#include "editor/said_line.h"
#include "editor/set_aside.h"
#include "editor/trial.h"
#include "server/ceilings.h"
#include "server/time_file.h"

namespace betwixt {

using Nanos = std::int64_t;  // of a clock that only goes forward

// How the document's time goes with the clock.
struct Transport {
  bool running = false;
  Nanos since = 0;  // it has been running since then …
  Time at;          // … and was here
  Time time(Nanos now) const;
  Nanos when(Time) const;  // the first moment at which the document's time is this
  friend bool operator==(const Transport&, const Transport&) = default;
};

// A value of the film that has begun, or ceased, to take longer than frames have.
struct SlowTurn {
  std::string target;
  bool slow = false;
  double late = 0;  // milliseconds of the film: how old what is shown is
};

// A frame that was put where frames go.
struct Shown {
  std::int64_t number = 0;  // of the frame at the server's rate; the one at time 0 has number 1
  Time time;
  Nanos late = 0;
  std::vector<std::string> problems;
  std::vector<SlowTurn> turns = {};
};

class Imaging {
 public:
  enum class Claim : std::uint8_t { fair, first };
  struct Options {
    std::int64_t latency = 1;  // ticks: a command about environments takes effect so long after it came
    Ceilings ceilings;
    UndoDepth undo{1000, 128 << 20};    // commands that can be undone, and bytes that they hold
    std::size_t checkpoint = 16 << 20;  // bytes of log from one checkpoint to the next
    bool sweep = false;                 // what is fast is noticed even where it slips through between two frames
    ContactOptions contacts;
    bool wait = false;        // the clock stands at 0 until a host says `start`
    bool from_start = false;  // time begins at 0, not where it was in the history
    LoadOptions load;
    std::function<std::string()> stats;  // members of a JSON object, of what stands around
    // Does work that may take long, and lets other lines be entered meanwhile; it may be begun several times over,
    // unless it is done first, before all that waits. False: who asked for it has gone. None: all is done at once.
    std::function<bool(const std::function<void()>&, Claim)> beside;
    // Frees large things on another thread. Without it, they are freed at once.
    std::function<void(std::shared_ptr<const void>)> discard;
    std::function<void(const std::string&)> warn;  // whoever runs the server
  };
  using Host = std::uint64_t;
  struct Reply {
    std::string line;  // one line of JSON with its end; empty inside a bundle
    bool quit = false;
    bool later = false;  // it was not looked at, and is to be entered again when nobody is waited for any more
  };
  static constexpr std::size_t longest_line = 1 << 20;      // bytes
  static constexpr std::size_t longest_question = 1 << 16;  // of a line that begins with a word of the server

  explicit Imaging(Options);

  // Begins with a script, "" without; keeps the history in a file and the journal beside it, "": does not.
  Result<Diagnostics> begin(const std::string& file, const std::string& save, bool overwrite, Nanos now);

  Host arrive();
  void leave(Host);
  // One line, with or without its end.
  Reply enter(Host, std::string_view line, Nanos now);
  // Somebody is being waited for: lines of others that change the document are for later.
  bool waits() const { return alone_.has_value(); }
  // A line that is too long to be looked at.
  Reply enter_too_long(Host, Nanos now);
  // Everything that was answered is on the disk, the time too. An error: it may not be, and the server must end.
  Status sync(Nanos now = 0);
  // When that must be done again, though nothing is said: the time goes on. None: it stands, or no history is kept.
  std::optional<Nanos> sync_again() const;
  // The server ends: the file is the whole history. Errors: file, machine; then the journal has it.
  Status finish(Nanos now = 0);

  void work_beside(decltype(Options::beside) how, decltype(Options::discard) discard = {}) {
    options_.beside = std::move(how), options_.discard = std::move(discard);
  }

  // An event for a host that subscribed. Hosts share one text.
  struct Event {
    Host to = 0;
    std::shared_ptr<const std::string> line;
  };
  std::vector<Event> events() { return std::exchange(events_, {}); }
  void shown(const std::vector<Shown>&);  // in their order
  bool frames_wanted() const;             // a host has subscribed to something that frames tell

  const Document& document() const { return editor_.now().document; }
  Program program();   // of this document; it can change during the call
  bool large() const;  // so much that compiling and freeing it takes long
  const Transport& transport() const { return transport_; }
  std::uint64_t version() const { return version_; }  // another one: the document or the transport is another
  std::string history() const { return as_script(editor_.base(), editor_.steps()); }
  std::int64_t tick(Nanos now) const;

 private:
  enum Topic : unsigned { changes = 1, notes = 2, frames = 4, contacts = 8, slow = 16 };
  struct Bundled {
    std::int64_t number = 0;  // of the line
    std::string text;
    bool alone = false;  // a word by itself
    bool open = false;   // it goes on
  };
  struct Visitor {
    Host host = 0;
    std::int64_t line = 0;
    std::shared_ptr<const OpenSheet> sheet;  // that its rows go to; null: none is open
    std::string open;                        // lines of a command that is not whole yet
    int open_lines = 0;
    int attempts = 0;  // at its line, that were in vain …
    Nanos took = 0;    // … and what the last one took of a processor
    bool bundling = false, leaving = false;
    std::vector<Bundled> bundle;
    std::size_t bundle_size = 0;
    std::optional<Error> bundle_broken;
    unsigned topics = 0;
  };
  // Commands of a bundle, so far.
  struct Together;
  // A command on a copy, and what there is to say to a host.
  struct Carried {
    Deed deed;
    std::size_t events = 0;  // of the document after it
    std::size_t values = 0;  // bytes of them, at most
    std::size_t bytes = 0;   // that undo keeps for it
    std::string said;        // warnings
    bool kept = true;        // in the history: not what only opens a sheet
  };
  struct Word {
    std::string_view word, usage, sentence;
    std::size_t most;                                                                       // words behind it
    Result<std::string> (Imaging::*run)(Visitor&, const std::vector<std::string>&, Nanos);  // null: undo, redo
    std::string_view more = {};  // lines that its help ends with
    Did step = Did::command;     // back, or on again
  };
  static std::span<const Word> words();
  static const Word* find_word(std::string_view);
  static bool starts_show(std::string_view verb);  // a time that stands goes on with it

  // `from` has the sheet that the host's rows go to.
  Result<Carried> carry_out(const Point& from, std::size_t events, std::string_view line, std::int64_t stamp) const;
  Reply enter_next(Visitor&, std::string_view line, Nanos now);
  Reply enter_whole(Visitor&, const SaidLine&, Nanos now);
  static const Word* word_of(const Visitor&, const SaidLine&);
  static bool changes_document(const Visitor&, std::string_view line);
  static bool ends_bundle(const Visitor&, const SaidLine&);
  bool takes_long(const Visitor&, const SaidLine&) const;
  bool speaks_of_many(std::string_view text) const;
  // Works something out from how things are. Where that may take long others go on meanwhile, and it is worked out
  // again if the document is another one then; what would change that waits in the end, but only where it is short.
  // gone: nobody wants it any more; later: somebody else must not be disturbed; in_vain: the others never rested.
  enum class Worked { done, gone, later, in_vain };
  Reply not_worked(const Visitor&, Worked, Nanos now);
  // What is refused, or only asks, has changed nothing, and is right of the document that it was worked out from:
  // `work` says whether there is anything to lose.
  // Bytes of values in `after`, which adds `made` bytes to the document. Errors: range.
  Result<std::size_t> values_in(const Scene& after, std::size_t made) const;
  Worked work_out(Visitor&, bool takes_long, const std::function<bool(const Point&, std::size_t events)>& work);
  class Alone;
  Reply command(Visitor&, const SaidLine&, Nanos now);
  Reply step(Visitor&, Did, Nanos now);
  Reply collect(Visitor&, std::string_view line, Nanos now);
  void start_clock(Nanos now);
  Result<Kept> gather(const std::string& from, bool goes_on, bool overwrite);
  Result<Diagnostics> begin_script(const Kept&, bool goes_on, std::vector<SetAside>& aside);
  Status begin_steps(StepList, std::vector<SetAside>& aside);
  Status begin_history(const Kept&, bool mended, bool less);
  Status begin_time(const Kept&, bool goes_on, Nanos now);
  Status open_time();
  Status keep_time();
  std::size_t checkpoint_every() const;
  void take_checkpoint();
  Reply end_bundle(Visitor&, Nanos now);
  std::optional<Error> carry_out(const Bundled&, Together&, std::int64_t stamp) const;
  // Answers a question from one version of the film. Other hosts can change the document in the meantime.
  class Film;
  Result<std::string> asked(const std::function<Result<std::string>(Film&)>& answer);
  std::optional<Result<std::string>> known_at_once(const std::vector<std::string>& words, Time now);
  Reply yes(const Visitor&, Nanos now, std::string members, std::optional<std::int64_t> tick = {});
  Reply no(const Visitor&, Nanos now, const Error&, const std::string& members = {});
  void tell_all(Topic, const std::function<std::string()>& what);  // calls `what` once, if a host subscribed
  void tell(const Shown&);
  void tell_contacts(const Shown&);
  void recount(const Document& before);
  void changed(Host by, const std::string& commands, Nanos now);  // as JSON
  void keep_program(Program, std::uint64_t version);
  template <class T>
  void discard(T gone) {
    if (options_.discard) options_.discard(std::make_shared<const T>(std::move(gone)));
  }
  std::int64_t stamp(Nanos now) const { return tick(now) + options_.latency; }

  Result<std::string> eval(Visitor&, const std::vector<std::string>&, Nanos);
  Result<std::string> look(Visitor&, const std::vector<std::string>&, Nanos);
  Result<std::string> help(Visitor&, const std::vector<std::string>&, Nanos);
  Result<std::string> time(Visitor&, const std::vector<std::string>&, Nanos);
  Result<std::string> stats(Visitor&, const std::vector<std::string>&, Nanos);
  Result<std::string> bundle(Visitor&, const std::vector<std::string>&, Nanos);
  Result<std::string> quit(Visitor&, const std::vector<std::string>&, Nanos);
  Result<std::string> history_word(Visitor&, const std::vector<std::string>&, Nanos);
  Result<std::string> subscribe(Visitor&, const std::vector<std::string>&, Nanos);
  Result<std::string> unsubscribe(Visitor&, const std::vector<std::string>&, Nanos);
  Result<std::string> start(Visitor&, const std::vector<std::string>&, Nanos);
  Result<std::string> pause(Visitor&, const std::vector<std::string>&, Nanos);
  Result<std::string> go(Visitor&, const std::vector<std::string>&, Nanos);
  Result<std::string> seek(Visitor&, const std::vector<std::string>&, Nanos);
  Result<std::string> save(Visitor&, const std::vector<std::string>&, Nanos);
  Result<std::string> names(Visitor&, const std::vector<std::string>&, Nanos);
  Result<std::string> set_aside_word(Visitor&, const std::vector<std::string>&, Nanos);
  Result<std::string> end(Visitor&, const std::vector<std::string>&, Nanos);
  Result<std::string> not_for_hosts(Visitor&, const std::vector<std::string>&, Nanos);

  Options options_;
  std::string name_, save_;
  LoadOptions author_;  // what the script's author may
  Editor editor_;
  History history_;
  std::optional<Checkpoint> checkpoint_;  // while one is made
  std::size_t checkpoint_at_ = 0;         // bytes of log
  std::set<std::int64_t> names_given_;    // thousands of numbers that the script has names of
  std::int64_t next_names_ = 1;
  std::size_t event_count_ = 0;         // of the document
  std::atomic<std::size_t> values_{0};  // bytes of them, at most
  std::atomic<std::size_t> making_{0};  // by commands that are being worked out
  struct Overview {                     // what `help` says, as long as nobody adds words
    decltype(Scene::defined) defined;
    decltype(Scene::procedures) procedures;
    std::string text;
  };
  std::optional<Overview> overview_;
  Transport transport_;
  Nanos latest_ = 0;  // that somebody has said it is
  std::optional<TimeFile> time_file_;
  Transport kept_transport_;  // as that file has it …
  KeptTime kept_time_;        // … with a time that nobody has been told yet, while it goes on
  std::uint64_t version_ = 1, compiled_ = 0;
  Program program_;
  bool long_to_compile_ = false;  // it was, the last time
  std::optional<Host> alone_;     // who is waited for; 0: nobody's host …
  std::set<Host> later_;          // … and who waits
  std::map<Host, Visitor> hosts_;
  Host last_host_ = 0;
  std::deque<Shown> shown_;              // frames of which nobody has been told yet …
  bool telling_ = false;                 // … and somebody is at it
  std::shared_ptr<ContactWatch> watch_;  // while anybody wants to know
  Time told_;                            // notes up to here have been told
  std::vector<Event> events_;
  Nanos begun_ = 0;
  std::uint64_t lines_ = 0, commands_ = 0, refused_ = 0, bytes_ = 0;
};

// One version of the document, and its program, which is compiled at the first use.
class Imaging::Film {
 public:
  Film(Document document, Program before, bool newest)
      : document_(std::move(document)), program_(std::move(before)), compiled_(newest) {}
  const Document& document() const { return document_; }
  const Program& program() {
    if (!compiled_) program_ = Program::compile(document_, program_), compiled_ = true;
    return program_;
  }
  bool compiled() const { return compiled_; }

 private:
  const Document document_;
  Program program_;
  bool compiled_;
};

}  // namespace betwixt
