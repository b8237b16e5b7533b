// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The questions of the lesson's page about a motion, answered as JSON. For a string that cannot be read or shown the
// answer is {"error":{"message","hint","column","length"}}, column and length in characters, 0 if the place is unknown.
// Matrices are the twelve numbers of their first three rows, row by row.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "algebra/study.h"

namespace betwixt::algebra::lesson {

inline constexpr std::int64_t drift_steps = 100'000;
inline constexpr std::size_t counted_for = 1'000;  // the number of points for the plan of `best`

// Reads a motion that the lesson can show. Errors: those of parse_motion and can_be_shown; name (a centre that is an
// object).
Result<Motion> read(std::string_view text, const Places& points = {});

// Returns the string itself: its text, factors, unit, and the matrices in symbols, of each factor and of all.
std::string string_answer(std::string_view text, const Places& points);
// Returns {"frames": [A(t)]} at `count` + 1 even times. The page calls this and moment_answer for every picture, so
// they do not check again whether the string can be shown.
std::string frames_answer(std::string_view text, double from, double to, int count, bool linear_law);
// Returns A(t), the letters' values, and the part of each factor at t.
std::string moment_answer(std::string_view text, double t);
// Returns the costs of the methods, their points, and how the string is compiled.
std::string methods_answer(std::string_view text, std::int64_t steps, const Places& points);
// Returns {"alone": [...], "renewed": [...], "marks": [...]}; null for infinity.
std::string drift_answer(std::string_view text, Method, bool linear_law, bool single, const Places& points);
std::string ways_answer(std::string_view text, const Places& points);
// Returns {"text": ...}: the string with one field of one factor changed: "by", "centre", "axis", "angle" (to.x, in
// degrees), "linear" (to.x, 0 or 1).
std::string changed_answer(std::string_view text, std::size_t factor, std::string_view what, Vec3 to);

}  // namespace betwixt::algebra::lesson
