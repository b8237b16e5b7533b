// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// A film as facts, each with a key and a text in the language. Two films are equal if their facts are.
#pragma once

#include <compare>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "betwixt/document.h"

namespace betwixt {

// In the order in which a merge carries them out.
enum class FactPart : std::uint8_t {
  setting,      // of the film: rate, background
  definition,   // procedure, let, function, alias, kind, dial
  object,       // that it exists, and its kind
  list,         // a display list with its rows and versions
  environment,  // all commands about it
  value,        // that was set
  manner,       // the twerper and the extrapolation of a track
  event,
  filters,
  camera,  // a cut
  note,    // all notes at one time, a line each
};
std::string_view word_of(FactPart);

struct FactKey {
  FactPart part = FactPart::setting;
  std::string object;  // "" of the film
  std::string about;   // "position.x"; of the film "rate", "alias toys"
  std::string layer;   // that it is on, or ""
  Time time;           // of an event, a cut, a note

  // "ball.position on sway"
  std::string name() const;
  // The same key without its time: the track.
  FactKey track() const { return {part, object, about, layer, {}}; }
  bool timed() const { return part == FactPart::event || part == FactPart::camera || part == FactPart::note; }
  friend auto operator<=>(const FactKey&, const FactKey&) = default;
};

struct Facts {
  std::map<FactKey, std::string> said;
  std::vector<std::string> objects;  // in order of creation
  friend bool operator==(const Facts&, const Facts&) = default;
};
Facts facts_of(const Document&);

using TrackEvents = std::map<Time, std::string>;  // the row of each, without its time
// Returns the events, cuts or notes of a track.
TrackEvents events_of(const std::map<FactKey, std::string>& said, FactKey track);

// Returns the commands that make this fact true in a film where its object exists. Empty if none can.
std::vector<std::string> commands_for(const FactKey&, const std::string& said, const Document&);
// Returns the commands that undo a fact. Empty if none can.
std::vector<std::string> commands_without(const FactKey&, const Document&);

}  // namespace betwixt
