// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Declarations that the files of betwixt algebra share.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "betwixt/css.h"

namespace betwixt::algebra_command {

struct Call {
  std::string motion, method, origin, steps_text, css_to, css_under, size, font_size, viewport;
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
  std::vector<double> frames;  // empty means all
  std::optional<Method> method;
  Vec3 origin;
};

// Reads the number of an option.
Result<double> read_number(std::string_view text, std::string_view option);
// Reads points: two or three numbers with commas between them.
Result<std::vector<Point>> read_points(const std::string&);
// Prints an error below the place in its text. Returns the exit code.
int complain_about(const std::string& text, const Error&, const char* name = "motion");

struct Shown {
  std::vector<Point> points;
  std::optional<Mat4> matrix;  // of a CSS transform
};
// Prints frames as text or JSON. `show` computes a frame, or returns why it has none. `head` and `tail` are JSON before
// and after the frames. Returns the exit code.
int show_frames(const Call&, const Asked&, const std::string& head, const std::string& tail,
                const std::function<Status(double k, Shown&)>& show);

// Print or return the counts of operations, as text or JSON.
void print_counts(const Call&, const Asked&);
std::string count_json(const Call&, const Asked&);
// Returns whether the paper's geometric method is exact only at the motion's end, as in two rows of its table.
bool end_only(const Motion&);
// Returns the largest distance of the points from their exact places under such a method.
double off_the_way(const Call&, const Asked&);

// Prints the matrix in symbols, as text or JSON. Returns the exit code.
int show_symbols(const Call&, const Asked&);

// Returns whether the call needs more than a list of translations, rotations and scalings that starts from `none`.
bool beyond_motions(const Call&);
// Prints the frames of such a call. Returns the exit code.
int show_css(const Call&, const Asked&);
// Returns what the units of the page refer to, as far as the call says it.
Result<CssPage> read_page(const Call&);

}  // namespace betwixt::algebra_command
