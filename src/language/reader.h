// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Carries out a text, command by command, on a scene. A command that cannot be carried out changes nothing and says
// why.
#pragma once

#include <filesystem>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "betwixt/language.h"
#include "language/plugins.h"
#include "language/values.h"
#include "track/operations.h"

namespace betwixt {

// A pattern that was read: which targets it names, and what their values are.
struct Selected {
  std::vector<Target> targets;
  const FunctionSpec* spec = nullptr;  // of the first; all have its type
  int component = -1;
  std::string_view text;
  bool velocity = false;
  Type type() const { return component < 0 ? spec->type : component_type(spec->type); }
};

// Where the dot between an object's name and its function is; dots inside braces ({1..100}) are not.
std::size_t first_dot(std::string_view word);

class Reader {
 public:
  Reader(Scene& scene, Diagnostics& out, const LoadOptions& options) : s(scene), diagnostics_(out), options_(options) {
    adopt_plugins(s);
  }

  // Reads a file or a text as if it stood where the author's script does. `root`: the folder that files are read below.
  void read_file(const std::string& path);
  void read_text(std::string_view text, const std::string& name);

  // One target pattern: for the command line too.
  bool targets(Cursor& c, std::string_view word, Selected& out, bool world_too = false);
  ValueReader values(Cursor& c);

  // What later lines must know of earlier ones: for a session, which gives every line to a reader of its own.
  struct Carried {
    bool frames_read = false, ticks_read = false;
    bool sheet_open = false;  // when the text ended
    int included = 0;
    std::size_t copied = 0;
    std::string sheet;  // the lines that must stand above the next row, where a sheet is open
  };
  Carried carried() const { return {rows_read_frames_, rows_read_ticks_, left_open_, included_, copied_, left_sheet_}; }
  // `script`: the file that the lines will be written to, and that they cannot `use`; may be empty.
  void carry(const Carried& from, const std::string& script);
  // Every verb and its usage.
  static std::vector<std::pair<std::string_view, std::string_view>> words();
  // The same of the rows of display lists.
  static std::vector<std::pair<std::string_view, std::string_view>> row_words();
  static constexpr std::size_t at_end = std::numeric_limits<std::size_t>::max();

  Scene& s;

 private:
  struct Verb {
    std::string_view word, usage;
    bool (Reader::*run)(Cursor&);
  };
  static const std::vector<Verb>& verbs();
  static std::string_view not_yet(std::string_view verb);

  // reader.cpp: lines, places, sheets
  void run(std::string_view text);
  void line(Cursor& c, const char* line_start);
  bool command(Cursor& c);
  bool finish(Cursor& c);  // nothing may follow
  bool open_sheet(Cursor& c, std::string_view word);
  bool row(Cursor& c);
  void report(Severity severity, Error error, std::string_view about);
  void note(Severity severity, std::string message, std::string_view about, std::string hint = {});
  const char* after_line(const char* line_start, bool* closed = nullptr) const;
  bool sound_text(std::string_view text);

  // events.cpp
  bool event(Cursor& c, const Selected& to, Time time);
  bool twerper(Cursor& c, const Selected& to, Twerper& out, std::array<double, 4>& bezier);
  bool way(Cursor& c, const Selected& to, Event& event);
  bool time_or_segment(Cursor& c, Time& from, std::optional<Time>& until);
  bool one_time_only(Cursor& c, std::string_view segment);
  bool tangent(Cursor& c, const Selected& to, std::string_view key, Event& event);
  bool rate_of_change(Cursor& c, const Selected& to, Value& out);
  bool computed(Cursor& c, const Selected& to, Value& out);
  bool put(const Selected& to, Event event, Cursor& c, std::string_view about);
  bool at(Cursor& c);
  bool set(Cursor& c);
  bool global_twerper(Cursor& c);
  bool extend(Cursor& c);
  bool note_command(Cursor& c);
  bool notes(Cursor& c);
  bool look(Cursor& c);
  bool show(Cursor& c) { return display(c, true); }
  bool hide(Cursor& c) { return display(c, false); }
  bool display(Cursor& c, bool on);

