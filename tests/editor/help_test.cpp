// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Every word has help that holds.
#include "language/help.h"

#include <algorithm>
#include <sstream>

#include "editor/author.h"
#include "language/reader.h"
#include "support/small_film.h"

namespace betwixt {
namespace {

// shows: G22
TEST(Help, EveryWordIsExplained) {
  std::vector<std::string_view> words;
  for (const auto& [verb, usage] : Reader::words()) words.push_back(verb);
  words.insert(words.end(), twerper_names.begin() + 1, twerper_names.end());
  words.insert(words.end(), kind_names.begin(), kind_names.end());
  for (const FunctionSpec& f : built_in_functions()) words.push_back(f.name);
  for (const std::string_view w : words)
    EXPECT_TRUE(std::any_of(help_entries().begin(), help_entries().end(), [&](const auto& e) { return e.word == w; }))
        << w;
  const Folder folder;
  Session s;
  s.open(folder / "film.bx");
  for (const HelpEntry& e : help_entries()) {
    const auto answer = s.enter(fmt::format("help {}", e.word));
    EXPECT_TRUE(answer.done) << e.word;
    EXPECT_NE(answer.said.find(e.sentence), std::string::npos) << e.word;
  }
  EXPECT_NE(s.enter("help sphre").said.find("did you mean 'sphere'?"), std::string::npos);
}

// shows: G22
TEST(Help, ExamplesRun) {
  for (const HelpEntry& e : help_entries()) {
    if (!in_a_film(e)) continue;
    const Folder folder;
    folder.put("film.bx", small_film);
    folder.put("colors.bx", "background navy\n");
    Session s;
    const auto begun = s.open(folder / "film.bx");
    EXPECT_EQ(begun.said, "");
    std::istringstream lines{std::string(e.example)};
    for (std::string line; std::getline(lines, line);) {
      const auto answer = s.enter(line);
      EXPECT_TRUE(answer.done) << e.word << ": " << line << "\n" << answer.said;
    }
  }
}

}  // namespace
}  // namespace betwixt
