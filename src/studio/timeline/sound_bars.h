// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The sounds of a film as bars along the time, with their loudness.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "betwixt/program.h"
#include "betwixt/sound.h"

namespace betwixt::studio {

struct SoundBar {
  ObjectId id;
  std::string name;
  std::shared_ptr<const Sound> sound;
  Time from, to;    // when it is heard
  double own = 0;   // seconds of the sound at `from`
  double peak = 0;  // of the loudness while it is heard
  int row = 0;      // sounds that overlap are in different rows

  // Returns the loudest moment between two times of the film: the root mean square, 0 to 1.
  double loudness(Time a, Time b) const;
};

// Returns all sounds of the film, in order of their beginnings, each in the first free row.
std::vector<SoundBar> sound_bars(const Program&);

}  // namespace betwixt::studio
