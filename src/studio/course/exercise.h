// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The exercises of the course. They are the rows of exercises.txt:
//   exercise NAME      begins an exercise; the lines below it that begin with | are the script of its film
//   about SENTENCE     what it shows
//   step SENTENCE      what to do; the rows below it belong to the step:
//     point PLACE      what the frame surrounds (course_pointer.h)
//     until CONDITION  the step is done when all its conditions hold (holds)
//     show LINE        what "Show me" does: a line of the language, or an act (show_how)
// In places, conditions and lines, $sphere stands for the name of the first sphere of the film, $box2 for that of the
// second box, and $now for the time of the playhead.
#pragma once

#include <string>
#include <vector>

#include "studio/shell/workspace.h"

namespace betwixt::studio {

class Window;

struct CourseStep {
  std::string words, point;
  std::vector<std::string> until, show;
};
struct Exercise {
  std::string name, about, film;
  std::vector<CourseStep> steps;
};

Result<std::vector<Exercise>> read_exercises(std::string_view text);
const std::vector<Exercise>& exercises();

// Replaces $sphere and the like. What the film does not have stays as it is.
std::string with_names(const std::string& words, const Workspace&);
// Returns whether a condition of a step holds.
bool holds(const std::string& condition, const Window&);
bool is_done(const CourseStep&, const Window&);
// Carries out what the step shows. Returns false if a line has an error.
bool show_how(const CourseStep&, Window&);

}  // namespace betwixt::studio
