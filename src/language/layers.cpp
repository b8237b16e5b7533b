// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Commands that lay motion over motion, and filter it through time.
#include <fmt/format.h>

#include <algorithm>

#include "base/names.h"
#include "language/reader.h"

namespace betwixt {
bool Reader::layer(Cursor& c) {
  c.space();
  const std::string_view word = c.word();
  if (word.empty()) return c.fail_here(Code::syntax, "a name is missing here");
  if (!free_name(c, std::string(word), word)) return false;
  c.space();
  const std::string_view mode = c.word();
  if (mode != "add" && mode != "mix")
    return c.fail(Code::syntax, mode.empty() ? "add or mix is missing here" : "a layer adds or mixes",
                  mode.empty() ? std::string_view(c.at, 0) : mode,
                  "add lays its values on top; mix goes over to them by its weight");
  Object object;
  object.name = word;
  object.kind = Kind::layer;
  object.slot(fn::mode).set = Text(std::string(mode));
  if (!parameters(c, object)) return false;
  add_object(s, std::move(object));
  return true;
}

bool Reader::on_layer(Cursor& c) {
  c.space();
  const std::string_view word = c.word();
  if (word.empty()) return c.fail_here(Code::syntax, "the name of a layer is missing here");
  const ObjectId id = s.names.find(word);
  c.space();
  const std::string_view next = c.peek_word();
  // The rows of its sheet would have nowhere to go.
  if (!timed_ && first_dot(next) != std::string_view::npos) source_.sheet.open = source_.sheet.broken = true;
  if (!id) {
    std::vector<std::string_view> layers;
    for (std::size_t i = 0; i < s.objects.size(); ++i)
      if (s.objects[i].kind == Kind::layer && !s.objects[i].removed) layers.push_back(s.objects[i].name);
    const std::string near = did_you_mean(word, layers);
    return c.fail(Code::name, fmt::format("there is no layer '{}'", word.substr(0, 40)), word,
                  near.empty() ? fmt::format("layer {} add makes one", word.substr(0, 40)) : near);
  }
  if (s.objects[id.index].kind != Kind::layer)
    return c.fail(Code::type, fmt::format("'{}' is no layer", word), word, fmt::format("layer NAME add makes one"));
  if (layer_) return c.fail(Code::syntax, "one layer is enough", word);
  c.space();
  if (c.at_line_end())
    return c.fail_here(Code::syntax, "a command is missing here", "as in on sway set ball.position (0 1 0)");
  static constexpr std::string_view allowed[] = {"set",     "at",     "copy",      "move",   "stretch",
                                                 "reverse", "scale",  "translate", "rotate", "clear",
                                                 "stagger", "spread", "twerper",   "extend", "filter"};
  const std::string_view verb = c.peek_word();
  if (verb.find('.') == std::string_view::npos &&
      std::find(std::begin(allowed), std::end(allowed), verb) == std::end(allowed))
    return c.fail(Code::syntax, fmt::format("'{}' works on no layer", verb.substr(0, 40)), verb,
                  "on a layer go events, set, filters and track operations");
  layer_ = id;
  if (timed_ && verb.find('.') != std::string_view::npos) {  // at T on LAYER TARGET VALUE
    c.space();
    const std::string_view w = c.word();
    Selected to;
    if (!targets(c, w, to)) return false;
    if (to.spec) return event(c, to, time_);
    c.at = after_line(w.data());
    if (c.at > w.data() && c.at[-1] == '\n') --c.at;
    return true;
  }
  return command(c);
}

// key=value behind a filter's name: numbers, lengths of time, vectors and texts.
bool Reader::filter(Cursor& c) {
  Selected on;
  c.space();
  const std::string_view word = c.word();
  if (!targets(c, word, on)) return false;
  if (on.velocity) return c.fail(Code::type, "filters stand on values, not on velocities", word);
  c.space();
  const std::string_view name = c.word();
  Filter made;
  made.name = name;
  const FilterSpec* spec = find_filter(name);
  const NamedProcedure* own = find_procedure(s, name);
  if (own && own->role != Role::filter) own = nullptr;
  const bool none = name == "none";
  if (!spec && !own && !none) {
    std::vector<std::string_view> words;
    std::string all = "filters are";
    for (const FilterSpec& f : built_in_filters()) words.push_back(f.name), all += " " + std::string(f.name);
    for (const NamedProcedure& p : *s.procedures)
      if (p.role == Role::filter) words.push_back(p.name);
    const std::string hint = did_you_mean(name, words);
    return c.fail(Code::name,
                  name.empty() ? "the name of a filter is missing here"
                               : fmt::format("there is no filter '{}'", name.substr(0, 40)),
                  name.empty() ? std::string_view(c.at, 0) : name,
                  hint.empty() ? all + "; of a plug-in: --load PLUGIN" : hint);
  }
  if (own) made.code = own->code;
  const Type type = on.spec ? on.type() : Type::vector;
  if (type == Type::attachment || type == Type::names || type == Type::transform || type == Type::motion ||
      type == Type::points || (spec && !own && on.spec && !suits(*spec, type)))
    return c.fail(Code::type, fmt::format("'{}' means nothing for {}", name, to_string(type)), word);
  while (!c.at_line_end()) {
    const char* start = c.at;
    const char ch = c.peek();
    if ((ch >= '0' && ch <= '9') || ch == '-' || ch == '+' || ch == '.') {
      Time from, to;
      if (!c.segment(from, to)) return false;
      made.segment = {from, to};
      continue;
    }
    const std::string_view key = c.word();
    if (key.empty() || !c.accept('='))
      return c.fail(Code::syntax,
                    fmt::format("'{}' is not expected here", key.empty() ? std::string_view(start, 1) : key),
                    c.since(start), "key=value, or a segment A..B");
    const FilterParameter* known = nullptr;
    if (spec && !own) {
      std::vector<std::string_view> words;
      for (const FilterParameter& p : spec->parameters) {
        words.push_back(p.name);
        if (p.name == key) known = &p;
      }
      if (!known)
        return c.fail(Code::name, fmt::format("'{}' has no '{}'", name, key.substr(0, 40)), key,
                      did_you_mean(key, words));
    }
    if (own && own->code->language == "lua") {  // a slip would be a nil in its code
      std::string global(key);
      std::replace(global.begin(), global.end(), '-', '_');
      if (!stands_in(own->code->source, global))
        return c.fail(Code::name, fmt::format("'{}' makes no use of '{}'", name, key.substr(0, 40)), key);
    }
    c.space();
    const char* at = c.at;
    Value v;
    if (c.peek() == '"') {
      std::string text;
      if (!c.text(text)) return false;
      v = Text(std::move(text));
    } else if (c.peek() == '(') {
      Vec3 three;
      if (!values(c).vector(3, three)) return false;
      v = three;
    } else if (known && known->time) {
      Time length;
      if (!c.length(length)) return false;
      v = length.seconds();
    } else {
      double d = 0;
      if (!c.number(d)) return false;
      const std::string_view unit = c.unit();
      if (!unit.empty()) {  // a length of time is seconds, an angle radians
        c.at = at;
        Time length;
        if (unit == "deg" || unit == "rad" || unit == "turn") {
          if (!c.angle(d)) return false;
        } else if (!c.length(length)) {
          return false;
        } else {
          d = length.seconds();
        }
      }
      v = d;
    }
    if (const auto* d = std::get_if<double>(&v); known && d && !(*d >= known->low && *d <= known->high))
      return c.fail(Code::range,
                    *d < known->low ? fmt::format("{} is at least {}", key, write_number(known->low))
                                    : fmt::format("{} is at most {}", key, write_number(known->high)),
                    c.since(at));
    if (known && !std::holds_alternative<double>(v) && !(key == "amount" && std::holds_alternative<Vec3>(v)))
      return c.fail(Code::type, fmt::format("{} is a number", key), c.since(at));
    made.parameters.emplace_back(std::string(key), std::move(v));
  }
  for (const Target& t : on.targets) {
    Slot& slot = s.objects.edit(t.object.index).slot(t.function, t.layer);
    made.component = t.component;
    if (!none)
      slot.filters.push_back(made);
    else
      std::erase_if(slot.filters, [&](const Filter& f) { return t.component < 0 || f.component == t.component; });
  }
  return true;
}

}  // namespace betwixt
