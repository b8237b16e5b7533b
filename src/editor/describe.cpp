// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "editor/describe.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <unordered_map>

#include "base/cancellation.h"
#include "base/counted.h"
#include "base/names.h"
#include "betwixt/environment.h"
#include "betwixt/kind.h"
#include "betwixt/language.h"
#include "betwixt/program.h"
#include "editor/help.h"
#include "editor/plain_values.h"
#include "language/values.h"
#include "scene/names.h"
#include "scene/own_kinds.h"
#include "scene/sections.h"

namespace betwixt {
namespace {

std::size_t events_of(const Strand& s) {
  std::size_t n = s.track->events.size();
  for (const auto& c : s.components) n += c->events.size();
  return n;
}
std::size_t events_of(const Object& o) {
  std::size_t n = 0;
  for (const Slot& s : o.slots)
    if (!s.layer) n += events_of(s);
  return n;
}
// Returns the number of events on each layer, by layer number.
std::unordered_map<std::uint32_t, std::size_t> events_of_layers(const Scene& s) {
  std::unordered_map<std::uint32_t, std::size_t> all;
  for (std::size_t i = 0; i < s.objects.size(); ++i)
    for (Cancellation::check(); const Slot& slot : s.objects[i].slots)
      if (slot.layer) all[slot.layer.index] += events_of(slot);
  return all;
}

Error no_object(const Document& d, const std::string& word) {
  return unknown_name("object", word, near_object(d.scene(), word));
}

constexpr std::size_t longest_description = 32 << 20;  // bytes

Error too_long(const std::string& word) {
  return fail(ErrorCode::range,
              fmt::format("the description of '{}' is longer than {} bytes", word.substr(0, 60), longest_description),
              "describe fewer objects at a time");
}

// Lists what the object is attached to, and from when until when.
std::string attachment_lines(const Document& d, const Object& o) {
  std::string said;
  for (const AttachmentSpan& a : attachments(o)) {
    if (!a.to.parent && !a.computed && a.from == earliest_time) continue;
    if (a.computed) {
      said += "  its parent is computed by code";
      said += a.from == earliest_time ? "\n" : fmt::format(" from {}\n", format_time(a.from, d));
      continue;
    }
    static constexpr std::string_view how[] = {"is detached", "is let go", "hangs on", "is attached to",
                                               "is coupled to"};
    said += fmt::format("  {}", how[static_cast<std::size_t>(a.to.kind)]);
    if (a.to.parent) said += " " + d.name(a.to.parent);
    if (a.from != earliest_time) said += fmt::format(" {} {}", a.to.parent ? "from" : "at", format_time(a.from, d));
    said += a.to.keep_world ? ", keep-world\n" : "\n";
  }
  return said;
}

void add_manner(const Strand& strand, const Scene& s, std::vector<std::string>& all) {
  const auto put = [&](const Track& t) {
    if (t.global != Twerper::unset) all.push_back("twerper " + twerper_name(s, t.global));
    const auto extends = [&](Extrapolation e, const char* where) {
      if (e != Extrapolation::hold)
        all.push_back(fmt::format("extend {}{}", extrapolation_names[static_cast<std::size_t>(e)], where));
    };
    if (t.before == t.after) return extends(t.after, "");
    extends(t.before, " before"), extends(t.after, " after");
  };
  put(*strand.track);
  for (const auto& c : strand.components) put(*c);
}

// Summarises what computes the value of a function, for the end of its line.
std::string in_brief(const Document& d, const Object& o, FunctionId f) {
  std::vector<std::string> all;
  for (const Slot& slot : o.slots) {
    if (slot.function != f) continue;
    if (slot.layer) {
      all.push_back("layer " + d.name(slot.layer));
      continue;
    }
    if (const std::size_t n = events_of(slot); n > 0) all.push_back(counted(n, "event"));
    if (slot.set && std::holds_alternative<Procedure>(*slot.set)) all.emplace_back("a procedure");
    add_manner(slot, d.scene(), all);
    if (const std::size_t n = events_of(slot.velocity); n > 0) all.push_back("velocity " + counted(n, "event"));
    for (const Filter& filter : slot.filters) all.push_back("filter " + filter.name + (filter.off ? " (off)" : ""));
  }
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return fmt::format("{}", fmt::join(all, ", "));
}

// Members of environments, and objects under layers, by object number. Found once for everything that is described.
using Lists = std::unordered_map<std::uint32_t, std::string>;
struct About {
  const Program& program;
  const Document& d = program.document();
  const Time first = d.range().first;
  std::optional<Lists> moved = {}, driven = {}, laid = {};

