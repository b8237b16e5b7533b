// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Commands that make, remove and name objects.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <set>

#include "base/cancellation.h"
#include "base/counted.h"
#include "base/names.h"
#include "commands/command.h"
#include "commands/following.h"
#include "commands/foreign_words.h"
#include "commands/furnishing.h"
#include "commands/own_kinds.h"
#include "commands/parts.h"
#include "commands/plugins.h"
#include "commands/video_files.h"
#include "scene/formula_parts.h"

namespace betwixt {
namespace {

// Finds the parent in a name: `car/wheel` is coupled to `car` from the beginning.
bool parent_by_name(Command& k, const std::string& name, std::string_view about, ObjectId& parent) {
  auto& [s, c, time, layer, script] = k;
  const auto slash = name.rfind('/');
  if (slash == std::string::npos) return true;
  const std::string above = name.substr(0, slash);
  parent = s.names.find(above);
  return parent ? true
                : c.fail(ErrorCode::name, fmt::format("there is no '{}' for '{}' to belong to", above, name), about,
                         fmt::format("create {} first", above));
}

// The source of copies: the original with the settings for its copy, and everything below it.
struct Like {
  ObjectId original;
  Object object;
  std::vector<FunctionId> said;
  std::vector<ObjectId> parts;
  std::string kind;  // of the author's own, if the copies are its instances
};

// Adds one copy. References to the original, or to one of its parts, become references to the copy of that part.
void add_copy(Scene& s, const Like& like, const std::string& name, ObjectId parent) {
  Cancellation::check();
  const std::string& old = like.object.name;
  Following copies(old, name, &s);
  const auto first = static_cast<std::uint32_t>(s.objects.size());
  std::vector<Object> all{like.object};
  all[0].leads = !like.parts.empty() && s.objects[like.original.index].leads;
  copies.instead(like.original, {first});
  for (const ObjectId part : like.parts) {
    copies.instead(part, {first + static_cast<std::uint32_t>(all.size())});
    all.push_back(s.objects[part.index]);
  }
  for (std::uint32_t n = 0; n < all.size(); ++n) {
    all[n].name = name + all[n].name.substr(old.size());
    all[n].derived = all[n].hidden = false;
    s.names.put(all[n].name, {first + n});
  }
  for (Object& one : all) copies.apply(one);
  for (const FunctionId f : like.said) all[0].slot(f).set = like.object.find(f)->set;
  for (std::size_t n = 0; n < all.size(); ++n) add_child(s, std::move(all[n]), n == 0 ? parent : ObjectId{});
  if (!like.kind.empty()) add_instance(s, like.kind, {first}, like.said);
}

bool create_like(Command& k, const Like& like, const std::vector<std::string>& names,
                 const std::vector<ObjectId>& parents, std::string_view about) {
  auto& [s, c, time, layer, script] = k;
  for (const std::string& name : names)
    for (const ObjectId part : like.parts)
      if (!free_name(k, name + s.objects[part.index].name.substr(like.object.name.size()), about)) return false;
  if (!like.parts.empty()) script.touched = std::max<std::size_t>(script.touched, 1) + names.size() * like.parts.size();
  for (std::size_t i = 0; i < names.size(); ++i) add_copy(s, like, names[i], parents[i]);
  return true;
}

// Returns the object that a formula has made for one of its parts. A written script creates it again.
ObjectId made_with_formula(const Scene& s, const std::string& name) {
  const ObjectId id = s.names.find(name);
  return id && shown_part(s.objects[id.index]) ? id : ObjectId{};
}
bool same_part(const Object& made, const Object& there) {
  const std::string* const part = shown_part(made);
  return part && *part == *shown_part(there);
}

// Returns the word in braces that can only be a table, if there is no such table.
std::string_view missing_table(const Scene& s, std::string_view pattern) {
  for (std::size_t open = pattern.find('{'); open != pattern.npos; open = pattern.find('{', open + 1)) {
    const std::string_view word = pattern.substr(open + 1, pattern.find_first_of("{}", open + 1) - open - 1);
    if (const auto table = s.tables->find(word);
        is_name(word) && (table == s.tables->end() || table->second->keys.empty()))
      return word;
  }
  return {};
}

bool create(Command& k) {
  auto& [s, c, time, layer, script] = k;
  const std::string_view word = c.next_word();
  if (word.empty()) return c.fail_here(ErrorCode::syntax, "a name is missing here");
  const bool one = script.only && !std::exchange(script.only->met, true);
  auto names = one ? Result<std::vector<std::string>>(std::vector{script.only->name})
                   : expand_braces(with_keys(*s.tables, word));
  if (!names) return c.fail(names.error(), word);
  if (const std::string_view missing = missing_table(s, word); s.tables->contains(missing))
    return c.fail(ErrorCode::type, fmt::format("the table '{}' has no keys, so it makes no names", missing), missing,
                  fmt::format("name the column of the keys: data {} … key=COLUMN", missing));
  else if (!missing.empty())
    return c.fail(unknown_name("table", missing, "data " + std::string(missing) + " from \"FILE.csv\" reads one"),
                  missing);
  if (!script.only && names->size() > 1) script.touched = names->size();
  for (const auto& name : *names)
    if (Cancellation::check(); !made_with_formula(s, name) && !free_name(k, name, word)) return false;
  const std::string_view kind_word = c.next_word();
  if (kind_word == "scene") {
    std::vector<ObjectId> parents(names->size());
    for (std::size_t i = 0; i < names->size(); ++i)
      if (!parent_by_name(k, (*names)[i], word, parents[i])) return false;
    return create_scene(k, *names, parents, word);
  }
  if (!find_kind(kind_word) && !s.kinds->find(kind_word) && find_part(k, kind_word)) {
    std::vector<ObjectId> parents(names->size());
    for (std::size_t i = 0; i < names->size(); ++i)
      if (!parent_by_name(k, (*names)[i], word, parents[i])) return false;
    return create_parts(k, *names, parents, kind_word);
  }
  if (c.error) return false;
  Like like;
  auto& [original, object, said, parts, own_kind] = like;
  if (kind_word == "like") {
    if (!values(k).object(original)) return false;
    object = s.objects[original.index];
    parts = script.below(s, object.name, object.derived);
  } else if (const OwnKind* one = find_own_kind(k, kind_word)) {
    for (const auto& name : *names)
      if (!no_circle(k, *one, name, word)) return false;
    own_kind = one->name, original = one->model(), object = s.objects[original.index];
    parts.assign(one->parts.begin() + 1, one->parts.end());
  } else if (c.error) {
    return false;
  } else {
    const auto kind = find_kind(kind_word);
    if (kind == Kind::layer)
      return c.fail(ErrorCode::name, "create cannot make a layer", kind_word,
                    fmt::format("to make one: layer {} add", word.substr(0, 40)));
    if (kind == Kind::environment)
      return c.fail(ErrorCode::name, "create cannot make an environment", kind_word,
                    fmt::format("to make one: animate {} every 1t by rotate(6deg, z)", word.substr(0, 40)));
    if (!kind) {
      Hint hint{std::string(foreign_word_hint(kind_word))};
      std::vector<std::string_view> known(kind_names.begin(), kind_names.end());
      for (const OwnKind& one : s.kinds->all) known.push_back(one.name);
      const std::vector<std::string> of_plugins = plugin_kinds();
      known.insert(known.end(), of_plugins.begin(), of_plugins.end());
      for (const std::string_view name : part_names(s)) known.push_back(name);
      if (hint.empty()) hint = did_you_mean(kind_word, known);
      if (hint.empty()) hint = fmt::format("kinds are {}; and scene", fmt::join(known, " "));
      return c.fail(
          ErrorCode::name,
          kind_word.empty() ? "a kind is missing here" : fmt::format("there is no kind '{}'", kind_word.substr(0, 40)),
          kind_word.empty() ? std::string_view(c.at, 0) : kind_word, hint);
    }
    object.kind = *kind;
  }
  Furniture furniture;
  if (!parameters(k, object, &said, &furniture)) return false;
  if (object.kind == Kind::mesh && !object.find(fn::file))
    return c.fail(ErrorCode::syntax, "a mesh needs its file", kind_word, "as in file=\"cow.obj\"");
  if (object.kind == Kind::video && !complete_video(k, object, kind_word)) return false;
  if (furniture.say && !give_said_text(k, object, furniture, kind_word)) return false;
  if (object.kind == Kind::sound && !object.find(fn::sound_file))
    return c.fail(ErrorCode::syntax, "a sound needs its file", kind_word,
                  "as in file=\"music.mp3\", or say=\"Hello\" for a voice");
  std::vector<ObjectId> parents(names->size());
  std::vector<std::string> sorted = *names;
  std::sort(sorted.begin(), sorted.end());
  if (const auto twice = std::adjacent_find(sorted.begin(), sorted.end()); twice != sorted.end())
    return c.fail(ErrorCode::name, fmt::format("'{}' would be created twice", *twice), word);
  if (s.objects.size() + names->size() * (1 + parts.size()) > most_objects)
    return c.fail(ErrorCode::range, fmt::format("a film can have at most {} objects", most_objects), word);
  for (std::size_t i = 0; i < names->size(); ++i)
    if (!parent_by_name(k, (*names)[i], word, parents[i]) || !put_on_axes(k, object, parents[i], word)) return false;
  for (const std::string& name : *names)
    if (const ObjectId there = made_with_formula(s, name); there && !same_part(object, s.objects[there.index]))
      return free_name(k, name, word);
  if (original) return create_like(k, like, *names, parents, word);
  Rollback rollback(s);
  const Object plain = object;
  for (std::size_t i = 0; i < names->size(); ++i) {
    Cancellation::check();
    object = plain;
    object.name = (*names)[i];
    give_theme_color(k, object);
    if (const ObjectId there = made_with_formula(s, object.name)) {
      for (const FunctionId f : said) s.objects.edit(there.index).slot(f).set = object.find(f)->set;
      continue;
    }
    const ObjectId id = add_child(s, object, parents[i]);
    if (!furnish(k, id, furniture, kind_word)) return false;
    for (const FunctionId f : said)
      if (const auto& v = object.find(f)->set; v && !make_parts(k, id, f, *v, word)) return false;
  }
  return rollback.keep(), true;
}

// Adds everything below the objects that are about to be removed.
void take_along(Command& k, std::vector<ObjectId>& going, std::string_view about) {
  auto& [s, c, time, layer, script] = k;
  const std::size_t named = going.size();
  std::set<std::uint32_t> known;
  for (const ObjectId id : going) known.insert(id.index);
  std::string names;
  for (std::size_t i = 0; i < named; ++i)
    for (const ObjectId part : script.below(s, s.objects[going[i].index].name, false)) {
      if (!known.insert(part.index).second) continue;
      if (going.size() < named + 5) names += fmt::format("{}{}", names.empty() ? "" : ", ", s.objects[part.index].name);
      going.push_back(part);
    }
  const std::size_t along = going.size() - named;
  if (along == 0) return;
  script.touched = going.size();
  script.note(Severity::notice,
              fmt::format("this also removes {} below {}: {}{}", counted(along, "object"),
                          named == 1 ? fmt::format("'{}'", s.objects[going[0].index].name) : "them", names,
                          along > 5 ? ", …" : ""),
              about);
}

bool remove(Command& k) {
  auto& [s, c, time, layer, script] = k;
  std::string_view word;
  std::vector<ObjectId> found;
  if (!objects(k, word, found) || !finish(c)) return false;
  take_along(k, found, word);
  const std::vector<std::uint32_t> speaking = script.speakers(s, found);
  keep_centres(k, found, speaking, word);
  keep_ways(k, found, speaking, word);
  remove_objects(s, found, speaking);
  return true;
}

constexpr Verb objects_rows[] = {
    {"create",
     "create NAME KIND [key=value …], create NAME like OTHER or create NAME scene file=\"…\" [animation=…] "
     "[start=TIME]",
     "Makes an object of a kind, a copy of another with everything below it, or all objects of a scene file.",
     "create moon sphere radius=0.5 color=silver", Verb::makes_thing | Verb::quick, create,
     "NEW; KIND like scene; PARAMETER…"},
    {"remove", "remove OBJECTS", "Removes objects from the film, with everything below them.", "remove wheel*", 0,
     remove, "OBJECT…"},
};

}  // namespace

ObjectId add_child(Scene& s, Object object, ObjectId parent) {
  if (parent) {
    object.slot(fn::attachment).set = Attachment{AttachmentKind::couple, parent, false};
    if (!s.objects[parent.index].leads) s.objects.edit(parent.index).leads = true;
  }
  return add_object(s, std::move(object));
}

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
  if (name == "none") return c.fail(ErrorCode::name, "'none' cannot be a name: it means no object", about);
  if (const ObjectId id = s.names.find(name)) {
    const Kind kind = s.objects[id.index].kind;
    return placed(kind) ? c.fail(ErrorCode::name, fmt::format("'{}' already exists", name), about)
                        : c.fail(ErrorCode::name, fmt::format("{} '{}' already exists", a_kind(kind), name), about,
                                 "objects, environments and layers cannot share a name");
  }
  if (s.aliases->contains(name))
    return c.fail(ErrorCode::name, fmt::format("'{}' is already an alias", name), about,
                  "an alias hides an object with the same name");
  if (s.lists->empty() && s.later_lists->empty()) return true;
  if (!versions(s, name).empty())
    return c.fail(ErrorCode::name, fmt::format("a display list '{}' already exists", name), about);
  for (std::size_t slash = name.find('/'); slash != std::string::npos; slash = name.find('/', slash + 1))
    if (const std::string above = name.substr(0, slash); !versions(s, above).empty())
      return c.fail(ErrorCode::name,
                    fmt::format("names that begin with '{}/' are reserved for the objects of that display list", above),
                    about);
  return true;
}

