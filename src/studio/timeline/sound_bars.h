// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The sounds of a film as bars along the time, with their loudness.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "betwixt/program.h"
#include "betwixt/sound.h"
#include "scene/spoken_words.h"

namespace betwixt::studio {

struct SoundBar {
  ObjectId id;
  std::string name;
  std::shared_ptr<const Sound> sound;
  Time from, to;                                       // when it is heard
  double own = 0;                                      // seconds of the sound at `from`
  double peak = 0;                                     // of the loudness while it is heard
  int row = 0;                                         // sounds that overlap are in different rows
  std::shared_ptr<const SpokenWords> words = nullptr;  // null if it has none

  // Returns the loudest moment between two times of the film: the root mean square, 0 to 1.
  double loudness(Time a, Time b) const;
  // Return when a word begins in the film, the words that are heard as [first, end), and a word as a script writes its
  // time: voice:"square"#2, or "" if it has no letters.
  Time time_of_word(std::size_t) const;
  std::pair<std::size_t, std::size_t> heard_words() const;
  std::string moment_of_word(std::size_t) const;
};

// Returns all sounds of the film, in order of their beginnings, each in the first free row.
std::vector<SoundBar> sound_bars(const Program&);

}  // namespace betwixt::studio
