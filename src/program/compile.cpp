// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <tuple>

#include "program/code.h"
#include "track/operations.h"

namespace betwixt {
namespace {

struct Compiler {
  Program::Compiled& code;
  const Scene& scene;

  // Room for a constant of a type in the array of numbers; colours become light.
  Binding place(FunctionId f, const Value& v, Type type) {
    Binding b;
    b.function = f;
    b.constant = v;
    if (!numeric(v)) return b;
    double n[4];
    const int count = held_numbers(v, false, n);
    b.channels = static_cast<std::uint8_t>(std::min(count, row_of(type).channels));
    b.orientation = std::holds_alternative<Quat>(v);
    b.offset = static_cast<std::uint32_t>(code.rest.size());
    code.rest.insert(code.rest.end(), n, n + 4);  // always four: a rotation's curve may want them
    return b;
  }

  static bool scripted(const Value& v) { return std::holds_alternative<Procedure>(v); }
  static bool scripted(const Track& t) {
    bool any = false;
    t.events.each([&](const Event& e) {
      any = any || scripted(e.value) || (e.detail && e.detail->before && scripted(*e.detail->before));
    });
    return any;
  }
  template <class F>
  static void each_track(const Strand& s, F&& f) {
    if (s.components.empty()) f(*s.track);
    for (const auto& c : s.components) f(*c);
  }
  static bool empty(const Strand& s) {
    bool any = false;
    each_track(s, [&](const Track& t) { any = any || !t.events.empty(); });
    return !any;
  }
  // Not just a track: it takes asking others, adding up, or more than one.
  bool alive(const Slot& slot) const {
    bool any = scripted(slot.set.value_or(spec_of(scene, slot.function).rest)) || !slot.filters.empty() ||
               !empty(slot.velocity);
    each_track(slot, [&](const Track& t) { any = any || scripted(t); });
    return any;
  }

  static bool has_values(const Track& t) {
    bool any = false;
    t.events.each([&](const Event& e) { any = any || !e.keep; });
    return any;
  }
  static bool all_numeric(const Track& t) {
    bool all = true;
    t.events.each([&](const Event& e) {
      all = all && (e.keep || numeric(e.value)) && (!e.detail || !e.detail->before || numeric(*e.detail->before));
    });
    return all;
  }

  Binding bind(const Slot& slot) {
    const FunctionSpec& spec = spec_of(scene, slot.function);
    Binding b = place(slot.function, slot.set.value_or(spec.rest), spec.type);
    b.first_curve = static_cast<std::uint32_t>(code.curves.size());
    const auto add = [&](const Track& track, Type type, std::uint32_t offset, bool component = false) {
      code.curves.push_back(
          {code.set.add(track, type, component), offset, spec.low > -1e300 || spec.high < 1e300, spec.low, spec.high});
      ++b.curves;
    };
    const auto point = [&] {
      b = place(slot.function, Vec3{}, spec.type);
      b.first_curve = static_cast<std::uint32_t>(code.curves.size());
    };
    for (std::size_t i = 0; i < slot.components.size(); ++i) {
      const Track& t = *slot.components[i];
      if (b.channels == 0 && has_values(t)) point();  // an aim at an object gives way to numbers
      if (has_values(t)) add(t, component_track_type(spec.type), b.offset + static_cast<std::uint32_t>(i), true);
    }
    if (!has_values(*slot.track)) return b;
    if (!all_numeric(*slot.track) || (b.channels == 0 && row_of(spec.type).channels == 0)) {
      b.steps = static_cast<std::int32_t>(code.steps.size());
      b.channels = 0;
      code.steps.emplace_back(*slot.track, spec.type);
      return b;
    }
    if (b.channels == 0) point();
    // Events that are all points of the world are a vector's; the same twerpers suit them.
    add(*slot.track, spec.type == Type::aim ? Type::vector : spec.type, b.offset);
    b.channels = code.curves.back().curve.channels;
    b.orientation = code.curves.back().curve.orientation;
    return b;
  }

