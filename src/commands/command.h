// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// A command, and what the bodies of commands share. A body reads all its arguments before it changes anything; one
// that cannot be carried out says why (once, at the cursor), changes nothing and returns false.
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

inline constexpr std::size_t most_objects = 1'000'000;  // braces make many of them in a few words

struct Command {
  Scene& scene;
  Cursor& cursor;
  std::optional<Time> time;  // of `at TIME`
  ObjectId layer;            // of `on LAYER`
  Script& script;
};

// A verb: how it is written, what its help says, what it may stand behind, and what it does.
struct Verb {
  enum : unsigned {
    timed = 1,         // `at TIME` may stand before it
    layered = 2,       // `on LAYER` may stand before it
    stamped = 4,       // without a time it happens now, where the author is a live host (LoadOptions::now)
    opens_sheet = 8,   // its rows go below it
    starts_show = 16,  // a live host's time goes on with it where it stands; it is not set back
    once = 32,         // what it says holds for the film until it is said again
    aside = 64,        // it makes nothing of what tracks hold
  };
  std::string_view word, usage, sentence;
  std::string_view example;  // lines that can be entered one after another
  unsigned flags;
  bool (*run)(Command&);
};

// The command that begins here: a verb, a command of the author's own, or a target that opens a sheet.
bool carry_out(Command&);
// Nothing may follow.
bool finish(Cursor&);
// Why what stands behind `on LAYER` cannot.
bool on_no_layer(Cursor&, std::string_view verb);
// What stands there is none of the words that may: an error of type, as of the words of a function; of syntax where
// nothing stands.
bool no_choice(Cursor&, std::string_view word, std::string message, std::string hint = {});
// on or off, and nothing more; whoever says anything else is told `otherwise`.
bool on_or_off(Cursor&, const char* otherwise, bool& out);

// Why a word that is no verb cannot be one; empty where there is nothing special about it.
std::string_view not_of_a_script(std::string_view word);

ValueReader values(Command&);
// Where the dot between an object's name and its function is; dots inside braces ({1..100}) are not.
std::size_t first_dot(std::string_view word);
// What a pattern may name: functions with values of one type, so that what is of another is left out; one function,
// whatever the types of its values are; any, for what never asks for values; or, asking, also what can be asked for
// only and what display lists draw.
enum class Meant : std::uint8_t { alike, named_alike, any, asked };
bool targets(Command&, std::string_view word, Selected& out, Meant = Meant::alike);
// Whether all that are selected have values of one type.
bool alike(Command&, const Selected&);
// The rest of a command about targets of which there are none is read by nobody.
bool pass_over(Command&, const char* from);
// Reads what stands behind a target for all that it names, once for each type; whom it does not fit are left out,
// unless it fits nobody or types may be translated.
bool to_each_type(Command&, std::string_view word, const char* from, const std::function<bool(const Selected&)>& read);
// Carries out the rest of a command for all that is selected, once for each type of values. Those for which it means
// nothing are left out and named, unless it means nothing for all; with any other error nothing is done at all.
bool for_each_type(Command&, const Selected&, const std::function<bool(const Selected&)>& rest);
// Names targets that a command leaves out.
void say_left_out(Command&, const std::vector<Target>&, std::string_view about, std::string why);
// One or more objects: a name that exists, an alias, or a pattern (which may name none).
bool objects(Command&, std::string_view& word, std::vector<ObjectId>& out);

// A word that can be a name, here a `kind` ("function's name"); it has none of the characters in `never`.
bool new_name(Cursor&, std::string_view& out, std::string_view kind, std::string_view never = {});
// Whether nothing has the name yet.
bool free_name(Command&, const std::string& name, std::string_view about);
// Whether it is not drawn by display lists, whose rows alone change it.
bool own(Command&, ObjectId, std::string_view about);
// key=value …, of a new object; `said`: which functions that was about.
bool parameters(Command&, Object&, std::vector<FunctionId>* said = nullptr);
// Adds an object, coupled to its parent if there is one.
ObjectId add_child(Scene&, Object, ObjectId parent);
// create NAME scene: what stands behind the word.
bool create_scene(Command&, const std::vector<std::string>& names, const std::vector<ObjectId>& parents,
                  std::string_view about);
