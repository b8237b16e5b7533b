// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What is said of the whole document.
#include "support/loaded_film.h"

namespace betwixt {
namespace {

TEST(Settings, SettingsOfTheDocument) {
  const LoadedFilm s("rate 30000/1001\nticks 60\nrange 1f 100f\nbackground #336699\nnotes off\npolicy ignore\n");
  EXPECT_EQ(s.loaded.document.rate(), (Rate{30000, 1001}));
  EXPECT_EQ(s.loaded.document.frame_count(), 100);
  EXPECT_NEAR(s.program.frame({}).background->x, std::pow((0.2 + 0.055) / 1.055, 2.4), 1e-12);
  EXPECT_EQ(LoadedFilm("").loaded.document.frame_count(), 24);
}

// shows: G27
TEST(Settings, PolicyDecidesWhatAMeaninglessValueGets) {
  const LoadedFilm translate("create b sphere\npolicy translate\nset b.radius (3 4 0)\nset b.position 2\n");
  expect_numbers(translate, "b.radius", "1f", {5});
  expect_numbers(translate, "b.position", "1f", {2, 2, 2});
  const Loaded ignore = read("create b sphere\npolicy ignore\nset b.radius (3 4 0)\nset b.radius 2\n");
  ASSERT_EQ(ignore.diagnostics.size(), 1u);
  EXPECT_EQ(ignore.diagnostics[0].severity, Severity::warning);
  EXPECT_EQ(ignore.diagnostics[0].what.message, "ignored: a number is wanted here, not a vector");
  EXPECT_EQ(errors(read("create b sphere\nset b.radius (3 4 0)\n")),
            (std::vector<std::string>{"2:14: a number is wanted here, not a vector"}));
}

}  // namespace
}  // namespace betwixt
