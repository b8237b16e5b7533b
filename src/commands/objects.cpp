// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Commands that make, remove and name objects.
#include <fmt/format.h>

#include <algorithm>

#include "base/names.h"
#include "commands/command.h"
#include "commands/roads.h"
#include "procedure/lua.h"

namespace betwixt {
namespace {

constexpr std::size_t most_objects = 1'000'000;  // braces make many of them in a few words

// The source with texts that are the object's name, or begin with it and a dot, speaking of the new name.
std::string renamed(const std::string& source, const std::string& old, const std::string& name) {
  std::string out;
  for (std::size_t i = 0; i < source.size();) {
    const char quote = source[i];
    out += quote;
    ++i;
    if (quote != '"' && quote != '\'') continue;
    if (source.compare(i, old.size(), old) == 0 && i + old.size() < source.size() &&
        (source[i + old.size()] == '.' || source[i + old.size()] == quote)) {
      out += name;
      i += old.size();
    }
    for (; i < source.size() && source[i] != quote; ++i) {
      out += source[i];
      if (source[i] == '\\' && i + 1 < source.size()) out += source[++i];
    }
    if (i < source.size()) out += source[i++];
  }
  return out;
}

// `rename` keeps every reference, those in code and in lists of environments too.
void rename_in_values(Scene& s, const std::string& old, const std::string& name) {
  const auto changed = [&](Role role, const std::shared_ptr<const Routine>& code) -> std::shared_ptr<const Routine> {
    if (!code || code->language != "lua" || code->source.find(old) == std::string::npos) return nullptr;
    const std::string source = renamed(code->source, old, name);
    if (source == code->source) return nullptr;
    auto made = make_lua(role, source);
    return made ? *std::move(made) : nullptr;
  };
  const auto change = [&](Value& v) {
    if (auto* p = std::get_if<Procedure>(&v))
      if (auto code = changed(Role::value, p->code)) p->code = std::move(code);
    if (auto* names = std::get_if<Names>(&v)) {
      auto list = **names;
      std::replace(list.begin(), list.end(), old, name);
      *names = Names(std::move(list));
    }
    if (auto* moves = std::get_if<Moves>(&v)) {
      Motion motion = **moves;
      for (Factor& f : motion.factors)
        if (f.about == old) f.about = name;
      *moves = Moves(std::move(motion));
    }
  };
  const auto speaks = [&](const Value& v) {
    if (const auto* names = std::get_if<Names>(&v))
      return std::find((*names)->begin(), (*names)->end(), old) != (*names)->end();
    if (const auto* moves = std::get_if<Moves>(&v))
      return std::any_of((*moves)->factors.begin(), (*moves)->factors.end(),
                         [&](const Factor& f) { return f.about == old; });
    const auto* p = std::get_if<Procedure>(&v);
    return p && changed(Role::value, p->code);
  };
  for (std::size_t i = 0; i < s.procedures->size(); ++i)
    if (auto code = changed((*s.procedures)[i].role, (*s.procedures)[i].code))
      s.procedures.edit()[i].code = std::move(code);
  for (std::size_t i = 0; i < s.defined->size(); ++i)
    if (speaks((*s.defined)[i].rest)) change(s.defined.edit()[i].rest);
  for (std::size_t i = 0; i < s.objects.size(); ++i) {
    const auto& slots = s.objects[i].slots;
    for (std::size_t k = 0; k < slots.size(); ++k) {
      const auto in = [&](const Track& t) {
        bool any = false;
        t.events.each([&](const Event& e) { any = any || speaks(e.value); });
        return any;
      };
      const auto edit = [&](Track& t) {
        t.events.edit_between({INT64_MIN}, {INT64_MAX}, [&](Event& e) { change(e.value); });
      };
      if (slots[k].set && speaks(*slots[k].set)) change(*s.objects.edit(i).slots[k].set);
      if (in(*slots[k].track)) edit(s.objects.edit(i).slots[k].track.edit());
      for (std::size_t n = 0; n < slots[k].components.size(); ++n)
        if (in(*slots[k].components[n])) edit(s.objects.edit(i).slots[k].components[n].edit());
    }
  }
}

// `car/wheel` is coupled to `car` from the beginning.
bool parent_by_name(Command& k, const std::string& name, std::string_view about, ObjectId& parent) {
  auto& [s, c, time, layer, script] = k;
  const auto slash = name.rfind('/');
  if (slash == std::string::npos) return true;
  const std::string above = name.substr(0, slash);
  parent = s.names.find(above);
  return parent ? true
                : c.fail(ErrorCode::name, fmt::format("there is no '{}' that '{}' could belong to", above, name), about,
                         fmt::format("create {} first", above));
}

bool create(Command& k) {
  auto& [s, c, time, layer, script] = k;
  const std::string_view word = c.next_word();
  if (word.empty()) return c.fail_here(ErrorCode::syntax, "a name is missing here");
  auto names = expand_braces(word);
  if (!names) return c.fail(names.error().code, names.error().message, word);
  if (script.only && !std::exchange(script.only->met, true)) names = std::vector{script.only->name};
  if (!script.only && names->size() > 1) script.touched = names->size();
  for (const auto& name : *names)
    if (!free_name(k, name, word)) return false;
  const std::string_view kind_word = c.next_word();
  Object object;
  ObjectId original;
  if (kind_word == "like") {
    if (!values(k).object(original)) return false;
    object = s.objects[original.index];
    object.derived = false;
  } else {
    const auto kind = find_kind(kind_word);
    if (kind == Kind::layer)
      return c.fail(ErrorCode::name, "a layer is made by a command of its own", kind_word,
                    fmt::format("layer {} add", word.substr(0, 40)));
    if (kind == Kind::environment)
      return c.fail(ErrorCode::name, "an environment is made by a command of its own", kind_word,
                    fmt::format("animate {} every 1t by rotate(6deg, z)", word.substr(0, 40)));
    if (!kind) {
      std::string hint = did_you_mean(kind_word, {kind_names.begin(), kind_names.end()});
      if (hint.empty()) hint = road(kind_word);
      if (hint.empty()) {
        hint = "kinds are";
        for (auto k : kind_names) hint += " " + std::string(k);
      }
      return c.fail(
          ErrorCode::name,
          kind_word.empty() ? "a kind is missing here" : fmt::format("there is no kind '{}'", kind_word.substr(0, 40)),
          kind_word.empty() ? std::string_view(c.at, 0) : kind_word, hint);
    }
    object.kind = *kind;
  }
  if (!parameters(k, object)) return false;
  if (object.kind == Kind::mesh && !object.find(fn::file))
    return c.fail(ErrorCode::syntax, "a mesh needs its file", kind_word, "as in file=\"cow.obj\"");
  std::vector<ObjectId> parents(names->size());
  std::vector<std::string> sorted = *names;
  std::sort(sorted.begin(), sorted.end());
  if (const auto twice = std::adjacent_find(sorted.begin(), sorted.end()); twice != sorted.end())
    return c.fail(ErrorCode::name, fmt::format("'{}' would be made twice", *twice), word);
  if (s.objects.size() + names->size() > most_objects)
    return c.fail(ErrorCode::range, fmt::format("a film has at most {} objects", most_objects), word);
  for (std::size_t i = 0; i < names->size(); ++i)
    if (!parent_by_name(k, (*names)[i], word, parents[i])) return false;
  for (std::size_t i = 0; i < names->size(); ++i) {
    Object each = object;
    each.name = (*names)[i];
    each.leads = false;
    if (original && each.find(fn::motion))
      each.slot(fn::motion).track =
          Cow<Track>(centred(*each.find(fn::motion)->track, s.objects[original.index].name, each.name));
    if (parents[i]) {
      each.slot(fn::attachment).set = Attachment{AttachmentKind::couple, parents[i], false};
      if (!s.objects[parents[i].index].leads) s.objects.edit(parents[i].index).leads = true;
    }
    add_object(s, std::move(each));
  }
  return true;
}

bool remove(Command& k) {
  auto& [s, c, time, layer, script] = k;
  std::string_view word;
  std::vector<ObjectId> found;
  if (!objects(k, word, found) || !finish(c)) return false;
  keep_centres(k, found, word);
  keep_ways(k, found, word);
  remove_objects(s, found);
  return true;
}

bool rename(Command& k) {
  auto& [s, c, time, layer, script] = k;
  ObjectId id;
  c.space();
  if (!versions(s, c.peek_word()).empty()) return rename_list(k);
  if (is_pattern(c.peek_word()))
    return c.fail_here(ErrorCode::syntax, "one object gets another name: a pattern is none",
                       "as in rename ball planet");
  const char* start = c.at;
  if (!values(k).object(id) || !own(k, id, c.since(start))) return false;
  const std::string_view word = c.next_word();
  const std::string name(word);
  if (word.empty()) return c.fail_here(ErrorCode::syntax, "the new name is missing here");
  if (!free_name(k, name, word) || !finish(c)) return false;
  const std::string old = s.objects[id.index].name;
  const auto among = [&](std::string_view element) {
    const auto all = select(s, element);
    return std::find(all.begin(), all.end(), id) != all.end();
  };
  std::vector<std::pair<std::string, std::string>> meant;  // an alias, and the pattern in it that names the object
  for (const auto& [alias, elements] : *s.aliases)
    for (const std::string& e : elements)
      if (is_pattern(e) && among(e)) meant.emplace_back(alias, e);
  s.names.erase(old);
  s.names.put(name, id);
  s.objects.edit(id.index).name = name;
  rename_in_values(s, old, name);
  if (s.objects[id.index].environment) rename_environment(s, old, name);
  for (const auto& alias : *s.aliases) {  // aliases speak of objects by name
    if (std::find(alias.second.begin(), alias.second.end(), old) == alias.second.end()) continue;
    for (auto& a : s.aliases.edit()) std::replace(a.second.begin(), a.second.end(), old, name);
    break;
  }
  for (const auto& [alias, pattern] : meant) {  // and what a pattern named stays, under its new name
    if (among(alias)) continue;
    auto& elements = s.aliases.edit()[alias];
    elements.insert(std::find(elements.begin(), elements.end(), pattern) + 1, name);
  }
  return true;
}

constexpr Verb objects_rows[] = {
    {"create", "create NAME KIND [key=value …] or create NAME like OTHER",
     "Makes an object of a kind, or one like another.", "create moon sphere radius=0.5 color=silver", 0, create},
    {"remove", "remove NAME", "Takes objects out of the film.", "remove wheel*", 0, remove},
    {"rename", "rename OLD NEW, an object or a display list",
     "Gives an object or a display list another name; all that spoke of it goes on.", "rename ball planet", 0, rename},
};

}  // namespace

bool new_name(Cursor& c, std::string_view& out, std::string_view kind, std::string_view never) {
  out = c.next_word();
  if (out.empty()) return c.fail(ErrorCode::syntax, "a name is missing here", {c.at, 0});
  return (is_name(out) && out.find_first_of(never) == std::string_view::npos) ||
         c.fail(ErrorCode::syntax, fmt::format("'{}' cannot be a {}", out.substr(0, 60), kind), out);
}

bool free_name(Command& k, const std::string& name, std::string_view about) {
  auto& [s, c, time, layer, script] = k;
  if (!is_name(name))
    return c.fail(ErrorCode::syntax, fmt::format("'{}' cannot be a name", name.substr(0, 60)), about,
                  "a name starts with a letter; letters, digits, '-', '_' and '/' follow");
  if (name == "none") return c.fail(ErrorCode::name, "'none' means no object; it cannot be a name", about);
  if (const ObjectId id = s.names.find(name)) {
    const Kind kind = s.objects[id.index].kind;
    return placed(kind) ? c.fail(ErrorCode::name, fmt::format("there is a '{}' already", name), about)
                        : c.fail(ErrorCode::name, fmt::format("there is {} '{}' already", a_kind(kind), name), about,
                                 "objects, environments and layers have names of their own");
  }
  if (s.aliases->contains(name))
    return c.fail(ErrorCode::name, fmt::format("'{}' is an alias already", name), about,
                  "an alias wins over an object");
  if (s.lists->empty() && s.later_lists->empty()) return true;
  if (!versions(s, name).empty())
    return c.fail(ErrorCode::name, fmt::format("there is a display list '{}' already", name), about);
  for (std::size_t slash = name.find('/'); slash != std::string::npos; slash = name.find('/', slash + 1))
    if (const std::string above = name.substr(0, slash); !versions(s, above).empty())
      return c.fail(ErrorCode::name,
                    fmt::format("names that begin with '{}/' are for what that display list draws", above), about);
  return true;
}

// What display lists draw is changed by their rows only.
bool own(Command& k, ObjectId id, std::string_view about) {
  auto& [s, c, time, layer, script] = k;
  if (!s.objects[id.index].derived) return true;
  return c.fail(ErrorCode::type, fmt::format("display lists say what '{}' is", s.objects[id.index].name), about,
                fmt::format("edit {}, or what it calls", s.main));
}

bool parameters(Command& k, Object& object) {
  auto& [s, c, time, layer, script] = k;
  while (!c.at_line_end()) {
    const std::string_view key = c.word();
    if (key.empty()) return c.fail_here(ErrorCode::syntax, "key=value is wanted here");
    if (!c.accept('=')) {
      const auto colon = key.find(':');
      return c.fail(
          ErrorCode::syntax, fmt::format("'{}' needs a value", key.substr(0, std::min<std::size_t>(colon, 40))), key,
          key == "at" ? "a place is said by position=(0 0 0)"
          : colon != std::string_view::npos
              ? fmt::format("write {}={}", key.substr(0, std::min<std::size_t>(colon, 40)), key.substr(colon + 1, 40))
              : fmt::format("as in {}=…", key.substr(0, 40)));
    }
    const auto dot = key.find('.');
    const std::string_view name = key.substr(0, dot);
    const auto f = find_function(s, object.kind, name);
    if (!f) {
      return c.fail(ErrorCode::name, fmt::format("{} has no '{}'", a_kind(object.kind), name.substr(0, 40)), name,
                    did_you_mean(name, function_names(s, object.kind)));
    }
    const FunctionSpec& spec = spec_of(s, *f);
    const int component = dot == std::string_view::npos ? -1 : find_component(spec.type, key.substr(dot + 1));
    if (dot != std::string_view::npos && component < 0)
      return c.fail(ErrorCode::name, fmt::format("{} has no component '{}'", spec.name, key.substr(dot + 1, 40)),
                    key.substr(dot + 1));
    c.space();
    if (c.peek() == '"' && spec.type != Type::text && c.end - c.at > 1) {
      // A formula in quotes would be a procedure.
      return c.fail_here(ErrorCode::type, fmt::format("{} is {}, not a text", spec.name, to_string(spec.type)));
    }
    if (spec.type == Type::motion)
      return c.fail(ErrorCode::type, "a motion is not set: it takes a segment of time", key,
                    "as in at 1f..24f wheel.motion T(6 0)");
    if (spec.type == Type::attachment)
      return c.fail(ErrorCode::type, "an attachment is not set", key, "couple A to B, attach A to B, hang A on B");
    Value v;
    if (!values(k).value(spec, component, v, *f)) return false;
    Slot& slot = object.slot(*f);
    if (component >= 0 && slot.set && std::holds_alternative<Quat>(*slot.set))
      return c.fail(ErrorCode::type, "an orientation has no separate angles", key);
    slot.set = component < 0 ? v : with_component(slot.set.value_or(spec.rest), component, std::get<double>(v));
  }
  return true;
}

// One or more objects: a name that exists, an alias, or a pattern (which may name none).
bool objects(Command& k, std::string_view& word, std::vector<ObjectId>& out) {
  auto& [s, c, time, layer, script] = k;
  word = c.next_word();
  if (word.empty()) return c.fail_here(ErrorCode::syntax, "the name of an object is missing here");
  out = named(k, word);
  const bool any = !out.empty();
  if (!is_pattern(word) && out.size() == 1 && !own(k, out[0], word)) return false;
  std::erase_if(out, [&](ObjectId id) { return s.objects[id.index].derived; });
  if (any) return true;
  if (is_pattern(word) || s.aliases->contains(std::string(word))) {
    if (const auto braces = expand_braces(word); !braces)
      return c.fail(braces.error().code, braces.error().message, word);
    script.note(Severity::notice, fmt::format("'{}' names nothing", word), word);
    return true;
  }
  c.at = word.data();
  ObjectId id;
  return values(k).object(id);  // says what is wrong
}

std::span<const Verb> objects_verbs() { return objects_rows; }

}  // namespace betwixt