  // Whether a rotation is held as orientations: some event says so, or the turning goes about an axis.
  bool turns(const Slot& slot, Type type) const {
    if (row_of(type).changes != Changes::by_turning) return false;
    bool any =
        std::holds_alternative<Quat>(row_of(type).example()) || (slot.set && std::holds_alternative<Quat>(*slot.set));
    each_track(slot, [&](const Track& t) {
      t.events.each([&](const Event& e) { any = any || std::holds_alternative<Quat>(e.value); });
    });
    each_track(slot.velocity, [&](const Track& t) {
      t.events.each([&](const Event& e) { any = any || std::holds_alternative<Vec3>(e.value); });
    });
    return any;
  }

  // The pieces of time of one track with a velocity track beside it (R-T5).
  std::vector<Piece> pieces(LivePart& part, const Track& primary, const Track& velocity) {
    std::vector<Piece> out;
    const bool component = part.component >= 0;
    const bool is_scripted = scripted(primary) || scripted(part.rest);
    const auto add_primary = [&](Time from, const Track& track) {
      Piece p;
      p.from = from;
      p.scripted = is_scripted;
      if (!is_scripted && has_values(track)) p.primary = code.set.add(track, part.type, component);
      out.push_back(std::move(p));
    };
    add_primary({INT64_MIN}, primary);
    Track reign;
    reign.global = velocity.global, reign.bezier = velocity.bezier;
    const auto close = [&](std::optional<Time> release) {
      if (reign.events.empty()) return;
      reign.after = release ? Extrapolation::hold : velocity.after;
      Piece p;
      p.from = reign.events.front().time;
      p.reign = static_cast<std::int32_t>(code.reigns.size());
      // Rates are added up as the author writes them: as plain vectors, colours and angles too.
      Track rates = reign;
      rates.events = {};
      reign.events.each([&](Event e) {
        const auto plain = [](Value& v) {
          if (const auto* c = std::get_if<Color>(&v)) v = Vec3{c->r, c->g, c->b};
          if (const auto* a = std::get_if<Angles>(&v)) v = a->xyz;
        };
        plain(e.value);
        if (e.detail->before) plain(*e.detail.edit().before);
        if (e.detail->tangent_in) plain(*e.detail.edit().tangent_in);
        if (e.detail->tangent_out) plain(*e.detail.edit().tangent_out);
        rates.events.put(std::move(e));
      });
      const Type type = component ? Type::scalar : row_of(part.type).rate.value_or(part.type);
      code.reigns.emplace_back(code.set, code.set.add(rates, type), part.orientation);
      out.push_back(p);
      reign.events = {};
      if (!release) return;
      // From the release on the primary track goes from what was reached to its next event.
      Track rest = primary;
      rest.events = {};
      const Event* last = nullptr;
      std::vector<Event> all;
      primary.events.each([&](const Event& e) { all.push_back(e); });
      for (const Event& e : all) {
        if (e.time < *release) last = &e;
        if (e.time >= *release) rest.events.put(e);
      }
      if (is_scripted || !has_values(rest)) {
        Piece held;  // nothing comes: what was reached stays
        held.from = *release;
        held.scripted = is_scripted;
        out.push_back(held);
        return;
      }
      Asking asking;
      Live live{object, function, {}};
      code.lives.push_back(std::move(live));
      LiveStrand strand;
      strand.parts.push_back(part);
      strand.parts[0].pieces = out;
      code.lives.back().strands.push_back(std::move(strand));
      LivePart& probe = code.lives.back().strands[0].parts[0];
      probe.component = -1;  // its value alone is asked for
      probe.type = part.value_type();
      const Value reached = code.live_value(static_cast<std::int32_t>(code.lives.size()) - 1, *release, asking);
      code.lives.pop_back();
      Event e;
      e.time = *release;
      e.value = reached;
      e.twerper = last ? last->twerper : Twerper::unset;
      if (last && last->twerper == Twerper::bezier) e.detail.edit().bezier = last->detail->bezier;
      if (const Event* there = rest.events.find(*release); there && !there->keep) {  // the author says where to go on
        Event cut = *there;
        cut.detail.edit().before = reached;
        e = std::move(cut);
      }
      rest.events.put(std::move(e));
      add_primary(*release, rest);
    };
    velocity.events.each([&](const Event& e) {
      if (e.release) {
        close(e.time);
      } else {
        reign.events.put(e);
      }
    });
    close(std::nullopt);
    return out;
  }
  LiveStrand strand(const Slot& slot) {
    const FunctionSpec& spec = spec_of(scene, slot.function);
    LiveStrand out;
    out.layer = slot.layer;
    out.filters = slot.filters;
    // What a layer adds is nothing until it says something.
    out.set = slot.set.value_or(spec.rest);
    if (slot.layer) {
      const auto mode = scene.objects[slot.layer.index].find(fn::mode);
      out.mix = mode && mode->set && *std::get<Text>(*mode->set) == "mix";
      if (!slot.set && !out.mix && numeric(out.set)) out.set = *add_scaled_or(out.set);
    }
    bool plain = empty(slot.velocity) && !scripted(out.set);
    each_track(slot, [&](const Track& t) { plain = plain && !scripted(t); });
    if (plain) {
      Slot alone = slot;
      alone.set = out.set;
      out.plain = static_cast<std::int32_t>(code.plains.size());
      code.plains.push_back(bind(alone));
      return out;
    }
    const bool orientation = turns(slot, spec.type);
    const bool parts = !slot.components.empty() || !slot.velocity.components.empty();
    const auto add = [&](const Track& primary, const Track& velocity, int component) {
      LivePart part;
      part.component = component;
      part.type = component < 0 ? spec.type : component_track_type(spec.type);
      part.orientation = orientation && component < 0;
      part.track = primary;
      part.rest = component < 0 || scripted(out.set) ? out.set : Value(component_of(out.set, component));
      if (!velocity.events.empty()) part.pieces = pieces(part, primary, velocity);
      if (part.pieces.empty() && !scripted(primary) && !has_values(primary) && component >= 0) return;
      out.parts.push_back(std::move(part));
    };
    if (!parts) {
      add(*slot.track, *slot.velocity.track, -1);
      return out;
    }
    const Strand primary = split_into_components(slot, spec.type);
    const Strand velocity = split_into_components(slot.velocity, spec.type);
    for (std::size_t i = 0; i < primary.components.size(); ++i)
      add(*primary.components[i], *velocity.components[i], static_cast<int>(i));
    return out;
  }
  static std::optional<Value> add_scaled_or(const Value& v) {  // nothing, of the same kind
    if (std::holds_alternative<Quat>(v)) return Value(Quat{});
    if (std::holds_alternative<bool>(v)) return v;
    return add_scaled(v, v, -1);
  }

