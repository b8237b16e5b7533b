// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Shutter and lens opening of cameras. Only src/scene/functions.cpp includes this; its rows come after those of
// src/scene/sound_functions.h.
#pragma once

#include "scene/document.h"
#include "scene/functions.h"

namespace betwixt {

inline constexpr double sharp = 1e6;  // the f-stop of a closed opening: everything is sharp

inline const FunctionSpec camera_functions[] = {
    {.name = "shutter",
     .type = Type::scalar,
     .rest = 0.0,
     .kinds = bit(Kind::camera),
     .unit = Unit::opening,
     .low = 0,
     .high = 60,
     .sentence = "The exposure time of each frame, from its time on: motion blur.",
     .written = "an angle (360deg is a frame), a length of time, or off",
     .example = "set eye.shutter 180deg"},
    {.name = "f-stop",
     .type = Type::scalar,
     .rest = sharp,
     .kinds = bit(Kind::camera),
     .low = 1e-4,
     .high = sharp,
     .sentence =
         "The aperture of a camera: the smaller the number, the stronger the depth of field; 1000000, or `off`: "
         "everything is sharp.",
     .written = "a number, or off",
     .example = "set eye.f-stop 0.1"},
    {.name = "focus",
     .type = Type::aim,
     .rest = ObjectId{},
     .kinds = bit(Kind::camera),
     .unit = Unit::metres,
     .sentence = "What is in focus: an object, a point, or a distance; none: the point that the camera looks at.",
     .written = "a name, a point or a distance",
     .example = "set eye.focus ball"},
};

}  // namespace betwixt
