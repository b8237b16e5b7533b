// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// filter: applies a function through time to a track.
#include <fmt/format.h>

#include <algorithm>

#include "base/names.h"
#include "commands/command.h"
#include "syntax/tokens.h"
#include "track/filter.h"

namespace betwixt {
namespace {

// The filter that a command names: built in, of the author's own, or `none`.
struct Chosen {
  std::string_view name;
  const FilterSpec* spec = nullptr;
  const NamedProcedure* own = nullptr;
  bool none() const { return name == "none"; }
};

bool choose(Command& k, Chosen& out) {
  auto& [s, c, time, layer, script] = k;
  const std::string_view name = out.name = c.next_word();
  const NamedProcedure* own = find_procedure(s, name);
  if (own && own->role == Role::filter) out.own = own;
  out.spec = out.own ? nullptr : find_filter(name);
  if (out.spec || out.own || out.none()) return true;
  std::vector<std::string_view> words;
  std::string all = "filters are";
  for (const FilterSpec& f : built_in_filters()) words.push_back(f.name), all += " " + std::string(f.name);
  for (const NamedProcedure& p : *s.procedures)
    if (p.role == Role::filter) words.push_back(p.name);
  const Hint hint = did_you_mean(name, words);
  return c.fail(ErrorCode::name,
                name.empty() ? "the name of a filter is missing here"
                             : fmt::format("there is no filter '{}'", name.substr(0, 40)),
                name.empty() ? std::string_view(c.at, 0) : name,
                hint.empty() ? Hint(all + "; for a filter of a plug-in: --load PLUGIN") : hint);
}

bool means_something(const Chosen& filter, Type type) {
  if (filter.spec && filter.spec->any_type) return suits(*filter.spec, type);
  return row_of(type).computed && (!filter.spec || suits(*filter.spec, type));
}

// Finds the filter's parameter. Sets `known` to nullptr for a filter of the author's own, which may use any key.
bool known_key(Cursor& c, const Chosen& filter, std::string_view key, const FilterParameter*& known) {
  if (filter.own) {
    if (filter.own->code->language != "lua") return true;
    std::string global(key);  // a typing error would be nil in its code
    std::replace(global.begin(), global.end(), '-', '_');
    return stands_in(filter.own->code->source, global) ||
           c.fail(ErrorCode::name, fmt::format("'{}' does not use '{}'", filter.name, key.substr(0, 40)), key);
  }
  if (!filter.spec) return true;
  std::vector<std::string_view> words;
  for (const FilterParameter& p : filter.spec->parameters) {
    words.push_back(p.name);
    if (p.name == key) known = &p;
  }
  return known || c.fail(ErrorCode::name, fmt::format("'{}' has no '{}'", filter.name, key.substr(0, 40)), key,
                         did_you_mean(key, words));
}

// Reads a number. With a unit it is a length of time, in seconds, or an angle, in radians.
bool number_or_length(Cursor& c, bool length_wanted, double& out, bool& unit) {
  const char* const at = (c.space(), c.at);
  std::optional<Quantity> q;
  bool angle = false;
  if (!length_wanted) {
    if (!c.number(out, q)) return false;
    const std::string_view word = q ? std::string_view() : c.unit();
    angle = q ? q->of == Quantity::Of::angle : word == "deg" || word == "rad" || word == "turn";
    unit = q ? q->of != Quantity::Of::number : !word.empty();
    if (!unit) return true;
    c.at = at;
  }
  if (angle) return c.angle(out);
  Time length;
  if (!c.length(length)) return false;
  out = length.seconds();
  return true;
}

bool parameter_value(Command& k, std::string_view key, const FilterParameter* known, bool angles, Value& out) {
  Cursor& c = k.cursor;
  c.space();
  const char* at = c.at;
  if (c.peek() == '"') {
    std::string text;
    if (!c.text(text)) return false;
    out = Text(std::move(text));
  } else if (c.peek() == '(') {
    Vec3 three;
    if (angles) {
      if (!c.open()) return false;
      for (int i = 0; i < 3; ++i)
        if (!values(k).angle(three[i])) return false;
      if (!c.close()) return false;
    } else if (!values(k).vector(3, three)) {
      return false;
    }
    out = three;
  } else {
    double d = 0;
    bool unit = false;
    if (angles ? !values(k).angle(d) : !number_or_length(c, known && known->time, d, unit)) return false;
    if (known && unit)
      return c.fail(ErrorCode::type, fmt::format("{} must be a plain number, without a unit", key), c.since(at),
                    key == "frequency" ? "it is a number of times per second" : "");
    out = d;
    if (known && !(d >= known->low && d <= known->high))
      return c.fail(ErrorCode::range,
                    d < known->low ? fmt::format("{} must be at least {}", key, write_number(known->low))
                                   : fmt::format("{} must be at most {}", key, write_number(known->high)),
                    c.since(at));
  }
  if (known && !std::holds_alternative<double>(out) &&
      !(known->type == Type::vector && std::holds_alternative<Vec3>(out)))
    return c.fail(ErrorCode::type, fmt::format("{} must be a number", key), c.since(at));
  return true;
}

// Reads [key=value …] [A..B] [off]
bool filter_arguments(Command& k, const Chosen& chosen, Type type, Filter& made) {
  Cursor& c = k.cursor;
  while (!c.at_line_end()) {
    const char* start = c.at;
    if (starts_like_time(c.peek())) {
      Time from, to;
      if (!c.segment(from, to)) return false;
      made.segment = {from, to};
      continue;
    }
    const std::string_view key = c.word();
    const bool value = c.accept('=');
    if (key == "off" && !value && !chosen.none()) {
      made.off = true;
      continue;
    }
    if (key.empty() || !value)
      return c.fail(ErrorCode::syntax,
                    fmt::format("'{}' is not expected here", key.empty() ? std::string_view(start, 1) : key),
                    c.since(start), "write key=value, a segment A..B, or off");
    if (key == "off" && !chosen.own)
      return c.fail(ErrorCode::syntax, "'off' has no value", c.since(start), "write the word alone: off");
    const FilterParameter* known = nullptr;
    Value v;
    if (!known_key(c, chosen, key, known)) return false;
    const bool angles = known && known->value && row_of(type).angles;
    if (!parameter_value(k, key, known, angles, v)) return false;
    made.parameters.emplace_back(std::string(key), std::move(v));
  }
  return true;
}

// Reads [key=value …] [A..B] [off] of a filter for values of one type, and adds the filter.
bool put_filter(Command& k, const Selected& on, const Chosen& chosen, std::string_view word) {
  const Type type = on.spec ? on.type() : Type::vector;
  if (!chosen.none() && !means_something(chosen, type) && !(chosen.spec && !on.spec))
    return k.cursor.fail(ErrorCode::type, fmt::format("'{}' cannot filter {}", chosen.name, to_string(type)), word);
  Filter made;
  made.name = chosen.name;
  if (chosen.own) made.code = chosen.own->code;
  if (!filter_arguments(k, chosen, type, made)) return false;
  for (const Target& t : on.targets) {
    Slot& slot = k.scene.objects.edit(t.object.index).slot(t.function, t.layer);
    made.component = t.component;
    if (!chosen.none())
      slot.filters.push_back(made);
    else
      std::erase_if(slot.filters, [&](const Filter& f) { return t.component < 0 || f.component == t.component; });
  }
  return true;
}

bool filter(Command& k) {
  Cursor& c = k.cursor;
  Selected on;
  Chosen chosen;
  const std::string_view word = c.next_word();
  if (!targets(k, word, on, Meant::any)) return false;
  if (on.velocity) return c.fail(ErrorCode::type, "a velocity cannot have filters; a value can", word);
  if (!choose(k, chosen)) return false;
  if (chosen.none()) return put_filter(k, on, chosen, word);
  return for_each_type(k, on, [&](const Selected& one) { return put_filter(k, one, chosen, word); });
}

constexpr Verb filters_rows[] = {
    {"filter", "filter TARGET NAME [key=value …] [A..B] [off] or filter TARGET none",
     "Adds a filter to a track: it changes the values of the track as a function of time. With `off` it "
     "stays in the script and does nothing.",
     "filter ball.position delay by=6f", Verb::layered, filter, "TARGET; FILTER; SETTING…"},
};

}  // namespace

std::span<const Verb> filters_verbs() { return filters_rows; }

}  // namespace betwixt
