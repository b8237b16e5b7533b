// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Nodes: the parents and environments of each object, and from which time on.
#include <algorithm>
#include <cmath>
#include <tuple>
#include <unordered_map>

#include "base/cancellation.h"
#include "program/compile.h"
#include "scene/formula_parts.h"

namespace betwixt {
namespace {

struct NodeCompiler {
  CompiledFilm& compiled;
  const Scene& scene = compiled.document.scene();

  // Returns the environments that a function of the object names, one entry for each event that changes them.
  std::int32_t siting(std::uint32_t object, FunctionId f) {
    const Object& o = scene.objects[object];
    Siting made;
    if (const Binding& b = compiled.find(object, f); b.live >= 0) {
      made.live = b.live, compiled.computes_sitings = true;
      compiled.sitings.push_back(std::move(made));
      return static_cast<std::int32_t>(compiled.sitings.size()) - 1;
    }
    for (const EnvironmentsFrom& e : environments_of(scene, o, f)) {
      made.changes.push_back({e.from, {}});
      for (const Generation& g : e.all) made.changes.back().sites.push_back(site(g.environment.index, g.number));
    }
    if (made.changes.empty()) return -1;
    std::size_t hash = made.changes.size();
    for (const Siting::Change& c : made.changes) {
      hash = hash * 31 + std::hash<std::int64_t>{}(c.from.flicks);
      for (const Site& s : c.sites) hash = hash * 31 + s.member;
    }
    const auto [first, last] = siting_index.equal_range(hash);
    for (auto at = first; at != last; ++at)
      if (compiled.sitings[static_cast<std::size_t>(at->second)].changes == made.changes) return at->second;
    const auto number = static_cast<std::int32_t>(compiled.sitings.size());
    siting_index.emplace(hash, number);
    compiled.sitings.push_back(std::move(made));
    return number;
  }
  std::unordered_multimap<std::size_t, std::int32_t> siting_index{};  // equal sitings share one number
  Site site(std::uint32_t object, int generation) {
    const auto [at, fresh] =
        environment_index.emplace(object, static_cast<std::uint32_t>(compiled.environments.size()));
    if (fresh) compiled.environments.push_back(scene.objects[object].environment);
    const auto [member, first] =
        member_index.emplace(std::pair(at->second, generation), static_cast<std::uint32_t>(members.size()));
    if (first) members.push_back({compiled.environments[at->second], generation});
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
    const auto offset = [&](FunctionId f) { return compiled.find(object, f).offset; };
    n.on_axes = compiled.find(object, fn::placed).live >= 0;
    n.position = offset(n.on_axes ? fn::placed : fn::position), n.rotation = offset(fn::rotation),
    n.scale = offset(fn::scale);
    n.pivot = offset(fn::pivot), n.attach = offset(fn::attach_position), n.display = offset(fn::display),
    n.color = compiled.find_shown(object, fn::color).offset;
    n.orientation = compiled.find(object, fn::rotation).orientation;
    n.around = siting(object, fn::environments), n.drive = siting(object, fn::drive);
    n.transform = o.find(fn::transform) != nullptr;
    compiled.offsets.push_back({n.position, n.rotation, n.scale, n.pivot, n.orientation});
    const auto said = [&](FunctionId f) { return &compiled.find(object, f) != &compiled.defaults[f]; };
    n.looks = said(fn::look_at) || said(fn::roll);
    if (said(fn::reach)) {  // for the whole film, because the number of joints does not change
      double bones[4] = {2};
      const Binding& chain = compiled.find(object, fn::reach_chain);
      if (chain.live < 0) compiled.evaluate_curves(chain, {}, bones);
      n.reaches = static_cast<std::uint8_t>(std::clamp(std::round(bones[0]), 1.0, 64.0));
    }
    compiled.looks = compiled.looks || n.looks || n.reaches;
    compiled.sited = compiled.sited || n.around >= 0;
    compiled.node_of[object] = static_cast<std::uint32_t>(compiled.nodes.size());
    compiled.nodes.push_back(std::move(n));
  }

  // Finds the parts of formulas, which the bindings of their looks depend on.
  void pieces_of_formulas() {
    for (std::uint32_t i = 0; i < scene.objects.size(); ++i) {
      const Object& o = scene.objects[i];
      const std::string* const key = o.removed ? nullptr : shown_part(o);
      const ObjectId whole = key ? formula_of_part(scene, o) : ObjectId{};
      if (!whole) continue;
      compiled.pieces_of_formulas[i] = {whole.index, Text(*key)};
      std::string& all = apart[whole.index];
      all += (all.empty() ? "" : "\n") + *key;
    }
    for (auto& [object, keys] : apart) compiled.apart[object] = Text(std::move(keys));
  }
  std::map<std::uint32_t, std::string> apart{};

