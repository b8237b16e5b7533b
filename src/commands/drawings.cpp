// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// create NAME scene file="logo.svg": the shapes of a drawing become objects.
#include "commands/drawings.h"

#include <fmt/format.h>

#include "base/cancellation.h"
#include "base/kept_results.h"
#include "base/memory_budget.h"
#include "exchange/drawing.h"

namespace betwixt {
namespace {

// Converts a shape of the drawing to an object.
Object object_of(const DrawnThing& thing, const std::string& name) {
  static const auto of_polygon = [](std::string_view function) { return *find_built_in(Kind::polygon, function); };
  Object o;
  o.name = name;
  o.kind = thing.group ? Kind::group : Kind::polygon;
  const auto set = [&o](FunctionId f, Value v) { o.slot(f).set = std::move(v); };
  if (!(thing.at == Vec3{})) set(fn::position, thing.at);
  if (thing.group) return o;
  MemoryBudget::charge((thing.points.size() + thing.holes.size()) * sizeof(Vec3));
  set(of_polygon("points"), Points(thing.points));
  if (!thing.holes.empty()) set(of_polygon("holes"), Points(thing.holes));
  set(fn::color, thing.color);
  set(fn::material, Text("glow"));  // keeps the drawn colours under any light
  if (thing.transparency > 0) set(fn::transparency, thing.transparency);
  // The functions of strokes follow those of fills.
  const auto grade = [&](const DrawnGradient& g, std::size_t first) {
    if (g.kind == 0) return;
    const auto at = [&](FunctionId f) { return static_cast<FunctionId>(f - fn::gradient + first); };
    const auto word = [&](FunctionId f, std::uint32_t number) {
      return Text(std::string(choices(built_in_functions()[f])[number]));
    };
    set(at(fn::gradient), word(fn::gradient, g.kind));
    set(at(fn::gradient_stops), Text(g.stops));
    if (g.turn != 0) set(at(fn::gradient_turn), g.turn);
    if (g.move_x != 0 || g.move_y != 0) set(at(fn::gradient_move), Vec3{g.move_x, g.move_y, 0});
    if (g.size != 1) set(at(fn::gradient_size), g.size);
    if (g.spread != 0) set(at(fn::gradient_spread), word(fn::gradient_spread, g.spread));
  };
  grade(thing.gradient, fn::gradient), grade(thing.stroke_gradient, fn::stroke_gradient);
  if (!thing.fills) set(of_polygon("fill"), false);
  if (thing.strokes) set(of_polygon("stroke"), thing.stroke);
  if (thing.stroke_width > 0) set(of_polygon("stroke-width"), thing.stroke_width);
  if (thing.round) set(of_polygon("stroke-round"), true);
  if (thing.dash.y > 0) set(of_polygon("dash"), thing.dash);
  if (thing.trim_to < 1) set(of_polygon("trim"), Vec3{0, thing.trim_to, 0});
  return o;
}

}  // namespace

bool create_drawing(Command& k, const std::vector<std::string>& names, const std::vector<ObjectId>& parents,
                    const Object& root, std::string path, std::string_view about) {
  auto& [s, c, time, layer, script] = k;
  std::filesystem::path where;
  if (!may_use(k, path, about, where)) return false;
  const auto loaded = KeptResults::get("drawing", where.string(), [&] {
    return load_drawing(
        where.string(), [&](const std::string& p) { return k.script.may_read(p); }, k.script.options.read_anywhere);
  });
  if (!loaded) return c.fail(loaded.error(), about);
  const DrawingFile& drawing = **loaded;
  if (s.objects.size() + names.size() * (1 + drawing.things.size()) > most_objects)
    return c.fail(ErrorCode::range, fmt::format("a film can have at most {} objects", most_objects), about);
  for (const std::string& name : names)
    for (const DrawnThing& thing : drawing.things)
      if (!free_name(k, name + "/" + thing.name, about)) return false;
  for (std::size_t i = 0; i < names.size(); ++i) {
    std::vector<ObjectId> ids;
    Object all = root;
    all.name = names[i];
    const ObjectId first = add_child(s, std::move(all), parents[i]);
    for (const DrawnThing& thing : drawing.things) {
      Cancellation::check();
      ids.push_back(add_child(s, object_of(thing, names[i] + "/" + thing.name),
                              thing.above == DrawnThing::nothing ? first : ids[thing.above]));
    }
  }
  for (const std::string& sentence : drawing.left_out)
    script.note(Severity::warning, fmt::format("in {}: {}", path, sentence), about);
  return true;
}

}  // namespace betwixt
