// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "commands/verbs.h"

#include <algorithm>
#include <unordered_map>

namespace betwixt {

using Rows = std::span<const Verb>;
Rows settings_verbs(), appearance_verbs(), skies_verbs(), environments_verbs(), objects_verbs(), renaming_verbs(),
    names_verbs(), tracks_verbs(), attachments_verbs(), showing_verbs(), notes_verbs(), copying_verbs(),
    segments_verbs(), clearing_verbs(), groups_verbs(), baking_verbs(), reaching_verbs(), arranging_verbs(),
    filters_verbs(), layers_verbs(), procedures_verbs(), fall_verbs(), dials_verbs(), files_verbs(),
    display_lists_verbs(), texts_verbs(), entrances_verbs(), annotations_verbs(), connecting_verbs(), callouts_verbs(),
    diagrams_verbs(), theming_verbs(), own_kinds_verbs(), dimensioning_verbs(), tables_verbs(), translating_verbs(),
    sections_verbs(), cues_verbs(), parts_verbs(), captions_verbs();

const std::vector<Verb>& verbs() {
  static const std::vector<Verb> all = [] {
    std::vector<Verb> rows;
    for (const Rows family :
         {settings_verbs(),    appearance_verbs(), skies_verbs(),       environments_verbs(), objects_verbs(),
          renaming_verbs(),    tracks_verbs(),     attachments_verbs(), showing_verbs(),      notes_verbs(),
          copying_verbs(),     segments_verbs(),   clearing_verbs(),    groups_verbs(),       baking_verbs(),
          arranging_verbs(),   texts_verbs(),      filters_verbs(),     layers_verbs(),       procedures_verbs(),
          fall_verbs(),        dials_verbs(),      names_verbs(),       files_verbs(),        display_lists_verbs(),
          reaching_verbs(),    own_kinds_verbs(),  entrances_verbs(),   annotations_verbs(),  connecting_verbs(),
          callouts_verbs(),    diagrams_verbs(),   theming_verbs(),     dimensioning_verbs(), tables_verbs(),
          translating_verbs(), sections_verbs(),   cues_verbs(),        parts_verbs(),        captions_verbs()})
      rows.insert(rows.end(), family.begin(), family.end());
    return rows;
  }();
  return all;
}

const Verb* find_verb(std::string_view word) {
  static const auto index = [] {
    std::unordered_map<std::string_view, const Verb*> by_word;
    for (const Verb& v : verbs()) by_word.emplace(v.word, &v);
    return by_word;
  }();
  const auto at = index.find(word);
  return at == index.end() ? nullptr : at->second;
}

std::vector<std::string_view> verb_words(unsigned flags) {
  std::vector<std::string_view> words;
  for (const Verb& v : verbs())
    if ((v.flags & flags) == flags) words.push_back(v.word);
  return words;
}

static constexpr std::string_view to_be_repeated = "…";

std::string_view words_at(std::string_view words, std::size_t place) {
  const bool repeats = words.ends_with(to_be_repeated);
  if (repeats) words.remove_suffix(to_be_repeated.size());
  for (; place > 0; --place) {
    const std::size_t next = words.find(';');
    if (next == std::string_view::npos) return repeats ? words : std::string_view();
    words.remove_prefix(next + 1);
  }
  return words.substr(0, words.find(';'));
}

bool has_word(std::string_view words, std::string_view one) {
  for (std::size_t at = words.find(one); at != std::string_view::npos; at = words.find(one, at + 1)) {
    const std::string_view behind = words.substr(at + one.size());
    const bool begins = at == 0 || words[at - 1] == ' ';
    if (begins && (behind.empty() || behind[0] == ' ' || behind[0] == ';' || behind.starts_with(to_be_repeated)))
      return true;
  }
  return false;
}

std::span<const std::string_view> reserved_words() {
  static constexpr std::string_view shell[] = {"help", "list", "undo", "redo", "plot", "play", "stop", "rewrite",
                                               "save", "open", "load", "quit", "exit", "eval", "style"};
  return shell;
}

}  // namespace betwixt
