// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// betwixt eval: values at given times.
#include <fmt/format.h>
#include <unistd.h>

#include "app/command.h"
#include "app/stats.h"
#include "app/subcommand.h"
#include "base/names.h"
#include "base/tell_user.h"
#include "base/utf8.h"
#include "betwixt/evaluation.h"
#include "editor/plain_values.h"
#include "language/values.h"

namespace betwixt {
namespace {

struct EvalCall {
  std::string file;
  std::vector<std::string> times, targets;
  bool json = false, stats = false;
};

// Prints the cost of whole frames at the times: the first one evaluates all, later ones only the changes.
void print_stats(const Program& program, const std::vector<std::pair<std::string, Time>>& times) {
  Evaluation e(program);
  Spending first, after;
  for (std::size_t i = 0; i < times.size(); ++i) {
    const Spending::Listening listening(i == 0 ? &first : &after);
    e.to(times[i].second);
  }
  const auto stages = {Stage::tracks, Stage::procedures, Stage::environments, Stage::hierarchy, Stage::looks};
  first.print("the first frame", stages);
  if (times.size() > 1) after.print("a frame after it", stages);
  print_sizes(program);
}

int eval(const EvalCall& call) {
  const auto document = open_script(call.file);
  if (!document) return wrong_input;
  std::vector<std::pair<std::string, Time>> times;
  if (call.times.empty()) {
    const Time first = document->range().first;
    times.emplace_back(write_number(document->rate().frame_number(first)) + "f", first);
  }
  for (const auto& text : call.times) {
    const auto t = read_time(text, *document, "--at");
    if (!t) return complain(t.error(), wrong_call);
    times.emplace_back(text, *t);
  }
  const auto found = targets_of(*document, call.targets, [](const std::string& pattern) {
    tell_user(fmt::format("betwixt: notice: {}\n", nothing_named(pattern).message));
  });
  if (!found) return complain(found.error(), wrong_input);
  const std::vector<Target>& targets = *found;
  const Program program = Program::compile(*document);
  if (call.stats) print_stats(program, times);
  Problems problems;
  if (call.json) {
    fmt::print("{}\n", values_json(*document, program, targets, times,
                                   [&](const std::vector<std::string>& said) { problems.say(said); }));
    return all_done;
  }
  const bool terminal = ::isatty(STDOUT_FILENO) == 1;
  std::size_t width = 0;
  for (const Target& t : targets) width = std::max(width, document->name(t).size());
  for (const auto& [text, t] : times) {
    if (times.size() > 1) fmt::print("{} ({} s)\n", text, write_number(t.seconds()));
    std::vector<std::string> said;
    const auto values = program.read(targets, t, &said);
    problems.say(said);
    for (std::size_t k = 0; k < targets.size(); ++k) {
      const std::string value = plain_value(values[k], targets[k], *document);
      fmt::print("{}{:{}}  {}\n", times.size() > 1 ? "  " : "", document->name(targets[k]), width,
                 terminal ? visible(value, true) : value);
    }
  }
  return all_done;
}

const Enlisted enlisted_eval(eval, [](EvalCall& call) -> Subcommand {
  return {
      .rank = 40,
      .name = "eval",
      .sentence = "prints values at times",
      .takes = {script_parameter(call.file),
                targets_parameter(call.targets, "the targets: ball.position, wheel*.color, ball; by default all"),
                {.name = "--at",
                 .value = "T[,T…]",
                 .sentence = "the times: 24f, 2.5s, …; by default the film's first frame",
                 .into = &call.times,
                 .separated = true},
                flag("--json", "one JSON object", call.json),
                flag("--stats", "prints the times of the parts of a frame, and the memory of the film", call.stats)},
      .example = "betwixt eval examples/bounce.bx --at 12f,24f ball.position --json",
      .manual =
          "In JSON, each number has as few digits as possible, but reads back as exactly the same number. A world is "
          "16 numbers, row by row."};
});

}  // namespace
}  // namespace betwixt
