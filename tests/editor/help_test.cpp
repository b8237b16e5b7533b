// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Every word must have help, and its examples must work.
#include "editor/help.h"

#include <algorithm>
#include <sstream>

#include "commands/foreign_words.h"
#include "commands/plugins.h"
#include "commands/verbs.h"
#include "editor/author.h"
#include "support/small_film.h"

namespace betwixt {
namespace {

// shows: G22
TEST(Help, EveryWordIsExplained) {
  std::vector<std::string_view> words = verb_words();
  words.insert(words.end(), twerper_names.begin() + 1, twerper_names.end());
  words.insert(words.end(), kind_names.begin(), kind_names.end());
  for (const FunctionSpec& f : built_in_functions()) words.push_back(f.name);
  for (const std::string_view w : words)
    EXPECT_TRUE(std::any_of(help_entries().begin(), help_entries().end(), [&](const auto& e) { return e.word == w; }))
        << w;
  const Folder folder;
  Session s = opened(folder);
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
    folder.put("de.po", "msgid \"The end\"\nmsgstr \"Ende\"\n");
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

// Words from elsewhere lead to those that are there; none of them is one itself.
TEST(Help, RoadsLeadToWords) {
  const auto has_help = [](std::string_view w) {
    return std::any_of(help_entries().begin(), help_entries().end(), [&](const HelpEntry& e) { return e.word == w; });
  };
  for (const ForeignWord& r : foreign_words()) {
    // The name of a function of few kinds, as speed of videos, has both: where it leads, and what it is there.
    EXPECT_FALSE(std::any_of(help_entries().begin(), help_entries().end(), [&](const HelpEntry& e) {
      return e.word == r.word && !e.function;
    })) << r.word;
    std::istringstream see{std::string(r.see)};
    int words = 0;
    for (std::string w; see >> w; ++words) EXPECT_TRUE(has_help(w)) << r.word << " leads to " << w;
    EXPECT_GT(words, 0) << r.word;
    EXPECT_TRUE(help_text(r.word, Scene()).starts_with(fmt::format("{}: {}", r.word, r.leads)));
  }
  for (const char* word : {"loop", "easing", "path", "alpha", "sheet", "time", "rgb", "channel", "f-curve", "property",
                           "ik", "depth-of-field", "dope-sheet", "keyframe", "interpolation"})
    EXPECT_FALSE(foreign_word_hint(word).empty()) << word;
  EXPECT_EQ(help_text("alpha", Scene()),
            "alpha: transparency goes the other way, from 0, solid, to 1: set ball.transparency 0.5\n"
            "  see: help transparency\n");
}

// Kinds have functions of one name and different meanings.
TEST(Help, AFunctionIsExplainedForEachKind) {
  for (const FunctionSpec& f : built_in_functions()) EXPECT_FALSE(f.sentence.empty()) << f.name;
  EXPECT_EQ(sentence_of("from=", Kind::arc), "The angle at which an arc begins, anticlockwise from the right.");
  EXPECT_EQ(sentence_of("music.from", Kind::sound), "The second of its file with which a sound begins.");
  EXPECT_EQ(sentence_of("points=", Kind::star), "How many points (tips) a star has.");
  EXPECT_EQ(sentence_of("size=", Kind::sphere), "") << "size is a command too, and a function of other kinds";
  EXPECT_TRUE(sentence_of("size").starts_with("The size in pixels for play"));
  EXPECT_TRUE(sentence_of("ease-in").starts_with("Begins slowly"));
  EXPECT_TRUE(sentence_of("ease-in=").find("arrives slowly") != std::string_view::npos);
  for (const char* of : {"sound", "trace", "arc"})
    EXPECT_NE(help_text("from", Scene()).find(fmt::format("from, a function of {}: ", of)), std::string::npos) << of;
  EXPECT_EQ(help_text("from", Scene(), Kind::sound).find("arc"), std::string::npos);
}

// shows: G22
TEST(Help, ExplainsProceduresOfAllRoles) {
  const Folder folder;
  Session s = opened(folder);
  for (const std::string_view role : role_names) {
    const std::string name = "my-" + std::string(role);
    expect_done(s, fmt::format("procedure {} {} lua \"1\"", name, role == "value" ? "" : role));
    const auto answer = s.enter("help " + name);
    EXPECT_TRUE(answer.done && answer.said.starts_with(name + ": ")) << answer.said;
    EXPECT_NE(answer.said.find("example: "), std::string::npos) << answer.said;
  }
  EXPECT_TRUE(s.enter("help").done);
  expect_done(s, "procedure hop command (who object, height number = 2, back time = none) \"Hops once.\" lua \"1\"");
  EXPECT_EQ(s.enter("help hop").said,
            "hop: A command of this film: Hops once.\n  usage: hop who=OBJECT [height=2] [back=TIME]\n");
}

TEST(Help, GroupsAreListed) {
  EXPECT_TRUE(
      help_text("twerpers", Scene()).starts_with("Twerpers (interpolation from one event to the next)\n  hold  "));
  for (const char* group : {"shell", "commands", "rows", "kinds", "functions", "filters", "options"}) {
    const std::string text = help_text(group, Scene());
    EXPECT_GT(std::count(text.begin(), text.end(), '\n'), 5) << group;
  }
}

TEST(Help, ExplainsMotions) {
  for (const char* letter : {"T", "R", "S"})
    EXPECT_TRUE(help_text(letter, Scene()).starts_with(std::string(letter) + ", a factor of a motion: a ")) << letter;
  EXPECT_NE(help_text("motion", Scene()).find("example: at 1f..48f ball.motion"), std::string::npos);
}

// shows: G15
TEST(Help, ExplainsWordsOfPlugins) {
  const std::string example = PLUGIN_DIR "/example.so";
  ASSERT_TRUE(use_plugin(example));
  Scene scene;
  adopt_plugins(scene);
  EXPECT_EQ(help_text("overshoot", scene),
            "overshoot: A twerper of the plug-in " + example +
                ": goes a tenth beyond the end and comes back.\n  example: at 12f ball.radius 2 overshoot\n");
  EXPECT_NE(help_overview(scene).find("  stairs           A filter of the plug-in"), std::string::npos);
}

// What a script is told of words that are not its own, and what it may not name so.
TEST(Help, WordsOfTheShellAreReserved) {
  for (const HelpEntry& e : shell_entries())
    EXPECT_NE(find_verb(e.word) != nullptr,
              std::find(reserved_words().begin(), reserved_words().end(), e.word) != reserved_words().end())
        << e.word;
  for (const std::string_view w : reserved_words())
    EXPECT_TRUE(std::any_of(help_entries().begin(), help_entries().end(), [&](const HelpEntry& e) {
      return e.group == HelpGroup::shell && e.word == w;
    })) << w;
}

}  // namespace
}  // namespace betwixt
