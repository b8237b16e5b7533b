// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Targets: which display functions of which objects a pattern names.
#include <fmt/format.h>

#include <algorithm>

#include "base/names.h"
#include "language/reader.h"

namespace betwixt {

std::size_t first_dot(std::string_view w) {
  int braces = 0;
  for (std::size_t i = 0; i < w.size(); ++i) {
    if (w[i] == '{') ++braces;
    if (w[i] == '}') --braces;
    if (w[i] == '.' && braces <= 0) return i;
  }
  return std::string_view::npos;
}

bool Reader::targets(Cursor& c, std::string_view word, Selected& out, bool world_too) {
  out = {};
  out.text = word;
  const auto dot = first_dot(word);
  if (dot == std::string_view::npos)
    return c.fail(Code::syntax,
                  word.empty() ? "a target is missing here" : fmt::format("'{}' is not a target", word.substr(0, 60)),
                  word, "a target is an object and a function, as in ball.position");
  const std::string_view object = word.substr(0, dot);
  std::string_view function = word.substr(dot + 1), component;
  if (const auto second = first_dot(function); second != std::string_view::npos) {
    component = function.substr(second + 1);
    function = function.substr(0, second);
  }
  // .velocity, before or behind the component
  const auto strip = [&](std::string_view& from) {
    if (from != "velocity" && !from.ends_with(".velocity") && !from.starts_with("velocity.")) return;
    if (from == "velocity")
      from = {};
    else if (from.starts_with("velocity."))
      from.remove_prefix(9);
    else
      from.remove_suffix(9);
    out.velocity = true;
  };
  strip(component);
  const std::string_view function_text = function;
  const auto target = [&](ObjectId id, FunctionId f, int part) {
    Target t{id, f, part};
    t.velocity = out.velocity;
    t.layer = layer_;
    return t;
  };
  const auto still = [&](const FunctionSpec& spec) {
    return c.fail(Code::type, fmt::format("{} has no velocity: it is {}", spec.name, to_string(spec.type)),
                  function_text);
  };
  if (component.empty() && !is_pattern(word)) {  // one function of one object: what a million lines say
    const ObjectId id = s.aliases->contains(object) ? ObjectId{} : s.names.find(object);
    if (const auto f = id ? find_function(s, s.objects[id.index].kind, function) : std::nullopt) {
      if (!world_too && !own(c, id, word)) return false;
      out.spec = &spec_of(s, *f);
      if (out.velocity && !has_velocity(out.spec->type)) return still(*out.spec);
      out.targets.push_back(target(id, *f, -1));
      return true;
    }
  }
  std::vector<ObjectId> objects = select(s, object);
  if (!world_too) {  // patterns name only what can be changed
    if (objects.size() == 1 && !is_pattern(object) && !own(c, objects[0], word)) return false;
    std::erase_if(objects, [&](ObjectId id) { return s.objects[id.index].derived; });
  }
  if (objects.empty()) {
    const bool alias = s.aliases->contains(std::string(object));
    if (is_pattern(object) || alias) {
      if (is_pattern(object))
        if (const auto braces = expand_braces(object); !braces)
          return c.fail(braces.error().code, braces.error().message, object);
      note(Severity::notice, fmt::format("'{}' names nothing", object), object);
      return true;
    }
    std::vector<std::string_view> names;
    for (std::size_t i = 0; i < s.objects.size() && i < 10000; ++i)
      if (!s.objects[i].removed) names.push_back(s.objects[i].name);
    for (const auto& a : *s.aliases) names.push_back(a.first);
    return c.fail(Code::name, fmt::format("there is no object '{}'", object.substr(0, 60)), object,
                  did_you_mean(object, names));
  }
  const bool many_functions = is_pattern(function);
  std::vector<std::string> wanted{std::string(function)};
  if (many_functions) {
    auto braces = expand_braces(function);
    if (!braces) return c.fail(braces.error().code, braces.error().message, function);
    wanted = std::move(*braces);
  }
  if (const auto asked = find_asked(s.objects[objects[0].index].kind, function); asked && component.empty()) {
    if (!world_too) return c.fail(Code::type, fmt::format("'{}' can be asked for, not set", function), function);
    for (ObjectId id : objects)
      if (find_asked(s.objects[id.index].kind, function)) out.targets.push_back({id, *asked, -1});
    return true;
  }
  if (const auto asked = find_asked(s.objects[objects[0].index].kind, function); asked && !component.empty()) {
    if (!world_too) return c.fail(Code::type, fmt::format("'{}' can be asked for, not set", function), function);
    if (*asked == world_function)  // where it is
      for (const ObjectId id : objects)
        for (int i = 0; i < 3; ++i)
          if (const auto words = expand_braces(component, 100); words && find_asked(s.objects[id.index].kind, function))
            for (const std::string& w : *words)
              if (matches(w, component_name(Type::vector, i))) out.targets.push_back({id, *asked, i});
    if (!out.targets.empty()) return true;
    const std::string whole(word.substr(0, word.size() - component.size() - 1));
    return c.fail(Code::name, fmt::format("'{}' has no part '{}'", whole, component.substr(0, 40)), component,
                  *asked == world_function    ? fmt::format("{}.x, .y and .z say where it is", whole)
                  : *asked == motion_function ? fmt::format("{} is a matrix, row by row", whole)
                                              : fmt::format("ask for {}", whole));
  }
  for (ObjectId id : objects) {
    const Kind kind = s.objects[id.index].kind;
    for (const auto& want : wanted) {
      std::vector<FunctionId> found;
      if (is_pattern(want)) {
        for (const auto name : function_names(s, kind))
          if (matches(want, name)) found.push_back(*find_function(s, kind, name));
      } else if (const auto f = find_function(s, kind, want)) {
        found.push_back(*f);
      }
      for (FunctionId f : found) {
        const FunctionSpec& spec = spec_of(s, f);
        if (out.velocity && !has_velocity(spec.type)) {
          if (many_functions) continue;
          return still(spec);
        }
        std::vector<int> parts;
        if (component.empty()) {
          parts.push_back(-1);
        } else {
          const std::string near = has_velocity(spec.type) ? did_you_mean(component, {"velocity"}) : std::string();
          if (component_count(spec.type) == 0)
            return c.fail(Code::name, fmt::format("{} has no components: it is {}", spec.name, to_string(spec.type)),
                          component, near);
          const auto words = expand_braces(component, 100);
          if (!words) return c.fail(words.error().code, words.error().message, component);
          for (const auto& w : *words)
            for (int i = 0; i < component_count(spec.type); ++i)
              if (matches(w, component_name(spec.type, i)) && std::find(parts.begin(), parts.end(), i) == parts.end())
                parts.push_back(i);
          if (parts.empty())
            return c.fail(Code::name, fmt::format("{} has no component '{}'", spec.name, component.substr(0, 40)),
                          component,
                          !near.empty()              ? near
                          : spec.type == Type::color ? "components are r, g and b"
                          : spec.type == Type::pair  ? "components are x and y"
                                                     : "components are x, y and z");
        }
        if (!out.spec) out.spec = &spec, out.component = parts[0];
        if (!world_too && (spec.type != out.spec->type || spec.unit != out.spec->unit)) {
          if (many_functions)
            return c.fail(Code::type,
                          spec.type == out.spec->type
                              ? fmt::format("{} and {} are measured in different units", out.spec->name, spec.name)
                              : fmt::format("these functions have values of different types: {} is {}, {} is {}",
                                            out.spec->name, to_string(out.spec->type), spec.name, to_string(spec.type)),
                          function_text);
          continue;
        }
        for (int part : parts) out.targets.push_back(target(id, f, part));
      }
    }
  }
  if (!out.targets.empty()) return true;
  if (many_functions) {
    note(Severity::notice, fmt::format("'{}' names nothing", word), word);
    return true;
  }
  const Object& o = s.objects[objects[0].index];
  auto names = function_names(s, o.kind);
  names.push_back("world");
  return c.fail(Code::name,
                fmt::format("'{}', {}, has no function '{}'", o.name, a_kind(o.kind), function.substr(0, 40)), function,
                did_you_mean(function, names));
}

}  // namespace betwixt
