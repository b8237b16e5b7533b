// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/poses/poses.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>

#include "betwixt/language.h"
#include "betwixt/math.h"
#include "betwixt/object.h"
#include "editor/made_by.h"
#include "scene/document.h"
#include "scene/own_kinds.h"
#include "studio/objects/object_lines.h"
#include "studio/poses/mixed.h"
#include "studio/viewport/hand.h"
#include "track/types.h"

namespace betwixt::studio {
namespace {

constexpr std::string_view head = "# pose of ";
bool has_place_in_pose(Type type) {
  return type != Type::attachment && type != Type::motion && type != Type::transform && type != Type::names;
}

Mat4 world_of(const Program& program, ObjectId id, Time t) {
  const Value v = program.read(Target(id, Query::world), t);
  const auto* m = std::get_if<Matrix>(&v);
  return m ? **m : Mat4{};
}

Type type_of(const Document& d, const Target& t) { return spec_of(d.scene(), t.function).type; }

std::optional<Target> target_of(const Document& d, const std::string& object, const std::string& function) {
  const ObjectId id = d.find(object);
  if (!id) return std::nullopt;
  for (const FunctionView& f : functions(d, id))
    if (f.name == function) return Target(id, f.id);
  return std::nullopt;
}

// Replaces the root of a name: man/arm becomes twin/arm.
std::string under(const std::string& name, const std::string& root, const std::string& other) {
  if (name == root) return other;
  return is_below(name, root) ? other + name.substr(root.size()) : name;
}

// --- Left and right

bool letter(const std::string& s, std::size_t i, int (*is)(int)) {
  return i < s.size() && is(static_cast<unsigned char>(s[i])) != 0;
}

// Returns the name of the other side: man/left-arm for man/right-arm, Arm.L for Arm.R; "" if it has none.
std::string other_side(const std::string& name) {
  static constexpr std::pair<std::string_view, std::string_view> sides[] = {
      {"left", "right"}, {"Left", "Right"}, {"LEFT", "RIGHT"}, {"L", "R"}, {"l", "r"}};
  std::string out = name;
  bool any = false;
  for (const auto& [a, b] : sides)
    for (const auto& [from, to] : {std::pair(a, b), std::pair(b, a)})
      for (std::size_t at = name.find(from); at != std::string::npos; at = name.find(from, at + 1)) {
        const std::size_t end = at + from.size();
        const bool lower = std::islower(static_cast<unsigned char>(from[0])) != 0, single = from.size() == 1;
        // "bright" and "Lamp" have no side.
        if (at > 0 && (single ? letter(name, at - 1, std::isalnum) : lower && letter(name, at - 1, std::isalpha)))
          continue;
        if (single ? letter(name, end, std::isalpha) : letter(name, end, std::islower)) continue;
        if (out != name) continue;  // one exchange a name, of the first kind that fits
        out.replace(at, from.size(), to), any = true;
      }
  return any ? out : "";
}

// Returns the axis along which the two sides lie apart in their parents' space; x if nothing has two sides.
int axis_between_sides(const Program& program, const Pose& pose, Time t) {
  const Document& d = program.document();
  Vec3 apart{};
  for (const Pose::Part& part : pose.parts) {
    if (part.function != "position") continue;
    const ObjectId one = d.find(part.object), two = d.find(other_side(part.object));
    if (!one || !two || parent_at(d, one, t) != parent_at(d, two, t)) continue;
    const Value a = program.read(Target(one, fn::position), t), b = program.read(Target(two, fn::position), t);
    for (int i = 0; i < 3; ++i)
      if (std::holds_alternative<Vec3>(a) && std::holds_alternative<Vec3>(b))
        apart[i] += std::abs(std::get<Vec3>(a)[i] - std::get<Vec3>(b)[i]);
  }
  return apart.z > apart.x && apart.z >= apart.y ? 2 : apart.y > apart.x ? 1 : 0;
}

Value in_mirror(Value v, const std::string& function, int axis) {
  if (auto* place = std::get_if<Vec3>(&v); place && function != "scale") (*place)[axis] *= -1;
  if (auto* angles = std::get_if<Angles>(&v))
    for (int i = 0; i < 3; ++i) angles->xyz[i] *= i == axis ? 1 : -1;
  if (auto* q = std::get_if<Quat>(&v))
    *q = {q->w, axis == 0 ? q->x : -q->x, axis == 1 ? q->y : -q->y, axis == 2 ? q->z : -q->z};
  return v;
}

// Adds the lines that give a whole function a value: one line for each component if these have tracks of their own.
void add_lines(const Document& d, const Target& whole, const Value& now, const Value& wanted, Time t, bool make_events,
               Lines& to) {
  const Time first = d.range().first;
  const auto add = [&](const Target& target, const Value& was, const Value& is, bool keyed) {
    if (!keyed && was == is) return;
    // The film before keeps the value that the function had.
    if (make_events && !keyed && t > first)
      to.push_back(fmt::format("at {} {} {} hold", format_time(first, d), d.name(target), value_words(d, target, was)));
    if (keyed || make_events || was != is) to.push_back(line_for(d, target, is, t, keyed || make_events));
  };
  const bool keyed = made_by(d, whole, t).events;
  if (!in_components(d, whole)) {
    add(whole, now, wanted, keyed);
    return;
  }
  for (int c = 0; c < 3; ++c) {
    const Target part(whole.object, whole.function, c);
    const bool own = next_event(d, part, earliest_time).has_value();
    const double was = component_of(now, c), is = component_of(wanted, c);
    if (own || was != is) add(part, was, is, own);
  }
}

}  // namespace

Pose pose_of(const Program& program, const std::vector<ObjectId>& objects, Time t) {
  const Document& d = program.document();
  Pose pose;
  const std::vector<ObjectId> all = all_below_at(d, objects, t);
  if (all.empty()) return pose;
  const auto is_root = [&](ObjectId id) { return std::ranges::find(all, parent_at(d, id, t)) == all.end(); };
  const auto has_parts = [&](ObjectId id) {
    return std::ranges::any_of(all, [&](ObjectId part) { return parent_at(d, part, t) == id; });
  };
  const ObjectId root = *std::ranges::find_if(all, is_root);
  pose.root = d.name(root);
  const auto back = inverse(world_of(program, root, t));
  for (const ObjectId id : all) {
    const bool stays = is_root(id) && has_parts(id);
    for (const FunctionView& f : functions(d, id)) {
      const Target whole(id, f.id);
      const bool moves = f.id == fn::position || f.id == fn::rotation;
      const MadeBy made = made_by(d, whole, t);
      if (!has_place_in_pose(f.type) || !made.code.empty() || (stays && moves)) continue;
      if (!made.events && !moves && !(made.said && f.id == fn::scale)) continue;
      Value v = program.read(whole, t);
      if (f.type == Type::aim) {
        const auto* point = std::get_if<Vec3>(&v);
        if (!point || !back) continue;
        v = transform_point(*back, *point);
      }
      pose.parts.push_back({d.name(id), std::string(f.name), written_plain(v, f.type == Type::angle)});
    }
  }
  return pose;
}

Pose mirrored(const Pose& pose, const Program& program, Time t) {
  const Document& d = program.document();
  const int axis = axis_between_sides(program, pose, t);
  Pose out = pose;
  for (Pose::Part& part : out.parts) {
    part.value = in_mirror(part.value, part.function, axis);
    if (const std::string other = other_side(part.object); d.find(other)) part.object = other;
  }
  return out;
}

Lines pose_lines(const Program& program, const Pose& pose, ObjectId onto, Time t, bool make_events, double share) {
  const Document& d = program.document();
  const std::string root = onto ? d.name(onto) : pose.root;
  Lines lines;
  const ObjectId root_id = d.find(root);
  const Mat4 world = root_id ? world_of(program, root_id, t) : Mat4{};
  // A character that moves at all gets the pose from here on, and not for the whole film.
  for (const Pose::Part& part : pose.parts)
    if (const auto target = target_of(d, under(part.object, pose.root, root), part.function))
      make_events = make_events || made_by(d, *target, t).events;
  for (const Pose::Part& part : pose.parts) {
    const auto target = target_of(d, under(part.object, pose.root, root), part.function);
    if (!target || !made_by(d, *target, t).code.empty()) continue;
    Value wanted = part.value;
    if (type_of(d, *target) == Type::aim)
      if (const auto* point = std::get_if<Vec3>(&wanted)) wanted = transform_point(world, *point);
    const Value now = program.read(*target, t);
    const bool angle = type_of(d, *target) == Type::angle;
    add_lines(d, *target, written_plain(now, angle), written_plain(mixed(now, wanted, share), angle), t, make_events,
              lines);
  }
  return lines;
}

std::string text_of_pose(const Pose& pose, const Document& d) {
  std::string text = std::string(head) + pose.root + "\n";
  for (const Pose::Part& part : pose.parts)
    if (const auto target = target_of(d, part.object, part.function))
      text += fmt::format("set {} {}\n", d.name(*target), value_words(d, *target, part.value));
  return text;
}

Result<Pose> read_pose(const std::string& text, const Document& d, ObjectId onto,
                       const std::function<Result<Document>(const Lines&)>& trial) {
  const auto no_pose = [] {
    return Error{ErrorCode::syntax, "this is no pose", "it begins with '# pose of NAME'", {}};
  };
  if (!text.starts_with(head)) return no_pose();
  Pose pose;
  Lines lines;
  std::vector<std::string> targets;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const std::string line = text.substr(at, end - at);
    at = end + 1;
    if (line.starts_with(head)) pose.root = line.substr(head.size());
    if (!line.starts_with("set ")) continue;
    // Names with blanks have quotes.
    const std::size_t after = line[4] == '"' ? line.find('"', 5) : 4,
                      space = line.find(' ', std::min(after, line.size()));
    if (space == std::string::npos) return no_pose();
    const std::string words = line.substr(4, space - 4);
    targets.push_back(under(words.substr(0, words.rfind('.')), pose.root, onto ? d.name(onto) : pose.root) +
                      words.substr(std::min(words.rfind('.'), words.size())));
    lines.push_back("set " + targets.back() + line.substr(space));
  }
  if (onto) pose.root = d.name(onto);
  const Result<Document> there = trial(lines);
  if (!there) return there.error();
  for (const std::string& words : targets) {
    const auto found = find_targets(words, *there);
    if (!found || found->size() != 1) return no_pose();
    const Value* value = value_set(*there, found->front());
    if (value) pose.parts.push_back({there->name(found->front().object), words.substr(words.rfind('.') + 1), *value});
  }
  return pose;
}

}  // namespace betwixt::studio
