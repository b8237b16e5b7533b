// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "commands/command_parameters.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/names.h"
#include "language/code_names.h"
#include "procedure/lua.h"
#include "scene/names.h"

namespace betwixt {
namespace {

constexpr std::size_t most_parameters = 30;

std::string in_lua(const Value& v) {
  if (const auto* n = std::get_if<double>(&v)) return write_number(*n);
  if (const auto* b = std::get_if<bool>(&v)) return *b ? "true" : "false";
  if (const auto* p = std::get_if<Vec3>(&v)) return write_code(*p);
  if (const auto* c = std::get_if<Color>(&v)) return write_code(*c);
  if (const auto* t = std::get_if<Text>(&v)) return write_code(*t);
  return "nil";
}

template <Type type>
bool read_value(Command& k, std::string& code) {
  FunctionSpec spec{.name = "value", .type = type, .rest = row_of(type).example(), .kinds = 0xffffffff};
  Value v;
  if (!values(k).value(spec, -1, v)) return false;
  code = in_lua(v);
  return true;
}

bool read_object(Command& k, std::string& code) {
  ObjectId id;
  if (!values(k).object(id)) return false;
  code = write_text(k.scene.objects[id.index].name);
  return true;
}

bool read_objects(Command& k, std::string& code) {
  Cursor& c = k.cursor;
  const std::string_view word = c.next_word();
  if (word.empty()) return c.fail_here(ErrorCode::syntax, "a name or a pattern is missing here");
  const std::vector<ObjectId> all = select(k.scene, word);
  if (all.empty() && !is_pattern(word)) return c.fail(unknown_name("object", word, near_object(k.scene, word)), word);
  if (all.empty()) return c.fail(nothing_named(word), word);
  code = "{";
  for (const ObjectId id : all) code += write_text(k.scene.objects[id.index].name) + ",";
  code += "}";
  return true;
}

template <bool (Cursor::*read)(Time&)>
bool read_seconds(Command& k, std::string& code) {
  Time t;
  if (!(k.cursor.*read)(t)) return false;
  code = write_number(t.seconds());
  return true;
}

struct ParameterType {
  std::string_view word;
  bool (*read)(Command&, std::string& code);
};
constexpr std::array<ParameterType, 10> parameter_types{{{"object", read_object},
                                                         {"objects", read_objects},
                                                         {"time", read_seconds<&Cursor::time>},
                                                         {"length", read_seconds<&Cursor::length>},
                                                         {"number", read_value<Type::scalar>},
                                                         {"angle", read_value<Type::angle>},
                                                         {"vector", read_value<Type::vector>},
                                                         {"color", read_value<Type::color>},
                                                         {"boolean", read_value<Type::boolean>},
                                                         {"text", read_value<Type::text>}}};

const ParameterType* type_called(std::string_view word) {
  const auto at = std::find_if(parameter_types.begin(), parameter_types.end(),
                               [&](const ParameterType& t) { return t.word == word; });
  return at == parameter_types.end() ? nullptr : &*at;
}

// Reads NAME TYPE [= DEFAULT].
bool read_parameter(Command& k, std::vector<CommandParameter>& out) {
  Cursor& c = k.cursor;
  const std::string_view name = c.next_word();
  if (name.empty()) return c.fail_here(ErrorCode::syntax, "the name of a parameter is missing here");
  if (name.find_first_of("-/.") != std::string_view::npos || !is_name(name) ||
      !make_lua(Role::command, fmt::format("local {} = nil", name)))
    return c.fail(ErrorCode::syntax, fmt::format("'{}' cannot be a parameter's name", name.substr(0, 60)), name,
                  "letters, digits and '_' can be in it, as in Lua");
  if (std::any_of(out.begin(), out.end(), [&](const CommandParameter& p) { return p.name == name; }))
    return c.fail(ErrorCode::name, fmt::format("there are two parameters '{}'", name), name);
  const std::string_view word = c.next_word();
  const ParameterType* type = type_called(word);
  if (!type) {
    std::vector<std::string_view> words;
    for (const ParameterType& t : parameter_types) words.push_back(t.word);
    if (word.empty())
      return c.fail_here(ErrorCode::syntax, fmt::format("the type of '{}' is missing here", name),
                         fmt::format("types are {}", fmt::join(words, " ")));
    const Hint near = did_you_mean(word, words);
    return c.fail(ErrorCode::name, fmt::format("there is no type '{}' of parameters", word.substr(0, 40)), word,
                  near.empty() ? Hint(fmt::format("types are {}", fmt::join(words, " "))) : near);
  }
  CommandParameter made{std::string(name), std::string(word), {}, {}};
  c.space();
  if (c.accept('=')) {
    c.space();
    const char* const start = c.at;
    if (c.accept_word("none"))
      made.code = "nil";
    else if (!type->read(k, made.code))
      return false;
    made.said = std::string(start, c.at);
  }
  out.push_back(std::move(made));
  return true;
}

}  // namespace

bool read_parameters(Command& k, std::vector<CommandParameter>& out) {
  Cursor& c = k.cursor;
  if (!c.open()) return false;
  for (c.space(); c.peek() != ')'; c.space()) {
    if (c.at >= c.end) return c.fail_here(ErrorCode::syntax, "this bracket is never closed");
    if (out.size() >= most_parameters)
      return c.fail_here(ErrorCode::range, fmt::format("a command can have at most {} parameters", most_parameters));
    if (!read_parameter(k, out)) return false;
  }
  return c.close();
}

std::string declared(const std::vector<CommandParameter>& all, const std::vector<std::string>& codes) {
  if (all.empty()) return {};
  std::vector<std::string_view> names;
  for (const CommandParameter& p : all) names.push_back(p.name);
  return fmt::format("local {} = {} ", fmt::join(names, ", "),
                     codes.empty() ? "nil" : fmt::format("{}", fmt::join(codes, ", ")));
}

bool read_arguments(Command& k, const NamedProcedure& of, std::string_view about, std::vector<std::string>& codes) {
  Cursor& c = k.cursor;
  const auto& all = of.parameters;
  codes.assign(all.size(), "");
  std::vector<std::string_view> keys;
  for (const CommandParameter& p : all) keys.push_back(p.name);
  std::size_t next = 0;
  bool named = false;
  while (!c.at_line_end()) {
    const char* const start = c.at;
    Cursor ahead = c;
    const std::string_view key = ahead.word();
    std::size_t at = next;
    if (!key.empty() && ahead.accept('=')) {
      c = ahead, named = true;
      c.space();
      at = static_cast<std::size_t>(std::find(keys.begin(), keys.end(), key) - keys.begin());
      if (at == all.size())
        return c.fail(ErrorCode::name, fmt::format("{} has no '{}'", of.name, key.substr(0, 40)), key,
                      did_you_mean(key, keys));
      if (!codes[at].empty()) return c.fail(ErrorCode::syntax, fmt::format("'{}' is given twice", key), key);
    } else if (named || next == all.size()) {
      return c.fail_here(ErrorCode::syntax, named ? "after NAME=VALUE, all other arguments need names too"
                                                  : "nothing more is expected here");
    } else {
      ++next;
    }
    if (all[at].code == "nil" && c.accept_word("none")) {
      codes[at] = "nil";
    } else if (!type_called(all[at].type)->read(k, codes[at])) {
      if (c.where.data() == nullptr) c.where = c.since(start);
      return false;
    }
  }
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (codes[i].empty()) codes[i] = all[i].code;
    if (codes[i].empty()) return c.fail(ErrorCode::syntax, fmt::format("{} needs '{}'", of.name, all[i].name), about);
  }
  return true;
}

std::string usage_of(const NamedProcedure& p) {
  std::string out = p.name;
  for (const CommandParameter& one : p.parameters) {
    std::string word = one.type;
    std::transform(word.begin(), word.end(), word.begin(), [](char c) { return static_cast<char>(c - 'a' + 'A'); });
    out += one.code.empty()     ? fmt::format(" {}={}", one.name, word)
           : one.said == "none" ? fmt::format(" [{}={}]", one.name, word)
                                : fmt::format(" [{}={}]", one.name, one.said);
  }
  return out;
}

}  // namespace betwixt
