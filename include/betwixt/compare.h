// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Compares two films, and merges the changes of two authors. Both look at what films say (objects, values, events), and
// not at the lines of their scripts: the order of lines, comments and layout make no difference.
//
// Room: compare
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "betwixt/document.h"
#include "betwixt/language.h"

namespace betwixt {

// A difference of one event. `was` and `before` are of the old film, `is` and `after` of the new one; an event that
// came has no `was`, and one that went has no `is`.
struct EventChange {
  std::optional<Time> was, is;
  std::string before, after;  // its row, without the time
  friend bool operator==(const EventChange&, const EventChange&) = default;
};

// A difference of two films.
struct FilmChange {
  enum class What : std::uint8_t { added, removed, changed, moved, renamed };
  What what = What::changed;
  std::string part;                 // "object", "value", "event", "twerper", "filter", "note", "camera", "setting", …
  std::string name;                 // of the thing: "ball", "ball.position", "rate"; of a renamed object, the old name
  std::string before, after;        // as the language writes them; "" if there is none, and for several events
  std::vector<EventChange> events;  // of events, notes and camera cuts
  Time by;                          // how far events have moved, if all moved as far
  std::string words;                // "ball.position: 3 events moved by 5f"
};
std::string_view to_string(FilmChange::What);

// Returns all differences: those of the film as a whole first, then object by object. The list is empty if and only if
// the documents are equal. An object that was removed and one with the same content that was added are one object that
// was renamed. What belongs to an added or removed object is not listed again.
std::vector<FilmChange> compare(const Document& old, const Document& now);

// A change that could not be merged, as the other author's version was changed too.
struct MergeConflict {
  std::string name;    // "ball.position"
  std::string mine;    // in words: "at 24f (8 10 0)", "removed"
  std::string theirs;  // the same
  std::string line;    // the line of the language that would carry out THEIRS
  int place = 0;       // the line of the merged text with the comment about it
};
struct MergedFilm {
  std::string text;
  std::vector<MergeConflict> conflicts;
  std::vector<std::string> notices;  // what follows only from both changes together, in words
  bool by_lines = false;             // a text could not be read, or its changes not be placed: lines were merged
  std::string why;                   // … the reason, in words
  bool clean() const { return conflicts.empty(); }
};
// Merges what `mine` and `theirs` have each changed in the text `base`, by objects, tracks and events. The result has
// the lines of `mine`, with the changes of `theirs` where an author would write them. Where both changed the same thing
// differently, that of `mine` stays, and a comment `# conflict: theirs: …` beside it has the other. If a text has
// errors or its changes cannot be placed, merges the lines; then conflicts have the usual marks, <<<<<<< and >>>>>>>.
// `name` is the script's path, from which it finds its files.
MergedFilm merge_films(const std::string& base, const std::string& mine, const std::string& theirs,
                       const std::string& name, const LoadOptions& = {});

}  // namespace betwixt
