// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Functions of sounds. Only src/scene/functions.cpp includes this; its rows come after those of
// src/scene/aiming_functions.h.
#pragma once

#include "scene/functions.h"

namespace betwixt {

// Returns the row as that of a length of a sound's time.
inline FunctionSpec part_of_sound(FunctionSpec row) {
  row.kinds = bit(Kind::sound), row.unit = Unit::seconds, row.low = 0, row.high = longest_seconds;
  row.written = "a length of time";
  return row;
}

inline const FunctionSpec sound_functions[] = {
    {.name = "file",
     .type = Type::text,
     .rest = Text(),
     .kinds = bit(Kind::sound),
     .by_script = true,
     .sentence = "The file of a sound.",
     .written = "\"FILE\""},
    {.name = "words",
     .type = Type::text,
     .rest = Text(),
     .kinds = bit(Kind::sound),
     .by_script = true,
     .sentence = "The file that says when each word of a sound is spoken; voice:\"hello\" is then a time.",
     .written = "\"FILE\""},
    {.name = "at",
     .type = Type::scalar,
     .rest = 0.0,
     .kinds = bit(Kind::sound),
     .unit = Unit::moment,
     .low = -longest_seconds,
     .high = longest_seconds,
     .sentence = "The time of the film at which a sound begins.",
     .written = "a time",
     .example = "create music sound file=\"music.mp3\"\nset music.at 24f"},
    part_of_sound({.name = "from",
                   .rest = 0.0,
                   .sentence = "The second of its file with which a sound begins.",
                   .example = "create music sound file=\"music.mp3\"\nset music.from 10s"}),
    part_of_sound({.name = "until",
                   .rest = longest_seconds,
                   .sentence = "The second of its file with which a sound ends; by default it ends with the file.",
                   .example = "create music sound file=\"music.mp3\"\nset music.until 70s"}),
    {.name = "gain",
     .type = Type::scalar,
     .rest = 1.0,
     .kinds = bit(Kind::sound),
     .low = 0,
     .high = 1000,
     .sentence = "The volume of a sound, as a factor; 0 is silence.",
     .written = "a number",
     .example = "create music sound file=\"music.mp3\"\nat 24f music.gain 0.5"},
    part_of_sound({.name = "fade-in",
                   .rest = 0.0,
                   .sentence = "The length of a sound's fade-in.",
                   .example = "create music sound file=\"music.mp3\"\nset music.fade-in 2s"}),
    part_of_sound({.name = "fade-out",
                   .rest = 0.0,
                   .sentence = "The length of a sound's fade-out.",
                   .example = "create music sound file=\"music.mp3\"\nset music.fade-out 2s"}),
};

}  // namespace betwixt
