// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests the texts of diagrams and the places of their nodes.
#include "scene/graph_layout.h"

#include <gtest/gtest.h>

#include <random>

namespace betwixt {
namespace {

Graph graph(std::string_view text) {
  const auto g = read_graph(text);
  EXPECT_TRUE(g) << text << ": " << (g ? "" : g.error().message);
  return g ? *g : Graph();
}

TEST(Graphs, AreReadAsWritten) {
  const Graph g = graph("a -> b -- c: 5; 'x -> y' -> a\n b->two words : long label ;; d");
  EXPECT_EQ(g.nodes, (std::vector<std::string>{"a", "b", "c", "x -> y", "two words", "d"}));
  ASSERT_EQ(g.edges.size(), 4U);
  EXPECT_TRUE(g.edges[0].arrow);
  EXPECT_FALSE(g.edges[1].arrow);
  EXPECT_EQ(g.edges[0].label, "5");
  EXPECT_EQ(g.edges[1].label, "5");
  EXPECT_EQ(g.edges[2].label, "");
  EXPECT_EQ(g.edges[3].label, "long label");
  EXPECT_EQ(g.edges[3].from, 1U);
  EXPECT_EQ(g.edges[3].to, 4U);
}

TEST(Graphs, ErrorsHaveTheirPlaces) {
  const std::pair<const char*, int> wrong[] = {{"", 1},        {"a ->", 5},   {"-> a", 1},  {"a -> b; c: x", 10},
                                               {"'a -> b", 1}, {"a => b", 3}, {"'a' b", 5}, {"a -> ; b", 6}};
  for (const auto& [text, column] : wrong) {
    const auto g = read_graph(text);
    ASSERT_FALSE(g) << text;
    EXPECT_EQ(g.error().code, ErrorCode::syntax) << text;
    EXPECT_EQ(g.error().place.column, column) << text;
  }
  std::string many = "n0";
  for (std::size_t i = 1; i <= most_graph_nodes; ++i) many += "->n" + std::to_string(i);
  EXPECT_EQ(read_graph(many).error().code, ErrorCode::range);
}

Graph random_graph(std::mt19937& random, std::size_t nodes, std::size_t edges) {
  Graph g;
  for (std::size_t i = 0; i < nodes; ++i) g.nodes.push_back(std::to_string(i));
  for (std::size_t i = 0; i < edges; ++i)
    if (const std::size_t a = random() % nodes, b = random() % nodes; a != b) g.edges.push_back({a, b, true, {}});
  return g;
}

TEST(Graphs, NodesKeepApartInEveryLayout) {
  std::mt19937 random(3);
  for (int round = 0; round < 200; ++round) {
    const Graph g = random_graph(random, 1 + random() % 14, random() % 20);
    for (const GraphLayout layout :
         {GraphLayout::layered, GraphLayout::tree, GraphLayout::force, GraphLayout::circle}) {
      const auto at = place_graph(g, layout, {2, 1.5, 0});
      ASSERT_EQ(at.size(), g.nodes.size());
      for (std::size_t i = 0; i < at.size(); ++i) {
        EXPECT_TRUE(std::isfinite(length(at[i])));
        for (std::size_t j = 0; j < i; ++j) {
          const Vec3 d = at[i] - at[j];
          if (layout == GraphLayout::layered || layout == GraphLayout::tree)
            EXPECT_TRUE(std::abs(d.x) > 2 - 1e-9 || std::abs(d.y) > 1.5 - 1e-9) << round;
          else
            EXPECT_GT(length(d), 0.6) << round << " " << static_cast<int>(layout);
        }
      }
    }
  }
}

TEST(Graphs, LayersGoDownAlongEveryEdgeThatClosesNoCircle) {
  std::mt19937 random(4);
  for (int round = 0; round < 100; ++round) {
    // Edges from a lower to a higher number have no circle.
    Graph g = random_graph(random, 2 + random() % 12, random() % 20);
    for (Graph::Edge& e : g.edges)
      if (e.from > e.to) std::swap(e.from, e.to);
    const auto at = place_graph(g, GraphLayout::layered, {2, 1.5, 0});
    for (const Graph::Edge& e : g.edges) EXPECT_LE(at[e.to].y, at[e.from].y - 1.5 + 1e-9);
  }
  EXPECT_EQ(place_graph(graph("a -> b -> c -> a"), GraphLayout::layered, {2, 1, 0}).size(), 3U);
}

TEST(Graphs, AParentStandsAboveItsChildren) {
  const auto at = place_graph(graph("a -> b; a -> c; c -> d; c -> e; c -> f"), GraphLayout::tree, {1, 1, 0});
  EXPECT_NEAR(at[0].x, (at[1].x + at[2].x) / 2, 1e-12);
  EXPECT_NEAR(at[2].x, at[4].x, 1e-12);
  EXPECT_NEAR(at[0].y - at[3].y, 2, 1e-12);
}

TEST(Graphs, ACircleIsRegular) {
  const auto at = place_graph(graph("a -> b -> c -> d -> e"), GraphLayout::circle, {2, 2, 0});
  for (std::size_t i = 1; i < 5; ++i) EXPECT_NEAR(length(at[i] - at[i - 1]), length(at[4] - at[0]), 1e-12);
  EXPECT_GE(length(at[1] - at[0]), 2 - 1e-9);
}

TEST(Graphs, TheLargestArePlaced) {
  std::mt19937 random(5);
  const Graph g = random_graph(random, most_graph_nodes, most_graph_edges);
  for (const GraphLayout layout : {GraphLayout::layered, GraphLayout::tree, GraphLayout::force, GraphLayout::circle})
    EXPECT_EQ(place_graph(g, layout, {2, 1.5, 0}).size(), most_graph_nodes);
}

// Layers and siblings, along x and y: the distance to the next layer and to the next sibling.
TEST(Layouts, GoTheWayThatIsSaid) {
  const Graph g = graph("a -> b; a -> c");  // b is the first child
  const std::tuple<GraphWay, Vec3, Vec3, Vec3> wanted[] = {{GraphWay::down, {0, 1, 0}, {-1.5, -1, 0}, {1.5, -1, 0}},
                                                           {GraphWay::up, {0, -1, 0}, {-1.5, 1, 0}, {1.5, 1, 0}},
                                                           {GraphWay::right, {-1.5, 0, 0}, {1.5, 1, 0}, {1.5, -1, 0}},
                                                           {GraphWay::left, {1.5, 0, 0}, {-1.5, 1, 0}, {-1.5, -1, 0}}};
  for (const GraphLayout layout : {GraphLayout::layered, GraphLayout::tree})
    for (const auto& [way, a, b, c] : wanted) {
      const auto at = place_graph(g, layout, {3, 2, 0}, way);
      EXPECT_NEAR(length(at[0] - a) + length(at[1] - b) + length(at[2] - c), 0, 1e-9) << static_cast<int>(way);
    }
}

}  // namespace
}  // namespace betwixt
