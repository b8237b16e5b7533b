// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Golden films: what a film must show, in a file X.expect beside X.bx.
//
//   at 48f ball.position (1 2 3) within 0.001
//   size 320x180
//   frame 48f "bounce-48.png" within 2
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "betwixt/document.h"
#include "betwixt/result.h"

namespace betwixt {

// A value that the film must have at a time.
struct ExpectedValue {
  std::string time, target, value;
  double within = 1e-6;
};
// A frame that must look like a picture.
struct ExpectedPicture {
  std::string time, path;  // the path is relative to the file
  std::optional<std::pair<int, int>> size;
  double within = 2;  // of 255
};
struct Expectation {
  int line = 0;
  std::variant<ExpectedValue, ExpectedPicture> what;
};
// Errors: syntax; the place has the line.
Result<std::vector<Expectation>> read_expectations(std::string_view text);

struct GoldenResult {
  std::size_t checks = 0;
  std::vector<std::string> failures;  // a line each, with its place
  std::vector<std::string> written;   // pictures
};
// Checks one film: X.bx for the file X.expect. `update`: writes the pictures instead of comparing them.
GoldenResult check_golden(const std::string& expect_file, bool update);
// Returns the files X.expect of a folder and below, or the one that a file X.expect or X.bx means.
std::vector<std::string> golden_files(const std::string& path);

}  // namespace betwixt
