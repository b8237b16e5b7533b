// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The state of a session: an editor, its journal, the file, and the words of the shell.
#pragma once

#include <fmt/format.h>

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "betwixt/program.h"
#include "betwixt/session.h"
#include "editor/editor.h"
#include "editor/journal.h"
#include "editor/placing.h"
#include "editor/set_aside.h"
#include "editor/track_rows.h"
#include "syntax/tokens.h"

namespace betwixt {

struct Session::State {
  using Words = std::vector<std::string>;
  // A word of the shell. If it is also a command of the language, the shell takes it only when it is alone on its line.
  struct Word {
    std::string_view word, usage, sentence, example;
    std::size_t most;  // the largest number of arguments
    Answer (State::*run)(const Words&);
    std::string_view words = {};  // that can follow, as in Verb::words
  };
  static std::span<const Word> words();
  static const Word* find_word(std::string_view);

  static Answer done(std::string said) { return {true, false, false, std::move(said)}; }
  static Answer refused(const std::string& message, const std::string& hint = {});
  static Answer refused(const Error& e) { return refused(e.message, e.hint); }
  static Answer answer_of(const Result<std::string>& said) { return said ? done(*said) : refused(said.error()); }
  static Answer answer_of(const Status& s) { return s ? done("") : refused(s.error()); }

  State(Callbacks with, const LoadOptions& load) : callbacks(std::move(with)), options(load), editor(load) {
    keep_journal();
  }
  ~State() { close(tally.unsaved() > 0); }

  Callbacks callbacks;
  LoadOptions options;
  Editor editor;
  std::string file;
  Tally tally;
  std::optional<Fingerprint> known;  // of the file when it was last read or written; nullopt if there was none
  std::unique_ptr<Journal> journal;
  std::string nameless_journal = journal_path("");
  std::vector<std::string> drawn;  // plots of this session, replaced without a question
  bool looks_only = false;
  bool sheet_refused = false;  // the last sheet was refused, so its rows are refused too
  bool ended = false;
  bool in_place = false;  // edits change the author's text; if false, they are appended to it
  // The text as it is, with all rows that set_track() has put at its end. They are written when somebody asks for it.
  PlacedText& placed() { return write_rows(), written; }
  const PlacedText& placed() const { return write_rows(), written; }
  mutable PlacedText written;
  struct UnwrittenRows {
    std::size_t step;                // its place among the steps
    std::vector<std::string> lines;  // above the rows
    std::shared_ptr<const TrackRows> rows;
    bool instead;  // of the rows of the call before
  };
  mutable std::vector<UnwrittenRows> unwritten;
  // The last set_track(): the film that it made, and where its rows are in the text.
  std::string last_opener;
  Document last_made;
  struct RowsInText {
    std::size_t begin = 0, end = 0;
  };
  mutable RowsInText last_rows;
  Diagnostics of_text;                               // diagnostics of the author's text
  std::size_t journal_knows = 0, journal_undid = 0;  // last standing and undone steps that the journal has
  int lines = 0;                                     // entered until now
  Program program;                                   // of the last document in which code was tried
  bool quiet = false;                                // does not report the number of matches of a pattern
  std::set<std::string> problems;                    // of code, already reported
  std::map<std::string, int, std::less<>> failed;    // names that refused lines would have made, with the line numbers

  const Document& document() const { return editor.now().document; }
  std::string called() const { return file.empty() ? "this film" : fmt::format("'{}'", file); }
  std::string text() const;

  // session.cpp: lines
  Answer enter(std::string_view line);
  Answer command(std::string_view line);
  int line_of(std::string_view text) const;
  std::string told(const Diagnostics& all, std::string_view line) const;
  Diagnostics hinted(Diagnostics all, std::string_view line) const;
  std::string tried(const Words& words, std::string_view line);
  Answer together(const std::vector<std::string>& said);
  Result<Document> ahead(const std::vector<std::string>& said) const;
  Answer only_looks() const;
  Answer undo(const Words& = {});
  Answer redo(const Words& = {});
  using Asking = decltype(Callbacks::ask);
  std::optional<bool> asked_about(const CommandResult& refused, std::string_view line) const;
  std::optional<std::size_t> choose(Question question) const { return choose(std::move(question), callbacks.ask); }
  std::optional<std::size_t> choose(Question question, const Asking& ask) const;

  // session_files.cpp: files and journals
  enum class Leave { stay, go, keep };
  Answer save(const std::string& to);
  Answer save_word(const Words& w) { return save(w.size() > 1 ? w[1] : ""); }
  Result<std::unique_ptr<Journal>> journal_beside(const std::string& name, std::string& said) const;
  bool begin(Journal& j, const Fingerprint& saved) const;
  void close(bool keep);
  Status write_down(Did what, std::string_view text);
  Status write_step(Did what, const Step&);
  void keep_journal();
  Leave leave(std::string& said, bool ends);
  Answer quit(const Words& = {});
  Answer reopen(const Words&);

  // set_track.cpp: tracks from columns of numbers
  Answer set_track(std::string_view name, std::span<const Time> times, std::span<const double> numbers,
                   std::string_view twerper);
  Status take_track(Point then, Step step, const std::string& opener);
  void write_rows() const;

  // session_text.cpp: edits that change the author's text
  void go_in_place();
  Answer rewrite(std::string_view line);
  Answer rewrite_word(const Words&) { return rewrite(std::string_view()); }
  Result<TextEdit> rewriting(std::string_view line) const;
  Status take(Point after, Step);
  std::optional<TextEdits> place_each(const Point& after, const Step&) const;
  Status go_back();
  Status go_again();
  void read_text_again();
  Point after(const std::string& text, const TextEdit&, Diagnostics& said) const;
  Status go_on_from_file();

  // session_opening.cpp: beginning a session, or continuing an earlier one
  struct Opening {
    std::string name, text;            // the current text of the file
    std::optional<Fingerprint> print;  // … nullopt if the file does not exist
    std::string said;
  };
  Answer open(const std::string& name, Earlier earlier);
  void begin(std::string text, const std::string& name);
  Answer after_earlier(Opening, Earlier earlier);
  Status put_aside(Opening&, bool fits) const;
  std::optional<bool> wanted(const Tally& then, Earlier earlier) const;
  std::string recorded() const;
  void start(Opening&, const std::string& base);
  Answer replay(Opening, const std::string& base);
  // Records of a journal that were carried out again, and those that failed.
  struct Replayed {
    std::vector<Record> records;
    std::vector<SetAside> aside;
  };
  using Killers = std::map<std::size_t, std::string>;  // records that crash the program, and how
  Replayed carry_out(std::span<const Record>, const Killers&, const std::string& now_saved);
  std::string again(const std::string& command);

  // session_words.cpp: words that change nothing
  Answer help(const Words&);
  Answer list(const Words&);
  Answer describe(const Words&);
  Answer notes(const Words&);
  Answer plot(const Words&);
  Answer play(const Words&);
  Answer eval(const Words&);
  Answer picture(const Words&);
  Answer stop(const Words&);
  Answer load(const Words&);
};

// Returns true if the line changes lines of the text (`rewrite`).
bool is_rewriting(std::string_view line);

// Removes blanks and new lines at the end, and at the beginning if `both`.
std::string_view trimmed(std::string_view s, bool both = true);

}  // namespace betwixt
