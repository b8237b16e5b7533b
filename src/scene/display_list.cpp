// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "scene/display_list.h"

#include <algorithm>
#include <unordered_set>

#include "scene/document.h"

namespace betwixt {

void DisplayCommands::put(std::size_t i, DisplayCommand command) {
  if (i < size_) {
    chunks_[i / chunk].edit()[i % chunk] = std::move(command);
    return;
  }
  if (size_ % chunk == 0) chunks_.emplace_back();
  chunks_.back().edit().push_back(std::move(command));
  ++size_;
}

namespace {

const std::string& name_in(const DisplayCommand& c) { return *std::get<Text>(c.value); }

template <class F>
void each_call(const DisplayList& list, F&& f) {
  for (std::size_t i = 0; i < list.commands.size(); ++i)
    if (list.commands[i].what == Drawing::call) f(name_in(list.commands[i]));
}

bool draws(Drawing d) { return d <= Drawing::text; }

// How many objects a list becomes, and how deep they stand in one another.
struct Size {
  std::size_t objects = 0;
  int depth = 0;
};
struct Measure {
  const Scene& s;
  std::map<std::string_view, Size> known;

  Size operator()(const std::string& name, int depth) {
    constexpr std::size_t enough = most_derived + 1;
    const auto at = s.lists->find(name);
    if (at == s.lists->end()) return {};
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
      const Size inside = (*this)(name_in(c), depth + 1);
      size.objects = std::min(enough, size.objects + inside.objects);
      size.depth = std::max(size.depth, 1 + open + inside.depth);
    }
    return known[at->first] = size;
  }
};

struct Part {
  Object object;
  std::int32_t parent = -1;
};

// Scans lists as the interpreter of the source does; where that would draw, it writes down an object.
struct Expansion {
  const Scene& s;
  std::vector<Part> parts;
  std::map<std::pair<std::int32_t, std::string>, int> counted;

  // What holds the things that are drawn now: a group, and the matrix since.
  struct Level {
    Mat4 m;
    std::int32_t group = -1;
  };
  struct Look {
    std::optional<Value> color, texture, font;
  };

  // A name that the group does not have yet: car/star-2.
  std::string named(std::int32_t group, std::string_view word) {
    std::string plain(word);
    std::replace(plain.begin(), plain.end(), '/', '-');
    const int number = ++counted[{group, plain}];
    return parts[static_cast<std::size_t>(group)].object.name + "/" + plain + "-" + std::to_string(number);
  }

  Object& add(std::string name, Kind kind, const Level& at) {
    Part part;
    part.object.name = std::move(name);
    part.object.kind = kind;
    part.object.derived = true;
    part.object.leads = kind == Kind::group;
    part.parent = at.group;
    if (!(at.m == Mat4{})) part.object.slot(fn::transform).set = Matrix(at.m);
    parts.push_back(std::move(part));
    return parts.back().object;
  }

  Level group(std::string name, const Level& at) {
    add(std::move(name), Kind::group, at);
    return {{}, static_cast<std::int32_t>(parts.size()) - 1};
  }

  // An environment moves what is in it behind the matrix so far: a group of its own carries that one.
  Level environment(const DisplayCommand& c, Level at) {
    const std::string name = named(at.group, name_in(c));
    if (!(at.m == Mat4{})) at = group(name + "-base", at);
    at = group(name, at);
    Slot& drive = parts.back().object.slot(fn::drive);
    const Value names = Names({name_in(c)});
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
    Object& o = add(named(at.group, drawing_names[static_cast<std::size_t>(c.what)]), kind, at);
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
          if (const auto called = s.lists->find(name_in(c)); called != s.lists->end())
            list(*called->second, group(named(at.group, called->first), at), look, nullptr);
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

  void main(const std::string& name, const DisplayList& of) {
    const Level root = group(name, {});
    Eye eye{false, root, {}};
    list(of, root, {}, &eye);
    if (!eye.any) return;
    Object& camera = add(name + "/camera", Kind::camera, eye.at);
    if (eye.lens) camera.slot(eye.lens->first).set = eye.lens->second;
  }
};

// Of derived objects: a value each, but for environments that have begun at a tick.
bool same_slots(const std::vector<Slot>& a, const std::vector<Slot>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Slot& x, const Slot& y) {
    return x.function == y.function && x.set == y.set && x.track->events == y.track->events;
  });
}

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
  s.view = !parts.empty() && s.objects[now.back().index].kind == Kind::camera ? now.back() : ObjectId{};
  if (*s.expansion != now) s.expansion = Cow<std::vector<ObjectId>>(std::move(now));
}

}  // namespace

std::vector<std::string> calls(const Scene& s, const std::string& from, const std::string& to) {
  std::vector<std::pair<std::string_view, std::size_t>> steps{{from, 0}};  // and the step that led there
  std::unordered_set<std::string_view> seen{from};
  for (std::size_t i = 0; i < steps.size(); ++i) {
    if (steps[i].first == to) {
      std::vector<std::string> way{to};
      for (std::size_t k = i; k != 0; k = steps[k].second) way.emplace_back(steps[steps[k].second].first);
      std::reverse(way.begin(), way.end());
      return way;
    }
    const auto list = s.lists->find(steps[i].first);
    if (list == s.lists->end()) continue;
    each_call(*list->second, [&](const std::string& name) {
      if (seen.insert(name).second) steps.emplace_back(name, i);
    });
  }
  return {};
}

std::optional<std::size_t> unbalanced(const DisplayList& list) {
  std::vector<std::size_t> open;
  for (std::size_t i = 0; i < list.commands.size(); ++i) {
    const Drawing what = list.commands[i].what;
    if (what == Drawing::push || what == Drawing::begin) open.push_back(i);
    if (what != Drawing::pop && what != Drawing::end) continue;
    const Drawing opener = what == Drawing::pop ? Drawing::push : Drawing::begin;
    if (open.empty() || list.commands[open.back()].what != opener) return i;
    open.pop_back();
  }
  return open.empty() ? std::nullopt : std::optional(open.back());
}

void rename_environment(Scene& s, const std::string& old, const std::string& name) {
  std::vector<std::pair<std::string, std::size_t>> spoken;
  for (const auto& [in, list] : *s.lists)
    for (std::size_t i = 0; i < list->commands.size(); ++i)
      if (list->commands[i].what == Drawing::begin && name_in(list->commands[i]) == old) spoken.emplace_back(in, i);
  for (const auto& [in, i] : spoken) {
    DisplayCommands& commands = s.lists.edit()[in].edit().commands;
    DisplayCommand command = commands[i];
    command.value = Text(name);
    commands.put(i, std::move(command));
  }
  if (!spoken.empty()) (void)expand(s);  // as many as before
}

Status expand(Scene& s) {
  const auto main = s.lists->find(s.main);
  if (main == s.lists->end()) {
    if (!s.expansion->empty()) put(s, {});
    return Nothing{};
  }
  const Size size = Measure{s, {}}(s.main, 1);
  if (size.depth > deepest_derived)
    return fail(Code::range, "'" + s.main + "' would hold instances and environments more than " +
                                 std::to_string(deepest_derived) + " deep in one another");
  if (size.objects > most_derived)
    return fail(Code::range, "'" + s.main + "' would become more than " + std::to_string(most_derived) + " objects",
                "a film has objects for all that its main list draws");
  Expansion expansion{s, {}, {}};
  expansion.main(main->first, *main->second);
  put(s, std::move(expansion.parts));
  return Nothing{};
}

}  // namespace betwixt
