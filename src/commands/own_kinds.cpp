// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The commands for the author's own kinds. model_updates.cpp updates their instances.
#include "commands/own_kinds.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/names.h"
#include "commands/plugins.h"
#include "commands/reader.h"
#include "scene/names.h"

namespace betwixt {
namespace {

constexpr std::size_t most_kinds = 1000;

// Reads `of (A B …)`: the existing objects that become instances.
bool linked(Command& k, std::vector<ObjectId>& out) {
  Cursor& c = k.cursor;
  c.space();
  if (c.peek() != '(')
    return c.fail_here(ErrorCode::syntax, "names in brackets are missing here", "as in of (anna bert)");
  if (!c.open()) return false;
  for (c.space(); c.peek() != ')'; c.space()) {
    const std::string_view word = c.next_word();
    if (word.empty()) return c.fail_here(ErrorCode::syntax, "a name or ')' is missing here");
    const std::vector<ObjectId> found = select(k.scene, word);
    if (found.empty()) return c.fail(unknown_name("object", word, near_object(k.scene, word)), word);
    out.insert(out.end(), found.begin(), found.end());
  }
  return c.close();
}

// Returns the instance that an existing object is, with the parts that have the names and kinds of the model's.
KindInstance linked_instance(const Scene& s, const OwnKind& kind, ObjectId root) {
  KindInstance one;
  const std::string &model = s.objects[kind.model().index].name, &name = s.objects[root.index].name;
  for (const ObjectId part : kind.parts) {
    const Object& o = s.objects[part.index];
    const ObjectId id = s.names.find(name + o.name.substr(model.size()));
    one.parts.push_back(find_object(s, id) && s.objects[id.index].kind == o.kind ? id : ObjectId{});
  }
  return one;
}

bool link(Command& k, OwnKind& kind, const std::vector<ObjectId>& roots, std::string_view about) {
  const Scene& s = k.scene;
  const Object& model = s.objects[kind.model().index];
  for (const ObjectId root : roots) {
    const Object& o = s.objects[root.index];
    if (root == kind.model() || o.kind != model.kind || o.derived)
      return k.cursor.fail(ErrorCode::type, fmt::format("'{}' cannot be an instance of '{}'", o.name, kind.name), about,
                           root == kind.model() ? "it is the model of this kind"
                                                : fmt::format("an instance is {}, like the model", a_kind(model.kind)));
    if (const OwnKind* other = s.kinds->of(root))
      return k.cursor.fail(ErrorCode::name, fmt::format("'{}' is already an instance of '{}'", o.name, other->name),
                           about, fmt::format("unlink {} first", o.name));
    if (is_below(o.name, model.name))
      return k.cursor.fail(ErrorCode::name, fmt::format("'{}' is part of the model of '{}'", o.name, kind.name), about);
    kind.instances.emplace_back(linked_instance(s, kind, root));
  }
  return true;
}

bool kind_name(Command& k, std::string_view& name) {
  auto& [s, c, time, layer, script] = k;
  if (!new_name(c, name, "kind's name", "/")) return false;
  if (name == "scene" || name == "like" || find_kind(name) || s.kinds->find(name))
    return c.fail(ErrorCode::name, fmt::format("a kind '{}' already exists", name), name);
  if (s.kinds->all.size() >= most_kinds)
    return c.fail(ErrorCode::range, fmt::format("a film can define at most {} kinds", most_kinds), name);
  return true;
}

bool unlink_kind(Command& k) {
  auto& [s, c, time, layer, script] = k;
  const std::string_view name = c.next_word();
  const OwnKind* kind = s.kinds->find(name);
  if (!kind) {
    std::vector<std::string_view> names;
    for (const OwnKind& one : s.kinds->all) names.push_back(one.name);
    return c.fail(ErrorCode::name, fmt::format("there is no kind '{}' of your own", name.substr(0, 40)), name,
                  did_you_mean(name, names));
  }
  if (!finish(c)) return false;
  for (const ObjectId id : kind->parts)
    if (s.objects[id.index].hidden) s.objects.edit(id.index).hidden = false;
  std::erase_if(s.kinds.edit().all, [&](const OwnKind& one) { return one.name == name; });
  return true;
}

bool unlink(Command& k) {
  auto& [s, c, time, layer, script] = k;
  c.space();
  Cursor after = c;
  if (after.next_word() == "kind" && !after.at_line_end()) return c.next_word(), unlink_kind(k);
  std::string_view word;
  std::vector<ObjectId> found;
  if (!objects(k, word, found) || !finish(c)) return false;
  std::vector<bool> chosen(s.objects.size());
  for (const ObjectId id : found) chosen[id.index] = true;
  const auto named = [&](const Cow<KindInstance>& one) { return chosen[one->parts.front().index]; };
  std::size_t count = 0;
  for (const OwnKind& kind : s.kinds->all)
    count += static_cast<std::size_t>(std::count_if(kind.instances.begin(), kind.instances.end(), named));
  if (count == 0 && !found.empty())
    return c.fail(ErrorCode::type, fmt::format("'{}' is no instance of a kind of your own", word.substr(0, 60)), word,
                  "name the whole instance; a part of it follows with it. unlink kind NAME ends a kind");
  if (count > 0)
    for (OwnKind& kind : s.kinds.edit().all) std::erase_if(kind.instances, named);
  return true;
}

// `revert anna.color anna/hat`: targets and objects.
bool revert_words(Command& k) {
  auto& [s, c, time, layer, script] = k;
  std::vector<std::pair<ObjectId, std::optional<FunctionId>>> what;
  const char* const start = (c.space(), c.at);
  do {
    Cursor after = c;
    std::string_view word = after.next_word();
    if (word.find('.') != word.npos) {
      Selected found;
      c = after;
      if (!targets(k, word, found, Meant::any)) return false;
      for (const Target& t : found.targets) what.emplace_back(t.object, t.function);
    } else {
      std::vector<ObjectId> found;
      if (!objects(k, word, found)) return false;
      for (const ObjectId id : found) {
        what.emplace_back(id, std::nullopt);
        for (const ObjectId part : script.below(s, s.objects[id.index].name, false))
          what.emplace_back(part, std::nullopt);
      }
    }
    c.space();
  } while (!c.at_line_end());
  Rollback whole(s);
  if (revert(s, what) == 0 && !what.empty())
    return c.fail(ErrorCode::type, "no instance of a kind of your own is named here", c.since(start),
                  "as in revert anna.color, or revert anna/hat, for an instance anna");
  whole.keep();
  return true;
}

constexpr Verb own_kinds_rows[] = {
    {"revert", "revert TARGET … or revert OBJECTS …",
     "Gives an instance of a kind of your own the values of the model again, so that it follows the model: one "
     "function, or all functions of an object and of the parts below it. The place of the whole instance stays.",
     "define kind toy like ball\ncreate copy1 toy color=red\nrevert copy1.color", 0, revert_words,
     "TARGET OBJECT; TARGET OBJECT…"},
    {"unlink", "unlink OBJECTS or unlink kind NAME",
     "Makes instances of a kind of your own ordinary objects, which no longer follow the model. `unlink kind` ends the "
     "kind.",
     "define kind toy like ball\ncreate copy1 toy\nunlink copy1", 0, unlink, "OBJECT kind; OBJECT…"},
};

}  // namespace

bool defines_kind(Cursor c) {
  if (c.next_word() != "kind") return false;
  c.next_word();
  return c.next_word() == "like";
}

bool define_kind(Command& k) {
  auto& [s, c, time, layer, script] = k;
  c.next_word();  // kind
  std::string_view name;
  if (!kind_name(k, name)) return false;
  c.next_word();  // like
  c.space();
  const char* const start = c.at;
  OwnKind kind{std::string(name), false, {}, {}};
  ObjectId model;
  if (!values(k).object(model) || !own(k, model, c.since(start))) return false;
  kind.parts = script.below(s, s.objects[model.index].name, false);
  kind.parts.insert(kind.parts.begin(), model);
  kind.hidden = c.accept_word("hidden");
  std::vector<ObjectId> roots;
  c.space();
  const char* const of = c.at;
  if (c.accept_word("of") && !linked(k, roots)) return false;
  if (!link(k, kind, roots, c.since(of)) || !finish(c)) return false;
  Rollback whole(s);
  for (const ObjectId id : kind.parts)
    if (kind.hidden) s.objects.edit(id.index).hidden = true;
  s.kinds.edit().all.push_back(std::move(kind));
  s.kinds_saw = s.objects;
  if (!no_circles(k, c.since(of))) return false;
  whole.keep();
  return true;
}

const OwnKind* find_own_kind(Command& k, std::string_view name) {
  Scene& s = k.scene;
  if (const OwnKind* known = s.kinds->find(name)) return known;
  const auto lines = plugin_kind(name);
  if (!lines) return nullptr;
  Rollback whole(s);
  Diagnostics said;
  LoadOptions options;
  Script script(s, said, options);
  read_text(s, script, fmt::format("{0}\ndefine kind {1} like {1} hidden\n", *lines, name), "");
  for (const Diagnostic& d : said)
    if (d.severity == Severity::error) {
      k.cursor.fail(d.what.code, fmt::format("the plug-in's kind '{}' cannot be made: {}", name, d.what.message), name);
      return nullptr;
    }
  whole.keep();
  return s.kinds->find(name);
}

bool no_circle(Command& k, const OwnKind& kind, const std::string& name, std::string_view about) {
  const OwnKind* whole = circle(k.scene, kind, name);
  return !whole ||
         k.cursor.fail(
             ErrorCode::name,
             fmt::format("'{}' would be part of the model of '{}', which would then contain itself", name, whole->name),
             about, fmt::format("the model of '{}' is {}", whole->name, k.scene.objects[whole->model().index].name));
}

bool no_circles(Command& k, std::string_view about) {
  const Scene& s = k.scene;
  for (const OwnKind& kind : s.kinds->all)
    for (const Cow<KindInstance>& one : kind.instances)
      if (const Object& root = s.objects[one->parts.front().index]; !root.removed)
        if (!no_circle(k, kind, root.name, about)) return false;
  return true;
}

void add_instance(Scene& s, const std::string& kind_name, ObjectId first, const std::vector<FunctionId>& said) {
  for (OwnKind& kind : s.kinds.edit().all) {
    if (kind.name != kind_name) continue;
    KindInstance one;
    for (std::uint32_t n = 0; n < kind.parts.size(); ++n) one.parts.push_back({first.index + n});
    for (const FunctionId f : said) one.own[{kind.model().index, f, ObjectId::nothing}] |= aspect::set;
    kind.instances.emplace_back(std::move(one));
  }
}

std::span<const Verb> own_kinds_verbs() { return own_kinds_rows; }

}  // namespace betwixt
