// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Places for the nodes of a diagram.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "betwixt/result.h"
#include "betwixt/value.h"

namespace betwixt {

// A graph as it is written: "a -> b -> c; a -- d: 5". Nodes are numbered in the order in which they come.
struct Graph {
  struct Edge {
    std::size_t from = 0, to = 0;
    bool arrow = true;
    std::string label;
  };
  std::vector<std::string> nodes;  // their texts
  std::vector<Edge> edges;
};
inline constexpr std::size_t most_graph_nodes = 1'000, most_graph_edges = 3'000;

// Reads a graph. `->` makes an edge with an arrow, `--` one without; `;` or a new line ends a chain; a text after a
// colon is the label of the edges of its chain; texts with other signs stand in single quotes. Errors: syntax, range;
// their place is the column (from 1) in the text.
Result<Graph> read_graph(std::string_view text);

enum class GraphLayout : std::uint8_t { layered, tree, force, circle };
inline constexpr std::string_view graph_layout_words = "layered|tree|force|circle";
// Where the arrows of the layouts `layered` and `tree` go.
enum class GraphWay : std::uint8_t { down, right, left, up };
inline constexpr std::string_view graph_way_words = "down|right|left|up";
inline bool goes_across(GraphWay way) { return way == GraphWay::right || way == GraphWay::left; }

// Returns a place for each node, about the origin. `apart`: the distance of neighbours, along x and y.
//   layered  each edge goes down, or the way that is said, as far as there is no circle; edges cross as little as a few
//   sweeps can do tree     children below their parent, or on the side that is said, which is the first node that leads
//   to them force    edges pull and nodes push, from a circle on circle   in their order, clockwise, the first on top
std::vector<Vec3> place_graph(const Graph&, GraphLayout, Vec3 apart, GraphWay = GraphWay::down);

}  // namespace betwixt
