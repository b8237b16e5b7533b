// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The drawables as columns, with words turned into numbers; and the schedule of changes.
#include <algorithm>
#include <unordered_map>

#include "program/compile.h"
#include "program/on_axes.h"
#include "scene/formula_parts.h"

namespace betwixt {
namespace {

using Compiled = Program::Compiled;

std::uint8_t effect_of(const FunctionSpec& spec, FunctionId f) {
  if (spec.shape || f == fn::geometry) return affects::form;
  if (is_of_finish(f) || is_of_gradient(f)) return affects::look;
  if (is_of_layer(f)) return affects::other;
  if (f >= fn::video_file && f <= fn::texture_time) return affects::look;
  switch (f) {
    case fn::color:
      return affects::look | affects::other;  // the colour of a light, too
    case fn::transparency:
    case fn::shininess:
    case fn::material:
    case fn::texture:
    case fn::display:
    case fn::casts:
      return affects::look;
    case fn::look_at:
    case fn::look_offset:
    case fn::roll:
    case fn::front:
    case fn::reach:
    case fn::reach_share:
    case fn::reach_pole:
      return affects::aim;
    case fn::scale:
      return affects::place | affects::other;  // the range of a light
    case fn::range:
    case fn::intensity:
    case fn::shines:
    case fn::casting:
    case fn::light_shape:
    case fn::light_size:
    case fn::cone:
    case fn::cone_edge:
    case fn::light_picture:
    case fn::lens:
    case fn::fov:
    case fn::camera_height:
    case fn::shutter:
    case fn::f_stop:
    case fn::focus:
      return affects::other;
    default:
      return spec.place ? affects::place : 0;
  }
}

std::size_t hash_of(const Shape& s) {
  std::size_t h = static_cast<std::size_t>(s.kind);
  for (const double x : {s.size.x, s.size.y, s.size.z, s.radius, s.height, s.tube, s.width, s.depth})
    h = h * 0x9e3779b97f4a7c15u + std::hash<double>{}(x);
  h = h * 31 + std::hash<std::string>{}(*s.text);
  // Hashes some coordinates only: drawings have many outlines with equal numbers of points.
  for (std::size_t i = 0; i < s.points->size(); i += 1 + s.points->size() / 4)
    h = h * 31 + std::hash<double>{}((*s.points)[i].x) + 7 * std::hash<double>{}((*s.points)[i].y);
  return h * 31 + s.points->size() + std::hash<const void*>{}(s.mesh.get());
}

struct ScheduleCompiler {
  Compiled& compiled;
  const CompiledFilm* before;  // the last program, to share with; may be null
  const Scene& scene = compiled.document.scene();
  Schedule& schedule = compiled.schedule;

  void keep(const Schedule::Source& s) {
    schedule.sources.push_back(s);
    schedule.events.push_back(s.what == Schedule::Source::curve ? CurveEvents(compiled.curves[s.index].curve)
                                                                : CurveEvents());
  }

  template <class Activities>
  void add(Schedule::Source source, Activities&& activities) {
    source.first_activity = static_cast<std::uint32_t>(schedule.activities.size());
    activities(schedule.activities);
    source.activities = static_cast<std::uint32_t>(schedule.activities.size()) - source.first_activity;
    if (source.activities > 0) return keep(source);
    if (source.what != Schedule::Source::curve) return;
    const CurveUse& use = compiled.curves[source.index];  // constant
    compiled.evaluate_curve(use, {}, &compiled.rest[use.offset]);
  }

  // Returns true if the object's columns come from the last program; then its sources do too.
  bool shared(std::uint32_t object) const {
    return before && object + 1 < before->pieces.size() && before->pieces[object].columns &&
           before->pieces[object].columns == compiled.pieces[object].columns;
  }
  void share(std::uint32_t object) {
    const ObjectPiece &from = before->pieces[object], &to = compiled.pieces[object];
    for (std::uint32_t k = from.source; k < before->pieces[object + 1].source; ++k) {
      Schedule::Source s = before->schedule.sources[k];
      const auto first = before->schedule.activities.begin() + s.first_activity;
      s.node = compiled.node_of[object];
      s.index += s.what == Schedule::Source::curve ? to.curve - from.curve : to.step - from.step;
      s.first_activity = static_cast<std::uint32_t>(schedule.activities.size());
      schedule.activities.insert(schedule.activities.end(), first, first + s.activities);
      keep(s);
    }
  }

  std::uint8_t effect_on(std::uint32_t node, const Binding& b) const {
    std::uint8_t effect = effect_of(spec_of(scene, b.function), b.function);
    if (weighs(node, b)) effect |= affects::form;
    return effect;
  }

