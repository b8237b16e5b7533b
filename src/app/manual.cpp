// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "app/manual.h"

#include <fmt/format.h>

#include <string_view>

#include "app/manual_page.h"
#include "app/markup.h"
#include "app/subcommand.h"

namespace betwixt {
namespace {

// Escapes a text for troff.
std::string roff(std::string_view text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    constexpr std::string_view dots = "…";
    if (text.substr(i).starts_with(dots))
      out += "...", i += dots.size() - 1;
    else if (text[i] == '\\')
      out += "\\e";
    else if (text[i] == '-')
      out += "\\-";
    else if (text[i] == '"')
      out += "\\(dq";
    else
      out += text[i];
  }
  return out;
}

std::string bold(std::string_view text) { return "\\fB" + roff(text) + "\\fP"; }
std::string slanted(std::string_view text) { return "\\fI" + roff(text) + "\\fP"; }

// Returns a paragraph with bold options.
std::string prose(std::string_view text) {
  std::string out = "\\&";  // prevents a request at the start of the line
  while (!text.empty()) {
    std::size_t option = text.find("--");
    if (option == text.npos) option = text.size();
    out += roff(text.substr(0, option));
    text.remove_prefix(option);
    const std::size_t end = std::min(text.find_first_not_of("-abcdefghijklmnopqrstuvwxyz"), text.size());
    if (end > 0) out += bold(text.substr(0, end));
    text.remove_prefix(end);
  }
  return out + "\n";
}

// "-o, --output OUT"
std::string spelled(const Parameter& p) {
  const std::size_t comma = p.name.find(',');
  std::string out = p.is_option() ? bold(p.name.substr(0, comma)) : slanted(p.name);
  if (comma != std::string::npos) out += ", " + bold(p.name.substr(comma + 1));
  return p.value.empty() ? out : out + " " + slanted(p.value);
}

std::string row(const Parameter& p) { return ".TP\n" + spelled(p) + "\n" + prose(p.sentence); }

std::string synopsis() {
  std::string out;
  for (const Subcommand& s : subcommands()) {
    out += fmt::format(".SY \"betwixt {}\"\n", s.name);
    for (const Parameter& p : s.takes) {
      if (p.hidden) continue;
      const std::string name = p.name.substr(0, p.name.find(','));
      std::string text = p.is_option() ? bold(name) : slanted(name);
      if (!p.value.empty()) text += "\\ " + slanted(p.value);
      if (std::holds_alternative<std::vector<std::string>*>(p.into) && !p.is_option()) text += "...";
      out += (p.required ? text : "[" + text + "]") + "\\&\n";  // not the end of a sentence
    }
    out += ".YS\n";
  }
  return out + ".SY betwixt\n\\fB\\-\\-help\\fP | \\fB\\-\\-version\\fP\n.YS\n";
}

std::string commands() {
  std::string out;
  for (const Subcommand& s : subcommands()) {
    out += fmt::format(".SS {}\n{}", s.name, prose(s.sentence + "."));
    if (!s.manual.empty()) out += prose(s.manual);
    if (!s.note.empty()) out += ".PP\n" + prose(s.note);
    for (const Parameter& p : s.takes)
      if (!p.hidden) out += row(p);
  }
  out += ".SS All commands\n";
  for (const Parameter& p : common_parameters()) out += row(p);
  return out + ".TP\n\\fB\\-h\\fP, \\fB\\-\\-help\\fP\nexplains the program or a command.\n" +
         ".TP\n\\fB\\-\\-version\\fP\nprints the version.\n";
}

}  // namespace

std::string manual_page() {
  return filled(betwixt_1_in, {{"version", BETWIXT_VERSION}, {"synopsis", synopsis()}, {"commands", commands()}});
}

}  // namespace betwixt
