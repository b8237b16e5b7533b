// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests the smallest film that uses each feature: the example of every word, from its text to pictures.
#include <gtest/gtest.h>

#include <set>

#include "betwixt/language.h"
#include "betwixt/program.h"
#include "betwixt/render.h"
#include "support/small_film.h"

namespace betwixt {
namespace {

TEST(Features, TheSmallestFilmOfEachIsRendered) {
  RenderOptions options;
  options.width = 64, options.height = 36;
  const auto renderer = make_renderer(options);
  ASSERT_TRUE(renderer) << renderer.error().message;
  const Document without = load_text(small_film, "film.bx").document;
  // Its example makes what it takes away.
  const std::set<std::string_view> changes_nothing = {"delete"};
  for (const HelpEntry& e : help_entries()) {
    // Two commands read a file, and `language` comes before the first text.
    if (!in_a_film(e) || e.word == "use" || std::string_view(e.example).starts_with("language ")) continue;
    const Loaded film = load_text(std::string(small_film) + std::string(e.example) + "\n", "film.bx");
    std::string said;
    for (const Diagnostic& d : film.diagnostics)
      if (d.severity == Severity::error) said += to_string(d);
    EXPECT_EQ(said, "") << e.word;
    EXPECT_EQ(film.document == without, changes_nothing.contains(e.word)) << e.word << ": " << e.example;
    const Program program = Program::compile(film.document);
    for (const double number : {1.0, 20.0, 60.0}) {
      const Frame frame = program.frame(film.document.rate().frame(number));
      EXPECT_TRUE(frame.problems.empty()) << e.word << ": " << frame.problems[0];
      Picture picture;
      const Status made = (*renderer)->render(frame, picture);
      EXPECT_TRUE(made) << e.word;
      EXPECT_EQ(picture.rgba.size(), 64u * 36 * 4) << e.word;
    }
  }
}

}  // namespace
}  // namespace betwixt
