// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What the files of betwixt algebra share.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "betwixt/css.h"

namespace betwixt::algebra_command {

struct Call {
  std::string motion, method, origin, steps_text, css_to, css_under, size;
  std::optional<std::string> points, lesson;
  std::vector<std::string> at;
  std::int64_t steps = 24;
  bool count = false, json = false, inverse = false, css = false, to_css = false, accumulate = false, symbols = false;
};

struct Point {
  Vec3 at;
  int numbers = 2;
};

struct Asked {
  Motion motion;
  std::vector<Point> points;
  std::vector<double> frames;  // empty: all
  std::optional<Method> method;
  Vec3 origin;
};

// The number that an option has.
Result<double> read_number(std::string_view text, std::string_view option);
// Numbers with commas between them, two or three.
Result<std::vector<Point>> read_points(const std::string&);
// What is wrong with a text, under it. The exit code.
int complain_about(const std::string& text, const Error&, const char* name = "motion");

struct Shown {
  std::vector<Point> points;
  std::optional<Mat4> matrix;  // of CSS
};
// Shows frames as text or as JSON. `show` says what is in a frame, or why nothing is; `head` is what stands in JSON
// between the steps and the frames, `tail` behind them. The exit code.
int show_frames(const Call&, const Asked&, const std::string& head, const std::string& tail,
                const std::function<Status(double k, Shown&)>& show);

// Operations, as text or JSON.
void print_counts(const Call&, const Asked&);
std::string count_json(const Call&, const Asked&);
// Two rows of the source's table meet the motion at its end only.
bool end_only(const Motion&);
// How far from where they belong such a scheme has the points, at its worst.
double off_the_way(const Call&, const Asked&);

// The matrix in letters, as text or JSON. The exit code.
int show_symbols(const Call&, const Asked&);

// Whether what is asked is more than what a browser shows from `none` to a list of moving, turning and scaling.
bool beyond_motions(const Call&);
// The frames of that. The exit code.
int show_css(const Call&, const Asked&);
// What percentages are of; none where nothing is said of it.
Result<std::optional<CssSize>> read_size(const Call&);

}  // namespace betwixt::algebra_command