  Binding bind_live(const Object& o, FunctionId f) {
    const FunctionSpec& spec = spec_of(scene, f);
    static const Slot nothing;
    Live live{object, f, {}};
    function = f;
    const Slot* own = o.find(f);
    Slot base = own ? *own : nothing;
    base.function = f;
    live.strands.push_back(strand(base));
    for (const Slot& slot : o.slots)
      if (slot.function == f && slot.layer && find_object(scene, slot.layer)) live.strands.push_back(strand(slot));
    const Value& rest = base.set.value_or(spec.rest);
    Value example = scripted(rest) ? spec.rest : rest;
    if (scripted(example)) example = row_of(spec.type).example();
    if (spec.type == Type::aim) example = ObjectId{};  // may be either, at any time
    Binding b = place(f, example, spec.type);
    b.orientation = row_of(spec.type).changes == Changes::by_turning;
    if (b.orientation) b.channels = 4;
    b.live = static_cast<std::int32_t>(code.lives.size());
    code.lives.push_back(std::move(live));
    return b;
  }
  void bindings() {
    const auto functions = static_cast<FunctionId>(built_in_functions().size() + scene.defined->size());
    std::vector<FunctionId> computed;  // functions of the author's whose value at rest is code
    for (FunctionId f = 0; f < functions; ++f) {
      const FunctionSpec& spec = spec_of(scene, f);
      if (scripted(spec.rest)) computed.push_back(f);
      code.defaults.push_back(place(f, scripted(spec.rest) ? row_of(spec.type).example() : spec.rest, spec.type));
      if (!spec.shape) continue;
      for (const KindRow& row : kinds())
        if (spec.kinds & bit(row.kind)) code.shaping[row.kind].push_back(f);
    }
    code.first_binding.reserve(scene.objects.size() + 1);
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
      code.first_binding.push_back(static_cast<std::uint32_t>(code.bindings.size()));
      const Object& o = scene.objects[i];
      object = static_cast<std::uint32_t>(i);
      std::vector<FunctionId> own;
      for (const Slot& slot : o.slots)
        if (own.empty() || own.back() != slot.function) own.push_back(slot.function);
      if (!o.removed && !computed.empty()) {
        std::vector<FunctionId> both;
        std::set_union(own.begin(), own.end(), computed.begin(), computed.end(), std::back_inserter(both));
        own = std::move(both);
      }
      for (const FunctionId f : own) {
        const Slot* slot = o.find(f);
        bool live = slot ? alive(*slot) : scripted(spec_of(scene, f).rest);
        for (const Slot& other : o.slots) live = live || (other.function == f && find_object(scene, other.layer));
        code.bindings.push_back(live ? bind_live(o, f) : bind(*slot));
      }
    }
    code.first_binding.push_back(static_cast<std::uint32_t>(code.bindings.size()));
  }
  std::uint32_t object = 0;  // being bound
  FunctionId function = 0;