// Fails if display lists draw the object, because only their rows can change it.
bool own(Command& k, ObjectId id, std::string_view about) {
  auto& [s, c, time, layer, script] = k;
  if (!s.objects[id.index].derived) return true;
  return c.fail(ErrorCode::type,
                fmt::format("'{}' belongs to a display list, so only its rows can change it", s.objects[id.index].name),
                about, fmt::format("edit {}, or a list that it calls", s.main));
}

bool one_parameter(Command& k, Object& object, std::vector<FunctionId>* said, Furniture* furnished,
                   std::string_view* styled) {
  auto& [s, c, time, layer, script] = k;
  const std::string_view key = c.word();
  if (key.empty()) return c.fail_here(ErrorCode::syntax, "expected key=value here");
  if (!c.accept('=')) {
    const auto colon = key.find(':');
    const bool decimals = std::isdigit(static_cast<unsigned char>(key[0])) && key.data()[-1] == ',';
    return c.fail(
        ErrorCode::syntax, fmt::format("'{}' needs a value", key.substr(0, std::min<std::size_t>(colon, 40))), key,
        decimals      ? "numbers have a point: 0.5"
        : key == "at" ? "write the place as position=(0 0 0)"
        : colon != std::string_view::npos
            ? fmt::format("write {}={}", key.substr(0, std::min<std::size_t>(colon, 40)), key.substr(colon + 1, 40))
            : fmt::format("as in {}=…", key.substr(0, 40)));
  }
  const auto dot = key.find('.');
  const std::string_view name = furnished ? meant_at_create(object.kind, key.substr(0, dot)) : key.substr(0, dot);
  const auto f = find_function(s, object.kind, name);
  if (!f) {
    if (furnished && furniture(k, object.kind, key, *furnished)) return true;
    if (c.error) return false;
    return c.fail(ErrorCode::name, fmt::format("{} has no '{}'", a_kind(object.kind), name.substr(0, 40)), name,
                  missing_parameter_hint(s, object.kind, name));
  }
  const FunctionSpec& spec = spec_of(s, *f);
  const int component = dot == std::string_view::npos ? -1 : find_component(spec.type, key.substr(dot + 1));
  if (dot != std::string_view::npos && component < 0)
    return c.fail(ErrorCode::name, fmt::format("{} has no component '{}'", spec.name, key.substr(dot + 1, 40)),
                  key.substr(dot + 1));
  c.space();
  if (c.peek() == '"' && spec.type != Type::text && c.end - c.at > 1) {
    // A quoted formula would be a procedure.
    return c.fail_here(ErrorCode::type, fmt::format("{} is {}, not a text", spec.name, to_string(spec.type)));
  }
  if (spec.type == Type::motion)
    return c.fail(ErrorCode::type, "a motion cannot be set: it needs a segment of time", key,
                  "as in at 1f..24f wheel.motion T(6 0)");
  if (spec.type == Type::attachment)
    return c.fail(ErrorCode::type, "an attachment cannot be set", key,
                  "write couple A to B, attach A to B or hang A on B");
  Value v;
  if (!values(k).value(spec, component, v, *f)) return false;
  Slot& slot = object.slot(*f);
  if (said) said->push_back(*f);
  if (component >= 0 && slot.set && std::holds_alternative<Quat>(*slot.set))
    return c.fail(ErrorCode::type, "an orientation has no separate angles", key);
  slot.set = component < 0 ? v : with_component(slot.set.value_or(spec.rest), component, std::get<double>(v));
  if (furnished && *f == fn::text) furnished->text_at = key;
  if (styled && (key == "weight" || key == "slant")) *styled = key;
  return true;
}

