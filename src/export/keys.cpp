// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "betwixt/keys.h"

#include <algorithm>
#include <map>
#include <optional>
#include <unordered_map>

#include "betwixt/pose.h"
#include "betwixt/track.h"
#include "export/fit.h"
#include "export/parts.h"
#include "program/placing.h"
#include "track/track.h"

namespace betwixt {
namespace {

using Compiled = Program::Compiled;

// Adds the events of tracks, and the ends of their eases.
void add_events(const Document& d, const std::vector<TrackView>& tracks, Time from, Time until,
                std::vector<Time>& out) {
  for (const TrackView& t : tracks)
    each_event(d, t.target, from, until, [&](const EventView& e) {
      out.push_back(e.time);
      if (e.ease_in > Time{}) out.push_back(e.time - e.ease_in);
      if (e.ease_out > Time{}) out.push_back(e.time + e.ease_out);
    });
}

// Returns all possible corners.
std::vector<Time> all_knots(const Program& program, Time from, Time until) {
  std::vector<Time> all = program.discontinuities(from, until);
  const Document& d = program.document();
  for (const ObjectId id : objects(d)) add_events(d, tracks(d, id), from, until, all);
  return knots_between(std::move(all), from, until);
}

// Translation, rotation and scale of an object at a time, and a further rotation if it is sheared.
struct Place {
  Vec3 translation, scale;
  KeyValue rotation{}, inner{};
};

KeyValue numbers_of(Quat q) { return {q.x, q.y, q.z, q.w}; }

class Stage {
 public:
  Stage(const Program& program, Time from, Time until, const KeyOptions& options)
      : program_(program), compiled_(program.compiled()), from_(from), until_(until), options_(options) {
    moved_.resize(compiled_.nodes.size());
    for (const auto& source : compiled_.schedule.sources)
      if (source.affects & (affects::place | affects::aim)) moved_[source.node] |= by_tracks;
    for (const auto& live : compiled_.schedule.lives)
      if (live.affects & (affects::place | affects::aim)) moved_[live.node] |= by_code;
  }

  std::vector<ObjectKeys> all() {
    measure();
    std::vector<ObjectKeys> out;
    const std::vector<ObjectId> ids = objects(program_.document());
    for (std::size_t i = 0; i < ids.size(); ++i) {
      const ObjectId id = ids[i];
      if (options_.go_on && !options_.go_on(static_cast<double>(i) / static_cast<double>(ids.size()))) break;
      if (id.index >= compiled_.node_of.size() || compiled_.node_of[id.index] == ObjectId::nothing) continue;
      const Node& n = compiled_.nodes[compiled_.node_of[id.index]];
      if (placed(n.kind)) out.push_back(keys(id));
    }
    return out;
  }

  const std::vector<Time>& everybodys() {
    if (everybodys_.empty()) everybodys_ = all_knots(program_, from_, until_);
    return everybodys_;
  }

 private:
  enum : std::uint8_t { by_tracks = 1, by_code = 2 };

  // Returns its constant parent, or a span with `computed` if that changes.
  CompiledSpan held(const Node& n) const {
    const CompiledSpan* first = compiled_.span(n, from_);
    const CompiledSpan* last = compiled_.span(n, {until_.flicks - 1});
    CompiledSpan changing;
    changing.computed = true;
    return first != last ? changing : first ? *first : CompiledSpan{};
  }

  static double size_of(const Mat4& m) {
    return std::max({length(column(m, 0)), length(column(m, 1)), length(column(m, 2))});
  }

