// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Turns display lists into plain objects.
#include "scene/expansion.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>
#include <unordered_set>

#include "scene/mentions.h"

namespace betwixt {
namespace {

// Compares the slots of derived objects: one value each, and the events of those whose environments begin at a tick.
bool same_slots(const std::vector<Slot>& a, const std::vector<Slot>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Slot& x, const Slot& y) {
    return x.function == y.function && x.set == y.set && x.track->events == y.track->events;
  });
}

// The expansions of all versions together: a part that is equal before and after an edit is one part.
struct Versions {
  struct Shown {
    ExpandedPart part;
    std::vector<Time> turns;  // when it comes and goes, alternating
    std::size_t last = 0;     // the last version that has it, counted from 1
  };
  std::vector<Shown> all;
  std::map<std::tuple<std::int32_t, std::int32_t, std::string>, std::vector<std::int32_t>> alike;  // by parent and word
  std::vector<std::pair<Time, std::int32_t>> eyes;  // cameras by time; -1: none
  std::vector<std::int32_t> now;
  std::size_t version = 0;
  bool one = false;  // there is one version only: no part needs to be found again

  void add(Time from, std::vector<ExpandedPart> parts) {
    ++version;
    std::vector<std::int32_t> next;
    next.reserve(parts.size());
    for (ExpandedPart& part : parts) {
      const auto place = [&](std::int32_t i) { return i < 0 ? i : next[static_cast<std::size_t>(i)]; };
      part.parent = place(part.parent), part.within = place(part.within);
      next.push_back(found(from, std::move(part)));
      Shown& shown = all[static_cast<std::size_t>(next.back())];
      if (shown.turns.size() % 2 == 0) shown.turns.push_back(from);
      shown.last = version;
    }
    for (const std::int32_t i : now)
      if (Shown& before = all[static_cast<std::size_t>(i)]; before.last != version) before.turns.push_back(from);
    now = std::move(next);
    const bool sees = !now.empty() && all[static_cast<std::size_t>(now.back())].part.object.kind == Kind::camera;
    eyes.emplace_back(from, sees ? now.back() : -1);
  }

  // Returns the existing equal part, or adds a new one.
  std::int32_t found(Time from, ExpandedPart part) {
    const auto index = static_cast<std::int32_t>(all.size());
    if (!one) {
      auto& others = alike[{part.parent, part.within, part.word}];
      for (const std::int32_t i : others)
        if (const Object& o = all[static_cast<std::size_t>(i)].part.object;
            o.kind == part.object.kind && same_slots(o.slots, part.object.slots))
          return i;
      others.push_back(index);
    }
    part.object.name = name(from, part);
    all.push_back({std::move(part), {}, 0});
    return index;
  }

  // Appends the time if another part has the name at another time.
  std::string name(Time from, const ExpandedPart& part) {
    const std::string above = part.within < 0 ? "" : all[static_cast<std::size_t>(part.within)].part.object.name + "/";
    const std::string plain = above + part.word;
    if (one || names.insert(plain).second) return plain;
    const std::string timed = plain + "-at-" + std::to_string(std::llround(from.seconds() * 1000)) + "ms";
    std::string name = timed;
    for (int i = 2; !names.insert(name).second; ++i) name = timed + "-" + std::to_string(i);
    return name;
  }
  std::unordered_set<std::string> names;

  // Parts that draw are hidden while they do not exist; mere groups need not be.
  std::vector<ExpandedPart> parts() {
    std::vector<ExpandedPart> out;
    for (Shown& shown : all) {
      Object& o = shown.part.object;
      if (drawable(o.kind) && shown.turns != std::vector{earliest_time}) {
        Events& events = o.slot(fn::display).track.edit().events;
        const auto put = [&](Time t, bool on) {
          Event e;
          e.time = t, e.value = on;
          events.put(std::move(e));
        };
        put(-from_seconds(longest_seconds), shown.turns[0] == earliest_time);
        for (std::size_t i = 0; i < shown.turns.size(); ++i)
          if (shown.turns[i] != earliest_time) put(shown.turns[i], i % 2 == 0);
      }
      out.push_back(std::move(shown.part));
    }
    return out;
  }
};

// Removes objects so that nothing refers to them and their numbers can be reused.
void take_out(Scene& s, const std::vector<ObjectId>& gone) {
  remove_objects(s, gone, all_of(s.objects));
  const auto is_gone = [&](const Value& v) {
    const auto* id = std::get_if<ObjectId>(&v);
    return id && *id && s.objects[id->index].removed;
  };
  for (std::size_t i = 0; i < s.objects.size(); ++i)
    for (std::size_t k = 0; k < s.objects[i].slots.size(); ++k) {
      const Slot& slot = s.objects[i].slots[k];
      bool any = slot.set && is_gone(*slot.set);
      slot.track->events.each([&](const Event& e) { any = any || is_gone(e.value); });
      if (!any) continue;
      Slot& mine = s.objects.edit(i).slots[k];
      if (mine.set && is_gone(*mine.set)) mine.set = ObjectId{};
      mine.track.edit().events.edit_between({INT64_MIN}, {INT64_MAX}, [&](Event& e) {
        if (is_gone(e.value)) e.value = ObjectId{};
      });
    }
  auto& spare = s.spare.edit();
  for (const ObjectId id : gone) spare.push_back(id.index);
}

