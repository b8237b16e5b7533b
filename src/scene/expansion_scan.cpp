// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Scans display lists like the interpreter of the source, and records an object where that one would draw.
#include <algorithm>

#include "scene/expansion.h"

namespace betwixt {
namespace {

const std::string& name_of_call(const DisplayCommand& c) { return *std::get<Text>(c.value); }

bool draws(Drawing d) { return d <= Drawing::text; }

struct ExpansionMeasure {
  const DisplayLists& lists;
  std::map<std::string_view, ExpansionSize> known;

  ExpansionSize operator()(const std::string& name, int depth) {
    constexpr std::size_t enough = most_derived + 1;
    const auto at = lists.find(name);
    if (at == lists.end()) return {};
    if (depth > deepest_derived) return {0, depth};
    if (const auto k = known.find(at->first); k != known.end()) return k->second;
    ExpansionSize size{1, 1};
    int open = 0;
    const DisplayCommands& commands = at->second->commands;
    for (std::size_t i = 0; i < commands.size() && size.objects < enough; ++i) {
      const DisplayCommand& c = commands[i];
      if (draws(c.what)) ++size.objects;
      if (c.what == Drawing::begin) ++size.objects, size.depth = std::max(size.depth, 1 + ++open);
      if (c.what == Drawing::end) open = std::max(0, open - 1);
      if (c.what != Drawing::call) continue;
      const ExpansionSize inside = (*this)(name_of_call(c), depth + 1);
      size.objects = std::min(enough, size.objects + inside.objects);
      size.depth = std::max(size.depth, 1 + open + inside.depth);
    }
    return known[at->first] = size;
  }
};

// Scans lists like the interpreter of the source, and records an object where that one would draw.
struct Expansion {
  const Scene& s;
  const DisplayLists& lists;
  std::vector<ExpandedPart> parts;
  std::map<std::pair<std::int32_t, std::string>, int> counted;
  std::set<std::string, std::less<>> called;  // whether they exist or not

  // The parent of the next objects: a group, and the matrix since.
  struct Level {
    Mat4 m;
    std::int32_t group = -1;
  };
  struct Look {
    std::optional<Value> color, texture, font;
  };

  // Returns a numbered word that the group does not have yet.
  std::string numbered(std::int32_t group, std::string_view word) {
    std::string plain(word);
    std::replace(plain.begin(), plain.end(), '/', '-');
    const int number = ++counted[{group, plain}];
    return plain + "-" + std::to_string(number);
  }

  Object& add(std::string word, Kind kind, const Level& at, std::int32_t within) {
    ExpandedPart part;
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

  // An environment acts after the matrix of its begin, so a separate group has that matrix.
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

  // The document's camera; only the main list makes it.
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
      if (stack.empty() || stack.back().by != by) return;  // the error is reported where the list is closed
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

}  // namespace

ExpansionSize expansion_size(const DisplayLists& lists, const std::string& main) {
  return ExpansionMeasure{lists, {}}(main, 1);
}

Expanded expanded(const Scene& s, const DisplayLists& lists, const std::string& main) {
  Expansion expansion{s, lists, {}, {}, {}};
  expansion.main(main);
  return {std::move(expansion.parts), std::move(expansion.called)};
}

}  // namespace betwixt
