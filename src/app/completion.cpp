// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "app/completion.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <string_view>

#include "app/subcommand.h"

namespace betwixt {
namespace {

constexpr const char* head =
    "# SPDX-FileCopyrightText: 2026 The Betwixt authors\n# SPDX-License-Identifier: Apache-2.0\n";

// Puts a text into single quotes, for all three shells.
std::string in_quotes(std::string_view text) {
  std::string out = "'";
  for (const char c : text) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return out + "'";
}

// Splits "-o,--output" into both names.
std::vector<std::string> spellings(const Parameter& p) {
  const std::size_t comma = p.name.find(',');
  if (comma == std::string::npos) return {p.name};
  return {p.name.substr(0, comma), p.name.substr(comma + 1)};
}

template <class See>
void each_parameter(const Subcommand& s, bool options, const See& see) {
  for (const Parameter& p : s.takes)
    if (p.is_option() == options && !p.hidden) see(p);
}

// Returns the words to offer for a parameter, without duplicates, or "".
std::string words_for(const Parameter& p) {
  if (p.offer != Offer::commands) return fmt::format("{}", fmt::join(p.words, " "));
  std::set<std::string> words(p.words.begin(), p.words.end());
  for (const Subcommand& s : subcommands()) words.insert(s.name);
  return fmt::format("{}", fmt::join(words, " "));
}

// Returns the words to offer for the arguments.
std::string argument_words(const Subcommand& s) {
  std::string all;
  each_parameter(s, false, [&](const Parameter& p) { all += words_for(p); });
  return all;
}

bool takes_script(const Subcommand& s) {
  return std::any_of(s.takes.begin(), s.takes.end(), [](const Parameter& p) { return p.offer == Offer::scripts; });
}

std::string command_names() {
  std::string out;
  for (const Subcommand& s : subcommands()) out += (out.empty() ? "" : " ") + s.name;
  return out;
}

// ---- bash

// Returns the case for an option's value.
std::string bash_value(const Parameter& p, const std::string& indent) {
  if (p.is_flag()) return {};
  const std::string words = words_for(p);
  const std::string offer = !words.empty()              ? "words=" + in_quotes(words)
                            : p.offer == Offer::nothing ? "return"
                                                        : "files='*'";
  return fmt::format("{}{}) {} ;;\n", indent, fmt::join(spellings(p), " | "), offer);
}

std::string bash_case(const Subcommand& s) {
  std::string names, values;
  each_parameter(s, true, [&](const Parameter& p) {
    names += fmt::format("{}{}", names.empty() ? "" : " ", fmt::join(spellings(p), " "));
    values += bash_value(p, "        ");
  });
  std::string out = fmt::format("    {})\n", s.name);
  if (!names.empty()) out += fmt::format("      options='{}'\n", names);
  if (takes_script(s)) out += "      scripts='!*.bx'\n";
  if (const std::string words = argument_words(s); !words.empty())
    out += fmt::format("      arguments={}\n", in_quotes(words));
  if (!values.empty()) out += fmt::format("      case $previous in\n{}      esac\n", values);
  return out + "      ;;\n";
}

// ---- zsh

// Escapes a text for the brackets and colons in a row of _arguments.
std::string zsh_escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '[' || c == ']' || c == ':' || c == '\\') out += '\\';
    out += c;
  }
  return out;
}

std::string zsh_action(const Parameter& p) {
  if (const std::string words = words_for(p); !words.empty()) return "(" + zsh_escaped(words) + ")";
  switch (p.offer) {
    case Offer::files:
      return "_files";
    case Offer::scripts:
      return "_files -g \"*.bx\"";
    case Offer::commands:  // their names are among the words
    case Offer::nothing:
      break;
  }
  return " ";
}

bool is_list(const Parameter& p) { return p.repeated || std::holds_alternative<std::vector<std::string>*>(p.into); }

// Returns the option that excludes this one; either of the two may declare it.
std::string rival(const Subcommand& s, const Parameter& p) {
  for (const Parameter& other : s.takes)
    if (other.excludes == p.name) return other.name;
  return p.excludes;
}

std::string zsh_option(const Subcommand& s, const Parameter& p) {
  const std::vector<std::string> names = spellings(p);
  const std::string equals = p.is_flag() ? "" : "=";
  std::string about = fmt::format("[{}]", zsh_escaped(p.sentence));
  if (!p.is_flag()) about += fmt::format(":{}:{}", zsh_escaped(p.value), zsh_action(p));
  if (names.size() > 1)
    return fmt::format("{}{{{},{}{}}}{}", in_quotes(fmt::format("({})", fmt::join(names, " "))), names[0], names[1],
                       equals, in_quotes(about));
  const std::string other = rival(s, p);
  return in_quotes((is_list(p) ? "*" : other.empty() ? "" : "(" + other + ")") + p.name + equals + about);
}

