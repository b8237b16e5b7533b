// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The words of a recording, with the times at which they are spoken. Words are compared by their letters and digits
// alone: capitals, punctuation and blanks do not count.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace betwixt {

struct SpokenWord {
  double start = 0, end = 0;  // seconds of the recording
  std::string text;           // as the file spells it
};

struct SpokenWords {
  std::vector<SpokenWord> words;  // by their starts
  // The letters of all words, one after another, and where those of each word begin there; last, where all end.
  std::string letters;
  std::vector<std::uint32_t> begins{0};

  void add(SpokenWord word);
};

// Words that follow each other: their indices.
struct SpokenRun {
  std::size_t first = 0, last = 0;
};

// Returns what words are compared by: the letters and digits, small.
std::string letters_of(std::string_view text);
// Returns the spoken words of a text as it spells them. Signs alone, such as a dash, are no words.
std::vector<std::string> words_of_text(std::string_view text);
// Returns where these letters are spoken, as whole words. Runs do not overlap.
std::vector<SpokenRun> find_spoken(const SpokenWords&, std::string_view letters);
// Returns the words that are most like these letters, or nullopt if none are alike.
std::optional<SpokenRun> nearest_spoken(const SpokenWords&, std::string_view letters);
// Returns the words as they are spelt, with blanks between them, without punctuation at the ends.
std::string spelt(const SpokenWords&, SpokenRun);

}  // namespace betwixt