  // Computes the tolerance of each object so that its descendants are exact enough: errors add up along a chain, a
  // rotation moves far objects by more, and a scale magnifies.
  void measure() {
    const auto count = static_cast<std::uint32_t>(compiled_.nodes.size());
    std::vector<std::int32_t> above(count, -1);
    for (std::uint32_t i = 0; i < count; ++i)
      if (const CompiledSpan span = held(compiled_.nodes[i]); !span.computed) above[i] = span.parent;
    links_.assign(count, 1), reach_.assign(count, 1), above_.assign(count, 1);
    // Circles are cut by their length.
    const auto each_above = [&](std::uint32_t node, auto&& f) {
      std::int32_t at = above[node];
      for (std::uint32_t length = 1; at >= 0 && length <= deepest; ++length, at = above[static_cast<std::size_t>(at)])
        f(static_cast<std::uint32_t>(at), length);
    };
    std::vector<std::uint32_t> up(count), down(count);
    for (std::uint32_t i = 0; i < count; ++i)
      each_above(i, [&](std::uint32_t a, std::uint32_t n) { up[i] = n, down[a] = std::max(down[a], n); });
    for (std::uint32_t i = 0; i < count; ++i) links_[i] = 1.0 + up[i] + down[i];
    for (int look = 0; look < 5; ++look) {
      const auto poses = betwixt::poses(program_, {from_.flicks + (until_.flicks - from_.flicks) / 4 * look});
      const auto place = [&](std::uint32_t node) { return translation_of(poses[compiled_.nodes[node].object].world); };
      for (std::uint32_t i = 0; i < count; ++i) {
        const double size = size_of(poses[compiled_.nodes[i].object].world);
        reach_[i] = std::clamp(size, reach_[i], 1e4);
        if (above[i] >= 0)
          above_[i] = std::clamp(size_of(poses[compiled_.nodes[static_cast<std::size_t>(above[i])].object].world),
                                 above_[i], 1e4);
        each_above(i, [&](std::uint32_t a, std::uint32_t) {
          reach_[a] = std::clamp(length(place(i) - place(a)), reach_[a], 1e4);
        });
      }
    }
  }

  ObjectKeys keys(ObjectId id) {
    const Node& n = compiled_.nodes[compiled_.node_of[id.index]];
    const CompiledSpan span = held(n);
    // Its own tracks determine everything.
    const bool coupled = span.kind == AttachmentKind::couple, own = coupled || span.kind == AttachmentKind::detach;
    const bool plain = own && !span.computed && span.frozen < 0 && n.drive < 0 && n.moving < 0 && !n.transform &&
                       !n.looks && !n.bends && n.reaches == 0 && !compiled_.sited;
    const ObjectId parent = span.computed || span.parent < 0
                                ? ObjectId{}
                                : ObjectId{compiled_.nodes[static_cast<std::size_t>(span.parent)].object};
    const std::uint8_t moved = moved_[compiled_.node_of[id.index]];
    if (plain) {
      auto knots = moved == by_tracks ? own_knots(id) : moved ? std::optional(everybodys()) : still();
      return made(id, coupled ? parent : ObjectId{}, knots ? *knots : everybodys(), [&, node = &n](Time t) {
        Asking asking;
        const OwnTransform said = own_transform_at(compiled_, *node, t, asking);
        Mat4 m = rotation(said.turn);
        for (int c = 0; c < 3; ++c)
          for (int i = 0; i < 3; ++i) m(i, c) *= said.scale[c];
        return Place{said.position + (coupled ? said.attach : Vec3{}) + said.pivot - transform_vector(m, said.pivot),
                     said.scale,
                     numbers_of(said.turn),
                     {}};
      });
    }
    ObjectKeys in_world = by_matrix(id, {});
    if (!parent) return in_world;
    ObjectKeys below = by_matrix(id, parent);
    const bool better = !below.sheared && (in_world.sheared || cost(below) <= cost(in_world) || coupled);
    return better && !below.translation.pieces.empty() ? below : in_world;
  }

  static std::size_t cost(const ObjectKeys& k) { return k.translation.keys() + k.rotation.keys() + k.scale.keys(); }
  std::vector<Time> still() const { return {from_, until_}; }

  // Returns the knots of its tracks if these are constant after their last event; nullopt: ask for all knots.
  std::optional<std::vector<Time>> own_knots(ObjectId id) const {
    const Document& d = program_.document();
    const std::vector<TrackView> own = tracks(d, id);
    std::vector<Time> all;
    for (const TrackView& t : own) {
      if (t.extrapolation_before != "hold" || t.extrapolation_after != "hold") return std::nullopt;
      all.push_back(t.first), all.push_back(t.last);
    }
    add_events(d, own, from_, until_, all);
    return knots_between(std::move(all), from_, until_);
  }

