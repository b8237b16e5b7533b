// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "program/needed.h"

#include <algorithm>
#include <utility>

#include "program/placing.h"

namespace betwixt {
namespace {

bool is_hand(const Node& n) { return n.reaches > 0; }

// Collects the nodes that one node depends on.
struct Following {
  const Program::Compiled& c;
  Time t;
  Asking& asking;
  Needed out;
  std::vector<std::pair<std::uint32_t, bool>> left;  // nodes to visit, and whether their rotation is needed

  std::int32_t above(std::uint32_t node) const {
    const CompiledSpan h = held(c, node, t, asking);
    return h.kind >= AttachmentKind::hang ? h.parent : -1;
  }
  void need(std::uint32_t node, bool turned) {
    std::vector<bool>& known = turned ? out.turns : out.places;
    if (known[node]) return;
    known[node] = true;
    left.emplace_back(node, turned);
  }
  void need_aim(const Value& v) {
    const auto* id = std::get_if<ObjectId>(&v);
    if (const auto node = id ? c.node_of_object(*id) : std::nullopt) need(*node, false);
  }
  // Adds the objects that it aims at now.
  void need_aims(std::uint32_t node, FunctionId f) {
    const Binding& b = c.find(c.nodes[node].object, f);
    if (b.live >= 0) return need_aim(c.live_value(b.live, t, asking));
    if (b.channels > 0) return;
    if (b.steps < 0) return need_aim(b.constant);
    const Between w = c.between(b, t, asking);
    const auto values = c.steps_of(b).values();
    need_aim(values[w.a]), need_aim(values[w.b]);
  }
  void follow(std::uint32_t node, bool turned) {
    const Node& n = c.nodes[node];
    need(node, turned ? false : !turns_in_place(c, n));
    if (!turned)
      if (const std::int32_t parent = above(node); parent >= 0) need(static_cast<std::uint32_t>(parent), true);
    if (!turned || !n.looks) return;
    out.aims[node] = true;
    need_aims(node, fn::look_at);
  }
  bool bends_any(std::uint32_t hand) const {
    std::int32_t joint = above(hand);
    for (std::size_t bone = 0; bone < c.nodes[hand].reaches && joint >= 0; ++bone) {
      const auto node = static_cast<std::uint32_t>(joint);
      if (out.places[node]) return true;
      joint = above(node);
    }
    return false;
  }
  // Adds the inverse-kinematics chains that turn needed nodes. Returns true if there were new ones.
  bool hands(std::vector<bool>& known) {
    bool more = false;
    for (std::uint32_t hand = 0; hand < c.nodes.size(); ++hand) {
      if (!is_hand(c.nodes[hand]) || known[hand] || !bends_any(hand)) continue;
      known[hand] = out.aims[hand] = more = true;
      need(hand, true);
      need_aims(hand, fn::reach), need_aims(hand, fn::reach_pole);
    }
    return more;
  }
  void all() {
    const bool any_hand = std::any_of(c.nodes.begin(), c.nodes.end(), is_hand);
    std::vector<bool> known(any_hand ? c.nodes.size() : 0);
    do {
      while (!left.empty()) {
        const auto [node, turned] = left.back();
        left.pop_back();
        follow(node, turned);
      }
    } while (any_hand && hands(known));
    out.held = any_hand ? std::vector<bool>(c.nodes.size(), true) : out.places;
    if (!any_hand && !c.held_by_code.empty()) order();
  }
  // The order in which eyes turn depends on their parents.
  void order() {
    for (const std::uint32_t eye : c.eyes)
      for (auto i = static_cast<std::int32_t>(eye); i >= 0; i = above(static_cast<std::uint32_t>(i)))
        out.held[static_cast<std::size_t>(i)] = true;
  }
};

}  // namespace

bool turns_in_place(const CompiledFilm& c, const Node& n) {
  if (n.transform || n.drive >= 0) return false;
  const Binding& pivot = c.find(n.object, fn::pivot);
  return !pivot.varies() && vec3(&c.rest[pivot.offset]) == Vec3{};
}

bool Needed::wants(const Schedule::LiveSource& live) const {
  if (live.affects & affects::aim) return aims[live.node];
  if (!(live.affects & affects::place)) return false;
  const FunctionId f = live.binding->function;
  return f == fn::rotation || f == fn::scale ? turns[live.node] : places[live.node];
}

Needed needed(const Program::Compiled& c, std::span<const std::uint32_t> nodes, bool turned, Time t, Asking& asking) {
  const std::vector<bool> none(c.nodes.size());
  Following f{c, t, asking, {none, none, none, none}, {}};
  for (const std::uint32_t node : nodes) f.need(node, turned);
  f.all();
  return std::move(f.out);
}

}  // namespace betwixt
