// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Bounding boxes, their overlaps, and their place relative to the camera's view. Bullet's tree finds candidate pairs in
// f32, with margin; the exact tests use f64.
#include "betwixt/contacts.h"

#include <BulletCollision/BroadphaseCollision/btQuantizedBvh.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <vector>

#include "program/contacts.h"
#include "scene/kinds.h"

namespace betwixt {
namespace {

Vec3 row(const Mat4& m, int i) { return {m(i, 0), m(i, 1), m(i, 2)}; }
double dot_of_sizes(Vec3 a, Vec3 b) { return std::abs(a.x * b.x) + std::abs(a.y * b.y) + std::abs(a.z * b.z); }

// Returns how far a shape of half extent `half` reaches along a world axis; `r` is that row of its matrix.
double reach(const Shape& s, Vec3 half, Vec3 r) {
  const auto of_kind = row_of(s.kind).reach;
  return of_kind ? of_kind(s, r) : dot_of_sizes(half, r);
}

Extent in_world(const Shape& s, const Mat4& world) {
  const Extent e = extent(s);
  if (e.empty()) return {};
  const Vec3 middle = transform_point(world, 0.5 * (e.low + e.high)), half = 0.5 * (e.high - e.low);
  Vec3 out;
  for (int i = 0; i < 3; ++i) out[i] = reach(s, half, row(world, i));
  if (!finite(middle - out) || !finite(middle + out)) return {};
  return {middle - out, middle + out};
}

// Bounds a shape that morphs into another. Each point moves on a straight line; twerpers may overshoot.
Extent on_the_way(const Extent& a, const Extent& b, double w) {
  if (a.empty() || b.empty()) return a.empty() ? b : a;
  Extent e;
  const auto mix = [](double x, double y, double s) { return x * (1 - s) + y * s; };
  for (int i = 0; i < 3; ++i) {
    e.low[i] = mix(w > 1 ? a.high[i] : a.low[i], w < 0 ? b.high[i] : b.low[i], w);
    e.high[i] = mix(w > 1 ? a.low[i] : a.high[i], w < 0 ? b.low[i] : b.high[i], w);
  }
  return e;
}

// The camera's view: an unbounded convex set. All boxes have the same axes, so the separating axes are the same for all
// boxes. They and the view's range along them are computed once. The test is exact.
class Window {
 public:
  Window(const Camera& c, std::optional<double> asked) : eye_(translation_of(c.world)) {
    double aspect = asked.value_or(c.aspect);
    if (!(aspect > 0)) aspect = 1;
    // In camera space: corners, and directions in which the view is unbounded.
    std::vector<Vec3> corners{{0, 0, 0}}, ways{{0, 0, -1}}, faces, edges;
    if (c.orthographic) {
      const double y = std::max(c.height, 1e-9) / 2, x = y * aspect;
      corners = {{-x, -y, 0}, {x, -y, 0}, {-x, y, 0}, {x, y, 0}};
      faces = edges = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    } else {
      const double x = std::tan(std::clamp(c.fov, 1e-5, pi - 1e-3) / 2), y = x / aspect;
      edges = ways = {{-x, -y, -1}, {x, -y, -1}, {-x, y, -1}, {x, y, -1}};
      faces = {{1, 0, -x}, {-1, 0, -x}, {0, 1, -y}, {0, -1, -y}};
    }
    // `flat`: a direction of the set that is perpendicular to n; rounding must not count.
    const auto put = [&](Vec3 n, Vec3 flat) {
      Way w{transform_vector(c.world, n), std::numeric_limits<double>::infinity(), 0};
      w.high = -w.low;
      for (const Vec3 p : corners) w.low = std::min(w.low, dot(n, p)), w.high = std::max(w.high, dot(n, p));
      for (const Vec3 d : ways) {
        const double along = d == flat ? 0 : dot(n, d);
        if (along < 0) w.low = -std::numeric_limits<double>::infinity();
        if (along > 0) w.high = std::numeric_limits<double>::infinity();
      }
      ways_.push_back(w);
    };
    for (const Vec3 n : faces) put(n, {});
    faces_ = ways_.size();
    // The separating axis theorem: two convex bodies that are apart are separated along a face normal of one, or along
    // the cross product of an edge of each.
    for (int i = 0; i < 3; ++i) {
      const Vec3 axis = row(c.world, i);  // of the world
      put(axis, {});
      for (const Vec3 e : edges)
        if (const Vec3 n = cross(e, axis); length(n) > 1e-9 * length(e)) put(n, e);
    }
  }

