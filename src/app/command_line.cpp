// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "app/command_line.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>

#include "app/command.h"
#include "app/version.h"
#include "base/names.h"
#include "base/tell_user.h"

namespace betwixt {
namespace {

std::vector<int> as_numbers(const std::vector<std::string>& words) {
  std::vector<int> all;
  for (const std::string& w : words) all.push_back(std::stoi(w));
  return all;
}

CLI::Option* add_reader(CLI::App& app, const Parameter& p, const ReadValue& read) {
  const auto take = [read, name = p.name](const std::string& text) {
    if (const Status s = read(text); !s) throw CLI::ValidationError(name, s.error().message);
  };
  if (!p.repeated) return app.add_option_function<std::string>(p.name, take, p.sentence);
  const auto take_all = [take](const std::vector<std::string>& texts) {
    for (const std::string& text : texts) take(text);
  };
  return app.add_option_function<std::vector<std::string>>(p.name, take_all, p.sentence)->allow_extra_args(false);
}

CLI::Option* add_plain(CLI::App& app, const Parameter& p) {
  return std::visit(
      [&](const auto& into) -> CLI::Option* {
        using To = std::decay_t<decltype(into)>;
        if constexpr (std::is_same_v<To, bool*>)
          return app.add_flag(p.name, *into, p.sentence);
        else if constexpr (std::is_same_v<To, ReadValue>)
          return add_reader(app, p, into);
        else
          return app.add_option(p.name, *into, p.sentence);
      },
      p.into);
}

void add_parameter(CLI::App& app, const Parameter& p) {
  CLI::Option* o = add_plain(app, p);
  o->required(p.required);
  if (!p.is_flag()) o->type_name(p.value);
  if (p.separated) o->delimiter(',')->allow_extra_args(false);
  if (p.words_only && std::holds_alternative<int*>(p.into))
    o->check(CLI::IsMember(as_numbers(p.words)).description(""));
  else if (p.words_only)
    o->check(CLI::IsMember(p.words).description(""));
  if (p.range) o->check(CLI::Range(p.range->first, p.range->second).description(""));
  if (p.hidden) o->group("");
}

// Adds parameters in the order of the rows, but hidden ones first, because after the last visible one they would leave
// an empty line. Needs and excludes are set when all options exist.
CLI::App* add_subcommand(CLI::App& app, const Subcommand& s) {
  CLI::App* sub = app.add_subcommand(s.name, s.sentence);
  for (const bool hidden : {true, false})
    for (const Parameter& p : s.takes)
      if (p.hidden == hidden) add_parameter(*sub, p);
  for (const Parameter& p : s.takes) {
    if (!p.needs.empty()) sub->get_option(p.name)->needs(sub->get_option(p.needs));
    if (!p.excludes.empty()) sub->get_option(p.name)->excludes(sub->get_option(p.excludes));
  }
  sub->footer((s.note.empty() ? "" : s.note + "\n") + "Example:\n  " + s.example);
  sub->set_help_flag("-h,--help", "this help");
  for (const Parameter& p : common_parameters()) add_parameter(*sub, p);
  return sub;
}

std::string hinted(const std::string& what, const std::string& word, const std::vector<std::string>& known) {
  const std::string hint = did_you_mean(word, {known.begin(), known.end()}).text;
  return what + " '" + word + "'" + (hint.empty() ? "" : "\n  " + hint);
}

std::vector<std::string> option_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* o : app.get_options())
    for (const std::string& name : o->get_lnames())
      if (!o->get_group().empty()) names.push_back("--" + name);
  return names;
}

// Describes an error of the command line, in our words where the parser's are poor.
std::string explain(const CLI::App& app, const CLI::ParseError& e) {
  const auto asked = app.get_subcommands();
  const CLI::App& place = asked.empty() ? app : *asked.front();
  for (const std::string& word : app.remaining(true))
    if (word.size() > 1 && word[0] == '-')
      return hinted("no such option", word.substr(0, word.find('=')), option_names(place));
  for (const std::string& word : app.remaining(true)) {
    if (!asked.empty()) return fmt::format("'{}' is not expected here", word);
    std::vector<std::string> names;
    for (const Subcommand& s : subcommands()) names.push_back(s.name);
    if (word.ends_with(".bx"))
      return fmt::format("no such command '{0}'\n  to play this script: betwixt play {0}", word);
    return hinted("no such command", word, names);
  }
  return e.what();
}

// Sets the program's own options and help.
void describe(CLI::App& app) {
  app.set_version_flag("-V,--version", version_line(), "the version, and the commit that it was built from");
  app.set_help_flag("-h,--help", "this help, or a command's");
  app.get_formatter()->column_width(28);
  app.footer("Example:\n  betwixt render examples/bounce.bx -o bounce.mp4");
  app.require_subcommand(0, 1);
}

}  // namespace

std::string help_of(const Subcommand& s) {
  CLI::App app;
  describe(app);
  return add_subcommand(app, s)->help("betwixt");
}

int command_line(int argc, char** argv) {
  CLI::App app("Betwixt makes films from scripts: event-driven animation.", "betwixt");
  describe(app);
  for (const Subcommand& s : subcommands()) add_subcommand(app, s);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& e) {
    return app.exit(e);
  } catch (const CLI::ParseError& e) {
    const auto asked = app.get_subcommands();
    tell_user(fmt::format("betwixt: error: {}\n  see betwixt {}--help\n", explain(app, e),
                          asked.empty() ? "" : asked.front()->get_name() + " "));
    return wrong_call;
  }
  for (const Subcommand& s : subcommands()) {
    if (!app.got_subcommand(s.name)) continue;
    const int exit_code = s.run();
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0)
      return complain(fail(ErrorCode::machine, "the output cannot be written to standard output"), machine_failed);
    return exit_code;
  }
  fmt::print(stderr, "{}", app.help());
  return wrong_call;
}

}  // namespace betwixt