  void bindings(std::uint32_t object) {
    const std::uint32_t node = compiled.node_of[object];
    for (auto i = compiled.pieces[object].binding; i < compiled.pieces[object + 1].binding; ++i) {
      const Binding& b = compiled.bindings[i];
      const FunctionSpec& spec = spec_of(scene, b.function);
      const std::uint8_t effect = effect_on(node, b);
      if (b.live >= 0) {
        schedule.lives.push_back({&b, effect, node, spec.matters_to_contacts() || (effect & affects::form) != 0});
        continue;
      }
      // With the author's own twerpers, an error must still be reported.
      if (effect == 0 && compiled.set.own.empty()) continue;
      for (std::uint32_t k = 0; k < b.curves; ++k)
        add({Schedule::Source::curve, effect, b.first_curve + k, node}, [&](std::vector<Activity>& out) {
          compiled.set.activities(compiled.curves[b.first_curve + k].curve, out);
        });
      if (b.steps >= 0)
        add({Schedule::Source::steps, effect, static_cast<std::uint32_t>(b.steps), node},
            [&](std::vector<Activity>& out) { compiled.steps_of(b).activities(out); });
    }
  }

  // Numbers the bindings that have tracks with coded twerpers.
  void coded() {
    const auto& own = compiled.set.own;
    if (std::all_of(own.begin(), own.end(), [](const auto& code) { return !code; })) return;
    for (std::uint32_t object = 0; object < compiled.node_of.size(); ++object)
      for (auto i = compiled.pieces[object].binding; i < compiled.pieces[object + 1].binding; ++i) {
        Binding& b = compiled.bindings[i];
        const std::uint32_t node = compiled.node_of[object];
        if (b.coded < 0 || node == ObjectId::nothing) continue;
        b.coded = -1;
        if (b.function == fn::geometry && compiled.draws(node) && compiled.drawables[node].blend >= 0) continue;
        b.coded = static_cast<std::int32_t>(schedule.coded.size());
        schedule.coded.push_back({&b, effect_on(node, b), node, false});
      }
  }

  // Returns true if the binding is the weight of a morph target of the node's mesh.
  bool weighs(std::uint32_t node, const Binding& b) const {
    if (!compiled.draws(node) || compiled.drawables[node].skin < 0) return false;
    const auto& weights = compiled.skins[static_cast<std::size_t>(compiled.drawables[node].skin)].weights;
    return std::find(weights.begin(), weights.end(), &b) != weights.end();
  }

  // Whether a text turns into others, and what it is a part of.
  void describe_text(std::uint32_t node, Drawable& d) {
    const std::uint32_t object = compiled.nodes[node].object;
    if (!has_letters(scene.objects[object].kind)) return;
    if (const auto piece = compiled.pieces_of_formulas.find(object); piece != compiled.pieces_of_formulas.end()) {
      d.whole = static_cast<std::int32_t>(compiled.node_of[piece->second.whole]);
      compiled.formula_pieces.push_back(node);
    }
    static const FunctionId tex = *find_built_in(Kind::text, "tex");
    for (const FunctionId f : {tex, FunctionId{fn::text}})
      if (const Binding& b = compiled.find_shown(object, f); b.steps >= 0 && compiled.steps_of(b).blends())
        d.matches = compiled.matching = true;
  }

  bool form_varies(std::uint32_t object) const {
    if (scene.objects[object].kind == Kind::trace || points_by_axes(scene, scene.objects[object])) return true;
    const auto piece = compiled.pieces_of_formulas.find(object);
    if (piece != compiled.pieces_of_formulas.end() && form_varies(piece->second.whole)) return true;
    for (auto i = compiled.pieces[object].binding; i < compiled.pieces[object + 1].binding; ++i)
      if (const Binding& b = compiled.bindings[i]; b.varies() && spec_of(scene, b.function).shape) return true;
    return false;
  }

  bool may_be_layer(std::uint32_t object) const {
    for (FunctionId f = fn::opacity; f <= fn::shadow_opacity; ++f)
      if (&compiled.find(object, f) != &compiled.defaults[f]) return !scene.objects[object].hidden;
    return false;
  }