  void nodes() {
    compiled.node_of.assign(scene.objects.size(), ObjectId::nothing);
    for (const bool drawn : {true, false})
      for (std::uint32_t i = 0; i < scene.objects.size(); ++i)
        if (const Object& o = scene.objects[i]; !o.removed && !o.environment && drawable(o.kind) == drawn)
          Cancellation::check(), node(i);
    spans();
  }

  // Takes the attachments of all objects in the order of time. Leaves out one that would close a cycle with those in
  // force. At equal times, releases come before new attachments.
  void spans() {
    struct Happening {
      Time time;
      bool takes;
      std::uint32_t node;
      Attachment what;
      bool computed;
    };
    std::vector<Happening> all;
    for (std::uint32_t i = 0; i < compiled.nodes.size(); ++i)
      for (const AttachmentSpan& a : attachments(scene.objects[compiled.nodes[i].object]))
        if (a.from.flicks != INT64_MIN || a.to.kind >= AttachmentKind::hang || a.computed)
          all.push_back(
              {a.from, a.to.kind >= AttachmentKind::hang && find_object(scene, a.to.parent), i, a.to, a.computed});
    std::stable_sort(all.begin(), all.end(), [&](const Happening& a, const Happening& b) {
      return std::tuple(a.time, a.takes, compiled.nodes[a.node].object) <
             std::tuple(b.time, b.takes, compiled.nodes[b.node].object);
    });
    std::vector<std::int32_t> above(compiled.nodes.size(), -1);
    std::vector<bool> leads(compiled.nodes.size());
    std::vector<std::pair<std::uint32_t, CompiledSpan>> kept;
    for (const Happening& h : all) {
      CompiledSpan span;
      span.from = h.time;
      span.computed = h.computed;
      span.kind = h.takes ? h.what.kind : h.what.kind >= AttachmentKind::hang ? AttachmentKind::detach : h.what.kind;
      if (h.takes) {
        span.parent = static_cast<std::int32_t>(compiled.node_of[h.what.parent.index]);
        bool round = span.parent == static_cast<std::int32_t>(h.node);
        if (leads[h.node])
          for (std::int32_t at = span.parent; at >= 0 && !round; at = above[static_cast<std::size_t>(at)])
            round = at == static_cast<std::int32_t>(h.node);
        if (round) {
          const auto name = [&](std::uint32_t node) { return scene.objects[compiled.nodes[node].object].name; };
          compiled.notices.push_back("'" + name(h.node) + "' cannot have the parent '" +
                                     name(static_cast<std::uint32_t>(span.parent)) +
                                     "', which is below it at that time: this attachment is left out");
          continue;
        }
        leads[static_cast<std::size_t>(span.parent)] = true;
        span.one_body = compiled.one_body(h.node, static_cast<std::uint32_t>(span.parent));
      }
      above[h.node] = span.parent;
      if (h.what.kind == AttachmentKind::letgo || (h.takes && h.what.keep_world)) {
        span.frozen = static_cast<std::int32_t>(frozen.size());
        frozen.emplace_back();
        frozen.back().node = h.node;
      }
      compiled.turning = compiled.turning || span.frozen >= 0 || span.kind == AttachmentKind::attach || h.computed;
      kept.push_back({h.node, span});
    }
    for (const auto& k : kept)
      if (k.second.frozen >= 0) frozen_by_time.push_back(k.second.frozen);
    std::stable_sort(kept.begin(), kept.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    for (const auto& [node, span] : kept) {
      Node& n = compiled.nodes[node];
      if (n.spans == 0) n.first_span = static_cast<std::uint32_t>(compiled.spans.size());
      if (span.frozen >= 0) frozen[static_cast<std::size_t>(span.frozen)].span = static_cast<std::int32_t>(n.spans);
      ++n.spans;
      if (span.computed && (compiled.held_by_code.empty() || compiled.held_by_code.back() != node))
        compiled.held_by_code.push_back(node);
      compiled.spans.push_back(span);
    }
  }
  std::vector<Frozen> frozen{};
  std::vector<std::int32_t> frozen_by_time{};  // indices
};

}  // namespace

void compile_nodes(Program::Compiled& compiled, const CompiledFilm* before) {
  NodeCompiler made{compiled};
  made.pieces_of_formulas();
  made.nodes();
  constexpr std::size_t many = 1024;  // for fewer, the setup costs more than it saves
  if (made.members.size() >= many && !made.scene.smooth_ticks)
    compiled.caches.environments.set.emplace(std::move(made.members));
  compiled.frozen = std::move(made.frozen);
  find_joints(compiled);
  compile_motions(compiled);
  compile_schedule(compiled, before);
  settle(compiled, made.frozen_by_time);
}

}  // namespace betwixt
