// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The words of the shell.
#include <algorithm>
#include <filesystem>

#include "editor/describe.h"
#include "editor/help.h"
#include "editor/plain_values.h"
#include "editor/session_state.h"

namespace betwixt {
namespace {

namespace fs = std::filesystem;

// Returns the first argument.
std::string argument(const std::vector<std::string>& words) { return words.size() > 1 ? words[1] : ""; }

constexpr std::size_t any_number = 1 << 30;

}  // namespace

using Answer = Session::Answer;

std::span<const Session::State::Word> Session::State::words() {
  static constexpr Word all[] = {
      {"help", "help [WORD]", "Explains a word; without one, lists all words.", "help copy", 1, &State::help, "WORD"},
      {"list", "list [PATTERN]", "Lists the objects, their kinds and how many events they have.", "list wheel*", 1,
       &State::list, "OBJECT"},
      {"describe", "describe NAME|TARGET",
       "Prints an object with its functions and its parent; of a target, its events.", "describe ball", 1,
       &State::describe, "OBJECT QUERY"},
      {"undo", "undo", "Undoes the last command, without limit.", "undo", 0, &State::undo, "NUMBER"},
      {"redo", "redo", "Repeats the last undone command.", "redo", 0, &State::redo, "NUMBER"},
      {"notes", "notes", "Without a word, lists the notes and their times.", "notes", 0, &State::notes},
      {"plot", "plot TARGET [-> FILE.svg]", "Draws values against time, in an SVG file.",
       "plot ball.position -> ball.svg", any_number, &State::plot, "QUERY…"},
      {"play", "play [A..B], or play A to the end", "Plays the film, or a part of it, in the terminal; q returns.",
       "play 1f..24f", 1, &State::play, "NUMBER"},
      {"eval", "eval TARGET… [at TIME[,TIME…]]",
       "Prints values at times; of an object, all values that differ from the default.", "eval ball.position at 13f",
       any_number, &State::eval, "OBJECT QUERY…"},
      {"style", "style [NAME]", "The style of play from now on: shaded, wireframe, hidden-line or traced.",
       "style wireframe", 1, &State::picture, "STYLE"},
      {"samples", "samples [1|4|9|16|auto]", "The number of samples per pixel for play from now on; more is smoother.",
       "samples 4", 1, &State::picture},
      {"size", "size [WxH]", "The size in pixels for play from now on.", "size 640x360", 1, &State::picture},
      {"stop", "stop", "Stops the film.", "stop", 0, &State::stop},
      {"rewrite", "rewrite FIRST..LAST \"…\"",
       "Changes lines of the script's text; after that, commands change the text in place, not below it.",
       "rewrite 2..2 \"create ball sphere\"", any_number, &State::rewrite_word, "NUMBER…"},
      {"save", "save [FILE]", "Writes your text unchanged, and the commands since then below it.", "save film.bx", 1,
       &State::save_word, "FILE"},
      {"open", "open FILE", "Opens another script; asks first if something is not saved.", "open bounce.bx", 1,
       &State::reopen, "FILE"},
      {"load", "load FILE", "Loads a plug-in; its words are then used like all others.", "load ./swirl.so", 1,
       &State::load, "FILE"},
      {"quit", "quit", "Ends the session; asks first if something is not saved. exit and Ctrl-D are the same.", "quit",
       0, &State::quit, "NUMBER"},
      {"exit", "exit", "The same as quit.", "exit", 0, &State::quit, "NUMBER"},
  };
  return all;
}

const Session::State::Word* Session::State::find_word(std::string_view word) {
  for (const Word& w : words())
    if (w.word == word) return &w;
  return nullptr;
}

std::vector<HelpEntry> shell_entries() {
  std::vector<HelpEntry> all;
  for (const Session::State::Word& w : Session::State::words())
    all.push_back({HelpGroup::shell, w.word, w.sentence, w.usage, w.example});
  return all;
}

Answer Session::State::help(const Words& w) { return answer_of(look_up(document(), argument(w))); }
Answer Session::State::list(const Words& w) { return answer_of(list_objects(document(), argument(w))); }
Answer Session::State::describe(const Words& w) { return answer_of(betwixt::describe(document(), argument(w))); }
Answer Session::State::notes(const Words&) { return done(list_notes(document())); }
Answer Session::State::stop(const Words&) { return refused("nothing is playing", "while a film plays, q stops it"); }

Answer Session::State::picture(const Words& w) {
  if (!callbacks.set_play_option) return refused("films cannot be played here");
  return answer_of(callbacks.set_play_option(w[0], argument(w)));
}

// TARGET … [at] T[,T…]
Answer Session::State::eval(const Words& w) {
  std::vector<std::string> patterns;
  std::vector<std::pair<std::string, Time>> times;
  for (std::size_t i = 1; i < w.size(); ++i) {
    if (w[i] == "at" && i + 1 < w.size()) continue;
    if (!starts_like_time(w[i][0])) {
      patterns.push_back(w[i]);
      continue;
    }
    const bool bare = w[i].find_first_not_of("0123456789.-") == std::string::npos;  // frames, as for `play`
    const Result<Time> t = parse_time(bare ? w[i] + "f" : w[i], document());
    if (!t) return refused(t.error());
    times.emplace_back(w[i], *t);
  }
  if (times.empty()) times.emplace_back(format_time(document().range().first, document()), document().range().first);
  return answer_of(values_at(document(), patterns, times));
}

Answer Session::State::play(const Words& w) {
  if (!callbacks.play) return refused("films cannot be played here");
  return answer_of(callbacks.play(document(), argument(w)));
}

Answer Session::State::load(const Words& w) {
  if (w.size() < 2) return refused("a file name is missing here", "usage: load FILE");
  if (!callbacks.load_plugin) return refused("plug-ins cannot be loaded here");
  return answer_of(callbacks.load_plugin(w[1]));
}

Answer Session::State::plot(const Words& w) {
  const bool named = w.size() >= 3 && w[w.size() - 2] == "->";
  if (w.size() != (named ? 4 : 2))
    return refused("plot needs one target or pattern", "usage: plot TARGET [-> FILE.svg]");
  if (!callbacks.plot) return refused("plots cannot be drawn here");
  std::string to = named ? w.back() : "";
  if (to.empty()) {
    std::string name = w[1];
    for (char& c : name)
      if (c == '/' || c == '*' || c == '?') c = '_';
    to = (fs::path(file).parent_path() / (name + ".svg")).string();
  }
  std::error_code ignored;
  if (fs::exists(to, ignored) && std::find(drawn.begin(), drawn.end(), to) == drawn.end() &&
      choose({{}, fmt::format("File '{}' already exists; overwrite it", to), {"yes", "no"}}) != std::size_t{0})
    return {false, false, false, "not drawn\n"};
  if (Status s = callbacks.plot(document(), w[1], to); !s) return refused(s.error());
  drawn.push_back(to);
  return done(fmt::format("drawn in '{}'\n", to));
}

}  // namespace betwixt
