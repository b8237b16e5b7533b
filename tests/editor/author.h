// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Helpers for tests of sessions: prepared answers to questions, and a script of an author.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "betwixt/session.h"
#include "support/folder.h"

namespace betwixt {

inline Session::Callbacks answering(std::vector<std::string> answers, std::string* asked = nullptr) {
  Session::Callbacks callbacks;
  callbacks.ask = [answers, asked,
                   k = std::size_t{0}](const Session::Question& q) mutable -> std::optional<std::string> {
    if (asked) *asked += to_string(q);
    if (k == answers.size()) return std::nullopt;
    return answers[k++];
  };
  return callbacks;
}

// Opens a session on film.bx of the folder. Writes the text to this file first, if one is given.
inline Session opened(const Folder& folder, const char* text = nullptr, Session::Callbacks callbacks = {}) {
  if (text) folder.put("film.bx", text);
  Session s(std::move(callbacks));
  s.open(folder / "film.bx");
  return s;
}

inline void expect_done(Session& s, const std::string& line) {
  const auto answer = s.enter(line);
  EXPECT_TRUE(answer.done) << line << "\n" << answer.said;
}

inline constexpr const char* author =
    "# by hand\nrate 24\ncreate ball sphere  # round\nball.position\n  1f (0 10 0)\n  24f (8 10 0)";

}  // namespace betwixt
