// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What the readers of src/exchange/words_*.cpp share. Only they include this.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "exchange/words_file.h"

namespace betwixt {

// Collects the words of a file and the first thing that is wrong.
class WordsReading {
 public:
  WordsReading(std::string_view text, const std::string& name) : text_(text), name_(name) {}

  std::string_view text() const { return text_; }
  // Says what is wrong at a part of the text. Returns false.
  bool wrong(std::string_view at, const std::string& what);
  // Adds a word; `at` is where it stands, for messages.
  bool add(double start, double end, std::string_view word, std::string_view at);
  // Adds the words of a sentence. Each gets a part of the time in proportion to its letters.
  bool add_sentence(double start, double end, std::string_view sentence, std::string_view at);
  // Reads a whole piece of text as seconds.
  bool seconds(std::string_view piece, double& out);
  // Reads hours:minutes:seconds, or minutes:seconds, with '.' or ',' before the milliseconds.
  bool clock(std::string_view piece, double& out);

  Result<std::shared_ptr<const SpokenWords>> result();

 private:
  std::string_view text_;
  const std::string& name_;
  SpokenWords words_;
  std::optional<Error> error_;
};

// Takes the next line of a text, without its end.
std::string_view take_line_of(std::string_view& rest);
// Returns the piece without blanks at its ends.
std::string_view without_blanks(std::string_view);
// Returns a cue's text without its tags, <b> or {\an8}, and with its entities replaced.
std::string plain_cue(std::string_view);

bool read_word_lines(WordsReading&);  // lines `start end word`, and labels of Audacity
bool read_cues(WordsReading&);        // WebVTT and SRT
bool read_whisper(WordsReading&);
bool read_text_grid(WordsReading&);

}  // namespace betwixt
