// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The script around a command: the text being read, the open sheet, the state, and the diagnostics.
#pragma once

#include <filesystem>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "betwixt/language.h"
#include "language/lines.h"
#include "language/translations.h"
#include "scene/document.h"
#include "scene/mentions.h"
#include "scene/sections.h"

namespace betwixt {

class PlaceFinder;

// The result of reading a pattern: the targets that it names, and the type of their values.
struct Selected {
  std::vector<Target> targets;
  const FunctionSpec* spec = nullptr;  // of the first; all have its type
  int component = -1;
  std::string_view text;
  bool velocity = false;
  Type type() const { return component < 0 ? spec->type : component_type(spec->type); }
};

// The destination of rows: the tracks of targets, or the versions of a display list.
struct Sheet {
  static constexpr std::size_t at_end = std::numeric_limits<std::size_t>::max();

  bool open = false, broken = false;
  Selected on;
  std::vector<Track*> tracks;  // where rows go directly: whole, unsplit tracks
  bool warned = false;
  bool fresh = false;            // the track had no events when the sheet was opened
  std::optional<Time> above;     // the time of the row before
  std::vector<Time> each_above;  // the same for each object, if they differ
  std::string opener;            // the line that opened it
  // For a display list:
  std::string list;
  struct Version {  // a version that receives the rows
    Time from;
    std::size_t next = at_end;                   // index of the next row; at_end: after all others
    bool passed_over = false;                    // it lacks the command that a row replaces
    std::optional<std::vector<Drawing>> nested;  // the commands left open at its end; nullopt: not known
  };
  std::vector<Version> versions;
  std::optional<Time> from;             // of an edit at a time
  std::string tag;                      // rows replace the commands that follow this tag
  std::string_view place;               // of its name
  std::vector<std::string_view> spots;  // of the commands that were read here, in the first version
  Cow<DisplayLists> before;
  Cow<LaterLists> later_before;
  bool changed = false;

  void breaks() { *this = {}, open = broken = true; }  // its rows are skipped without an error for each
};

// A sheet that stays open between lines, with the meaning of its names when it was left. While the names keep that
// meaning its rows go to the same place; otherwise its lines are read again.
struct OpenSheet {
  std::string opener;   // the lines that must precede the next row
  std::string pattern;  // that names its targets
  Sheet sheet;
  NameIndex names;
  Cow<OwnFunctions> defined;
  Cow<std::map<std::string, std::vector<std::string>, std::less<>>> aliases;
  Cow<DisplayLists> lists;
  Cow<LaterLists> later_lists;
};

// An open block: the commands that are indented below a line.
struct OpenBlock {
  std::size_t outer = 0;              // the indentation of the line that opens it
  std::optional<std::size_t> indent;  // that of its commands, after the first one
  bool skipped = false;               // its lines are passed over, because their opener has an error
  SectionClock clock;                 // of its times
  std::optional<std::size_t> grows;   // the section that ends with the latest time in the block
  std::string part;                   // that the lines belong to; "" for a block of commands
};

// The state that later lines need from earlier ones. It is a value, so that a copy of it serves undo.
struct ReaderState {
  bool frames_read = false, ticks_read = false;      // whether times have been given in these
  int included = 0;                                  // files
  std::size_t copied = 0;                            // events made by copying
  bool texts_shown = false;                          // texts that can be translated have been read
  std::shared_ptr<const Translations> translations;  // nullptr if texts stay as they are written
  std::shared_ptr<const OpenSheet> left;             // nullptr if no sheet is open
  std::vector<OpenBlock> blocks;                     // that later lines may continue; the innermost is the last

