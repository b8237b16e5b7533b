// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "app/pronunciation.h"

#include <fcntl.h>

#include <algorithm>
#include <chrono>
#include <set>

#include "base/child.h"
#include "base/files.h"
#include "scene/spoken_words.h"
#include "syntax/characters.h"

namespace betwixt {
namespace {

constexpr std::size_t most_asked = 5000;  // words that espeak-ng says, one call each

struct Spelling {
  std::string_view written, phones;
};

// The phonemes of espeak-ng's American English, the longest first where one begins another.
constexpr Spelling espeak_sounds[] = {
    {"tS", "CH"},   {"dZ", "JH"},   {"aI@", "AY ER"}, {"aI3", "AY ER"}, {"aU@", "AW ER"}, {"aU3", "AW ER"},
    {"aI", "AY"},   {"aU", "AW"},   {"eI", "EY"},     {"OI", "OY"},     {"oU", "OW"},     {"i@3", "IH R"},
    {"i@", "IH R"}, {"e@", "EH R"}, {"U@", "UH R"},   {"A@", "AA R"},   {"O@", "AO R"},   {"o@", "AO R"},
    {"3:", "ER"},   {"A:", "AA"},   {"O:", "AO"},     {"i:", "IY"},     {"u:", "UW"},     {"@L", "AH L"},
    {"aa", "AE"},   {"a#", "AH"},   {"I#", "IH"},     {"n-", "AH N"},   {"p", "P"},       {"b", "B"},
    {"t", "T"},     {"d", "D"},     {"k", "K"},       {"g", "G"},       {"f", "F"},       {"v", "V"},
    {"s", "S"},     {"z", "Z"},     {"h", "HH"},      {"m", "M"},       {"n", "N"},       {"l", "L"},
    {"r", "R"},     {"w", "W"},     {"j", "Y"},       {"x", "K"},       {"T", "TH"},      {"D", "DH"},
    {"S", "SH"},    {"Z", "ZH"},    {"N", "NG"},      {"I", "IH"},      {"i", "IY"},      {"E", "EH"},
    {"a", "AE"},    {"0", "AA"},    {"A", "AA"},      {"O", "AO"},      {"V", "AH"},      {"U", "UH"},
    {"u", "UW"},    {"@", "AH"},    {"3", "ER"},      {"e", "EH"},      {"o", "OW"},      {"y", "UW"}};

constexpr Spelling letter_sounds[] = {
    {"tion", "SH AH N"}, {"sion", "ZH AH N"}, {"ough", "AO"},  {"eigh", "EY"},     {"tch", "CH"},        {"igh", "AY"},
    {"sch", "SH"},       {"th", "TH"},        {"sh", "SH"},    {"ch", "CH"},       {"ph", "F"},          {"ck", "K"},
    {"ng", "NG"},        {"qu", "K W"},       {"wh", "W"},     {"ee", "IY"},       {"ea", "IY"},         {"oo", "UW"},
    {"ou", "AW"},        {"ow", "OW"},        {"oi", "OY"},    {"oy", "OY"},       {"ai", "EY"},         {"ay", "EY"},
    {"au", "AO"},        {"aw", "AO"},        {"er", "ER"},    {"ir", "ER"},       {"ur", "ER"},         {"ar", "AA R"},
    {"or", "AO R"},      {"a", "AE"},         {"b", "B"},      {"c", "K"},         {"d", "D"},           {"e", "EH"},
    {"f", "F"},          {"g", "G"},          {"h", "HH"},     {"i", "IH"},        {"j", "JH"},          {"k", "K"},
    {"l", "L"},          {"m", "M"},          {"n", "N"},      {"o", "AA"},        {"p", "P"},           {"q", "K"},
    {"r", "R"},          {"s", "S"},          {"t", "T"},      {"u", "AH"},        {"v", "V"},           {"w", "W"},
    {"x", "K S"},        {"y", "IY"},         {"z", "Z"},      {"0", "Z IH R OW"}, {"1", "W AH N"},      {"2", "T UW"},
    {"3", "TH R IY"},    {"4", "F AO R"},     {"5", "F AY V"}, {"6", "S IH K S"},  {"7", "S EH V AH N"}, {"8", "EY T"},
    {"9", "N AY N"}};

// Replaces the sounds of a table one after another. Skips other characters.
template <std::size_t N>
std::string replaced(std::string_view text, const Spelling (&table)[N]) {
  std::string out;
  while (!text.empty()) {
    const auto known = std::find_if(std::begin(table), std::end(table),
                                    [&](const Spelling& s) { return text.starts_with(s.written); });
    if (known != std::end(table)) (out += out.empty() ? "" : " ") += known->phones;
    text.remove_prefix(known == std::end(table) ? 1 : known->written.size());
  }
  return out;
}

// Returns a word as the dictionary has it: small letters, a plain apostrophe, without other signs.
std::string key_of(std::string_view word) {
  std::string key;
  for (std::size_t i = 0; i < word.size(); ++i) {
    const bool apostrophe = word[i] == '\'' || word.substr(i).starts_with("\xE2\x80\x99");
    if (apostrophe && !key.empty()) key += '\'';
    if (is_letter(word[i])) key += static_cast<char>(word[i] | 0x20);
    if (is_digit(word[i])) key += word[i];
  }
  while (key.ends_with('\'')) key.pop_back();
  return key;
}

// The parts of twenty-one and and/or.
std::vector<std::string> parts_of_word(std::string_view word) {
  std::vector<std::string> parts;
  for (std::size_t from = 0; from <= word.size();) {
    const std::size_t to = std::min(word.find_first_of("-/", from), word.size());
    if (std::string key = key_of(word.substr(from, to - from)); !key.empty()) parts.push_back(std::move(key));
    from = to + 1;
  }
  return parts;
}

// Reads the lines of the dictionary that are about these words: "square S K W EH R", "the(2) DH IY".
Result<Pronunciations> look_up(const std::set<std::string>& words, const std::string& dictionary) {
  const auto text = read_whole(dictionary);
  if (!text) return text.error();
  Pronunciations all;
  for (std::string_view rest = *text; !rest.empty();) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    const std::string_view line = rest.substr(0, end);
    rest.remove_prefix(std::min(rest.size(), end + 1));
    const std::size_t blank_at = std::min(line.find(' '), line.size());
    const std::string word(line.substr(0, std::min(line.find('('), blank_at)));
    if (words.contains(word) && blank_at < line.size()) all[word].emplace_back(line.substr(blank_at + 1));
  }
  return all;
}

// Returns what espeak-ng prints for a word, or "" if it is not installed or fails.
std::string asked_espeak(const std::string& word, const std::string& folder) {
  static const std::string program = find_program("espeak-ng");
  if (program.empty()) return {};
  const std::string out = folder + "/said";
  const OpenFile file(::open(out.c_str(), O_CREAT | O_TRUNC | O_WRONLY | O_CLOEXEC, 0600));
  pid_t pid = -1;
  if (!file || start_child(pid, {program, "-q", "-x", "-v", "en-us", "--", word}, {-1, file.fd(), -1}) != 0) return {};
  if (wait_for_child(pid, std::chrono::seconds(5)) != 0) return {};
  const auto said = read_whole(out);
  return said ? *said : std::string();
}

std::string unknown_phones(const std::string& word, const std::string& folder, std::size_t& asked) {
  const std::string said = asked++ < most_asked ? phones_of_espeak(asked_espeak(word, folder)) : std::string();
  return said.empty() ? phones_of_letters(word) : said;
}

}  // namespace

