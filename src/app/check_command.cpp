// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// betwixt check: all errors and warnings of a script.
#include <fmt/format.h>

#include "app/code_errors.h"
#include "app/command.h"
#include "app/po_template.h"
#include "app/streams.h"
#include "app/subcommand.h"
#include "base/counted.h"
#include "base/error_words.h"
#include "base/json.h"
#include "base/tell_user.h"
#include "base/utf8.h"

namespace betwixt {
namespace {

struct CheckCall {
  std::string file;
  bool counts = false, json = false;
  std::string po;
};

// `code` is empty for a warning that only frames give: it is a text without a place.
std::string json_of(Severity severity, std::string_view code, const Error& e) {
  return fmt::format(
      "{{\"severity\": \"{}\", \"code\": \"{}\", \"file\": {}, \"line\": {}, \"column\": {}, \"length\": {}, "
      "\"message\": {}, \"hint\": {}, \"instead\": {}}}",
      word_of(severity), code, json_text(e.place.file), e.place.line, e.place.column, e.place.length,
      json_words(e.message), json_words(e.hint), json_words(e.instead));
}

// Prints one object: whether the film loads, and all messages, each with its place.
void print_json(const Diagnostics& all, const std::vector<std::string>& warnings, const Document& d, bool fine) {
  std::string list;
  for (const Diagnostic& one : all)
    list += (list.empty() ? "\n  " : ",\n  ") + json_of(one.severity, word_of(one.what.code), one.what);
  for (const std::string& text : warnings)
    list +=
        (list.empty() ? "\n  " : ",\n  ") + json_of(Severity::warning, "", {.message = text, .hint = "", .place = {}});
  fmt::print("{{\"ok\": {}, \"objects\": {}, \"frames\": {}, \"messages\": [{}{}]}}\n", fine, d.names().size(),
             d.frame_count(), list, list.empty() ? "" : "\n");
}

int check(const CheckCall& call) {
  const std::string &file = call.file, name = is_stream(file) ? "<stdin>" : file;
  load_options().counts = call.counts;
  PoTemplate texts;
  if (!call.po.empty()) load_options().shows = texts.listener();
  const Loaded loaded = load_script(file);
  load_options().shows = {};
  std::size_t errors = 0, warnings = 0;
  for (const Diagnostic& d : loaded.diagnostics) {
    if (!call.json) tell_user(d);
    errors += d.severity == Severity::error;
    warnings += d.severity == Severity::warning;
  }
  Diagnostics all = loaded.diagnostics;
  std::vector<std::string> others;
  if (errors == 0) {
    const auto [first, last] = loaded.document.range();
    const Findings found =
        look_through(Program::compile(loaded.document), file, first, last, loaded.document.frame_count());
    if (!call.json) {
      for (const Diagnostic& d : found.errors) tell_user(d);
      for (const std::string& p : found.warnings) tell_user(fmt::format("{}: warning: {}\n", name, p));
    }
    all.insert(all.end(), found.errors.begin(), found.errors.end());
    others = found.warnings;
    errors += found.errors.size(), warnings += found.warnings.size();
  }
  if (!call.po.empty() && errors == 0)
    if (const Status s = texts.write(call.po); !s) return complain(s.error(), wrong_call);
  if (call.json) {
    print_json(all, others, loaded.document, errors == 0);
    return errors ? wrong_input : all_done;
  }
  if (errors + warnings > 0)
    fmt::print(stderr, "{}, {}\n", counted(errors, "error"), counted(warnings, "warning"));
  else
    fmt::print("{}: no errors, {}, {}\n", visible(name), counted(loaded.document.names().size(), "object"),
               counted(static_cast<std::size_t>(loaded.document.frame_count()), "frame"));
  return errors ? wrong_input : all_done;
}

const Enlisted enlisted_check(check, [](CheckCall& call) -> Subcommand {
  return {.rank = 60,
          .name = "check",
          .sentence = "prints all errors and warnings of a script, and those that appear only in its frames",
          .takes = {script_parameter(call.file),
                    flag("-v,--verbose", "prints for each command how many objects its pattern matched", call.counts),
                    flag("--json", "prints one JSON object with all messages and their places", call.json),
                    file_option("--po", "OUT.pot", "writes all texts of the film as a gettext catalogue to translate",
                                &call.po)},
          .example = "betwixt check examples/bounce.bx",
          .manual = "It checks up to 60 frames. The exit code is 1 if there is an error."};
});

}  // namespace
}  // namespace betwixt