  // Returns the indentation of commands: deeper lines are rows.
  std::size_t margin() const { return blocks.empty() ? 0 : blocks.back().indent.value_or(blocks.back().outer); }
  bool goes_on(std::string_view line) const;  // whether the line is a row of the open sheet
  bool belongs(std::string_view line) const;  // whether the line is in an open block, or a row
  void close() { left.reset(), blocks.clear(); }
};

// What a script says of its sections, for a second reading if a section waits for one that is written below it.
struct SectionsAhead {
  struct Written {
    std::string name, after;  // `after`: the section that it waits for; may be empty
    bool timed = false;       // it begins at a time
  };
  std::vector<Section> known;                               // from the reading before
  std::vector<Written> written;                             // in this reading
  std::map<std::string, std::string, std::less<>> circles;  // sections that wait for themselves: "a after b after a"
  bool missing = false;                                     // a line speaks of a section that is not known yet
  bool whole = false;                                       // the text is the whole script, so it can be read again
  int readings = 0;                                         // before this one
};

// The location of a script, found once. `name`: of its file; may be empty.
struct Home {
  Home() = default;
  explicit Home(const std::string& name);
  std::string name;
  std::filesystem::path root;  // real path of its folder
  std::filesystem::path file;  // real path of the file, which it cannot `use`
};

struct Script : ReaderState {
  // Adds the plug-ins' words to the scene.
  Script(Scene&, Diagnostics&, const LoadOptions&);
  // For a live author: continues from `ReaderState`.
  Script(Scene&, Diagnostics&, const LoadOptions&, const ReaderState&, const Home&);

  Diagnostics& diagnostics;
  LoadOptions options;
  std::filesystem::path root;                     // real path of the first script's folder
  std::vector<std::filesystem::path> open_files;  // that use each other
  std::size_t files_at_home = 0;                  // of them, while a live line itself is read
  int depth = 0;                                  // depth of the author's commands that run other commands
  bool live = false;                              // lines come one by one
  bool whole = false;                             // a whole text is read, not one line of a live author
  std::set<std::string, std::less<>> lets_given;  // those of the options that the script has
  Source source;                                  // the text being read now
  std::filesystem::path folder;                   // of the source
  Sheet sheet;                                    // of the source
  SectionClock clock;                             // of the source: that of the block that uses it
  bool in_section = false;                        // a section's block uses the source
  Time latest;                                    // the latest time in the last text that was read
  SectionsAhead ahead;
  std::map<std::string, Diagnostic, std::less<>> section_places;
  SectionClock clock_now() const { return blocks.empty() ? clock : blocks.back().clock; }
  std::map<std::string, std::size_t, std::less<>> stems;  // names that have a color of the theme (theming.cpp)

  // Diagnostics that are reported at the end of the script if they still apply:
  std::map<std::pair<std::uint32_t, FunctionId>, Diagnostic> velocities;  // at the first mention of each
  struct Release {
    Target target;
    Time time;
    Diagnostic idle;  // reported if no velocity is in effect
  };
  std::vector<Release> releases;
  struct Fall {
    ObjectId object;
    Time time;
    Mat4 to_world;  // the transformation of its parents at that time; with `origin` and `speed` the input of the fall
    Vec3 origin, speed;
    Diagnostic turned;  // reported if the input has changed
  };
  std::vector<Fall> falls;
  std::map<std::pair<std::string, Time>, Diagnostic> unfinished;  // the incomplete display lists

  // Sheets of display lists that are finished but not expanded yet. Successive ones are expanded together.
  struct Unshown {
    Cow<DisplayLists> before;
    Cow<LaterLists> later_before;
    std::string_view place;
  };
  std::vector<Unshown> unshown;

  // Replacements that turn a line into its form for the history: with the time at which it came.
  struct Stamp {
    std::size_t at, length;  // the part of the line to replace
    std::string text;
  };
  std::vector<Stamp> stamps;
  bool spells_out = false;  // also replaces values that a policy has changed by the resulting values
  bool in_time = false;     // one of the stamps gives the time
  void respell(std::string_view place, std::string instead);
  void respell_live(std::string_view place, std::string instead);  // for a line of a live author
  bool in_line(std::string_view place) const;  // whether the place is in the line itself, not in what the line uses
  std::size_t touched = 0;     // the number of objects that the command's pattern named, if more than one
  const char* verb = nullptr;  // of the command that is being run
  void stamp(const Scene&, std::string_view place, std::string_view before, std::string_view behind);
  std::string stamped() const;

