// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests plug-ins in the language: their words work like the built-in ones.
#include <filesystem>

#include "support/loaded_film.h"

namespace betwixt {
namespace {

std::string at(const std::string& name) { return PLUGIN_DIR "/" + name + ".so"; }

std::string refusal(const std::string& name) {
  const Status s = use_plugin(at(name));
  EXPECT_FALSE(s) << name;
  return s ? "" : s.error().message;
}

// shows: G15 G17 G19
TEST(Plugins, TheirWordsAreUsedAndExplainedLikeBuiltInOnes) {
  ASSERT_TRUE(use_plugin(at("example")));
  ASSERT_TRUE(use_plugin(at("example")));  // again: nothing new
  const LoadedFilm s(
      "create a sphere\na.radius\n  1f 1 overshoot\n  25f 3\na.position.x\n  1f 0 linear\n  25f 1\n"
      "filter a.position.x stairs step=0.5\n");
  const double v = 0.5 - 1, more = 1.70158;
  expect_numbers(s, {{"a.radius", "13f", {1 + 2 * (1 + v * v * ((more + 1) * v + more))}},
                     {"a.position.x", "6f", {0}},
                     {"a.position.x", "8f", {0.5}}});
  EXPECT_EQ(all_told(read("create a sphere\nat 1f a.radius 2 overshot\n")),
            std::vector<std::string>{"name 2:18 overshot"});
  EXPECT_EQ(read("create a sphere\nat 1f a.radius 2 overshot\n").diagnostics.at(0).what.hint,
            "did you mean 'overshoot'?");
}

// shows: G14 G19
TEST(Plugins, TheirKindsAreMadeWhenTheyAreUsed) {
  ASSERT_TRUE(use_plugin(at("example")) && use_plugin(at("spoilt")));
  EXPECT_EQ(read("create a sphere\n").document.names().size(), 1u);
  const LoadedFilm film(
      "create left signal position=(-2 0 0)\ncreate right signal position=(2 0 0)\nset right/top.color red\n"
      "set signal/top.radius 0.25\n");
  const std::vector<std::string> names = film.loaded.document.names();
  EXPECT_EQ(names.size(), 12u);
  expect_numbers(film, {{"left/top.radius", "1f", {0.25}}, {"right/top.radius", "1f", {0.25}}});
  expect_place(film, "left/top", "1f", {-2, 0.5, 0.15});
  EXPECT_EQ(film.frame("1f").items.size(), 8u);  // the model is hidden
  EXPECT_TRUE(read(write(film.loaded.document)).document == film.loaded.document);
  EXPECT_EQ(all_told(read("create signal box\ncreate left signal\n")), std::vector<std::string>{"name 2:13 signal"});
  const Loaded spoilt = read("create a spoilt\n");
  EXPECT_EQ(all_told(spoilt), std::vector<std::string>{"name 1:10 spoilt"}) << said(spoilt.diagnostics);
  EXPECT_TRUE(spoilt.document.names().empty());
  EXPECT_EQ(read("create a signl\n").diagnostics.at(0).what.hint, "did you mean 'signal'?");
}

// shows: G19
TEST(Plugins, WordsThatAreTakenAreRefused) {
  EXPECT_EQ(refusal("colliding"), at("colliding") + ": it registers 'quantise', which is already a filter");
  ASSERT_TRUE(use_plugin(at("example")));
  const std::string copy = testing::TempDir() + "betwixt-copy.so";
  std::filesystem::copy_file(at("example"), copy, std::filesystem::copy_options::overwrite_existing);
  const Status s = use_plugin(copy);
  ASSERT_FALSE(s);
  EXPECT_EQ(s.error().message, copy + ": it registers 'overshoot', which " + at("example") + " has already registered");
  EXPECT_EQ(all_told(read("procedure quantise filter lua \"1\"\n")), std::vector<std::string>{"name 1:11 quantise"});
}

// shows: G19
TEST(Plugins, ScriptsDoNotLoadThem) {
  const Loaded l = read("load swirl.so\n");
  EXPECT_EQ(all_told(l), std::vector<std::string>{"name 1:1 load"});
  EXPECT_EQ(l.diagnostics.at(0).what.hint, "load it when you show the film: betwixt play --load PLUGIN FILE");
  EXPECT_EQ(read("create a sphere\nat 1f a.radius 2 swirly\n").diagnostics.at(0).what.hint,
            "if a plug-in has it: --load PLUGIN");
}

}  // namespace
}  // namespace betwixt
