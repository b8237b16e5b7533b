// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Where all nodes are: those that were moved, and what hangs on them.
#include <algorithm>
#include <cstring>

#include "program/evaluator.h"
#include "program/placing.h"

namespace betwixt {

// Depth first: all that hangs on a node, and on that, is the interval behind it.
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
  arrange_eyes();
}

// Cameras take their turns in the order of the objects, but whoever is above another before it.
void Evaluator::arrange_eyes() {
  eyes_.clear();
  if (compiled_.eyes.empty()) return;
  std::vector<bool> is_eye(order_.size()), seen(order_.size());
  for (const std::uint32_t e : compiled_.eyes) is_eye[e] = true;
  std::vector<std::uint32_t> chain;
  for (std::uint32_t start = 0; start < order_.size(); ++start) {
    for (auto i = static_cast<std::int32_t>(start); i >= 0 && !seen[static_cast<std::size_t>(i)];
         i = parent_[static_cast<std::size_t>(i)]) {
      seen[static_cast<std::size_t>(i)] = true;
      chain.push_back(static_cast<std::uint32_t>(i));
    }
    for (; !chain.empty(); chain.pop_back())
      if (is_eye[chain.back()]) eyes_.push_back(chain.back());
  }
}

void Evaluator::place_alone(std::uint32_t node, Asking& asking) {
  const Node& n = compiled_.nodes[node];
  Said said = said_by(n, numbers_.data());
  if (n.transform || n.drive >= 0)
    said.own =
        compiled_.driven(n, now_, asking, n.drive >= 0 ? &products_[static_cast<std::size_t>(n.drive)] : nullptr);
  if (n.moving >= 0) said.motion = compiled_.moved(n, now_);
  // What nobody holds is where it is by itself; cameras may be turned, and must know how they stood.
  (held_[node] || n.kind == Kind::camera ? own_ : placed_)[node] = own_place(said);
}

void Evaluator::compose(std::uint32_t node) {
  const Node& n = compiled_.nodes[node];
  const CompiledSpan* h = held_[node];
  const Frozen* f = h && h->frozen >= 0 ? &compiled_.frozen[static_cast<std::size_t>(h->frozen)] : nullptr;
  const std::int32_t above = parent_[node];
  if (h)
    placed_[node] = hang(own_[node], vec3(&numbers_[n.attach]), h, f,
                         above >= 0 ? &placed_[static_cast<std::size_t>(above)] : nullptr);
  else if (n.kind == Kind::camera)
    placed_[node] = own_[node];
  if (compiled_.sited) {
    const Mat4* outer = above >= 0 ? &around_[static_cast<std::size_t>(above)] : f && f->held ? &f->around : nullptr;
    around_[node] = n.around >= 0 ? products_[static_cast<std::size_t>(n.around)] : Mat4{};
    if (outer) around_[node] = *outer * around_[node];
  }
  if (n.drawable >= 0) show(node);
}

void Evaluator::show(std::uint32_t node) {
  const auto d = static_cast<std::uint32_t>(compiled_.nodes[node].drawable);
  const Mat4 around = compiled_.sited ? world(node) : Mat4{};
  const Mat4& m = compiled_.sited ? around : placed_[node].world;
  if (std::memcmp(&m, &worlds[d], sizeof m) == 0) return;
  worlds[d] = m;
  flag(d);
}

void Evaluator::places(Asking& asking) {
  if (rearrange_) arrange();
  rearrange_ = false;
  dirty_places_.clear();
  bool turning = false;
  for (std::size_t i = 0; i < marked_.size(); ++i) {
    const std::uint32_t node = marked_[i];
    turning = turning || (dirty_[node] & affects::aim);
    if (!(dirty_[node] & affects::place)) continue;
    place_alone(node, asking);
    dirty_places_.push_back(at_[node]);
  }
  if (dirty_places_.empty() && !turning) return;
  // What hangs on cameras is worked out twice: what it was before this time is kept aside.
  std::vector<std::pair<std::uint32_t, Mat4>> before;
  for (const std::uint32_t eye : eyes_) {
    dirty_places_.push_back(at_[eye]);
    each_below(eye, [&](std::uint32_t i) {
      if (const std::int32_t d = compiled_.nodes[i].drawable; d >= 0 && !flagged_[static_cast<std::size_t>(d)])
        before.emplace_back(static_cast<std::uint32_t>(d), worlds[static_cast<std::size_t>(d)]);
    });
  }
  sort_numbers(dirty_places_);
  std::uint32_t done = 0;
  for (const std::uint32_t at : dirty_places_) {
    if (at < done) continue;
    done = at + size_[at];
    for (std::uint32_t k = at; k < done; ++k) compose(order_[k]);
  }
  if (eyes_.empty()) return;
  turn_eyes(asking);
  for (const auto& [d, m] : before)
    if (flagged_[d] && std::memcmp(&m, &worlds[d], sizeof m) == 0) {
      flagged_[d] = false;
      std::erase(changed, d);
    }
}

// A camera that looks at something turns with it, and so does what hangs on the camera: each sees those before it
// already turned.
void Evaluator::turn_eyes(Asking& asking) {
  const auto in_world = [&](std::uint32_t i) { return translation_of(world(i)); };
  for (const std::uint32_t eye : eyes_) {
    const auto target = compiled_.aim(compiled_.nodes[eye].object, now_, numbers_.data(), in_world, asking);
    const Vec3 place = in_world(eye);
    if (!target || *target == place) continue;
    placed_[eye].world = look_at(place, *target);
    placed_[eye].turn = from_matrix(placed_[eye].world);
    if (compiled_.sited)  // it stands upright in the world, whatever encloses it
      if (const auto back = inverse(around_[eye])) placed_[eye].world = *back * placed_[eye].world;
    each_below(eye, [&](std::uint32_t i) {
      if (i != eye) compose(i);
    });
  }
}

}  // namespace betwixt
