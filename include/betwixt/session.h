// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
// A session: a film that is edited line by line. It keeps every version of the document since the session started, so
// undo has no limit. It also keeps the author's text. The journal is a file beside the script: the session writes each
// command to it, on the disk, before `enter` returns. A session has no user interface; the shell and the studio add
// their own.
//
// Room: editor
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "betwixt/language.h"

namespace betwixt {

class Session {
 public:
  static constexpr std::string_view called_off = "\x03";  // what `ask` returns after Ctrl-C: cancels the line

  // A question to the user.
  struct Question {
    std::string above;  // lines to show above the question; may be empty
    std::string text;   // "1 command is not saved"
    std::vector<std::string> choices;
  };
  // Functions of your program that the session calls. You may leave any of them empty; a command that needs it then
  // gives an error.
  struct Callbacks {
    // Returns the user's choice, `called_off` to cancel, or std::nullopt if there is no one to answer.
    std::function<std::optional<std::string>(const Question&)> ask;
    // Draws a plot of a target (or of those that a pattern names) into an SVG file.
    std::function<Status(const Document&, const std::string& target, const std::string& file)> plot;
    // Plays the film. `frames` is "A..B" (from A to B), "A" (from A to the end) or "" (all).
    std::function<Status(const Document&, const std::string& frames)> play;
    // Loads a plug-in, so that its words can be used.
    std::function<Status(const std::string& file)> load_plugin;
    // Changes style, samples or size of `play` and returns a message. If `value` is empty, changes nothing and returns
    // the current setting.
    std::function<Result<std::string>(const std::string& what, const std::string& value)> set_play_option;
    std::vector<std::string> styles;  // the styles that exist, for completion
    // Like `ask`, for a line that may mean something else than the author thinks. If it is empty, the session carries
    // the line out without asking. Leave it empty if lines come faster than a person reads.
    std::function<std::optional<std::string>(const Question&)> ask_about_line;
  };
  // What to do with the commands of an earlier session that ended without saving.
  enum class Earlier { ask, recover, discard };
  struct Answer {
    bool done = false;  // the line was carried out; if not, nothing has changed
    bool quit = false;
    bool refused = false;  // the line has an error; false if it was cancelled or blank
    std::string said;      // the output, in whole lines; may be empty
    Diagnostics why = {};  // messages about the line or lines, each with its place in them
  };

  struct State;
  explicit Session(Callbacks = {}, const LoadOptions& = {});
  ~Session();
  Session(Session&&) noexcept;
  Session& operator=(Session&&) noexcept;

  // Opens a script. If the file does not exist, starts a new film. If `file` is "", starts a film without a file.
  Answer open(const std::string& file, Earlier = Earlier::ask);
  // Sets the journal of a film without a file; call it before open(). A program with several such films gives each its
  // own. Without a call it is `.betwixt.journal` in the current folder.
  void keep_nameless_in(std::string journal);
  // Starts from a text, for programs that store the film themselves. Messages use the name `file`. The script may read
  // files in the folder of `file` and below. The file itself need not exist. There is no journal, and other sessions
  // may use the file.
  void begin(std::string text, const std::string& file);
  // Carries out one logical line. It is a command, a row of the open sheet (the list of events below a target), or a
  // word of the shell, such as `undo`.
  Answer enter(std::string_view line);
  // Carries out several lines: all or none. One undo takes them back.
  Answer enter_together(const std::vector<std::string>& lines);
  // Replaces all events of a track. `target` names one track, such as "ball.position"; see find_targets. `times`
  // increase. `numbers` has one number for each time, or two or three for each if a value is a pair, a vector, a colour
  // or a rotation: metres, radians, or sRGB from 0 to 1. `twerper` is the interpolation after each event, as in a row:
  // "linear", or "" for the default. One undo takes the call back. A call that follows another for the same track
  // replaces its rows in the text. A million events take about a tenth of a second. The answer says what is wrong:
  // name (there is no such track), type (its values are not numbers), range (wrong count, order or value).
  Answer set_track(std::string_view target, std::span<const Time> times, std::span<const double> numbers,
                   std::string_view twerper = {});
  // Returns the film as these lines would make it, without changing the session. Errors: that of the first wrong line.
  Result<Document> look_ahead(const std::vector<std::string>& lines) const;
  // Returns the film that the text would make if `others` replaced its lines `first` to `last` (counted from 1, both
  // included). With last = first - 1, `others` are inserted before line `first`. Does not change the session.
  Loaded look_ahead(int first, int last, std::string_view others) const;
  // After this call, commands change existing lines of the text where they can, as an author would. A command that
  // changes an event changes the row of that event. Other commands are appended. The command `rewrite FIRST..LAST "…"`
  // replaces these lines of the text, and makes this call by itself.
  void edit_in_place();
  // Returns the command `rewrite FIRST..LAST "…"` that replaces the lines `first` to `last` with `others`.
  static std::string rewrite_line(int first, int last, std::string_view others);
  // Reads the file again. From then on the session edits in place, the content of the file counts as saved, and the
  // rest of the session's text counts as unsaved. Call it when another program has written the file and you have
  // entered its changes into the session. Does nothing if the session has no file, or if another session has it.
  // Errors: file (the file does not exist or cannot be read), machine (the journal cannot be written).
  Status go_on_from_file();
  // Returns the errors and warnings of the text, each with its place.
  const Diagnostics& diagnostics() const;
  // After this call, the session no longer says how many objects a pattern matches.
  void keep_quiet();
  // Returns whether a bracket or a """ is open, so that the line continues.
  static bool needs_more(std::string_view line);
  // Returns the possible completions of the last word, in order.
  std::vector<std::string> complete(std::string_view line) const;

  const Document& document() const;
  // Returns the line that opened the current sheet, or "" if no sheet is open.
  std::string sheet() const;
  const std::string& file() const;  // "" if it has none
  std::size_t unsaved() const;      // how many commands are not saved
  // A step of the history: what one undo takes back.
  struct PastStep {
    std::string line;       // the first of its lines
    std::size_t lines = 1;  // how many it has
    std::string sheet;      // the target of its rows; "" if it is no row of an open sheet
    bool stands = true;     // false if it was undone
  };
  // Returns the latest steps, at most so many, in order; undone steps come last, and the next redo first among them.
  std::vector<PastStep> history(std::size_t most) const;
  bool may_change() const;   // false if another session has the file
  std::string text() const;  // the text that `save` writes: the author's, then the commands

 private:
  std::unique_ptr<State> state_;
};

// Returns the text to show: the lines of `above`, then a line with the question and its choices, such as "1 command is
// not saved: save, discard or stay? ".
std::string to_string(const Session::Question&);

}  // namespace betwixt