  Sight see(const ContactBox& b) const {
    const Vec3 middle = 0.5 * (b.low + b.high) - eye_, half = 0.5 * (b.high - b.low);
    bool inside = true;
    for (std::size_t i = 0; i < ways_.size(); ++i) {
      const Way& w = ways_[i];
      const double at = dot(w.direction, middle), reach = dot_of_sizes(w.direction, half);
      if (at + reach < w.low || at - reach > w.high) return Sight::out;
      inside = inside && at - reach > w.low && at + reach < w.high;
      if (inside && i + 1 == faces_) return Sight::in;
    }
    return Sight::boundary;
  }

 private:
  struct Way {
    Vec3 direction;    // in world space
    double low, high;  // range of the view
  };
  Vec3 eye_;
  std::vector<Way> ways_;  // face normals first
  std::size_t faces_ = 0;
};

// ---- broad phase

// A moving box: `from` at time `first`, `to` at time `last`, both 0 to 1.
struct Mover {
  ContactBox from, to;
  double first = 0, last = 0;
};

// Bullet's bounding-volume tree, tested against itself. It is always balanced.
class Tree : btQuantizedBvh {
 public:
  explicit Tree(const std::vector<Extent>& boxes) {
    m_useQuantization = false;  // with quantization, one distant box would merge all others
    Extent all;
    for (const Extent& b : boxes) all.add(b);
    const Vec3 origin = all.middle();
    const int count = static_cast<int>(boxes.size());
    m_leafNodes.resize(count);
    for (int i = 0; i < count; ++i) {
      btOptimizedBvhNode& leaf = m_leafNodes[i];
      const Extent& b = boxes[static_cast<std::size_t>(i)];
      leaf.m_aabbMinOrg = outward(b.low - origin, -1), leaf.m_aabbMaxOrg = outward(b.high - origin, 1);
      leaf.m_escapeIndex = -1, leaf.m_subPart = 0, leaf.m_triangleIndex = i;
    }
    m_contiguousNodes.resize(2 * count);
    m_curNodeIndex = 0;
    buildTree(0, count);
  }

  // Calls `found` once for each overlapping pair, until it returns false.
  template <class F>
  void each_pair(const F& found) const {
    const btOptimizedBvhNode* nodes = &m_contiguousNodes[0];
    for (int i = 0; i < m_curNodeIndex; ++i) {
      const btOptimizedBvhNode& one = nodes[i];
      if (one.m_escapeIndex != -1) continue;
      for (int k = i + 1; k < m_curNodeIndex;) {  // only nodes behind it: those before it have been tested against it
        const btOptimizedBvhNode& other = nodes[k];
        const bool leaf = other.m_escapeIndex == -1, meet = overlap(one, other);
        if (meet && leaf && !found(one.m_triangleIndex, other.m_triangleIndex)) return;
        k += meet || leaf ? 1 : other.m_escapeIndex;
      }
    }
  }

