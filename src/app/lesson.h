// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// A page that teaches one motion: what it does, factor by factor, and what the methods cost and lose.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "betwixt/algebra.h"

namespace betwixt {

struct LessonOptions {
  std::int64_t steps = 60;   // for the counts
  std::vector<Vec3> points;  // shown beside the figure
};

// One HTML file that needs nothing else; written whole or not at all. Errors: those of `check`; type (a motion that
// leaves the plane); range (a path that does not end in .html or .htm; steps below 1; more factors, points or larger
// numbers than a page can show); file, machine.
Status write_lesson(const std::string& path, const Motion&, const LessonOptions&);

}  // namespace betwixt
