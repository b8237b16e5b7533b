// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// An imaging server without sockets, with a clock that the tests set.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "server/imaging.h"
#include "support/folder.h"

namespace betwixt {

inline constexpr Nanos second = 1'000'000'000;
// Returns the time at which a tick begins.
inline Nanos tick(std::int64_t n) { return (n * second + 29) / 30; }

inline bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

class Stage {
 public:
  explicit Stage(Imaging::Options options = {}, const std::string& file = "", const std::string& save = "")
      : imaging(std::move(options)) {
    const auto begun = imaging.begin(file, save, false, 0);
    EXPECT_TRUE(begun) << (begun ? "" : begun.error().message);
  }
  std::string say(Imaging::Host host, const std::string& line, Nanos now = 0) {
    return imaging.enter(host, line, now).line;
  }
  void done(Imaging::Host host, const std::string& line, Nanos now = 0) {
    const std::string answer = say(host, line, now);
    EXPECT_TRUE(holds(answer, "\"ok\":true")) << line << "\n" << answer;
  }
  void refused(Imaging::Host host, const std::string& line, const std::string& why, Nanos now = 0) {
    const std::string answer = say(host, line, now);
    EXPECT_TRUE(holds(answer, "\"ok\":false") && holds(answer, why)) << line << "\n" << answer;
  }
  // Checks that the history, loaded as a script, makes this document. (R-E1c)
  void expect_history() const {
    const Loaded again = load_text(imaging.history(), "");
    EXPECT_FALSE(has_errors(again.diagnostics)) << to_string(again.diagnostics[0]) << imaging.history();
    EXPECT_TRUE(again.document == imaging.document()) << imaging.history();
  }
  Imaging imaging;
};

}  // namespace betwixt
