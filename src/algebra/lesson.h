// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What a page that teaches a motion asks, and the answers as JSON. A string that is none, or that cannot be shown, is
// answered by {"error":{"message","hint","column","length"}}, column and length in characters, 0 where no place is
// known. Matrices are the twelve numbers of their upper three rows, row by row.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "algebra/study.h"

namespace betwixt::algebra::lesson {

inline constexpr std::int64_t drift_steps = 100'000;
inline constexpr std::size_t counted_for = 1'000;  // points that `best` is made for

// Motions of texts that a lesson can show. Errors: those of parse_motion and can_be_shown; name (a centre that is an
// object).
Result<Motion> read(std::string_view text, const Places& points = {});

// The string as it is: its text, factors, unit, and the matrices in letters, of each factor and of all.
std::string string_answer(std::string_view text, const Places& points);
// {"frames": [A(t)]} at `count` + 1 even times. This and the next are asked for every picture: whether the string can
// be shown is not looked at again.
std::string frames_answer(std::string_view text, double from, double to, int count, bool linear_law);
// A(t), the letters' values, and of each factor what of it is done by t.
std::string moment_answer(std::string_view text, double t);
// What the methods cost, where each of them has the points, and how the string is compiled.
std::string methods_answer(std::string_view text, std::int64_t steps, const Places& points);
// {"alone": [...], "renewed": [...], "marks": [...]}; null: beyond all numbers.
std::string drift_answer(std::string_view text, Method, bool linear_law, bool single, const Places& points);
std::string ways_answer(std::string_view text, const Places& points);
// {"text": ...}: the string with one thing of one factor changed: "by", "centre", "axis", "angle" (to.x, in degrees),
// "linear" (to.x, 0 or 1).
std::string changed_answer(std::string_view text, std::size_t factor, std::string_view what, Vec3 to);

}  // namespace betwixt::algebra::lesson
