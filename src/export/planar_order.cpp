// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "export/planar_order.h"

#include <algorithm>
#include <cstdint>

namespace betwixt {
namespace {

constexpr std::size_t most_cells = 16'000'000;

using Order = std::vector<std::size_t>;  // objects

struct StackPart {
  std::size_t thing;
  std::vector<Time> since;  // when it begins and ends to be in use, alternating
};

// Returns the places of the stack for an order, as many as possible: the longest common subsequence. -1: none.
std::vector<std::int64_t> places_of(const std::vector<StackPart>& stack, const Order& order) {
  const std::size_t n = stack.size(), m = order.size(), row = m + 1;
  std::vector<std::int64_t> out(m, -1);
  std::vector<std::uint32_t> longest((n + 1) * row);  // of the rest
  for (std::size_t i = n; i-- > 0;)
    for (std::size_t j = m; j-- > 0;)
      longest[i * row + j] = stack[i].thing == order[j]
                                 ? longest[(i + 1) * row + j + 1] + 1
                                 : std::max(longest[(i + 1) * row + j], longest[i * row + j + 1]);
  for (std::size_t i = 0, j = 0; i < n && j < m;) {
    if (stack[i].thing == order[j])
      out[j++] = static_cast<std::int64_t>(i++);
    else if (longest[(i + 1) * row + j] >= longest[i * row + j + 1])
      ++i;
    else
      ++j;
  }
  return out;
}

bool varies(const PlanarDepths& d) {
  std::optional<double> one;
  for (const auto& [t, depth] : d) {
    if (depth && one && *one != *depth) return true;
    if (depth) one = depth;
  }
  return false;
}

std::optional<double> first_of(const PlanarDepths& d) {
  for (const auto& [t, depth] : d)
    if (depth) return depth;
  return std::nullopt;
}

}  // namespace

void put(PlanarDepths& all, Time t, std::optional<double> depth) {
  if (all.empty() || all.back().second != depth) all.emplace_back(t, depth);
}

std::vector<StackPlace> stack_of(const std::vector<PlanarDepths>& all, Time until, bool& whole) {
  whole = true;
  std::vector<std::optional<double>> depth;
  for (const PlanarDepths& d : all) depth.push_back(first_of(d));
  const auto sorted = [&](bool seen_only) {
    Order order;
    for (std::size_t i = 0; i < all.size(); ++i)
      if (depth[i] || !seen_only) order.push_back(i);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return depth[a].value_or(0) < depth[b].value_or(0); });
    return order;
  };
  const Order at_first = sorted(false);
  std::vector<StackPart> stack;
  for (const std::size_t thing : at_first) stack.push_back({thing, {}});
  if (std::any_of(all.begin(), all.end(), varies)) {
    std::vector<std::pair<Time, std::size_t>> changes;
    for (std::size_t i = 0; i < all.size(); ++i) {
      depth[i] = std::nullopt;
      for (const auto& [t, d] : all[i]) changes.emplace_back(t, i);
    }
    std::sort(changes.begin(), changes.end());
    std::vector<std::size_t> next(all.size());
    Order before;
    for (std::size_t k = 0; k < changes.size() && whole;) {
      const Time t = changes[k].first;
      for (; k < changes.size() && changes[k].first == t; ++k) {
        const std::size_t thing = changes[k].second;
        depth[thing] = all[thing][next[thing]++].second;
      }
      const Order order = sorted(true);
      if (order == before) continue;
      before = order;
      if ((stack.size() + 1) * (order.size() + 1) > most_cells) whole = false;
      if (!whole) break;
      std::vector<std::int64_t> places = places_of(stack, order);
      std::vector<bool> taken(stack.size());
      for (const std::int64_t p : places)
        if (p >= 0) taken[static_cast<std::size_t>(p)] = true;
      for (std::size_t i = 0; i < stack.size(); ++i)
        if (taken[i] != (stack[i].since.size() % 2 == 1)) stack[i].since.push_back(t);
      std::size_t at = 0, added = 0;
      for (std::size_t j = 0; j < order.size(); ++j) {
        if (places[j] >= 0) {
          at = static_cast<std::size_t>(places[j]) + added + 1;
        } else {
          stack.insert(stack.begin() + static_cast<std::ptrdiff_t>(at), StackPart{order[j], {t}});
          ++at, ++added;
        }
      }
      whole = stack.size() <= 4 * all.size() + 16;
    }
  }
  std::vector<StackPlace> out;
  if (!whole) {
    for (const std::size_t thing : at_first) out.push_back({thing, {}});
    return out;
  }
  std::vector<std::size_t> places(all.size());
  std::vector<bool> used(all.size());
  for (const StackPart& p : stack) used[p.thing] = used[p.thing] || !p.since.empty();
  std::erase_if(stack, [&](const StackPart& p) { return p.since.empty() && used[p.thing]; });
  for (const StackPart& p : stack) ++places[p.thing];
  for (const StackPart& p : stack) {
    StackPlace place{p.thing, {}};
    if (places[p.thing] > 1)
      for (std::size_t i = 0; i < p.since.size(); i += 2)
        place.spans.emplace_back(p.since[i], i + 1 < p.since.size() ? p.since[i + 1] : until);
    out.push_back(std::move(place));
  }
  return out;
}

}  // namespace betwixt
