// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The transforms of all nodes: those that moved, and their children.
#include <algorithm>
#include <bit>
#include <cstring>

#include "base/stages.h"
#include "program/evaluator.h"
#include "program/placing.h"

namespace betwixt {

// Sorts nodes depth first, so that a subtree is an interval.
void Evaluator::arrange() {
  const std::size_t n = compiled_.nodes.size();
  constexpr std::uint32_t none = nothing;
  std::vector<std::uint32_t> child(n, none), sibling(n, none), roots;
  for (std::uint32_t i = 0; i < n; ++i)
    parent_[i] = held_[i] && held_[i]->kind >= AttachmentKind::hang ? held_[i]->parent : -1;
  for (std::uint32_t i = static_cast<std::uint32_t>(n); i-- > 0;) {
    if (parent_[i] < 0) continue;
    std::uint32_t& first = child[static_cast<std::size_t>(parent_[i])];
    sibling[i] = std::exchange(first, i);
  }
  order_.clear(), order_.reserve(n);
  at_.resize(n), size_.assign(n, 1), body_.resize(n);
  for (std::uint32_t root = 0; root < n; ++root) {
    if (parent_[root] >= 0) continue;
    for (std::uint32_t i = root; i != none;) {
      at_[i] = static_cast<std::uint32_t>(order_.size());
      order_.push_back(i);
      body_[i] = held_[i] && held_[i]->one_body ? body_[static_cast<std::size_t>(parent_[i])] : i;
      if (child[i] != none) {
        i = child[i];
        continue;
      }
      while (i != root && sibling[i] == none) i = static_cast<std::uint32_t>(parent_[i]);
      i = i == root ? none : sibling[i];
    }
  }
  for (std::size_t p = n; p-- > 0;)
    if (const std::int32_t above = parent_[order_[p]]; above >= 0)
      size_[at_[static_cast<std::size_t>(above)]] += size_[p];
  links_.resize(n);
  for (std::uint32_t k = 0; k < n; ++k) {
    const std::uint32_t node = order_[k];
    const bool plain = parent_[node] >= 0 && held_[node]->kind == AttachmentKind::couple && held_[node]->frozen < 0 &&
                       !kept_apart(node) && !compiled_.sited;
    links_[k] = {node, plain ? static_cast<std::uint32_t>(parent_[node]) : 0, compiled_.nodes[node].attach, plain};
  }
  arrange_eyes();
}

// Sorts the objects that look at something: in the order of the objects, but parents before children.
void Evaluator::arrange_eyes() {
  eyes_.clear();
  if (compiled_.eyes.empty()) return;
  std::vector<bool> is_eye(order_.size()), seen(order_.size());
  for (const std::uint32_t e : compiled_.eyes) is_eye[e] = true;
  std::vector<std::uint32_t> chain;
  for (std::uint32_t start = 0; start < order_.size(); ++start) {
    if (!is_eye[start]) continue;
    for (auto i = static_cast<std::int32_t>(start); i >= 0 && !seen[static_cast<std::size_t>(i)];
         i = parent_[static_cast<std::size_t>(i)]) {
      seen[static_cast<std::size_t>(i)] = true;
      chain.push_back(static_cast<std::uint32_t>(i));
    }
    for (; !chain.empty(); chain.pop_back())
      if (is_eye[chain.back()]) eyes_.push_back(chain.back());
  }
  arrange_reaches();
}

namespace {

Placed placed_of(const Own& own) {
  Placed p{{}, own.turn};
  for (int c = 0; c < 4; ++c)
    for (int i = 0; i < 3; ++i) p.world(i, c) = own.m[3 * c + i];
  return p;
}

Own own_of_placed(const Placed& p) {
  Own own;
  for (int c = 0; c < 4; ++c)
    for (int i = 0; i < 3; ++i) own.m[3 * c + i] = p.world(i, c);
  own.turn = p.turn;
  return own;
}

}  // namespace

Placed Evaluator::own_placed(std::uint32_t node) const { return placed_of(owns_[node]); }

// Returns the transform that the node's own tracks give.
Own Evaluator::own_of(std::uint32_t node, Asking& asking) const {
  const Node& n = compiled_.nodes[node];
  OwnTransform said = said_by(n, numbers_.data());
  if (n.transform || n.drive >= 0)
    said.own =
        driven(compiled_, n, now_, asking, n.drive >= 0 ? &products_[static_cast<std::size_t>(n.drive)] : nullptr);
  if (n.moving >= 0) said.motion = moved(compiled_, n, now_, asking);
  return own_of_placed(own_place(said));
}

void Evaluator::put_world(std::uint32_t node, const Mat4& m) {
  Mat4& was = worlds_[node];
  std::uint64_t other = 0;  // bits that differ
  for (std::size_t i = 0; i < m.m.size(); ++i)
    other |= std::bit_cast<std::uint64_t>(m.m[i]) ^ std::bit_cast<std::uint64_t>(was.m[i]);
  if (other == 0) return;
  was = m;
  if (!compiled_.sited) flags_.add(node, true);
}

// Stores a node's own transform. If nothing holds or turns the node, the transform is final. Otherwise it is kept
// apart, because the node needs it again.
void Evaluator::settle(std::uint32_t node, const Own& own) {
  if (kept(node)) {
    owns_[node] = own;
    return dirty_places_.push_back(at_[node]);
  }
  if (!turns_.empty()) turns_[node] = own.turn;
  put_world(node, placed_of(own).world);
  if (size_[at_[node]] > 1 || compiled_.sited) dirty_places_.push_back(at_[node]);
}

// Places the marked nodes, those with equal rotation types together (SIMD).
void Evaluator::place_marked(Asking& asking) {
  dirty_places_.clear();
  for (auto& alike : alike_) alike.clear();
  for (const std::uint32_t node : marks_.all()) {
    if (!(marks_[node] & (affects::place | affects::around)) || (only_ && !only_->places[node])) continue;
    if (!(marks_[node] & affects::place)) {  // only its environments have changed
      dirty_places_.push_back(at_[node]);
      continue;
    }
    if (const Node& n = compiled_.nodes[node]; n.transform || n.drive >= 0 || n.moving >= 0)
      settle(node, own_of(node, asking));
    else
      alike_[n.orientation].push_back(node);
  }
  for (const auto& alike : alike_)
    for (std::size_t first = 0; first < alike.size(); first += playing::block) {
      const auto some = std::span(alike).subspan(first, std::min(playing::block, alike.size() - first));
      Own owns[playing::block];
      playing::place(compiled_.offsets.data(), some, numbers_.data(), owns);
      for (std::size_t k = 0; k < some.size(); ++k) settle(some[k], owns[k]);
    }
}

void Evaluator::compose(std::uint32_t node) {
  const Node& n = compiled_.nodes[node];
  const CompiledSpan* h = held_[node];
  const Frozen* f = h && h->frozen >= 0 ? &compiled_.frozen[static_cast<std::size_t>(h->frozen)] : nullptr;
  const std::int32_t above = parent_[node];
  if (kept(node)) {
    Placed parent;
    if (above >= 0) parent = placed(static_cast<std::uint32_t>(above));
    const Placed p = hang(placed_of(owns_[node]), vec3(&numbers_[n.attach]), h, f, above >= 0 ? &parent : nullptr);
    if (!turns_.empty()) turns_[node] = p.turn;
    put_world(node, p.world);
  }
  if (!compiled_.sited) return;
  const Mat4* outer = above >= 0 ? &around_[static_cast<std::size_t>(above)] : f && f->held ? &f->around : nullptr;
  around_[node] = n.around >= 0 ? products_[static_cast<std::size_t>(n.around)] : Mat4{};
  if (outer) around_[node] = *outer * around_[node];
  show_sited(node);
}

// Updates a drawable's world transform, environments included.
void Evaluator::show_sited(std::uint32_t node) {
  if (!compiled_.sited || !compiled_.draws(node)) return;
  const Mat4 shown = world(node);
  if (std::memcmp(&shown, &shown_[node], sizeof shown) == 0) return;
  shown_[node] = shown;
  flags_.add(node, true);
}

// Updates the node at an index of the order, and its subtree.
void Evaluator::compose_below(std::uint32_t at) {
  for (const std::uint32_t end = at + size_[at]; at < end;) {
    std::uint32_t plain = at;
    while (plain < end && links_[plain].plain) ++plain;
    if (plain == at) {
      compose(order_[at++]);
      continue;
    }
    const auto links = std::span(links_).subspan(at, plain - at);
    playing::follow(links, numbers_.data(), owns_.data(), worlds_.data(), flags_);
    if (!turns_.empty())
      for (const playing::Link& l : links) turns_[l.node] = turns_[l.parent] * owns_[l.node].turn;
    at = plain;
  }
}

void Evaluator::places(Asking& asking) {
  const InStage stage(Stage::hierarchy);
  if (rearrange_) arrange();
  rearrange_ = false;
  place_marked(asking);
  const auto marked = marks_.all();
  const bool turning = !eyes_.empty() && std::any_of(marked.begin(), marked.end(), [&](std::uint32_t node) {
    return marks_[node] & (affects::aim | affects::place | affects::around);
  });
  if (dirty_places_.empty() && !turning) return;
  // A node that turns to a target, and its subtree, are computed twice. Keeps their old transforms, so that only true
  // changes are reported.
  std::vector<std::pair<std::uint32_t, Mat4>> before;
  for (const std::uint32_t eye : eyes_) {
    const auto joints = joints_of(eye);
    const std::uint32_t top = joints.empty() ? eye : joints.front();
    dirty_places_.push_back(at_[top]);
    each_below(top, [&](std::uint32_t d) {
      if (compiled_.draws(d) && !flags_[d]) before.emplace_back(d, worlds()[d]);
    });
  }
  if (!std::is_sorted(dirty_places_.begin(), dirty_places_.end()))
    std::sort(dirty_places_.begin(), dirty_places_.end());
  std::uint32_t done = 0;
  for (const std::uint32_t at : dirty_places_) {
    if (at < done) continue;
    done = at + size_[at];
    compose_below(at);
  }
  if (eyes_.empty()) return;
  turn_eyes(asking);
  for (const auto& [d, m] : before)
    if (flags_[d] && std::memcmp(&m, &worlds()[d], sizeof m) == 0) flags_.take_back(d);
}

// Turns the nodes that look at something, and their subtrees. Each sees the earlier ones already turned.
void Evaluator::turn_eyes(Asking& asking) {
  const auto in_world = [&](std::uint32_t i) { return translation_of(world(i)); };
  for (const std::uint32_t eye : eyes_) {
    const Node& n = compiled_.nodes[eye];
    if (only_ && !only_->aims[eye]) continue;
    if (n.reaches) reach(eye, asking);
    if (!n.looks) continue;
    const auto target = compiled_.aim(n.object, fn::look_at, now_, numbers_.data(), in_world, asking);
    const Vec3 place = in_world(eye);
    const double roll = numbers_[compiled_.find(n.object, fn::roll).offset];
    const bool looks = target && *target != place;
    if (!looks && roll == 0) continue;
    // Upright in world space, whatever its environments are.
    const Mat4 around = compiled_.sited ? around_[eye] : Mat4{};
    const Mat4 before = around * worlds_[eye];
    const Quat was = turn_of(before);
    Quat turn = looks ? turned_to(compiled_, n, *target - place, now_, asking) : was;
    if (roll != 0) turn = turn * axis_angle({0, 0, 1}, roll);
    // Keeps the object's scale; a camera has none.
    Mat4 turned = n.kind == Kind::camera ? rotation(turn) : rotation(turn * conjugate(was)) * linear_part(before);
    for (int i = 0; i < 3; ++i) turned(i, 3) = place[i];
    if (!turns_.empty()) turns_[eye] = turn;
    if (const auto back = inverse(around)) {
      turned = *back * turned;
      for (int i = 0; i < 3; ++i) turned(i, 3) = worlds_[eye](i, 3);  // keeps the position exact to the last bit
    }
    put_world(eye, turned);
    show_sited(eye);
    each_below(eye, [&](std::uint32_t i) {
      if (i != eye) compose(i);
    });
  }
}

bool Evaluator::wants(std::uint32_t object) const {
  const std::uint32_t node = compiled_.node_of[object];
  return !only_ || only_->places[node] || only_->turns[node];
}

// Environments are constant between ticks, unless code names them.
void Evaluator::environments(Asking& asking, bool own_set) {
  const InStage stage(Stage::environments);
  if (compiled_.sitings.empty()) return;
  const Scene& scene = compiled_.document.scene();
  const std::int64_t tick = scene.smooth_ticks ? now_.flicks : scene.ticks.whole(now_);
  const bool ticked = tick != tick_;
  if (!ticked && !compiled_.computes_sitings) return;
  tick_ = tick;
  if (SharedEnvironments& many = compiled_.caches.environments; many.set && own_set) {
    if (!many_) many_ = many.copy();
    if (many_->tick() != tick) many_->advance(tick);
  }
  // Many nodes may share a product, so each is computed once.
  for (std::size_t i = 0; i < products_.size(); ++i) {
    turned_[i] = false;
    const std::int32_t live = compiled_.sitings[i].live;
    if (live < 0 ? !ticked : !wants(compiled_.lives[static_cast<std::size_t>(live)].object)) continue;
    const Mat4 m = product(compiled_, static_cast<std::int32_t>(i), now_, asking, many_ ? &*many_ : nullptr);
    turned_[i] = fresh_ || !same_bits(m, products_[i]);
    products_[i] = m;
  }
  for (std::uint32_t i = 0; i < compiled_.nodes.size(); ++i) {
    const Node& n = compiled_.nodes[i];
    if (n.around >= 0 && turned_[static_cast<std::size_t>(n.around)]) marks_.add(i, affects::around);
    if (n.drive >= 0 && turned_[static_cast<std::size_t>(n.drive)]) marks_.add(i, affects::place);
  }
}

}  // namespace betwixt
