// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Poses: the values of a character's functions at one time, to use at another time, mirrored, or in another film.
#pragma once

#include <string>
#include <vector>

#include "betwixt/program.h"
#include "betwixt/result.h"
#include "studio/timeline/event_lines.h"

namespace betwixt::studio {

struct Pose {
  struct Part {
    std::string object, function;
    Value value;  // points in the world are in the root's space
  };
  std::string root;  // the uppermost object
  std::vector<Part> parts;
};

// Returns the pose of objects with all that hangs on them: position, rotation, a scale
// that the script sets, and all functions with events.
// Code keeps what it computes. If an uppermost object has parts, its own position and rotation are not in the pose.
Pose pose_of(const Program&, const std::vector<ObjectId>&, Time);
// Exchanges left and right: values of man/left-arm go to man/right-arm, mirrored in the plane between the two sides.
Pose mirrored(const Pose&, const Program&, Time);
// Returns the lines that give the pose to an object, `onto`, or to the pose's own root if that is none. If any
// of its functions has events, or with `make_events`, they make events; a function without any keeps its value before.
// `share`: how far towards the pose.
Lines pose_lines(const Program&, const Pose&, ObjectId onto, Time, bool make_events, double share = 1);

// A pose as text of the language: "# pose of man", and lines such as `set man/arm.rotation (0 0 30deg)`.
std::string text_of_pose(const Pose&, const Document&);
// Returns the pose of such a text for a film; `onto` as above. `trial` carries out lines on a copy of the film. Errors:
// the text is no pose, or names an object that the film does not have.
Result<Pose> read_pose(const std::string& text, const Document&, ObjectId onto,
                       const std::function<Result<Document>(const Lines&)>& trial);

}  // namespace betwixt::studio
