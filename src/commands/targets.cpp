// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Targets: finds the display functions and objects that a pattern names.
#include <fmt/format.h>

#include <algorithm>

#include "base/cancellation.h"
#include "base/names.h"
#include "commands/command.h"
#include "commands/foreign_words.h"
#include "scene/names.h"

namespace betwixt {
namespace {

// OBJECT.FUNCTION.COMPONENT, each of which may be a pattern; `velocity` may precede or follow the component.
struct TargetWords {
  std::string_view whole, object, function, component;
  bool velocity = false;
};

TargetWords words_of(std::string_view word) {
  TargetWords w{word, {}, {}, {}};
  const auto dot = first_dot(word);
  w.object = word.substr(0, dot), w.function = word.substr(dot + 1);
  if (const auto second = first_dot(w.function); second != std::string_view::npos) {
    w.component = w.function.substr(second + 1);
    w.function = w.function.substr(0, second);
  }
  constexpr std::string_view velocity = "velocity";
  std::string_view& from = w.component;
  w.velocity = from == velocity || from.ends_with(".velocity") || from.starts_with("velocity.");
  if (w.velocity && from == velocity)
    from = {};
  else if (w.velocity && from.starts_with("velocity."))
    from.remove_prefix(velocity.size() + 1);
  else if (w.velocity)
    from.remove_suffix(velocity.size() + 1);
  return w;
}

// The state of one search for a pattern.
struct Search {
  Command& k;
  TargetWords words;
  Meant meant;
  Selected& out;
  std::vector<Target>& left_out;
  const Scene& scene() const { return k.scene; }
  Kind kind(ObjectId id) const { return k.scene.objects[id.index].kind; }

