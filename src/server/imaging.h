// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The imaging server without its sockets and its clock: one document, any number of hosts, lines in, answers out. The
// caller passes the time with every line, so a test can choose any.
//
// Source: Animation Imaging Model 3.2, 3.3; 3.3.3 (its locks are one swapped pointer here); 4.1.2 (simulated time).
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

#include "base/kept_results.h"
#include "betwixt/contacts.h"
#include "betwixt/program.h"
#include "editor/checkpoint.h"
#include "editor/crash_recovery.h"
#include "editor/editor.h"
#include "editor/history.h"
#include "editor/said_line.h"
#include "editor/set_aside.h"
#include "server/ceilings.h"
#include "server/time_file.h"

namespace betwixt {

using Nanos = std::int64_t;  // of a monotonic clock

// Maps the clock to the document's time.
struct Transport {
  bool running = false;
  Nanos since = 0;  // running since this moment …
  Time at;          // … when the document's time was this
  Time time(Nanos now) const;
  Nanos when(Time) const;  // the first moment at which the document's time is `t`
  friend bool operator==(const Transport&, const Transport&) = default;
};

// A value whose evaluation has begun, or stopped, to take longer than a frame has.
struct SlowTurn {
  std::string target;
  bool slow = false;
  double late = 0;  // milliseconds of the film: the age of the shown value
};

// A frame that the screen has shown.
struct Shown {
  std::int64_t number = 0;  // at the server's rate; the frame at time 0 has number 1
  Time time;
  Nanos late = 0;
  std::vector<std::string> problems;
  std::vector<SlowTurn> turns = {};
};

class Imaging {
 public:
  enum class Claim : std::uint8_t { fair, first };
  struct Options {
    std::int64_t latency = 1;  // ticks from a command about environments to its effect
    Ceilings ceilings;
    UndoLimits undo{1000, 128 << 20};   // commands that can be undone, and the bytes kept for them
    std::size_t checkpoint = 16 << 20;  // bytes of log between two checkpoints
    bool sweep = false;                 // finds contacts between two frames, too (continuous detection)
    ContactOptions contacts;
    bool wait = false;        // the clock waits at 0 until a host sends `start`
    bool from_start = false;  // begins at time 0 instead of the history's time
    LoadOptions load;
    std::function<std::string()> stats;  // more members of the JSON object that `stats` returns
    // Runs work that may take long. Other lines can be entered before it ends. May start the work several times, unless
    // the claim is `first`: that work runs once, before all that waits. Returns false if the host has left. If empty,
    // all work is done at once.
    std::function<bool(const std::function<void()>&, Claim)> beside;
    // Frees large things on another thread. Without it, they are freed at once.
    std::function<void(std::shared_ptr<const void>)> discard;
    std::function<void(const std::string&)> warn;  // warns the user who runs the server
    CheckpointStep checkpoint_step;                // for tests
    // While others change the document, a line is tried three times and then they wait, if it takes no more processor
    // time than this; else it is tried twelve times.
    Nanos most_waited = 50'000'000;
  };
  using Host = std::uint64_t;
  struct Reply {
    std::string line;  // one line of JSON with its end; empty inside a bundle
    bool quit = false;
    bool later = false;  // not processed: enter the line again when waits() is false
  };
  static constexpr std::size_t longest_line = 1 << 20;  // bytes
  // Bytes of a line that begins with one of the server's own words.
  static constexpr std::size_t longest_question = 1 << 16;

  explicit Imaging(Options);

  // Starts with a script, or with an empty document if `file` is "". Keeps the history in the file `save` and a journal
  // beside it, unless `save` is "".
  Result<Diagnostics> begin(const std::string& file, const std::string& save, bool overwrite, Nanos now);

  Host arrive();
  void leave(Host);
  // Enters one line, with or without its end.
  Reply enter(Host, std::string_view line, Nanos now);
  // Returns true while one host has the document to itself: lines of others that change it must wait.
  bool waits() const { return alone_.has_value(); }
  // Returns how many bytes follow this line of the host, if it is a `send` that says so.
  std::optional<std::uint64_t> bytes_after(Host, std::string_view line) const;
  // Returns whether these bytes are wanted. If so, the caller passes them to receive() before it enters the line. If
  // not, it skips them and enters the line, which is then refused.
  bool wants_bytes(Host, std::string_view line);
  void receive(Host, std::string bytes);
  // Refuses a line that is too long to be read.
  Reply enter_too_long(Host, Nanos now);
  // Writes the time and every accepted command to the disk. On an error they may be lost, and the server must end.
  Status sync(Nanos now = 0);
  // Returns when sync() must run next because the time runs, or nullopt if it is paused or no history is kept.
  std::optional<Nanos> sync_again() const;
  // Writes the whole history into its file at the server's end. Errors: file, machine; then the journal still has it.
  Status finish(Nanos now = 0);

  void work_beside(decltype(Options::beside) how, decltype(Options::discard) discard = {}) {
    options_.beside = std::move(how), options_.discard = std::move(discard);
  }