bool parameters(Command& k, Object& object, std::vector<FunctionId>* said, Furniture* furnished) {
  std::string_view styled;
  while (!k.cursor.at_line_end())
    if (!one_parameter(k, object, said, furnished, &styled)) return false;
  if (const auto f = styled.empty() ? std::nullopt : find_function(k.scene, object.kind, styled))
    say_missing_style(k, object, *f, *object.find(*f)->set, styled);
  if (furnished && !furnished->text_at.empty())
    say_missing_style(k, object, fn::text, *object.find(fn::text)->set, furnished->text_at);
  return true;
}

// Reads one or more objects: an existing name, an alias, or a pattern (which may match nothing).
bool objects(Command& k, std::string_view& word, std::vector<ObjectId>& out) {
  auto& [s, c, time, layer, script] = k;
  word = c.next_word();
  if (word.empty()) return c.fail_here(ErrorCode::syntax, "the name of an object is missing here");
  out = named(k, word);
  const bool any = !out.empty();
  if (!is_pattern(word) && out.size() == 1 && !own(k, out[0], word)) return false;
  std::erase_if(out, [&](ObjectId id) { return k.scene.objects[id.index].derived; });
  if (any) return true;
  if (is_pattern(word) || s.aliases->contains(std::string(word))) {
    if (const auto braces = expand_braces(word); !braces) return c.fail(braces.error(), word);
    script.names_nothing(word);
    return true;
  }
  c.at = word.data();
  ObjectId id;
  return values(k).object(id);  // reports the error
}

std::span<const Verb> objects_verbs() { return objects_rows; }

}  // namespace betwixt
