// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "scene/spoken_words.h"

#include <algorithm>

#include "base/cancellation.h"
#include "base/utf8.h"

namespace betwixt {
namespace {

// Beyond these a search for similar words would take too long.
constexpr std::size_t most_compared = 200'000, longest_compared = 60;

bool in(char32_t c, char32_t low, char32_t high) { return c >= low && c <= high; }

// Returns the small letter of a capital of the Latin, Greek and Cyrillic alphabets.
char32_t small(char32_t c) {
  if (in(c, 'A', 'Z') || (in(c, 0xC0, 0xDE) && c != 0xD7) || (in(c, 0x391, 0x3A9) && c != 0x3A2) || in(c, 0x410, 0x42F))
    return c + 0x20;
  if (in(c, 0x400, 0x40F)) return c + 0x50;
  const bool odd = in(c, 0x139, 0x148) || in(c, 0x179, 0x17E);  // there the capital has the odd number
  if (odd) return c + (c & 1);
  return in(c, 0x100, 0x177) && c != 0x130 && c != 0x131 && c != 0x138 ? c | 1 : c;
}

// Signs that are neither letters nor digits. Everything else beyond ASCII counts as a letter.
bool is_sign(char32_t c) {
  if (c < 0x80) return !(in(c, '0', '9') || in(c, 'A', 'Z') || in(c, 'a', 'z'));
  return (in(c, 0x80, 0xBF) && c != 0xAA && c != 0xB5 && c != 0xBA) || in(c, 0x2000, 0x206F) || in(c, 0x2190, 0x2BFF) ||
         in(c, 0x2E00, 0x2E7F) || in(c, 0x3000, 0x303F) || in(c, 0xFF00, 0xFF0F) || c == 0xFEFF || c == 0xFFFD;
}

void append(std::string& to, char32_t c) {
  const auto put = [&](char32_t byte) { to += static_cast<char>(byte); };
  const auto rest = [&](int shift) { put(0x80 | (c >> shift & 0x3F)); };
  if (c < 0x80) return put(c);
  if (c < 0x800) return put(0xC0 | c >> 6), rest(0);
  if (c < 0x10000) return put(0xE0 | c >> 12), rest(6), rest(0);
  put(0xF0 | c >> 18), rest(12), rest(6), rest(0);
}

// Returns the index of the word that has the letter at a place.
std::size_t word_with(const SpokenWords& words, std::size_t place) {
  const auto behind = std::upper_bound(words.begins.begin(), words.begins.end(), place);
  return static_cast<std::size_t>(behind - words.begins.begin()) - 1;
}

}  // namespace

void SpokenWords::add(SpokenWord word) {
  letters += letters_of(word.text);
  words.push_back(std::move(word));
  begins.push_back(static_cast<std::uint32_t>(letters.size()));
}

std::string letters_of(std::string_view text) {
  std::string out;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = character_length(text, i);
    if (length == 0) {
      ++i;
      continue;
    }
    const char32_t c = character_at(text, i, length);
    if (!is_sign(c)) append(out, small(c));
    i += length;
  }
  return out;
}

std::vector<std::string> words_of_text(std::string_view text) {
  std::vector<std::string> all;
  const auto white = [](char c) { return std::string_view(" \t\r\n").find(c) != std::string_view::npos; };
  for (auto at = text.begin(); at != text.end();) {
    const auto from = std::find_if_not(at, text.end(), white), to = std::find_if(from, text.end(), white);
    if (const std::string word(from, to); !letters_of(word).empty()) all.push_back(word);
    at = to;
  }
  return all;
}

std::vector<SpokenRun> find_spoken(const SpokenWords& in, std::string_view letters) {
  std::vector<SpokenRun> all;
  if (letters.empty()) return all;
  for (std::size_t at = 0; (at = in.letters.find(letters, at)) != std::string::npos;) {
    const std::size_t end = at + letters.size();
    const std::size_t last = word_with(in, end - 1);
    const auto begins = std::lower_bound(in.begins.begin(), in.begins.end(), at);
    if (*begins != at || in.begins[last + 1] != end) {
      ++at;
      continue;
    }
    all.push_back({word_with(in, at), last});
    at = end;
  }
  return all;
}

// The distance of two texts is the number of letters to change, add or leave out. `from`: where the best match that
// ends here begins.
std::optional<SpokenRun> nearest_spoken(const SpokenWords& in, std::string_view letters) {
  letters = letters.substr(0, longest_compared);
  const std::string_view all = std::string_view(in.letters).substr(0, most_compared);
  struct Cell {
    std::size_t cost = 0, from = 0;
  };
  std::vector<Cell> row(letters.size() + 1);
  for (std::size_t i = 0; i < row.size(); ++i) row[i] = {i, 0};
  std::size_t best = letters.size() / 2 + 1, from = 0, to = 0;
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (k % 4096 == 0) Cancellation::check();
    Cell before = row[0];
    row[0] = {0, k + 1};
    for (std::size_t i = 1; i < row.size(); ++i) {
      Cell cell{before.cost + (letters[i - 1] != all[k]), before.from};
      if (row[i].cost + 1 < cell.cost) cell = {row[i].cost + 1, row[i].from};
      if (row[i - 1].cost + 1 < cell.cost) cell = {row[i - 1].cost + 1, row[i - 1].from};
      before = std::exchange(row[i], cell);
    }
    if (row.back().cost < best) best = row.back().cost, from = row.back().from, to = k;
  }
  if (best > letters.size() / 2 || in.words.empty() || from > to) return std::nullopt;
  return SpokenRun{word_with(in, from), word_with(in, to)};
}

std::string spelt(const SpokenWords& in, SpokenRun run) {
  std::string out;
  for (std::size_t i = run.first; i <= run.last; ++i) out += (i > run.first ? " " : "") + in.words[i].text;
  const auto ends = [](char c) { return std::string_view(" .,;:!?\"()").find(c) != std::string_view::npos; };
  while (!out.empty() && ends(out.back())) out.pop_back();
  while (!out.empty() && ends(out.front())) out.erase(0, 1);
  std::replace(out.begin(), out.end(), '"', '\'');
  return out;
}

}  // namespace betwixt
