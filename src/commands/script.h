// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The script around a command: the text that is read, the sheet that is open, what has been read so far, and what there
// is to say.
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
#include "scene/document.h"
#include "scene/mentions.h"

namespace betwixt {

class Watch;

// A pattern that was read: which targets it names, and what their values are.
struct Selected {
  std::vector<Target> targets;
  const FunctionSpec* spec = nullptr;  // of the first; all have its type
  int component = -1;
  std::string_view text;
  bool velocity = false;
  Type type() const { return component < 0 ? spec->type : component_type(spec->type); }
};

// What rows go to: the tracks of targets, or the versions of a display list.
struct Sheet {
  static constexpr std::size_t at_end = std::numeric_limits<std::size_t>::max();

  bool open = false, broken = false;
  Selected on;
  std::vector<Track*> tracks;  // where rows go directly: whole, unsplit tracks
  bool warned = false;
  bool fresh = false;            // the track had no events when the sheet was opened
  std::optional<Time> above;     // when the row before was …
  std::vector<Time> each_above;  // … of each object, where that is not the same
  std::string opener;            // the line
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

  void breaks() { *this = {}, open = broken = true; }  // its rows are passed over, not complained about one by one
};

// A sheet that stays open between lines, and what names meant when it was left. As long as they mean that, its rows go
// where they went; otherwise its lines are read again.
struct OpenSheet {
  std::string opener;   // the lines that must stand above the next row
  std::string pattern;  // that names its targets
  Sheet sheet;
  NameIndex names;
  Cow<std::vector<FunctionSpec>> defined;
  Cow<std::map<std::string, std::vector<std::string>, std::less<>>> aliases;
  Cow<DisplayLists> lists;
  Cow<LaterLists> later_lists;
};

// What later lines must know of earlier ones: a value, so that keeping one is undo.
struct SoFar {
  bool frames_read = false, ticks_read = false;  // times have been given in these
  int included = 0;                              // files
  std::size_t copied = 0;                        // events made by copying
  std::shared_ptr<const OpenSheet> left;         // null: no sheet is open
};

// Where a script stands, found out once. `name`: of its file, may be empty.
struct Home {
  Home() = default;
  explicit Home(const std::string& name);
  std::string name;
  std::filesystem::path root;  // real path of its folder
  std::filesystem::path file;  // … of itself, which it cannot `use`
};

struct Script : SoFar {
  // What plug-ins brought becomes the scene's too.
  Script(Scene&, Diagnostics&, const LoadOptions&);
  // A live author's, which goes on.
  Script(Scene&, Diagnostics&, const LoadOptions&, const SoFar&, const Home&);

  Diagnostics& diagnostics;
  LoadOptions options;
  std::filesystem::path root;                     // real path of the first script's folder
  std::vector<std::filesystem::path> open_files;  // that use each other
  int depth = 0;                                  // of the author's commands that run others
  bool live = false;                              // lines come one by one
  Source source;                                  // the text being read now
  std::filesystem::path folder;                   // its
  Sheet sheet;                                    // its

  // Said when all is read, where it is still so then:
  std::map<std::pair<std::uint32_t, FunctionId>, Diagnostic> velocities;  // where each was first spoken of
  struct Release {
    Target target;
    Time time;
    Diagnostic idle;  // what to say where no velocity reigns
  };
  std::vector<Release> releases;
  struct Fall {
    ObjectId object;
    Time time;
    Mat4 to_world;  // what carried it then, and what of that it kept: it was worked out from these
    Vec3 origin, speed;
    Diagnostic turned;  // what to say where that is no longer so
  };
  std::vector<Fall> falls;
  std::map<std::pair<std::string, Time>, Diagnostic> unfinished;  // display lists, and what is wrong with them

  // Sheets of display lists that are over and not shown yet: those that follow each other are shown together.
  struct Unshown {
    Cow<DisplayLists> before;
    Cow<LaterLists> later_before;
    std::string_view place;
  };
  std::vector<Unshown> unshown;

  // How the line stands in a history, where it happens now: with the time at which it came.
  struct Stamp {
    std::size_t at, length;  // what of the line it stands in place of
    std::string text;
  };
  std::vector<Stamp> stamps;
  bool spells_out = false;  // what the policy made of values stands there too, as values that mean it
  bool in_time = false;     // one of them says when
  void respell(std::string_view place, std::string instead);
  void respell_live(std::string_view place, std::string instead);  // a line of a live author
  std::size_t touched = 0;     // how many the pattern of the command named, where that is more than one
  const char* verb = nullptr;  // of the command that is carried out
  void stamp(const Scene&, std::string_view place, std::string_view before, std::string_view behind);
  std::string stamped() const;

  // Of a command that is carried out once for each that its pattern names: which one it is about now.
  struct Only {
    ObjectId object;
    std::string name;  // of what is created
    bool met = false;  // the pattern has been read
  };
  std::optional<Only> only;

  // Names that lines would have made which were refused: what lines below lack then is said once.
  std::set<std::string, std::less<>> failed;
  bool file_missing = false;  // a line `use` was refused: any name may be what it would have made

  // Who may speak of these, and all that is named below an object (man/arm and man/arm/hand of man; `drawn`: what
  // display lists draw too), in the order of creation.
  std::vector<std::uint32_t> speakers(const Scene&, const std::vector<ObjectId>&);
  std::vector<ObjectId> below(const Scene&, const std::string& name, bool drawn);

  Watch* watch = nullptr;  // looks on, line by line; null: nobody does

  int errors = 0;
  bool given_up = false;  // there are so many that the rest is not said

  void report(Severity, Error, std::string_view about);
  void note(Severity severity, std::string message, std::string_view about, std::string hint = {});
  // A pattern has found nothing: a notice, unless what it could have found comes of a line that was refused.
  void names_nothing(std::string_view pattern);

  // The same to be said later, if it is still so then; none where nothing more is said.
  std::optional<Diagnostic> withheld(Severity severity, std::string message, std::string_view about);

  bool may_read(const std::filesystem::path&) const;
  // The path as people know it: relative to the first script's folder.
  std::string shown(const std::filesystem::path&) const;

 private:
  // Looking at all objects costs less for the first few lines that ask, and for those that come one by one.
  const Mentions* mentions(const Scene&);
  Mentions mentions_;
  std::size_t asked_ = 0;
};

// The rows of a display list are over: what shows it must show it as it is now.
void close_list(Scene&, Script&);
void show_list(Scene&, Script&);  // … while they go on
// Before anything is said that may speak of what lists draw.
void show_lists(Scene&, Script&);
// The lines that the next row would have to stand below.
std::string opener(const Scene&, const Sheet&);
// The sheet of a script, for the lines that are still to come; null: none is open.
std::shared_ptr<const OpenSheet> left_open(const Scene&, const Script&);
// Whether a sheet that was left open still means what it meant; then it is the script's.
bool go_on(Scene&, Script&, const OpenSheet&);
// Where rows go directly.
void find_tracks(Scene&, Sheet&);
// What is to be said when all is read: what velocities mask, releases that end nothing, lists that are not whole, falls
// that lines below have turned.
void say_masked_events(const Scene&, Script&);
void say_idle_releases(const Scene&, Script&);
void say_unfinished_lists(Script&);
void say_turned_falls(const Scene&, Script&);

}  // namespace betwixt