  Target target(ObjectId id, FunctionId f, int part) const {
    Target t{id, f, part};
    t.velocity = words.velocity;
    t.layer = k.layer;
    return t;
  }
  bool fail(ErrorCode code, std::string message, std::string_view about, Hint hint = {}) const {
    return k.cursor.fail(code, std::move(message), about, std::move(hint));
  }
  bool still(const FunctionSpec& spec) const {
    return fail(ErrorCode::type, fmt::format("{} has no velocity: it is {}", spec.name, to_string(spec.type)),
                words.function);
  }
  bool names_nothing(std::string_view what) const {
    k.script.names_nothing(what);
    return true;
  }
};

bool no_object(const Search& q) {
  const Scene& s = q.scene();
  const std::string_view object = q.words.object;
  if (is_pattern(object))
    if (const auto braces = expand_braces(with_keys(*s.tables, object)); !braces)
      return q.fail(braces.error().code, braces.error().message, object, braces.error().hint);
  if (is_pattern(object) || s.aliases->contains(std::string(object))) return q.names_nothing(object);
  return q.k.cursor.fail(unknown_name("object", object, near_object(s, object)), object);
}

// Finds targets for queries only: the world matrix and the like, or an object's place, as in world.x.
bool asked_for(const Search& q, const std::vector<ObjectId>& objects, Query asked) {
  const auto& [whole, object, function, component, velocity] = q.words;
  if (q.meant != Meant::asked)
    return q.fail(ErrorCode::type, fmt::format("'{}' can be read, but not set", function), function);
  const auto words =
      component.empty() ? Result<std::vector<std::string>>(std::vector<std::string>()) : expand_braces(component, 100);
  for (const ObjectId id : objects) {
    if (!find_query(q.kind(id), function)) continue;
    if (component.empty()) q.out.targets.push_back({id, asked, -1});
    for (int i = 0; i < 3 && asked == Query::world && words; ++i)
      for (const std::string& w : *words)
        if (matches(w, component_name(Type::vector, i))) q.out.targets.push_back({id, asked, i});
  }
  if (component.empty() || !q.out.targets.empty()) return true;
  const std::string_view without = whole.substr(0, whole.size() - component.size() - 1);
  return q.fail(ErrorCode::name, fmt::format("'{}' has no part '{}'", without, component.substr(0, 40)), component,
                asked == Query::world ? fmt::format("its position is {}.x, .y and .z", without)
                : asked == Query::by  ? fmt::format("{} is a matrix, row by row", without)
                                      : fmt::format("read {}", without));
}

// Finds the named components; -1 represents the whole.
bool parts_of(const Search& q, const FunctionSpec& spec, std::vector<int>& parts) {
  const std::string_view component = q.words.component;
  if (component.empty()) return parts.push_back(-1), true;
  const Hint near = has_velocity(spec.type) ? did_you_mean(component, {"velocity"}) : Hint();
  if (component_count(spec.type) == 0)
    return q.fail(ErrorCode::name, fmt::format("{} has no components: it is {}", spec.name, to_string(spec.type)),
                  component, near);
  const auto words = expand_braces(component, 100);
  if (!words) return q.fail(words.error().code, words.error().message, component);
  std::string known;
  for (int i = 0; i < component_count(spec.type); ++i) {
    const std::string_view name = component_name(spec.type, i);
    known += fmt::format("{}{}",
                         i == 0                               ? "components are "
                         : i + 1 < component_count(spec.type) ? ", "
                                                              : " and ",
                         name);
  }
  for (const auto& w : *words)
    for (int i = 0; i < component_count(spec.type); ++i)
      if (matches(w, component_name(spec.type, i)) && std::find(parts.begin(), parts.end(), i) == parts.end())
        parts.push_back(i);
  return !parts.empty() ||
         q.fail(ErrorCode::name, fmt::format("{} has no component '{}'", spec.name, component.substr(0, 40)), component,
                near.empty() ? known : near);
}

std::vector<FunctionId> functions(const Search& q, Kind kind, const std::string& want) {
  if (!is_pattern(want)) {
    const auto f = find_function(q.scene(), kind, want);
    return f ? std::vector{*f} : std::vector<FunctionId>();
  }
  std::vector<FunctionId> found;
  for (const auto name : function_names(q.scene(), kind))
    if (matches(want, name)) found.push_back(*find_function(q.scene(), kind, name));
  return found;
}

bool differ(const FunctionSpec& a, const FunctionSpec& b) { return a.type != b.type || a.unit != b.unit; }

bool unlike(Command& k, const FunctionSpec& a, const FunctionSpec& b, std::string_view about) {
  return k.cursor.fail(ErrorCode::type,
                       a.type == b.type ? fmt::format("{} and {} are measured in different units", a.name, b.name)
                                        : fmt::format("these functions have different types: {} is {}, {} is {}",
                                                      a.name, to_string(a.type), b.name, to_string(b.type)),
                       about);
}

// Adds one function of one object to the result.
bool take(const Search& q, ObjectId id, FunctionId f, bool many) {
  const FunctionSpec& spec = spec_of(q.scene(), f);
  Selected& out = q.out;
  if (out.velocity && !has_velocity(spec.type)) return many || q.still(spec);
  std::vector<int> parts;
  if (!parts_of(q, spec, parts)) return false;
  if (!out.spec) out.spec = &spec, out.component = parts[0];
  if (differ(spec, *out.spec) && (q.meant == Meant::alike || q.meant == Meant::named_alike)) {
    if (many) return unlike(q.k, *out.spec, spec, q.words.function);
    if (q.meant == Meant::alike) return q.left_out.push_back(q.target(id, f, parts[0])), true;
  }
  for (const int part : parts) out.targets.push_back(q.target(id, f, part));
  return true;
}

// Reports objects whose function of that name has values of another type.
void say_of_other_type(Command& k, const std::vector<Target>& those, std::string_view about, std::string why) {
  constexpr std::size_t most = 4;
  std::string names;
  for (std::size_t i = 0; i < those.size() && i < most; ++i)
    names += (i == 0 ? "" : ", ") + k.scene.objects[those[i].object.index].name;
  if (those.size() > most) names += fmt::format(" and {} more", those.size() - most);
  const FunctionSpec& spec = spec_of(k.scene, those[0].function);
  k.script.note(Severity::notice, fmt::format("left out: {}, whose {} is {}", names, spec.name, to_string(spec.type)),
                about, std::move(why));
}

bool no_function(const Search& q, ObjectId id, std::string_view function) {
  const Object& o = q.scene().objects[id.index];
  auto names = function_names(q.scene(), o.kind);
  names.push_back("world");
  Hint near = did_you_mean(function, names);
  if (function.find('.') != std::string_view::npos) near = "write the component after the braces: {position,scale}.y";
  return q.fail(ErrorCode::name,
                fmt::format("'{}', {}, has no function '{}'", o.name, a_kind(o.kind), function.substr(0, 40)),
                q.words.function,
                near.empty() ? Hint(std::string(foreign_word_hint(function == "opacity" ? "alpha" : function))) : near);
}

// Returns whether any kind of object has the function. If so, objects without it are left out; if not, its name is
// wrong.
bool anybody_has(const Scene& s, std::string_view function) {
  return std::any_of(kinds().begin(), kinds().end(),
                     [&](const KindRow& row) { return find_function(s, row.kind, function).has_value(); });
}

bool all_of(const Search& q, const std::vector<ObjectId>& objects) {
  const std::string_view function = q.words.function;
  const bool many = is_pattern(function);
  std::vector<std::string> wanted{std::string(function)};
  if (many) {
    auto braces = expand_braces(function);
    if (!braces) return q.fail(braces.error().code, braces.error().message, function);
    wanted = std::move(*braces);
  }
  std::vector<bool> found(wanted.size());
  for (const ObjectId id : objects) {
    Cancellation::check();
    for (std::size_t i = 0; i < wanted.size(); ++i)
      for (const FunctionId f : functions(q, q.kind(id), wanted[i])) {
        found[i] = true;
        if (!take(q, id, f, many)) return false;
      }
  }
  if (!q.left_out.empty()) say_of_other_type(q.k, q.left_out, q.words.whole, {});
  for (std::size_t i = 0; i < wanted.size() && wanted.size() > 1; ++i)  // finds the wrong word among several
    if (!found[i] && !is_pattern(wanted[i]) && !anybody_has(q.scene(), wanted[i]))
      return no_function(q, objects[0], wanted[i]);
  if (!q.out.targets.empty()) return true;
  return many ? q.names_nothing(q.words.whole) : no_function(q, objects[0], function);
}

// Groups the targets by the type of their values, in order of the first of each.
std::vector<Selected> by_type(const Scene& s, const Selected& all) {
  std::vector<Selected> types;
  for (const Target& t : all.targets) {
    const FunctionSpec& spec = spec_of(s, t.function);
    const auto known =
        std::find_if(types.begin(), types.end(), [&](const Selected& other) { return !differ(spec, *other.spec); });
    if (known != types.end())
      known->targets.push_back(t);
    else
      types.push_back({{t}, &spec, t.component, all.text, all.velocity});
  }
  return types;
}

// Targets that failed to read a value, and the error.
struct Refused {
  std::vector<Target> targets;
  std::optional<Error> error;
  std::string_view where;
};

}  // namespace

bool alike(Command& k, const Selected& of) {
  for (const Target& t : of.targets)
    if (const FunctionSpec& spec = spec_of(k.scene, t.function); differ(spec, *of.spec))
      return unlike(k, *of.spec, spec, words_of(of.text).function);
  return true;
}

bool to_each_type(Command& k, std::string_view word, const char* from,
                  const std::function<bool(const Selected&)>& read) {
  Selected all;
  const bool translates = k.scene.policy == Policy::translate;
  if (!targets(k, word, all, translates ? Meant::any : Meant::named_alike)) return false;
  if (!all.spec) return pass_over(k, from);
  if (all.targets.size() == 1) return read(all);
  const std::vector<Selected> types = by_type(k.scene, all);
  if (types.size() == 1) return read(types[0]);
  Cursor& c = k.cursor;
  const char* const value = c.at;
  const int depth = c.depth;
  const char* behind = nullptr;
  std::vector<Refused> refused;
  for (const Selected& one : types) {
    c.at = value, c.depth = depth;
    if (read(one)) {
      behind = c.at;
      continue;
    }
    if (translates) return false;
    refused.push_back({one.targets, std::exchange(c.error, std::nullopt), c.where});
  }
  if (behind == nullptr) return c.error = std::move(refused[0].error), c.where = refused[0].where, false;
  c.at = behind, c.depth = depth;
  for (Refused& r : refused)
    say_of_other_type(k, r.targets, word, r.error ? std::move(r.error->message) : std::string());
  return true;
}

bool for_each_type(Command& k, const Selected& all, const std::function<bool(const Selected&)>& rest) {
  const std::vector<Selected> types = by_type(k.scene, all);
  if (types.size() < 2) return rest(all);
  Cursor& c = k.cursor;
  const char* const start = c.at;
  const int depth = c.depth;
  const char* behind = nullptr;
  Rollback rollback(k.scene);
  Refused refused;
  for (const Selected& one : types) {
    c.at = start, c.depth = depth;
    if (rest(one)) {
      behind = c.at;
      continue;
    }
    if (!c.error || c.error->code != ErrorCode::type) return false;
    refused.targets.insert(refused.targets.end(), one.targets.begin(), one.targets.end());
    if (!refused.error) refused.error = c.error, refused.where = c.where;
    c.error.reset(), c.where = {};
  }
  if (behind == nullptr) return c.error = std::move(refused.error), c.where = refused.where, false;
  c.at = behind, c.depth = depth;
  rollback.keep();
  if (refused.error) say_left_out(k, refused.targets, all.text, std::move(refused.error->message));
  return true;
}

void say_left_out(Command& k, const std::vector<Target>& those, std::string_view about, std::string why) {
  constexpr std::size_t most = 4;
  std::string names;
  for (std::size_t i = 0; i < those.size() && i < most; ++i)
    names += (i == 0 ? "" : ", ") + target_name(k.scene, those[i]);
  if (those.size() > most) names += fmt::format(" and {} more", those.size() - most);
  k.script.note(Severity::notice, "left out: " + names, about, std::move(why));
}

bool targets(Command& k, std::string_view word, Selected& out, Meant meant) {
  const Scene& s = k.scene;
  const bool asking = meant == Meant::asked;
  out = {};
  out.text = word;
  if (first_dot(word) == std::string_view::npos)
    return k.cursor.fail(
        ErrorCode::syntax,
        word.empty() ? "a target is missing here" : fmt::format("'{}' is not a target", word.substr(0, 60)), word,
        "a target is an object and a function, as in ball.position");
  std::vector<Target> left_out;
  const Search q{k, words_of(word), meant, out, left_out};
  const std::string_view object = q.words.object;
  out.velocity = q.words.velocity;
  // A fast path for one function of one object, because scripts with a million lines consist of it.
  if (q.words.component.empty() && !is_pattern(word)) {
    const ObjectId id = s.aliases->contains(object) ? ObjectId{} : s.names.find(object);
    if (const auto f = id ? find_function(s, q.kind(id), q.words.function) : std::nullopt) {
      if (!asking && !own(k, id, word)) return false;
      out.spec = &spec_of(s, *f);
      if (out.velocity && !has_velocity(out.spec->type)) return q.still(*out.spec);
      out.targets.push_back(q.target(id, *f, -1));
      return true;
    }
  }
  std::vector<ObjectId> objects = named(k, object);
  if (!asking) {  // patterns name only targets that can be changed
    if (objects.size() == 1 && !is_pattern(object) && !own(k, objects[0], word)) return false;
    std::erase_if(objects, [&](ObjectId id) { return s.objects[id.index].derived; });
  }
  if (objects.empty()) return no_object(q);
  if (const auto asked = find_query(q.kind(objects[0]), q.words.function)) return asked_for(q, objects, *asked);
  return all_of(q, objects);
}

}  // namespace betwixt
