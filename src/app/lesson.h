// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// A web page that teaches motions. It starts with one motion, which the reader can edit.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "betwixt/algebra.h"

namespace betwixt {

inline constexpr std::int64_t most_lesson_steps = 2'000;

struct LessonOptions {
  std::int64_t steps = 60;   // of the methods
  std::vector<Vec3> points;  // shown beside the figure
};

// Writes one HTML file that needs no others and contains the engine. It is written whole or not at all. Errors: those
// of `check`; range (a path that does not end in .html or .htm; steps below 1 or too many; more factors, points or
// larger numbers than a page can show); file; machine (the engine for pages is not installed).
Status write_lesson(const std::string& path, const Motion&, const LessonOptions&);

}  // namespace betwixt
