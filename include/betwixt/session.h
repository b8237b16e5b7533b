// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// A session: a film that is made line by line. It keeps every document that ever was (undo has no limit), what the
// author wrote, and a journal beside the script, in which a command is on the disk before it is answered. It knows no
// terminal: the shell, or a server, stands around it.
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
  static constexpr std::string_view called_off = "\x03";  // Ctrl-C: nothing shall happen

  // What the session cannot do itself. All may be empty.
  struct Doors {
    // The answer to a question, or `called_off`; none where nobody answers any more.
    std::function<std::optional<std::string>(const std::string& question)> ask;
    std::function<Status(const Document&, const std::string& target, const std::string& file)> plot;
    std::function<Status(const Document&, const std::string& frames)> play;
    std::function<Status(const std::string& file)> load;
    // How `play` draws: style, samples or size; without a value, what they are. Says it.
    std::function<Result<std::string>(const std::string& what, const std::string& value)> picture;
    std::vector<std::string> styles;  // that there are: for completion
    // The same as `ask`, of what a line means: empty where lines come faster than anybody reads.
    std::function<std::optional<std::string>(const std::string& question)> ask_about_line;
  };
  // Commands of a session that ended without saving.
  enum class Earlier { ask, recover, discard };
  struct Answer {
    bool done = false;  // the line was carried out; else nothing has changed
    bool quit = false;
    bool refused = false;  // the line is wrong (and not just called off, or blank)
    std::string said;      // lines, each with its end; may be empty
    Diagnostics why = {};  // what of it is about the line, or lines, each with its place in them
  };

  struct State;
  explicit Session(Doors = {}, const LoadOptions& = {});
  ~Session();
  Session(Session&&) noexcept;
  Session& operator=(Session&&) noexcept;

  // Begins with a script (one that is not there yet is a new film), or without: "".
  Answer open(const std::string& file, Earlier = Earlier::ask);
  // Begins with a text, that of a file or of one that is not there, for programs that keep themselves what is done:
  // there is no journal, and nobody is kept from the file.
  void begin(std::string text, const std::string& file);
  // Carries out one logical line: a command, a row of the sheet that is open, or a word of the shell.
  Answer enter(std::string_view line);
  // Several lines as one: all of them or none, and one undo takes them back.
  Answer enter_together(const std::vector<std::string>& lines);
  // What the film would be after these lines; nothing is done. Errors: of the first line that is wrong.
  Result<Document> look_ahead(const std::vector<std::string>& lines) const;
  // What the author's text says where its lines from `first` (the first is 1) up to `last` are others; `last` one less
  // than `first`: these stand before that line.
  Loaded look_ahead(int first, int last, std::string_view others) const;
  // From now on what is done goes to where an author would write it: an event that is changed changes its row, and only
  // what is new goes to the end. `rewrite FIRST..LAST "…"` then changes the text itself.
  void keep_in_place();
  // The line that writes other lines in the place of some, as above.
  static std::string rewrite_line(int first, int last, std::string_view others);
  // Somebody else has changed the file, and what he wrote has been seen to: from now on it is what was saved last.
  Status go_on_from_file();
  // What there is to say of the text: errors and warnings, each with its place in it.
  const Diagnostics& diagnostics() const;
  // From now on how many things a pattern named is not said.
  void keep_quiet();
  // A bracket or a """ is open: the line goes on.
  static bool needs_more(std::string_view line);
  // What the last word of a line can become, in order.
  std::vector<std::string> complete(std::string_view line) const;

  const Document& document() const;
  // The line that opened the sheet whose rows may follow; empty: none is open.
  std::string sheet() const;
  const std::string& file() const;  // may be empty
  std::size_t unsaved() const;      // commands
  bool may_change() const;          // false: another session has the file
  std::string text() const;         // what `save` writes: the author's text, byte for byte, and what was done since

 private:
  std::unique_ptr<State> state_;
};

}  // namespace betwixt