  bool shape_varies(std::uint32_t object) const {
    for (auto i = code.first_binding[object]; i < code.first_binding[object + 1]; ++i) {
      const Binding& b = code.bindings[i];
      if (b.varies() && spec_of(scene, b.function).shape) return true;
    }
    return false;
  }

  // The environments that a function of the object's names, from the event on that names them.
  std::int32_t siting(const Object& o, FunctionId f) {
    Siting made;
    for (const EnvironmentsFrom& e : environments_of(scene, o, f)) {
      made.changes.push_back({e.from, {}});
      for (const Generation& g : e.all) made.changes.back().sites.push_back(site(g.environment.index, g.number));
    }
    if (made.changes.empty()) return -1;
    code.sitings.push_back(std::move(made));
    return static_cast<std::int32_t>(code.sitings.size()) - 1;
  }
  Site site(std::uint32_t object, int generation) {
    const auto [at, fresh] = environment_index.emplace(object, static_cast<std::uint32_t>(code.environments.size()));
    if (fresh) code.environments.push_back(scene.objects[object].environment);
    const auto [member, first] =
        member_index.emplace(std::pair(at->second, generation), static_cast<std::uint32_t>(members.size()));
    if (first) members.push_back({code.environments[at->second], generation});
    return {at->second, generation, member->second};
  }
  std::unordered_map<std::uint32_t, std::uint32_t> environment_index{};
  std::map<std::pair<std::uint32_t, int>, std::uint32_t> member_index{};
  std::vector<EnvironmentSet::Member> members{};

  void node(std::uint32_t object) {
    const Object& o = scene.objects[object];
    Node n;
    n.object = object;
    n.kind = o.kind;
    const auto offset = [&](FunctionId f) { return code.find(object, f).offset; };
    n.position = offset(fn::position), n.rotation = offset(fn::rotation), n.scale = offset(fn::scale);
    n.pivot = offset(fn::pivot), n.attach = offset(fn::attach_position), n.display = offset(fn::display),
    n.color = offset(fn::color);
    n.orientation = code.find(object, fn::rotation).orientation;
    n.around = siting(o, fn::environments), n.drive = siting(o, fn::drive);
    n.transform = o.find(fn::transform) != nullptr;
    code.sited = code.sited || n.around >= 0;
    if (drawable(o.kind) && !shape_varies(object)) {
      Asking asking;
      n.shape = std::make_shared<const Shape>(code.shape(object, {}, code.rest.data(), asking));
    }
    code.node_of[object] = static_cast<std::uint32_t>(code.nodes.size());
    code.nodes.push_back(std::move(n));
  }

  void nodes() {
    code.node_of.assign(scene.objects.size(), ObjectId::nothing);
    for (std::uint32_t i = 0; i < scene.objects.size(); ++i)
      if (!scene.objects[i].removed) node(i);
    constexpr std::size_t many = 1024;  // below, setting them up costs more than it saves
    if (members.size() >= many && !scene.smooth_ticks) code.many.emplace(std::move(members));
    hands();
  }