  // Returns true if its shape may take long to make, constant or not.
  bool may_take_long(std::uint32_t object, const Drawable& d) const {
    const Binding& seen = compiled.find(object, fn::display);
    // Not shown, such as a road that others move along.
    if (!seen.varies() && compiled.rest[seen.offset] == 0) return false;
    return d.skin >= 0 ? slow_skins : is_large(object, d, 5'000, 500);
  }

  // Returns true if its shape has more points or letters than these, or they vary.
  bool is_large(std::uint32_t object, const Drawable& d, std::size_t points, std::size_t letters) const {
    if (scene.objects[object].kind == Kind::trace) return true;
    if (d.shape < compiled.shapes.size()) {
      const Shape& s = *compiled.shapes[d.shape];
      return s.points->size() + s.holes->size() > points || s.text->size() > letters;
    }
    for (auto i = compiled.pieces[object].binding; i < compiled.pieces[object + 1].binding; ++i)
      if (const Binding& b = compiled.bindings[i]; b.varies())
        if (const FunctionSpec& spec = spec_of(scene, b.function);
            spec.shape && (spec.type == Type::points || spec.type == Type::text))
          return true;
    return false;
  }

  // Returns true if blending the shapes that it takes may take long.
  bool blends_long(const Drawable& own) const {
    if (own.geometry->steps < 0 || !compiled.steps_of(*own.geometry).blends()) return false;
    const auto values = compiled.steps_of(*own.geometry).values();
    return std::any_of(values.begin(), values.end(), [&](const Value& v) {
      const Object* o = find_object(scene, std::get<ObjectId>(v));
      const auto taken = o && drawable(o->kind) ? compiled.node_of[std::get<ObjectId>(v).index]
                                                : static_cast<std::uint32_t>(&own - compiled.drawables.data());
      const Drawable& d = compiled.drawables[taken];
      if (d.skin >= 0) return slow_skins;
      const bool large_mesh = d.shape < compiled.shapes.size() && compiled.shapes[d.shape]->mesh &&
                              compiled.shapes[d.shape]->mesh->positions.size() > many_vertices;
      return large_mesh || is_large(compiled.nodes[taken].object, d, 500, 50);
    });
  }

  static constexpr std::size_t many_vertices = 5'000;
  bool slow_skins = false;  // deforming all skins of a frame may take long

  // Returns the shape's number; equal shapes share one.
  std::uint32_t shape_number(std::uint32_t object) {
    Asking asking;
    auto shape = std::make_shared<const Shape>(compiled.shape(object, {}, compiled.rest.data(), asking));
    const auto [first, last] = shape_index.equal_range(hash_of(*shape));
    for (auto at = first; at != last; ++at)
      if (*compiled.shapes[at->second] == *shape) return at->second;
    const auto number = static_cast<std::uint32_t>(compiled.shapes.size());
    shape_index.emplace(hash_of(*shape), number);
    compiled.shapes.push_back(std::move(shape));
    return number;
  }
  std::unordered_multimap<std::size_t, std::uint32_t> shape_index{};

  void drawables() {
    number_textures(compiled);
    std::vector<std::uint32_t> varying;
    for (std::uint32_t i = 0; i < compiled.nodes.size(); ++i) {
      const Node& n = compiled.nodes[i];
      const auto find = [&](FunctionId f) { return &compiled.find_shown(n.object, f); };
      if (n.kind == Kind::light && !scene.objects[n.object].hidden) compiled.lights.push_back(i);
      if (n.kind == Kind::group && may_be_layer(n.object)) compiled.layers.push_back(i);
      if (n.kind == Kind::camera) {
        if (const Object& o = scene.objects[n.object]; !o.derived && !o.hidden && !compiled.first_camera)
          compiled.first_camera = n.object;
      }
      if (n.looks || n.reaches) compiled.eyes.push_back(i);
      if (!drawable(n.kind)) continue;
      Drawable d{compiled.find(n.object, fn::transparency).offset,
                 find(fn::shininess)->offset,
                 find(fn::casts)->offset,
                 find(fn::material),
                 find(fn::texture),
                 &compiled.find(n.object, fn::geometry)};
      describe_text(i, d);
      if (n.kind == Kind::trace) {
        compiled.traces = true;
        schedule.lives.push_back({&compiled.defaults[fn::trace_of], affects::form, i, false});
      }
      if (points_by_axes(scene, scene.objects[n.object]))
        schedule.lives.push_back({&compiled.defaults[fn::on_axes], affects::form, i, false});
      // Without a value of its own that changes, a video changes with the time.
      if (show_video(compiled, i, d))
        schedule.lives.push_back({&compiled.defaults[fn::trace_of], affects::look, i, false});
      if (auto skin = compile_skin(compiled, i)) {
        d.skin = static_cast<std::int32_t>(compiled.skins.size());
        compiled.skins.push_back(*std::move(skin));
      }
      if (d.skin >= 0 || form_varies(n.object))
        varying.push_back(i);
      else
        d.shape = shape_number(n.object);
      if (!d.material->varies()) d.made_of = &material_of(d.material->constant);
      d.plain = d.made_of && !d.texture->varies() && d.video < 0;
      if (d.plain) d.texture_number = compiled.texture(d.texture->constant);
      if (auto use = finish_use(compiled, n.object, d)) {
        d.finish = static_cast<std::int32_t>(compiled.finishes.size());
        compiled.finishes.push_back(*use);
      }
      if (auto use = gradient_use(compiled, n.object)) {
        d.gradients = static_cast<std::int32_t>(compiled.gradients.size());
        compiled.gradients.push_back(*use);
      }
      if (d.geometry != &compiled.defaults[fn::geometry]) compiled.borrowers.push_back(i);
      compiled.drawables.push_back(d);
    }
    for (const std::uint32_t i : varying)
      compiled.drawables[i].shape = static_cast<std::uint32_t>(compiled.shapes.size()) + i;
    std::size_t vertices = 0;
    for (const Skin& skin : compiled.skins) vertices += skin.rest->positions.size();
    slow_skins = vertices > many_vertices;
    for (std::uint32_t i = 0; i < compiled.drawables.size(); ++i) {
      Drawable& d = compiled.drawables[i];
      if (!may_take_long(compiled.nodes[i].object, d)) continue;
      d.slow = static_cast<std::int32_t>(compiled.slow_shapes.size());
      compiled.slow_shapes.push_back(i);
    }
    for (std::uint32_t i = 0; i < compiled.drawables.size(); ++i) {
      Drawable& d = compiled.drawables[i];
      if (!blends_long(d)) continue;
      d.blend = static_cast<std::int32_t>(compiled.slow_blends.size());
      compiled.slow_blends.push_back(i);
    }
  }

  void nodes() {
    for (std::uint32_t i = 0; i < compiled.nodes.size(); ++i) {
      const Node& n = compiled.nodes[i];
      add({Schedule::Source::attachment, affects::place, 0, i}, [&](std::vector<Activity>& out) {
        const std::size_t first = out.size();
        for (std::uint32_t k = 0; k < n.spans; ++k)
          if (const std::int64_t from = compiled.spans[n.first_span + k].from.flicks; from > INT64_MIN)
            add_activity(out, first, {from, from});
      });
      if (n.moving >= 0)
        add({Schedule::Source::motion, affects::place, static_cast<std::uint32_t>(n.moving), i},
            [&](std::vector<Activity>& out) {
              motion_activities(compiled.movings[static_cast<std::size_t>(n.moving)], out);
            });
      for (const std::int32_t siting : {n.around, n.drive})
        if (siting >= 0)
          add({Schedule::Source::siting, affects::place, static_cast<std::uint32_t>(siting), i},
              [&](std::vector<Activity>& out) {
                const std::size_t first = out.size();
                for (const Siting::Change& c : compiled.sitings[static_cast<std::size_t>(siting)].changes)
                  add_activity(out, first, {c.from.flicks, c.from.flicks});
              });
    }
  }

  static void motion_activities(const Moving& m, std::vector<Activity>& out) {
    const std::size_t first = out.size();
    if (m.extend_before != Extrapolation::hold) add_activity(out, first, {INT64_MIN, m.first.flicks});
    for (const Moving::Piece& p : m.pieces)
      add_activity(out, first, {p.from.flicks, p.open ? p.from.flicks : p.until.flicks});
    if (m.extend_after != Extrapolation::hold) add_activity(out, first, {m.last.flicks, INT64_MAX});
  }

  void edges() {
    for (std::uint32_t s = 0; s < schedule.sources.size(); ++s)
      for (std::uint32_t k = 0; k < schedule.sources[s].activities; ++k) {
        const Activity& r = schedule.activities[schedule.sources[s].first_activity + k];
        schedule.begins.push_back({r.from, s});
        schedule.ends.push_back({r.until, s});
      }
    const auto earlier = [](const Schedule::Edge& a, const Schedule::Edge& b) { return a.time < b.time; };
    std::stable_sort(schedule.begins.begin(), schedule.begins.end(), earlier);
    std::stable_sort(schedule.ends.begin(), schedule.ends.end(), earlier);
  }
};

}  // namespace

void compile_schedule(Compiled& compiled, const CompiledFilm* before) {
  ScheduleCompiler c{compiled, before};
  c.drawables();
  for (std::uint32_t i = 0; i <= compiled.node_of.size(); ++i) {
    compiled.pieces[i].source = static_cast<std::uint32_t>(compiled.schedule.sources.size());
    if (i == compiled.node_of.size() || compiled.node_of[i] == ObjectId::nothing) continue;
    c.shared(i) ? c.share(i) : c.bindings(i);
  }
  c.coded();
  c.nodes();
  c.edges();
}

}  // namespace betwixt