std::string phones_of_espeak(std::string_view said) { return replaced(said, espeak_sounds); }

std::string phones_of_letters(std::string_view word) {
  std::string phones = replaced(key_of(word), letter_sounds);
  return phones.empty() ? "AH" : phones;
}

Result<Pronunciations> pronunciations(const std::vector<std::string>& words, const std::string& dictionary,
                                      const std::string& folder) {
  std::set<std::string> wanted;
  for (const std::string& word : words) {
    wanted.insert(key_of(word));
    for (std::string& part : parts_of_word(word)) wanted.insert(std::move(part));
  }
  Result<Pronunciations> known = look_up(wanted, dictionary);
  if (!known) return known;
  std::size_t asked = 0;
  Pronunciations all;
  for (const std::string& word : words) {
    std::vector<std::string>& ways = all[word];
    if (!ways.empty()) continue;
    if (const auto whole = known->find(key_of(word)); whole != known->end()) {
      ways = whole->second;
      continue;
    }
    const std::vector<std::string> parts = parts_of_word(word);
    std::string phones;
    for (const std::string& part : parts) {
      const auto there = parts.size() > 1 ? known->find(part) : known->end();
      (phones += phones.empty() ? "" : " ") +=
          there != known->end() ? there->second.front() : unknown_phones(parts.size() > 1 ? part : word, folder, asked);
    }
    ways.push_back(phones.empty() ? unknown_phones(word, folder, asked) : phones);
  }
  return all;
}

}  // namespace betwixt