  // Returns the names of the objects in an environment.
  const std::string& of(std::optional<Lists>& lists,
                        std::vector<EnvironmentSpan> (*spans_of)(const Document&, ObjectId), ObjectId environment) {
    if (!lists) {
      lists.emplace();
      for (const std::string& name : d.names()) {
        Cancellation::check();
        std::set<std::uint32_t> all;
        for (const EnvironmentSpan& span : spans_of(d, d.find(name)))
          for (const ObjectId id : span.environments) all.insert(id.index);
        for (const std::uint32_t id : all) (*lists)[id] += " " + name;
      }
    }
    return (*lists)[environment.index];
  }
  // Returns the functions that a layer changes, one per line.
  const std::string& on(ObjectId layer) {
    if (!laid) {
      laid.emplace();
      for (std::uint32_t i = 0; i < d.scene().objects.size(); ++i)
        for (const Slot& slot : d.scene().objects[i].slots)
          if (slot.layer)
            (*laid)[slot.layer.index] +=
                fmt::format("  on {:13} {}\n", d.name(Target{{i}, slot.function}), counted(events_of(slot), "event"));
    }
    return (*laid)[layer.index];
  }
};

// Describes the values of an environment and its members.
std::string environment_lines(About& about, ObjectId id) {
  const Document& d = about.d;
  std::string said;
  const Object& o = d.scene().objects[id.index];
  const std::string all = write_environment(o.name, *o.environment);
  for (std::string_view rest = all; !rest.empty(); rest.remove_prefix(rest.find('\n') + 1))
    said += fmt::format("  {}\n", rest.substr(0, rest.find('\n')));
  const auto list = [&](const char* verb, const std::string& names) {
    if (!names.empty()) said += fmt::format("  {}{}\n", verb, names);
  };
  list("moves", about.of(about.moved, surrounding, id)), list("drives", about.of(about.driven, driving, id));
  return said;
}

// Returns ", of the kind human2" for an instance of a kind of the author's own, otherwise "".
std::string kind_of_instance(const About& about, ObjectId id) {
  const OwnKind* kind = about.d.scene().kinds->of(id);
  return kind ? ", of the kind " + kind->name : "";
}

std::string object_lines(About& about, ObjectId id) {
  const Document& d = about.d;
  const Time first = about.first;
  const Object& o = d.scene().objects[id.index];
  std::string said =
      fmt::format("{}, {}{}\n", o.name, a_kind(o.kind), kind_of_instance(about, id)) + attachment_lines(d, o);
  std::vector<std::string_view> at_rest;
  for (const std::string_view name : function_names(d.scene(), o.kind)) {
    const auto f = find_function(d.scene(), o.kind, name);
    if (!f || *f == fn::attachment) continue;
    const Slot* slot = o.find(*f);
    const std::string brief = in_brief(d, o, *f);
    if (brief.empty() && (!slot || !slot->set)) {
      at_rest.push_back(name);
      continue;
    }
    const Target t{id, *f, -1};
    said += fmt::format("  {:16} {}", name, plain_value(about.program.read(t, first), t, d));
    if (!brief.empty()) said += fmt::format(" at {}; {}", format_time(first, d), brief);
    said += "\n";
  }
  if (o.kind == Kind::environment) said += environment_lines(about, id);
  if (!at_rest.empty()) said += fmt::format("  untouched: {}\n", fmt::join(at_rest, " "));
  if (o.kind == Kind::layer) said += about.on(id);
  return said;
}

// Lists the instances of a kind of the author's own, each with its own values.
std::string kind_lines(const Document& d, const KindView& kind) {
  std::string said = fmt::format("{}, a kind like {}{}: {}\n", kind.name, d.name(kind.model),
                                 kind.hidden ? ", which is hidden" : "", counted(kind.instances.size(), "object"));
  for (const InstanceView& one : kind.instances) {
    said += fmt::format("  {:16}", d.name(one.root));
    for (const Target& t : one.own) said += " " + d.name(t);
    if (!one.missing.empty()) said += fmt::format(" without {}", fmt::join(one.missing, " "));
    said += one.own.empty() && one.missing.empty() ? " follows the model in everything\n" : "\n";
  }
  return said;
}

// Lists the rows of a target, then what else affects its value.
std::string track_lines(const Document& d, const Target& t) {
  std::string said;
  if (t.query()) return said;
  const auto put = [&](const std::string& rows) {
    for (std::string_view rest = rows; !rest.empty();) {
      const std::size_t end = rest.find('\n'), time = rest.find_first_not_of(' '), space = rest.find(' ', time);
      said += fmt::format("  {:8}{}", rest.substr(time, space - time), rest.substr(space, end + 1 - space));
      rest.remove_prefix(end + 1);
    }
  };
  const std::size_t parts = t.component < 0 ? tracks_of(d.scene(), t).size() : 1;
  if (parts < 2) put(write_rows(d, t));
  for (std::size_t i = 0; parts > 1 && i < parts; ++i) {  // each component has a track of its own
    Target part = t;
    part.component = static_cast<int>(i);
    const std::string rows = write_rows(d, part);
    if (!rows.empty()) said += fmt::format("  {}\n", d.name(part));
    put(rows);
  }
  const std::string besides = write_besides(d, t);
  for (std::string_view rest = besides; !rest.empty();) {
    const std::size_t end = rest.find('\n') + 1;
    said += fmt::format("  {}", rest.substr(0, end));
    rest.remove_prefix(end);
  }
  return said;
}

// Lists the rows of a display list; if they change in time, each version with its time.
std::string list_lines(const Document& d, const std::string& name, const std::vector<Time>& versions) {
  std::string said = fmt::format("{}, a display list{}\n", name, name == d.scene().main ? ", the main object" : "");
  for (const Time from : versions) {
    if (from != earliest_time) said += fmt::format("from {}\n", format_time(from, d));
    said += write_rows(*list_at(d.scene(), name, from));
  }
  for (const auto& [from, changed] : *d.scene().later_lists)
    if (const auto list = changed.find(name); list != changed.end() && !list->second->there)
      said += fmt::format("deleted at {}\n", format_time(from, d));
  return said;
}

}  // namespace

Result<std::string> list_objects(const Document& d, const std::string& pattern) {
  std::vector<ObjectId> ids;
  if (pattern.empty()) {
    for (const auto& n : d.names()) ids.push_back(d.find(n));
  } else {
    ids = select(d.scene(), pattern);
    if (ids.empty() && !is_pattern(pattern) && !find_section(d.sections(), pattern) &&
        versions(d.scene(), pattern).empty() && !d.scene().kinds->find(pattern))
      return no_object(d, pattern);
  }
  std::size_t wide = 0;
  for (ObjectId id : ids) wide = std::max(wide, d.name(id).size());
  const auto meant = [&](const std::string& name) { return pattern.empty() || matches(pattern, name); };
  for (const Section& one : d.sections())
    if (meant(one.name)) wide = std::max(wide, one.name.size());
  std::vector<std::string> lists;
  for (const std::string_view name : list_names(d.scene()))
    if (meant(std::string(name))) lists.emplace_back(name), wide = std::max(wide, name.size());
  std::string said;
  for (const std::string& name : lists) {
    const std::vector<Time> from = versions(d.scene(), name);
    said += fmt::format("{:{}}  {:8}  {}{}\n", name, wide, "list",
                        counted(list_at(d.scene(), name, from[0])->commands.size(), "row"),
                        from.size() > 1 ? fmt::format(", {}", counted(from.size(), "version")) : "");
  }
  for (const OwnKind& kind : d.scene().kinds->all)
    if (meant(kind.name))
      said += fmt::format("{:{}}  {:8}  like {}, {}\n", kind.name, wide, "kind", d.name(kind.model()),
                          counted(kind.instances.size(), "object"));
  for (const Section& one : d.sections())
    if (meant(one.name))
      said += fmt::format("{:{}}  {:8}  {}..{}{}\n", one.name, wide, "section", format_time(one.begin, d),
                          format_time(one.end, d), one.speed == 1 ? "" : " speed=" + write_number(one.speed));
  const auto laid = events_of_layers(d.scene());
  for (ObjectId id : ids) {
    Cancellation::check();
    const Object& o = d.scene().objects[id.index];
    std::size_t events = events_of(o);
    if (const auto on = laid.find(id.index); on != laid.end()) events += on->second;
    said += fmt::format("{:{}}  {:8}  {}\n", o.name, wide, name_of(o.kind), counted(events, "event"));
  }
  return said.empty() ? (pattern.empty() ? "there are no objects yet\n" : "nothing has this name\n") : said;
}

Result<std::string> describe(const Document& d, const std::string& word) { return describe(Program::compile(d), word); }

Result<std::string> describe(const Program& program, const std::string& word) {
  const Document& d = program.document();
  if (word.empty()) return fail(ErrorCode::name, "a name is missing here", "usage: describe NAME");
  if (const auto all = versions(d.scene(), word); !all.empty()) return list_lines(d, word, all);
  const auto ids = select(d.scene(), word);
  if (ids.empty())
    for (const KindView& kind : own_kinds(d))
      if (kind.name == word) return kind_lines(d, kind);
  std::string said;
  const auto put = [&](const std::string& one) {
    Cancellation::check();
    said += one;
    return said.size() <= longest_description;
  };
  if (ids.empty()) {
    if (word.find('.') == std::string::npos) return no_object(d, word);
    const auto targets = find_targets(word, d);
    if (!targets) return targets.error();
    const Time first = d.range().first;
    for (const Target& t : *targets) {
      const std::string events = track_lines(d, t);
      const bool rows = !t.query() && !write_rows(d, t).empty();
      const std::string now = rows ? std::string() : plain_value(program.read(t, first), t, d);
      if (!put(fmt::format("{}{}{}\n{}", d.name(t), now.empty() ? "" : "  ", now, events))) return too_long(word);
    }
    return said;
  }
  About about{program};
  for (ObjectId id : ids)
    if (!put(object_lines(about, id))) return too_long(word);
  return said;
}

std::string list_notes(const Document& d) {
  std::string said;
  for (const Note& n : d.notes(earliest_time, latest_time))
    said += fmt::format("{:8} {}{}\n", format_time(n.time, d), write_text(n.text),
                        n.color ? " color=" + write_color(*n.color) : "");
  return said.empty() ? "there are no notes\n" : said;
}

std::string notes_shown(const Document& d, std::optional<Time> after, Time now) {
  std::string said;
  if (!d.scene().notes_shown) return said;
  for (const Note& n : d.notes(after ? *after + Time{1} : now, now))
    said += fmt::format("{}\"{}\"", said.empty() ? "" : " ", n.text);
  return said;
}

Result<std::string> look_up(const Document& d, const std::string& word) {
  if (word.empty()) return help_overview(d.scene());
  if (const std::string text = help_text(word, d.scene()); !text.empty()) return text;
  if (const ObjectId id = d.find(word); id)
    return fmt::format("{} is an object of this film: describe {}\n", word, word);
  const std::vector<std::string_view> known = words_with_help();
  return unknown_name("help for", word, did_you_mean(word, known));
}

}  // namespace betwixt