  // An event for a subscribed host. Hosts share one text.
  struct Event {
    Host to = 0;
    std::shared_ptr<const std::string> line;
  };
  std::vector<Event> events() { return std::exchange(events_, {}); }
  void shown(const std::vector<Shown>&);    // in the order they were shown
  bool frames_wanted() const;               // a host has subscribed to events that come with frames
  std::string statistics(Nanos now) const;  // what `stats` answers: a JSON object

  const Document& document() const { return editor_.now().document; }
  Program program();   // compiles the document; other threads may change it during the call
  bool large() const;  // so large that compiling and freeing it takes long
  const Transport& transport() const { return transport_; }
  std::uint64_t version() const { return version_; }  // changes with the document and the transport
  std::string history() const { return as_script(editor_.base(), editor_.steps()); }
  std::int64_t tick(Nanos now) const;

 private:
  enum Topic : unsigned { changes = 1, notes = 2, frames = 4, contacts = 8, slow = 16 };
  struct BundleLine {
    std::int64_t number = 0;  // of its line
    std::string text;
    bool alone = false;  // a single word
    bool open = false;   // the command continues on the next line
  };
  struct HostState {
    Host host = 0;
    std::int64_t line = 0;
    std::shared_ptr<const OpenSheet> sheet;  // the open sheet that takes the host's rows; null if none is open
    std::string open;                        // the first lines of an unfinished command
    int open_lines = 0;
    int attempts = 0;            // tries for its current line …
    Nanos took = 0;              // … and the processor time of the last one
    KeptResults::Store results;  // … and the results that they share
    bool bundling = false, leaving = false;
    std::vector<BundleLine> bundle;
    std::size_t bundle_size = 0;
    std::optional<Error> bundle_broken;
    unsigned topics = 0;
    std::size_t promised = 0;         // bytes that it is about to send
    std::optional<std::string> sent;  // the bytes of its `send`
  };
  // A bundle's commands, carried out on a copy.
  struct Together;
  // A command carried out on a copy, and its answer.
  struct CommandOutcome {
    CommandResult result;
    std::size_t events = 0;  // in the document after it
    std::size_t values = 0;  // bytes of them, an upper bound
    std::size_t bytes = 0;   // kept for undo
    std::vector<std::string> warnings;
    bool kept = true;  // false if it only opens a sheet, so the history does not need it
  };
  struct Word {
    std::string_view word, usage, sentence;
    std::size_t most;  // maximum number of words after it
    Result<std::string> (Imaging::*run)(HostState&, const std::vector<std::string>&, Nanos);  // null for undo and redo
    std::string_view more = {};  // the last lines of its help
    Did step = Did::command;     // undo or redo
  };
  static std::span<const Word> words();
  static const Word* find_word(std::string_view);
  static bool starts_show(std::string_view verb);  // starts a paused clock

  // `from` holds the sheet that takes the host's rows.
  Result<CommandOutcome> carry_out(const Point& from, std::size_t events, std::string_view line,
                                   std::int64_t stamp) const;
  // Returns the first error, in words for hosts. Adds the warnings and notices before it to `warnings`.
  std::optional<Error> sort_out(const Diagnostics&, std::vector<std::string>& warnings) const;
  Reply enter_next(HostState&, std::string_view line, Nanos now);
  Reply enter_whole(HostState&, const SaidLine&, Nanos now);
  static const Word* word_of(const HostState&, const SaidLine&);
  static bool changes_document(const HostState&, std::string_view line);
  static bool ends_bundle(const HostState&, const SaidLine&);
  bool takes_long(const HostState&, const SaidLine&) const;
  bool speaks_of_many(std::string_view text) const;
  // Computes a result from the present document. If that may take long, other hosts can change the document first; then
  // the work is done again. After some tries other hosts must wait, but only if the work is short.
  // gone: the host has left; later: another host must not be disturbed; in_vain: the document changed during every try.
  enum class Worked { done, gone, later, in_vain };
  Reply not_worked(const HostState&, Worked, Nanos now);
  // `work` returns true if its result changes the document. A refusal or a question needs no second try: it holds for
  // the document that it was computed from.
  // values_in() returns the bytes of values in `after`, which adds `made` bytes to the document. Errors: range.
  Result<std::size_t> values_in(const Scene& after, std::size_t made) const;
  Worked work_out(HostState&, bool takes_long, const std::function<bool(const Point&, std::size_t events)>& work);
  class Alone;
  Reply command(HostState&, const SaidLine&, Nanos now);
  Reply step(HostState&, Did, Nanos now);
  Reply collect(HostState&, std::string_view line, Nanos now);
  void start_clock(Nanos now);
  Result<StoredHistory> gather(const std::string& from, bool goes_on, bool overwrite);
  Result<Diagnostics> begin_script(const StoredHistory&, bool goes_on, std::vector<SetAside>& aside);
  Status begin_steps(StepList, std::vector<SetAside>& aside);
  Status begin_history(const StoredHistory&, bool mended, bool less);
  Status begin_time(const StoredHistory&, bool goes_on, Nanos now);
  Status open_time();
  Status keep_time();
  std::size_t checkpoint_every() const;
  void go_on_with_checkpoint();
  Status go_over_to_checkpoint();
  void end_checkpoint(const Status&);
  void end_change();
  Reply end_bundle(HostState&, Nanos now);
  std::optional<Error> carry_out(const BundleLine&, Together&, std::int64_t stamp) const;
  // Answers a question from one version of the film. Other hosts can change the document in the meantime.
  class Film;
  Result<std::string> asked(const std::function<Result<std::string>(Film&)>& answer);
  std::optional<Result<std::string>> known_at_once(const std::vector<std::string>& words, Time now);
  Reply yes(const HostState&, Nanos now, std::string members, std::optional<std::int64_t> tick = {});
  Reply no(const HostState&, Nanos now, const Error&, const std::string& members = {});
  void tell_all(Topic, const std::function<std::string()>& what);  // calls `what` once, if a host subscribed
  void tell(const Shown&);
  void tell_contacts(const Shown&);
  void recount(const Document& before);
  void changed(Host by, const std::string& commands, Nanos now);  // `commands` is JSON
  void keep_program(Program, std::uint64_t version);
  template <class T>
  void discard(T gone) {
    if (options_.discard) options_.discard(std::make_shared<const T>(std::move(gone)));
  }
  std::int64_t stamp(Nanos now) const { return tick(now) + options_.latency; }

