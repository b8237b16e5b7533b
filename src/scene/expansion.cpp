// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Display lists become plain objects.
#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>
#include <unordered_set>

#include "scene/display_list.h"
#include "scene/document.h"

namespace betwixt {
namespace {

const std::string& name_of_call(const DisplayCommand& c) { return *std::get<Text>(c.value); }

bool draws(Drawing d) { return d <= Drawing::text; }

// How many objects a list becomes, and how deep they stand in one another.
struct Size {
  std::size_t objects = 0;
  int depth = 0;
};
struct Measure {
  const DisplayLists& lists;
  std::map<std::string_view, Size> known;

  Size operator()(const std::string& name, int depth) {
    constexpr std::size_t enough = most_derived + 1;
    const auto at = lists.find(name);
    if (at == lists.end()) return {};
    if (depth > deepest_derived) return {0, depth};
    if (const auto k = known.find(at->first); k != known.end()) return k->second;
    Size size{1, 1};
    int open = 0;
    const DisplayCommands& commands = at->second->commands;
    for (std::size_t i = 0; i < commands.size() && size.objects < enough; ++i) {
      const DisplayCommand& c = commands[i];
      if (draws(c.what)) ++size.objects;
      if (c.what == Drawing::begin) ++size.objects, size.depth = std::max(size.depth, 1 + ++open);
      if (c.what == Drawing::end) open = std::max(0, open - 1);
      if (c.what != Drawing::call) continue;
      const Size inside = (*this)(name_of_call(c), depth + 1);
      size.objects = std::min(enough, size.objects + inside.objects);
      size.depth = std::max(size.depth, 1 + open + inside.depth);
    }
    return known[at->first] = size;
  }
};

struct Part {
  Object object;  // without a name
  std::int32_t parent = -1;
  std::int32_t within = -1;  // whose name stands before its own: the parent's, or that of what holds the parent
  std::string word;          // star-2
};

// Scans lists as the interpreter of the source does; where that would draw, it writes down an object.
struct Expansion {
  const Scene& s;
  const DisplayLists& lists;
  std::vector<Part> parts;
  std::map<std::pair<std::int32_t, std::string>, int> counted;
  std::set<std::string, std::less<>> called;  // whether they are there or not

  // What holds the things that are drawn now: a group, and the matrix since.
  struct Level {
    Mat4 m;
    std::int32_t group = -1;
  };
  struct Look {
    std::optional<Value> color, texture, font;
  };

  // A word that the group does not have yet.
  std::string numbered(std::int32_t group, std::string_view word) {
    std::string plain(word);
    std::replace(plain.begin(), plain.end(), '/', '-');
    const int number = ++counted[{group, plain}];
    return plain + "-" + std::to_string(number);
  }

  Object& add(std::string word, Kind kind, const Level& at, std::int32_t within) {
    Part part;
    part.word = std::move(word);
    part.within = within;
    part.object.kind = kind;
    part.object.derived = true;
    part.object.leads = kind == Kind::group;
    part.parent = at.group;
    if (!(at.m == Mat4{})) part.object.slot(fn::transform).set = Matrix(at.m);
    parts.push_back(std::move(part));
    return parts.back().object;
  }

  Level group(std::string word, const Level& at, std::int32_t within) {
    add(std::move(word), Kind::group, at, within);
    return {{}, static_cast<std::int32_t>(parts.size()) - 1};
  }

  // An environment moves what is in it behind the matrix so far: a group of its own carries that one.
  Level environment(const DisplayCommand& c, Level at) {
    const std::string word = numbered(at.group, name_of_call(c));
    const std::int32_t above = at.group;
    if (!(at.m == Mat4{})) at = group(word + "-base", at, above);
    at = group(word, at, above);
    Slot& drive = parts.back().object.slot(fn::drive);
    const Value names = Names({name_of_call(c)});
    if (!c.since) {
      drive.set = names;
      return at;
    }
    Event e;
    e.time = s.ticks.span(static_cast<double>(*c.since));
    e.value = names;
    drive.track.edit().events.put(std::move(e));
    return at;
  }

