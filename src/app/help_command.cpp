// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// betwixt help: help for a subcommand or a word of the language. Also prints files that are installed with the program.
#include <fmt/format.h>

#include "app/command.h"
#include "app/command_line.h"
#include "app/completion.h"
#include "app/editor_words.h"
#include "app/manual.h"
#include "app/reference.h"
#include "base/names.h"
#include "commands/plugins.h"
#include "editor/help.h"

namespace betwixt {
namespace {

struct HelpCall {
  std::string word, print;
  bool json = false;
};

// Lists all commands and the next steps.
std::string overview() {
  std::string out = "Betwixt makes films from scripts: event-driven animation.\nUsage: betwixt COMMAND …\n\nCommands\n";
  for (const Subcommand& s : subcommands()) out += fmt::format("  {:10} {}\n", s.name, s.sentence);
  return out +
         "\nbetwixt help COMMAND explains a command, as in betwixt help render.\nbetwixt help WORD explains a word of "
         "the language, as in betwixt help create.\nbetwixt shell makes a film line by line; there, help lists all "
         "words.\n";
}

std::string to_print(const std::string& what) {
  if (what == "bash") return bash_completion();
  if (what == "zsh") return zsh_completion();
  if (what == "fish") return fish_completion();
  if (what == "vim") return vim_syntax();
  if (what == "textmate") return textmate_grammar();
  if (what == "reference") return language_reference();
  if (what == "command-line") return command_line_reference();
  if (what == "llms") return words_for_assistants();
  return manual_page();
}

std::vector<std::string> words_of_the_language() {
  std::vector<std::string> all;
  for (const HelpEntry& e : help_entries()) all.emplace_back(e.word);
  return all;
}

int say(const std::string& text) {
  fmt::print("{}", text);
  return all_done;
}

int help(const HelpCall& call) {
  if (!call.print.empty()) return say(to_print(call.print));
  if (call.json) return say(words_json());
  if (call.word.empty()) return say(overview());
  std::vector<std::string_view> known = words_with_help();
  Scene words;
  adopt_plugins(words);
  const std::string text = help_text(call.word, words);
  for (const Subcommand& s : subcommands())
    if (s.name == call.word && s.name != "help")
      return say(help_of(s) + (text.empty() ? "" : "\n\nIn scripts:\n\n" + text));
  if (!text.empty()) return say(text);
  for (const Subcommand& s : subcommands()) known.push_back(s.name);
  return complain(unknown_name("help for", call.word, did_you_mean(call.word, known)), wrong_call);
}

const Enlisted enlisted_help(help, [](HelpCall& call) -> Subcommand {
  return {
      .rank = 120,
      .name = "help",
      .sentence = "explains a command, or a word of the language",
      .takes = {{.name = "WORD",
                 .sentence = "a command or a word; by default all commands are listed",
                 .into = &call.word,
                 .words = words_of_the_language(),
                 .offer = Offer::commands},
                flag("--json", "prints all words and commands as one JSON object", call.json),
                {.name = "--print",
                 .value = "WHAT",
                 .sentence = "a completion, a page of documentation, or colours of scripts for an editor",
                 .into = &call.print,
                 .hidden = true,
                 .words_only = true,
                 .words = {"bash", "zsh", "fish", "manual", "reference", "command-line", "vim", "textmate", "llms"}}},
      .example = "betwixt help copy"};
});

}  // namespace
}  // namespace betwixt