  // Returns no pieces if the parent is singular at some time.
  ObjectKeys by_matrix(ObjectId id, ObjectId parent) {
    const std::uint32_t node = compiled_.node_of[id.index];
    bool flat = false, sheared = false;
    const auto matrix = [&, node](Time t) {
      Asking asking;
      const Mat4 world = placement(compiled_, node, t, asking).in_world();
      if (!parent) return world;
      const auto above = inverse(placement(compiled_, compiled_.node_of[parent.index], t, asking).in_world());
      flat = flat || !above;
      return above ? *above * world : world;
    };
    const auto& knots = everybodys();
    const std::int64_t frame = std::max<std::int64_t>(program_.document().rate().span(1).flicks, 1);
    for (Time t = from_; t <= until_ && !flat && !sheared; t.flicks += frame) sheared = is_sheared(matrix(t));
    for (std::size_t k = 0; k < knots.size() && !flat && !sheared; ++k) sheared = is_sheared(matrix(knots[k]));
    ObjectKeys none;
    none.id = id, none.parent = parent, none.sheared = sheared;
    if (flat || (sheared && parent)) return none;
    if (sheared) return by_parts(id, parent, matrix);
    return made(id, parent, knots, [&](Time t) {
      const Parts p = parts_of(matrix(t));
      return Place{p.way, p.growth, numbers_of(p.turn), {}};
    });
  }

  // Sheared: rotation, scale, rotation. There are many choices for both rotations, so each is the one nearest to that
  // of the time before; linear pieces, close together.
  template <class Matrix>
  ObjectKeys by_parts(ObjectId id, ObjectId parent, const Matrix& matrix) {
    ObjectKeys k;
    k.id = id, k.parent = parent, k.sheared = true;
    k.rotation = {4, true, {}}, k.inner = {4, true, {}};
    const auto& knots = everybodys();
    const std::int64_t frame = std::max<std::int64_t>(program_.document().rate().span(1).flicks, 1);
    TurnedParts last = turned_parts(matrix(from_), {});
    for (std::size_t i = 0; i + 1 < knots.size(); ++i)
      for (Time at = knots[i]; at < knots[i + 1];) {
        const Time next{std::min(at.flicks + frame, knots[i + 1].flicks)};
        last = turned_parts(matrix(at), last);
        between(k, matrix, at, next, last, 0);
        at = next;
      }
    return k;
  }
  template <class Matrix>
  void between(ObjectKeys& k, const Matrix& matrix, Time a, Time b, TurnedParts& last, int depth) {
    const Mat4 at_end = matrix(Time{b.flicks - 1});
    const TurnedParts begin = last, end = turned_parts(at_end, begin);
    const Time middle{(a.flicks + b.flicks) / 2};
    bool near = true;
    for (const double u : {0.25, 0.5, 0.75}) {
      const Time t{a.flicks + std::llround(u * static_cast<double>((b - a).flicks))};
      near = near && apart(put_together(blended(begin, end, u)), matrix(t)) < 0.5 * options_.metres;
    }
    if (!near && depth < 9 && middle > a) {
      between(k, matrix, a, middle, last, depth + 1);
      last = turned_parts(matrix(middle), last);
      return between(k, matrix, middle, b, last, depth + 1);
    }
    const auto add = [&](Channel& c, const KeyValue& from, const KeyValue& to) {
      c.pieces.push_back({from == to ? KeyPiece::held : KeyPiece::straight, a, b, from, to, {}, {}});
    };
    const auto three = [](Vec3 v) { return KeyValue{v.x, v.y, v.z, 0}; };
    add(k.translation, three(begin.way), three(end.way));
    add(k.rotation, numbers_of(begin.outer), numbers_of(end.outer));
    add(k.scale, three(begin.growth), three(end.growth));
    add(k.inner, numbers_of(begin.inner), numbers_of(end.inner));
    last = end;
  }

