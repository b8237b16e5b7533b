// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "app/code_errors.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>

#include "base/diagnostic.h"
#include "base/files.h"

namespace betwixt {
namespace {

// The error where its code stands in the script; without a place where it stands in a file that was loaded.
Diagnostic placed_error(const Frame::CodeError& e, const std::string& file) {
  Diagnostic d;
  d.what = fail(ErrorCode::type, e.message);
  d.what.place.file = file;
  const auto text = read_whole(file);
  if (text) point_at(d, *text, e.source);
  return d;
}

}  // namespace

void add_findings(Findings& found, const Frame& frame, const std::string& file) {
  const auto known = [&](const std::string& message) {
    return std::any_of(found.errors.begin(), found.errors.end(),
                       [&](const Diagnostic& d) { return d.what.message == message; });
  };
  for (const Frame::CodeError& e : frame.errors)
    if (!known(e.message)) found.errors.push_back(placed_error(e, file));
  for (const std::string& p : frame.problems)
    if (!known(p) && std::find(found.warnings.begin(), found.warnings.end(), p) == found.warnings.end())
      found.warnings.push_back(p);
}

Findings look_through(const Program& program, const std::string& file, Time first, Time last, int frames) {
  constexpr int looks = 60;
  const auto stop = std::chrono::steady_clock::now() + std::chrono::milliseconds(1500);
  Findings found;
  for (int k = 0, n = std::min(looks, frames); k < n && std::chrono::steady_clock::now() < stop; ++k)
    add_findings(found, program.frame(n > 1 ? Time{first.flicks + (last - first).flicks / (n - 1) * k} : first), file);
  return found;
}

bool stopped_by(const Findings& found, bool keep_going) {
  for (Diagnostic d : found.errors) {
    if (keep_going) d.severity = Severity::warning;
    std::fputs(to_string(d).c_str(), stderr);
  }
  if (found.errors.empty() || keep_going) return false;
  fmt::print(
      stderr,
      "betwixt: nothing was made; --keep-going makes it with the values that the tracks have without that code\n");
  return true;
}

}  // namespace betwixt