  void primitive(const DisplayCommand& c, const Level& at, const Look& look) {
    static constexpr Kind kinds[] = {Kind::points, Kind::polyline, Kind::polygon, Kind::text};
    const Kind kind = kinds[static_cast<std::size_t>(c.what)];
    Object& o = add(numbered(at.group, drawing_names[static_cast<std::size_t>(c.what)]), kind, at, at.group);
    o.slot(kind == Kind::text ? fn::text : fn::points).set = c.value;
    if (look.color) o.slot(fn::color).set = look.color;
    if (look.texture) o.slot(fn::texture).set = look.texture;
    if (look.font && kind == Kind::text) o.slot(fn::font).set = look.font;
  }

  // The document's camera, which only the main list makes.
  struct Eye {
    bool any = false;
    Level at;
    std::optional<std::pair<FunctionId, Value>> lens;
  };

  void list(const DisplayList& of, Level at, Look look, Eye* eye) {
    struct Saved {
      Drawing by;
      Level level;
    };
    std::vector<Saved> stack;
    const auto restore = [&](Drawing by) {
      if (stack.empty() || stack.back().by != by) return;  // said to be wrong where the list is closed
      at = stack.back().level;
      stack.pop_back();
    };
    for (std::size_t i = 0; i < of.commands.size(); ++i) {
      const DisplayCommand& c = of.commands[i];
      switch (c.what) {
        case Drawing::point:
        case Drawing::vector:
        case Drawing::polygon:
        case Drawing::text:
          primitive(c, at, look);
          break;
        case Drawing::color:
          look.color = c.value;
          break;
        case Drawing::texture:
          look.texture = c.value;
          break;
        case Drawing::font:
          look.font = c.value;
          break;
        case Drawing::push:
          stack.push_back({c.what, at});
          break;
        case Drawing::pop:
          restore(Drawing::push);
          break;
        case Drawing::multiply:
          at.m = at.m * *std::get<Matrix>(c.value);
          break;
        case Drawing::begin:
          stack.push_back({c.what, at});
          at = environment(c, at);
          break;
        case Drawing::end:
          restore(Drawing::begin);
          break;
        case Drawing::call:
          called.insert(name_of_call(c));
          if (const auto other = lists.find(name_of_call(c)); other != lists.end())
            list(*other->second, group(numbered(at.group, other->first), at, at.group), look, nullptr);
          break;
        case Drawing::view:
        case Drawing::perspective:
        case Drawing::orthographic:
          if (eye) see(c, at, *eye);
          break;
      }
    }
  }

  static void see(const DisplayCommand& c, const Level& at, Eye& eye) {
    eye.any = true;
    if (c.what == Drawing::view) {
      const std::vector<Vec3>& p = *std::get<Points>(c.value);
      eye.at = {at.m * look_at(p[0], p[1]), at.group};
    } else {
      eye.lens = {c.what == Drawing::perspective ? fn::fov : fn::camera_height, c.value};
    }
  }

  void main(const std::string& name) {
    called.insert(name);
    const auto of = lists.find(name);
    if (of == lists.end()) return;
    const Level root = group(name, {}, -1);
    Eye eye{false, root, {}};
    list(*of->second, root, {}, &eye);
    if (!eye.any) return;
    Object& camera = add("camera", Kind::camera, eye.at, root.group);
    if (eye.lens) camera.slot(eye.lens->first).set = eye.lens->second;
  }
};

// Of derived objects: a value each, but for environments that have begun at a tick.
bool same_slots(const std::vector<Slot>& a, const std::vector<Slot>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Slot& x, const Slot& y) {
    return x.function == y.function && x.set == y.set && x.track->events == y.track->events;
  });
}

