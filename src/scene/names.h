// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Names of objects, targets and times, from a scene, since messages need no document.
#pragma once

#include <string>

#include "scene/document.h"

namespace betwixt {

std::string object_name(const Scene&, ObjectId);       // "none" if there is no such object
std::string target_name(const Scene&, const Target&);  // "ball.position.x", "ball.position.velocity", "ball.world"
// "did you mean 'ball'?" if an object or an alias has a similar name, else an empty text. In large films it reads only
// the first 10,000 objects.
Hint near_object(const Scene&, std::string_view word);
std::string format_time(Time, Rate);  // "24f" where it is on a frame, else seconds: "1.2345s"

// Returns "world"; for environments "by", "every" and "count"; for drawn objects "touching" and "in-view".
std::string_view name_of(Query);
std::optional<Query> find_query(Kind, std::string_view name);

}  // namespace betwixt
