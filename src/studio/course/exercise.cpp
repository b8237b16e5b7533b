// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/course/exercise.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <functional>
#include <map>
#include <set>
#include <sstream>

#include "betwixt/language.h"
#include "editor/plain_values.h"
#include "studio/exercises_text.h"
#include "studio/shell/window.h"
#include "studio/timeline/event_actions.h"
#include "studio/viewport/viewport.h"

namespace betwixt::studio {
namespace {

using Words = std::vector<std::string>;
constexpr std::string_view tool_names[] = {"move", "turn", "scale"};  // in the order of Tool

Words words_of(const std::string& line) {
  std::istringstream in(line);
  Words all;
  for (std::string word; in >> word;) all.push_back(word);
  return all;
}

std::optional<Target> target_of(const std::string& words, const Document& d) {
  const auto found = find_targets(words, d);
  if (!found || found->empty()) return std::nullopt;
  return found->front();
}

// Returns the times of all events of a function.
std::set<Time> times_of(const std::string& words, const Document& d) {
  std::set<Time> all;
  const auto target = target_of(words, d);
  if (!target) return all;
  for (const TrackView& t : tracks(d, *target))
    each_event(d, t.target, earliest_time, latest_time, [&](const EventView& e) { all.insert(e.time); });
  return all;
}

bool any_track(const std::string& words, const Document& d, const std::function<bool(const TrackView&)>& is) {
  const auto target = target_of(words, d);
  return target && std::ranges::any_of(tracks(d, *target), is);
}

std::string value_of(const std::string& words, const Workspace& w) {
  const auto target = target_of(words, w.document());
  return target ? plain_value(w.program().read(*target, w.time()), *target, w.document()) : "";
}

// A condition: its first word, how many words follow it, and whether it holds.
struct ConditionRow {
  const char* word;
  std::size_t words;
  bool (*holds)(const Words&, const Window&);
};
const ConditionRow conditions[] = {
    // there KIND N: the film has so many objects of this kind
    {"there", 2,
     [](const Words& a, const Window& window) {
       const Workspace& w = window.workspace();
       const auto is = [&](ObjectId id) { return name_of(kind(w.document(), id)) == a[0]; };
       return std::ranges::count_if(objects(w.document()), is) >= std::atoi(a[1].c_str());
     }},
    {"selected", 1,
     [](const Words& a, const Window& window) {
       const Workspace& w = window.workspace();
       return w.selected().size() == 1 && w.name(w.selected()[0]) == a[0];
     }},
    // events TARGET N: it has events at so many times
    {"events", 2,
     [](const Words& a, const Window& window) {
       const Workspace& w = window.workspace();
       return times_of(a[0], w.document()).size() >= static_cast<std::size_t>(std::atoi(a[1].c_str()));
     }},
    // value TARGET >|< NUMBER: at the playhead
    {"value", 3,
     [](const Words& a, const Window& window) {
       const Workspace& w = window.workspace();
       const auto target = target_of(a[0], w.document());
       if (!target) return false;
       const Value now = w.program().read(*target, w.time());
       const double* number = std::get_if<double>(&now);
       const double limit = std::atof(a[2].c_str());
       return number && (a[1] == ">" ? *number > limit : *number < limit);
     }},
    // not TARGET VALUE: at the playhead, the value is another one
    {"not", 2,
     [](const Words& a, const Window& window) {
       const Workspace& w = window.workspace();
       const std::string now = value_of(a[0], w);
       return !now.empty() && now != a[1];
     }},
    // at TIME TIME: the playhead is between these times
    {"at", 2,
     [](const Words& a, const Window& window) {
       const Workspace& w = window.workspace();
       const auto from = parse_time(a[0], w.document()), to = parse_time(a[1], w.document());
       return from && to && *from <= w.time() && w.time() <= *to;
     }},
    {"plays", 0, [](const Words&, const Window& w) { return w.workspace().playhead().playing(); }},
    {"auto-key", 0, [](const Words&, const Window& w) { return w.workspace().makes_events(); }},
    // tool NAME: the picture shows these handles
    {"tool", 1,
     [](const Words& a, const Window& w) {
       const ViewportSwitches& s = w.viewport().switches();
       return s.handles && a[0] == tool_names[static_cast<int>(s.tool)];
     }},
    // chosen N: so many events are selected
    {"chosen", 1,
     [](const Words& a, const Window& w) {
       return w.workspace().events_selected().size() >= static_cast<std::size_t>(std::atoi(a[0].c_str()));
     }},
    // twerper TARGET WORD: the track or one of its events has this twerper
    {"twerper", 2,
     [](const Words& a, const Window& window) {
       const Workspace& w = window.workspace();
       return any_track(a[0], w.document(), [&](const TrackView& t) {
         return t.twerper == a[1] || std::ranges::any_of(events(w.document(), t.target),
                                                         [&](const EventView& e) { return e.twerper == a[1]; });
       });
     }},
    // extends TARGET WORD: so its track goes on after its last event
    {"extends", 2,
     [](const Words& a, const Window& window) {
       const Workspace& w = window.workspace();
       return any_track(a[0], w.document(), [&](const TrackView& t) { return t.extrapolation_after == a[1]; });
     }},
    // held NAME, free NAME: it hangs on something at the playhead, or no longer
    {"held", 1,
     [](const Words& a, const Window& window) {
       const Workspace& w = window.workspace();
       const auto spans = attachments(w.document(), w.document().find(a[0]));
       return std::ranges::any_of(
           spans, [&](const AttachmentSpan& s) { return s.from <= w.time() && w.time() < s.until && s.to.parent; });
     }},
    {"free", 1,
     [](const Words& a, const Window& window) {
       const Workspace& w = window.workspace();
       const auto spans = attachments(w.document(), w.document().find(a[0]));
       return !spans.empty() && !spans.back().to.parent && spans.back().from <= w.time();
     }},
};

const ConditionRow* condition_of(const Words& words) {
  const auto found = std::ranges::find_if(
      conditions, [&](const ConditionRow& row) { return row.word == words[0] && row.words + 1 == words.size(); });
  return found == std::end(conditions) ? nullptr : found;
}

// An act of "Show me" that is no line of the language.
struct ActRow {
  std::string_view word;
  std::size_t words;
  void (*carry_out)(const Words&, Window&);
};
const ActRow acts[] = {
    {"go", 1,
     [](const Words& a, Window& w) {
       if (const auto t = parse_time(a[0], w.workspace().document())) w.workspace().go_to(*t);
     }},
    {"pick", 1, [](const Words& a, Window& w) { w.workspace().select({w.workspace().document().find(a[0])}); }},
    {"auto-key", 0, [](const Words&, Window& w) { w.workspace().set_makes_events(true); }},
    {"play", 0,
     [](const Words&, Window& w) {
       if (!w.workspace().playhead().playing()) w.workspace().play(1);
     }},
    {"tool", 1,
     [](const Words& a, Window& w) {
       ViewportSwitches s = w.viewport().switches();
       s.handles = true;
       s.tool = static_cast<Tool>(std::ranges::find(tool_names, a[0]) - std::begin(tool_names));
       w.viewport().set_switches(s);
     }},
    // choose TARGET: selects its events
    {"choose", 1,
     [](const Words& a, Window& w) {
       std::vector<EventAt> chosen;
       if (const auto target = target_of(a[0], w.workspace().document()))
         for (const TrackView& t : tracks(w.workspace().document(), *target))
           for (const EventView& e : events(w.workspace().document(), t.target)) chosen.push_back({t.target, e.time});
       w.workspace().select_events(std::move(chosen));
     }},
    {"copy-events", 0, [](const Words&, Window& w) { EventActions::of(w.workspace()).copy(); }},
    {"paste-events", 0, [](const Words&, Window& w) { EventActions::of(w.workspace()).paste(); }},
};

}  // namespace

Result<std::vector<Exercise>> read_exercises(std::string_view text) {
  std::vector<Exercise> all;
  std::istringstream in{std::string(text)};
  int number = 0;
  for (std::string line; std::getline(in, line);) {
    ++number;
    line.erase(0, line.find_first_not_of(' '));
    if (line.empty() || line[0] == '#') continue;
    const std::string word = line.substr(0, line.find(' '));
    const std::string rest = line.substr(std::min(line.size(), word.size() + 1));
    CourseStep* const step = all.empty() || all.back().steps.empty() ? nullptr : &all.back().steps.back();
    if (word == "exercise")
      all.push_back({rest, {}, {}, {}});
    else if (all.empty())
      return fail(ErrorCode::syntax, fmt::format("line {}: no exercise has begun", number));
    else if (word == "|" && !step)
      all.back().film += rest + "\n";
    else if (word == "about" && !step)
      all.back().about = rest;
    else if (word == "step")
      all.back().steps.push_back({rest, {}, {}, {}});
    else if (word == "point" && step)
      step->point = rest;
    else if (word == "until" && step && condition_of(words_of(rest)))
      step->until.push_back(rest);
    else if (word == "show" && step)
      step->show.push_back(rest);
    else
      return fail(ErrorCode::syntax, fmt::format("line {}: '{}' cannot be read here", number, line));
  }
  return all;
}

const std::vector<Exercise>& exercises() {
  static const std::vector<Exercise> all = *read_exercises(exercises_txt);
  return all;
}

std::string with_names(const std::string& words, const Workspace& w) {
  const Document& d = w.document();
  std::string out;
  for (std::size_t at = 0; at < words.size(); ++at) {
    if (words[at] != '$') {
      out += words[at];
      continue;
    }
    std::size_t end = at + 1;
    while (end < words.size() && std::islower(static_cast<unsigned char>(words[end]))) ++end;
    const std::string what = words.substr(at + 1, end - at - 1);
    const std::size_t digits = end;
    while (end < words.size() && std::isdigit(static_cast<unsigned char>(words[end]))) ++end;
    int left = end > digits ? std::atoi(words.c_str() + digits) : 1;
    std::string name = what == "now" ? w.when(w.time()) : words.substr(at, end - at);
    for (const ObjectId id : objects(d))
      if (name_of(kind(d, id)) == what && !derived(d, id) && --left == 0) name = d.name(id);
    out += name;
    at = end - 1;
  }
  return out;
}

bool holds(const std::string& condition, const Window& w) {
  Words words = words_of(with_names(condition, w.workspace()));
  const ConditionRow* row = condition_of(words);
  words.erase(words.begin());
  return row && row->holds(words, w);
}

bool is_done(const CourseStep& step, const Window& w) {
  return std::ranges::all_of(step.until, [&](const std::string& c) { return holds(c, w); });
}

bool show_how(const CourseStep& step, Window& w) {
  Lines lines;
  for (const std::string& shown : step.show) {
    const std::string line = with_names(shown, w.workspace());
    Words words = words_of(line);
    const auto act = std::ranges::find(acts, words[0], &ActRow::word);
    words.erase(words.begin());
    if (act == std::end(acts) || act->words != words.size())
      lines.push_back(line);
    else
      act->carry_out(words, w);
  }
  return lines.empty() || w.workspace().say(lines);
}

}  // namespace betwixt::studio