 private:
  // Rounds outward by one f32 step, and clamps so that the tree's sums of squares stay finite.
  static btVector3 outward(Vec3 v, int way) {
    btVector3 out(0, 0, 0);
    for (int i = 0; i < 3; ++i) {
      const auto near = static_cast<float>(std::clamp(v[i], -1e15, 1e15));
      out[i] = std::nextafter(near, static_cast<float>(way) * std::numeric_limits<float>::infinity());
    }
    return out;
  }
  static bool overlap(const btOptimizedBvhNode& a, const btOptimizedBvhNode& b) {
    const btScalar *al = a.m_aabbMinOrg, *ah = a.m_aabbMaxOrg, *bl = b.m_aabbMinOrg, *bh = b.m_aabbMaxOrg;
    return bool((al[0] <= bh[0]) & (bl[0] <= ah[0]) & (al[1] <= bh[1]) & (bl[1] <= ah[1]) & (al[2] <= bh[2]) &
                (bl[2] <= ah[2]));
  }
};

// ---- narrow phase

// Returns when two boxes first touch, 0 to 1, or nullopt if never. Along each axis, they overlap while each one's low
// end is below the other's high end.
std::optional<double> meeting(const Mover& a, const Mover& b) {
  double first = std::max(a.first, b.first), last = std::min(a.last, b.last);
  // x + s (y - x) <= 0 for s in first..last
  const auto below = [&](double x, double y) {
    if (x <= 0 && y <= 0) return;
    if (x > 0 && y > 0)
      last = -1;
    else if (x > 0)
      first = std::max(first, x / (x - y));
    else
      last = std::min(last, x / (x - y));
  };
  for (int i = 0; i < 3; ++i) {
    below(a.from.low[i] - b.from.high[i], a.to.low[i] - b.to.high[i]);
    below(b.from.low[i] - a.from.high[i], b.to.low[i] - a.to.high[i]);
  }
  return first <= last ? std::optional(first) : std::nullopt;
}

void find_pairs(Contacts& c, const std::vector<Mover>& movers, Time from, Time to, bool related) {
  if (movers.size() < 2) return;
  std::vector<Extent> ways(movers.size());
  for (std::size_t i = 0; i < movers.size(); ++i) {
    const auto &a = movers[i].from, &b = movers[i].to;
    ways[i] = {a.low, a.high};
    ways[i].add({b.low, b.high});
  }
  const auto span = static_cast<double>((to - from).flicks);
  Tree(ways).each_pair([&](int i, int k) {
    const Mover &x = movers[static_cast<std::size_t>(i)], &y = movers[static_cast<std::size_t>(k)];
    if (!related && x.to.body == y.to.body) return true;
    const auto when = meeting(x, y);
    if (!when) return true;
    if (c.pairs.size() == Contacts::most_pairs) return c.complete = false;
    const bool in_order = x.to.id.index < y.to.id.index;
    c.pairs.push_back(
        {in_order ? x.to.id : y.to.id, in_order ? y.to.id : x.to.id, from + Time{std::llround(*when * span)}});
    return true;
  });
  std::sort(c.pairs.begin(), c.pairs.end(), [](const Contact& x, const Contact& y) {
    return std::pair(x.a.index, x.b.index) < std::pair(y.a.index, y.b.index);
  });
}

// Connected components of more than two.
void find_groups(Contacts& c) {
  std::uint32_t most = 0;
  for (const Contact& p : c.pairs) most = std::max(most, p.b.index);
  std::vector<std::uint32_t> above(most + std::size_t{1});
  std::iota(above.begin(), above.end(), 0);
  const auto first = [&](std::uint32_t i) {  // the root of its component
    while (above[i] != i) i = above[i] = above[above[i]];
    return i;
  };
  for (const Contact& p : c.pairs) {
    const auto a = first(p.a.index), b = first(p.b.index);
    above[std::max(a, b)] = std::min(a, b);
  }
  std::vector<std::uint32_t> group(above.size()), size(above.size());
  for (const Contact& p : c.pairs) ++size[first(p.a.index)];
  for (const Contact& p : c.pairs) {
    const auto lead = first(p.a.index);
    if (size[lead] < 2) continue;
    if (lead == p.a.index && group[lead] == 0) {  // the first pair of its group, because pairs are sorted
      c.groups.emplace_back().pairs.reserve(size[lead]);
      group[lead] = static_cast<std::uint32_t>(c.groups.size());
    }
    c.groups[group[lead] - 1].pairs.push_back(p);
  }
  for (std::uint32_t i = 0; i < above.size(); ++i)
    if (const auto of = group[first(i)]) c.groups[of - 1].objects.push_back({i});
}

Contacts boxes(const Frame& frame, std::optional<double> aspect) {
  Contacts c;
  c.time = frame.time;
  c.boxes.reserve(frame.items.size());
  const Window window(frame.camera, aspect);
  for (const Item& item : frame.items) {
    Extent e = in_world(*item.shape, item.world);
    if (item.toward) e = on_the_way(e, in_world(*item.toward, item.world), item.blend);
    if (e.empty() || !finite(e.low) || !finite(e.high)) continue;
    ContactBox b{item.id, item.body ? item.body : item.id, e.low, e.high, Sight::out};
    b.sight = window.see(b);
    c.boxes.push_back(b);
  }
  const auto order = [](const ContactBox& a, const ContactBox& b) { return a.id.index < b.id.index; };
  if (!std::is_sorted(c.boxes.begin(), c.boxes.end(), order)) std::sort(c.boxes.begin(), c.boxes.end(), order);
  return c;
}

}  // namespace

Contacts contacts(const Frame& frame, const ContactOptions& options) {
  Contacts c = boxes(frame, options.aspect);
  std::vector<Mover> movers;
  movers.reserve(c.boxes.size());
  for (const ContactBox& b : c.boxes) movers.push_back({b, b, 0, 0});
  find_pairs(c, movers, c.time, c.time, options.related);
  find_groups(c);
  return c;
}

Contacts swept(const Contacts& before, const Contacts& after, const ContactOptions& options) {
  Contacts c;
  c.time = after.time, c.boxes = after.boxes;
  std::vector<Mover> movers;
  movers.reserve(after.boxes.size());
  auto was = before.boxes.begin();
  for (const ContactBox& is : after.boxes) {
    for (; was != before.boxes.end() && was->id.index < is.id.index; ++was) movers.push_back({*was, *was, 0, 0});
    const bool both = was != before.boxes.end() && was->id == is.id;
    movers.push_back({both ? *was++ : is, is, both ? 0.0 : 1.0, 1});
  }
  for (; was != before.boxes.end(); ++was) movers.push_back({*was, *was, 0, 0});
  find_pairs(c, movers, before.time, after.time, options.related);
  find_groups(c);
  return c;
}

Contacts swept(const Frame& before, const Frame& after, const ContactOptions& options) {
  return swept(boxes(before, options.aspect), boxes(after, options.aspect), options);
}

const ContactBox* Contacts::find(ObjectId id) const {
  const auto at = std::lower_bound(boxes.begin(), boxes.end(), id.index,
                                   [](const ContactBox& b, std::uint32_t i) { return b.id.index < i; });
  return at != boxes.end() && at->id == id ? &*at : nullptr;
}

Sight Contacts::sight(ObjectId id) const {
  const ContactBox* b = find(id);
  return b ? b->sight : Sight::out;
}

std::vector<ObjectId> Contacts::touching(ObjectId id) const {
  std::vector<ObjectId> out;
  for (const Contact& p : pairs)
    if (p.a == id || p.b == id) out.push_back(p.a == id ? p.b : p.a);
  return out;  // sorted: first the objects before `id`, in order, then those behind it
}

bool Contacts::touching(ObjectId a, ObjectId b) const {
  if (b.index < a.index) std::swap(a, b);
  const auto at = std::lower_bound(pairs.begin(), pairs.end(), std::pair(a.index, b.index),
                                   [](const Contact& p, auto key) { return std::pair(p.a.index, p.b.index) < key; });
  return at != pairs.end() && at->a == a && at->b == b;
}

}  // namespace betwixt