// Whether the script may read the file; `path` becomes its place below the first script's folder.
bool may_use(Command&, std::string& path, std::string_view about, std::filesystem::path& where);
// Keeps the meshes of a file as those that its path and their names name.
void keep_meshes(Scene&, const std::string& path, const SceneFile&);
// Where a text's font has no letters as they should look by this value and what else was set.
void say_missing_style(Command&, const Object&, FunctionId, const Value&, std::string_view about);
// = "…": a value that code computes.
bool computed(Command&, const Selected& to, Value& out);
// Code of a value, which knows what `let` gave, and, `placed`, the place in the command's pattern.
Result<std::shared_ptr<const Routine>> make_code(const Command&, std::string source, bool placed);
// A twerper's word and what stands in brackets behind it.
bool twerper(Command&, const Selected& to, Twerper& out, TwerperArguments&);

// What a pattern names; where the command is carried out once for each, the one that it is about now.
std::vector<ObjectId> named(Command&, std::string_view pattern);
// Carries out a command or a row once, or where its formulas speak of their place (i, n, i1 …) once for each that its
// pattern names; all of it or nothing.
bool in_places(Command&, const std::function<bool()>& command);
bool in_places(Command&, const Selected& of_row, const std::function<bool(const Selected&)>& row);

// TIME, or A..B where a motion may follow.
bool time_or_segment(Cursor&, Time& from, std::optional<Time>& until);
bool one_time_only(Cursor&, std::string_view segment);
// Whether an object can show a shape; an error of a geometry where it cannot.
bool draws(Command&, const Target&, std::string_view about);
// A camera focuses on something else than itself; any other function may have any value.
bool focuses_elsewhere(Command&, const Target&, const Value&, std::string_view about);
// Whether code says what any of its rows are.
bool has_code(const Track&);
// What stands behind a row's time.
bool event(Command&, const Selected& to, Time);
// A value per second: angles of a rotation one by one, or the turning about an axis.
bool rate_of_change(Command&, const Selected&, Value& out);
// tangent=V, tangent-in=V, tangent-out=V of an event, behind the word `key`.
bool tangent(Command&, const Selected&, std::string_view key, Event&);
bool handle(Command&, const Selected&, std::string_view key, Event&);
// How an event goes on: [TWERPER] [ease-in=L] [ease-out=L] [tangent…=V]
bool way(Command&, const Selected& to, Event&);
// What stands behind a row's segment: a motion.
bool moving(Command&, const Selected& to, Time from, std::optional<Time> until);

// Whether a way along a line begins here, in place of a value; the same behind a time or a segment, and as what is set.
inline bool goes_along(Cursor& c) { return c.peek() == 'a' && c.peek_word() == "along"; }
bool along_line(Command&, const Selected& to, Time from, std::optional<Time> until);
bool set_along_line(Command&, const Selected& to);
// What goes along something that is about to go goes straight from then on.
void keep_ways(const Command&, const std::vector<ObjectId>& leaving, const std::vector<std::uint32_t>& speaking,
               std::string_view about);

// What reaches, by `set` and rows too, for what moves with it, in words.
std::vector<std::string> hindered_reaches(const Scene&);
// Ends a fall where something takes hold, and says so.
void say_fall_ends(Command&, ObjectId, Time, std::string_view about);
// Puts an attachment on the tracks of `children`, or nothing at all where one of them would hang on itself (R-H6).
bool attachment(Command&, const std::vector<ObjectId>& children, const Attachment&, std::optional<Time>,
                std::string_view about);
// Ends what `fall` has written where it goes on beyond this time; tells whether there was any.
bool end_fall(Scene&, ObjectId, Time);

// What operations on times have made of motions, said where they last otherwise than before.
void say_lasting(const Command&, const Scene& before, const Selected& on, std::string_view about);
// A copy that turned about the object itself turns about the one that it is copied to.
Track centred(Track, const std::string& from, const std::string& to);
// Motions about objects that are about to go keep the places.
void keep_centres(const Command&, const std::vector<ObjectId>& leaving, const std::vector<std::uint32_t>& speaking,
                  std::string_view about);

// A row of the display list that is open.
bool list_row(Command&);
// rename OLD NEW, where the old name is a list's.
bool rename_list(Command&);
// A command of the author's own.
bool own_command(Command&, const NamedProcedure&);

// The tick that the command belongs to: between ticks it is the one before (R-E1a). Without a time a live host's
// commands happen now, an author's at the beginning.
std::int64_t tick(const Command&);

}  // namespace betwixt
