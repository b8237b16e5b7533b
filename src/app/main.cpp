// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cstdio>
#include <exception>

#include "app/command.h"
#include "base/names.h"
#include "language/help.h"
#include "language/plugins.h"

namespace betwixt {
namespace {

constexpr const char* version = "betwixt " BETWIXT_VERSION;

std::string hinted(const std::string& what, const std::string& word, const std::vector<std::string>& known) {
  const std::string hint = did_you_mean(word, {known.begin(), known.end()});
  return what + " '" + word + "'" + (hint.empty() ? "" : "\n  " + hint);
}

std::vector<std::string> option_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* o : app.get_options())
    for (const std::string& name : o->get_lnames()) names.push_back("--" + name);
  return names;
}

// What is wrong with a command line, in our words where the parser's are poor.
std::string explain(const CLI::App& app, const CLI::ParseError& e) {
  const auto asked = app.get_subcommands();
  const CLI::App& place = asked.empty() ? app : *asked.front();
  for (const std::string& word : app.remaining(true))
    if (word.size() > 1 && word[0] == '-')
      return hinted("no such option", word.substr(0, word.find('=')), option_names(place));
  for (const std::string& word : app.remaining(true)) {
    if (!asked.empty()) return fmt::format("'{}' is one word too many", word);
    std::vector<std::string> names;
    for (const CLI::App* sub : app.get_subcommands([](const CLI::App*) { return true; }))
      names.push_back(sub->get_name());
    return hinted("no such command", word, names);
  }
  return e.what();
}

// All commands, and where to go on.
std::string overview(const CLI::App& app) {
  std::string out = fmt::format("{}\nUsage: betwixt COMMAND …\n\nCommands\n", app.get_description());
  for (const CLI::App* sub : app.get_subcommands([](const CLI::App*) { return true; }))
    out += fmt::format("  {:10} {}\n", sub->get_name(), sub->get_description());
  return out +
         "\nbetwixt help COMMAND says more about one, as in betwixt help render.\n"
         "betwixt help WORD explains a word of the language, as in betwixt help create.\n"
         "betwixt shell makes a film line by line; there, help lists all words.\n";
}

// betwixt help [WORD]: a subcommand's help, or a word's of the language.
int help(const CLI::App& app, const std::string& word) {
  if (word.empty()) return fmt::print("{}", overview(app)), all_done;
  std::vector<std::string_view> known;
  std::vector<std::string> commands;
  for (const CLI::App* sub : app.get_subcommands([](const CLI::App*) { return true; })) {
    if (sub->get_name() == word && word != "help") return fmt::print("{}", sub->help("betwixt")), all_done;
    commands.push_back(sub->get_name());
  }
  Scene words;
  adopt_plugins(words);
  if (const std::string text = help_text(word, words); !text.empty()) return fmt::print("{}", text), all_done;
  for (const HelpEntry& e : help_entries()) known.push_back(e.word);
  known.insert(known.end(), commands.begin(), commands.end());
  return complain(fail(Code::name, fmt::format("there is no help about '{}'", word), did_you_mean(word, known)),
                  wrong_call);
}

int run(int argc, char** argv) {
  CLI::App app("Betwixt makes films from scripts: event-driven animation.", "betwixt");
  int exit_code = all_done;
  app.set_version_flag("--version", version, "the version");
  app.set_help_flag("-h,--help", "this help, or a command's");
  app.get_formatter()->column_width(28);
  app.footer("Example:\n  betwixt render examples/bounce.bx -o bounce.mp4");
  app.require_subcommand(0, 1);
  for (const auto& add : {add_render, add_frame, add_play, add_eval, add_plot, add_check, add_tidy, add_algebra,
                          add_contacts, add_shell, add_serve})
    add(app, exit_code);
  std::string word;
  CLI::App* helping = app.add_subcommand("help", "explains a command, or a word of the language");
  helping->add_option("WORD", word, "what is asked about; all commands if none is")->type_name("");
  helping->footer("Example:\n  betwixt help copy");
  helping->callback([&] { exit_code = help(app, word); });
  for (CLI::App* sub : app.get_subcommands([](const CLI::App*) { return true; })) {
    sub->set_help_flag("-h,--help", "this help");
    sub->add_flag("--read-anywhere", load_options().read_anywhere, "let the script read files outside its own folder");
    sub->add_option_function<std::vector<std::string>>(
           "--load",
           [](const std::vector<std::string>& files) {
             for (const std::string& file : files)
               if (const Status s = use_plugin(file); !s) throw CLI::ValidationError("--load", s.error().message);
           },
           "a plug-in: its words are the script's")
        ->allow_extra_args(false)
        ->type_name("PLUGIN");
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& e) {
    return app.exit(e);
  } catch (const CLI::ParseError& e) {
    const auto asked = app.get_subcommands();
    fmt::print(stderr, "betwixt: {}\n  see betwixt {}--help\n", explain(app, e),
               asked.empty() ? "" : asked.front()->get_name() + " ");
    return wrong_call;
  }
  if (!app.get_subcommands().empty()) {
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0)
      return complain(fail(Code::machine, "the answer cannot be written to standard output"), machine_failed);
    return exit_code;
  }
  fmt::print(stderr, "{}", app.help());
  return wrong_call;
}

}  // namespace
}  // namespace betwixt

int main(int argc, char** argv) {
  try {
    return betwixt::run(argc, argv);
  } catch (const std::exception& e) {  // memory that is not to be had, above all
    fmt::print(stderr, "betwixt: the machine failed: {}\n", e.what());
    return betwixt::machine_failed;
  }
}