  // Attachments in the order of time, over all objects: one that would close a circle with those in force then is left
  // out (R-H6). At one time, what lets go does so before anything takes hold.
  void hands() {
    struct Happening {
      Time time;
      bool takes;
      std::uint32_t node;
      Attachment what;
    };
    std::vector<Happening> all;
    for (std::uint32_t i = 0; i < code.nodes.size(); ++i)
      for (const AttachmentSpan& a : attachments(scene.objects[code.nodes[i].object]))
        if (a.from.flicks != INT64_MIN || a.to.hold >= Hold::hang)
          all.push_back({a.from, a.to.hold >= Hold::hang && find_object(scene, a.to.parent), i, a.to});
    std::stable_sort(all.begin(), all.end(), [](const Happening& a, const Happening& b) {
      return std::tuple(a.time, a.takes, a.node) < std::tuple(b.time, b.takes, b.node);
    });
    std::vector<std::int32_t> above(code.nodes.size(), -1);
    std::vector<bool> leads(code.nodes.size());
    std::vector<std::pair<std::uint32_t, Hand>> kept;
    for (const Happening& h : all) {
      Hand hand;
      hand.from = h.time;
      hand.hold = h.takes ? h.what.hold : h.what.hold >= Hold::hang ? Hold::detach : h.what.hold;
      if (h.takes) {
        hand.parent = static_cast<std::int32_t>(code.node_of[h.what.parent.index]);
        bool round = hand.parent == static_cast<std::int32_t>(h.node);
        if (leads[h.node])
          for (std::int32_t at = hand.parent; at >= 0 && !round; at = above[static_cast<std::size_t>(at)])
            round = at == static_cast<std::int32_t>(h.node);
        if (round) {
          const auto name = [&](std::uint32_t node) { return scene.objects[code.nodes[node].object].name; };
          code.notices.push_back("'" + name(h.node) + "' cannot hang on '" +
                                 name(static_cast<std::uint32_t>(hand.parent)) +
                                 "', which hangs on it at that time: this attachment is left out");
          continue;
        }
        leads[static_cast<std::size_t>(hand.parent)] = true;
      }
      above[h.node] = hand.parent;
      if (h.what.hold == Hold::letgo || (h.takes && h.what.keep_world)) {
        hand.frozen = static_cast<std::int32_t>(code.frozen.size());
        code.frozen.emplace_back();
        code.frozen.back().node = h.node;
      }
      kept.push_back({h.node, hand});
    }
    std::vector<std::int32_t> in_time;  // frozen ones, as they come
    for (const auto& k : kept)
      if (k.second.frozen >= 0) in_time.push_back(k.second.frozen);
    std::stable_sort(kept.begin(), kept.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    for (const auto& [node, hand] : kept) {
      Node& n = code.nodes[node];
      if (n.hands == 0) n.first_hand = static_cast<std::uint32_t>(code.hands.size());
      if (hand.frozen >= 0)
        code.frozen[static_cast<std::size_t>(hand.frozen)].hand = static_cast<std::int32_t>(n.hands);
      ++n.hands;
      code.hands.push_back(hand);
    }
    compile_motions(code, in_time);
  }
};

}  // namespace

const Binding& Program::Compiled::find(std::uint32_t object, FunctionId f) const {
  const auto first = bindings.begin() + first_binding[object], last = bindings.begin() + first_binding[object + 1];
  const auto at = std::lower_bound(first, last, f, [](const Binding& b, FunctionId id) { return b.function < id; });
  return at != last && at->function == f ? *at : defaults[f];
}

Program Program::compile(const Document& document) {
  auto code = std::make_shared<Compiled>(document);
  for (const NamedProcedure& p : *document.scene().procedures)
    code->set.own.push_back(p.role == Role::twerper ? p.code : nullptr);
  Compiler compiler{*code, document.scene()};
  compiler.bindings();
  compiler.nodes();
  Program p;
  p.code_ = std::move(code);
  return p;
}

const Document& Program::document() const { return code_->document; }

}  // namespace betwixt