// The expansions of all versions in one: what is the same before and after an edit is one part.
struct Versions {
  struct Shown {
    Part part;
    std::vector<Time> turns;  // when it comes, when it goes, in turn
    std::size_t last = 0;     // the version that had it last, counted from 1
  };
  std::vector<Shown> all;
  std::map<std::tuple<std::int32_t, std::int32_t, std::string>, std::vector<std::int32_t>> alike;  // by place and word
  std::vector<std::pair<Time, std::int32_t>> eyes;  // cameras by time; -1: none
  std::vector<std::int32_t> now;
  std::size_t version = 0;
  bool one = false;  // there will be no other: nothing needs to be found again

  void add(Time from, std::vector<Part> parts) {
    ++version;
    std::vector<std::int32_t> next;
    next.reserve(parts.size());
    for (Part& part : parts) {
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

  // The part that is the same, or a new one.
  std::int32_t found(Time from, Part part) {
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

  // Where another part has the name at another time, the time is said behind it.
  std::string name(Time from, const Part& part) {
    const std::string above = part.within < 0 ? "" : all[static_cast<std::size_t>(part.within)].part.object.name + "/";
    const std::string plain = above + part.word;
    if (one || names.insert(plain).second) return plain;
    const std::string timed = plain + "-at-" + std::to_string(std::llround(from.seconds() * 1000)) + "ms";
    std::string name = timed;
    for (int i = 2; !names.insert(name).second; ++i) name = timed + "-" + std::to_string(i);
    return name;
  }
  std::unordered_set<std::string> names;

  // Those that draw are hidden while they are not there; what only holds others need not be.
  std::vector<Part> parts() {
    std::vector<Part> out;
    for (Shown& shown : all) {
      Object& o = shown.part.object;
      if (drawn(o.kind) && shown.turns != std::vector{from_the_beginning}) {
        Events& events = o.slot(fn::display).track.edit().events;
        const auto put = [&](Time t, bool on) {
          Event e;
          e.time = t, e.value = on;
          events.put(std::move(e));
        };
        put(-from_seconds(longest_seconds), shown.turns[0] == from_the_beginning);
        for (std::size_t i = 0; i < shown.turns.size(); ++i)
          if (shown.turns[i] != from_the_beginning) put(shown.turns[i], i % 2 == 0);
      }
      out.push_back(std::move(shown.part));
    }
    return out;
  }
};

// Objects that are no more: nothing speaks of them, so that their numbers can be given out again.
void take_out(Scene& s, const std::vector<ObjectId>& gone) {
  remove_objects(s, gone);
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

void put(Scene& s, std::vector<Part> parts) {
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
      made.slot(fn::attachment).set = Attachment{Hold::couple, now[static_cast<std::size_t>(parts[i].parent)], false};
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
  return fail(Code::range, "'" + s.main + "' would become more than " + std::to_string(most_derived) + " objects",
              "a film has objects for all that its main list draws");
}

Result<Versions> versions_of_main(const Scene& s) {
  Versions versions;
  versions.one = s.later_lists->empty();
  std::set<std::string, std::less<>> called;
  std::size_t scanned = 0;
  const auto add = [&](Time from, const DisplayLists& lists) -> Status {
    const Size size = Measure{lists, {}}(s.main, 1);
    scanned += size.objects;
    if (size.depth > deepest_derived)
      return fail(Code::range, "'" + s.main + "' would hold instances and environments more than " +
                                   std::to_string(deepest_derived) + " deep in one another");
    if (size.objects > most_derived) return too_many(s);
    if (scanned > most_scanned)
      return fail(Code::range, "'" + s.main + "' changes too often for its size: all that it draws from edit to edit " +
                                   "would be more than " + std::to_string(most_scanned) + " objects");
    Expansion expansion{s, lists, {}, {}, {}};
    expansion.main(s.main);
    called = std::move(expansion.called);
    versions.add(from, std::move(expansion.parts));
    return Nothing{};
  };
  if (Status first = add(from_the_beginning, *s.lists); !first) return first.error();
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
  std::vector<Part> parts = versions.parts();
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
