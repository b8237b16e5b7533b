// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What a logical line is, by its first words and the rows of the verbs, without running it: for help, completion,
// colours, renaming and all other tools that look at scripts.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "commands/verbs.h"
#include "syntax/script_text.h"

namespace betwixt {

struct LineHead {
  bool row = false;                                // indented: it belongs to the sheet or list above it
  std::string_view time;                           // of `at TIME`
  std::string_view layer;                          // of `on LAYER`
  std::string_view word;                           // after these: a verb or a target; may be empty
  const Verb* verb = nullptr;                      // nullptr if the word is no verb
  std::string_view name, rest;                     // the piece after the word, and the rest of the line
  bool alone() const { return empty_line(rest); }  // nothing follows the name
};
LineHead line_head(std::string_view line);
// Returns the word that names the kind of a new object; "" if the verb takes none.
std::string_view kind_word(const LineHead&);

// The rows that can follow a line: those of a sheet, those of a display list, or none.
enum class Opens : std::uint8_t { nothing, sheet, list };
Opens opens(const LineHead&);
inline bool opens_sheet(std::string_view line) { return opens(line_head(line)) != Opens::nothing; }
// Returns whether commands that are indented below the line belong to it.
bool opens_block(const LineHead&);
inline bool opens_block(std::string_view line) { return opens_block(line_head(line)); }
// Returns whether the line can be below an opener (it is a row, a comment or blank), so that the opener is further up.
inline bool below_opener(std::string_view line) { return indented(line) || empty_line(line); }
// Returns the line that opens the sheet or list of a row; count() if there is none.
std::size_t opener_of(const ScriptText&, std::size_t line);
// Returns whether the line is a row of a sheet or list above it.
inline bool is_row(const ScriptText& text, std::size_t line) { return opener_of(text, line) < text.count(); }
// Returns the line that opens the innermost block of a command or a row; count() if there is none.
std::size_t block_of(const ScriptText&, std::size_t line);

// Follows the logical lines of a script from its first one on, and tells what the indentation of each makes of it.
class Indentation {
 public:
  // Takes the next line, which has a word. Returns whether it is a row.
  bool row(std::string_view line);
  // Of that line: the number of blocks that it is in, and the line that opens the innermost one.
  std::size_t depth() const { return blocks_.size() - pending_; }
  std::string_view block() const { return depth() > 0 ? std::string_view(blocks_[depth() - 1].opener) : ""; }
  Opens sheet() const { return sheet_; }  // what rows below that line would belong to

 private:
  struct Open {
    std::size_t outer;
    std::optional<std::size_t> indent;
    std::string opener;
  };
  std::vector<Open> blocks_;
  std::size_t pending_ = 0;  // 1 if the line itself opens the last of the blocks
  Opens sheet_ = Opens::nothing;
};

// thing: an object, a layer, an environment, a display list or an alias. let: a value defined by `let`. function,
// procedure and kind: the author's own.
enum class NameKind : std::uint8_t { thing, let, function, procedure, kind };
// The verb of a line and the name, or the pattern of many names, that it makes.
struct Making {
  std::string_view verb, word;
  NameKind kind = NameKind::thing;
};
std::optional<Making> making(std::string_view line);
// Returns the verbs that make names.
std::vector<std::string_view> making_verbs();
// Returns all names that a line makes, or would make if it did not fail. "title/" represents all names that
// `split title` makes. Returns none if the pattern has more than 10,000 names.
std::vector<std::string> names_made(std::string_view line);

}  // namespace betwixt