  // The current object of a command that runs once for each object that its pattern names.
  struct Only {
    ObjectId object;
    std::string name;  // of the object to create
    bool met = false;  // the pattern has been read
  };
  std::optional<Only> only;

  // Names that failed lines would have made. Errors of later lines that lack such a name are suppressed.
  std::set<std::string, std::less<>> failed;
  bool file_missing = false;  // a `use` line failed, so any name could have come from its file

  // speakers(): the objects that may refer to these. below(): all objects named below an object (man/arm and
  // man/arm/hand of man; with `drawn` also those drawn by display lists), in the order of creation.
  std::vector<std::uint32_t> speakers(const Scene&, const std::vector<ObjectId>&);
  std::vector<ObjectId> below(const Scene&, const std::string& name, bool drawn);

  // Opens a block below the command that begins there. skip_block(): one whose lines are passed over, unless the
  // command has opened one.
  OpenBlock& open_block(const char* command);
  void skip_block(const char* command);
  // Closes the blocks that a line of this indentation is not in. Returns whether it is indented less than the commands
  // of a block, but more than the line that opens the block.
  bool leave_blocks(std::size_t indent);

  PlaceFinder* watch = nullptr;  // observes each line; may be nullptr

  int errors = 0;
  bool given_up = false;  // there are too many errors; later ones are not reported

  void report(Severity, Error, std::string_view about);
  void note(Severity severity, std::string message, std::string_view about, Hint hint = {});
  // Adds a notice that a pattern matched nothing, unless a failed line would have made a name that it matches.
  void names_nothing(std::string_view pattern);

  // Returns the diagnostic to report later if it still applies, or nullopt if no more are reported.
  std::optional<Diagnostic> withheld(Severity severity, std::string message, std::string_view about);

  bool may_read(const std::filesystem::path&) const;
  // Returns the path for messages: relative to the first script's folder.
  std::string shown(const std::filesystem::path&) const;

 private:
  // Returns nullptr for the first few requests and for live lines: there, a look at all objects costs less than an
  // index.
  const Mentions* mentions(const Scene&);
  Mentions mentions_;
  std::size_t asked_ = 0;
};

// close_list() ends the rows of a display list and expands it where it is shown; show_list() expands it before they
// end.
void close_list(Scene&, Script&);
void show_list(Scene&, Script&);
// Expands all pending lists. Called before a diagnostic that may mention objects drawn by lists.
void show_lists(Scene&, Script&);
// Returns the lines that would have to precede the next row.
std::string opener(const Scene&, const Sheet&, std::size_t margin);
// ---- sections.cpp

// Returns the beginning or the end of a section, for lines that speak of it.
Result<Time> section_time(const Scene&, Script&, std::string_view name, bool end);
// The same, of these sections.
Result<Time> section_edge(const std::vector<Section>&, std::string_view name, bool end);
// Takes the latest time of a line of a section's block into the section.
void grow_section(Scene&, const Script&, Time latest);
// Reports sections that overlap, at the end of a script.
void say_overlaps(const Scene&, Script&);
// After a reading: what the next one needs to know. Returns false if no other one is needed, or if others do not help.
bool look_ahead(const Scene&, Script&, SectionsAhead& next);

// Returns the script's open sheet for later lines, or nullptr if none is open.
std::shared_ptr<const OpenSheet> left_open(const Scene&, const Script&);
// Reopens a sheet in the script, without the text of its target. Returns false if its names no longer mean the same.
bool go_on(Scene&, Script&, const OpenSheet&);
// Sets the tracks that receive rows directly.
void find_tracks(Scene&, Sheet&);
// Stores the lists if the sheet's list is shown, so that rows which make it too large can be dropped. A stored state
// makes the next change copy the names of all lists.
void keep_shown(const Scene&, Sheet&);
// Report, at the end of the script: events masked by velocities, releases that end nothing, incomplete lists, and falls
// that later lines have turned.
void say_masked_events(const Scene&, Script&);
void say_idle_releases(const Scene&, Script&);
void say_unfinished_lists(Script&);
void say_turned_falls(const Scene&, Script&);

}  // namespace betwixt