std::string zsh_argument(const Parameter& p) {
  return in_quotes(fmt::format("{}:{}:{}",
                               is_list(p)   ? "*"
                               : p.required ? ""
                                            : ":",
                               zsh_escaped(p.sentence), zsh_action(p)));
}

// ---- fish

std::string fish_option(const std::string& when, const Parameter& p) {
  std::string out = fmt::format("complete -c betwixt -n {}", in_quotes(when));
  for (const std::string& name : spellings(p))
    out += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
  if (const std::string words = words_for(p); !words.empty())
    out += " -x -a " + in_quotes(words);
  else if (!p.is_flag())
    out += p.offer == Offer::nothing ? " -x" : " -r -F";
  return out + " -d " + in_quotes(p.sentence) + "\n";
}

}  // namespace

std::string bash_completion() {
  std::string cases, values, names;
  for (const Subcommand& s : subcommands()) cases += bash_case(s);
  for (const Parameter& p : common_parameters()) names += " " + p.name, values += bash_value(p, "    ");
  return head + fmt::format(R"(_betwixt() {{
  local current=${{COMP_WORDS[COMP_CWORD]}} previous=${{COMP_WORDS[COMP_CWORD - 1]}} options='' words='' files='' scripts='' arguments=''
  if [ "$COMP_CWORD" = 1 ]; then
    mapfile -t COMPREPLY < <(compgen -W '{} --help --version' -- "$current")
    return
  fi
  case ${{COMP_WORDS[1]}} in
{}  esac
  case $previous in
{}  esac
  if [ -n "$words" ]; then
    mapfile -t COMPREPLY < <(compgen -W "$words" -- "$current")
  elif [ -n "$files" ]; then
    mapfile -t COMPREPLY < <(compgen -f -- "$current")
  elif [[ $current == -* ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$options{} --help" -- "$current")
  elif [ -n "$arguments" ]; then
    mapfile -t COMPREPLY < <(compgen -W "$arguments" -- "$current")
  elif [ -n "$scripts" ]; then
    mapfile -t COMPREPLY < <(compgen -f -X "$scripts" -- "$current"; compgen -d -- "$current")
  fi
}}
complete -o filenames -F _betwixt betwixt
)",
                            command_names(), cases, values, names);
}

std::string zsh_completion() {
  std::string commands, cases;
  for (const Subcommand& s : subcommands()) {
    commands += fmt::format("    {}\n", in_quotes(s.name + ":" + zsh_escaped(s.sentence)));
    cases += fmt::format("  {})\n    _arguments", s.name);
    const auto add = [&](const std::string& row) { cases += " \\\n      " + row; };
    each_parameter(s, true, [&](const Parameter& p) { add(zsh_option(s, p)); });
    each_parameter(s, false, [&](const Parameter& p) { add(zsh_argument(p)); });
    for (const Parameter& p : common_parameters()) add(zsh_option(s, p));
    add("'--help[this help]'");
    cases += " ;;\n";
  }
  return std::string("#compdef betwixt\n") + head +
         fmt::format(R"(if (( CURRENT == 2 )); then
  local -a commands=(
{}  )
  _describe command commands
  _arguments '--help[this help]' '--version[the version]'
  return
fi
local command=$words[2]
shift words
(( CURRENT-- ))
case $command in
{}esac
)",
                     commands, cases);
}

std::string fish_completion() {
  const std::string none = "not __fish_seen_subcommand_from $commands";
  std::string out = head + fmt::format("set -l commands {}\ncomplete -c betwixt -f\n", command_names());
  // The condition contains a variable of this file, so it needs double quotes.
  for (const Subcommand& s : subcommands())
    out += fmt::format("complete -c betwixt -n \"{}\" -a {} -d {}\n", none, s.name, in_quotes(s.sentence));
  out += fmt::format("complete -c betwixt -n \"{}\" -l version -d 'the version'\n", none);
  out += "complete -c betwixt -s h -l help -d 'this help'\n";
  std::string all, scripts;
  for (const Subcommand& s : subcommands()) {
    each_parameter(s, true,
                   [&](const Parameter& p) { out += fish_option("__fish_seen_subcommand_from " + s.name, p); });
    all += " " + s.name;
    if (takes_script(s)) scripts += " " + s.name;
    if (const std::string words = argument_words(s); !words.empty())
      out += fmt::format("complete -c betwixt -n '__fish_seen_subcommand_from {}' -a {}\n", s.name, in_quotes(words));
  }
  for (const Parameter& p : common_parameters()) out += fish_option("__fish_seen_subcommand_from" + all, p);
  return out +
         fmt::format("complete -c betwixt -n '__fish_seen_subcommand_from{}' -k -a '(__fish_complete_suffix .bx)'\n",
                     scripts);
}

}  // namespace betwixt