void put(Scene& s, std::vector<ExpandedPart> parts) {
  std::vector<ObjectId> now(parts.size()), gone;
  std::vector<bool> stays(s.objects.size());
  for (std::size_t i = 0; i < parts.size(); ++i)
    if ((now[i] = s.names.find(parts[i].object.name))) stays[now[i].index] = true;
  for (const ObjectId id : *s.expansion)
    if (!stays[id.index]) gone.push_back(id);
  if (!gone.empty()) take_out(s, gone);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    Object& made = parts[i].object;
    if (parts[i].parent >= 0)
      made.slot(fn::attachment).set =
          Attachment{AttachmentKind::couple, now[static_cast<std::size_t>(parts[i].parent)], false};
    if (now[i]) {
      const Object& there = s.objects[now[i].index];
      if (there.kind == made.kind && same_slots(there.slots, made.slots)) continue;
      made.leads = made.leads || there.leads;
      s.objects.edit(now[i].index) = std::move(made);
    } else if (!s.spare->empty()) {
      now[i] = {s.spare->back()};
      s.spare.edit().pop_back();
      s.names.put(made.name, now[i]);
      s.objects.edit(now[i].index) = std::move(made);
    } else {
      now[i] = add_object(s, std::move(made));
    }
  }
  if (*s.expansion != now) s.expansion = Cow<std::vector<ObjectId>>(std::move(now));
}

Error too_many(const Scene& s) {
  return fail(ErrorCode::range, "'" + s.main + "' would make more than " + std::to_string(most_derived) + " objects",
              "each thing that the main list draws becomes an object of the film");
}

Result<Versions> versions_of_main(const Scene& s) {
  Versions versions;
  versions.one = s.later_lists->empty();
  std::set<std::string, std::less<>> called;
  std::size_t scanned = 0;
  const auto add = [&](Time from, const DisplayLists& lists) -> Status {
    const ExpansionSize size = expansion_size(lists, s.main);
    scanned += size.objects;
    if (size.depth > deepest_derived)
      return fail(ErrorCode::range, "'" + s.main + "' would have instances and environments nested more than " +
                                        std::to_string(deepest_derived) + " levels deep");
    if (size.objects > most_derived) return too_many(s);
    if (scanned > most_scanned)
      return fail(ErrorCode::range, "'" + s.main + "' changes too often for its size: all its versions together " +
                                        "would make more than " + std::to_string(most_scanned) + " objects");
    Expanded made = expanded(s, lists, s.main);
    called = std::move(made.called);
    versions.add(from, std::move(made.parts));
    return Nothing{};
  };
  if (Status first = add(earliest_time, *s.lists); !first) return first.error();
  if (versions.one) return versions;
  DisplayLists lists = *s.lists;
  for (const auto& [from, changed] : *s.later_lists) {
    change(lists, changed);
    if (std::none_of(changed.begin(), changed.end(), [&](const auto& list) { return called.contains(list.first); }))
      continue;
    if (Status next = add(from, lists); !next) return next.error();
  }
  return versions;
}

Status expand(Scene& s, bool renamed) {
  if (s.main.empty() && s.expansion->empty()) return Nothing{};
  Versions versions;
  if (!s.main.empty()) {
    auto made = versions_of_main(s);
    if (!made) return made.error();
    versions = *std::move(made);
  }
  std::vector<ExpandedPart> parts = versions.parts();
  if (parts.size() > most_derived) return too_many(s);
  if (renamed && parts.size() == s.expansion->size()) {
    for (const ObjectId id : *s.expansion) s.names.erase(s.objects[id.index].name);
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const ObjectId id = (*s.expansion)[i];
      s.names.put(parts[i].object.name, id);
      s.objects.edit(id.index).name = parts[i].object.name;
    }
  }
  put(s, std::move(parts));
  std::map<Time, ObjectId> views;
  for (const auto& [from, eye] : versions.eyes)
    if (eye >= 0 || !views.empty())
      views.insert_or_assign(views.end(), from, eye < 0 ? ObjectId{} : (*s.expansion)[static_cast<std::size_t>(eye)]);
  if (*s.views != views) s.views = Cow<std::map<Time, ObjectId>>(std::move(views));
  return Nothing{};
}

}  // namespace

Status expand(Scene& s) { return expand(s, false); }
void expand_renamed(Scene& s) { (void)expand(s, true); }  // as many as before

}  // namespace betwixt
