// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Functions of sounds. Only src/scene/functions.cpp includes this; its rows come after those of
// src/scene/aiming_functions.h.
#pragma once

#include "scene/functions.h"

namespace betwixt {

inline const FunctionSpec sound_functions[] = {
    {.name = "file", .type = Type::text, .rest = Text(), .kinds = bit(Kind::sound)},
    {.name = "at",
     .type = Type::scalar,
     .rest = 0.0,
     .kinds = bit(Kind::sound),
     .unit = Unit::moment,
     .low = -longest_seconds,
     .high = longest_seconds,
     .sentence = "When a sound begins.",
     .written = "a time",
     .example = "create music sound file=\"music.mp3\"\nset music.at 24f"},
    {.name = "from",
     .type = Type::scalar,
     .rest = 0.0,
     .kinds = bit(Kind::sound),
     .unit = Unit::seconds,
     .low = 0,
     .high = longest_seconds},
    {.name = "until",
     .type = Type::scalar,
     .rest = longest_seconds,
     .kinds = bit(Kind::sound),
     .unit = Unit::seconds,
     .low = 0,
     .high = longest_seconds},
    {.name = "gain",
     .type = Type::scalar,
     .rest = 1.0,
     .kinds = bit(Kind::sound),
     .low = 0,
     .high = 1000,
     .sentence = "The volume of a sound, as a factor; 0 is silence.",
     .written = "a number",
     .example = "create music sound file=\"music.mp3\"\nat 24f music.gain 0.5"},
    {.name = "fade-in",
     .type = Type::scalar,
     .rest = 0.0,
     .kinds = bit(Kind::sound),
     .unit = Unit::seconds,
     .low = 0,
     .high = longest_seconds,
     .sentence = "The length of a sound's fade-in.",
     .written = "a length of time",
     .example = "create music sound file=\"music.mp3\"\nset music.fade-in 2s"},
    {.name = "fade-out",
     .type = Type::scalar,
     .rest = 0.0,
     .kinds = bit(Kind::sound),
     .unit = Unit::seconds,
     .low = 0,
     .high = longest_seconds,
     .sentence = "The length of a sound's fade-out.",
     .written = "a length of time",
     .example = "create music sound file=\"music.mp3\"\nset music.fade-out 2s"},
};

}  // namespace betwixt