  // motions.cpp
  bool moving(Cursor& c, const Selected& to, Time from, std::optional<Time> until);
  void lasting(const Scene& before, const Selected& on, std::string_view about);
  // A copy that turned about the object itself turns about the one that it is copied to.
  static Track centred(Track track, const std::string& from, const std::string& to);
  // Motions about objects that are about to go keep the places.
  void keep_centres(const std::vector<ObjectId>& leaving, std::string_view about);

  // objects.cpp
  bool create(Cursor& c);
  bool parameters(Cursor& c, Object& object);
  bool parent_by_name(Cursor& c, const std::string& name, std::string_view about, ObjectId& parent);
  bool free_name(Cursor& c, const std::string& name, std::string_view about);
  bool objects(Cursor& c, std::string_view& word, std::vector<ObjectId>& out);
  bool own(Cursor& c, ObjectId id, std::string_view about);
  bool remove(Cursor& c);
  bool rename(Cursor& c);
  bool hang(Cursor& c) { return take_hold(c, Hold::hang, "on"); }
  bool attach(Cursor& c) { return take_hold(c, Hold::attach, "to"); }
  bool couple(Cursor& c) { return take_hold(c, Hold::couple, "to"); }
  bool detach(Cursor& c) { return let_loose(c, Hold::detach); }
  bool letgo(Cursor& c) { return let_loose(c, Hold::letgo); }
  bool take_hold(Cursor& c, Hold hold, std::string_view link);
  bool let_loose(Cursor& c, Hold hold);
  bool attachment(Cursor& c, const std::vector<ObjectId>& children, const Attachment&, std::optional<Time> time,
                  std::string_view about);
  bool alias(Cursor& c);
  bool define(Cursor& c);

  // extensions.cpp
  bool layer(Cursor& c);
  bool on_layer(Cursor& c);
  bool filter(Cursor& c);
  bool procedure(Cursor& c);
  bool own_command(Cursor& c, const NamedProcedure& p);
  bool dial(Cursor& c);
  bool record(Cursor& c);
  bool fall(Cursor& c);

  // lists.cpp
  struct Sheet;
  bool make_list(Cursor& c);
  bool edit_list(Cursor& c);
  bool delete_list(Cursor& c);
  bool start_list(Cursor& c);
  bool rename_list(Cursor& c);
  bool free_below(Cursor& c, const std::string& name, std::string_view about);
  bool list_name(Cursor& c, std::string_view& word);
  Time list_time() const { return timed_ ? time_ : from_the_beginning; }
  void open(std::string_view list);
  bool list_row(Cursor& c);
  bool tag(Cursor& c);
  bool replace(Cursor& c);
  bool drawing(Cursor& c, Drawing what, std::string_view about);
  bool callable(Cursor& c, const std::string& name);
  bool since(Cursor& c, DisplayCommand& command);
  std::vector<Drawing> nested(const DisplayList& list) const;
  bool in_order(Cursor& c, const DisplayCommand& command, std::string_view about);
  void close_list();
  std::string opener(const Sheet& sheet) const;
  void unfinished_lists();

  // environments.cpp
  bool animate(Cursor& c);
  bool halt(Cursor& c) { return to_environments(c, EnvironmentEvent::Halt{}); }
  bool kill(Cursor& c) { return to_environments(c, EnvironmentEvent::Kill{}); }
  bool cancel(Cursor& c) { return to_environments(c, EnvironmentEvent::Cancel{}); }
  bool to_environments(Cursor& c, const decltype(EnvironmentEvent::what)& what);
  bool add_to(Cursor& c, const std::vector<std::string>& names, const decltype(EnvironmentEvent::what)& what,
              std::string_view about);
  bool whole_ticks(Cursor& c, std::int64_t& out);
  std::int64_t tick() const;

