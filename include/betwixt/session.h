// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// A session: a film that is edited line by line. It keeps every document since its start (undo has no limit) and the
// author's text. A journal beside the script stores each command on the disk before it is answered. A session has no
// user interface; the shell and the server bring theirs.
//
// Room: editor
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "betwixt/language.h"

namespace betwixt {

class Session {
 public:
  static constexpr std::string_view called_off = "\x03";  // the answer after Ctrl-C: cancels the line

  // A question to the user.
  struct Question {
    std::string above;  // lines to show above the question; may be empty
    std::string text;   // "1 command is not saved"
    std::vector<std::string> choices;
  };
  // Callbacks into the host. Each may be empty.
  struct Callbacks {
    // Returns the user's choice, `called_off` to cancel, or std::nullopt if there is no one to answer.
    std::function<std::optional<std::string>(const Question&)> ask;
    // Draws a plot of a target (or of those that a pattern names) into an SVG file.
    std::function<Status(const Document&, const std::string& target, const std::string& file)> plot;
    // Plays the frames "A..B", from "A" to the end, or all of them: "".
    std::function<Status(const Document&, const std::string& frames)> play;
    // Loads a plug-in, so that its words can be used.
    std::function<Status(const std::string& file)> load_plugin;
    // Changes style, samples or size of `play` and returns a message. With an empty value, returns the current one.
    std::function<Result<std::string>(const std::string& what, const std::string& value)> set_play_option;
    std::vector<std::string> styles;  // the styles that exist, for completion
    // Like `ask`, for questions about the meaning of a line. Leave it empty if lines come faster than a person reads.
    std::function<std::optional<std::string>(const Question&)> ask_about_line;
  };
  // What to do with the commands of an earlier session that ended without saving.
  enum class Earlier { ask, recover, discard };
  struct Answer {
    bool done = false;  // the line was carried out; if not, nothing has changed
    bool quit = false;
    bool refused = false;  // the line is wrong (neither cancelled nor blank)
    std::string said;      // the output, in whole lines; may be empty
    Diagnostics why = {};  // messages about the line or lines, each with its place in them
  };

  struct State;
  explicit Session(Callbacks = {}, const LoadOptions& = {});
  ~Session();
  Session(Session&&) noexcept;
  Session& operator=(Session&&) noexcept;

  // Opens a script, a new film if the file does not exist, or no file at all: "".
  Answer open(const std::string& file, Earlier = Earlier::ask);
  // Starts from a text, for hosts that store the film themselves. `file` is the name in messages, and files are read
  // below its folder; it need not exist. There is no journal, and other sessions may use the file.
  void begin(std::string text, const std::string& file);
  // Carries out one logical line: a command, a row of the open sheet, or a word of the shell.
  Answer enter(std::string_view line);
  // Carries out several lines: all or none. One undo takes them back.
  Answer enter_together(const std::vector<std::string>& lines);
  // Returns the film as these lines would make it, without changing the session. Errors: that of the first wrong line.
  Result<Document> look_ahead(const std::vector<std::string>& lines) const;
  // Returns the film as the text would make it with `others` in place of the lines `first` to `last`, counted from 1.
  // With last = first - 1, `others` are inserted before line `first`.
  Loaded look_ahead(int first, int last, std::string_view others) const;
  // From now on edits the text in place, as an author would: a changed event changes its row, and only new lines are
  // appended. `rewrite FIRST..LAST "…"` then changes the text itself.
  void edit_in_place();
  // Returns the line that replaces lines as above: `rewrite FIRST..LAST "…"`.
  static std::string rewrite_line(int first, int last, std::string_view others);
  // From now on what the file holds counts as saved, and the rest of the text as unsaved. Call it after another program
  // wrote the file and you have dealt with its changes. Errors: file (there is none), machine.
  Status go_on_from_file();
  // Returns the errors and warnings of the text, each with its place.
  const Diagnostics& diagnostics() const;
  // From now on omits the notices of how many objects a pattern named.
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
  bool may_change() const;          // false if another session has the file
  std::string text() const;         // the text that `save` writes: the author's, byte for byte, and the commands since

 private:
  std::unique_ptr<State> state_;
};

// Returns the question in one line, with the lines above it: "1 command is not saved: save, discard or stay? ".
std::string to_string(const Session::Question&);

}  // namespace betwixt
