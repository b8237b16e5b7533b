// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/objects/object_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "betwixt/language.h"
#include "betwixt/math.h"
#include "betwixt/pick.h"
#include "commands/verbs.h"
#include "editor/made_by.h"
#include "language/values.h"
#include "scene/document.h"
#include "scene/functions.h"
#include "scene/own_kinds.h"
#include "studio/viewport/hand.h"
#include "syntax/tokens.h"

namespace betwixt::studio {
namespace {

std::vector<ObjectId> in_order(const std::set<std::uint32_t>& numbers) {
  std::vector<ObjectId> all;
  for (const std::uint32_t i : numbers) all.push_back({i});
  return all;
}

// Returns the objects and everything below them; `parent` returns the parent of an object.
template <class Parent>
std::set<std::uint32_t> closure(const Document& d, const std::vector<ObjectId>& objects, const Parent& parent) {
  std::set<std::uint32_t> all;
  for (const ObjectId id : objects) all.insert(id.index);
  for (bool more = true; more;) {
    more = false;
    for (std::uint32_t i = 0; i < d.scene().objects.size(); ++i) {
      const Object& o = d.scene().objects[i];
      if (o.removed || o.derived || all.contains(i)) continue;
      const ObjectId up = parent(ObjectId{i});
      if (up && all.contains(up.index)) more = all.insert(i).second;
    }
  }
  return all;
}

Attachment couple_to(ObjectId parent) { return {AttachmentKind::couple, parent, false}; }

}  // namespace

Vec3 place_of(const Program& program, ObjectId id, Time t) {
  const Value v = program.read(Target(id, Query::world), t);
  const auto* m = std::get_if<Matrix>(&v);
  return m ? translation_of(**m) : Vec3{};
}

std::optional<Attachment> fixed_attachment(const Document& d, ObjectId id) {
  const std::vector<AttachmentSpan> spans = attachments(d, id);
  if (spans.size() != 1 || spans[0].computed || spans[0].to.kind < AttachmentKind::hang || !spans[0].to.parent)
    return std::nullopt;
  return spans[0].to;
}

std::string hold_line(const Attachment& to, const std::string& child, const std::string& parent, bool keep_world) {
  const bool hangs = to.kind == AttachmentKind::hang;
  return fmt::format("{} {} {} {}{}",
                     hangs                               ? "hang"
                     : to.kind == AttachmentKind::attach ? "attach"
                                                         : "couple",
                     child, hangs ? "on" : "to", parent, keep_world ? " keep-world" : "");
}

namespace {

bool is_free(const Document& d, const std::string& name, const std::vector<std::string>& taken) {
  return !d.find(name) && !d.aliases().contains(name) && std::ranges::find(taken, name) == taken.end();
}

}  // namespace

std::string free_name(const Document& d, const std::string& wanted, const std::vector<std::string>& taken) {
  return is_free(d, wanted, taken) ? wanted : unused_name(d, wanted, taken);
}

std::string unused_name(const Document& d, std::string_view like, const std::vector<std::string>& taken) {
  const std::size_t last = like.find_last_not_of("0123456789");
  const std::string_view stem = last == like.npos ? like : like.substr(0, last + 1);
  for (int n = 2;; ++n) {
    std::string name = fmt::format("{}{}", stem, n);
    if (is_free(d, name, taken)) return name;
  }
}

std::vector<ObjectId> with_all_below(const Document& d, const std::vector<ObjectId>& objects) {
  return in_order(closure(d, objects, [&](ObjectId id) {
    const auto held = fixed_attachment(d, id);
    return held ? held->parent : ObjectId{};
  }));
}

ObjectId parent_at(const Document& d, ObjectId id, Time t) {
  for (const AttachmentSpan& span : attachments(d, id))
    if (span.from <= t && t < span.until && span.to.kind >= AttachmentKind::hang) return span.to.parent;
  return {};
}

std::vector<ObjectId> all_below_at(const Document& d, const std::vector<ObjectId>& objects, Time t) {
  return in_order(closure(d, objects, [&](ObjectId id) { return parent_at(d, id, t); }));
}

ObjectId whole_of(const Document& d, ObjectId id) {
  const std::string name = d.name(id);
  for (std::size_t at = name.find('/'); at != name.npos; at = name.find('/', at + 1)) {
    const ObjectId up = d.find(name.substr(0, at));
    if (!up || !find_built_in(kind(d, up), "bare")) continue;
    return kind(d, up) == Kind::diagram ? d.find(name.substr(0, name.find('/', at + 1))) : up;
  }
  return id;
}

std::vector<ObjectId> topmost(const Document& d, const std::vector<ObjectId>& objects) {
  std::vector<ObjectId> out;
  for (const ObjectId id : objects) {
    bool below = false;
    ObjectId up = id;
    for (int deep = 0; deep < 10'000 && !below; ++deep) {
      const auto held = fixed_attachment(d, up);
      if (!held) break;
      up = held->parent;
      below = std::ranges::find(objects, up) != objects.end();
    }
    if (!below) out.push_back(id);
  }
  return out;
}

ObjectEdit duplicate_lines(const Document& d, const std::vector<ObjectId>& objects) {
  ObjectEdit edit;
  const std::vector<ObjectId> all = with_all_below(d, objects);
  std::map<std::uint32_t, std::string> copies;
  std::vector<std::string> taken;
  for (const ObjectId id : all) {
    const std::string name = d.name(id);
    // `create NAME like` copies what is named below an object along with it.
    std::string copied_along;
    for (const auto& [above, copy] : copies)
      if (is_below(name, d.name(ObjectId{above}))) copied_along = copy + name.substr(d.name(ObjectId{above}).size());
    if (!copied_along.empty()) {
      copies[id.index] = copied_along;
      continue;
    }
    const std::string copy = unused_name(d, name, taken);
    copies[id.index] = copy, taken.push_back(copy);
    edit.lines.push_back(fmt::format("create {} like {}", copy, name));
  }
  for (const ObjectId id : all) {
    const auto held = fixed_attachment(d, id);
    if (!held || !copies.contains(held->parent.index)) continue;
    if (is_below(d.name(id), d.name(held->parent))) continue;  // copied with its parent
    edit.lines.push_back(hold_line(*held, copies[id.index], copies[held->parent.index], held->keep_world));
  }
  for (const ObjectId id : objects)
    if (copies.contains(id.index)) edit.names.push_back(copies[id.index]);
  return edit;
}

ObjectEdit instance_lines(const Document& d, const std::vector<ObjectId>& objects) {
  ObjectEdit edit;
  const OwnKinds& kinds = *d.scene().kinds;
  for (const ObjectId id : objects) {
    const std::string name = d.name(id);
    const OwnKind* kind = kinds.of(id);
    for (const OwnKind& k : kinds.all)
      if (k.model() == id) kind = &k;
    std::string called = kind ? kind->name : "";
    if (!kind) {
      std::string stem = name.substr(name.rfind('/') + 1);
      for (int n = 1; called.empty() || kinds.find(called); ++n)
        called = n == 1 ? stem + "-kind" : fmt::format("{}-kind{}", stem, n);
      edit.lines.push_back(fmt::format("define kind {} like {}", called, name));
    }
    edit.names.push_back(unused_name(d, name, edit.names));
    edit.lines.push_back(fmt::format("create {} {}", edit.names.back(), called));
  }
  return edit;
}

ObjectEdit mirror_lines(const Document& d, const std::vector<ObjectId>& objects, Axis axis) {
  const std::vector<ObjectId> tops = topmost(d, objects);
  ObjectEdit edit = duplicate_lines(d, tops);
  std::map<std::uint32_t, std::string> mirrors;  // by the parent of what they mirror
  std::vector<std::string> taken = edit.names;
  for (std::size_t i = 0; i < tops.size(); ++i) {
    const auto held = fixed_attachment(d, tops[i]);
    std::string& mirror = mirrors[held ? held->parent.index : ObjectId::nothing];
    if (mirror.empty()) {
      mirror = free_name(d, "mirror", taken);
      taken.push_back(mirror);
      edit.lines.push_back(fmt::format("create {} group scale=({} {} {})", mirror, axis == Axis::x ? -1 : 1,
                                       axis == Axis::y ? -1 : 1, axis == Axis::z ? -1 : 1));
      if (held) edit.lines.push_back(hold_line(*held, mirror, d.name(held->parent), false));
    }
    edit.lines.push_back(fmt::format("couple {} to {}", edit.names[i], mirror));
  }
  return edit;
}

ObjectEdit group_lines(const Program& program, const std::vector<ObjectId>& objects, Time t) {
  const Document& d = program.document();
  ObjectEdit edit;
  std::vector<ObjectId> tops = topmost(d, objects);
  std::erase_if(tops, [&](ObjectId id) { return !placed(kind(d, id)); });
  if (tops.empty()) return edit;
  Vec3 sum{};
  for (const ObjectId id : tops) sum = sum + place_of(program, id, t);
  Vec3 middle = (1.0 / static_cast<double>(tops.size())) * sum;
  // If all parts have one parent, the group comes between them.
  const auto first = fixed_attachment(d, tops[0]);
  const bool one = first && !first->keep_world && first->kind == AttachmentKind::couple &&
                   std::ranges::all_of(tops, [&](ObjectId id) { return fixed_attachment(d, id) == first; });
  if (one)
    if (const Value v = program.read(Target(first->parent, Query::world), t); const auto* m = std::get_if<Matrix>(&v))
      middle = transform_point(inverse(**m).value_or(Mat4{}), middle);
  const auto number = [](double v) { return write_number(rounded(v, millimetre) + 0); };
  edit.names = {free_name(d, "group1")};
  edit.lines.push_back(fmt::format("create {} group pivot=({} {} {})", edit.names[0], number(middle.x),
                                   number(middle.y), number(middle.z)));
  if (one) edit.lines.push_back(hold_line(*first, edit.names[0], d.name(first->parent), false));
  for (const ObjectId id : tops) {
    const auto held = fixed_attachment(d, id);
    edit.lines.push_back(hold_line(couple_to({}), d.name(id), edit.names[0], held && (held->keep_world || !one)));
  }
  return edit;
}

Lines display_lines(const Document& d, const std::vector<ObjectId>& objects, bool shown, Time t) {
  Lines lines;
  for (const ObjectId id : objects) {
    if (!placed(kind(d, id))) continue;
    const bool timed = made_by(d, Target(id, fn::display), t).events;
    lines.push_back((timed ? "at " + format_time(t, d) + " " : "") + (shown ? "show " : "hide ") + d.name(id));
  }
  return lines;
}

Lines remove_lines(const Document& d, const std::vector<ObjectId>& objects, bool all, Time t) {
  std::vector<ObjectId> leaving = objects;
  if (all) leaving = all_below_at(d, objects, t);
  Lines lines;
  for (const ObjectId id : leaving) {
    const std::string name = d.name(id);
    const bool along = std::ranges::any_of(leaving, [&](ObjectId other) { return is_below(name, d.name(other)); });
    if (!along) lines.push_back("remove " + name);
  }
  return lines;
}

Lines lines_to_leave(const Document& d, const std::vector<ObjectId>& objects) {
  std::set<std::string> kept;
  for (const ObjectId id : with_all_below(d, objects)) kept.insert(d.name(id));
  const auto stays = [&](const std::string& name) {
    return kept.contains(name) || std::ranges::any_of(kept, [&](const std::string& k) { return is_below(name, k); });
  };
  Lines lines;
  std::vector<std::string> leaving;
  for (const std::string& name : d.names()) {
    const Object* const o = find_object(d.scene(), d.find(name));
    const bool has_kept = std::ranges::any_of(kept, [&](const std::string& k) { return is_below(k, name); });
    const bool along = std::ranges::any_of(leaving, [&](const std::string& other) { return is_below(name, other); });
    if (!o || o->derived || stays(name) || has_kept || along) continue;
    leaving.push_back(name);
    lines.push_back("remove " + name);
  }
  return lines;
}

namespace {

// Returns the logical lines of a script, rows with the line above them, without settings of the film.
Lines without_settings(const std::string& script) {
  Lines all;
  bool skipped = false;
  for (std::string_view rest = script; !rest.empty();) {
    const LogicalLine one = logical_line(rest);
    const std::string_view line = between(rest.data(), one.end);
    rest = between(one.next(rest.data() + rest.size()), rest.data() + rest.size());
    if (first_word(line).empty()) continue;
    if (!indented(line)) {
      const Verb* const verb = find_verb(first_word(line));
      skipped = (verb && (verb->flags & Verb::once)) || first_word(line) == "alias";
    }
    if (!skipped) all.emplace_back(line);
  }
  return all;
}

}  // namespace

std::string text_of_objects(const Document& rest) {
  return fmt::format("{}\n", fmt::join(without_settings(write(rest)), "\n"));
}

Result<ObjectEdit> paste_lines(const Document& d, const std::string& film_text, const std::string& text) {
  Session other;
  other.begin(text, "");
  for (const Diagnostic& wrong : other.diagnostics())
    if (wrong.severity == Severity::error) return wrong.what;
  ObjectEdit edit;
  std::vector<std::string> taken = other.document().names();
  for (const std::string& name : other.document().names()) {
    if (!other.document().find(name)) continue;  // renamed with what it is below
    std::string now = name;
    if (d.find(name)) {
      now = unused_name(d, name, taken);
      taken.push_back(now);
      if (const Session::Answer a = other.enter("rename " + name + " " + now); !a.done)
        return a.why.empty() ? fail(ErrorCode::name, a.said) : a.why[0].what;
    }
    if (now.find('/') == now.npos) edit.names.push_back(now);
  }
  // What the film already says, such as `let` and `define`, is not said again.
  const Lines there = without_settings(film_text);
  for (std::string& line : without_settings(write(other.document()))) {
    const std::string_view word = first_word(line);
    const bool named = word == "let" || word == "define";
    constexpr std::string_view kind = "define kind ";
    if (line.starts_with(kind) && d.scene().kinds->find(first_word(std::string_view(line).substr(kind.size()))))
      continue;
    if (!(named && std::ranges::find(there, line) != there.end())) edit.lines.push_back(std::move(line));
  }
  return edit;
}

}  // namespace betwixt::studio
