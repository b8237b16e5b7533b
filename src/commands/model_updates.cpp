// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// An update merges three: the model as it was and as it is, both put in the place of the instance, and the instance.
// What the instance has in common with the old model becomes that of the new one. Everything else is the instance's
// own, and stays so.
#include <fmt/format.h>

#include <algorithm>
#include <unordered_map>

#include "base/cancellation.h"
#include "betwixt/kind.h"
#include "commands/following.h"
#include "commands/own_kinds.h"

namespace betwixt {
namespace {

// Copies aspects from one slot to another. A null pointer is an empty slot.
void take(Slot& to, const Slot* from, unsigned aspects) {
  static const Slot nothing;
  const Slot& f = from ? *from : nothing;
  if (aspects & aspect::set) to.set = f.set;
  if (aspects & aspect::track) static_cast<Strand&>(to) = f;
  if (aspects & aspect::velocity) to.velocity = f.velocity;
  if (aspects & aspect::filters) to.filters = f.filters;
}

// Returns the slots of a part of an instance after an update, and adds to `own` what differs from `before`.
std::vector<Slot> merged(const Object& before, const Object& after, const Object& now, std::uint32_t part,
                         std::map<OwnSlot, std::uint8_t>& own) {
  std::vector<std::tuple<FunctionId, std::uint32_t, ObjectId>> keys;
  for (const Object* o : {&before, &after, &now})
    for (const Slot& slot : o->slots) keys.emplace_back(slot.function, slot.layer.index + 1, slot.layer);
  const auto key = [](const auto& k) { return std::pair(std::get<0>(k), std::get<1>(k)); };
  std::sort(keys.begin(), keys.end(), [&](const auto& a, const auto& b) { return key(a) < key(b); });
  keys.erase(std::unique(keys.begin(), keys.end(), [&](const auto& a, const auto& b) { return key(a) == key(b); }),
             keys.end());
  std::vector<Slot> out;
  for (const auto& [function, number, layer] : keys) {
    const Slot* is = now.find(function, layer);
    unsigned mine = differing(before.find(function, layer), is);
    const OwnSlot slot_of{part, function, layer.index};
    if (const auto at = own.find(slot_of); at != own.end()) mine |= at->second;
    if (mine) own[slot_of] = static_cast<std::uint8_t>(mine);
    Slot slot;
    slot.function = function, slot.layer = layer;
    take(slot, is, mine), take(slot, after.find(function, layer), aspect::all & ~mine);
    if (differing(&slot, nullptr)) out.push_back(std::move(slot));
  }
  return out;
}

bool same_slots(const std::vector<Slot>& a, const std::vector<Slot>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Slot& x, const Slot& y) {
    return x.function == y.function && x.layer == y.layer && differing(&x, &y) == 0;
  });
}

Object in_place(const Object& part, const Following& following) {
  Object o = part;
  o.hidden = o.derived = false;
  if (following.concerns(o)) following.apply(o);
  return o;
}

// The update of one kind's instances. `before` and `after` are all objects at the last update and at this one.
struct Update {
  Scene& s;
  Script& script;
  OwnKind& kind;
  const Objects &before, &after;
  std::string_view about;  // the place for what it reports
  std::string was = before[kind.model().index].name, is = after[kind.model().index].name;  // the model's name
  std::vector<ObjectId> old = kind.parts;
  std::size_t kept = 0;  // the number of parts that the model had before

  bool belongs(ObjectId id) const {
    const Object& o = after[id.index];
    return !o.removed && !o.derived && (id == kind.model() || is_below(o.name, is));
  }

  void run(const std::vector<std::uint32_t>& changed) {
    std::erase_if(kind.parts, [&](ObjectId id) { return !belongs(id); });
    kept = kind.parts.size();
    std::vector<ObjectId> sorted = kind.parts;
    const auto order = [](ObjectId a, ObjectId b) { return a.index < b.index; };
    std::sort(sorted.begin(), sorted.end(), order);
    for (const std::uint32_t i : changed)
      if (belongs({i}) && !std::binary_search(sorted.begin(), sorted.end(), ObjectId{i}, order))
        kind.parts.push_back({i});
    for (const ObjectId id : kind.parts)
      if (kind.hidden && !s.objects[id.index].hidden) s.objects.edit(id.index).hidden = true;
    std::erase_if(kind.instances, [&](const auto& one) { return s.objects[one->parts.front().index].removed; });
    for (Cow<KindInstance>& one : kind.instances) {
      Cancellation::check();
      KindInstance now = *one;
      update(now);
      if (!(now == *one)) one = Cow<KindInstance>(std::move(now));  // the others stay shared with earlier documents
    }
  }

