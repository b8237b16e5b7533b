// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// betwixt check: all errors and warnings of a script.
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "app/code_errors.h"
#include "app/command.h"
#include "app/subcommand.h"
#include "base/names.h"
#include "betwixt/object.h"
#include "betwixt/track.h"
#include "scene/document.h"

namespace betwixt {
namespace {

// Environments that something stands in but nobody ever animates, and one of those that do.
std::map<std::string, std::string> idle_environments(const Scene& s) {
  std::map<std::string, std::string> idle;
  for (std::size_t i = 0; i < s.objects.size(); ++i) {
    const Object& o = s.objects[i];
    const auto look = [&](const Value& v) {
      const auto* names = std::get_if<Names>(&v);
      for (const std::string& name : names ? **names : std::vector<std::string>()) {
        const ObjectId id = s.names.find(name);
        if (!id || s.objects[id.index].kind != Kind::environment) idle.try_emplace(name, o.name);
      }
    };
    for (const FunctionId f : {fn::environments, fn::drive})
      if (const Slot* slot = o.removed ? nullptr : o.find(f)) {
        if (slot->set) look(*slot->set);
        slot->track->events.each([&](const Event& e) { look(e.value); });
      }
  }
  return idle;
}

void say_idle_environments(const std::string& file, const Scene& s) {
  std::vector<std::string_view> known;
  for (std::size_t i = 0; i < s.objects.size(); ++i)
    if (s.objects[i].environment && !s.objects[i].removed) known.push_back(s.objects[i].name);
  for (const auto& [name, holder] : idle_environments(s)) {
    const std::string near = did_you_mean(name, known);
    fmt::print(stderr, "{}: notice: '{}' is in the environment '{}', which nobody animates\n  {}\n", file, holder, name,
               near.empty() ? fmt::format("as in animate {} every 1t by rotate(3deg, z)", name) : near);
  }
}

// A bspline comes near its events only: beside another twerper, which goes through them, it jumps.
void say_torn_splines(const std::string& file, const Document& document) {
  for (const ObjectId id : objects(document))
    for (const TrackView& track : tracks(document, id)) {
      if (!track.twerper.empty()) continue;  // one for all
      const auto all = events(document, track.target);
      const auto spline = [&](const EventView& e) {
        return (e.twerper.empty() ? track.unsaid : e.twerper) == "bspline";
      };
      for (std::size_t i = 1; i + 1 < all.size(); ++i) {
        if (spline(all[i - 1]) == spline(all[i])) continue;
        fmt::print(stderr, "{}: notice: {} jumps at {}, where bspline meets another twerper\n  twerper {} bspline\n",
                   file, document.name(track.target), format_time(all[i].time, document), document.name(track.target));
        break;
      }
    }
}

std::string counted(std::size_t n, const char* what) { return fmt::format("{} {}{}", n, what, n == 1 ? "" : "s"); }

struct CheckCall {
  std::string file;
  bool counts = false;
};

int check(const CheckCall& call) {
  const std::string& file = call.file;
  load_options().counts = call.counts;
  const Loaded loaded = load_file(file, load_options());
  std::size_t errors = 0, warnings = 0;
  for (const Diagnostic& d : loaded.diagnostics) {
    std::fputs(to_string(d).c_str(), stderr);
    errors += d.severity == Severity::error;
    warnings += d.severity == Severity::warning;
  }
  if (errors == 0) {
    const auto [first, last] = loaded.document.range();
    const Findings found =
        look_through(Program::compile(loaded.document), file, first, last, loaded.document.frame_count());
    for (const Diagnostic& d : found.errors) std::fputs(to_string(d).c_str(), stderr);
    for (const std::string& p : found.warnings) fmt::print(stderr, "{}: warning: {}\n", file, p);
    errors += found.errors.size(), warnings += found.warnings.size();
  }
  if (errors == 0) say_idle_environments(file, loaded.document.scene()), say_torn_splines(file, loaded.document);
  if (errors + warnings > 0)
    fmt::print(stderr, "{}, {}\n", counted(errors, "error"), counted(warnings, "warning"));
  else
    fmt::print("{}: no errors, {}, {}\n", file, counted(loaded.document.names().size(), "object"),
               counted(static_cast<std::size_t>(loaded.document.frame_count()), "frame"));
  return errors ? wrong_input : all_done;
}

const Enlisted enlisted_check(check, [](CheckCall& call) -> Subcommand {
  return {.rank = 60,
          .name = "check",
          .sentence = "says all errors and warnings of a script, and what goes wrong in its frames",
          .takes = {script_parameter(call.file),
                    flag("-v,--verbose", "says of each command how many objects its pattern named", call.counts)},
          .example = "betwixt check examples/bounce.bx",
          .manual = "Up to 60 of its frames are looked at. The exit code is 1 if there is an error."};
});

}  // namespace
}  // namespace betwixt