  Result<std::string> eval(HostState&, const std::vector<std::string>&, Nanos);
  Result<std::string> look(HostState&, const std::vector<std::string>&, Nanos);
  Result<std::string> help(HostState&, const std::vector<std::string>&, Nanos);
  Result<std::string> time(HostState&, const std::vector<std::string>&, Nanos);
  Result<std::string> stats(HostState&, const std::vector<std::string>&, Nanos);
  Result<std::string> bundle(HostState&, const std::vector<std::string>&, Nanos);
  Result<std::string> quit(HostState&, const std::vector<std::string>&, Nanos);
  Result<std::string> history_word(HostState&, const std::vector<std::string>&, Nanos);
  Result<std::string> subscribe(HostState&, const std::vector<std::string>&, Nanos);
  Result<std::string> unsubscribe(HostState&, const std::vector<std::string>&, Nanos);
  Result<std::string> start(HostState&, const std::vector<std::string>&, Nanos);
  Result<std::string> pause(HostState&, const std::vector<std::string>&, Nanos);
  Result<std::string> go(HostState&, const std::vector<std::string>&, Nanos);
  Result<std::string> seek(HostState&, const std::vector<std::string>&, Nanos);
  Result<std::string> save(HostState&, const std::vector<std::string>&, Nanos);
  Result<std::string> names(HostState&, const std::vector<std::string>&, Nanos);
  Result<std::string> set_aside_word(HostState&, const std::vector<std::string>&, Nanos);
  Result<std::string> end(HostState&, const std::vector<std::string>&, Nanos);
  Result<std::string> send(HostState&, const std::vector<std::string>&, Nanos);
  Result<std::string> not_for_hosts(HostState&, const std::vector<std::string>&, Nanos);

  Options options_;
  std::string name_, save_;
  LoadOptions author_;  // rights of the script's author
  Editor editor_;
  History history_;
  std::optional<Checkpoint> checkpoint_;  // while one is written
  std::size_t checkpoint_at_ = 0;         // bytes of log
  std::set<std::int64_t> names_given_;    // thousands of numbers that the script already uses for names
  std::int64_t next_names_ = 1;
  std::size_t event_count_ = 0;         // in the document
  std::atomic<std::size_t> values_{0};  // bytes of them, an upper bound
  std::atomic<std::size_t> making_{0};  // bytes made by commands in progress
  struct Overview {                     // the text of `help`, valid until new words are defined
    decltype(Scene::defined) defined;
    decltype(Scene::procedures) procedures;
    std::string text;
  };
  std::optional<Overview> overview_;
  Transport transport_;
  Nanos latest_ = 0;  // the latest moment passed by a caller
  std::optional<TimeFile> time_file_;
  Transport kept_transport_;  // the transport that the file holds …
  KeptTime kept_time_;        // … and its time, ahead of the present one while the clock runs
  std::uint64_t version_ = 1, compiled_ = 0;
  Program program_;
  bool long_to_compile_ = false;  // the last time
  std::optional<Host> alone_;     // the host that has the document to itself …
  std::set<Host> later_;          // … and the hosts that wait for that
  std::map<Host, HostState> hosts_;
  std::size_t promised_ = 0;  // bytes that hosts are about to send
  Host last_host_ = 0;
  std::deque<Shown> shown_;              // frames whose events have not been sent …
  bool telling_ = false;                 // … and whether a thread is sending them
  std::shared_ptr<ContactWatch> watch_;  // while a host has subscribed to contacts
  Time told_;                            // notes up to here have been sent
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
