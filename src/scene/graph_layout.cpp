// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "scene/graph_layout.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>

namespace betwixt {
namespace {

using Lists = std::vector<std::vector<std::size_t>>;

Lists children_of(const Graph& g) {
  Lists out(g.nodes.size());
  for (const Graph::Edge& e : g.edges)
    if (e.from != e.to) out[e.from].push_back(e.to);
  return out;
}

void center(std::vector<Vec3>& all) {
  Vec3 low = all[0], high = all[0];
  for (const Vec3 p : all)
    for (int i = 0; i < 3; ++i) low[i] = std::min(low[i], p[i]), high[i] = std::max(high[i], p[i]);
  for (Vec3& p : all) p = p - 0.5 * (low + high);
}

// ---- In layers

// Returns the edges without those that close a circle.
Lists without_circles(const Graph& g) {
  const Lists children = children_of(g);
  Lists out(g.nodes.size());
  std::vector<int> state(g.nodes.size());  // 0: not seen; 1: on the way; 2: done
  for (std::size_t root = 0; root < g.nodes.size(); ++root) {
    if (state[root]) continue;
    std::vector<std::pair<std::size_t, std::size_t>> way{{root, 0}};
    state[root] = 1;
    while (!way.empty()) {
      auto& [at, next] = way.back();
      if (next == children[at].size()) {
        state[at] = 2;
        way.pop_back();
        continue;
      }
      const std::size_t to = children[at][next++];
      if (state[to] == 1) continue;
      out[at].push_back(to);
      if (state[to] == 0) state[to] = 1, way.emplace_back(to, 0);
    }
  }
  return out;
}

// Returns the layer of each node: the longest way to it.
std::vector<std::size_t> layers_of(const Lists& down) {
  const std::size_t n = down.size();
  std::vector<std::size_t> layer(n), left(n), ready;
  for (const auto& all : down)
    for (const std::size_t to : all) ++left[to];
  for (std::size_t i = 0; i < n; ++i)
    if (left[i] == 0) ready.push_back(i);
  for (std::size_t k = 0; k < ready.size(); ++k)
    for (const std::size_t to : down[ready[k]]) {
      layer[to] = std::max(layer[to], layer[ready[k]] + 1);
      if (--left[to] == 0) ready.push_back(to);
    }
  return layer;
}

// Puts nodes that are not drawn on edges through several layers, so that these edges have room between other nodes.
void fill_long_edges(Lists& down, std::vector<std::size_t>& layer) {
  constexpr std::size_t most = 4 * most_graph_nodes;
  for (std::size_t i = 0, n = down.size(); i < n; ++i)
    for (std::size_t k = 0; k < down[i].size(); ++k) {
      const std::size_t to = down[i][k];
      std::size_t from = i;
      for (std::size_t at = layer[i] + 1; at < layer[to] && down.size() < most; ++at) {
        const std::size_t added = down.size();
        if (from == i)
          down[i][k] = added;
        else
          down[from].push_back(added);
        down.emplace_back(), layer.push_back(at);
        from = added;
      }
      if (from != i) down[from].push_back(to);
    }
}

std::vector<Vec3> in_layers(const Graph& g, Vec3 apart) {
  Lists down = without_circles(g);
  std::vector<std::size_t> layer = layers_of(down);
  fill_long_edges(down, layer);
  const std::size_t all = down.size(), count = *std::max_element(layer.begin(), layer.end()) + 1;
  Lists rows(count), up(all);
  for (std::size_t i = 0; i < all; ++i) {
    rows[layer[i]].push_back(i);
    for (const std::size_t to : down[i]) up[to].push_back(i);
  }
  std::vector<double> x(all);
  const auto spread = [&](const std::vector<std::size_t>& row) {
    for (std::size_t k = 0; k < row.size(); ++k)
      x[row[k]] = (static_cast<double>(k) - (static_cast<double>(row.size()) - 1) / 2) * apart.x;
  };
  for (const auto& row : rows) spread(row);
  // Sorts each row by the middles of the neighbours above, then below, some times.
  const auto sweep = [&](std::vector<std::size_t>& row, const Lists& neighbours) {
    std::vector<double> wanted(all);
    for (const std::size_t i : row) {
      double sum = 0;
      for (const std::size_t other : neighbours[i]) sum += x[other];
      wanted[i] = neighbours[i].empty() ? x[i] : sum / static_cast<double>(neighbours[i].size());
    }
    std::stable_sort(row.begin(), row.end(), [&](std::size_t a, std::size_t b) { return wanted[a] < wanted[b]; });
    spread(row);
  };
  for (int round = 0; round < 8; ++round) {
    for (std::size_t k = 1; k < count; ++k) sweep(rows[k], up);
    for (std::size_t k = count; k-- > 0;) sweep(rows[k], down);
  }
  std::vector<Vec3> out(g.nodes.size());
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = {x[i], -static_cast<double>(layer[i]) * apart.y, 0};
  return out;
}

// ---- As a tree

std::vector<Vec3> as_tree(const Graph& g, Vec3 apart) {
  const std::size_t n = g.nodes.size();
  const Lists all = children_of(g);
  Lists children(n);
  std::vector<bool> seen(n), led(n);
  std::vector<Vec3> out(n);
  for (const auto& to : all)
    for (const std::size_t i : to) led[i] = true;
  std::vector<std::size_t> roots;
  // Breadth first, so that a child belongs to the nearest root.
  const auto grow_from = [&](std::size_t root) {
    roots.push_back(root), seen[root] = true;
    std::vector<std::size_t> queue{root};
    for (std::size_t k = 0; k < queue.size(); ++k)
      for (const std::size_t to : all[queue[k]])
        if (!seen[to]) {
          seen[to] = true, children[queue[k]].push_back(to), queue.push_back(to);
          out[to].y = out[queue[k]].y - apart.y;
        }
  };
  for (std::size_t i = 0; i < n; ++i)
    if (!led[i]) grow_from(i);
  for (std::size_t i = 0; i < n; ++i)
    if (!seen[i]) grow_from(i);
  // Leaves stand side by side; a parent stands above the middle of its children.
  double next = 0;
  std::vector<std::pair<std::size_t, std::size_t>> way;
  for (const std::size_t root : roots)
    for (way.emplace_back(root, 0); !way.empty();) {
      auto& [at, child] = way.back();
      if (child < children[at].size()) {
        way.emplace_back(children[at][child++], 0);
        continue;
      }
      if (children[at].empty())
        out[at].x = next, next += apart.x;
      else
        out[at].x = 0.5 * (out[children[at].front()].x + out[children[at].back()].x);
      way.pop_back();
    }
  return out;
}

// ---- On a circle, and by forces

std::vector<Vec3> on_circle(std::size_t n, Vec3 apart) {
  std::vector<Vec3> out(n);
  const double distance = std::hypot(apart.x, apart.y) / std::sqrt(2.0);
  const double radius = n < 2 ? 0 : std::max(distance / (2 * std::sin(pi / static_cast<double>(n))), 0.6 * distance);
  for (std::size_t i = 0; i < n; ++i) {
    const double angle = pi / 2 - 2 * pi * static_cast<double>(i) / static_cast<double>(n);
    out[i] = radius * Vec3{std::cos(angle), std::sin(angle), 0};
  }
  return out;
}

std::vector<Vec3> by_forces(const Graph& g, Vec3 apart) {
  const std::size_t n = g.nodes.size();
  const double ideal = 0.5 * (apart.x + apart.y);
  std::vector<Vec3> at = on_circle(n, apart), moves(n);
  const int rounds = n > 300 ? 60 : 300;
  for (int round = 0; round < rounds; ++round) {
    std::fill(moves.begin(), moves.end(), Vec3{});
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = i + 1; j < n; ++j) {
        const Vec3 d = at[i] - at[j];
        const double r = std::max(length(d), 1e-3 * ideal);
        const Vec3 push = (ideal * ideal / (r * r)) * d;
        moves[i] = moves[i] + push, moves[j] = moves[j] - push;
      }
    for (const Graph::Edge& e : g.edges) {
      const Vec3 d = at[e.to] - at[e.from], pull = (length(d) / ideal) * d;
      moves[e.from] = moves[e.from] + pull, moves[e.to] = moves[e.to] - pull;
    }
    // Cools down: nodes move less and less far. A weak pull keeps parts together.
    const double most = ideal * (1 - static_cast<double>(round) / rounds) * 0.5;
    for (std::size_t i = 0; i < n; ++i) {
      const Vec3 move = moves[i] - 0.05 * at[i];
      const double far = length(move);
      if (far > 1e-9) at[i] = at[i] + (std::min(far, most) / far) * move;
    }
  }
  return at;
}

}  // namespace

std::vector<Vec3> place_graph(const Graph& g, GraphLayout layout, Vec3 apart, GraphWay way) {
  if (g.nodes.empty()) return {};
  std::vector<Vec3> out;
  if (layout == GraphLayout::circle) {
    out = on_circle(g.nodes.size(), apart);
  } else if (layout == GraphLayout::force) {
    out = by_forces(g, apart);
  } else {
    const Vec3 as_down = goes_across(way) ? Vec3{apart.y, apart.x, 0} : apart;
    out = layout == GraphLayout::tree ? as_tree(g, as_down) : in_layers(g, as_down);
    // What is on the left is on top if the arrows go across.
    for (Vec3& p : out)
      p = way == GraphWay::right  ? Vec3{-p.y, -p.x, 0}
          : way == GraphWay::left ? Vec3{p.y, -p.x, 0}
          : way == GraphWay::up   ? Vec3{p.x, -p.y, 0}
                                  : p;
  }
  center(out);
  return out;
}

}  // namespace betwixt
