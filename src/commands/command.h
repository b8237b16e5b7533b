// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// A command, and the helpers that the bodies of commands share. A body reads all its arguments before it changes
// anything. A body that fails reports one error at the cursor, changes nothing and returns false. The helpers stand
// below the names of their files.
#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "commands/script.h"
#include "exchange/scene_file.h"
#include "language/values.h"
#include "scene/rollback.h"
#include "track/operations.h"

namespace betwixt {

class ContentBytes;  // scene/memory.h

inline constexpr std::size_t most_objects = 1'000'000;  // a few words with braces can make many objects

struct Command {
  Scene& scene;
  Cursor& cursor;
  std::optional<Time> time;  // of `at TIME`
  ObjectId layer;            // of `on LAYER`
  Script& script;
};

// A verb: its syntax, its help, the prefixes that it allows, and its body.
struct Verb {
  enum : unsigned {
    timed = 1,         // `at TIME` may precede it
    layered = 2,       // `on LAYER` may precede it
    stamped = 4,       // without a time it takes effect now if the author is a live host (LoadOptions::now)
    opens_sheet = 8,   // the rows of its sheet follow it
    starts_show = 16,  // starts a live host's clock, from its present time
    once = 32,         // its setting holds for the whole film until it is set again
    aside = 64,        // its effect does not depend on the contents of tracks
    prefix = 128,      // a piece and another command follow it: `at TIME`, `on LAYER`
    quick = 256,       // changes little: no file is read, no code runs, no list is drawn
    // The word after it is a name that it makes:
    makes_thing = 512,       // of an object, a layer, an environment, a display list or an alias
    makes_let = 1024,        // of a value in formulas
    makes_function = 2048,   // of a function
    makes_procedure = 4096,  // of code
    makes_parts = 8192,      // of objects below the thing that the word names
    after_time = 32768,      // only after `at TIME`; without it, the word is one of the shell
    opens_block = 16384,     // the commands that are indented below it belong to it
    makes_kind = 32768,      // the word after it is a name of a kind that it makes
  };
  std::string_view word, usage, sentence;
  std::string_view example;  // lines that can be entered one after another
  unsigned flags;
  bool (*run)(Command&);
  // The words that can follow, for completion and colours: those of one place are separated by blanks, places by ';'.
  // "…" at the end repeats the last place. A word in capitals stands for many: see `argument_kinds` in
  // editor/completion.cpp. Names of objects can be at all places without words.
  std::string_view words = {};
};

// ---- reader.cpp

// Runs the command at the cursor: a verb, a command of the author's own, or a target that opens a sheet.
bool carry_out(Command&);
// Fails unless the line ends here.
bool finish(Cursor&);
// Reports that the word is not one of the allowed ones, and returns false. The error is of type if there is a word, of
// syntax if there is none.
bool no_choice(Cursor&, std::string_view word, std::string message, Hint hint = {});
// Reads `on` or `off` and the end of the line. For any other word the error is `otherwise`.
bool on_or_off(Cursor&, const char* otherwise, bool& out);
// Returns why the word cannot be a verb, or "" if there is no special reason.
std::string_view not_of_a_script(std::string_view word);
// Skips the rest of a command whose pattern names no target.
bool pass_over(Command&, const char* from);

// ---- blocks.cpp

// ---- places.cpp

// Returns the objects that a pattern names. If the command runs once for each of them, returns only the current one.
std::vector<ObjectId> named(Command&, std::string_view pattern);
// Runs a command or a row once; or, if its formulas mention their place (i, n, i1 …), once for each object that its
// pattern names. Either all runs succeed or nothing changes.
bool in_places(Command&, const std::function<bool()>& command);
bool in_places(Command&, const Selected& of_row, const std::function<bool(const Selected&)>& row);

// ---- targets.cpp

// The targets that a pattern may name. `alike`: functions with values of one type; targets of other types are left out.
// `named_alike`: one function, with values of any types. `any`: for commands that read no values. `asked`: for
// queries; also the query-only targets, and objects drawn by display lists.
enum class Meant : std::uint8_t { alike, named_alike, any, asked };
bool targets(Command&, std::string_view word, Selected& out, Meant = Meant::alike);
// Returns whether the values of all selected targets have one type.
bool alike(Command&, const Selected&);
// Reads the words after a target for all targets that it names, once for each type. Leaves out the targets that the
// words do not fit. Fails if they fit no target, or if they misfit one and types may be translated.
bool to_each_type(Command&, std::string_view word, const char* from, const std::function<bool(const Selected&)>& read);
// Runs the rest of a command for all selected targets, once for each type of value. Leaves out, and names in a notice,
// the targets for which the command has no meaning; fails if it has none for any of them. On any other error it changes
// nothing.
bool for_each_type(Command&, const Selected&, const std::function<bool(const Selected&)>& rest);
// Names, in a notice, the targets that a command leaves out.
void say_left_out(Command&, const std::vector<Target>&, std::string_view about, std::string why);

// ---- objects.cpp

// Reads one or more objects: an existing name, an alias, or a pattern (which may match nothing).
bool objects(Command&, std::string_view& word, std::vector<ObjectId>& out);
// Reads a word that can be a name. `kind` names the kind of name in errors ("function's name"). The name has none of
// the characters in `never`.
bool new_name(Cursor&, std::string_view& out, std::string_view kind, std::string_view never = {});
// Fails if the name is taken.
bool free_name(Command&, const std::string& name, std::string_view about);
// Fails if display lists draw the object, because only their rows can change it.
bool own(Command&, ObjectId, std::string_view about);
// Reads key=value … of a new object. `said` receives the functions that were set, `furniture` what its kind takes
// besides (see furnishing.h).
struct Furniture;
bool one_parameter(Command&, Object&, std::vector<FunctionId>* said = nullptr, Furniture* = nullptr,
                   std::string_view* styled = nullptr);
bool parameters(Command&, Object&, std::vector<FunctionId>* said = nullptr, Furniture* = nullptr);
// Adds an object, and couples it to its parent if it has one.
ObjectId add_child(Scene&, Object, ObjectId parent);

// ---- names.cpp

// Reads a number, an angle, a length, a time, a vector, a pair, a colour or a text.
bool let_item(Command&, LetItem& out);

// ---- scenes.cpp

// Runs the part of `create NAME scene` that follows the word `scene`.
bool create_scene(Command&, const std::vector<std::string>& names, const std::vector<ObjectId>& parents,
                  std::string_view about);

// ---- files.cpp

ValueReader values(Command&);
// Returns whether the script may read the file. Makes `path` relative to the first script's folder.
// Reads the pictures or meshes that code names in quotes, if `f` shows such files; "walk%03d.png" names all numbers.
bool files_in_code(Command&, FunctionId f, const std::string& source, std::string_view about);
bool may_use(Command&, std::string& path, std::string_view about, std::filesystem::path& where);
// Fails if the document would exceed the limit of MemoryBudget with these contents of files.
bool has_room(Command&, const ContentBytes&, std::string_view about);
// Stores the meshes of a file under its path and their own names. Fails if there is no room for them (MemoryBudget).
bool keep_meshes(Command&, const std::string& path, const SceneFile&, std::string_view about);
// Reads a file of a scene that the script may use.
Result<std::shared_ptr<const SceneFile>> scene_of_file(const Command&, const std::filesystem::path& where);

// ---- texts.cpp

// Reports if a text's font lacks letters in the look that results from this value and the other settings.
void say_missing_style(Command&, const Object&, FunctionId, const Value&, std::string_view about);
// Makes an object for each marked part of a formula that has none yet. Does nothing for other functions.
bool make_parts(Command&, ObjectId, FunctionId, const Value&, std::string_view about);

// ---- events.cpp

// Reads = "…": a value that code computes.
bool computed(Command&, const Selected& to, Value& out);
// Reads TIME, or A..B where a motion may follow.
bool time_or_segment(Cursor&, Time& from, std::optional<Time>& until);
bool one_time_only(Cursor&, std::string_view segment);
// Fails if the target is the geometry of an object that cannot show a shape.
bool draws(Command&, const Target&, std::string_view about);
// Fails if a camera would focus on itself. Accepts any value of any other function.
bool focuses_elsewhere(Command&, const Target&, const Value&, std::string_view about);
// Returns whether code computes any of the track's rows.
bool has_code(const Track&);
// Reads the part of a row that follows its time.
bool event(Command&, const Selected& to, Time);
// Adds the event to all tracks that it is for.
bool put_row(Command&, const Selected& to, Event, std::string_view about);
// Reads the interpolation that follows an event: [TWERPER] [ease-in=L] [ease-out=L] [tangent…=V]; with `lasts` also
// [for L].
bool way(Command&, const Selected& to, Event&, std::optional<Time>* lasts = nullptr);

// ---- moves.cpp

// Returns the value that a function has at a time, as far as what is set and its own events say: before the first event
// what is set, or the first event's value. With `counts`, other values are passed over.
Value value_said(const Scene&, const Object&, FunctionId, Time, bool (*counts)(const Value&) = nullptr);
// Adds two events: what is there at the event's time, and its value at the end.
bool put_for(Command&, const Selected& to, Event, Time length, std::string_view about);

// ---- theming.cpp

// Gives an object that has no color one of the film's theme, if it has a theme.
void give_theme_color(Command&, Object&);

// ---- rates.cpp

// Reads a value per second. For a rotation: a rate for each angle, or an angular velocity about an axis.
bool rate_of_change(Command&, const Selected&, Value& out);
// Read an event's tangent=V, tangent-in=V or tangent-out=V, and its handles, after the word `key`.
bool tangent(Command&, const Selected&, std::string_view key, Event&);
bool handle(Command&, const Selected&, std::string_view key, Event&);

// ---- twerpers.cpp

// Reads a twerper's word and the arguments in brackets that follow it.
bool twerper(Command&, const Selected& to, Twerper& out, TwerperArguments&);

// ---- procedures.cpp

// Compiles the code of a value. The code knows the names made by `let`; if `placed`, also its place in the command's
// pattern.
Result<std::shared_ptr<const Routine>> make_code(const Command&, std::string source, bool placed, Role = Role::value);
// Carries out lines of the language inside a command. Changes the scene even if one of them fails.
// `in_block`: their times are those of the block of the command, not of the film.
Diagnostics carried_out(Command&, std::string_view lines, bool in_block = false);
// Runs a command of the author's own.
bool own_command(Command&, const NamedProcedure&);

// ---- motions.cpp

// Reads the motion that follows a row's segment.
bool moving(Command&, const Selected& to, Time from, std::optional<Time> until);
// Reports motions whose duration an operation on times has changed.
void say_lasting(const Command&, const Scene& before, const Selected& on, std::string_view about);
// Returns a copy of the track in which motions about the object `from` are about `to`.
Track centred(Track, const std::string& from, const std::string& to);
// Keeps the centres of motions about objects that are about to be removed.
void keep_centres(const Command&, const std::vector<ObjectId>& leaving, const std::vector<std::uint32_t>& speaking,
                  std::string_view about);

// ---- along.cpp

// goes_along() returns whether `along` begins here, in place of a value. The other functions read the rest of it after
// a time or a segment, and after `set`.
inline bool goes_along(Cursor& c) { return c.peek() == 'a' && c.peek_word() == "along"; }
bool along_line(Command&, const Selected& to, Time from, std::optional<Time> until);
bool set_along_line(Command&, const Selected& to);
// Straightens the motion of objects along lines that are about to be removed.
void keep_ways(const Command&, const std::vector<ObjectId>& leaving, const std::vector<std::uint32_t>& speaking,
               std::string_view about);

// ---- attachments.cpp

// Ends a fall at the moment when something takes hold of the object, and reports it.
void say_fall_ends(Command&, ObjectId, Time, std::string_view about);
// Puts an attachment on the tracks of `children`. Changes nothing if one of them would depend on itself.
bool attachment(Command&, const std::vector<ObjectId>& children, const Attachment&, std::optional<Time>,
                std::string_view about);

// ---- fall.cpp

// Ends the motion that `fall` has written if it continues beyond this time. Returns whether there was one.
bool end_fall(Scene&, ObjectId, Time);

// ---- reaching.cpp

// Returns an error for each object that reaches, by `set` and rows too, for something that moves with it.
std::vector<Error> hindered_reaches(const Scene&);

// ---- layers.cpp

// Reports that the verb cannot follow `on LAYER`. Returns false.
bool on_no_layer(Cursor&, std::string_view verb);

// ---- list_rows.cpp

// Reads a row of the open display list.
bool list_row(Command&);

// ---- display_lists.cpp

// Runs `rename OLD NEW` where OLD is a display list.
bool rename_list(Command&);

// ---- environments.cpp

// Returns the tick that the command belongs to; between two ticks, the earlier one. Without a time a live host's
// commands happen now, and an author's at the beginning.
std::int64_t tick(const Command&);

}  // namespace betwixt