  // settings.cpp
  bool rate(Cursor& c) { return rate_of(c, s.rate, c.frames_read, "frames"); }
  bool ticks(Cursor& c) { return rate_of(c, s.ticks, c.ticks_read, "ticks"); }
  bool rate_of(Cursor& c, Rate& rate, bool used, const char* what);
  bool range(Cursor& c);
  bool background(Cursor& c);
  bool policy(Cursor& c);
  bool use(Cursor& c);

  // operations.cpp
  struct Copying {
    Segment segment;
    Time start;
    std::optional<Value> shift;
    int times = 1;
  };
  Result<std::size_t> copy_track(const Scene& before, const Target& from, const Target& to, const Copying&);
  bool copy(Cursor& c);
  bool move(Cursor& c);
  bool stretch(Cursor& c);
  bool reverse(Cursor& c);
  bool scale(Cursor& c);
  bool translate(Cursor& c);
  bool rotate(Cursor& c);
  bool clear(Cursor& c);
  bool stagger(Cursor& c);
  bool spread(Cursor& c);
  template <class F>
  bool operate(Cursor& c, const Selected& on, std::string_view about, bool moves_times, F&& f, bool along = true);
  bool on_segment(Cursor& c, std::string_view& word, Selected& on, Segment& segment);
  bool operand(Cursor& c, const Selected& on, Value& out);

  // files.cpp
  bool asset(Cursor& c, FunctionId f, std::string& path, std::string_view about);
  bool may_read(const std::filesystem::path& path) const;
  std::string shown(const std::filesystem::path& path) const;

  struct Sheet {
    bool open = false, broken = false;
    Selected on;
    std::vector<Track*> tracks;  // where rows go directly: whole, unsplit tracks
    bool warned = false;
    bool fresh = false;  // the track had no events when the sheet was opened
    std::string opener;  // the line
    // Of a display list:
    std::string list;
    struct Version {  // that rows go to
      Time from;
      std::size_t next = at_end;                   // where the next row goes; at_end: behind all others
      bool passed_over = false;                    // it does not have what is replaced
      std::optional<std::vector<Drawing>> nested;  // what is open at its end, where that is known
    };
    std::vector<Version> versions;
    std::optional<Time> from;             // of an edit at a time
    std::string tag;                      // behind which rows replace others
    std::string_view place;               // of its name
    std::vector<std::string_view> spots;  // of the commands that were read here, in the first version
    Cow<DisplayLists> before;
    Cow<LaterLists> later_before;
    bool changed = false;
  };
  struct Source {  // the text being read now
    std::string_view text;
    std::string name;
    std::filesystem::path folder;
    const char* counted = nullptr;  // lines are counted up to here
    int lines = 1;
    Sheet sheet;
  };

  Diagnostics& diagnostics_;
  LoadOptions options_;
  std::filesystem::path root_;  // real path of the first script's folder
  std::vector<std::filesystem::path> open_files_;
  int included_ = 0;
  std::size_t copied_ = 0;  // events made by copying
  Source source_;
  void masked_events();  // what velocities keep from being seen, said when all is read …
  void idle_releases();  // … and which releases end nothing
  std::map<std::pair<std::uint32_t, FunctionId>, Diagnostic> velocities_;  // where each was first spoken of
  struct Release {
    Target target;
    Time time;
    Diagnostic idle;  // what to say where no velocity reigns
  };
  std::vector<Release> releases_;
  ObjectId layer_;         // the command is for this layer
  int commands_deep_ = 0;  // commands of the author's that run others
  bool timed_ = false;     // the command has an `at`
  Time time_;
  bool rows_read_frames_ = false, rows_read_ticks_ = false;
  bool left_open_ = false;  // a sheet, when the text ended
  std::string left_sheet_;
  bool live_ = false;                                              // lines come one by one
  std::map<std::pair<std::string, Time>, Diagnostic> unfinished_;  // display lists, and what is wrong with them
  int errors_ = 0;
  bool given_up_ = false;
};

}  // namespace betwixt
