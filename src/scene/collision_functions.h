// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// How an object moves by velocities, and what it does where it would run into others. Only src/scene/functions.cpp
// includes this; its rows come after those of src/scene/rig_functions.h.
#pragma once

#include "scene/document.h"
#include "scene/functions.h"

namespace betwixt {

inline const FunctionSpec collision_functions[] = {
    {.name = "obstacles",
     .type = Type::names,
     .rest = Names(),
     .place = true,
     .sentence = "The objects that it cannot move through: its position stops, slides or bounces where it would touch.",
     .written = "(A B), or none",
     .example = "create wall box position=(4 0 0)\nset ball.obstacles (wall)"},
    {.name = "collision",
     .type = Type::text,
     .rest = Text(std::string("stop")),
     .words = "stop|slide|bounce|mirror",
     .place = true,
     .sentence =
         "What it does where it touches an obstacle: `stop` there, `slide` along the surface, `bounce` off as a "
         "ball does, or `mirror` the rest of its path.",
     .written = "stop, slide, bounce or mirror",
     .example = "set ball.collision bounce"},
    {.name = "bounciness",
     .type = Type::scalar,
     .rest = 1.0,
     .low = 0,
     .high = 1,
     .place = true,
     .sentence = "How much of its speed towards the surface it keeps at a bounce: 1 keeps all, 0 none.",
     .written = "a number from 0 to 1",
     .example = "set ball.bounciness 0.8"},
    {.name = "velocity-space",
     .type = Type::text,
     .rest = Text(std::string("parent")),
     .words = "parent|own",
     .place = true,
     .sentence =
         "The space of its velocity: that of its position (`parent`), or its own, which turns with its rotation "
         "(`own`): a car that drives forward while it steers.",
     .written = "parent or own",
     .example = "create car box velocity-space=own\nat 1f car.position.velocity (2 0 0)"},
};

}  // namespace betwixt
