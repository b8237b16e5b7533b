// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Fuzzes the readers of words and their times: lines, WebVTT, SRT, JSON, TextGrid and labels. The first byte chooses
// the name of the file.
#include <cmath>
#include <cstdint>
#include <string>

#include "exchange/words_file.h"
#include "fuzz.h"

using namespace betwixt;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const Slow slow;
  constexpr const char* names[] = {"a.words", "a.vtt", "a.srt", "a.json", "a.TextGrid", "a.txt"};
  const std::string text(reinterpret_cast<const char*>(data) + 1, size - 1);
  const auto read = read_words(text, names[data[0] % std::size(names)]);
  if (!read) {
    insist(!read.error().message.empty(), "an error has words", text);
    return slow.verdict();
  }
  double last = 0;
  for (const SpokenWord& word : (*read)->words) {
    insist(std::isfinite(word.end) && word.start >= 0 && word.start <= word.end, "a word has a beginning and an end",
           text);
    insist(word.start >= last - 1e-5, "words are in order", text);
    last = word.start;
  }
  insist((*read)->begins.size() == (*read)->words.size() + 1, "each word has its letters", text);
  const auto again = read_words(write_words(**read), "again.words");
  insist(again && (*again)->letters == (*read)->letters, "what is written is read again", text);
  return slow.verdict();
}
