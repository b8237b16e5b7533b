// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Nodes: what each object hangs on and which environments it is in, from when on.
#include <algorithm>
#include <tuple>
#include <unordered_map>

#include "program/compile.h"

namespace betwixt {
namespace {

struct NodeCompiler {
  Program::Compiled& code;
  const Scene& scene = code.document.scene();

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

void compile_nodes(Program::Compiled& code) { NodeCompiler{code}.nodes(); }

}  // namespace betwixt
