// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests how errors are printed on a terminal.
#include "base/diagnostic.h"

#include <gtest/gtest.h>

#include <sstream>

namespace betwixt {
namespace {

Diagnostic marked(const std::string& line, int caret, int length) {
  Diagnostic d;
  d.severity = Severity::error;
  d.what.message = "no";
  d.what.place = {"f.bx", 1, caret + 1, length};
  d.line = line, d.caret = caret;
  return d;
}

std::vector<std::string> shown(const Diagnostic& d) {
  std::istringstream in(to_string(d));
  std::vector<std::string> out;
  for (std::string line; std::getline(in, line);) out.push_back(line);
  return out;
}

TEST(ShownDiagnostic, ErrorsHaveNoLine) {
  EXPECT_EQ(to_string(fail(ErrorCode::file, "there is no file 'a.bx'", "did you mean 'b.bx'?")),
            "error: there is no file 'a.bx'\n  did you mean 'b.bx'?\n");
}

TEST(ShownDiagnostic, NothingIsObeyedByATerminal) {
  Diagnostic d = marked("say '\x1b]0;x\x07\u202e' \x80", 0, 3);
  d.what.message = "no '\x1b[2J'\nthe next line";
  d.what.hint = "\u009b2J", d.what.place.file = "\x1b.bx";
  const std::string all = to_string(d);
  for (const char c : all) EXPECT_TRUE(c == '\n' || (c >= ' ' && c < 127)) << static_cast<int>(c);
  EXPECT_EQ(shown(d)[0], "\\x1b.bx:1:1: error: no '\\x1b[2J'");
}

// The mark stands below what it marks, however much wider that became.
TEST(ShownDiagnostic, TheMarkStandsBelowWhatItMarks) {
  const std::vector<std::string> pieces = {"a", "é", "\x1b", "\u202e", "中", "\xff"},
                                 seen = {"a", "é", "\\x1b", "\\u{202e}", "中", "\\xff"};
  const auto characters = [](const std::string& s) {
    int n = 0;
    for (const char c : s) n += (c & 0xC0) != 0x80;
    return n;
  };
  for (std::size_t i = 0; i < pieces.size(); ++i)
    for (std::size_t j = 0; j < pieces.size(); ++j) {
      const auto lines = shown(marked(pieces[i] + "x" + pieces[j] + "y", 2, 2));
      EXPECT_EQ(lines[1], "  " + seen[i] + "x" + seen[j] + "y");
      EXPECT_EQ(lines[2], std::string(static_cast<std::size_t>(2 + characters(seen[i]) + 1), ' ') + "^" +
                              std::string(static_cast<std::size_t>(characters(seen[j])), '~'));
    }
  EXPECT_EQ(shown(marked("\ta", 1, 1))[2], "  \t^");
  EXPECT_EQ(shown(marked("ab", 2, 1))[2], "    ^") << "behind the end";
}

}  // namespace
}  // namespace betwixt