  template <class At>
  ObjectKeys made(ObjectId id, ObjectId parent, const std::vector<Time>& knots, const At& at) {
    std::unordered_map<std::int64_t, Place> seen;
    const auto place = [&](Time t) -> const Place& {
      const auto [found, fresh] = seen.try_emplace(t.flicks);
      if (fresh) found->second = at(t);
      return found->second;
    };
    const std::uint32_t node = compiled_.node_of[id.index];
    const auto channel = [&](std::size_t width, bool turn, double tolerance, auto&& part) {
      Followed f = followed(program_.document(), width, 1.0 / links_[node] * tolerance,
                            [&](Time t) -> KeyValue { return part(place(t)); });
      f.turn = turn;
      return follow(f, knots, options_);
    };
    const auto three = [](Vec3 v) { return KeyValue{v.x, v.y, v.z, 0}; };
    ObjectKeys k;
    k.id = id, k.parent = parent;
    double least = 1;
    for (const Time t : {from_, Time{(from_.flicks + until_.flicks) / 2}, until_}) {
      const Vec3 growth = place(t).scale;
      least = std::min({least, std::abs(growth.x), std::abs(growth.y), std::abs(growth.z)});
    }
    k.translation =
        channel(3, false, options_.metres / above_[node], [&](const Place& p) { return three(p.translation); });
    k.rotation = channel(4, true, options_.radians / reach_[node], [&](const Place& p) { return p.rotation; });
    k.scale = channel(3, false, options_.metres / std::max(reach_[node], above_[node]) * std::max(least, 0.05),
                      [&](const Place& p) { return three(p.scale); });
    return k;
  }

  const Program& program_;
  const Compiled& compiled_;
  const Time from_, until_;
  const KeyOptions& options_;
  static constexpr std::uint32_t deepest = 100;
  std::vector<std::uint8_t> moved_;  // by node
  // By node too: the length of its longest chain, the reach of its descendants, the scale of all its parents.
  std::vector<double> links_, reach_, above_;
  std::vector<Time> everybodys_;
};

}  // namespace

std::vector<ObjectKeys> motion_keys(const Program& program, Time from, Time until, const KeyOptions& options) {
  return Stage(program, from, std::max(until, Time{from.flicks + 1}), options).all();
}

Channel value_keys(const Program& program, const Target& target, Time from, Time until, const KeyOptions& options) {
  const Document& d = program.document();
  const auto read = [&](Time t) -> std::optional<KeyValue> {
    const Value v = program.read(target, t);
    if (const auto* color = std::get_if<Color>(&v)) {
      const Vec3 light = to_linear(*color);
      return KeyValue{light.x, light.y, light.z, 0};
    }
    if (const auto* turn = std::get_if<Quat>(&v)) return numbers_of(*turn);
    const std::vector<double> n = numbers(v);
    if (n.empty() || n.size() > 4) return std::nullopt;
    KeyValue out{};
    std::copy(n.begin(), n.end(), out.begin());
    return out;
  };
  if (!read(from)) return {0, false, {}};
  until = std::max(until, Time{from.flicks + 1});
  std::unordered_map<std::int64_t, KeyValue> seen;
  const Value first = program.read(target, from);
  Followed f = followed(d, numbers(first).size(), options.radians, [&](Time t) {
    const auto [found, fresh] = seen.try_emplace(t.flicks);
    if (fresh) found->second = read(t).value_or(KeyValue{});
    return found->second;
  });
  f.turn = std::holds_alternative<Quat>(first);
  std::vector<Time> all;
  bool alone = true;
  for (const TrackView& t : tracks(d, target)) {
    alone = alone && t.extrapolation_before == "hold" && t.extrapolation_after == "hold";
    add_events(d, {t}, from, until, all);
  }
  const Binding& binding = program.compiled().find(target.object.index, target.function);
  const bool stored = !target.query() && !target.velocity && binding.live < 0;
  if (stored && !binding.varies()) return {f.width, f.turn, {{KeyPiece::held, from, until, f.at(from), f.at(from)}}};
  if (!stored || !alone) all = all_knots(program, from, until);
  return follow(f, knots_between(std::move(all), from, until), options);
}

}  // namespace betwixt