  void update(KindInstance& one) {
    leave(one);
    const std::string root = s.objects[one.parts.front().index].name;
    Following then(was, root, &s), now(is, root, &s);
    for (std::size_t k = 0; k < kept; ++k) then.instead(kind.parts[k], one.parts[k]);
    std::vector<Object> bases(kept);
    for (std::size_t k = 0; k < kept; ++k)
      if (merges(one, k)) bases[k] = in_place(before[kind.parts[k].index], then);
    for (std::size_t k = 0; k < kept; ++k)
      if (merges(one, k)) rename(one.parts[k], root, bases[k].name, after[kind.parts[k].index].name);
    make_room(one, root);
    for (std::size_t k = 0; k < kind.parts.size(); ++k) now.instead(kind.parts[k], one.parts[k]);
    for (std::size_t k = 0; k < kind.parts.size(); ++k) {
      if (k < kept ? !merges(one, k) : !one.parts[k]) continue;
      const Object& model = after[kind.parts[k].index];
      Object next = in_place(model, now);
      if (k < kept) {
        merge(one.parts[k], bases[k], next, kind.parts[k].index, one.own);
      } else {
        next.name = root + model.name.substr(is.size());
        s.objects.add(std::move(next));
      }
    }
  }

  bool merges(const KindInstance& one, std::size_t k) const {
    return find_object(s, one.parts[k]) && !after.same(kind.parts[k].index, before);
  }

  // Removes the parts that the model no longer has.
  void leave(KindInstance& one) {
    std::vector<ObjectId> stay, go;
    for (std::size_t k = 0; k < old.size(); ++k) {
      const bool stays = belongs(old[k]);
      (stays ? stay : go).push_back(one.parts[k]);
      if (!stays) std::erase_if(one.own, [&](const auto& own) { return own.first.part == old[k].index; });
    }
    one.parts = std::move(stay);
    std::erase_if(go, [&](ObjectId id) { return !find_object(s, id); });
    take_along(go);
    if (!go.empty()) remove_objects(s, go, script.speakers(s, go));
  }

  // Adds the instance's own objects below the parts that go, as `remove` does.
  void take_along(std::vector<ObjectId>& go) {
    std::string names;
    const std::size_t count = go.size();
    for (std::size_t i = 0; i < count; ++i)
      for (const ObjectId id : script.below(s, s.objects[go[i].index].name, false))
        if (std::find(go.begin(), go.end(), id) == go.end()) {
          names += (names.empty() ? "'" : ", '") + s.objects[id.index].name + "'";
          go.push_back(id);
        }
    if (!names.empty())
      script.note(Severity::warning, fmt::format("the model's part is removed, and with it {}", names), about);
  }

  // Renames a part of an instance whose model was renamed, if it still has the model's old name.
  void rename(ObjectId id, const std::string& root, const std::string& old_name, const std::string& new_name) {
    const std::string wanted = root + new_name.substr(is.size());
    const std::string& name = s.objects[id.index].name;
    if (name == wanted || name != root + old_name.substr(was.size()) || !room_for(wanted, "keeps its name")) return;
    s.names.erase(name);
    s.objects.edit(id.index).name = wanted;
    s.names.put(wanted, id);
  }

  bool room_for(const std::string& name, const char* otherwise) {
    if (!s.names.find(name) && !s.aliases->contains(name) && versions(s, name).empty()) return true;
    script.note(Severity::warning,
                fmt::format("'{}' already exists, so the part of '{}' {} here", name, kind.name, otherwise), about);
    return false;
  }

  // Gives names and numbers to the parts that are new.
  void make_room(KindInstance& one, const std::string& root) {
    auto next = static_cast<std::uint32_t>(s.objects.size());
    for (std::size_t k = kept; k < kind.parts.size(); ++k) {
      const std::string name = root + after[kind.parts[k].index].name.substr(is.size());
      const bool room = next < most_objects && room_for(name, "is left out");
      one.parts.push_back(room ? ObjectId{next++} : ObjectId{});
      if (room) s.names.put(name, one.parts.back());
    }
  }

  void merge(ObjectId id, const Object& base, const Object& next, std::uint32_t part,
             std::map<OwnSlot, std::uint8_t>& own) {
    const Object& now = s.objects[id.index];
    std::vector<Slot> slots = merged(base, next, now, part, own);
    auto environment = now.environment == base.environment ? next.environment : now.environment;
    if (same_slots(slots, now.slots) && environment == now.environment) return;
    Object& mine = s.objects.edit(id.index);
    mine.slots = std::move(slots), mine.environment = std::move(environment), mine.leads |= next.leads;
  }
};

bool concerns(const OwnKind& kind, const Objects& after, const std::vector<std::uint32_t>& changed) {
  std::vector<std::uint32_t> parts;
  for (const ObjectId id : kind.parts) parts.push_back(id.index);
  std::sort(parts.begin(), parts.end());
  const std::string& model = after[kind.model().index].name;
  return std::any_of(changed.begin(), changed.end(), [&](std::uint32_t i) {
    return std::binary_search(parts.begin(), parts.end(), i) || is_below(after[i].name, model);
  });
}

// Ends the kinds whose models have been removed. Their instances become ordinary objects.
void end_kinds_without_model(Scene& s, Script& script, std::string_view about) {
  const auto ended = [&](const OwnKind& kind) { return s.objects[kind.model().index].removed; };
  if (std::none_of(s.kinds->all.begin(), s.kinds->all.end(), ended)) return;
  for (const OwnKind& kind : s.kinds->all)
    if (ended(kind))
      script.note(Severity::notice,
                  fmt::format("this removes the model of the kind '{}', and so ends the kind; its {} now", kind.name,
                              kind.instances.size() == 1
                                  ? "instance is an ordinary object"
                                  : fmt::format("{} instances are ordinary objects", kind.instances.size())),
                  about);
  std::erase_if(s.kinds.edit().all, ended);
}

// Returns what makes the model's parts those of the instance.
Following following_of(const Scene& s, const OwnKind& kind, const KindInstance& one) {
  Following out(s.objects[kind.model().index].name, s.objects[one.parts.front().index].name, &s);
  for (std::size_t k = 0; k < one.parts.size(); ++k) out.instead(kind.parts[k], one.parts[k]);
  return out;
}

// Returns the functions of an instance that differ from the model, or have differed when the model changed.
std::vector<Target> own_values(const Scene& s, const OwnKind& kind, const KindInstance& one) {
  const Following following = following_of(s, kind, one);
  std::vector<Target> out;
  for (std::size_t k = 0; k < kind.parts.size(); ++k) {
    const Object* now = find_object(s, one.parts[k]);
    if (!now) continue;
    std::map<OwnSlot, std::uint8_t> own = one.own;
    const Object base = in_place(s.objects[kind.parts[k].index], following);
    merged(base, base, *now, kind.parts[k].index, own);
    for (const auto& [slot, aspects] : own)
      if (const Target t(one.parts[k], slot.function);
          slot.part == kind.parts[k].index && (out.empty() || !(out.back() == t)))
        out.push_back(t);
  }
  return out;
}

std::vector<std::string> missing_parts(const Scene& s, const OwnKind& kind, const KindInstance& one) {
  std::vector<std::string> out;
  const std::string& model = s.objects[kind.model().index].name;
  for (std::size_t k = 0; k < kind.parts.size(); ++k)
    if (const Object& part = s.objects[kind.parts[k].index]; !part.removed && !find_object(s, one.parts[k]))
      out.push_back(part.name.substr(model.size()));
  return out;
}

}  // namespace

void follow_models(Scene& s, Script& script, std::string_view about) {
  if (s.kinds->all.empty()) return;
  // An update may change the model of another kind. Kinds never contain themselves, so each round ends one at least.
  for (std::size_t round = 0; round <= s.kinds->all.size(); ++round) {
    std::vector<std::uint32_t> changed;
    s.objects.each_changed(s.kinds_saw, [&](std::size_t i) { changed.push_back(static_cast<std::uint32_t>(i)); });
    if (changed.empty()) return;
    end_kinds_without_model(s, script, about);
    const Objects before = std::exchange(s.kinds_saw, s.objects), after = s.objects;
    for (std::size_t i = 0; i < s.kinds->all.size(); ++i)
      if (concerns(s.kinds->all[i], after, changed))
        Update{s, script, s.kinds.edit().all[i], before, after, about}.run(changed);
  }
}

std::size_t revert(Scene& s, const std::vector<std::pair<ObjectId, std::optional<FunctionId>>>& what) {
  struct Part {
    std::size_t kind, instance, number;
  };
  std::unordered_map<std::uint32_t, Part> parts;
  for (std::size_t k = 0; k < s.kinds->all.size(); ++k)
    for (std::size_t i = 0; i < s.kinds->all[k].instances.size(); ++i)
      for (std::size_t n = 0; n < s.kinds->all[k].instances[i]->parts.size(); ++n)
        parts[s.kinds->all[k].instances[i]->parts[n].index] = {k, i, n};
  std::size_t count = 0;
  for (const auto& [id, function] : what) {
    const auto found = parts.find(id.index);
    if (found == parts.end()) continue;
    ++count;
    const auto [k, i, n] = found->second;
    OwnKind& kind = s.kinds.edit().all[k];
    KindInstance& one = kind.instances[i].edit();
    const Object model = in_place(s.objects[kind.parts[n].index], following_of(s, kind, one));
    const auto reverts = [&, f = function, whole = n == 0](FunctionId slot) {
      return f ? *f == slot : !whole || !spec_of(s, slot).place;
    };
    Object& mine = s.objects.edit(id.index);
    std::erase_if(mine.slots, [&](const Slot& slot) { return reverts(slot.function); });
    for (const Slot& slot : model.slots)
      if (reverts(slot.function)) take(mine.slot(slot.function, slot.layer), &slot, aspect::all);
    std::erase_if(one.own, [&, part = kind.parts[n].index](const auto& own) {
      return own.first.part == part && reverts(own.first.function);
    });
    if (!function) mine.environment = model.environment;
    mine.leads |= model.leads;
  }
  return count;
}

std::vector<KindView> own_kinds(const Document& d) {
  const Scene& s = d.scene();
  std::vector<KindView> out;
  for (const OwnKind& kind : s.kinds->all) {
    out.push_back({kind.name, kind.model(), kind.hidden, {}});
    for (const Cow<KindInstance>& one : kind.instances)
      if (find_object(s, one->parts.front()))
        out.back().instances.push_back({one->parts.front(), own_values(s, kind, *one), missing_parts(s, kind, *one)});
  }
  return out;
}

}  // namespace betwixt
